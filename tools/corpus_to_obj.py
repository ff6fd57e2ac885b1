#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Turns a planar or surface mesh of a test corpus into an OBJ.

usage: corpus_to_obj.py IN OUT.obj

For tests: it opens meshes of other programs to evenmesh, whose business conversion is not. It
reads legacy VTK in ASCII (unstructured grids and polydata), SU2 and MFEM mesh v1.0; by content,
not by suffix. Triangles, quads and polygons are written in their order, as they are wound, with
the digits of the file; points and lines are left out, and so is all other data. Of a curved MFEM
mesh (H1 nodes) only the corner vertices are used: its cells become straight.

Anything else is refused, volume meshes too: one line on standard error and exit status 1.
"""
import itertools
import pathlib
import re
import sys

VTK_FACES = {5, 7, 9}  # triangle, polygon, quad
VTK_BELOW_FACES = {1, 2, 3, 4}  # vertices and lines
SU2_FACES = {5: 3, 9: 4}  # type: corners
MFEM_FACES = {2: 3, 3: 4}  # geometry: corners


class Refused(Exception):
    """What is wrong with the input, for people."""


class Words:
    """The words of a text, one after another."""

    def __init__(self, text):
        self.words = text.split()
        self.at = 0

    def take(self, count):
        if count < 0 or self.at + count > len(self.words):
            raise Refused("the file ends early")
        self.at += count
        return self.words[self.at - count:self.at]

    def word(self):
        return self.take(1)[0]

    def integer(self):
        return int(self.word())

    def integers(self, count):
        return [int(word) for word in self.take(count)]

    def expect(self, wanted):
        """Goes on to just after this word."""
        while self.word() != wanted:
            pass


def points_of(words, dimension):
    """The words in groups of a point each, with z = 0 in the plane."""
    return [words[i:i + dimension] + ["0"] * (3 - dimension)
            for i in range(0, len(words), dimension)]


def lists_of(words, count):
    """VTK's lists of vertices, each after its length; the number of all words comes first."""
    words.integer()
    return [words.integers(words.integer()) for _ in range(count)]


def read_vtk(text):
    head = text.split("\n", 4)
    if len(head) < 5 or head[2].strip() != "ASCII":
        raise Refused("it is no VTK file in ASCII")
    kind = head[3].split()[-1]
    words = Words(head[4])
    words.expect("POINTS")
    count = words.integer()
    words.word()  # the type of number
    points = points_of(words.take(3 * count), 3)
    if kind == "POLYDATA":
        words.expect("POLYGONS")
        return points, lists_of(words, words.integer())
    if kind != "UNSTRUCTURED_GRID":
        raise Refused(f"data set {kind}")
    words.expect("CELLS")
    cells = lists_of(words, words.integer())
    words.expect("CELL_TYPES")
    types = words.integers(words.integer())
    for kind in set(types) - VTK_FACES - VTK_BELOW_FACES:
        raise Refused(f"it has cells of VTK's type {kind}")
    return points, [cell for kind, cell in zip(types, cells) if kind in VTK_FACES]


def su2_lines(text, name):
    """The lines, as words, that the number after a name announces."""
    _, *rest = re.split(rf"^{name}\s*=\s*(\d+)[^\n]*\n", text, maxsplit=1, flags=re.MULTILINE)
    if not rest:
        raise Refused(f"there is no {name}")
    lines = (line.split() for line in rest[1].split("\n") if line.strip())
    found = list(itertools.islice(lines, int(rest[0])))
    if len(found) < int(rest[0]):
        raise Refused("the file ends early")
    return found


def read_su2(text):
    text = re.sub(r"%.*", "", text)
    if re.search(r"^NDIME\s*=\s*2\s*$", text, re.MULTILINE) is None:
        raise Refused("it is not in the plane")
    cells = []
    for line in su2_lines(text, "NELEM"):
        kind = int(line[0])
        if kind not in SU2_FACES:
            raise Refused(f"it has elements of SU2's type {kind}")
        cells.append([int(word) for word in line[1:1 + SU2_FACES[kind]]])
    return [line[:2] + ["0"] for line in su2_lines(text, "NPOIN")], cells


def mfem_nodes(words, vertex_count):
    """The corner vertices among the nodes, which H1 numbers first."""
    words.expect("FiniteElementCollection:")
    collection = words.word()
    if not collection.startswith("H1_2D_"):
        raise Refused(f"nodes in {collection}")
    words.expect("VDim:")
    dimension = words.integer()
    words.expect("Ordering:")
    by_vertex = words.integer() == 1
    values = words.take(len(words.words) - words.at)
    if by_vertex:
        return points_of(values[:dimension * vertex_count], dimension)
    nodes = len(values) // dimension
    columns = [values[nodes * k:nodes * k + vertex_count] for k in range(dimension)]
    return points_of(list(itertools.chain.from_iterable(zip(*columns))), dimension)


def read_mfem(text):
    words = Words(re.sub(r"#.*", "", text))
    words.expect("dimension")
    if words.integer() != 2:
        raise Refused("it is not of faces")
    words.expect("elements")
    cells = []
    for _ in range(words.integer()):
        _, kind = words.integers(2)
        if kind not in MFEM_FACES:
            raise Refused(f"it has elements of MFEM's geometry {kind}")
        cells.append(words.integers(MFEM_FACES[kind]))
    words.expect("vertices")
    count = words.integer()
    if words.words[words.at] == "nodes":
        return mfem_nodes(words, count), cells
    dimension = words.integer()
    return points_of(words.take(dimension * count), dimension), cells


def read(text):
    if text.startswith("# vtk DataFile"):
        return read_vtk(text)
    if text.startswith("MFEM mesh v1.0"):
        return read_mfem(text)
    if re.search(r"^NDIME\s*=", text, re.MULTILINE):
        return read_su2(text)
    raise Refused("it is of no format known here")


def obj_of(points, cells):
    lines = ["v " + " ".join(point) for point in points]
    for cell in cells:
        if min(cell) < 0 or max(cell) >= len(points):
            raise Refused(f"a cell has the vertices {cell} of {len(points)}")
        lines.append("f " + " ".join(str(vertex + 1) for vertex in cell))
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__.strip())
    source = pathlib.Path(sys.argv[1])
    try:
        points, cells = read(source.read_text(encoding="latin-1"))
        if not cells:
            raise Refused("it has no faces")
        pathlib.Path(sys.argv[2]).write_text(obj_of(points, cells), encoding="ascii")
    except (Refused, ValueError, IndexError) as reason:
        sys.exit(f"{source}: {reason}")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes small Exodus files in the three classic formats of netCDF.

usage: make_exodus_seeds.py FOLDER      (fuzz/corpus/exodus was made by it)
"""
import itertools
import math
import pathlib
import struct
import sys

TYPES = {"c": 2, "i": 4, "f": 5, "d": 6, "q": 10}  # struct's letters to netCDF's numbers
DIMENSIONS, VARIABLES, ATTRIBUTES = 10, 11, 12


class Netcdf:
    """A file in format 1, 2 or 5; variables come behind the header in the order they are added."""

    def __init__(self, version):
        self.version = version
        self.dimensions = {}
        self.variables = []  # name, dimensions, letter, values, attributes
        self.steps = 0
        self.apart = 1  # whether x, y and z have a variable each

    def dimension(self, name, length):
        self.dimensions[name] = length

    def variable(self, name, dimensions, letter, values, **attributes):
        self.variables.append((name, dimensions, letter, list(values), attributes))

    def _count(self, value):
        return struct.pack(">q" if self.version == 5 else ">i", value)

    def _list(self, tag, things):
        head = struct.pack(">i", tag if things else 0) + self._count(len(things))
        return head + b"".join(things)

    def _name(self, name):
        text = name.encode()
        return self._count(len(text)) + text + bytes(-len(text) % 4)

    def _attribute(self, name, text):
        return self._name(name) + struct.pack(">i", TYPES["c"]) + self._name(text)

    def _number(self, name, letter, value):
        return (self._name(name) + struct.pack(">i", TYPES[letter]) + self._count(1)
                + self._values(letter, [value]))

    def _values(self, letter, values):
        raw = b"".join(values) if letter == "c" else struct.pack(f">{len(values)}{letter}", *values)
        return raw + bytes(-len(raw) % 4)

    def _header(self, begins):
        names = list(self.dimensions)
        out = b"CDF" + bytes([self.version]) + self._count(self.steps)
        out += self._list(DIMENSIONS, [self._name(name) + self._count(length)
                                       for name, length in self.dimensions.items()])
        # What Sandia's library asks for before it opens a file.
        word = 4 if any(variable[2] == "f" for variable in self.variables) else 8
        out += self._list(ATTRIBUTES, [self._attribute("title", "made by hand"),
                                       self._number("api_version", "f", 5.14),
                                       self._number("version", "f", 5.14),
                                       self._number("floating_point_word_size", "i", word),
                                       self._number("file_size", "i", self.apart)])
        variables = []
        for (name, shape, letter, values, attributes), begin in zip(self.variables, begins):
            entry = self._name(name) + self._count(len(shape))
            entry += b"".join(self._count(names.index(dimension)) for dimension in shape)
            entry += self._list(ATTRIBUTES, [self._attribute(*pair) for pair in attributes.items()])
            entry += struct.pack(">i", TYPES[letter])
            entry += self._count(len(self._values(letter, values)))
            entry += struct.pack(">i" if self.version == 1 else ">q", begin)
            variables.append(entry)
        return out + self._list(VARIABLES, variables)

    def bytes(self):
        at = len(self._header([0] * len(self.variables)))
        begins = []
        # Variables with a slice per time step stand last.
        for name, shape, letter, values, _ in sorted(self.variables, key=self._is_record):
            begins.append((name, at))
            at += len(self._values(letter, values))
        begins = dict(begins)
        out = self._header([begins[variable[0]] for variable in self.variables])
        for _, _, letter, values, _ in sorted(self.variables, key=self._is_record):
            out += self._values(letter, values)
        return out

    def _is_record(self, variable):
        return bool(variable[1]) and self.dimensions[variable[1][0]] == 0


def names(texts, width=16):
    return [text.encode().ljust(width, b"\0") for text in texts]


def add_nodes(file, points, letter, together=False):
    file.dimension("time_step", 0)
    file.dimension("num_dim", len(points[0]))
    file.dimension("num_nodes", len(points))
    if together:
        file.apart = 0
        values = [p[k] for k in range(len(points[0])) for p in points]
        file.variable("coord", ["num_dim", "num_nodes"], letter, values)
        return
    for k, axis in enumerate("xyz"[:len(points[0])]):
        file.variable(f"coord{axis}", ["num_nodes"], letter, [p[k] for p in points])


def add_blocks(file, blocks, letter="i"):
    """blocks: type, elements."""
    file.dimension("num_el_blk", len(blocks))
    file.variable("eb_prop1", ["num_el_blk"], "i", range(10, 10 * len(blocks) + 10, 10))
    for i, (kind, elements) in enumerate(blocks, 1):
        file.dimension(f"num_el_in_blk{i}", len(elements))
        file.dimension(f"num_nod_per_el{i}", len(elements[0]))
        file.variable(f"connect{i}", [f"num_el_in_blk{i}", f"num_nod_per_el{i}"], letter,
                      [node for element in elements for node in element], elem_type=kind)


def mixed():
    """A hex, a wedge beside it, a pyramid and a tet on top, a shell and a bar; maps and sets."""
    points = [(x, y, z) for z in (0., 1.) for y in (0., 1.) for x in (0., 1.)]
    points += [(2., .5, 0.), (2., .5, 1.), (.5, .5, 2.), (1.5, .5, 2.1), (.4, .6, -1.)]
    file = Netcdf(2)
    file.steps = 1
    file.dimension("len_name", 16)
    add_nodes(file, points, "d")
    add_blocks(file, [("HEX", [(1, 2, 4, 3, 5, 6, 8, 7)]), ("WEDGE", [(2, 9, 4, 6, 10, 8)]),
                      ("PYRAMID", [(5, 6, 8, 7, 11)]), ("TETRA", [(6, 8, 11, 12)]),
                      ("SHELL4", [(1, 2, 4, 3)]), ("BEAM", [(1, 13)])])
    file.variable("eb_names", ["num_el_blk", "len_name"], "c",
                  names(["body", "", "", "", "skin", ""]))
    file.dimension("num_elem", 6)
    file.variable("elem_num_map", ["num_elem"], "i", [101, 102, 103, 104, 105, 106])
    file.variable("node_num_map", ["num_nodes"], "i", range(501, 514))
    file.dimension("num_node_sets", 1)
    file.dimension("num_nod_ns1", 2)
    file.variable("ns_prop1", ["num_node_sets"], "i", [7])
    file.variable("node_ns1", ["num_nod_ns1"], "i", [11, 12])
    file.dimension("num_side_sets", 1)
    file.dimension("num_side_ss1", 3)
    file.variable("ss_prop1", ["num_side_sets"], "i", [4])
    file.variable("ss_names", ["num_side_sets", "len_name"], "c", names(["inlet"]))
    file.variable("elem_ss1", ["num_side_ss1"], "i", [1, 2, 5])
    file.variable("side_ss1", ["num_side_ss1"], "i", [1, 4, 3])
    file.variable("time_whole", ["time_step"], "d", [0.5])
    file.variable("vals_nod_var1", ["time_step", "num_nodes"], "d", range(13))
    return file


def plane():
    """Four triangles and a quad in the plane, floats, all coordinates in one array."""
    file = Netcdf(1)
    add_nodes(file, [(0., 0.), (1., 0.), (1., 1.), (0., 1.), (.4, .3), (2., 0.), (2., 1.)], "f",
              together=True)
    add_blocks(file, [("TRI3", [(1, 2, 5), (2, 3, 5), (3, 4, 5), (4, 1, 5)]),
                      ("QUAD", [(2, 6, 7, 3)])])
    file.dimension("num_side_sets", 1)
    file.dimension("num_side_ss1", 1)
    file.variable("ss_prop1", ["num_side_sets"], "i", [3])
    file.variable("elem_ss1", ["num_side_ss1"], "i", [5])
    file.variable("side_ss1", ["num_side_ss1"], "i", [2])
    return file


HEX27 = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1),
         (-1, 1, 1), (0, -1, -1), (1, 0, -1), (0, 1, -1), (-1, 0, -1), (-1, -1, 0), (1, -1, 0),
         (1, 1, 0), (-1, 1, 0), (0, -1, 1), (1, 0, 1), (0, 1, 1), (-1, 0, 1), (0, 0, 0), (0, 0, -1),
         (0, 0, 1), (-1, 0, 0), (1, 0, 0), (0, -1, 0), (0, 1, 0)]


def second_order():
    """Eight straight hexes of 27 nodes, the corner in the middle pushed aside; numbers of 8 bytes."""
    numbers, elements = {}, []
    for offset in itertools.product((0, 2), repeat=3):
        element = []
        for place in HEX27:
            at = tuple(o + p + 1 for o, p in zip(offset, place))
            element.append(numbers.setdefault(at, len(numbers) + 1))
        elements.append(element)
    file = Netcdf(5)
    pushed = [math.prod(1 - abs(x - 2) / 2 for x in at) for at in numbers]
    add_nodes(file, [tuple(x / 4 + share * by for x, by in zip(at, (.1, -.05, .06)))
                     for at, share in zip(numbers, pushed)], "d")
    add_blocks(file, [("HEX27", elements)], "q")
    return file


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, file in (("mixed", mixed()), ("plane", plane()), ("second_order", second_order())):
        (folder / f"{name}.e").write_bytes(file.bytes())


main()

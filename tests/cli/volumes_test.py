#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Meshes of tools/make_volumes.py are what they were asked to be.

usage: volumes_test.py PROGRAM
"""
import collections
import pathlib
import re
import subprocess
import sys
import tempfile

MAKER = pathlib.Path(__file__).resolve().parent.parent.parent / "tools/make_volumes.py"
PROGRAM = sys.argv[1] if len(sys.argv) == 2 else sys.exit(__doc__)

KINDS = ("hex_cube", "hex_cylinder", "tet_cube", "mixed")
FACES = {  # by the number of vertices of a cell
    4: ((0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3)),
    5: ((0, 1, 2, 3), (0, 1, 4), (1, 2, 4), (2, 3, 4), (0, 3, 4)),
    6: ((0, 1, 2), (3, 4, 5), (0, 1, 3, 4), (1, 2, 4, 5), (0, 2, 3, 5)),
    8: ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 4, 5), (1, 2, 5, 6), (2, 3, 6, 7), (0, 3, 4, 7)),
}


def make(*arguments):
    return subprocess.run([sys.executable, MAKER, *map(str, arguments)], capture_output=True,
                          text=True, check=False)


def mesh_of(*arguments):
    """Points, cells and the text itself."""
    made = make(*arguments)
    assert made.returncode == 0, made.stderr
    lines = iter(made.stdout.splitlines())
    count = next(int(line.split()[1]) for line in lines if line.startswith("POINTS "))
    points = [tuple(map(float, next(lines).split())) for _ in range(count)]
    count = int(next(lines).split()[1])
    cells = [tuple(map(int, next(lines).split()[1:])) for _ in range(count)]
    return points, cells, made.stdout


def measured(text, folder):
    """What the program finds: the number of inverted cells and the worst scaled Jacobian."""
    path = folder / "mesh.vtk"
    path.write_text(text)
    done = subprocess.run([PROGRAM, "check", path], capture_output=True, text=True, check=False)
    assert done.returncode in (0, 4), done.stderr
    count = re.search(r"inverted cells +([\d,]+)", done.stdout)[1].replace(",", "")
    return int(count), float(re.search(r"scaled_jacobian +([-.\d]+)", done.stdout)[1])


def on_skin(kind, corners):
    if kind == "hex_cylinder":
        round_about = all(abs(x * x + y * y - 1) < 1e-15 for x, y, _ in corners)
        return round_about or {z for _, _, z in corners} in ({0.0}, {2.0})
    return any({corner[axis] for corner in corners} in ({0.0}, {1.0}) for axis in range(3))


def check_faces(kind, points, cells):
    """Cells meet in whole faces, and what is open is the skin of the figure."""
    seen = collections.Counter(frozenset(cell[v] for v in face)
                               for cell in cells for face in FACES[len(cell)])
    assert set(seen.values()) == {1, 2}, kind
    open_faces = [face for face, times in seen.items() if times == 1]
    assert all(on_skin(kind, [points[v] for v in face]) for face in open_faces), kind


def check_kind(kind, folder):
    points, cells, text = mesh_of(kind, 800, "--jitter", 0.6)
    assert 0.9 * 800 < len(points) < 1.1 * 800, (kind, len(points))
    assert set(map(len, cells)) == {"hex_cube": {8}, "hex_cylinder": {8}, "tet_cube": {4},
                                    "mixed": {4, 5, 6, 8}}[kind]
    check_faces(kind, points, cells)
    count, worst = measured(text, folder)
    assert count == 0 and 0.03 < worst < 0.1, (kind, count, worst)
    assert text == mesh_of(kind, 800, "--jitter", 0.6, "--seed", 1)[2], kind
    assert points != mesh_of(kind, 800, "--jitter", 0.6, "--seed", 2)[0], kind
    _, cells, text = mesh_of(kind, 800, "--tangle", 0.1)
    share = measured(text, folder)[0] / len(cells)
    print(f"{kind}: asked for 0.1, {share:.4f} inverted")
    assert abs(share - 0.1) < 0.005, (kind, share)


def main():
    with tempfile.TemporaryDirectory() as folder:
        for kind in KINDS:
            check_kind(kind, pathlib.Path(folder))
    for arguments in (("hex_cube", 5), ("ball", 100), ("tet_cube", 100, "--tangle", 1),
                      ("tet_cube", 100, "--tangle", 0.95),
                      ("tet_cube", 100, "--tangle", 0.1, "--jitter", 0.1)):
        made = make(*arguments)
        assert made.returncode != 0 and made.stderr and not made.stdout, arguments


main()

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Equations on a smoothed mesh are solved in fewer iterations and to a smaller error.

usage: poisson_test.py PROGRAM EXAMPLE

EXAMPLE is examples/poisson.cpp, which is tested here too, on meshes of tools/make_volumes.py.
docs/finite_elements.md tells what is done here, with more vertices.
"""
import itertools
import json
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
MAKER = ROOT / "tools/make_volumes.py"
PROGRAM, EXAMPLE = sys.argv[1:] if len(sys.argv) == 3 else sys.exit(__doc__)


def make(folder, *arguments):
    path = folder / ("_".join(arguments) + ".vtk")
    subprocess.run([sys.executable, MAKER, *arguments, "-o", path], check=True)
    return path


def solve(path, *options):
    done = subprocess.run([EXAMPLE, path, "--json", *options], capture_output=True, text=True,
                          check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def smoothed(path):
    even = path.with_name("even_" + path.name)
    subprocess.run([PROGRAM, path, "-o", even], capture_output=True, check=True)
    return even


def check_refused(status, words, *arguments):
    done = subprocess.run([EXAMPLE, *arguments], capture_output=True, text=True, check=False)
    assert done.returncode == status, (arguments, done)
    assert all(word in done.stderr for word in words), done.stderr
    assert done.stderr.count("\n") == 1 and not done.stdout, done


def check_smoothing_helps(folder):
    for kind in ("tet_cube", "hex_cylinder"):
        poor = make(folder, kind, "1500", "--jitter", "0.5")
        even = smoothed(poor)
        before, after = solve(poor), solve(even)
        print(f"{kind}: {before} -> {after}")
        for method in ("plain", "jacobi"):
            for figure in ("iterations", "condition"):
                assert after[method][figure] < before[method][figure], (kind, method, figure)
        for error in ("l2_error", "h1_error"):
            assert after[error] < before[error], (kind, error)
        # Linear elements of any shape have a linear function exactly.
        for path in (poor, even):
            linear = solve(path, "--linear")
            assert max(linear["greatest_error"], linear["h1_error"]) < 1e-8, linear


def check_errors_fall_as_the_theory_says(folder):
    for kind in ("tet_cube", "hex_cube"):
        coarse, fine = (solve(make(folder, kind, str(side ** 3))) for side in (9, 17))
        assert fine["unknowns"] == 15 ** 3
        h1, l2 = (coarse[error] / fine[error] for error in ("h1_error", "l2_error"))
        assert 1.9 < h1 < 2.1 and 3.8 < l2 < 4.2, (kind, h1, l2)


def grid_condition(side, eigenvalue):
    """Of a grid whose eigenvectors are products of sines, from the eigenvalue of each."""
    angles = [math.pi * k / (side - 1) for k in range(1, side - 1)]
    values = [eigenvalue(*angle) for angle in itertools.product(angles, repeat=3)]
    return max(values) / min(values)


def check_condition(folder):
    side = 9

    def stiffness(t):
        return 2 - 2 * math.cos(t)

    def mass(t):
        return (2 + math.cos(t)) / 3

    def seven_points(*angles):  # which is what six tets in a block come to
        return sum(map(stiffness, angles))

    def trilinear(a, b, c):
        return sum(stiffness(p) * mass(q) * mass(r)
                   for p, q, r in ((a, b, c), (b, c, a), (c, a, b)))

    for kind, eigenvalue in (("tet_cube", seven_points), ("hex_cube", trilinear)):
        expected = grid_condition(side, eigenvalue)
        found = solve(make(folder, kind, str(side ** 3)))
        for method in ("plain", "jacobi"):  # the diagonal is the same everywhere
            value = found[method]["condition"]
            assert 0.99 * expected < value < 1.0001 * expected, (kind, method, value, expected)


def check_left_handed_file(folder):
    path = make(folder, "hex_cube", "300", "--jitter", "0.3")
    lines = path.read_text().splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith("POINTS ")) + 1
    for i in range(first, first + int(lines[first - 1].split()[1])):
        lines[i] = "-" + lines[i]
    mirrored = path.with_name("mirrored.vtk")
    mirrored.write_text("\n".join(lines) + "\n")
    assert solve(mirrored, "--linear")["greatest_error"] < 1e-8
    condition, expected = (solve(each)["jacobi"]["condition"] for each in (mirrored, path))
    assert abs(condition / expected - 1) < 1e-3, (condition, expected)


def check_bad_input(folder):
    tangled = make(folder, "hex_cube", "500", "--tangle", "0.05")
    check_refused(1, ("cell ", "(line ", " is inverted"), tangled)
    check_refused(1, ("takes tets and hexes",), make(folder, "mixed", "200"))
    check_refused(1, ("no tets and no hexes",), ROOT / "data/soccerball.obj")
    check_refused(1, ("missing.vtk",), folder / "missing.vtk")
    check_refused(2, ("usage",))
    check_refused(2, ("usage",), tangled, "--nonsense")
    lone = folder / "lone.mesh"
    lone.write_text("MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                    "0 0 1 0\nTetrahedra 1\n1 2 3 4 0\nEnd\n")
    check_refused(1, ("on the skin",), lone)
    curved = folder / "curved.inp"
    nodes = "0,0,0 2,0,0 0,2,0 0,0,2 1,0,0 1,1,0 0,1,0 0,0,1 1,0,1 0,1,1".split()
    curved.write_text("*NODE\n" + "".join(f"{i},{node}\n" for i, node in enumerate(nodes, 1))
                      + "*ELEMENT, TYPE=C3D10\n1,1,2,3,4,5,6,7,8,9,10\n")
    check_refused(1, ("second order",), curved)


def main():
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        check_smoothing_helps(folder)
        check_errors_fall_as_the_theory_says(folder)
        check_condition(folder)
        check_left_handed_file(folder)
        check_bad_input(folder)


main()

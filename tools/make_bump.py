#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the unit square with a tall, narrow bump pushed in from below, as OBJ.

usage: make_bump.py [--cells N] [--triangles] [--boundary-only] FILE

The bump is Gaussian, .75 high, with a standard deviation of .05. Columns of vertices are shifted
along so that all cells are valid; with --boundary-only nothing but the bottom is moved, which leaves
cells inverted.
"""
import argparse
import math

HEIGHT, WIDTH = 0.75, 0.05


def points(n, boundary_only):
    for j in range(n + 1):
        for i in range(n + 1):
            x, y = i / n, j / n
            bump = HEIGHT * math.exp(-((x - 0.5) / WIDTH) ** 2 / 2)
            share = float(j == 0) if boundary_only else 1 - y
            yield x, y + share * bump


def cells(n, triangles):
    for j in range(n):
        for i in range(n):
            a = j * (n + 1) + i + 1
            b, c, d = a + 1, a + n + 2, a + n + 1
            if triangles:
                yield a, b, c
                yield a, c, d
            else:
                yield a, b, c, d


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cells", type=int, default=100, metavar="N", help="along each side (100)")
    parser.add_argument("--triangles", action="store_true")
    parser.add_argument("--boundary-only", action="store_true")
    parser.add_argument("file")
    arguments = parser.parse_args()
    if arguments.cells < 1:
        parser.error("there must be at least 1 cell along each side")
    with open(arguments.file, "w", encoding="ascii") as out:
        for x, y in points(arguments.cells, arguments.boundary_only):
            out.write(f"v {x!r} {y!r} 0\n")
        for cell in cells(arguments.cells, arguments.triangles):
            out.write("f " + " ".join(map(str, cell)) + "\n")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes tests/quality/golden.json: cells and what VTK's vtkMeshQuality says about them.

    apt-get install python3-vtk9        # 9.1 on Debian 12
    /usr/bin/python3 tools/make_quality_golden.py tests/quality/golden.json

Only this script needs VTK; the test reads the committed file. The cells are random with a fixed
seed and have few digits, so that a second run writes the same bytes.

An angle is left out (null) where one of the cell's angles is within 0.01 degrees of 0 or 180: VTK
takes an arc cosine there and has fewer than nine digits itself.
"""
import json
import math
import random
import sys

import vtk

KINDS = {  # kind: VTK cell, prefix of the functions, metrics that VTK has, ideal cell
    "triangle": (vtk.vtkTriangle, "Triangle", ("shape", "scaled_jacobian", "min_angle",
                 "max_angle", "aspect_ratio", "edge_ratio"),
                 [(0, 0, 0), (1, 0, 0), (0.5, math.sqrt(0.75), 0)]),
    "quad": (vtk.vtkQuad, "Quad", ("shape", "scaled_jacobian", "min_angle", "max_angle",
             "aspect_ratio", "edge_ratio"),
             [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]),
    "tet": (vtk.vtkTetra, "Tet", ("shape", "scaled_jacobian", "min_angle", "aspect_ratio",
            "edge_ratio"),
            [(0, 0, 0), (1, 0, 0), (0.5, math.sqrt(0.75), 0),
             (0.5, math.sqrt(0.75) / 3, math.sqrt(2 / 3))]),
    # VTK 9.1 has an edge ratio of hexes, too, but overlooks some of their edges.
    "hex": (vtk.vtkHexahedron, "Hex", ("shape", "scaled_jacobian"),
            [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
             (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]),
}
FUNCTIONS = {"shape": "Shape", "scaled_jacobian": "ScaledJacobian", "min_angle": "MinAngle",
             "max_angle": "MaxAngle", "aspect_ratio": "AspectRatio", "edge_ratio": "EdgeRatio"}
ANGLES = ("min_angle", "max_angle")
SEED = 20110708


def vtk_cell(kind, points):
    cell = KINDS[kind][0]()
    cell.GetPoints().SetDataTypeToDouble()
    cell.GetPoints().SetNumberOfPoints(len(points))
    for i, point in enumerate(points):
        cell.GetPoints().SetPoint(i, point)
    return cell


def vtk_values(kind, points):
    """All measures VTK has for the cell, by our names."""
    _, prefix, metrics, _ = KINDS[kind]
    cell = vtk_cell(kind, points)
    values = {m: getattr(vtk.vtkMeshQuality, prefix + FUNCTIONS[m])(cell) for m in metrics}
    if kind == "tet":  # VTK 9.1 overlooks the edges 0-2 and 1-3
        turned = vtk_cell(kind, [points[i] for i in (1, 2, 0, 3)])
        values["min_angle"] = min(values["min_angle"], vtk.vtkMeshQuality.TetMinAngle(turned))
    if any(m in values and not 0.01 < values[m] % 180 < 179.99 for m in ANGLES):
        values.update({m: None for m in ANGLES if m in values})
    return values


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def is_bow_tie(p):
    """Whether two corners of a quad point against its mean normal, so that its sides cross."""
    normal = cross(minus(p[2], p[0]), minus(p[3], p[1]))
    corners = (cross(minus(p[i], p[i - 1]), minus(p[(i + 1) % 4], p[i])) for i in range(4))
    return sum(dot(normal, c) < 0 for c in corners) > 1


def rotation(rng):
    """A random rotation from a random quaternion."""
    w, x, y, z = (rng.gauss(0, 1) for _ in range(4))
    n = math.sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = w / n, x / n, y / n, z / n
    return ((1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
            (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
            (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)))


def placed(points, rng, size=1.0, offset=0.0, digits=7):
    """The points rotated, scaled, moved and rounded to a few digits of the size."""
    r = rotation(rng)
    shift = [offset * rng.uniform(-1, 1) for _ in range(3)]
    decimals = digits - math.floor(math.log10(size))
    return [tuple(round(size * sum(a * b for a, b in zip(row, p)) + s, decimals)
                  for row, s in zip(r, shift)) for p in points]


def shaken(points, rng, amount, planar):
    return [tuple(x + (0 if planar and k == 2 else rng.uniform(-amount, amount))
                  for k, x in enumerate(p)) for p in points]


def stretched(points, factors):
    return [tuple(x * f for x, f in zip(p, factors)) for p in points]


def candidates(kind, rng):
    """Good, poor, sliver, nearly degenerate, far, small and large cells, in this order."""
    ideal = KINDS[kind][3]
    surface = kind in ("triangle", "quad")
    yield "ideal", ideal
    for amount in (0.05, 0.2, 0.35, 0.6):
        for _ in range(12):
            yield f"shaken {amount}", placed(shaken(ideal, rng, amount, surface), rng)
    for factor in (1e-1, 1e-2, 1e-3):
        for _ in range(5):
            cell = stretched(shaken(ideal, rng, 0.3, surface), (1, factor, 1))
            yield f"sliver {factor}", placed(cell, rng, digits=10)
    for gap in (1e-2, 1e-4, 1e-6):
        for _ in range(3):  # two corners nearly meet
            cell = shaken(ideal, rng, 0.1, surface)
            cell[1] = tuple(a + gap * rng.uniform(0.5, 1) for a in cell[0])
            if surface:
                cell[1] = (cell[1][0], cell[0][1], 0)
            yield f"short edge {gap}", placed(cell, rng, digits=12)
    for offset in (1e2, 1e4, 1e6):
        for _ in range(4):
            yield f"far {offset}", placed(shaken(ideal, rng, 0.2, surface), rng, offset=offset)
    for size in (1e-6, 1e-3, 1e3, 1e6):
        for _ in range(4):
            yield f"size {size}", placed(shaken(ideal, rng, 0.25, surface), rng, size=size)
    if kind == "quad":
        for amount in (0.05, 0.2, 0.4):
            for _ in range(8):
                yield f"warped {amount}", placed(shaken(ideal, rng, amount, False), rng)
        for _ in range(8):  # the third corner turns inwards
            x = rng.uniform(0.15, 0.45)
            cell = [(0, 0, 0), (1, 0, 0), (x, rng.uniform(0.1, 0.9 - x), 0), (0, 1, 0)]
            yield "concave", placed(cell, rng)
    if kind == "hex":
        yield "worst at the centre", [
            (-0.83, 0.68, 0.2), (0.54, -0.24, 0.54), (1.48, 1.96, -0.22), (-0.16, 0.13, 0.6),
            (0.01, 0.99, 0.13), (0.39, -0.76, 0.59), (1.15, 0.88, 0.12), (-0.01, 0.61, 0.12)]


def main(path):
    rng = random.Random(SEED)
    cells = []
    for kind in KINDS:
        for what, points in candidates(kind, rng):
            if kind == "quad" and is_bow_tie(points):
                continue  # VTK's largest angle is not one of its corners
            cells.append({"kind": kind, "what": what, "points": points,
                          "values": vtk_values(kind, points)})
    head = {"vtk": vtk.vtkVersion.GetVTKVersion(), "seed": SEED}
    with open(path, "w", encoding="ascii") as file:
        file.write(json.dumps(head)[:-1] + ', "cells": [\n')
        file.write(",\n".join(json.dumps(cell) for cell in cells) + "\n]}\n")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])

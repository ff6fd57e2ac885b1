#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prints data/plate_with_hole.inp: a CalculiX deck whose hole was moved without its mesh.

usage: make_plate_deck.py [--meshed-anew]

A plate of 120 x 60 x 1 mm with a hole of radius 8 mm, pulled by 100 MPa, in CPS8 elements. The hole
was in the middle; then somebody moved the nodes on its edge by 5 mm, and the first row of elements
on that side turned inside out. --meshed-anew prints the same deck with all nodes where the mesher
puts them for the moved hole.
"""
import math
import sys

LENGTH, HEIGHT, RADIUS = 120.0, 60.0, 8.0
MOVED = 5.0
AROUND, ROWS = 32, 6  # elements
FIRST_NODE, FIRST_ELEMENT = 1001, 5001  # numbers do not begin at 1, as in any real deck


def rim(turn):
    """The point of the plate's rim in that direction from its middle, turn in [0, 1)."""
    corner = AROUND // 8
    step = turn * AROUND
    side, along = divmod(step + corner, 2 * corner)
    along = along / corner - 1.0
    x, y = ((LENGTH / 2, along * HEIGHT / 2), (-along * LENGTH / 2, HEIGHT / 2),
            (-LENGTH / 2, -along * HEIGHT / 2), (along * LENGTH / 2, -HEIGHT / 2))[int(side) % 4]
    return x, y


def at_hole(step, hole):
    angle = 2 * math.pi * step / (2 * AROUND)
    return hole + RADIUS * math.cos(angle), RADIUS * math.sin(angle)


def between(a, b, share=0.5):
    return tuple(x + share * (y - x) for x, y in zip(a, b))


def place(ring, step, edge, mesh):
    """A node: `ring` from 0 at the hole to 2 * ROWS at the rim, `step` around, both even at corners.

    The edge of the hole is around `edge`; the other corners were made for a hole around `mesh`.
    """
    if ring == 0:
        return at_hole(step, edge)
    if ring % 2 == 1:
        return between(place(ring - 1, step, edge, mesh), place(ring + 1, step, edge, mesh))
    if step % 2 == 1:
        return between(place(ring, step - 1, edge, mesh), place(ring, step + 1, edge, mesh))
    share = ring / (2 * ROWS)
    share *= 0.25 + 0.75 * share  # rows are thin at the hole
    return between(at_hole(step, mesh), rim(step / (2 * AROUND)), share)


def rows_of(numbers, per_line=8):
    for i in range(0, len(numbers), per_line):
        yield ", ".join(str(n) for n in numbers[i:i + per_line])


def main():
    meshed_anew = sys.argv[1:] == ["--meshed-anew"]
    if sys.argv[1:] and not meshed_anew:
        sys.exit(__doc__)
    around = 2 * AROUND
    numbers, lines = {}, []
    for ring in range(2 * ROWS + 1):
        for step in range(0, around, 1 + ring % 2):
            numbers[ring, step] = FIRST_NODE + len(numbers)
            x, y = place(ring, step, MOVED, MOVED if meshed_anew else 0.0)
            lines.append(f"{numbers[ring, step]}, {x:.6f}, {y:.6f}, 0.0")
    elements = []
    for row in range(ROWS):
        for column in range(AROUND):
            r, s = 2 * row, 2 * column
            e = (s + 2) % around
            corners = [(r, s), (r + 2, s), (r + 2, e), (r, e)]
            middles = [(r + 1, s), (r + 2, s + 1), (r + 1, e), (r, s + 1)]
            elements.append([numbers[key] for key in corners + middles])

    last = 2 * ROWS
    on_rim = {step: place(last, step, 0.0, 0.0) for step in range(around)}
    left = [numbers[last, s] for s, (x, _) in on_rim.items() if x < 1e-6 - LENGTH / 2]
    pin = [numbers[last, s] for s, (x, y) in on_rim.items()
           if x < 1e-6 - LENGTH / 2 and abs(y) < 1e-6]
    right = [FIRST_ELEMENT + (ROWS - 1) * AROUND + column for column in range(AROUND)
             if on_rim[2 * column + 1][0] > LENGTH / 2 - 1e-6]
    end = [numbers[last, s] for s, (x, _) in on_rim.items() if x > LENGTH / 2 - 1e-6]

    print("** A plate with a hole, pulled by 100 MPa. N, mm, MPa.")
    print("*HEADING\nPlate with a hole, revision B: hole moved by 5 mm")
    print("*NODE, NSET=NALL")
    print("\n".join(lines))
    print("*ELEMENT, TYPE=CPS8, ELSET=PLATE")
    for i, nodes in enumerate(elements):
        print(f"{FIRST_ELEMENT + i}, " + ", ".join(map(str, nodes)))
    for kind, name, items in (("NSET", "LEFT", left), ("NSET", "PIN", pin), ("NSET", "END", end),
                              ("ELSET", "RIGHT", right)):
        print(f"*{kind}, {kind}={name}")
        print("\n".join(rows_of(items)))
    print("""*MATERIAL, NAME=STEEL
*ELASTIC
210000., 0.3
*SOLID SECTION, ELSET=PLATE, MATERIAL=STEEL
1.
*BOUNDARY
LEFT, 1, 1
PIN, 2, 2
** The face of each element at the right end
*STEP
*STATIC
*DLOAD
RIGHT, P2, -100.
*NODE PRINT, NSET=END
U
*EL PRINT, ELSET=PLATE
S
*END STEP""")


main()

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes a volume mesh of random cells: valid but poor ones, or tangled ones. VTK, legacy text.

usage: make_volumes.py KIND N [--jitter SHARE [--least D] | --tangle SHARE] [--seed S] [-o FILE]

N is about how many vertices there are. Kinds:

  hex_cube      a unit cube of blocks
  hex_cylinder  a round cylinder, radius 1, height 2: a square of blocks amid four rings of them
  tet_cube      a unit cube of blocks, each cut into the six tets around its diagonal
  mixed         a unit cube: from left to right hexes, wedges, pyramids and tets

Vertices on the skin stay where they are. Those inside move at random along each axis:

  --jitter SHARE  by up to this share of the cell size there, less where a cell would become
                  too flat: at each corner det(a, b, c) >= D |a| |b| |c| for its edges, 0.05 unless
                  --least says another
  --tangle SHARE  by as much as it takes to turn over this share of the cells

The same arguments give the same bytes. Needs nothing but Python; 250,000 vertices take 10 to 25 s
of CPU time.
"""
import argparse
import math
import random
import sys

SAMPLE = 20_000  # cells that are looked at to find out how far tangled vertices move
FARTHEST = 4.0  # cell sizes

# By the number of vertices of a cell, which is different for each kind: its corners and the ends of
# the three edges there, right-handed. A pyramid has four edges at its tip, which is no corner here.
CORNERS = {
    4: ((0, 1, 2, 3), (1, 2, 0, 3), (2, 0, 1, 3), (3, 0, 2, 1)),
    5: ((0, 1, 3, 4), (1, 2, 0, 4), (2, 3, 1, 4), (3, 0, 2, 4)),
    6: ((0, 1, 2, 3), (1, 2, 0, 4), (2, 0, 1, 5), (3, 5, 4, 0), (4, 3, 5, 1), (5, 4, 3, 2)),
    8: ((0, 1, 3, 4), (1, 2, 0, 5), (2, 3, 1, 6), (3, 0, 2, 7),
        (4, 7, 5, 0), (5, 4, 6, 1), (6, 5, 7, 2), (7, 6, 4, 3)),
}
VTK_TYPES = {4: 10, 5: 14, 6: 13, 8: 12}

# The faces of a block seen from outside, each from an end of the diagonal that tets cut it along.
LEFT, RIGHT = (0, 4, 7, 3), (1, 2, 6, 5)
FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (3, 7, 6, 2), LEFT, RIGHT)
AROUND_DIAGONAL = (1, 2, 3, 7, 4, 5, 1)  # of a block, 0 to 6


class Volume:
    """A mesh; beside each vertex whether it stays and how large the cells there are."""

    def __init__(self):
        self.points, self.cells, self.stays, self.sizes = [], [], [], []

    def add(self, point, stays, size):
        self.points.append(point)
        self.stays.append(stays)
        self.sizes.append(size)
        return len(self.points) - 1


# ---- shapes --------------------------------------------------------------------------------------
def lattice(columns, rows, layers):
    """The vertices of a unit cube."""
    volume = Volume()
    size = 1 / (max(columns, rows, layers) - 1)
    for k in range(layers):
        for j in range(rows):
            for i in range(columns):
                stays = (i in (0, columns - 1) or j in (0, rows - 1) or k in (0, layers - 1))
                volume.add((i / (columns - 1), j / (rows - 1), k / (layers - 1)), stays, size)
    return volume


def blocks(columns, rows, layers):
    """The vertices of each block in the order of a hex, and its column."""
    for k in range(layers - 1):
        for j in range(rows - 1):
            for i in range(columns - 1):
                a = (k * rows + j) * columns + i
                d, e = a + columns, a + columns * rows
                h = e + columns
                yield (a, a + 1, d + 1, d, e, e + 1, h + 1, h), i


def cube_counts(n):
    """Vertices along each axis."""
    side = max(3, round(n ** (1 / 3)))
    return side, side, max(3, round(n / side ** 2))


def hex_cube(n):
    counts = cube_counts(n)
    volume = lattice(*counts)
    volume.cells = [block for block, _ in blocks(*counts)]
    return volume


def tets_of(block):
    return [(block[0], block[a], block[b], block[6])
            for a, b in zip(AROUND_DIAGONAL, AROUND_DIAGONAL[1:])]


def tet_cube(n):
    counts = cube_counts(n)
    volume = lattice(*counts)
    for block, _ in blocks(*counts):
        volume.cells += tets_of(block)
    return volume


def wedges_of(b):
    return [(b[0], b[1], b[2], b[4], b[5], b[6]), (b[0], b[2], b[3], b[4], b[6], b[7])]


def star_of(block, tip, cut):
    """A pyramid from each face to the middle of the block, two tets from a face that is cut."""
    cells = []
    for face in FACES:
        a, b, c, d = (block[v] for v in face)
        cells += [(a, c, b, tip), (a, d, c, tip)] if face is cut else [(a, d, c, b, tip)]
    return cells


def mixed(n):
    """Wedges stand upright, so that their triangles lie on the skin. Between their quads and the
    tets' triangles are blocks with a vertex in the middle."""
    side = max(5, round((n / 1.25) ** (1 / 3)))
    wedge, star, tet = (max(1, round(share * (side - 1))) + part
                        for part, share in ((0, 0.25), (0, 0.5), (0, 0.75)))
    in_stars = (tet - star) * (side - 1)
    layers = max(3, round((n + in_stars) / (side ** 2 + in_stars)))
    volume = lattice(side, side, layers)
    for block, column in blocks(side, side, layers):
        if column < wedge:
            volume.cells.append(block)
        elif column < star:
            volume.cells += wedges_of(block)
        elif column < tet:
            low, high = volume.points[block[0]], volume.points[block[6]]
            middle = tuple((a + b) / 2 for a, b in zip(low, high))
            tip = volume.add(middle, False, 0.7 * volume.sizes[block[0]])
            volume.cells += star_of(block, tip, RIGHT if column == tet - 1 else None)
        else:
            volume.cells += tets_of(block)
    return volume


def disk(core, rings):
    """A round disk of quads: places, quads, and which vertices lie on the circle.

    The core is a square with `core` quads along each side, bent outwards; `rings` go around it.
    """
    places, number = [], {}
    for j in range(core + 1):
        for i in range(core + 1):
            x, y = 2 * i / core - 1, 2 * j / core - 1
            number[i, j] = len(places)
            # The sides bulge by a tenth of the radius, less towards the middle.
            places.append((x * (0.46 + 0.1 * (1 - y * y)), y * (0.46 + 0.1 * (1 - x * x))))
    quads = [(number[i, j], number[i + 1, j], number[i + 1, j + 1], number[i, j + 1])
             for j in range(core) for i in range(core)]

    inner = [number[i, 0] for i in range(core)] + [number[core, j] for j in range(core)]
    inner += [number[i, core] for i in range(core, 0, -1)]
    inner += [number[0, j] for j in range(core, 0, -1)]
    around = len(inner)
    rim = [(math.cos(angle), math.sin(angle))
           for angle in (math.pi * (2 * s / around - 0.75) for s in range(around))]
    before = inner
    for ring in range(1, rings + 1):
        share = ring / rings
        first = len(places)
        for v, (x, y) in zip(inner, rim):
            a, b = places[v]
            places.append((x, y) if ring == rings else (a + share * (x - a), b + share * (y - b)))
        after = list(range(first, len(places)))
        quads += [(before[s], after[s], after[(s + 1) % around], before[(s + 1) % around])
                  for s in range(around)]
        before = after
    return places, quads, set(before)


def shortest_sides(places, quads):
    """At each vertex."""
    sizes = [math.inf] * len(places)
    for quad in quads:
        for a, b in zip(quad, quad[1:] + quad[:1]):
            length = math.dist(places[a], places[b])
            sizes[a], sizes[b] = min(sizes[a], length), min(sizes[b], length)
    return sizes


def hex_cylinder(n):
    core = max(2, round((n / 5.4) ** (1 / 3)))  # 3 core^2 vertices in each of 1.8 core layers
    places, quads, rim = disk(core, max(2, round(core / 2)))
    layers = max(3, round(n / len(places)))
    height = 2 / (layers - 1)
    sizes = [min(size, height) for size in shortest_sides(places, quads)]
    volume = Volume()
    for k in range(layers):
        for v, (x, y) in enumerate(places):
            volume.add((x, y, k * height), v in rim or k in (0, layers - 1), sizes[v])
    for k in range(layers - 1):
        low, high = k * len(places), (k + 1) * len(places)
        volume.cells += [tuple(v + low for v in quad) + tuple(v + high for v in quad)
                         for quad in quads]
    return volume


KINDS = {"hex_cube": hex_cube, "hex_cylinder": hex_cylinder, "tet_cube": tet_cube, "mixed": mixed}


# ---- disturbing ----------------------------------------------------------------------------------
def worst_corner(cell, points):
    """The least det(a, b, c) / |a| |b| |c| at the corners, a, b, c the edges there."""
    worst = 1.0
    for at, p, q, r in CORNERS[len(cell)]:
        x, y, z = points[cell[at]]
        px, py, pz = points[cell[p]]
        qx, qy, qz = points[cell[q]]
        rx, ry, rz = points[cell[r]]
        px -= x; py -= y; pz -= z
        qx -= x; qy -= y; qz -= z
        rx -= x; ry -= y; rz -= z
        det = px * (qy * rz - qz * ry) + py * (qz * rx - qx * rz) + pz * (qx * ry - qy * rx)
        squares = ((px * px + py * py + pz * pz) * (qx * qx + qy * qy + qz * qz)
                   * (rx * rx + ry * ry + rz * rz))
        value = det / math.sqrt(squares) if squares > 0 else 0.0
        if value < worst:
            worst = value
    return worst


def random_moves(volume, seed):
    """For each vertex a move of up to one cell size along each axis."""
    number = random.Random(seed).random
    return [(0.0, 0.0, 0.0) if stays
            else tuple(size * (2 * number() - 1) for _ in range(3))
            for stays, size in zip(volume.stays, volume.sizes)]


def moved(point, move, share):
    return tuple(x + share * d for x, d in zip(point, move))


def jitter(volume, moves, share, least):
    """Moves all; takes a quarter of it back at the vertices of poor cells until there are none."""
    rest, shares = volume.points, [share] * len(volume.points)
    points = [moved(point, move, share) for point, move in zip(rest, moves)]
    poor = [cell for cell in volume.cells if worst_corner(cell, points) < least]
    while poor:
        blamed = set().union(*poor)
        for v in blamed:
            shares[v] *= 0.75
            points[v] = moved(rest[v], moves[v], shares[v])
        poor = [cell for cell in volume.cells
                if not blamed.isdisjoint(cell) and worst_corner(cell, points) < least]
    volume.points = points


def inverted_share(cells, points):
    return sum(worst_corner(cell, points) <= 0 for cell in cells) / len(cells)


def tangle(volume, moves, wanted):
    """Moves all so far that the wanted share of a sample of the cells is inverted."""
    sample = volume.cells[::max(1, len(volume.cells) // SAMPLE)]
    used = sorted(set().union(*sample))

    def share_at(amount):
        points = {v: moved(volume.points[v], moves[v], amount) for v in used}
        return inverted_share(sample, points)

    low, high = 0.0, FARTHEST
    most = share_at(high)
    if most < wanted:
        sys.exit(f"make_volumes.py: --tangle {wanted:g}: at most {most:.2f} of these cells turn "
                 "over; ask for less or for more vertices")
    for _ in range(20):
        amount = (low + high) / 2
        low, high = (amount, high) if share_at(amount) < wanted else (low, amount)
    volume.points = [moved(point, move, high) for point, move in zip(volume.points, moves)]


# ---- file ----------------------------------------------------------------------------------------
def write(volume, title, out):
    points, cells = volume.points, volume.cells
    out.write(f"# vtk DataFile Version 3.0\n{title}\nASCII\nDATASET UNSTRUCTURED_GRID\n")
    out.write(f"POINTS {len(points)} double\n")
    out.writelines(f"{x!r} {y!r} {z!r}\n" for x, y, z in points)
    out.write(f"CELLS {len(cells)} {sum(map(len, cells)) + len(cells)}\n")
    out.writelines(f"{len(cell)} {' '.join(map(str, cell))}\n" for cell in cells)
    out.write(f"CELL_TYPES {len(cells)}\n")
    out.writelines(f"{VTK_TYPES[len(cell)]}\n" for cell in cells)


def share_below(limit):
    def parse(text):
        value = float(text)
        if not 0 <= value < limit:
            raise argparse.ArgumentTypeError(f"{text} is not in [0, {limit:g})")
        return value
    return parse


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0],
                                     description=__doc__.split("\n")[0])
    parser.add_argument("kind", choices=KINDS)
    parser.add_argument("vertices", type=int)
    how = parser.add_mutually_exclusive_group()
    how.add_argument("--jitter", type=share_below(10), default=0.0)
    how.add_argument("--tangle", type=share_below(1), default=0.0)
    parser.add_argument("--least", type=share_below(0.2), default=0.05)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-o", "--output")
    args = parser.parse_args()
    if args.vertices < 27:
        parser.error(f"{args.vertices} vertices: ask for 27 or more")

    volume = KINDS[args.kind](args.vertices)
    moves = random_moves(volume, args.seed)
    if args.jitter:
        jitter(volume, moves, args.jitter, args.least)
    if args.tangle:
        tangle(volume, moves, args.tangle)
    title = (f"{args.kind} {args.vertices}, jitter {args.jitter:g}, least {args.least:g}, "
             f"tangle {args.tangle:g}, seed {args.seed}")
    if args.output:
        with open(args.output, "w", encoding="ascii") as out:
            write(volume, title, out)
    else:
        write(volume, title, sys.stdout)


if __name__ == "__main__":
    main()

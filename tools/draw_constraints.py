#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the schematic pictures of docs/constraints.md.

usage: draw_constraints.py [FOLDER]      (docs/pictures/constraints)

Squares are fixed vertices, circles with arrows slide along these, plain circles are free. What was
before is pale.
"""
import math
import pathlib
import sys

SIZE = 40  # pixels per unit
MESH, PALE, FIXED, SLIDES, FREE, GUIDE = (
    "#5b6770", "#c9d1d6", "#c0392b", "#1f77b4", "#ffffff", "#e08e0b")


class Drawing:
    def __init__(self, width, height):
        self.width, self.height, self.parts = width, height, []

    def at(self, p):
        return (p[0] + 0.6) * SIZE, (self.height - p[1] + 0.6) * SIZE

    def line(self, a, b, colour=MESH, width=1.5, dash="", arrow=False):
        (x1, y1), (x2, y2) = self.at(a), self.at(b)
        extra = f' stroke-dasharray="{dash}"' if dash else ""
        extra += ' marker-end="url(#tip)"' if arrow else ""
        self.parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" '
                          f'stroke="{colour}" stroke-width="{width}"{extra}/>')

    def path(self, points, colour=MESH, width=1.5, dash="", fill="none", close=False):
        text = " ".join("%.1f,%.1f" % self.at(p) for p in points)
        kind = "polygon" if close else "polyline"
        extra = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<{kind} points="{text}" fill="{fill}" stroke="{colour}" '
                          f'stroke-width="{width}"{extra}/>')

    def circle(self, centre, radius, colour=GUIDE, dash="4 3"):
        x, y = self.at(centre)
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius * SIZE:.1f}" fill="none" '
                          f'stroke="{colour}" stroke-width="1.5" stroke-dasharray="{dash}"/>')

    def fixed(self, p):
        x, y = self.at(p)
        self.parts.append(f'<rect x="{x - 5:.1f}" y="{y - 5:.1f}" width="10" height="10" '
                          f'fill="{FIXED}"/>')

    def free(self, p, colour=FREE):
        x, y = self.at(p)
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{colour}" '
                          f'stroke="{MESH}" stroke-width="1.5"/>')

    def slides(self, p, direction):
        length = math.hypot(*direction)
        d = [0.38 * c / length for c in direction]
        for sign in (1, -1):
            self.line(p, (p[0] + sign * d[0], p[1] + sign * d[1]), SLIDES, 2, arrow=True)
        self.free(p, SLIDES)

    def text(self, p, words):
        x, y = self.at(p)
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" font-family="sans-serif" font-size="13" '
                          f'text-anchor="middle" fill="#333">{words}</text>')

    def svg(self):
        w, h = (self.width + 1.2) * SIZE, (self.height + 1.2) * SIZE
        tip = ('<defs><marker id="tip" viewBox="0 0 6 6" refX="5" refY="3" markerWidth="4" '
               'markerHeight="4" orient="auto"><path d="M0,0 L6,3 L0,6 z" '
               'fill="context-stroke"/></marker></defs>')
        return "\n".join([
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{w:.0f}" height="{h:.0f}" '
            f'viewBox="0 0 {w:.0f} {h:.0f}">', tip,
            f'<rect width="{w:.0f}" height="{h:.0f}" fill="#ffffff"/>', *self.parts, "</svg>", ""])


def grid(columns, rows, place=lambda i, j: (i, j)):
    return [[place(i, j) for i in range(columns + 1)] for j in range(rows + 1)]


def draw_grid(drawing, points, colour=MESH, dash=""):
    for row in points:
        drawing.path(row, colour, dash=dash)
    for column in zip(*points):
        drawing.path(column, colour, dash=dash)


def mark_square(d, points):
    """Corners fixed, sides sliding, inside free."""
    last_row, last = len(points) - 1, len(points[0]) - 1
    for j, row in enumerate(points):
        for i, p in enumerate(row):
            side, end = i in (0, last), j in (0, last_row)
            if side and end:
                d.fixed(p)
            elif side or end:
                d.slides(p, (0, 1) if side else (1, 0))
            else:
                d.free(p)


def default():
    d = Drawing(11, 3)
    square = grid(3, 3)
    draw_grid(d, square)
    mark_square(d, square)
    ring = [[(8 + r * math.cos(t), 1.5 + r * math.sin(t))
             for t in [2 * math.pi * k / 12 for k in range(13)]] for r in (0.7, 1.5)]
    draw_grid(d, ring)
    for k in range(12):
        d.fixed(ring[0][k])
        d.fixed(ring[1][k])
    return d


def fix():
    d = Drawing(4, 3)
    points = grid(4, 3, lambda i, j: (i + (0.2 if 0 < i < 4 and 0 < j < 3 else 0), j))
    draw_grid(d, points)
    for j, row in enumerate(points):
        for i, p in enumerate(row):
            (d.fixed if i in (0, 4) or j in (0, 3) else d.free)(p)
    return d


def slide():
    d = Drawing(10, 3)
    angles = [2 * math.pi * (k + 0.18 * math.sin(2.1 * k)) / 12 for k in range(12)]
    ring = [[(1.5 + r * math.cos(t), 1.5 + r * math.sin(t)) for t in angles + angles[:1]]
            for r in (0.7, 1.5)]
    draw_grid(d, ring)
    d.circle((1.5, 1.5), 1.5)
    for t in angles:
        d.slides((1.5 + 1.5 * math.cos(t), 1.5 + 1.5 * math.sin(t)), (-math.sin(t), math.cos(t)))
    outline = [(5 + 5 * s, 1 + 0.9 * math.sin(3.4 * s)) for s in [k / 40 for k in range(41)]]
    d.path(outline, GUIDE, 1.5, "4 3")
    coarse = [outline[k] for k in (0, 5, 13, 18, 28, 34, 40)]
    d.path(coarse)
    for k, p in enumerate(coarse):
        if k in (0, 6):
            d.fixed(p)
        else:
            a, b = coarse[k - 1], coarse[k + 1]
            d.slides(p, (b[0] - a[0], b[1] - a[1]))
    return d


def symmetry():
    d = Drawing(4, 3)
    half = grid(2, 3, lambda i, j: (2 + i + (0.15 * math.sin(2 * j) if i else 0), j))
    draw_grid(d, [[(4 - x, y) for x, y in row] for row in half], PALE)
    draw_grid(d, half)
    d.line((2, -0.4), (2, 3.4), GUIDE, 2, "6 4")
    for row in half:
        d.slides(row[0], (0, 1))
    return d


def periodic():
    d = Drawing(4, 3)
    points = grid(4, 3, lambda i, j: (i, j + (0.15 * math.sin(3 * j) if i in (0, 4) else 0.1)))
    draw_grid(d, points)
    for row in points:
        for i in (0, 4):
            d.slides(row[i], (0.3, 1))
    for row in points:
        d.line((row[0][0] + 0.25, row[0][1]), (row[4][0] - 0.25, row[4][1]), GUIDE, 1.5, "2 4")
    return d


def max_move():
    d = Drawing(4, 3)
    before = grid(4, 3, lambda i, j: (i + 0.3 * math.sin(5 * i + 3 * j),
                                      j + 0.2 * math.cos(7 * i + j)))
    after = grid(4, 3)
    draw_grid(d, before, PALE)
    for row, other in zip(before, after):
        for p, q in zip(row, other):
            d.circle(p, 0.25)
            way = math.hypot(q[0] - p[0], q[1] - p[1])
            part = min(1, 0.25 / way) if way else 1
            end = (p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1]))
            d.line(p, end, SLIDES, 2, arrow=True)
    return d


def max_deviation():
    d = Drawing(5, 2.4)
    curve = [(2.5 - 2.5 * math.cos(t), 2.2 * math.sin(t))
             for t in [math.pi * k / 60 for k in range(61)]]
    d.path(curve, PALE, 26)
    d.path(curve, GUIDE, 1.5, "4 3")
    chain = [curve[k] for k in (0, 10, 21, 30, 42, 51, 60)]
    d.path(chain)
    for p in chain[1:-1]:
        d.free(p, SLIDES)
    for p in (chain[0], chain[-1]):
        d.fixed(p)
    return d


def min_area():
    d = Drawing(7, 2)
    d.path([(0, 0), (3, 0), (1.4, 0.25)], FIXED, 2, fill="#f6d5d1", close=True)
    d.text((1.5, -0.4), "too small")
    d.path([(4, 0), (7, 0), (5.4, 1.1)], MESH, 2, fill="#dbe9f4", close=True)
    d.line((5.4, 0), (5.4, 1.05), GUIDE, 1.5, "3 3")
    d.text((5.5, -0.4), "area &#8805; A")
    return d


def keep():
    d = Drawing(8, 2.4)
    turn = [2 * math.pi * k / 18 for k in range(18)]
    blob = [(1.6 + (1.1 + 0.25 * math.sin(3 * t)) * math.cos(t),
             1.2 + (1 + 0.2 * math.cos(5 * t)) * math.sin(t)) for t in turn]
    d.path(blob, MESH, 2, fill="#dbe9f4", close=True)
    d.text((1.6, 1.1), "A")
    d.line((3.2, 1.2), (4.4, 1.2), MESH, 2, arrow=True)
    disk = [(6.2 + 1.08 * math.cos(t), 1.2 + 1.08 * math.sin(t)) for t in turn]
    d.path(disk, MESH, 2, fill="#dbe9f4", close=True)
    d.text((6.2, 1.1), "A")
    return d


def equal_spacing():
    d = Drawing(6, 2)

    def curve(s):
        return 6 * s, 0.5 + 0.9 * math.sin(math.pi * s) ** 2
    before, after = (0, 0.05, 0.3, 0.38, 0.8, 1), (0, 0.2, 0.395, 0.605, 0.8, 1)
    for shift, marks in ((0.6, before), (-0.5, after)):
        d.path([(curve(k / 60)[0], curve(k / 60)[1] + shift) for k in range(61)], GUIDE, 1.5, "4 3")
        points = [(curve(s)[0], curve(s)[1] + shift) for s in marks]
        d.path(points)
        for k, p in enumerate(points):
            (d.fixed if k in (0, 5) else d.free)(p)
    return d


def prescribe():
    d = Drawing(4, 3.6)
    lift = [0, 0.25, 0.8, 0.25, 0]
    draw_grid(d, grid(4, 3), PALE)
    draw_grid(d, grid(4, 3, lambda i, j: (i, j + lift[i] * (j / 3) ** 1.3)))
    for i in range(5):
        if lift[i]:
            d.line((i, 3), (i, 3 + lift[i]), GUIDE, 2, arrow=True)
        d.fixed((i, 3 + lift[i]))
        d.fixed((i, 0))
    return d


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "docs/pictures/constraints")
    folder.mkdir(parents=True, exist_ok=True)
    for draw in (default, fix, slide, symmetry, periodic, max_move, max_deviation, min_area, keep,
                 equal_spacing, prescribe):
        (folder / f"{draw.__name__}.svg").write_text(draw().svg())


if __name__ == "__main__":
    main()

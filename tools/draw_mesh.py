#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws one mesh, or two side by side, as an SVG picture coloured by the shape of the cells.

usage: draw_mesh.py BEFORE [AFTER] -o PICTURE.svg [--view X,Y,Z] [--up X,Y,Z] [--zoom X0,Y0,X1,Y1]

Reads OBJ and STL. A planar mesh is drawn flat, a surface in parallel projection, lit from the
viewer's upper left. Colour is the inverse mean ratio at a cell's worst corner: 1 for the ideal
cell, 0 for a degenerate one; the cells of a planar mesh that are turned over are red. Both meshes
are drawn to the same scale.
"""
import argparse
import array
import html
import math
import pathlib
import struct

# Dark to light at an even pace, and told apart by every kind of colour vision.
COLOUR_POINTS = ["#36125f", "#3d4a8f", "#2b7d8c", "#46ab7b", "#a9d566", "#fff1a8"]
INVERTED_COLOUR = "#e0202f"
CLASSES = 20   # of shape
SHADES = 6     # of light, on surfaces

GAP, MARGIN, HEAD, FOOT, LEGEND = 28, 14, 34, 30, 56
UNITS = 10     # per pixel: coordinates are whole tenths of a pixel


# ---- vectors -------------------------------------------------------------------------------------
def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(dot(a, a))
    return (a[0] / length, a[1] / length, a[2] / length) if length > 0 else (0.0, 0.0, 0.0)


# ---- reading -------------------------------------------------------------------------------------
def read_obj(text):
    points, cells = [], []
    for line in text.replace("\\\n", " ").splitlines():
        words = line.split()
        if not words:
            continue
        if words[0] == "v":
            points.append(tuple(float(word) for word in words[1:4]))
        elif words[0] == "f":
            ids = [int(word.split("/")[0]) for word in words[1:]]
            cells.append([i - 1 if i > 0 else len(points) + i for i in ids])
    return points, cells


def read_stl(data):
    count = struct.unpack_from("<I", data, 80)[0] if len(data) >= 84 else -1
    if len(data) == 84 + 50 * count:
        corners = [facet[3 + k:6 + k] for facet in struct.iter_unpack("<12fH", data[84:])
                   for k in (0, 3, 6)]
    else:
        words = data.decode("utf-8", "replace").split()
        corners = [tuple(float(w) for w in words[i + 1:i + 4])
                   for i, word in enumerate(words) if word == "vertex"]
    points = list(dict.fromkeys(corners))
    number = {point: i for i, point in enumerate(points)}
    ids = [number[corner] for corner in corners]
    return points, [ids[i:i + 3] for i in range(0, len(ids), 3)]


def read_mesh(path):
    if path.suffix.lower() == ".stl":
        points, cells = read_stl(path.read_bytes())
    else:
        points, cells = read_obj(path.read_text(encoding="utf-8", errors="replace"))
    if not cells:
        raise SystemExit(f"{path}: no cells found; OBJ and STL files can be drawn")
    return points, cells


# ---- geometry ------------------------------------------------------------------------------------
def area_vector(corners):
    """Twice the area of a polygon times its unit normal."""
    total = (0.0, 0.0, 0.0)
    for a, b in zip(corners[1:], corners[2:]):
        c = cross(minus(a, corners[0]), minus(b, corners[0]))
        total = (total[0] + c[0], total[1] + c[1], total[2] + c[2])
    return total


def shape(corners, up):
    """Inverse mean ratio at the worst corner, against the regular polygon; 0 if not positive."""
    n = len(corners)
    angle = math.pi * (n - 2) / n
    least = 1.0
    for k in range(n):
        a = minus(corners[(k + 1) % n], corners[k])
        b = minus(corners[k - 1], corners[k])
        area = dot(cross(a, b), up)
        norm = dot(a, a) + dot(b, b) - 2 * math.cos(angle) * dot(a, b)
        if not area > 0 or not norm > 0:
            return 0.0
        least = min(least, 2 * math.sin(angle) * area / norm)
    return least


def find_plane(points):
    """The axis along which a planar mesh has no extent, None for a surface."""
    extents = [max(p[k] for p in points) - min(p[k] for p in points) for k in range(3)]
    flat = min(range(3), key=lambda k: extents[k])
    return flat if extents[flat] <= 1e-6 * max(extents) else None


class Camera:
    """A parallel projection: x to the right, y up, depth towards the viewer."""

    def __init__(self, view, up):
        self.towards = unit(view)
        self.right = unit(cross(up, self.towards))
        if self.right == (0.0, 0.0, 0.0):
            raise SystemExit("--view and --up must not point the same way")
        self.up = cross(self.towards, self.right)
        self.light = unit(tuple(0.75 * t + 0.5 * u - 0.4 * r
                                for t, u, r in zip(self.towards, self.up, self.right)))

    def project(self, p):
        return dot(p, self.right), dot(p, self.up), dot(p, self.towards)


# ---- what covers what ----------------------------------------------------------------------------
class Raster:
    """Per pixel one number: finds hidden faces, and faces that may be drawn in any order."""

    def __init__(self, width, height):
        self.width, self.height = int(width) + 2, int(height) + 2
        self.values = array.array("i", [0]) * (self.width * self.height)

    def pixels(self, polygon):
        """The pixels whose centres are inside; at least the one at the polygon's own centre."""
        ys = [p[1] for p in polygon]
        found = False
        for row in range(max(0, math.ceil(min(ys) - 0.5)),
                         min(self.height, math.floor(max(ys) - 0.5) + 1)):
            y, cuts = row + 0.5, []
            for (x0, y0), (x1, y1) in zip(polygon, polygon[1:] + polygon[:1]):
                if (y0 <= y) != (y1 <= y):
                    cuts.append(x0 + (y - y0) * (x1 - x0) / (y1 - y0))
            cuts.sort()
            for x0, x1 in zip(cuts[::2], cuts[1::2]):
                for column in range(max(0, math.ceil(x0 - 0.5)),
                                    min(self.width, math.floor(x1 - 0.5) + 1)):
                    found = True
                    yield row * self.width + column
        column = int(sum(p[0] for p in polygon) / len(polygon))
        row = int(sum(ys) / len(polygon))
        if not found and 0 <= column < self.width and 0 <= row < self.height:
            yield row * self.width + column


def visible_layers(polygons, depths, width, height):
    """Layers of polygon numbers, far to near: within one, none covers another. Hidden ones go."""
    order = sorted(range(len(polygons)), key=lambda i: -depths[i])
    taken, visible = Raster(width, height), []
    for i in order:
        pixels = list(taken.pixels(polygons[i]))
        if any(not taken.values[p] for p in pixels):
            visible.append(i)
        for p in pixels:
            taken.values[p] = 1

    top, layers = Raster(width, height), []
    for i in reversed(visible):
        pixels = list(top.pixels(polygons[i]))
        layer = max((top.values[p] for p in pixels), default=0)
        if layer == len(layers):
            layers.append([])
        layers[layer].append(i)
        for p in pixels:
            top.values[p] = layer + 1
    return layers


# ---- colour --------------------------------------------------------------------------------------
def colour(value, shade=1.0):
    """The colour of a shape in [0, 1], made darker by shade in [0, 1]."""
    place = min(max(value, 0.0), 1.0) * (len(COLOUR_POINTS) - 1)
    k = min(int(place), len(COLOUR_POINTS) - 2)
    rgb = []
    for channel in (1, 3, 5):
        a, b = (int(COLOUR_POINTS[j][channel:channel + 2], 16) for j in (k, k + 1))
        dim = shade if channel < 5 else (1 + shade) / 2  # shadows are blue, or yellow turns to mud
        rgb.append(round((a + (place - k) * (b - a)) * dim))
    return "#{:02x}{:02x}{:02x}".format(*rgb)


def shade_of(level):
    return 1.0 - 0.34 * (1.0 - (level + 1) / SHADES)


def fill(style):
    """The colour of (class, shade level): class -1 is inverted, level None is unlit."""
    shape_class, level = style
    if shape_class < 0:
        return INVERTED_COLOUR
    return colour((shape_class + 0.5) / CLASSES, 1.0 if level is None else shade_of(level))


# ---- drawing -------------------------------------------------------------------------------------
class Drawing:
    """A mesh as seen by a camera: polygons in the plane, their depths, styles and statistics."""

    def __init__(self, mesh, camera, planar):
        points, cells = mesh
        projected = [camera.project(p) for p in points]
        vectors = [area_vector([points[i] for i in cell]) for cell in cells]
        # A whole file may be wound the other way: the sense of the greater area is the right one.
        sense = 1.0 if sum(dot(v, camera.towards) for v in vectors) >= 0 else -1.0
        self.polygons, self.depths, self.styles, self.shapes = [], [], [], []
        self.inverted = 0
        for cell, vector in zip(cells, vectors):
            corners = [points[i] for i in cell]
            up = tuple(sense * t for t in camera.towards) if planar else unit(vector)
            value = shape(corners, up)
            inverted = planar and dot(vector, up) <= 0
            self.inverted += inverted
            self.shapes.append(value)
            light = abs(dot(unit(vector), camera.light))
            self.styles.append((
                -1 if inverted else min(int(value * CLASSES), CLASSES - 1),
                None if planar else min(int(light * SHADES), SHADES - 1)))
            self.polygons.append([projected[i][:2] for i in cell])
            self.depths.append(sum(projected[i][2] for i in cell) / len(cell))

    def bounds(self):
        xs = [x for polygon in self.polygons for x, _ in polygon]
        ys = [y for polygon in self.polygons for _, y in polygon]
        return min(xs), min(ys), max(xs), max(ys)

    def caption(self):
        text = (f"worst {min(self.shapes):.3f} \u00b7 "
                f"mean {sum(self.shapes) / len(self.shapes):.3f}")
        return text + (f" \u00b7 {self.inverted} inverted" if self.inverted else "")


def path_data(polygons):
    """SVG path of polygons in whole units: each starts absolute and goes on relative."""
    parts = []
    for polygon in polygons:
        (x, y), *rest = polygon
        parts.append(f"M{x} {y}")
        steps = []
        for px, py in rest:
            steps.append(f"{px - x} {py - y}")
            x, y = px, py
        parts.append("l" + " ".join(steps).replace(" -", "-") + "z")
    return "".join(parts)


def draw_panel(drawing, window, width, height, planar, line_width):
    """The cells of one mesh within a window of the projection plane, as lines of SVG."""
    scale = width / (window[2] - window[0])
    polygons, kept = [], []
    for i, polygon in enumerate(drawing.polygons):
        pixels = [((x - window[0]) * scale, (window[3] - y) * scale) for x, y in polygon]
        if (max(x for x, _ in pixels) >= 0 and min(x for x, _ in pixels) <= width
                and max(y for _, y in pixels) >= 0 and min(y for _, y in pixels) <= height):
            polygons.append(pixels)
            kept.append(i)
    depths = [-float(drawing.styles[i][0] < 0) if planar else drawing.depths[i] for i in kept]
    if planar:  # nothing is hidden; what is turned over is drawn last
        layers = [[k for k, d in enumerate(depths) if d == 0], [k for k, d in enumerate(depths) if d]]
    else:
        layers = visible_layers(polygons, depths, width, height)

    lines = []
    for layer in layers:
        styles = {}
        for k in layer:
            whole = [(round(x * UNITS), round(y * UNITS)) for x, y in polygons[k]]
            styles.setdefault(drawing.styles[kept[k]], []).append(whole)
        lines += [f'<path fill="{fill(style)}" d="{path_data(styles[style])}"/>'
                  for style in sorted(styles, key=str)]
    return (f'<g transform="scale({1 / UNITS:g})" stroke="#1b1b1b" stroke-opacity=".55" '
            f'stroke-width="{line_width * UNITS:g}" stroke-linejoin="round">'), lines, "</g>"


def draw_legend(x, y, width, with_inverted):
    step = width / 60
    lines = [f'<g transform="translate({x:g} {y:g})" font-size="12">']
    lines += [f'<rect x="{k * step:.2f}" width="{step + 0.3:.2f}" height="12" '
              f'fill="{colour((k + 0.5) / 60)}"/>' for k in range(60)]
    for tick in (0, 0.25, 0.5, 0.75, 1):
        lines.append(f'<path d="M{tick * width:g} 12v4" stroke="#444"/>'
                     f'<text x="{tick * width:g}" y="28" text-anchor="middle">{tick:g}</text>')
    lines.append('<text x="-10" y="10" text-anchor="end">shape of the cells</text>')
    lines.append(f'<text x="{width + 10:g}" y="10">ideal</text>')
    if with_inverted:
        lines.append(f'<rect x="{width + 56:g}" width="12" height="12" fill="{INVERTED_COLOUR}"/>'
                     f'<text x="{width + 73:g}" y="10">inverted</text>')
    return lines + ["</g>"]


def draw(drawings, titles, zoom, planar, panel_width):
    """The whole picture as SVG text."""
    x0, y0, x1, y1 = drawings[0].bounds()
    for other in drawings[1:]:
        bounds = other.bounds()
        x0, y0 = min(x0, bounds[0]), min(y0, bounds[1])
        x1, y1 = max(x1, bounds[2]), max(y1, bounds[3])
    w, h = x1 - x0, y1 - y0
    window = (x0 + zoom[0] * w, y0 + zoom[1] * h, x0 + zoom[2] * w, y0 + zoom[3] * h)
    panel_height = panel_width * (window[3] - window[1]) / (window[2] - window[0])
    cells = max(len(d.polygons) for d in drawings) * (zoom[2] - zoom[0]) * (zoom[3] - zoom[1])
    line_width = min(0.8, max(0.15, 0.03 * math.sqrt(panel_width * panel_height / max(cells, 1))))

    width = 2 * MARGIN + len(drawings) * panel_width + (len(drawings) - 1) * GAP
    height = HEAD + panel_height + FOOT + LEGEND
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" '
             f'width="{width:.0f}" height="{height:.0f}" '
             'font-family="Helvetica, Arial, sans-serif" fill="#222">',
             f'<rect width="{width:.0f}" height="{height:.0f}" rx="6" fill="#fff"/>',
             f'<clipPath id="panel"><rect x="-1" y="-1" width="{panel_width + 2:.0f}" '
             f'height="{panel_height + 2:.0f}"/></clipPath>']
    subject = "shape" if zoom == (0, 0, 1, 1) else "shape, whole mesh"
    for k, (drawing, title) in enumerate(zip(drawings, titles)):
        left = MARGIN + k * (panel_width + GAP)
        middle = left + panel_width / 2
        lines.append(f'<text x="{middle:.1f}" y="22" font-size="16" font-weight="bold" '
                     f'text-anchor="middle">{html.escape(title)}</text>')
        opening, cells, closing = draw_panel(drawing, window, panel_width, panel_height, planar,
                                             line_width)
        lines += [f'<g transform="translate({left:g} {HEAD})" clip-path="url(#panel)">', opening,
                  *cells, closing, "</g>"]
        lines.append(f'<text x="{middle:.1f}" y="{HEAD + panel_height + 20:.1f}" font-size="13" '
                     f'text-anchor="middle">{subject}: {drawing.caption()}</text>')
    bar = min(240, width / 2.6)
    lines += draw_legend((width - bar) / 2, height - LEGEND + 14, bar,
                         any(d.inverted for d in drawings))
    return "\n".join(lines + ["</svg>", ""])


# ---- command line --------------------------------------------------------------------------------
def numbers(count):
    def parse(text):
        values = tuple(float(word) for word in text.split(","))
        if len(values) != count:
            raise argparse.ArgumentTypeError(f"needs {count} numbers with commas between them")
        return values
    return parse


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("meshes", metavar="MESH", type=pathlib.Path, nargs="+",
                        help="one mesh, or the mesh before and after")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, metavar="SVG")
    parser.add_argument("--view", type=numbers(3), default=None, metavar="X,Y,Z",
                        help="from where a surface is seen (default: 1,0.6,1.4 for y up)")
    parser.add_argument("--up", type=numbers(3), default=(0.0, 1.0, 0.0), metavar="X,Y,Z")
    parser.add_argument("--zoom", type=numbers(4), default=(0.0, 0.0, 1.0, 1.0),
                        metavar="X0,Y0,X1,Y1",
                        help="part of the picture, from 0,0 (lower left) to 1,1 (upper right)")
    parser.add_argument("--titles", default="before,after", help="with a comma between them")
    parser.add_argument("--width", type=int, default=440, help="of one mesh, in pixels")
    options = parser.parse_args()
    if len(options.meshes) > 2:
        parser.error("one mesh or two")
    if not (options.zoom[0] < options.zoom[2] and options.zoom[1] < options.zoom[3]):
        parser.error("--zoom: the second corner must lie right of and above the first")

    meshes = [read_mesh(path) for path in options.meshes]
    planes = {find_plane(points) for points, _ in meshes}
    plane = planes.pop() if len(planes) == 1 and options.view is None else None
    if plane is None:
        camera = Camera(options.view or (1.0, 0.6, 1.4), options.up)
    else:  # x to the right if there is one, the later axis up
        camera = Camera(*[((1, 0, 0), (0, 0, 1)), ((0, -1, 0), (0, 0, 1)),
                          ((0, 0, 1), (0, 1, 0))][plane])
    drawings = [Drawing(mesh, camera, plane is not None) for mesh in meshes]
    titles = options.titles.split(",") if len(meshes) == 2 else [options.meshes[0].name]
    options.output.write_text(
        draw(drawings, titles, options.zoom, plane is not None, options.width), encoding="utf-8")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures how large HTML reports of large meshes get and how long they take; writes a table in Markdown.

usage: measure_report.py [--build DIR] [--vertices N ...] [--max-mb N]

Needs the program and write_case, which is built with the benchmarks (-DEVENMESH_BUILD_BENCH=ON).
"""
import argparse
import json
import math
import pathlib
import random
import re
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent


def bend(flat, curved, moved):
    """Makes a surface of a planar mesh, and the same with every vertex moved by about half an edge."""
    lines = flat.read_text().splitlines()
    vertices = [line.split()[1:3] for line in lines if line.startswith("v ")]
    noise = 0.5 * math.sqrt(math.pi / len(vertices))
    place = random.Random(1)

    def on_surface(x, y):
        return f"v {x!r} {y!r} {0.2 * math.sin(5 * x) * math.cos(4 * y)!r}"

    faces = [line for line in lines if line.startswith("f ")]
    points = [(float(x), float(y)) for x, y in vertices]
    curved.write_text("\n".join([on_surface(x, y) for x, y in points] + faces) + "\n")
    points = [(x + noise * place.gauss(0, 0.5), y + noise * place.gauss(0, 0.5)) for x, y in points]
    moved.write_text("\n".join([on_surface(x, y) for x, y in points] + faces) + "\n")


def measure(program, before, after, report, most):
    """A row of the table."""
    start = time.monotonic()
    subprocess.run([program, "report", before, after, "-o", report, "--report-max-mb", str(most),
                    "--quiet"], check=True, stdout=subprocess.DEVNULL)
    seconds = time.monotonic() - start
    text = report.read_text(encoding="utf-8")
    found = re.search(r'id="evenmesh-report">(.*?)</script>', text, re.DOTALL)
    page = json.loads(found[1])
    mesh = page["mesh"]
    return (f"{mesh['cells']['of']:,}", f"{mesh['cells']['shown']:,}", f"{len(mesh['metrics'])}",
            f"{report.stat().st_size / 1e6:.2f} MB",
            f"{sum(a['bytes'] for a in page['arrays'].values()) / 1e6:.2f} MB", f"{seconds:.1f} s")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    parser.add_argument("--vertices", type=int, nargs="+", default=[5_000, 100_000, 500_000])
    parser.add_argument("--max-mb", type=float, default=8.0)
    arguments = parser.parse_args()
    program = arguments.build / "evenmesh"
    print("| mesh | triangles | shown | metrics | file | mesh data | time |\n"
          "|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        flat, even, curved, moved = (folder / f"{f}.obj" for f in ("flat", "even", "curved", "moved"))
        for vertices in arguments.vertices:
            subprocess.run([arguments.build / "write_case", "disk", str(vertices), flat], check=True)
            subprocess.run([program, flat, "-o", even, "--iterations", "20", "--quiet"], check=True,
                           stdout=subprocess.DEVNULL)
            bend(flat, curved, moved)
            for title, a, b in (("disk, smoothed", flat, even), ("surface, all moved", curved, moved)):
                row = measure(program, a, b, folder / "report.html", arguments.max_mb)
                print(f"| {title} | " + " | ".join(row) + " |", flush=True)


if __name__ == "__main__":
    main()

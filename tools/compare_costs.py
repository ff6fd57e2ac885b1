#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Smooths meshes with the cost shape and with edge lengths and counts which did better.

usage: compare_costs.py [--program FILE] FOLDER

Takes every file up to 1.5 MB below FOLDER that the program reads and in which something moves; one
row of a Markdown table for each folder just below. Edge lengths are `local`, with `barycenter` for
anything but triangles and tets.
"""
import argparse
import json
import pathlib
import subprocess
import tempfile

LARGEST = 1_500_000  # bytes
CLEARLY = 1e-3  # in shape, which is 1 at best
EDGES, BOTH = "local=1", "local=0.3,barycenter=0.3"
HEADER = ("| meshes | number | mean shape: better / worse | worst shape: better / worse | "
          "still inverted | CPU s |\n|---|---|---|---|---|---|")


def run(program, path, folder, cost):
    """The report of a run, None if the mesh is not read or the run is refused."""
    report = folder / "report.json"
    report.unlink(missing_ok=True)
    subprocess.run([program, path, "-o", folder / f"out{path.suffix}", "-q", "--threads", "1",
                    "--cost", cost, "--time-limit", "60", "--json", report], capture_output=True,
                   check=False)
    if not report.exists():
        return None
    said = json.loads(report.read_text())
    return said if (said.get("quality") or {}).get("after") else None


def is_simple(program, path):
    """Whether a mesh has triangles and tets only."""
    said = subprocess.run([program, "info", path], capture_output=True, encoding="latin-1",
                          check=False)
    cells = [line for line in said.stdout.splitlines() if line.startswith("cells ")]
    return bool(cells) and not any(word in cells[0] for word in
                                   ("quad", "polygon", "hex", "wedge", "pyramid"))


def compare(program, path, folder):
    """Reports with shape and with edge lengths, None if there are not both or nothing moved."""
    shape = run(program, path, folder, "shape=1")
    if not shape:
        return None
    edges = run(program, path, folder, EDGES if is_simple(program, path) else BOTH)
    if not edges or shape["geometry"]["moved"] + edges["geometry"]["moved"] == 0:
        return None
    return shape, edges


def row_of(name, pairs):
    def count(key, sign):
        return sum(sign * (shape["quality"]["after"]["shape"][key]
                           - edges["quality"]["after"]["shape"][key]) > CLEARLY
                   for shape, edges in pairs)

    def total(get):
        return " / ".join(get(sum_of) for sum_of in zip(*pairs))

    return (f"| {name} | {len(pairs)} | {count('mean', 1)} / {count('mean', -1)} | "
            f"{count('worst', 1)} / {count('worst', -1)} | "
            + total(lambda runs: f"{sum(r['inverted_after'] for r in runs):,}") + " | "
            + total(lambda runs: f"{sum(r['time']['cpu_seconds'] for r in runs):.1f}") + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=pathlib.Path, default="build/release/evenmesh")
    parser.add_argument("folder", type=pathlib.Path)
    arguments = parser.parse_args()
    program = arguments.program.resolve()
    print(HEADER)
    everything = []
    with tempfile.TemporaryDirectory() as folder:
        for group in sorted(path for path in arguments.folder.iterdir() if path.is_dir()):
            pairs = []
            for path in sorted(group.rglob("*")):
                if path.is_file() and path.stat().st_size <= LARGEST:
                    pair = compare(program, path, pathlib.Path(folder))
                    if pair:
                        pairs.append(pair)
            if pairs:
                print(row_of(group.name, pairs), flush=True)
                everything += pairs
    print(row_of("all", everything))


main()

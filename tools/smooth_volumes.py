#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Smooths generated volume meshes and prints what became of them: the table of docs/benchmarks.md.

    tools/smooth_volumes.py build/release/evenmesh          # small ones, a minute
    tools/smooth_volumes.py build/release/evenmesh --large  # up to 250,000 vertices, some minutes

The meshes come from tools/make_volumes.py: valid ones with interior vertices moved by half a cell
at random and cells as flat as a scaled Jacobian of 0.05, and tangled ones. CPU seconds are those of
the whole program on one thread, reading and writing included; memory is its peak.
"""
import argparse
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

SMALL = (("tet_cube", 16000), ("hex_cube", 20000), ("hex_cylinder", 20000), ("mixed", 16000))
LARGE = (("tet_cube", 190000), ("hex_cube", 250000), ("hex_cylinder", 250000))
TANGLED = (("tet_cube", 16000, 0.07), ("hex_cube", 20000, 0.45), ("hex_cylinder", 20000, 0.45),
           ("mixed", 16000, 0.2))


def run(program, folder, kind, vertices, how):
    """Returns the report, with CPU seconds and kB added."""
    mesh, out, report = folder / "in.vtk", folder / "out.vtk", folder / "report.json"
    generator = pathlib.Path(__file__).with_name("make_volumes.py")
    subprocess.run([sys.executable, generator, kind, str(vertices), *how, "-o", mesh], check=True,
                   stdout=subprocess.DEVNULL)
    child = subprocess.Popen([program, mesh, "-o", out, "--json", report, "--threads", "1", "-q"],
                             stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    if os.waitstatus_to_exitcode(status) != 0:
        sys.exit(f"{kind} {vertices}: exit code {os.waitstatus_to_exitcode(status)}")
    result = json.loads(report.read_text())
    result["cpu"] = usage.ru_utime + usage.ru_stime
    result["kilobytes"] = usage.ru_maxrss
    return result


def row(name, report):
    before, after = report["quality"]["before"], report["quality"]["after"]
    vertices = report["input"]["vertices"]

    def change(metric, value, digits):
        return f"{before[metric][value]:.{digits}f} -> {after[metric][value]:.{digits}f}"

    print(f"| {name} | {vertices:,} | {report['inverted_before']:,} -> {report['inverted_after']} "
          f"| {change('scaled_jacobian', 'worst', 3)} | {change('scaled_jacobian', 'mean', 3)} "
          f"| {change('shape', 'worst', 3)} | {change('shape', 'mean', 3)} "
          f"| {report['iterations']} | {report['cpu']:.1f} "
          f"| {report['kilobytes'] * 1024 / vertices:.0f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--large", action="store_true")
    arguments = parser.parse_args()
    print("| mesh | vertices | inverted | worst scaled Jacobian | mean scaled Jacobian | worst shape "
          "| mean shape | iterations | CPU s | bytes per vertex |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        small = {}
        for kind, vertices in SMALL:
            report = run(arguments.program, folder, kind, vertices, ["--jitter", "0.5"])
            small[kind] = report
            row(kind, report)
        for kind, vertices, part in TANGLED:
            report = run(arguments.program, folder, kind, vertices, ["--tangle", str(part)])
            row(kind + ", tangled", report)
            print(f"tangled {kind}: {report['cpu'] / small[kind]['cpu']:.1f} times the time of the "
                  "valid start", file=sys.stderr)
        for kind, vertices in LARGE if arguments.large else ():
            report = run(arguments.program, folder, kind, vertices, ["--jitter", "0.5"])
            row(kind, report)
            exponent = (math.log(report["cpu"] / small[kind]["cpu"]) /
                        math.log(report["input"]["vertices"] / small[kind]["input"]["vertices"]))
            print(f"{kind}: time grows with the exponent {exponent:.2f}", file=sys.stderr)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs every method over some meshes and writes a table in Markdown.

usage: compare_methods.py [--program FILE] [--iterations N] [--note TEXT] MESH... > docs/comparison.md
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

METHODS = ["lagrange_newton", "laplacian", "smart_laplacian", "combined", "global_laplacian",
           "lennard_jones", "lennard_jones_printed", "pliant", "angle_based", "optimal_delaunay"]

HEADER = """# Comparison of methods

Made by `tools/compare_methods.py{options} {meshes}`.
Every method with its defaults, at most {iterations} iterations, one thread. *Unguarded* is how many cells the
method alone would have left inverted; *pulled back* how many vertices went back so that nothing is worse than in the
input, which is what the qualities are measured after. *Shape* is 1 for an ideal cell and 0 for a flat one. CPU time is
that of the whole program, reading and writing included. See [classic](classic.md) for the methods.{note}
"""
COLUMNS = ("method", "worst shape", "mean shape", "min angle", "unguarded", "pulled back",
           "iterations", "stop", "CPU s")


def run(program, mesh, method, iterations, folder):
    """The report of one run, or the reason why there is none."""
    report = folder / "report.json"
    report.unlink(missing_ok=True)
    done = subprocess.run([program, mesh, "-o", folder / f"out{mesh.suffix}", "--method", method,
                           "--iterations", str(iterations), "--threads", "1", "--quiet",
                           "--json", report], capture_output=True, text=True)
    if done.returncode == 2:
        return None, "not for these cells" if " is for " in done.stderr else done.stderr.strip()
    return json.loads(report.read_text()), done.stderr.strip()


def row_of(report):
    """What the table says about a run."""
    quality = report["quality"]["after"]
    stop = report["stop_reason"] if report["promise"] != "unimproved" else "refused"
    if report["promise"] == "earlier_iterate":
        stop = "earlier iterate"
    return (f"{quality['shape']['worst']:.4f}", f"{quality['shape']['mean']:.4f}",
            f"{quality['min_angle']['worst']:.2f}", f"{report['inverted_unguarded']:,}",
            f"{report['geometry']['pulled_back']:,}", f"{report['iterations']}",
            stop.replace("_", " "), f"{report['time']['cpu_seconds']:.2f}")


def section(program, mesh, iterations, folder):
    """One mesh with all methods."""
    lines = []
    for method in METHODS:
        print(f"{mesh}: {method}", file=sys.stderr)
        report, reason = run(program, mesh, method, iterations, folder)
        if report is None:
            lines.append(f"| {method} | {reason} |" + " |" * (len(COLUMNS) - 2))
            continue
        if not lines:
            before = report["quality"]["before"]
            cells = ", ".join(f"{n:,} {kind}s" for kind, n in report["input"]["cells"].items())
            lines = [f"\n## {mesh.name}\n",
                     f"{report['input']['type']}, {cells}, {report['geometry']['movable']:,} "
                     f"vertices may move, {report['inverted_before']} cells inverted in the "
                     "input\n",
                     "| " + " | ".join(COLUMNS) + " |", "|---" * len(COLUMNS) + "|",
                     f"| *input* | {before['shape']['worst']:.4f} | {before['shape']['mean']:.4f} "
                     f"| {before['min_angle']['worst']:.2f} |" + " |" * (len(COLUMNS) - 4)]
        lines.append("| " + " | ".join((method,) + row_of(report)) + " |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", default="build/release/evenmesh")
    parser.add_argument("--iterations", type=int, default=200)
    parser.add_argument("--note", default="", help="where the meshes are from")
    parser.add_argument("meshes", nargs="+", type=pathlib.Path)
    arguments = parser.parse_args()
    options = "" if arguments.iterations == 200 else f" --iterations {arguments.iterations}"
    meshes = " ".join(m.name if m.is_absolute() else str(m) for m in arguments.meshes)
    print(HEADER.format(options=options, meshes=meshes, iterations=arguments.iterations,
                        note=" " + arguments.note if arguments.note else ""))
    with tempfile.TemporaryDirectory() as folder:
        for mesh in arguments.meshes:
            print(section(arguments.program, mesh, arguments.iterations, pathlib.Path(folder)))


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Solves an equation on poor meshes before and after they are smoothed, and prints Markdown tables.

usage: compare_solves.py [--build DIR] [--vertices N] [--folder DIR]

Meshes come from make_volumes.py, solves from examples/poisson.cpp. Needs a build with evenmesh_app
and example_poisson; build/dev unless told. docs/finite_elements.md shows what this prints.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
MAKER = ROOT / "tools/make_volumes.py"
STATES = {
    "poor": ("--jitter", "0.5"),
    "almost flat": ("--jitter", "0.5", "--least", "0.002"),
    "tangled": ("--tangle", "0.05"),
}
HEADER = """\
| mesh | shape, worst | mean | scaled Jacobian, worst | mean | condition | iterations | condition, \
Jacobi | iterations, Jacobi | L2 error | H1 error | at a vertex |
|---|---|---|---|---|---|---|---|---|---|---|---|"""


def quality(program, path):
    """Worst and mean of shape and scaled Jacobian, as words."""
    said = subprocess.run([program, "check", path], capture_output=True, text=True, check=False)
    rows = {words[0]: words for words in map(str.split, said.stdout.splitlines()) if words}
    return [rows[metric][column] for metric in ("shape", "scaled_jacobian") for column in (1, 4)]


def solve(example, path):
    done = subprocess.run([example, path, "--json"], capture_output=True, text=True, check=False)
    if done.returncode != 0 and "is inverted" in done.stderr:
        return ["refused: inverted cells"] + [""] * 6
    if done.returncode != 0:
        sys.exit(done.stderr)
    said = json.loads(done.stdout)
    figures = []
    for method in ("plain", "jacobi"):
        figures += [f"{said[method]['condition']:.0f}", str(said[method]["iterations"])]
    return figures + [f"{said[error]:.5f}" for error in ("l2_error", "h1_error", "greatest_error")]


def print_row(name, programs, path):
    program, example = programs
    print("|", " | ".join([name, *quality(program, path), *solve(example, path)]), "|", flush=True)


def compare(kind, vertices, programs, folder):
    print(HEADER)
    for state, options in STATES.items():
        name = f"{kind}_{state.replace(' ', '_')}"
        before, after = folder / f"{name}.vtk", folder / f"{name}_even.vtk"
        subprocess.run([sys.executable, MAKER, kind, vertices, *options, "-o", before], check=True)
        print_row(state, programs, before)
        subprocess.run([programs[0], before, "-o", after], capture_output=True, check=True)
        print_row("- smoothed", programs, after)
    regular = folder / f"{kind}_regular.vtk"
    subprocess.run([sys.executable, MAKER, kind, vertices, "-o", regular], check=True)
    print_row("never disturbed", programs, regular)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/dev")
    parser.add_argument("--vertices", default="16000")
    parser.add_argument("--folder", type=pathlib.Path, help="where meshes are kept")
    args = parser.parse_args()
    programs = [args.build / "evenmesh", args.build / "example_poisson"]
    for program in programs:
        if not program.exists():
            sys.exit(f"compare_solves.py: no {program}; build it, or name a folder with --build")
    with tempfile.TemporaryDirectory() as temporary:
        folder = args.folder or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        for kind in ("tet_cube", "hex_cylinder"):
            print(f"\n{kind}\n")
            compare(kind, args.vertices, programs, folder)


main()

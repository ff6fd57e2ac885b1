#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Smooths files and asks VTK, meshio and Gmsh whether they see the same cells, groups and fields.

usage: oracles_test.py PROGRAM

Takes every file up to 1.5 MB in data/, in fuzz/corpus/ and in the corpus if there is one: where
EVENMESH_CORPUS_DIR says, or shared/corpus beside the project. What none of the libraries
reads, or what the program refuses, says nothing. Exit status 77, which is a skipped test, if none
of the libraries is installed.
"""
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import check_oracles  # noqa: E402  (found by the line before)

LARGEST = 1_500_000  # bytes
SKIPPED = 77


def has_oracles():
    return any(importlib.util.find_spec(module) for _, module, _, _ in check_oracles.ORACLES)


def smooth(program, path, output):
    """Whether the program wrote the file with some vertices moved."""
    command = [program, path, "-o", output, "--iterations", "3", "--threads", "1", "--quiet"]
    done = subprocess.run(command, capture_output=True, check=False)
    return done.returncode == 0 and output.read_bytes() != path.read_bytes()


def judge(path, output, folder):
    """The exit status of check_oracles.py."""
    before = check_oracles.unpacked(path, folder, "before")
    after = check_oracles.unpacked(output, folder, "after")
    return check_oracles.check(before, after)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    if not has_oracles():
        print("skipped: none of the Python packages vtk, meshio and gmsh is installed")
        sys.exit(SKIPPED)
    suffixes = {suffix for _, _, _, known in check_oracles.ORACLES for suffix in known}
    counts = {"agree": 0, "read by none": 0, "not smoothed": 0}
    failed = []
    corpus = pathlib.Path(os.environ.get("EVENMESH_CORPUS_DIR", ROOT.parent / "shared/corpus"))
    for folder in (ROOT / "data", ROOT / "fuzz/corpus", corpus):
        for path in sorted(folder.rglob("*")):
            if path.suffix.lower() not in suffixes or path.stat().st_size > LARGEST:
                continue
            with tempfile.TemporaryDirectory() as temporary:
                temporary = pathlib.Path(temporary)
                output = temporary / ("smoothed" + path.suffix)
                if not smooth(sys.argv[1], path, output):
                    counts["not smoothed"] += 1
                    continue
                print(path, flush=True)
                status = judge(path, output, temporary)
            if status == 1:
                failed.append(path)
            else:
                counts["agree" if status == 0 else "read by none"] += 1
    print(", ".join(f"{number} {what}" for what, number in counts.items()))
    for path in failed:
        print(f"FAILED: {path}")
    sys.exit(1 if failed else 0)


main()

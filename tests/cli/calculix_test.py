#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A deck that CalculiX refuses runs after it was smoothed, and gives what a new mesh gives.

usage: calculix_test.py PROGRAM

Needs `ccx` (Debian: calculix-ccx); exit status 77, which is a skipped test, where there is none.
docs/calculix.md tells what is done here.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DECK = ROOT / "data/plate_with_hole.inp"
MAKER = ROOT / "tools/make_plate_deck.py"
SKIPPED = 77


def solve(deck):
    """CalculiX's exit status and what it says."""
    done = subprocess.run(["ccx", "-i", deck.stem], cwd=deck.parent, capture_output=True, text=True,
                          timeout=300, check=False)
    return done.returncode, done.stdout


def results(deck):
    """Mean displacement of the pulled end, greatest stress, both along x."""
    numbers = {"displacements": [], "stresses": []}
    rows = None
    for line in deck.with_suffix(".dat").read_text().splitlines():
        words = line.split()
        if words and words[0] in numbers:
            rows = numbers[words[0]]
        elif words and words[0].isdigit():
            # node, 3 displacements; or element, integration point, 6 stresses
            rows.append(float(words[1] if rows is numbers["displacements"] else words[2]))
    return sum(numbers["displacements"]) / len(numbers["displacements"]), max(numbers["stresses"])


def is_close(value, expected, relative):
    return abs(value - expected) <= relative * abs(expected)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    made = subprocess.run([sys.executable, MAKER], capture_output=True, text=True, check=True)
    assert made.stdout == DECK.read_text(), f"{MAKER} no longer makes {DECK}"
    if not shutil.which("ccx"):
        print("skipped: ccx is not installed")
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        deck = folder / "before.inp"
        shutil.copy(DECK, deck)
        status, said = solve(deck)
        assert status != 0 and "nonpositive jacobian" in said, said

        smoothed = folder / "after.inp"
        subprocess.run([sys.argv[1], DECK, "-o", smoothed], check=True)
        status, said = solve(smoothed)
        assert status == 0 and "nonpositive jacobian" not in said, said
        before, after = DECK.read_text().splitlines(), smoothed.read_text().splitlines()
        changed = [a for a, b in zip(before, after) if a != b]
        assert len(before) == len(after) and changed
        assert all(line.endswith(", 0.0") and line.count(",") == 3 for line in changed), changed

        anew = folder / "anew.inp"
        made = subprocess.run([sys.executable, MAKER, "--meshed-anew"], capture_output=True,
                              text=True, check=True)
        anew.write_text(made.stdout)
        status, said = solve(anew)
        assert status == 0, said
        (move, stress), (wanted_move, wanted_stress) = results(smoothed), results(anew)
    print(f"smoothed: {move:.6f} mm, {stress:.1f} MPa; meshed anew: {wanted_move:.6f} mm, "
          f"{wanted_stress:.1f} MPa")
    assert is_close(move, wanted_move, 0.002)
    assert is_close(stress, wanted_stress, 0.05)


main()

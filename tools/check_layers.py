#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks the architecture: which folder of src/evenmesh may include which, and what none may do.

usage: check_layers.py [--root DIR]

Prints every violation as file:line: reason and exits 1 if there are any. To change the
architecture, change the table below, in a commit of its own.
"""
import argparse
import pathlib
import re
import sys

MAY_INCLUDE = {
    "base": "",
    "geometry": "base",
    "mesh": "base",
    "quality": "base geometry mesh",
    "io": "base mesh",
    "cost": "base geometry mesh",
    "constraint": "base geometry mesh",
    "problem": "base geometry mesh cost constraint",
    "classic": "base geometry mesh quality constraint",
    "solver": "base geometry mesh quality cost constraint problem classic",
    "report": "base mesh quality problem solver plot",
    "plot": "base geometry mesh quality problem solver",
}

INCLUDE = re.compile(r'\s*#\s*include\s+(["<])([^">]+)[">]')
FOREIGN = re.compile(r"CLI/|mpi\.h|petsc|iostream$")  # the command line's and the cluster's
FORBIDDEN = re.compile(
    r"\bstd::(?:cout|cerr|clog)\b|\bfmt::print"
    r"|(?<![\w.>])(?:v?f?printf|f?puts|putchar|_?exit|quick_exit|abort|terminate)\s*\(")
STRING_OR_COMMENT = re.compile(r'"(?:\\.|[^"\\])*"|//.*')


def is_listed(file):
    """True when the folder's CMakeLists.txt names the file, with or without its suffix."""
    folder_list = file.parent / "CMakeLists.txt"
    words = re.split(r"[\s()]+", folder_list.read_text()) if folder_list.is_file() else []
    return file.name in words or file.stem in words


def check_include(layer, quote, path, root):
    """Says what is wrong with an #include in a file of a layer, None if nothing is."""
    if not path.startswith("evenmesh/"):
        if quote == '"':
            return f'"{path}" is not a path from src/, such as "evenmesh/base/vec3.h"'
        return f"<{path}> does not belong into the library" if FOREIGN.match(path) else None
    if quote == "<":
        return f'<{path}> is our own: use "{path}"'
    if not (root / "src" / path).is_file():
        return f'"{path}" does not exist'
    used = path.split("/")[1]
    if used != layer and used not in MAY_INCLUDE[layer].split():
        return f'{layer}/ may not include {used}/ ("{path}"), only: {MAY_INCLUDE[layer] or "-"}'
    return None


def check_file(file, layer, root):
    """Yields (line number, reason) for every violation in one source file."""
    lines = file.read_text(encoding="utf-8").splitlines()
    listed = is_listed(file)
    if not lines or "SPDX-License-Identifier: MIT" not in lines[0]:
        yield 1, "the first line must be // SPDX-License-Identifier: MIT"
    if file.suffix == ".h" and "#pragma once" not in lines:
        yield 1, "a header needs #pragma once"
    for number, line in enumerate(lines, 1):
        if include := INCLUDE.match(line):
            reason = check_include(layer, include[1], include[2], root)
            if reason:
                yield number, reason
            elif listed and include[1] == '"' and not is_listed(root / "src" / include[2]):
                yield number, f'"{include[2]}" is not in its CMakeLists.txt: installed without it'
        elif call := FORBIDDEN.search(STRING_OR_COMMENT.sub('""', line)):
            yield number, f"{call[0].strip(' (')}: the library neither prints nor exits"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--root", type=pathlib.Path,
                        default=pathlib.Path(__file__).resolve().parent.parent)
    root = parser.parse_args().root
    library = root / "src" / "evenmesh"
    files = [f for f in sorted(library.rglob("*")) if f.suffix in (".h", ".cpp")]
    if not files:
        sys.exit(f"{library}: no sources found")

    violations = [f"src/evenmesh/{folder.name}: a folder that the table does not know"
                  for folder in sorted(library.iterdir())
                  if folder.is_dir() and folder.name not in MAY_INCLUDE]
    for file in files:
        layer = file.relative_to(library).parts[0]
        if layer in MAY_INCLUDE:
            violations += [f"{file.relative_to(root)}:{line}: {reason}"
                           for line, reason in check_file(file, layer, root)]
        elif file.parent == library:
            violations.append(f"{file.relative_to(root)}: belongs into one of the layers")
    for violation in violations:
        print(violation)
    print(f"{len(files)} files, {len(violations)} violations")
    sys.exit(1 if violations else 0)


if __name__ == "__main__":
    main()

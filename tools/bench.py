#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures evenmesh and judges what it measured.

usage: bench.py [--build DIR] [--output FILE] [--quick] [--only GROUP[,GROUP]]

Runs the benchmark programs of a build folder, prints tables and writes everything to a JSON file.
Builds nothing: `./run bench` does both. Groups, in the order they run:

  solver   whole solves: iterations, CPU time, memory, threads, vertex order
  peers    the same problem given to NLopt and Ipopt, where they were built
  file     the command line program on a file of a million vertices
  io       reading and patching such files in every format, beside meshio, Gmsh and VTK
  kernels  single functions, with Google Benchmark

and, only when asked for with --only:

  limits   whole solves in which no triangle may become too small, against Ipopt's: needs a
           solver_bench that takes a least area (or none) and what the boundary may do

--quick leaves out a million vertices and the peers. Goals that were not measured say so. The exit
status is 1 if a program failed, not if a goal is missed.
"""
import argparse
import datetime
import json
import os
import pathlib
import platform
import re
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
GROUPS = ("solver", "peers", "file", "io", "kernels")
GROUPS_ON_DEMAND = ("limits",)
SIZES = (10_000, 100_000, 1_000_000)
LARGEST = SIZES[-1]
REPEATS = 3
PEERS = {"NLopt": "peer_nlopt", "Ipopt": "peer_ipopt"}
PEER_CPU_LIMIT = 300.0  # seconds after which a peer may give up
# Case, vertices, least area in mean areas, what the boundary may do, noise of the same mesh for
# Ipopt; None where it would take too long.
LIMITED = (
    ("disk", 1_000, 0.2, "slide", 0),
    ("disk_tangled", 1_000, 0.2, "slide", 1),
    ("disk", 1_000, 0.6, "slide", 0),
    ("disk_tangled", 1_000, 0.6, "slide", 1),
    ("disk", 10_000, 0.2, "slide", 0),
    ("disk_tangled", 10_000, 0.2, "slide", 1),
    ("triangles", LARGEST, 0.2, "fixed", None),
    ("tangled", LARGEST, 0.2, "fixed", None),
)
# A tangled mesh has no unconstrained solve of its own worth comparing with: the valid one's.
VALID_TWIN = {"disk_tangled": "disk", "tangled": "triangles"}
MIB = 1024.0 * 1024.0


def narrate(text):
    print(f"bench: {text}", file=sys.stderr, flush=True)


def size_name(vertices):
    return f"{vertices // LARGEST}M" if vertices >= LARGEST else f"{vertices // 1000}k"


# ---- running programs ----------------------------------------------------------------------------


class Failed(Exception):
    """A program that should have answered did not."""


def run_json(*command):
    """What a program printed, parsed."""
    command = [str(word) for word in command]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Failed(f"{' '.join(command)}: exit status {done.returncode}\n{done.stderr.strip()}")
    return json.loads(done.stdout)


def run_measured(command):
    """Exit status, CPU seconds, wall seconds and peak memory of a program, output discarded."""
    start = datetime.datetime.now()
    process = subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    kib = 1 if sys.platform == "darwin" else 1024
    return {
        "exit_code": process.returncode,
        "cpu_seconds": usage.ru_utime + usage.ru_stime,
        "wall_seconds": (datetime.datetime.now() - start).total_seconds(),
        "peak_memory_bytes": usage.ru_maxrss * kib,
    }


# ---- where and what ------------------------------------------------------------------------------


def first_line(command):
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=ROOT)
    except (OSError, subprocess.CalledProcessError):
        return ""
    return done.stdout.strip().split("\n")[0]


def cpu_model():
    try:
        text = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        return first_line(["sysctl", "-n", "machdep.cpu.brand_string"]) or platform.processor()
    found = re.search(r"^model name\s*:\s*(.*)$", text, re.MULTILINE)
    return found[1] if found else platform.machine()


def describe_machine():
    return {
        "cpu": cpu_model(),
        "cores": os.cpu_count(),
        "memory_bytes": os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES"),
        "system": f"{platform.system()} {platform.release()} {platform.machine()}",
    }


def describe_build(build):
    cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")
    entries = dict(re.findall(r"^(CMAKE_\w+):\w+=(.*)$", cache, re.MULTILINE))
    compiler = entries.get("CMAKE_CXX_COMPILER", "")
    return {
        "type": entries.get("CMAKE_BUILD_TYPE", ""),
        "compiler": first_line([compiler, "--version"]) if compiler else "",
    }


def describe_commit():
    return {
        "hash": first_line(["git", "rev-parse", "HEAD"]),
        "modified": bool(first_line(["git", "status", "--porcelain"])),
    }


# ---- measuring -----------------------------------------------------------------------------------


def measure_solver(build, sizes):
    wanted = [(case, size, 1) for case in ("triangles", "triangles_bent", "quads")
              for size in sizes]
    wanted += [("triangles", sizes[-1], 2), ("triangles_shuffled", sizes[-1], 1)]
    results = []
    for case, size, threads in wanted:
        narrate(f"{case}, {size_name(size)} vertices, {threads} thread(s)")
        result = run_json(build / "solver_bench", case, size, threads, REPEATS)
        results.append({"size": size, **result})
    return results


def target_of(results, build, size):
    """The cost that peers are asked for, and what it took evenmesh."""
    for result in results:
        if (result["case"], result["size"], result["threads"]) == ("triangles", size, 1):
            return result
    narrate(f"triangles, {size_name(size)} vertices: the cost to be reached")
    return run_json(build / "solver_bench", "triangles", size, 1, REPEATS)


def measure_peers(build, solver):
    results = []
    for size in SIZES[:2]:
        ours = target_of(solver, build, size)
        for peer, program in PEERS.items():
            if not (build / program).exists():
                results.append({"name": peer, "size": size, "absent": True,
                                "reason": f"{program} was not built: {peer} was not found"})
                continue
            narrate(f"{peer}, {size_name(size)} vertices")
            result = run_json(build / program, size, repr(ours["cost"]), PEER_CPU_LIMIT)
            # One that gave up took at least that long.
            result["slower_than_evenmesh"] = (
                result["cpu_seconds"] / ours["cpu_to_same_cost_seconds"])
            result["slower_than_all_of_smooth"] = (
                result["cpu_seconds"] / ours["cpu_of_parts_seconds"]["smooth"])
            results.append({"name": peer, "size": size, "absent": False, **result})
    return results


def measure_oracle(build, size, least, rim, noise):
    """Ipopt's answer, None where it is too slow or was not built."""
    program = build / "oracle_ipopt"
    if noise is None or not program.exists():
        return None
    return run_json(program, "disk", size, 1, noise, least, rim, PEER_CPU_LIMIT)


def measure_limits(build, quick):
    results = []
    for case, size, least, rim, noise in LIMITED:
        if quick and size == LARGEST:
            continue
        narrate(f"{case}, {size_name(size)} vertices, areas of at least {least} mean areas, {rim}")
        result = run_json(build / "solver_bench", case, size, 1, REPEATS, least, rim)
        free = run_json(build / "solver_bench", VALID_TWIN.get(case, case), size, 1, REPEATS,
                        "none", rim)
        oracle = measure_oracle(build, size, least, rim, noise)
        results.append({
            **result, "case": case, "size": size, "least": least, "rim": rim, "oracle": oracle,
            "slower_than_free": ratio(result, free, "cpu_of_parts_seconds", "smooth"),
            "cost_over_oracle": ratio(result, oracle, "cost"),
            "oracle_slower": oracle and (oracle["cpu_seconds"] /
                                         result["cpu_of_parts_seconds"]["smooth"])})
    return results


def measure_file(build, size):
    """The program from file to file, as a user runs it."""
    program = build / "evenmesh"
    if not program.exists():
        return [{"absent": True, "reason": "the program evenmesh was not built"}]
    results = []
    with tempfile.TemporaryDirectory() as folder:
        mesh, even, report = (pathlib.Path(folder) / name
                              for name in ("in.obj", "even.obj", "report.json"))
        for case in ("triangles", "triangles_shuffled"):
            narrate(f"file to file: {case}, {size_name(size)} vertices")
            subprocess.run([build / "write_case", case, str(size), mesh], check=True)
            result = run_measured([program, mesh, "-o", even, "-q", "--threads", "1",
                                   "--json", report])
            if result["exit_code"] not in (0, 4) or not report.exists():
                raise Failed(f"{program} ended with exit status {result['exit_code']}")
            vertices = sum(line.startswith(b"v ") for line in mesh.open("rb"))
            said = json.loads(report.read_text(encoding="utf-8"))
            result.update(
                absent=False, case=case, size=size, vertices=vertices,
                file_bytes=mesh.stat().st_size,
                bytes_per_vertex=result["peak_memory_bytes"] / vertices,
                read_mb_per_second=mesh.stat().st_size / 1e6 / said["time"]["read_seconds"],
                **{key: said.get(key) for key in ("iterations", "inverted_after", "time")})
            results.append(result)
    return results


# Suffix, what it is, whether it is text.
IO_FORMATS = (
    ("obj", "OBJ", True),
    ("msh", "MSH 4.1, text", True),
    ("inp", "Abaqus deck", True),
    ("bdf", "Nastran deck, 16 columns", True),
    ("mesh", "MEDIT, text", True),
    ("mshb", "MSH 4.1, binary", False),
    ("meshb", "MEDIT, binary", False),
    ("vtk", "VTK legacy, binary", False),
    ("vtu", "VTU, raw", False),
    ("ply", "PLY, binary", False),
    ("stl", "STL, binary", False),
)
# How others read such a file, in Python: suffixes, import, statement.
IO_PEERS = {
    "meshio": (("obj", "msh", "inp", "bdf", "mesh", "vtk", "vtu", "ply", "stl"),
               "import meshio", "meshio.read(path)"),
    "Gmsh": (("msh", "mshb"), "import gmsh; gmsh.initialize(['', '-v', '1'])", "gmsh.open(path)"),
    "VTK": (("obj", "vtk", "vtu", "ply", "stl"), "import vtkmodules.all as vtk",
            "reader = {'.obj': vtk.vtkOBJReader, '.vtk': vtk.vtkUnstructuredGridReader, "
            "'.vtu': vtk.vtkXMLUnstructuredGridReader, '.ply': vtk.vtkPLYReader, "
            "'.stl': vtk.vtkSTLReader}[path[path.rindex('.'):]](); "
            "reader.SetFileName(path); reader.Update()"),
}


def measure_io_peers(path, suffix):
    """CPU seconds in which others read the file; nothing of those that are not installed or fail."""
    seconds = {}
    for name, (suffixes, load, read) in IO_PEERS.items():
        if suffix not in suffixes:
            continue
        script = (f"import sys, time; path = sys.argv[1]; {load}\n"
                  f"before = time.process_time()\n{read}\n"
                  "print('SECONDS', time.process_time() - before)")
        done = subprocess.run([sys.executable, "-c", script, str(path)], capture_output=True,
                              text=True, check=False)
        found = re.search(r"^SECONDS (.*)$", done.stdout, re.MULTILINE)
        if done.returncode == 0 and found:
            seconds[name] = float(found[1])
    return seconds


def measure_io(build, size):
    """Reads, patches and reads again; io_bench sees that it is the same mesh."""
    results = []
    with tempfile.TemporaryDirectory() as folder:
        for suffix, name, is_text in IO_FORMATS:
            narrate(f"reading and patching {name}, {size_name(size)} vertices")
            path, output = (pathlib.Path(folder) / f"{stem}.{suffix}" for stem in ("in", "out"))
            subprocess.run([build / "write_case", "triangles", str(size), path], check=True)
            runs = [run_json(build / "io_bench", path, output) for _ in range(REPEATS)]
            result = {key: statistics.median(run[key] for run in runs) for key in runs[0]}
            result.update(format=name, suffix=suffix, is_text=is_text, size=size,
                          others=measure_io_peers(path, suffix))
            megabytes = result["file_bytes"] / 1e6
            for step in ("read", "write", "copy"):
                result[f"{step}_mb_per_second"] = megabytes / max(result[f"{step}_seconds"], 1e-9)
            result["bytes_per_vertex"] = (
                result["peak_memory_bytes"] - result["file_bytes"]) / result["vertices"]
            results.append(result)
            path.unlink()
            output.unlink()
    return results


def measure_kernels(build, quick):
    results = []
    for program in sorted(build.glob("*_bench")):
        if program.name == "solver_bench":
            continue
        narrate(f"kernels: {program.name}")
        options = ["--benchmark_format=json", "--benchmark_min_time=0.1"]
        if quick:
            options.append(f"--benchmark_filter=-/({LARGEST}|1024)$")
        for kernel in run_json(program, *options)["benchmarks"]:
            results.append({"program": program.name, **kernel})
    return results


# ---- judging -------------------------------------------------------------------------------------


class Goals:
    """Rows of the last table: what was asked for, what came out."""

    def __init__(self):
        self.rows = []

    def add(self, part, what, goal, value, met, text=None):
        """met: None where nothing was measured or nothing is asked for."""
        self.rows.append({"part": part, "what": what, "goal": goal, "value": value, "met": met,
                          "text": text if text is not None else value})

    def at_most(self, part, what, limit, value, text="{:.2f}", unit=""):
        self._compare(part, what, "<=", limit, value, text, unit)

    def at_least(self, part, what, limit, value, text="{:.1f}", unit=""):
        self._compare(part, what, ">=", limit, value, text, unit)

    def _compare(self, part, what, sign, limit, value, text, unit):
        met = None
        if value is not None:
            met = value <= limit if sign == "<=" else value >= limit
        shown = "not measured" if value is None else text.format(value) + unit
        self.add(part, what, f"{sign} {limit:g}{unit}", value, met, shown)


def pick(results, case, size, threads=1):
    for result in results:
        if (result["case"], result["size"], result["threads"]) == (case, size, threads):
            return result
    return None


def ratio(above, below, *keys):
    """above[keys] / below[keys]; None where one of them was not measured."""
    if above is None or below is None:
        return None
    for key in keys:
        above, below = above[key], below[key]
    return above / below


def iterations_of(result):
    """None unless measured; infinite where the gradient never got there."""
    if result is None:
        return None
    return result["iterations"] if result["iterations"] >= 0 else float("inf")


def judge_solver(goals, solver):
    triangles, bent, quads = ([pick(solver, case, size) for size in SIZES]
                              for case in ("triangles", "triangles_bent", "quads"))
    for name, results in (("triangles", triangles), ("triangles_bent", bent)):
        for size, limit, result in zip(SIZES, (15, 22, 32), results):
            goals.at_most("a", f"{name} {size_name(size)}: iterations", limit,
                          iterations_of(result), "{:.0f}")
    for size, result in zip(SIZES, quads):
        goals.at_most("a", f"quads {size_name(size)}: iterations", 20, iterations_of(result),
                      "{:.0f}")
    for name, results in (("triangles", triangles), ("quads", quads)):
        goals.at_most("a", f"{name}: CPU time from 100k to 1M", 13,
                      ratio(results[2], results[1], "cpu_seconds"), "{:.1f}", "x")
    # Its steps get longer, counted in cells, as cells get smaller: no goal, but worth seeing.
    growth = ratio(bent[2], bent[1], "cpu_seconds")
    goals.add("a", "triangles_bent: CPU time from 100k to 1M", "report", growth, None,
              "not measured" if growth is None else f"{growth:.1f}x")


def judge_peers(goals, peers):
    for name, limit in (("NLopt", 10), ("Ipopt", 25)):
        found = [p for p in peers if p["name"] == name and p["size"] == SIZES[1]]
        what = f"{name} 100k: CPU time, evenmesh = 1"
        if not found or found[0]["absent"]:
            goals.at_least("b", what, limit, None)
            continue
        text = "{:.1f}" if found[0]["reached"] else "more than {:.1f}"
        goals.at_least("b", what, limit, found[0]["slower_than_evenmesh"], text, "x")


def judge_million(goals, solver):
    large = pick(solver, "triangles", LARGEST)
    shuffled = pick(solver, "triangles_shuffled", LARGEST)
    two = pick(solver, "triangles", LARGEST, 2)
    evaluation = large and large["evaluation"]
    goals.at_most("c", "cost + gradient, copying 70 bytes per vertex = 1", 8,
                  evaluation and (evaluation["seconds"] /
                                  evaluation["copy_70_bytes_per_vertex_seconds"]), "{:.1f}", "x")
    goals.at_most("c", "random order, CPU time, sorted = 1", 1.3,
                  ratio(shuffled, large, "cpu_seconds"), "{:.2f}", "x")
    alone = ratio(shuffled, large, "cpu_of_parts_seconds", "smooth")
    goals.add("c", "the same, smooth() alone", "report", alone, None,
              "not measured" if alone is None else f"{alone:.2f}x")
    parts = large and large["cpu_of_parts_seconds"]
    goals.at_most("d", "set-up, part of the 1M solve", 25,
                  parts and 100.0 * parts["setup"] / parts["smooth"], "{:.0f}", " %")
    for name, result in (("sorted", large), ("random order", shuffled)):
        goals.at_most("e", f"peak memory at 1M, {name}", 700,
                      result and result["bytes_per_vertex"], "{:.0f}", " bytes/vertex")
    speedup = ratio(large, two, "wall_seconds")
    shown = "not measured" if speedup is None else f"{speedup:.2f}x faster"
    goals.add("f", "two threads, wall time at 1M", "report", speedup, None, shown)


def judge_file(goals, files):
    measured = [f for f in files if not f["absent"] and f["size"] == LARGEST]
    speed = measured[0]["read_mb_per_second"] if measured else None
    goals.at_least("file", "reading OBJ text", 100, speed, "{:.0f}", " MB/s")
    shuffled = ratio(measured[1], measured[0], "cpu_seconds") if measured else None
    goals.add("file", "file to file, random order, CPU time, sorted = 1", "report", shuffled, None,
              "not measured" if shuffled is None else f"{shuffled:.2f}x")


def judge_io(goals, results):
    measured = {r["suffix"]: r for r in results if r["size"] == LARGEST}
    for suffix in ("msh", "inp"):
        speed = measured[suffix]["read_mb_per_second"] if measured else None
        goals.at_least("io", f"reading {dict((s, n) for s, n, _ in IO_FORMATS)[suffix]}", 150,
                       speed, "{:.0f}", " MB/s")
    slowest = min((r["copy_seconds"] / r["read_seconds"] for r in measured.values()
                   if not r["is_text"]), default=None)
    goals.at_least("io", "reading binary files, slowest, copy = 1", 0.25, slowest, "{:.2f}", "")
    most = max((r["bytes_per_vertex"] for r in measured.values()), default=None)
    goals.at_most("io", "memory beyond the size of the file, most", 400, most, "{:.0f}",
                  " bytes/vertex")


def judge(results):
    goals = Goals()
    judge_solver(goals, results.get("solver", []))
    judge_peers(goals, results.get("peers", []))
    judge_million(goals, results.get("solver", []))
    judge_file(goals, results.get("file", []))
    judge_io(goals, results.get("io", []))
    return goals.rows


# ---- printing ------------------------------------------------------------------------------------


def print_table(title, header, rows, words=1):
    """Columns as wide as they need to be; the first ones, words, to the left, numbers right."""
    rows = [[str(cell) for cell in row] for row in rows]
    widths = [max(len(row[i]) for row in [header, *rows]) for i in range(len(header))]
    print(f"\n{title}")
    for row in [header, ["-" * width for width in widths], *rows]:
        cells = [cell.ljust(width) if i < words else cell.rjust(width)
                 for i, (cell, width) in enumerate(zip(row, widths))]
        print("  " + "  ".join(cells).rstrip())


def print_solver(solver):
    rows = []
    for result in solver:
        parts = result["cpu_of_parts_seconds"]
        rows.append([
            result["case"], size_name(result["size"]), result["threads"],
            f"{result['iterations']} ({result['iterations_preconditioned']})",
            result["evaluations"], f"{result['cpu_seconds']:.3f}",
            f"{1e6 * result['cpu_seconds'] / result['vertices']:.2f}",
            f"{parts['smooth']:.3f}", f"{parts['setup']:.3f}",
            f"{result['wall_seconds']:.3f}",
            # Below, most of it is the program itself and what it inherits from whoever started it.
            f"{result['bytes_per_vertex']:.0f}" if result["size"] >= 100_000 else "-",
            f"{result['inverted_before']} > {result['inverted_after']}"])
    print_table("Whole solves to a relative gradient of 1e-6 (in brackets: in the norm of the "
                "preconditioner)",
                ["case", "size", "threads", "iterations", "evaluations", "CPU s", "us/vertex",
                 "smooth CPU s", "set-up CPU s", "smooth wall s", "bytes/vertex", "inverted"], rows)


def print_peers(peers):
    rows = []
    for peer in peers:
        if peer["absent"]:
            rows.append([peer["name"], size_name(peer["size"])] + ["absent"] + ["-"] * 4)
            continue
        rows.append([
            f"{peer['peer']} {peer['version']}", size_name(peer["size"]),
            "yes" if peer["reached"] else f"no, {peer['relative_excess']:.1e} above",
            f"{peer['cpu_seconds']:.2f}", f"{peer['slower_than_evenmesh']:.1f}x",
            f"{peer['slower_than_all_of_smooth']:.1f}x", peer["values"] + peer["gradients"]])
    print_table("The same triangles, cost, start and gradient, to the same cost within 1e-6",
                ["optimiser", "size", "reached", "CPU s", "evenmesh = 1", "all of smooth() = 1",
                 "evaluations"], rows)


def print_limits(limits):
    def shown(value, text):
        return "-" if value is None else text.format(value)

    rows = [[limit["case"], size_name(limit["size"]), limit["rim"], f"{limit['least']:g}",
             f"{limit['inverted_before']} > {limit['inverted_after']}",
             limit["iterations_until_valid"], limit["iterations"],
             f"{limit['cpu_of_parts_seconds']['smooth']:.3f}",
             f"{limit['slower_than_free']:.1f}x",
             shown(limit["cost_over_oracle"] and limit["cost_over_oracle"] - 1.0, "{:+.1e}"),
             shown(limit["oracle_slower"], "{:.1f}x")] for limit in limits]
    print_table("No triangle below a least area (in mean areas)",
                ["case", "size", "boundary", "least", "inverted", "iterations until none",
                 "iterations", "smooth CPU s", "valid, no limit = 1", "cost over Ipopt's",
                 "Ipopt, evenmesh = 1"], rows)


def print_files(files):
    rows = [[f["case"], size_name(f["size"]), f"{f['file_bytes'] / 1e6:.0f}",
             f"{f['read_mb_per_second']:.0f}", f"{f['cpu_seconds']:.2f}",
             f"{f['wall_seconds']:.2f}", f"{f['bytes_per_vertex']:.0f}"]
            for f in files if not f["absent"]]
    if rows:
        print_table("The program, file to file, one thread",
                    ["case", "size", "MB", "read MB/s", "CPU s", "wall s", "bytes/vertex"], rows)
    for absent in (f for f in files if f["absent"]):
        print(f"\nThe program, file to file: {absent['reason']}")


def print_io(results):
    rows = [[r["format"], f"{r['file_bytes'] / 1e6:.0f}", f"{r['read_seconds']:.2f}",
             f"{r['read_mb_per_second']:.0f}", f"{r['write_mb_per_second']:.0f}",
             f"{r['copy_mb_per_second']:.0f}", f"{r['bytes_per_vertex']:.0f}",
             ", ".join(f"{name} {seconds / r['read_seconds']:.1f}x"
                       for name, seconds in r["others"].items()) or "-"] for r in results]
    if rows:
        print_table(f"Reading and patching, {size_name(results[0]['size'])} vertices, all moved",
                    ["format", "MB", "read CPU s", "read MB/s", "patch MB/s", "copy MB/s",
                     "bytes/vertex beyond the file", "CPU time of others to read it"], rows)


def print_kernels(kernels):
    rows = []
    for kernel in kernels:
        items = kernel.get("items_per_second")
        size = kernel.get("bytes_per_second")
        speed = f"{items / 1e6:.1f} M/s" if items else f"{size / MIB:.0f} MiB/s" if size else ""
        rows.append([kernel["name"], f"{kernel['cpu_time']:.3f} {kernel['time_unit']}", speed])
    print_table("Kernels, one thread (cells, vertices or bytes per second)",
                ["kernel", "CPU time", "speed"], rows)


def print_goals(rows):
    words = {True: "yes", False: "NO", None: "-"}
    print_table("Goals", ["part", "what", "measured", "goal", "met?"],
                [[row["part"], row["what"], row["text"], row["goal"], words[row["met"]]]
                 for row in rows], words=2)


def print_setting(results):
    machine, commit = results["machine"], results["commit"]
    print(f"evenmesh {commit['hash'][:12]}{' with changes' if commit['modified'] else ''}, "
          f"{results['date']}, {results['build']['type']}, {results['build']['compiler']}")
    print(f"{machine['cpu']}, {machine['cores']} cores, {machine['memory_bytes'] / 2**30:.0f} GiB; "
          f"load {results['load_before'][0]:.1f} before, {results['load_after'][0]:.1f} after")


def print_all(results):
    print_setting(results)
    for key, show in (("solver", print_solver), ("peers", print_peers), ("limits", print_limits),
                      ("file", print_files), ("io", print_io), ("kernels", print_kernels)):
        if results.get(key):
            show(results[key])
    print_goals(results["goals"])


# ---- the command ---------------------------------------------------------------------------------


def parse_arguments():
    parser = argparse.ArgumentParser(
        description="Measures evenmesh and judges what it measured.")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "bench",
                        help="folder of the benchmark programs (build/bench)")
    parser.add_argument("--output", type=pathlib.Path, default=ROOT / "out" / "bench.json",
                        help="file for the results (out/bench.json)")
    parser.add_argument("--quick", action="store_true",
                        help="without a million vertices and without peers")
    parser.add_argument("--only", default="", help=f"some of {','.join(GROUPS + GROUPS_ON_DEMAND)}")
    arguments = parser.parse_args()
    groups = [group for group in arguments.only.split(",") if group] or list(GROUPS)
    for group in groups:
        if group not in GROUPS + GROUPS_ON_DEMAND:
            parser.error(f"there is no group '{group}'; known are "
                         f"{', '.join(GROUPS + GROUPS_ON_DEMAND)}")
    if not (arguments.build / "solver_bench").exists():
        parser.error(f"there is no {arguments.build / 'solver_bench'}; ./run bench builds it")
    if arguments.quick and not arguments.only:
        groups.remove("peers")
    return arguments, groups


def measure(build, groups, quick):
    sizes = SIZES[:-1] if quick else SIZES
    results = {}
    if "solver" in groups:
        results["solver"] = measure_solver(build, sizes)
    if "peers" in groups:
        results["peers"] = measure_peers(build, results.get("solver", []))
    if "limits" in groups:
        results["limits"] = measure_limits(build, quick)
    if "file" in groups:
        results["file"] = measure_file(build, sizes[-1])
    if "io" in groups:
        results["io"] = measure_io(build, sizes[-1])
    if "kernels" in groups:
        results["kernels"] = measure_kernels(build, quick)
    return results


def main():
    arguments, groups = parse_arguments()
    results = {
        "schema_version": 1,
        "date": datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds"),
        "commit": describe_commit(),
        "machine": describe_machine(),
        "build": describe_build(arguments.build),
        "load_before": os.getloadavg(),
    }
    try:
        results.update(measure(arguments.build, groups, arguments.quick))
    except (Failed, OSError, subprocess.CalledProcessError, ValueError) as error:
        narrate(error)
        return 1
    results["load_after"] = os.getloadavg()
    results["goals"] = judge(results)
    arguments.output.parent.mkdir(parents=True, exist_ok=True)
    arguments.output.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    print_all(results)
    narrate(f"results in {arguments.output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())

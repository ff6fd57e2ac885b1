#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Smooths a surface of triangles with several programs and says what became of it.

usage: compare_surface_smoothers.py SURFACE.obj [...] [--build DIR] [--iterations N]
                                    [--evenmesh-options "..."]

Prints one Markdown table per surface: the input, evenmesh, two filters of VTK, and a smoother of
OpenMesh where bench/peer_openmesh was built (needs libopenmesh-dev). Needs VTK and NumPy for
Python (python3-vtk9, python3-numpy). Columns:

  shape worst, mean  4 sqrt(3) area / sum of squared sides: 1 is equilateral, 0 has no area
  turned over        triangles whose normal points against the one they had in the input
  off surface %      greatest distance of vertices and centroids of either surface to the other one,
                     of the diagonal of the bounding box
  off features %     the same for vertices on feature edges of the input (dihedral angle above 45
                     degrees, or a boundary) to the nearest of these edges
  CPU s              smoothing alone; for evenmesh the whole program, file to file
"""
import argparse
import json
import pathlib
import resource
import shlex
import subprocess
import sys
import tempfile
import time

try:
    import numpy as np
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    from vtkmodules.vtkFiltersCore import (vtkImplicitPolyDataDistance, vtkSmoothPolyDataFilter,
                                           vtkWindowedSincPolyDataFilter)
except ImportError as error:
    sys.exit(f"compare_surface_smoothers: {error}; on Debian and Ubuntu: "
             "apt install python3-vtk9 python3-numpy, then run it with /usr/bin/python3")

ROOT = pathlib.Path(__file__).resolve().parent.parent
FEATURE_ANGLE_DEG = 45.0
ACCEPTED_STATUS = (0, 4)  # of evenmesh: done, and done as far as it got


# ---- files and VTK -------------------------------------------------------------------------------


def read_obj(path):
    """Points and triangles; polygons are an error."""
    points, triangles = [], []
    for line in path.read_text(encoding="utf-8", errors="replace").splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append([float(word) for word in words[1:4]])
        elif words[:1] == ["f"]:
            if len(words) != 4:
                raise ValueError(f"{path}: a face has {len(words) - 1} vertices, not three")
            corners = [int(word.split("/")[0]) for word in words[1:]]
            triangles.append([c - 1 if c > 0 else len(points) + c for c in corners])
    return np.array(points), np.array(triangles)


def write_obj(path, points, triangles):
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in points.tolist())
        file.writelines(f"f {a} {b} {c}\n" for a, b, c in (triangles + 1).tolist())


def poly_data(points, triangles):
    locations = vtkPoints()
    locations.SetDataTypeToDouble()
    locations.SetData(numpy_to_vtk(points, deep=True))
    cells = vtkCellArray()
    words = np.hstack([np.full((len(triangles), 1), 3), triangles]).astype(np.int64)
    cells.SetCells(len(triangles), numpy_to_vtkIdTypeArray(words.ravel(), deep=True))
    result = vtkPolyData()
    result.SetPoints(locations)
    result.SetPolys(cells)
    return result


# ---- smoothers: points and triangles -> points, CPU seconds --------------------------------------


def run_filter(smoother, points, triangles):
    smoother.SetInputData(poly_data(points, triangles))
    start = time.process_time()
    smoother.Update()
    seconds = time.process_time() - start
    return vtk_to_numpy(smoother.GetOutput().GetPoints().GetData()).astype(float), seconds


def set_features(smoother, iterations):
    smoother.SetNumberOfIterations(iterations)
    smoother.SetFeatureEdgeSmoothing(True)
    smoother.SetFeatureAngle(FEATURE_ANGLE_DEG)
    smoother.SetBoundarySmoothing(True)


def vtk_laplacian(points, triangles, options):
    smoother = vtkSmoothPolyDataFilter()
    set_features(smoother, options.iterations)
    smoother.SetRelaxationFactor(0.1)
    smoother.SetOutputPointsPrecision(1)  # double
    return run_filter(smoother, points, triangles)


def vtk_windowed_sinc(points, triangles, options):
    smoother = vtkWindowedSincPolyDataFilter()
    set_features(smoother, options.iterations)
    smoother.SetPassBand(0.1)
    smoother.NormalizeCoordinatesOn()
    return run_filter(smoother, points, triangles)


def through_files(points, triangles, command_of):
    """Output and CPU seconds of a program that reads and writes OBJ, and what it printed."""
    with tempfile.TemporaryDirectory() as folder:
        before, after = (pathlib.Path(folder) / name for name in ("in.obj", "out.obj"))
        write_obj(before, points, triangles)
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(command_of(before, after), capture_output=True, text=True,
                              check=False)
        if done.returncode not in ACCEPTED_STATUS or not after.exists():
            raise RuntimeError(f"exit status {done.returncode}: {done.stderr.strip()}")
        now = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = now.ru_utime + now.ru_stime - used.ru_utime - used.ru_stime
        return read_obj(after)[0], seconds, done.stdout


def evenmesh(points, triangles, options):
    program = options.build / "evenmesh"
    return through_files(points, triangles, lambda before, after: [
        program, before, "-o", after, "-q", *shlex.split(options.evenmesh_options)])[:2]


def openmesh(points, triangles, options):
    program = options.build / "peer_openmesh"
    after, _, said = through_files(points, triangles, lambda before, after: [
        program, before, after, str(options.iterations)])
    return after, json.loads(said)["cpu_seconds"]


SMOOTHERS = {
    "evenmesh": evenmesh,
    "VTK vtkSmoothPolyDataFilter": vtk_laplacian,
    "VTK vtkWindowedSincPolyDataFilter": vtk_windowed_sinc,
    "OpenMesh JacobiLaplaceSmootherT": openmesh,
}


# ---- measures ------------------------------------------------------------------------------------


def normals(points, triangles):
    """Twice the area long."""
    a, b, c = (points[triangles[:, i]] for i in range(3))
    return np.cross(b - a, c - a)


def shapes(points, triangles):
    sides = sum(((points[triangles[:, i]] - points[triangles[:, i - 1]]) ** 2).sum(axis=1)
                for i in range(3))
    areas = np.linalg.norm(normals(points, triangles), axis=1) / 2.0
    return 4.0 * np.sqrt(3.0) * areas / np.maximum(sides, 1e-300)


def greatest_distance(points, triangles, other):
    """Of vertices and centroids to another surface."""
    distance = vtkImplicitPolyDataDistance()
    distance.SetInput(other)
    samples = np.vstack([points, points[triangles].mean(axis=1)])
    result = vtkDoubleArray()
    distance.FunctionValue(numpy_to_vtk(samples, deep=True), result)
    return np.abs(vtk_to_numpy(result)).max()


def feature_edges(points, triangles):
    """Pairs of vertices: sides with a sharp dihedral angle or with other than two triangles."""
    unit = normals(points, triangles)
    unit = unit / np.maximum(np.linalg.norm(unit, axis=1, keepdims=True), 1e-300)
    owners = {}
    for cell, corners in enumerate(triangles.tolist()):
        for i in range(3):
            side = tuple(sorted((corners[i], corners[i - 1])))
            owners.setdefault(side, []).append(cell)
    least = np.cos(np.radians(FEATURE_ANGLE_DEG))
    return np.array([side for side, cells in owners.items()
                     if len(cells) != 2 or unit[cells[0]] @ unit[cells[1]] < least], dtype=int
                    ).reshape(-1, 2)


def distance_to_edges(point, start, along):
    length = np.maximum((along ** 2).sum(axis=1), 1e-300)
    place = np.clip(((point - start) * along).sum(axis=1) / length, 0.0, 1.0)
    return np.linalg.norm(start + place[:, None] * along - point, axis=1).min()


def off_features(before, after, edges):
    if len(edges) == 0:
        return None
    start = before[edges[:, 0]]
    along = before[edges[:, 1]] - start
    return max(distance_to_edges(after[v], start, along) for v in np.unique(edges))


def row(name, before, after, triangles, edges, seconds):
    diagonal = np.linalg.norm(before.max(axis=0) - before.min(axis=0))
    off = max(greatest_distance(after, triangles, poly_data(before, triangles)),
              greatest_distance(before, triangles, poly_data(after, triangles)))
    feature = off_features(before, after, edges)
    shape = shapes(after, triangles)
    turned = ((normals(before, triangles) * normals(after, triangles)).sum(axis=1) < 0).sum()
    return [name, f"{shape.min():.4f}", f"{shape.mean():.4f}", str(turned),
            f"{100 * off / diagonal:.3f}",
            "-" if feature is None else f"{100 * feature / diagonal:.3f}",
            "-" if seconds is None else f"{seconds:.2f}"]


# ---- the command ---------------------------------------------------------------------------------


def compare(path, options):
    points, triangles = read_obj(path)
    edges = feature_edges(points, triangles)
    print(f"\n{path.name}: {len(points)} vertices, {len(triangles)} triangles, "
          f"{len(edges)} feature edges\n")
    print("| smoother | shape worst | mean | turned over | off surface % | off features % | CPU s |")
    print("|---|---:|---:|---:|---:|---:|---:|")
    print("| " + " | ".join(row("input", points, points, triangles, edges, None)) + " |")
    for name, smooth in SMOOTHERS.items():
        try:
            after, seconds = smooth(points, triangles, options)
        except (OSError, RuntimeError) as error:
            print(f"| {name} | not run: {' '.join(str(error).split())[:120]} | | | | | |")
            continue
        print("| " + " | ".join(row(name, points, after, triangles, edges, seconds)) + " |",
              flush=True)


def main():
    parser = argparse.ArgumentParser(description="Compares smoothers of surfaces.")
    parser.add_argument("surfaces", nargs="+", type=pathlib.Path, help="OBJ files of triangles")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "bench",
                        help="folder of evenmesh and peer_openmesh (build/bench)")
    parser.add_argument("--iterations", type=int, default=100, help="of VTK and OpenMesh (100)")
    parser.add_argument("--evenmesh-options", default="", help="further options for evenmesh")
    options = parser.parse_args()
    for path in options.surfaces:
        try:
            compare(path, options)
        except (OSError, ValueError) as error:
            print(f"compare_surface_smoothers: {error}", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())

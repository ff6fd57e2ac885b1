#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes small VTK files in every way VTK itself knows, with VTK's own writers.

usage: make_vtk_seeds.py FOLDER      (needs the Python package vtk; made with 9.1)

fuzz/corpus/vtk, vtu and vtp were made by it. All files grid_* hold one mesh and all files surface_*
another, but for the precision of their points.
"""
import pathlib
import sys

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk

SECOND_ORDER = (vtk.vtkQuadraticTriangle, vtk.vtkQuadraticQuad, vtk.vtkQuadraticTetra,
                vtk.vtkQuadraticHexahedron, vtk.vtkQuadraticWedge, vtk.vtkQuadraticPyramid,
                vtk.vtkBiQuadraticQuad, vtk.vtkTriQuadraticHexahedron,
                vtk.vtkBiQuadraticQuadraticWedge, vtk.vtkBiQuadraticTriangle)
LAGRANGE = ((vtk.vtkLagrangeTriangle, 6), (vtk.vtkLagrangeQuadrilateral, 9),
            (vtk.vtkLagrangeTetra, 10))


def array(name, values, dtype):
    result = numpy_to_vtk(numpy.array(values, dtype=dtype), deep=1)
    result.SetName(name)
    return result


def points_of(places, dtype):
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(numpy.array(places, dtype=dtype), deep=1))
    return points


def make_grid(dtype):
    """Eight hexes, a pyramid and a tet on them, a loose line and a vertex."""
    places = [[i / 3, j / 3, k / 3] for k in range(3) for j in range(3) for i in range(3)]
    places[13] = [0.4, 0.31, 0.36]
    places += [[1 / 6, 1 / 3, 1.0], [0.5, 0.5, 1.0], [0.7, 0.2, 1.1], [1.5, 0, 0], [1.7, 0.25, 0]]
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(points_of(places, dtype))

    def point(i, j, k):
        return i + 3 * j + 9 * k

    def add(kind, points):
        grid.InsertNextCell(kind, len(points), points)

    add(vtk.VTK_VERTEX, [30])
    for k in range(2):
        for j in range(2):
            for i in range(2):
                bottom = [point(i, j, k), point(i + 1, j, k), point(i + 1, j + 1, k),
                          point(i, j + 1, k)]
                add(vtk.VTK_HEXAHEDRON, bottom + [p + 9 for p in bottom])
    add(vtk.VTK_PYRAMID, [point(1, 1, 2), point(2, 1, 2), point(2, 2, 2), point(1, 2, 2), 28])
    add(vtk.VTK_TETRA, [point(1, 1, 2), point(2, 1, 2), 29, 28])
    add(vtk.VTK_LINE, [30, 31])
    on_points = grid.GetPointData()
    on_points.AddArray(array("bc flags", [place[0] == 0 for place in places], numpy.int8))
    on_points.AddArray(array("temperature", [100 * p[2] + 0.5 for p in places], numpy.float64))
    on_points.SetVectors(array("load", [[p[1], -p[0], 0.125] for p in places], numpy.float32))
    on_cells = grid.GetCellData()
    on_cells.SetScalars(array("material", [7] + [3] * 8 + [4, 4] + [9], numpy.int32))
    on_cells.AddArray(array("size", numpy.arange(grid.GetNumberOfCells()) / 4, numpy.float32))
    words = vtk.vtkStringArray()
    words.SetName("who")
    words.InsertNextValue("a < b & c")
    words.InsertNextValue("")
    grid.GetFieldData().AddArray(words)
    return grid


def make_surface(dtype):
    """Triangles and quads, a line of three points and a vertex."""
    surface = vtk.vtkPolyData()
    surface.SetPoints(points_of([[i / 3, j / 3, 0.1 * (i * j % 2)] for j in range(4)
                                 for i in range(4)], dtype))
    vertices, lines, polygons = vtk.vtkCellArray(), vtk.vtkCellArray(), vtk.vtkCellArray()
    vertices.InsertNextCell(1, [0])
    lines.InsertNextCell(3, [0, 1, 2])
    for j in range(3):
        for i in range(3):
            a = i + 4 * j
            if (i + j) % 2:
                polygons.InsertNextCell(4, [a, a + 1, a + 5, a + 4])
            else:
                polygons.InsertNextCell(3, [a, a + 1, a + 5])
                polygons.InsertNextCell(3, [a, a + 5, a + 4])
    surface.SetVerts(vertices)
    surface.SetLines(lines)
    surface.SetPolys(polygons)
    cells = surface.GetNumberOfCells()
    surface.GetCellData().AddArray(array("region", numpy.arange(cells) % 3, numpy.int64))
    surface.GetPointData().AddArray(array("wall", numpy.arange(16) % 4 == 0, numpy.uint8))
    return surface


def make_structured():
    grid = vtk.vtkStructuredGrid()
    grid.SetDimensions(3, 4, 2)
    grid.SetPoints(points_of([[i, j + 0.1 * i, k] for k in range(2) for j in range(4)
                              for i in range(3)], numpy.float64))
    return grid


def make_second_order():
    """One cell of each type, its points where the type has them if its edges are straight."""
    grid = vtk.vtkUnstructuredGrid()
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    cells = [kind() for kind in SECOND_ORDER]
    for kind, count in LAGRANGE:
        cell = kind()
        cell.GetPointIds().SetNumberOfIds(count)
        cell.GetPoints().SetNumberOfPoints(count)
        if kind is vtk.vtkLagrangeQuadrilateral:
            cell.SetUniformOrderFromNumPoints(count)
        else:
            cell.Initialize()
        cells.append(cell)
    for number, cell in enumerate(cells):
        places = cell.GetParametricCoords()
        first = points.GetNumberOfPoints()
        count = cell.GetNumberOfPoints()
        for i in range(count):
            x, y, z = places[3 * i:3 * i + 3]
            # The parameters of a pyramid are those of a cube whose top is one point.
            width = 1 - z if isinstance(cell, vtk.vtkQuadraticPyramid) else 1
            points.InsertNextPoint(width * x + 2 * number, width * y, z)
        grid.InsertNextCell(cell.GetCellType(), count, range(first, first + count))
    grid.SetPoints(points)
    return grid


def write_legacy(path, data, writer, binary, version):
    output = writer()
    output.SetInputData(data)
    output.SetFileName(str(path))
    if binary:
        output.SetFileTypeToBinary()
    else:
        output.SetFileTypeToASCII()
    output.SetFileVersion(version)
    output.Write()


def write_xml(path, data, writer, mode, zipped, big_endian, long_sizes):
    output = writer()
    output.SetInputData(data)
    output.SetFileName(str(path))
    output.SetDataMode({"text": 0, "inline": 1}.get(mode, 2))
    output.SetEncodeAppendedData(mode == "appended_base64")
    if zipped:
        output.SetCompressorTypeToZLib()
        output.SetBlockSize(256)
    else:
        output.SetCompressorTypeToNone()
    if big_endian:
        output.SetByteOrderToBigEndian()
    else:
        output.SetByteOrderToLittleEndian()
    if long_sizes:
        output.SetHeaderTypeToUInt64()
    else:
        output.SetHeaderTypeToUInt32()
    output.Write()


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    for name in ("vtk", "vtu", "vtp"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    for binary in (False, True):
        for version in (42, 51):
            name = f"{'binary' if binary else 'text'}{version}.vtk"
            write_legacy(folder / f"vtk/grid_{name}", make_grid(numpy.float64),
                         vtk.vtkUnstructuredGridWriter, binary, version)
            write_legacy(folder / f"vtk/surface_{name}", make_surface(numpy.float32),
                         vtk.vtkPolyDataWriter, binary, version)
    write_legacy(folder / "vtk/structured.vtk", make_structured(), vtk.vtkStructuredGridWriter,
                 False, 42)
    write_legacy(folder / "vtk/second_order.vtk", make_second_order(),
                 vtk.vtkUnstructuredGridWriter, False, 42)
    single, double = numpy.float32, numpy.float64
    for number, mode in enumerate(("text", "inline", "appended_raw", "appended_base64")):
        for zipped in (False, True) if mode != "text" else (False,):
            name = mode + ("_zlib" if zipped else "")
            odd = (number + zipped) % 2 == 1
            write_xml(folder / f"vtu/grid_{name}.vtu", make_grid(single if odd else double),
                      vtk.vtkXMLUnstructuredGridWriter, mode, zipped, number == 2, odd)
            write_xml(folder / f"vtp/surface_{name}.vtp", make_surface(double if odd else single),
                      vtk.vtkXMLPolyDataWriter, mode, zipped, number == 3, not odd)


main()

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Asks other libraries whether two mesh files differ in the places of their points only.

usage: check_oracles.py BEFORE AFTER

Reads both files with VTK, meshio and Gmsh, those of them that are installed and know the format,
and compares cells, groups and fields as these see them. What a library cannot read in BEFORE says
nothing; what it can read in BEFORE it has to read in AFTER.

Exit status 0 if every library that reads BEFORE sees the same in AFTER, 1 if one does not, 77 if
none here reads it.
"""
import argparse
import contextlib
import gzip
import importlib
import io
import pathlib
import shutil
import sys
import tempfile


class Unreadable(Exception):
    """Why a library does not read a file."""


def numpy():
    return importlib.import_module("numpy")


# VTK

VTK_READERS = {".vtk": "vtkGenericDataObjectReader", ".vtu": "vtkXMLUnstructuredGridReader",
               ".vtp": "vtkXMLPolyDataReader", ".ply": "vtkPLYReader", ".stl": "vtkSTLReader",
               ".obj": "vtkOBJReader"}
EXODUS_SUFFIXES = (".e", ".exo", ".g")
VTK_READ_ALL = ("Scalars", "Vectors", "Normals", "Tensors", "TCoords", "Fields", "ColorScalars")
VTK_CELLS = ("Cells", "Verts", "Lines", "Polys", "Strips")


def vtk_output(vtk, path):
    """What VTK makes of a file."""
    reader = getattr(vtk, VTK_READERS[path.suffix])()
    reader.SetFileName(str(path))
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("an error"))
    if path.suffix == ".stl":
        reader.MergingOff()  # how many points are at one place may change
    if path.suffix == ".vtk":
        for what in VTK_READ_ALL:
            getattr(reader, f"ReadAll{what}On")()
    reader.Update()
    output = reader.GetOutput()
    if errors or output is None or output.GetNumberOfPoints() == 0:
        raise Unreadable(errors[0] if errors else "no points")
    return output


def vtk_values(array):
    """The values of an array of VTK, which may be one of strings."""
    if array is None:
        return None
    if hasattr(array, "GetDataType") and array.IsNumeric():
        convert = importlib.import_module("vtkmodules.util.numpy_support").vtk_to_numpy
        return convert(array).copy()
    return [str(array.GetValue(i)) for i in range(array.GetNumberOfValues())]


def vtk_facts(path):
    vtk = importlib.import_module("vtk")
    output = vtk_output(vtk, path)
    points = output.GetPoints() if hasattr(output, "GetPoints") else None
    facts = {"type": output.GetClassName(), "points": output.GetNumberOfPoints(),
             "type of the points": points.GetDataType() if points else None}
    if hasattr(output, "GetDimensions"):
        facts["dimensions"] = tuple(output.GetDimensions())
    if hasattr(output, "GetCellTypesArray"):
        facts["cell types"] = vtk_values(output.GetCellTypesArray())
    for name in VTK_CELLS:
        cells = getattr(output, f"Get{name}", lambda: None)()
        if cells:
            facts[f"{name} offsets"] = vtk_values(cells.GetOffsetsArray())
            facts[f"{name} connectivity"] = vtk_values(cells.GetConnectivityArray())
    for where in ("PointData", "CellData", "FieldData"):
        data = getattr(output, f"Get{where}")()
        for index in range(data.GetNumberOfArrays()):
            array = data.GetAbstractArray(index)
            name = f"{where} {index} '{array.GetName()}'"
            facts[name] = vtk_values(array)
            facts[f"{name} type"] = (array.GetDataType(), array.GetNumberOfComponents())
    if path.suffix == ".stl":
        facts = {name: fact for name, fact in facts.items() if "Normals" not in name}
    return facts


def exodus_facts(path):
    """VTK's Exodus reader, a thing of its own: a tree of blocks and sets."""
    vtk = importlib.import_module("vtk")
    reader = vtk.vtkExodusIIReader()
    reader.SetFileName(str(path))
    errors = []
    # The reader hands the events of its own parts on.
    vtk.vtkObject.GlobalWarningDisplayOff()
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("an error"))
    reader.UpdateInformation()
    for kind in (reader.NODE_SET, reader.SIDE_SET):
        for index in range(reader.GetNumberOfObjects(kind)):
            reader.SetObjectStatus(kind, index, 1)
    for index in range(reader.GetNumberOfPointResultArrays()):
        reader.SetPointResultArrayStatus(reader.GetPointResultArrayName(index), 1)
    reader.ApplyDisplacementsOff()
    reader.Update()
    facts = {}
    leaves = reader.GetOutput().NewIterator()
    while not leaves.IsDoneWithTraversal():
        piece = leaves.GetCurrentDataObject()
        name = f"{len(facts)} '{leaves.GetCurrentMetaData().Get(vtk.vtkCompositeDataSet.NAME())}'"
        fields = [piece.GetPointData(), piece.GetCellData()]
        facts[name] = {
            "points": piece.GetNumberOfPoints(), "types": vtk_values(piece.GetCellTypesArray()),
            "offsets": vtk_values(piece.GetCells().GetOffsetsArray()),
            "connectivity": vtk_values(piece.GetCells().GetConnectivityArray()),
            "fields": [{data.GetArrayName(i): vtk_values(data.GetAbstractArray(i))
                        for i in range(data.GetNumberOfArrays())} for data in fields]}
        leaves.GoToNextItem()
    if errors or not facts:
        raise Unreadable(errors[0] if errors else "no blocks")
    return facts


# meshio

def meshio_facts(path):
    meshio = importlib.import_module("meshio")
    try:
        mesh = meshio.read(path)
    except (Exception, SystemExit) as error:  # it ends the program where it knows no format
        raise Unreadable(f"{type(error).__name__}: {error}") from error
    if len(mesh.points) == 0:
        raise Unreadable("no points")
    facts = {"points": mesh.points.shape, "type of the points": str(mesh.points.dtype)}
    for index, block in enumerate(mesh.cells):
        facts[f"cells {index}"] = (block.type, numpy().asarray(block.data))
    for where in ("point_data", "cell_data", "field_data", "point_sets", "cell_sets"):
        for name, values in (getattr(mesh, where, None) or {}).items():
            facts[f"{where} '{name}'"] = values
    facts["periodic"] = getattr(mesh, "gmsh_periodic", None)
    return facts


# Gmsh

def gmsh_facts(path):
    gmsh = importlib.import_module("gmsh")
    gmsh.initialize([], False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.open(str(path))
        return gmsh_model_facts(gmsh)
    except Exception as error:  # the library raises nothing more special
        raise Unreadable(str(error)) from error
    finally:
        gmsh.finalize()


def gmsh_model_facts(gmsh):
    facts = {}
    for entity in gmsh.model.getEntities():
        nodes, _, _ = gmsh.model.mesh.getNodes(*entity)
        facts[f"nodes of {entity}"] = nodes
        facts[f"elements of {entity}"] = gmsh.model.mesh.getElements(*entity)
        facts[f"groups of {entity}"] = gmsh.model.getPhysicalGroupsForEntity(*entity)
    if not gmsh.model.mesh.getNodes()[0].size:
        raise Unreadable("no nodes")
    for group in gmsh.model.getPhysicalGroups():
        facts[f"name of group {group}"] = gmsh.model.getPhysicalName(*group)
    for tag in gmsh.view.getTags():
        facts[f"view {tag}"] = gmsh.view.option.getString(tag, "Name")
        facts[f"data of view {tag}"] = gmsh.view.getModelData(tag, 0)[:3]
    return facts


# The comparison.

ORACLES = [  # name, module, what it sees in a file, suffixes of the files it is asked about
    ("VTK", "vtk", vtk_facts, tuple(VTK_READERS)),
    ("VTK", "vtk", exodus_facts, EXODUS_SUFFIXES),
    ("meshio", "meshio", meshio_facts,
     (".msh", ".inp", ".mesh", ".meshb", ".bdf", ".nas", ".fem", ".su2", ".off", ".vtu", ".vtk")),
    ("Gmsh", "gmsh", gmsh_facts, (".msh",)),
]


def is_same(old, new):
    """Compares two facts, which may be arrays, or lists and dicts of them."""
    if type(old) is not type(new):
        return False
    if isinstance(old, dict):
        return old.keys() == new.keys() and all(is_same(old[key], new[key]) for key in old)
    if isinstance(old, (list, tuple)):
        return len(old) == len(new) and all(map(is_same, old, new))
    if isinstance(old, numpy().ndarray):
        is_number = old.dtype.kind in "fc"
        return old.dtype == new.dtype and numpy().array_equal(old, new, equal_nan=is_number)
    return old == new


def first_difference(before, after):
    """What a library sees differently, None if nothing."""
    for name in list(before) + [name for name in after if name not in before]:
        if name not in after:
            return f"{name} is gone"
        if name not in before:
            return f"{name} is new"
        if not is_same(before[name], after[name]):
            return f"{name} differs"
    return None


def ask(facts_of, before, after):
    """What a library sees differently, None if nothing. Refuses if it does not read BEFORE."""
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        old = facts_of(before)
        try:
            new = facts_of(after)
        except Unreadable as error:
            return f"it no longer reads the file: {error}"
    return first_difference(old, new)


def unpacked(path, folder, name):
    """A file with its suffix in lower case, decompressed where it is in gzip."""
    suffixes = [suffix.lower() for suffix in path.suffixes if suffix.lower() != ".gz"]
    copy = folder / (name + (suffixes[-1] if suffixes else ""))
    with open(path, "rb") as file:
        is_gzip = file.read(2) == b"\x1f\x8b"
    with (gzip.open if is_gzip else open)(path, "rb") as source, open(copy, "wb") as target:
        shutil.copyfileobj(source, target)
    return copy


def check(before, after):
    """Asks every library. Returns the exit status."""
    status = 77
    for name, module, facts_of, suffixes in ORACLES:
        if before.suffix not in suffixes:
            continue
        try:
            importlib.import_module(module)
            difference = ask(facts_of, before, after)
        except ImportError:
            print(f"{name}: not installed")
            continue
        except Unreadable as error:
            print(f"{name}: does not read it: {error}")
            continue
        if difference:
            print(f"{name}: {difference}")
            return 1
        print(f"{name}: same cells, groups and fields")
        status = 0
    if status == 77:
        print("No library here reads this file.")
    return status


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("before", type=pathlib.Path)
    parser.add_argument("after", type=pathlib.Path)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        before = unpacked(arguments.before, folder, "before")
        after = unpacked(arguments.after, folder, "after")
        if before.suffix != after.suffix:
            after = after.rename(after.with_suffix(before.suffix))
        sys.exit(check(before, after))


if __name__ == "__main__":
    main()

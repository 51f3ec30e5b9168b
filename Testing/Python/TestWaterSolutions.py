# SPDX-License-Identifier: BSD-3-Clause
"""A Solution reads what solvers wrote, of every kind of file, at its steps and between them."""

import gc
import weakref

import numpy as np
import pytest
import water_test as wt
from solution_files import (COLUMNS, FILES, LEVELS, ROWS, TIMES, XML, folder, polygons, structured, unstructured,
                            write, write_collection, write_xml)
from vtkmodules import vtkIOHDF, vtkIONetCDF
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_QUAD, VTK_TETRA, vtkCellArray, vtkDataSetAttributes, vtkPolyData,
                                           vtkUnstructuredGrid)
from vtkmodules.vtkIOExodus import vtkExodusIIWriter
from vtkmodules.vtkIOLegacy import vtkDataSetWriter
from vtkwater import readers, solutions
from vtkwater.ugrid import UgridMesh


def judge_mesh(name, mesh, level, h="h"):
    x = vtk_to_numpy(mesh.GetPoints().GetData())[:, 0]
    depth = vtk_to_numpy(mesh.GetPointData().GetArray(h)).astype(float)
    depth = np.where(np.isfinite(depth), depth, 0.0)
    wt.check_equal(f"{name}: class, points", (mesh.GetClassName(), mesh.GetNumberOfPoints()),
                   ("vtkPolyData", COLUMNS * ROWS))
    wt.check_at_most(f"{name}: depth off by", float(np.abs(depth - np.maximum(level - x / 100 + 1, 0.0)).max()), 1e-6)


@pytest.mark.parametrize("kind", [*XML, ".vtk"])
def test_every_kind_of_vtk_file_is_read(folder, kind):
    """Their arrays of points and cells are those that were written."""
    path = folder / f"slope{kind}"
    if kind == ".vtk":
        write(vtkDataSetWriter(), structured(), path)
    else:
        write_xml(path)
    solution = solutions.Solution(path, ["h", "fraction"])
    wt.check_equal("times", solution.times, (0.0,))
    judge_mesh(kind, solution.at(0.0), 0.0)
    wt.check_equal("an array of cells", solution.range_of("fraction"), (0.0, 0.0))


def test_an_exodus_file_is_read(folder):
    path = write(vtkExodusIIWriter(), unstructured(0.5), folder / "slope.exo")
    judge_mesh("exo", solutions.Solution(path, ["h"]).at(0.0), 0.5)


def test_a_vtkhdf_file_is_read(folder):
    if not hasattr(vtkIOHDF, "vtkHDFWriter"):
        pytest.skip("this VTK writes no such files")
    path = write(vtkIOHDF.vtkHDFWriter(), unstructured(0.5), folder / "slope.vtkhdf")
    judge_mesh("vtkhdf", solutions.Solution(path, ["h"]).at(0.0), 0.5)


def has_netcdf4():
    try:
        import netCDF4  # noqa: F401
    except ImportError:
        return False
    return True


def test_a_mesh_is_the_same_by_netcdf4():
    """Points, cells, values and times are those of VTK's own reader, where it has one."""
    pytest.importorskip("netCDF4")
    mesh = UgridMesh(FILES / "mesh.nc")
    wt.check_equal("times", tuple(mesh.times), TIMES)
    data = mesh.read(2)
    if not hasattr(vtkIONetCDF, "vtkNetCDFUGRIDReader"):
        judge_mesh("netCDF4", data, 0.5)
        return
    other = solutions.Solution(FILES / "mesh.nc", ["h", "zb", "speed"]).step(2)
    for name in ("h", "zb", "speed", "place"):
        one, two = (at_corners(each, name) for each in (data, other))
        wt.check_equal(f"{name}: the same", bool(np.array_equal(one, two)), True)


def at_corners(mesh, name):
    """Of the cells' corners one after the other: filters may number points anew."""
    if name == "speed":
        return vtk_to_numpy(mesh.GetCellData().GetArray(name)).astype(float)
    values = mesh.GetPoints().GetData() if name == "place" else mesh.GetPointData().GetArray(name)
    return vtk_to_numpy(values).astype(float)[vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())]


@pytest.mark.parametrize("name", ("grid.nc", "lonlat.nc", "mesh.nc"))
def test_netcdf_is_read_with_its_times(name):
    """CF's grids and UGRID's meshes; in degrees they become metres: a degree at 60 north is 55.6 km wide."""
    if name == "mesh.nc" and not hasattr(vtkIONetCDF, "vtkNetCDFUGRIDReader") and not has_netcdf4():
        with pytest.raises(solutions.FileError, match="UGRID conventions need VTK 9.2"):
            solutions.Solution(FILES / name, ["h"])
        return
    solution = solutions.Solution(FILES / name, ["h", "zb"])
    wt.check_equal(f"{name}: times", solution.times, TIMES)
    bounds = solution.at(10.0).GetBounds()
    wide, high = (0.2 * 0.5 * 111195.08, 0.1 * 111195.08) if name == "lonlat.nc" else (200.0, 100.0)
    wt.check_at_most(f"{name}: width off by, of it", abs(bounds[1] / wide - 1.0), 1e-4)
    wt.check_at_most(f"{name}: height off by, of it", abs(bounds[3] / high - 1.0), 1e-4)
    for time, level in zip(TIMES, LEVELS):
        depth = vtk_to_numpy(solution.at(time).GetPointData().GetArray("h"))
        wt.check_at_most(f"{name}: deepest at {time} off by", abs(float(np.nanmax(depth)) - level - 1.0), 1e-6)
    if name != "mesh.nc":
        wt.check_equal(f"{name}: what is missing is NaN", bool(np.isnan(depth).any()), True)
    if name == "lonlat.nc":
        flat = solutions.Solution(FILES / name, ["h"], is_lonlat=False)
        wt.check_at_most("in degrees", abs(flat.at(0.0).GetBounds()[0] + 3.0), 1e-6)


def test_between_steps_all_arrays_and_points_are_interpolated(folder):
    files = [(time, f"moving{i}.vts") for i, time in enumerate(TIMES)]
    for (time, name), level in zip(files, LEVELS):
        write_xml(folder / name, structured(level, shift=time))
    solution = solutions.Solution(write_collection(folder / "moving.pvd", files), ["zeta", "v", "fraction"])
    for time, level in ((0.0, -0.5), (4.0, -0.3), (25.0, 0.375), (10.0, 0.0), (4.0, -0.3), (30.0, 0.5)):
        mesh = solution.at(time)
        wt.check_at_most(f"at {time}: a cell's value off by",
                         abs(mesh.GetCellData().GetArray("fraction").GetValue(7) - level), 1e-9)
        wt.check_at_most(f"at {time}: a vector off by",
                         abs(mesh.GetPointData().GetArray("v").GetTuple(9)[1] - 4 * level), 1e-9)
        wt.check_at_most(f"at {time}: z off by", abs(mesh.GetPoint(5)[2] - time), 1e-9)


def test_between_other_meshes_the_earlier_is_shown(folder):
    solution = solutions.Solution(folder / "mixed.pvd", ["h"])
    judge_mesh("between", solution.at(9.0), -0.5)
    wt.check_equal("told", "steps 0 and 1 differ" in solution.note, True)
    wt.check_equal("of the later one, points", solution.at(10.0).GetNumberOfPoints(), 18)


@pytest.mark.parametrize("first, second, equal", (
    (((0, 1, 2), (3, 4, 5, 6)), ((0, 1, 2, 3), (4, 5, 6)), False),
    (((0, 1, 2), (3, 4, 5, 6)), ((0, 1, 2), (3, 4, 5, 6)), True)))
def test_polygons_with_other_corners_are_other_cells(first, second, equal):
    """Even if the corners of all of them, one after the other, are the same."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.random.default_rng(1).uniform(size=(7, 3)), deep=True))
    meshes = []
    for polygons in (first, second):
        meshes.append(vtkPolyData())
        meshes[-1].SetPoints(points)
        meshes[-1].SetPolys(vtkCellArray())
        for corners in polygons:
            meshes[-1].GetPolys().InsertNextCell(len(corners), corners)
    wt.check_equal("the same", solutions.have_same_cells(*meshes), equal)


def test_cells_of_other_types_are_other_cells():
    meshes = []
    for kind in (VTK_TETRA, VTK_QUAD, VTK_TETRA):
        meshes.append(vtkUnstructuredGrid())
        meshes[-1].SetPoints(structured().GetPoints())
        meshes[-1].InsertNextCell(kind, 4, (0, 1, COLUMNS + 1, COLUMNS))
    wt.check_equal("the same", [solutions.have_same_cells(meshes[0], mesh) for mesh in meshes], [True, False, True])


@pytest.mark.parametrize("kind", (".vti", ".vtr", ".vts", ".vtu"))
def test_hidden_cells_are_no_part_of_a_solution(kind, tmp_path):
    mesh = XML[kind][0]()
    marks = np.zeros(mesh.GetNumberOfCells(), np.uint8)
    path = tmp_path / f"hidden{kind}"
    for wanted in (10, 0):
        marks[wanted:] = vtkDataSetAttributes.HIDDENCELL
        array = numpy_to_vtk(marks, deep=True)
        array.SetName(vtkDataSetAttributes.GhostArrayName())
        mesh.GetCellData().AddArray(array)
        write_xml(path, mesh)
        if wanted:
            wt.check_equal("cells", solutions.Solution(path, ["h"]).step(0).GetNumberOfCells(), wanted)
            if kind in (".vts", ".vtu"):
                wt.check_equal("cells of a surface", readers.read(path).data.GetNumberOfCells(), wanted)
    with pytest.raises(solutions.FileError, match="all of its cells are hidden"):
        solutions.Solution(path, ["h"])


def test_only_two_steps_are_kept(folder):
    solution = solutions.Solution(folder / "slope.pvd", ["h"])
    for time in (0.0, 5.0, 20.0, 30.0):
        solution.at(time)
    wt.check_equal("steps in memory", sorted(solution._steps), [1, 2])


def test_a_solution_goes_with_its_meshes(folder):
    solution = solutions.Solution(folder / "slope.pvd", ["h"])
    known, gone = weakref.ref(solution), []
    between = solution.at(15.0)
    kept = {"points": solution.step(1).GetPoints(), "cells": solution.step(1).GetPolys(), "source": solution._pipeline}
    for name, thing in kept.items():
        thing.AddObserver("DeleteEvent", lambda *_, name=name: gone.append(name))
    del solution, between, kept, thing
    gc.collect()
    wt.check_equal("kept", known() is not None, False)
    wt.check_equal("of VTK's objects are gone", sorted(gone), ["cells", "points", "source"])

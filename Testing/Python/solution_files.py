# SPDX-License-Identifier: BSD-3-Clause
"""Files of solvers of every kind that VTK writes, for tests: a level over a sloping bed, at three times."""

import pathlib

import numpy as np
import pytest
from vtkmodules import vtkIOXML
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkRectilinearGrid, vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

FILES = pathlib.Path(__file__).resolve().parents[1] / "Data/Solutions"
TIMES, LEVELS = (0.0, 10.0, 30.0), (-0.5, 0.0, 0.5)
COLUMNS, ROWS, STEP = 21, 11, 10.0
SIZE = "160x120"


def add_array(mesh, name, values, of_cells=False):
    array = numpy_to_vtk(np.asarray(values, dtype=float), deep=True)
    array.SetName(name)
    (mesh.GetCellData() if of_cells else mesh.GetPointData()).AddArray(array)


def filled(mesh, level):
    """With the bed of a slope along x, water on it, and arrays of a velocity and of cells."""
    x = np.array([mesh.GetPoint(i)[0] for i in range(mesh.GetNumberOfPoints())])
    bed = x / 100.0 - 1.0
    add_array(mesh, "zb", bed)
    add_array(mesh, "h", np.maximum(level - bed, 0.0))
    add_array(mesh, "zeta", np.maximum(level, bed))
    add_array(mesh, "v", np.stack([3.0 * level + 0.0 * x, 4.0 * level + 0.0 * x, 0.0 * x], axis=1))
    add_array(mesh, "fraction", np.full(mesh.GetNumberOfCells(), level), True)
    return mesh


def image(level=0.0, layers=1):
    mesh = vtkImageData()
    mesh.SetDimensions(COLUMNS, ROWS, layers)
    mesh.SetSpacing(STEP, STEP, STEP)
    return filled(mesh, level)


def rectilinear(level=0.0):
    mesh = vtkRectilinearGrid()
    mesh.SetDimensions(COLUMNS, ROWS, 1)
    for axis, count in (("X", COLUMNS), ("Y", ROWS), ("Z", 1)):
        getattr(mesh, f"Set{axis}Coordinates")(numpy_to_vtk(STEP * np.arange(float(count)), deep=True))
    return filled(mesh, level)


def structured(level=0.0, shift=0.0):
    mesh = vtkStructuredGrid()
    mesh.SetDimensions(COLUMNS, ROWS, 1)
    y, x = np.mgrid[0:ROWS, 0:COLUMNS] * STEP
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.stack([x, y, 0.0 * x + shift], axis=-1).reshape(-1, 3), deep=True))
    mesh.SetPoints(points)
    return filled(mesh, level)


def unstructured(level=0.0):
    append = vtkAppendFilter()
    append.AddInputData(structured(level))
    append.Update()
    return append.GetOutput()


def polygons(level=0.0):
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(structured(level))
    surface.Update()
    return surface.GetOutput()


def blocks(level=0.0):
    made = vtkMultiBlockDataSet()
    made.SetBlock(0, structured(level))
    return made


def write(writer, data, path):
    writer.SetFileName(str(path))
    writer.SetInputData(data)
    writer.Write()
    return path


XML = {".vti": (image, "ImageData"), ".vtr": (rectilinear, "RectilinearGrid"), ".vts": (structured, "StructuredGrid"),
       ".vtp": (polygons, "PolyData"), ".vtu": (unstructured, "UnstructuredGrid"), ".vtm": (blocks, "MultiBlockData"),
       ".pvtu": (unstructured, "PUnstructuredGrid"), ".pvtp": (polygons, "PPolyData")}


def write_xml(path, data=None):
    make, kind = XML[path.suffix]
    return write(getattr(vtkIOXML, f"vtkXML{kind}Writer")() if hasattr(vtkIOXML, f"vtkXML{kind}Writer") else
                 parallel_writer(kind), make() if data is None else data, path)


def parallel_writer(kind):
    from vtkmodules import vtkIOParallelXML
    return getattr(vtkIOParallelXML, f"vtkXML{kind}Writer")()


def write_collection(path, files):
    entries = "".join(f'<DataSet timestep="{time}" file="{file}"/>' for time, file in files)
    path.write_text(f'<VTKFile type="Collection"><Collection>{entries}</Collection></VTKFile>')
    return path


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A series of three steps, slope.pvd, its steps out of order; and what is wrong with others."""
    made = tmp_path_factory.mktemp("data")
    for i, level in enumerate(LEVELS):
        write_xml(made / f"s{i}.vts", structured(level))
    files = [(time, f"s{i}.vts") for i, time in enumerate(TIMES)]
    write_collection(made / "slope.pvd", [files[2], files[0], files[1]])
    write_collection(made / "gap.pvd", [files[0], (10.0, "lost.vts")])
    write_collection(made / "none.pvd", [])
    write_collection(made / "late.pvd", [("soon", "s0.vts")])
    write_collection(made / "nan.pvd", [("nan", "s0.vts"), files[1]])
    write_collection(made / "endless.pvd", [files[0], ("-inf", "s1.vts")])
    write_xml(made / "other.vtp", polygons(0.5))
    write_collection(made / "mixed.pvd", [files[0], (10.0, "coarse.vti")])
    coarse = vtkImageData()
    coarse.SetDimensions(6, 3, 1)
    coarse.SetSpacing(40.0, 50.0, 1.0)
    write_xml(made / "coarse.vti", filled(coarse, 0.5))
    write_xml(made / "volume.vti", image(0.0, 5))
    write_xml(made / "dry.vts", structured(-3.0))
    (made / "text.pvd").write_text("not what its name claims\n")
    (made / "text.nc").write_text("not what its name claims\n")
    return made

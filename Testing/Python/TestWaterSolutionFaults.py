# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong with a NetCDF mesh is said, by VTK's reader and by the package netCDF4 in its place."""

import numpy as np
import pytest
import water_test as wt
from vtkmodules import vtkIONetCDF
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkwater import netcdf, solutions
from vtkwater.readers import METRES_PER_DEGREE, FileError
from vtkwater.ugrid import NoMesh, UgridMesh

try:
    import netCDF4
except ModuleNotFoundError as error:
    print(f"skipped: {error}")  # CMake's tests look for it
    pytest.skip(str(error), allow_module_level=True)

HAS_VTKS = hasattr(vtkIONetCDF, "vtkNetCDFUGRIDReader")
SQUARE = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]


def write_mesh(path, dimension=2, coordinates="x y", faces=((0, 1, 2, 3),), times=(0.0, 10.0, 30.0), values=4,
               role="mesh_topology", node="node", units=None):
    """A square; h of its nodes is 100 times its step plus the node, and there is one value that has no place.

    node: the name of the nodes' dimension
    """
    with netCDF4.Dataset(path, "w") as file:
        for name, size in ((node, 4), ("face", len(faces)), ("corner", 4), ("time", len(times)), ("n", values)):
            file.createDimension(name, size)
        mesh = file.createVariable("mesh", "i4")
        mesh.cf_role, mesh.node_coordinates, mesh.face_node_connectivity = role, coordinates, "faces"
        if dimension is not None:
            mesh.topology_dimension = dimension
        for axis, name in enumerate("xy"):
            places = file.createVariable(name, "f8", (node,))
            places[:] = [place[axis] for place in SQUARE]
            if units:
                places.units = units[axis]
        file.createVariable("faces", "i4", ("face", "corner"), fill_value=-1)[:] = faces
        file.createVariable("time", "f8", ("time",))[:] = times
        h = file.createVariable("h", "f8", ("time", node if values == 4 else "n"))
        h[:] = 100.0 * np.arange(len(times))[:, None] + np.arange(values)
        single = file.createVariable("single", "f8")
        single[:] = 3.0
        for variable in (h, single):
            variable.mesh, variable.location = "mesh", "node"
    return path


def h_of(data):
    return vtk_to_numpy(data.GetPointData().GetArray("h")).tolist()


FAULTS = (
    ({"dimension": None}, "the topology_dimension of 'mesh' is missing; it must be 2"),
    ({"dimension": 1}, "the topology_dimension of 'mesh' is 1; it must be 2"),
    ({"coordinates": "east y"}, "there is no variable 'east', the node_coordinates of 'mesh'"),
    ({"coordinates": "x"}, "the node_coordinates of 'mesh' is 'x'; it must name 2 variables"),
    ({"faces": ((0, 1, 2, 9),)}, "a face names node 9; there are 4, from 0 on"),
    ({"times": (0.0, float("nan"))}, "its time 1 is nan; it must be finite"),
    ({"times": (float("-inf"), 0.0)}, "its time 0 is -inf; it must be finite"),
)


@pytest.mark.parametrize("fault, words", FAULTS, ids=lambda value: None if isinstance(value, str) else str(value))
def test_what_is_wrong_with_a_mesh_is_said_by_netcdf4(tmp_path, fault, words):
    path = write_mesh(tmp_path / "mesh.nc", **fault)
    with pytest.raises(FileError) as caught:
        UgridMesh(path)
    wt.check_equal("said", str(caught.value), f"{path}: not a NetCDF mesh of the UGRID conventions: {words}")


@pytest.mark.parametrize("is_vtks", (True, False))
@pytest.mark.parametrize("fault, by_vtk, by_netcdf4", (
    ({"dimension": None}, "Attribute not found", "the topology_dimension of 'mesh' is missing"),
    ({"coordinates": "east y"}, "Variable not found", "there is no variable 'east'"),
    ({"times": (0.0, float("nan"))}, "its time 1 is nan", "its time 1 is nan"),
), ids=str)
def test_why_a_mesh_is_refused_is_said(tmp_path, monkeypatch, is_vtks, fault, by_vtk, by_netcdf4):
    """Though the file is then read as a grid."""
    if is_vtks and not HAS_VTKS:
        pytest.skip("this VTK reads no such meshes")
    if not is_vtks:
        hide_vtks(monkeypatch)
    path = write_mesh(tmp_path / "mesh.nc", **fault)
    with pytest.raises(FileError) as caught:
        solutions.Solution(path, ["h"])
    words = by_vtk if is_vtks else by_netcdf4
    wt.check_equal(f"'{words}' is in: {caught.value}", words in str(caught.value), True)


def hide_vtks(monkeypatch):
    """As if this were a VTK before 9.2."""
    of_vtk = netcdf.reader_of
    monkeypatch.setattr(netcdf, "reader_of",
                        lambda module, name: None if "UGRID" in name else of_vtk(module, name))


def test_steps_are_in_the_order_of_their_times(tmp_path, monkeypatch):
    path = write_mesh(tmp_path / "mesh.nc", times=(30.0, 0.0, 10.0))
    if HAS_VTKS:  # whose reader gives other steps
        with pytest.raises(FileError, match="its time 1 is 0, after 30; times must ascend"):
            solutions.Solution(path, ["h"])
    hide_vtks(monkeypatch)
    solution = solutions.Solution(path, ["h"])
    wt.check_equal("times", solution.times, (0.0, 10.0, 30.0))
    wt.check_equal("h", [h_of(solution.at(time))[0] for time in (0.0, 5.0, 10.0, 30.0)], [100.0, 150.0, 200.0, 0.0])


def write_grid(path, times, axes=("y", "x")):
    with netCDF4.Dataset(path, "w") as file:
        for name, values in (("time", times), (axes[0], range(4)), (axes[1], range(5))):
            file.createDimension(name, len(values))
            file.createVariable(name, "f8", (name,))[:] = values
        file["time"].units = "seconds since 2024-01-01"
        file.createVariable("h", "f8", ("time", *axes))[:] = 1.0
    return path


def test_names_of_dimensions_may_have_hyphens(tmp_path):
    """WRF's south-north and west-east are no degrees; lat-rho and lon-rho of another model are."""
    metres = solutions.Solution(write_grid(tmp_path / "a.nc", (0.0, 10.0), ("south-north", "west-east")), ["h"])
    wt.check_equal("times", metres.times, (0.0, 10.0))
    wt.check_equal("h", set(h_of(metres.at(10.0))), {1.0})
    wt.check_equal("width in metres", metres.at(0.0).GetBounds()[1], 4.0)
    degrees = solutions.Solution(write_grid(tmp_path / "b.nc", (0.0, 10.0), ("lat-rho", "lon-rho")), ["h"])
    # a degree of longitude at the middle latitude, 1.5 degrees
    wide = 4.0 * METRES_PER_DEGREE * np.cos(np.radians(1.5))
    bounds = degrees.at(0.0).GetBounds()
    wt.check_at_most("width off by, of it", abs((bounds[1] - bounds[0]) / wide - 1.0), 1e-3)


@pytest.mark.parametrize("is_vtks", (True, False))
def test_nodes_of_a_mesh_may_have_hyphens(tmp_path, monkeypatch, is_vtks):
    """A mesh whose dimension of nodes is mesh-nodes is in degrees if its coordinates have the units of degrees."""
    if is_vtks and not HAS_VTKS:
        pytest.skip("this VTK reads no such meshes")
    if not is_vtks:
        hide_vtks(monkeypatch)
    path = write_mesh(tmp_path / "mesh.nc", node="mesh-nodes", units=("degrees_east", "degrees_north"))
    solution = solutions.Solution(path, ["h"])
    wt.check_equal("h", h_of(solution.at(0.0)), [0.0, 1.0, 2.0, 3.0])
    bounds = solution.at(0.0).GetBounds()
    wt.check_at_most("height off by, of it", abs((bounds[3] - bounds[2]) / METRES_PER_DEGREE - 1.0), 1e-6)


@pytest.mark.parametrize("write", (write_grid, write_mesh), ids=("grid", "mesh"))
@pytest.mark.parametrize("times, words", (
    ((1800.0, 0.0, 3000.0), "its time 1 is 0, after 1800; times must ascend"),
    ((0.0, 600.0, 600.0), "its time 2 is 600, after 600; times must ascend"),
    ((20.0, 10.0, 0.0), "its time 1 is 10, after 20; times must ascend")))
def test_times_that_do_not_ascend_are_an_error(write, times, words, tmp_path):
    """It comes before others, and no step is left out silently."""
    path = tmp_path / "a.nc"
    write(path, times=times)
    if write is write_mesh and not HAS_VTKS:
        pytest.skip("netCDF4 sorts the steps of a mesh")
    with pytest.raises(FileError) as caught:
        solutions.Solution(path, ["none"])
    wt.check_equal("the error", str(caught.value), f"{path}: {words}")


def test_a_repeated_time_of_a_mesh_is_an_error_without_vtks_reader(tmp_path):
    with pytest.raises(FileError, match="its time 2 is 600, like an earlier one; times must differ"):
        UgridMesh(write_mesh(tmp_path / "a.nc", times=(0.0, 600.0, 600.0)))


def test_a_single_value_is_no_array_of_the_mesh(tmp_path):
    mesh = UgridMesh(write_mesh(tmp_path / "mesh.nc"))
    data = mesh.read(2)
    wt.check_equal("arrays", data.GetPointData().GetNumberOfArrays(), 1)
    wt.check_equal("h", h_of(data), [200.0, 201.0, 202.0, 203.0])


def test_an_array_of_another_size_is_refused(tmp_path):
    with pytest.raises(FileError, match="the variable 'h' has 3 values; the mesh has 4 nodes"):
        UgridMesh(write_mesh(tmp_path / "mesh.nc", values=3)).read(0)


def test_a_file_without_a_mesh_is_none(tmp_path):
    with pytest.raises(NoMesh, match="holds no mesh"):
        UgridMesh(write_mesh(tmp_path / "mesh.nc", role="none"))


def test_a_file_is_closed(tmp_path, monkeypatch):
    """After it is opened, after each step, and where it is refused."""
    path = write_mesh(tmp_path / "mesh.nc")
    refused, opened, of_netcdf4 = write_mesh(tmp_path / "refused.nc", coordinates="x"), [], netCDF4.Dataset

    def remember(*arguments):
        opened.append(of_netcdf4(*arguments))
        return opened[-1]

    monkeypatch.setattr(netCDF4, "Dataset", remember)
    UgridMesh(path).read(1)
    with pytest.raises(FileError):
        UgridMesh(refused)
    wt.check_equal("opened, still open", (len(opened), sum(file.isopen() for file in opened)), (3, 0))


@pytest.mark.parametrize("has_bed", (False, True))
def test_a_time_without_units_is_said(tmp_path, has_bed):
    """VTK counts it as a dimension of space; the error says so, and what is missing."""
    path = tmp_path / "grid.nc"
    with netCDF4.Dataset(path, "w") as file:
        for name, size in (("time", 3), ("y", 4), ("x", 5)):
            file.createDimension(name, size)
            file.createVariable(name, "f8", (name,))[:] = np.arange(size)
        file.createVariable("h", "f8", ("time", "y", "x"))[:] = 1.0
        if has_bed:
            file.createVariable("zb", "f8", ("y", "x"))[:] = 0.0
    with pytest.raises(FileError) as caught:
        solutions.Solution(path, ["h"]).step(0)
    for words in ("the time 'time' has no units", "give its variable the attribute units"):
        wt.check_equal(words, words in str(caught.value), True)


@pytest.mark.parametrize("has_data, is_refused", ((True, False), (False, True)))
def test_an_empty_dimension_is_no_matter_if_others_have_data(has_data, is_refused, tmp_path):
    """A run that has just begun is an error; an empty list of stations beside a grid is none."""
    with netCDF4.Dataset(tmp_path / "a.nc", "w") as file:
        for name, size in (("time", None), ("y", 3), ("x", 4), ("station", None)):
            file.createDimension(name, size)
        file.createVariable("heights", "f8", ("station", "x"))
        if has_data:
            file.createVariable("zeta", "f8", ("y", "x"))[:] = 1.0
    refused = None
    try:
        netcdf.check_dimensions(tmp_path / "a.nc")
    except FileError as error:
        refused = str(error)
    wt.check_equal(f"refused: {refused}", refused is not None and "'station' is empty" in refused, is_refused)

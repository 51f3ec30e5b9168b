# SPDX-License-Identifier: BSD-3-Clause
"""What a NetCDF file states of units counts: degrees become metres, and so do heights in centimetres and feet."""

import json

import numpy as np
import pytest
import water_test as wt
from vtkmodules import vtkIONetCDF
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkwater import command, netcdf
from vtkwater.data_scenes import DataWater
from vtkwater.measure import gauges
from vtkwater.scenes import Scene
from vtkwater.solutions import Solution, array_of

try:
    import netCDF4
except ModuleNotFoundError as error:
    print(f"skipped: {error}")  # CMake's tests look for it
    pytest.skip(str(error), allow_module_level=True)

HAS_VTKS = hasattr(vtkIONetCDF, "vtkNetCDFUGRIDReader")
KILOMETRES_PER_DEGREE = 111.195  # of a great circle
DEGREES = "degrees_east", "degrees_north"
LON, LAT = (-3.0, -2.8), (59.95, 60.05)  # ends
WIDE, HIGH = 0.2 * 500 * KILOMETRES_PER_DEGREE, 0.1 * 1000 * KILOMETRES_PER_DEGREE  # m: the cosine of 60 degrees is 0.5
ROWS, COLUMNS = 6, 11


def places():
    return np.meshgrid(np.linspace(*LON, COLUMNS), np.linspace(*LAT, ROWS))


def add_heights(file, dimensions, shape, units, **attributes):
    """A bed of -2 m, and a level of 0.5 m that rises by 0.5 m a step, in other units."""
    per_metre = {"cm": 100.0, "m": 1.0, "feet": 1.0 / 0.3048, "": 1.0}
    for name, unit, steps in (("zeta", units[0], (0.5, 1.0)), ("zb", units[1], None)):
        times = () if steps is None else ("time",)
        variable = file.createVariable(name, "f8", (*times, *dimensions))
        if unit:
            variable.units = unit
        for key, value in attributes.items():
            setattr(variable, key, value)
        for i, height in enumerate(steps or (-2.0,)):
            values = np.full(shape, per_metre[unit] * height)
            if steps is None:
                variable[:] = values
            else:
                variable[i] = values
    time = file.createVariable("time", "f8", ("time",))
    time.units = "seconds since 2020-01-01"
    time[:] = (0.0, 10.0)


def write_curvilinear(path, coordinates=DEGREES, units=("m", "m")):
    """A grid as ocean models write it: the places of its points are variables of two dimensions."""
    with netCDF4.Dataset(path, "w") as file:
        file.Conventions = "CF-1.8"
        for name, size in (("time", None), ("eta_rho", ROWS), ("xi_rho", COLUMNS)):
            file.createDimension(name, size)
        for name, unit, values in zip(("lon_rho", "lat_rho"), coordinates, places()):
            place = file.createVariable(name, "f8", ("eta_rho", "xi_rho"))
            place.units = unit
            place[:] = values
        add_heights(file, ("eta_rho", "xi_rho"), (ROWS, COLUMNS), units, coordinates="lon_rho lat_rho")
    return path


def write_rows(path, coordinates=DEGREES, units=("m", "m")):
    """A grid whose rows and columns have a coordinate each."""
    with netCDF4.Dataset(path, "w") as file:
        file.Conventions = "CF-1.8"
        for name, size in (("time", None), ("y", ROWS), ("x", COLUMNS)):
            file.createDimension(name, size)
        for name, unit, ends, count in zip("xy", coordinates, (LON, LAT), (COLUMNS, ROWS)):
            place = file.createVariable(name, "f8", (name,))
            place.units = unit
            place[:] = np.linspace(*ends, count)
        add_heights(file, ("y", "x"), (ROWS, COLUMNS), units)
    return path


def write_mesh(path, coordinates=DEGREES, units=("m", "m"), others=None):
    """Triangles after UGRID. others: units of two more variables of the nodes, which are not their places."""
    with netCDF4.Dataset(path, "w") as file:
        file.Conventions = "CF-1.8 UGRID-1.0"
        first = np.arange(ROWS * COLUMNS).reshape(ROWS, COLUMNS)[:-1, :-1].ravel()
        faces = np.concatenate([np.stack([first, first + 1, first + COLUMNS], axis=1),
                                np.stack([first + 1, first + COLUMNS + 1, first + COLUMNS], axis=1)])
        for name, size in (("time", None), ("node", ROWS * COLUMNS), ("face", len(faces)), ("three", 3)):
            file.createDimension(name, size)
        mesh = file.createVariable("mesh", "i4")
        mesh.cf_role, mesh.topology_dimension = "mesh_topology", np.int32(2)
        mesh.node_coordinates, mesh.face_node_connectivity = "node_x node_y", "face_nodes"
        for name, unit, values in zip(("node_x", "node_y"), coordinates, places()):
            place = file.createVariable(name, "f8", ("node",))
            place.units = unit
            place[:] = values.ravel()
        for name, unit in zip(("lon", "lat"), others or ()):
            file.createVariable(name, "f8", ("node",)).units = unit
            file[name][:] = np.linspace(10.0, 10.1, ROWS * COLUMNS)
        connected = file.createVariable("face_nodes", "i4", ("face", "three"))
        connected.cf_role, connected.start_index = "face_node_connectivity", np.int32(0)
        connected[:] = faces
        add_heights(file, ("node",), ROWS * COLUMNS, units, mesh="mesh", location="node")
    return path


def reader(monkeypatch, kind):
    """As if this were a VTK before 9.2, of which netCDF4 reads the meshes; or VTK's own reader."""
    if kind == "VTK":
        if not HAS_VTKS:
            pytest.skip("this VTK has no reader of UGRID")
        return
    of_vtk = netcdf.reader_of
    monkeypatch.setattr(netcdf, "reader_of",
                        lambda module, name: None if "UGRID" in name else of_vtk(module, name))


WRITERS = {"curvilinear": write_curvilinear, "rows": write_rows, "mesh": write_mesh}
KINDS = (("curvilinear", "VTK"), ("rows", "VTK"), ("mesh", "VTK"), ("mesh", "netCDF4"))


def write(kind, path, **words):
    return WRITERS[kind](path, **words)


def check_size(path, wide, high):
    bounds = Solution(path, ["zeta"]).at(5.0).GetBounds()
    wt.check_at_most("width off by, of it", abs((bounds[1] - bounds[0]) / wide - 1.0), 1e-3)
    wt.check_at_most("height off by, of it", abs((bounds[3] - bounds[2]) / high - 1.0), 1e-3)


@pytest.mark.parametrize("kind, by", KINDS)
@pytest.mark.parametrize("coordinates", (DEGREES, ("degree_E", "degreesN")), ids=" ".join)
def test_degrees_become_metres(kind, by, coordinates, tmp_path, monkeypatch):
    """By the units of the coordinates, whatever their names are."""
    reader(monkeypatch, by)
    check_size(write(kind, tmp_path / "a.nc", coordinates=coordinates), WIDE, HIGH)


@pytest.mark.parametrize("kind, by", KINDS[1:])  # of a curvilinear grid in metres VTK reads no places
def test_metres_stay(kind, by, tmp_path, monkeypatch):
    """A small basin whose metres may be taken for degrees; a mesh that knows its nodes' longitudes, too."""
    reader(monkeypatch, by)
    words = {} if kind == "rows" else {"others": DEGREES}
    check_size(write(kind, tmp_path / "a.nc", coordinates=("m", "m"), **words), LON[1] - LON[0], LAT[1] - LAT[0])


@pytest.mark.parametrize("kind, by", KINDS)
@pytest.mark.parametrize("units", (("cm", "m"), ("feet", "m"), ("m", "feet"), ("", "cm"), ("m", "m")), ids=" ".join)
def test_heights_become_metres(kind, by, units, tmp_path, monkeypatch):
    """Level and bed in other units: the water is 2.5 m deep, later 3; a unit that is not stated is metres. Colours keep
    the file's unit."""
    reader(monkeypatch, by)
    solution = Solution(write(kind, tmp_path / "a.nc", units=units), ["zeta", "zb"])
    water = DataWater(Scene((32, 24)), solution, level="zeta", bed="zb", color_by="zeta")
    for time, level in ((0.0, 0.5), (5.0, 0.75), (10.0, 1.0)):
        water.show(time)
        surface = water.filter.GetOutput()
        depth = vtk_to_numpy(surface.GetPointData().GetArray("WaterDepth"))
        wt.check_at_most(f"depth at {time} off by", float(np.abs(depth - level - 2.0).max()), 1e-6)
        wt.check_at_most(f"level at {time} off by", abs(surface.GetBounds()[4] - level), 1e-6)
    ends = water.water.GetMapper().GetLookupTable().GetRange()
    shown = {"cm": 100.0, "feet": 1.0 / 0.3048}.get(units[0], 1.0)
    wt.check_at_most("range of colours off by", float(np.abs(np.array(ends) - (0.5 * shown, shown)).max()), 1e-4)
    wt.check_equal("nothing is told", water.notes, [])


@pytest.mark.parametrize("kind, by", KINDS)
@pytest.mark.parametrize("unit, metres", (("ft", 0.3048), ("US_survey_foot", 1200.0 / 3937.0), ("cm", 0.01)))
def test_a_solution_is_in_metres(kind, by, unit, metres, tmp_path, monkeypatch):
    """As the command's water: at a step and between two, in ranges and at gauges; other arrays keep their values."""
    reader(monkeypatch, by)
    path = write(kind, tmp_path / "a.nc", units=("m", "m"))
    with netCDF4.Dataset(path, "a") as file:
        file["zeta"][:] = file["zeta"][:] / metres
        file["zeta"].units = unit
    solution = Solution(path, ["zeta", "zb"])
    for time, level in ((0.0, 0.5), (5.0, 0.75), (10.0, 1.0)):
        values = vtk_to_numpy(array_of(solution.at(time), "zeta"))
        wt.check_at_most(f"level at {time} off by", float(np.abs(values - level).max()), 1e-6)
    wt.check_at_most("range off by", float(np.abs(np.array(solution.range_of("zeta")) - (0.5, 1.0)).max()), 1e-6)
    wt.check_equal("unit of the file", (solution.unit_of("zeta"), solution.factor_of("zb")), (unit, 1.0))
    bounds = solution.at(0.0).GetBounds()
    found = gauges(solution, [(0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]))], level="zeta", bed="zb")
    wt.check_at_most("depths off by", float(np.abs(found["WaterDepth"].ravel() - (2.5, 3.0)).max()), 1e-6)


@pytest.mark.parametrize("unit", ("furlong", "kg"))
def test_a_unit_that_is_no_length_is_told(unit, tmp_path):
    path = write("rows", tmp_path / "a.nc", coordinates=("m", "m"))
    with netCDF4.Dataset(path, "a") as file:
        file["zeta"].units = unit
    solution = Solution(path, ["zeta", "zb"])
    water = DataWater(Scene((32, 24)), solution, level="zeta", bed="zb")
    wt.check_equal("notes", len(water.notes), 1)
    with pytest.warns(UserWarning) as caught:
        gauges(solution, [(0.0, 0.0)], level="zeta", bed="zb")
    wt.check_equal("warnings", len(caught), 1)
    for text in (water.notes[0], str(caught[0].message)):
        for word in ("'zeta'", f"'{unit}'", "taken as metres", "us_survey_foot", "cm"):
            wt.check(f"'{word}' is in the text", text, word, word in text)


@pytest.mark.parametrize("kind, by", KINDS)
def test_units_are_listed(kind, by, tmp_path, monkeypatch, capsys):
    reader(monkeypatch, by)
    path = write(kind, tmp_path / "a.nc", units=("cm", "m"))
    wt.check_equal("status", command.main(["info", str(path), "--json"]), 0)
    facts = json.loads(next(line for line in capsys.readouterr().out.splitlines() if line.startswith("{")))
    wt.check_equal("units", {array["name"]: array["unit"] for array in facts["arrays"] if array["name"] in
                             ("zeta", "zb")}, {"zeta": "cm", "zb": "m"})
    wt.check_equal("of places", facts["units"], "degrees, converted to metres for pictures")

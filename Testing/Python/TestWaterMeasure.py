# SPDX-License-Identifier: BSD-3-Clause
"""Water of data can be measured: picks, probes, shorelines, areas, volumes; and other tools get its geometry."""

import base64
import json

import numpy as np
import pytest
import water_test as wt
from TestWaterSurfaceFilter import HALF, add_array, bed_at, flooded, mesh_of, places_of, surface_of, wet_area
from TestWaterSurfaceMeshes import hide
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkImageData, vtkPolyData, vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkPointDataToCellData
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOExport import vtkGLTFExporter
from vtkmodules.vtkIOGeometry import vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter, vtkXMLStructuredGridWriter
from vtkmodules.vtkRenderingCore import vtkCellPicker, vtkPolyDataMapper
from vtkwater import measure, vtkWaterActor, vtkWaterLakes
from vtkwater.data_scenes import table_of
from vtkwater.solutions import Solution

LEVEL = 0.4
SIZE = (320, 240)


def slope(scale=1.0, **arrays):
    """Water on a slope, with an array x of its points, and the mesh it is made of."""
    mesh = flooded(LEVEL)
    add_array(mesh, "x", places_of(mesh, False)[:, 0])
    made, surface, _ = surface_of(mesh, DepthArrayName="h", BedArrayName="zb", DryDepth=0.0, VerticalScale=scale)
    return made, surface, mesh


def scene(scale=1.0):
    """The same seen from above, coloured by x."""
    made, _, mesh = slope(scale)
    view = wt.View(SIZE)
    water = vtkWaterActor()
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(made.GetOutputPort())
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("x")
    mapper.SetLookupTable(table_of("viridis", (-HALF, HALF)))
    mapper.UseLookupTableScalarRangeOn()
    water.SetMapper(mapper)
    water.SetLevel(made.GetMeanLevel())
    view.renderer.AddActor(water)
    wt.place_camera(view.renderer, (0, 0, 20), (0, 0, 0), (1, 100), (0, 1, 0))
    view.picture()
    view.made = made  # it lives as long as the view
    return view, water, mesh


@pytest.mark.parametrize("scale", (1.0, 3.0))
def test_a_probe_tells_level_depth_and_every_array(scale):
    """At random places of the water exactly, at all others NaN; however high it is drawn."""
    _, surface, _ = slope(scale)
    places = np.random.default_rng(5).uniform(-HALF, HALF, (2000, 2))
    found = measure.probe(surface, places)
    wet = bed_at(places) < LEVEL
    wt.check_equal("dry places are NaN, wet ones are not",
                   bool((np.isnan(found["WaterLevel"]) == ~wet).all()), True)
    for name, wanted in (("WaterLevel", np.full(len(places), LEVEL)), ("WaterDepth", LEVEL - bed_at(places)),
                         ("x", places[:, 0]), ("zb", bed_at(places)), ("z", np.full(len(places), scale * LEVEL))):
        wt.check_at_most(f"{name} off by", float(np.abs(found[name] - wanted)[wet].max()), 1e-5)


def test_a_probe_tells_cells_and_vectors():
    mesh = flooded(9.0)
    add_array(mesh, "v", np.stack([places_of(mesh, False)[:, 0], 2.0 * places_of(mesh, False)[:, 1]], axis=1))
    convert = vtkPointDataToCellData()
    convert.SetInputData(mesh)
    convert.PassPointDataOn()
    convert.Update()
    convert.GetOutput().GetPointData().RemoveArray("v")
    _, surface, _ = surface_of(convert.GetOutput(), LevelArrayName="zeta")
    found = measure.probe(surface, [(1.0, 2.0, 77.0), (-3.0, -4.0, 0.0), (50.0, 0.0, 0.0)])["v"]
    wt.check_equal("shape", found.shape, (3, 2))
    wt.check_at_most("of the cells off by", float(np.abs(found[:2] - [(1.0, 4.0), (-3.0, -8.0)]).max()), 2.5)
    wt.check_equal("outside", bool(np.isnan(found[2]).all()), True)


@pytest.mark.parametrize("bad, words", (
    ([1.0, 2.0, 3.0, 4.0], r"are of shape \(4,\)"), ([[[1.0, 2.0]]], r"are of shape \(1, 1, 2\)"),
    ([(0.0, 0.0), (1.0, float("nan"))], r"has \(1, nan\) at 1"), ("here", "is 'here'"),
    ([(1, 2), (1,)], r"is .*\(1,\)\]"),
))
def test_wrong_places_are_refused(bad, words):
    """With the value that is wrong."""
    with pytest.raises(ValueError, match=f"points {words}; (they|it) must be n x 2 or n x 3 finite numbers"):
        measure.probe(slope()[1], bad)


def test_what_is_no_water_of_data_is_refused():
    with pytest.raises(TypeError, match="must be a vtkWaterActor, vtkWaterLakes or vtkPolyData .* not float"):
        measure.flooded(3.0)
    with pytest.raises(TypeError, match="mesh must be a vtkDataSet, not NoneType"):
        measure.shoreline(slope()[1], None)


def test_of_no_water_there_are_no_values():
    wt.check_equal("of nothing", bool(np.isnan(measure.probe(vtkPolyData(), [(0.0, 0.0)])["z"]).all()), True)
    wt.check_equal("at no place", measure.probe(slope()[1], [])["WaterLevel"].shape, (0,))


def polygon_of(corners, is_strip=False, depth=None, with_line=False):
    """One polygon, or a strip of triangles."""
    points, cells, made = vtkPoints(), vtkCellArray(), vtkPolyData()
    for x, y in corners:
        points.InsertNextPoint(x, y, 0.0)
    cells.InsertNextCell(len(corners), list(range(len(corners))))
    made.SetPoints(points)
    (made.SetStrips if is_strip else made.SetPolys)(cells)
    if depth is not None:
        add_array(made, "WaterDepth", np.array([depth(x, y) for x, y in corners], dtype=float))
    if with_line:
        lines = vtkCellArray()
        lines.InsertNextCell(2, [0, 1])
        made.SetLines(lines)
    return made


NOTCHED = [(0, 0), (4, 0), (4, 4), (2, 1), (0, 4)]  # square 16, less a triangle of 6
STRIP = [(0, 0), (0, 1), (2, 0), (2, 1), (4, 0), (4, 1)]


@pytest.mark.parametrize("turn", range(5))
@pytest.mark.parametrize("way", (1, -1))
def test_a_concave_polygon_has_its_own_area(turn, way):
    """Whichever its first corner is, and whichever way round it goes; depth 1 + x."""
    corners = (NOTCHED[turn:] + NOTCHED[:turn])[::way]
    found = measure.flooded(polygon_of(corners, depth=lambda x, y: 1 + x))
    wt.check_equal("area, volume", np.round(found, 9).tolist(), [10.0, 30.0])


def test_strips_of_triangles_count():
    wt.check_equal("area, volume", np.round(measure.flooded(polygon_of(STRIP, True, lambda x, y: 1 + x)), 9).tolist(),
                   [4.0, 12.0])


def test_each_array_keeps_its_values():
    """An array z is not lost, one without a name is left out, and lines are no water."""
    surface = polygon_of([(0, 0), (4, 0), (4, 4), (0, 4)], with_line=True)
    add_array(surface, "z", np.full(4, 7.0))
    add_array(surface, None, np.zeros(4))
    add_array(surface, "of_cells", np.array([-1.0, 5.0]), True)
    found = measure.probe(surface, [(2.0, 1.0), (2.0, 0.0)])
    wt.check_equal("arrays", sorted(found), ["WaterZ", "of_cells", "z"])
    wt.check_equal("z", np.round(found["z"], 9).tolist(), [7.0, 7.0])
    wt.check_equal("height", found["WaterZ"].tolist(), [0.0, 0.0])
    wt.check_equal("of the polygon, also on the line", found["of_cells"].tolist(), [5.0, 5.0])


@pytest.mark.parametrize("of_cells, what", ((False, "4 points"), (True, "1 cells")))
def test_a_short_array_is_refused(of_cells, what):
    surface = polygon_of([(0, 0), (4, 0), (4, 4), (0, 4)])
    add_array(surface, "short", np.zeros(0 if of_cells else 2), of_cells)
    with pytest.raises(ValueError, match=f"the array 'short' has [02] values; the water has {what}"):
        measure.probe(surface, [(1.0, 1.0)])
    add_array(surface, "WaterDepth", np.zeros(2))
    with pytest.raises(ValueError, match="the array 'WaterDepth' has 2 values; the water has 4 points"):
        measure.flooded(surface)


@pytest.mark.parametrize("measured", (measure.flooded, lambda water: measure.probe(water, [(0.0, 0.0)])))
def test_a_point_that_is_not_finite_is_refused(measured):
    with pytest.raises(ValueError, match=r"point 2 of the water is at \(nan, 4, 0\); it must be finite"):
        measured(polygon_of([(0, 0), (4, 0), (float("nan"), 4), (0, 4)]))


def test_all_lakes_are_measured():
    """Of a vtkWaterLakes with two of them."""
    both = vtkAppendPolyData()
    for x in (0.0, 10.0):
        both.AddInputData(polygon_of([(x, 0), (x + 4, 0), (x + 4, 4), (x, 4)], depth=lambda x, y: 2.0 + 0.1 * x))
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(both.GetOutputPort())
    lakes = vtkWaterLakes()
    lakes.SetMapper(mapper)
    lakes.Update()
    wt.check_equal("area", measure.flooded(lakes)[0], 32.0)
    wt.check_at_most("depth in both off by", float(np.abs(
        measure.probe(lakes, [(1, 1), (11, 1)])["WaterDepth"] - (2.1, 3.1)).max()), 1e-9)


@pytest.mark.parametrize("of_points", (True, False), ids=("points", "cells"))
def test_the_surface_has_all_lakes_and_their_colours(tmp_path, of_points):
    """One mesh to export: its area, values and colours are those of both lakes; the first actor's mesh has one only."""
    both = vtkAppendPolyData()
    for x in (0.0, 10.0):
        both.AddInputData(polygon_of([(x, 0), (x + 4, 0), (x + 4, 4), (x, 4)], depth=lambda x, y: 2.0 + 0.1 * x))
    both.Update()
    places = vtk_to_numpy(both.GetOutput().GetPoints().GetData())
    places[:, 2] = places[:, 0] >= 10.0  # two levels
    add_array(both.GetOutput(), "kind", [0.0, 1.0], True)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(both.GetOutput())
    if of_points:
        mapper.SetScalarModeToUsePointFieldData()
    else:
        mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("WaterDepth" if of_points else "kind")
    mapper.SetLookupTable(table_of("viridis", (0.0, 1.0)))
    mapper.SetScalarRange((2.0, 3.4) if of_points else (0.0, 1.0))
    lakes = vtkWaterLakes()
    lakes.SetMapper(mapper)
    lakes.Update()
    surface = measure.surface(lakes)
    wt.check_equal("area", measure.flooded(surface), measure.flooded(lakes))
    wt.check_equal("area of the first actor's mesh", measure.flooded(lakes.GetWater().GetMapper().GetInput())[0], 16.0)
    wt.check_equal("values", measure.probe(surface, [(1, 1), (11, 1)])["WaterDepth"].round(9).tolist(), [2.1, 3.1])
    data = surface.GetPointData() if of_points else surface.GetCellData()
    wt.check_equal("active array", data.GetScalars().GetName(), "WaterDepth" if of_points else "kind")
    colors = vtk_to_numpy(data.GetArray("WaterColors"))
    ends = [0, -1] if not of_points else [int(np.argmin(vtk_to_numpy(data.GetScalars()))),
                                          int(np.argmax(vtk_to_numpy(data.GetScalars())))]
    wt.check_at_most("colours of both ends off by", float(np.abs(
        colors[ends] - np.array([(0x44, 0x01, 0x54), (0xFD, 0xE7, 0x25)], float)).max()), 2)
    names = [surface.GetFieldData().GetArrayName(i) for i in range(surface.GetFieldData().GetNumberOfArrays())]
    wt.check_equal("field data", names, [])
    wt.check_equal("the water keeps its arrays", both.GetOutput().GetPointData().GetArray("WaterColors"), None)
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(surface)
    writer.SetFileName(str(tmp_path / "lakes.vtp"))
    writer.Write()
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(tmp_path / "lakes.vtp"))
    reader.Update()
    wt.check_equal("area in the file", measure.flooded(reader.GetOutput())[0], 32.0)


def test_a_surface_of_one_lake_is_clean():
    """Without the field data of its plane, and without colours if no scalars show; other things are refused."""
    _, made, mesh = slope()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(made)
    mapper.ScalarVisibilityOff()
    lakes = vtkWaterLakes()
    lakes.SetMapper(mapper)
    lakes.Update()
    actor = lakes.GetWater()
    wt.check_equal("field data of a lake's mesh", actor.GetMapper().GetInput().GetFieldData().GetNumberOfArrays(), 5)
    for water in (actor, lakes, made, actor.GetMapper().GetInput()):
        surface = measure.surface(water)
        wt.check_equal("field data", surface.GetFieldData().GetNumberOfArrays(), 0)
        wt.check_equal("colours", surface.GetPointData().GetArray("WaterColors"), None)
        wt.check_equal("area and volume", measure.flooded(surface), measure.flooded(made))
    wt.check_equal("the lake's own field data", actor.GetMapper().GetInput().GetFieldData().GetNumberOfArrays(), 5)
    for water in (None, 3.0, mesh_of):
        with pytest.raises(TypeError, match="water must be a vtkWaterActor, vtkWaterLakes or vtkPolyData"):
            measure.surface(water)


def test_the_shoreline_is_where_the_bed_reaches_the_level():
    """On the slope one line, with nothing of the mesh's border; its length is that of the line on the map."""
    _, surface, mesh = slope()
    line = measure.shoreline(surface, mesh)
    wt.check_equal("lines", line.GetNumberOfLines(), 1)
    places = vtk_to_numpy(line.GetPoints().GetData())
    wt.check_at_most("off the shore by", float(np.abs(bed_at(places) - LEVEL).max()), 1e-6)
    ordered = places[vtk_to_numpy(line.GetLines().GetConnectivityArray())]
    length = float(np.linalg.norm(np.diff(ordered, axis=0), axis=1).sum())
    wt.check_at_most("length off by", abs(length - 2 * HALF * np.hypot(1.0, 1.0 / 3.0)), 1e-4)
    wt.check_equal("the depth comes along", line.GetPointData().HasArray("WaterDepth"), 1)


def test_a_dyke_has_a_shoreline_and_the_border_none():
    mesh = mesh_of()
    x = places_of(mesh, True)[:, 0]
    add_array(mesh, "h", np.where(x < 0, 1.0, 0.0), True)
    add_array(mesh, "zb", np.full(mesh.GetNumberOfPoints(), -1.0))
    _, surface, _ = surface_of(mesh, DepthArrayName="h", BedArrayName="zb")
    line = measure.shoreline(surface, mesh)
    places = vtk_to_numpy(line.GetPoints().GetData())
    wt.check_at_most("off the dyke by, of a cell", float(np.abs(places[:, 0]).max()), 1.0)
    wt.check_at_most("ends at the border, off by", 2 * HALF - float(np.ptp(places[:, 1])), 1e-6)
    full = surface_of(flooded(9.0), DepthArrayName="h", BedArrayName="zb")[1]
    wt.check_equal("of water all over the mesh", measure.shoreline(full, flooded(9.0)).GetNumberOfLines(), 0)


@pytest.mark.parametrize("scale", (1.0, 3.0))
def test_area_and_volume_are_those_of_the_slope(scale):
    _, surface, _ = slope(scale)
    area, volume = measure.flooded(surface)
    y = np.linspace(-HALF, HALF, 20001)
    low = 0.1 * y - 0.3 * HALF  # bed at x = -HALF, which is under water everywhere
    wide = np.clip((LEVEL - low) / 0.3, 0.0, 2 * HALF)
    wanted = float(np.trapezoid(wide * (LEVEL - low) - 0.15 * wide**2, y) if hasattr(np, "trapezoid") else
                   np.trapz(wide * (LEVEL - low) - 0.15 * wide**2, y))
    wt.check_at_most("area off by", abs(area - wet_area(LEVEL)), 1e-5)
    wt.check_at_most("volume off by, of it", abs(volume / wanted - 1.0), 1e-5)


def test_what_is_measured_is_the_water_of_now():
    """Also before the next picture: the level falls, and the area with it."""
    _, water, mesh = scene()
    bed = bed_at(places_of(mesh, False))
    add_array(mesh, "h", np.maximum(-0.6 - bed, 0.0))
    mesh.Modified()
    wt.check_at_most("area off by", abs(measure.flooded(water)[0] - wet_area(-0.6)), 1e-2)


def test_without_depths_there_is_no_volume():
    _, surface, _ = surface_of(flooded(LEVEL), LevelArrayName="zeta")
    area, volume = measure.flooded(surface)
    wt.check_at_most("area off by", abs(area - 4 * HALF**2), 1e-9)
    wt.check_equal("volume is NaN", np.isnan(volume), True)
    wt.check_equal("of nothing", measure.flooded(vtkPolyData()), (0.0, 0.0))


def strip_of(quads, heights=0.0):
    """Unit squares in a row along x, as polygons."""
    mesh = vtkPolyData()
    mesh.SetPoints(vtkPoints())
    for x in range(quads + 1):
        for y in (0, 1):
            mesh.GetPoints().InsertNextPoint(x, y, heights)
    mesh.SetPolys(vtkCellArray())
    for x in range(quads):
        mesh.GetPolys().InsertNextCell(4, (2 * x, 2 * x + 2, 2 * x + 3, 2 * x + 1))
    return mesh


def test_cells_have_one_depth():
    mesh = strip_of(4)
    add_array(mesh, "of cells", np.array((1.0, 0.5, np.nan, 2.0)), of_cells=True)
    wt.check_equal("area, volume", measure.flooded_cells(mesh, "of cells"), (3.0, 3.5))
    wt.check_equal("deeper than 0.5", measure.flooded_cells(mesh, "of cells", 0.5), (2.0, 3.0))
    add_array(mesh, "filled", np.array((1.0, 9.96921e36, 1e20, 2.0)), of_cells=True)
    wt.check_equal("without fill values", measure.flooded_cells(mesh, "filled"), (2.0, 3.0))


def test_the_cell_of_a_point_is_its_share_of_the_polygons_around_it():
    """A point at the corner of a square has a quarter of it; one between two, two quarters."""
    mesh = strip_of(4)
    depths = np.zeros(10)
    depths[[0, 4]] = 1.0, 3.0  # a corner, and a point between two squares
    add_array(mesh, "h", depths)
    wt.check_equal("area, volume", measure.flooded_cells(mesh, "h"), (0.75, 1.75))
    mesh.SetPolys(vtkCellArray())
    mesh.SetStrips(vtkCellArray())
    mesh.GetStrips().InsertNextCell(4, (0, 2, 1, 3))  # two triangles: the first point is a corner of one
    wt.check_at_most("of a strip, off by", float(np.abs(np.subtract(measure.flooded_cells(mesh, "h"), 1 / 6)).max()),
                     1e-12)


def half_hidden(kind):
    """6 x 2 unit cells with the depth 1, of points and of cells; the three columns on the right are hidden."""
    if kind == "image":
        mesh = vtkImageData()
    else:
        mesh, points = vtkStructuredGrid(), vtkPoints()
        y, x = np.mgrid[0:3, 0:7].astype(float)
        points.SetData(numpy_to_vtk(np.stack([x, y, 0.0 * x], axis=-1).reshape(-1, 3), deep=True))
        mesh.SetPoints(points)
    mesh.SetDimensions(7, 3, 1)
    add_array(mesh, "h", np.ones(21))
    add_array(mesh, "of cells", np.ones(12), of_cells=True)
    hide(mesh.GetCellData(), 12, [3, 4, 5, 9, 10, 11], vtkDataSetAttributes.HIDDENCELL)
    if kind == "polygons":
        outside = vtkDataSetSurfaceFilter()
        outside.SetInputData(mesh)
        outside.Update()
        return outside.GetOutput()
    return mesh


@pytest.mark.parametrize("kind, area", (("image", 6.0), ("rows", 6.0), ("polygons", 12.0)))
def test_hidden_cells_of_grids_are_not_measured(kind, area):
    """Those of vtkPolyData are, as they are drawn. Where cells are hidden the mesh ends: there is no shore."""
    mesh = half_hidden(kind)
    _, surface, _ = surface_of(mesh, DepthArrayName="h")
    wt.check_equal("of the water", measure.flooded(surface), (area, area))
    for name in ("h", "of cells"):
        wt.check_equal(f"by {name}", measure.flooded_cells(mesh, name), (area, area))
    wt.check_equal("lines of shores", measure.shoreline(surface, mesh).GetNumberOfLines(), 0)


def test_a_gauge_in_a_hidden_cell_is_dry(tmp_path):
    mesh = half_hidden("rows")
    path = tmp_path / "hidden.vts"
    writer = vtkXMLStructuredGridWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(mesh)
    writer.Write()
    found = measure.gauges(Solution(path, ["h"]), [(1.5, 0.5), (4.5, 0.5)], depth="h")
    wt.check_equal("depths", np.isfinite(found["WaterDepth"]).tolist(), [[True, False]])


def test_cells_of_a_sloping_lake_hold_its_water():
    """Where the mesh is fine the totals of both ways agree."""
    _, surface, mesh = slope()
    area, volume = measure.flooded_cells(mesh, "h")
    wanted = measure.flooded(surface)
    wt.check_at_most("area off by, of it", abs(area / wanted[0] - 1.0), 0.05)
    wt.check_at_most("volume off by, of it", abs(volume / wanted[1] - 1.0), 0.01)


@pytest.mark.parametrize("arguments, error, words", (
    ((3.0, "h"), TypeError, "mesh must be a vtkDataSet, not float"),
    ((strip_of(1), "h"), ValueError, "the mesh has no array 'h'; it has none"),
    ((strip_of(1), "h", -1.0), ValueError, "dry_depth is -1.0; it must be 0 or more, and finite")))
def test_totals_of_cells_that_there_are_not(arguments, error, words):
    with pytest.raises(error, match=words):
        measure.flooded_cells(*arguments)


@pytest.mark.parametrize("scale", (1.0, 3.0))
def test_a_profile_goes_along_its_line(scale):
    """From the land into the water: the depth grows evenly with the distance."""
    _, surface, _ = slope(scale)
    start, end = np.array((HALF, -3.0)), np.array((-HALF, 2.0))
    values = measure.profile(surface, start, end, 101)
    places = start + np.linspace(0, 1, 101)[:, None] * (end - start)
    depth = LEVEL - bed_at(places)
    wet = np.abs(depth) > 1e-6
    wt.check_equal("wet", np.isfinite(values["WaterDepth"])[wet].tolist(), (depth > 0)[wet].tolist())
    wt.check_at_most("depth off by", float(np.nanmax(np.abs(values["WaterDepth"] - depth))), 1e-6)
    wt.check_at_most("distance off by",
                     float(np.abs(values["distance"] - np.linalg.norm(places - start, axis=1)).max()), 1e-9)


@pytest.mark.parametrize("count", (1, 2.5, "two"))
def test_a_profile_has_two_places_or_more(count):
    with pytest.raises(ValueError, match=f"count is {count!r}; it must be a whole number, 2 or more"):
        measure.profile(vtkPolyData(), (0, 0), (1, 1), count)


def write_tide(folder, levels):
    """A file of the slope at each of these levels, an hour apart."""
    entries = []
    for i, level in enumerate(levels):
        mesh = flooded(level)
        add_array(mesh, "x", places_of(mesh, False)[:, 0])
        writer = vtkXMLPolyDataWriter()
        writer.SetInputData(mesh)
        writer.SetFileName(str(folder / f"{i}.vtp"))
        writer.Write()
        entries.append(f'<DataSet timestep="{3600 * i}" file="{i}.vtp"/>')
    path = folder / "tide.pvd"
    path.write_text(f'<VTKFile type="Collection"><Collection>{"".join(entries)}</Collection></VTKFile>')
    return path


def test_gauges_tell_every_array_over_time(tmp_path):
    """A gauge in the deep, one that falls dry, and one on land; at the file's times, and between them."""
    levels = (0.4, -0.6, 0.8)
    solution = Solution(write_tide(tmp_path, levels), ["h", "zb", "x"])
    places = np.array([(-4.0, 1.0), (0.0, -2.0), (4.5, 0.0)])
    values = measure.gauges(solution, places, depth="h", bed="zb", dry_depth=0.0)
    depth = np.array(levels)[:, None] - bed_at(places)
    wt.check_equal("times", values["time"].tolist(), [0.0, 3600.0, 7200.0])
    wt.check_equal("wet", np.isfinite(values["WaterDepth"]).tolist(), (depth > 0).tolist())
    wt.check_equal("of these are wet", (depth > 0).sum(axis=0).tolist(), [3, 2, 0])
    wt.check_at_most("depth off by", float(np.nanmax(np.abs(values["WaterDepth"] - depth))), 1e-6)
    wt.check_at_most("x off by", float(np.nanmax(np.abs(values["x"] - places[:, 0]))), 1e-6)
    between = measure.gauges(solution, places[:1], depth="h", bed="zb", times=[1800.0])
    wt.check_at_most("level half an hour later off by", abs(float(between["WaterLevel"][0, 0]) + 0.1), 1e-6)


def test_a_gauge_of_no_array_is_an_error(tmp_path):
    solution = Solution(write_tide(tmp_path, (0.4,)), ["h"])
    with pytest.raises(ValueError, match="there is no numeric array 'zb'.*h \\(points\\)"):
        measure.gauges(solution, [(0, 0)], depth="h", bed="zb")


@pytest.mark.parametrize("scale", (1.0, 3.0))
def test_a_pick_gives_the_point_and_its_values(scale):
    """As the guide has it: VTK's picker finds the place, and a probe tells what is there."""
    view, water, _ = scene(scale)
    picker = vtkCellPicker()
    picker.SetTolerance(1e-6)
    worst = 0.0
    for x, y in ((-4.0, -3.0), (-1.5, 2.0), (0.5, 0.5)):
        view.renderer.SetWorldPoint(x, y, scale * LEVEL, 1.0)
        view.renderer.WorldToDisplay()
        column, row, _ = view.renderer.GetDisplayPoint()
        wt.check_equal("picked", bool(picker.Pick(column, row, 0.0, view.renderer)), True)
        wt.check_equal("the water", picker.GetActor() is water, True)
        at = picker.GetPickPosition()
        values = measure.probe(water, [at])
        worst = max(worst, float(np.abs(np.array(at) - (x, y, scale * LEVEL)).max()), abs(values["x"][0] - x),
                    abs(values["WaterDepth"][0] - LEVEL + bed_at(np.array([(x, y)]))[0]))
    wt.check_at_most("place, and values, off by", worst, 1e-3)


def test_other_tools_get_the_geometry_with_its_colours(tmp_path):
    """VTP keeps all arrays, PLY and glTF the colours, STL the triangles."""
    view, water, _ = scene()
    surface = measure.surface(water)
    writers = {"vtp": vtkXMLPolyDataWriter(), "stl": vtkSTLWriter(), "ply": vtkPLYWriter()}
    writers["ply"].SetArrayName("WaterColors")
    for kind, writer in writers.items():
        writer.SetInputData(surface)
        writer.SetFileName(str(tmp_path / f"water.{kind}"))
        writer.Write()
    found = {}
    for kind, reader in (("vtp", vtkXMLPolyDataReader()), ("stl", vtkSTLReader()), ("ply", vtkPLYReader())):
        reader.SetFileName(str(tmp_path / f"water.{kind}"))
        reader.Update()
        found[kind] = reader.GetOutput()
        off = np.abs(np.array(found[kind].GetBounds()) - surface.GetBounds()).max()
        wt.check_at_most(f"{kind}: bounds off by", float(off), 1e-6)
    wt.check_equal("arrays", found["vtp"].GetPointData().GetNumberOfArrays(), surface.GetPointData().GetNumberOfArrays())
    table, x = water.GetMapper().GetLookupTable(), vtk_to_numpy(surface.GetPointData().GetArray("x"))
    colors = np.array([table.GetTableValue(table.GetIndex(value))[:3] for value in x]) * 255
    of_ply = vtk_to_numpy(found["ply"].GetPointData().GetScalars()).astype(int)
    wt.check_at_most("PLY: colours off by, of 255", float(np.abs(of_ply - colors).max()), 1)
    exporter = vtkGLTFExporter()
    exporter.SetRenderWindow(view.window)
    exporter.SetFileName(str(tmp_path / "water.gltf"))
    exporter.InlineDataOn()
    exporter.Write()
    content = json.loads((tmp_path / "water.gltf").read_text())
    meshes = content["meshes"]
    wt.check_equal("glTF: meshes, with colours", [set(mesh["primitives"][0]["attributes"]) >= {"POSITION", "COLOR_0"}
                                                  for mesh in meshes], [True])
    of_gltf = values_of(content, meshes[0]["primitives"][0]["attributes"]["COLOR_0"]).reshape(len(x), -1)[:, :3]
    wt.check_at_most("glTF: colours off by, of 255",
                     float(np.abs(of_gltf * (255 if of_gltf.max() <= 1 else 1) - colors).max()), 1)


def values_of(content, number):
    """The numbers of one of a glTF's accessors, whose buffers are in the text."""
    accessor = content["accessors"][number]
    view = content["bufferViews"][accessor["bufferView"]]
    data = base64.b64decode(content["buffers"][view["buffer"]]["uri"].partition("base64,")[2])
    kind = {5121: np.uint8, 5123: np.uint16, 5126: np.float32}[accessor["componentType"]]
    return np.frombuffer(data, kind, view["byteLength"] // np.dtype(kind).itemsize, view.get("byteOffset", 0)).astype(float)

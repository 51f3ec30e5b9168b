# SPDX-License-Identifier: BSD-3-Clause
"""Water of data can be measured: picks, probes, shorelines, areas, volumes; and other tools get its geometry."""

import json

import numpy as np
import pytest
import water_test as wt
from TestWaterSurfaceFilter import HALF, add_array, bed_at, flooded, mesh_of, places_of, surface_of, wet_area
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPointDataToCellData
from vtkmodules.vtkIOExport import vtkGLTFExporter
from vtkmodules.vtkIOGeometry import vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter
from vtkmodules.vtkRenderingCore import vtkCellPicker, vtkPolyDataMapper
from vtkwater import measure, vtkWaterActor
from vtkwater.data_scenes import table_of

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


@pytest.mark.parametrize("bad", ([1.0, 2.0, 3.0, 4.0], [(1.0, float("nan"))], [[[1.0, 2.0]]]))
def test_wrong_places_are_refused(bad):
    with pytest.raises(ValueError, match="n x 2 or n x 3 finite numbers"):
        measure.probe(slope()[1], bad)


def test_what_is_no_water_of_data_is_refused():
    with pytest.raises(TypeError, match="must be a vtkWaterActor or vtkPolyData, not float"):
        measure.flooded(3.0)


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
    surface = water.GetMapper().GetInput()
    writers = {"vtp": vtkXMLPolyDataWriter(), "stl": vtkSTLWriter(), "ply": vtkPLYWriter()}
    writers["ply"].SetArrayName("x")
    writers["ply"].SetLookupTable(water.GetMapper().GetLookupTable())
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
    wt.check_equal("colours", found["ply"].GetPointData().GetScalars().GetNumberOfComponents(), 3)
    exporter = vtkGLTFExporter()
    exporter.SetRenderWindow(view.window)
    exporter.SetFileName(str(tmp_path / "water.gltf"))
    exporter.InlineDataOn()
    exporter.Write()
    meshes = json.loads((tmp_path / "water.gltf").read_text())["meshes"]
    wt.check_equal("glTF: meshes, with colours", [set(mesh["primitives"][0]["attributes"]) >= {"POSITION", "COLOR_0"}
                                                  for mesh in meshes], [True])

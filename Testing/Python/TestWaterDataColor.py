# SPDX-License-Identifier: BSD-3-Clause
"""Scalars of a mesh colour the water, and can be read back from the picture."""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkFiltersCore import vtkPointDataToCellData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkDataSetMapper, vtkPolyDataMapper
from vtkwater import vtkWaterProperty

SIZE = (320, 240)
HALF, HEIGHT = 10.0, 20.0  # the mesh covers [-10, 10] x [-10, 10]; of the eye
STEPS = 64  # of the lookup table


def table_of(steps=STEPS):
    """Red grows and green falls from step to step, so that a pixel tells its step."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(steps)
    for i in range(steps):
        table.SetTableValue(i, i / (steps - 1), 1 - i / (steps - 1), 0.5, 1)
    table.SetRange(-HALF, HALF)
    return table


def mesh_of(values, of_cells=False):
    source = vtkPlaneSource()
    source.SetOrigin(-HALF, -HALF, 0)
    source.SetPoint1(HALF, -HALF, 0)
    source.SetPoint2(-HALF, HALF, 0)
    source.SetResolution(40, 40)
    source.Update()
    mesh = source.GetOutput()
    x, y, _ = vtk_to_numpy(mesh.GetPoints().GetData()).T
    array = numpy_to_vtk(np.asarray(values(x, y), dtype=float), deep=True)
    array.SetName("c")
    mesh.GetPointData().SetScalars(array)
    if of_cells:
        convert = vtkPointDataToCellData()
        convert.SetInputData(mesh)
        convert.Update()
        mesh = convert.GetOutput()
    return mesh


def water_of(mesh, kind=vtkPolyDataMapper, samples=0, table=None, before=False):
    """Water of the mesh, seen from straight above, whose optics are off."""
    view = wt.View(SIZE, (0, 0, 0), samples=samples)
    water = wt.add_water(view.renderer, None, None, 0.0)
    water.GetWaterProperty().GlitterOff()
    mapper = kind()
    mapper.SetInputData(mesh)
    mapper.SetLookupTable(table or table_of())
    mapper.SetUseLookupTableScalarRange(True)
    mapper.SetInterpolateScalarsBeforeMapping(before)
    water.SetMapper(mapper)
    camera = wt.place_camera(view.renderer, (0, 0, HEIGHT), (0, 0, 0), (1, 100), (0, 1, 0))
    camera.SetViewAngle(40)
    return view, water


def x_of_columns():
    return (np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2) * 2 * HEIGHT * np.tan(np.radians(20)) / SIZE[1]


def steps_of(picture):
    return picture[:, :, 0] / 255 * (STEPS - 1)


@pytest.mark.parametrize("kind", (vtkPolyDataMapper, vtkDataSetMapper))
@pytest.mark.parametrize("samples", (0, 4))
@pytest.mark.parametrize("before", (False, True))
def test_a_pixel_tells_its_value(kind, samples, before):
    """Of points: what is read back is within a step of the table, at every pixel of the water."""
    view, _ = water_of(mesh_of(lambda x, y: x), kind, samples, before=before)
    steps = steps_of(view.picture())
    values = -HALF + (steps + 0.5) / STEPS * 2 * HALF
    x = x_of_columns()
    inside = np.abs(x) < HALF - 0.2
    wt.check_at_most("worst value read back, steps",
                     float(np.abs(values - x)[:, inside].max() / (2 * HALF / STEPS)), 1.0)


def test_the_actors_light_changes_no_data():
    view, water = water_of(mesh_of(lambda x, y: x))
    plain = view.picture().astype(int)
    water.GetProperty().SetAmbient(0.5)
    water.GetProperty().SetDiffuse(0.25)
    inside = np.abs(x_of_columns()) < HALF - 0.2
    wt.check_at_most("off by, of 255", int(np.abs(view.picture() - plain)[:, inside].max()), 1)


def test_cells_have_one_colour_each():
    view, _ = water_of(mesh_of(lambda x, y: x, of_cells=True))
    picture = view.picture()
    x = x_of_columns()
    inside = np.abs(x) < HALF - 0.6
    cell = np.floor((x + HALF) / 0.5)
    middle = np.abs((x + HALF) / 0.5 - cell - 0.5) < 0.3
    wanted = np.floor((-HALF + (cell + 0.5) * 0.5 + HALF) / (2 * HALF) * STEPS)
    off = np.abs(steps_of(picture)[SIZE[1] // 2] - wanted)[inside & middle]
    wt.check_at_most("worst step of a cell", float(off.max()), 0.51)


def test_values_that_are_none_have_their_colour():
    table = table_of()
    table.SetNanColor(0, 0, 1, 1)
    view, _ = water_of(mesh_of(lambda x, y: np.where(x > 0, np.nan, x)), table=table)
    wt.check_equal("colour where there is no number", view.picture()[120, 240].tolist(), [0, 0, 255])


def test_categories_have_their_colours():
    table = vtkLookupTable()
    table.SetNumberOfTableValues(3)
    table.IndexedLookupOn()
    for i, color in enumerate(((1, 0, 0), (0, 1, 0), (0, 0, 1))):
        table.SetTableValue(i, *color, 1)
        table.SetAnnotation(i, "abc"[i])
    view, _ = water_of(mesh_of(lambda x, y: np.where(x < -3, 0.0, np.where(x < 3, 1.0, 2.0)), True), table=table)
    row = view.picture()[120]
    wt.check_equal("colours", [row[i].tolist() for i in (60, 160, 260)], [[255, 0, 0], [0, 255, 0], [0, 0, 255]])


def test_water_reflects_over_its_data():
    """What is reflected comes on top: (1 - R) of the data's colour, and R of the scene's."""
    view, water = water_of(mesh_of(lambda x, y: x))
    plain = view.picture().astype(float)
    view.renderer.SetBackground(1, 1, 1)
    water.GetWaterProperty().SetReflectance(0.25)
    shown = view.picture().astype(float)
    inside = np.abs(x_of_columns()) < HALF - 0.2
    wt.check_at_most("off by, of 255", float(np.abs(shown - 0.75 * plain - 0.25 * 255)[:, inside].max()), 1.0)


@pytest.mark.parametrize("share", (0.0, 0.25, 1.0))
def test_data_are_blended_with_the_water(share):
    view, water = water_of(mesh_of(lambda x, y: x))
    look = water.GetWaterProperty()
    look.SetDeepColor(0.2, 0.4, 0.6)
    full = view.picture().astype(float)
    look.SetDataOpacity(share)
    shown = view.picture().astype(float)
    wanted = share * full + (1 - share) * 255 * np.array((0.2, 0.4, 0.6))
    inside = np.abs(x_of_columns()) < HALF - 0.2
    wt.check_at_most("off by, of 255", float(np.abs(shown - wanted)[:, inside].max()), 1.0)


def test_data_hide_the_bed_as_far_as_they_are_opaque():
    view, water = water_of(mesh_of(lambda x, y: x))
    wt.add_actor(view.renderer, wt.box((0, 0, -0.6), (40, 40, 1)), (1, 1, 1), lit=False)
    hidden = view.picture().astype(int)
    water.GetWaterProperty().RefractionOn()
    wt.check_at_most("with refraction off by", int(np.abs(hidden - view.picture()).max()), 1)
    water.GetWaterProperty().SetDataOpacity(0.5)
    wt.check_at_least("half of it: brighter by", float((view.picture().astype(int) - hidden)[:, 100:220].mean()), 30)


def test_scalars_can_be_switched_off_and_on():
    """Without them the water has its own colour; the shader follows."""
    view, water = water_of(mesh_of(lambda x, y: x))
    water.GetWaterProperty().SetDeepColor(0.2, 0.4, 0.6)
    on = view.picture()
    water.GetMapper().ScalarVisibilityOff()
    off = view.picture()
    water.GetMapper().ScalarVisibilityOn()
    wt.check_equal("colour without", off[120, 160].tolist(), [51, 102, 153])
    wt.check_equal("pixels that differ from before", int((on != view.picture()).sum()), 0)


@pytest.mark.parametrize("value", (-0.1, 1.5, float("nan")))
def test_a_bad_share_is_refused(value):
    look = vtkWaterProperty()
    said = wt.errors_of(look)
    look.SetDataOpacity(value)
    wt.check_equal("errors", len(said), 1)
    wt.check_equal("it names the range", "[0, 1]" in said[0], True)
    wt.check_equal("it stays", look.GetDataOpacity(), 1.0)


@pytest.mark.parametrize("kind", (vtkPolyDataMapper, vtkDataSetMapper))
@pytest.mark.parametrize("before", (False, True))
def test_the_opacity_of_a_tables_colour_blends_it(kind, before):
    """Where it is 0 the water shows, where it is 0.5 both do; and the water stays opaque."""
    table = table_of(3)
    for i, (color, opacity) in enumerate((((1, 0, 0), 1), ((1, 0, 0), 0.5), ((1, 0, 0), 0))):
        table.SetTableValue(i, *color, opacity)
    view, water = water_of(mesh_of(lambda x, y: x), kind, table=table, before=before)
    wt.add_actor(view.renderer, wt.box((0, 0, -5), (30, 30, 1)), (1, 1, 1))  # it must not shine through
    water.GetWaterProperty().SetDeepColor(0.0, 0.0, 0.8)
    row = view.picture()[SIZE[1] // 2].astype(int)
    x = x_of_columns()
    for name, low, high, wanted in (("1", -9, -4, (255, 0, 0)), ("0.5", -2, 2, (128, 0, 102)), ("0", 4, 9, (0, 0, 204))):
        seen = row[(x > low) & (x < high)]
        wt.check_at_least(f"opacity {name}: pixels", len(seen), 20)
        wt.check_at_most(f"opacity {name}: off by, of 255", int(np.abs(seen - wanted).max()), 2)
    wt.check_at_most("is in the translucent pass", int(water.HasTranslucentPolygonalGeometry()), 0)

# SPDX-License-Identifier: BSD-3-Clause
"""Water keeps its picture wherever a user puts it: as the user's mesh, under a pass composed by hand, after
a new size, a release or a move to another window, and in two windows. From below it mirrors what is below,
and the debug corner changes nothing but itself.
"""

import gc

import numpy as np
import pytest
import water_test as wt
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass
from vtkwater import vtkWaterReflectionPass

SIZE = (320, 240)
LEVEL = ((0, 0, 0), (0, 0, 1))
SHEET = (-9, 9, -6, 9)


def place_camera(renderer, position):
    camera = renderer.GetActiveCamera()
    camera.SetPosition(position)
    camera.SetViewUp(0, 0, 1)
    camera.SetClippingRange(1, 60)


def build(reflectance=1.0):
    view = wt.View(SIZE)
    for data, color in wt.columns_and_pyramids():
        wt.add_actor(view.renderer, data, color)
    wt.add_scene_light(view.renderer, (3, -5, 8))
    water = wt.add_water(view.renderer, wt.plane(*LEVEL), SHEET, reflectance)
    place_camera(view.renderer, (2, -13, 4))
    return view, water


@pytest.fixture(scope="module")
def reference():
    """The scene's picture."""
    view, _ = build()
    return view.picture()


def lake_with_an_island():
    """A flat mesh in the water's plane: the sheet's rectangle with a hole."""
    corners = [(-9, -6), (9, -6), (9, 9), (-9, 9), (-2, -5), (2, -5), (2, -3), (-2, -3)]
    points = vtkPoints()
    for x, y in corners:
        points.InsertNextPoint(x, y, 0)
    cells = vtkCellArray()
    for quad in ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)):
        cells.InsertNextCell(4)
        for corner in quad:
            cells.InsertCellPoint(corner)
    lake = vtkPolyData()
    lake.SetPoints(points)
    lake.SetPolys(cells)
    return lake


def test_a_mesh_shows_what_the_own_sheet_shows(reference):
    """A flat mesh of the user's in the plane shows what the own sheet shows there, and has its hole."""
    view, water = build()
    view.picture()
    mask = wt.water_mask(view, water)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(lake_with_an_island())
    water.SetMapper(mapper)
    mesh = view.picture()
    mesh_mask = wt.water_mask(view, water)
    wt.check_at_least("mesh with an island: pixels of the hole", int((mask & ~mesh_mask).sum()), 300)
    off = float((np.abs(mesh - reference).max(axis=2) > 1)[mesh_mask].mean() * 100)
    wt.check_at_most("mesh with an island: % of its pixels off", off, 0.02)
    water.SetMapper(None)
    wt.check_equal("own sheet again: largest error", wt.difference(view.picture(), reference), 0)


@pytest.mark.parametrize("name, make_delegate", [
    ("default delegate", lambda: None), ("render steps", vtkRenderStepsPass),
], ids=["default_delegate", "render_steps"])
def test_a_pass_composed_by_hand_gives_the_same_picture(name, make_delegate, reference):
    """Composed by hand, the pass is in charge and gives the same picture; taken out again, the own one does."""
    view, water = build()
    by_hand = vtkWaterReflectionPass()
    by_hand.SetDelegatePass(make_delegate())
    view.renderer.SetPass(by_hand)
    picture = view.picture()
    wt.check_equal(f"pass composed by hand, {name}: in charge", water.GetReflectionPass() is by_hand, True)
    wt.check_equal(f"pass composed by hand, {name}: renders", by_hand.GetNumberOfReflectionRenders(), 1)
    wt.check_equal(f"pass composed by hand, {name}: largest error", wt.difference(picture, reference), 0)
    view.renderer.SetPass(None)
    wt.check_equal(f"taken out again, {name}: largest error", wt.difference(view.picture(), reference), 0)
    wt.check_equal(f"taken out again, {name}: own pass", water.GetReflectionPass() is by_hand, False)


def test_from_below_it_mirrors_what_is_below():
    """From below, the underside shows the mirror image of what is below, whole where reflection is total."""
    view, water = build(reflectance=None)
    view.renderer.GetActiveCamera().SetPosition(2, -13, -2)
    view.renderer.RemoveAllLights()
    wt.add_scene_light(view.renderer, (3, -5, -8))
    seen = view.picture()
    mask = wt.water_mask(view, water)
    mirror = wt.View(SIZE)
    for data, color in wt.columns_and_pyramids():
        wt.add_actor(mirror.renderer, wt.mirror_image(data, (0, 0, 0), (0, 0, -1)), color)
    wt.add_scene_light(mirror.renderer, (3, -5, 8))
    place_camera(mirror.renderer, (2, -13, -2))
    off = float((np.abs(seen - mirror.picture()).max(axis=2) > 1)[mask].mean() * 100)
    wt.check_at_least("from below: water pixels", int(mask.sum()), 3000)
    wt.check_at_most("from below, total reflection: % of water pixels off", off, 0.02)


def test_a_window_may_be_resized(reference):
    """Resized and back, the window has the same picture."""
    view, _ = build()
    view.picture()
    view.window.SetSize(200, 300)
    view.picture()
    view.window.SetSize(*SIZE)
    wt.check_equal("resized and back: largest error", wt.difference(view.picture(), reference), 0)


def test_a_window_may_be_released(reference):
    """Released and rendered again, the window has the same picture."""
    view, _ = build()
    view.picture()
    view.window.Finalize()
    wt.check_equal("released and rendered again: largest error", wt.difference(view.picture(), reference), 0)


def test_a_renderer_may_move_to_another_window(reference):
    """A renderer that has moved to another window has the same picture there."""
    view, _ = build()
    view.picture()
    other = wt.View(SIZE)
    other.window.RemoveRenderer(other.renderer)
    view.window.RemoveRenderer(view.renderer)
    other.window.AddRenderer(view.renderer)
    other.renderer = view.renderer
    wt.check_equal("in another window: largest error", wt.difference(other.picture(), reference), 0)


def test_two_windows_may_share_look_and_plane(reference):
    """Two windows in turn, whose waters share their look and plane, have the same picture, also when one is gone."""
    # VTK itself draws no prop rightly in two windows of separate contexts (9.6, without any water): each
    # window has its own water here, and both of them the one look and plane.
    first, shared = build()
    second, twin = build()
    twin.SetWaterProperty(shared.GetWaterProperty())
    twin.SetPlane(shared.GetPlane())
    for turn in range(2):
        wt.check_equal(f"two windows in turn, first, turn {turn}: largest error",
                       wt.difference(first.picture(), reference), 0)
        wt.check_equal(f"two windows in turn, second, turn {turn}: largest error",
                       wt.difference(second.picture(), reference), 0)
    del twin
    del second
    gc.collect()
    wt.check_equal("after the second window is gone: largest error", wt.difference(first.picture(), reference), 0)


def test_the_debug_corner_shows_the_map(reference):
    """The debug corner shows the reflection texture, turned back, in the lower left quarter and nowhere else."""
    view, water = build()
    mask = wt.water_mask(view, water)
    water.GetReflectionPass().ShowReflectionOn()
    corner = view.picture()
    wt.check_equal("debug corner: the rest, largest error", wt.difference(corner[120:], reference[120:]), 0)
    wt.check_equal("debug corner: right half, largest error", wt.difference(corner[:, 160:], reference[:, 160:]), 0)
    # each pixel of the corner is the reflection texture at twice its place, where the water looks it up
    shown = corner[:120, :160][2:-2, 2:-2]
    expected = reference[::2, ::2][2:-2, 2:-2]
    inside = mask[::2, ::2][2:-2, 2:-2]
    close = float((np.abs(shown - expected).max(axis=2) < 40)[inside].mean())
    wt.check_at_least("debug corner: share of the water's pixels that show its reflection", close, 0.9)

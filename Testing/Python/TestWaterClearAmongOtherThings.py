# SPDX-License-Identifier: BSD-3-Clause
"""Clear water stays right beside what else a scene may have: later actors, opacity, more sheets, passes with
several buffers, a transparent background, a shore."""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkwater import vtkWaterActor

SIZE = (200, 150)
SHEET = (-40, 40, -40, 40)
UNDER = {"eye": (3, -8, -1.2), "target": (0, 0, -1)}


def scene(eye=(3, -8, 4), target=(0, 0, 0)):
    """Clear water over a bed, with a pole that stands in it."""
    made = wt.View(SIZE, (0.5, 0.7, 0.9))
    water = wt.add_water(made.renderer, None, SHEET, None)
    water.GetWaterProperty().RefractionOn()
    water.GetWaterProperty().SetAbsorption(0.3, 0.1, 0.05)
    water.GetWaterProperty().SetScattering(0, 0, 0)
    # added after the water: it must be seen through it all the same
    wt.add_actor(made.renderer, wt.box((0, 0, -3), (40, 40, 1)), (0.8, 0.7, 0.5), lit=False)
    wt.add_actor(made.renderer, wt.box((0, 0, -0.5), (1, 1, 4)), (0.9, 0.2, 0.1), lit=False)
    wt.place_camera(made.renderer, eye, target, (0.1, 200))
    return made, water


def test_the_order_of_adding_does_not_matter():
    """Water that is added last gives the picture of water that was added first."""
    made, water = scene()
    before = made.picture()
    made.renderer.RemoveActor(water)
    made.renderer.AddActor(water)
    wt.check_equal("water added last: difference", wt.difference(made.picture(), before), 0)


@pytest.mark.parametrize("peeling", (False, True), ids=("blended", "peeled"))
@pytest.mark.parametrize("name, place", (("above", {}), ("under water", UNDER)), ids=("above", "under_water"))
def test_opacity_of_either_property_is_the_same(name, place, peeling):
    """An actor that is made translucent by its own vtkProperty is plain alpha blending, as by the water's."""
    pictures = []
    for by_actor in (False, True):
        made, water = scene(**place)
        made.renderer.SetUseDepthPeeling(peeling)
        (water.GetProperty() if by_actor else water.GetWaterProperty()).SetOpacity(0.5)
        pictures.append(made.picture())
    wt.check_at_most(f"opacity by either property, {name}, peeling {peeling}: difference", wt.difference(*pictures), 1)


@pytest.mark.parametrize("name, sheets", (("two sheets of one water", ((-40, 0, -40, 40), (0, 40, -40, 40))),
                                          ("twice the same sheet", (SHEET, SHEET))), ids=("side_by_side", "the_same"))
def test_water_over_an_eye_is_there_once(name, sheets):
    """Between an eye under two sheets and the scene there is the water of one."""
    made, water = scene(**UNDER)
    once = made.picture()
    other = vtkWaterActor()
    other.SetWaterProperty(water.GetWaterProperty())
    for actor, bounds in zip((water, other), sheets):
        actor.SetSheetBounds(bounds)
    made.renderer.AddActor(other)
    wt.check_at_most(f"{name}: % of the pixels under it that differ",
                     100 * float((np.abs(made.picture() - once).max(axis=2) > 1)[:60].mean()), 0.5)


@pytest.mark.parametrize("name, prepare", (("plain", lambda renderer: None),
                                           ("SSAO", lambda renderer: renderer.UseSSAOOn()),
                                           ("FXAA", lambda renderer: renderer.UseFXAAOn())),
                         ids=("plain", "ssao", "fxaa"))
def test_fog_of_perfectly_clear_water_changes_nothing(name, prepare):
    """Fog through perfectly clear water changes nothing, whatever else is being drawn into."""
    pictures = []
    for sheet in (SHEET, (-40, -30, -40, -30)):  # the eye is in it, or not
        made, water = scene(**UNDER)
        water.GetWaterProperty().SetAbsorption(0, 0, 0)
        water.SetSheetBounds(*sheet)
        prepare(made.renderer)
        pictures.append(made.picture())
    wt.check_at_most(f"fog of nothing, {name}: largest difference under the horizon",
                     int(np.abs(pictures[0] - pictures[1])[:40].max()), 1)


def alpha_of(made):
    made.picture()
    pixels = vtkUnsignedCharArray()
    made.window.GetRGBACharPixelData(0, 0, SIZE[0] - 1, SIZE[1] - 1, 0, pixels)
    return vtk_to_numpy(pixels).reshape(SIZE[1], SIZE[0], 4)[:, :, 3]


def test_a_transparent_background_stays_transparent():
    """Beside the surface a background of no opacity keeps none."""
    made, water = scene(eye=(3, -8, -1.2), target=(0, 60, 20))
    water.SetSheetBounds(-40, 40, -40, -5)  # over the eye, and not over what it sees behind
    made.window.SetAlphaBitPlanes(True)
    made.renderer.SetBackgroundAlpha(0.0)
    alpha = alpha_of(made)
    water.VisibilityOff()
    is_open = alpha_of(made) == 0
    is_open[90:] = False  # the surface is there
    wt.check_at_least("transparent background: pixels beside the surface", int(is_open.sum()), 10000)
    wt.check_equal("transparent background: opaque pixels beside the surface", int((alpha[is_open] > 0).sum()), 0)


def test_a_soft_shore_reflects_with_the_depth():
    """At a soft shore the reflectance grows from nothing, with the depth of the water, to what it is."""
    made = wt.View(SIZE, (0, 0, 0))
    bed = wt.box((0, 0, -0.5), (40, 40, 1))
    points = bed.GetPoints()
    for i in range(points.GetNumberOfPoints()):  # dry from x = 0 on, 0.1 m deeper every metre to the left
        px, py, pz = points.GetPoint(i)
        points.SetPoint(i, px, py, pz + 0.1 * px)
    wt.add_actor(made.renderer, bed, (0.5, 0.5, 0.5), lit=False)
    water = wt.add_water(made.renderer, None, SHEET, 1.0)
    look = water.GetWaterProperty()
    look.RefractionOn()
    look.SetShoreSoftness(0.2)  # full from x = -2 on
    look.SetOutputToReflectance()
    camera = wt.place_camera(made.renderer, (-1, 0, 20), (-1, 0, 0), (1, 40), view_up=(0, 1, 0))
    camera.ParallelProjectionOn()
    camera.SetParallelScale(3)
    row = made.picture()[75]
    x = -1 + (np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2) * 6 / SIZE[1]
    shown = (256 * row[:, 0] + row[:, 1]) / 65535
    is_water = x < -0.05
    wt.check_at_most("soft shore: error of the reflectance",
                     float(np.abs(shown - np.clip(-0.1 * x / 0.2, 0, 1))[is_water].max()), 0.01)

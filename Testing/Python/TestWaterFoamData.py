# SPDX-License-Identifier: BSD-3-Clause
"""Foam lies where data say so, and covers as much of the picture as they say; without data nothing changes."""

import numpy as np
import pytest
import water_test as wt
from data_waters import SIZE, Scene, mesh_of
from vtkwater import vtkWaterActor

RENDERERS = pytest.mark.parametrize("is_software", (1, 0), ids=("software", "hardware"))


def foamy(values_at, measure="Cover", half=5.0, name="air", of_cells=False, components=1, used=True):
    """White foam on black water over a black bed, seen from straight above; the picture is 2 half high."""
    scene = Scene(mesh_of("air", values_at, 60.0, of_cells=of_cells, components=components), bed=(0, 0, 0))
    scene.look.SetDeepColor(0, 0, 0)
    scene.look.SetFoamColor(1, 1, 1)
    wt.add_scene_light(scene.view.renderer, (0, 0, 1))
    if used:
        scene.water.SetFoamArrayName(name)
        getattr(scene.water, f"SetFoamMeasureTo{measure}")()
    scene.look_from((0, 0, 30), parallel=half)
    return scene


def cover_of(scene, times=(0.0, 3.0, 6.0, 9.0)):
    """Mean share of the picture that is foam."""
    means = []
    for time in times:
        scene.water.SetTime(time)
        means.append(scene.picture()[:, :, 0].mean() / 255)
    return float(np.mean(means))


@pytest.mark.parametrize("share, half, is_software", (
    (0.1, 3.0, 1), (0.3, 3.0, 1), (0.5, 3.0, 1), (0.7, 3.0, 1), (0.9, 3.0, 1), (1.0, 3.0, 1), (0.2, 36.0, 1),
    (0.6, 36.0, 1), (0.5, 3.0, 0), (0.5, 36.0, 0)))
def test_the_picture_is_covered_as_the_data_say(share, half, is_software, monkeypatch):
    """The mean of the picture is the array's, as a lace from near and as a tint from far."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    scene = foamy(lambda x, y: share + 0 * x, half=half)
    found = cover_of(scene)
    wt.save(scene.picture(), wt.output_folder() / f"foam_data_{share:g}_{half:g}.png")
    wt.check_at_most(f"cover {found:.3f}, off {share}", abs(found - share), 0.05)
    wt.check_equal("told", scene.errors + scene.warnings, [])


def test_a_plume_has_the_arrays_mean():
    """Foam that varies over the picture covers as much of it as the array's mean over what is seen."""
    half = 9.0
    scene = foamy(lambda x, y: np.exp(-(x**2 + y**2) / 60), half=half)
    wide = half * SIZE[0] / SIZE[1]
    x, y = np.meshgrid(np.linspace(-wide, wide, 200), np.linspace(-half, half, 200))
    wanted = np.exp(-(x**2 + y**2) / 60).mean()
    picture = scene.picture()[:, :, 0] / 255
    wt.check_at_most("cover, off the mean", abs(cover_of(scene) - wanted), 0.05)
    wt.check_at_least("the middle over the border", picture[50:70, 70:90].mean() - picture[:, :10].mean(), 0.7)


@pytest.mark.parametrize("measure, value, share, of_cells", (
    ("FroudeNumber", 0.95, 0.0, False), ("FroudeNumber", 1.0, 0.0, True), ("FroudeNumber", 1.35, 0.5, False),
    ("FroudeNumber", 1.35, 0.5, True), ("FroudeNumber", 3.0, 1.0, True), ("BreakingIndex", 0.77, 0.0, False),
    ("BreakingIndex", 0.955, 0.5, False), ("BreakingIndex", 1.2, 1.0, False)))
def test_a_measure_has_its_foam(measure, value, share, of_cells):
    """None below the value at which a flow outruns its waves or waves break, all of it where they surely do."""
    scene = foamy(lambda x, y: value + 0 * x, measure, of_cells=of_cells)
    wt.check_at_most(f"{measure} {value}: cover, off {share}", abs(cover_of(scene) - share), 0.05 if share else 0.0)


def test_the_border_of_foam_lies_between_the_vertices():
    """A Froude number that rises from 0.95 to 1.05 within a cell: foam begins where it is 1, not at a vertex."""
    scene = foamy(lambda x, y: 1.0 + 0.5 * (x - 0.5), "FroudeNumber", half=2.0)
    column = scene.picture()[:, :, 0].max(axis=0)
    x = (np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2) * 4.0 / SIZE[1]
    first = x[np.flatnonzero(column > 2)[0]]
    wt.check_equal("foam before that", int(column[x < 0.48].max()), 0)
    wt.check_at_most("begins that much later, m", float(first - 0.5), 0.12)


@RENDERERS
def test_no_foam_is_as_without_data(is_software, monkeypatch):
    """Covers of 0 leave every byte, with other foam and without."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    for depth in (0.0, 3.0):
        pictures = []
        for used in (False, True):
            scene = foamy(lambda x, y: 0 * x, used=used)
            scene.look.SetFoamDepth(depth)
            pictures.append(scene.picture())
        wt.check_equal(f"foam of {depth} m: pixels that differ", int((pictures[0] != pictures[1]).sum()), 0)
        wt.check_equal("there is foam", bool(pictures[0].max() > 100), depth > 0)


def test_the_larger_cover_counts():
    """Foam of data is not laid over the shore's, nor less than it."""
    both = foamy(lambda x, y: np.where(x < 0, 1.0, 0.0))
    both.look.SetFoamDepth(3.0)
    shore = foamy(lambda x, y: 0 * x, used=False)
    shore.look.SetFoamDepth(3.0)
    one, other = both.picture(), shore.picture()
    wt.check_equal("where data have none: pixels that differ", int((one[:, 90:] != other[:, 90:]).sum()), 0)
    wt.check_at_least("where data have all: darkest pixel", int(one[:, :40, 0].min()), 240)


def test_foam_moves_with_the_time_alone():
    scene = foamy(lambda x, y: 0.5 + 0 * x)
    first = scene.picture()
    scene.water.SetTime(3.0)
    wt.check_at_least("3 s later: share of pixels that differ",
                      float((np.abs(scene.picture() - first)[:, :, 0] > 20).mean()), 0.1)
    scene.water.SetTime(0.0)
    wt.check_equal("back: pixels that differ", int((scene.picture() != first).sum()), 0)


def test_wrong_values_are_told_once():
    """A cover over 1 counts as 1; what is negative or no number counts as 0."""
    wrong = foamy(lambda x, y: np.where(x < -2, np.nan, np.where(x > 2, 1.5, np.where(y > 0, -0.2, 0.5))))
    right = foamy(lambda x, y: np.where(x < -2, 0.0, np.where(x > 2, 1.0, np.where(y > 0, 0.0, 0.5))))
    wt.check_equal("pixels that differ", int((wrong.picture() != right.picture()).sum()), 0)
    wrong.water.SetTime(1.0)
    wrong.picture()
    wt.check_equal("told", (len(wrong.warnings), len(wrong.errors), len(right.warnings)), (1, 0, 0))
    for words in ("FoamArrayName", "'air'", "covers of foam", "nan at point 0", "[0, 1]", "as 1"):
        wt.check(f"'{words}' is told", words in wrong.warnings[0], True, words in wrong.warnings[0])
    froude = foamy(lambda x, y: -2 + 0 * x, "FroudeNumber")
    wt.check_equal("negative Froude numbers: brightest pixel", int(froude.picture().max()), 0)
    wt.check("told", "Froude numbers", "in it", "Froude numbers" in froude.warnings[0])


@pytest.mark.parametrize("name, components, words", (
    ("foam", 1, ("no numeric array 'foam'", "air", "no foam from data")),
    ("air", 2, ("2 components", "covers of foam must have 1"))), ids=("missing", "components"))
def test_a_wrong_array_is_an_error_once(name, components, words):
    scene = foamy(lambda x, y: 1 + 0 * x, name=name, components=components)
    for time in (0.0, 1.0):
        scene.water.SetTime(time)
        wt.check_equal("brightest pixel", int(scene.picture().max()), 0)
    wt.check_equal("errors", len(scene.errors), 1)
    wt.check_equal("the last error", scene.water.GetLastError() in scene.errors[0], True)
    for word in words:
        wt.check(f"'{word}' is in the error", word in scene.errors[0], True, word in scene.errors[0])


def test_shadows_fall_on_it():
    """A box over the water keeps the sun off a part of the foam."""
    scene = foamy(lambda x, y: 1 + 0 * x)
    scene.look.ShadowsOn()
    plain = scene.picture()
    scene.view.renderer.RemoveAllLights()
    wt.add_scene_light(scene.view.renderer, (1, 0, 1))
    wt.add_actor(scene.view.renderer, wt.box((3, 0, 1.5), (1, 2, 3)), (0.2, 0.2, 0.2), lit=False)
    shaded = scene.picture()
    wt.save(shaded, wt.output_folder() / "foam_data_shadow.png")
    wt.check_at_least("darkest foam before", int(plain.min()), 200)
    wt.check_at_least("pixels in the shadow", int((shaded[:, :80, 0] < 140).sum()), 60)


def test_settings_are_checked_copied_and_printed():
    water = vtkWaterActor()
    errors = wt.errors_of(water)
    for wrong in (-1, 3):
        water.SetFoamMeasure(wrong)
    wt.check_equal("errors", (len(errors), water.GetFoamMeasure()), (2, water.COVER))
    names = []
    for measure in (water.COVER, water.FROUDE_NUMBER, water.BREAKING_INDEX):
        water.SetFoamMeasure(measure)
        names.append(water.GetFoamMeasureAsString())
    wt.check_equal("names", names, ["COVER", "FROUDE_NUMBER", "BREAKING_INDEX"])
    water.SetFoamArrayName("fr")
    copied = vtkWaterActor()
    copied.ShallowCopy(water)
    wt.check_equal("copied", (copied.GetFoamArrayName(), copied.GetFoamMeasure()), ("fr", water.BREAKING_INDEX))
    for words in ("FoamArrayName: fr", "FoamMeasure: BREAKING_INDEX"):
        wt.check(f"'{words}' is printed", words in str(water), True, words in str(water))

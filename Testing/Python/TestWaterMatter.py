# SPDX-License-Identifier: BSD-3-Clause
"""Matter that the water carries takes light along the refracted ray as Beer's law has it, colours deep water as a medium
of both, and where there is none changes nothing."""

import numpy as np
import pytest
import ray_caster
import water_test as wt
from data_waters import SIZE, Scene, mesh_of
from vtkmodules.vtkRenderingCore import vtkDataSetMapper, vtkPolyDataMapper
from vtkwater import vtkWaterActor, vtkWaterLakes

INDEX = 1.333
DEPTH = 2.0
CLEAR = np.array((0.02, 0.05, 0.1))  # 1/m
PER_UNIT = np.array((0.004, 0.02, 0.06))  # 1/m, per g/m^3
RENDERERS = pytest.mark.parametrize("is_software", (1, 0), ids=("software", "hardware"))
SLANTED = (0, -8, 9)


def murky(values_at, name="silt", of_cells=False, components=1, mapper=None, deep=(0, 0, 0), samples=0, used=True):
    """A pool 2 m deep with a white bed, and matter that only absorbs."""
    mesh = mesh_of("silt", values_at, of_cells=of_cells, components=components)
    scene = Scene(mesh, DEPTH, samples=samples)
    if mapper is not None:
        mapper.SetInputDataObject(mesh)
        mapper.ScalarVisibilityOff()
        scene.water.SetMapper(mapper)
    scene.look.SetIndexOfRefraction(INDEX)
    scene.look.SetAbsorption(CLEAR)
    scene.look.SetScattering(0, 0, 0)
    if deep is not None:
        scene.look.SetDeepColor(deep)
    if used:
        scene.water.SetMatterArrayName(name)
        scene.water.SetMatterAbsorption(PER_UNIT)
        scene.water.SetMatterScattering(0, 0, 0)
    scene.look_from(SLANTED)
    return scene


def ways_of(scene):
    """For each pixel, the length of its refracted ray, m, and where on the surface that begins."""
    start, ray = ray_caster.eye_rays(scene.view.renderer.GetActiveCamera(), SIZE, 1)
    places = start - (start[:, 2] / ray[:, 2])[:, None] * ray
    return DEPTH / np.sqrt(1 - (1 - ray[:, 2] ** 2) / INDEX**2), places


def check_left(scene, concentrations, what):
    """What is left of a white bed, by Beer's law; as near to it as clear water comes (TestWaterRefractsAndAbsorbs)."""
    ways, places = ways_of(scene)
    expected = np.exp(-(CLEAR + concentrations(places)[:, None] * PER_UNIT) * ways[:, None])
    picture = scene.picture()
    found = picture.reshape(-1, 3) / 255
    wt.check_at_most(f"{what}: largest error of a pixel", float(np.abs(found - expected).max()), 0.6 / 255 + 0.005)
    for i, channel in enumerate("rgb"):
        if expected[:, i].mean() > 0.02:  # or the steps of 1 / 255 are coarse
            error = float(abs(found[:, i].mean() / expected[:, i].mean() - 1))
            wt.check_at_most(f"{what}, {channel}: error of the mean transmittance", error, 0.005)
    return picture


@pytest.mark.parametrize("concentration, kind, is_software", (
    (0.5, "points", 1), (5.0, "points", 1), (20.0, "points", 1), (60.0, "points", 1), (5.0, "points", 0),
    (20.0, "points", 0), (5.0, "cells", 1), (5.0, "data set mapper", 1), (20.0, "multisampled", 1)))
def test_light_is_lost_as_beers_law_has_it(concentration, kind, is_software, monkeypatch):
    """What is left of a white bed is exp(-(a + c m) x) over the refracted ray's length x, for each channel."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    scene = murky(lambda x, y: concentration + 0 * x, of_cells=kind == "cells",
                  mapper=vtkDataSetMapper() if kind == "data set mapper" else None,
                  samples=4 if kind == "multisampled" else 0)
    picture = check_left(scene, lambda places: np.full(len(places), concentration), f"{kind}, {concentration} g/m^3")
    if kind == "points":
        wt.save(picture, wt.output_folder() / f"matter_{concentration:g}.png")
    wt.check_equal("told", scene.errors + scene.warnings, [])


def test_a_ray_sees_the_matter_where_it_enters():
    """A concentration that rises along x: each pixel shows that of its point of the surface, between the vertices too."""
    scene = murky(lambda x, y: np.maximum(10 + 1.5 * x, 0))
    picture = check_left(scene, lambda places: np.maximum(10 + 1.5 * places[:, 0], 0), "rising")
    wt.save(picture, wt.output_folder() / "matter_rising.png")


@RENDERERS
@pytest.mark.parametrize("deep", ((0.1, 0.3, 0.4), None), ids=("given", "medium"))
def test_none_of_it_is_as_without(deep, is_software, monkeypatch):
    """A concentration of 0 leaves every byte, under a sun and on waves, too."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    pictures = []
    for used in (False, True):
        scene = murky(lambda x, y: 0 * x, deep=deep, used=used)
        scene.look.SetScattering(0.01, 0.02, 0.03)
        scene.look.SetReflectanceModeToFresnel()
        scene.look.AddNormalMap(None, 3.0, 0.0, 0.0, 0.3)
        wt.add_scene_light(scene.view.renderer, (0.3, 0.2, 1))
        pictures.append(scene.picture())
    wt.check_equal("pixels that differ", int((pictures[0] != pictures[1]).any(axis=2).sum()), 0)
    wt.check_at_least("spread of the picture", float(pictures[0].std()), 3.0)


def encoded(linear):
    linear = np.clip(linear, 0, 1)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


@pytest.mark.parametrize("concentration", (2.0, 50.0, 1e6))
def test_deep_water_has_the_color_of_both(concentration):
    """Where nothing is seen through it, the water sends back 0.33 b / (a + b) of both together, under white light; and as
    water does that has these coefficients itself."""
    absorbed, scattered, own = np.array((0.0032, 0.0110, 0.0376)), np.full(3, 0.012), np.array((0.001, 0.002, 0.004))
    shown = []
    for is_given in (False, True):
        scene = Scene(mesh_of("silt", lambda x, y: concentration + 0 * x), depth=150.0, bed=(0, 0, 0))
        wt.add_scene_light(scene.view.renderer, (0, 0, 1))
        added = concentration if is_given else 0.0
        scene.look.SetAbsorption(CLEAR + added * absorbed)
        scene.look.SetScattering(own + added * scattered)
        if not is_given:
            scene.water.SetMatterArrayName("silt")
            scene.water.SetMatterAbsorption(absorbed)
            scene.water.SetMatterScattering(scattered)
        scene.look_from((0, 0, 20))
        shown.append(scene.picture()[60, 80])
    both = own + concentration * scattered
    share = 0.33 * both / (both + CLEAR + concentration * absorbed)
    wt.check_at_most("off the formula, of 255", float(np.abs(shown[0] - 255 * encoded(share)).max()), 1.0)
    wt.check_at_most("off water of these coefficients", int(np.abs(shown[0] - shown[1]).max()), 1)


def test_a_given_deep_color_stays():
    scene = murky(lambda x, y: 1e6 + 0 * x, deep=(0.2, 0.6, 0.4))
    wt.check_at_most("off the given color", int(np.abs(scene.picture()[60, 80] - (51, 153, 102)).max()), 1)


def test_an_eye_under_water_looks_through_clear_water():
    scenes = [murky(lambda x, y: 30 + 0 * x, used=used) for used in (False, True)]
    for scene in scenes:
        scene.look.SetScattering(0.1, 0.1, 0.1)
        wt.place_camera(scene.view.renderer, (0, -6, -1.2), (0, 0, 0), (0.1, 100), (0, 0, 1))
    wt.check_equal("pixels that differ", int((scenes[0].picture() != scenes[1].picture()).sum()), 0)


def test_wrong_values_count_as_0_and_are_told_once():
    """Negative ones, and those that are not finite; the text says how many, and the first."""
    wrong = murky(lambda x, y: np.where(x < -10, np.nan, np.where(x > 10, -3.0, np.where(y > 10, np.inf, 8.0))))
    right = murky(lambda x, y: np.where((np.abs(x) > 10) | (y > 10), 0.0, 8.0))
    wt.check_equal("pixels that differ", int((wrong.picture() != right.picture()).sum()), 0)
    wrong.look_from((0, -3, 12))
    wrong.picture()
    wt.check_equal("told", (len(wrong.warnings), len(wrong.errors), len(right.warnings)), (1, 0, 0))
    for words in ("MatterArrayName", "'silt'", "of the 1681 concentrations", "nan at point 0", "not negative", "as 0"):
        wt.check(f"'{words}' is told", words in wrong.warnings[0], True, words in wrong.warnings[0])


@pytest.mark.parametrize("of_cells", (False, True), ids=("points", "cells"))
@pytest.mark.parametrize("name, components, words", (
    ("salt", 1, ("no numeric array 'salt'", "silt", "water is clear")),
    ("silt", 3, ("3 components", "concentrations must have 1"))), ids=("missing", "components"))
def test_a_wrong_array_is_an_error_once(name, components, words, of_cells):
    """The water is clear then, and a right array works after it."""
    scene = murky(lambda x, y: 9 + 0 * x, name=name, components=components, of_cells=of_cells)
    clear = murky(lambda x, y: 9 + 0 * x, used=False)
    for _ in range(2):
        wt.check_equal("pixels that differ", int((scene.picture() != clear.picture()).sum()), 0)
        scene.look_from((0, -8, 9))
    wt.check_equal("errors", len(scene.errors), 1)
    wt.check_equal("the last error", scene.water.GetLastError() in scene.errors[0], True)
    for word in words:
        wt.check(f"'{word}' is in the error", word in scene.errors[0], True, word in scene.errors[0])
    scene.mapper.SetInputDataObject(mesh_of("silt", lambda x, y: 9 + 0 * x))
    scene.water.SetMatterArrayName("silt")
    wt.check_at_least("pixels that change", int((scene.picture() != clear.picture()).any(axis=2).sum()), 1000)
    wt.check_equal("errors after that", (len(scene.errors), scene.water.GetLastError()), (1, ""))


def test_the_array_is_followed_from_frame_to_frame():
    scene = murky(lambda x, y: 5 + 0 * x)
    scene.picture()
    mesh = scene.mapper.GetInput()
    mesh.GetPointData().AddArray(mesh_of("silt", lambda x, y: 40 + 0 * x).GetPointData().GetArray("silt"))
    wt.check_equal("pixels that differ", int((scene.picture() != murky(lambda x, y: 40 + 0 * x).picture()).sum()), 0)


def test_settings_are_checked_copied_and_printed():
    water = vtkWaterActor()
    errors = wt.errors_of(water)
    for wrong in ((-1, 0, 0), (0, float("nan"), 0), (0, 0, float("inf")), (2e9, 0, 0)):
        water.SetMatterAbsorption(wrong)
        water.SetMatterScattering(wrong)
    wt.check_equal("errors", len(errors), 8)
    wt.check("the text", "finite, not negative and at most 1e9", "in it", "finite, not negative and at most 1e9" in errors[0])
    wt.check_at_most("defaults are off", float(np.abs(np.subtract(
        water.GetMatterAbsorption() + water.GetMatterScattering(),
        (0.0032, 0.0110, 0.0376, 0.012, 0.012, 0.012))).max()), 5e-5)
    water.SetMatterArrayName("c")
    water.SetMatterAbsorption(1, 2, 3)
    water.SetMatterScattering(4, 5, 6)
    copied = vtkWaterActor()
    copied.ShallowCopy(water)
    wt.check_equal("copied", (copied.GetMatterArrayName(), copied.GetMatterAbsorption(), copied.GetMatterScattering()),
                   ("c", (1, 2, 3), (4, 5, 6)))
    for words in ("MatterArrayName: c", "MatterAbsorption: (1, 2, 3)", "MatterScattering: (4, 5, 6)"):
        wt.check(f"'{words}' is printed", words in str(water), True, words in str(water))
    sheet = murky(lambda x, y: 1 + 0 * x)
    sheet.water.SetMapper(None)
    sheet.picture()
    wt.check_equal("errors of a sheet without arrays", len(sheet.errors), 1)


def test_waters_of_one_mesh_carry_the_same_matter():
    """vtkWaterLakes gives its parts the array."""
    scene = murky(lambda x, y: 12 + 0 * x)
    alone = scene.picture()
    lakes, mapper = vtkWaterLakes(), vtkPolyDataMapper()
    mapper.SetInputData(mesh_of("silt", lambda x, y: 12 + 0 * x))
    mapper.ScalarVisibilityOff()
    lakes.SetMapper(mapper)
    water = lakes.GetWater()
    scene.view.renderer.RemoveActor(scene.water)
    water.SetWaterProperty(scene.look)
    water.SetMatterArrayName("silt")
    water.SetMatterAbsorption(PER_UNIT)
    water.SetMatterScattering(0, 0, 0)
    lakes.AddTo(scene.view.renderer)
    wt.check_equal("pixels that differ", int((scene.picture() != alone).sum()), 0)

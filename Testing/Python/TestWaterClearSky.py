# SPDX-License-Identifier: BSD-3-Clause
"""The clear sky: a picture for a skybox, in which VTK and the water find the sun's side where the sun is."""

import numpy as np
import sky_scenes
import water_test as wt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkSkybox
from vtkwater import vtkWaterClearSkySource


def texels_of(sky):
    image = sky.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)


def direction(azimuth, elevation):
    azimuth, elevation = np.radians(azimuth), np.radians(elevation)
    return np.array((np.sin(azimuth) * np.cos(elevation), np.cos(azimuth) * np.cos(elevation), np.sin(elevation)))


def test_picture_is_the_sky_as_a_camera_sees_it():
    """VTK shows the skybox's brightest place where the sun is, and everywhere the texel of that direction."""
    sky = vtkWaterClearSkySource()
    sky.SetAzimuth(70)
    sky.SetElevation(25)
    looker = sky_scenes.Looker("colour")
    box = vtkSkybox()
    sky.ConfigureSkybox(box, looker.view.renderer)
    box.GetTexture().MipmapOff()  # VTK 9.1 shows its second level
    looker.view.renderer.AddActor(box)
    wt.check_at_most("direction of the sun", float(np.abs(np.array(sky.GetSunDirection()) - direction(70, 25)).max()), 1e-12)
    texels = texels_of(sky)
    height, width = texels.shape[:2]
    row, column = np.unravel_index(texels.sum(axis=2).argmax(), (height, width))
    u, v = (column + 0.5) / width, (row + 0.5) / height
    bright = direction(90 + 360 * (u - 0.5), 180 * (v - 0.5))
    wt.check_at_least("cosine to the sun of the brightest texel over the haze", float(bright @ direction(70, 25)), 0.9)
    chance = np.random.default_rng(5)
    worst = 0
    for _ in range(30):
        column, row = chance.integers(0, width), chance.integers(height // 2, height)
        u, v = (column + 0.5) / width, (row + 0.5) / height
        shown = looker.colour((0, 0, 0), direction(90 + 360 * (u - 0.5), 180 * (v - 0.5)))
        expected = 255 * np.clip(texels[row, column], 0, 1) ** (1 / 2.2)
        worst = max(worst, float(np.abs(shown - expected).max()))
    wt.check_at_most("the picture in its directions: error of 255", round(worst, 2), 2.0)


def test_looks_natural():
    """The sky's mean is 0.3 of white, blue at the zenith, and a low sun is orange; haze is grey."""
    sky = vtkWaterClearSkySource()
    for elevation in (5, 30, 60):
        sky.SetElevation(elevation)
        up = texels_of(sky)[-1].mean(axis=0)
        wt.check(f"sun at {elevation}: the zenith is blue", up.round(3), "blue > green > red", up[2] > up[1] > up[0])
        color = np.array(sky.GetSunColor())
        wt.check_at_most(f"sun at {elevation}: its brightest colour", float(color.max()), 1.0)
    wt.check_equal("turbidity of a new sky", sky.GetTurbidity(), 2.0)
    sky.SetElevation(3)
    low = np.array(sky.GetSunColor())
    sky.SetElevation(60)
    high = np.array(sky.GetSunColor())
    wt.check_at_least("red over blue of a low sun, against a high one", low[0] / low[2] / (high[0] / high[2]), 1.3)
    width = 64
    sky.SetWidth(width)
    wt.check_equal("dimensions", sky.GetOutput().GetDimensions(), (width, width // 2, 1))
    before = texels_of(sky).copy()
    sky.SetExposure(0.01)
    after = texels_of(sky)
    wt.check("another exposure is another picture", float(np.abs(after - before).max()), "> 0", (after != before).any())


def test_bad_values_are_said_once_and_change_nothing():
    """A sun under the horizon, air that is none, a picture of no size: one error that names them."""
    for setter, value, words in (("SetElevation", -1.0, ("Elevation", "-1", "[0, 90]", "horizon")),
                                 ("SetElevation", float("nan"), ("Elevation", "nan")),
                                 ("SetAzimuth", 400.0, ("Azimuth", "400", "[-360, 360]")),
                                 ("SetTurbidity", 1.5, ("Turbidity", "1.5", "[2, 10]")),
                                 ("SetTurbidity", 11.0, ("Turbidity", "11", "[2, 10]")),
                                 ("SetExposure", -1.0, ("Exposure", "-1")),
                                 ("SetWidth", 8, ("Width", "8", "[16, 8192]"))):
        sky = vtkWaterClearSkySource()
        errors = wt.errors_of(sky)
        before = getattr(sky, setter.replace("Set", "Get"))()
        getattr(sky, setter)(value)
        wt.check_equal(f"{setter}({value}): errors", len(errors), 1)
        for word in words:
            wt.check_equal(f"{setter}({value}): the error says '{word}'", word in "".join(errors), True)
        wt.check_equal(f"{setter}({value}): it stays", getattr(sky, setter.replace("Set", "Get"))(), before)
    errors = wt.errors_of(sky)
    sky.ConfigureSkybox(None, None)
    wt.check_equal("no skybox: errors", len(errors), 1)

# SPDX-License-Identifier: BSD-3-Clause
"""Normal maps on the water: the normals are the texels', where the map has moved to; far away what is
smaller than a pixel is averaged; what is no normal map is refused."""

import numpy as np
import pytest
import ray_caster
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkTexture
from vtkwater import vtkWaterProperty

SIZE = (300, 220)
INDEX = 1.333
TEXELS = 128
LAYERS = ((3.0, 0.4, 30.0, 1.0), (1.7, 0.7, -100.0, 0.6))  # size, speed, direction, strength
NAN = float("nan")


def texture_of(values, kind=np.uint8):
    image = vtkImageData()
    image.SetDimensions(values.shape[1], values.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(values.reshape(-1, values.shape[2]).astype(kind), deep=True))
    texture = vtkTexture()
    texture.SetInputData(image)
    return texture


def slopes(u, v):
    """Slopes over a map, u and v in maps: a few waves."""
    return (0.08 * np.cos(2 * np.pi * (2 * u + v)) + 0.03 * np.sin(2 * np.pi * 3 * v),
            0.05 * np.cos(2 * np.pi * (u - 2 * v)) - 0.04 * np.sin(2 * np.pi * 2 * u))


def normal_map(texels=TEXELS):
    u, v = np.meshgrid(*2 * ((np.arange(texels) + 0.5) / texels,))
    normal = np.stack([-slopes(u, v)[0], -slopes(u, v)[1], np.ones_like(u)], axis=2)
    normal /= np.linalg.norm(normal, axis=2, keepdims=True)
    return np.rint(127.5 + 127.5 * normal)


def scene(position):
    made = wt.View(SIZE, (0, 0, 0))
    water = wt.add_water(made.renderer, None, (-90, 90, -90, 90), None)
    water.GetWaterProperty().SetIndexOfRefraction(INDEX)
    camera = wt.place_camera(made.renderer, position, (0.3, 0.2, 0), (0.1, 400), view_up=(0, 1, 0.2))
    start, ray = ray_caster.eye_rays(camera, SIZE, 1)
    return made, water, start - (start[:, 2] / ray[:, 2])[:, None] * ray, ray


def reflectance(made):
    shown = made.picture().reshape(-1, 3)
    return (256 * shown[:, 0] + shown[:, 1]) / 65535


def expected_reflectance(layers, time, place, ray):
    """Of places seen along rays, from the Fresnel equations and the slopes of some layers at a time."""
    slope_x, slope_y = np.zeros(len(place)), np.zeros(len(place))
    for size, speed, direction, strength in layers:
        way = speed * time
        u = (place[:, 0] - way * np.cos(np.radians(direction))) / size
        v = (place[:, 1] - way * np.sin(np.radians(direction))) / size
        x, y = slopes(u, v)
        slope_x, slope_y = slope_x + strength * x, slope_y + strength * y
    normal = np.stack([-slope_x, -slope_y, np.ones_like(slope_x)], axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    return ray_caster.fresnel(-(ray * normal).sum(axis=1))


def mapped_scene(layers):
    """A scene near water with maps, that shows its reflectance."""
    made, water, place, ray = scene((0.5, -3, 1.2))
    texture = texture_of(normal_map())
    for layer in layers:
        water.GetWaterProperty().AddNormalMap(texture, *layer)
    water.GetWaterProperty().SetOutputToReflectance()
    return made, water, place, ray


@pytest.mark.parametrize("time", [0.0, 12.3], ids=["0_s", "12.3_s"])
@pytest.mark.parametrize("count", [1, 2], ids=["1_map", "2_maps"])
def test_normals_are_those_of_the_texels(count, time):
    """The reflectance near by is that of the maps' normals, where each map has moved to at the time."""
    made, water, place, ray = mapped_scene(LAYERS[:count])
    water.SetTime(time)
    expected = expected_reflectance(LAYERS[:count], time, place, ray)
    near = np.linalg.norm(place, axis=1) < 4
    error = np.abs(reflectance(made) - expected)[near]
    wt.check_at_most(f"{count} map(s) at {time:g} s: error of the reflectance, 99 % of the pixels",
                     float(np.percentile(error, 99)), 6e-3)
    still = expected_reflectance([], 0.0, place, ray)[near]
    wt.check_at_least(f"{count} map(s) at {time:g} s: the maps' own part of it",
                      float(np.abs(expected[near] - still).mean()), 1.2e-2)


def test_time_alone_makes_the_picture():
    """A late time gives the same picture at once and after frames of other times, also after a release."""
    made, water, _, _ = mapped_scene(LAYERS)
    made.picture()
    water.ReleaseGraphicsResources(made.window)
    water.SetTime(1e6)
    straight = made.picture()
    water.SetTime(3.3)
    made.picture()
    water.SetTime(1e6)
    wt.check_equal("1e6 s after other frames: largest difference", int(np.abs(made.picture() - straight).max()), 0)


def test_far_away_the_mean_of_a_pixel_is_shown():
    """From far away the maps are a variance: a pixel is near the mean of 25 samples of it, nearer than its middle."""
    made, water, _, _ = scene((0.5, -300, 100))
    look = water.GetWaterProperty()
    look.AddNormalMap(None, 2.0, 0.5)
    look.SetOutputToReflectance()
    made.renderer.GetActiveCamera().SetViewAngle(4)
    found = reflectance(made).reshape(SIZE[1], SIZE[0])
    made.window.SetSize(5 * SIZE[0], 5 * SIZE[1])
    many = reflectance(made).reshape(SIZE[1], 5, SIZE[0], 5)
    points = many[:, 2, :, 2]
    many = many.mean(axis=(1, 3))
    middle = (slice(90, 130), slice(100, 200))
    error = float(np.sqrt(((found - many)[middle] ** 2).mean()))
    wt.check_at_most("far away: mean reflectance over that of 25 samples a pixel, less 1",
                     abs(float(found[middle].mean() / many[middle].mean()) - 1), 0.02)
    wt.check_at_most("far away: RMSE from 25 samples a pixel, over their mean",
                     error / float(many[middle].mean()), 0.05)
    wt.check_at_most("far away: the same of the pixels' middles, over that",
                     error / float(np.sqrt(((points - many)[middle] ** 2).mean())), 0.5)


def test_the_built_in_map_can_be_read():
    """The built-in map is a texture that can be read, and a map that was not added is none."""
    look = vtkWaterProperty()
    look.AddNormalMap(None, 2.0, 0.5)
    wt.check_equal("built-in map: size", look.GetNormalMapTexture(0).GetInput().GetDimensions(), (256, 256, 1))
    wt.check_equal("no third map", look.GetNormalMapTexture(2), None)


def one_channel():
    return texture_of(normal_map()[:, :, :1])


def floats():
    return texture_of(normal_map() / 255, np.float32)


def one_row():
    return texture_of(normal_map()[:1])


def cube_map():
    texture = vtkTexture()
    texture.CubeMapOn()
    return texture


def built_in():
    return None


REFUSED = {  # a texture, size, speed, ...; what the error must say
    "one channel": (one_channel, (1.0,), ("1 channel", "3 or 4")),
    "floats": (floats, (1.0,), ("float", "8 bits")),
    "one row": (one_row, (1.0,), ("128 x 1", "2 x 2")),
    "no picture": (vtkTexture, (1.0,), ("one picture",)),
    "cube map": (cube_map, (1.0,), ("one picture",)),
    "size 0": (built_in, (0.0,), ("Size 0", "[1e-6, 1e9]")),
    "speed NaN": (built_in, (1.0, NAN), ("nan", "finite")),
    "strength infinite": (built_in, (1.0, 0.0, 0.0, float("inf")), ("inf", "[-1000, 1000]")),
}


@pytest.mark.parametrize("name", REFUSED, ids=lambda name: name.replace(" ", "_"))
def test_what_is_no_normal_map_is_refused(name):
    """What is no normal map is refused with one error that says why, and nothing is added."""
    make, arguments, words = REFUSED[name]
    look = vtkWaterProperty()
    errors = wt.errors_of(look)
    wt.check_equal(f"{name}: refused", look.AddNormalMap(make(), *arguments), -1)
    wt.check_equal(f"{name}: errors", len(errors), 1)
    for word in words:
        wt.check_equal(f"{name}: the error says '{word}'", word in "".join(errors), True)
    wt.check_equal(f"{name}: none added", look.GetNumberOfNormalMaps(), 0)


def test_a_texture_that_loses_its_picture_is_left_out():
    """A texture that loses its picture is said once and left out; the picture's return brings the map back."""
    made, water, _, _ = scene((0.5, -3, 1.2))
    water.GetWaterProperty().SetOutputToReflectance()
    level = made.picture()
    texture = texture_of(normal_map())
    water.GetWaterProperty().AddNormalMap(texture, 2.0)
    rippled = made.picture()
    errors = wt.errors_of(water.GetWaterProperty())
    texture.RemoveAllInputConnections(0)
    for _ in range(3):
        without = made.picture()
    wt.check_equal("picture gone: errors in three frames", len(errors), 1)
    wt.check_at_most("picture gone: difference from level water, of 255",
                     int(np.abs(without - level)[:, :, 0].max()), 1)
    texture.SetInputData(texture_of(normal_map()).GetInput())
    wt.check_equal("picture back: difference", int(np.abs(made.picture() - rippled).max()), 0)


def test_a_third_map_is_refused():
    """A water has two normal maps at most; a third is refused with an error."""
    look = vtkWaterProperty()
    errors = wt.errors_of(look)
    wt.check_equal("three maps", [look.AddNormalMap(None, 1.0) for _ in range(3)], [0, 1, -1])
    wt.check_equal("three maps: errors", len(errors), 1)

# SPDX-License-Identifier: BSD-3-Clause
"""Normal maps on the water: the normals are the texels', where the map has moved to; far away what is
smaller than a pixel is averaged; what is no normal map is refused."""

import numpy as np
import ray_caster
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkTexture
from vtkwater import vtkWaterProperty

SIZE = (300, 220)
INDEX = 1.333
TEXELS = 128


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
    """layers: size, speed, direction, strength."""
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


LAYERS = ((3.0, 0.4, 30.0, 1.0), (1.7, 0.7, -100.0, 0.6))
texture = texture_of(normal_map())
for count in (1, 2):
    for time in (0.0, 12.3):
        made, water, place, ray = scene((0.5, -3, 1.2))
        look = water.GetWaterProperty()
        for layer in LAYERS[:count]:
            look.AddNormalMap(texture, *layer)
        look.SetOutputToReflectance()
        water.SetTime(time)
        expected = expected_reflectance(LAYERS[:count], time, place, ray)
        near = np.linalg.norm(place, axis=1) < 4
        error = np.abs(reflectance(made) - expected)[near]
        wt.check_at_most(f"{count} map(s) at {time:g} s: error of the reflectance, 99 % of the pixels",
                         float(np.percentile(error, 99)), 6e-3)
        still = expected_reflectance([], 0.0, place, ray)[near]
        wt.check_at_least(f"{count} map(s) at {time:g} s: the maps' own part of it",
                          float(np.abs(expected[near] - still).mean()), 1.2e-2)
        water.ReleaseGraphicsResources(made.window)

# Time alone makes the picture.
water.SetTime(1e6)
straight = made.picture()
water.SetTime(3.3)
made.picture()
water.SetTime(1e6)
wt.check_equal("1e6 s after other frames: largest difference", int(np.abs(made.picture() - straight).max()), 0)

# From far away the maps are a variance: the mean reflectance is that of the picture at 25 times the
# samples, and neighbours are alike.
made, water, place, ray = scene((0.5, -300, 100))
look = water.GetWaterProperty()
look.AddNormalMap(None, 2.0, 0.5)
look.SetOutputToReflectance()
camera = made.renderer.GetActiveCamera()
camera.SetViewAngle(4)
found = reflectance(made).reshape(SIZE[1], SIZE[0])
look.RemoveAllNormalMaps()
calm = reflectance(made).reshape(SIZE[1], SIZE[0])
look.AddNormalMap(None, 2.0, 0.5)
made.window.SetSize(5 * SIZE[0], 5 * SIZE[1])
many = made.picture()
many = ((256 * many[:, :, 0] + many[:, :, 1]) / 65535).reshape(SIZE[1], 5, SIZE[0], 5)
points = many[:, 2, :, 2]
many = many.mean(axis=(1, 3))
middle = (slice(90, 130), slice(100, 200))
wt.check_at_most("far away: mean reflectance over that of 25 samples a pixel, less 1",
                 abs(float(found[middle].mean() / many[middle].mean()) - 1), 0.02)
wt.check_at_most("far away: RMSE from 25 samples a pixel, over their mean",
                 float(np.sqrt(((found - many)[middle] ** 2).mean()) / many[middle].mean()), 0.05)
wt.check_at_most("far away: the same of the pixels' middles, over that",
                 float(np.sqrt(((found - many)[middle] ** 2).mean()) / np.sqrt(((points - many)[middle] ** 2).mean())), 0.5)

# The built-in map is one: it can be read, and it ripples the water.
texture = look.GetNormalMapTexture(0)
wt.check_equal("built-in map: size", texture.GetInput().GetDimensions(), (256, 256, 1))
wt.check_equal("no third map", look.GetNormalMapTexture(2), None)

# What is no normal map is refused, with the reason; nothing is added.
NAN = float("nan")
gray = texture_of(normal_map()[:, :, :1])
floats = texture_of(normal_map() / 255, np.float32)
thin = texture_of(normal_map()[:1])
cube = vtkTexture()
cube.CubeMapOn()
for name, arguments, words in (("one channel", (gray, 1.0), ("1 channel", "3 or 4")),
                               ("floats", (floats, 1.0), ("float", "8 bits")),
                               ("one row", (thin, 1.0), ("128 x 1", "2 x 2")),
                               ("no picture", (vtkTexture(), 1.0), ("one picture",)),
                               ("cube map", (cube, 1.0), ("one picture",)),
                               ("size 0", (None, 0.0), ("Size 0", "[1e-6, 1e9]")),
                               ("speed NaN", (None, 1.0, NAN), ("nan", "finite")),
                               ("strength infinite", (None, 1.0, 0.0, 0.0, float("inf")), ("inf", "[-1000, 1000]"))):
    look = vtkWaterProperty()
    errors = wt.errors_of(look)
    wt.check_equal(f"{name}: refused", look.AddNormalMap(*arguments), -1)
    wt.check_equal(f"{name}: errors", len(errors), 1)
    for word in words:
        wt.check_equal(f"{name}: the error says '{word}'", word in "".join(errors), True)
    wt.check_equal(f"{name}: none added", look.GetNumberOfNormalMaps(), 0)
# A texture that loses its picture later is said once, and left out; its return brings the map back.
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
wt.check_at_most("picture gone: difference from level water, of 255", int(np.abs(without - level)[:, :, 0].max()), 1)
texture.SetInputData(texture_of(normal_map()).GetInput())
wt.check_equal("picture back: difference", int(np.abs(made.picture() - rippled).max()), 0)

look = vtkWaterProperty()
errors = wt.errors_of(look)
wt.check_equal("three maps", [look.AddNormalMap(None, 1.0) for _ in range(3)], [0, 1, -1])
wt.check_equal("three maps: errors", len(errors), 1)
wt.finish()

# SPDX-License-Identifier: BSD-3-Clause
"""What the sun does: glitter by the formula, shadows and caustics against rays; foam; and a static
environment in place of the mirrored scene."""

import numpy as np
import ray_caster
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkTexture
from vtkwater import vtkWaterProperty, vtkWaterReflectionPass

SIZE = (300, 220)
INDEX = 1.333


def look_at(made, position, target=(0, 0, 0), angle=30, up=(0, 0, 1)):
    camera = made.renderer.GetActiveCamera()
    camera.SetPosition(position)
    camera.SetFocalPoint(target)
    camera.SetViewUp(up)
    camera.SetViewAngle(angle)
    camera.SetClippingRange(0.1, 400)
    return camera


def dark_water(made, reflectance=0.0):
    water = wt.add_water(made.renderer, None, (-200, 200, -200, 200), reflectance)
    water.GetWaterProperty().SetDeepColor(0, 0, 0)
    return water


def pixel_rays(camera, samples=1):
    start, ray = ray_caster.eye_rays(camera, SIZE, samples)
    return start - (start[:, 2] / ray[:, 2])[:, None] * ray, ray


# Glitter of slopes that are too small for waves: Cox and Munk's Gaussian along and across the wind,
# written here again; radiance pi I F p / (4 cos(eye) cos^4(facet)).
SUN = np.array((0.3, 0.6, 0.55))
for along, across, wind in ((0.02, 0.02, 0.0), (0.03, 0.012, 0.0), (0.03, 0.012, 40.0)):
    made = wt.View(SIZE, (0, 0, 0))
    wt.add_scene_light(made.renderer, SUN)
    made.renderer.GetLights().GetItemAsObject(0).SetIntensity(0.5)
    water = dark_water(made)
    water.GetWaterProperty().SetSlopeVariance(along, across, wind)
    camera = look_at(made, (1, -10, 6), angle=60)
    _, ray = pixel_rays(camera)
    sun = SUN / np.linalg.norm(SUN)
    facet = sun - ray
    facet /= np.linalg.norm(facet, axis=1, keepdims=True)
    slope = -facet[:, :2] / facet[:, 2:]
    turn = np.radians(wind)
    first = slope @ (np.cos(turn), np.sin(turn))
    second = slope @ (-np.sin(turn), np.cos(turn))
    density = np.exp(-0.5 * (first**2 / along + second**2 / across)) / (2 * np.pi * np.sqrt(along * across))
    expected = np.pi * 0.5 * ray_caster.fresnel(facet @ sun) * density / (4 * -ray[:, 2] * facet[:, 2] ** 4)
    shown = made.picture()[:, :, 0].ravel() / 255
    good = (ray[:, 2] < -0.05) & (expected < 0.99)
    name = f"glitter, variances {along}, {across}, wind {wind:g} degrees"
    wt.check_at_most(f"{name}: largest error", float(np.abs(shown - expected)[good].max()), 0.01)
    wt.check_at_least(f"{name}: brightest pixel that is compared", float(shown[good].max()), 0.25)
water.GetWaterProperty().GlitterOff()
wt.check_equal("glitter off: brightest pixel", int(made.picture().max()), 0)
water.GetWaterProperty().GlitterOn()
made.renderer.RemoveAllLights()
made.renderer.CreateLight()
wt.check_equal("a headlight is no sun: brightest pixel", int(made.picture().max()), 0)
water.GetWaterProperty().SetSlopeVarianceToWind(10.0, 30.0)
given = [0.0, 0.0, 0.0]
water.GetWaterProperty().GetSlopeVariance(given)
wt.check_at_most("wind of 10 m/s: error of Cox and Munk's variances",
                 float(np.abs(np.array(given) - (0.0316, 0.0222, 30)).max()), 1e-12)

# A post's shadow on the glitter: the ray from the water to the sun, cast.
made = wt.View(SIZE, (0, 0, 0))
post = ray_caster.Box((0.4, 1.0, 1), (0.8, 0.8, 3), (0, 0, 0))
wt.add_actor(made.renderer, wt.box(0.5 * (post.low + post.high), post.high - post.low), (0, 0, 0), lit=False)
wt.add_scene_light(made.renderer, SUN)
made.renderer.GetLights().GetItemAsObject(0).SetIntensity(6)
water = dark_water(made)
water.GetWaterProperty().SetReflectanceModeToFresnel()
water.GetWaterProperty().SetSlopeVariance(0.08, 0.08)
camera = look_at(made, (1, -10, 6))
bright = made.picture()[:, :, 0]
water.GetWaterProperty().ShadowsOn()
shadowed = made.picture()[:, :, 0]
place, ray = pixel_rays(camera)
_, way = ray_caster.cast([post], (0, 0, 0), place + 1e-6 * sun, np.tile(sun, (len(place), 1)))
_, seen = ray_caster.cast([post], (0, 0, 0), np.tile(camera.GetPosition(), (len(place), 1)), ray)
is_shaded = (np.isfinite(way) & ~np.isfinite(seen)).reshape(SIZE[1], SIZE[0]) & (bright > 30)
is_lit = (~np.isfinite(way) & ~np.isfinite(seen)).reshape(SIZE[1], SIZE[0]) & (bright > 30)
wt.check_at_least("shadow: pixels of glitter in it", int(is_shaded.sum()), 300)
wt.check_at_least("shadow: % of them that are dark", 100 * float((shadowed < 10)[is_shaded].mean()), 90)
# what passes behind the post, as the mirrored view has it, counts as shaded
wt.check_at_least("shadow: % of the lit glitter that stays", 100 * float((shadowed == bright)[is_lit].mean()), 94)

# Caustics of one wave on a level bed: light gathers where rays from the surface do, counted.
WAVE, DEPTH = (0.03, 1.5, 0.0, 0.0), 1.5
made = wt.View(SIZE, (0, 0, 0))
wt.add_actor(made.renderer, wt.box((0, 0, -DEPTH - 0.5), (300, 300, 1)), (0.4, 0.4, 0.4), lit=False)
wt.add_scene_light(made.renderer, (0, 0, 1))
water = dark_water(made)
look = water.GetWaterProperty()
look.RefractionOn()
look.SetAbsorption(0, 0, 0)
look.SetScattering(0, 0, 0)
look.GlitterOff()
look.AddWave(*WAVE)
look_at(made, (0, 0, 12), angle=20, up=(0, 1, 0))
plain = made.picture()[110, :, 0].astype(float)
look.SetCaustics(1.0)
row = made.picture()[110, :, 0] / plain
x = np.linspace(-6, 6, 400001)
_, slope, _ = ray_caster.heights_and_slopes((WAVE,), x, np.zeros_like(x), 0.0)
tilt = np.arctan(slope)
lands = x + DEPTH * np.tan(tilt - np.arcsin(np.sin(tilt) / INDEX))
edges = np.linspace(-2.2, 2.2, 111)
light = np.histogram(lands, edges)[0] / (len(x) / 12 * (edges[1] - edges[0]))
apparent = DEPTH / INDEX  # straight down: the bed seems nearer
pixel = 2 * (12 + apparent) * np.tan(np.radians(10)) / SIZE[1]
at = (np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2) * pixel
shown = np.interp(0.5 * (edges[1:] + edges[:-1]), at, row)
wt.check_at_least("caustics: correlation with counted rays", float(np.corrcoef(shown, light)[0, 1]), 0.9)
wt.check_at_most("caustics: error of the mean light", abs(float(shown.mean()) - float(light.mean())), 0.05)
wt.check_at_least("caustics: brightest over darkest", float(shown.max() / shown.min()), 1.4)

# Foam lies where the water is shallow, and on the crests of steep waves; nowhere else.
made = wt.View(SIZE, (0, 0, 0))
bed = wt.box((0, 0, -0.5), (40, 40, 1))
points = bed.GetPoints()
for i in range(points.GetNumberOfPoints()):  # a slope: 1 m deep at x = 5, dry from x = -5 on
    px, py, pz = points.GetPoint(i)
    points.SetPoint(i, px, py, pz - 0.1 * (px + 5))
wt.add_actor(made.renderer, bed, (0.2, 0.1, 0.1), lit=False)
wt.add_scene_light(made.renderer, (0, 0, 1))
water = dark_water(made)
look = water.GetWaterProperty()
look.RefractionOn()
look.SetFoamDepth(0.4)
look_at(made, (0, 0, 25), up=(0, 1, 0))
row = made.picture()[100:120, :, 2].mean(axis=0)
at = (np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2) * 2 * 25 * np.tan(np.radians(15)) / SIZE[1]
depth = 0.1 * (at + 5)
wt.check_at_least("foam: mean of 255 where the water is under 8 cm", float(row[(depth > 0) & (depth < 0.08)].mean()), 180)
wt.check_at_most("foam: mean of 255 where it is over 40 cm", float(row[depth > 0.42].mean()), 45)
# Deep water has none, even where its pixels share their samples with a thing that hangs in the air.
made = wt.View(SIZE, (0, 0, 0), samples=8)
wt.add_actor(made.renderer, wt.box((0, 0, -4), (400, 400, 1)), (0, 0, 0), lit=False)
wt.add_actor(made.renderer, wt.box((0, 0, 1.5), (3, 3, 1)), (0, 0, 0), lit=False)
wt.add_scene_light(made.renderer, (0, 0, 1))
look = dark_water(made).GetWaterProperty()
look.GlitterOff()
look.RefractionOn()
look.SetFoamDepth(0.4)
look_at(made, (9, -14, 7))
wt.check_equal("foam round a thing in the air: brightest pixel", int(made.picture().max()), 0)
made = wt.View(SIZE, (0, 0, 0))
wt.add_scene_light(made.renderer, (0, 0, 1))
water = dark_water(made)
look = water.GetWaterProperty()
look.GlitterOff()
look.AddWave(0.3, 2 * np.pi, 0.0, 0.0, 1.0)  # k A Q = 0.3: crests stand at 0.7 of the rest
look_at(made, (0, 0, 40), up=(0, 1, 0))
wt.check_equal("foam on crests: none by default", int(made.picture().max()), 0)
look.SetFoamStretch(1.0)
row = made.picture()[:, :, 0].mean(axis=0)
at = (np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2) * 2 * 40 * np.tan(np.radians(15)) / SIZE[1]
is_crest = np.abs((at - np.pi / 2 + np.pi) % (2 * np.pi) - np.pi) < 0.4
is_trough = np.abs((at + np.pi / 2 + np.pi) % (2 * np.pi) - np.pi) < 1.0
wt.check_at_least("foam on crests: mean of 255 there over that of the troughs",
                  float(row[is_crest].mean()) - float(row[is_trough].mean()), 20)
wt.check_equal("foam on crests: brightest trough", int(row[is_trough].max()), 0)

# A static environment: the texel in the reflected direction, and nothing is rendered for it.
width, height = 512, 256
u, v = np.meshgrid((np.arange(width) + 0.5) / width, (np.arange(height) + 0.5) / height)
texels = np.stack([255 * u, 255 * v, 128 + 127 * np.sin(6 * np.pi * u)], axis=2).astype(np.uint8)
image = vtkImageData()
image.SetDimensions(width, height, 1)
image.GetPointData().SetScalars(numpy_to_vtk(texels.reshape(-1, 3), deep=True))
texture = vtkTexture()
texture.SetInputData(image)
texture.InterpolateOn()
for waves in ((), ((0.02, 2.0, 20.0, 10.0),)):
    made = wt.View(SIZE, (0, 0, 0))
    wt.add_actor(made.renderer, wt.box((0, 3, 1), (1, 1, 1)), (1, 1, 1), lit=False)
    made.renderer.SetEnvironmentUp(0, 0, 1)
    made.renderer.SetEnvironmentRight(1, 0, 0)
    water = dark_water(made, 1.0)
    look = water.GetWaterProperty()
    look.SetReflectionSourceToEnvironment()
    look.SetEnvironmentTexture(texture)
    for wave in waves:
        look.AddWave(*wave)
    camera = look_at(made, (1, -10, 4), (1, 0, 0))
    place, ray = pixel_rays(camera)
    _, sx, sy = ray_caster.heights_and_slopes(waves, place[:, 0], place[:, 1], 0.0)
    normal = np.stack([-sx, -sy, np.ones_like(sx)], axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    away = ray - 2 * (ray * normal).sum(axis=1, keepdims=True) * normal
    right, up, back = away[:, 0], np.abs(away[:, 2]), -away[:, 1]  # right x up
    expected_u = 0.5 + np.arctan2(back, right) / (2 * np.pi)
    expected_v = 0.5 + np.arctan2(up, np.hypot(right, back)) / np.pi
    shown = made.picture().reshape(-1, 3)
    wt.check_equal(f"environment, {len(waves)} waves: mirrored views",
                   water.GetReflectionPass().GetNumberOfReflectionRenders(), 0)
    wt.check_equal(f"environment, {len(waves)} waves: decision", water.GetReflectionPass().GetDecision(),
                   vtkWaterReflectionPass.STATIC_ENVIRONMENT)
    mask = wt.water_mask(made, water).ravel() & (ray[:, 2] < -0.1)
    error = np.maximum(np.abs(shown[:, 0] - 255 * expected_u), np.abs(shown[:, 1] - 255 * expected_v))[mask]
    wt.check_at_most(f"environment, {len(waves)} waves: error of 255, 99 % of the water", float(np.percentile(error, 99)), 2.0)
look.SetEnvironmentTexture(None)
made.renderer.SetBackground(0.2, 0.4, 0.6)
wt.check_at_most("environment without a texture: error from the background",
                 float(np.abs(made.picture().reshape(-1, 3)[mask] - 255 * np.array((0.2, 0.4, 0.6))).max()), 1.0)

# Bad input.
cube = vtkTexture()
cube.CubeMapOn()
for setter, value, words in (("SetSlopeVariance", (-0.1, 0.1), ("-0.1", "not negative")),
                             ("SetSlopeVariance", (0.1, float("nan")), ("nan", "finite")),
                             ("SetSlopeVarianceToWind", (0.0,), ("0 m/s", "[0.1, 100]")),
                             ("SetFoamDepth", (-1.0,), ("-1", "[0,")),
                             ("SetFoamStretch", (1.5,), ("1.5", "[0, 1]")),
                             ("SetFoamColor", (0.0, 2.0, 0.0), ("2", "[0, 1]")),
                             ("SetShoreSoftness", (float("nan"),), ("nan", "[0,")),
                             ("SetCaustics", (2.0,), ("2", "[0, 1]")),
                             ("SetReflectionSource", (2,), ("2", "[0, 1]")),
                             ("SetEnvironmentTexture", (cube,), ("cube map", "latitude"))):
    look = vtkWaterProperty()
    before = str(look).split("ReflectanceMode")[1]
    errors = wt.errors_of(look)
    getattr(look, setter)(*value)
    wt.check_equal(f"{setter}{value}: errors", len(errors), 1)
    for word in words:
        wt.check_equal(f"{setter}{value}: the error says '{word}'", word in "".join(errors), True)
    wt.check_equal(f"{setter}{value}: all stays", str(look).split("ReflectanceMode")[1] == before, True)
wt.finish()

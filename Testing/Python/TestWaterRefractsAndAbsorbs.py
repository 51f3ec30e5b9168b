# SPDX-License-Identifier: BSD-3-Clause
"""What is seen through the surface is what the laws of refraction, absorption and total reflection, and a ray
caster, say; from above and from below."""

import numpy as np
import pytest
import ray_caster
import water_test as wt
from vtkwater import vtkWaterProperty
from wave_scenes import rmse

INDEX = 1.333
SIZE = (304, 228)
MIDDLE = (slice(76, 152), slice(76, 228))  # of the picture
SKY, BED = (0.6, 0.75, 0.9), (0.7, 0.65, 0.5)
ABSORPTION, DEEP = np.array((0.35, 0.12, 0.06)), np.array((0.02, 0.10, 0.16))
RIPPLES = ((0.0127, 2.0, 20.0, 10.0), (0.0064, 1.2, 80.0, 200.0))
ANGLES = (0, 5, 10, 20, 30, 40, 45, 48, 48.5, 48.7, 49, 55, 60, 65, 70, 75, 80, 82, 84, 86, 88, 89, 89.5, 89.9)


def look_at(made, position, target=(0, 0, 0), angle=30, up=(0, 0, 1), parallel=0):
    camera = wt.place_camera(made.renderer, position, target, (0.1, 400), view_up=up)
    camera.SetViewAngle(angle)
    camera.SetParallelProjection(parallel > 0)
    if parallel:
        camera.SetParallelScale(parallel)
    return camera


def clear_water(made, absorption, deep=(0, 0, 0), reflectance=0.0, scattering=(0, 0, 0)):
    water = wt.add_water(made.renderer, None, (-200, 200, -200, 200), reflectance)
    look = water.GetWaterProperty()
    look.RefractionOn()
    look.SetAbsorption(absorption)
    look.SetScattering(scattering)
    look.SetDeepColor(deep)
    look.SetIndexOfRefraction(INDEX)
    return water


def rays_of(camera, samples=1, size=SIZE):
    start, ray = ray_caster.eye_rays(camera, size, samples)
    with np.errstate(divide="ignore"):
        to_water = np.where(ray[:, 2] < 0, -start[:, 2] / ray[:, 2], np.inf)
    return start, ray, to_water


def refracted(ray, normal, ratio):
    """Unit rays beyond the surface; NaN where all is reflected."""
    cosine = -(ray * normal).sum(axis=1, keepdims=True)
    under = 1 - ratio**2 * (1 - cosine**2)
    with np.errstate(invalid="ignore"):
        return ratio * ray + (ratio * cosine - np.sqrt(under)) * normal


@pytest.mark.parametrize("name, position, parallel", (("45 degrees", (0, -8, 8), 0), ("low", (0, -12, 2), 0),
                                                      ("high", (0.5, -1, 12), 0), ("parallel", (0, -8, 6), 3)),
                         ids=("45_degrees", "low", "high", "parallel"))
def test_a_pool_absorbs_along_the_refracted_ray(name, position, parallel):
    """In a pool of constant depth, what is left of a white bed is exp(-a d / cos of the refracted ray)."""
    made = wt.View(SIZE, (0, 0, 0))
    wt.add_actor(made.renderer, wt.box((0, 0, -2.5), (398, 398, 1)), (1, 1, 1), lit=False)
    clear_water(made, (0.02, 0.1, 0.3))
    camera = look_at(made, position, parallel=parallel)
    picture = made.picture()
    _, ray, to_water = rays_of(camera)
    cosine = np.sqrt(1 - (1 - ray[:, 2] ** 2) / INDEX**2)
    # beyond, a pixel is so long on the bed that its depth is one of many
    good = np.isfinite(to_water) & (to_water < 25)
    expected = np.exp(-np.array((0.02, 0.1, 0.3)) * 2.0 / cosine[:, None])[good]
    found = picture.reshape(-1, 3)[good] / 255
    for i, channel in enumerate("rgb"):
        # the mean over many pixels is finer than the steps of 1 / 255, unless all are alike
        error = abs(float(found[:, i].mean() / expected[:, i].mean()) - 1)
        step = 0.5 / 255 / expected[:, i].mean() if parallel else 0
        wt.check_at_most(f"pool, {name}, {channel}: error of the mean transmittance", error, max(0.005, step))
    wt.check_at_most(f"pool, {name}: largest error of a pixel", float(np.abs(found - expected).max()),
                     0.6 / 255 + 0.005)


def test_scattering_dims_and_turns_into_the_deep_colour():
    """Scattering dims like absorption, and what is lost turns into the deep colour."""
    made = wt.View(SIZE, (0, 0, 0))
    wt.add_actor(made.renderer, wt.box((0, 0, -2.5), (398, 398, 1)), (1, 0, 0), lit=False)
    clear_water(made, (0.1, 0.1, 0.1), (0, 0.8, 0), scattering=(0.2, 0.2, 0.2))
    look_at(made, (0, 0, 10), up=(0, 1, 0))
    left = np.exp(-0.3 * 2)
    wt.check_at_most("deep colour over 2 m: error of 255",
                     float(np.abs(made.picture()[150, 200] - 255 * np.array((left, 0.8 * (1 - left), 0))).max()), 1.0)


def apparent_column(height, depth, x):
    """Column, in pixels, at which an eye over the middle sees a mark at x on the bed."""
    low, high = 0.0, x
    for _ in range(200):  # where on the surface the ray enters: sines by Snell's law
        middle = 0.5 * (low + high)
        above = middle / np.hypot(middle, height)
        below = (x - middle) / np.hypot(x - middle, depth)
        low, high = (middle, high) if above < INDEX * below else (low, middle)
    return SIZE[0] / 2 + SIZE[1] / 2 / np.tan(np.radians(15)) * low / height


@pytest.mark.parametrize("x", (0.3, 1.2, 2.2))
@pytest.mark.parametrize("depth", (0.5, 2.0, 6.0))
def test_a_mark_on_the_bed_is_seen_by_snells_law(depth, x):
    """A mark on the bed has the apparent place that Snell's law gives it: d / n straight down."""
    made = wt.View(SIZE, (0, 0, 0))
    wt.add_actor(made.renderer, wt.box((x - 50, 0, -depth - 0.5), (100, 100, 1)), (1, 1, 1), lit=False)
    wt.add_actor(made.renderer, wt.box((x + 50, 0, -depth - 0.5), (100, 100, 1)), (1, 0, 0), lit=False)
    clear_water(made, (0, 0, 0))
    look_at(made, (0, 0, 10), up=(0, 1, 0))
    row = made.picture()[150, :, 1]
    found = np.nonzero(row < 128)[0]
    wt.check_at_most(f"mark at {x} m, {depth} m deep: error of its apparent place, px",
                     abs(float(found[0] if len(found) else SIZE[0]) - apparent_column(10, depth, x)), 1.0)


def things_in_water():
    things = [ray_caster.Box((0, 0, -3.5), (399, 399, 1), BED)]
    for i in range(7):
        center = (-4 + 1.4 * i, -1 + 1.1 * (i % 3), -2.4 + 0.2 * i)
        things.append(ray_caster.Sphere(center, 0.55, (0.2 + 0.1 * i, 0.3, 0.8 - 0.1 * i)))
    for i in range(4):  # they stand in the water
        things.append(ray_caster.Box((-3 + 2.1 * i, 2.5 - 0.8 * i, -1), (0.3, 0.3, 5), (0.8, 0.3 + 0.1 * i, 0.2)))
    return things


def truth_of(things, camera, waves=(), samples=4, size=SIZE):
    """The ray caster's picture, of 255, and which of its pixels show nothing but water."""
    start, ray, to_water = rays_of(camera, samples, size)
    colors, distance = ray_caster.cast(things, SKY, start, ray)
    is_water = to_water < distance
    point = start[is_water] + to_water[is_water][:, None] * ray[is_water]
    point[:, 2] = 0
    _, slope_x, slope_y = ray_caster.heights_and_slopes(waves, point[:, 0], point[:, 1], 0.0)
    normal = np.stack([-slope_x, -slope_y, np.ones_like(slope_x)], axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    seen, way = ray_caster.cast(things, DEEP, point, refracted(ray[is_water], normal, 1 / INDEX))
    left = np.exp(-ABSORPTION * np.where(np.isfinite(way), way, 1e9)[:, None])
    colors[is_water] = left * seen + (1 - left) * DEEP
    shape = (size[1], samples, size[0], samples)
    return 255 * colors.reshape(*shape, 3).mean(axis=(1, 3)), is_water.reshape(shape).all(axis=(1, 3))


@pytest.mark.parametrize("name, position, parallel, waves", (
    ("high", (1, -9, 9), 0, ()), ("parallel", (1, -9, 8), 4, ()), ("middle, waves", (2, -13, 5), 0, RIPPLES)),
    ids=("high", "parallel", "middle_with_waves"))
def test_a_scene_under_water_is_the_ray_casters(name, position, parallel, waves):
    """A scene under water is a ray caster's picture; water that reflects nothing renders no mirrored view."""
    made, things = wt.View(SIZE, SKY), things_in_water()
    for thing in things:
        data = (wt.box(0.5 * (thing.low + thing.high), thing.high - thing.low) if isinstance(thing, ray_caster.Box)
                else wt.sphere(thing.center, thing.radius, 96))
        wt.add_actor(made.renderer, data, thing.color, lit=False)
    water = clear_water(made, ABSORPTION, DEEP)
    camera = look_at(made, position, parallel=parallel)
    for wave in waves:
        water.GetWaterProperty().AddWave(*wave)
    truth, mask = truth_of(things, camera, waves)
    once, _ = truth_of(things, camera, waves, 1)
    picture = made.picture()
    mask &= wt.water_mask(made, water)
    path = str(wt.output_folder() / f"TestWaterRefractsAndAbsorbs-{name.replace(', ', '-')}")
    wt.save(picture, path + ".png")
    wt.save(np.clip(truth, 0, 255), path + "-truth.png")
    error = rmse(picture, truth, mask)
    water.GetWaterProperty().SetIndexOfRefraction(1.0)  # straight through: what plain blending shows
    straight = rmse(made.picture(), truth, mask)
    print(f"{name}: RMSE of 255 refracted {error:.2f}, straight through {straight:.2f}, "
          f"a perfect tracer at one sample a pixel {rmse(once, truth, mask):.2f}")
    wt.check_at_least(f"{name}: RMSE straight through / refracted", straight / error, 4.0)
    wt.check_at_least(f"{name}: % of the water within 4 of 255 of the ray caster",
                      100 * float((np.abs(picture - truth).max(axis=2) <= 4)[mask].mean()), 97)
    if not waves:
        wt.check_equal(f"{name}: mirrored views rendered without a reflectance",
                       water.GetReflectionPass().GetNumberOfReflectionRenders(), 0)


@pytest.mark.parametrize("distance", (1.0, 4.0, 12.0))
def test_an_eye_in_the_water_sees_a_wall_through_it(distance):
    """An eye in the water sees a white wall through the water between, and nothing of the far side."""
    made = wt.View(SIZE, SKY)
    wt.add_actor(made.renderer, wt.box((0, distance + 0.5, -5), (300, 1, 9)), (1, 1, 1), lit=False)
    clear_water(made, ABSORPTION, DEEP)
    camera = look_at(made, (0, 0, -5), (0, 1, -5))
    _, ray = ray_caster.eye_rays(camera, SIZE, 1)
    left = np.exp(-ABSORPTION * (distance / ray[:, 1])[:, None])
    expected = 255 * (left + (1 - left) * DEEP)
    wt.check_at_most(f"under water, a wall {distance:g} m away: error of 255, 99 % of the pixels",
                     float(np.percentile(np.abs(made.picture().reshape(-1, 3) - expected), 99)), 1.0)


@pytest.mark.parametrize("name, position, target, expected", (
    ("under water, looking down: error of the deep colour", (0, 0, -5), (0, 1, -7), DEEP),  # into nothing
    ("over water, looking up: error of the sky", (0, 0, 5), (0, 1, 7), SKY),
    ("beside the water: error of the sky", (0, 300, -5), (0, 301, -5), SKY),  # lower than it
), ids=("under_water", "over_water", "beside_the_water"))
def test_an_eye_that_does_not_see_the_sheet_knows_where_it_is(name, position, target, expected):
    """Where the sheet itself is out of view, the eye is in the water only if it is under the sheet."""
    made = wt.View(SIZE, SKY)
    wt.add_actor(made.renderer, wt.box((0, 0, -9.5), (1, 1, 1)), (1, 1, 1), lit=False)
    clear_water(made, ABSORPTION, DEEP)
    look_at(made, position, target)
    wt.check_at_most(name, float(np.abs(made.picture()[MIDDLE] - 255 * np.array(expected)).max()), 1.0)


def test_from_under_water_things_in_the_air_stand_where_the_ray_meets_them():
    """From under water things in the air stand where the refracted ray meets them, and not straight ahead."""
    balls = [ray_caster.Sphere((-2.0 + 1.5 * i, 2.5 + 0.5 * i, 2.0 + 0.4 * i), 0.6, (0.8, 0.2 + 0.2 * i, 0.2))
             for i in range(4)]
    made = wt.View(SIZE, SKY)
    for ball in balls:
        wt.add_actor(made.renderer, wt.sphere(ball.center, ball.radius, 96), ball.color, lit=False)
    water = clear_water(made, (0, 0, 0), DEEP)
    camera = look_at(made, (0, -0.5, -4), (0, 2.0, 2), angle=60)
    start, ray = ray_caster.eye_rays(camera, SIZE, 1)
    point = start - (start[:, 2] / ray[:, 2])[:, None] * ray
    point[:, 2] = 0
    beyond = refracted(ray, np.array((0, 0, -1.0)), INDEX)
    is_window = np.isfinite(beyond).all(axis=1) & (ray[:, 2] > 0)
    truth = np.tile(DEEP, (len(ray), 1))
    truth[is_window] = ray_caster.cast(balls, SKY, point[is_window], beyond[is_window])[0]
    difference = np.abs(made.picture().reshape(-1, 3) - 255 * truth).max(axis=1)
    is_ball = is_window & (np.abs(truth - SKY).max(axis=1) > 0.1)
    wt.check_at_least("from under water: pixels of things in the air", int(is_ball.sum()), 1000)
    wt.check_at_least("from under water: % of the window within 4 of 255 of the ray caster",
                      100 * float((difference <= 4)[is_window].mean()), 95)
    water.GetWaterProperty().SetIndexOfRefraction(1.0)
    straight = np.abs(made.picture().reshape(-1, 3) - 255 * truth).max(axis=1)
    wt.check_at_most("from under water, straight through: % of the things within 4 of 255",
                     100 * float((straight <= 4)[is_ball].mean()), 60)


def reflectance_at(angle, below):
    """The reflectance that the shader has at an angle of incidence."""
    made = wt.View((41, 41), (1, 1, 1))
    water = wt.add_water(made.renderer, None, (-4000, 4000, -4000, 4000), None)
    water.GetWaterProperty().SetOutputToReflectance()
    turn = np.radians(angle)
    camera = look_at(made, (0, -10 * np.sin(turn), 10 * np.cos(turn) * (-1 if below else 1)),
                     angle=0.02, up=(0, 1, 0) if angle < 45 else (0, 0, 1))
    camera.SetClippingRange(1, 40)
    red, green, _ = made.picture()[20, 20]
    return (256 * red + green) / 65535


def reflectance_of(angle, ratio):
    """Born and Wolf, 1.5.2, eq. 21a."""
    into = np.radians(angle)
    sine = np.sin(into) / ratio
    if sine >= 1:
        return 1.0
    if angle == 0:
        return ((ratio - 1) / (ratio + 1)) ** 2
    out = np.arcsin(sine)
    return 0.5 * ((np.sin(into - out) / np.sin(into + out)) ** 2 + (np.tan(into - out) / np.tan(into + out)) ** 2)


@pytest.mark.parametrize("side, ratio", (("above", INDEX), ("below", 1 / INDEX)), ids=("above", "below"))
def test_the_reflectance_is_fresnels_from_either_side(side, ratio):
    """The reflectance that the shader has is Fresnel's, from above and from below, up to total reflection."""
    worst = max(abs(reflectance_at(angle, side == "below") - reflectance_of(angle, ratio)) for angle in ANGLES)
    wt.check_at_most(f"Fresnel from {side}, 0 to 89.9 degrees: largest error", worst, 1e-3)


def test_snells_window_is_a_disc_of_48_6_degrees():
    """From under water the world above lies in a disc of 48.6 degrees; beyond it, all is reflected."""
    made = wt.View((801, 801), (1, 1, 1))
    water = clear_water(made, (0, 0, 0), reflectance=None)
    water.GetWaterProperty().SetOutputToReflectance()
    look_at(made, (0, 0, -10), angle=110, up=(0, 1, 0))
    row = made.picture()[400]
    total = 256 * row[:, 0] + row[:, 1] == 65535
    inside = np.nonzero(~total)[0]
    radius = np.degrees(np.arctan(0.5 * (inside[-1] - inside[0] + 1) / 400.5 * np.tan(np.radians(55))))
    wt.check_at_most(f"window of {radius:.3f} degrees: error", abs(radius - np.degrees(np.arcsin(1 / INDEX))), 0.1)


REFUSALS = (
    ("SetAbsorption", (0.1, float("nan"), 0.1), ("nan", "not negative")),
    ("SetAbsorption", (-1, 0, 0), ("-1", "not negative")),
    ("SetScattering", (0, 0, float("inf")), ("inf", "finite")),
    ("SetIndexOfRefraction", (0.9,), ("0.9", "[1, 10]")),
    ("SetIndexOfRefraction", (float("nan"),), ("nan", "[1, 10]")),
    ("SetWaterType", ("IX",), ("IX", "9C")),
    ("SetPreset", ("sea",), ("sea", "turbid river")),
)


@pytest.mark.parametrize("setter, value, words", REFUSALS,
                         ids=[f"{setter}_{words[0]}" for setter, _, words in REFUSALS])
def test_a_bad_value_is_refused(setter, value, words):
    """Bad input is one error that names value and range; the last good value stays."""
    look = vtkWaterProperty()
    before = str(look)
    errors = wt.errors_of(look)
    getattr(look, setter)(*value)
    wt.check_equal(f"{setter}{value}: errors", len(errors), 1)
    for word in words:
        wt.check_equal(f"{setter}{value}: the error says '{word}'", word in "".join(errors), True)
    stays = str(look).split("ReflectanceMode")[1] == before.split("ReflectanceMode")[1]
    wt.check_equal(f"{setter}{value}: all stays", stays, True)

# SPDX-License-Identifier: BSD-3-Clause
"""How far, in pixels, from the right place of the mirrored view a wave's reflection is looked up.

Smooth islands in waves. The ray caster follows a pixel's reflected ray to what it meets; the right
place is where the mirrored view shows that point. Counted are rays that meet an island at a point
which the mirrored view sees and has on its picture: nothing can be looked up of the others. The ray
caster has the normals of the surface under test: a wave that is short against a pixel counts by its
mean over the pixel, exp(-(turn per pixel)^2 / 24).
"""

import numpy as np
import ray_caster
import water_test as wt

SIZE = (240, 180)
ISLANDS = tuple(
    ray_caster.Sphere(center, radius, color)
    for center, radius, color in (
        ((-3.0, 2.0, -2.4), 3.2, (0.2, 0.5, 0.2)),
        ((2.5, 4.0, -4.0), 5.5, (0.4, 0.4, 0.2)),
        ((0.5, -1.5, -1.6), 2.0, (0.6, 0.5, 0.4)),
        ((-8.0, 14.0, -6.0), 10.0, (0.3, 0.3, 0.5)),
        ((9.0, 18.0, -9.0), 13.0, (0.5, 0.3, 0.3)),
    )
)
# wavelength, direction, phase; the amplitudes make the slopes alike
WAVES = ((2.0, 20.0, 10.0), (1.2, 80.0, 200.0), (0.75, 140.0, 90.0))
VIEWS = {"middle": (2, -13, 4), "low": (3, -12, 1.2), "high": (1, -9, 9)}


def waves_of(slope_rms):
    each = slope_rms * np.sqrt(2.0 / len(WAVES))
    return tuple((each * length / (2 * np.pi), length, direction, phase) for length, direction, phase in WAVES)


def scene(position, waves):
    made = wt.View(SIZE, (0.55, 0.7, 0.9))
    for island in ISLANDS:
        wt.add_actor(made.renderer, wt.sphere(island.center, island.radius, 200), island.color, lit=False)
    water = wt.add_water(made.renderer, None, (-200, 200, -200, 200))
    for wave in waves:
        water.GetWaterProperty().AddWave(*wave)
    camera = made.renderer.GetActiveCamera()
    camera.SetPosition(position)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    camera.SetClippingRange(0.5, 150)
    return made, water


def map_places(camera, water, points):
    """Where the mirrored view shows points of the world: u, v in [0, 1] of its texture."""
    matrix = camera.GetCompositeProjectionTransformMatrix(SIZE[0] / SIZE[1], -1, 1)
    to_clip = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    mirrored = np.concatenate([points * (1, 1, -1), np.ones((len(points), 1))], axis=1)
    clip = mirrored @ to_clip.T
    ndc = clip[:, :2] / clip[:, 3:] * (-1, 1)
    texture = water.GetReflectionPass().GetReflectionTexture()
    texture_size = np.array((texture.GetWidth(), texture.GetHeight()))
    return 0.5 + 0.5 * ndc * np.array(SIZE) / texture_size, texture_size


def mean_slopes(waves, place):
    across = np.repeat(place[:, 1::2] - place[:, ::2], 2, axis=1)[..., :2]  # pixels go by fours
    down = np.repeat(place[1::2] - place[::2], 2, axis=0)[..., :2]
    slopes = [np.zeros(place.shape[0] * place.shape[1]) for _ in range(2)]
    for wave in waves:
        k = 2 * np.pi / wave[1]
        direction = k * np.array((np.cos(np.radians(wave[2])), np.sin(np.radians(wave[2]))))
        seen = np.exp(-((across @ direction) ** 2 + (down @ direction) ** 2) / 24).ravel()
        _, *own = ray_caster.heights_and_slopes((wave,), place[..., 0].ravel(), place[..., 1].ravel(), 0.0)
        for total, slope in zip(slopes, own):
            total += seen * slope
    return slopes


def truth(camera, water, waves):
    """For every pixel of the picture: the right place in the map, and whether it counts."""
    start, ray = ray_caster.eye_rays(camera, SIZE, 1)
    _, distance = ray_caster.cast(ISLANDS, (0, 0, 0), start, ray)
    with np.errstate(divide="ignore"):
        to_water = np.where(ray[:, 2] < 0, -start[:, 2] / ray[:, 2], np.inf)
    counts = to_water < np.minimum(distance, 150)
    place = start + np.where(np.isfinite(to_water), to_water, 0)[:, None] * ray
    slope_x, slope_y = mean_slopes(waves, place.reshape(SIZE[1], SIZE[0], 3))
    normal = np.stack([-slope_x, -slope_y, np.ones_like(slope_x)], axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    away = ray - 2 * (ray * normal).sum(axis=1, keepdims=True) * normal
    place[:, 2] = 1e-9
    _, length = ray_caster.cast(ISLANDS, (0, 0, 0), place, away)
    counts &= (away[:, 2] > 0) & np.isfinite(length)
    met = place + np.where(counts, length, 0)[:, None] * away
    # the mirrored eye looks at it from below, through the water
    below = np.asarray(camera.GetPosition()) * (1, 1, -1)
    look = met - below
    with np.errstate(divide="ignore", invalid="ignore"):
        enters = np.where(look[:, 2] > 0, -below[2] / look[:, 2], 0)
    through = below + enters[:, None] * look
    way = np.linalg.norm(met - through, axis=1)
    direction = look / np.linalg.norm(look, axis=1, keepdims=True)
    _, free = ray_caster.cast(ISLANDS, (0, 0, 0), through + 1e-9 * direction, direction)
    counts &= free > way - 1e-3
    right, texture_size = map_places(camera, water, met)
    counts &= ((right > 0) & (right < 1)).all(axis=1)
    return right, counts, texture_size


def looked_up(made, water):
    water.GetWaterProperty().SetOutputToLookup()
    red, green, blue = (made.picture()[:, :, i].ravel() for i in range(3))
    water.GetWaterProperty().SetOutputToColor()
    return np.stack([red * 16 + green // 16, green % 16 * 256 + blue], axis=1) / 4095.0


class Suite:
    """All views with waves of a slope, and the truth of each."""

    def __init__(self, slope_rms):
        waves = waves_of(slope_rms)
        self.cases = []
        for position in VIEWS.values():
            made, water = scene(position, waves)
            made.picture()
            is_water = wt.water_mask(made, water).ravel()
            right, counts, texture_size = truth(made.renderer.GetActiveCamera(), water, waves)
            self.cases.append((made, water, right, counts & is_water, texture_size))

    def errors(self, setter, scale=0.0):
        """Distances, in pixels, of the lookups from their right places."""
        found = []
        for made, water, right, counts, texture_size in self.cases:
            getattr(water.GetWaterProperty(), setter)()
            water.GetWaterProperty().SetOffsetScale(scale)
            found.append(np.linalg.norm((looked_up(made, water) - right) * texture_size, axis=1)[counts])
        return np.concatenate(found)


def describe(errors):
    return (f"median {np.median(errors):.3f} px, 95 % within {np.percentile(errors, 95):.2f} px, "
            f"{100 * (errors < 2).mean():.2f} % under 2 px, {len(errors)} pixels")


# rms slope of the waves, least share of pixels under 2 px
for slope_rms, share in ((0.05, 97), (0.10, 96)):
    suite = Suite(slope_rms)
    for lookup, scales in (("FixedOffset", np.linspace(0, 1, 11)), ("ViewScaledOffset", np.linspace(0, 10, 11))):
        best = min((suite.errors(f"SetLookupTo{lookup}", scale) for scale in scales), key=np.median)
        print(f"slope {slope_rms}: {lookup}, the best of {len(scales)} scales: {describe(best)}")
    suite.errors("SetLookupToRayTraced")
    for quality in ("Fast", "High"):
        print(f"slope {slope_rms}: {quality}: {describe(suite.errors('SetRayTraceQualityTo' + quality))}")
    errors = suite.errors("SetRayTraceQualityToDefault")
    name = f"slope {slope_rms}, default quality"
    print(f"{name}: {describe(errors)}")
    wt.check_at_least(f"{name}: pixels", len(errors), 5000)
    wt.check_at_most(f"{name}: median error, px", float(np.median(errors)), 0.1)
    wt.check_at_least(f"{name}: % under 2 px", 100 * float((errors < 2).mean()), share)
    if slope_rms == 0.05:
        wt.check_at_most(f"{name}: 95 % within, px", float(np.percentile(errors, 95)), 0.5)
wt.finish()

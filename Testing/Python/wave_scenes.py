# SPDX-License-Identifier: BSD-3-Clause
"""wave_scenes: the two scenes that reflections on waves are measured in, and how to read a lookup back.

islands  smooth spheres in the water: how far from its right place a reflection is looked up
posts    poles, boxes and floating things with hard edges: colour

Both are unlit, in water at z = 0 that reflects everything. Colours are whole 255ths: a picture of 8 bits
can be right.
"""

import numpy as np
import ray_caster
import water_test as wt


def _color(red, green, blue):
    return (red / 255, green / 255, blue / 255)


SKY = _color(140, 178, 230)

ISLANDS_SIZE = (240, 180)
ISLANDS_VIEWS = {"middle": (2, -13, 4), "low": (3, -12, 1.2), "high": (1, -9, 9)}
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
ISLANDS_WAVES = ((2.0, 20.0, 10.0), (1.2, 80.0, 200.0), (0.75, 140.0, 90.0))

POSTS_SIZE = (400, 300)
POSTS_VIEWS = {"middle": ((2, -13, 4), 30), "low": ((3, -12, 1.2), 30), "high": ((1, -9, 9), 35)}
# amplitude m, wavelength m, direction and phase in degrees; the slopes add up to 0.10
POSTS_WAVES = ((0.0127, 2.0, 20.0, 10.0), (0.0064, 1.2, 80.0, 200.0), (0.0032, 0.75, 140.0, 90.0))


def island_waves(slope_rms):
    each = slope_rms * np.sqrt(2.0 / len(ISLANDS_WAVES))
    return tuple((each * length / (2 * np.pi), length, direction, phase) for length, direction, phase in ISLANDS_WAVES)


def island_scene(view, waves):
    made = wt.View(ISLANDS_SIZE, SKY)
    for island in ISLANDS:
        wt.add_actor(made.renderer, wt.sphere(island.center, island.radius, 200), island.color, lit=False)
    return made, _add_water(made, waves, 200, ISLANDS_VIEWS[view])


def posts():
    colors = [_color(*rgb) for rgb in ((217, 51, 38), (242, 217, 77), (38, 128, 51), (230, 230, 230), (64, 51, 153))]
    made = []
    for i in range(9):  # poles
        x, y = -6 + 1.6 * i, -3 + 2.9 * (i % 4)
        made.append(ray_caster.Box((x, y, 1), (0.22, 0.22, 3 + 0.5 * (i % 3)), colors[i % 5]))
    for i in range(6):  # boxes in the water
        lengths = (0.9, 0.7, 0.9 + 0.3 * (i % 2))
        made.append(ray_caster.Box((-5 + 2.1 * i, 4 - 1.1 * i, 0.2), lengths, colors[(i + 2) % 5]))
    for i in range(6):  # things over it
        center = (-4.5 + 1.9 * i, -2 + 1.4 * i, 1.0 + 0.3 * i)
        made.append(ray_caster.Sphere(center, 0.35 + 0.06 * i, colors[(i + 1) % 5]))
    return made


def post_scene(view, waves=POSTS_WAVES, parallel=False, size=POSTS_SIZE):
    made = wt.View(size, SKY)
    for thing in posts():
        if isinstance(thing, ray_caster.Box):
            data = wt.box(0.5 * (thing.low + thing.high), thing.high - thing.low)
        else:
            data = wt.sphere(thing.center, thing.radius, 96)
        wt.add_actor(made.renderer, data, thing.color, lit=False)
    position, angle = POSTS_VIEWS[view]
    water = _add_water(made, waves, 60, position)
    camera = made.renderer.GetActiveCamera()
    camera.SetViewAngle(angle)
    camera.SetParallelProjection(parallel)
    camera.SetParallelScale(4)
    return made, water


def _add_water(made, waves, half_width, position):
    water = wt.add_water(made.renderer, None, (-half_width, half_width, -half_width, half_width))
    for wave in waves:
        water.GetWaterProperty().AddWave(*wave)
    wt.place_camera(made.renderer, position, (0, 0, 0), (0.5, 150))
    return water


def map_places(camera, water, points, size):
    """Where the mirrored view shows points of the world: u, v in [0, 1] of its texture; and the
    texture's size. NaN for a point beside or behind the mirrored eye."""
    matrix = camera.GetCompositeProjectionTransformMatrix(size[0] / size[1], -1, 1)
    to_clip = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    mirrored = np.concatenate([points * (1, 1, -1), np.ones((len(points), 1))], axis=1)
    clip = mirrored @ to_clip.T
    ndc = clip[:, :2] / np.where(clip[:, 3:] > 0, clip[:, 3:], np.nan) * (-1, 1)
    texture = water.GetReflectionPass().GetReflectionTexture()
    texture_size = np.array((texture.GetWidth(), texture.GetHeight()))
    return 0.5 + 0.5 * ndc * np.array(size) / texture_size, texture_size


def mean_slopes(waves, place):
    """Slopes of the surface under test at a picture of places: a wave that is short against a pixel
    counts by its mean over the pixel, exp(-(turn per pixel)^2 / 24)."""
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


def reflected_at(waves, place, ray, size):
    """Directions of a picture's rays, reflected by waves at places of rows x columns, and the normals there."""
    slope_x, slope_y = mean_slopes(waves, place.reshape(size[1], size[0], 3))
    normal = np.stack([-slope_x, -slope_y, np.ones_like(slope_x)], axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    return ray - 2 * (ray * normal).sum(axis=1, keepdims=True) * normal, normal


def map_shows(camera, water, things, points, size, lowest=0.0):
    """Where the mirrored view shows points of things, as map_places; and whether it sees them there.

    The mirrored eye looks from below, through the height at which its view begins: lowest.
    """
    below = np.asarray(camera.GetPosition()) * (1, 1, -1)
    look = points - below
    with np.errstate(divide="ignore", invalid="ignore"):
        enters = np.where(look[:, 2] > 0, (lowest - below[2]) / look[:, 2], 0)
    through = below + np.maximum(enters, 0)[:, None] * look
    way = np.linalg.norm(points - through, axis=1)
    direction = look / np.linalg.norm(look, axis=1, keepdims=True)
    _, free = ray_caster.cast(things, (0, 0, 0), through + 1e-9 * direction, direction)
    right, texture_size = map_places(camera, water, points, size)
    return right, (free > way - 1e-3) & ((right > 0) & (right < 1)).all(axis=1), texture_size


def looked_up(made, water):
    """Where each pixel had its reflection from: u, v of the mirrored view's texture."""
    water.GetWaterProperty().SetOutputToLookup()
    picture = made.picture()
    red, green, blue = (picture[:, :, i].ravel() for i in range(3))
    water.GetWaterProperty().SetOutputToColor()
    return np.stack([red * 16 + green // 16, green % 16 * 256 + blue], axis=1) / 4095.0


def reflected_rays(camera, size, waves):
    """For each pixel, row by row from below: its place on the plane z = 0, and the direction of its reflected ray."""
    x, y = np.meshgrid(*((np.arange(count) + 0.5) / count * 2 - 1 for count in size))
    start, ray = ray_caster.rays_at(camera, size, x.ravel(), y.ravel())
    place = start - (start[:, 2] / ray[:, 2])[:, None] * ray
    _, along_x, along_y = ray_caster.heights_and_slopes(waves, place[:, 0], place[:, 1], 0.0)
    normal = np.stack([-along_x, -along_y, np.ones_like(along_x)], axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    ray = ray / np.linalg.norm(ray, axis=1, keepdims=True)
    away = ray - 2 * (ray * normal).sum(axis=1, keepdims=True) * normal
    away[:, 2] = np.abs(away[:, 2])  # one that would meet the water again is bounced off it once more
    return place, away


def rmse(picture, truth, mask):
    return float(np.sqrt(((picture - truth)[mask] ** 2).mean()))

# SPDX-License-Identifier: BSD-3-Clause
"""ray_caster: the truth for waves: a ray caster in double precision, of spheres and boxes, unlit, opaque or not.

It shares nothing with the code under test: waves, dispersion, reflection and intersections are
written here again, from the definitions in vtkWaterProperty.h.
"""

import numpy as np

GRAVITY = 9.80665  # m/s^2


def dot(a, b):
    return np.einsum("...i,...i", a, b)


class Box:
    def __init__(self, center, lengths, color):
        self.low = np.asarray(center) - 0.5 * np.asarray(lengths)
        self.high = np.asarray(center) + 0.5 * np.asarray(lengths)
        self.color = np.asarray(color)

    def distance(self, start, ray):
        enters, leaves = self.span(start, ray)
        return np.where((enters <= leaves) & (leaves > 1e-9), np.maximum(enters, 0), np.inf)

    def span(self, start, ray):
        """Where rays are between the sides of all three axes, if the first value is the smaller one."""
        enters, leaves = np.full(ray.shape[:-1], -np.inf), np.full(ray.shape[:-1], np.inf)
        for axis in range(3):  # much faster than reductions over three values
            with np.errstate(divide="ignore", invalid="ignore"):
                first = (self.low[axis] - start[..., axis]) / ray[..., axis]
                second = (self.high[axis] - start[..., axis]) / ray[..., axis]
            enters = np.maximum(enters, np.minimum(first, second))
            leaves = np.minimum(leaves, np.maximum(first, second))
        return enters, leaves

    def crossings(self, start, ray):
        """Where rays enter and leave, before their start, too; inf: they do not."""
        enters, leaves = self.span(start, ray)
        return np.where(enters <= leaves, (enters, leaves), np.inf)


class Sphere:
    def __init__(self, center, radius, color):
        self.center, self.radius, self.color = np.asarray(center), radius, np.asarray(color)

    def distance(self, start, ray):
        arm = start - self.center
        b = dot(arm, ray)
        under = b * b - dot(arm, arm) + self.radius**2
        root = np.sqrt(np.maximum(under, 0))
        near = np.where(-b - root > 1e-9, -b - root, -b + root)
        return np.where((under >= 0) & (near > 1e-9), near, np.inf)

    def crossings(self, start, ray):
        arm = start - self.center
        b = dot(arm, ray)
        under = b * b - dot(arm, arm) + self.radius**2
        root = np.sqrt(np.maximum(under, 0))
        return np.where(under >= 0, (-b - root, -b + root), np.inf)


class Translucent:
    """A thing whose surfaces are translucent, or a volume: opacity of each surface, or per unit of length."""

    def __init__(self, thing, opacity, is_volume=False):
        self.thing, self.opacity, self.is_volume = thing, opacity, is_volume

    def kept(self, start, ray, farthest):
        """Share of the light from behind it, and where rays first meet it (inf: before the farthest nowhere)."""
        places = self.thing.crossings(start, ray)
        is_there = (places > 1e-9) & (places < farthest)
        if self.is_volume:
            enters, leaves = np.clip(np.where(np.isfinite(places), places, 0), 0, farthest)
            return (1 - self.opacity) ** (leaves - enters), np.where(leaves > enters, enters, np.inf)
        return (1 - self.opacity) ** is_there.sum(axis=0), np.where(is_there, places, np.inf).min(axis=0)


BLOCK = 1 << 14  # rays at a time: what they need stays in the processor's cache, which is three times as fast


def in_blocks(function, *arrays):
    """Results of a function of rows, block by block; the rows of all results together."""
    parts = [function(*(np.asfortranarray(array[begin:begin + BLOCK]) for array in arrays))
             for begin in range(0, max(len(arrays[0]), 1), BLOCK)]
    return np.concatenate(parts) if isinstance(parts[0], np.ndarray) else [np.concatenate(each) for each in zip(*parts)]


def cast(things, background, start, ray, clear=()):
    """Colours (n x 3) that rays of unit length see, and the distances to them (inf: background).

    clear: Translucent, none within another; their distances do not count.
    """
    return in_blocks(lambda *rows: _cast(things, background, *rows, clear), start, ray)


def _cast(things, background, start, ray, clear):
    nearest = np.full(len(ray), np.inf)
    colors = np.tile(np.asarray(background, dtype=float), (len(ray), 1))
    for thing in things:
        distance = thing.distance(start, ray)
        closer = distance < nearest
        nearest[closer] = distance[closer]
        colors[closer] = thing.color
    if clear:
        kept, first = zip(*(one.kept(start, ray, nearest) for one in clear))
        kept, tints = np.array(kept), np.array([one.thing.color for one in clear])
        for each in np.argsort(first, axis=0)[::-1]:  # from behind
            share = np.take_along_axis(kept, each[None], axis=0)[0][:, None]
            colors = share * colors + (1 - share) * tints[each]
    return colors, nearest


def angular_frequency(wavelength, depth=np.inf):
    k = 2 * np.pi / wavelength
    return np.sqrt(GRAVITY * k * np.tanh(k * depth))


def phases(waves, x, y, time, depth):
    """Of each sine (amplitude, wavelength, direction and phase in degrees): amplitude, wave vector, angles at places."""
    for amplitude, wavelength, direction, phase in waves:
        k = 2 * np.pi / wavelength
        kx, ky = k * np.cos(np.radians(direction)), k * np.sin(np.radians(direction))
        yield amplitude, kx, ky, kx * x + ky * y + np.radians(phase) - angular_frequency(wavelength, depth) * time


def heights(waves, x, y, time, depth=np.inf):
    """Of sines, by definition."""
    return sum((amplitude * np.sin(angle) for amplitude, _, _, angle in phases(waves, x, y, time, depth)),
               np.zeros_like(x))


def heights_and_slopes(waves, x, y, time, depth=np.inf):
    """Of sines, by definition."""
    height, slope_x, slope_y = heights(waves, x, y, time, depth), np.zeros_like(x), np.zeros_like(x)
    for amplitude, kx, ky, angle in phases(waves, x, y, time, depth):
        cosine = amplitude * np.cos(angle)
        slope_x += kx * cosine
        slope_y += ky * cosine
    return height, slope_x, slope_y


def fresnel(cosine, index=1.333):
    """Reflectance of unpolarised light from above; Born and Wolf, 1.5.2, eq. 21, by amplitudes."""
    inside = np.sqrt(1 - (1 - cosine**2) / index**2)
    s = (cosine - index * inside) / (cosine + index * inside)
    p = (index * cosine - inside) / (index * cosine + inside)
    return 0.5 * (s**2 + p**2)


def eye_rays(camera, size, samples):
    """Start and unit direction of samples x samples rays in every pixel; rows from the bottom."""
    width, height = size
    place = (np.arange(samples) + 0.5) / samples
    x = (np.arange(width)[:, None] + place).ravel() / width * 2 - 1
    y = (np.arange(height)[:, None] + place).ravel() / height * 2 - 1
    x, y = np.meshgrid(x, y)
    return rays_at(camera, size, x.ravel(), y.ravel())


def rays_at(camera, size, x, y):
    """Start and unit direction of rays through places of the picture, x and y in [-1, 1], by the camera's matrices.

    Any camera: off its axis, parallel, rolled. Rays start at the eye, parallel ones in the plane through it.
    """
    projection = _array(camera.GetProjectionTransformMatrix(size[0] / size[1], -1, 1))
    to_world = np.linalg.inv(_array(camera.GetViewTransformMatrix()))
    scale, center = projection[(0, 1), (0, 1)], projection[:2, 3 if camera.GetParallelProjection() else 2]
    place = np.stack([x, y], axis=1)
    if camera.GetParallelProjection():
        start = np.concatenate([(place - center) / scale, np.zeros((len(place), 1))], axis=1)
        ray = np.tile(to_world[:3, :3] @ (0, 0, -1), (len(place), 1))
        return start @ to_world[:3, :3].T + to_world[:3, 3], ray
    ray = np.concatenate([(place + center) / scale, np.full((len(place), 1), -1.0)], axis=1) @ to_world[:3, :3].T
    ray /= np.linalg.norm(ray, axis=1, keepdims=True)
    return np.tile(np.asarray(camera.GetPosition()), (len(ray), 1)), ray


def _array(matrix):
    return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


def meet_waves(start, ray, waves, time, farthest):
    """Distances at which rays first meet displaced sines (inf: not within the farthest)."""
    return in_blocks(lambda *rows: _meet_waves(*rows, waves, time, farthest), start, ray)


def _meet_waves(start, ray, waves, time, farthest):
    top = sum(wave[0] for wave in waves)

    def over(way, rays):
        at = start[rays] + way[:, None] * ray[rays]
        return at[:, 2] - heights(waves, at[:, 0], at[:, 1], time)

    with np.errstate(divide="ignore", invalid="ignore"):
        enters = np.where(ray[:, 2] < 0, np.maximum((top - start[:, 2]) / ray[:, 2], 0), np.inf)
        leaves = np.where(ray[:, 2] < 0, np.minimum((-top - start[:, 2]) / ray[:, 2], farthest), np.inf)
    left = np.flatnonzero(enters < leaves)  # the rays that have not met them yet
    low, high = enters.copy(), np.full(len(ray), np.inf)
    for part in np.linspace(0, 1, 400)[1:]:
        here = enters[left] + part * (leaves[left] - enters[left])
        hits = over(here, left) <= 0
        high[left[hits]] = here[hits]
        left, here = left[~hits], here[~hits]
        low[left] = here
    met = np.flatnonzero(np.isfinite(high))
    for _ in range(40):
        middle = 0.5 * (low[met] + high[met])
        above = over(middle, met) > 0
        low[met], high[met] = np.where(above, middle, low[met]), np.where(above, high[met], middle)
    return high


def picture(camera, size, things, background, waves, time, samples=4, clear=()):
    """The picture of level water at z = 0 that reflects everything (255 RGB), and which pixels are
    water and nothing else. waves: as in heights_and_slopes, or a function (x, y) -> slopes; clear: as in cast."""
    colors, is_water = in_blocks(lambda *rows: _water_colors(*rows, things, background, waves, time, clear),
                                 *eye_rays(camera, size, samples))
    width, height = size
    shape = (height, samples, width, samples)
    return (255 * colors.reshape(*shape, 3).mean(axis=(1, 3)),
            is_water.reshape(shape).all(axis=(1, 3)))


def _water_colors(start, ray, things, background, waves, time, clear):
    """Colours that rays see, and which of them meet the water first."""
    colors, distance = cast(things, background, start, ray)
    with np.errstate(divide="ignore"):
        to_water = np.where(ray[:, 2] < 0, -start[:, 2] / ray[:, 2], np.inf)
    is_water = to_water < distance
    for one in clear:
        is_water &= one.kept(start, ray, to_water)[1] == np.inf
    point = start[is_water] + to_water[is_water][:, None] * ray[is_water]
    point[:, 2] = 0
    if callable(waves):
        slope_x, slope_y = waves(point[:, 0], point[:, 1])
    else:
        _, slope_x, slope_y = heights_and_slopes(waves, point[:, 0], point[:, 1], time)
    normal = np.stack([-slope_x, -slope_y, np.ones_like(slope_x)], axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    seen = ray[is_water]
    away = seen - 2 * dot(seen, normal)[:, None] * normal
    away[:, 2] = np.abs(away[:, 2])  # a ray that would meet the water again is bounced off once more
    colors[is_water] = cast(things, background, point, away, clear)[0]
    return colors, is_water

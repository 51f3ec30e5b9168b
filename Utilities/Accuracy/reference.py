# SPDX-License-Identifier: BSD-3-Clause
"""reference: what is right, from definitions alone, for level water at z = 0.

Waves are sums of A sin(k . x + phase - omega t) with analytic slopes, on a flat sheet. A reflected
ray that would meet the sheet again is bounced off it once more.
"""

import copy

import numpy as np
import ray_caster
import wave_scenes

FARTHEST = 150.0  # the far plane of the scenes
POINTS = 64  # on a ray that meets nothing: is one of them behind something in the mirrored view?


def _rays_to_water(tracer, camera, size, samples):
    start, ray = ray_caster.eye_rays(camera, size, samples)
    colors, distance = tracer.cast(start, ray)
    with np.errstate(divide="ignore"):
        to_water = np.where(ray[:, 2] < 0, -start[:, 2] / ray[:, 2], np.inf)
    is_water = to_water < distance
    place = start + np.where(np.isfinite(to_water), to_water, 0)[:, None] * ray
    place[:, 2] = 0
    return ray, colors, is_water, to_water, place


def reflected(ray, slope_x, slope_y):
    """Unit normals of a surface with these slopes, and the rays it reflects."""
    normal = np.stack([-slope_x, -slope_y, np.ones_like(slope_x)], axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    return normal, ray - 2 * (ray * normal).sum(axis=1, keepdims=True) * normal


def picture(tracer, camera, size, waves, samples):
    """What a camera sees (whole 255 RGB), samples x samples rays a pixel; which pixels are water alone."""
    ray, colors, is_water, _, place = _rays_to_water(tracer, camera, size, samples)
    _, slope_x, slope_y = ray_caster.heights_and_slopes(waves, place[is_water, 0], place[is_water, 1], 0.0)
    _, away = reflected(ray[is_water], slope_x, slope_y)
    away[:, 2] = np.abs(away[:, 2])
    colors[is_water] = tracer.cast(place[is_water], away)[0]
    width, height = size
    shape = (height, samples, width, samples)
    return (np.rint(255 * colors.reshape(*shape, 3).mean(axis=(1, 3))), is_water.reshape(shape).all(axis=(1, 3)))


class Pixels:
    """The ray through every pixel's middle, reflected where the water's surface under test is.

    All arrays have a row per pixel. calm and right are places in the mirrored view's texture.
    """

    def __init__(self, tracer, made, water, waves, size):
        self.size = np.array(size)
        self._camera, self._water = made.renderer.GetActiveCamera(), water
        self.ray, _, self.is_water, self.distance, self.place = _rays_to_water(tracer, self._camera, size, 1)
        self.is_water &= self.distance < FARTHEST
        slopes = wave_scenes.mean_slopes(waves, self.place.reshape(size[1], size[0], 3))
        self.normal, self.away = reflected(self.ray, *slopes)
        self.is_downward = self.away[:, 2] <= 0
        upwards = np.where(self.is_downward[:, None], (0, 0, 1), self.away)
        _, length = tracer.cast(self.place, upwards)
        self.is_hit = np.isfinite(length) & ~self.is_downward
        # a ray that meets nothing ends over the highest thing
        climb = tracer.top / np.maximum(upwards[:, 2], 1e-9)
        self.end = self.place + np.where(self.is_hit, length, climb)[:, None] * upwards
        self.right, self.texture_size = self.map_places(self.end)
        self.is_on_map = ((self.right > 0) & (self.right < 1)).all(axis=1)
        self.is_seen = self._is_seen(tracer, self.end)
        self.calm, _ = self.map_places(self.place)
        self.depth = self._depth(self.place)

    def map_places(self, points):
        return wave_scenes.map_places(self._camera, self._water, points, self.size)

    def only(self, chosen):
        """The same of some pixels."""
        some = copy.copy(self)
        for name, values in vars(self).items():
            if isinstance(values, np.ndarray) and len(values) == len(chosen):
                setattr(some, name, values[chosen])
        return some

    def is_passing_behind(self, tracer):
        """Whether the mirrored eye sees something before a point of the ray."""
        behind = np.zeros(len(self.ray), dtype=bool)
        first, last = self._depth(self.place), self._depth(self.end)
        for share in (np.arange(POINTS) + 0.5) / POINTS:  # of the ray's way in the mirrored picture
            part = share * first / (share * first + (1 - share) * last)
            behind |= ~self._is_seen(tracer, self.place + part[:, None] * (self.end - self.place))
        return behind

    def _depth(self, points):
        """Along the mirrored camera's axis."""
        mirrored = points * (1, 1, -1) - self._camera.GetPosition()
        return mirrored @ np.asarray(self._camera.GetDirectionOfProjection())

    def _is_seen(self, tracer, points):
        """Whether the mirrored eye, from below through the water, sees points."""
        below = np.asarray(self._camera.GetPosition()) * (1, 1, -1)
        look = points - below
        through = below + (-below[2] / np.maximum(look[:, 2], 1e-9))[:, None] * look
        way = np.linalg.norm(points - through, axis=1)
        _, free = tracer.cast(through, look / np.linalg.norm(look, axis=1, keepdims=True))
        return free > way - 1e-3

# SPDX-License-Identifier: BSD-3-Clause
"""refraction_truth: what is right of a scene of refraction_generator, from Snell's law, Beer's and a tracer.

A tracer is tracer.Tracer (Embree), or LocatorTracer, slow, but of VTK alone.
"""

import numpy as np
import ray_caster
from refraction_generator import refracted
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator

NEAR = 5  # px
SLACK = 4  # of 255
AWAY = -0.02  # cosine with the normal: facets that are turned further away are not seen, as others stand before them
REASONS = ("seen", "hidden by what is over the water", "hidden under the water", "out of the picture")


class LocatorTracer:
    """Casts rays at the unlit actors of a renderer, without its water; as tracer.Tracer."""

    def __init__(self, renderer, origin=(0.0, 0.0, 0.0)):
        self._origin, self._things = np.asarray(origin), []
        self._background = np.array(renderer.GetBackground())
        for actor in renderer.GetActors():
            if actor.IsA("vtkWaterActor"):
                continue
            data = actor.GetMapper().GetInput()
            locator = vtkStaticCellLocator()
            locator.SetDataSet(data)
            locator.BuildLocator()
            ids = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
            corners = vtk_to_numpy(data.GetPoints().GetData())[ids]
            colors = np.full(corners.shape, actor.GetProperty().GetColor())
            if actor.GetMapper().GetScalarVisibility() and data.GetPointData().GetScalars():
                colors = vtk_to_numpy(data.GetPointData().GetScalars())[ids] / 255
            self._things.append((locator, corners, colors, np.array(data.GetBounds()).reshape(3, 2)))

    def cast(self, start, ray):
        colors, distance = np.tile(self._background, (len(ray), 1)), np.full(len(ray), np.inf)
        t, part, cell, place, parts = mutable(0.0), mutable(0), mutable(0), np.zeros(3), np.zeros(3)
        start = start + self._origin
        for locator, corners, of_corners, bounds in self._things:
            radius = np.linalg.norm(bounds)
            farthest = 2 * radius + np.linalg.norm(start, axis=1).max()
            rays, cells, places = [], [], []
            for i in np.flatnonzero(_may_meet(start, ray, bounds, 1e-6 * farthest)):
                if locator.IntersectWithLine(start[i], start[i] + farthest * ray[i], 0.0, t, place, parts, part, cell) and (
                        float(t) * farthest < distance[i]):
                    distance[i] = float(t) * farthest
                    rays.append(i)
                    cells.append(int(cell))
                    places.append(place.copy())
            if rays:
                weights = _weights(np.array(places), corners[cells].astype(float))
                colors[rays] = np.einsum("ij,ijk->ik", weights, of_corners[cells])
        return colors, distance


def _may_meet(start, ray, bounds, slack):
    """Which rays pass through a box, a little widened: the others need not be asked one by one."""
    with np.errstate(divide="ignore", invalid="ignore"):
        ends = np.stack([(bounds[:, side] + (slack if side else -slack) - start) / ray for side in (0, 1)])
    enters, leaves = np.fmin(*ends).max(axis=1), np.fmax(*ends).min(axis=1)
    return ~((enters > leaves) | (leaves < 0))  # NaN, of a ray in a side of the box: it may


def _weights(place, corners):
    """Barycentric, of places in triangles."""
    one, other, arm = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0], place - corners[:, 0]
    dot = ray_caster.dot
    area = dot(one, one) * dot(other, other) - dot(one, other) ** 2  # twice the area, squared
    second = (dot(other, other) * dot(one, arm) - dot(one, other) * dot(other, arm)) / area
    third = (dot(one, one) * dot(other, arm) - dot(one, other) * dot(one, arm)) / area
    return np.stack((1 - second - third, second, third), axis=1)


class Truth:
    """picture and once: of 255, with all rays of a pixel and with its middle one; mask: pixels of water alone;
    low and high: the least and most of each colour that water has within NEAR pixels."""

    def __init__(self, scene, tracer, size, samples):
        self._scene, self._tracer, self._size = scene, tracer, size
        self._facts = np.array(scene.facts["extinction"]), np.array(scene.facts["deep"])
        self.once, self.mask = self._picture((0.5, 0.5))
        self.reasons = self._reasons()
        side = round(np.sqrt(samples))
        low, high, total = self._only_water(self.once, self.mask) + (0.0,)
        for shift in np.stack(np.meshgrid(*[(np.arange(side) + 0.5) / side] * 2), axis=-1).reshape(-1, 2):
            seen, is_water = self._picture(shift)
            least, most = self._only_water(seen, is_water)
            low, high, total = np.minimum(low, least), np.maximum(high, most), total + seen
            self.mask = self.mask & is_water
        self.picture = total / side**2
        self.low, self.high = -_most_near(-low), _most_near(high)

    def is_strange(self, picture):
        """Pixels of water in which a picture has what the truth does not have near them."""
        return self.mask & ((picture < self.low - SLACK) | (picture > self.high + SLACK)).any(axis=2)

    def _only_water(self, picture, mask):
        return (np.where(mask[..., None], picture, np.inf), np.where(mask[..., None], picture, -np.inf))

    def _water(self, shift):
        """Colours and distances of rays, whether they meet water that is turned to the eye, where, and the ways on."""
        start, ray = self._scene.rays(self._size, shift)
        colors, distance = self._tracer.cast(start, ray)
        is_water, place = self._scene.meet_water(start, ray, distance)
        _, *slopes = ray_caster.heights_and_slopes(self._scene.waves, place[:, 0], place[:, 1], 0.0)
        normal = np.stack([-slopes[0], -slopes[1], np.ones(len(place))], axis=1)
        normal /= np.linalg.norm(normal, axis=1, keepdims=True)
        is_turned = (ray * normal).sum(axis=1) > AWAY
        normal[is_turned] = (0, 0, 1)
        return colors, is_water, is_turned, place[is_water], refracted(ray[is_water], normal[is_water])

    def _picture(self, shift):
        """Of 255, and which rays meet water that is turned to the eye."""
        extinction, deep = self._facts
        colors, is_water, is_turned, place, way = self._water(shift)
        seen, length = self._tracer.cast(place, way)
        left = np.exp(-extinction * np.where(np.isfinite(length), length, np.inf)[:, None])
        colors[is_water] = left * seen + (1 - left) * deep
        shape = (self._size[1], self._size[0])
        return 255 * colors.reshape(*shape, 3), (is_water & ~is_turned).reshape(shape)

    def _reasons(self):
        """Numbers in REASONS, of the middle rays: can the picture without water have what is right?"""
        found = np.zeros(self._size[0] * self._size[1], dtype=int)
        _, is_water, _, place, way = self._water((0.5, 0.5))
        _, length = self._tracer.cast(place, way)
        length = np.where(np.isfinite(length), length, self._scene.facts["far"])
        end = place + length[:, None] * way
        start, ray, is_inside = self._to_eye(end)
        _, free = self._tracer.cast(start, ray)
        meets = start + np.where(np.isfinite(free), free, 0)[:, None] * ray
        whole = np.linalg.norm(end - start, axis=1)
        is_hidden = free < whole - 2e-3 * length - 1e-6 * whole
        hidden = np.where(is_hidden, np.where(meets[:, 2] > 0, 1, 2), 0)
        found[is_water] = np.where(is_inside, hidden, 3)
        return found.reshape(self._size[1], self._size[0])

    def _to_eye(self, points):
        """Rays from the near plane to points, and whether they are within the picture."""
        camera = self._scene.made.renderer.GetActiveCamera()
        points = points + self._scene.origin
        matrix = camera.GetCompositeProjectionTransformMatrix(self._size[0] / self._size[1], -1, 1)
        clip = np.concatenate([points, np.ones((len(points), 1))], axis=1) @ ray_caster._array(matrix).T
        place = clip[:, :2] / clip[:, 3:]
        start, ray = ray_caster.rays_at(camera, self._size, place[:, 0], place[:, 1])
        near = camera.GetClippingRange()[0] / (ray @ np.array(camera.GetDirectionOfProjection()))
        return start - self._scene.origin + near[:, None] * ray, ray, (clip[:, 3] > 0) & (np.abs(place) < 1).all(axis=1)


def _most_near(values):
    """The most of each channel in a square around each pixel."""
    for axis in (0, 1):
        padded = np.pad(values, [(NEAR, NEAR) if each == axis else (0, 0) for each in range(3)],
                        constant_values=-np.inf)
        count = values.shape[axis]
        values = np.max([padded.take(range(i, i + count), axis=axis) for i in range(2 * NEAR + 1)], axis=0)
    return values

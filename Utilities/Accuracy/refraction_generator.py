# SPDX-License-Identifier: BSD-3-Clause
"""refraction_generator: random scenes (scene_generator) of clear water over a bed, which reflects nothing.

Things stand in the water through its surface, lie under it, float or hang over it. The bed's colours differ from
place to place, and it ends: beyond it water is deep. facts has extinction (1/m) and deep (the deep colour), too.
"""

import numpy as np
import scene_generator
import scene_shapes as shapes
import water_test as wt
from scene_generator import any_color, log_uniform

INDEX = 1.333
THICKNESS = (0.03, 3.0)  # of the water, as the eye counts it: optical depth of a reach


def refracted(ray, normal):
    """Unit rays in the water; its surface has unit normals."""
    cosine = -(ray * normal).sum(axis=-1, keepdims=True)
    return ray / INDEX + (cosine / INDEX - np.sqrt(1 - (1 - cosine**2) / INDEX**2)) * normal


class Draft(scene_generator.Draft):
    ELEVATION = (3.0, 85.0)
    TERRAINS, DOMES = 1.0, 0.25

    def _terrain(self, random):
        """A bed: rough or smooth, level or with a shore, of two colours in patches and of two more by height."""
        count = int(random.integers(32, 97))
        depth = self.reach * log_uniform(random, 0.03, 0.35)
        relief = depth * random.uniform(0.05, 0.9)
        tilt = depth * random.uniform(0.5, 2.5) if random.random() < 0.4 else 0.0
        width = self.reach * random.uniform(2, 6)
        center = self.reach * random.uniform(-0.5, 0.5, 2)
        x, y = np.meshgrid(np.linspace(-0.5, 0.5, count), np.linspace(-0.5, 0.5, count), indexing="ij")
        field, patches = (_cosines(random, x, y) for _ in range(2))
        turn = random.uniform(0, 2 * np.pi)
        height = relief * field + 2 * tilt * (x * np.cos(turn) + y * np.sin(turn)) - depth
        points = np.stack([center[0] + width * x, center[1] + width * y, height], axis=-1)
        self._bed = np.abs(points[..., :2]).max()
        low, high, patch = (np.array(any_color(random)) for _ in range(3))
        colors = low + 0.5 * (1 + field)[..., None] * (high - low)
        return shapes.surface(points), colors + 0.25 * (1 + patches)[..., None] * (patch - colors)

    def _thing(self, random):
        shape = shapes.NAMES[random.integers(len(shapes.NAMES))]
        size = self.reach * log_uniform(random, 0.02, 0.2)
        tilts = random.uniform(-0.5, 0.5, 2) if random.random() < 0.5 else (0, 0)
        data = shapes.turned(shapes.SHAPES[shape](random, size), tilts, random.uniform(0, 2 * np.pi))
        low, high = data.GetBounds()[4:]
        tall = high - low
        lowest = {"stands": random.uniform(-0.8, -0.2) * tall, "under": -tall - self.reach * log_uniform(random, 0.005, 0.2),
                  "floats": random.uniform(-0.2, -0.02) * tall, "hangs": random.uniform(0.05, 1.5) * size}
        where = list(lowest)[random.integers(len(lowest))]
        away = self.reach * 0.9 * random.random()
        turn = random.uniform(0, 2 * np.pi)
        data = wt.moved(data, (away * np.cos(turn), away * np.sin(turn), lowest[where] - low))
        return data, any_color(random)

    def _origin(self, random):
        self._extinction = log_uniform(random, *THICKNESS) / self.reach * random.uniform(0.2, 1, 3)
        self._deep = random.uniform(0, 0.4, 3)
        return super()._origin(random)

    def _settle(self):
        """All of the bed that is under the plane is to be under the sheet."""
        return super()._settle() and self._bed < self.sheet

    def _beyond(self, ray):
        return refracted(ray, np.array((0, 0, 1.0)))

    def scene(self, seed, tries):
        made = super().scene(seed, tries)
        look = made.water.GetWaterProperty()
        look.SetReflectance(0)
        look.RefractionOn()
        look.SetIndexOfRefraction(INDEX)
        look.SetAbsorption(self._extinction)
        look.SetScattering(0, 0, 0)
        look.SetDeepColor(self._deep)
        made.facts |= {"extinction": tuple(self._extinction), "deep": tuple(self._deep)}
        return made


def make(seed, size=scene_generator.SIZE):
    return scene_generator.make(seed, size, Draft)


def _cosines(random, x, y):
    """A field in [-1, 1]."""
    field = np.zeros_like(x)
    for number in random.uniform(1, 9, 12):
        turn, phase = random.uniform(0, 2 * np.pi, 2)
        field += np.cos(2 * np.pi * number * (x * np.cos(turn) + y * np.sin(turn)) + phase) / number
    return field / np.abs(field).max()

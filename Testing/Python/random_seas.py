# SPDX-License-Identifier: BSD-3-Clause
"""random_seas: things of one colour that stand in a wind sea, float in it or hang over it, and what its mirror shows of
them: many rays per pixel to the wave heights' twin.
"""

import numpy as np
import water_test as wt

SIZE = (240, 160)
SKY = np.array((0.2, 0.3, 0.6))
STEP, SIDE = 4, 5  # pixels between those that are looked at; rays in each direction of one
LEAST_DOWN = 0.02  # of the directions that are looked at: what is nearer to the horizon are a few rows


class Sea:
    """A seed's view, with its water, and its things: ("box", lower and upper corner, colour) or ("ball", centre, radius)."""

    def __init__(self, seed):
        random = np.random.default_rng(seed)
        self.things = [self._thing(random) for _ in range(random.integers(3, 8))]
        self.eye = np.array((0.0, -5.0, random.uniform(3.0, 12.0)))
        self.view = wt.View(SIZE, background=tuple(SKY))
        self.water = wt.add_water(self.view.renderer)
        look = self.water.GetWaterProperty()
        look.SeaOn()
        look.SetWindSpeed(random.uniform(4.0, 13.0))
        look.SetFetch(60e3)
        look.SetSeaCascades(3)
        self.water.SetSheetToHorizon()
        for kind, *place, color in self.things:
            data = wt.box(np.mean(place, axis=0), place[1] - place[0]) if kind == "box" else wt.sphere(*place, 48)
            wt.add_actor(self.view.renderer, data, tuple(color), lit=False)
        down = 30.0 * random.uniform(0.05, 0.25)
        self.ahead = (0.0, 25.0, self.eye[2] - down)
        wt.place_camera(self.view.renderer, tuple(self.eye), self.ahead, (0.5, 5000.0))

    @staticmethod
    def _thing(random):
        color = random.uniform(0.0, 1.0, 3)
        x, y = random.uniform(-40.0, 40.0), random.uniform(15.0, 160.0)
        size = random.uniform(0.03, 0.2) * y
        kind = random.integers(4)
        if kind == 2:
            return "ball", (x, y, random.uniform(-0.5, 2.0) * size), 0.6 * size, color
        wide, low = (size, -2.0) if kind == 0 else (2.0 * size, random.uniform(0.3, 2.0) * size + 1.0)
        high = random.uniform(0.2, 2.0) * size if kind == 0 else low + random.uniform(0.1, 1.0) * size
        if kind == 3:  # a mast
            wide, low, high = 0.1 * size, -2.0, random.uniform(2.0, 6.0) * size
        return "box", np.array((x - wide, y - wide / 3, low)), np.array((x + wide, y + wide / 3, high)), color

    def rays(self):
        """From the eye, by place in the picture: (rows, columns, SIDE^2, 3)."""
        forwards = wt.unit(np.array(self.ahead) - self.eye)
        right = wt.unit(np.cross(forwards, (0.0, 0.0, 1.0)))
        up = np.cross(right, forwards)
        half = np.tan(np.radians(self.view.renderer.GetActiveCamera().GetViewAngle() / 2))
        part = (np.arange(SIDE) + 0.5) / SIDE
        rows, columns = np.arange(0, SIZE[1], STEP), np.arange(0, SIZE[0], STEP)
        y = (2 * (rows[:, None, None, None] + part[:, None]) - SIZE[1]) / SIZE[1]
        x = (2 * (columns[None, :, None, None] + part) - SIZE[0]) / SIZE[1]
        rays = forwards + half * (x[..., None] * right + y[..., None] * up)
        rays = rays.reshape(len(rows), len(columns), SIDE * SIDE, 3)
        return rays / np.linalg.norm(rays, axis=-1, keepdims=True)

    def met(self, start, way):
        """How far away the first thing is, and its colour, or the sky's."""
        nearest, color = np.full(len(start), np.inf), np.tile(SKY, (len(start), 1))
        for kind, first, second, own in self.things:
            if kind == "box":
                ends = np.sort([(first - start) / way, (second - start) / way], axis=0)
                near, far = ends[0].max(axis=1), ends[1].min(axis=1)
                is_met, near = (near <= far) & (far > 0.0), np.maximum(near, 0.0)
            else:
                off = start - first
                ahead = (off * way).sum(axis=1)
                root = ahead**2 - (off**2).sum(axis=1) + second**2
                near = -ahead - np.sqrt(np.maximum(root, 0.0))
                is_met = (root > 0.0) & (near > 0.0)
            is_met &= near < nearest
            nearest[is_met], color[is_met] = near[is_met], own
        return nearest, color

    def truth(self):
        """Colours of 255, and which pixels show water alone. Surfaces count as wide as the eye sees them."""
        rays = self.rays()
        is_water = (rays[..., 2] < -LEAST_DOWN).all(axis=-1)
        rays = rays[is_water]
        count = len(rays)
        rays = rays.reshape(-1, 3)
        points = self.eye - rays * (self.eye[2] / rays[:, 2:])
        hidden = self.met(np.tile(self.eye, (len(rays), 1)), rays)[0] < 1.02 * np.linalg.norm(points - self.eye, axis=1)
        normals, normal = np.empty_like(points), [0.0, 0.0, 0.0]
        for i, (x, y, _) in enumerate(points):
            self.water.GetWaveNormal(x, y, normal)
            normals[i] = normal
        facing = np.maximum(-(rays * normals).sum(axis=1), 0.0)
        ways = rays + 2.0 * facing[:, None] * normals
        ways[:, 2] = np.maximum(np.abs(ways[:, 2]), 1e-6)  # once more off the water
        share = (facing / normals[:, 2]).reshape(count, -1, 1)
        color = self.met(points, ways)[1].reshape(count, -1, 3)
        is_water[is_water] = ~hidden.reshape(count, -1).any(axis=1)
        mean = (share * color).sum(axis=1) / np.maximum(share.sum(axis=1), 1e-12)
        return 255.0 * mean[~hidden.reshape(count, -1).any(axis=1)], is_water

    def picture(self, quality):
        """The same pixels with a quality."""
        self.water.GetWaterProperty().SetRayTraceQuality(quality)
        return self.view.picture()[::STEP, ::STEP]

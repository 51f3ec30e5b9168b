# SPDX-License-Identifier: BSD-3-Clause
"""data_tide: a tide in a basin as solvers write it: the same mesh with new arrays of level and depth in each step."""

import numpy as np

HALF_WIDTH = 500.0  # m
RANGE = (0.0, 8.0)  # m, of the depths shown
EYE, TARGET, ANGLE = (0.0, -900.0, 300.0), (0.0, 0.0, 0.0), 30.0


class Tide:
    """Level and depth at any step, on a mesh of quads; the shore moves in each step."""

    def __init__(self, cells):
        self.side = round(cells**0.5) + 1
        places = np.linspace(-HALF_WIDTH, HALF_WIDTH, self.side)
        self.x, self.y = (each.ravel() for each in np.meshgrid(places, places))
        self.bed = (-8.0 + 10.0 * (np.hypot(self.x, self.y) / HALF_WIDTH) ** 2
                    + 1.5 * np.sin(self.x / 60.0) * np.cos(self.y / 45.0))

    def points(self, heights):
        return np.column_stack([self.x, self.y, heights])

    def quads(self):
        """Points of the cells, n x 4."""
        i = np.arange(self.side**2).reshape(self.side, self.side)
        return np.stack([i[:-1, :-1], i[:-1, 1:], i[1:, 1:], i[1:, :-1]], axis=-1).reshape(-1, 4)

    def step(self, number):
        """Level, which is the bed's height on land, and depth."""
        sea = 0.3 * np.sin(0.3 * number) + 0.05 * np.sin(self.x / 30.0 - 0.5 * number)
        level = np.maximum(sea, self.bed)
        return level, level - self.bed

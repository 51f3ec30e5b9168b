# SPDX-License-Identifier: BSD-3-Clause
"""The example's waves are long waves: swell keeps its height and its speed, and leaves; the file holds all of it."""

import math
import pathlib
import sys

import numpy as np
import pytest
import water_test as wt
from vtkwater.solutions import Solution

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Examples/Python"))
import breakwater  # noqa: E402

LENGTH, WIDTH, DEPTH = 400.0, 60.0, 10.0


def channel(depth=DEPTH):
    points, triangles = breakwater.make_mesh((), WIDTH, LENGTH)
    return points, triangles, breakwater.Waves(points, triangles, np.full(len(points), -depth), closed=LENGTH - 1.0)


def test_swell_travels_at_its_speed():
    """In water of one depth: a plane wave of the swell's height, as fast as the root of g h, that only the far end
    knows nothing of yet."""
    points, _, waves = channel()
    waves.open = waves.sent  # the sides are walls
    heights = waves.run(60.0, 1.0, breakwater.AMPLITUDE, breakwater.PERIOD)
    speed = math.sqrt(breakwater.GRAVITY * DEPTH)
    time = 40.0  # it has come 396 m, its beginning has passed the first half
    at = points[:, 1] < 0.5 * LENGTH
    late = time - points[at, 1] / speed
    wanted = breakwater.AMPLITUDE * np.sin(2.0 * math.pi * late / breakwater.PERIOD)
    wt.check_at_most("heights off by, of the swell's",
                     float(np.abs(heights[40][at] - wanted).max() / breakwater.AMPLITUDE), 0.06)


def test_waves_leave():
    """What goes out by the open edge does not come back: the water that was hit is level again."""
    points, _, waves = channel()
    waves.open = waves.sent
    still = waves.run(0.0, 1.0, 0.0, 9.0)[0]
    wt.check_equal("at rest", bool((still == 0.0).all()), True)
    start = 0.1 * np.exp(-(((points[:, 1] - 100.0) / 25.0) ** 2))
    step = 0.9 * waves.longest_step()
    now = before = start
    drag = 0.5 * step * waves.open / waves.mass
    for _ in range(round(90.0 / step)):  # to the wall and back, and out
        now, before = waves.advanced(now, before, 0.0, step, drag), now
    wt.check_at_most("left of it", float(np.abs(now).max() / 0.1), 0.03)


def test_all_of_the_harbour_is_meshed():
    """The triangles cover the water, without the walls, the pier and the land, and none is a sliver."""
    points, triangles = breakwater.make_mesh(breakwater.solids())
    corners = points[triangles]
    edge = np.roll(corners, -1, axis=1) - corners
    area = 0.5 * np.abs(edge[:, 0, 0] * edge[:, 1, 1] - edge[:, 0, 1] * edge[:, 1, 0])
    inner = breakwater.LENGTH - breakwater.SHORE
    west, east, south, north = breakwater.QUAY
    sea, gap = breakwater.WIDTH * breakwater.WALL[0], np.ptp(breakwater.GAP) * np.ptp(breakwater.WALL)
    harbour = (breakwater.WIDTH - 2 * breakwater.SHORE) * (inner - breakwater.WALL[1])
    wanted = sea + gap + harbour - (east - west) * (north - south)
    wt.check_at_most("area off by, of it", abs(float(area.sum()) / wanted - 1.0), 1e-9)
    wt.check_at_least("least height of a triangle, of its longest side",
                      float((2.0 * area / (edge**2).sum(axis=2).max(axis=1)).min()), 0.02)


def test_the_file_holds_what_was_solved(tmp_path):
    pytest.importorskip("netCDF4")
    points, triangles, waves = channel()
    heights = waves.run(5.0, 1.0, 0.5, 9.0)
    bed = {"zb": np.full(len(points), -9.0)}
    breakwater.write_ugrid(tmp_path / "c.nc", points, triangles, np.arange(6.0), heights, bed)
    solution = Solution(tmp_path / "c.nc", ["zeta", "zb"])
    wt.check_equal("times, triangles", (solution.times, solution.step(0).GetNumberOfCells()),
                   (tuple(map(float, range(6))), len(triangles)))
    off = np.abs(np.array(solution.range_of("zeta")) - (heights.min(), heights.max())).max()
    wt.check_at_most("range off by", float(off), 1e-6)

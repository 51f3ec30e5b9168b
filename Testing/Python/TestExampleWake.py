# SPDX-License-Identifier: BSD-3-Clause
"""The example's wake is Kelvin's: its waves have the speed of the ship, and lie in the angle that he found."""

import math
import pathlib
import sys

import numpy as np
import pytest
import water_test as wt

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Examples/Python"))
import wake  # noqa: E402

KELVIN_DEG = math.degrees(math.asin(1.0 / 3.0))


@pytest.fixture(scope="module")
def heights():
    return wake.wake(70.0)


def test_each_wave_obeys_its_equation():
    """The closed form against the equation of motion, integrated step by step: z'' + g k z = -g k p, with damping."""
    for k_x, k in ((0.2, 0.3), (-0.5, 0.6), (0.15, 0.15), (0.05, 1.2)):
        omega, steps, end = math.sqrt(wake.GRAVITY * k), 20000, 25.0
        s = (np.arange(steps) + 0.5) * (end / steps)  # since the push
        answer = np.sin(omega * s) / omega * np.exp((1j * k_x * wake.SPEED - wake.DAMPING) * s)
        wanted = -wake.GRAVITY * k * answer.sum() * (end / steps)
        got = complex(wake.response(np.float64(k_x), np.float64(k), end))
        wt.check_at_most(f"k = ({k_x}, {k}): off by, of it", abs(got - wanted) / abs(wanted), 1e-5)


def test_at_rest_the_water_gives_way_to_the_hull():
    """Long after a start at no speed the hollow is as deep as the hull, which fills it: the water is level."""
    speed, wake.SPEED = wake.SPEED, 0.0
    try:
        off = complex(wake.response(np.float64(0.1), np.float64(0.4), 2000.0))
    finally:
        wake.SPEED = speed
    wt.check_at_most("off by", abs(off + 1.0), 1e-3)


def test_the_waves_that_follow_are_as_fast_as_the_ship(heights):
    """Behind it, on its way, they are 2 pi U^2 / g long."""
    at = wake.places()
    behind = (at > -220.0) & (at < -60.0)
    line = heights[len(at) // 2, behind]
    zero = np.flatnonzero(np.diff(np.sign(line)))
    length = 2.0 * np.diff(at[behind][zero]).mean()
    wt.check_at_most("length off by, of it", abs(length * wake.GRAVITY / (2.0 * math.pi * wake.SPEED**2) - 1.0), 0.03)


def test_the_wake_lies_in_kelvins_angle(heights):
    """Beyond it, from the bow on, the water is all but level; within, it is not."""
    at = wake.places()
    x, y = np.meshgrid(at, at)
    angle = np.degrees(np.arctan2(np.abs(y), 0.5 * wake.LENGTH - x))
    ring = (x < -60.0) & (x > -180.0)
    rms = [float(np.sqrt((heights[ring & (angle > low) & (angle < high)] ** 2).mean()))
           for low, high in ((10.0, KELVIN_DEG), (KELVIN_DEG + 6.0, 45.0))]
    wt.check_at_most("waves beyond it, of those within", rms[1] / rms[0], 0.08)
    ahead = (at > 40.0) & (at < wake.AHEAD)  # what is shown: beyond, the periodic water begins again
    wt.check_at_most("waves ahead, of those behind",
                     float(np.abs(heights[:, ahead]).max() / np.abs(heights[:, at < -40.0]).max()), 0.05)


def test_it_begins_level(heights):
    wt.check_at_most("height at the start, of the later, less the hull's hollow",
                     float(np.abs(wake.shown(wake.wake(0.0))[0][:, :300]).max() / np.abs(heights).max()), 1e-6)

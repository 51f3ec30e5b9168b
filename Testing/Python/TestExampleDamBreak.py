# SPDX-License-Identifier: BSD-3-Clause
"""The example's dam break keeps its water, begins as the column of the experiment, and its surface reaches the walls."""

import pathlib
import sys

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Examples/Python"))
import dam_break  # noqa: E402

COLUMN = 1.228, 1.0, 0.55  # m


@pytest.fixture(scope="module")
def flow():
    return dam_break.DamBreak()


def test_no_water_is_lost(flow):
    """At each step of the solver: the volume of the column, 0.675 m3, within a layer of cells; later that, less the 1 %
    that splashes over the wall, by the solver's own count, and never more."""
    with np.load(dam_break.DATA) as kept:
        x, y, z = (np.diff(kept[axis].astype(float)) for axis in "xyz")
    volumes = np.einsum("tkji,k,j,i->t", flow.alpha / 255.0, z, y, x)
    wt.check_at_most("at first off by, of it", abs(volumes[0] / np.prod(COLUMN) - 1.0), 0.04)
    wt.check_at_most("lost over the wall off by, of the first", abs(float(1.0 - volumes[-1] / volumes[0]) - 0.01), 0.001)
    wt.check_at_most("more than before, of the first", float(np.diff(volumes).max() / volumes[0]), 0.0005)


def test_the_column_stands_at_first(flow):
    flow.show(0.0)
    bounds = flow.normals.GetOutput().GetBounds()
    wanted = 0, COLUMN[0], 0, COLUMN[1], 0, COLUMN[2]
    wt.check_at_most("off by, m, of cells of 0.04", float(np.abs(np.array(bounds) - wanted).max()), 0.045)


def test_between_steps_the_front_goes_on(flow):
    """On the dry bottom it runs towards the box, farther at each time, also between the steps; then up the far wall."""
    fronts = []
    for time in np.arange(0.10, 0.42, 0.01):
        flow.show(float(time))
        fronts.append(flow.normals.GetOutput().GetBounds()[1])
    wt.check_equal("goes on", bool((np.diff(fronts) > 0.0).all()), True)
    # Ritter 1892: no front is faster than 2 sqrt(g h)
    speed = np.diff(fronts).mean() / 0.01
    wt.check_at_least("speed of the front, m/s", float(speed), 1.5)
    wt.check_at_most("speed of the front, m/s", float(speed), 2.0 * np.sqrt(9.81 * COLUMN[2]))
    flow.show(2.0)
    places = vtk_to_numpy(flow.normals.GetOutput().GetPoints().GetData())
    wt.check_at_most("of the far wall, m", 3.22 - float(places[:, 0].max()), 1e-6)
    wt.check_at_most("of both sides, m", float(1.0 - np.ptp(places[:, 1])), 1e-6)

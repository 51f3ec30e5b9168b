# SPDX-License-Identifier: BSD-3-Clause
"""Several clear waters are drawn in their order from the eye, in whatever order they were added, and wherever the eye
goes: each shows the others behind it."""

import itertools

import numpy as np
import pytest
import water_test as wt
from vtkwater import vtkWaterActor

SIZE = (90, 70)
EXTINCTION = np.array((0.35, 0.15, 0.25))  # 1/m
BED = np.array((0.9, 0.8, 0.7))
BED_DEPTH = 12.0
COLORS = ((0.9, 0.1, 0.1), (0.1, 0.9, 0.1), (0.1, 0.1, 0.9))
EYES = ((0.0, -6.0, 14.0), (5.0, 2.0, 20.0), (-8.0, 4.0, 11.0))


def scene(levels, order):
    """Three clear waters over a bed, each with a colour of its own, that neither bend nor reflect light."""
    view = wt.View(SIZE, (0, 0, 0))
    wt.add_actor(view.renderer, wt.box((0, 0, -BED_DEPTH - 0.5), (300, 300, 1)), BED, lit=False)
    waters = []
    for i in order:
        water = vtkWaterActor()
        water.SetLevel(levels[i])
        water.SetSheetBounds(-60, 60, -60, 60)
        look = water.GetWaterProperty()
        look.SetReflectanceModeToConstant()
        look.SetReflectance(0.0)
        look.SetIndexOfRefraction(1.0001)
        look.RefractionOn()
        look.SetAbsorption(*EXTINCTION)
        look.SetScattering(0, 0, 0)
        look.SetDeepColor(*COLORS[i])
        look.SetShoreSoftness(0.0)
        view.renderer.AddActor(water)
        waters.append(water)
    return view, waters


def truth(view, levels):
    """Colours along the middle ray: from the bed up, each layer of water adds its own; waters see those behind them as
    what lies under their surface."""
    camera = view.renderer.GetActiveCamera()
    eye, target = np.array(camera.GetPosition()), np.array(camera.GetFocalPoint())
    down = (eye - target)[2] / np.linalg.norm(eye - target)
    color, below = BED, -BED_DEPTH
    for i in np.argsort(levels):
        left = np.exp(-EXTINCTION * (levels[i] - below) / down)
        color = left * color + (1 - left) * np.array(COLORS[i])
        below = levels[i]
    return 255 * color


@pytest.mark.parametrize("seed", range(2))
def test_the_order_is_from_the_eye(seed):
    """Three waters at random depths, added in each order, have the colours of their layers from each eye."""
    levels = np.random.default_rng(seed).uniform(-6.0, 4.0, 3)
    for order in itertools.permutations(range(3)):
        view, waters = scene(levels, order)
        errors = [wt.errors_of(water) for water in waters]
        for eye in EYES:
            wt.place_camera(view.renderer, eye, (0.4 * eye[0], 0.4 * eye[1], 0.0), (1, 200))
            wanted = truth(view, levels)
            seen = view.picture()[SIZE[1] // 2, SIZE[0] // 2]
            off = float(np.abs(seen - wanted).max())
            wt.check_at_most(f"levels {np.round(levels, 1)}, added {order}, from {eye}: off, of 255", off, 3.0)
        wt.check_equal("errors", sum(errors, []), [])

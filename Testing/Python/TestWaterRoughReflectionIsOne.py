# SPDX-License-Identifier: BSD-3-Clause
"""A rough reflection is one blurred image, not several sharp ones."""

import numpy as np
import water_test as wt


def test_brightness_rises_step_by_step():
    """Across a blurred edge the brightness rises step by step, without a jump at an image of the edge."""
    made = wt.View((200, 150), (0, 0, 0))
    wt.add_actor(made.renderer, wt.box((0, 20, 4), (200, 0.1, 8)), (1, 1, 1), lit=False)
    water = wt.add_water(made.renderer, None, (-90, 90, -90, 90), 1.0)
    water.GetWaterProperty().SetSlopeVariance(5e-4, 5e-4)
    wt.place_camera(made.renderer, (0, -20, 5), (0, 0, 1), (1, 200))
    column = made.picture()[:, 100, 0]
    steps = np.abs(np.diff(column))[:70]  # from the bottom up to the foot of the wall
    wt.check_at_least("rough reflection: from the sky's black to the wall's white, of 255", int(np.ptp(column[:70])), 200)
    wt.check_at_most("rough reflection: largest step from pixel to pixel, of 255", int(steps.max()), 60)

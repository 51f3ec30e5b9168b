# SPDX-License-Identifier: BSD-3-Clause
"""A scene at (5e6, 4e6, 100) metres gives the picture it gives at the origin."""

import numpy as np
import pytest
import water_test as wt

OFFSET = (5e6, 4e6, 100.0)
LIMIT_PERCENT = 0.02


def picture(offset, tilt):
    view = wt.View((640, 480))
    for data, color in wt.columns_and_pyramids():
        wt.add_actor(view.renderer, wt.moved(data, offset), color, specular=0.3)
    wt.add_scene_light(view.renderer, np.add((4, -5, 8), offset), offset)
    water = wt.add_water(
        view.renderer, wt.plane(offset, wt.unit(tilt)), (-20, 20, -20, 20), reflectance=None
    )
    wt.place_camera(view.renderer, np.add((2, -14, 4), offset), offset, (1, 60))
    seen = view.picture()
    wt.check_equal(f"offset {offset}: decision", water.GetReflectionPass().GetDecisionAsString(), "rendered")
    return seen


@pytest.mark.parametrize("tilt", ((0, 0, 1), (0.1, 0.05, 1)), ids=("level", "tilted"))
def test_the_picture_far_away_is_that_at_the_origin(tilt):
    """A scene five thousand kilometres away gives the picture that it gives at the origin."""
    here = picture((0.0, 0.0, 0.0), tilt)
    there = picture(OFFSET, tilt)
    off = (np.abs(here - there).max(axis=2) > 1).mean() * 100
    wt.check_at_most(f"normal {tilt}: % of all pixels off by more than 1/255", off, LIMIT_PERCENT)
    wt.check_at_least(f"normal {tilt}: colours in the picture", len(np.unique(here)), 50)

# SPDX-License-Identifier: BSD-3-Clause
"""water_scenes: the small scene that water is put beside other things of VTK in: one pyramid and a sheet."""

import numpy as np
import water_test as wt

SIZE = (200, 150)
SHEET = (-9, 9, -9, 9)


def view(offset=(0, 0, 0)):
    """An empty window whose camera looks down at the pyramid's place."""
    made = wt.View(SIZE)
    wt.place_camera(made.renderer, np.add((4, -5, 2), offset), offset, (0.1, 100))
    return made


def add_thing(renderer, offset=(0, 0, 0)):
    """Adds the pyramid; returns its actor."""
    return wt.add_actor(renderer, wt.moved(wt.pyramid((0, 0, 0.4), 1.2), offset), (1, 0.6, 0.2))


def plain_picture():
    """The pyramid and a mirror, with nothing else: what other ways to the same scene must show."""
    made = view()
    add_thing(made.renderer)
    wt.add_water(made.renderer, None, SHEET)
    return made.picture()

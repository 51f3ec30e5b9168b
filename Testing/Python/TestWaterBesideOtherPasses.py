# SPDX-License-Identifier: BSD-3-Clause
"""A reflection pass that the user composes serves its own plane, and a chain of passes that leads back ends."""

import pytest
import water_test as wt
from vtkwater import vtkWaterReflectionPass
from water_scenes import add_thing, view

FRAMES = 2


def two_levels(composed):
    """Pictures of water at two levels, with a pass of the user's or without."""
    scene = view()
    add_thing(scene.renderer)
    for level, sheet in ((-0.2, (-9, 0, -9, 9)), (-0.6, (0, 9, -9, 9))):
        wt.add_water(scene.renderer, wt.plane((0, 0, level), (0, 0, 1)), sheet)
    if composed:
        scene.renderer.SetPass(vtkWaterReflectionPass())
    return [scene.picture() for _ in range(FRAMES)]


def test_water_in_another_plane_keeps_its_own_mirror():
    """A composed pass takes charge of one plane; water in another keeps its own mirror."""
    for own, composed in zip(two_levels(False), two_levels(True)):
        wt.check_equal("two levels with a composed pass: error", wt.difference(composed, own), 0)


@pytest.fixture
def cycle():
    """Two passes of which each delegates to the other; they are taken apart at the end, or they would never die."""
    first, second = vtkWaterReflectionPass(), vtkWaterReflectionPass()
    first.SetDelegatePass(second)
    second.SetDelegatePass(first)
    yield first
    second.SetDelegatePass(None)


def test_a_chain_of_passes_that_leads_back_ends(cycle):
    """A chain of passes that leads back is said once, and ends, where it is rendered and where it is printed."""
    errors = wt.errors_of(cycle)
    scene = view()
    add_thing(scene.renderer)
    scene.renderer.SetPass(cycle)
    for _ in range(3):
        scene.picture()
    wt.check_equal("cycle of passes: errors", len(errors), 1)
    wt.check_equal("cycle of passes: printed", "leads back" in str(cycle), True)
    scene.renderer.SetPass(None)

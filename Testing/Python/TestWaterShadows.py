# SPDX-License-Identifier: BSD-3-Clause
"""Shadows on the water lie where rays to the sun are stopped, along coasts, too, and nowhere else.

A coast takes seconds, most of them for its rays. coast_shadows.py by itself looks at 50 of them.
"""

import coast_shadows as coasts
import pytest
import water_test as wt

LIMIT = 0.5  # % of the water's pixels
coasts.SIZE = (225, 165)  # of three quarters: most of the time is that of the rays
LAND_SEEDS = (14, 26)  # they have shadows
THING_SEEDS = (0, 3)
CLEAR_SEEDS = (18,)  # the picture shows what casts the shadows, and the mirrored view does not
# over the shore from the sea, along it, from the land, from high over it; whether the water is clear
BEACH_EYES = (((-5, -25, 8), (0, 0, 0), False), ((-15, -15, 10), (0, 0, 0), True), ((20, -12, 12), (-3, 0, 0), False),
              ((-3, 0, 30), (-3, 0.1, 0), True), ((-4, 25, 14), (-1, 0, 0), False))


def check(name, coast, has_refraction=False):
    dark, lit, shaded, picture = coasts.compared(coast, has_refraction)
    wt.save(picture, wt.output_folder() / f"{name.replace(' ', '_')}.png")
    print(f"{name}: {100 * shaded:.2f} % of the water is in shadow")
    wt.check_at_least(f"{name}: pixels of water", int((picture[:, :, 2] > 0).sum()), 100)
    wt.check_at_most(f"{name}: % that is dark or lit wrongly", 100 * float(dark + lit), LIMIT)


@pytest.mark.parametrize("eye, target, has_refraction", BEACH_EYES)
def test_a_beach_shades_no_water(eye, target, has_refraction):
    """A beach of a slope of a tenth, under a sun 45 degrees high, keeps the sun off nothing."""
    check(f"beach from {eye}", coasts.beach(eye, target), has_refraction)


@pytest.mark.parametrize("seed", LAND_SEEDS)
def test_land_shades_what_rays_say(seed):
    """Random bays, hills and islands under random suns."""
    check(f"land {seed}", coasts.random_coast(seed, has_things=False))


@pytest.mark.parametrize("seed", THING_SEEDS)
def test_things_shade_what_rays_say(seed):
    """The same with posts and balls."""
    check(f"things {seed}", coasts.random_coast(seed))


@pytest.mark.parametrize("seed", CLEAR_SEEDS)
def test_clear_water_has_shadows_of_what_the_picture_shows(seed):
    """Clear water looks for what keeps the sun off in the picture, too: there, the sides that face the eye are seen."""
    check(f"clear {seed}", coasts.random_coast(seed), has_refraction=True)

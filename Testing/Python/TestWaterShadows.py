# SPDX-License-Identifier: BSD-3-Clause
"""Shadows on the water lie where rays to the sun are stopped, along coasts, too, and nowhere else."""

import coast_shadows as coasts
import pytest
import water_test as wt

LIMIT = 0.5  # % of the water's pixels
LAND_SEEDS = (3, 9, 14, 18, 26, 40)  # 14, 18 and 26 have shadows
THING_SEEDS = (0, 3, 6, 9, 15, 25)
# over the shore from the sea, along it, from the land, from high over it
BEACH_EYES = (((-5, -25, 8), (0, 0, 0)), ((-15, -15, 10), (0, 0, 0)), ((20, -12, 12), (-3, 0, 0)),
              ((-3, 0, 30), (-3, 0.1, 0)), ((-4, 25, 14), (-1, 0, 0)))


def check(name, coast):
    dark, lit, shaded, picture = coasts.compared(coast)
    wt.save(picture, wt.output_folder() / f"{name.replace(' ', '_')}.png")
    print(f"{name}: {100 * shaded:.2f} % of the water is in shadow")
    wt.check_at_least(f"{name}: pixels of water", int((picture[:, :, 2] > 0).sum()), 100)
    wt.check_at_most(f"{name}: % that is dark or lit wrongly", 100 * float(dark + lit), LIMIT)


@pytest.mark.parametrize("eye, target", BEACH_EYES)
def test_a_beach_shades_no_water(eye, target):
    """A beach of a slope of a tenth, under a sun 45 degrees high, keeps the sun off nothing."""
    check(f"beach from {eye}", coasts.beach(eye, target))


@pytest.mark.parametrize("seed", LAND_SEEDS)
def test_land_shades_what_rays_say(seed):
    """Random bays, hills and islands under random suns."""
    check(f"land {seed}", coasts.random_coast(seed, has_things=False))


@pytest.mark.parametrize("seed", THING_SEEDS)
def test_things_shade_what_rays_say(seed):
    """The same with posts and balls."""
    check(f"things {seed}", coasts.random_coast(seed))

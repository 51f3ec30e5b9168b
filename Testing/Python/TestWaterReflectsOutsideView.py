# SPDX-License-Identifier: BSD-3-Clause
"""What the user's camera does not see is reflected all the same, at its true height and depth."""

import numpy as np
import water_test as wt


def picture(box_center, focal_point=(0, 0, 0), with_box=True):
    view = wt.View((320, 240), background=(0, 0, 0))
    wt.add_water(view.renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-30, 30, -30, 30))
    if with_box:
        wt.add_actor(view.renderer, wt.box(box_center, (3, 3, 3)), (1, 0, 0), lit=False)
    # the clipping range ends behind the water, before the farthest mirror image
    wt.place_camera(view.renderer, (0, -20, 6), focal_point, (1, 45))
    return (view.picture() == (255, 0, 0)).all(axis=2)


# The camera looks down by 16.7 degrees and sees 15 around that; directions are given as degrees up.
# Box at 9 up: above the screen. Its mirror image: 25 down.
ABOVE_THE_SCREEN = (0, 20, 12.6)


def test_a_box_above_the_screen_is_reflected():
    """A box above the screen is reflected."""
    wt.check_at_least("box above the screen: reflected pixels", int(picture(ABOVE_THE_SCREEN).sum()), 200)


def test_a_box_behind_the_camera_is_reflected():
    """A box behind the camera is reflected."""
    # Looking down by 60, box at 45 up: behind the camera. Its mirror image: 66 down.
    behind = picture((0, -10, 16), (0, -20 + 6 / np.tan(np.radians(60)), 0))
    wt.check_at_least("box behind the camera: reflected pixels", int(behind.sum()), 200)


def test_a_box_beyond_the_far_plane_is_reflected():
    """A box whose mirror image is beyond the camera's far plane is reflected."""
    # Box at depth 39, its mirror image at depth 48, beyond the far plane at 45.
    far = picture((0, 24, 16))
    wt.check_at_least("box whose mirror image is beyond the far plane: reflected pixels", int(far.sum()), 100)


def test_without_a_box_nothing_is_red():
    """Without a box no pixel has its colour."""
    wt.check_equal("no box: red pixels", int(picture(ABOVE_THE_SCREEN, with_box=False).sum()), 0)


def test_the_mirror_image_is_where_geometry_puts_it():
    """The highest point of the mirror image is in the row where geometry puts it."""
    # The far lower edge (y, z) = (21.5, 11.1), mirrored to z = -11.1, is the highest point of the mirror image.
    rows = np.nonzero(picture(ABOVE_THE_SCREEN).any(axis=1))[0]
    down = np.arctan2(6, 20)
    angle = np.arctan2(6 + 11.1, 20 + 21.5)
    expected = 120 - 120 * np.tan(angle - down) / np.tan(np.radians(15))
    error = float(abs(rows.max() + 1 - expected)) if len(rows) else np.inf
    wt.check_at_most("row of the upper end of the mirror image, error in pixels", error, 1.0)

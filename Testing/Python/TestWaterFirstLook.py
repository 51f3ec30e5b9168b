# SPDX-License-Identifier: BSD-3-Clause
"""A newcomer's first pictures: water without a setting is neither black nor a hole, in scenes of all sizes."""

import sys
from pathlib import Path

import numpy as np
import pytest
import water_test as wt

sys.path.insert(0, str(Path(__file__).parents[2] / "Utilities" / "FirstLook"))
try:
    import pyvista  # noqa: F401
except ImportError as error:
    reason = f"{error}; Testing/Python/requirements.txt says what to install"
    print(f"skipped: {reason}")
    pytest.skip(reason, allow_module_level=True)
import contact_sheet
from first_scenes import SCENES

SIZE = (160, 120)
SOLID = {"hexahedral beam"}  # all of the water may be in it
DARK, BLACK = 40, 12


@pytest.mark.parametrize("name", SCENES, ids=lambda name: name.replace(" ", "_"))
def test_water_without_a_setting_is_not_black(name):
    """Half of the water is no darker than a deep lake, and next to nothing of it is black."""
    seen = 0
    for camera in contact_sheet.CAMERAS:
        water, none = (contact_sheet.picture_of(name, camera, kind, SIZE).astype(int) for kind in ("water", "none"))
        mask = np.abs(water - none).max(axis=2) > 3
        seen += int(mask.sum())
        if mask.sum() < 50:
            continue
        brightest = water.max(axis=2)[mask]
        wt.check_at_least(f"{camera}: median of the water, of 255", float(np.median(brightest)), DARK)
        black = (brightest < BLACK) & (none.max(axis=2)[mask] >= BLACK)
        wt.check_at_most(f"{camera}: % that is black", 100 * float(black.mean()), 1.0)
    wt.check_at_least("pixels of water in three pictures", seen, 0 if name in SOLID else 300)


def picture(name, camera, wider=1, has_water=True, **words):
    """A scene in 320 x 240 pixels: the middle of a picture that is so many times as wide and high."""
    plotter = pyvista.Plotter(off_screen=True, window_size=[320 * wider, 240 * wider])
    plotter.disable_anti_aliasing()
    level = SCENES[name](plotter)
    if has_water:
        plotter.add_water(level=level, **words)
    contact_sheet.look(plotter, camera)
    plotter.camera.view_angle = np.degrees(2 * np.arctan(wider * np.tan(np.radians(plotter.camera.view_angle / 2))))
    shown = plotter.screenshot(return_img=True).astype(int)
    plotter.close()
    x, y = 160 * (wider - 1), 120 * (wider - 1)
    return shown[y:y + 240, x:x + 320]


def test_a_low_eye_sees_whole_objects_in_open_water():
    """What the picture's lower border cuts off a cone under water is seen, as in the middle of a wider picture."""
    whole = picture("cone", "low", wider=2, own_view=False)
    wrong = {}
    for kind, words in (("default", {}), ("picture", {"own_view": False})):
        shown = picture("cone", "low", **words)
        wt.save(shown.astype(np.uint8), wt.output_folder() / f"TestWaterFirstLook-cone-{kind}.png")
        wrong[kind] = 100 * float((np.abs(shown - whole).max(axis=2) > 12).mean())
    wt.check_at_most("% of wrong pixels", wrong["default"], 0.1)
    wt.check_at_least("% of wrong pixels from the picture", wrong["picture"], 0.5)


def test_the_hidden_side_of_a_cone_is_no_specks():
    """Seen from above, the far side of a cone is hidden: it has no teeth at the cone's edge."""
    shown = picture("cone", "above")
    wt.save(shown.astype(np.uint8), wt.output_folder() / "TestWaterFirstLook-cone-above.png")
    none = picture("cone", "above", has_water=False)
    beside = (none == none[0, 0]).all(axis=2) & (np.abs(shown - shown[100, 60]).max(axis=2) > 12)
    wt.check_at_most("pixels beside the cone that are not deep water", int(beside[:122, :150].sum()), 3)

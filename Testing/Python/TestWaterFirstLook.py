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

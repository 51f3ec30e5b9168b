# SPDX-License-Identifier: BSD-3-Clause
"""The mirrored view is cut at the water's plane however close the near plane is."""

import water_test as wt
from vtkmodules.vtkFiltersSources import vtkPlaneSource

SIZE = (240, 160)
RISE = 1e-3


def test_a_shallow_shore_is_cut_where_the_water_is():
    """With a near plane at 1/4000 of the distance, a bed that rises by a millimetre per metre through calm water shows nothing of
    what lies below the water in the reflection."""
    made = wt.View(SIZE, (0, 0, 1))
    bed = vtkPlaneSource()  # through the water's plane at y = 4; what is over it is too low to be reflected
    bed.SetOrigin(-20, -20, -24 * RISE)
    bed.SetPoint1(20, -20, -24 * RISE)
    bed.SetPoint2(-20, 20, 16 * RISE)
    bed.SetOutputPointsPrecision(1)
    bed.Update()
    wt.add_actor(made.renderer, bed.GetOutput(), (1, 0, 0), lit=False)
    water = wt.add_water(made.renderer, None, (-15, 15, -15, 15), reflectance=1.0)
    camera = wt.place_camera(made.renderer, (0, -8, 1.6), (0, 2, 0), (0.002, 200))
    camera.SetViewAngle(30)
    picture = made.picture()
    counts = wt.water_mask(made, water)
    wt.save(picture, wt.output_folder() / "TestWaterNearPlane.png")
    wt.check_at_least("pixels counted", int(counts.sum()), 15000)
    wt.check_equal("pixels of the water that show the bed", int(((picture[..., 0] > 128) & counts).sum()), 0)

# SPDX-License-Identifier: BSD-3-Clause
"""A water actor is made, placed and copied as VTK's other actors are: by any thread, by any plane, with all it has."""

import threading

import pytest
import water_test as wt
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkwater import vtkWaterActor
from water_scenes import SHEET, add_thing, plain_picture, view


def test_any_thread_may_make_water():
    """Water made by a thread and water made by another, in one renderer, show one mirror."""
    halves = []
    maker = threading.Thread(target=lambda: halves.append(vtkWaterActor()))
    maker.start()
    maker.join()
    halves.append(vtkWaterActor())
    scene = view()
    add_thing(scene.renderer)
    for water, sheet in zip(halves, ((-9, 0, -9, 9), (0, 9, -9, 9))):
        water.SetSheetBounds(sheet)
        water.GetWaterProperty().SetReflectanceModeToConstant()
        water.GetWaterProperty().SetReflectance(1)
        scene.renderer.AddActor(water)
    wt.check_equal("water of two threads: picture, error", wt.difference(scene.picture(), plain_picture()), 0)


@pytest.mark.skipif(not hasattr(vtkPlane, "SetOffset"), reason="a plane has an offset from VTK 9.4 on")
def test_a_planes_offset_moves_the_sheet():
    """A plane with an offset besides its origin has its sheet where the plane's function is zero."""
    plane = wt.plane((0, 0, -0.2), (0, 0, 1))
    plane.SetOffset(0.5)
    level = -0.2 - plane.EvaluateFunction((0, 0, -0.2))
    scene = view()
    water = wt.add_water(scene.renderer, plane, SHEET)
    scene.picture()
    wt.check_at_most("plane with an offset: error of the sheet's height", abs(water.GetBounds()[4] - level), 1e-12)


def test_a_copy_has_the_settings_of_its_mirror():
    """A shallow copy of water has what was set on the original's reflection pass."""
    water, copy = vtkWaterActor(), vtkWaterActor()
    water.GetReflectionPass().SetTextureScale(0.25)
    water.GetReflectionPass().SetClipMargin(0.1)
    water.GetReflectionPass().SetMultiSamples(4)
    copy.ShallowCopy(water)
    copied = copy.GetReflectionPass()
    wt.check_equal("ShallowCopy: TextureScale, ClipMargin, MultiSamples",
                   (copied.GetTextureScale(), copied.GetClipMargin(), copied.GetMultiSamples()), (0.25, 0.1, 4))

# SPDX-License-Identifier: BSD-3-Clause
"""A tilted sheet under a gradient sky, half reflecting, equals its baseline."""

import os
import pathlib

import water_test as wt
from vtkmodules.vtkTestingRendering import vtkTesting


def test_tilted_sheet_equals_its_baseline():
    """The picture of a tilted, half reflecting sheet under a gradient sky is the stored one."""
    view = wt.View((300, 225))
    view.renderer.GradientBackgroundOn()
    view.renderer.SetBackground(0.85, 0.88, 0.9)
    view.renderer.SetBackground2(0.25, 0.45, 0.75)
    for data, color in wt.curved_things():
        wt.add_actor(view.renderer, data, color, specular=0.5)
    wt.add_scene_light(view.renderer, (3, -5, 8))
    wt.add_water(view.renderer, wt.plane((0, 0, 0.1), wt.unit((0.2, 0.1, 1))), (-6, 6, -5, 9), 0.6)
    wt.place_camera(view.renderer, (2, -9, 3), (0, 0, 0), (1, 40))
    view.window.Render()

    baseline = pathlib.Path(os.environ["VTK_BASELINE_ROOT"]) / "TestWaterTiltedPicture.png"
    tester = vtkTesting()
    for argument in ("-T", str(wt.output_folder()), "-V", str(baseline)):
        tester.AddArgument(argument)
    tester.SetRenderWindow(view.window)
    wt.check_equal("regression test passed", tester.RegressionTest(10.0) == vtkTesting.PASSED, True)

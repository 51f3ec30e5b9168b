# SPDX-License-Identifier: BSD-3-Clause
"""State files, the state as a Python program, and a Python trace show the same picture again."""
import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
from water_scene import pv  # noqa: E402

water_scene.load()

LOOK = {"Preset": "lake", "Waves": "Sines", "SineWaves": [0.02, 1.5, 30.0, 0.01, 0.8, 80.0], "Refraction": "On",
        "WaterType": "3C", "Caustics": 0.5, "FoamDepth": 0.2, "TimeScale": 2.0, "MetresPerUnit": 1.0,
        "Quality": "high"}


def make(view):
    water_scene.add_sphere(view)
    shown = water_scene.add_water(view, **LOOK)
    scene = pv.GetAnimationScene()
    scene.EndTime = 4.0
    scene.AnimationTime = 1.25
    pv.Render(view)
    return shown


class TestState(unittest.TestCase):
    def setUp(self):
        pv.ResetSession()

    def check(self, name, expected):
        view = pv.GetActiveViewOrCreate("RenderView")
        view.ViewSize = water_scene.SIZE
        self.assertEqual(water_scene.differing(expected, water_scene.picture(view, name), 0), 0)

    def run_program(self, program, name, end=""):
        """Runs it by another pvpython, which has nothing of this one, and returns its picture."""
        file = water_scene.path(name + ".py")
        shot = water_scene.path(name + ".png")
        if os.path.exists(shot):
            os.remove(shot)
        with open(file, "w", encoding="utf-8") as stream:
            stream.write("import paraview.simple\nparaview.simple._DisableFirstRenderCameraReset()\n")
            stream.write("paraview.simple.LoadPlugin(%r, remote=False, ns=vars(paraview.simple))\n"
                         % water_scene.PLUGIN)
            stream.write(program)
            stream.write("\nview = GetActiveView()\nview.ViewSize = %r\n%s\n" % (list(water_scene.SIZE), end))
            stream.write("SaveScreenshot(%r, view, ImageResolution=%r)\n" % (shot, list(water_scene.SIZE)))
        done = subprocess.run([os.environ["WATER_PVPYTHON"], "--force-offscreen-rendering", file], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120, check=False)
        self.assertTrue(os.path.exists(shot), done.stdout)
        return water_scene.read(shot)

    def test_a_state_file_restores_the_picture(self):
        view = water_scene.make_view()
        make(view)
        expected = water_scene.picture(view, "state-expected")
        pv.SaveState(water_scene.path("state.pvsm"))
        pv.ResetSession()
        pv.LoadState(water_scene.path("state.pvsm"))
        self.check("state-loaded", expected)

    def test_the_state_as_a_program_restores_the_picture(self):
        from paraview import smstate
        view = water_scene.make_view()
        make(view)
        expected = water_scene.picture(view, "program-expected")
        program = smstate.get_state()
        self.assertIn("Water(", program)
        self.assertIn("'lake'", program)
        # such a program leaves the time out (ParaView 5.11), or sets it before the end of the animation (5.13): a time
        # after the end has no effect, and neither has the same time once more
        end = "scene = GetAnimationScene()\nscene.EndTime = 4.0\nscene.AnimationTime = 0.0\nscene.AnimationTime = 1.25"
        self.assertEqual(water_scene.differing(expected, self.run_program(program, "program-run", end), 0), 0)

    def test_a_trace_shows_the_water_again(self):
        from paraview import smtrace
        # what a program assigns is not traced, only what a user changes in the panels: so no look here
        look_across = "view.CameraPosition = [0.0, -6.0, 2.0]\nview.CameraFocalPoint = [0.0, 0.0, 0.2]\n" \
                      "view.CameraViewUp = [0.0, 0.0, 1.0]\nview.OrientationAxesVisibility = 0"
        smtrace.start_trace()
        view = pv.CreateView("RenderView")
        pv.Show(pv.Sphere(Center=[0.0, 0.0, 1.0]), view)
        pv.Show(pv.Water(Level=0.1, Extent="Bounds", SheetBounds=[-4.0, 4.0, -3.0, 4.0]), view)
        program = smtrace.stop_trace()
        view.ViewSize = water_scene.SIZE
        exec(look_across, {"view": view})
        expected = water_scene.picture(view, "trace-expected")
        self.assertIn("'WaterRepresentation'", program)
        self.assertRegex(program, r"SheetBounds ?= ?\[-4\.0, 4\.0, -3\.0, 4\.0\]")  # 6.1: by Set(...)
        self.assertEqual(water_scene.differing(expected, self.run_program(program, "trace-run", look_across), 0), 0)


water_scene.main()

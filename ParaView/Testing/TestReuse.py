# SPDX-License-Identifier: BSD-3-Clause
"""Frames in which nothing changes render no mirrored view; ParaView's levels of detail do."""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
from water_scene import pv  # noqa: E402

water_scene.load()


def renders(shown):
    return water_scene.of(shown, "ReflectionRenders")


class TestReuse(unittest.TestCase):
    def setUp(self):
        pv.ResetSession()
        self.view = water_scene.make_view()
        self.sphere = water_scene.add_sphere(self.view)
        self.shown = water_scene.add_water(self.view)
        pv.Render(self.view)
        pv.Render(self.view)

    def test_still_frames_use_the_mirrored_view_again(self):
        first = renders(self.shown)
        self.assertGreaterEqual(first, 1)
        for _ in range(5):
            pv.Render(self.view)
        self.assertEqual(renders(self.shown), first)
        self.assertIn("used again", water_scene.of(self.shown, "Decision"))

    def test_waves_that_move_use_it_again(self):
        self.shown.Waves = "Wind Sea"
        pv.Render(self.view)
        first = renders(self.shown)
        for time in (0.5, 1.0, 1.5):
            self.view.ViewTime = time
            pv.Render(self.view)
        self.assertEqual(water_scene.of(self.shown, "WaveTime"), 1.5)
        self.assertEqual(renders(self.shown), first)

    def test_what_changes_is_rendered_anew(self):
        for change in (lambda: setattr(self.sphere, "Radius", 0.4),
                       lambda: setattr(pv.GetDisplayProperties(self.sphere, self.view), "DiffuseColor", [0, 1, 0]),
                       lambda: setattr(pv.GetDisplayProperties(self.sphere, self.view), "Scale", [1.1, 1, 1]),
                       lambda: setattr(self.view, "CameraPosition", [0.5, -6.0, 2.0])):
            before = renders(self.shown)
            change()
            pv.Render(self.view)
            self.assertGreater(renders(self.shown), before)
            pv.Render(self.view)  # data that a representation has taken over may be new once more
            settled = renders(self.shown)
            pv.Render(self.view)
            self.assertEqual(renders(self.shown), settled)

    def test_levels_of_detail_are_mirrored_and_used_again(self):
        self.view.LODThreshold = 0.0  # all data count as large
        self.view.LODResolution = 0.0
        interactive = self.view.SMProxy.InteractiveRender
        interactive()
        interactive()
        coarse = renders(self.shown)
        for _ in range(3):
            interactive()
        self.assertEqual(renders(self.shown), coarse)
        pv.Render(self.view)
        fine = renders(self.shown)
        self.assertGreater(fine, coarse)  # of the whole sphere
        pv.Render(self.view)
        self.assertEqual(renders(self.shown), fine)
        interactive()
        self.assertGreater(renders(self.shown), fine)


water_scene.main()

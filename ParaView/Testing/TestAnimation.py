# SPDX-License-Identifier: BSD-3-Clause
"""The animation's time moves the waves, and a picture depends on its time alone."""
import glob
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
from water_scene import pv  # noqa: E402

water_scene.load()


class TestAnimation(unittest.TestCase):
    def setUp(self):
        pv.ResetSession()
        self.view = water_scene.make_view()
        water_scene.add_sphere(self.view)
        self.shown = water_scene.add_water(self.view, Waves="Wind Sea", WindSpeed=3.0, MetresPerUnit=1.0)
        self.scene = pv.GetAnimationScene()
        self.scene.PlayMode = "Sequence"
        self.scene.StartTime = 0.0
        self.scene.EndTime = 4.0
        self.scene.NumberOfFrames = 5

    def at(self, time, name):
        self.scene.AnimationTime = time
        return water_scene.picture(self.view, name)

    def test_a_picture_is_a_function_of_its_time(self):
        start = self.at(0.0, "time-0")
        there = self.at(3.0, "time-3")
        self.assertGreater(water_scene.differing(start, there), 2000)
        self.at(1.0, "time-1")
        self.assertEqual(water_scene.differing(there, self.at(3.0, "time-3-again"), 0), 0)
        self.assertEqual(water_scene.differing(start, self.at(0.0, "time-0-again"), 0), 0)

    def test_the_time_of_the_waves_has_a_scale_and_a_shift(self):
        self.shown.TimeScale = 0.5
        self.shown.TimeShift = 2.0
        scaled = self.at(2.0, "scaled")
        self.assertEqual(water_scene.of(self.shown, "WaveTime"), 3.0)
        self.shown.TimeScale = 1.0
        self.shown.TimeShift = 0.0
        self.assertEqual(water_scene.differing(scaled, self.at(3.0, "unscaled"), 0), 0)

    def test_a_saved_animation_has_the_pictures_of_its_times(self):
        for old in glob.glob(water_scene.path("movie.*.png")):
            os.remove(old)
        pv.SaveAnimation(water_scene.path("movie.png"), self.view, ImageResolution=list(water_scene.SIZE),
                         FrameWindow=[0, 4])
        frames = sorted(glob.glob(water_scene.path("movie.*.png")))
        self.assertEqual(len(frames), 5)
        for time, frame in enumerate(frames):
            alone = self.at(float(time), "movie-alone-%d" % time)
            self.assertEqual(water_scene.differing(water_scene.read(frame), alone, 0), 0, frame)

    def test_a_screenshot_may_have_another_size(self):
        small = water_scene.picture(self.view, "small", [160, 120])
        self.assertEqual(small.shape, (120, 160, 3))
        large = water_scene.picture(self.view, "large", [640, 480])  # larger than the view: in tiles
        self.assertEqual(large.shape, (480, 640, 3))
        coarse = large.reshape(120, 4, 160, 4, 3).mean(axis=(1, 3))
        self.assertLess(abs(coarse - small).mean(), 3.0)


water_scene.main()

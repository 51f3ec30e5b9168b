# SPDX-License-Identifier: BSD-3-Clause
"""The water of ParaView reflects what the view shows, at the right place."""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
from water_scene import pv  # noqa: E402

water_scene.load()


def red(picture):
    return (picture[:, :, 0] > 150) & (picture[:, :, 1] < 60) & (picture[:, :, 2] < 60)


class TestReflection(unittest.TestCase):
    def setUp(self):
        pv.ResetSession()

    def test_the_picture_changes_only_where_there_is_water(self):
        view = water_scene.make_view()
        water_scene.add_sphere(view)
        without = water_scene.picture(view, "without")
        water_scene.add_water(view)
        with_water = water_scene.picture(view, "with")
        self.assertGreater(water_scene.differing(without, with_water), 0.3 * without.shape[0] * without.shape[1])
        sky = without.shape[0] - 40  # rows above the sphere
        self.assertEqual(water_scene.differing(without[sky:], with_water[sky:], 0), 0)

    def test_the_mirrored_sphere_is_where_a_sphere_below_the_water_would_be(self):
        view = water_scene.make_view()
        water_scene.add_sphere(view)
        water_scene.add_water(view, Preset="mirror floor")
        reflected = red(water_scene.picture(view, "reflected"))
        pv.ResetSession()
        view = water_scene.make_view()
        water_scene.add_sphere(view)
        water_scene.add_sphere(view, -1.0)
        explicit = red(water_scene.picture(view, "explicit"))
        self.assertGreater(explicit.sum(), 8000)
        self.assertLess((reflected != explicit).sum(), 0.01 * explicit.sum())  # pixels at edges

    def test_a_hidden_water_is_gone_and_comes_back(self):
        view = water_scene.make_view()
        water_scene.add_sphere(view)
        without = water_scene.picture(view, "hidden-0")
        shown = water_scene.add_water(view)
        with_water = water_scene.picture(view, "hidden-1")
        shown.Visibility = 0
        self.assertEqual(water_scene.differing(without, water_scene.picture(view, "hidden-2"), 0), 0)
        shown.Visibility = 1
        self.assertEqual(water_scene.differing(with_water, water_scene.picture(view, "hidden-3"), 0), 0)
        pv.Delete(shown)
        del shown
        self.assertEqual(water_scene.differing(without, water_scene.picture(view, "hidden-4"), 0), 0)

    def test_level_extent_and_plane_are_those_of_the_source(self):
        view = water_scene.make_view()
        water_scene.add_sphere(view)
        water = pv.Water(Level=0.25, Extent="Bounds", SheetBounds=[-4.0, 4.0, -4.0, 4.0])
        pv.Show(water, view)
        level = water_scene.picture(view, "level")
        water.UsePlane = 1
        water.Origin = [0.0, 0.0, 0.25]
        plane = water_scene.picture(view, "plane")
        self.assertEqual(water_scene.differing(level, plane, 0), 0)
        water.Normal = [0.3, 0.0, 1.0]
        tilted = water_scene.picture(view, "tilted")
        self.assertGreater(water_scene.differing(level, tilted), 1000)
        water.UsePlane = 0
        water.SheetBounds = [-1.0, 1.0, -1.0, 1.0]
        smaller = water_scene.picture(view, "smaller")
        water.Extent = "Horizon"
        wider = water_scene.picture(view, "wider")
        water.Extent = "Automatic"  # a sphere above open water: to the horizon
        automatic = water_scene.picture(view, "automatic")
        self.assertGreater(water_scene.differing(level, smaller), 5000)
        self.assertGreater(water_scene.differing(wider, level), 1000)
        self.assertEqual(water_scene.differing(wider, automatic, 0), 0)

    def test_looks_change_the_picture(self):
        view = water_scene.make_view()
        water_scene.add_sphere(view)
        water_scene.add_sphere(view, -0.6, (1.0, 1.0, 0.0))
        shown = water_scene.add_water(view, MetresPerUnit=1.0)
        last = water_scene.picture(view, "look")
        changes = (
            ("Refraction", "On"), ("Preset", "turbid river"), ("Preset", "lake"), ("WaterType", "9C"),
            ("Waves", "Wind Sea"), ("WindSpeed", 9.0), ("WindDirection", 70.0), ("Fetch", 500.0), ("SeaSeed", 7),
            ("Waves", "Sines"), ("SineWaves", [0.02, 1.5, 30.0, 0.01, 0.8, 80.0]), ("DisplaceSurface", 1),
            ("Waves", "Calm"), ("UseDeepColor", 1), ("DeepColor", [0.5, 0.1, 0.1]), ("Refraction", "Off"),
            ("Refraction", "On"), ("UseDeepColor", 0), ("ShoreSoftness", 0.6), ("Refraction", "Off"),
            ("Opacity", 0.5), ("ReflectScene", 0), ("MetresPerUnit", 1.0))
        for number, (name, value) in enumerate(changes):
            setattr(shown, name, value)
            now = water_scene.picture(view, "look-%d-%s" % (number, name))
            same = name in ("MetresPerUnit",)
            self.assertEqual(water_scene.differing(last, now) == 0, same, (name, value))
            last = now

    def test_a_view_from_below_has_light_shafts(self):
        view = water_scene.make_view()
        view.CameraPosition = [0.0, -3.0, -1.5]
        view.CameraFocalPoint = [0.0, 0.0, -1.2]
        water_scene.add_sphere(view, -1.2, (0.8, 0.8, 0.8))
        view.UseLight = 0
        pv.AddLight(view=view).Position = [1.0, 1.0, 5.0]
        shown = water_scene.add_water(view, Preset="clear tropical", Waves="Sines",
                                      SineWaves=[0.03, 0.9, 30.0, 0.02, 0.6, 100.0])
        without = water_scene.picture(view, "shafts-0")
        shown.LightShafts = 1.0
        self.assertGreater(water_scene.differing(without, water_scene.picture(view, "shafts-1"), 2), 2000)
        self.assertEqual(water_scene.of(shown, "LastError"), "")
        shown.LightShafts = 0.0
        self.assertEqual(water_scene.differing(without, water_scene.picture(view, "shafts-2"), 0), 0)

    def test_a_dome_port_is_half_under_water(self):
        view = water_scene.make_view()
        view.CameraPosition = [0.0, -3.0, 0.02]
        view.CameraFocalPoint = [0.0, 0.0, 0.0]
        water_scene.add_sphere(view)
        water_scene.add_sphere(view, -0.6, (1.0, 1.0, 0.0))
        water = pv.Water(Extent="Horizon")
        shown = pv.Show(water, view)
        shown.Preset = "clear tropical"
        shown.Waves = "Calm"
        above = water_scene.picture(view, "port-0")
        shown.DomePort = 0.1
        half = water_scene.picture(view, "port-1")
        self.assertEqual(water_scene.of(shown, "LastError"), "")
        self.assertEqual(water_scene.differing(above[140:], half[140:], 1), 0)
        self.assertGreater(water_scene.differing(above[:60], half[:60], 2), 6000)

    def test_the_order_of_the_properties_does_not_matter(self):
        pictures = []
        for order in (("Preset", "Refraction", "UseDeepColor"), ("UseDeepColor", "Refraction", "Preset")):
            pv.ResetSession()
            view = water_scene.make_view()
            water_scene.add_sphere(view)
            shown = water_scene.add_water(view)
            for name in order:
                setattr(shown, name, {"Preset": "lake", "Refraction": "Off", "UseDeepColor": 1}[name])
            pictures.append(water_scene.picture(view, "order-%d" % len(pictures)))
        self.assertEqual(water_scene.differing(pictures[0], pictures[1], 0), 0)


water_scene.main()

# SPDX-License-Identifier: BSD-3-Clause
"""Sheets of each extent, with an automatic unit, are on ranks what they are in one process.

No more pixels may be off than 1.1 times those that are without water, or one in 5,000.
"""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
import data_scene  # noqa: E402
import ranks  # noqa: E402

PROGRAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), "extents_program.py")
PIXELS = water_scene.SIZE[0] * water_scene.SIZE[1]


class TestExtents(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        data_scene.make_steps()
        ranks.batch(1, "extents-1", program=PROGRAM)

    def check(self, name):
        for scene in ("balls", "basin"):
            dry = ranks.pixels("extents-1-%s-dry" % scene, "%s-%s-dry" % (name, scene))
            for extent in ("Automatic", "Scene", "Horizon", "Bounds"):
                wet = ranks.pixels("extents-1-%s-%s" % (scene, extent), "%s-%s-%s" % (name, scene, extent))
                print("%s, %s, %s: %d pixels are off, %d without water" % (name, scene, extent, wet, dry))
                with self.subTest(name=name, scene=scene, extent=extent):
                    self.assertLessEqual(wet, max(1.1 * dry, PIXELS / 5000))

    def test_pvbatch(self):
        for count in (2, 4):
            name = "extents-%d" % count
            said = ranks.batch(count, name, program=PROGRAM)
            self.assertNotIn("ERROR", said)
            self.check(name)

    def test_pvserver(self):
        _, said = ranks.server(2, [PROGRAM, "extents-server", "--server"])
        self.assertNotIn("ERROR", said)
        self.check("extents-server")


water_scene.main()

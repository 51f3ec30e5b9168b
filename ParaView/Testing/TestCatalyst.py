# SPDX-License-Identifier: BSD-3-Clause
"""A simulation in Python hands its steps over to Catalyst, which writes pictures of its water."""
import glob
import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
import ranks  # noqa: E402

PROGRAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../Examples/catalyst_simulation.py")


class TestCatalyst(unittest.TestCase):
    def test_every_second_step_has_a_picture_of_its_water(self):
        for old in glob.glob(water_scene.path("water_*.png")):
            os.remove(old)
        done = subprocess.run([os.environ["WATER_PYTHON"], PROGRAM, "6"], text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=120, check=False,
                              env=dict(ranks.ENVIRONMENT, WATER_PICTURES=water_scene.OUTPUT))
        self.assertIn("the end", done.stdout)
        self.assertNotIn("Traceback", done.stdout)
        names = sorted(os.path.basename(name) for name in glob.glob(water_scene.path("water_*.png")))
        self.assertEqual(names, ["water_0000.png", "water_0002.png", "water_0004.png"])
        wet = [int((picture[:, :, 2] > picture[:, :, 0] + 40).sum())
               for picture in (water_scene.read(water_scene.path(name)) for name in names)]
        self.assertGreater(wet[0], 20000)
        self.assertGreater(wet[1], wet[0] + 5000)
        self.assertGreater(wet[2], wet[1] + 5000)


water_scene.main()

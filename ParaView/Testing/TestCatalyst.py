# SPDX-License-Identifier: BSD-3-Clause
"""A simulation in Python hands its steps over to Catalyst, which writes pictures of its water; on two ranks the same."""
import glob
import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
import ranks  # noqa: E402

PROGRAM = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../Examples/catalyst_simulation.py")


def simulate(count):
    """Six steps on so many ranks. Returns what they say, and the pictures by their names."""
    folder = water_scene.path("catalyst-%d" % count)
    os.makedirs(folder, exist_ok=True)
    for old in glob.glob(os.path.join(folder, "*.png")):
        os.remove(old)
    done = subprocess.run(ranks.on_ranks(count, [os.environ["WATER_PYTHON"], PROGRAM, "6"]), text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=280, check=False,
                          env=dict(ranks.ENVIRONMENT, WATER_PICTURES=folder))
    return done.stdout, {os.path.basename(name): water_scene.read(name)
                         for name in sorted(glob.glob(os.path.join(folder, "*.png")))}


class TestCatalyst(unittest.TestCase):
    def test_every_second_step_has_a_picture_of_its_water(self):
        said, pictures = simulate(1)
        self.assertEqual(said.count("the end"), 1, said)
        self.assertNotIn("Traceback", said)
        self.assertEqual(list(pictures), ["water_0000.png", "water_0002.png", "water_0004.png"])
        wet = [int((picture[:, :, 2] > picture[:, :, 0] + 40).sum()) for picture in pictures.values()]
        self.assertGreater(wet[0], 20000)
        self.assertGreater(wet[1], wet[0] + 5000)
        self.assertGreater(wet[2], wet[1] + 5000)

    def test_two_ranks_have_the_same_pictures(self):
        _, expected = simulate(1)
        said, pictures = simulate(2)
        self.assertEqual(said.count("the end"), 2, said)
        self.assertNotIn("Traceback", said)
        self.assertEqual(list(pictures), list(expected))
        for name, picture in pictures.items():
            off = water_scene.differing(picture, expected[name])
            print("%s: %d pixels of 2 ranks are off" % (name, off))
            self.assertLess(off, 0.0002 * picture.shape[0] * picture.shape[1], name)


water_scene.main()

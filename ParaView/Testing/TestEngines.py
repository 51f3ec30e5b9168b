# SPDX-License-Identifier: BSD-3-Clause
"""On the ranks of MPI, water is the serial one with each engine of ParaView's VTK that joins their pictures.

WaterEngines is a program in C++, which mpirun starts; it prints a line for each look.
"""
import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
import ranks  # noqa: E402

LOOKS = {"depth": 3, "icet": 3, "blend": 6, "icet-ordered": 6}


class TestEngines(unittest.TestCase):
    def check(self, engine):
        for count in (2, 4):
            command = ranks.on_ranks(count, [os.environ["WATER_ENGINES"], engine])
            done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  timeout=ranks.LIMIT, check=False, env=ranks.ENVIRONMENT)
            print(done.stdout)
            self.assertEqual(done.returncode, 0)
            self.assertEqual(done.stdout.count(") ok"), LOOKS[engine])

    def test_pictures_compared_by_depth(self):
        self.check("depth")

    def test_pictures_blended_by_a_tree(self):
        self.check("blend")

    def test_icet_comparing_depths(self):
        self.check("icet")

    def test_icet_blending_in_order(self):
        self.check("icet-ordered")


water_scene.main()

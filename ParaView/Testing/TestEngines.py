# SPDX-License-Identifier: BSD-3-Clause
"""On the ranks of MPI, water is the serial one with each engine of ParaView's VTK that joins their pictures.

Its argument names the engine. WaterEngines is a program in C++, which mpirun starts; it prints a line for each look.
"""
import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
import ranks  # noqa: E402

LOOKS = {"depth": 6, "icet": 6, "blend": 15, "icet-ordered": 15}
ENGINE = sys.argv.pop() if sys.argv[-1] in LOOKS else "depth"


class TestEngines(unittest.TestCase):
    def check(self, count):
        done = subprocess.run(ranks.on_ranks(count, [os.environ["WATER_ENGINES"], ENGINE]), text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=ranks.LIMIT, check=False,
                              env=ranks.ENVIRONMENT)
        print(done.stdout)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(done.stdout.count(") ok"), LOOKS[ENGINE])

    def test_two_ranks(self):
        self.check(2)

    def test_four_ranks(self):
        self.check(4)


water_scene.main()

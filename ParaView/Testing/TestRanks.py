# SPDX-License-Identifier: BSD-3-Clause
"""Several ranks show the water of one rank, as nearly as ParaView shows the same scene without water."""
import os
import re
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
PROGRAM = os.path.join(HERE, "ranks_program.py")
MPIRUN = [os.environ["WATER_MPIRUN"], "--oversubscribe", "--bind-to", "none"]
LIMIT = 240  # seconds, for a hang
# without what says that this process is a rank already: pvpython is one of MPI's programs, too
ENVIRONMENT = {name: value for name, value in os.environ.items()
               if not name.startswith(("OMPI_", "PMIX_")) or name.startswith("OMPI_ALLOW_RUN_AS_ROOT")}


def run(command):
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=LIMIT,
                          check=False, env=ENVIRONMENT)
    if done.returncode != 0 or "the end" not in done.stdout:
        raise AssertionError("%s\n%s" % (" ".join(command), done.stdout[-4000:]))
    return done.stdout


def batch(ranks, name, *arguments):
    """Pictures and counts of pvbatch on so many ranks."""
    command = [os.environ["WATER_PVBATCH"], "--force-offscreen-rendering", PROGRAM, name, *arguments]
    return run(command if ranks == 1 else MPIRUN + ["-np", str(ranks)] + command)


def pixels(one, other):
    return water_scene.differing(water_scene.read(water_scene.path(one + ".png")),
                                 water_scene.read(water_scene.path(other + ".png")))


def counts(said, name):
    """The numbers that a line of the program's output gives."""
    return [int(number) for number in re.search(name + r":([ \d]+)", said).group(1).split()]


class TestRanks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        batch(1, "dry-1", "--dry")
        batch(1, "calm-1", "--look", "calm")

    def check_picture(self, name, floor):
        """No more pixels are off with water than 1.1 times those that are without it."""
        for end in ("", "-animation"):
            dry = pixels("dry-1" + end, floor + end)
            wet = pixels("calm-1" + end, name + end)
            print("%s%s: %d pixels are off, %d without water" % (name, end, wet, dry))
            self.assertLessEqual(wet, 1.1 * dry)

    def check_counts(self, said):
        static = counts(said, "pixels joined in still frames")
        self.assertEqual(set(static), {0}, said)
        self.assertGreater(counts(said, "pixels joined when moved")[0], 1000)

    def test_pvbatch(self):
        for ranks in (2, 4):
            floor = "dry-%d" % ranks
            batch(ranks, floor, "--dry")
            name = "calm-%d" % ranks
            said = batch(ranks, name, "--look", "calm")
            self.check_picture(name, floor)
            self.check_counts(said)


water_scene.main()

# SPDX-License-Identifier: BSD-3-Clause
"""Several ranks show the water of one rank, as nearly as ParaView shows the same scene without water.

Its argument chooses the scene of ranks_program.py.
"""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
import ranks  # noqa: E402

SERVERS = {"calm": (1, 2, 4), "sea": (2,), "basin": (1, 2), "balls": (2,)}  # ranks
SCENE = sys.argv.pop() if sys.argv[-1] in ("calm", "sea", "basin", "balls") else "calm"


class TestRanks(unittest.TestCase):
    """Pictures of one rank, and of several without water, are made once."""

    @classmethod
    def setUpClass(cls):
        if SCENE == "basin":
            import data_scene
            data_scene.make_steps()
        ranks.batch(1, SCENE + "-dry-1", "--dry", "--look", SCENE)
        ranks.batch(1, SCENE + "-1", "--look", SCENE)
        cls.floors = {1: SCENE + "-dry-1"}
        for count in (2, 4):
            cls.floors[count] = "%s-dry-%d" % (SCENE, count)
            ranks.batch(count, cls.floors[count], "--dry", "--look", SCENE)

    def check_picture(self, name, count, end="", serial=""):
        """No more pixels are off with water than 1.1 times those that are without it; blended: RMS 1 of 255 more."""
        of_dry = SCENE + "-dry-1" + serial, self.floors[count] + serial
        of_wet = SCENE + "-1" + serial, name + end
        if SCENE == "balls":
            dry, wet = ranks.rms(*of_dry), ranks.rms(*of_wet)
            print("%s%s: RMS %.3f of 255, %.3f without water" % (name, end, wet, dry))
            self.assertLessEqual(wet, dry + 1.0)
            return
        dry, wet = ranks.pixels(*of_dry), ranks.pixels(*of_wet)
        print("%s%s: %d pixels are off, %d without water" % (name, end, wet, dry))
        self.assertLessEqual(wet, 1.1 * dry)

    def check_counts(self, said):
        static = ranks.counts(said, "pixels joined in still frames")
        self.assertEqual(set(static), {0}, said)
        self.assertGreater(ranks.counts(said, "pixels joined when moved")[0], 1000)

    def test_pvbatch(self):
        for count in (2, 4):
            name = "%s-%d" % (SCENE, count)
            said = ranks.batch(count, name, "--look", SCENE)
            self.check_picture(name, count)
            self.check_picture(name, count, "-animation", "-animation")
            self.check_counts(said)

    def test_pvserver(self):
        """It renders, then the client does, then the server again, and all frames of an animation."""
        for count in SERVERS[SCENE]:
            name = "%s-server-%d" % (SCENE, count)
            _, said = ranks.server(count, [ranks.PROGRAM, name, "--look", SCENE, "--server"])
            self.assertNotIn("ERROR", said)
            self.check_picture(name, count)
            self.check_picture(name, count, "-local")
            self.check_picture(name, count, "-remote-again")
            self.check_picture(name, count, "-animation", "-animation")


water_scene.main()

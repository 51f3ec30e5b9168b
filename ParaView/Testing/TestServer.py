# SPDX-License-Identifier: BSD-3-Clause
"""A client and a server, of which one, both or none has the plugin."""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
from water_scene import pv  # noqa: E402
import ranks  # noqa: E402

CLIENT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "client_program.py")


def make_state():
    water_scene.load()
    view = water_scene.make_view()
    water_scene.add_sphere(view)
    water_scene.add_water(view)
    picture = water_scene.picture(view, "client-alone")
    pv.SaveState(water_scene.path("client.pvsm"))
    return picture


class TestServer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.alone = make_state()

    def test_both_have_it(self):
        said, _ = ranks.server(2, [CLIENT, "both"])
        self.assertNotIn("refused", said)
        picture = water_scene.read(water_scene.path("client-both.png"))
        self.assertLess(water_scene.differing(self.alone, picture), 40)

    def test_without_it_the_server_has_no_water(self):
        for who in ("none", "local"):
            said, _ = ranks.server(2, [CLIENT, who])
            self.assertIn("refused: module 'paraview.simple' has no attribute 'Water'", said)

    def test_a_state_without_it_names_what_is_missing(self):
        said, _ = ranks.server(1, [CLIENT, "state", water_scene.path("client.pvsm")])
        self.assertRegex(said, "Water")

    def test_a_client_without_it_is_told_what_it_lacks(self):
        """ParaView itself ends the client then; the server ends, too."""
        with self.assertRaisesRegex(AssertionError, "Failed to create 'vtkPVWater"):
            ranks.server(2, [CLIENT, "remote"])


water_scene.main()

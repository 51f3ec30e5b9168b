# SPDX-License-Identifier: BSD-3-Clause
"""A client of a server, for TestServer.py: client_program.py none|local|remote|both|state [STATE] PORT.

The first argument says which of the two loads the plugin; state: neither, and a state file with water is loaded.
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
from water_scene import pv  # noqa: E402

who, port = sys.argv[1], sys.argv[-1]
pv.Connect("localhost", int(port))
if who in ("remote", "both"):
    water_scene.load(remote=True)
if who in ("local", "both"):
    water_scene.load()
view = water_scene.make_view()
water_scene.add_sphere(view)
try:
    if who == "state":
        pv.LoadState(sys.argv[2])
    else:
        pv.Show(pv.Water(Extent="Bounds", SheetBounds=[-4.0, 4.0, -4.0, 4.0]), view)
except Exception as error:
    print("refused:", error)
water_scene.picture(view, "client-" + who)
print("the end")
sys.stdout.flush()

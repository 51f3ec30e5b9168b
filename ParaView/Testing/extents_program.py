# SPDX-License-Identifier: BSD-3-Clause
"""Water of each extent, with an automatic unit, for TestExtents.py: pvbatch on some ranks, or a client of a server.

    extents_program.py NAME [--server PORT]

Writes NAME-*.png: balls in open water, and the solver's basin of data_scene.py with water up to its shore; both without
water, too. Says for each water the error, if there is one.
"""
import argparse
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
from water_scene import pv  # noqa: E402
import data_scene  # noqa: E402

EXTENTS = ("Automatic", "Scene", "Horizon", "Bounds")
COLORS = ((1.0, 0.0, 0.0), (0.2, 0.8, 0.1), (0.9, 0.8, 0.1))


def balls(view):
    """In open water: each rank has a part of each."""
    for number, color in enumerate(COLORS):
        ball = pv.Sphere(Radius=0.5, Center=[1.4 * (number - 1), 0.4 * number, 0.45], ThetaResolution=48,
                         PhiResolution=48)
        shown = pv.Show(ball, view)
        shown.DiffuseColor = shown.AmbientColor = list(color)


def basin(view):
    """Ground under all of the water: each rank has a part of it."""
    data_scene.open_steps(view)
    water_scene.add_sphere(view, 1.2)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("name")
    parser.add_argument("--server")
    options = parser.parse_args()
    water_scene.begin(options.server)
    for scene in (balls, basin):
        view = water_scene.make_view()
        view.RemoteRenderThreshold = 0.0
        scene(view)
        pv.Render(view)
        water_scene.picture(view, "%s-%s-dry" % (options.name, scene.__name__))
        for extent in EXTENTS:
            water = pv.Water(Level=0.3 if scene is basin else 0.0, Extent=extent, SheetBounds=[-4.0, 4.0, -4.0, 4.0])
            shown = pv.Show(water, view)
            shown.Waves = "Wind Sea"
            shown.WindSpeed = 3.0
            shown.Refraction = "On"
            shown.WaterType = "3C"
            shown.MetresPerUnit = 0.0
            pv.Render(view)
            water_scene.picture(view, "%s-%s-%s" % (options.name, scene.__name__, extent))
            print(scene.__name__, extent, "error:", water_scene.of(shown, "LastError"))
            pv.Delete(shown)
            pv.Delete(water)
            del shown, water
        pv.Delete(view)
        del view
    print("the end")
    sys.stdout.flush()


main()

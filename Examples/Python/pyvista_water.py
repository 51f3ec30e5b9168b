# SPDX-License-Identifier: BSD-3-Clause
"""pyvista_water: water in a PyVista scene. Writes pyvista_water.png, or the file that it is given."""

import argparse

import pyvista as pv
from vtkwater.pictures import png_name

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("picture", nargs="?", default="pyvista_water.png", type=png_name, help="default: %(default)s")
picture = parser.parse_args().picture

plotter = pv.Plotter(off_screen=True, window_size=(640, 400))
plotter.set_background("white", top="lightskyblue")
plotter.add_mesh(pv.Cone(direction=(0.3, 0, 1), resolution=64), color="tomato")
plotter.camera_position = [(0.0, -3.5, 0.6), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)]
# README: from here
import vtkwater.pyvista

water = plotter.add_water(level=-0.2, waves=[(0.004, 0.6, 30), (0.0025, 0.35, 75)], bounds=(-9, 9, -9, 9))
plotter.screenshot(picture)
# README: to here

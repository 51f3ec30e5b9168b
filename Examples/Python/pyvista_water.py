# SPDX-License-Identifier: BSD-3-Clause
"""pyvista_water: water in a PyVista scene. Writes pyvista_water.png, or the file that it is given."""

import argparse

import pyvista
from vtkwater.pictures import png_name

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("picture", nargs="?", default="pyvista_water.png", type=png_name, help="default: %(default)s")
picture = parser.parse_args().picture
pyvista.OFF_SCREEN = True  # a picture in place of a window
pyvista.global_theme.window_size = (800, 500)
pyvista.global_theme.before_close_callback = lambda plotter: plotter.screenshot(picture)

# README: from here
import pyvista as pv
import vtkwater.pyvista

plotter = pv.Plotter()
plotter.add_mesh(pv.examples.load_random_hills(), color="tan")
plotter.add_water(level=3)
plotter.camera.azimuth, plotter.camera.elevation = 270, -25  # look across the water
plotter.camera.zoom(1.5)
plotter.show()
# README: to here

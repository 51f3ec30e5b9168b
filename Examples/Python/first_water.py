# SPDX-License-Identifier: BSD-3-Clause
"""first_water: a cone stands in water. Writes first_water.png, or the file that it is given."""

import argparse

from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow
from vtkwater.errors import ending
from vtkwater.pictures import png_name, write_png

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("picture", nargs="?", default="first_water.png", type=png_name, help="default: %(default)s")
picture = parser.parse_args().picture

# README: from here
from vtkwater import vtkWaterActor

cone = vtkConeSource()
cone.SetDirection(0.3, 0.0, 1.0)
cone.SetResolution(64)
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(cone.GetOutputPort())
actor = vtkActor()
actor.SetMapper(mapper)
actor.GetProperty().SetColor(0.90, 0.45, 0.25)

water = vtkWaterActor()
water.SetLevel(-0.2)
water.SetSheetBounds(-9.0, 9.0, -9.0, 9.0)  # without it: as wide as the scene

renderer = vtkRenderer()
renderer.SetBackground(0.72, 0.80, 0.88)
renderer.AddActor(actor)
renderer.AddActor(water)  # that is all
# README: to here
renderer.GetActiveCamera().SetPosition(0.0, -3.5, 0.3)
renderer.GetActiveCamera().SetFocalPoint(0.0, 0.0, 0.0)
renderer.GetActiveCamera().SetViewUp(0.0, 0.0, 1.0)
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetSize(640, 400)
window.AddRenderer(renderer)

with ending("first_water"):
    write_png(window, picture)

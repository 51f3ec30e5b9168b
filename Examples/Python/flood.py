# SPDX-License-Identifier: BSD-3-Clause
"""flood: an elevation model under water, with a slider for the level.

Opens a window; with --picture it renders off-screen instead.
"""

import argparse
import pathlib

import vtkmodules.vtkInteractionStyle  # noqa: F401
from vtkmodules.vtkRenderingCore import vtkRenderWindowInteractor
from vtkmodules.vtkRenderingUI import vtkGenericRenderWindowInteractor
from vtkwater.backend import check_display
from vtkwater.errors import ending
from vtkwater.pictures import png_name
from vtkwater.readers import read
from vtkwater.scenes import Scene
from vtkwater.widgets import LevelSlider

TERRAIN = pathlib.Path(__file__).resolve().parents[1] / "Data/jacksboro.vti"
EXAGGERATION = 2.0  # heights are drawn this many times higher than they are


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("terrain", nargs="?", default=TERRAIN, help="a GeoTIFF or VTK image; default: %(default)s")
    parser.add_argument("--level", type=float, help="of the water at first; default: a third of the relief")
    parser.add_argument("--picture", type=png_name, metavar="FILE.png", help="render this and end")
    arguments = parser.parse_args()
    terrain = read(arguments.terrain)
    low, high = terrain.data.GetBounds()[4:]
    level = arguments.level if arguments.level is not None else low + 0.33 * (high - low)
    if not low <= level <= high:
        raise ValueError(f"level {level:g} is outside of the terrain's heights, {low:g} to {high:g}")

    scene = Scene((1280, 720))
    if not arguments.picture:
        check_display(scene.window, "give --picture FILE.png")
    scene.add_ground(terrain, level, EXAGGERATION)
    water = scene.add_water(level, "lake", wind=0, exaggeration=EXAGGERATION)
    scene.make_island()
    scene.set_sun(150.0, 28.0)
    scene.look(azimuth=105.0, height=3.0, zoom=6.8)  # low over the water: what it mirrors is seen
    if arguments.picture:
        interactor = vtkGenericRenderWindowInteractor()
    else:
        scene.window.SetOffScreenRendering(False)
        interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(scene.window)
    slider = LevelSlider(interactor, water, EXAGGERATION * low, EXAGGERATION * high, title="water level",
                         changed=lambda drawn: slider.widget.GetRepresentation().SetTitleText(
                             f"water level {drawn / EXAGGERATION:.0f} m"))
    slider.widget.GetRepresentation().ShowSliderLabelOff()  # it would be of the heights as drawn
    slider.widget.GetRepresentation().SetTitleText(f"water level {level:.0f} m")
    if arguments.picture:
        scene.write(arguments.picture)
    else:
        interactor.Start()


if __name__ == "__main__":
    with ending("flood"):
        main()

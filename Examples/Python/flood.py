# SPDX-License-Identifier: BSD-3-Clause
"""flood: an elevation model under water, with a slider for the level.

Opens a window; with --picture it renders off-screen instead.
"""

import argparse
import pathlib

import vtkmodules.vtkInteractionStyle  # noqa: F401
from vtkmodules.vtkRenderingCore import vtkRenderWindowInteractor
from vtkmodules.vtkRenderingUI import vtkGenericRenderWindowInteractor
from vtkwater.readers import FileError, read
from vtkwater.scenes import Scene
from vtkwater.widgets import LevelSlider

TERRAIN = pathlib.Path(__file__).resolve().parents[1] / "Data/jacksboro.vti"
EXAGGERATION = 2.0  # heights are drawn this many times higher than they are
FLOODED_AROUND = 10.0  # times the terrain's width: no edge of the water is seen


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("terrain", nargs="?", default=TERRAIN, help="a GeoTIFF or VTK image; default: %(default)s")
    parser.add_argument("--level", type=float, help="of the water at first; default: a third of the relief")
    parser.add_argument("--picture", metavar="FILE.png", help="render this and end")
    arguments = parser.parse_args()
    try:
        terrain = read(arguments.terrain)
    except FileError as error:
        raise SystemExit(f"flood: {error}") from None
    low, high = terrain.data.GetBounds()[4:]
    level = arguments.level if arguments.level is not None else low + 0.33 * (high - low)
    if not low <= level <= high:
        raise SystemExit(f"flood: level {level:g} is outside of the terrain's heights, {low:g} to {high:g}")

    scene = Scene((1280, 720))
    scene.add_ground(terrain, level, EXAGGERATION)
    water = scene.add_water(level, "lake", wind=0, exaggeration=EXAGGERATION)
    west, east, south, north = terrain.data.GetBounds()[:4]
    reach = FLOODED_AROUND * max(east - west, north - south)
    water.SetSheetBounds(west - reach, east + reach, south - reach, north + reach)
    scene.set_sun(150.0, 28.0)
    scene.look(azimuth=105.0, height=3.0, zoom=6.5)  # low over the water: what it mirrors is seen
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
    main()

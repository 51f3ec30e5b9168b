# SPDX-License-Identifier: BSD-3-Clause
"""vtk_water: this project's water in VTK, as it comes, and with half the texture scale.

The waves are three sines, together of the rms slope 0.05, ray traced: what AddWave alone gives.
They are as long as they have to be to be seen from the height of the eye.
"""

import math
import sys

from peer import read_scene, serve
from vtk_view import VERSION, View, driver, read_terrain

import vtkwater

RMS_SLOPE = 0.05
WAVES = ((150.0, 20.0), (97.0, 75.0), (61.0, -40.0))  # wavelength in m, direction in degrees


def watery_view(scene, terrain, texture_scale, with_waves):
    view = View(scene, terrain)
    view.water = vtkwater.vtkWaterActor()
    view.water.SetLevel(0.0)
    view.water.SetSheetBounds(scene["sheet"])
    view.water.GetReflectionPass().SetTextureScale(texture_scale)
    if with_waves:
        # a sine of amplitude A and wavelength L has the mean square slope (2 pi A / L)^2 / 2
        steepness = RMS_SLOPE * math.sqrt(2.0 / len(WAVES))
        for wavelength, direction in WAVES:
            amplitude = steepness * wavelength / (2.0 * math.pi)
            view.water.GetWaterProperty().AddWave(amplitude, wavelength, direction)
    view.renderer.AddActor(view.water)
    return view


def main():
    scene = read_scene(sys.argv[1])
    terrain = read_terrain(scene["terrain"])
    views = {"plain": View(scene, terrain)}
    for name, with_waves in (("calm", False), ("waves", True)):
        views[name] = watery_view(scene, terrain, 1.0, with_waves)
        views[f"{name}-half"] = watery_view(scene, terrain, 0.5, with_waves)
    serve(views, f"VTK::RenderingWater, {VERSION}", driver(views["plain"]))


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: BSD-3-Clause
"""tide: a tide and a storm surge over a barrier island and its bay, as an animation.

The level is the semidiurnal tide M2 with the surge of a storm that passes in 12 hours. Ctrl-C stops and keeps
the frames that are done.
"""

import argparse
import math
import sys

import numpy as np
from vtkwater import movies
from vtkwater.errors import ending
from vtkwater.pictures import png_name
from vtkwater.readers import surface_of_heights
from vtkwater.scenes import Scene

try:
    from tqdm import tqdm
except ImportError:  # without a bar
    tqdm = iter

M2_HOURS, TIDE, SURGE = 12.42, 0.7, 2.4  # period; amplitudes in m
DURATION_HOURS, PEAK_HOURS, WIDTH_HOURS = 30.0, 17.0, 4.0
WIND, STORM_WIND = 4.0, 14.0  # m/s
EXAGGERATION = 20.0


def bathymetry(size=(240, 640), spacing=25.0):
    """Heights in m: sea in the south, an island with dunes and an inlet, a bay with marshes, the mainland."""
    y, x = np.mgrid[0:size[0], 0:size[1]] * spacing
    wobble = 120.0 * np.sin(x / 900.0) + 60.0 * np.sin(x / 310.0 + 1.0)
    offshore = (y - 1700.0 - wobble) / 1700.0
    heights = 7.0 * np.tanh(1.6 * offshore) - 0.5
    heights = np.where(offshore > 0, -1.6 + 0.25 * np.sin(x / 150.0) * np.sin(y / 170.0), heights)  # the bay
    dunes = np.exp(-(((y - 1900.0 - wobble) / 260.0) ** 2))
    inlet = 1.0 - np.exp(-(((x - 3900.0) / 230.0) ** 2))
    heights += dunes * inlet * (5.4 + 0.8 * np.sin(x / 210.0) + 0.5 * np.sin(x / 77.0))
    mainland = np.clip((y - 4300.0 - 2.0 * wobble) / 1300.0, 0.0, 1.0)
    hills = 15.0 + 3.0 * np.sin(x / 700.0) + 1.5 * np.sin(x / 260.0 + y / 900.0)
    return heights + hills * mainland + 1.1 * np.exp(-(((x - 1500.0) / 500.0) ** 2) - ((y - 3300.0) / 300.0) ** 2), spacing


def sea(hours):
    """Level in m and wind in m/s."""
    storm = math.exp(-(((hours - PEAK_HOURS) / WIDTH_HOURS) ** 2))
    return TIDE * math.sin(2.0 * math.pi * hours / M2_HOURS) + SURGE * storm, WIND + (STORM_WIND - WIND) * storm


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("movie", nargs="?", default="tide.gif", help=f"{', '.join(movies.KINDS)}; default: %(default)s")
    parser.add_argument("--frames", type=int, default=30, help="default: %(default)s")
    parser.add_argument("--picture", type=png_name, metavar="FILE.png", help="the frame of the highest water, besides")
    arguments = parser.parse_args()

    heights, spacing = bathymetry()
    scene = Scene((800, 450))
    scene.add_ground(surface_of_heights(heights, (spacing, spacing)), 0.0, EXAGGERATION)
    water = scene.add_water(0.0, "clear tropical", wind=WIND)
    water.GetWaterProperty().SetFetch(20e3)  # m
    water.GetWaterProperty().SetRayTraceQualityToHigh()  # rays also find what is behind the nearest objects
    water.GetWaterProperty().SetFoamDepth(0.3 * EXAGGERATION)
    water.SetSheetBounds(-80e3, 96e3, -80e3, 6e3)  # the open sea to the horizon; land is in the north
    scene.set_sun(105.0, 35.0)
    scene.set_camera((4800.0, 1000.0, 190.0), (7600.0, 2250.0, 0.0), 32.0)
    hours = [DURATION_HOURS * i / max(arguments.frames - 1, 1) for i in range(arguments.frames)]
    highest = max(hours, key=lambda hour: sea(hour)[0], default=0.0)
    levels = []
    with movies.open_movie(arguments.movie, 10.0) as movie, movies.interrupts() as is_stopped:
        for i, hour in enumerate(tqdm(hours)):
            if is_stopped():
                break
            level, wind = sea(hour)
            water.SetLevel(EXAGGERATION * level)
            water.GetWaterProperty().SetWindSpeed(wind)
            water.SetTime(0.1 * i)  # the waves go on as one sees them; hours would blur them
            movie.add(scene.picture())
            if arguments.picture and hour == highest:
                scene.write(arguments.picture)
            levels.append(level)
    print(f"{arguments.movie}: {len(levels)} of {arguments.frames} frames, highest water {max(levels, default=0.0):.2f} m")
    return 130 if is_stopped() else 0


if __name__ == "__main__":
    with ending("tide"):
        sys.exit(main())

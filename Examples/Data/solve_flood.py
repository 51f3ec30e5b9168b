#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""solve_flood: a rain flood or a dam break over the land of jacksboro.vti, by landlab's solver OverlandFlow.

    pip install "landlab==2.9.2" vtk
    python solve_flood.py jacksboro.vti flood.npz
    python solve_flood.py jacksboro.vti dam_flood.npz --dam

The solver is that of de Almeida, Bates, Freer and Souvignet 2012, "Improving the stability of a simple formulation of
the shallow water equations for 2-D flood modeling". Rain falls evenly for some hours on a part of the map; or a lake is
behind a dam across a valley, and at the start the dam is gone. The water leaves over the border. README.md says what is
written.
"""

import argparse

import numpy as np
from landlab import RasterModelGrid
from landlab.components import OverlandFlow
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

FIRST, COUNT = (150, 40), (180, 150)  # columns and rows of the map
RAIN, RAIN_HOURS = 0.06, 2.0  # m/h
HOURS, FRAMES = 6.0, 61
FRICTION = 0.05  # Manning's, of rough grass
THIN = 1e-5  # m of water that the solver wants everywhere
COARSEST = 0.01  # m: depths are kept in such steps
# The dam break: another part of the map, with points between its points.
DAM_FIRST, DAM_COUNT, FINER = (150, 85), (80, 65), 2
DAM = (38.0, 28.0), (44.0, 44.0)  # ends of the dam, in columns and rows of this part
UPSTREAM = 46, 33  # a place in the lake
LAKE_LEVEL = 565.0  # m
DAM_HOURS = 0.25


def land(path, first, count):
    """Heights of a part, from south to north and from west to east, and the spacing, m."""
    reader = vtkXMLImageDataReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    heights = vtk_to_numpy(image.GetPointData().GetArray("elevation")).reshape(rows, columns).astype(float)
    return heights[first[1]:first[1] + count[1], first[0]:first[0] + count[0]], image.GetSpacing()[:2]


def finer(heights, spacing):
    """The same land with points between, bilinear."""
    for axis in (0, 1):
        old = np.arange(heights.shape[axis])
        new = np.linspace(0, old[-1], FINER * old[-1] + 1)
        heights = np.apply_along_axis(lambda line, new=new, old=old: np.interp(new, old, line), axis, heights)
    return heights, tuple(part / FINER for part in spacing)


def lake(heights):
    """Depths of the lake behind the dam: where the land is below its level, and joined with the place upstream."""
    y, x = np.mgrid[0:heights.shape[0], 0:heights.shape[1]] / FINER
    (left, bottom), (right, top) = DAM
    side = (y - bottom) * (right - left) - (x - left) * (top - bottom)
    along = ((x - left) * (right - left) + (y - bottom) * (top - bottom)) / np.hypot(right - left, top - bottom)**2
    is_behind = side * side[UPSTREAM[1] * FINER, UPSTREAM[0] * FINER] > 0
    is_low = (heights < LAKE_LEVEL) & (is_behind | (along < 0) | (along > 1))
    reached = np.zeros_like(is_low)
    reached[UPSTREAM[1] * FINER, UPSTREAM[0] * FINER] = True
    while True:
        grown = reached.copy()
        for axis in (0, 1):
            for way in (-1, 1):
                grown |= np.roll(reached, way, axis)
        grown &= is_low
        if (grown == reached).all():
            return np.where(reached, LAKE_LEVEL - heights, 0.0)
        reached = grown


def flood(heights, spacing, start, rain, hours):
    """Depths at FRAMES times, m, and the times, h. start: depths at first; rain: m/h, for RAIN_HOURS."""
    grid = RasterModelGrid(heights.shape, xy_spacing=spacing)
    grid.add_field("topographic__elevation", heights.ravel().copy(), at="node")
    grid.add_field("surface_water__depth", np.maximum(start, THIN).ravel(), at="node")
    solver = OverlandFlow(grid, mannings_n=FRICTION, steep_slopes=True, h_init=THIN)
    depth = grid.at_node["surface_water__depth"]
    frames, hours = [], np.linspace(0.0, hours, FRAMES)
    time = 0.0
    for hour in hours:
        while time < 3600.0 * hour:
            step = min(solver.calc_time_step(), 3600.0 * hour - time)
            solver.rainfall_intensity = rain / 3600.0 if time < 3600.0 * RAIN_HOURS else 0.0
            solver.overland_flow(dt=step)
            time += step
        frames.append(depth.reshape(heights.shape).copy())
        print(f"{hour:5.2f} h: deepest {depth.max():.2f} m, wet {np.mean(depth > 0.1):.1%}", flush=True)
    return np.array(frames), hours


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("land", help="jacksboro.vti")
    parser.add_argument("out", help="flood.npz")
    parser.add_argument("--dam", action="store_true", help="a dam breaks, in place of rain")
    arguments = parser.parse_args()
    if arguments.dam:
        heights, spacing = finer(*land(arguments.land, DAM_FIRST, DAM_COUNT))
        depths, hours = flood(heights, spacing, lake(heights), 0.0, DAM_HOURS)
    else:
        heights, spacing = land(arguments.land, FIRST, COUNT)
        depths, hours = flood(heights, spacing, np.zeros_like(heights), RAIN, HOURS)
    steps = np.round(depths / COARSEST).astype(np.uint16)
    bed = heights.astype(np.float32 if arguments.dam else np.int16)
    np.savez_compressed(arguments.out, depth=np.diff(steps.astype(np.int16), axis=0, prepend=np.int16(0)),
                        step=COARSEST, hours=hours, bed=bed, spacing=spacing)


if __name__ == "__main__":
    main()

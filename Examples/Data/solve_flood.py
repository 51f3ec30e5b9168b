#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""solve_flood: a rain flood over the land of jacksboro.vti, by landlab's solver OverlandFlow.

    pip install "landlab==2.9.2" vtk
    python solve_flood.py jacksboro.vti flood.npz

The solver is that of de Almeida, Bates, Freer and Souvignet 2012, "Improving the stability of a simple formulation of
the shallow water equations for 2-D flood modeling". Rain falls evenly for some hours on a part of the map; the water
leaves over its border. README.md says what is written.
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


def land(path):
    """Heights, from south to north and from west to east, and the spacing, m."""
    reader = vtkXMLImageDataReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    heights = vtk_to_numpy(image.GetPointData().GetArray("elevation")).reshape(rows, columns).astype(float)
    part = heights[FIRST[1]:FIRST[1] + COUNT[1], FIRST[0]:FIRST[0] + COUNT[0]]
    return part, image.GetSpacing()[:2]


def flood(heights, spacing):
    """Depths at FRAMES times, m, and the times, h."""
    grid = RasterModelGrid(heights.shape, xy_spacing=spacing)
    grid.add_field("topographic__elevation", heights.ravel().copy(), at="node")
    grid.add_full("surface_water__depth", THIN, at="node")
    solver = OverlandFlow(grid, mannings_n=FRICTION, steep_slopes=True, h_init=THIN)
    depth = grid.at_node["surface_water__depth"]
    frames, hours = [], np.linspace(0.0, HOURS, FRAMES)
    time = 0.0
    for hour in hours:
        while time < 3600.0 * hour:
            step = min(solver.calc_time_step(), 3600.0 * hour - time)
            solver.rainfall_intensity = RAIN / 3600.0 if time < 3600.0 * RAIN_HOURS else 0.0
            solver.overland_flow(dt=step)
            time += step
        frames.append(depth.reshape(heights.shape).copy())
        print(f"{hour:4.1f} h: deepest {depth.max():.2f} m, wet {np.mean(depth > 0.1):.1%}", flush=True)
    return np.array(frames), hours


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("land", help="jacksboro.vti")
    parser.add_argument("out", help="flood.npz")
    arguments = parser.parse_args()
    heights, spacing = land(arguments.land)
    depths, hours = flood(heights, spacing)
    steps = np.round(depths / COARSEST).astype(np.uint16)
    np.savez_compressed(arguments.out, depth=np.diff(steps.astype(np.int16), axis=0, prepend=np.int16(0)),
                        step=COARSEST, hours=hours, bed=heights.astype(np.int16), spacing=spacing)


if __name__ == "__main__":
    main()

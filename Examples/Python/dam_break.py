# SPDX-License-Identifier: BSD-3-Clause
"""dam_break: a column of water falls on a box in a tank, computed by OpenFOAM's interFoam.

The water's surface is the contour of the volume fraction at a half; the water is dyed, as if it were deeper.
Examples/Data/solve_dam_break.py made the data: the tank of Kleefsman et al. 2005.
"""

import argparse
import pathlib
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkRectilinearGrid
from vtkmodules.vtkFiltersCore import vtkClipPolyData, vtkContourFilter, vtkCutter, vtkPolyDataNormals
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper
from vtkwater import movies
from vtkwater.errors import ending
from vtkwater.pictures import png_name
from vtkwater.scenes import Scene

DATA = pathlib.Path(__file__).resolve().parents[1] / "Data/dam_break.npz"
BOX = 2.3955, 2.5565, 0.2985, 0.7015, 0.0, 0.161  # m
WALL, RIM = 0.05, 0.62  # m: thickness and height of the tank's walls
SHOWN = 1.3  # s after the start: of the picture
SLOWER = 4.0  # the movie's time is stretched
SIDE = 0.06, 0.30, 0.40  # colour of the water behind glass
DYE = 40.0  # the water takes as much light as water that is so many times deeper


class DamBreak:
    """The volume fractions of the solver, and the surface of the water at any time of theirs."""

    def __init__(self):
        with np.load(DATA) as kept:
            self.alpha, self.times = kept["alpha"], kept["times"]
            borders = [kept[axis].astype(float) for axis in "xyz"]
        # a value a cell; the cells at a wall go on into it, so that the surface reaches the wall
        middles = [np.concatenate([edge[:1], 0.5 * (edge[1:] + edge[:-1]), edge[-1:]]) for edge in borders]
        self.grid = vtkRectilinearGrid()
        self.grid.SetDimensions(*map(len, middles))
        for axis, places in zip("XYZ", middles):
            getattr(self.grid, f"Set{axis}Coordinates")(numpy_to_vtk(places, deep=True))
        x, y, z = (0.5 * (edge[1:] + edge[:-1]) for edge in borders)
        self.is_box = ((BOX[4] < z) & (z < BOX[5]))[:, None, None] & ((BOX[2] < y) & (y < BOX[3]))[:, None] & (
            (BOX[0] < x) & (x < BOX[1]))
        self.contour = vtkContourFilter()
        self.contour.SetInputData(self.grid)
        self.contour.SetValue(0, 0.5)
        self.normals = vtkPolyDataNormals()
        self.normals.SetInputConnection(self.contour.GetOutputPort())
        self.normals.SplittingOff()
        # the water behind the glass of the tank's near side
        glass = vtkPlane()
        glass.SetOrigin(0.0, 1e-6, 0.0)
        glass.SetNormal(0.0, 1.0, 0.0)
        cut = vtkCutter()
        cut.SetCutFunction(glass)
        cut.SetInputData(self.grid)
        self.side = vtkClipPolyData()
        self.side.SetInputConnection(cut.GetOutputPort())
        self.side.SetValue(0.48)  # a little over the surface's edge, whose corners lie elsewhere: no gap is between

    def show(self, time):
        """The surface at a time, between two steps of the solver by their fractions."""
        i = int(np.clip(np.searchsorted(self.times, time, side="right") - 1, 0, len(self.times) - 2))
        share = np.clip((time - self.times[i]) / (self.times[i + 1] - self.times[i]), 0.0, 1.0)
        alpha = ((1.0 - share) * self.alpha[i] + share * self.alpha[i + 1]) / 255.0
        alpha = np.pad(filled(alpha, self.is_box), 1, mode="edge")
        array = numpy_to_vtk(alpha.ravel(), deep=True)
        array.SetName("alpha")
        self.grid.GetPointData().SetScalars(array)
        self.grid.Modified()
        self.normals.Update()


def filled(alpha, is_box):
    """With the fractions beside the box in it, so that the surface reaches its sides."""
    alpha = np.where(is_box, np.nan, alpha)
    for _ in range(3):
        near = np.stack([np.roll(alpha, shift, axis) for shift in (1, -1) for axis in (1, 2)])
        known = np.isfinite(near)
        mean = np.where(known, near, 0.0).sum(axis=0) / np.maximum(known.sum(axis=0), 1)
        alpha = np.where(np.isnan(alpha) & known.any(axis=0), mean, alpha)
    return np.nan_to_num(alpha)


def add_tank(scene, size):
    """Floor, box and the walls that do not stand before the water."""
    long, wide, _ = size
    floor, wall = (0.62, 0.60, 0.56), (0.72, 0.71, 0.68)
    scene.add_box((-WALL, long + WALL, -WALL, wide + WALL, -WALL, 0.0), floor)
    scene.add_box((-WALL, 0.0, -WALL, wide + WALL, 0.0, RIM), wall)
    scene.add_box((-WALL, long + WALL, wide, wide + WALL, 0.0, RIM), wall)
    scene.add_box((long, long + WALL, -WALL, wide + WALL, 0.0, RIM), wall)
    scene.add_box(BOX, (0.75, 0.22, 0.14))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="dam_break.png", type=png_name, help="default: %(default)s")
    parser.add_argument("time", nargs="?", type=float, default=SHOWN, metavar="S",
                        help="of the picture, after the start; default: %(default)s")
    parser.add_argument("--movie", metavar="FILE", help=f"of all of it: {', '.join(movies.KINDS)}")
    parser.add_argument("--frames", type=int, default=120, help="of the movie; default: %(default)s")
    arguments = parser.parse_args()
    flow = DamBreak()
    if not flow.times[0] <= arguments.time <= flow.times[-1]:
        raise ValueError(f"time is {arguments.time:g}; it must lie in [{flow.times[0]:g}, {flow.times[-1]:g}] s")

    scene = Scene((1280, 720))
    add_tank(scene, flow.grid.GetBounds()[1::2])
    flow.show(arguments.time)
    water = scene.add_water(0.0, "clear tropical", wind=0, units=DYE)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(flow.normals.GetOutputPort())
    mapper.ScalarVisibilityOff()
    water.SetMapper(mapper)
    water.AddObserver("WarningEvent", lambda *_: None)  # a splash is steeper than any wave: its plane is no better
    side = scene.add_mesh(flow.side, SIDE, smooth=False)
    side.GetProperty().LightingOff()
    scene.set_sun(250.0, 45.0)
    scene.set_camera((3.6, -3.0, 1.9), (1.75, 0.42, 0.12), 30.0)

    def show(time):
        flow.show(time)
        water.SetLevel(0.0)
        placement = [0.0] * 4
        if water.GetMeshPlacement(placement):
            water.SetLevel(placement[0])  # the plane that is reflected in is the mean of the surface

    if arguments.movie:
        with movies.open_movie(arguments.movie, arguments.frames / (SLOWER * flow.times[-1])) as movie, (
                movies.interrupts()) as is_stopped:
            for i in range(arguments.frames):
                if is_stopped():
                    return 130
                show(flow.times[-1] * i / max(arguments.frames - 1, 1))
                movie.add(scene.picture())
    show(arguments.time)
    scene.write(arguments.picture)
    print(f"{arguments.picture}: {arguments.time:g} of {flow.times[-1]:g} s, the highest water at "
          f"{flow.normals.GetOutput().GetBounds()[5]:.2f} m")
    return 0


if __name__ == "__main__":
    with ending("dam_break"):
        sys.exit(main())

# SPDX-License-Identifier: BSD-3-Clause
"""wake: a ship sets out over calm water, and the mesh of its waves is the water.

The waves are those of a pressure on the surface that moves at a constant speed from a time on, the weight of a Wigley
hull over its waterplane: linear theory of deep water, exact at every time, by Fourier transform. Lamb 1932,
"Hydrodynamics", sections 255 and 256; Darmon, Benzaquen and Raphael 2014, "Kelvin wake pattern at large Froude
numbers", J. Fluid Mech. 738, R3. The eye sails with the ship.
"""

import argparse
import math
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkStructuredGrid
from vtkmodules.vtkFiltersGeometry import vtkStructuredGridGeometryFilter
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper
from vtkwater import movies
from vtkwater.errors import ending
from vtkwater.pictures import png_name
from vtkwater.readers import calm_around, surface_of_heights
from vtkwater.scenes import Scene

GRAVITY = 9.81
LENGTH, BEAM, DRAUGHT, FREEBOARD = 40.0, 6.0, 2.5, 2.4  # m, of the hull
SPEED = 8.0  # m/s
SMOOTH = 1.2  # m: the ends of the pressure are as blunt
DAMPING = 0.02  # 1/s: what little the air takes; it also ends the waves that leave the domain
DOMAIN, POINTS = 960.0, 2048  # m of the periodic water, and points along a side
SIZE, AHEAD = 420.0, 90.0  # m of it that are shown, and of these before the ship's middle
HORIZON = 10e3  # m: calm water goes on to there
SETTLED = 60.0  # s after the start
WIND = 1.5  # m/s: ripples
BUOYS = ((-150.0, -38.0), (-90.0, 42.0), (-20.0, -46.0), (60.0, 40.0), (130.0, -40.0))  # m, at the picture's time


def places():
    """Along a side, m from the ship's middle."""
    return (np.arange(POINTS) - POINTS // 2) * (DOMAIN / POINTS)


def hull_draught():
    """Depth of the hull's bottom under calm water at the grid's points, rows along y: its weight as a pressure."""
    x, y = np.meshgrid(places(), places())
    half = 0.5 * BEAM * np.clip(1.0 - (2.0 * x / LENGTH) ** 2, 0.0, None)
    inside = np.abs(y) < half
    return DRAUGHT * np.sqrt(np.where(inside, 1.0 - np.abs(y) / np.where(inside, half, 1.0), 0.0))


def response(k_x, k, seconds):
    """What a unit of pressure (m of water) has made of a plane wave, in the ship's frame, since it set out.

    The wave's height z obeys z'' + g k z = -g k p, and p has moved at SPEED for these seconds.
    """
    omega = np.sqrt(GRAVITY * k)

    def turns(rate):
        return (np.exp((1j * rate - DAMPING) * seconds) - 1.0) / (1j * rate - DAMPING)

    return -GRAVITY * k * (turns(k_x * SPEED + omega) - turns(k_x * SPEED - omega)) / (2j * omega)


def wake(seconds):
    """Heights of the water, m, at the grid's points so many seconds after the start."""
    draught = hull_draught()
    wave = 2.0 * math.pi * np.fft.fftfreq(POINTS, DOMAIN / POINTS)
    k_x, k_y = np.meshgrid(wave[: POINTS // 2 + 1].copy(), wave)
    k_x[:, -1] *= -1.0
    k = np.maximum(np.hypot(k_x, k_y), 1e-9)
    pressure = np.fft.rfft2(draught) * np.exp(-0.5 * (SMOOTH * k) ** 2)
    # less the hollow that the hull itself fills
    return np.fft.irfft2(pressure * (response(k_x, k, seconds) + 1.0), s=draught.shape)


def shown(heights):
    """The square around the ship that is drawn: heights, which end in calm water, and its x and y."""
    at = places()
    columns, rows = (at >= AHEAD - SIZE) & (at < AHEAD), np.abs(at + 0.25 * DOMAIN / POINTS) < 0.5 * SIZE
    x, y = at[columns], at[rows]
    edge = [np.clip((0.5 * SIZE - np.abs(along)) / (0.12 * SIZE), 0.0, 1.0)
            for along in (x - 0.5 * (x[0] + x[-1]), y - 0.5 * (y[0] + y[-1]))]
    fade = [share * share * (3.0 - 2.0 * share) for share in edge]
    return heights[np.ix_(rows, columns)] * np.outer(fade[1], fade[0]), x, y


class Water:
    """The mesh of the waves as the water, and calm water around it to the horizon."""

    def __init__(self, scene):
        self.mesh = vtkStructuredGrid()
        self.show(0.0)
        polygons = vtkStructuredGridGeometryFilter()
        polygons.SetInputData(self.mesh)
        waves, calm = add_sheet(scene), add_sheet(scene)
        waves.GetMapper().SetInputConnection(polygons.GetOutputPort())
        calm.GetMapper().SetInputData(calm_around(self.mesh.GetBounds(), HORIZON))
        self.sheets = waves, calm

    def show(self, seconds):
        heights, x, y = shown(wake(seconds))
        spacing = DOMAIN / POINTS
        points = vtkPoints()
        points.SetData(numpy_to_vtk(
            np.stack([*np.meshgrid(x, y), heights], axis=2).reshape(-1, 3).astype(np.float32), deep=True))
        self.mesh.SetDimensions(len(x), len(y), 1)
        self.mesh.SetPoints(points)
        slope_y, slope_x = np.gradient(heights, spacing)
        normals = np.stack([-slope_x, -slope_y, np.ones_like(heights)], axis=2)
        normals /= np.linalg.norm(normals, axis=2, keepdims=True)
        self.mesh.GetPointData().SetNormals(numpy_to_vtk(normals.reshape(-1, 3).astype(np.float32), deep=True))


def add_sheet(scene):
    water = scene.add_water(0.0, wind=WIND)
    plane = vtkPlane()
    plane.SetNormal(0.0, 0.0, 1.0)
    water.SetPlane(plane)
    mapper = vtkPolyDataMapper()
    mapper.ScalarVisibilityOff()
    water.SetMapper(mapper)
    return water


def strake(scene, points, color):
    """A surface through rows of points."""
    data = surface_of_heights(np.zeros(points.shape[:2])).data
    data.GetPoints().SetData(numpy_to_vtk(points.reshape(-1, 3).copy(), deep=True))
    scene.add_mesh(data, color)


def add_ship(scene):
    """The Wigley hull, straight above the water, with a deck, a house, a funnel and a mast."""
    x, z = np.meshgrid(np.linspace(-0.5, 0.5, 81), np.linspace(-1.0, 1.0, 21))
    half = 0.5 * BEAM * (1.0 - (2.0 * x) ** 2) * (1.0 - np.clip(-z, 0.0, 1.0) ** 2)
    height = np.where(z < 0.0, DRAUGHT * z, FREEBOARD * z * (1.0 + 0.6 * x))
    for side in (-1.0, 1.0):
        for band, color in ((slice(0, 13), (0.58, 0.12, 0.10)), (slice(12, 21), (0.10, 0.14, 0.24))):
            strake(scene, np.stack([LENGTH * x, side * half, height], axis=2)[band], color)
    along, side = np.meshgrid(np.linspace(-0.5, 0.5, 81), [-1.0, 1.0])
    strake(scene, np.stack([LENGTH * along, side * 0.5 * BEAM * (1.0 - (2.0 * along) ** 2),
                            0.85 * FREEBOARD * (1.0 + 0.6 * along)], axis=2), (0.55, 0.48, 0.38))
    white = (0.93, 0.93, 0.90)
    scene.add_box((-14.0, -4.0, -1.9, 1.9, 1.6, 4.6), white)
    scene.add_box((-10.0, -4.6, -1.7, 1.7, 4.6, 6.6), white)
    scene.add_box((-12.8, -11.2, -0.7, 0.7, 4.6, 7.6), (0.85, 0.45, 0.12))
    scene.add_box((-7.4, -7.1, -0.15, 0.15, 6.6, 11.5), (0.30, 0.30, 0.32))


def add_buoys(scene):
    """Marks of the fairway; in the ship's frame they go by."""
    actors = []
    for x, y in BUOYS:
        cone = vtkConeSource()
        cone.SetDirection(0.0, 0.0, 1.0)
        cone.SetHeight(4.0)
        cone.SetRadius(1.1)
        cone.SetResolution(32)
        actor = scene.add_mesh(cone, (0.75, 0.10, 0.08) if y < 0 else (0.05, 0.45, 0.18), smooth=False)
        actor.SetPosition(x, y, 1.2)
        actors.append(actor)
    return actors


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="wake.png", type=png_name, help="default: %(default)s")
    parser.add_argument("time", nargs="?", type=float, default=SETTLED, metavar="S",
                        help="seconds after the ship set out; default: %(default)g")
    parser.add_argument("--movie", metavar="FILE", help=f"the way to there, too: {', '.join(movies.KINDS)}")
    parser.add_argument("--frames", type=int, default=60, help="of the movie; default: %(default)s")
    arguments = parser.parse_args()
    if not 0.0 <= arguments.time <= 1e6:
        raise ValueError(f"time is {arguments.time:g}; it must lie in [0, 1e+06] s")

    scene = Scene((1280, 720))
    add_ship(scene)
    buoys = add_buoys(scene)
    water = Water(scene)
    scene.set_clear_sky(76.0, 42.0, 3.0)
    scene.set_camera((-185.0, -24.0, 44.0), (-32.0, -1.0, 0.0), 31.0)
    scene.renderer.GetActiveCamera().SetClippingRange(5.0, 2.0 * HORIZON)

    def show(seconds):
        water.show(seconds)
        for actor, (x, y) in zip(buoys, BUOYS):
            actor.SetPosition(x + SPEED * (arguments.time - seconds), y, 1.2)
        for sheet in water.sheets:
            sheet.SetTime(seconds)

    if arguments.movie:
        with movies.open_movie(arguments.movie, 12.0) as movie, movies.interrupts() as is_stopped:
            for i in range(arguments.frames):
                if is_stopped():
                    return 130
                show(arguments.time * i / max(arguments.frames - 1, 1))
                movie.add(scene.picture())
    show(arguments.time)
    scene.write(arguments.picture)
    print(f"{arguments.picture}: {arguments.time:g} s after the start; waves of "
          f"{2.0 * math.pi * SPEED**2 / GRAVITY:.1f} m follow the ship")
    return 0


if __name__ == "__main__":
    with ending("wake"):
        sys.exit(main())

# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of a newcomer's: what PyVista has built in, terrains of all sizes, and things under a sky.

Each scene is a function that adds its meshes to a plotter and returns the level of its water.
"""
from pathlib import Path

import numpy as np
import pyvista as pv
from pyvista import examples

ELEVATIONS = Path(__file__).resolve().parents[2] / "Examples" / "Data" / "jacksboro.vti"
SKY = dict(color="white", top=(0.45, 0.65, 0.9))


def hills(plotter):
    plotter.add_mesh(examples.load_random_hills())
    return 2.0


def airplane(plotter):
    mesh = examples.load_airplane()
    plotter.add_mesh(mesh, color="lightgray", smooth_shading=True)
    return mesh.bounds[4] - 0.1 * mesh.length


def sphere(plotter):
    plotter.add_mesh(pv.Sphere(), color="tomato", smooth_shading=True)
    return 0.0


def cone(plotter):
    plotter.add_mesh(pv.Cone(direction=(0, 0, 1)), color="orange")
    return -0.2


def ant(plotter):
    mesh = examples.load_ant()
    plotter.add_mesh(mesh.rotate_x(90), color="sienna", smooth_shading=True)
    return mesh.rotate_x(90).center[2]


def knot(plotter):
    plotter.add_mesh(pv.ParametricTorus(ringradius=2, crosssectionradius=0.5), scalars=None, color="gold",
                     smooth_shading=True)
    return 0.0


def globe(plotter):
    plotter.add_mesh(examples.load_globe(), texture=examples.load_globe_texture(), smooth_shading=True)
    return 0.0


def beam(plotter):
    plotter.add_mesh(examples.load_hexbeam(), show_edges=True, color="lightblue")
    return 0.5


LOOKS = ({}, {"color": "tan"}, {"cmap": "gist_earth"}, {"color": "olivedrab"})


def terrain(size, seed, relief=0.12, points=160, level=0.0):
    """A function that adds a fractal terrain of so many units, with heights in [-relief, relief] of its size."""
    def add(plotter):
        draw = np.random.default_rng(seed)
        frequencies = np.hypot(*np.meshgrid(np.fft.fftfreq(points), np.fft.fftfreq(points)))
        frequencies[0, 0] = 1.0
        spectrum = draw.normal(size=(2, points, points))
        heights = np.fft.ifft2((spectrum[0] + 1j * spectrum[1]) / frequencies ** 2.1).real
        heights -= np.median(heights)
        heights *= relief * size / np.abs(heights).max()
        x, y = np.meshgrid(*[np.linspace(-0.5 * size, 0.5 * size, points)] * 2)
        mesh = pv.StructuredGrid(x, y, heights)
        look = LOOKS[seed % len(LOOKS)]
        scalars = {} if "color" in look else {"scalars": heights.ravel(order="F"), "show_scalar_bar": False}
        plotter.add_mesh(mesh, smooth_shading=True, **scalars, **look)
        return level * relief * size
    return add


def fault(plotter):
    image = pv.read(ELEVATIONS)
    mesh = image.warp_by_scalar(factor=2.0)
    plotter.add_mesh(mesh, cmap="gist_earth", show_scalar_bar=False, smooth_shading=True)
    return 2.0 * 384


def under_sky(add):
    """A scene with a sky as its background."""
    def with_sky(plotter):
        plotter.set_background(SKY["color"], top=SKY["top"])
        return add(plotter)
    return with_sky


def lighthouse(plotter):
    plotter.add_mesh(pv.Cylinder(center=(0, 0, 3), direction=(0, 0, 1), radius=0.6, height=7), color="white",
                     smooth_shading=True, split_sharp_edges=True)
    plotter.add_mesh(pv.Cone(center=(0, 0, 7), direction=(0, 0, 1), radius=0.8, height=1), color="red")
    plotter.add_mesh(pv.Sphere(radius=2.5, center=(0, 0, -1.6)), color="dimgray", smooth_shading=True)
    return 0.0


def pier(plotter):
    for x in np.arange(-6.0, 7.0, 3.0):
        for y in (-1.0, 1.0):
            plotter.add_mesh(pv.Cylinder(center=(x, y, -1.0), direction=(0, 0, 1), radius=0.15, height=4), color="saddlebrown")
    plotter.add_mesh(pv.Cube(center=(0, 0, 1.05), x_length=13, y_length=2.6, z_length=0.15), color="peru")
    return 0.0


def ship(plotter):
    hull = pv.Cube(x_length=20, y_length=4, z_length=3).triangulate().subdivide(3)
    points = hull.points
    points[:, 1] *= (1 - (np.abs(points[:, 0]) / 10.5) ** 3) * (0.75 + 0.1 * points[:, 2])
    plotter.add_mesh(hull, color="firebrick")
    plotter.add_mesh(pv.Cube(center=(-5, 0, 3), x_length=5, y_length=2.4, z_length=3), color="white")
    plotter.add_mesh(pv.Cylinder(center=(4, 0, 3.5), direction=(0, 0, 1), radius=0.2, height=5), color="gray")
    return -0.4


def pool(plotter):
    plotter.add_mesh(pv.Cube(center=(0, 0, -2.1), x_length=12, y_length=6, z_length=0.2), color=(0.75, 0.88, 0.92))
    for x, y, dx, dy in ((0, 3.1, 12.4, 0.2), (0, -3.1, 12.4, 0.2), (6.1, 0, 0.2, 6), (-6.1, 0, 0.2, 6)):
        plotter.add_mesh(pv.Cube(center=(x, y, -0.95), x_length=dx, y_length=dy, z_length=2.5), color="white")
    plotter.add_mesh(pv.Sphere(radius=0.4, center=(2, 1, 0.1)), color="red", smooth_shading=True)
    plotter.add_mesh(pv.Cylinder(center=(-3, 0, -1), direction=(0, 0, 1), radius=0.3, height=3), color="gold")
    return 0.0


def islands(plotter):
    for x, y, radius in ((0, 0, 30), (60, 40, 20), (-70, 20, 25), (20, -60, 15)):
        plotter.add_mesh(pv.ParametricEllipsoid(radius, 0.8 * radius, 0.4 * radius).translate((x, y, -2)), color="olivedrab",
                         smooth_shading=True)
    return 0.0


SCENES = {
    "random hills": hills, "airplane": airplane, "sphere": sphere, "cone": cone,
    "ant": ant, "torus": knot, "globe": globe, "hexahedral beam": beam,
    "terrain 1 mm": terrain(0.001, 1), "terrain 1 unit": terrain(1.0, 2, level=0.2), "terrain 50": terrain(50.0, 3),
    "terrain 1e3": terrain(1e3, 4, level=-0.2), "terrain 2e4": terrain(2e4, 5, 0.06), "terrain 1e6": terrain(1e6, 6, 0.02),
    "terrain 1e7": terrain(1e7, 7, 0.01, level=0.1), "Jacksboro fault": fault,
    "lighthouse": under_sky(lighthouse), "pier": under_sky(pier), "ship": under_sky(ship), "pool": under_sky(pool),
    "islands": under_sky(islands), "terrain 200 and sky": under_sky(terrain(200.0, 8, 0.1)),
    "terrain 5e3 and sky": under_sky(terrain(5e3, 9, 0.08, level=-0.3)), "cone and sky": under_sky(cone),
}

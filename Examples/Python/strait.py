# SPDX-License-Identifier: BSD-3-Clause
"""strait: a day of tides around Vancouver Island, over a real bed, with flats that dry out.

The bed is topobathy.npz of matplotlib's sample data, in longitude and latitude. It has -1 m in a fifth of its places,
the shallow sea beside land, which low water bares. The level is the sum of the four largest constituents of the tide,
as an array of the mesh; where it falls below the bed the water ends.
"""

import argparse
import sys

import numpy as np
import pyvista as pv
import vtkwater.pyvista  # noqa: F401  add_water
from matplotlib import cbook
from matplotlib.colors import LinearSegmentedColormap
from vtkwater import movies
from vtkwater.errors import ending
from vtkwater.pictures import png_name
from vtkwater.readers import METRES_PER_DEGREE

# Speeds in degrees an hour: Schureman 1958, "Manual of Harmonic Analysis and Prediction of Tides", table 2. Amplitudes
# in m, to a decimetre those of the mixed tide in the Strait of Georgia, all high at the start: no forecast.
CONSTITUENTS = {"M2": (28.9841042, 0.9), "S2": (30.0, 0.2), "K1": (15.0410686, 0.9), "O1": (13.9430356, 0.5)}
EXAGGERATION = 7.0  # heights are drawn this many times higher than they are
# m, and the colour of the bed or the land there
COLORS = ((-400, "#3a3a32"), (-20, "#6b5f46"), (-3, "#8a7a58"), (2, "#a8966c"), (8, "#6f7a45"), (120, "#4a5f30"),
          (700, "#37482a"), (1300, "#6d675e"), (1800, "#e8e8e8"))
SHADES = 4096
SUN = (215.0, 40.0)  # azimuth and elevation, degrees
HOURS = 24.84  # a lunar day


def level_of(hours):
    """Height of the tide over its mean, m."""
    return sum(amplitude * np.cos(np.radians(speed * hours)) for speed, amplitude in CONSTITUENTS.values())


def seabed():
    """The bed as a grid in metres, from its south-west: z is the bed's height, and so is the array zb."""
    with cbook.get_sample_data("topobathy.npz") as data:
        heights, longitude, latitude = (data[name].astype(float) for name in ("topo", "longitude", "latitude"))
    x = (longitude - longitude[0]) * METRES_PER_DEGREE * np.cos(np.radians(latitude.mean()))
    y = (latitude - latitude[0]) * METRES_PER_DEGREE
    grid = pv.StructuredGrid(*np.meshgrid(x, y, indexing="ij"), heights.T)
    grid["zb"] = grid.points[:, 2].copy()
    return grid


def make_plotter(sea):
    """The bed, the water of the mesh's arrays zeta and zb, and the view from over Puget Sound to the north-west."""
    plotter = pv.Plotter(off_screen=True, window_size=(1200, 640), lighting="none")
    plotter.set_scale(zscale=EXAGGERATION)
    low, high = COLORS[0][0], COLORS[-1][0]
    stops = [((z - low) / (high - low), color) for z, color in COLORS]
    shades = LinearSegmentedColormap.from_list("land", stops, SHADES)
    plotter.add_mesh(seabed(), scalars="zb", cmap=shades, clim=(low, high), n_colors=SHADES, show_scalar_bar=False,
                     smooth_shading=True, ambient=0.25)
    plotter.add_water(sea, level="zeta", bed="zb", preset="clear tropical", wind=0, sun=SUN, units="m")
    plotter.set_background("#e8eeee", top="#4d84bf")
    plotter.camera.position = 330e3, -60e3, 95e3
    plotter.camera.focal_point = 205e3, 95e3, 0.0
    plotter.camera.up = 0.0, 0.0, 1.0
    return plotter


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="strait.png", type=png_name,
                        help="at the lowest water; default: %(default)s")
    parser.add_argument("--movie", metavar="FILE", help=f"of a lunar day: {', '.join(movies.KINDS)}")
    parser.add_argument("--frames", type=int, default=60, help="of the movie; default: %(default)s")
    arguments = parser.parse_args()
    sea = seabed()
    sea["zeta"] = np.zeros(sea.n_points)
    plotter = make_plotter(sea)
    hours = np.linspace(0.0, HOURS, 500)
    lowest = hours[level_of(hours).argmin()]

    def picture(at):
        sea["zeta"] = np.full(sea.n_points, level_of(at))
        plotter.render()
        return plotter.screenshot(None, return_img=True)

    if arguments.movie:
        with movies.open_movie(arguments.movie, 12.0) as movie, movies.interrupts() as is_stopped:
            for i in range(arguments.frames):
                if is_stopped():
                    return 130
                movie.add(picture(HOURS * i / max(arguments.frames - 1, 1)))
    picture(lowest)
    plotter.screenshot(arguments.picture)
    bared = (sea["zb"] > level_of(lowest)) & (sea["zb"] < level_of(hours).max())
    print(f"{arguments.picture}: low water of {level_of(lowest):.2f} m after {lowest:.1f} hours; it bares "
          f"{bared.mean():.0%} of the map that high water, {level_of(hours).max():.2f} m, covers")
    return 0


if __name__ == "__main__":
    with ending("strait"):
        sys.exit(main())

# SPDX-License-Identifier: BSD-3-Clause
"""breakwater: swell runs into a harbour, on an unstructured mesh in a NetCDF of the UGRID conventions.

The waves are solved here, by linear finite elements for long waves: z'' = div(g h grad z), h the depth at rest (Stoker
1957, "Water Waves", section 10.13), with open edges that send swell in and let waves out (Sommerfeld's condition), and
an absorbing beach. The file is written by the package netCDF4 and read back by VTK's reader, before VTK 9.2 by netCDF4;
vtkwater draws it as the command does: vtkwater render breakwater.nc --level zeta --bed zb --color-by height
"""

import argparse
import math
import pathlib
import sys
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkDelaunay2D
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkCylinderSource
from vtkwater import movies
from vtkwater.data_scenes import DataWater
from vtkwater.errors import ending
from vtkwater.pictures import png_name
from vtkwater.scenes import Scene
from vtkwater.solutions import Solution

GRAVITY = 9.81
WIDTH, LENGTH, SHORE = 640.0, 560.0, 40.0  # m of the map along x and y; of land on three sides of the harbour
WALL = 212.0, 224.0  # m along y: the breakwaters
GAP = 290.0, 370.0  # m along x: the entrance
QUAY = (420.0, 600.0, 400.0, 424.0)  # a pier in the harbour: xmin, xmax, ymin, ymax
SPACING = 5.0  # m between the mesh's points
DEPTH, INNER, BEACH = 10.0, 6.0, 90.0  # m: of the sea, of the harbour, and of the beach before its north side
PERIOD, AMPLITUDE = 9.0, 0.7  # s, m: of the swell, which comes from the south
SECONDS, EVERY = 120.0, 1.0  # that are solved, and between two steps of the file
AVERAGED = 3  # periods: the height of the waves is four times their rms over the last of them
DAMPED = 0.25  # 1/s, in the shallow water of the beach
MOST = 4.0  # m: height of the waves with the last colour
EXAGGERATION = 3.0  # heights are drawn this many times higher than they are


def bed_at(x, y):
    """Height of the bed, m: the sea, a step at the breakwaters, the harbour, and a beach in its north."""
    inside = 1.0 / (1.0 + np.exp(-(y - 235.0) / 12.0))
    beach = np.clip((y - (LENGTH - SHORE - BEACH)) / BEACH, 0.0, 1.0)
    return -(DEPTH + (INNER - DEPTH) * inside) * (1.0 - 0.9 * beach)


def solids():
    """What stands in the water: breakwaters and pier, as xmin, xmax, ymin, ymax."""
    return (0.0, GAP[0], *WALL), (GAP[1], WIDTH, *WALL), QUAY


def make_mesh(walls, width=WIDTH, length=LENGTH - SHORE, left=SHORE, spacing=SPACING):
    """Points (n x 2) and triangles (m x 3) of the water, with points along all that stands in it.

    Behind the first of the walls land begins at x = left and width - left.
    """
    random = np.random.default_rng(3)
    half = 0.5 * spacing
    x, y = np.meshgrid(np.arange(half, width, spacing), np.arange(half, length, 0.866 * spacing))
    x = x + half * (np.arange(len(x)) % 2)[:, None]
    inner = np.stack([x.ravel(), y.ravel()], axis=1) + random.uniform(-0.12, 0.12, (x.size, 2)) * spacing
    boxes = list(walls)
    if walls:
        boxes += [(0.0, left, walls[0][3], length), (width - left, width, walls[0][3], length)]
    edges = [outline((0.0, width, 0.0, length), half)] + [outline(box, half) for box in boxes]
    for box in boxes:
        inner = inner[distance(inner, box) > 0.6 * half]
    inner = inner[distance(inner, (0.0, width, 0.0, length), outside=False) > 0.6 * half]
    points = np.unique(np.round(np.concatenate([inner, *edges]), 6), axis=0)
    places = vtkPoints()
    places.SetDataTypeToDouble()
    places.SetData(numpy_to_vtk(np.c_[points, np.zeros(len(points))], deep=True))
    cloud = vtkPolyData()
    cloud.SetPoints(places)
    delaunay = vtkDelaunay2D()
    delaunay.SetInputData(cloud)
    delaunay.Update()
    triangles = vtk_to_numpy(delaunay.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3).copy()
    middles = points[triangles].mean(axis=1)
    keep = np.all([distance(middles, box) > 0.0 for box in boxes], axis=0) if boxes else np.ones(len(middles), bool)
    used, triangles = np.unique(triangles[keep], return_inverse=True)
    return points[used], triangles.reshape(-1, 3)


def outline(box, spacing):
    """Points along the edges of a rectangle."""
    west, east, south, north = box
    x = np.linspace(west, east, max(round((east - west) / spacing), 1) + 1)
    y = np.linspace(south, north, max(round((north - south) / spacing), 1) + 1)
    return np.concatenate([np.stack([x, np.full_like(x, edge)], axis=1) for edge in (south, north)]
                          + [np.stack([np.full_like(y, edge), y], axis=1) for edge in (west, east)])


def distance(points, box, outside=True):
    """How far points lie out of a rectangle, negative within; or the other way round."""
    west, east, south, north = box
    x, y = points.T
    out = np.maximum(np.maximum(west - x, x - east), np.maximum(south - y, y - north))
    return out if outside else -out


class Waves:
    """Long waves on a mesh: mass and stiffness of linear triangles, the mass lumped; open are y = 0 and the sides.

    closed: y from which on the sides are walls.
    """

    def __init__(self, points, triangles, bed, closed=math.inf, damping=0.0):
        self.points, self.damping = points, damping
        corners = points[triangles]
        edge = np.roll(corners, -1, axis=1) - np.roll(corners, 1, axis=1)  # opposite to each corner
        twice = np.abs(edge[:, 0, 0] * edge[:, 1, 1] - edge[:, 0, 1] * edge[:, 1, 0])
        self.mass = np.bincount(triangles.ravel(), np.repeat(twice / 6.0, 3), len(points))
        speed2 = GRAVITY * np.maximum(-bed, 0.0)
        per_area = speed2[triangles].mean(axis=1) / (2.0 * twice)
        pairs = [(0, 1), (1, 2), (2, 0)]
        self.a = np.concatenate([triangles[:, i] for i, _ in pairs])
        self.b = np.concatenate([triangles[:, j] for _, j in pairs])
        self.weight = np.concatenate([-per_area * (edge[:, i] * edge[:, j]).sum(axis=1) for i, j in pairs])
        self.open, self.sent = self.edges(triangles, np.sqrt(speed2), closed)

    def edges(self, triangles, speed, closed):
        """Of the nodes: length of open edge times the waves' speed, of all of it and of where swell comes in."""
        sides = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
        sides, count = np.unique(sides, axis=0, return_counts=True)
        sides = sides[count == 1]
        one, two = self.points[sides[:, 0]], self.points[sides[:, 1]]
        flow = np.linalg.norm(two - one, axis=1) * speed[sides].mean(axis=1)
        highest = np.maximum(one, two)
        south = highest[:, 1] < 1e-6
        upright = (np.abs(one[:, 0] - two[:, 0]) < 1e-6) & (highest[:, 1] <= closed)
        width = self.points[:, 0].max()
        side = upright & ((highest[:, 0] < 1e-6) | (highest[:, 0] > width - 1e-6))
        return [np.bincount(sides[which].ravel(), np.repeat(0.5 * flow[which], 2), len(self.points))
                for which in (south | side, south)]

    def longest_step(self):
        """Of time, s, that leapfrog is stable with: by Gershgorin's circles, 2 over the largest frequency."""
        strength = np.abs(self.weight)
        row = np.bincount(self.a, strength, len(self.mass)) + np.bincount(self.b, strength, len(self.mass))
        return math.sqrt(2.0 / (row / self.mass).max())

    def advanced(self, now, before, rising, step, drag):
        """Heights a step later; rising: m/s, of the swell at the edge that it comes in by."""
        flux = self.weight * (now[self.a] - now[self.b])
        push = np.bincount(self.b, flux, len(now)) - np.bincount(self.a, flux, len(now)) + 2.0 * self.sent * rising
        return (2.0 * now - (1.0 - drag) * before + step**2 * push / self.mass) / (1.0 + drag)

    def run(self, seconds, every, amplitude, period):
        """Heights at 0, every, ... seconds: leapfrog, the swell grows over its first two periods."""
        per_output = math.ceil(every / (0.9 * self.longest_step()))
        step = every / per_output
        heights = [np.zeros(len(self.points))]
        now, before = heights[0], heights[0]
        drag = 0.5 * step * (self.open / self.mass + self.damping)
        turn = 2.0 * math.pi / period
        for i in range(per_output * round(seconds / every)):
            time = i * step
            rising = min(time / (2.0 * period), 1.0) * amplitude * turn * math.cos(turn * time)
            now, before = self.advanced(now, before, rising, step, drag), now
            if (i + 1) % per_output == 0:
                heights.append(now)
        return np.array(heights)


def solve(path):
    """Solve the swell and write it, with the bed and the waves' height."""
    points, triangles = make_mesh(solids())
    bed = bed_at(*points.T)
    beach = np.clip((points[:, 1] - (LENGTH - SHORE - BEACH)) / BEACH, 0.0, 1.0)
    waves = Waves(points, triangles, bed, closed=WALL[0], damping=DAMPED * beach)
    heights = waves.run(SECONDS, EVERY, AMPLITUDE, PERIOD)
    last = heights[-round(AVERAGED * PERIOD / EVERY):]
    write_ugrid(path, points, triangles, EVERY * np.arange(len(heights)), heights,
                {"zb": bed, "height": 4.0 * np.sqrt((last**2).mean(axis=0))})
    return len(points), len(triangles)


def write_ugrid(path, points, triangles, times, heights, of_nodes):
    """A mesh with its heights over time, zeta, and other arrays of its nodes, after UGRID 1.0."""
    import netCDF4

    with netCDF4.Dataset(path, "w") as file:
        file.Conventions = "CF-1.8 UGRID-1.0"
        for name, size in (("time", None), ("node", len(points)), ("face", len(triangles)), ("corner", 3)):
            file.createDimension(name, size)
        mesh = file.createVariable("mesh", "i4")
        mesh.cf_role, mesh.topology_dimension = "mesh_topology", np.int32(2)
        mesh.node_coordinates, mesh.face_node_connectivity = "node_x node_y", "face_nodes"
        for i, axis in enumerate("xy"):
            place = file.createVariable(f"node_{axis}", "f8", ("node",))
            place.units, place.standard_name = "m", f"projection_{axis}_coordinate"
            place[:] = points[:, i]
        faces = file.createVariable("face_nodes", "i4", ("face", "corner"))
        faces.cf_role, faces.start_index = "face_node_connectivity", np.int32(0)
        faces[:] = triangles
        time = file.createVariable("time", "f8", ("time",))
        time.units = "seconds since 2020-01-01"
        time[:] = times
        for name, dimensions, values in (("zeta", ("time", "node"), heights),
                                         *((name, ("node",), values) for name, values in of_nodes.items())):
            data = file.createVariable(name, "f4", dimensions, zlib=True)
            data.mesh, data.location, data.units = "mesh", "node", "m"
            data[:] = values


def add_harbour(scene):
    """Breakwaters, upright as of caissons, quays, a pier with sheds, and a light at either side of the entrance."""
    top = EXAGGERATION
    for box in solids()[:2]:
        scene.add_box((*box, -DEPTH * top, 2.0 * top), (0.50, 0.48, 0.45))
        scene.add_box((box[0], box[1], box[2] + 3.0, box[3] - 3.0, 2.0 * top, 2.4 * top), (0.66, 0.65, 0.62))
    stone = (0.62, 0.60, 0.55)
    scene.add_box((*QUAY, -INNER * top, 1.6 * top), stone)
    for west in (0.0, WIDTH - SHORE):
        scene.add_box((west, west + SHORE, WALL[1], LENGTH, -INNER * top, 1.6 * top), stone)
    scene.add_box((SHORE, WIDTH - SHORE, LENGTH - SHORE, LENGTH, -INNER * top, 0.8 * top), (0.72, 0.65, 0.48))
    for x, y, size, color in ((440.0, 404.0, 42.0, (0.70, 0.32, 0.24)), (500.0, 404.0, 52.0, (0.78, 0.76, 0.70))):
        scene.add_box((x, x + size, y, y + 13.0, 1.6 * top, 1.6 * top + 11.0), color)
    for x, color in ((GAP[0] - 8.0, (0.75, 0.10, 0.08)), (GAP[1] + 8.0, (0.06, 0.42, 0.18))):
        tower = vtkCylinderSource()
        tower.SetRadius(2.6)
        tower.SetHeight(20.0)
        tower.SetResolution(32)
        actor = scene.add_mesh(tower, color)
        actor.RotateX(90.0)
        actor.SetPosition(x, 0.5 * sum(WALL), 2.4 * top + 10.0)
        lamp = vtkConeSource()
        lamp.SetRadius(3.4)
        lamp.SetHeight(5.0)
        lamp.SetDirection(0.0, 0.0, 1.0)
        lamp.SetResolution(32)
        scene.add_mesh(lamp, (0.93, 0.93, 0.90), smooth=False).SetPosition(x, 0.5 * sum(WALL), 2.4 * top + 22.0)


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n\n")[0])
    parser.add_argument("picture", nargs="?", default="breakwater.png", type=png_name,
                        help="after two minutes; default: %(default)s")
    parser.add_argument("--netcdf", metavar="FILE.nc", help="keep the file of the solution")
    parser.add_argument("--movie", metavar="FILE", help=f"of the two minutes: {', '.join(movies.KINDS)}")
    parser.add_argument("--frames", type=int, default=180, help="of the movie; default: %(default)s")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(arguments.netcdf or pathlib.Path(folder) / "breakwater.nc")
        points, triangles = solve(path)
        solution = Solution(path, ["zeta", "zb", "height"])
        scene = Scene((1200, 675))
        scene.set_sun(300.0, 40.0)
        water = DataWater(scene, solution, level="zeta", bed="zb", color_by="height", cmap="turbo",
                          clim=(0.0, MOST), exaggeration=EXAGGERATION, units="m")
        water.bar("height of the waves, m")
        add_harbour(scene)
        scene.set_camera((120.0, -330.0, 250.0), (330.0, 245.0, 0.0), 36.0)
        if arguments.movie:
            with movies.open_movie(arguments.movie, 12.0) as movie, movies.interrupts() as is_stopped:
                for i in range(arguments.frames):
                    if is_stopped():
                        return 130
                    water.show(solution.times[-1] * i / max(arguments.frames - 1, 1))
                    movie.add(scene.picture())
        water.show(solution.times[-1])
        scene.write(arguments.picture)
        low, high = solution.range_of("height")
    print(f"{arguments.picture}: {points} nodes, {triangles} triangles; waves of {low:.2f} to {high:.2f} m")
    return 0


if __name__ == "__main__":
    with ending("breakwater"):
        sys.exit(main())

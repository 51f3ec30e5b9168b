# SPDX-License-Identifier: BSD-3-Clause
"""surfaces: how far from its right place a reflection is looked up on a mesh that is not flat, by the height of the
surface over its plane."""

import numpy as np
import water_test as wt
import wave_scenes
from reference import reflected
from report import plt, table
from ray_caster import eye_rays
from tracer import Tracer
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper

HALF_WIDTH = 24.0
CELLS = 480
BINS = (0.0, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8)  # of heights over or under the plane
LEAST = 100  # pixels of a bin that is told of
VIEWS = ("middle", "low", "high")

TEXT = """
A solver's surface leaves its plane. Here a swell, and the front of a dam break with short waves behind it, are meshes of
$cells x $cells cells with normals, around the islands of the first section. Embree traces the mesh and what its
reflected rays meet. A pixel counts only if its ray meets an island that is visible in the mirrored view, and does not
meet water first. The error is the distance in pixels of the lookup from its correct place. "Plane's normal" is the same
with `MeshSlopesOff`.

$table

$plot

*Error by the height of the surface above or below its plane: median (solid lines) and the error that 95 % of the
pixels do not exceed (dashed). Grey: the plane's normal, median.*
"""


def swell(x, y):
    angle = 0.55 * x + 0.25 * y
    return 0.35 * np.sin(angle), 0.55 * 0.35 * np.cos(angle), 0.25 * 0.35 * np.cos(angle)


def dam_break(x, y):
    """A front along y, 1.1 m high over 6 m, behind it waves of 4 cm."""
    rise = 0.55 * np.tanh(-x / 3.0)
    slope = -0.55 / 3.0 / np.cosh(x / 3.0) ** 2
    part, change = 0.5 - 0.5 * np.tanh(x / 3.0), -0.5 / 3.0 / np.cosh(x / 3.0) ** 2
    angle = 2.2 * x + 1.3 * y
    ripple = 0.04 * np.sin(angle)
    return (rise + part * ripple, slope + change * ripple + 2.2 * 0.04 * part * np.cos(angle),
            1.3 * 0.04 * part * np.cos(angle))


SURFACES = {"swell": swell, "dam break": dam_break}


def mesh_of(surface):
    source = vtkPlaneSource()
    source.SetOrigin(-HALF_WIDTH, -HALF_WIDTH, 0)
    source.SetPoint1(HALF_WIDTH, -HALF_WIDTH, 0)
    source.SetPoint2(-HALF_WIDTH, HALF_WIDTH, 0)
    source.SetResolution(CELLS, CELLS)
    source.Update()
    places = np.linspace(-HALF_WIDTH, HALF_WIDTH, CELLS + 1)
    x, y = np.meshgrid(places, places)
    height, along, across = surface(x, y)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.stack([x, y, height], axis=-1).reshape(-1, 3), deep=1))
    normals = np.stack([-along, -across, np.ones_like(along)], axis=-1).reshape(-1, 3)
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(source.GetOutput().GetPolys())
    mesh.GetPointData().SetNormals(
        numpy_to_vtk(normals / np.linalg.norm(normals, axis=1, keepdims=True), deep=1))
    return mesh


def tracer_of(mesh):
    """Of the water's mesh alone, with the colours of its points where it has some."""
    view = wt.View((4, 4))
    wt.add_actor(view.renderer, mesh, (1, 1, 1), lit=False).GetMapper().ScalarVisibilityOn()
    return Tracer(view.renderer)


class Case:
    """One view of a surface: where each of its pixels should be looked up, and the pixels that count.

    away_of(ray, place, seen) returns the rays that the surface reflects, from rays, where they meet it, and its colours
    there. The water's plane is z = 0, and its mesh is the mapper's.
    """

    def __init__(self, made, water, size, away_of):
        self.made, self.water, self._size = made, water, size
        mesh = water.GetMapper().GetInput()
        made.picture()
        self.things, waters = Tracer(made.renderer), tracer_of(mesh)
        camera = made.renderer.GetActiveCamera()
        start, ray = eye_rays(camera, size, 1)
        to_thing = self.things.cast(start, ray)[1]
        seen, to_water = waters.cast(start, ray)
        is_water = (to_water < to_thing) & wt.water_mask(made, water).ravel()
        place = start + np.where(np.isfinite(to_water), to_water, 0)[:, None] * ray
        away = away_of(ray, place, seen)
        length = self.things.cast(place, away)[1]
        again = waters.cast(place + 1e-2 * away, away)[1]
        is_hit = np.isfinite(length) & (length < again) & (away[:, 2] > 0)
        end = place + np.where(is_hit, length, 0)[:, None] * away
        lowest = min(0.999 * mesh.GetBounds()[4], 0.0)  # a film on a floor does not show it
        right, self.texture_size = wave_scenes.map_places(camera, water, end, size)
        is_on_map = ((right > 0) & (right < 1)).all(axis=1)
        self.counts = is_water & is_hit & is_on_map & self._is_seen(camera, end, lowest)
        self.right, self.height = right[self.counts], np.abs(place[self.counts, 2])

    def _is_seen(self, camera, points, lowest):
        """Whether the mirrored eye sees points, through the height at which its view begins."""
        below = np.asarray(camera.GetPosition()) * (1, 1, -1)
        look = points - below
        share = np.where(look[:, 2] > 0, (lowest - below[2]) / np.where(look[:, 2] > 0, look[:, 2], 1), 0)
        through = below + np.maximum(share, 0)[:, None] * look
        way = np.linalg.norm(points - through, axis=1)
        return self.things.cast(through, look / np.linalg.norm(look, axis=1, keepdims=True))[1] > way - 1e-3

    def errors(self):
        looked_up = wave_scenes.looked_up(self.made, self.water)[self.counts]
        return np.linalg.norm((looked_up - self.right) * self.texture_size, axis=1)


def island_case(view, surface):
    made, water = wave_scenes.island_scene(view, ())
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh_of(surface))
    water.SetMapper(mapper)
    return Case(made, water, wave_scenes.ISLANDS_SIZE,
                lambda ray, place, _: reflected(ray, *surface(place[:, 0], place[:, 1])[1:])[1])


def measure(cases):
    """Heights, and errors with the mesh's slopes and by the plane's normal, of some cases."""
    sloped = np.concatenate([case.errors() for case in cases])
    for case in cases:
        case.water.MeshSlopesOff()
    plane = np.concatenate([case.errors() for case in cases])
    return np.concatenate([case.height for case in cases]), sloped, plane


def plot(measured):
    figure, axes = plt.subplots(1, len(measured), figsize=(9, 3.6), sharey=True)
    for axis, (name, (height, sloped, plane)) in zip(axes, measured.items()):
        bins = [(0.5 * (low + high), (height >= low) & (height < high)) for low, high in zip(BINS, BINS[1:])]
        bins = [(middle, chosen) for middle, chosen in bins if chosen.sum() >= LEAST]
        middles = [middle for middle, _ in bins]
        axis.plot(middles, [np.median(sloped[chosen]) for _, chosen in bins], "k-o", markersize=3)
        axis.plot(middles, [np.percentile(sloped[chosen], 95) for _, chosen in bins], "k--")
        axis.plot(middles, [np.median(plane[chosen]) for _, chosen in bins], color="0.6")
        axis.set(yscale="log", ylim=(0.01, 300), xlabel="height over the plane, m", title=name)
    axes[0].set_ylabel("lookup error, pixels")
    return figure


def run(report):
    rows, measured = [], {}
    for name, surface in SURFACES.items():
        measured[name] = height, sloped, plane = measure([island_case(view, surface) for view in VIEWS])
        report.check_at_least(f"{name}: pixels counted", len(sloped), 1000, 0)
        report.check_at_most(f"{name}: median error, px", float(np.median(sloped)), 0.2)
        report.check_at_least(f"{name}: % of hits within 1 px", 100 * float((sloped <= 1).mean()), 95, 2)
        report.check_at_least(f"{name}: median error with the plane's normal, px", float(np.median(plane)), 2)
        for low, high in zip(BINS, BINS[1:]):
            chosen = (height >= low) & (height < high)
            if chosen.sum() >= LEAST:
                off = sloped[chosen]
                rows.append((name, f"{low:g} to {high:g}", str(int(chosen.sum())), f"{np.median(off):.3f}",
                             f"{np.percentile(off, 95):.2f}", f"{100 * (off <= 1).mean():.1f} %",
                             f"{np.median(plane[chosen]):.1f}"))
    header = ("surface", "height, m", "pixels", "median, px", "95 % within", "within 1 px", "plane's normal: median")
    report.add(
        "Meshes that are not flat", TEXT, cells=CELLS, table=table(header, rows),
        plot=report.save(plot(measured), "surfaces", "Lookup error by the height over the plane"))

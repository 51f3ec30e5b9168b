# SPDX-License-Identifier: BSD-3-Clause
"""solver: how far from its right place a reflection is looked up on the water of the example's dam break, which
OpenFOAM's interFoam has computed, and on the same water with a flat plane's mirror."""

import pathlib
import sys

import numpy as np
import water_test as wt
from report import table
from surfaces import Case, measure
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper
from vtkwater import vtkWaterActor

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Examples/Python"))
import dam_break  # noqa: E402

SIZE = (640, 360)
TIMES = (0.4, 0.7, 1.0, 1.3, 1.6, 2.0)  # s
EYE, FOCAL_POINT, VIEW_ANGLE = (3.6, -3.0, 1.9), (1.75, 0.42, 0.12), 30.0  # as in the example

TEXT = """
The water of [dam_break.py](../Examples/Python/dam_break.py), in the example's tank and seen by its camera, at $count times: the contour
of interFoam's volume fraction, with splashes and overturning waves. Embree traces it, with the same normals, and what
its reflected rays meet, as in the last section. "Flat mirror" is the same surface, showing what its mean plane
reflects (`MeshSlopesOff`, the "plane's normal" of the last section).

$table
"""


def mesh_at(flow, time):
    """The surface with its mean height at z = 0, its normals also as scalars that a tracer reads; and that height."""
    flow.show(time)
    mesh = vtkPolyData()
    mesh.DeepCopy(flow.normals.GetOutput())
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    water, placement = vtkWaterActor(), [0.0] * 4
    water.SetMapper(mapper)
    water.GetMeshPlacement(placement)
    normals = 255.0 * vtk_to_numpy(mesh.GetPointData().GetNormals()).astype(float)
    mesh.GetPointData().SetScalars(numpy_to_vtk(normals, deep=True))
    return lowered(mesh, placement[0]), placement[0]


def lowered(mesh, height):
    places = vtk_to_numpy(mesh.GetPoints().GetData())
    places[:, 2] -= height
    mesh.GetPoints().Modified()
    return mesh


class Tank:
    """Takes the parts of the example's tank, and puts them into a view, lower by a height."""

    def __init__(self, view, height):
        self._view, self._height = view, height

    def add_box(self, bounds, color):
        low, high = np.array(bounds[::2]), np.array(bounds[1::2])
        box = lowered(wt.box(0.5 * (low + high), high - low), self._height)
        wt.add_actor(self._view.renderer, box, color, lit=False)


def case_at(flow, time):
    mesh, height = mesh_at(flow, time)
    view = wt.View(SIZE)
    dam_break.add_tank(Tank(view, height), flow.grid.GetBounds()[1::2])
    glass = vtkPolyData()
    flow.side.Update()
    glass.DeepCopy(flow.side.GetOutput())
    glass.GetPointData().Initialize()
    wt.add_actor(view.renderer, lowered(glass, height), dam_break.SIDE, lit=False)
    water = wt.add_water(view.renderer)
    water.AddObserver("WarningEvent", lambda *_: None)  # a splash is steeper than any wave
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.ScalarVisibilityOff()
    water.SetMapper(mapper)
    down = np.array((0.0, 0.0, height))
    wt.place_camera(view.renderer, EYE - down, FOCAL_POINT - down, (0.5, 20.0))
    view.renderer.GetActiveCamera().SetViewAngle(VIEW_ANGLE)
    return Case(view, water, SIZE, away_of)


def away_of(ray, place, normal):
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    normal = normal / np.where(length > 0, length, 1)
    return ray - 2 * (ray * normal).sum(axis=1, keepdims=True) * normal


def run(report):
    flow, rows, all_sloped, all_plane = dam_break.DamBreak(), [], [], []
    for time in TIMES:
        height, sloped, plane = measure([case_at(flow, time)])
        all_sloped.append(sloped)
        all_plane.append(plane)
        rows.append((f"{time:g}", str(len(sloped)), f"{height.max():.2f}", f"{np.median(sloped):.3f}",
                     f"{100 * (sloped <= 1).mean():.1f} %", f"{np.median(plane):.1f}",
                     f"{100 * (plane <= 1).mean():.1f} %"))
    sloped, plane = np.concatenate(all_sloped), np.concatenate(all_plane)
    report.check_at_least("interFoam's dam break: pixels counted", len(sloped), 1000, 0)
    report.check_at_least("interFoam's dam break: % of hits within 1 px", 100 * float((sloped <= 1).mean()), 95, 2)
    report.check_at_most("interFoam's dam break: median error, px", float(np.median(sloped)), 0.2)
    report.check_at_least("interFoam's dam break: median error of a flat mirror, px", float(np.median(plane)), 2)
    header = ("time, s", "pixels", "height, m, at most", "median, px", "within 1 px", "flat mirror: median", "within 1 px")
    report.add("A solver's dam break", TEXT, count=len(TIMES), table=table(header, rows))

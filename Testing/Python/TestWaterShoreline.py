# SPDX-License-Identifier: BSD-3-Clause
"""The shore in the picture is where the depth is zero, step by step, and what stays dry does not change."""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper
from vtkwater import vtkWaterActor, vtkWaterSurfaceFilter

STEPS = 100
SIZE = (160, 120)
CELLS = 40  # a side: of 4 pixels each
HALF = 10.0  # the mesh covers [-10, 10] x [-10, 10]
HEIGHT, ANGLE = 40.0, 20.0  # of the eye; degrees
SLOPE = np.array((0.3, 0.11))  # of the bed


def bed_at(x, y):
    return SLOPE[0] * x + SLOPE[1] * y


def level_of(step):
    return 2.0 * np.sin(0.37 * step)


def grid():
    """Triangles whose points lie in no row, and their bed."""
    random = np.random.default_rng(3)
    x, y = np.meshgrid(*2 * [np.linspace(-HALF, HALF, CELLS + 1)])
    x, y = (part + np.pad(random.uniform(-0.15, 0.15, (CELLS - 1, CELLS - 1)), 1) for part in (x, y))
    first = (np.arange(CELLS)[:, None] * (CELLS + 1) + np.arange(CELLS)).ravel()
    cells = vtkCellArray()
    for corners in (first, first + 1, first + CELLS + 2), (first, first + CELLS + 2, first + CELLS + 1):
        for triangle in np.stack(corners, axis=1).tolist():
            cells.InsertNextCell(3, triangle)
    points, mesh = vtkPoints(), vtkPolyData()
    places = np.c_[x.ravel(), y.ravel(), bed_at(x, y).ravel()]
    points.SetData(numpy_to_vtk(places, deep=True))
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    add(mesh, "zb", places[:, 2])
    return mesh, places


def add(mesh, name, values):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    mesh.GetPointData().AddArray(array)


def places_of_pixels():
    """x and y where the ray of each pixel meets the bed, rows from below."""
    scale = np.tan(np.radians(ANGLE / 2)) / (SIZE[1] / 2)
    u = (np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2) * scale
    v = ((np.arange(SIZE[1]) + 0.5 - SIZE[1] / 2) * scale)[:, None]
    way = HEIGHT / (1.0 + bed_at(u, v))  # (u, v, -1) way from the eye meets z = bed
    return u * way, v * way, scale


@pytest.mark.parametrize("samples", (0, 4))
def test_the_shore_is_where_the_depth_is_zero(samples):
    """Every pixel that is further than half a pixel from the exact line is wet or dry as the depth says, over 100
    steps; the land's pixels that are dry in two steps are the same in both."""
    mesh, places = grid()
    view = wt.View(SIZE, (0, 0, 0), samples=samples)
    land = wt.add_actor(view.renderer, mesh, (0.8, 0.4, 0.1))
    land.GetProperty().LightingOff()
    surface, mapper, water = vtkWaterSurfaceFilter(), vtkPolyDataMapper(), vtkWaterActor()
    surface.SetInputData(mesh)
    surface.SetDepthArrayName("h")
    surface.SetBedArrayName("zb")
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.ScalarVisibilityOff()
    water.SetMapper(mapper)
    look = water.GetWaterProperty()
    look.SetReflectanceModeToConstant()
    look.SetReflectance(0.0)
    look.SetDeepColor(0.0, 0.0, 1.0)
    view.renderer.AddActor(water)
    camera = wt.place_camera(view.renderer, (0, 0, HEIGHT), (0, 0, 0), (20, 60), (0, 1, 0))
    camera.SetViewAngle(ANGLE)
    x, y, scale = places_of_pixels()
    inside = (np.abs(x) < HALF - 0.5) & (np.abs(y) < HALF - 0.5)
    half_pixel = 0.5 * scale * HEIGHT * 1.1 * np.linalg.norm(SLOPE)  # of depth; land is nearer to the eye
    margin = half_pixel * (np.sqrt(2.0) if samples else 1.0)  # a line crosses several pixels' samples
    wrong = changed = 0
    before = before_dry = None
    for step in range(STEPS):
        level = level_of(step)
        add(mesh, "h", np.maximum(level - places[:, 2], 0.0))
        mesh.Modified()
        surface.Update()
        water.SetLevel(surface.GetMeanLevel())
        picture = view.picture().astype(int)
        depth = level - bed_at(x, y)
        dry = inside & (depth < -margin)
        wet = inside & (depth > margin)
        is_land = picture[:, :, 0] > 190
        is_water = picture[:, :, 0] < 10
        wrong += int((dry & ~is_land).sum() + (wet & ~is_water).sum())
        if before is not None:
            changed += int((dry & before_dry & (picture != before).any(axis=2)).sum())
        before, before_dry = picture, dry
    wt.save(before, wt.output_folder() / f"Shoreline-{samples}.png")
    wt.check_equal(f"pixels of {STEPS} steps on the wrong side, by more than half a pixel", wrong, 0)
    wt.check_equal(f"dry pixels of {STEPS} steps that change", changed, 0)
    wt.check_at_least("share of the last picture that is wet", float(is_water[inside].mean()), 0.1)
    wt.check_at_least("share of the last picture that is dry", float(is_land[inside].mean()), 0.1)

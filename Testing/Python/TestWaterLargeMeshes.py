# SPDX-License-Identifier: BSD-3-Clause
"""On a GPU large meshes are drawn as runs of their triangles: from eyes and on meshes that a seed chooses no
picture changes, and fewer triangles are drawn.

The environment may ask for more meshes: WATER_LARGE_MESHES, a number.
"""

import os

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkwater import vtkWaterReflectionPass as Pass

pytestmark = pytest.mark.usefixtures("on_a_gpu")

SIZE = (320, 240)
CELLS = 150  # a side: 45,000 triangles
# another VTK takes half of them where WATER_TESTS_ONCE=0
SEEDS = range(int(os.environ.get("WATER_LARGE_MESHES", 2 if os.environ.get("WATER_TESTS_ONCE") == "0" else 4)))
WAVES = ((0.05, 4.0, 20, 0), (0.03, 2.3, 80, 30))


def hilly(random):
    """A square of hills of random heights, some under water, in random order of rows and of columns."""
    axis = np.linspace(-14, 14, CELLS + 1)
    x, y = np.meshgrid(axis[:: random.choice((1, -1))], axis[:: random.choice((1, -1))])
    z = np.full_like(x, random.uniform(-1.5, 1.0))
    for _ in range(5):
        k, phase = random.uniform(-1.2, 1.2, 2), random.uniform(0, 6)
        z += random.uniform(0.2, 1.2) * np.sin(k[0] * x + k[1] * y + phase)
    points = np.stack((x, y, z), axis=-1).reshape(-1, 3)
    corner = (np.arange(CELLS)[:, None] * (CELLS + 1) + np.arange(CELLS)).ravel()
    quad = np.array((0, 1, CELLS + 2, 0, CELLS + 2, CELLS + 1))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray((corner[:, None] + quad).ravel(), deep=True))
    places = vtkPoints()
    places.SetData(numpy_to_vtk(points.astype(random.choice((np.float32, np.float64))), deep=True))
    data = vtkPolyData()
    data.SetPoints(places)
    data.SetPolys(cells)
    data.GetPointData().SetScalars(numpy_to_vtk(points[:, 2].copy(), deep=True))
    return data


def move_actor(scene, random):
    scene.land.SetPosition(*random.uniform(-2, 2, 2), random.uniform(-0.5, 0.5))


def turn_actor(scene, random):
    transform = vtkTransform()
    transform.RotateZ(random.uniform(0, 360))
    transform.RotateX(random.uniform(-10, 10))
    transform.Scale(1, 1, random.uniform(0.5, 2))
    scene.land.SetUserTransform(transform)


def change_points(scene, random):
    points = vtk_to_numpy(scene.data.GetPoints().GetData())
    points[:, 2] += random.uniform(-0.7, 0.7)
    scene.data.GetPoints().Modified()
    scene.data.Modified()


def raise_water(scene, random):
    scene.water.SetLevel(random.uniform(-1, 1))


def show_edges(scene, random):
    scene.land.GetProperty().SetEdgeVisibility(not scene.land.GetProperty().GetEdgeVisibility())


def show_points(scene, random):
    scene.land.GetProperty().SetVertexVisibility(not scene.land.GetProperty().GetVertexVisibility())


def do_nothing(scene, random):
    pass


CHANGES = (move_actor, turn_actor, change_points, raise_water, show_edges, show_points, do_nothing, do_nothing)


class Scene:
    """A mesh, another one in front of it now and then, and water; everything from the seed."""

    def __init__(self, seed, skips, has_waves, samples):
        self.random = np.random.default_rng(seed)
        self.view = wt.View(SIZE, samples=samples)
        self.data = hilly(self.random)
        self.land = wt.add_actor(self.view.renderer, self.data, (0.6, 0.5, 0.3))
        self.land.GetMapper().ScalarVisibilityOn()
        wt.add_actor(self.view.renderer, wt.box((3, 2, 1), (2, 2, 4)), (0.8, 0.2, 0.2))
        self.water = wt.add_water(self.view.renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-14, 14, -14, 14), 1.0)
        for wave in WAVES if has_waves else ():
            self.water.GetWaterProperty().AddWave(*wave)
        self.reflection = self.water.GetReflectionPass()
        self.reflection.SetSkips(skips)
        self.reflection.InstrumentationOn()

    def frames(self):
        """Pictures and numbers of triangles along random moves and changes."""
        for change in self.random.permutation(CHANGES):
            eye = (*self.random.uniform(-16, 16, 2), self.random.uniform(0.5, 9))
            wt.place_camera(self.view.renderer, eye, (*self.random.uniform(-6, 6, 2), 0), (0.1, 80))
            change(self, self.random)
            yield self.view.picture(), self.reflection.GetNumberOfTrianglesReflected()


@pytest.mark.parametrize("samples", [0, 4], ids=["0_samples", "4_samples"])
@pytest.mark.parametrize("has_waves", [False, True], ids=["calm", "waves"])
def test_runs_of_large_meshes_change_no_picture(has_waves, samples):
    """Whatever the eye, the mesh and its changes: the picture is that of the whole mesh, with fewer triangles."""
    largest, drawn, whole = 0, 0, 0
    seeds = SEEDS if samples == 0 else SEEDS[:max(2, len(SEEDS) // 2)]  # several samples are of the same triangles
    for seed in seeds:
        some = Scene(seed, Pass.SKIP_ALL, has_waves, samples)
        everything = Scene(seed, Pass.SKIP_ALL & ~Pass.PIECES, has_waves, samples)
        for (one, few), (other, many) in zip(some.frames(), everything.frames()):
            largest = max(largest, int(np.abs(one - other).max()))
            drawn += max(few, 0)
            whole += max(many, 0)
    wt.check_at_most("largest difference of a pixel", largest, 0)
    wt.check_at_most("triangles drawn, of all", drawn / whole, 0.95)


def layered(data):
    """The mesh with a second layer at the same places, of other colours, quad after quad in turns."""
    points = vtk_to_numpy(data.GetPoints().GetData())
    colours = vtk_to_numpy(data.GetPointData().GetScalars())
    quads = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 6)
    # a layer's quad lies some leaves of runs behind the other's, so that they are not in one leaf
    behind = np.roll(quads, -9 * CELLS // 10, axis=0) + len(points)
    places = vtkPoints()
    places.SetData(numpy_to_vtk(np.concatenate((points, points)), deep=True))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.stack((quads, behind), axis=1).ravel().astype(np.int64), deep=True))
    made = vtkPolyData()
    made.SetPoints(places)
    made.SetPolys(cells)
    made.GetPointData().SetScalars(numpy_to_vtk(np.concatenate((colours, 1 - colours)), deep=True))
    return made


def layers_picture(data, seed, skips):
    view = wt.View(SIZE)
    wt.add_actor(view.renderer, data, (1, 1, 1)).GetMapper().ScalarVisibilityOn()
    wt.add_water(view.renderer, None, (-14, 14, -14, 14), 1.0).GetReflectionPass().SetSkips(skips)
    wt.place_camera(view.renderer, (3 * seed - 10, -15, 4), (0, 0, 0), (0.1, 80))
    return view.picture()


def test_coincident_layers_keep_their_order():
    """Where two layers of one mesh are equally far the one drawn last is seen, as of the whole mesh."""
    largest = 0
    for seed in SEEDS:
        data = layered(hilly(np.random.default_rng(seed)))
        one, other = (layers_picture(data, seed, skips) for skips in (Pass.SKIP_ALL, Pass.SKIP_ALL & ~Pass.PIECES))
        largest = max(largest, int(np.abs(one - other).max()))
    wt.check_at_most("largest difference of a pixel", largest, 0)

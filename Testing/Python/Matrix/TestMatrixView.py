# SPDX-License-Identifier: BSD-3-Clause
"""Row View of the mirror matrix: cameras, and planes of any orientation."""

import math

import mirror_matrix as mm
import numpy as np
import water_test as wt
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform

row = mm.Results("View", __file__)


def things(scene):
    scene.add_data(wt.sphere((0, 0, 0.4), 1.5), (1, 0.6, 0.2), specular=0.6)
    scene.add_data(wt.box((2.6, 0.8, 0.4), (0.8, 0.8, 2.2)), (0.3, 0.8, 0.4), specular=0.6)
    scene.add_data(wt.pyramid((-2.4, 0.8, 0.6), 2.2), (0.4, 0.5, 1), specular=0.6)
    wt.add_scene_light(scene.renderer, (2, -4, 5))


def cell(name, look, **options):
    """look(scene, camera) sets the camera before anything is added."""

    def fill(scene):
        look(scene, scene.camera)
        things(scene)

    row.cell(name, fill, **options)


def parallel(scene, camera):
    camera.ParallelProjectionOn()
    camera.SetParallelScale(3)


def sheared(scene, camera):
    parallel(scene, camera)
    camera.SetViewShear(0.2, -0.3, 1.0)


def placed(position, focal_point=(0, 0, 0.2), up=(0, 0, 1)):
    def look(scene, camera):
        camera.SetPosition(position)
        camera.SetFocalPoint(focal_point)
        camera.SetViewUp(up)

    return look


def transformed(scene, camera):
    transform = vtkTransform()
    transform.RotateZ(12)
    transform.Translate(0.3, -0.2, 0)
    camera.SetUserViewTransform(transform)
    scene.keep.append(transform)


def explicit(scene, camera):
    """A frustum that is neither symmetric nor rectangular."""
    matrix = vtkMatrix4x4()
    values = ((2.4, 0.2, 0.15, 0), (-0.1, 3.1, -0.2, 0), (0, 0, -61 / 59, -120 / 59), (0, 0, -1, 0))
    for i, line in enumerate(values):
        for j, value in enumerate(line):
            matrix.SetElement(i, j, value)
    camera.SetExplicitProjectionTransformMatrix(matrix)
    camera.UseExplicitProjectionTransformMatrixOn()
    scene.keep.append(matrix)


def grazing(degrees):
    angle = math.radians(degrees)
    return placed((0, -12 * math.cos(angle), 12 * math.sin(angle)), (0, 0, 0))


cell("perspective", lambda scene, camera: camera.SetViewAngle(40))
cell("wide angle", lambda scene, camera: camera.SetViewAngle(90))
cell("parallel", parallel)
cell("window center", lambda scene, camera: camera.SetWindowCenter(0.4, -0.3))
cell("window center, parallel", lambda scene, camera: (parallel(scene, camera), camera.SetWindowCenter(-0.3, 0.2)))
cell("view shear, parallel", sheared)
cell("view shear, perspective", lambda scene, camera: camera.SetViewShear(0.15, 0.1, 1.0))
cell("user view transform", transformed)
cell("explicit projection", explicit)
cell("roll of 33 degrees", lambda scene, camera: camera.SetRoll(33))
cell("roll of 180 degrees", lambda scene, camera: camera.SetRoll(180))
cell("2 degrees over the water", grazing(2))
cell("0.3 degrees over the water", grazing(0.3))
cell("straight down", placed((0.2, 0.1, 9), (0.2, 0.1, 0), (0, 1, 0)))
cell("from under the water", placed((1.5, -9, -4)))
cell("from under the water, straight up", placed((0.2, 0.1, -9), (0.2, 0.1, 0), (0, 1, 0)))
cell("view angle by width", lambda scene, camera: camera.UseHorizontalViewAngleOn())
cell("a window of 301 x 173 pixels", lambda scene, camera: None, size=(301, 173))
cell("tilted plane", lambda scene, camera: None, origin=(0, 0, 0.1), normal=(0.2, 0.3, 1))
cell("upright plane", placed((3, -9, 4)), origin=(-1.5, 0, 0), normal=(1, -0.2, 0))
cell("plane whose normal points down", lambda scene, camera: None, normal=(0, 0, -1))


@row.makes("user view transform that scales")
def scaled():
    """A view that is not rigid has no mirror image that is a camera's: said, and plain water."""
    scene = mm.Scene(mm.SEEN)
    things(scene)
    transform = vtkTransform()
    transform.Scale(1.1, 0.9, 1)
    scene.camera.SetUserViewTransform(transform)
    water = wt.add_water(scene.renderer, wt.plane((0, 0, 0), (0, 0, 1)), mm.SHEET)
    water.GetWaterProperty().SetDeepColor(0, 0.2, 0.6)
    errors = wt.errors_of(water)
    seen = [scene.pixels() for _ in range(3)][-1]
    water.VisibilityOff()
    without = scene.pixels()
    is_water = np.abs(seen - without).max(axis=2) > 0
    is_plain = np.abs(seen - (0, 51, 153)).max(axis=2) <= 1
    row.say("user view transform that scales: one error, plain water",
            len(errors) == 1 and "view rigid" in errors[0] and is_water.sum() > 1000 and is_plain[is_water].all(),
            reason="A view that scales or shears is rejected with an error: no vtkCamera can have its mirror image.")


test_cell = row.test()

# SPDX-License-Identifier: BSD-3-Clause
"""skip_changes: changes of skip_scenes by name.

A change is a function of a scene and of the numbers that numbers() drew, uniform in [-1, 1]; two scenes
that get the same changes stay equal.
"""

import numpy as np
import water_test as wt
from skip_scenes import SIZE
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkCommonTransforms import vtkTransform

CHANGES = {}


def change(function):
    CHANGES[function.__name__.replace("_", " ")] = function
    return function


def numbers(random):
    return random.uniform(-1, 1, 8)


def _pick(things, number):
    return things[int((number + 1) / 2 * len(things)) % len(things)]


@change
def camera_orbits(scene, n):
    angle, height = np.pi * n[0], 0.6 + 5 * (n[1] + 1)
    scene.place_camera((16 * np.sin(angle), -16 * np.cos(angle), height), (3 * n[2], 3 * n[3], 0))


@change
def camera_creeps(scene, n):
    x, y, z = scene.camera.GetPosition()
    scene.camera.SetPosition(x + 0.3 * n[0], y + 0.3 * n[1], max(z, 0.2) + 0.1 * abs(n[2]))


@change
def camera_zooms(scene, n):
    scene.camera.SetViewAngle(30 + 20 * n[0])


@change
def camera_rolls(scene, n):
    scene.camera.Roll(60 * n[0])


@change
def camera_under_water(scene, n):
    scene.place_camera((6 * n[0], 6 * n[1] - 3, -0.9 + 0.5 * n[2]), (6 * n[3], 6 * n[4], 0.4 * n[5] - 0.3), angle=60)


@change
def camera_behind_a_hill(scene, n):
    scene.place_camera((4 * n[0], 18, 0.8 + 0.4 * n[1]), (2 * n[2], 0, 0.6), angle=25 + 10 * n[3])


@change
def camera_looks_down(scene, n):
    scene.place_camera((4 * n[0], 4 * n[1], 12), (4 * n[0], 4 * n[1], 0), roll=90 * n[2])


@change
def camera_looks_away(scene, n):
    scene.place_camera((3 * n[0], -14, 2), (3 * n[0], -40, 6 + 3 * n[1]))


@change
def camera_grazes(scene, n):
    scene.place_camera((8 * n[0], -12, 0.25 + 0.1 * n[1]), (0, 0, 0.2), angle=20)


@change
def camera_parallel(scene, n):
    scene.place_camera((10 * n[0], -12, 6 + 4 * n[1]), (0, 0, 0))
    scene.camera.ParallelProjectionOn()
    scene.camera.SetParallelScale(6 + 3 * n[2])


@change
def camera_parallel_to_the_water(scene, n):
    scene.place_camera((0, -14, 0.5), (0, 0, 0.5))
    scene.camera.ParallelProjectionOn()
    scene.camera.SetParallelScale(5)


@change
def clipping_range(scene, n):
    scene.camera.SetClippingRange(0.2 + 0.1 * n[0], 80 + 20 * n[1])


@change
def nothing(scene, n):
    pass


@change
def time_goes_on(scene, n):
    for water in scene.waters:
        water.SetTime(water.GetTime() + 0.2 + 0.1 * n[0])


@change
def thing_moves(scene, n):
    _pick(scene.things, n[0]).AddPosition(1.5 * n[1], 1.5 * n[2], n[3])


@change
def assembly_turns(scene, n):
    scene.parts.RotateZ(90 * n[0])
    scene.parts.GetParts().GetItemAsObject(0).SetScale(0.4 + 0.1 * n[1])


@change
def user_matrix(scene, n):
    transform = vtkTransform()
    transform.RotateX(30 * n[0])
    transform.Scale(1 + 0.3 * n[1], 1, 1)
    _pick(scene.things, n[2]).SetUserTransform(transform)


@change
def volume_moves(scene, n):
    scene.volume.SetPosition(4 * n[0], 4 * n[1], 1 + n[2])


@change
def volume_transfer(scene, n):
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(40 + 20 * n[0], 0)
    opacity.AddPoint(255, 0.5 + 0.2 * n[1])
    scene.volume.GetProperty().SetScalarOpacity(opacity)


@change
def visibility(scene, n):
    thing = _pick([*scene.things, scene.hills, scene.parts, scene.volume], n[0])
    thing.SetVisibility(not thing.GetVisibility())


@change
def colour(scene, n):
    _pick(scene.things, n[0]).GetProperty().SetColor(*(0.5 + 0.5 * n[1:4]))


@change
def opacity(scene, n):
    _pick(scene.things, n[0]).GetProperty().SetOpacity(0.4 if n[1] > 0 else 1.0)


@change
def representation(scene, n):
    land = _pick([scene.hills, scene.bed], n[0]).GetProperty()
    land.SetRepresentation(1 if n[1] > 0.6 else 2)
    land.SetInterpolation(1 if n[2] > 0 else 0)


@change
def points_in_place(scene, n):
    land = _pick([scene.hills, scene.bed], n[0]).GetMapper().GetInput()
    points = vtk_to_numpy(land.GetPoints().GetData())
    points[:, 2] += 0.3 * n[1] * np.sin(points[:, 0] * 2 + 3 * n[2])
    land.GetPoints().GetData().Modified()
    land.GetPoints().Modified()
    land.Modified()


@change
def scalars_in_place(scene, n):
    scalars = scene.hills.GetMapper().GetInput().GetPointData().GetScalars()
    vtk_to_numpy(scalars)[:] *= 1 + 0.3 * n[0]
    scalars.Modified()


@change
def scalars_shown_or_not(scene, n):
    scene.hills.GetMapper().SetScalarVisibility(int(n[0] > 0))


@change
def lookup_table(scene, n):
    scene.table.SetHueRange(0.3 + 0.3 * n[0], 0.5 + 0.3 * n[1])
    scene.table.ForceBuild()


@change
def texture_pixels(scene, n):
    pixels = scene.image.GetPointData().GetScalars()
    values = vtk_to_numpy(pixels)
    values[:] = np.roll(values, 3, axis=0) // 2 + int(60 * (n[0] + 1))
    pixels.Modified()
    scene.image.Modified()


@change
def light_moves(scene, n):
    scene.sun.SetPosition(15 * n[0], 15 * n[1], 20)


@change
def light_intensity(scene, n):
    scene.sun.SetIntensity(0.8 + 0.3 * n[0])


@change
def light_added_or_removed(scene, n):
    lights = scene.renderer.GetLights()
    if lights.GetNumberOfItems() > 1:
        scene.renderer.RemoveLight(lights.GetItemAsObject(1))
    else:
        scene.add_light((10 * n[0], 10, 8)).SetColor(1, 0.5 + 0.5 * n[1], 0.5)


@change
def background(scene, n):
    scene.renderer.SetBackground(*(0.5 + 0.4 * n[:3]))
    scene.renderer.SetBackground2(*(0.5 + 0.4 * n[3:6]))
    scene.renderer.SetGradientBackground(int(n[6] > 0))


@change
def level(scene, n):
    for water in scene.waters[:1] if n[0] > 0.6 else scene.waters[:2]:
        water.SetLevel(0.3 * n[1])


@change
def levels_again(scene, n):
    for water in scene.waters[:2]:
        water.SetLevel(0)


@change
def sheet_bounds(scene, n):
    scene.waters[0].SetSheetBounds(-7 + 2 * n[0], 0, -7 + 2 * n[1], 7 + 2 * n[2])


@change
def sheet_shrinks(scene, n):
    for i, water in enumerate(scene.waters[:2]):
        x = 4 * i - 3 + n[0]
        water.SetSheetBounds(x, x + 1.5, -1, 1 + n[1])


@change
def water_property(scene, n):
    look = scene.waters[0].GetWaterProperty()
    look.SetDeepColor(*(0.5 + 0.5 * n[:3]))
    look.SetIndexOfRefraction(1.3 + 0.2 * n[3])
    look.SetReflectanceMode(int(n[4] > 0))


@change
def reflects_nothing(scene, n):
    look = scene.waters[-1].GetWaterProperty()
    look.SetReflectanceModeToConstant()
    look.SetReflectance(0 if n[0] > 0.4 else 0.8)


@change
def reflects_next_to_nothing(scene, n):
    for water in scene.waters[:2]:
        look = water.GetWaterProperty()
        look.SetReflectanceModeToConstant()
        look.SetReflectance(0.0015 if n[0] > 0.3 else 0.9)


@change
def environment(scene, n):
    for water in scene.waters[:2]:
        look = water.GetWaterProperty()
        look.SetReflectionSource(int(n[0] > 0.5))


@change
def culled_below(scene, n):
    for water in scene.waters:
        water.GetProperty().SetBackfaceCulling(int(n[0] > -0.3))


@change
def window_size(scene, n):
    scene.view.window.SetSize(*((SIZE[0] + 13, SIZE[1] - 7) if n[0] > 0 else SIZE))


@change
def prop_added_or_removed(scene, n):
    if len(scene.extras) > 3:
        scene.renderer.RemoveActor(scene.extras.pop(1))
        return
    thing = wt.add_actor(scene.renderer, wt.pyramid((0, 0, 0), 2), tuple(0.5 + 0.5 * n[:3]))
    thing.SetPosition(7 * n[3], 7 * n[4], 0.5)
    scene.extras.append(thing)


@change
def wall_before_the_eye(scene, n):
    """A wall that is not reflected hides all of the picture, or a side of it."""
    camera = scene.camera
    position, forward = np.array(camera.GetPosition()), np.array(camera.GetDirectionOfProjection())
    transform = vtkTransform()
    transform.PostMultiply()
    size = 8 if camera.GetParallelProjection() == 0 else 40
    transform.Scale(size, size, 1)
    right = np.cross(forward, camera.GetViewUp())
    middle = position + 2 * forward + (0 if n[0] > -0.3 else 0.5 + 4) * right
    matrix = camera.GetModelViewTransformMatrix()
    turn = vtkTransform()
    turn.SetMatrix(matrix)
    angles = turn.GetInverse().GetOrientationWXYZ()
    transform.RotateWXYZ(*angles)
    transform.Translate(*middle)
    scene.wall.SetUserTransform(transform)
    scene.wall.VisibilityOn()


@change
def wall_leaves(scene, n):
    scene.wall.VisibilityOff()

# SPDX-License-Identifier: BSD-3-Clause
"""prop_changes: changes of prop_scene by name.

A change is a function of a scene and of numbers, uniform in [0, 1); two scenes that get the same changes stay equal.
"""

import numpy as np
import water_test as wt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkInformation, vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper, vtkProperty, vtkTexture
from vtkwater import vtkWaterReflectionPass as Pass

CHANGES = {}


def change(function):
    CHANGES[function.__name__.replace("_", " ")] = function
    return function


def pick(things, number):
    return things[int(number * len(things))]


@change
def nothing(scene, n):
    pass


@change
def time(scene, n):
    scene.water.SetTime(scene.water.GetTime() + 0.1)


@change
def camera(scene, n):
    scene.camera.SetPosition(8 * n[0] - 4, -15, 2 + 4 * n[1])


@change
def position(scene, n):
    pick([*scene.actors, scene.follower, scene.glyphs, scene.volume, scene.stand_in], n[0]).AddPosition(
        3 * n[1] - 1.5, 3 * n[2] - 1.5, 0.8 * n[3] - 0.4)


@change
def under_water_or_back(scene, n):
    actor = pick(scene.actors, n[0])
    x, y, z = actor.GetPosition()
    actor.SetPosition(x, y, -3.0 if z > -1 else 1.0)


@change
def far_away_or_back(scene, n):
    actor = pick(scene.actors, n[0])
    x, y, z = actor.GetPosition()
    actor.SetPosition(x + (300 if x < 100 else -300), y, z)


@change
def color(scene, n):
    pick(scene.actors, n[0]).GetProperty().SetColor(n[1:4])


@change
def opacity(scene, n):
    pick(scene.actors, n[0]).GetProperty().SetOpacity(0.4 if n[1] > 0.5 else 1)


@change
def other_property(scene, n):
    look = vtkProperty()
    look.SetColor(n[1:4])
    pick(scene.actors, n[0]).SetProperty(look)


@change
def shared_property(scene, n):
    pick(scene.actors, n[0]).SetProperty(pick(scene.actors, n[1]).GetProperty())


@change
def wide_lines(scene, n):
    look = pick(scene.actors, n[0]).GetProperty()
    look.SetRepresentation(1 if n[1] > 0.5 else 2)
    look.SetLineWidth(1 + 5 * n[2])


@change
def other_mapper(scene, n):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(wt.sphere((0, 0, 0), 0.3 + 0.5 * n[1], 8))
    pick(scene.actors, n[0]).SetMapper(mapper)


@change
def no_mapper(scene, n):
    pick(scene.actors, n[0]).SetMapper(None)


@change
def shared_mapper(scene, n):
    """Not with a textured actor, or one with shader lines: VTK itself then shows what the mapper was built for last."""
    plain = [actor for actor in scene.actors
             if not actor.GetTexture() and not actor.GetShaderProperty().GetNumberOfShaderReplacements()]
    pick(plain, n[0]).SetMapper(pick(plain, n[1]).GetMapper())


def mapper_of(scene, number):
    mapped = [actor for actor in scene.actors if actor.GetMapper()]
    return pick(mapped, number).GetMapper()


@change
def other_data(scene, n):
    mapper_of(scene, n[0]).SetInputData(wt.box((0, 0, 0), tuple(0.3 + n[1:4])))


@change
def other_output(scene, n):
    """What hands the data over gets others, behind the mapper."""
    producer = mapper_of(scene, n[0]).GetInputAlgorithm()
    if producer and producer.IsA("vtkTrivialProducer"):
        producer.SetOutput(wt.pyramid((0, 0, 0), 0.5 + n[1]))


@change
def points_in_place(scene, n):
    data = mapper_of(scene, n[0]).GetInput()
    if data and data.GetPoints():
        vtk_to_numpy(data.GetPoints().GetData())[:] *= 0.7 + 0.6 * n[1]
        data.GetPoints().GetData().Modified()
        data.GetPoints().Modified()


@change
def scalars_in_place(scene, n):
    data = mapper_of(scene, n[0]).GetInput()
    scalars = data.GetPointData().GetScalars() if data else None
    if scalars:
        vtk_to_numpy(scalars)[:] = np.roll(vtk_to_numpy(scalars), 3)
        scalars.Modified()


@change
def connection(scene, n):
    mapper_of(scene, n[0]).SetInputConnection(pick(scene.pipelines, n[1]).port)


@change
def far_upstream(scene, n):
    pick(scene.pipelines, n[0]).ball.SetRadius(0.3 + 0.6 * n[1])


@change
def upstream_transform(scene, n):
    pick(scene.pipelines, n[0]).transform.Translate(0.5 * n[1] - 0.25, 0, 0)


@change
def upstream_connection(scene, n):
    pick(scene.pipelines, n[0]).heights.SetInputConnection(pick(scene.pipelines, n[1]).ball.GetOutputPort())


@change
def lookup_table(scene, n):
    table = mapper_of(scene, n[0]).GetLookupTable()
    table.SetHueRange(n[1], n[2])
    table.ForceBuild()


@change
def other_lookup_table(scene, n):
    table = vtkLookupTable()
    table.SetHueRange(n[1], n[2])
    mapper_of(scene, n[0]).SetLookupTable(table)


@change
def texture_pixels(scene, n):
    pixels = scene.image.GetPointData().GetScalars()
    vtk_to_numpy(pixels)[:] = np.roll(vtk_to_numpy(pixels), 3, axis=0) // 2 + int(60 * n[0])
    pixels.Modified()


@change
def other_texture(scene, n):
    """Only of what has one: VTK itself shows none on an actor that was drawn without."""
    scene.texture = vtkTexture()
    scene.image = wt.checker(4 if n[0] > 0.5 else 8)
    scene.texture.SetInputData(scene.image)
    scene.poster.SetTexture(scene.texture)


@change
def texture_turns(scene, n):
    turn = vtkTransform()
    turn.RotateZ(90 * n[0])
    scene.texture.SetTransform(turn)


@change
def user_matrix(scene, n):
    matrix = vtkMatrix4x4()
    matrix.SetElement(2, 3, 0.8 * n[1])
    pick(scene.actors, n[0]).SetUserMatrix(matrix)


@change
def matrix_in_place(scene, n):
    matrix = pick(scene.actors, n[0]).GetUserMatrix()
    if matrix:
        matrix.SetElement(0, 3, 2 * n[1] - 1)


@change
def user_transform(scene, n):
    turn = vtkTransform()
    turn.RotateZ(90 * n[1])
    pick(scene.actors, n[0]).SetUserTransform(turn)


@change
def transform_in_place(scene, n):
    transform = pick(scene.actors, n[0]).GetUserTransform()
    if transform and transform.IsA("vtkTransform"):
        transform.RotateX(40 * n[1])


@change
def cut_added_or_removed(scene, n):
    mapper = mapper_of(scene, n[0])
    if mapper.GetClippingPlanes() and mapper.GetClippingPlanes().GetNumberOfItems():
        mapper.RemoveAllClippingPlanes()
    else:
        mapper.AddClippingPlane(scene.cut)


@change
def cut_moves(scene, n):
    scene.cut.SetOrigin(n[0] - 0.5, 0, 0)


@change
def visibility(scene, n):
    prop = pick([*scene.actors, scene.assembly, scene.follower, scene.volume, scene.glyphs], n[0])
    prop.SetVisibility(not prop.GetVisibility())


@change
def not_reflected(scene, n):
    actor = pick(scene.actors, n[0])
    if actor.GetPropertyKeys():
        actor.GetPropertyKeys().Set(Pass.NOT_REFLECTED(), int(n[1] > 0.5))
    else:
        wt.leave_out(actor)


@change
def stand_in(scene, n):
    actor = pick(scene.actors, n[0])
    if not actor.GetPropertyKeys():
        actor.SetPropertyKeys(vtkInformation())
    keys = actor.GetPropertyKeys()
    if keys.Has(Pass.STAND_IN()):
        keys.Remove(Pass.STAND_IN())
    else:
        keys.Set(Pass.STAND_IN(), scene.stand_in)


@change
def no_keys(scene, n):
    pick(scene.actors, n[0]).SetPropertyKeys(None)


@change
def order(scene, n):
    props = scene.props()
    for prop in props:
        scene.renderer.RemoveViewProp(prop)
    for i in np.random.default_rng(int(1e6 * n[0])).permutation(len(props)):
        scene.renderer.AddViewProp(props[i])


@change
def removed(scene, n):
    if len(scene.actors) > 5:
        scene.renderer.RemoveViewProp(scene.actors.pop(int(n[0] * len(scene.actors))))


@change
def added(scene, n):
    scene.add(wt.box((0, 0, 0), (0.8, 0.8, 1)), (8 * n[0] - 4, 4 * n[1] - 2, 0.7)).GetProperty().SetColor(n[2:5])


@change
def replaced(scene, n):
    """The new one may lie where the old one was in memory."""
    removed(scene, n)
    added(scene, n)


@change
def parts(scene, n):
    part = pick(scene.parts, n[0])
    part.SetPosition(n[1], n[2], 0)
    part.GetProperty().SetColor(n[3:6])


@change
def part_removed_or_added(scene, n):
    part = scene.parts[1]
    if scene.assembly.GetParts().IsItemPresent(part):
        scene.assembly.RemovePart(part)
    else:
        scene.assembly.AddPart(part)


@change
def volume_transfer(scene, n):
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(40 * n[0], 0)
    opacity.AddPoint(255, 0.3 + 0.5 * n[1])
    scene.volume.GetProperty().SetScalarOpacity(opacity)


@change
def volume_transfer_in_place(scene, n):
    scene.volume.GetProperty().GetScalarOpacity().AddPoint(255, 0.3 + 0.5 * n[0])


@change
def glyph_shape(scene, n):
    scene.shape.SetRadius(0.1 + 0.3 * n[0])


@change
def shader_lines(scene, n):
    actor = pick(scene.actors, n[0])
    others = [*scene.actors, *scene.parts, scene.follower, scene.stand_in]
    if [other.GetMapper() for other in others].count(actor.GetMapper()) > 1:
        return  # as above
    shaders = actor.GetShaderProperty()
    shaders.ClearAllFragmentShaderReplacements()
    if n[1] > 0.3:
        shaders.AddFragmentShaderReplacement("//VTK::Light::Impl", True,
                                             f"//VTK::Light::Impl\n  gl_FragData[0].g = {n[2]:.2f};", False)

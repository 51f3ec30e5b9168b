# SPDX-License-Identifier: BSD-3-Clause
"""Row Props of the mirror matrix: what faces the camera, 2D, the user's own cuts and shaders, keys.

Labels that turn to the camera and all that is 2D are not reflected, by rule: text would be upside down
and turned to an eye under the water. A vtkFollower is reflected as it stands, turned to its own camera.
"""

import mirror_matrix as mm
import water_test as wt
from vtkmodules.vtkCommonCore import vtkInformation, vtkLookupTable
from vtkmodules.vtkFiltersCore import vtkClipPolyData
from vtkmodules.vtkRenderingAnnotation import (
    vtkAxisActor2D,
    vtkCaptionActor2D,
    vtkCornerAnnotation,
    vtkCubeAxesActor,
    vtkLegendScaleActor,
    vtkScalarBarActor,
)
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkBillboardTextActor3D,
    vtkFlagpoleLabel,
    vtkFollower,
    vtkPolyDataMapper,
    vtkTextActor,
    vtkTextActor3D,
)
from vtkmodules.vtkRenderingFreeType import vtkVectorText
from vtkwater import vtkWaterReflectionPass

row = mm.Results("Props: labels, cuts and keys", __file__)


def ball(scene, color=(1, 0.6, 0.2)):
    return scene.add_data(wt.sphere((0, 0, 0.4), 1.4), color, specular=0.4)


# What faces a camera.
def letters(actor):
    text = vtkVectorText()
    text.SetText("Ripple")
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(text.GetOutputPort())
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(1, 0.8, 0.2)
    actor.SetPosition(-2, 0, 0.1)
    return actor


def follower(scene):
    actor = letters(vtkFollower())
    actor.SetCamera(scene.users_camera())
    scene.add(wt.reflect(actor))


def upright_text(scene):
    actor = letters(vtkActor())
    actor.RotateX(80)
    scene.add(actor)


def text_3d(scene):
    text = vtkTextActor3D()
    text.SetInput("Ripple")
    text.GetTextProperty().SetFontSize(48)
    text.SetScale(0.02)
    text.RotateX(80)
    text.SetPosition(-2, 0, 0.3)
    scene.add(text, cut=False)


row.cell("vtkFollower", follower)
row.cell("text as geometry", upright_text)
row.cell("vtkTextActor3D over the water", text_3d)


def with_ball(add):
    def fill(scene, on):
        ball(scene)
        if on:
            add(scene)

    return fill


def rule(name, add, reason):
    """A cell of what is not reflected, beside a ball that is."""
    row.cell(name, with_ball(add), control=mm.UNREFLECTED, reason=reason)


def billboard(scene):
    label = vtkBillboardTextActor3D()
    label.SetInput("Ripple")
    label.SetPosition(0.5, -1, 1.2)
    label.GetTextProperty().SetFontSize(40)
    scene.renderer.AddViewProp(label)


def flagpole(scene):
    label = vtkFlagpoleLabel()
    label.SetInput("Ripple")
    label.SetBasePosition(0.5, -1, 0)
    label.SetTopPosition(0.5, -1, 1.4)
    label.GetTextProperty().SetFontSize(40)
    label.SetFlagSize(1.5)
    scene.renderer.AddViewProp(label)


TURNS = ("Labels that face the camera are not reflected: in the mirrored view they would face an eye under the "
         "water.")
rule("vtkBillboardTextActor3D", billboard, TURNS)
rule("vtkFlagpoleLabel", flagpole, TURNS)


# 2D.
def scalar_bar(scene):
    bar = vtkScalarBarActor()
    table = vtkLookupTable()
    table.Build()
    bar.SetLookupTable(table)
    bar.SetNumberOfLabels(3)
    bar.SetPosition(0.7, 0.3)
    bar.SetWidth(0.2)
    bar.SetHeight(0.6)
    scene.renderer.AddViewProp(bar)


def text_2d(scene):
    text = vtkTextActor()
    text.SetInput("Ripple")
    text.GetTextProperty().SetFontSize(40)
    text.SetPosition(10, 100)
    scene.renderer.AddViewProp(text)


def caption(scene):
    actor = vtkCaptionActor2D()
    actor.SetCaption("Ripple")
    actor.SetAttachmentPoint(0, 0, 1.2)
    actor.SetPosition(30, 5)
    actor.SetWidth(0.3)
    actor.SetHeight(0.2)
    scene.renderer.AddViewProp(actor)


def corners(scene):
    actor = vtkCornerAnnotation()
    for i in range(4):
        actor.SetText(i, "Ripple")
    scene.renderer.AddViewProp(actor)


def axis_2d(scene):
    axis = vtkAxisActor2D()
    axis.SetPoint1(0.1, 0.8)
    axis.SetPoint2(0.9, 0.75)
    axis.SetTitle("Ripple")
    scene.renderer.AddViewProp(axis)


FLAT = "2D overlays are drawn over the finished picture and are not part of the reflected scene."
rule("scalar bar", scalar_bar, FLAT)
rule("2D text", text_2d, FLAT)
rule("caption", caption, FLAT)
rule("corner annotation", corners, FLAT)
rule("2D axis", axis_2d, FLAT)


def legend(scene):
    actor = vtkLegendScaleActor()
    actor.LegendVisibilityOn()
    scene.renderer.AddViewProp(actor)


rule("legend with scale", legend, FLAT)


# The user's own cuts.
def six_planes():
    normals = ((1, 0, -0.4), (-1, 0, -0.4), (0, 1, -0.4), (0, -1, -0.4), (0.3, 0.3, -1), (-0.2, 0.4, -1))
    return [wt.plane(tuple(-1.25 * wt.unit(normal)), tuple(wt.unit(normal))) for normal in normals]


def clipped(data, planes):
    for plane in planes:
        clip = vtkClipPolyData()
        clip.SetInputData(data)
        clip.SetClipFunction(plane)
        clip.SetOutputPointsPrecision(1)
        clip.Update()
        data = clip.GetOutput()
    return data


def users_planes(scene, on):
    """With the water's there would be seven, which VTK refuses: the mirrored picture's data is cut."""
    data = wt.sphere((0, 0, 0.4), 1.5, 60)
    if scene.kind == mm.MIRRORED:
        data = clipped(data, [wt.plane((0, 0, 0), (0, 0, 1))])
    actor = scene.add_data(data, (1, 0.6, 0.2), specular=0.4, cut=False)
    if on:
        for plane in six_planes():
            actor.GetMapper().AddClippingPlane(plane)


row.cell("six user-defined clipping planes", users_planes)


# The user's own shaders.
def shader(tag, code, vertex=False):
    def fill(scene, on):
        actor = ball(scene)
        if on:
            add = actor.GetShaderProperty().AddVertexShaderReplacement if vertex else (
                actor.GetShaderProperty().AddFragmentShaderReplacement)
            add(tag, True, code, False)

    return fill


row.cell("shader replacement that colours", shader(
    "//VTK::Color::Impl",
    "//VTK::Color::Impl\n"
    "  diffuseColor = 0.5 + 0.5 * sin(0.2 * gl_FragCoord.zzz * vec3(90.0, 300.0, 700.0));\n"))
row.cell("shader replacement after lighting", shader(
    "//VTK::Light::Impl", "//VTK::Light::Impl\n  gl_FragData[0].rgb = gl_FragData[0].brg;\n"))
row.cell("shader replacement that discards", shader(
    "//VTK::Light::Impl", "//VTK::Light::Impl\n  if (fract(40.0 * normalVCVSOutput.x) > 0.5) discard;\n"))
row.cell("shader replacement that moves vertices", shader(
    "//VTK::PositionVC::Impl",
    "vec4 moved = vertexMC + vec4(0.2 * sin(6.0 * vertexMC.z), 0.0, 0.0, 0.0);\n"
    "  vertexVCVSOutput = MCVCMatrix * moved;\n  gl_Position = MCDCMatrix * moved;\n", vertex=True))


# Keys and visibility.
def keyed(set_keys):
    def add(scene):
        actor = scene.add_data(wt.box((2.4, -0.5, 0.6), (0.8, 0.8, 2.4)), (0.2, 0.5, 1))
        keys = vtkInformation()
        set_keys(keys)
        actor.SetPropertyKeys(keys)

    return add


rule("NOT_REFLECTED", keyed(lambda keys: keys.Set(vtkWaterReflectionPass.NOT_REFLECTED(), 1)),
     "The key requests it.")
row.cell("NOT_REFLECTED of 0", with_ball(keyed(lambda keys: keys.Set(vtkWaterReflectionPass.NOT_REFLECTED(), 0))))


def stood_in(scene, on):
    ball(scene)
    coarse = vtkActor()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(wt.sphere((2.2, -0.5, 0.6), 0.9, 8))
    coarse.SetMapper(mapper)
    if scene.kind == mm.MIRRORED and on:  # there the stand-in stands itself
        scene.add(coarse)
        return
    fine = scene.add_data(wt.sphere((2.2, -0.5, 0.6), 0.9, 40), (0.2, 0.5, 1))
    keys = vtkInformation()
    keys.Set(vtkWaterReflectionPass.STAND_IN(), coarse)
    fine.SetPropertyKeys(keys)
    scene.keep.append(coarse)


row.cell("STAND_IN", stood_in)


def hidden(scene, on):
    ball(scene)
    actor = scene.add_data(wt.box((2.4, -0.5, 0.6), (0.8, 0.8, 2.4)), (0.2, 0.5, 1))
    actor.SetVisibility(not on)


row.cell("invisible", hidden)


def cube_axes(scene):
    ball(scene)
    axes = vtkCubeAxesActor()
    axes.SetBounds(-2, 2, -1.5, 1.5, 1.6, 2.4)  # labels hang under it
    axes.SetCamera(scene.users_camera())
    for name in "XYZ":
        getattr(axes, f"Get{name}AxesLinesProperty")().SetColor(1, 0.8, 0)
    scene.renderer.AddViewProp(wt.reflect(axes))


row.cell("vtkCubeAxesActor over the water", cube_axes)
test_cell = row.test()

# SPDX-License-Identifier: BSD-3-Clause
"""Row Classes of props of the mirror matrix: VTK's props that have no cell of their own in another row.

Each stands in the water, half over and half under it, where it can; the near plane of the mirrored picture cuts
it, whatever its parts are. All have the key that reflects rulers and axes, too.
"""

import mirror_matrix as mm
import water_test as wt
from vtk_classes import find
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingAnnotation import vtkAxisActor
from vtkmodules.vtkRenderingCore import vtkActor, vtkCamera, vtkLight, vtkPolyDataMapper
from vtkmodules.vtkRenderingFreeType import vtkVectorText

row = mm.Results("Classes of props", __file__)
BOUNDS = (-2, 2, -1.5, 1.5, -0.7, 1.9)
YELLOW = (1, 0.8, 0.2)
AVATAR = ("VTK does not expose its parts. They are not cut at the water, and their headlight is not the user's.")
GRID = ("Its ticks and labels depend on the view; it keeps those of the mirrored view, also in the picture.")


def cell(path, make, name=None, cut=True, **options):
    """Registers the cell of a class, given by its module and name, if this VTK has it.

    make(class, scene) gives the prop; cut: it stands in the water, and the mirrored picture is cut
    """
    made_class = find(path)
    if made_class is None:
        return

    def fill(scene):
        if cut:
            scene.cut_by_view()
        scene.renderer.AddViewProp(wt.reflect(make(made_class, scene)))

    row.cell(name or path.split(".")[1], fill, **options)


def letters(actor=None):
    text = vtkVectorText()
    text.SetText("Ripple")
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(text.GetOutputPort())
    actor = actor or vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(YELLOW)
    return actor


def annotated_cube(made_class, scene):
    cube = made_class()
    cube.GetCubeProperty().SetColor(0.3, 0.8, 0.4)
    return cube


def axes(made_class, scene):
    actor = made_class()
    actor.AxisLabelsOff()
    actor.SetTotalLength(2.5, 2.5, 2.5)
    actor.SetShaftTypeToCylinder()
    actor.SetCylinderRadius(0.15)
    transform = vtkTransform()
    transform.RotateX(50)
    transform.RotateY(30)
    transform.Translate(-1, 0, 0)
    actor.SetUserTransform(transform)
    return actor


def axis(made_class, scene):
    actor = made_class()
    actor.SetAxisTypeToX()
    actor.SetPoint1(-2, 0, -0.6)
    actor.SetPoint2(2, 0, 1.2)
    actor.SetBounds(-2, 2, 0, 0, -0.6, 1.2)
    actor.SetRange(0, 10)
    actor.SetMajorTickSize(0.4)
    actor.SetMinorTickSize(0.2)
    actor.SetDeltaRangeMajor(2)
    actor.SetDeltaRangeMinor(1)
    actor.SetTickLocationToBoth()
    actor.SetCamera(scene.users_camera())
    for look in (actor.GetProperty(), actor.GetAxisLinesProperty(), actor.GetAxisMajorTicksProperty(),
                 actor.GetAxisMinorTicksProperty()):
        look.SetColor(YELLOW)
        look.SetLineWidth(4)
    labels = vtkStringArray()
    for text in "024680":
        labels.InsertNextValue(text)
    actor.SetLabels(labels)
    actor.SetLabelScale(0.3)
    actor.SetTitle("Ripple")
    return actor


def axis_follower(made_class, scene):
    follower = letters(made_class())
    line = axis(vtkAxisActor, scene)
    scene.keep.append(line)
    follower.SetAxis(line)
    follower.SetCamera(scene.users_camera())
    follower.SetPosition(-2, 0, -0.3)
    return follower


def follower(made_class, scene):
    actor = letters(made_class())
    actor.SetCamera(scene.users_camera())
    actor.SetPosition(-2, 0, -0.3)
    return actor


def prop_follower(made_class, scene):
    prop = made_class()
    prop.SetProp3D(letters())
    prop.SetCamera(scene.users_camera())
    prop.SetPosition(-2, 0, -0.3)
    return prop


def prop_axis_follower(made_class, scene):
    prop = prop_follower(made_class, scene)
    line = axis(vtkAxisActor, scene)
    scene.keep.append(line)
    prop.SetAxis(line)
    prop.SetViewport(scene.renderer)
    return prop


def camera_actor(made_class, scene):
    camera = vtkCamera()
    camera.SetPosition(-2, 0.5, 0.4)
    camera.SetFocalPoint(2, 0, 0.2)
    camera.SetClippingRange(0.6, 3.5)
    actor = made_class()
    actor.SetCamera(camera)
    actor.GetProperty().SetColor(YELLOW)
    actor.GetProperty().SetLineWidth(4)
    return actor


def light_actor(made_class, scene):
    light = vtkLight()
    light.PositionalOn()
    light.SetPosition(-1.5, 0, 1.5)
    light.SetFocalPoint(0.5, 0, -0.5)
    light.SetConeAngle(25)
    light.SetDiffuseColor(YELLOW)
    actor = made_class()
    actor.SetLight(light)
    actor.SetClippingRange(0.3, 3)
    return actor


def cube_axes(made_class, scene):
    actor = made_class()
    actor.SetBounds(BOUNDS)
    actor.SetCamera(scene.users_camera())
    for name in "XYZ":
        getattr(actor, f"Get{name}AxesLinesProperty")().SetColor(YELLOW)
        getattr(actor, f"Draw{name}GridlinesOn")()
    return actor


def polar_axes(made_class, scene):
    actor = made_class()
    actor.SetCamera(scene.users_camera())
    actor.SetBounds(-2, 2, -2, 2, 0, 0)
    actor.SetPole(0, 0, 0.0)
    actor.SetMaximumRadius(2.2)
    actor.SetMaximumAngle(300)
    for text in ("PolarLabel", "PolarTitle", "RadialTitle"):  # which are axis followers
        getattr(actor, f"Set{text}Visibility")(False)
    actor.RotateX(20)
    for name in ("PolarAxis", "LastRadialAxis", "SecondaryRadialAxes", "PolarArcs", "SecondaryPolarArcs"):
        getattr(actor, f"Get{name}Property")().SetColor(YELLOW)
    return actor


def grid_axes(made_class, scene):
    actor = made_class()
    actor.SetGridBounds(-2, 2, -1.5, 1.5, 0.3, 1.9)
    actor.GetProperty().SetColor(YELLOW)
    if hasattr(actor, "SetFaceMask"):
        actor.SetFaceMask(63)
    if hasattr(actor, "SetFace"):
        actor.SetFace(1)  # the one of least y
    return actor


def avatar(made_class, scene):
    actor = made_class()
    actor.SetHeadPosition(0, 0, 0.6)
    actor.SetHeadOrientation(0, 90, 0)
    actor.SetLeftHandPosition(-1, 0.4, 0.2)
    actor.SetRightHandPosition(1, -0.4, 0.1)
    actor.SetScale(1.5)
    return actor


def text_3d(made_class, scene):
    text = made_class()
    text.SetInput("Ripple")
    text.GetTextProperty().SetFontSize(48)
    text.SetScale(0.02)
    text.RotateX(80)
    text.SetPosition(-2, 0, -0.3)
    return text


cell("RenderingAnnotation.vtkAnnotatedCubeActor", annotated_cube)
cell("RenderingAnnotation.vtkAxesActor", axes)
cell("RenderingAnnotation.vtkAxisActor", axis)
cell("RenderingAnnotation.vtkAxisFollower", axis_follower)
cell("RenderingAnnotation.vtkCubeAxesActor", cube_axes)
cell("RenderingAnnotation.vtkPolarAxesActor", polar_axes)
cell("RenderingAnnotation.vtkProp3DAxisFollower", prop_axis_follower)
cell("RenderingVRModels.vtkOpenGLAvatar", avatar, wrong=True, reason=AVATAR)
cell("RenderingCore.vtkCameraActor", camera_actor)
cell("RenderingCore.vtkFollower", follower, "vtkFollower across the water")
cell("RenderingCore.vtkLightActor", light_actor)
cell("RenderingCore.vtkProp3DFollower", prop_follower)
cell("RenderingCore.vtkTextActor3D", text_3d)
cell("RenderingGridAxes.vtkGridAxesActor2D", grid_axes, cut=False, wrong=True, reason=GRID)
cell("RenderingGridAxes.vtkGridAxesActor3D", grid_axes, cut=False, wrong=True, reason=GRID)
cell("RenderingGridAxes.vtkGridAxesPlaneActor2D", grid_axes)
test_cell = row.test()

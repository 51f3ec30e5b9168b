# SPDX-License-Identifier: BSD-3-Clause
"""Row Classes of widgets of the mirror matrix: what VTK's widgets draw, each placed in one box across the water.

Many are sized in pixels of the renderer that they are told. In the mirrored picture they are told another one,
whose camera stays where the user's is: what stands in the water is the thing that the user sees. All parts are
opaque: VTK's order-independent blending reaches no parts of widgets, and what it shows of them is undefined.
"""

import mirror_matrix as mm
import volumes
import water_test as wt
from mirror_scene import mapper_of
from vtk_classes import find
from vtkmodules.vtkInteractionWidgets import vtkBoxRepresentation, vtkPointHandleRepresentation3D
from vtkmodules.vtkRenderingCore import vtkActor, vtkCamera, vtkPropCollection

row = mm.Results("Classes of widgets", __file__)
BOX = (-1.5, 1.5, -1, 1, -0.6, 1.4)
CORNERS = ((-1.5, 0, -0.5), (0, 0.5, 1.3), (1.5, -0.5, 0.4))
FLAT = "2D overlays are drawn over the finished picture and are not part of the reflected scene."


PARTS = ("VTK does not expose all of its parts (vtkProp::GetActors). These are not cut at the water, and their "
         "headlight is not the user's.")
OLD = mm.VTK_VERSION < (9, 3)
CURVE = f"VTK 9.1: {PARTS}" if OLD else "VTK 9.6: its reflected handles differ in size by part of a pixel."
LABEL = "In its first frame its label is placed for the mirrored view, also in the picture."


def placed(made_class, scene, set_up):
    widget = made_class()
    other = scene
    if scene.kind == mm.MIRRORED:
        other = mm.Scene(mm.SEEN, scene.window.GetSize())
        other.camera.SetViewAngle(scene.camera.GetViewAngle())
        scene.keep.append(other)
    other.window.Render()  # a new window knows no pixels
    widget.SetRenderer(other.renderer)
    if hasattr(widget, "SetPlaceFactor"):
        widget.SetPlaceFactor(1)
    kept = set_up(widget, scene) if set_up else None
    if kept is None:
        widget.PlaceWidget(BOX)
    else:
        scene.keep.append(kept)
    widget.VisibilityOn()
    widget.BuildRepresentation()
    parts = vtkPropCollection()
    widget.GetActors(parts)
    for i in range(parts.GetNumberOfItems()):
        part = parts.GetItemAsObject(i)
        if part.IsA("vtkActor") and part.GetProperty().GetOpacity() > 0:
            part.GetProperty().SetOpacity(1)
    scene.renderer.AddViewProp(widget)


def cell(path, set_up=None, near=False, **options):
    """Registers the cell of a class, given by its module and name, if this VTK has it.

    set_up(widget, scene) gives what is to be kept, if the widget has its place by then; else it is placed in BOX
    """
    made_class = find(path)
    if made_class is None:
        return

    def fill(scene):
        scene.cut_by_view()
        if near:  # what is thin fills more of the picture
            scene.camera.SetViewAngle(12)
        placed(made_class, scene, set_up)

    row.cell(path.split(".")[1], fill, size=(100, 75) if near else mm.SIZE, **options)


def flat(path, set_up=None, size=(120, 90)):
    """The same of a class that draws in 2D and is not reflected, beside a ball that is."""
    made_class = find(path)
    if made_class is None:
        return

    def fill(scene, on):
        scene.cut_by_view()
        scene.add_data(wt.sphere((0, 0, 0.4), 1.4), specular=0.4, cut=False)
        if on:
            placed(made_class, scene, set_up)

    row.cell(path.split(".")[1], fill, control=mm.UNREFLECTED, reason=FLAT, size=size)


def distance(widget, scene):
    ends = vtkPointHandleRepresentation3D()
    widget.SetHandleRepresentation(ends)
    widget.InstantiateHandleRepresentation()
    line(widget, scene)
    return ends


def angle(widget, scene):
    widget.InstantiateHandleRepresentation()
    for name, corner in zip(("Point1", "Center", "Point2"), CORNERS):
        getattr(widget, f"Get{name}Representation")().SetWorldPosition(corner)
    return widget


def contour(widget, scene):
    for corner in CORNERS:
        widget.AddNodeAtWorldPosition(corner)
    widget.GetLinesProperty().SetLineWidth(3)
    return widget


def textless(widget, scene):
    """Its text is 2D."""
    widget.HandleTextOff()


def line(widget, scene):
    widget.SetPoint1WorldPosition(CORNERS[0])
    widget.SetPoint2WorldPosition(CORNERS[1])
    return widget


def handle(widget, scene):
    widget.SetHandle(wt.sphere((0, 0, 0), 0.8, 20))
    widget.SetWorldPosition((0.3, 0, 0.2))
    return widget


def large(widget, scene):
    """The handle is large enough to be seen in the water."""
    widget.SetHandleSize(40)
    widget.SetWorldPosition((0.3, 0, 0.4))
    return widget


def button(widget, scene):
    actor = vtkActor()
    actor.SetMapper(mapper_of(wt.sphere((0, 0, 0), 0.5)))
    widget.SetNumberOfStates(1)
    widget.SetButtonProp(0, actor)
    widget.PlaceWidget(BOX)
    widget.SetState(0)
    return actor


def points(widget, scene):
    widget.PlacePointCloud(wt.sphere((0, 0, 0.4), 1.2, 8))
    return widget


def camera(widget, scene):
    shown = vtkCamera()
    shown.SetPosition(-1.5, 0.5, 0.5)
    shown.SetFocalPoint(1, 0, 0.3)
    shown.SetClippingRange(0.5, 3)
    shown.SetViewAngle(25)
    widget.SetCamera(shown)
    return shown


def light(widget, scene):
    widget.SetLightPosition((-1, 0, 1.2))
    widget.SetFocalPoint((0.8, 0, -0.2))
    widget.SetPositional(True)
    widget.SetConeAngle(20)
    return widget


cell("InteractionWidgets.vtk3DCursorRepresentation", near=True)
cell("InteractionWidgets.vtkAngleRepresentation3D", angle, near=True, wrong=True, reason=PARTS)
cell("InteractionWidgets.vtkBoxRepresentation")
cell("InteractionWidgets.vtkCamera3DRepresentation", camera, wrong=True, reason=PARTS)
cell("InteractionWidgets.vtkCameraPathRepresentation", wrong=True, reason=CURVE)
cell("InteractionWidgets.vtkCoordinateFrameRepresentation")
cell("InteractionWidgets.vtkDisplaySizedImplicitPlaneRepresentation")
cell("InteractionWidgets.vtkDistanceRepresentation3D", distance, near=True, wrong=True, reason=PARTS)
cell("InteractionWidgets.vtkFixedSizeHandleRepresentation3D", large, near=True)
cell("InteractionWidgets.vtkImplicitAnnulusRepresentation")
cell("InteractionWidgets.vtkImplicitConeRepresentation")
cell("InteractionWidgets.vtkImplicitCylinderRepresentation")
cell("InteractionWidgets.vtkImplicitPlaneRepresentation")
cell("InteractionWidgets.vtkLightRepresentation", light, wrong=OLD, reason=PARTS if OLD else None)
cell("InteractionWidgets.vtkLineRepresentation", line, near=True)
cell("InteractionWidgets.vtkMeasurementCubeHandleRepresentation3D", wrong=True, reason=LABEL)
cell("InteractionWidgets.vtkMultiLineRepresentation")
cell("InteractionWidgets.vtkOrientationRepresentation")
cell("InteractionWidgets.vtkOrientedGlyphContourRepresentation", contour)
cell("InteractionWidgets.vtkOrientedPolygonalHandleRepresentation3D", handle)
cell("InteractionWidgets.vtkParallelopipedRepresentation")
cell("InteractionWidgets.vtkPointCloudRepresentation", points, wrong=True, reason=PARTS)
cell("InteractionWidgets.vtkPointHandleRepresentation3D", large, near=True)
cell("InteractionWidgets.vtkPolyLineRepresentation", near=True, wrong=True, reason=CURVE)
cell("InteractionWidgets.vtkPolygonalHandleRepresentation3D", handle)
cell("InteractionWidgets.vtkProp3DButtonRepresentation", button)
cell("InteractionWidgets.vtkSliderRepresentation3D")
cell("InteractionWidgets.vtkSphereHandleRepresentation", large)
cell("InteractionWidgets.vtkSphereRepresentation", textless, wrong=True, reason=PARTS)
cell("InteractionWidgets.vtkSplineRepresentation", near=True, wrong=True, reason=CURVE)

flat("InteractionWidgets.vtkAffineRepresentation2D")
flat("InteractionWidgets.vtkAngleRepresentation2D", angle, size=(80, 60))
flat("InteractionWidgets.vtkBorderRepresentation", size=(80, 60))
flat("InteractionWidgets.vtkCameraRepresentation")
flat("InteractionWidgets.vtkOrientedGlyphFocalPlaneContourRepresentation", contour, size=(80, 60))
flat("InteractionWidgets.vtkPlaybackRepresentation")
flat("InteractionWidgets.vtkProgressBarRepresentation")


def about_volume(scene):
    """The box and what it is about stand over the water: neither is cut."""
    scene.add_data(wt.sphere((-2.2, 0.4, 0.3), 0.7))
    placed(vtkBoxRepresentation, scene, lambda widget, scene: widget.PlaceWidget((-1, 1, -1, 1, 0.5, 2.5)) or widget)
    scene.renderer.AddViewProp(volumes.ray_cast(volumes.ball((0, 0, 1.5), 0.9, 30, 1.0, 70), 0.04, (
        (0, 1, 0.9, 0.2), (100, 0.9, 0.2, 0.1)), ((0, 0.6), (90, 0.2), (105, 0))))


row.cell("vtkBoxRepresentation about a volume", about_volume)
test_cell = row.test()

# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong is said once, by an ErrorEvent that names it; the water turns plain, the rest stays.

Each fault is rendered three times: one error, however many frames. Then its cause is removed and the
next frame is right again. Props with NaN bounds: TestWaterBadBounds.cxx.
"""

import math

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper
from vtkwater import vtkWaterActor

NAN, INFINITY = float("nan"), float("inf")
DEEP = (0.0, 0.2, 0.6)


class Scene:
    def __init__(self):
        self.view = wt.View((320, 240), background=(0.5, 0.7, 0.9))
        for data, color in wt.columns_and_pyramids():
            wt.add_actor(self.view.renderer, data, color)
        self.water = wt.add_water(self.view.renderer, None, (-9, 9, -6, 9))
        self.water.GetWaterProperty().SetDeepColor(DEEP)
        self.camera = self.view.renderer.GetActiveCamera()
        self.place_camera()
        self.errors = []
        self.water.AddObserver("ErrorEvent", lambda caller, event: self.errors.append(caller.GetLastError()))

    def place_camera(self, height=4):
        self.camera.SetPosition(2, -13, height)
        self.camera.SetFocalPoint(0, 0, 0)
        self.camera.SetViewUp(0, 0, 1)
        self.camera.SetClippingRange(0.1, 60)

    def frames(self):
        self.errors.clear()
        return [self.view.picture() for _ in range(3)][-1]


def judge(name, words, spoil, mend, plain_water=True):
    """spoil(scene) makes the scene wrong, mend(scene) right again; words must be in the error."""
    scene = Scene()
    good = scene.frames()
    mask = wt.water_mask(scene.view, scene.water)
    wt.check_equal(f"{name}: errors before", scene.errors, [])
    spoil(scene)
    picture = scene.frames()
    wt.check_equal(f"{name}: errors in three frames", len(scene.errors), 1)
    for word in words:
        wt.check_equal(f"{name}: the error names '{word}'", word in "".join(scene.errors), True)
    if plain_water:
        color = np.round(255 * np.asarray(DEEP))
        wt.check_at_most(f"{name}: water is its plain colour, error",
                         float(np.abs(picture - color).max(axis=2)[mask].max()), 1.0)
        wt.check_equal(f"{name}: the rest, largest error", int(np.abs(picture - good)[~mask].max()), 0)
    mend(scene)
    picture = scene.frames()
    wt.check_equal(f"{name}: errors after", scene.errors, [])
    wt.check_equal(f"{name}: next picture, largest error", int(np.abs(picture - good).max()), 0)


@pytest.mark.parametrize("name, normal, words", (
    ("zero normal", (0, 0, 0), ("(0, 0, 0)", "nonzero")),
    ("normal with NaN", (0, NAN, 1), ("nan", "finite")),
    ("infinite normal", (0, 0, INFINITY), ("inf", "finite")),
), ids=("zero", "nan", "infinite"))
def test_a_bad_normal_is_one_error_and_plain_water(name, normal, words):
    """A plane without a direction is said once; the water has its plain colour, all else its picture."""
    def spoil(scene):
        plane = vtkPlane()
        plane.SetOrigin(0, 0, 0)
        plane.SetNormal(normal)
        scene.water.SetPlane(plane)

    judge(name, words, spoil, lambda scene: scene.water.SetLevel(0))


def test_a_camera_on_the_plane_is_no_error():
    """A camera that is exactly on the water plane is taken to be over it, without a word."""
    scene = Scene()
    scene.place_camera(0)
    for _ in range(3):
        scene.view.picture()
    wt.check_equal("camera exactly on the plane: errors", (scene.errors, scene.water.GetLastError()), ([], ""))


def test_a_bad_camera_in_one_of_two_renderers_is_one_error():
    """Water in two renderers, one of which cannot show it, says so once and names that one's camera."""
    scene = Scene()
    below = scene.view.add_renderer((0, 0, 0), (0, 0, 0.3, 0.3))
    below.GetActiveCamera().SetPosition(0, -5, float("inf"))
    below.GetActiveCamera().SetClippingRange(0.1, 100)
    below.AddActor(scene.water)
    for _ in range(5):
        scene.view.picture()
    wt.check_equal("bad camera in one of two renderers: errors in five frames", len(scene.errors), 1)
    wt.check_equal("bad camera: position named", "(0, -5, inf)" in scene.water.GetLastError(), True)


def test_a_texture_that_the_gpu_cannot_hold_is_one_error():
    """A mirrored view larger than the GPU's textures is said once, with both factors of its size."""
    def spoil(scene):
        scene.view.window.SetSize(2100, 300)  # times 16 more than any GPU has
        scene.water.GetReflectionPass().SetTextureScale(16)

    def mend(scene):
        scene.view.window.SetSize(320, 240)
        scene.water.GetReflectionPass().SetTextureScale(1)

    judge("texture larger than the GPU's limit", ["2100 x 300", "16", "exceeds"], spoil, mend, plain_water=False)


def test_an_empty_scene_is_one_error():
    """Water that has nothing to take its sheet from is said once."""
    def spoil(scene):
        props = scene.view.renderer.GetViewProps()
        scene.props = [props.GetItemAsObject(i) for i in range(props.GetNumberOfItems())]
        scene.view.renderer.RemoveAllViewProps()
        scene.view.renderer.AddActor(scene.water)
        scene.water.ResetSheetBounds()

    def mend(scene):
        scene.view.renderer.RemoveAllViewProps()
        scene.water.SetSheetBounds(-9, 9, -6, 9)
        for prop in scene.props:
            scene.view.renderer.AddActor(prop)

    judge("empty scene", ["no surface", "empty"], spoil, mend, plain_water=False)


def test_a_mapper_without_input_is_one_error():
    """A mapper of the user's without input is said once, by name."""
    scene = Scene()
    scene.water.SetMapper(vtkPolyDataMapper())
    for _ in range(3):
        scene.view.picture()
    wt.check_equal("mapper without input: errors", len(scene.errors), 1)
    wt.check_equal("mapper without input: named", "has no input" in scene.water.GetLastError(), True)


def test_a_window_of_no_size_does_no_harm():
    """A window of no size does not crash, and the next frame is right."""
    scene = Scene()
    good = scene.frames()
    scene.view.window.SetSize(0, 0)
    scene.view.window.Render()
    scene.view.window.SetSize(320, 240)
    wt.check_equal("zero-size window: next picture, largest error", int(np.abs(scene.frames() - good).max()), 0)


WATER, LOOK, MIRROR = range(3)  # whose setter it is
REFUSALS = (
    *((LOOK, "Reflectance", value, "[0, 1]") for value in (-0.1, 1.5, NAN)),
    *((LOOK, "Opacity", value, "[0, 1]") for value in (-0.1, 1.5, NAN)),
    *((LOOK, "IndexOfRefraction", value, "[1, 10]") for value in (0.9, NAN, INFINITY)),
    (LOOK, "ReflectanceMode", 7, "[0, 1]"),
    (LOOK, "DeepColor", (0.5, NAN, 0.5), "[0, 1]"),
    (LOOK, "DeepColor", (0.5, 2.0, 0.5), "[0, 1]"),
    *((MIRROR, "TextureScale", value, "16]") for value in (0.0, -1.0, 17.0, NAN)),
    *((MIRROR, "ClipMargin", value, "[0, ") for value in (-1.0, NAN, INFINITY)),
    *((MIRROR, "GuardBand", value, "[1, 2]") for value in (0.5, 2.5, NAN)),
    (MIRROR, "MultiSamples", -2, "[-1, 32]"),
    *((MIRROR, "RankRegion", (box,), f"({box[0]:g}, {box[1]:g}, ")
      for box in ((2.0, 1.0, 0.0, 1.0, 0.0, 1.0), (0.0, 1.0, 3.0, 3.0, 0.0, 1.0), (0.0, 1.0, 0.0, 1.0, NAN, 1.0))),
    *((WATER, "Level", value, "finite") for value in (NAN, INFINITY)),
    *((WATER, "SheetBounds", value, "finite") for value in ((1.0, -1.0, 0.0, 2.0), (0.0, NAN, 0.0, 1.0))),
)


@pytest.mark.parametrize("whose, what, value, words", REFUSALS,
                         ids=[f"{what}_{value}".replace(" ", "") for _, what, value, _ in REFUSALS])
def test_a_setter_refuses_what_is_out_of_range(whose, what, value, words):
    """A value out of range is one error that names it and the range; the last good value stays."""
    water = vtkWaterActor()
    owner = (water, water.GetWaterProperty(), water.GetReflectionPass())[whose]
    errors = wt.errors_of(owner)
    before = getattr(owner, f"Get{what}")()
    arguments = value if isinstance(value, tuple) else (value,)
    getattr(owner, f"Set{what}")(*arguments)
    name = f"{owner.GetClassName()}.Set{what}{arguments}"
    wt.check_equal(f"{name}: errors", len(errors), 1)
    named = all(f"{v:g}" in errors[0] for v in arguments if isinstance(v, float) and not math.isinf(v))
    wt.check_equal(f"{name}: names the value", bool(errors) and named, True)
    wt.check_equal(f"{name}: names '{words}'", bool(errors) and words in errors[0], True)
    wt.check_equal(f"{name}: the last good value stays", getattr(owner, f"Get{what}")() == before, True)


def sheet(place, turn=0.0, amplitude=0.0):
    """A mesh of 12 by 8 units, turned about x, with waves along x, raised."""
    source = vtkPlaneSource()
    source.SetOrigin(-6, -4, 0)
    source.SetPoint1(6, -4, 0)
    source.SetPoint2(-6, 4, 0)
    source.SetResolution(96, 8)
    source.Update()
    mesh = source.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    points[:, 2] += amplitude * np.sin(np.pi * points[:, 0])
    turned = vtkTransform()
    turned.Translate(0, 0, place)
    turned.RotateX(turn)
    return wt.transformed(mesh, turned.GetMatrix())


@pytest.mark.parametrize("mesh, words", (
    (sheet(1.0), ("mean height above the plane is 1;", "[-0.1442", "0.1442", "SetLevel")),
    (sheet(-1.0), ("mean height above the plane is -1;",)),
    (sheet(0.0, turn=90.0), ("tilted by 90 degrees", "[0, 30]")),
    (sheet(0.1, turn=1.0, amplitude=0.1), ()),
), ids=("over", "under", "upright", "waves"))
def test_a_mesh_off_its_plane_is_told_once(mesh, words):
    """A mesh of the user's that lies off the plane or stands upright is drawn, and one warning names by how much."""
    scene = Scene()
    without = Scene()
    without.view.renderer.RemoveActor(without.water)
    told = []
    note = lambda caller, event, text: told.append(text)  # noqa: E731  it gets an attribute
    note.CallDataType = VTK_STRING
    scene.water.AddObserver("WarningEvent", note)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    scene.water.SetMapper(mapper)
    first = scene.frames()
    picture = scene.frames()
    wt.check_equal("warnings in six frames", len(told), 1 if words else 0)
    for word in words:
        wt.check_equal(f"the warning names '{word}'", word in "".join(told), True)
    wt.check_equal("errors", scene.errors, [])
    wt.check_equal("the picture stays", int(np.abs(picture - first).max()), 0)
    mask = wt.water_mask(scene.view, scene.water)
    wt.check_at_least("pixels of the mesh", int(mask.sum()), 500)
    wt.check_equal("the rest, largest error", int(np.abs(picture - without.frames())[~mask].max()), 0)
    mapper.SetInputData(sheet(0.0))
    scene.frames()
    mapper.SetInputData(sheet(2.0))
    scene.frames()
    wt.check_equal("warnings after it was right, and wrong again", len(told), 2 if words else 1)

# SPDX-License-Identifier: BSD-3-Clause
"""mirror_matrix: what the cells of Documentation/mirror-matrix.md share.

A cell is a function that fills a scene. It is rendered through calm water of reflectance 1, and
without any of our code, in two steps:

1. the mirrored picture: VTK's own camera, mirrored at the plane, looks at the same scene, whose mappers
   cut it with a clipping plane of VTK's, under the lights where the user's camera has put them; the
   picture is turned left to right;
2. the composed picture: the same scene with an ordinary sheet in the water's place, which shows the
   mirrored picture pixel by pixel. What stands before, over or behind the water is so composed by VTK.

The water's pixels of the two must be the same, and all others those of the scene without water. The same
two steps with what a cell is about taken out (its base) must give another picture: a cell that cannot
fail proves nothing.
"""

import inspect
import json
import pathlib
import re
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import water_test as wt  # noqa: E402
from vtkmodules.vtkCommonCore import vtkVersion  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkImageData  # noqa: E402
from vtkmodules.vtkCommonMath import vtkMatrix4x4  # noqa: E402
from vtkmodules.vtkCommonTransforms import vtkMatrixToLinearTransform  # noqa: E402
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray  # noqa: E402
from vtkmodules.vtkFiltersSources import vtkPlaneSource  # noqa: E402
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkTexture  # noqa: E402

SIZE = (240, 180)
SHEET = (-7, 7, -5, 7)
UP = (0.0, 0.0, 1.0)
EXACT_PERCENT = 0.05  # of the water's pixels may be off by more than 1/255
LARGEST_RMSE = 1.0  # of 255, of a cell that says why it is not exact
VTK_VERSION = tuple(int(x) for x in re.findall(r"\d+", vtkVersion.GetVTKVersion())[:2])

REFLECTED, UNREFLECTED, BEHIND = "reflected", "unreflected", "behind"
ALONE, BESIDE, FILTERED = "alone", "beside", "filtered"
SEEN, MIRRORED, COMPOSED = "seen", "mirrored", "composed"

# The sheet of the composed picture shows its texture by the place in the window.
BY_PLACE = """
  gl_FragData[0] = vec4(texelFetch(actortexture, ivec2(gl_FragCoord.xy), 0).rgb, opacity);
"""


class Scene(wt.View):
    """One picture of a cell; kind tells what it is for.

    What is added with add() is cut at the water in the mirrored picture.
    """

    def __init__(self, kind, size=SIZE, background=(0.2, 0.3, 0.4), samples=0, origin=(0, 0, 0), normal=UP):
        super().__init__(size, background, samples)
        self.kind = kind
        self.origin, self.normal = np.asarray(origin, float), wt.unit(normal)
        camera = self.camera = self.renderer.GetActiveCamera()
        camera.SetPosition(1.5, -9, 4)
        camera.SetFocalPoint(0, 0, 0.2)
        camera.SetViewUp(0, 0, 1)
        camera.SetClippingRange(1, 60)
        self.keep = []  # what VTK does not hold on to
        self.freezes_lights = True
        self.when_mirrored = []  # to be called when the camera is

    def add(self, prop, cut=True):
        """Adds a prop, in the mirrored picture cut at the water unless cut is False; returns it."""
        if self.kind == MIRRORED and cut:
            self.cut(prop)
        self.renderer.AddViewProp(prop)
        return prop

    def cut(self, prop):
        """Cuts a prop, or the parts of an assembly, at the water with VTK's own clipping planes."""
        if hasattr(prop, "GetParts"):
            parts = prop.GetParts()
            for i in range(parts.GetNumberOfItems()):
                self.cut(parts.GetItemAsObject(i))
        elif hasattr(prop, "GetMapper"):
            normal = self.normal if self.is_above() else -self.normal
            prop.GetMapper().AddClippingPlane(wt.plane(self.origin, normal))

    def cut_fragments(self, actor):
        """In the mirrored picture, cuts an actor fragment by fragment, by a shader of the user's.

        For what VTK's clipping planes keep or drop whole, by its center.
        """
        if self.kind != MIRRORED:
            return
        above = self.is_above()

        def set_plane():
            normal = self.normal if above else -self.normal
            world_to_clip = self.camera.GetCompositeProjectionTransformMatrix(
                self.renderer.GetTiledAspectRatio(), -1, 1)
            clip_to_world = np.linalg.inv([[world_to_clip.GetElement(i, j) for j in range(4)] for i in range(4)])
            plane = np.append(normal, -np.dot(normal, self.origin)) @ clip_to_world
            width, height = self.window.GetSize()
            window_to_clip = np.array([(2 / width, 0, 0, -1), (0, 2 / height, 0, -1), (0, 0, 2, -1), (0, 0, 0, 1)])
            actor.GetShaderProperty().GetFragmentCustomUniforms().SetUniform4f(
                "cutPlane", list(plane @ window_to_clip))

        actor.GetShaderProperty().AddFragmentShaderReplacement(
            "//VTK::Clip::Impl", True,
            "if (dot(cutPlane, vec4(gl_FragCoord.xyz, 1.0)) < 0.0) discard;\n//VTK::Clip::Impl", False)
        self.when_mirrored.append(set_plane)

    def add_data(self, data, color=(1, 0.6, 0.2), cut=True, **options):
        """Adds an actor of poly data; options as those of water_test.add_actor."""
        actor = wt.add_actor(self.renderer, data, color, **options)
        self.renderer.RemoveActor(actor)
        return self.add(actor, cut)

    def is_above(self):
        """Is the user's eye on the side that the normal points to? Asked before the camera is mirrored."""
        return wt.is_above(self.camera, self.origin, self.normal)

    def pixels(self):
        """Renders; returns rows x columns x RGB as integers, bottom row first."""
        return self.picture()


def mirror(scene):
    """Turns a filled scene into its mirrored picture's, to be turned left to right."""
    camera, origin, normal = scene.camera, scene.origin, scene.normal
    scene.renderer.ComputeAspect()
    if scene.freezes_lights:
        freeze_lights(scene)
    up = np.asarray(camera.GetViewUp())
    position, focal_point = camera.GetPosition(), camera.GetFocalPoint()
    camera.SetPosition(wt.mirror_point(position, origin, normal))
    camera.SetFocalPoint(wt.mirror_point(focal_point, origin, normal))
    camera.SetViewUp(wt.mirror_point(up, (0, 0, 0), normal))
    center, shear = camera.GetWindowCenter(), camera.GetViewShear()
    camera.SetWindowCenter(-center[0], center[1])
    camera.SetViewShear(-shear[0], shear[1], shear[2])
    if camera.GetUserViewTransform():
        camera.SetUserViewTransform(turned_left_to_right(camera.GetUserViewTransform().GetMatrix(), scene))
    if camera.GetUseExplicitProjectionTransformMatrix():
        matrix = camera.GetExplicitProjectionTransformMatrix()
        camera.SetExplicitProjectionTransformMatrix(turned_left_to_right(matrix, scene).GetMatrix())
    for act in scene.when_mirrored:
        act()


def turned_left_to_right(matrix, scene):
    """F M F with F = diag(-1, 1, 1, 1), as a transform that scene keeps."""
    turned = vtkMatrix4x4()
    for i in range(4):
        for j in range(4):
            turned.SetElement(i, j, matrix.GetElement(i, j) * (-1 if (i == 0) != (j == 0) else 1))
    transform = vtkMatrixToLinearTransform()
    transform.SetInput(turned)
    scene.keep.append(transform)
    return transform


def freeze_lights(scene):
    """Makes scene lights of all lights, where the camera now puts them."""
    renderer = scene.renderer
    lights = [renderer.GetLights().GetItemAsObject(i) for i in range(renderer.GetLights().GetNumberOfItems())]
    if not lights and renderer.GetAutomaticLightCreation():
        headlight = vtkLight()
        headlight.SetLightTypeToHeadlight()
        lights = [headlight]
    placed = scene.camera.GetCameraLightTransformMatrix()
    frozen = []
    for light in lights:
        copy = vtkLight()
        copy.DeepCopy(light)
        copy.SetLightTypeToSceneLight()
        position, focal_point = (*light.GetPosition(), 1), (*light.GetFocalPoint(), 1)
        if light.LightTypeIsHeadlight():
            position, focal_point = (*scene.camera.GetPosition(), 1), (*scene.camera.GetFocalPoint(), 1)
        elif light.LightTypeIsCameraLight():
            position, focal_point = placed.MultiplyPoint(position), placed.MultiplyPoint(focal_point)
        copy.SetPosition(position[:3])
        copy.SetFocalPoint(focal_point[:3])
        frozen.append(copy)
    renderer.RemoveAllLights()
    for light in frozen:
        renderer.AddLight(light)
    renderer.AutomaticLightCreationOff()
    renderer.LightFollowCameraOff()


def matrix_of(*rows):
    """A vtkMatrix4x4 of its first rows."""
    matrix = vtkMatrix4x4()
    for i, row in enumerate(rows):
        for j, value in enumerate(row):
            matrix.SetElement(i, j, value)
    return matrix


def image_of(picture):
    """Rows x columns x RGB as vtkImageData."""
    height, width = picture.shape[:2]
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    values = np.ascontiguousarray(picture.astype(np.uint8)).reshape(-1, 3)
    image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    return image


def add_sheet(scene, picture, data=None, bounds=SHEET, opacity=1.0):
    """An ordinary sheet in the water's place that shows a picture, if any, by the place in the window."""
    if data is None:
        first, second = axes_of(scene.normal)
        corner = [scene.origin + x * first + y * second
                  for x, y in ((bounds[0], bounds[2]), (bounds[1], bounds[2]), (bounds[0], bounds[3]))]
        source = vtkPlaneSource()
        source.SetOutputPointsPrecision(1)
        source.SetOrigin(corner[0])
        source.SetPoint1(corner[1])
        source.SetPoint2(corner[2])
        source.Update()
        data = source.GetOutput()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    sheet = vtkActor()
    sheet.SetMapper(mapper)
    sheet.GetProperty().SetOpacity(opacity)
    scene.renderer.AddActor(sheet)
    if picture is None:
        return sheet
    texture = vtkTexture()
    texture.SetInputData(image_of(picture))
    texture.InterpolateOff()
    texture.RepeatOff()
    sheet.SetTexture(texture)
    sheet.GetShaderProperty().AddFragmentShaderReplacement("//VTK::TCoord::Impl", True, BY_PLACE, False)
    return sheet


def axes_of(normal):
    """The plane's own axes, as the design defines them."""
    normal = np.asarray(normal, float)
    world = np.array((1.0, 0, 0)) if abs(normal[0]) <= np.sqrt(0.5) else np.array((0.0, 1, 0))
    first = wt.unit(world - np.dot(world, normal) * normal)
    return first, np.cross(normal, first)


def mirrored_picture(fill, **options):
    """The scene as the mirrored camera sees it, turned left to right."""
    scene = Scene(MIRRORED, **options)
    fill(scene)
    mirror(scene)
    return scene.pixels()[:, ::-1]


def composed_picture(fill, mirrored, bounds=SHEET, opacity=1.0, **options):
    """The scene with an ordinary sheet in the water's place that shows a mirrored picture."""
    scene = Scene(COMPOSED, **options)
    fill(scene)
    add_sheet(scene, mirrored, None, bounds, opacity)
    return scene.pixels()


def water_pixels(scene, water):
    """Which pixels have any colour of the water's."""
    look = water.GetWaterProperty()
    look.SetReflectance(0)
    pictures = []
    for color in ((1, 0, 1), (0, 1, 0)):
        look.SetDeepColor(color)
        pictures.append(scene.pixels())
    look.SetReflectance(1)
    return np.abs(pictures[0] - pictures[1]).max(axis=2) > 0


class Results:
    """The cells of one row of the table: checked, printed, and written for the table."""

    def __init__(self, row):
        self.row = row
        self.folder = wt.output_folder()
        self.cells = []

    def add(self, name, pixels, percent, rmse, outside, control=None, reason=None, exact=True):
        """Remembers a cell and checks its figures; those of inexact cells only against LARGEST_RMSE."""
        wt.check_at_least(f"{name}: water pixels", pixels, 300)
        if exact:
            wt.check_at_most(f"{name}: % of water pixels off by more than 1/255", round(percent, 4), EXACT_PERCENT)
        else:
            print(f"{name}: {percent:.3f} % of water pixels off by more than 1/255, because: {reason}")
            wt.check_at_most(f"{name}: RMSE of 255", round(rmse, 4), LARGEST_RMSE)
        wt.check_equal(f"{name}: other pixels off by more than 1/255", outside, 0)
        if control is not None:
            wt.check_at_least(f"{name}: % of water pixels that it changes", round(control, 3), 0.5)
        self.cells.append(dict(cell=name, percent=percent, rmse=rmse, outside=outside, control=control,
                               reason=reason, exact=exact))

    def say(self, name, holds, reason=None):
        """A cell that is true or false."""
        wt.check_equal(name, bool(holds), True)
        self.cells.append(dict(cell=name, holds=bool(holds), reason=reason, exact=True))

    def note(self, name, reason):
        """A cell that this VTK cannot show; the reason is printed."""
        print(f"{name}: left out: {reason}", flush=True)
        self.cells.append(dict(cell=name, holds=None, reason=reason, exact=True))

    def compare(self, name, seen, expected, without, water, control=None, reason=None, exact=True):
        """Adds a cell by its pictures; water: which pixels show some of it."""
        error = np.abs(seen - expected)[water]
        changed = None if control is None else 100.0 * float((np.abs(control - expected)[water].max(axis=1) > 1).mean())
        percent = 100.0 * float((error.max(axis=1) > 1).mean()) if len(error) else 100.0
        rmse = float(np.sqrt((error.astype(float) ** 2).mean())) if len(error) else 255.0
        outside = 0 if without is None else int((np.abs(seen - without).max(axis=2) > 1)[~water].sum())
        self.add(name, int(water.sum()), percent, rmse, outside, changed, reason, exact)
        stem = re.sub(r"[^a-z0-9]+", "_", name.lower()).strip("_")
        wt.save(seen, self.folder / f"{stem}_water.png")
        wt.save(expected, self.folder / f"{stem}_truth.png")

    def cell(self, name, fill, truth=None, reason=None, exact=True, bounds=SHEET, prepare=None,
             control=REFLECTED, opacity=1.0, others=ALONE, **options):
        """One cell.

        fill     fills a Scene; called as fill(scene), or as fill(scene, True) and, for the control, as
                 fill(scene, False) without what the cell is about. Without the second argument the
                 control is the empty scene.
        truth    fills the mirrored and the composed picture, where that needs other means; None: fill
        prepare  (scene, water), called before the water is seen for the first time
        control  what the control differs in: REFLECTED, what the cell is about is not in the mirrored
                 picture; UNREFLECTED, it is, and must not be; BEHIND, it is not seen through the water
        opacity  of the water
        others   what pixels beside the water are compared with: ALONE, without water; BESIDE, with an
                 ordinary sheet, where any sheet changes them; FILTERED, with the composed picture, where a
                 filter mixes them with the water's
        options  of Scene: size, background, samples, origin, normal
        """
        base = (lambda scene: fill(scene, False)) if takes_two(fill) else without_props(fill)
        full = (lambda scene: fill(scene, True)) if takes_two(fill) else fill
        scene = Scene(SEEN, **options)
        full(scene)
        water = wt.add_water(scene.renderer, wt.plane(scene.origin, scene.normal), bounds)
        water.GetWaterProperty().SetOpacity(opacity)
        if prepare:
            prepare(scene, water)
        errors = wt.errors_of(water)
        seen = scene.pixels()
        if errors:
            wt.check_equal(f"{name}: errors", errors, [])
        pixels = water_pixels(scene, water)
        water.VisibilityOff()
        without = scene.pixels()
        truth = truth or full
        composed = base if control is BEHIND else truth
        mirrored, other = (base, truth) if control is UNREFLECTED else (truth, base)
        expected = composed_picture(truth, mirrored_picture(mirrored, **options), bounds, opacity, **options)
        wrong = composed_picture(composed, mirrored_picture(other, **options), bounds, opacity, **options)
        if others is BESIDE:
            without = composed_picture(truth, None, bounds, opacity, **options)
        elif others is FILTERED:
            without = expected
        self.compare(name, seen, expected, without, pixels, wrong, reason, exact)

    def cell_of_picture(self, name, fill, mirrored, reason=None, exact=True, bounds=SHEET, prepare=None, **options):
        """A cell whose mirrored picture is known; its control is that of the scene's plain background."""

        def plain(scene):
            fill(scene)
            scene.renderer.GradientBackgroundOff()

        scene = Scene(SEEN, **options)
        fill(scene)
        water = wt.add_water(scene.renderer, wt.plane(scene.origin, scene.normal), bounds)
        if prepare:
            prepare(scene, water)
        seen = scene.pixels()
        pixels = water_pixels(scene, water)
        water.VisibilityOff()
        without = scene.pixels()
        wrong = composed_picture(fill, mirrored_picture(plain, **options), bounds, **options)
        expected = composed_picture(fill, mirrored, bounds, **options)
        self.compare(name, seen, expected, without, pixels, wrong, reason, exact)

    def finish(self):
        """Writes the row for the table and ends the test."""
        result = dict(row=self.row, vtk=vtkVersion.GetVTKVersion(), cells=self.cells)
        (self.folder / "mirror-matrix.json").write_text(json.dumps(result, indent=1))
        wt.finish()


def takes_two(fill):
    """Does a fill take whether what the cell is about is on?"""
    return "on" in inspect.signature(fill).parameters


def without_props(fill):
    """A fill that takes a fill's camera and background, and no props."""

    def empty(scene):
        fill(scene)
        scene.renderer.RemoveAllViewProps()

    return empty

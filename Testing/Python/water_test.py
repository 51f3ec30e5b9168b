# SPDX-License-Identifier: BSD-3-Clause
"""water_test: what the Python tests share: windows, pictures, scenes and their mirror images.

Truths come from VTK itself: the mirrored scene is built from data (clipped at the plane, points and
normals mirrored, cells reversed), never from an actor's matrix of determinant -1, which VTK lights
wrongly.
"""

import contextlib
import gc
import os
import pathlib
import sys

import numpy as np

import vtkmodules.vtkInteractionStyle  # noqa: F401  factories
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import (
    vtkInformation,
    vtkLogger,
    vtkOutputWindow,
    vtkPoints,
    vtkStringOutputWindow,
    vtkUnsignedCharArray,
)
from vtkmodules.vtkCommonDataModel import vtkNonMergingPointLocator, vtkPlane, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkMatrixToLinearTransform
from vtkmodules.vtkFiltersCore import vtkClipPolyData, vtkPolyDataNormals, vtkReverseSense
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkCubeSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
)

import vtkwater  # noqa: F401
from vtkwater import vtkWaterActor, vtkWaterReflectionPass

failures = []


def check(name, value, limit, holds):
    """Prints one figure and remembers whether it holds."""
    print(f"{name}: {value} (limit {limit}) {'ok' if holds else 'FAILED'}", flush=True)
    if not holds:
        failures.append(name)


def check_equal(name, value, expected):
    check(name, value, f"= {expected}", value == expected)


def check_at_most(name, value, limit):
    check(name, value, f"<= {limit}", value <= limit)


def check_at_least(name, value, limit):
    check(name, value, f">= {limit}", value >= limit)


def finish():
    """Ends a command that is no test file: exit status 1 when a figure did not hold."""
    if failures:
        print("failed:", ", ".join(failures))
    sys.exit(1 if failures else 0)


def output_folder():
    """Where pictures go that a person may want to look at."""
    folder = pathlib.Path(os.environ.get("WATER_TEST_OUTPUT", "."))
    folder.mkdir(parents=True, exist_ok=True)
    return folder


@contextlib.contextmanager
def unheard():
    """Keeps messages out of the log, where they would fail the test: for what VTK itself does wrong.

    Builds of VTK that look for errors of OpenGL (Debian's 9.6 is one) report what others pass over.
    """
    shown, verbosity = vtkOutputWindow.GetInstance(), vtkLogger.GetCurrentVerbosityCutoff()
    vtkOutputWindow.SetInstance(vtkStringOutputWindow())
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    try:
        yield
    finally:
        gc.collect()  # what is deleted speaks, too
        vtkOutputWindow.SetInstance(shown)
        vtkLogger.SetStderrVerbosity(verbosity)


def settings_of(window):
    """What tests change of a window."""
    return (window.GetSize(), window.GetMultiSamples(), window.GetStereoRender(), window.GetStereoType(),
            window.GetNumberOfLayers(), window.GetDesiredUpdateRate(), window.GetAlphaBitPlanes(),
            window.GetTileScale(), window.GetTileViewport(), window.GetSwapBuffers(), window.GetErase(),
            window.GetUseSRGBColorSpace(), window.GetInteractor(), window.GetClassName())


class View:
    """A small off-screen window with one renderer.

    Mesa compiles each shader anew for each window, which takes most of a test's time. A window that nobody uses any
    more, and that is as it was made, is therefore used again by the next view of the same kind (windows_at_rest), with a
    new renderer. is_new: make a window, for tests of what happens in its first frames. WATER_TEST_NEW_WINDOWS=1 in the
    environment: make one for every view.
    """

    windows_at_rest = {}  # by size, samples and the environment that the module reads

    def __init__(self, size=(320, 240), background=(0.2, 0.3, 0.4), samples=0, is_new=False):
        software = os.environ.get("VTK_WATER_SOFTWARE")
        self.window_kind = None if is_new or os.environ.get("WATER_TEST_NEW_WINDOWS") else (tuple(size), samples, software)
        rest = View.windows_at_rest.get(self.window_kind)
        if rest:
            self.window = rest.pop()
        else:
            self.window = vtkRenderWindow()
            self.window.SetOffScreenRendering(True)
            self.window.SetMultiSamples(samples)
            self.window.SetSize(*size)
        self.settings = settings_of(self.window)
        self.renderer = self.add_renderer(background)

    def __del__(self):
        window, renderer = self.window, self.renderer
        self.window = self.renderer = None
        is_held = sys.getrefcount(window) > 2 or sys.getrefcount(renderer) > 2  # by a test; 2: here, and the argument
        if self.window_kind is None or is_held or not window.GetNeverRendered() == 0 or settings_of(window) != self.settings:
            return
        renderers = window.GetRenderers()
        while renderers.GetNumberOfItems():
            window.RemoveRenderer(renderers.GetItemAsObject(0))
        del renderers
        if window.GetReferenceCount() == 1:  # held by this wrapper alone
            View.windows_at_rest.setdefault(self.window_kind, []).append(window)

    def add_renderer(self, background, viewport=(0, 0, 1, 1)):
        renderer = vtkRenderer()
        renderer.SetBackground(background)
        renderer.SetViewport(viewport)
        self.window.AddRenderer(renderer)
        return renderer

    def picture(self):
        """Renders; returns rows x columns x RGB as integers, bottom row first."""
        self.window.Render()
        return self.shown()

    def shown(self, front=0, right=0):
        """The picture of a buffer as it is: of a stereo window, the front one has one for each eye."""
        width, height = self.window.GetSize()
        pixels = vtkUnsignedCharArray()
        self.window.GetRGBACharPixelData(0, 0, width - 1, height - 1, front, pixels, right)
        return vtk_to_numpy(pixels).reshape(height, width, 4)[:, :, :3].astype(int)


def place_camera(renderer, position, focal_point, clipping_range, view_up=(0, 0, 1)):
    """Places a renderer's camera and returns it; what VTK's own view takes from the scene's bounds is given."""
    camera = renderer.GetActiveCamera()
    camera.SetPosition(position)
    camera.SetFocalPoint(focal_point)
    camera.SetViewUp(view_up)
    camera.SetClippingRange(clipping_range)
    return camera


def difference(first, second):
    """The largest difference of two pictures in any colour of any pixel, of 255."""
    return int(np.abs(first - second).max())


def count_colors(pixels):
    """How many colours pixels (..., 3) have, of whole numbers up to 255; rows are slow to sort."""
    return len(np.unique(np.asarray(pixels).reshape(-1, 3).astype(int) @ (1, 256, 65536)))


def with_normals(source):
    """Output of a source with normals, hard edges split, in double precision."""
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(source.GetOutputPort())
    normals.SetFeatureAngle(30)
    normals.SetOutputPointsPrecision(1)
    normals.Update()
    return normals.GetOutput()


def box(center, lengths):
    source = vtkCubeSource()
    source.SetCenter(center)
    source.SetXLength(lengths[0])
    source.SetYLength(lengths[1])
    source.SetZLength(lengths[2])
    return with_normals(source)


def pyramid(center, height, resolution=4, radius=0.5):
    source = vtkConeSource()
    source.SetDirection(0, 0, 1)
    source.SetHeight(height)
    source.SetRadius(radius)
    source.SetResolution(resolution)
    source.SetCenter(center)
    return with_normals(source)


def sphere(center, radius, resolution=48):
    source = vtkSphereSource()
    source.SetCenter(center)
    source.SetRadius(radius)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    return with_normals(source)


def columns_and_pyramids():
    things = []
    for i in range(12):
        center = ((i % 4) * 2.2 - 3.3, (i // 4) * 2.6 - 1.5, 0.2)
        color = (0.3 + 0.05 * i, 0.9 - 0.06 * i, 0.5)
        if i % 2:
            things.append((box(center, (0.7, 0.9, 1 + 0.3 * i)), color))
        else:
            things.append((pyramid(center, 1.5 + 0.3 * i, 4 + i // 2), color))
    return things


def curved_things():
    return [
        (sphere((-0.5, 0, 0.2), 1.4), (1.0, 0.6, 0.2)),
        (pyramid((2.2, 0.3, 0.4), 2.2, 40, 0.8), (0.2, 0.6, 1.0)),
    ]


def tall_poles():
    return [
        (box((3 * i - 9, 4 * (i % 3), 2), (0.4, 0.4, 6 + i)), (0.9, 0.3 + 0.08 * i, 0.2))
        for i in range(7)
    ]


def transformed(data, matrix):
    """Data with its points, and its normals where it has any, transformed."""
    result = vtkPolyData()
    result.DeepCopy(data)
    transform = vtkMatrixToLinearTransform()
    transform.SetInput(matrix)
    points = vtkPoints()
    points.SetDataTypeToDouble()
    transform.TransformPoints(data.GetPoints(), points)
    result.SetPoints(points)
    normals = result.GetPointData().GetNormals()
    if normals:
        rotation = np.array([[matrix.GetElement(i, j) for j in range(3)] for i in range(3)])
        values = vtk_to_numpy(normals)
        values[:] = values @ rotation.T
    return result


def moved(data, offset):
    matrix = vtkMatrix4x4()
    for i in range(3):
        matrix.SetElement(i, 3, offset[i])
    return transformed(data, matrix)


def plane(origin, normal):
    result = vtkPlane()
    result.SetOrigin(origin)
    result.SetNormal(normal)
    return result


def unit(vector):
    vector = np.asarray(vector, dtype=float)
    return vector / np.linalg.norm(vector)


def mirror_point(point, origin, normal):
    return np.asarray(point) - 2 * np.dot(np.asarray(point) - origin, normal) * np.asarray(normal)


def mirror_image(data, origin, normal):
    """What lies on the side the normal points to, cut at the plane and mirrored there."""
    clip = vtkClipPolyData()
    clip.SetInputData(data)
    clip.SetClipFunction(plane(origin, normal))
    clip.SetLocator(vtkNonMergingPointLocator())  # the default one merges hard edges away
    clip.SetOutputPointsPrecision(1)
    clip.Update()
    matrix = vtkMatrix4x4()
    distance = np.dot(origin, normal)
    for i in range(3):
        for j in range(3):
            matrix.SetElement(i, j, (i == j) - 2 * normal[i] * normal[j])
        matrix.SetElement(i, 3, 2 * distance * normal[i])
    reverse = vtkReverseSense()  # a mirrored triangle winds the other way
    reverse.SetInputData(transformed(clip.GetOutput(), matrix))
    reverse.ReverseCellsOn()
    reverse.ReverseNormalsOff()
    reverse.Update()
    return reverse.GetOutput()


def add_actor(renderer, data, color, lit=True, specular=0.0, opacity=1.0):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetLighting(lit)
    actor.GetProperty().SetSpecular(specular)
    actor.GetProperty().SetSpecularPower(10)
    actor.GetProperty().SetOpacity(opacity)
    renderer.AddActor(actor)
    return actor


def leave_out(prop):
    """Gives a prop the key that keeps it out of all reflections, in place of its keys."""
    keys = vtkInformation()
    keys.Set(vtkWaterReflectionPass.NOT_REFLECTED(), 1)
    prop.SetPropertyKeys(keys)


def reflect(prop):
    """Gives rulers and axes the key with which they are reflected, in place of their keys; returns the prop."""
    keys = vtkInformation()
    keys.Set(vtkWaterReflectionPass.NOT_REFLECTED(), 0)
    prop.SetPropertyKeys(keys)
    return prop


def add_water(renderer, water_plane=None, sheet=None, reflectance=1.0):
    """Water that is a perfect mirror, or reflects a constant share; None: exact Fresnel."""
    water = vtkWaterActor()
    if water_plane is not None:
        water.SetPlane(water_plane)
    if sheet is not None:
        water.SetSheetBounds(*sheet)
    if reflectance is not None:
        water.GetWaterProperty().SetReflectanceModeToConstant()
        water.GetWaterProperty().SetReflectance(reflectance)
    renderer.AddActor(water)
    return water


def decision_of(water):
    """The name of what was decided last."""
    decision = water.GetReflectionPass().GetDecision()
    values = vars(vtkWaterReflectionPass).items()
    return next(name for name, value in values if isinstance(value, vtkWaterReflectionPass.Decisions) and
                value == decision)


def water_mask(view, water):
    """Which pixels show the water: those that change with its plain colour."""
    look = water.GetWaterProperty()
    mode, reflectance, color = (
        look.GetReflectanceMode(),
        look.GetReflectance(),
        look.GetDeepColor(),
    )
    look.SetReflectanceModeToConstant()
    look.SetReflectance(0)
    look.SetDeepColor(1, 0, 1)
    first = view.picture()
    look.SetDeepColor(0, 1, 0)
    second = view.picture()
    look.SetReflectanceMode(mode)
    look.SetReflectance(reflectance)
    look.SetDeepColor(color)
    return np.abs(first - second).max(axis=2) > 128


def errors_of(thing):
    """A list that the texts of an object's errors will be put into."""
    errors = []

    def remember(caller, event, text):
        errors.append(text)

    remember.CallDataType = "string0"
    thing.AddObserver("ErrorEvent", remember)
    return errors


def checker(size=16):
    """A picture of black and white squares."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData

    squares = np.add.outer(np.arange(size), np.arange(size)) % 2 * 255
    image = vtkImageData()
    image.SetDimensions(size, size, 1)
    image.GetPointData().SetScalars(
        numpy_to_vtk(np.repeat(squares.reshape(-1, 1), 3, axis=1).astype(np.uint8), deep=True))
    return image


def add_scene_light(renderer, position, focal_point=(0, 0, 0)):
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(position)
    light.SetFocalPoint(focal_point)
    renderer.AddLight(light)


def is_above(camera, origin, normal):
    if camera.GetParallelProjection():
        return np.dot(camera.GetDirectionOfProjection(), normal) < 0
    return np.dot(np.asarray(camera.GetPosition()) - origin, normal) > 0


def save(picture, path):
    """A picture as PNG, the right way up."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonDataModel import vtkImageData
    from vtkmodules.vtkIOImage import vtkPNGWriter

    height, width = picture.shape[:2]
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(
        numpy_to_vtk(np.ascontiguousarray(picture.astype(np.uint8)).reshape(-1, 3), deep=True)
    )
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()

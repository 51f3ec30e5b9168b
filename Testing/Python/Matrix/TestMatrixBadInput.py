# SPDX-License-Identifier: BSD-3-Clause
"""Bad input of the mirror matrix: a clear error, the frame finishes, the rest is right, nothing is lost.

What VTK says of a bad prop is caught; the water beside it must be that of the scene without the prop.
Texture units and references are counted before and after.
"""

import mirror_matrix as mm
import numpy as np
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401  factories
import water_test as wt
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkVolume
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper
from vtkwater import vtkWaterReflectionPass

row = mm.Results("Bad input", __file__)
FRAMES = 3


def things(scene):
    scene.add_data(wt.sphere((0, 0, 0.4), 1.5), (1, 0.6, 0.2))
    scene.add_data(wt.box((2.4, 0.8, 0.4), (0.8, 0.8, 2.2)), (0.3, 0.8, 0.4))


def units_in_use(scene):
    """How many texture units are taken; None where the window's class is not wrapped (VTK before 9.4)."""
    if not hasattr(scene.window, "GetTextureUnitManager"):
        return None
    units = scene.window.GetTextureUnitManager()
    return sum(bool(units.IsAllocated(i)) for i in range(units.GetNumberOfTextureUnits()))


def references(scene, water):
    props = scene.renderer.GetViewProps()
    first = props.GetItemAsObject(0)
    return [thing.GetReferenceCount() for thing in (
        scene.renderer, scene.window, scene.camera, water, water.GetReflectionPass(), first, first.GetMapper(),
        scene.renderer.GetLights())]


def frames(scene):
    """The last of some pictures, and what VTK says meanwhile, which does not go to the log."""
    heard = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(heard)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    pictures = [scene.pixels() for _ in range(FRAMES)]
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_INFO)
    vtkOutputWindow.SetInstance(None)
    return pictures[-1], heard.GetOutput()


def bad_prop(name, make, words, is_drawn=False):
    """A prop that cannot be drawn, or is drawn all the same, beside others; words are in what VTK says, None:
    it says nothing."""

    def with_prop(scene):
        things(scene)
        if is_drawn:
            scene.add(make(), cut=False)  # it is over the water

    plain = mm.composed_picture(things, mm.mirrored_picture(things))
    expected = mm.composed_picture(with_prop, mm.mirrored_picture(with_prop))
    scene = mm.Scene(mm.SEEN)
    things(scene)
    water = wt.add_water(scene.renderer, wt.plane((0, 0, 0), (0, 0, 1)), mm.SHEET)
    scene.pixels()
    before = units_in_use(scene), references(scene, water)
    prop = make()
    scene.renderer.AddViewProp(prop)
    with_water, said = frames(scene)
    water.VisibilityOff()
    _, said_without = frames(scene)
    water.VisibilityOn()
    scene.renderer.RemoveViewProp(prop)
    after_picture, after_said = frames(scene)
    is_water = mm.water_pixels(scene, water)
    scene.pixels()
    error = np.abs(with_water - expected).max(axis=2)[is_water]
    row.say(f"{name}: the water beside it is right", (error > 1).mean() <= mm.EXACT_PERCENT / 100)
    row.say(f"{name}: VTK's error is there" if words else f"{name}: no error, as without water",
            words in said if words else said == said_without)
    row.say(f"{name}: once it is removed, the next picture is right, without an error",
            np.abs(after_picture - plain).max() <= 1 and after_said == "")
    row.say(f"{name}: texture units and references are as before",
            (units_in_use(scene), references(scene, water)) == before)


def does_not_compile():
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(wt.sphere((-2.4, 0, 0.8), 0.7, 20))
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetShaderProperty().AddFragmentShaderReplacement("//VTK::Color::Impl", True, "this is no GLSL", False)
    return actor


def without_input():
    actor = vtkActor()
    actor.SetMapper(vtkPolyDataMapper())
    return actor


def empty_volume():
    volume = vtkVolume()
    volume.SetMapper(vtkGPUVolumeRayCastMapper())
    return volume


def volume_without_functions():
    image = vtkImageData()
    image.SetDimensions(8, 8, 8)
    image.SetSpacing(0.1, 0.1, 0.1)
    image.SetOrigin(-3, -1, 0.5)
    image.AllocateScalars(3, 1)
    image.GetPointData().GetScalars().Fill(90)
    mapper = vtkGPUVolumeRayCastMapper()
    mapper.SetInputData(image)
    mapper.UseJitteringOff()
    mapper.AutoAdjustSampleDistancesOff()
    volume = vtkVolume()
    volume.SetMapper(mapper)
    return volume


if mm.VTK_VERSION >= (9, 6):
    row.register("a prop whose shader does not compile", bad_prop, does_not_compile, "this is no GLSL")
else:
    row.register("a prop whose shader does not compile", row.note,
                 "VTK 9.1 ends the program with a segmentation fault, also without water: "
                 "vtkOpenGLPolyDataMapper::UpdateShaders continues without a program.")
row.register("a prop without a mapper", bad_prop, vtkActor, None)
row.register("a mapper without input", bad_prop, without_input, None)
row.register("a volume without transfer functions", bad_prop, volume_without_functions, None, is_drawn=True)
row.register("a volume without input", bad_prop, empty_volume, "has 0 connections")


def passes(name, set_up, words=None, shown="the props are drawn"):
    """A pass that is wrong: said once at most; set_up returns how to undo it. Nothing is rendered by passes that lead
    back to each other: then what is shown is the last picture."""
    scene = mm.Scene(mm.SEEN)
    things(scene)
    wt.add_water(scene.renderer, wt.plane((0, 0, 0), (0, 0, 1)), mm.SHEET)
    good = scene.pixels()
    before = units_in_use(scene)
    made = vtkWaterReflectionPass()
    errors = wt.errors_of(made)
    undo = set_up(scene, made)
    seen, _ = frames(scene)
    row.say(f"{name}: the errors in {FRAMES} frames: {1 if words else 0}",
            len(errors) == (1 if words else 0) and (not words or words in errors[0]))
    row.say(f"{name}: {shown}", np.abs(seen - good).max(axis=2)[mm.SIZE[1] // 2 + 40:].max() <= 1)
    scene.renderer.SetPass(None)
    undo()
    after, _ = frames(scene)
    row.say(f"{name}: once it is removed, the next picture is right", np.abs(after - good).max() <= 1)
    row.say(f"{name}: texture units are as before", units_in_use(scene) == before)


def no_delegate(scene, made):
    made.SetDelegatePass(None)
    scene.renderer.SetPass(made)
    return lambda: None


def own_delegate(scene, made):
    made.SetDelegatePass(made)
    scene.renderer.SetPass(made)
    return lambda: None


def cycle(scene, first):
    second = vtkWaterReflectionPass()
    first.SetDelegatePass(second)
    second.SetDelegatePass(first)
    scene.renderer.SetPass(first)
    return lambda: second.SetDelegatePass(None)


row.register("a pass without a delegate", passes, no_delegate)
row.register("a pass that is its own delegate", passes, own_delegate, "DelegatePass is the pass itself")
row.register("two passes that are each other's delegates", passes, cycle, "leads back",
             "the last picture stays")


@row.makes("a pass shared by two renderers")
def shared_pass():
    """One pass, in turn in charge of two renderers of one window."""
    scene = mm.Scene(mm.SEEN)
    scene.renderer.SetViewport(0, 0, 0.5, 1)
    other = scene.add_renderer((0.2, 0.3, 0.4), (0.5, 0, 1, 1))
    shared = vtkWaterReflectionPass()
    shared.SetDelegatePass(vtkRenderStepsPass())
    errors = wt.errors_of(shared)
    things(scene)
    for renderer in (scene.renderer, other):
        if renderer is other:
            other.SetActiveCamera(scene.camera)
            props = scene.renderer.GetViewProps()
            for i in range(props.GetNumberOfItems()):
                other.AddViewProp(props.GetItemAsObject(i))
        renderer.SetPass(shared)
    for renderer in (scene.renderer, other):
        wt.add_water(renderer, wt.plane((0, 0, 0), (0, 0, 1)), mm.SHEET)
    pictures = [scene.pixels() for _ in range(FRAMES)]
    half = mm.SIZE[0] // 2
    row.say("a pass shared by two renderers: no error", errors == [])
    row.say("a pass shared by two renderers: both show the same",
            all(np.abs(picture[:, :half] - picture[:, half:]).max() <= 1 for picture in pictures))
    own = mm.Scene(mm.SEEN, size=(half, mm.SIZE[1]))
    things(own)
    wt.add_water(own.renderer, wt.plane((0, 0, 0), (0, 0, 1)), mm.SHEET)
    row.say("a pass shared by two renderers: each shows what one alone shows",
            np.abs(pictures[-1][:, :half] - own.pixels()).max() <= 1)


test_cell = row.test()

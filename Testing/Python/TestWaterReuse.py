# SPDX-License-Identifier: BSD-3-Clause
"""The mirrored view of an unchanged scene is used again; every kind of change, one by one, renders it
anew; and no pipeline runs more often for it than it would without the water."""

import re

import pytest
import water_test as wt
from reuse_scene import SIZE, Scene, in_place, texture_of
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersProgrammable import vtkProgrammableFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkAssembly, vtkMapper, vtkProperty, vtkWindowToImageFilter
from vtkmodules.vtkRenderingLOD import vtkLODActor
from vtkwater import vtkWaterReflectionPass as Pass


def replace(scene):
    other = vtkActor()
    other.SetMapper(scene.colored.GetMapper())
    other.SetPosition(scene.colored.GetPosition())
    scene.renderer.RemoveActor(scene.colored)
    scene.renderer.AddActor(other)
    scene.colored = other


def replace_shader(actor, text):
    actor.GetShaderProperty().AddFragmentShaderReplacement(
        "//VTK::Color::Impl", True, f"//VTK::Color::Impl\n  diffuseColor *= {text};\n", False)


def user_transform(scene):
    transform = vtkTransform()
    transform.RotateX(20)
    scene.actor.SetUserTransform(transform)


def mask_volume(scene):
    scene.volume.GetMapper().SetMaskTypeToBinary()
    scene.volume.GetMapper().SetMaskInput(scene.mask)


def opacity_points(scene):
    scene.volume.GetProperty().GetScalarOpacity().AddPoint(200, 0.9)


def add_box(scene):
    wt.add_actor(scene.renderer, wt.box((1, -2, 1), (0.5, 0.5, 0.5)), (1, 0, 0))


def add_light_switched_off(scene):
    scene.add_light().SwitchOff()


def polygon_offset(scene):
    vtkMapper.SetResolveCoincidentTopologyToPolygonOffset()


def add_wave(scene):
    scene.look.AddWave(0.05, 2, 20)


def half_scale(scene):
    """Makes some props smaller than 12 pixels of the texture."""
    scene.reflection.SetTextureScale(0.5)


def make_wavy(scene):
    """Waves, a wide sheet and a guard band: what NO_CHANGES change of them concerns no mirrored view."""
    add_wave(scene)
    scene.water.SetSheetBounds(-9, 9, -9, 9)
    scene.reflection.SetGuardBand(1.5)


# What renders the mirrored view anew.
CHANGES = {
    "camera moves": lambda s: s.camera.SetPosition(1.1, -16, 5),
    "camera zooms": lambda s: s.camera.SetViewAngle(31),
    "camera rolls": lambda s: s.camera.Roll(2),
    "clipping range": lambda s: s.camera.SetClippingRange(2, 61),
    "actor moves": lambda s: s.actor.AddPosition(0.1, 0, 0),
    "user transform": user_transform,
    "user matrix in place": lambda s: s.matrix.SetElement(2, 3, 0.2),
    "colour": lambda s: s.poster.GetProperty().SetColor(1, 0.5, 0.5),
    "property replaced": lambda s: s.poster.SetProperty(vtkProperty()),
    "backface property": lambda s: s.poster.SetBackfaceProperty(vtkProperty()),
    "colour of the backface property": lambda s: s.poster.GetBackfaceProperty().SetColor(0, 0, 1),
    "opacity": lambda s: s.colored.GetProperty().SetOpacity(0.5),
    "texture's pixels": lambda s: in_place(s.image.GetPointData().GetScalars(), 17),
    "texture's interpolation": lambda s: s.poster.GetTexture().InterpolateOn(),
    "texture's table": lambda s: s.tones.SetTableValue(3, 1, 0, 1, 1),
    "texture replaced": lambda s: s.poster.SetTexture(texture_of(wt.checker(4))),
    "point in place": lambda s: in_place(s.data.GetPoints().GetData(), 0.1),
    "scalar in place": lambda s: in_place(s.data.GetPointData().GetScalars(), 0.1),
    "scalar range": lambda s: s.colored.GetMapper().SetScalarRange(0, 2),
    "lookup table": lambda s: s.table.SetHueRange(0.2, 0.5),
    "lookup table's value": lambda s: s.table.SetTableValue(100, 1, 1, 1, 1),
    "filter upstream": lambda s: s.heights.SetHighPoint(0, 0, 2),
    "source upstream of it": lambda s: s.ball.SetRadius(0.9),
    "visibility": lambda s: s.colored.VisibilityOff(),
    "visibility again": lambda s: s.colored.VisibilityOn(),
    "actor replaced by its like": replace,
    "actor added": add_box,
    "actor removed": lambda s: s.renderer.RemoveActor(s.renderer.GetActors().GetLastActor()),
    "block's points": lambda s: in_place(s.blocks.GetBlock(1).GetPoints().GetData(), 0.1),
    "block removed": lambda s: s.blocks.SetBlock(0, None),
    "block's colour": lambda s: s.attributes.SetBlockColor(s.blocks.GetBlock(1), (0.2, 0.9, 0.3)),
    "glyph's shape": lambda s: s.shape.SetRadius(0.4),
    "glyphs' size": lambda s: s.glyphs.GetMapper().SetScaleFactor(1.3),
    "volume's opacity": opacity_points,
    "volume's data": lambda s: in_place(s.volume.GetMapper().GetInput().GetPointData().GetScalars(), 1),
    "clipping plane in place": lambda s: s.cuts[0].SetOrigin(-4.3, 0, 1),
    "volume's clipping plane in place": lambda s: s.cuts[1].SetOrigin(-0.3, 2, 2.5),
    "volume's mask": mask_volume,
    "volume's mask in place": lambda s: in_place(s.mask.GetPointData().GetScalars(), 1),
    "volume moves": lambda s: s.volume.AddPosition(0.1, 0, 0),
    "slice's window": lambda s: s.slice.GetProperty().SetColorWindow(100),
    "slice's data": lambda s: in_place(s.slice.GetMapper().GetInput().GetPointData().GetScalars(), 1),
    "shader replacement": lambda s: replace_shader(s.poster, "0.5"),
    "light moves": lambda s: s.light.SetPosition(-3, -8, 9),
    "light's intensity": lambda s: s.light.SetIntensity(0.7),
    "light added": lambda s: s.add_light(),
    "light switched off": lambda s: s.renderer.GetLights().GetItemAsObject(1).SwitchOff(),
    "light removed": lambda s: s.renderer.RemoveLight(s.renderer.GetLights().GetItemAsObject(1)),
    "background": lambda s: s.renderer.SetBackground(0.5, 0.3, 0.3),
    "gradient": lambda s: (s.renderer.GradientBackgroundOn(), s.renderer.SetBackground2(0.1, 0.9, 0.3)),
    "level": lambda s: s.water.SetLevel(0.1),
    "plane in place": lambda s: s.water.GetPlane().SetNormal(0.02, 0, 1),
    "sheet grows": lambda s: s.water.SetSheetBounds(-9, 9, -9, 9),
    "window's size": lambda s: s.view.window.SetSize(SIZE[0] + 8, SIZE[1]),
    "update rate": lambda s: s.view.window.SetDesiredUpdateRate(5.0),
    "coincident topology": polygon_offset,
    "offset of polygons": lambda s: vtkMapper.SetResolveCoincidentTopologyPolygonOffsetParameters(1, 2),
    "offset of lines": lambda s: vtkMapper.SetResolveCoincidentTopologyLineOffsetParameters(1, 2),
    "texture scale": half_scale,
    "samples": lambda s: s.reflection.SetMultiSamples(4),
    "colour precision": lambda s: s.reflection.SetColorPrecision(Pass.HALF_FLOAT),
    "clip margin": lambda s: s.reflection.SetClipMargin(0.1),
    "smallest prop": lambda s: s.reflection.SetMinimumPropSize(12),
    "no smallest prop": lambda s: s.reflection.SetMinimumPropSize(0),
    "waves": add_wave,
    "guard band": lambda s: s.reflection.SetGuardBand(1.5),
}
# What is done to the scene before some of them.
BEFORE = {
    "colour of the backface property": lambda s: s.poster.SetBackfaceProperty(vtkProperty()),
    "visibility again": lambda s: s.colored.VisibilityOff(),
    "actor removed": add_box,
    "volume's mask in place": mask_volume,
    "light switched off": lambda s: s.add_light(),
    "light removed": add_light_switched_off,
    "offset of polygons": polygon_offset,
    "offset of lines": polygon_offset,
    "smallest prop": half_scale,
    "no smallest prop": lambda s: (half_scale(s), s.reflection.SetMinimumPropSize(12)),
    "guard band": add_wave,
}
# What does not concern it.
NO_CHANGES = {
    "nothing": lambda s: None,
    "time of waves": lambda s: s.water.SetTime(s.water.GetTime() + 0.3),
    "colour of the water": lambda s: s.look.SetDeepColor(0.3, 0.1, 0.1),
    "reflectance": lambda s: s.look.SetReflectance(0.8),
    "thing out of view moves": lambda s: s.unseen.AddPosition(0, 0.1, 0),
    "sheet shrinks": lambda s: s.water.SetSheetBounds(-8, 8, -8, 8),
    "instrumentation": lambda s: s.reflection.InstrumentationOn(),
}


def ids(name):
    return re.sub(r"\W+", "_", name)


@pytest.fixture
def coincident_topology():
    """Sets VTK's own way with coincident topology back after the test."""
    yield
    vtkMapper.SetResolveCoincidentTopologyToOff()
    vtkMapper.SetResolveCoincidentTopologyPolygonOffsetParameters(2, 2)
    vtkMapper.SetResolveCoincidentTopologyLineOffsetParameters(-1, -4)


def test_an_unchanged_scene_is_mirrored_once():
    """The mirrored view is rendered in the first frame, and used again in all frames of the unchanged scene."""
    scene = Scene()
    wt.check_equal("first frame: mirrored views", scene.renders(), 1)
    scene.renders()  # drawing builds lookup tables, which is a change
    wt.check_equal("ten unchanged frames: mirrored views", scene.renders(10), 0)


@pytest.mark.parametrize("name", CHANGES, ids=ids)
def test_a_change_renders_it_anew(name, coincident_topology):
    """A change of what is mirrored renders the mirrored view anew, in the very frame, and only there."""
    scene = Scene()
    BEFORE.get(name, lambda s: None)(scene)
    scene.settle()
    CHANGES[name](scene)
    wt.check_equal(f"{name}: mirrored views in this frame", scene.renders(), 1)
    if scene.reflection.GetMinimumPropSize() == 0:
        wt.check_at_most(f"{name}: largest error", scene.error(), 1)
    scene.renders()  # drawing may build a lookup table, which is a change
    wt.check_equal(f"{name}: mirrored views in the two frames after the next", scene.renders(2), 0)


@pytest.mark.parametrize("name", NO_CHANGES, ids=ids)
def test_what_does_not_concern_it_does_not_render_it(name):
    """A change of what is not mirrored lets the mirrored view be used again, and the picture is right."""
    scene = Scene()
    make_wavy(scene)
    scene.settle()
    NO_CHANGES[name](scene)
    wt.check_equal(f"{name}: mirrored views in two frames", scene.renders(2), 0)
    wt.check_at_most(f"{name}: largest error", scene.error(), 1)


def test_without_the_skip_every_frame_renders_it():
    """With UNCHANGED_VIEWS switched off, every frame renders the mirrored view."""
    scene = Scene()
    scene.settle()
    scene.reflection.SetSkips(Pass.SKIP_ALL & ~Pass.UNCHANGED_VIEWS)
    wt.check_equal("without UNCHANGED_VIEWS: mirrored views in three frames", scene.renders(3), 3)


def uniform(scene):
    replace_shader(scene.poster, "share")
    scene.poster.GetShaderProperty().GetFragmentCustomUniforms().SetUniformf("share", 0.7)


def unknown(scene):
    levels = vtkLODActor()
    levels.SetMapper(scene.colored.GetMapper())
    levels.SetPosition(1, -2, 1)
    scene.renderer.AddActor(levels)


def assembly(scene):
    part = vtkActor()
    part.SetMapper(scene.colored.GetMapper())
    parts = vtkAssembly()
    parts.AddPart(part)
    parts.SetPosition(-3, 2, 2.5)
    scene.renderer.AddActor(parts)


def check_every_frame(name, change):
    scene = Scene()
    scene.renders()
    change(scene)
    wt.check_equal(f"{name}: mirrored views in three frames", scene.renders(3), 3)


UNTOLD = {
    "custom uniform": uniform,
    "assembly, which moves its parts to draw them": assembly,
    "observer of UpdateShaderEvent": lambda s: s.poster.GetMapper().AddObserver(
        "UpdateShaderEvent", lambda caller, event: None),
    "prop of an unknown kind": unknown,
}


@pytest.mark.parametrize("name", UNTOLD, ids=ids)
def test_what_may_change_untold_is_rendered_in_every_frame(name):
    """What may look different without anybody saying so is mirrored in every frame."""
    check_every_frame(name, UNTOLD[name])


def test_a_texture_without_an_image_is_rendered_in_every_frame():
    """A texture that has lost its image may look different untold, and is mirrored in every frame."""
    with wt.unheard():  # VTK gives its own shader the texture unit -1, with water or without
        check_every_frame("texture without an image", lambda s: s.poster.GetTexture().RemoveAllInputConnections(0))


def test_taking_a_picture_is_no_change():
    """Taking a picture of the window, which swaps the renderer's camera and back, is no change."""
    scene = Scene()
    scene.settle()
    for _ in range(3):
        taken = vtkWindowToImageFilter()
        taken.SetInput(scene.view.window)
        taken.ReadFrontBufferOff()
        taken.ShouldRerenderOff()
        taken.Update()
        wt.check_equal("a picture taken: mirrored views", scene.renders(), 0)


def test_each_eye_has_its_own_map():
    """In stereo each eye's mirrored view is used again, and both are rendered anew after a change."""
    scene = Scene()
    scene.view.window.StereoRenderOn()
    scene.view.window.SetStereoTypeToAnaglyph()
    scene.settle()
    wt.check_equal("stereo, three unchanged frames: mirrored views", scene.renders(3), 0)
    scene.actor.AddPosition(0.1, 0, 0)
    wt.check_equal("stereo, actor moved: mirrored views", scene.renders(), 2)
    wt.check_at_most("stereo: largest error", scene.error(), 1)


def test_each_renderer_has_its_own_map():
    """Each renderer's mirrored view is used again, and that one alone is rendered anew whose camera moves."""
    scene = Scene()
    scene.renderer.SetViewport(0, 0, 0.5, 1)
    other = scene.view.add_renderer((0.4, 0.2, 0.1), (0.5, 0, 1, 1))
    for i in range(scene.renderer.GetViewProps().GetNumberOfItems()):
        other.AddViewProp(scene.renderer.GetViewProps().GetItemAsObject(i))
    wt.add_scene_light(other, (3, -8, 9))
    other.GetActiveCamera().DeepCopy(scene.camera)
    other.GetActiveCamera().Azimuth(20)
    scene.settle()
    wt.check_equal("two renderers, three unchanged frames: mirrored views", scene.renders(3), 0)
    other.GetActiveCamera().Azimuth(1)
    wt.check_equal("two renderers, the camera of one moves: mirrored views", scene.renders(), 1)
    scene.actor.AddPosition(0.1, 0, 0)
    wt.check_equal("two renderers, actor moved: mirrored views", scene.renders(), 2)
    wt.check_at_most("two renderers: largest error", scene.error(), 1)


def test_released_resources_are_not_used_again():
    """After the graphics resources were released, the mirrored view is rendered once and the picture is right."""
    scene = Scene()
    scene.renders()
    scene.water.ReleaseGraphicsResources(scene.view.window)
    wt.check_equal("resources released: mirrored views in three frames", scene.renders(3), 1)
    wt.check_equal("resources released: largest error", scene.error(), 0)


def executions(with_water):
    """How often the pipelines of a changing scene have run after each of some frames."""
    scene = Scene()
    if not with_water:
        scene.renderer.RemoveActor(scene.water)
    count = []

    def counting(upstream):
        counter = vtkProgrammableFilter()
        counter.SetInputConnection(upstream)

        def execute():
            count.append(1)
            counter.GetOutput().ShallowCopy(counter.GetInput())

        counter.SetExecuteMethod(execute)
        return counter

    counters = [counting(scene.heights.GetOutputPort())]
    scene.actor.GetMapper().SetInputConnection(counters[0].GetOutputPort())
    for thing in (scene.poster.GetTexture(), scene.volume.GetMapper(), scene.slice.GetMapper()):
        counters.append(counting(thing.GetInputConnection(0, 0)))
        thing.SetInputConnection(counters[-1].GetOutputPort())
    counts = []
    for step in range(8):
        scene.view.picture()
        counts.append(len(count))
        if step % 3 == 1:
            scene.ball.SetRadius(0.8 + 0.01 * step)
            in_place(scene.image.GetPointData().GetScalars(), 3)
        if step % 4 == 2:
            scene.camera.Azimuth(3)
        if step == 5:
            scene.actor.VisibilityOff()
    return counts


def test_pipelines_run_as_often_as_without_water():
    """No pipeline runs more often than it would without the water."""
    dry = executions(False)
    wt.check_at_least("pipelines executed without water", dry[-1], 6)
    wt.check_equal("pipelines executed by frames", executions(True), dry)

# SPDX-License-Identifier: BSD-3-Clause
"""The mirrored view of an unchanged scene is used again; every kind of change, one by one, renders it
anew; and no pipeline runs more often for it than it would without the water."""

import numpy as np
import water_test as wt
import vtkmodules.vtkRenderingOpenGL2 as opengl
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from skip_scenes import blob
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPlane
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersProgrammable import vtkProgrammableFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkAssembly,
    vtkCompositeDataDisplayAttributes,
    vtkCompositePolyDataMapper,
    vtkGlyph3DMapper,
    vtkImageSlice,
    vtkImageSliceMapper,
    vtkMapper,
    vtkPolyDataMapper,
    vtkProperty,
    vtkTexture,
    vtkWindowToImageFilter,
)
from vtkmodules.vtkRenderingLOD import vtkLODActor
from vtkwater import vtkWaterReflectionPass as Pass

SIZE = (160, 120)
HAS_COLORS = hasattr(vtkCompositePolyDataMapper, "SetCompositeDataDisplayAttributes")  # VTK 9.3 and later
BlockMapper = vtkCompositePolyDataMapper if HAS_COLORS else opengl.vtkCompositePolyDataMapper2


def texture_of(image):
    texture = vtkTexture()
    texture.SetInputData(image)
    return texture


class Scene:
    """One of every kind of thing, all of them seen in the water."""

    def __init__(self):
        self.view = wt.View(SIZE)
        self.renderer = self.view.renderer
        self.light = self.add_light()
        self.ball = vtkSphereSource()
        self.ball.SetRadius(0.8)
        self.heights = vtkElevationFilter()
        self.heights.SetInputConnection(self.ball.GetOutputPort())
        self.heights.SetLowPoint(0, 0, -1)
        self.heights.SetHighPoint(0, 0, 1)
        self.table = vtkLookupTable()
        self.actor = self.add(vtkPolyDataMapper(), (-4, 0, 1))
        self.actor.GetMapper().SetInputConnection(self.heights.GetOutputPort())
        self.actor.GetMapper().SetLookupTable(self.table)
        self.data = wt.box((0, 0, 0), (1, 1, 1.5))
        self.data.GetPointData().SetScalars(numpy_to_vtk(np.linspace(0, 1, self.data.GetNumberOfPoints()), deep=True))
        self.colored = self.add(vtkPolyDataMapper(), (-2, 0, 1))
        self.colored.GetMapper().SetInputData(self.data)
        self.matrix = vtkMatrix4x4()
        self.colored.SetUserMatrix(self.matrix)
        square = vtkPlaneSource()
        self.image = wt.checker(8)
        self.poster = self.add(vtkPolyDataMapper(), (0, 0, 1.2))
        self.poster.GetMapper().SetInputConnection(square.GetOutputPort())
        self.poster.SetOrientation(90, 0, 0)
        self.poster.SetTexture(texture_of(self.image))
        self.tones = vtkLookupTable()
        self.poster.GetTexture().SetLookupTable(self.tones)
        self.blocks = vtkMultiBlockDataSet()
        for number in range(2):
            self.blocks.SetBlock(number, wt.box((0, 0, number), (0.8, 0.8, 0.8)))
        self.composite = self.add(BlockMapper(), (2, 0, 0.6))
        self.composite.GetMapper().SetInputDataObject(self.blocks)
        self.attributes = vtkCompositeDataDisplayAttributes()
        self.composite.GetMapper().SetCompositeDataDisplayAttributes(self.attributes)
        self.shape = vtkSphereSource()
        self.shape.SetRadius(0.3)
        self.glyphs = self.add(vtkGlyph3DMapper(), (4, 0, 1))
        self.glyphs.GetMapper().SetInputData(wt.pyramid((0, 0, 0), 1))
        self.glyphs.GetMapper().SetSourceConnection(self.shape.GetOutputPort())
        self.volume = blob()
        self.volume.SetPosition(0, 2, 2.5)
        self.cuts = [vtkPlane(), vtkPlane()]
        for cut, thing in zip(self.cuts, (self.actor, self.volume)):
            cut.SetOrigin(thing.GetPosition())
            cut.SetNormal(1, 0, 0)
            thing.GetMapper().AddClippingPlane(cut)
        self.mask = vtkImageData()
        self.mask.DeepCopy(self.volume.GetMapper().GetInput())
        self.mask.GetPointData().GetScalars().Fill(255)
        self.renderer.AddVolume(self.volume)
        self.slice = vtkImageSlice()
        self.slice.SetMapper(vtkImageSliceMapper())
        picture = vtkImageData()
        picture.SetDimensions(8, 8, 1)
        picture.GetPointData().SetScalars(numpy_to_vtk(np.arange(64, dtype=np.uint8) * 4, deep=True))
        self.slice.GetMapper().SetInputData(picture)
        self.slice.SetScale(0.2)
        self.slice.SetOrientation(70, 0, 0)
        self.slice.SetPosition(2, 2, 2)
        self.renderer.AddViewProp(self.slice)
        self.unseen = wt.add_actor(self.renderer, wt.box((300, 0, 1), (1, 1, 1)), (1, 1, 1))
        self.water = wt.add_water(self.renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-9, 9, -9, -1), 0.9)
        self.reflection = self.water.GetReflectionPass()
        self.look = self.water.GetWaterProperty()
        self.camera = wt.place_camera(self.renderer, (1, -16, 5), (0, 0, 0.3), (1, 60))

    def add(self, mapper, position):
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.SetPosition(position)
        self.renderer.AddActor(actor)
        return actor

    def add_light(self):
        wt.add_scene_light(self.renderer, (3, -8, 9))
        lights = self.renderer.GetLights()
        return lights.GetItemAsObject(lights.GetNumberOfItems() - 1)

    def renders(self, frames=1):
        """Mirrored views rendered in some frames; the last of them must be right."""
        before = self.reflection.GetNumberOfReflectionRenders()
        for _ in range(frames):
            self.picture = self.view.picture()
        return self.reflection.GetNumberOfReflectionRenders() - before

    def error(self):
        """Of the last picture."""
        self.reflection.SetSkips(Pass.SKIP_NONE)
        right = self.view.picture()
        self.reflection.SetSkips(Pass.SKIP_ALL)
        return int(np.abs(self.picture - right).max())


def in_place(array, add):
    wt.vtk_to_numpy(array)[:] += add
    array.Modified()


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
    "actor added": lambda s: wt.add_actor(s.renderer, wt.box((1, -2, 1), (0.5, 0.5, 0.5)), (1, 0, 0)),
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
    "coincident topology": lambda s: vtkMapper.SetResolveCoincidentTopologyToPolygonOffset(),
    "offset of polygons": lambda s: vtkMapper.SetResolveCoincidentTopologyPolygonOffsetParameters(1, 2),
    "offset of lines": lambda s: vtkMapper.SetResolveCoincidentTopologyLineOffsetParameters(1, 2),
    "texture scale": lambda s: s.reflection.SetTextureScale(0.5),
    "samples": lambda s: s.reflection.SetMultiSamples(4),
    "colour precision": lambda s: s.reflection.SetColorPrecision(Pass.HALF_FLOAT),
    "clip margin": lambda s: s.reflection.SetClipMargin(0.1),
    "smallest prop": lambda s: s.reflection.SetMinimumPropSize(12),
    "no smallest prop": lambda s: s.reflection.SetMinimumPropSize(0),
    "waves": lambda s: s.look.AddWave(0.05, 2, 20),
    "guard band": lambda s: s.reflection.SetGuardBand(1.5),
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

scene = Scene()
wt.check_equal("first frame: mirrored views", scene.renders(), 1)
scene.renders()  # drawing builds lookup tables, which is a change
wt.check_equal("ten unchanged frames: mirrored views", scene.renders(10), 0)
for name, change in CHANGES.items():
    change(scene)
    wt.check_equal(f"{name}: mirrored views in this frame", scene.renders(), 1)
    if scene.reflection.GetMinimumPropSize() == 0:
        wt.check_at_most(f"{name}: largest error", scene.error(), 1)
    scene.renders()  # drawing may build a lookup table, which is a change
    wt.check_equal(f"{name}: mirrored views in the two frames after the next", scene.renders(2), 0)
for name, change in NO_CHANGES.items():
    change(scene)
    wt.check_equal(f"{name}: mirrored views in two frames", scene.renders(2), 0)
    wt.check_at_most(f"{name}: largest error", scene.error(), 1)
    scene.renders()
vtkMapper.SetResolveCoincidentTopologyToOff()
vtkMapper.SetResolveCoincidentTopologyPolygonOffsetParameters(2, 2)  # VTK's own
vtkMapper.SetResolveCoincidentTopologyLineOffsetParameters(-1, -4)

# Forced off.
scene.reflection.SetSkips(Pass.SKIP_ALL & ~Pass.UNCHANGED_VIEWS)
wt.check_equal("without UNCHANGED_VIEWS: mirrored views in three frames", scene.renders(3), 3)


# What may look different without anybody saying so is rendered in every frame.
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


for name, change in {
    "custom uniform": uniform,
    "assembly, which moves its parts to draw them": assembly,
    "observer of UpdateShaderEvent": lambda s: s.poster.GetMapper().AddObserver("UpdateShaderEvent", lambda *all: None),
    "prop of an unknown kind": unknown,
}.items():
    check_every_frame(name, change)
with wt.unheard():  # VTK gives its own shader the texture unit -1, with water or without
    check_every_frame("texture without an image", lambda s: s.poster.GetTexture().RemoveAllInputConnections(0))

# Taking a picture of the window swaps the renderer's camera and back: no change.
scene = Scene()
scene.renders(2)
for _ in range(3):
    taken = vtkWindowToImageFilter()
    taken.SetInput(scene.view.window)
    taken.ReadFrontBufferOff()
    taken.ShouldRerenderOff()
    taken.Update()
    wt.check_equal("a picture taken: mirrored views", scene.renders(), 0)

# Each eye has its own map, and so has each renderer.
scene = Scene()
scene.view.window.StereoRenderOn()
scene.view.window.SetStereoTypeToAnaglyph()
scene.renders(2)
wt.check_equal("stereo, three unchanged frames: mirrored views", scene.renders(3), 0)
scene.actor.AddPosition(0.1, 0, 0)
wt.check_equal("stereo, actor moved: mirrored views", scene.renders(), 2)
wt.check_at_most("stereo: largest error", scene.error(), 1)

scene = Scene()
scene.renderer.SetViewport(0, 0, 0.5, 1)
other = scene.view.add_renderer((0.4, 0.2, 0.1), (0.5, 0, 1, 1))
for i in range(scene.renderer.GetViewProps().GetNumberOfItems()):
    other.AddViewProp(scene.renderer.GetViewProps().GetItemAsObject(i))
wt.add_scene_light(other, (3, -8, 9))
other.GetActiveCamera().DeepCopy(scene.camera)
other.GetActiveCamera().Azimuth(20)
scene.renders(2)
wt.check_equal("two renderers, three unchanged frames: mirrored views", scene.renders(3), 0)
other.GetActiveCamera().Azimuth(1)
wt.check_equal("two renderers, the camera of one moves: mirrored views", scene.renders(), 1)
scene.actor.AddPosition(0.1, 0, 0)
wt.check_equal("two renderers, actor moved: mirrored views", scene.renders(), 2)
wt.check_at_most("two renderers: largest error", scene.error(), 1)

# Released graphics resources are not used again.
scene = Scene()
scene.renders()
scene.water.ReleaseGraphicsResources(scene.view.window)
wt.check_equal("resources released: mirrored views in three frames", scene.renders(3), 1)
wt.check_equal("resources released: largest error", scene.error(), 0)


# Pipelines run as often as without the water.
def executions(with_water):
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


dry = executions(False)
wt.check_at_least("pipelines executed without water", dry[-1], 6)
wt.check_equal("pipelines executed by frames", executions(True), dry)
wt.finish()

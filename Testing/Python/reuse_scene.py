# SPDX-License-Identifier: BSD-3-Clause
"""reuse_scene: a scene with one of every kind of thing, all of them seen in the water, and what can change of it."""

import numpy as np
import water_test as wt
import vtkmodules.vtkRenderingOpenGL2 as opengl
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from skip_scenes import blob
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet, vtkPlane
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCompositeDataDisplayAttributes,
    vtkCompositePolyDataMapper,
    vtkGlyph3DMapper,
    vtkImageSlice,
    vtkImageSliceMapper,
    vtkPolyDataMapper,
    vtkTexture,
)
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

    def settle(self):
        """Renders until nothing changes: drawing builds lookup tables, which is a change."""
        self.renders(2)
        assert self.renders() == 0

    def error(self):
        """Of the last picture."""
        self.reflection.SetSkips(Pass.SKIP_NONE)
        right = self.view.picture()
        self.reflection.SetSkips(Pass.SKIP_ALL)
        return int(np.abs(self.picture - right).max())


def in_place(array, add):
    wt.vtk_to_numpy(array)[:] += add
    array.Modified()

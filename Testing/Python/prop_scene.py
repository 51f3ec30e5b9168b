# SPDX-License-Identifier: BSD-3-Clause
"""prop_scene: a scene with props of every kind; prop_changes changes them."""

import numpy as np
import skip_scenes
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkElevationFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkAssembly,
    vtkFollower,
    vtkGlyph3DMapper,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkTexture,
)

SIZE = (120, 90)
SKY = (0.5, 0.6, 0.7)


def colored_box():
    data = wt.box((0, 0, 0), (1, 1, 1.5))
    data.GetPointData().SetScalars(numpy_to_vtk(np.linspace(0, 1, data.GetNumberOfPoints()), deep=True))
    return data


class Pipeline:
    """A ball, the third of three filters."""

    def __init__(self):
        self.ball, self.heights, self.moved = vtkSphereSource(), vtkElevationFilter(), vtkTransformPolyDataFilter()
        self.heights.SetInputConnection(self.ball.GetOutputPort())
        self.heights.SetLowPoint(0, 0, -0.5)
        self.heights.SetHighPoint(0, 0, 0.5)
        self.moved.SetInputConnection(self.heights.GetOutputPort())
        self.transform = vtkTransform()
        self.moved.SetTransform(self.transform)
        self.port = self.moved.GetOutputPort()


class Scene:
    """With an assembly, whose parts VTK changes as it draws them, no reflection is used again. With actors alone
    hardware draws the mirrored view in the middle of the main one."""

    def __init__(self, skips, has_assembly=False, has_actors_alone=False):
        self.view = wt.View(SIZE, SKY)
        self.renderer = self.view.renderer
        wt.add_scene_light(self.renderer, (3, -8, 9))
        self.pipelines = [Pipeline(), Pipeline()]
        self.cut = vtkPlane()
        self.cut.SetNormal(1, 0.3, 0)
        self.actors = []  # that are nothing but actors
        for i in range(6):
            self.add(colored_box() if i % 2 else wt.pyramid((0, 0, 0), 1.5), (2.2 * i - 5.5, 1.5 * (i % 3), 0.8))
        for i, pipeline in enumerate(self.pipelines):
            self.add(None, (4 * i - 2, -2, 0.6)).GetMapper().SetInputConnection(pipeline.port)
        self.add_poster()
        self.add_odd_things(has_assembly)
        if has_actors_alone:
            for prop in (self.follower, self.volume, self.glyphs):
                self.renderer.RemoveViewProp(prop)
        self.water = wt.add_water(self.renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-9, 9, -9, 6), 0.9)
        self.water.GetReflectionPass().SetSkips(skips)
        self.camera = wt.place_camera(self.renderer, (1, -15, 4), (0, 0, 0.3), (1, 60))

    def add(self, data, position):
        actor, mapper = vtkActor(), vtkPolyDataMapper()
        if data:
            mapper.SetInputData(data)
        actor.SetMapper(mapper)
        actor.SetPosition(position)
        self.renderer.AddActor(actor)
        self.actors.append(actor)
        return actor

    def add_poster(self):
        self.image = wt.checker(8)
        self.texture = vtkTexture()
        self.texture.SetInputData(self.image)
        square = vtkPlaneSource()
        self.poster = self.add(None, (0, 3, 1.5))
        self.poster.GetMapper().SetInputConnection(square.GetOutputPort())
        self.poster.SetOrientation(90, 0, 0)
        self.poster.SetScale(2)
        self.poster.SetTexture(self.texture)

    def add_odd_things(self, has_assembly):
        self.parts = [vtkActor(), vtkActor()]
        self.assembly = vtkAssembly()
        for i, part in enumerate(self.parts):
            part.SetMapper(self.actors[i].GetMapper())
            part.SetPosition(0.8 * i, 0, 0)
            part.SetScale(0.5)
            self.assembly.AddPart(part)
        self.assembly.SetPosition(4, -1, 1)
        self.follower = vtkFollower()
        self.follower.SetMapper(self.actors[1].GetMapper())
        self.follower.SetPosition(-4, -2, 0.8)
        self.follower.SetCamera(self.renderer.GetActiveCamera())
        self.volume = skip_scenes.blob()
        self.volume.SetPosition(0, -1, 1.8)
        self.glyphs = vtkActor()
        self.glyphs.SetMapper(vtkGlyph3DMapper())
        self.shape = vtkSphereSource()
        self.shape.SetRadius(0.2)
        self.glyphs.GetMapper().SetInputData(wt.pyramid((0, 0, 0), 1))
        self.glyphs.GetMapper().SetSourceConnection(self.shape.GetOutputPort())
        self.glyphs.SetPosition(6, 1, 1)
        self.stand_in = vtkActor()
        self.stand_in.SetMapper(self.actors[0].GetMapper())
        self.stand_in.GetProperty().SetColor(1, 0, 0)
        self.stand_in.SetPosition(-6, -3, 0.8)
        for prop in (self.follower, self.volume, self.glyphs):
            self.renderer.AddViewProp(prop)
        if has_assembly:
            self.renderer.AddViewProp(self.assembly)

    def props(self):
        found = self.renderer.GetViewProps()
        return [found.GetItemAsObject(i) for i in range(found.GetNumberOfItems())]

    def renew(self):
        """Another renderer with the same things: nothing is remembered of them."""
        old, props = self.renderer, self.props()
        new = vtkRenderer()
        new.SetBackground(SKY)
        new.SetActiveCamera(self.camera)
        for light in [old.GetLights().GetItemAsObject(i) for i in range(old.GetLights().GetNumberOfItems())]:
            new.AddLight(light)
        for prop in props:
            old.RemoveViewProp(prop)
            new.AddViewProp(prop)
        self.view.window.RemoveRenderer(old)
        self.view.window.AddRenderer(new)
        self.renderer = self.view.renderer = new

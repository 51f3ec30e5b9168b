# SPDX-License-Identifier: BSD-3-Clause
"""skip_scenes: scenes with all that a skip may be wrong about; skip_changes changes them."""

import numpy as np
import volumes
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkAssembly,
    vtkBillboardTextActor3D,
    vtkLight,
    vtkTextActor,
    vtkTexture,
)

SIZE = (160, 120)
TERRAIN_CELLS = 90  # 16,200 triangles


def terrain(low, high, height):
    """A mesh of many triangles with heights as scalars and places as texture coordinates."""
    source = vtkPlaneSource()
    source.SetOrigin(low[0], low[1], 0)
    source.SetPoint1(high[0], low[1], 0)
    source.SetPoint2(low[0], high[1], 0)
    source.SetResolution(TERRAIN_CELLS, TERRAIN_CELLS)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(source.GetOutputPort())
    triangles.Update()
    data = vtkPolyData()
    data.DeepCopy(triangles.GetOutput())
    points = vtk_to_numpy(data.GetPoints().GetData())
    points[:, 2] = height(points[:, 0], points[:, 1])
    data.GetPointData().SetScalars(numpy_to_vtk(points[:, 2].copy(), deep=True))
    return data


def blob():
    """A small volume of bytes."""
    size = 12
    axis = np.linspace(-1, 1, size)
    distance = np.sqrt(sum(part**2 for part in np.meshgrid(axis, axis, axis)))
    image = vtkImageData()
    image.SetDimensions(size, size, size)
    image.SetSpacing(*[2.0 / (size - 1)] * 3)
    image.SetOrigin(-1, -1, -1)
    values = np.clip(255 * (1 - distance), 0, 255).astype(np.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
    return volumes.ray_cast(image, 0.2, ((0, 0.2, 0.4, 1), (255, 1, 0.9, 0.4)), ((20, 0), (255, 0.5)))


class Scene:
    """kind: "one plane": two calm sheets; "levels": a pool and a sheet with waves besides;
    "clear": two sheets of a wind sea that is seen through, with sun, shadows and caustics;
    "fall": a pool, a sheet of water that falls into it and one with waves, which show the scene in each other."""

    def __init__(self, kind, skips, samples=0, size=SIZE):
        self.kind, self.skips = kind, skips
        self.view = wt.View(size, samples=samples)
        self.renderer = self.view.renderer
        if kind == "one plane":
            self.renderer.GetCullers().RemoveAllItems()  # so that water out of view is ours to find
        self.camera = self.renderer.GetActiveCamera()
        self.extras = []
        self.sun = self.add_light((8, -10, 20))
        self.add_land()
        self.add_things()
        self.waters = []
        self.add_waters()
        for water in self.waters:
            water.GetReflectionPass().SetSkips(skips)
        self.place_camera((3, -17, 5), (0, 0, 0))

    def place_camera(self, position, target, roll=0.0, angle=40.0):
        camera = self.camera
        camera.ParallelProjectionOff()
        camera.SetPosition(position)
        camera.SetFocalPoint(target)
        camera.SetViewUp((0, 0, 1) if abs(position[0] - target[0]) + abs(position[1] - target[1]) > 0.1 else (0, 1, 0))
        camera.SetRoll(camera.GetRoll() + roll)
        camera.SetViewAngle(angle)
        camera.SetClippingRange(0.1, 120)

    def add_light(self, position):
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(position)
        light.SetFocalPoint(0, 0, 0)
        self.renderer.AddLight(light)
        return light

    def add_land(self):
        hills = terrain((-12, 4), (12, 16), lambda x, y: -1.5 + 5 * np.exp(-((y - 10) / 4) ** 2) * (1.3 + np.sin(x)))
        self.hills = wt.add_actor(self.renderer, hills, (1, 1, 1), specular=0.2)
        self.table = vtkLookupTable()
        self.table.SetHueRange(0.1, 0.45)
        self.table.SetRange(-1.5, 9)
        mapper = self.hills.GetMapper()
        mapper.ScalarVisibilityOn()
        mapper.SetLookupTable(self.table)
        mapper.UseLookupTableScalarRangeOn()
        bed = terrain((-14, -14), (14, 6), lambda x, y: -2.2 + 0.5 * np.sin(x) * np.cos(y) + 3 * np.exp(-((x + 6) ** 2 + (y - 1) ** 2)))
        self.bed = wt.add_actor(self.renderer, bed, (0.6, 0.5, 0.3))

    def add_things(self):
        self.things = []
        for number, (x, y, z) in enumerate(((-2, 1, 0.4), (1, -3, 0.2), (4, 2, 2.5), (-5, -2, -1.2), (6, -5, 0.5),
                                            (0, 3, 1.5), (11, 0, 0.6), (300, 5, 2))):
            shape = wt.box((0, 0, 0), (1, 1.2, 2.2)) if number % 2 else wt.sphere((0, 0, 0), 0.9, 16)
            color = (0.9 - 0.1 * number, 0.2 + 0.1 * number, 0.3)
            thing = wt.add_actor(self.renderer, shape, color, specular=0.3, opacity=0.5 if number in (1, 5) else 1.0)
            thing.SetPosition(x, y, z)
            self.things.append(thing)
        self.parts = vtkAssembly()
        for offset in (-0.8, 0.8):
            part = vtkActor()
            part.SetMapper(self.things[1].GetMapper())
            part.GetProperty().SetColor(0.2, 0.8, 0.8)
            part.SetPosition(offset, 0, 0)
            part.SetScale(0.4)
            self.parts.AddPart(part)
        self.parts.SetPosition(-4, 3, 0.9)
        self.renderer.AddActor(self.parts)
        self.image = wt.checker(8)
        texture = vtkTexture()
        texture.SetInputData(self.image)
        square = vtkPlaneSource()
        square.SetOrigin(-3, 0, 0)
        square.SetPoint1(3, 0, 0)
        square.SetPoint2(-3, 0, 2)
        square.Update()
        self.poster = wt.add_actor(self.renderer, square.GetOutput(), (1, 1, 1), lit=False)
        self.poster.SetPosition(3, 5, 0.3)
        self.poster.SetTexture(texture)
        self.volume = blob()
        self.volume.SetPosition(-1, -4, 1.4)
        self.renderer.AddVolume(self.volume)
        self.wall = wt.add_actor(self.renderer, wt.box((0, 0, 0), (1, 1, 0.01)), (0.5, 0.4, 0.4), lit=False)
        self.wall.VisibilityOff()
        wt.leave_out(self.wall)
        self.renderer.AddActor(vtkActor())  # no mapper: empty
        empty = wt.add_actor(self.renderer, vtkPolyData(), (1, 1, 1))
        self.extras.append(empty)
        text = vtkTextActor()
        text.SetInput("overlay")
        self.renderer.AddActor(text)
        label = vtkBillboardTextActor3D()
        label.SetInput("label")
        label.SetPosition(2, 0, 1)
        self.renderer.AddActor(label)

    def add_waters(self):
        def add(level, sheet, reflectance=None):
            water = wt.add_water(self.renderer, wt.plane((0, 0, level), (0, 0, 1)), sheet, reflectance)
            self.waters.append(water)
            return water

        if self.kind == "clear":
            look = add(0, (-13, 2, -13, 13)).GetWaterProperty()
            add(0, (2, 13, -13, 13)).SetWaterProperty(look)
            look.SetPreset("lake")
            look.SetAbsorption(0.2, 0.1, 0.05)
            look.SetScattering(0.01, 0.01, 0.01)
            look.SetCaustics(0.8)
            look.ShadowsOn()
            look.SetFoamDepth(0.2)
            return
        if self.kind == "fall":
            add(0, (-9, 9, -9, 5), 0.9)
            for origin, normal, sheet in (((0, 5, 0), (0, -1, 0.2), (-5, 3, -2, 3)),
                                          ((8, 0, 0), (-1, -0.3, 0.3), (-3, 3, -1, 4))):
                self.waters.append(wt.add_water(self.renderer, wt.plane(origin, normal), sheet, 0.7))
            self.waters[2].GetWaterProperty().AddWave(0.01, 0.6, 20.0)
            for water in self.waters:
                water.GetReflectionPass().SecondaryReflectionsOn()
            return
        add(0, (-9, 0, -9, 9), 0.9)
        add(0, (0, 9, -9, 9), 0.9)
        if self.kind == "levels":
            add(1.2, (-8, -4, -8, -4))
            basin = wt.add_actor(self.renderer, wt.box((-6, -6, 0.5), (4.4, 4.4, 1.2)), (0.4, 0.4, 0.5))
            self.things.append(basin)
            look = add(0, (9.2, 14, -9, 9)).GetWaterProperty()
            look.AddWave(0.05, 2.0, 20.0)
            look.AddWave(0.02, 0.9, 100.0)

    def decisions(self):
        return [water.GetReflectionPass().GetDecision() for water in self.waters]

    def record_views(self):
        """A list that says which views of a frame show the bed, in the order they are drawn."""
        views = []
        self.bed.GetMapper().AddObserver("StartEvent", lambda mapper, event: views.append(
            "main" if self.renderer.GetActiveCamera() is self.camera else "mirrored"))
        return views

    def reasons(self):
        return [water.GetReflectionPass().GetDecisionAsString() for water in self.waters]

    def picture(self):
        return self.view.picture()

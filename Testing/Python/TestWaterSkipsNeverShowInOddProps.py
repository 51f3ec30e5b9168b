# SPDX-License-Identifier: BSD-3-Clause
"""Skips do not show in props that are not what their bounds, their order or their data say: each alone,
picture by picture equal to that with all skips off."""

import numpy as np
import pytest
import skip_scenes
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkAssembly, vtkPointGaussianMapper, vtkPolyDataMapper, vtkTexture
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLSphereMapper
from vtkwater import vtkWaterReflectionPass as Pass

SIZE = (200, 150)
POND = (-2, 2, -2, 2)
LAKE = (-14, 14, -14, 14)


def land(first=0, last=20):
    """Rows of triangles, from one y to the other: from the eye on, or towards it."""
    return skip_scenes.terrain((-14, first), (14, last), lambda x, y: 0.5 + np.sin(x) * np.cos(y) + 0.1 * y)


def add(renderer, mapper, data):
    mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)
    return actor


def blending(renderer):
    """VTK blends in the opaque pass what is forced into it: the order shows."""
    for i in range(8):
        box = wt.box((0, 8 - 2 * i, 2), (6 - 0.3 * i, 0.5, 3))
        wt.add_actor(renderer, box, (i / 8, 0.5, 1 - i / 8), opacity=0.4).ForceOpaqueOn()


def layers(renderer, *rows):
    """Where two triangles are equally far, the later one is seen."""
    both = vtkAppendPolyData()
    for shade in (0.0, 1.0):
        layer = land(*rows)
        layer.GetPointData().SetScalars(numpy_to_vtk(np.full(layer.GetNumberOfPoints(), shade), deep=True))
        both.AddInputData(layer)
    both.Update()
    add(renderer, vtkPolyDataMapper(), both.GetOutput())


def meshes(renderer):
    """So it is with two meshes."""
    for color in ((1, 0, 0), (0, 1, 0)):
        wt.add_actor(renderer, land(20, 0), color)


def glass(renderer):
    """A mesh that blends, and comes nearer."""
    wt.add_actor(renderer, land(20, 0), (0.6, 0.5, 0.3), opacity=0.4).ForceOpaqueOn()


def fence(renderer):
    """So does one whose texture is glass in places."""
    actor = wt.add_actor(renderer, land(20, 0), (1, 1, 1))
    image = vtkImageData()
    image.SetDimensions(16, 16, 1)
    texels = np.full((256, 4), 200, np.uint8)
    texels[:, 3] = np.where(np.arange(256) % 3, 255, 90)
    image.GetPointData().SetScalars(numpy_to_vtk(texels, deep=True))
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.RepeatOn()
    texture.UseSRGBColorSpaceOn()
    actor.GetProperty().SetTexture("albedoTex", texture)
    actor.GetProperty().SetInterpolationToPBR()


def displaced(renderer):
    """A vertex shader moves a large mesh to where its pieces are not."""
    actor = wt.add_actor(renderer, land(), (0.6, 0.5, 0.3))
    actor.GetShaderProperty().AddVertexShaderReplacement(
        "//VTK::PositionVC::Impl", True,
        "vec4 lifted = vec4(vertexMC.xy * vec2(0.5, 1.0), vertexMC.z + 3.0, 1.0);\n"
        "  gl_Position = MCDCMatrix * lifted;\n  vertexVCVSOutput = MCVCMatrix * lifted;\n", False)


def dots(renderer, mapper, cells, width_px=30):
    """Beside what the pond reflects, but for their width."""
    x = np.concatenate([np.linspace(-3.4, -2.2, 9), np.linspace(2.2, 3.4, 9)])
    data = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.stack([x, 0 * x, 0 * x + 0.4], axis=1), deep=True))
    data.SetPoints(points)
    for number in range(len(x)):
        part = vtkPolyData()
        own = vtkPoints()
        own.InsertNextPoint(points.GetPoint(number))
        own.InsertNextPoint(points.GetPoint(number)[0], 0, 0.9)
        part.SetPoints(own)
        array = vtkCellArray()
        array.InsertNextCell(2 if cells == "lines" else 1, (0, 1)[: 2 if cells == "lines" else 1])
        (part.SetLines if cells == "lines" else part.SetVerts)(array)
        actor = add(renderer, mapper(), part)
        actor.GetProperty().SetColor(1, number / len(x), 0)
        actor.GetProperty().SetPointSize(width_px)
        actor.GetProperty().SetLineWidth(width_px)


def splats():
    mapper = vtkPointGaussianMapper()
    mapper.SetScaleFactor(0.5)
    mapper.EmissiveOff()
    return mapper


def spheres():
    mapper = vtkOpenGLSphereMapper()
    mapper.SetRadius(2.0)
    return mapper


def assembled(renderer):
    """A part's splats are those of the whole."""
    dots(renderer, spheres, "points", 1)
    for actor in list(renderer.GetActors()):
        renderer.RemoveActor(actor)
        assembly = vtkAssembly()
        assembly.AddPart(actor)
        renderer.AddActor(assembly)


SCENES = {
    "blends in the opaque pass": (LAKE, blending),
    "coincident layers of a mesh": (LAKE, layers),
    "coincident layers that come nearer": (LAKE, lambda renderer: layers(renderer, 20, 0)),
    "coincident meshes": (LAKE, meshes),
    "blending mesh": (LAKE, glass),
    "texture with alpha": (LAKE, fence),
    "vertex shader of its own": (LAKE, displaced),
    "wide points": (POND, lambda renderer: dots(renderer, vtkPolyDataMapper, "points")),
    "wide lines": (POND, lambda renderer: dots(renderer, vtkPolyDataMapper, "lines")),
    "splats": (POND, lambda renderer: dots(renderer, splats, "points", 1)),
    "spheres of points": (POND, lambda renderer: dots(renderer, spheres, "points", 1)),
    "spheres in assemblies": (POND, assembled),
}


class Scene:
    def __init__(self, fill, sheet, skips):
        self.view = wt.View(SIZE)
        fill(self.view.renderer)
        self.water = wt.add_water(self.view.renderer, wt.plane((0, 0, 0), (0, 0, 1)), sheet, 1.0)
        self.water.GetReflectionPass().SetSkips(skips)
        wt.place_camera(self.view.renderer, (0, -14, 6), (0, 0, 0), (0.5, 80))

    def pictures(self):
        for _ in range(6):
            self.view.renderer.GetActiveCamera().Azimuth(4)
            yield self.view.picture()


@pytest.mark.parametrize("name", SCENES)
def test_skips_do_not_show_in(name):
    """A walk round the prop shows the same with all skips as with none, while the reflection is drawn."""
    sheet, fill = SCENES[name]
    full = list(Scene(fill, sheet, Pass.SKIP_NONE).pictures())
    scene = Scene(fill, sheet, Pass.SKIP_ALL)
    errors = [wt.difference(one, other) for one, other in zip(scene.pictures(), full)]
    wt.check_equal(f"{name}: decision", wt.decision_of(scene.water), "RENDERED")
    wt.check_at_most(f"{name}: largest error", max(errors), 1)


def test_front_stays_when_both_sides_are_culled():
    """Of both cullings VTK takes that of back faces: water that is seen from above stays as it is."""
    scene = Scene(blending, LAKE, Pass.SKIP_ALL)
    right = scene.view.picture()
    scene.water.GetProperty().BackfaceCullingOn()
    scene.water.GetProperty().FrontfaceCullingOn()
    wt.check_at_most("both cullings: largest error", wt.difference(scene.view.picture(), right), 1)
    wt.check_equal("both cullings: decision", wt.decision_of(scene.water) in ("RENDERED", "REUSED"), True)

# SPDX-License-Identifier: BSD-3-Clause
"""Large meshes whose pixels are not where their corners say, or have holes that the data does not
show, neither hide triangles nor are drawn in another order; what is left out changes no picture."""

import functools
import os

import numpy as np
import skip_scenes
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane
from vtkmodules.vtkRenderingCore import VTK_RESOLVE_POLYGON_OFFSET, vtkMapper, vtkTexture
from vtkwater import vtkWaterReflectionPass as Pass

SIZE = (300, 225)


def ridges(low, high):
    return skip_scenes.terrain(low, high, lambda x, y: 2 + np.sin(2 * x) * np.cos(2 * y) + 0.3 * np.sin(9 * x))


def hills():
    return skip_scenes.terrain((-14, 6), (14, 22), lambda x, y: 3 + 1.5 * np.sin(1.3 * x) * np.cos(y))


class Scene:
    """Two large meshes, of which the first hides parts of the second and of itself."""

    def __init__(self, skips, change, runs_nearer=False):
        self.view = wt.View(SIZE)
        renderer = self.view.renderer
        ends = ((14, 20), (-14, 5)) if runs_nearer else ((-14, 5), (14, 20))  # in the order of its triangles
        self.first = wt.add_actor(renderer, ridges(*ends), (0.8, 0.3, 0.2))
        if not runs_nearer:  # alone, such a mesh is drawn in the other order
            self.second = wt.add_actor(renderer, hills(), (0.2, 0.5, 0.9))
        self.water = wt.add_water(renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-14, 14, -14, 14), 1.0)
        self.water.GetReflectionPass().SetSkips(skips)
        self.camera = wt.place_camera(renderer, (0, -14, 4), (0, 0, 0), (0.5, 80))
        change(self)

    def pictures(self, before=lambda scene: None):
        for _ in range(4):
            self.camera.Azimuth(3)
            yield self.view.picture()
            before(self)


def check(name, change, **settings):
    """Compares with pictures for which nothing is left out, in software and, as far as it can be had, as on a GPU."""
    before = settings.pop("before", lambda scene: None)
    for is_software in (1, 0):
        os.environ["VTK_WATER_SOFTWARE"] = str(is_software)
        full = list(Scene(Pass.SKIP_NONE, change, **settings).pictures(before))
        scene = Scene(Pass.SKIP_ALL, change, **settings)
        errors = [wt.difference(one, other) for one, other in zip(scene.pictures(before), full)]
        title = f"{name}, {'software' if is_software else 'GPU'}"
        wt.check_equal(f"{title}: decision", wt.decision_of(scene.water), "RENDERED")
        wt.check_at_most(f"{title}: largest error", max(errors), 1)


# Where coincident surfaces are told apart, each pixel is further or nearer than its triangle, the
# more the steeper this is; and what would be further than all is as far as what the map is cleared with.
vtkMapper.SetResolveCoincidentTopology(VTK_RESOLVE_POLYGON_OFFSET)
for parameters in ((20, 0), (1, 60), (-1, -1)):
    vtkMapper.SetResolveCoincidentTopologyPolygonOffsetParameters(*parameters)
    check(f"offsets {parameters}", lambda scene: None)
    check(
        f"offsets {parameters}, the second's the other way",
        lambda scene: scene.second.GetMapper().SetRelativeCoincidentTopologyPolygonOffsetParameters(
            -2 * parameters[0], -2 * parameters[1]
        ),
    )
vtkMapper.SetResolveCoincidentTopologyPolygonOffsetParameters(0, 3000)
check("offset to the largest depth", lambda scene: None, runs_nearer=True)
vtkMapper.SetResolveCoincidentTopologyPolygonOffsetParameters(2, 2)  # VTK's own
vtkMapper.SetResolveCoincidentTopologyToDefault()

# The user's own fragment shader may do anything to a pixel.
SHADER = """//VTK::System::Dec
//VTK::Output::Dec
void main()
{
  gl_FragData[0] = vec4(1.0, 0.3, 0.2, 1.0);
  if (mod(gl_FragCoord.x, 8.0) < 4.0) { BODY }
}
"""
for name, body, runs_nearer in (("holes", "discard;", False), ("alpha", "gl_FragData[0].a = 0.3;", True)):
    code = SHADER.replace("BODY", body)
    check(f"shader with {name}", lambda scene: scene.first.GetShaderProperty().SetFragmentShaderCode(code), runs_nearer=runs_nearer)
code = SHADER.replace("if (mod(gl_FragCoord.x, 8.0) < 4.0) { BODY }", "gl_FragDepth = 0.9999;")
check("shader with depths", lambda scene: scene.first.GetShaderProperty().SetFragmentShaderCode(code))


def add_holes(scene):
    """A texture whose colours have no alpha, and get one by a table."""
    image = vtkImageData()
    image.SetDimensions(8, 8, 1)
    image.AllocateScalars(VTK_UNSIGNED_CHAR, 3)
    vtk_to_numpy(image.GetPointData().GetScalars())[:] = 4 * np.arange(64)[:, None]
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    table.SetRange(0, 255)
    table.Build()
    for i in range(256):
        table.SetTableValue(i, i / 255, 0.5, 0.5, 0.0 if i % 16 < 8 else 1.0)
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.SetLookupTable(table)
    texture.SetColorModeToMapScalars()
    data = scene.first.GetMapper().GetInput()
    places = vtk_to_numpy(data.GetPoints().GetData())[:, :2]
    data.GetPointData().SetTCoords(numpy_to_vtk(np.ascontiguousarray(0.2 * places), deep=True))
    scene.first.SetTexture(texture)


check("texture with a table", add_holes)


def add_clipping(scene):
    """The user's own clipping plane cuts the first mesh away where it is high."""
    plane = vtkPlane()
    plane.SetOrigin(0, 0, 1.6)
    plane.SetNormal(0, 0, -1)
    scene.first.GetMapper().AddClippingPlane(plane)


# Triangles that are not drawn hide nothing.
check("back faces culled", lambda scene: scene.first.GetProperty().BackfaceCullingOn())
check("front faces culled", lambda scene: scene.first.GetProperty().FrontfaceCullingOn())
check("clipping plane", add_clipping)


def write_points(scene):
    """Writes into the points, and does not say so: VTK still draws the old ones."""
    points = vtk_to_numpy(scene.first.GetMapper().GetInput().GetPoints().GetData())
    points[:, 2] += 0.3 * np.sin(points[:, 0])


check("points written in place", lambda scene: None, before=write_points)

# A scene in UTM metres, and parts that are placed there or scaled, are as good as one at the origin: VTK draws
# large and far meshes relative to their middle, and so is what single precision may do to them.
UTM = (500000.0, 4500000.0, 120.0)


def move(scene, offset, in_data, unit):
    """To an offset, by the data or by the actors' matrices; the data in its unit (m)."""
    for actor in (scene.first, scene.second):
        data = actor.GetMapper().GetInput()
        points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
        moved = vtkPoints()
        moved.SetData(numpy_to_vtk((points + in_data * np.array(offset)) / unit, deep=True))
        data.SetPoints(moved)
        actor.SetScale(unit, unit, unit)
        if not in_data:
            actor.SetPosition(*offset)
    scene.water.GetPlane().SetOrigin(*offset)
    scene.camera.SetPosition(*np.add(scene.camera.GetPosition(), offset))
    scene.camera.SetFocalPoint(*np.add(scene.camera.GetFocalPoint(), offset))


def triangles_of(change):
    os.environ["VTK_WATER_SOFTWARE"] = "1"
    scene = Scene(Pass.SKIP_ALL, change)
    scene.water.GetReflectionPass().InstrumentationOn()
    list(scene.pictures())
    return scene.water.GetReflectionPass().GetNumberOfTrianglesReflected()


near = triangles_of(lambda scene: None)
for name, in_data, unit in (("data", True, 1.0), ("matrices", False, 1.0), ("millimetres", True, 1e-3),
                            ("matrices, kilometres", False, 1e3)):
    change = functools.partial(move, offset=UTM, in_data=in_data, unit=unit)
    check(f"UTM by {name}", change)
    wt.check_at_most(f"UTM by {name}: triangles to {near} at the origin", triangles_of(change) / near, 1.02)

wt.finish()

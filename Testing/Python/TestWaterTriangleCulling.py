# SPDX-License-Identifier: BSD-3-Clause
"""Large meshes whose pixels are not where their corners say, or have holes that the data does not
show, neither hide triangles nor are drawn in another order; what is left out changes no picture."""

import functools

import numpy as np
import pytest
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


PLATFORMS = {"software": "1", "GPU": "0"}  # a GPU as far as it can be had: values of VTK_WATER_SOFTWARE


@pytest.fixture(params=PLATFORMS)
def platform(request, monkeypatch):
    """Whether triangles are left out as in software or as on a GPU; its name."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", PLATFORMS[request.param])
    return request.param


def check(title, change, before=lambda scene: None, **settings):
    """Compares with pictures for which nothing is left out."""
    full = list(Scene(Pass.SKIP_NONE, change, **settings).pictures(before))
    scene = Scene(Pass.SKIP_ALL, change, **settings)
    errors = [wt.difference(one, other) for one, other in zip(scene.pictures(before), full)]
    wt.check_equal(f"{title}: decision", wt.decision_of(scene.water), "RENDERED")
    wt.check_at_most(f"{title}: largest error", max(errors), 1)


# Where coincident surfaces are told apart, each pixel is further or nearer than its triangle, the
# more the steeper this is; and what would be further than all is as far as what the reflection texture is cleared
# with.
@pytest.fixture
def resolve_by_offset():
    """A function that moves all polygons by a factor and by units; afterwards they are as VTK has them."""
    vtkMapper.SetResolveCoincidentTopology(VTK_RESOLVE_POLYGON_OFFSET)
    yield vtkMapper.SetResolveCoincidentTopologyPolygonOffsetParameters
    vtkMapper.SetResolveCoincidentTopologyPolygonOffsetParameters(2, 2)  # VTK's own
    vtkMapper.SetResolveCoincidentTopologyToDefault()


some_offsets = pytest.mark.parametrize("offsets", ((20, 0), (1, 60), (-1, -1)), ids=str)


@some_offsets
def test_offsets_hide_no_triangle(offsets, resolve_by_offset, platform):
    """Polygons that are drawn further or nearer than they are do not show that triangles are left out."""
    resolve_by_offset(*offsets)
    check(f"offsets {offsets}, {platform}", lambda scene: None)


@some_offsets
def test_offsets_of_one_mesh_hide_no_triangle(offsets, resolve_by_offset, platform):
    """Nor do those of two meshes of which one goes further and the other nearer."""
    resolve_by_offset(*offsets)

    def other_way(scene):
        mapper = scene.second.GetMapper()
        mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(-2 * offsets[0], -2 * offsets[1])

    check(f"offsets {offsets}, the second's the other way, {platform}", other_way)


def test_offset_to_the_largest_depth_hides_no_triangle(resolve_by_offset, platform):
    """Polygons as far as what the reflection texture is cleared with are drawn in the right order."""
    resolve_by_offset(0, 3000)
    check(f"offset to the largest depth, {platform}", lambda scene: None, runs_nearer=True)


# The user's own fragment shader may do anything to a pixel.
SHADER = """//VTK::System::Dec
//VTK::Output::Dec
void main()
{
  gl_FragData[0] = vec4(1.0, 0.3, 0.2, 1.0);
  BODY
}
"""
IN_STRIPES = "if (mod(gl_FragCoord.x, 8.0) < 4.0) { BODY }"
# what is done, and whether the mesh's triangles come nearer
BODIES = {
    "holes": (IN_STRIPES.replace("BODY", "discard;"), False),
    "alpha": (IN_STRIPES.replace("BODY", "gl_FragData[0].a = 0.3;"), True),
    "depths": ("gl_FragDepth = 0.9999;", False),
}


@pytest.mark.parametrize("kind", BODIES)
def test_fragment_shader_of_the_users_hides_no_triangle(kind, platform):
    """A mesh whose fragment shader makes holes, blends or sets depths hides nothing, and is drawn in its order."""
    body, runs_nearer = BODIES[kind]
    code = SHADER.replace("BODY", body)
    check(f"shader with {kind}, {platform}",
          lambda scene: scene.first.GetShaderProperty().SetFragmentShaderCode(code), runs_nearer=runs_nearer)


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


def test_texture_whose_table_has_holes_hides_no_triangle(platform):
    """A mesh hides nothing where the table of its texture makes it transparent."""
    check(f"texture with a table, {platform}", add_holes)


def add_clipping(scene):
    """The user's own clipping plane cuts the first mesh away where it is high."""
    plane = vtkPlane()
    plane.SetOrigin(0, 0, 1.6)
    plane.SetNormal(0, 0, -1)
    scene.first.GetMapper().AddClippingPlane(plane)


CUTS = {
    "back faces culled": lambda scene: scene.first.GetProperty().BackfaceCullingOn(),
    "front faces culled": lambda scene: scene.first.GetProperty().FrontfaceCullingOn(),
    "clipping plane": add_clipping,
}


@pytest.mark.parametrize("name", CUTS)
def test_triangles_that_are_not_drawn_hide_nothing(name, platform):
    """Triangles that are culled or clipped away do not hide others."""
    check(f"{name}, {platform}", CUTS[name])


def write_points(scene):
    """Writes into the points, and does not say so: VTK still draws the old ones."""
    points = vtk_to_numpy(scene.first.GetMapper().GetInput().GetPoints().GetData())
    points[:, 2] += 0.3 * np.sin(points[:, 0])


def test_points_that_vtk_does_not_know_of_hide_nothing(platform):
    """What counts is the points that VTK draws, and not what was written into the array since."""
    check(f"points written in place, {platform}", lambda scene: None, before=write_points)


# A scene in UTM metres, and parts that are placed there or scaled, are as good as one at the origin: VTK draws
# large and far meshes relative to their middle, and so is what single precision may do to them.
UTM = (500000.0, 4500000.0, 120.0)
# by what they are moved: whether it is in the data, and the data's unit in metres
MOVES = {
    "data": (True, 1.0),
    "matrices": (False, 1.0),
    "millimetres": (True, 1e-3),
    "matrices, kilometres": (False, 1e3),
}


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


def moved_to_utm(name):
    in_data, unit = MOVES[name]
    return functools.partial(move, offset=UTM, in_data=in_data, unit=unit)


@pytest.mark.parametrize("name", MOVES)
def test_far_scene_shows_no_triangle_left_out(name, platform):
    """A scene in UTM coordinates shows the same with triangles left out as with all."""
    check(f"UTM by {name}, {platform}", moved_to_utm(name))


def triangles_of(change):
    scene = Scene(Pass.SKIP_ALL, change)
    scene.water.GetReflectionPass().InstrumentationOn()
    list(scene.pictures())
    return scene.water.GetReflectionPass().GetNumberOfTrianglesReflected()


@pytest.mark.parametrize("name", MOVES)
def test_far_scene_leaves_as_many_triangles_out(name, monkeypatch):
    """A scene in UTM coordinates draws hardly more triangles than the same at the origin."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", PLATFORMS["software"])
    near = triangles_of(lambda scene: None)
    far = triangles_of(moved_to_utm(name))
    wt.check_at_most(f"UTM by {name}: triangles to {near} at the origin", far / near, 1.02)

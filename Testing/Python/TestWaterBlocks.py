# SPDX-License-Identifier: BSD-3-Clause
"""Composite data is reflected block by block: blocks that no water shows are left out of the mirrored view.
The picture, the mapper and its attributes stay as they are."""

import functools

import numpy as np
import pytest
import water_test as wt
from TestWaterLarge import mapper_of_blocks
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPartitionedDataSetCollection, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkAssembly, vtkCompositeDataDisplayAttributes, vtkTexture
from vtkwater import vtkWaterReflectionPass as Pass

SIZE = (200, 150)
POND = (-2, 2, -2, 2)
LAKE = (-14, 14, -14, 14)
ACROSS = 12  # blocks, each way
EDGE = 28 / ACROSS
CELLS = 4  # of a block, each way
BESIDE = *np.linspace(-3.4, -2.2, 9), *np.linspace(2.2, 3.4, 9)  # the pond


def tile(i, j, offset=(0, 0, 0)):
    """A block of land that lies over the water's level and under it."""
    plane = vtkPlaneSource()
    x, y = EDGE * i - 14, EDGE * j - 14
    plane.SetOrigin(x, y, 0)
    plane.SetPoint1(x + EDGE, y, 0)
    plane.SetPoint2(x, y + EDGE, 0)
    plane.SetResolution(CELLS, CELLS)
    plane.Update()
    data = vtkPolyData()
    data.DeepCopy(plane.GetOutput())
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for number in range(data.GetNumberOfPoints()):
        x, y, _ = data.GetPoint(number)
        place = x, y, 1.2 * np.sin(0.8 * x) * np.cos(0.7 * y) + 0.2
        points.InsertNextPoint(*(a + b for a, b in zip(place, offset)))
    data.SetPoints(points)
    data.GetPointData().SetNormals(None)
    return data


def tiles(**settings):
    return [tile(i, j, **settings) for j in range(ACROSS) for i in range(ACROSS)]


@functools.cache
def kept():
    """The same blocks for two scenes: VTK 9.1 draws blocks in the order of their addresses."""
    return tiles()


def add(renderer, blocks, kind=vtkPartitionedDataSetCollection):
    data = kind()
    for number, block in enumerate(blocks):
        data.SetPartition(number, 0, block) if kind is vtkPartitionedDataSetCollection else data.SetBlock(number, block)
    mapper = mapper_of_blocks()
    mapper.SetInputDataObject(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(1, 0.8, 0.5)
    renderer.AddActor(actor)
    return actor


def attributes(renderer):
    """Colours, opacities and visibilities of blocks; their numbers count the nodes of the tree."""
    mapper = add(renderer, tiles(), vtkMultiBlockDataSet).GetMapper()
    look = vtkCompositeDataDisplayAttributes()
    mapper.SetCompositeDataDisplayAttributes(look)
    for number in range(1, ACROSS * ACROSS + 1):
        mapper.SetBlockColor(number, (number % 5 / 4, number % 7 / 6, 0.3))
        if number % 11 == 0:
            mapper.SetBlockOpacity(number, 0.5)
        if number % 13 == 0:
            mapper.SetBlockVisibility(number, False)


def cell_data(renderer):
    """The shader counts triangles to find their colours: of each block on its own."""
    blocks = tiles()
    for number, block in enumerate(blocks):
        count = block.GetNumberOfCells()
        block.GetCellData().SetScalars(numpy_to_vtk((np.arange(count) * 7 + number) % count / count, deep=True))
    mapper = add(renderer, blocks).GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetScalarModeToUseCellData()


def several_kinds(renderer):
    """Blocks with normals, with scalars and with neither are drawn by different parts of the mapper."""
    blocks = tiles()
    for block in blocks[::3]:
        block.GetPointData().SetNormals(numpy_to_vtk(np.tile([0.0, 0, 1], (block.GetNumberOfPoints(), 1)), deep=True))
    for block in blocks[1::3]:
        block.GetPointData().SetScalars(numpy_to_vtk(np.arange(block.GetNumberOfPoints()) / 30, deep=True))
    add(renderer, blocks).GetMapper().ScalarVisibilityOn()


def far_off(renderer):
    actor = add(renderer, tiles(offset=(5e5, 4e6, 300)))
    actor.SetPosition(-5e5, -4e6, -300)


def turned(renderer):
    actor = add(renderer, tiles())
    actor.SetScale(0.7, 1.3, 1.1)
    actor.RotateZ(30)
    actor.AddPosition(2, -1, 0.1)


def sharing(renderer):
    """Two actors, and the parts of an assembly, draw one mapper's blocks in different places."""
    mapper = add(renderer, tiles()).GetMapper()
    assembly = vtkAssembly()
    for x, y in ((-5, 9), (6, -7), (3, 12)):
        part = vtkActor()
        part.SetMapper(mapper)
        part.SetScale(0.3, 0.3, 2)
        part.SetPosition(x, y, 0.5)
        assembly.AddPart(part)
    renderer.AddActor(assembly)
    other = vtkActor()
    other.SetMapper(mapper)
    other.SetPosition(0, 20, 1)
    renderer.AddActor(other)


def one_block_twice(renderer):
    block = tile(3, 9)
    add(renderer, [*tiles(), block, block])


def lines(renderer, cells=2, width_px=30):
    """Beside what the pond reflects, but for their width."""
    blocks = []
    for x in BESIDE:
        block = vtkPolyData()
        points = vtkPoints()
        points.InsertNextPoint(x, 0, 0.4)
        points.InsertNextPoint(x, 0, 0.9)
        block.SetPoints(points)
        array = vtkCellArray()
        array.InsertNextCell(cells, (0, 1)[:cells])
        (block.SetLines if cells == 2 else block.SetVerts)(array)
        blocks.append(block)
    actor = add(renderer, blocks)
    actor.GetProperty().SetPointSize(width_px)
    actor.GetProperty().SetLineWidth(width_px)


@functools.cache
def kept_posts():
    """Triangles beside what the pond reflects."""
    return [wt.box((x, 0, 0.6), (0.05, 0.05, 0.6)) for x in BESIDE]


def posts(renderer):
    return add(renderer, kept_posts())


def as_wires(renderer):
    look = posts(renderer).GetProperty()
    look.SetRepresentationToWireframe()
    look.SetLineWidth(30)


def as_points(renderer):
    look = posts(renderer).GetProperty()
    look.SetRepresentationToPoints()
    look.SetPointSize(30)


def with_vertices(renderer):
    look = posts(renderer).GetProperty()
    look.VertexVisibilityOn()
    look.SetPointSize(30)


def with_edges(renderer):
    """They reach beyond their triangles; few, so that none hides another."""
    places = [(2.6, 0), (-2.6, 0), (0, 2.6), (2.2, 2.2), (-2.2, 2.2)]
    look = add(renderer, [wt.box((*place, 0.6), (0.05, 0.05, 0.6)) for place in places]).GetProperty()
    look.EdgeVisibilityOn()
    look.SetLineWidth(80)


def displaced(renderer):
    """A vertex shader moves the blocks to where their bounds are not."""
    add(renderer, tiles()).GetShaderProperty().AddVertexShaderReplacement(
        "//VTK::PositionVC::Impl", True,
        "vec4 lifted = vec4(vertexMC.xy * vec2(0.2, 1.0), vertexMC.z + 3.0, 1.0);\n"
        "  gl_Position = MCDCMatrix * lifted;\n  vertexVCVSOutput = MCVCMatrix * lifted;\n", False)


def glass(renderer):
    """Blocks that blend in the opaque pass: their order shows."""
    actor = add(renderer, kept())
    actor.GetProperty().SetOpacity(0.4)
    actor.ForceOpaqueOn()


def textured(renderer):
    """VTK 9.6 keeps a block's texture for the next blocks that have none."""
    blocks = tiles()
    for block in blocks:
        block.GetPointData().SetTCoords(numpy_to_vtk(np.random.default_rng(1).random((block.GetNumberOfPoints(), 2)), deep=True))
    mapper = add(renderer, blocks, vtkMultiBlockDataSet).GetMapper()
    if not hasattr(mapper, "SetBlockTexture"):
        return
    mapper.SetCompositeDataDisplayAttributes(vtkCompositeDataDisplayAttributes())
    for number in range(1, ACROSS * ACROSS + 1, 10):
        texture = vtkTexture()
        texture.SetInputData(wt.checker(2 + number % 7))
        mapper.SetBlockTexture(number, texture)


SCENES = {
    "a collection": (LAKE, lambda renderer: add(renderer, kept())),
    "a pond": (POND, lambda renderer: add(renderer, tiles())),
    "attributes of blocks": (LAKE, attributes),
    "data of cells": (LAKE, cell_data),
    "several kinds of blocks": (LAKE, several_kinds),
    "far from the origin": (LAKE, far_off),
    "turned and scaled": (LAKE, turned),
    "actors that share a mapper": (LAKE, sharing),
    "one block twice": (LAKE, one_block_twice),
    "wide lines": (POND, lines),
    "wide points": (POND, lambda renderer: lines(renderer, 1)),
    "wide wires": (POND, as_wires),
    "corners as wide points": (POND, as_points),
    "vertices as wide points": (POND, with_vertices),
    "wide edges": (POND, with_edges),
    "vertex shader of its own": (LAKE, displaced),
    "blends in the opaque pass": (LAKE, glass),
    "textures of blocks": (LAKE, textured),
}


class Scene:
    """settings: of the water, by SetNAME."""

    def __init__(self, fill, sheet, skips):
        self.view = wt.View(SIZE)
        self.added = fill(self.view.renderer)
        self.water = wt.add_water(self.view.renderer, wt.plane((0, 0, 0), (0, 0, 1)), sheet, 1.0)
        self.reflection = self.water.GetReflectionPass()
        self.reflection.SetSkips(skips)
        self.camera = wt.place_camera(self.view.renderer, (0, -14, 4), (0, 0, 0), (0.5, 80))

    def pictures(self):
        for _ in range(6):
            self.camera.Azimuth(9)
            yield self.view.picture()


PLATFORMS = {"software": "1", "GPU": "0"}  # a GPU as far as it can be had: values of VTK_WATER_SOFTWARE


@pytest.fixture(params=PLATFORMS)
def platform(request, monkeypatch):
    """Whether blocks are left out as in software or as on a GPU; its name."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", PLATFORMS[request.param])
    return request.param


@pytest.mark.parametrize("name", SCENES)
def test_pictures_are_those_with_all_blocks(name, platform):
    """A walk round the blocks shows the same with all skips as with none, in the main view, too."""
    sheet, fill = SCENES[name]
    full = Scene(fill, sheet, Pass.SKIP_NONE)
    scene = Scene(fill, sheet, Pass.SKIP_ALL)
    shown = 0
    for one, other in zip(scene.pictures(), full.pictures()):
        wt.check_at_most(f"{name}: largest error", wt.difference(one, other), 0)
        full.water.SetVisibility(False)
        shown = max(shown, int((full.view.picture() != other).any(axis=2).sum()))
        full.water.SetVisibility(True)
    wt.check_equal(f"{name}: decision", wt.decision_of(scene.water), "RENDERED")
    wt.check_at_least(f"{name}: pixels of water", shown, 20)


def triangles_of(scene):
    scene.reflection.InstrumentationOn()
    for _ in range(4):  # counts arrive late
        scene.camera.Azimuth(0.01)
        scene.view.window.Render()
    return scene.reflection.GetNumberOfTrianglesReflected()


def needed(scene):
    """How many blocks have a point over the water whose mirror image the picture's frame shows."""
    matrix = scene.camera.GetCompositeProjectionTransformMatrix(SIZE[0] / SIZE[1], -1, 1)
    to_clip = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    count = 0
    for block in kept():
        points = np.array([block.GetPoint(i) for i in range(block.GetNumberOfPoints())])
        points = points[points[:, 2] > 0] * (1, 1, -1)
        clip = np.column_stack([points, np.ones(len(points))]) @ to_clip.T
        count += bool(((np.abs(clip[:, :3]) < clip[:, 3:]).all(axis=1)).any())
    return count


def test_blocks_are_left_out(platform):
    """Those drawn are few more than those that the mirrored view shows; without the skip all are drawn."""
    fill = lambda renderer: add(renderer, kept())  # noqa: E731
    of_one = kept()[0].GetNumberOfCells() * 2
    whole = Scene(fill, LAKE, Pass.SKIP_ALL & ~Pass.PIECES)
    wt.check_equal("triangles without the skip", triangles_of(whole), of_one * len(kept()))
    for zoom in (1.0, 4.0):
        scene = Scene(fill, LAKE, Pass.SKIP_ALL & ~Pass.PIXELS)  # which counts hidden water, too
        scene.camera.Zoom(zoom)
        drawn = triangles_of(scene) / of_one
        wt.check_at_least(f"zoom {zoom}: blocks that are drawn", drawn, needed(scene))
        wt.check_at_most("  of those needed", drawn, 1.6 * needed(scene) + 4)
        wt.check_at_most("  of all", drawn, 0.7 * len(kept()))


def test_mapper_and_attributes_stay_as_they_are():
    """Frames change no time stamp and no attribute; blocks that the reflection leaves out are in the picture."""
    scene = Scene(attributes, LAKE, Pass.SKIP_ALL)
    (mapper,) = (actor.GetMapper() for actor in scene.view.renderer.GetActors() if not actor.IsA("vtkWaterActor"))
    list(scene.pictures())

    def state():
        numbers = range(1, ACROSS * ACROSS + 1)
        return (mapper.GetMTime(), mapper.GetCompositeDataDisplayAttributes().GetMTime(),
                sum(not mapper.GetBlockVisibility(number) for number in numbers))

    before = state()
    list(scene.pictures())
    wt.check_equal("times of modification, and invisible blocks", state(), before)
    wt.check_equal("  of them the user's", before[2], ACROSS * ACROSS // 13)
    with_water = scene.view.picture()
    scene.view.renderer.RemoveActor(scene.water)
    dry = scene.view.picture()
    fresh = Scene(attributes, LAKE, Pass.SKIP_NONE)
    fresh.view.renderer.RemoveActor(fresh.water)
    for _ in range(12):
        fresh.camera.Azimuth(9)
    wt.check_equal("pixels of the scene without water that differ", wt.difference(dry, fresh.view.picture()), 0)
    wt.check_at_least("pixels of water", int((with_water != dry).any(axis=2).sum()), 100)

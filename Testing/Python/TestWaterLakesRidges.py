# SPDX-License-Identifier: BSD-3-Clause
"""Lakes at different levels with land between that is one point or cell wide: each ends at its own level."""
import numpy as np
import pytest
import TestWaterLakes
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

from vtkwater import vtkWaterLakes, vtkWaterPlanesFilter, vtkWaterSurfaceFilter

LEFT, RIGHT = 0.3, 0.1  # levels of two lakes with a ridge between


def ridge_of(top, direction):
    """A solver's mesh: a grid of points, and a ridge of one row of dry points across it, with a lake on each side."""
    x, y = (part.ravel() for part in np.meshgrid(np.arange(-6.0, 7.0), np.arange(-2.0, 3.0)))
    across = x + direction * y
    mesh = vtkPolyData()
    mesh.ShallowCopy(TestWaterLakes.mesh_of((0.0,), rows=5, columns=13, width=12.0, depth=4.0))
    bed = top - 0.4 * np.abs(across)
    TestWaterLakes.set_array(mesh, "zb", bed)
    TestWaterLakes.set_array(mesh, "h", np.maximum(np.where(across < 0, LEFT, RIGHT) - bed, 0.0) * (across != 0))
    return mesh


@pytest.mark.parametrize("cut", (vtkWaterLakes.CUT_IN_FILTER, vtkWaterLakes.CUT_WHILE_DRAWN), ids=("filter", "drawn"))
@pytest.mark.parametrize("top", (0.45, LEFT), ids=("high", "at the level"))
@pytest.mark.parametrize("direction", (-1, 0, 1))
def test_lakes_with_a_ridge_between_end_at_their_own_levels(direction, top, cut):
    """The points of the ridge are beside both. The ridge is straight, and cuts quads along a diagonal or their sides."""
    source = vtkTrivialProducer()
    source.SetOutput(ridge_of(top, direction))
    lakes = vtkWaterLakes()
    lakes.SetShoreCut(cut)
    made = lakes.SetData(source.GetOutputPort(), "", "h", "zb")
    made.Update()
    lakes.GetWater().GetWaterProperty().SetReflectanceModeToConstant()
    lakes.GetWater().GetWaterProperty().SetReflectance(1.0)
    view = TestWaterLakes.view_of(TestWaterLakes.things())
    lakes.AddTo(view.renderer)
    seen = view.picture()
    waters = TestWaterLakes.waters_of(lakes)
    wt.check_equal("levels", sorted(round(water.GetLevel(), 9) for water in waters), [RIGHT, LEFT])
    places = vtk_to_numpy(made.GetOutput().GetPoints().GetData())
    across = places[:, 0] + direction * places[:, 1]
    shore = np.where(across < 1e-9, -(top - LEFT) / 0.4, (top - RIGHT) / 0.4)  # where the bed is at the level
    is_shore = vtk_to_numpy(made.GetOutput().GetPointData().GetArray("WaterDepth")) == 0.0
    wt.check_at_least("points on the shore", int(is_shore.sum()), 10)
    wt.check_at_most("shore off by", float(np.abs(across - shore)[is_shore].max()), 1e-12)
    wt.check_at_most("heights off by", float(np.abs(places[:, 2] - np.where(across < 1e-9, LEFT, RIGHT)).max()), 1e-12)
    TestWaterLakes.check_exact(view, seen, waters)


def lakes_in(mesh):
    """The lakes that the filters find in a mesh with depths and beds: blocks, and the heights of the points of each."""
    surface = vtkWaterSurfaceFilter()
    surface.SetInputData(mesh)
    surface.SetDepthArrayName("h")
    surface.SetBedArrayName("zb")
    planes = vtkWaterPlanesFilter()
    planes.SetInputConnection(surface.GetOutputPort())
    planes.Update()
    blocks = [planes.GetOutput().GetBlock(i) for i in range(planes.GetOutput().GetNumberOfBlocks())]
    return blocks, [vtk_to_numpy(block.GetPoints().GetData())[:, 2] for block in blocks]


HALF = 0.5 * np.sqrt(3.0)
# Corners of a mesh, its cells, the wet points of two lakes, the areas of both; the shore is in the middle of each side.
DIVIDED = {
    "ponds of a point": ([(x, y) for y in range(3) for x in range(5)],
                         [(i, i + 1, i + 6, i + 5) for i in (0, 1, 2, 3, 5, 6, 7, 8)], (6,), (8,), 0.5),
    "corners of a quad": ([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1, 2, 3)], (0,), (2,), 0.125),
    "sides of a hexagon": ([(1, 0), (0.5, HALF), (-0.5, HALF), (-1, 0), (-0.5, -HALF), (0.5, -HALF)],
                           [(0, 1, 2, 3, 4, 5)], (0, 1), (3, 4), 0.625 * HALF),
}


@pytest.mark.parametrize("turn", range(3))
@pytest.mark.parametrize("name", DIVIDED)
def test_lakes_in_one_cell_or_around_one_point_stay_apart(name, turn):
    """Land between them has no level of its own, however few neighbours show that they are lakes."""
    corners, polygons, left, right, area = DIVIDED[name]
    mesh, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for x, y in corners:
        points.InsertNextPoint(x, y, 0.0)
    for polygon in polygons:
        cells.InsertNextCell(len(polygon))
        for corner in np.roll(polygon, turn):
            cells.InsertCellPoint(corner)
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    bed, depth = np.full(len(corners), 2.0), np.zeros(len(corners))
    bed[list(left)], bed[list(right)] = 2.0 * LEFT - 2.0, 2.0 * RIGHT - 2.0  # as far below the level as land is above it
    depth[list(left)], depth[list(right)] = 2.0 - LEFT, 2.0 - RIGHT
    TestWaterLakes.set_array(mesh, "zb", bed)
    TestWaterLakes.set_array(mesh, "h", depth)
    blocks, heights = lakes_in(mesh)
    wt.check_equal("levels", sorted({round(z, 12) for part in heights for z in part}), [RIGHT, LEFT])
    wt.check_equal("lakes", len(blocks), 2)
    for block, part in zip(blocks, heights):
        wt.check_equal("one level", float(np.ptp(part)), 0.0)
        made = block.GetFieldData().GetArray("WaterArea").GetComponent(0, 0)
        wt.check_at_most("area off by", abs(made - area), 1e-12)


@pytest.mark.parametrize("wide", (1, 2, 3))
def test_lakes_of_cells_with_a_ridge_between_end_at_their_own_levels(wide):
    """The lake on the left is deep: at the points between its cells and the ridge, the mean bed is under water."""
    mesh = TestWaterLakes.mesh_of((0.0,), rows=4, columns=14, width=13.0, depth=3.0)
    column = np.tile(np.arange(13), 3)
    is_left, is_right = column < 6, column >= 6 + wide
    is_dry = ~(is_left | is_right)
    level = np.where(is_left, LEFT, RIGHT)
    bed = np.where(is_dry, 0.9, np.where(is_left, LEFT - 1.2, RIGHT - 0.02))
    for name, values in (("zb", bed), ("h", (level - bed) * ~is_dry)):
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        mesh.GetCellData().AddArray(array)
    _, heights = lakes_in(mesh)
    wt.check_equal("lakes", sorted({round(z, 12) for part in heights for z in part}), [RIGHT, LEFT])
    wt.check_equal("levels", [float(np.ptp(part)) for part in heights], [0.0, 0.0])

# SPDX-License-Identifier: BSD-3-Clause
"""The surface of a solver's water on every kind of mesh, on hidden cells, and on meshes that point beyond their arrays."""

import numpy as np
import pytest
import water_test as wt
from TestWaterSurfaceFilter import (HALF, add_array, area_of, bed_at, flooded, mesh_of, places_of, points_of,
                                    polygons_of, surface_of, wet_area)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_ID_TYPE, vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_PIXEL, vtkDataSetAttributes, vtkImageData, vtkPolyData,
                                           vtkRectilinearGrid, vtkStructuredGrid, vtkUnstructuredGrid)
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkwater import vtkWaterSurfaceFilter


def image():
    grid = vtkImageData()
    grid.SetDimensions(41, 41, 1)
    grid.SetSpacing(0.25, 0.25, 1.0)
    grid.SetOrigin(-HALF, -HALF, 0.0)
    return grid


def unstructured():
    append = vtkAppendFilter()
    append.AddInputData(mesh_of())
    append.Update()
    return append.GetOutput()


def rectilinear():
    grid, side = vtkRectilinearGrid(), HALF * np.sin(np.linspace(-0.5, 0.5, 41) * np.pi)
    grid.SetDimensions(41, 41, 1)
    for set_coordinates, values in ((grid.SetXCoordinates, side), (grid.SetYCoordinates, side[::2].repeat(2)[:-1])):
        set_coordinates(numpy_to_vtk(values, deep=True))
    grid.SetZCoordinates(numpy_to_vtk(np.zeros(1), deep=True))
    return grid


def structured():
    grid, points = vtkStructuredGrid(), vtkPoints()
    y, x = np.meshgrid(*2 * [np.linspace(-HALF, HALF, 41)], indexing="ij")
    swing = 0.05 * (HALF**2 - x**2) * (HALF**2 - y**2) / HALF**2
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.c_[(x + 0.3 * swing).ravel(), (y - swing).ravel(), 0 * x.ravel()], deep=True))
    grid.SetDimensions(41, 41, 1)
    grid.SetPoints(points)
    return grid


def pixels():
    """Cells that are no polygons: their corners are in rows."""
    grid, points, corners = vtkUnstructuredGrid(), vtkPoints(), places_at(image())
    for place in corners:
        points.InsertNextPoint(place)
    grid.SetPoints(points)
    for row in range(40):
        for column in range(40):
            first = 41 * row + column
            grid.InsertNextCell(VTK_PIXEL, 4, [first, first + 1, first + 41, first + 42])
    return grid


KINDS = (image, rectilinear, structured, unstructured, pixels)


def places_at(mesh):
    return np.array([mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())])


@pytest.mark.parametrize("make", KINDS)
def test_other_kinds_of_meshes(make):
    mesh = make()
    places = places_at(mesh)
    add_array(mesh, "h", np.maximum(0.4 - bed_at(places), 0.0))
    add_array(mesh, "zb", bed_at(places))
    _, surface, _ = surface_of(mesh, DepthArrayName="h", BedArrayName="zb")
    wt.check_at_most("area off by", abs(area_of(surface) - wet_area(0.4)), 1e-5)


@pytest.mark.parametrize("make", KINDS)
def test_arrays_stay_with_their_places(make):
    """Of points and of cells, whatever order the cells have; in a mesh that is wet everywhere."""
    mesh = make()
    places = places_at(mesh)
    middles = np.array([np.reshape(mesh.GetCell(i).GetBounds(), (3, 2)).mean(axis=1)
                        for i in range(mesh.GetNumberOfCells())])
    add_array(mesh, "zeta", np.full(len(places), 9.0))
    add_array(mesh, "x", places[:, 0])
    add_array(mesh, "middle x", middles[:, 0], of_cells=True)
    _, surface, _ = surface_of(mesh, LevelArrayName="zeta")
    made = vtk_to_numpy(surface.GetPointData().GetArray("x"))
    wt.check_at_most("x of points off by", float(np.abs(made - points_of(surface)[:, 0]).max()), 1e-6)
    made = vtk_to_numpy(surface.GetCellData().GetArray("middle x"))
    at = [np.reshape(surface.GetCell(i).GetBounds(), (3, 2)).mean(axis=1)[0] for i in range(surface.GetNumberOfCells())]
    wt.check_equal("cells", len(made), mesh.GetNumberOfCells())
    wt.check_at_most("x of cells off by", float(np.abs(made - at).max()), 1e-6)


@pytest.mark.parametrize("make", (image, rectilinear, structured, unstructured))
def test_polygons_of_a_grid_are_listed_once(make):
    """Later steps have the same list, so nothing that is known of its cells is lost; another grid has its own."""
    mesh = make()
    add_array(mesh, "zeta", np.full(mesh.GetNumberOfPoints(), 1.0))
    made, surface, _ = surface_of(mesh, LevelArrayName="zeta")
    cells = surface.GetPolys()
    add_array(mesh, "zeta", np.full(mesh.GetNumberOfPoints(), 2.0))
    mesh.Modified()
    made.Update()
    wt.check_equal("the same cells", made.GetOutput().GetPolys() is cells, True)
    wt.check_at_most("height off by", float(np.abs(points_of(made.GetOutput())[:, 2] - 2.0).max()), 1e-12)
    other = vtkImageData()
    other.SetDimensions(11, 21, 1)
    add_array(other, "zeta", np.full(231, 3.0))
    made.SetInputData(other)
    made.Update()
    wt.check_at_most("area of another grid off by", abs(area_of(made.GetOutput()) - 200.0), 1e-9)


def test_a_grid_that_moves_is_followed():
    """Its dimensions stay; origin and spacing do not."""
    mesh = image()
    add_array(mesh, "zeta", np.full(mesh.GetNumberOfPoints(), 1.0))
    made, _, _ = surface_of(mesh, LevelArrayName="zeta")
    mesh.SetOrigin(0.0, 0.0, 0.0)
    mesh.SetSpacing(0.5, 0.25, 1.0)
    made.Update()
    wt.check_equal("bounds", made.GetOutput().GetBounds()[:4], (0.0, 20.0, 0.0, 10.0))


def hide(attributes, count, numbers, mark):
    marks = np.zeros(count, np.uint8)
    marks[numbers] = mark
    array = numpy_to_vtk(marks, deep=True)
    array.SetName(vtkDataSetAttributes.GhostArrayName())
    attributes.AddArray(array)


@pytest.mark.parametrize("make", (image, rectilinear, structured, unstructured))
def test_hidden_cells_are_left_out(make):
    """And the values of the others stay with them."""
    mesh = make()
    cells = np.arange(mesh.GetNumberOfCells())
    add_array(mesh, "zeta", np.full(mesh.GetNumberOfPoints(), 1.0))
    add_array(mesh, "number", cells, of_cells=True)
    hide(mesh.GetCellData(), len(cells), cells[::2], vtkDataSetAttributes.HIDDENCELL)
    _, surface, _ = surface_of(mesh, LevelArrayName="zeta")
    left = vtk_to_numpy(surface.GetCellData().GetArray("number")).astype(int).tolist()
    wt.check_equal("cells that are left", left, cells[1::2].tolist())


def test_cells_of_hidden_points_are_left_out():
    mesh = image()
    count = mesh.GetNumberOfPoints()
    add_array(mesh, "zeta", np.full(count, 1.0))
    hide(mesh.GetPointData(), count, [0, count // 2], vtkDataSetAttributes.HIDDENPOINT)
    _, surface, _ = surface_of(mesh, LevelArrayName="zeta")
    wt.check_equal("cells", surface.GetNumberOfPolys(), mesh.GetNumberOfCells() - 5)


def test_the_shore_has_the_marks_of_its_wet_end():
    """Marks are bits: the mean of 0 and HIDDENPOINT is DUPLICATEPOINT, another mark."""
    mesh = polygons_of(np.array([(0, 0), (1, 0), (1, 1), (0, 1)], float), [range(4)])
    add_array(mesh, "z", (1, 1, 0, 0))
    add_array(mesh, "zb", (0, 0, 2, 2))
    for wet, dry in ((0, vtkDataSetAttributes.HIDDENPOINT), (vtkDataSetAttributes.DUPLICATEPOINT, 0)):
        array = numpy_to_vtk(np.array((wet, wet, dry, dry), np.uint8), deep=True)
        array.SetName(vtkDataSetAttributes.GhostArrayName())
        mesh.GetPointData().AddArray(array)
        _, surface, _ = surface_of(mesh, LevelArrayName="z", BedArrayName="zb")
        made = vtk_to_numpy(surface.GetPointData().GetArray(vtkDataSetAttributes.GhostArrayName())).tolist()
        wt.check_equal("marks", made, [wet] * 4)


def test_the_z_of_the_mesh_is_the_bed_where_none_is_given():
    mesh = flooded(0.4)
    places = places_of(mesh, False)
    places[:, 2] = bed_at(places)
    made, surface, _ = surface_of(mesh, DepthArrayName="h")
    wt.check_at_most("area off by", abs(area_of(surface) - wet_area(0.4)), 1e-5)
    wt.check_at_most("level off by", abs(made.GetMeanLevel() - 0.4), 1e-9)


def test_an_empty_mesh_is_silent():
    made, surface, said = surface_of(vtkPolyData(), DepthArrayName="h")
    wt.check_equal("errors, cells, level", (said, surface.GetNumberOfCells(), made.GetMeanLevel()), ([], 0, 0.0))


def test_cells_without_points_are_no_surface():
    mesh = polygons_of(np.zeros((0, 2)), [])
    mesh.GetPolys().InsertNextCell(3, [0, 1, 2])
    _, surface, _ = surface_of(mesh, DepthArrayName="h")
    wt.check_equal("cells", surface.GetNumberOfCells(), 0)


@pytest.mark.parametrize("point", (10_000_000, -5))
def test_a_point_that_is_not_there_is_an_error(point):
    mesh = flooded(0.4)
    mesh.GetPolys().InsertNextCell(3, [0, 1, point])
    _, surface, said = surface_of(mesh, DepthArrayName="h", BedArrayName="zb")
    wt.check_equal("cells", surface.GetNumberOfCells(), 0)
    wt.check_equal("errors", len(said), 1)
    wt.check_equal("names the point", f"the point {point}" in said[0], True)


def test_polygons_that_vtk_cannot_triangulate_are_cut_as_a_fan():
    """Corners that come twice, as where an island is joined to a lake's outline: no point is named that is not there."""
    corners = [5, 2, 2, 4, 5, 1, 0]
    random = np.random.default_rng(3)
    cut = 0
    for _ in range(50):
        mesh = polygons_of(random.random((6, 2)), [corners])
        add_array(mesh, "zeta", random.choice([-1.0, 1.0], 6))
        add_array(mesh, "zb", np.zeros(6))
        _, surface, said = surface_of(mesh, LevelArrayName="zeta", BedArrayName="zb", DryDepth=0.0)
        ids = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
        assert said == [] and (ids >= 0).all() and (ids < surface.GetNumberOfPoints()).all()
        cut += surface.GetNumberOfCells() > 0
    wt.check_at_least("meshes with water", cut, 25)

    # a wet square with an island of two corners on land
    outline = np.array(((0, 0), (10, 0), (10, 10), (0, 10), (4, 4), (6, 4), (6, 6), (4, 6)), float)
    mesh = polygons_of(outline, [[0, 1, 2, 3, 0, 4, 7, 6, 5, 4]])
    add_array(mesh, "zeta", np.array((1, 1, 1, 1, -1, -1, 1, 1), float))
    add_array(mesh, "zb", np.zeros(8))
    _, surface, _ = surface_of(mesh, LevelArrayName="zeta", BedArrayName="zb", DryDepth=0.0)
    wt.check_at_least("cells of a lake with an island", surface.GetNumberOfCells(), 4)


@pytest.mark.parametrize("is_grid", (False, True), ids=("polygons", "grid"))
def test_cells_that_change_in_place_are_looked_at_again(is_grid):
    """The array of their points is Modified(), not the cells: their own time stays as it was."""
    mesh = unstructured() if is_grid else flooded(0.4)
    if is_grid:
        add_array(mesh, "h", np.ones(mesh.GetNumberOfPoints()))
    surface = vtkWaterSurfaceFilter()
    surface.SetDepthArrayName("h")
    surface.SetInputData(mesh)
    surface.Update()
    wt.check_at_least("cells", surface.GetOutput().GetNumberOfCells(), 1)
    ids = (mesh.GetCells() if is_grid else mesh.GetPolys()).GetConnectivityArray()
    ids.SetComponent(5, 0, 10**9)
    ids.Modified()
    mesh.Modified()
    said = wt.errors_of(surface)
    surface.Update()
    wt.check_equal("cells", surface.GetOutput().GetNumberOfCells(), 0)
    wt.check_equal("names the point", [f"the point {10**9}" in text for text in said], [True])


def few_points():
    mesh = vtkStructuredGrid()
    mesh.SetDimensions(3000, 3000, 1)
    points = vtkPoints()
    points.SetNumberOfPoints(10)
    mesh.SetPoints(points)
    return mesh


def few_coordinates():
    mesh = vtkRectilinearGrid()
    mesh.SetDimensions(3000, 2, 1)
    for set_axis, count in ((mesh.SetXCoordinates, 1), (mesh.SetYCoordinates, 2), (mesh.SetZCoordinates, 1)):
        set_axis(numpy_to_vtk(np.arange(float(count)), deep=True))
    return mesh


def wrong_offsets():
    mesh = polygons_of(np.random.default_rng(1).random((8, 2)), [])
    numbers = [numpy_to_vtk(np.array(values, np.int64), deep=True, array_type=VTK_ID_TYPE)
               for values in ((0, 6, 4, 8), range(8))]
    mesh.GetPolys().SetData(*numbers)
    return mesh


@pytest.mark.parametrize("make, words", (
    (few_points, "the grid has 10 points; its dimensions need 9000000"),
    (few_coordinates, "the grid has 1 coordinates along axis 0; its dimensions need 3000"),
    (wrong_offsets, "offset 2 of the cells is wrong; offsets must ascend from 0 to at most 8"),
), ids=("points", "coordinates", "offsets"))
def test_what_lies_beyond_a_meshs_arrays_is_an_error(make, words):
    mesh = make()
    add_array(mesh, "h", np.ones(8))
    _, surface, said = surface_of(mesh, DepthArrayName="h")
    wt.check_equal("cells", surface.GetNumberOfCells(), 0)
    wt.check_equal("said once, with the numbers", [words in text for text in said], [True])

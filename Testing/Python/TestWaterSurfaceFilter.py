# SPDX-License-Identifier: BSD-3-Clause
"""The surface of a solver's water ends where the bed reaches its level, and nowhere else."""

import functools

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataObject, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkAppendPolyData, vtkDelaunay2D
from vtkmodules.vtkFiltersHybrid import vtkTemporalInterpolator
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkLineSource, vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper
from vtkwater import vtkWaterSurfaceFilter

HALF = 5.0  # the mesh covers [-5, 5] x [-5, 5]


def mesh_of(seed=1, inside=400):
    """A random triangulation of the square."""
    mesh = vtkPolyData()
    mesh.DeepCopy(triangulation(seed, inside))
    return mesh


@functools.lru_cache(maxsize=None)
def triangulation(seed, inside):
    random = np.random.default_rng(seed)
    border = np.linspace(-HALF, HALF, 21)
    places = np.vstack([random.uniform(-HALF, HALF, (inside, 2)), np.c_[border, np.full(21, -HALF)],
                        np.c_[border, np.full(21, HALF)], np.c_[np.full(19, -HALF), border[1:-1]],
                        np.c_[np.full(19, HALF), border[1:-1]]])
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.c_[places, np.zeros(len(places))], deep=True))
    cloud = vtkPolyData()
    cloud.SetPoints(points)
    triangles = vtkDelaunay2D()
    triangles.SetInputData(cloud)
    triangles.Update()
    return triangles.GetOutput()


def places_of(mesh, of_cells):
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    if not of_cells:
        return points
    cells = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return points[cells].mean(axis=1)


def add_array(mesh, name, values, of_cells=False):
    array = numpy_to_vtk(np.asarray(values, dtype=float), deep=True)
    array.SetName(name)
    (mesh.GetCellData() if of_cells else mesh.GetPointData()).AddArray(array)


def surface_of(mesh, **names):
    made = vtkWaterSurfaceFilter()
    made.SetInputData(mesh)
    for name, value in names.items():
        getattr(made, f"Set{name}")(value)
    said = wt.errors_of(made)
    made.Update()
    return made, made.GetOutput(), said


def points_of(surface):
    return vtk_to_numpy(surface.GetPoints().GetData())


def area_of(surface):
    """Of all polygons, each by the shoelace formula."""
    if surface.GetNumberOfPolys() == 0:
        return 0.0
    begins = vtk_to_numpy(surface.GetPolys().GetOffsetsArray())
    here = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
    following = np.roll(here, -1)
    following[begins[1:] - 1] = here[begins[:-1]]
    (x, y), (to_x, to_y) = (points_of(surface)[ids, :2].T for ids in (here, following))
    return float(0.5 * np.abs(np.add.reduceat(x * to_y - y * to_x, begins[:-1])).sum())


def bed_at(places):
    return 0.3 * places[:, 0] + 0.1 * places[:, 1]


def flooded(level, of_cells=False, seed=1):
    """A plane slope, and its water as a solver writes it: depths end at 0, and dry places have their bed as the level."""
    mesh = mesh_of(seed)
    bed = bed_at(places_of(mesh, of_cells))
    depth = np.maximum(level - bed, 0.0)
    add_array(mesh, "h", depth, of_cells)
    add_array(mesh, "zeta", bed + depth, of_cells)
    add_array(mesh, "zb", bed_at(places_of(mesh, False)))
    return mesh


@functools.lru_cache(maxsize=None)
def wet_area(level):
    """Of the square: the part where 0.3 x + 0.1 y < level."""
    y = np.linspace(-HALF, HALF, 200001)
    width = np.clip((level - 0.1 * y) / 0.3 + HALF, 0.0, 2 * HALF)
    return float((width[1:] + width[:-1]).mean() * HALF)


ARRAYS = ({"LevelArrayName": "zeta", "DepthArrayName": "h"}, {"DepthArrayName": "h", "BedArrayName": "zb"},
          {"LevelArrayName": "zeta", "BedArrayName": "zb"})


@pytest.mark.parametrize("names", ARRAYS, ids=lambda names: "_".join(names))
def test_the_shore_is_exact_between_the_points(names):
    """At 100 levels: the area of the water is that of the slope under it, and all of it lies at the level."""
    off, height = 0.0, 0.0
    for level in np.linspace(-1.9, 1.9, 100):
        made, surface, _ = surface_of(flooded(level), DryDepth=0.0, **names)
        off = max(off, abs(area_of(surface) - wet_area(level)))
        height = max(height, float(np.abs(points_of(surface)[:, 2] - level).max()), abs(made.GetMeanLevel() - level))
    wt.check_at_most("area off by", off, 1e-6)
    wt.check_at_most("height off by", height, 1e-12)


@pytest.mark.parametrize("bed", ("zb", "zb_cells"))
def test_data_of_cells_end_at_the_bed(bed):
    """With the bed at the points the shore is exact, too; with that of the cells it is within a tenth of a cell."""
    level, edge = 0.4, 2 * HALF / 20
    mesh = flooded(level, of_cells=True)
    add_array(mesh, "zb_cells", bed_at(places_of(mesh, True)), True)
    _, surface, _ = surface_of(mesh, DepthArrayName="h", BedArrayName=bed)
    places = points_of(surface)
    wt.check_at_most("how far it goes up the slope, of a cell",
                     float(((bed_at(places) - level).max()) / 0.316 / edge), 1e-6 if bed == "zb" else 0.5)
    wt.check_at_most("area off by, of a cell along the shore",
                     abs(area_of(surface) - wet_area(level)) / (2 * HALF) / edge, 0.02 if bed == "zb" else 0.05)
    wt.check_at_most("height off by", float(np.abs(places[:, 2] - level).max()), 1e-9)


def test_round_banks_of_cells_have_no_holes():
    """A dry cell whose bed just reaches the level is cut at the shore, and not left out, though its corners' beds, which are
    means over the cells around them, lie lower where the bank is round."""
    side = 60
    source = vtkPlaneSource()
    source.SetOrigin(-10, -10, 0)
    source.SetPoint1(10, -10, 0)
    source.SetPoint2(-10, 10, 0)
    source.SetResolution(side, side)
    source.Update()
    mesh = source.GetOutput()
    x, y = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)[:, :2].T
    heights = 1.2 * np.sin(x / 2.3) * np.cos(y / 2.9) + 0.3 * np.sin(y / 1.1)
    corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 4)
    bed = heights[corners].mean(axis=1)
    add_array(mesh, "zb", bed, True)
    add_array(mesh, "h", np.maximum(0.2 - bed, 0.0), True)
    _, surface, _ = surface_of(mesh, DepthArrayName="h", BedArrayName="zb")
    ends = vtk_to_numpy(surface.GetPolys().GetOffsetsArray())
    ids = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
    water = np.zeros((side, side))
    for begin, end in zip(ends, ends[1:]):
        px, py = (points_of(surface)[ids[begin:end], :2].astype(float).T + 10) * side / 20
        area = 0.5 * abs(np.dot(px, np.roll(py, -1)) - np.dot(py, np.roll(px, -1)))
        water[int(py.mean()), int(px.mean())] += area
    z = heights.reshape(side + 1, side + 1)
    under = np.zeros((side, side))
    for u, v in np.ndindex(8, 8):
        u, v = (u + 0.5) / 8, (v + 0.5) / 8
        there = (1 - v) * ((1 - u) * z[:-1, :-1] + u * z[:-1, 1:]) + v * ((1 - u) * z[1:, :-1] + u * z[1:, 1:])
        under += (there < 0.2) / 64
    wt.check_at_least("cells at the shore", int(((under > 0) & (under < 1)).sum()), 200)
    wt.check_at_most("largest part of a cell that lacks its water", float((under - water).max()), 0.2)


def test_dry_land_behind_a_dyke_stays_dry():
    """Cells that are dry, though they lie below the water beside them, are left out."""
    mesh = mesh_of()
    x = places_of(mesh, True)[:, 0]
    add_array(mesh, "h", np.where(x < 0, 1.0, 0.0), True)
    add_array(mesh, "zb", np.full(mesh.GetNumberOfPoints(), -1.0))
    _, surface, _ = surface_of(mesh, DepthArrayName="h", BedArrayName="zb")
    wet = sum(1 for at in x if at < 0)
    wt.check_equal("cells", surface.GetNumberOfCells(), wet)


def test_a_film_is_dry():
    """What is shallower than DryDepth is left out; the water on a slope ends there where its bed reaches the level."""
    mesh = mesh_of()
    add_array(mesh, "h", np.full(mesh.GetNumberOfPoints(), 0.0009))
    wt.check_equal("cells of a film", surface_of(mesh, DepthArrayName="h")[1].GetNumberOfCells(), 0)
    _, surface, _ = surface_of(mesh, DepthArrayName="h", DryDepth=0.0005)
    wt.check_equal("cells with a smaller threshold", surface.GetNumberOfCells(), mesh.GetNumberOfCells())


FILLS = (9.96921e36, 1e20, -1e20)  # of NetCDF and of models
NO_NUMBERS = (float("nan"), float("inf"))
NO_HEIGHTS = [  # -1 is a level or a bed as any other
    *(({"DepthArrayName": "h", "BedArrayName": "zb"}, "h", bad) for bad in (*NO_NUMBERS, -1.0, *FILLS)),
    *(({"DepthArrayName": "h", "BedArrayName": "zb"}, "zb", bad) for bad in (*NO_NUMBERS, *FILLS)),
    *(({"LevelArrayName": "zeta", "DepthArrayName": "h"}, "h", bad) for bad in (*NO_NUMBERS, -1.0, *FILLS)),
    *(({"LevelArrayName": "zeta", "BedArrayName": "zb"}, "zeta", bad) for bad in (*NO_NUMBERS, *FILLS)),
    *(({"LevelArrayName": "zeta", "BedArrayName": "zb"}, "zb", bad) for bad in (*NO_NUMBERS, *FILLS)),
    *(({"LevelArrayName": "zeta"}, "zeta", bad) for bad in (*NO_NUMBERS, *FILLS))]


@pytest.mark.parametrize("names, spoilt, bad", NO_HEIGHTS,
                         ids=lambda value: "_".join(value) if isinstance(value, dict) else str(value))
def test_what_is_no_height_is_dry(names, spoilt, bad):
    """The water ends beside it, and is elsewhere as it was."""
    mesh = flooded(10.0)
    values = vtk_to_numpy(mesh.GetPointData().GetArray(spoilt)).copy()
    values[places_of(mesh, False)[:, 0] > 2] = bad
    add_array(mesh, spoilt, values)
    _, surface, said = surface_of(mesh, **names)
    wt.check_equal("errors", said, [])
    places = points_of(surface)
    wt.check_equal("numbers are finite", bool(np.isfinite(places).all()), True)
    wt.check_at_most("water reaches to x", float(places[:, 0].max()), 3.5)
    wt.check_at_least("and to x", float(places[:, 0].max()), 2.0)
    wt.check_at_most("heights off by", float(np.abs(places[:, 2] - 10.0).max()), 1e-9)


@pytest.mark.parametrize("names, spoilt", (
    ({"LevelArrayName": "zeta", "DepthArrayName": "h"}, "zeta"), ({"LevelArrayName": "zeta", "DepthArrayName": "h"}, "h"),
    ({"LevelArrayName": "zeta", "BedArrayName": "zb"}, "zb"), ({"DepthArrayName": "h", "BedArrayName": "zb"}, "zb")))
def test_cells_without_a_height_are_dry(names, spoilt):
    """NaN and a fill value in data of cells end the water at the same place, at most half a cell beyond."""
    ends = []
    for bad in (float("nan"), 1e36):
        mesh = mesh_of()
        count = mesh.GetNumberOfCells()
        values = {"zeta": np.full(count, 2.0), "h": np.full(count, 1.0), "zb": np.full(count, 1.0)}
        values[spoilt][places_of(mesh, True)[:, 0] > 1] = bad
        for name in ("zeta", "h", "zb"):
            add_array(mesh, name, values[name], of_cells=True)
        _, surface, said = surface_of(mesh, **names)
        wt.check_equal("errors", said, [])
        ends.append(float(points_of(surface)[:, 0].max()))
    wt.check_at_most("ends apart", abs(ends[0] - ends[1]), 1e-9)
    wt.check_at_most("water ends at x", max(ends), 2.0)
    wt.check_at_least("and at x", min(ends), 0.5)


def test_the_level_alone_is_wet_everywhere():
    mesh = flooded(0.4)
    _, surface, _ = surface_of(mesh, LevelArrayName="zeta")
    wt.check_equal("cells", surface.GetNumberOfCells(), mesh.GetNumberOfCells())
    wt.check_equal("a depth", surface.GetPointData().HasArray("WaterDepth"), 0)


def test_arrays_come_along():
    """With their values between the points, the depths with 0 at the shore, and the scalars that were active."""
    mesh = flooded(0.4)
    add_array(mesh, "x", places_of(mesh, False)[:, 0])
    mesh.GetPointData().SetActiveScalars("x")
    _, surface, _ = surface_of(mesh, DepthArrayName="h", BedArrayName="zb")
    data = surface.GetPointData()
    x = vtk_to_numpy(data.GetArray("x"))
    wt.check_at_most("x off by", float(np.abs(x - points_of(surface)[:, 0]).max()), 1e-6)
    wt.check_at_least("least depth", float(vtk_to_numpy(data.GetArray("WaterDepth")).min()), -1e-7)
    wt.check_at_most("depth off by", float(np.abs(
        vtk_to_numpy(data.GetArray("WaterDepth")) - (0.4 - bed_at(points_of(surface)))).max()), 1e-6)
    wt.check_equal("active scalars", data.GetScalars().GetName(), "x")


@pytest.mark.parametrize("components", (1, 2))
def test_land_without_data_leaves_no_trace_on_the_shore(components):
    """Where dry points have no number, as in a raster with no-data values, the shore has that of the water beside it;
    water without a number keeps none."""
    mesh = flooded(0.4)
    values = np.where(bed_at(places_of(mesh, False)) < 0.4, 7.0, np.nan)
    values[np.flatnonzero(values == 7.0)[0]] = np.nan
    add_array(mesh, "c", values if components == 1 else np.c_[values, values])
    _, surface, _ = surface_of(mesh, DepthArrayName="h", BedArrayName="zb")
    found = vtk_to_numpy(surface.GetPointData().GetArray("c")).reshape(surface.GetNumberOfPoints(), -1)
    shore = vtk_to_numpy(surface.GetPointData().GetArray("WaterDepth")) <= 0.0
    wt.check_at_least("points of the shore", int(shore.sum()), 20)
    wt.check_equal("values on the shore", sorted(set(found[shore].ravel())), [7.0])
    wt.check_equal("water without a number", int((~np.isfinite(found[~shore][:, 0])).sum()), 1)


def test_heights_may_be_exaggerated():
    made, surface, _ = surface_of(flooded(0.4), DepthArrayName="h", BedArrayName="zb", VerticalScale=3.0)
    wt.check_at_most("height off by", float(np.abs(points_of(surface)[:, 2] - 1.2).max()), 1e-9)
    wt.check_at_most("mean off by", abs(made.GetMeanLevel() - 1.2), 1e-9)
    level = vtk_to_numpy(surface.GetPointData().GetArray("WaterLevel"))
    wt.check_at_most("array off by", float(np.abs(level - 0.4).max()), 1e-9)


def cube():
    append = vtkAppendFilter()
    source = vtkCubeSource()
    source.Update()
    append.AddInputData(source.GetOutput())
    grid = vtkUnstructuredGrid()
    append.Update()
    grid.SetPoints(append.GetOutput().GetPoints())
    grid.InsertNextCell(10, 4, [0, 1, 2, 4])  # a tetrahedron
    return grid


def mixed():
    mesh = flooded(0.4, of_cells=True)
    add_array(mesh, "level_of_points", np.zeros(mesh.GetNumberOfPoints()))
    return mesh


def of_vectors():
    mesh = mesh_of()
    add_array(mesh, "v", np.zeros((mesh.GetNumberOfPoints(), 3)))
    return mesh


def too_short():
    mesh = mesh_of()
    add_array(mesh, "h", [1.0, 2.0, 3.0])
    return mesh


def of_lines():
    source = vtkLineSource()
    source.Update()
    add_array(source.GetOutput(), "h", np.ones(2))
    return source.GetOutput()


def with_a_volume():
    """A plane, and a cell of three dimensions after it."""
    append = vtkAppendFilter()
    append.AddInputData(flooded(0.4))
    append.AddInputData(cube())
    append.Update()
    return append.GetOutput()


@pytest.mark.parametrize("kind, wanted", ((8, 4), (9, 4), (22, 6), (23, 8), (28, 9)))
def test_cells_of_too_few_points_are_an_error(kind, wanted):
    """VTK's filters would read points that a cell does not have."""
    grid = vtkUnstructuredGrid()
    points = vtkPoints()
    for place in ((0, 0, 0), (1, 0, 0), (0, 1, 0)):
        points.InsertNextPoint(place)
    grid.SetPoints(points)
    grid.InsertNextCell(kind, 3, (0, 1, 2))
    add_array(grid, "h", np.ones(3))
    _, surface, said = surface_of(grid, DepthArrayName="h")
    text = f"cell 0 has 3 points; cells of its type ({kind}) have {wanted}"
    wt.check_equal("errors with the text, cells", (len(said), text in said[0], surface.GetNumberOfCells()), (1, True, 0))


def test_an_array_of_texts_is_not_listed_among_those_that_can_be_shown():
    """An error for a missing array names the numeric ones."""
    mesh = flooded(0.4)
    texts = vtkStringArray()
    texts.SetName("texts")
    texts.SetNumberOfValues(mesh.GetNumberOfPoints())
    mesh.GetPointData().AddArray(texts)
    _, _, said = surface_of(mesh, DepthArrayName="texts")
    names = said[0].split("the numeric arrays are: ")[1]
    wt.check_equal("errors", len(said), 1)
    wt.check_equal("the texts are listed, the depths are", ("texts" in names, "h (points)" in names), (False, True))


def test_lines_are_no_surface():
    """Beside triangles they are left out, with their data."""
    mesh = flooded(9.0)
    count = mesh.GetNumberOfCells()
    append = vtkAppendPolyData()
    append.AddInputData(mesh)
    append.AddInputData(flooded_line())
    append.Update()
    _, surface, said = surface_of(append.GetOutput(), DepthArrayName="h", BedArrayName="zb")
    wt.check_equal("errors", said, [])
    wt.check_equal("cells", (surface.GetNumberOfCells(), surface.GetNumberOfLines()), (count, 0))


def flooded_line():
    line = vtkLineSource()
    line.Update()
    for name, value in (("h", 1.0), ("zb", 0.0), ("zeta", 1.0)):
        add_array(line.GetOutput(), name, np.full(2, value))
    return line.GetOutput()


@pytest.mark.parametrize("make, names, words", (
    (too_short, {"DepthArrayName": "h"}, ("'h' has 3 values", "points")),
    (of_lines, {"DepthArrayName": "h"}, ("no cells of two dimensions",)),
    (with_a_volume, {"DepthArrayName": "h"}, ("three dimensions",)),
    (lambda: flooded(0.4), {"LevelArrayName": "eta"}, ("'eta'", "h (points), zeta (points), zb (points)")),
    (lambda: flooded(0.4), {"BedArrayName": "zb"}, ("neither", "zeta (points)")),
    (mixed, {"LevelArrayName": "level_of_points", "DepthArrayName": "h"}, ("both be of points, or both of cells",)),
    (of_vectors, {"DepthArrayName": "v"}, ("'v' has 3 components; it must have 1",)),
    (cube, {"DepthArrayName": "h"}, ("three dimensions",)),
), ids=("short", "lines", "mixed", "misnamed", "none", "associations", "vectors", "volume"))
def test_wrong_arrays_are_told_once(make, names, words):
    mesh = make()
    made, surface, said = surface_of(mesh, **names)
    made.Update()
    wt.check_equal("errors", len(said), 1)
    wt.check_equal(f"words in: {said[0]}", [word for word in words if word not in said[0]], [])
    wt.check_equal("cells", surface.GetNumberOfCells(), 0)


@pytest.mark.parametrize("setter, value, words", (
    ("SetDryDepth", -1.0, ("DryDepth is -1", "[0,")), ("SetVerticalScale", 0.0, ("VerticalScale is 0",)),
    ("SetDryDepth", float("nan"), ("DryDepth is nan",))))
def test_bad_values_are_refused(setter, value, words):
    made = vtkWaterSurfaceFilter()
    said = wt.errors_of(made)
    before = (made.GetDryDepth(), made.GetVerticalScale())
    getattr(made, setter)(value)
    wt.check_equal("errors", len(said), 1)
    wt.check_equal(f"words in: {said[0]}", [word for word in words if word not in said[0]], [])
    wt.check_equal("it stays", (made.GetDryDepth(), made.GetVerticalScale()), before)


def polygons_of(places, cells):
    """A mesh of polygons with any number of corners."""
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(np.c_[places, np.zeros(len(places))], deep=True))
    polygons = vtkCellArray()
    for cell in cells:
        polygons.InsertNextCell(len(cell), cell)
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(polygons)
    return mesh


class Steps(VTKPythonAlgorithmBase):
    """A source of a mesh at each time step, as VTK's readers are."""

    def __init__(self, meshes):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")
        self.meshes = meshes

    def RequestInformation(self, request, inputs, outputs):
        info, times = outputs.GetInformationObject(0), list(range(len(self.meshes)))
        info.Set(vtkStreamingDemandDrivenPipeline.TIME_STEPS(), times, len(times))
        info.Set(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), [times[0], times[-1]], 2)
        return 1

    def RequestData(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        time = info.Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP()) or 0.0
        output = vtkPolyData.GetData(info)
        output.ShallowCopy(self.meshes[int(time)])
        output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), float(int(time)))
        return 1


def test_the_pipelines_time_is_the_waters():
    """Behind a source of steps and VTK's interpolator, in any order of times: the level, and the area of the water on
    the slope, are those of the time."""
    levels = (0.4, -0.6, 0.8)
    source = Steps([flooded(level) for level in levels])
    between = vtkTemporalInterpolator()
    between.SetInputConnection(source.GetOutputPort())
    made = vtkWaterSurfaceFilter()
    made.SetInputConnection(between.GetOutputPort())
    made.SetLevelArrayName("zeta")
    made.SetBedArrayName("zb")
    made.SetDryDepth(0.0)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(made.GetOutputPort())
    for time in (0.0, 2.0, 1.0, 0.0):
        mapper.GetInputAlgorithm().UpdateTimeStep(time)
        level = levels[int(time)]
        wt.check_at_most(f"area at {time} off by", abs(area_of(mapper.GetInput()) - wet_area(level)), 1e-4)
        wt.check_at_most(f"level at {time} off by", abs(made.GetMeanLevel() - level), 1e-6)
    # between steps: where both have water
    mapper.GetInputAlgorithm().UpdateTimeStep(0.25)
    points = points_of(mapper.GetInput())
    deep = bed_at(points) < min(levels[:2]) - 0.5
    level = 0.75 * levels[0] + 0.25 * levels[1]
    wt.check_at_least("points there", int(deep.sum()), 50)
    wt.check_at_most("level between two steps off by", float(np.abs(points[deep, 2] - level).max()), 1e-6)


def test_wet_meshes_share_their_cells_and_arrays():
    """Nothing is copied of what does not change from step to step; each step has its own points."""
    mesh = flooded(9.0)
    made, surface, _ = surface_of(mesh, DepthArrayName="h", BedArrayName="zb")
    wt.check_equal("the same cells", surface.GetPolys() is mesh.GetPolys(), True)
    wt.check_equal("the same array", surface.GetPointData().GetArray("zb") is mesh.GetPointData().GetArray("zb"), True)
    first = surface.GetPoints()
    add_array(mesh, "h", 8.0 - bed_at(places_of(mesh, False)))
    mesh.Modified()
    made.Update()
    wt.check_equal("the same points", made.GetOutput().GetPoints() is first, False)
    wt.check_at_most("height off by", float(np.abs(points_of(made.GetOutput())[:, 2] - 8.0).max()), 1e-12)
    wt.check_at_most("mean off by", abs(made.GetMeanLevel() - 8.0), 1e-9)


def test_a_shore_hangs_together():
    """Cells on both sides of an edge share their point on the shore, and no point is without a cell."""
    _, surface, _ = surface_of(flooded(0.4), DepthArrayName="h", BedArrayName="zb")
    places = points_of(surface)
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray())
    wt.check_equal("different points", len(np.unique(np.round(places, 9), axis=0)), len(places))
    wt.check_equal("points of cells", len(np.unique(corners)), len(places))
    wt.check_at_least("points on the shore",
                      int((vtk_to_numpy(surface.GetPointData().GetArray("WaterDepth")) == 0.0).sum()), 20)


def test_data_of_cells_come_along():
    """A cell, whole or cut, has the data of the one that it is of."""
    mesh = flooded(0.4)
    cells = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    add_array(mesh, "number", np.arange(len(cells)), True)
    _, surface, _ = surface_of(mesh, DepthArrayName="h", BedArrayName="zb")
    numbers = vtk_to_numpy(surface.GetCellData().GetArray("number")).astype(int)
    wt.check_equal("numbers", len(numbers), surface.GetNumberOfCells())
    wt.check_equal("triangles of a cell", set(np.unique(numbers, return_counts=True)[1]), {1, 2})
    places, off = points_of(surface), 0.0
    for i, number in enumerate(numbers):
        corners = surface.GetCell(i).GetPointIds()
        a, b, c = places_of(mesh, False)[cells[number], :2]
        inside = np.linalg.solve(np.array([b - a, c - a]).T,
                                 (places[[corners.GetId(j) for j in range(corners.GetNumberOfIds())], :2] - a).T)
        off = max(off, float(-inside.min()), float(inside.sum(axis=0).max() - 1.0))
    wt.check_at_most("corners beyond their cell by", off, 1e-9)


@pytest.mark.parametrize("places, depths, area", (
    # a square that is wet at two opposite corners: two triangles by the diagonal between them
    (((0, 0), (2, 0), (2, 2), (0, 2)), (1, -1, 1, -1), 4 - 2 * 0.5),
    (((0, 0), (2, 0), (2, 2), (0, 2)), (-1, 1, 1, -1), 2.0),
    # a concave polygon, an L: wet right of x = 1
    (((0, 0), (2, 0), (2, 2), (1.5, 2), (1.5, 0.5), (0, 0.5)), (-1, 1, 1, 0.5, 0.5, -1), 0.5 + 0.75),
    # one with its shore at two of its corners
    (((0, 0), (2, 0), (2, 2), (0, 2)), (0, 1, 0, -1), 2.0),
), ids=("saddle", "half", "concave", "corners"))
def test_polygons_of_any_shape_are_cut(places, depths, area):
    mesh = polygons_of(np.array(places, float), [range(len(places))])
    add_array(mesh, "zb", -np.array(depths, float))
    add_array(mesh, "zeta", np.zeros(len(places)))
    _, surface, said = surface_of(mesh, LevelArrayName="zeta", BedArrayName="zb", DryDepth=0.0)
    wt.check_equal("errors", said, [])
    wt.check_at_most("area off by", abs(area_of(surface) - area), 1e-9)


def test_normals_of_the_bed_are_not_the_surfaces():
    """They would turn its reflections: point normals of a water's mesh are its slopes."""
    for bed in (-1000.0, None):  # all wet, and with a shore
        mesh = flooded(0.4)
        if bed is not None:
            vtk_to_numpy(mesh.GetPointData().GetArray("zb"))[:] = bed
            vtk_to_numpy(mesh.GetPointData().GetArray("h"))[:] = 0.4 - bed
        for data, count in ((mesh.GetPointData(), mesh.GetNumberOfPoints()),
                            (mesh.GetCellData(), mesh.GetNumberOfCells())):
            normals = numpy_to_vtk(np.tile((1.0, 0.0, 0.0), (count, 1)), deep=True)
            normals.SetName("of the bed")
            data.SetNormals(normals)
        _, surface, said = surface_of(mesh, DepthArrayName="h", BedArrayName="zb")
        wt.check_equal("errors", said, [])
        wt.check_at_least("cells", surface.GetNumberOfCells(), 100)
        wt.check_equal("normals", (surface.GetPointData().GetNormals(), surface.GetCellData().GetNormals()), (None, None))
        wt.check_equal("the mesh keeps its own", mesh.GetPointData().GetNormals() is None, False)

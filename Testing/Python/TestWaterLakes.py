# SPDX-License-Identifier: BSD-3-Clause
"""The waters of one mesh that lie in several planes: each is as exact as one of its own, those in one plane share
a mirrored view, and only the largest of those in view have one."""
import gc
import weakref

import numpy as np
import pytest
import TestWaterSurfaceFilter
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (VTK_LINE, VTK_POLYGON, VTK_QUAD, VTK_VERTEX, vtkCellArray, vtkPolyData,
                                           vtkUnstructuredGrid)
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkPolyDataNormals
from vtkmodules.vtkFiltersHybrid import vtkTemporalInterpolator
from vtkmodules.vtkRenderingCore import vtkCompositePolyDataMapper, vtkPolyDataMapper, vtkRenderer

from vtkwater import vtkWaterActor, vtkWaterLakes, vtkWaterPlanesFilter, vtkWaterSurfaceFilter

SIZE = (400, 200)
LEVELS = (0.0, 0.11, -0.07, 0.2, 0.05, -0.15, 0.13, -0.02, 0.17, 0.09)
LIMIT_PERCENT = 0.02
USED_AGAIN = "used again: nothing has changed"


def mesh_of(heights, rows=2, columns=2, width=1.6, depth=3.0, step=2.0):
    """A patch for each entry of heights, a number or a function of x and y, side by side along x."""
    made, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for number, height in enumerate(heights):
        start = points.GetNumberOfPoints()
        left = step * (number - 0.5 * (len(heights) - 1)) - 0.5 * width
        for y in np.linspace(-0.5 * depth, 0.5 * depth, rows):
            for x in left + np.linspace(0.0, width, columns):
                points.InsertNextPoint(x, y, height(x, y) if callable(height) else height)
        for row in range(rows - 1):
            for column in range(columns - 1):
                first = start + row * columns + column
                cells.InsertNextCell(4)
                for corner in (first, first + 1, first + columns + 1, first + columns):
                    cells.InsertCellPoint(corner)
    made.SetPoints(points)
    made.SetPolys(cells)
    return made


def lakes_of(mesh, **settings):
    lakes = vtkWaterLakes()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    lakes.SetMapper(mapper)
    look = lakes.GetWater().GetWaterProperty()
    look.SetReflectanceModeToConstant()
    look.SetReflectance(1.0)
    for name, value in settings.items():
        getattr(lakes, f"Set{name}")(value)
    return lakes


def things():
    """Behind and over the lakes, none of which hides another."""
    return [(wt.box((x, 1.9 + 0.1 * (i % 3), 0.6), (0.5, 0.3, 0.9)), (0.2 + 0.07 * i, 0.8 - 0.06 * i, 0.3))
            for i, x in enumerate(np.linspace(-9, 9, 10))]


def view_of(pairs, look_at=(0, 0, 0), position=(0, -14, 9)):
    view = wt.View(SIZE)
    for data, color in pairs:
        wt.add_actor(view.renderer, data, color, lit=False)
    wt.place_camera(view.renderer, position, look_at, (1, 60))
    return view


def waters_of(lakes):
    return [lakes.GetWater(i) for i in range(lakes.GetNumberOfWaters())]


def renders_of(waters):
    return [water.GetReflectionPass().GetNumberOfReflectionRenders() for water in waters]


def decisions_of(lakes):
    return [water.GetReflectionPass().GetDecisionAsString() for water in waters_of(lakes)]


def mask_of(view, water):
    """Which pixels show the water, by a picture of its mesh in a colour of its own among all other things."""
    plain = wt.View(SIZE)
    color = (1.0, 0.0, 1.0)
    for actor in view.renderer.GetActors():
        data = actor.GetMapper().GetInput()
        wt.add_actor(plain.renderer, data, color if actor is water else (0.1, 0.1, 0.1), lit=False)
    plain.renderer.GetActiveCamera().DeepCopy(view.renderer.GetActiveCamera())
    return (np.abs(plain.picture() - np.array([255, 0, 255])).max(axis=2) <= 1)


def test_ten_lakes_of_one_mesh_are_each_exact():
    """In each of ten lakes at ten levels the picture is that of the scene mirrored at its level."""
    lakes = lakes_of(mesh_of(LEVELS), MaximumNumberOfMirrors=10)
    view = view_of(things())
    lakes.AddTo(view.renderer)
    seen = view.picture()
    waters = waters_of(lakes)
    wt.check_equal("levels", sorted(water.GetLevel() for water in waters), sorted(LEVELS))
    check_exact(view, seen, waters)


def test_flat_lakes_beside_waves_are_exact():
    """In a mesh whose other parts have waves, with normals of the mesh, flat parts are as exact as calm water."""
    def waves(x, y):
        return 0.05 + 0.1 * np.sin(3.0 * x + 2.0 * y)

    made = mesh_of((0.0, waves, 0.2, waves, -0.1), rows=40, columns=30)
    normals = vtkPolyDataNormals()
    normals.SetInputData(made)
    normals.SplittingOff()
    normals.Update()
    lakes = lakes_of(normals.GetOutput())
    view = view_of(things())
    lakes.AddTo(view.renderer)
    seen = view.picture()
    flat = [water for water in waters_of(lakes) if np.ptp(water.GetMapper().GetInput().GetBounds()[4:]) == 0.0]
    wt.check_equal("flat lakes", sorted(round(water.GetLevel(), 9) for water in flat), [-0.1, 0.0, 0.2])
    check_exact(view, seen, flat)


def check_exact(view, seen, waters):
    """The pixels of flat waters are those of the scene mirrored at their levels."""
    off, count = 0, 0
    for water in waters:
        normal, origin = (0, 0, 1), (0, 0, water.GetLevel())
        expected = view_of([(wt.mirror_image(data, origin, normal), color) for data, color in things()]).picture()
        mask = mask_of(view, water)
        off += int(((np.abs(seen - expected).max(axis=2) > 1) & mask).sum())
        count += int(mask.sum())
        shows_things = (np.ptp(expected[mask], axis=0) > 60).any()
        wt.check_equal(f"the lake at {water.GetLevel():g} shows things", bool(shows_things), True)
    wt.check_at_most("pixels off, percent", 100 * off / count, LIMIT_PERCENT)


def test_the_water_of_a_solvers_mesh_is_one_call():
    """Of two basins with their own levels: a water each, which follows the arrays, and is wet where the bed is lower."""
    mesh = vtkPolyData()
    mesh.ShallowCopy(mesh_of((0.0, 0.0)))
    count = mesh.GetNumberOfPoints()
    left = vtk_to_numpy(mesh.GetPoints().GetData())[:, 0] < 0.0
    for name, values in (("zeta", np.where(left, 0.4, 0.9)), ("zb", np.full(count, -1.0))):
        set_array(mesh, name, values)
    source = vtkTrivialProducer()
    source.SetOutput(mesh)
    lakes = vtkWaterLakes()
    surface = lakes.SetData(source.GetOutputPort(), "zeta", "", "zb")
    view = view_of(things())
    view.renderer.AddActor(lakes.GetWater())
    lakes.AddTo(view.renderer)
    view.picture()
    wt.check_equal("levels", sorted(round(water.GetLevel(), 9) for water in waters_of(lakes)), [0.4, 0.9])
    wt.check_equal("its filter", lakes.GetMapper().GetInputAlgorithm() is surface, True)
    set_array(mesh, "zeta", np.where(left, 0.6, -2.0))
    mesh.Modified()
    view.picture()
    wt.check_equal("later", [round(water.GetLevel(), 9) for water in waters_of(lakes)], [0.6])
    wt.check_equal("of no mesh", lakes.SetData(None, "", "", "") is None and lakes.GetMapper() is None, True)


@pytest.mark.parametrize("is_software", (1, 0))
def test_a_picture_is_a_function_of_the_pipelines_time(is_software, monkeypatch):
    """In any order of times, at steps and between them."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    levels = (0.1, 0.5, -0.3)
    between = vtkTemporalInterpolator()
    source = TestWaterSurfaceFilter.Steps([flooded(level) for level in levels])
    between.SetInputConnection(source.GetOutputPort())
    lakes = vtkWaterLakes()
    surface = lakes.SetData(between.GetOutputPort(), "zeta", "", "zb")
    surface.SetDryDepth(0.0)
    surface.UpdateTimeStep(1.5)  # VTK's interpolator refuses to be asked without a time
    view = view_of(things())
    view.renderer.AddActor(lakes.GetWater())
    lakes.AddTo(view.renderer)
    pictures = {}
    for time in (0.0, 2.0, 0.5, 1.0, 0.5, 2.0, 0.0):
        surface.UpdateTimeStep(time)
        picture = view.picture().astype(int)
        before = pictures.setdefault(time, picture)
        wt.check_equal(f"pixels at {time} that differ from the first time", int((picture != before).any(axis=2).sum()), 0)
        level = np.interp(time, range(len(levels)), levels)
        wt.check_at_most(f"level at {time}: off by", abs(lakes.GetWater().GetLevel() - level), 1e-6)
    wt.check_equal("cut while drawn", lakes.GetIsShoreCutWhileDrawn(), not is_software)
    for time in (0.5, 1.0, 2.0):
        changed = (pictures[time] != pictures[0.0]).any(axis=2).mean()
        wt.check_at_least(f"pixels that change until {time}, %", 100 * changed, 2)


@pytest.mark.parametrize("cut", ("CUT_IN_FILTER", "CUT_WHILE_DRAWN"))
def test_another_consumer_does_not_change_the_waters_time(cut):
    """The same source is read for another time: by another filter, or itself."""
    source = TestWaterSurfaceFilter.Steps([flooded(level) for level in (0.1, 0.5, -0.3)])
    lakes = vtkWaterLakes()
    surface = lakes.SetData(source.GetOutputPort(), "zeta", "", "zb")
    lakes.SetShoreCut(getattr(lakes, cut))
    view = view_of(things())
    view.renderer.AddActor(lakes.GetWater())
    lakes.AddTo(view.renderer)
    surface.UpdateTimeStep(0.0)
    first = view.picture().astype(int)
    other = vtkWaterSurfaceFilter()
    other.SetLevelArrayName("zeta")
    other.SetBedArrayName("zb")
    other.SetInputConnection(source.GetOutputPort())
    for read in (other.UpdateTimeStep, source.UpdateTimeStep):
        read(1.0)
        picture = view.picture().astype(int)
        wt.check_at_most("level off by", abs(lakes.GetWater().GetLevel() - 0.1), 1e-6)
        wt.check_equal("pixels that differ", int((picture != first).any(axis=2).sum()), 0)


def flooded(level):
    """A lake over a bed that slopes along y."""
    mesh = vtkPolyData()
    mesh.ShallowCopy(mesh_of((0.0,), rows=20, columns=20, width=8.0))
    bed = 0.6 * vtk_to_numpy(mesh.GetPoints().GetData())[:, 1]
    set_array(mesh, "zb", bed)
    set_array(mesh, "zeta", np.full(len(bed), level))
    return mesh


def set_array(mesh, name, values):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    mesh.GetPointData().AddArray(array)


def test_lakes_at_one_level_share_a_plane():
    lakes = lakes_of(mesh_of((0.0, 0.2, 0.0, 0.2, 0.0)))
    view = view_of(things())
    lakes.AddTo(view.renderer)
    view.picture()
    waters = waters_of(lakes)
    wt.check_equal("levels", [water.GetLevel() for water in waters], [0.0, 0.2])
    wt.check_equal("mirrored views", renders_of(waters), [1, 1])


def test_only_waters_in_view_are_mirrored():
    """Of fifty lakes six are in view: six mirrored views."""
    levels = [0.05 * (7 * i % 50) for i in range(50)]
    lakes = lakes_of(mesh_of(levels), MaximumNumberOfPlanes=50)
    view = view_of(things(), (0, 0, 1.2), (0, -10, 8))
    view.renderer.GetActiveCamera().SetViewAngle(24)
    lakes.AddTo(view.renderer)
    view.picture()
    waters = waters_of(lakes)
    wt.check_equal("waters", len(waters), 50)
    in_view = sum(bool(mask_of(view, water).any()) for water in waters)
    wt.check_equal("in view", in_view, 6)
    view.picture()
    wt.check_equal("mirrored views", sum(decision in ("rendered", USED_AGAIN) for decision in decisions_of(lakes)), 6)


def test_the_largest_in_view_have_a_mirrored_view():
    """Those that cover most of the picture; the others reflect the sky alone."""
    lakes = lakes_of(mesh_of([0.1 * i for i in range(5)]), MaximumNumberOfMirrors=2)
    view = view_of(things(), (-4, 0, 0), (-8, -6, 4))
    view.renderer.SetBackground(0.1, 0.2, 0.9)
    lakes.AddTo(view.renderer)
    picture = view.picture()
    masks = [mask_of(view, water) for water in waters_of(lakes)]
    largest = sorted(range(5), key=lambda number: -masks[number].sum())[:2]
    wt.check_equal("all are in view", all(mask.any() for mask in masks), True)
    for number, mask in enumerate(masks):
        is_sky = bool((np.abs(picture[mask] - np.array([0.1, 0.2, 0.9]) * 255) <= 1).all())
        wt.check_equal(f"lake {number} shows the sky alone", is_sky, number not in largest)
        wt.check_equal(f"lake {number} is mirrored", decisions_of(lakes)[number] == "rendered", number in largest)
    lakes.SetMaximumNumberOfMirrors(5)
    view.picture()
    wt.check_equal("decisions with five", decisions_of(lakes), ["rendered"] * 5)


def test_small_lakes_far_apart_do_not_take_the_view_of_a_large_one():
    """Two small lakes at one level, at both ends of the picture: their bounds cover more of it than the lake between."""
    append = vtkAppendPolyData()
    append.AddInputData(mesh_of((0.0, 0.0), width=0.3, depth=1.2, step=8.0))
    append.AddInputData(mesh_of((0.2,)))
    append.Update()
    lakes = lakes_of(append.GetOutput(), MaximumNumberOfMirrors=1)
    view = view_of(things())
    lakes.AddTo(view.renderer)
    seen = view.picture()
    waters = waters_of(lakes)
    wt.check_equal("levels", [water.GetLevel() for water in waters], [0.2, 0.0])
    masks = [mask_of(view, water) for water in waters]
    wt.check_equal("the large one covers more", bool(masks[0].sum() > masks[1].sum() > 0), True)
    wt.check_equal("mirrored views", renders_of(waters), [1, 0])
    check_exact(view, seen, waters[:1])


def test_beyond_the_most_planes_small_parts_are_one_water():
    levels = [0.05 * i for i in range(20)]
    lakes = lakes_of(mesh_of(levels))
    lakes.Update()
    wt.check_equal("waters", lakes.GetNumberOfWaters(), 17)
    found = [water.GetLevel() for water in waters_of(lakes)]
    wt.check_equal("the last is at the lowest without a plane", found[-1], min(set(levels) - set(found[:-1])))
    lakes.SetMaximumNumberOfPlanes(20)
    lakes.Update()
    wt.check_equal("waters of 20", lakes.GetNumberOfWaters(), 20)


@pytest.mark.parametrize("planes", [1, 4])
def test_parts_without_a_plane_reflect_the_sky_and_the_others_are_exact(planes):
    """The view mirrored at one lake is wrong for another: the others show nothing of it, at any height."""
    lakes = lakes_of(mesh_of(LEVELS), MaximumNumberOfPlanes=planes, MaximumNumberOfMirrors=10)
    view = view_of(things())
    lakes.AddTo(view.renderer)
    lakes.Update()
    waters = waters_of(lakes)
    wt.check_equal("waters", len(waters), planes + 1)
    warnings = []
    for water in waters:
        water.AddObserver("WarningEvent", lambda *_: warnings.append("a warning"))
    seen = view.picture()
    check_exact(view, seen, waters[:planes])
    rest = mask_of(view, waters[-1])
    sky = np.array(view.renderer.GetBackground()) * 255
    wt.check_equal("pixels of the others", bool(rest.sum() > 1000), True)
    wt.check_at_most("not the sky, percent", 100 * (np.abs(seen[rest] - sky).max(axis=1) > 1).mean(), LIMIT_PERCENT)
    wt.check_equal("mirrored views", renders_of(waters), [1] * planes + [0])
    wt.check_equal("warnings", warnings, [])


def test_waters_that_the_caller_adds_are_mirrored_except_the_rest():
    """Without AddTo nobody chooses the mirrored views: all waters have one, but for that of parts without a plane."""
    lakes = lakes_of(mesh_of(LEVELS[:3]), MaximumNumberOfPlanes=1)
    lakes.Update()
    lakes.SetMaximumNumberOfPlanes(2)  # the second water was the rest, and now the third is
    lakes.Update()
    view = view_of(things())
    for _ in range(2):
        for water in waters_of(lakes):
            view.renderer.AddActor(water)
        before = renders_of(waters_of(lakes))
        view.renderer.GetActiveCamera().Azimuth(1)
        view.picture()
        made = [after - first for after, first in zip(renders_of(waters_of(lakes)), before)]
        wt.check_equal("mirrored views", made, [1, 1, 0])
        for water in waters_of(lakes):
            view.renderer.RemoveActor(water)
        lakes.AddTo(view.renderer)
        view.picture()
        lakes.RemoveFrom(view.renderer)


def test_waters_follow_the_mesh():
    """Lakes that join are one, at one level, and lakes that rise have new planes."""
    lakes = lakes_of(mesh_of((0.0, 0.2)))
    view = view_of(things())
    lakes.AddTo(view.renderer)
    view.picture()
    wt.check_equal("waters", [water.GetLevel() for water in waters_of(lakes)], [0.0, 0.2])
    lakes.GetMapper().SetInputData(mesh_of((0.1, 0.3, 0.5)))
    view.picture()
    wt.check_equal("more", [water.GetLevel() for water in waters_of(lakes)], [0.1, 0.3, 0.5])
    wt.check_equal("in the renderer", sum(bool(actor.IsA("vtkWaterActor")) for actor in view.renderer.GetActors()), 3)
    lakes.GetMapper().SetInputData(mesh_of((0.4,)))
    view.picture()
    wt.check_equal("one", [water.GetLevel() for water in waters_of(lakes)], [0.4])
    lakes.GetMapper().SetInputData(vtkPolyData())
    without = view.picture()
    wt.check_equal("waters of nothing", lakes.GetNumberOfWaters(), 1)
    wt.check_equal("the picture of nothing", bool((without == view_of(things()).picture()).all()), True)


def test_the_others_follow_the_first():
    lakes = lakes_of(mesh_of((0.0, 0.2, 0.4)))
    view = view_of(things())
    lakes.AddTo(view.renderer)
    first, *others = waters_of(lakes)
    first.SetTime(3.5)
    first.GetReflectionPass().SetTextureScale(0.5)
    first.GetProperty().SetOpacity(0.7)
    view.picture()
    for water in others:
        wt.check_equal("time", water.GetTime(), 3.5)
        wt.check_equal("look", water.GetWaterProperty() is first.GetWaterProperty(), True)
        wt.check_equal("scale", water.GetReflectionPass().GetTextureScale(), 0.5)
    wt.check_equal("planes stay", [water.GetLevel() for water in waters_of(lakes)], [0.0, 0.2, 0.4])
    first.SetPosition(0, 0, 1)
    first.SetScale(1, 1, 2)
    view.picture()
    wt.check_equal("moved", [water.GetLevel() for water in waters_of(lakes)], [1.0, 1.4, 1.8])
    first.VisibilityOff()
    hidden = view.picture()
    wt.check_equal("hidden together", bool((hidden == view_of(things()).picture()).all()), True)


def test_the_first_takes_the_others_along():
    lakes = lakes_of(mesh_of((0.0, 0.2, 0.4)))
    known = weakref.ref(lakes.GetMapper())
    view = view_of(things())
    lakes.AddTo(view.renderer)
    first = lakes.GetWater()
    del lakes
    gc.collect()
    view.picture()
    wt.check_equal("there", sum(bool(actor.IsA("vtkWaterActor")) for actor in view.renderer.GetActors()), 3)
    view.renderer.RemoveActor(first)
    view.picture()
    wt.check_equal("left", sum(bool(actor.IsA("vtkWaterActor")) for actor in view.renderer.GetActors()), 0)
    gc.collect()
    wt.check_equal("kept alive", known() is not None, False)


def test_a_fall_is_tilted_and_waves_are_level():
    filtered = vtkWaterPlanesFilter()
    filtered.SetInputData(mesh_of(
        (lambda x, y: 1 + 0.02 * y, lambda x, y: 2 + 0.05 * np.sin(9 * y)), rows=40, columns=3))
    filtered.Update()
    blocks = filtered.GetOutput()
    wt.check_equal("planes", (blocks.GetNumberOfBlocks(), filtered.GetNumberOfPlanes()), (2, 2))
    fall, waves = (blocks.GetBlock(i).GetFieldData() for i in range(2))
    normal = vtk_to_numpy(fall.GetArray("WaterPlaneNormal"))[0]
    wt.check_at_most("fall off by", abs(-normal[1] / normal[2] - 0.02), 1e-9)
    wt.check_equal("waves", tuple(vtk_to_numpy(waves.GetArray("WaterPlaneNormal"))[0]), (0.0, 0.0, 1.0))
    wt.check_equal("normals of the fall, which is flat", blocks.GetBlock(0).GetPointData().GetNormals() is None, True)
    wt.check_equal("normals of waves", blocks.GetBlock(1).GetPointData().GetNormals() is None, False)
    wt.check_at_most("area off by", abs(vtk_to_numpy(fall.GetArray("WaterArea"))[0] - 4.8), 1e-9)


def test_arrays_of_cells_and_points_stay_with_their_cells():
    mesh = mesh_of((0.0, 0.5, 0.0))
    for data, count in ((mesh.GetPointData(), 12), (mesh.GetCellData(), 3)):
        array = numpy_to_vtk(np.arange(count, dtype=float), deep=1)
        array.SetName("number")
        data.AddArray(array)
    filtered = vtkWaterPlanesFilter()
    filtered.SetInputData(mesh)
    filtered.Update()
    blocks = [filtered.GetOutput().GetBlock(i) for i in range(2)]
    numbers = [vtk_to_numpy(block.GetCellData().GetArray("number")).tolist() for block in blocks]
    wt.check_equal("cells", numbers, [[0.0, 2.0], [1.0]])
    wt.check_equal("points", vtk_to_numpy(blocks[1].GetPointData().GetArray("number")).tolist(), [4.0, 5.0, 7.0, 6.0])


def test_a_mapper_that_loses_its_input_shows_no_water():
    """And nothing is made anew in each frame then."""
    lakes = lakes_of(mesh_of((0.0, 0.2, 0.4)))
    view = view_of(things())
    lakes.AddTo(view.renderer)
    view.picture()
    lakes.GetMapper().SetInputConnection(None)
    without = view.picture()
    wt.check_equal("the picture", bool((without == view_of(things()).picture()).all()), True)
    made = lakes.GetWater().GetMapper().GetMTime()
    view.picture()
    wt.check_equal("made anew", lakes.GetWater().GetMapper().GetMTime() == made, True)
    lakes.GetMapper().SetInputData(mesh_of((0.0, 0.2)))
    view.picture()
    wt.check_equal("waters of a new one", lakes.GetNumberOfWaters(), 2)


@pytest.mark.parametrize("levels", ((0.0,), (0.0, 0.2, 0.4, 0.6)))
def test_renderers_that_are_gone_are_forgotten(levels):
    lakes = lakes_of(mesh_of((0.0, 0.2)))
    renderer = vtkRenderer()
    lakes.AddTo(renderer)
    del renderer
    lakes.GetMapper().SetInputData(mesh_of(levels))
    lakes.Update()
    wt.check_equal("waters", lakes.GetNumberOfWaters(), len(levels))


@pytest.mark.parametrize("which", ("all", "the first", "another"))
def test_removed_waters_can_be_added_again_in_the_same_frame(which):
    lakes = lakes_of(mesh_of((0.0, 0.2, 0.4)))
    view = view_of(things())
    lakes.AddTo(view.renderer)
    expected = view.picture()
    if which == "all":
        view.renderer.RemoveAllViewProps()
        for data, color in things():
            wt.add_actor(view.renderer, data, color, lit=False)
    else:
        view.renderer.RemoveActor(lakes.GetWater(int(which == "another")))
    for _ in range(2):
        lakes.AddTo(view.renderer)
    wt.check_equal("the picture", bool((view.picture() == expected).all()), True)
    wt.check_equal("waters", sum(bool(actor.IsA("vtkWaterActor")) for actor in view.renderer.GetActors()), 3)


def test_the_user_says_whether_waters_reflect_the_scene():
    """The choice among waters keeps to it, and says nothing in its place."""
    lakes = lakes_of(mesh_of((0.0, 0.2, 0.4)), MaximumNumberOfMirrors=1)
    view = view_of(things())
    lakes.AddTo(view.renderer)
    view.picture()
    wt.check_equal("by default", [water.GetSceneReflection() for water in waters_of(lakes)], [True] * 3)
    wt.check_equal("mirrored", decisions_of(lakes).count("rendered"), 1)
    lakes.GetWater().SceneReflectionOff()
    for _ in range(2):
        view.picture()
        wt.check_equal("off", [water.GetSceneReflection() for water in waters_of(lakes)], [False] * 3)
        mirrored = [said in ("rendered", USED_AGAIN) for said in decisions_of(lakes)]
        wt.check_equal("mirrored when off", mirrored, [False] * 3)
    lakes.GetWater().SceneReflectionOn()
    lakes.SetMaximumNumberOfMirrors(3)
    view.picture()
    wt.check_equal("on again", [said in ("rendered", USED_AGAIN) for said in decisions_of(lakes)], [True] * 3)
    lakes.SetMaximumNumberOfMirrors(0)
    view.picture()
    lakes.RemoveFrom(view.renderer)
    view.renderer.AddActor(lakes.GetWater())
    view.picture()
    wt.check_equal("alone", wt.decision_of(lakes.GetWater()), "RENDERED")


def test_a_mapper_of_several_data_sets_is_refused():
    lakes = lakes_of(mesh_of((0.0, 0.2)))
    kept = lakes.GetMapper()
    errors = wt.errors_of(lakes)
    lakes.SetMapper(vtkCompositePolyDataMapper())
    wt.check_equal("errors", len(errors), 1)
    text = "CompositePolyDataMapper"
    wt.check_equal("names it", text in errors[0] and "It stays" in errors[0], True)
    wt.check_equal("kept", lakes.GetMapper() is kept, True)


@pytest.mark.parametrize("bad", (np.inf, -np.inf, np.nan, 1e200, 1e300))
def test_a_point_that_is_not_finite_spoils_only_its_cells(bad):
    """One in use takes its cell out; one that no cell uses changes nothing."""
    mesh = mesh_of((0.0, 0.2, 0.4), rows=3)
    mesh.GetPoints().SetPoint(4, bad, 0, bad)  # of a cell of the first patch's two
    mesh.GetPoints().InsertNextPoint(0, bad, bad)
    filtered = vtkWaterPlanesFilter()
    filtered.SetInputData(mesh)
    filtered.Update()
    blocks = [filtered.GetOutput().GetBlock(i) for i in range(filtered.GetNumberOfPlanes())]
    levels = [vtk_to_numpy(block.GetFieldData().GetArray("WaterPlaneOrigin"))[0][2] for block in blocks]
    found = sorted((block.GetNumberOfCells(), round(level, 9)) for block, level in zip(blocks, levels))
    wt.check_equal("cells and levels", found, [(1, 0.0), (2, 0.2), (2, 0.4)])
    wide = max(abs(bound) for block in blocks for bound in block.GetBounds())
    wt.check_at_most("bounds", wide, 3.0)


def test_an_unused_point_does_not_widen_the_only_water():
    mesh = mesh_of((0.0,))
    mesh.GetPoints().InsertNextPoint(0, np.inf, 0)
    filtered = vtkWaterPlanesFilter()
    filtered.SetInputData(mesh)
    filtered.Update()
    wt.check_at_most("bounds", max(abs(bound) for bound in filtered.GetOutput().GetBlock(0).GetBounds()), 1.5)


def test_a_concave_polygon_has_its_own_area():
    mesh, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    cells.InsertNextCell(5)
    for number, (x, y) in enumerate(((0, 0), (4, 0), (4, 4), (2, 1), (0, 4))):
        points.InsertNextPoint(x, y, 0)
        cells.InsertCellPoint(number)
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    filtered = vtkWaterPlanesFilter()
    filtered.SetInputData(mesh)
    filtered.Update()
    area = vtk_to_numpy(filtered.GetOutput().GetBlock(0).GetFieldData().GetArray("WaterArea"))[0]
    wt.check_at_most("area less 10", abs(area - 10), 1e-12)


@pytest.mark.parametrize("corners, has_points, planes, text", (
    ((0, 1, 99), True, 0, "cell 2 has the point 99; points must lie in [0, 7]"),
    ((0, 1, -3), True, 0, "cell 2 has the point -3; points must lie in [0, 7]"),
    ((0, 1, 2), False, 0, "cell 0 has the point 0; the mesh has no points"),
    ((), True, 2, "cell 2 is a polygon of 0 points; it must have at least 3"),
    ((), False, 0, "cell 0 is a polygon of 0 points; it must have at least 3"),
))
def test_a_wrong_cell_is_told(corners, has_points, planes, text):
    mesh = mesh_of((0.0, 0.2)) if has_points else vtkPolyData()
    cells = vtkCellArray()
    cells.DeepCopy(mesh.GetPolys())
    cells.InsertNextCell(len(corners), corners)
    mesh.SetPolys(cells)
    filtered = vtkWaterPlanesFilter()
    errors = wt.errors_of(filtered)
    filtered.SetInputData(mesh)
    filtered.Update()
    wt.check_equal("errors", len(errors), 1)
    wt.check_equal(f"the error says {text!r}", text in errors[0], True)
    wt.check_equal("planes", filtered.GetNumberOfPlanes(), planes)


def test_a_polygon_of_a_grid_with_too_few_points_is_told():
    """Lines and vertices may have so few."""
    mesh = mesh_of((0.0, 0.2))
    grid = vtkUnstructuredGrid()
    grid.SetPoints(mesh.GetPoints())
    for quad in vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 4).tolist():
        grid.InsertNextCell(VTK_QUAD, 4, quad)
    filtered = vtkWaterPlanesFilter()
    errors = wt.errors_of(filtered)
    filtered.SetInputData(grid)
    for kind, corners in ((VTK_LINE, (0, 1)), (VTK_VERTEX, (0,))):
        grid.InsertNextCell(kind, len(corners), corners)
        filtered.Update()
        wt.check_equal("errors for a line and a vertex", errors, [])
    grid.InsertNextCell(VTK_POLYGON, 2, (0, 1))
    grid.Modified()
    filtered.Update()
    text = "cell 4 is a polygon of 2 points; it must have at least 3"
    wt.check_equal(f"the error says {text!r}", [text in error for error in errors], [True])
    wt.check_equal("planes", filtered.GetNumberOfPlanes(), 2)


@pytest.mark.parametrize("make, setter, values, text", (
    (vtkWaterLakes, "SetMaximumNumberOfMirrors", (-1,), "MaximumNumberOfMirrors is -1; it must lie in [0, 4096]"),
    (vtkWaterLakes, "SetMaximumNumberOfPlanes", (0,), "MaximumNumberOfPlanes is 0; it must lie in [1, 4096]"),
    (vtkWaterPlanesFilter, "SetMaximumNumberOfPlanes", (0,), "MaximumNumberOfPlanes is 0; it must lie in [1, 4096]"),
    (vtkWaterPlanesFilter, "SetUpDirection", (0, 0, 0), "UpDirection is (0, 0, 0); it must be finite and not zero"),
))
def test_bad_values_are_refused(make, setter, values, text):
    made = make()
    errors = wt.errors_of(made)
    getattr(made, setter)(*values)
    wt.check_equal("errors", len(errors), 1)
    wt.check_equal(f"the error says {text!r}", text in errors[0], True)


def test_a_water_may_reflect_the_sky_alone():
    view = view_of(things())
    water = wt.add_water(view.renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-9, 9, -1.5, 1.5))
    water.SceneReflectionOff()
    view.picture()
    wt.check_equal("decision", wt.decision_of(water), "STATIC_ENVIRONMENT")
    other = vtkWaterActor()
    other.ShallowCopy(water)
    wt.check_equal("copied", other.GetSceneReflection(), False)
    water.SceneReflectionOn()
    view.picture()
    wt.check_equal("decision", wt.decision_of(water), "RENDERED")

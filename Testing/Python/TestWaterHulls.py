# SPDX-License-Identifier: BSD-3-Clause
"""No water is drawn inside a hull that floats in it, and all other pixels stay as they were."""

import re
import time

import numpy as np
import pytest
import ray_caster
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper
from vtkwater import vtkWaterActor

SIZE = (240, 180)
SKY = (0.55, 0.7, 0.9)
BOW = np.array(((-4, -1.5), (2, -1.5), (5, 0), (2, 1.5), (-4, 1.5)), dtype=float)
HOLD = BOW * 0.8
EYE = (6, -14, 11)


def prism(outline, low, high, bottom=True):
    """An outline's sides, and its bottom, without a lid; corners of their own for each polygon."""
    count = len(outline)
    points, polygons = [], []
    for i in range(count):
        (ax, ay), (bx, by) = outline[i], outline[(i + 1) % count]
        polygons.append(range(len(points), len(points) + 4))
        points += [(ax, ay, low), (bx, by, low), (bx, by, high), (ax, ay, high)]
    if bottom:
        polygons.append(range(len(points), len(points) + count))
        points += [(x, y, low) for x, y in outline]
    data, places, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetDataTypeToDouble()
    places.SetData(numpy_to_vtk(np.array(points, dtype=float), deep=True))
    for polygon in polygons:
        cells.InsertNextCell(len(polygon), list(polygon))
    data.SetPoints(places)
    data.SetPolys(cells)
    return data


def thick_walled():
    """A boat whose walls have two sides."""
    both = vtkAppendPolyData()
    both.AddInputData(prism(BOW, -1.0, 1.5))
    both.AddInputData(prism(HOLD, -0.8, 1.5))
    both.Update()
    return both.GetOutput()


class Scene:
    """A boat, a bed, and water; without it; and with a hull or without."""

    def __init__(self, meshes, set_look=None, parallel=False, eye=EYE):
        self.view = wt.View(SIZE, SKY)
        self.boats = [wt.add_actor(self.view.renderer, mesh, (0.8, 0.3, 0.2)) for mesh in meshes]
        wt.add_actor(self.view.renderer, wt.box((0, 0, -6), (80, 80, 1)), (0.6, 0.55, 0.4))
        self.water = vtkWaterActor()
        self.water.SetSheetBounds(-30, 30, -30, 30)
        if set_look:
            set_look(self.water.GetWaterProperty())
        self.view.renderer.AddActor(self.water)
        camera = wt.place_camera(self.view.renderer, eye, (0, 0.01, 0), (0.5, 120))
        camera.SetParallelProjection(parallel)
        camera.SetParallelScale(5)

    def dry(self):
        self.water.VisibilityOff()
        picture = self.view.picture()
        self.water.VisibilityOn()
        return picture

    def places(self):
        """Where the pixels' rays meet the water's plane: (rows, columns, 2), row 0 as in pictures."""
        start, ray = ray_caster.eye_rays(self.view.renderer.GetActiveCamera(), SIZE, 1)
        place = start - (start[:, 2:] / ray[:, 2:]) * ray
        return place[:, :2].reshape(SIZE[1], SIZE[0], 2)


def is_in(outline, places):
    """Which places are inside a convex outline, counter-clockwise."""
    inside = np.ones(places.shape[:2], dtype=bool)
    for a, b in zip(outline, np.roll(outline, -1, axis=0)):
        inside &= (b - a)[0] * (places[..., 1] - a[1]) - (b - a)[1] * (places[..., 0] - a[0]) > 0
    return inside


def check(name, scene, inside):
    """Inside the waterline the picture is the one without water, outside it the one without hulls."""
    wet, dry = scene.view.picture(), scene.dry()
    for boat in scene.boats:
        scene.water.AddHull(boat)
    shown = scene.view.picture()
    wt.save(shown, wt.output_folder() / f"hulls_{name.replace(' ', '_')}.png")
    flooded = inside & (np.abs(wet - dry).max(axis=2) > 8)
    wt.check_at_least(f"{name}: pixels that were wet inside", int(flooded.sum()), 200)
    wt.check_equal(f"{name}: pixels with water inside", int((shown != dry)[inside].any(axis=1).sum()), 0)
    wt.check_equal(f"{name}: pixels that changed outside", int((shown != wet)[~inside].any(axis=1).sum()), 0)
    wt.check_equal(f"{name}: error", scene.water.GetLastError(), "")


def clear(look):
    look.RefractionOn()
    look.SetAbsorption(0.5, 0.2, 0.1)


def waves(look):
    look.AddWave(0.2, 6.0, 30.0, 20.0)
    look.AddWave(0.08, 2.5, 100.0, 0.0, 0.6)


def displaced(look):
    waves(look)
    look.WaveGeometryOn()


def displaced_sea(look):
    look.SetSea(True)
    look.SetWindSpeed(6)
    look.SetSeaTileSize(64)
    look.WaveGeometryOn()


@pytest.mark.parametrize("set_look", [None, clear, waves], ids=["opaque", "clear", "waves"])
@pytest.mark.parametrize("mesh", ["thin", "thick"])
def test_an_open_boat_is_dry(mesh, set_look):
    """An open boat's hold has no water, be its walls thin or thick."""
    scene = Scene([prism(BOW, -1.0, 1.5) if mesh == "thin" else thick_walled()], set_look)
    check(f"boat {mesh} {set_look.__name__ if set_look else 'opaque'}", scene, is_in(BOW, scene.places()))


@pytest.mark.parametrize("set_look", [displaced, displaced_sea], ids=lambda look: look.__name__)
def test_a_boat_is_dry_among_waves_that_move_the_surface(set_look):
    """Seen straight from above a pixel shows the water over its own place, however high that is."""
    scene = Scene([prism(BOW, -2.0, 2.5)], set_look, parallel=True, eye=(0, 0, 60))
    scene.view.renderer.GetActiveCamera().SetViewUp(0, 1, 0)
    scene.view.renderer.GetActiveCamera().SetFocalPoint(0, 0, 0)
    scene.water.SetTime(3.0)
    check(set_look.__name__, scene, is_in(BOW, scene.places()))


def flared(layers=46, parts=24):
    """A boat whose sides lean out, of small polygons: half as wide at z = -2 as at 2.5."""
    around = np.concatenate([a + (b - a) * (np.arange(parts) / parts)[:, None]
                             for a, b in zip(BOW, np.roll(BOW, -1, axis=0))])
    count = len(around)
    points = np.concatenate([np.column_stack((around * wide_at(z), np.full(count, z)))
                             for z in np.linspace(-2, 2.5, layers)])
    first = np.arange(count)
    ids = [np.stack((low + first, low + np.roll(first, -1), low + count + np.roll(first, -1), low + count + first), axis=1)
           for low in count * np.arange(layers - 1)]
    data, places, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetDataTypeToDouble()
    places.SetData(numpy_to_vtk(points, deep=True))
    cells.SetData(4, numpy_to_vtkIdTypeArray(np.concatenate(ids).ravel().astype(np.int64), deep=True))
    data.SetPoints(places)
    data.SetPolys(cells)
    return data


def wide_at(z):
    return 0.5 + 0.5 * (np.asarray(z)[..., None] + 2) / 4.5


def test_a_flared_boat_has_its_waterline_where_the_waves_are():
    """Sides that lean out: inside is where they cut the waves, and not the plane."""
    scene = Scene([flared()], displaced, parallel=True, eye=(0, 0, 60))
    scene.view.renderer.GetActiveCamera().SetViewUp(0, 1, 0)
    scene.view.renderer.GetActiveCamera().SetFocalPoint(0, 0, 0)
    wet, dry = scene.view.picture(), scene.dry()
    scene.water.AddHull(scene.boats[0])
    shown = scene.view.picture()
    places = scene.places()
    heights = np.array([[scene.water.GetWaveHeight(x, y) for x, y in row] for row in places])
    inside = is_in(BOW, places / wide_at(heights))
    sure = is_in(BOW, places / (wide_at(heights) - 0.02))
    plain = is_in(BOW, places / wide_at(np.zeros_like(heights)))
    wt.check_at_least("pixels that the waves make another waterline of", int((plain != inside).sum()), 100)
    wt.check_at_least("pixels that were wet inside", int((sure & (wet != dry).any(axis=2)).sum()), 300)
    wt.check_equal("pixels with water inside", int((shown != dry)[sure].any(axis=1).sum()), 0)
    no = ~is_in(BOW, places / (wide_at(heights) + 0.02))
    wt.check_equal("pixels that changed outside", int((shown != wet)[no].any(axis=1).sum()), 0)


def test_it_follows_the_boat():
    """A boat that is moved, turned and pitched takes its dry place along."""
    scene = Scene([prism(BOW, -1.0, 1.5)], eye=(3, -8, 20))
    boat = scene.boats[0]
    scene.water.AddHull(boat)
    scene.view.picture()
    boat.SetPosition(-2.0, 1.5, 0.3)
    boat.RotateZ(40)
    turn = np.radians(40)
    outline = BOW @ np.array(((np.cos(turn), np.sin(turn)), (-np.sin(turn), np.cos(turn)))) + (-2.0, 1.5)
    shown, inside = scene.view.picture(), is_in(outline, scene.places())
    scene.water.RemoveAllHulls()
    wet, dry = scene.view.picture(), scene.dry()
    wt.check_at_least("pixels that were wet inside", int(((wet != dry).any(axis=2) & inside).sum()), 300)
    wt.check_equal("pixels with water inside", int((shown != dry)[inside].any(axis=1).sum()), 0)
    wt.check_equal("pixels that changed outside", int((shown != wet)[~inside].any(axis=1).sum()), 0)


def test_hulls_that_overlap_are_dry_both():
    """Where two hulls overlap there is no water either, nor in one that is inside another."""
    box = np.array(((-6, -1), (-2, -1), (-2, 3), (-6, 3)), dtype=float)
    scene = Scene([prism(BOW, -1.0, 1.5), prism(box, -1.0, 1.5), prism(HOLD, -0.9, 1.4)])
    places = scene.places()
    check("overlapping", scene, is_in(BOW, places) | is_in(box, places))


def test_a_tilted_plane_has_hulls_too():
    """Water of any plane: all of the scene is turned about x."""
    scene = Scene([prism(BOW, -1.0, 1.5)])
    scene.water.SetPlane(wt.plane((0, 0, 0), (0, -np.sin(0.3), np.cos(0.3))))
    scene.water.SetMapper(None)
    wet, dry = scene.view.picture(), scene.dry()
    scene.water.AddHull(scene.boats[0])
    shown = scene.view.picture()
    start, ray = ray_caster.eye_rays(scene.view.renderer.GetActiveCamera(), SIZE, 1)
    normal = np.array((0, -np.sin(0.3), np.cos(0.3)))
    place = (start - ((start @ normal) / (ray @ normal))[:, None] * ray).reshape(SIZE[1], SIZE[0], 3)
    inside = is_in(BOW, place[..., :2])
    wt.check_at_least("pixels that were wet inside", int(((wet != dry).any(axis=2) & inside).sum()), 200)
    wt.check_equal("pixels with water inside", int((shown != dry)[inside].any(axis=1).sum()), 0)
    wt.check_equal("pixels that changed outside", int((shown != wet)[~inside].any(axis=1).sum()), 0)


def errors_of(water):
    """For each error, what the water gave as its last error while it was told."""
    errors = []
    water.AddObserver("ErrorEvent", lambda *_: errors.append(water.GetLastError()))
    return errors


def test_a_hull_that_is_not_closed_is_an_error_once():
    """It has water inside, the picture stays as it was, and another hull is dry all the same."""
    leaky = prism(BOW, -1.0, 1.5)
    leaky.BuildCells()
    leaky.DeleteCell(0)
    leaky.RemoveDeletedCells()
    box = np.array(((-8, 2), (-5, 2), (-5, 5), (-8, 5)), dtype=float)
    scene = Scene([leaky, prism(box, -1.0, 1.5)])
    wet = scene.view.picture()
    errors = errors_of(scene.water)
    scene.water.AddHull(scene.boats[0])
    shown = scene.view.picture()
    scene.water.SetTime(1.0)
    scene.view.picture()
    wt.check_equal("errors", len(errors), 1)
    wt.check_equal("the last error names the hull", "is not closed" in errors[0], True)
    wt.check_equal("the last error stays", scene.water.GetLastError(), errors[0])
    wt.check_equal("pixels that changed", int((shown != wet).any(axis=2).sum()), 0)
    scene.water.AddHull(scene.boats[1])
    both = scene.view.picture()
    wt.check_at_least("pixels that the other hull makes dry", int((both != wet).any(axis=2).sum()), 30)
    scene.water.RemoveAllHulls()
    scene.view.picture()
    wt.check_equal("the last error without hulls", scene.water.GetLastError(), "")


def test_the_error_names_the_open_place_in_the_world():
    """Also if the plane has its origin elsewhere."""
    leaky = prism(BOW, -1.0, 1.5)
    leaky.BuildCells()
    leaky.DeleteCell(0)
    leaky.RemoveDeletedCells()
    scene = Scene([leaky])
    scene.water.GetPlane().SetOrigin(12.0, 9.0, 0.0)
    texts = wt.errors_of(scene.water)
    scene.water.AddHull(scene.boats[0])
    scene.view.picture()
    place = [float(part) for part in re.search(r"where the water cuts it, at \((.*?)\)", texts[0]).group(1).split(", ")]
    bounds = scene.boats[0].GetBounds()
    is_inside = [bounds[2 * i] - 1e-3 <= place[i] <= bounds[2 * i + 1] + 1e-3 for i in range(3)]
    wt.check_equal(f"{place} lies in {bounds}", is_inside, [True] * 3)


def test_what_is_no_hull_is_left_out():
    """nullptr and the water itself are errors; an actor without a mesh is; twice is once; out of the water is nothing."""
    scene = Scene([prism(BOW, 3.0, 4.0), prism(BOW, -5.0, -3.0)])
    wet = scene.view.picture()
    errors = errors_of(scene.water)
    scene.water.AddHull(None)
    scene.water.AddHull(scene.water)
    wt.check_equal("errors", (len(errors), scene.water.GetNumberOfHulls()), (2, 0))
    for boat in scene.boats + scene.boats:
        scene.water.AddHull(boat)
    wt.check_equal("hulls", scene.water.GetNumberOfHulls(), 2)
    wt.check_equal("pixels that changed", int((scene.view.picture() != wet).any(axis=2).sum()), 0)
    wt.check_equal("the second", scene.water.GetHull(1), scene.boats[1])
    wt.check_equal("none", (scene.water.GetHull(2), scene.water.GetHull(-1)), (None, None))
    scene.water.RemoveHull(scene.boats[0])
    wt.check_equal("hulls that are left", scene.water.GetNumberOfHulls(), 1)
    scene.boats[1].SetMapper(None)
    scene.view.picture()
    wt.check_equal("errors", len(errors), 3)


def moved_by(far):
    """A closed box in another place."""
    mesh = prism(np.array(((-8, 2), (-5, 2), (-5, 5), (-8, 5)), dtype=float), -1.0, 1.5)
    vtk_to_numpy(mesh.GetPoints().GetData())[:, 0] += far
    return mesh


def with_a_wrong_point():
    mesh = prism(BOW, -1.0, 1.5)
    mesh.GetPolys().InsertNextCell(3, [0, 1, 10_000_000])
    return mesh


def line():
    mesh = vtkPolyData()
    mesh.SetPoints(prism(BOW, -1.0, 1.5).GetPoints())
    cells = vtkCellArray()
    cells.InsertNextCell(2, [0, 1])
    mesh.SetLines(cells)
    return mesh


@pytest.mark.parametrize("bad", (moved_by(1e30), moved_by(np.nan), moved_by(np.inf), with_a_wrong_point(),
                                 line()), ids=("far", "nan", "infinite", "wrong_point", "line"))
def test_a_bad_hull_leaves_the_others_dry(bad):
    good, both = Scene([prism(BOW, -1.0, 1.5)]), Scene([prism(BOW, -1.0, 1.5)])
    good.water.AddHull(good.boats[0])
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(bad)
    hull = vtkActor()
    hull.SetMapper(mapper)
    errors = errors_of(both.water)
    both.water.AddHull(both.boats[0])
    both.water.AddHull(hull)
    off = (good.view.picture() != both.view.picture()).any(axis=2)
    wt.check_equal("errors", len(errors), 1)
    wt.check_equal("pixels that differ", int(off.sum()), 0)


def disc(sides, x):
    angles = np.linspace(0, 2 * np.pi, sides, endpoint=False)
    return prism(np.stack([x + 3 * np.cos(angles), 3 * np.sin(angles)], axis=-1), -1.0, 1.5)


def test_a_table_that_is_too_large_is_an_error_once():
    """Two hulls of many edges far apart; the picture is the one without hulls."""
    scene = Scene([disc(18000, 0.0), disc(18000, 10000.0)])
    wet = scene.view.picture()
    errors = errors_of(scene.water)
    for boat in scene.boats:
        scene.water.AddHull(boat)
    shown = scene.view.picture()
    scene.water.SetTime(1.0)
    scene.view.picture()
    wt.check_equal("errors", len(errors), 1)
    wt.check_equal("pixels that changed", int((shown != wet).any(axis=2).sum()), 0)


def test_a_water_is_no_hull_and_a_copy_of_itself_keeps_its_hulls():
    scene = Scene([prism(BOW, -1.0, 1.5)])
    other = vtkWaterActor()
    errors, others = errors_of(scene.water), errors_of(other)
    scene.water.AddHull(other)
    other.AddHull(scene.water)
    wt.check_equal("hulls", (scene.water.GetNumberOfHulls(), other.GetNumberOfHulls()), (0, 0))
    wt.check_equal("errors", (len(errors), len(others)), (1, 1))
    scene.water.GetMTime()
    scene.water.AddHull(scene.boats[0])
    scene.water.ShallowCopy(scene.water)
    wt.check_equal("hulls of a copy of itself", scene.water.GetNumberOfHulls(), 1)


def test_a_hull_that_has_not_moved_is_not_cut_again():
    """A small hull moves beside a ship of more than a million triangles: the ship's cut is kept, and is right."""
    box = np.array(((-8, 2), (-5, 2), (-5, 5), (-8, 5)), dtype=float)
    scene = Scene([wt.sphere((0, -2, 0), 2.0, 800), prism(box, -1.0, 1.5)])
    for boat in scene.boats:
        boat.VisibilityOff()  # what is drawn counts for both
        scene.water.AddHull(boat)
    scene.view.picture()
    works = []
    for boat in scene.boats:
        moves = []
        for move in range(1, 6):
            boat.SetPosition(0.01 * move, 0.0, 0.0)
            begin = time.process_time()
            scene.view.window.Render()
            moves.append(time.process_time() - begin)
        works.append(min(moves))
    wt.check_at_most("work when the small one moves / when the ship moves", works[1] / works[0], 0.5)
    shown = scene.view.picture()
    for boat in scene.boats:
        scene.water.RemoveHull(boat)
        scene.water.AddHull(boat)
    wt.check_equal("pixels that differ from hulls added anew", int((shown != scene.view.picture()).sum()), 0)

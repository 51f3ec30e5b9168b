# SPDX-License-Identifier: BSD-3-Clause
"""An automatic sheet is as wide as a scene that has ground under all of its water, and else reaches to the horizon."""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPlane, vtkPlaneCollection, vtkStructuredGrid
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkFeatureEdges
from vtkmodules.vtkFiltersGeneral import vtkClipClosedSurface
from vtkmodules.vtkFiltersGeometry import vtkStructuredGridGeometryFilter
from vtkmodules.vtkFiltersSources import vtkCylinderSource, vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkAreaPicker, vtkAssembly, vtkCompositePolyDataMapper, vtkPolyDataMapper
from vtkwater import vtkWaterActor


def surface_of(x, y, heights):
    """A mesh of heights over a grid."""
    points = len(x)
    grid = vtkStructuredGrid()
    grid.SetDimensions(points, points, 1)
    vertices = vtkPoints()
    vertices.SetData(numpy_to_vtk(np.stack([x, y, heights], axis=-1).reshape(-1, 3), deep=True))
    grid.SetPoints(vertices)
    outside = vtkStructuredGridGeometryFilter()
    outside.SetInputData(grid)
    outside.Update()
    return outside.GetOutput()


def terrain(size=10.0, points=40, place=(0.0, 0.0, 0.0)):
    x, y = np.meshgrid(*[np.linspace(-0.5, 0.5, points)] * 2)
    heights = 0.08 * np.sin(9 * x) * np.cos(7 * y)
    return surface_of(size * x + place[0], size * y + place[1], size * heights + place[2])


def of_blocks(data):
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, data)
    mapper = vtkCompositePolyDataMapper()
    mapper.SetInputDataObject(blocks)
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def actor_of(data):
    mapper = vtkPolyDataMapper()
    if data:
        mapper.SetInputData(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def in_assembly(data):
    """Moved and turned by what it is a part of."""
    assembly = vtkAssembly()
    actor = actor_of(data)
    actor.SetPosition(100, 50, 0)
    assembly.AddPart(actor)
    assembly.RotateZ(90)
    return assembly


def pool():
    floor, wall = wt.box((0, 0, -2.1), (12, 6, 0.2)), wt.box((0, 3.1, -1), (12.4, 0.2, 2.5))
    return [actor_of(floor), actor_of(wall)]


def beach(parts):
    source = vtkPlaneSource()
    source.SetOrigin(-5, -5, -1)
    source.SetPoint1(5, -5, -1)
    source.SetPoint2(-5, 5, 1)
    source.SetResolution(parts, parts)
    source.Update()
    return actor_of(source.GetOutput())


def terrain_block(height):
    """A terrain with a skirt and a base; height: of its lowest point over the base."""
    x, y = np.meshgrid(*[np.linspace(-5.0, 5.0, 40)] * 2)
    heights = 0.8 * np.sin(0.9 * x) * np.cos(0.7 * y)
    points = vtkPoints()
    layers = [np.stack([x, y, z], axis=-1) for z in (np.full_like(x, -0.8 - height), heights)]
    points.SetData(numpy_to_vtk(np.stack(layers).reshape(-1, 3), deep=True))
    grid = vtkStructuredGrid()
    grid.SetDimensions(40, 40, 2)
    grid.SetPoints(points)
    outside = vtkStructuredGridGeometryFilter()
    outside.SetInputData(grid)
    outside.Update()
    return outside.GetOutput()


def island(steepness):
    x, y = np.meshgrid(*[np.linspace(-5.0, 5.0, 60)] * 2)
    return surface_of(x, y, 1.0 - steepness * np.hypot(x, y))


def cone(resolution, angle):
    actor = actor_of(wt.pyramid((0, 0, 0), 2, resolution))
    actor.RotateZ(angle)
    return actor


def cylinder(center, height):
    source = vtkCylinderSource()
    source.SetResolution(32)
    source.SetHeight(height)
    actor = actor_of(None)
    actor.GetMapper().SetInputConnection(source.GetOutputPort())
    actor.RotateX(90)
    actor.SetPosition(0, 0, center)
    return actor


def half_sphere():
    """Closed by a disc."""
    cut = vtkPlane()
    cut.SetOrigin(0, 0, -0.5)
    cut.SetNormal(0, 0, 1)
    planes = vtkPlaneCollection()
    planes.AddItem(cut)
    clip = vtkClipClosedSurface()
    clip.SetInputData(wt.sphere((0, 0, -0.5), 1))
    clip.SetClippingPlanes(planes)
    clip.Update()
    return actor_of(clip.GetOutput())


LAND = {
    "land with a skirt": lambda: [actor_of(terrain_block(0.5))],
    "land with a high skirt": lambda: [actor_of(terrain_block(5.0))],
    "an island's bed": lambda: [actor_of(island(0.3))],
    "a steep island's bed": lambda: [actor_of(island(2.0))],
    "beach of one face": lambda: [beach(1)],
    "beach of nine faces": lambda: [beach(3)],
    "terrain": lambda: [actor_of(terrain())],
    "terrain of a millimetre": lambda: [actor_of(terrain(1e-3))],
    "terrain of 10,000 km": lambda: [actor_of(terrain(1e7))],
    "terrain of 250,000 points": lambda: [actor_of(terrain(10.0, 500))],
    "terrain far away": lambda: [actor_of(terrain(10.0, 40, (1e6, 2e6, 0)))],
    "terrain in blocks": lambda: [of_blocks(terrain())],
    "terrain in an assembly": lambda: [in_assembly(terrain())],
    "terrain and a tower": lambda: [actor_of(terrain()), actor_of(wt.box((1, 1, 2), (0.5, 0.5, 4)))],
    "two halves": lambda: [actor_of(terrain()), actor_of(terrain(10.0, 40, (10, 0, 0)))],
    "pool": pool,
}
SEA = {
    "cone of six sides": lambda: [cone(6, 0)],
    "cone of four sides": lambda: [cone(4, 0)],
    "pyramid": lambda: [cone(4, 45)],
    "cone": lambda: [cone(64, 0)],
    "cone far below": lambda: [moved(cone(4, 45), -3)],
    "cylinder": lambda: [cylinder(0, 1)],
    "low cylinder": lambda: [cylinder(0, 0.1)],
    "column below": lambda: [moved(actor_of(wt.box((0, 0, 0), (1, 1, 1))), -2)],
    "half a sphere": lambda: [half_sphere()],
    "barge": lambda: [actor_of(wt.box((0, 0, 0), (20, 4, 2)))],
    "slab of land with water at its side": lambda: [moved(actor_of(terrain_block(5.0)), 2.5)],
    "sphere": lambda: [actor_of(wt.sphere((0, 0, 0), 1))],
    "block": lambda: [actor_of(wt.box((0, 0, 0), (2, 3, 4)))],
    "low block": lambda: [actor_of(wt.box((0, 0, 0), (2, 2, 1)))],
    "islands": lambda: [actor_of(wt.sphere((x, x * x, 0), 1)) for x in (0, 3, 7)],
    "terrain and a ship far out": lambda: [actor_of(terrain()), actor_of(wt.box((40, 0, 0), (2, 1, 1)))],
    "invisible terrain": lambda: [actor_of(wt.sphere((0, 0, 0), 1)), hidden(actor_of(terrain()))],
}


def moved(actor, height):
    actor.SetPosition(0, 0, height)
    return actor


def hidden(actor):
    actor.VisibilityOff()
    return actor


def scene_of(props, water_first=False):
    view = wt.View((64, 48))
    water = vtkWaterActor()
    water.SetSheetToAutomatic()
    for prop in [water, *props] if water_first else [*props, water]:
        view.renderer.AddViewProp(prop)
    view.renderer.ResetCamera()
    view.picture()
    return view, water


@pytest.mark.parametrize("water_first", (False, True))
@pytest.mark.parametrize("name", LAND, ids=lambda name: name.replace(" ", "_"))
def test_ground_ends_the_water(name, water_first):
    view, water = scene_of(LAND[name](), water_first)
    wt.check_equal("it reaches to the horizon", water.GetSheetToHorizon(), False)
    wt.check_equal("errors", water.GetLastError(), "")
    bounds = np.array(water.GetBounds())
    water.VisibilityOff()
    scene = np.array(view.renderer.ComputeVisiblePropBounds())
    if name.startswith("beach"):
        wt.check_equal("it is within the scene", bool(scene[2] <= bounds[2] < bounds[3] <= scene[3]), True)
    else:
        wt.check_at_most("as wide as the scene, off by, of that",
                         float(np.abs(bounds - scene)[:4].max() / np.ptp(scene[:2])), 1e-6)


@pytest.mark.parametrize("water_first", (False, True))
@pytest.mark.parametrize("name", SEA, ids=lambda name: name.replace(" ", "_"))
def test_open_water_goes_to_the_horizon(name, water_first):
    _, water = scene_of(SEA[name](), water_first)
    wt.check_equal("it reaches to the horizon", water.GetSheetToHorizon(), True)
    wt.check_equal("it has no bounds", water.GetBounds(), None)
    wt.check_equal("errors", water.GetLastError(), "")


def test_it_is_looked_at_again_when_the_scene_changes():
    ship, land = actor_of(wt.box((0, 0, 0), (2, 1, 1))), actor_of(terrain())
    view, water = scene_of([ship])
    for what, change, is_endless in (
            ("a ship", lambda: None, True), ("land comes", lambda: view.renderer.AddActor(land), False),
            ("the ship leaves", lambda: ship.SetPosition(60, 0, 0), True), ("and returns", lambda: ship.SetPosition(0, 0, 0), False),
            ("the land rises", lambda: land.SetPosition(0, 0, 3), False), ("it goes", lambda: view.renderer.RemoveActor(land), True)):
        change()
        view.picture()
        wt.check_equal(what, water.GetSheetToHorizon(), is_endless)


def test_an_empty_scene_is_silent():
    view = wt.View((64, 48))
    water = vtkWaterActor()
    water.SetSheetToAutomatic()
    said = wt.errors_of(water)
    view.renderer.AddActor(water)
    wt.check_equal("bounds asked before any mesh: to the horizon", (water.GetBounds(), water.GetSheetToHorizon())[1], False)
    view.renderer.AddActor(actor_of(wt.sphere((0, 0, 0), 1)))
    view.renderer.ResetCamera()
    view.picture()
    wt.check_equal("then", water.GetSheetToHorizon(), True)
    wt.check_equal("errors", said, [])


def test_other_planes_have_their_own_ground():
    """A terrain that stands upright is ground for upright water, and none for level water."""
    actor = actor_of(terrain())
    actor.RotateX(90)
    view, water = scene_of([actor])
    wt.check_equal("level water", water.GetSheetToHorizon(), True)
    plane = vtkPlane()
    plane.SetNormal(0, -1, 0)
    water.SetPlane(plane)
    view.picture()
    wt.check_equal("upright water", water.GetSheetToHorizon(), False)


def test_the_last_word_counts():
    _, water = scene_of(SEA["sphere"]())
    other = vtkWaterActor()
    other.ShallowCopy(water)
    wt.check_equal("a copy is automatic", other.GetSheetIsAutomatic(), True)
    wt.check_equal("printed", "to the horizon (automatic)" in str(water), True)
    for name, change in (("SetSheetBounds", lambda: water.SetSheetBounds(-1, 1, -1, 1)), ("ResetSheetBounds", water.ResetSheetBounds),
                         ("SetSheetToHorizon", water.SetSheetToHorizon)):
        water.SetSheetToAutomatic()
        change()
        wt.check_equal(f"automatic after {name}", water.GetSheetIsAutomatic(), False)
        wt.check_equal(f"to the horizon after {name}", water.GetSheetToHorizon(), name == "SetSheetToHorizon")


def basin_data(points=129, lower=0.0):
    """Land that stands out of the water along all of its border; lower: by how much it is, but at its border and its middle."""
    x, y = np.meshgrid(*[np.linspace(-0.5, 0.5, points)] * 2)
    heights = 0.8 * np.hypot(x, y) - 0.2 + 0.03 * np.sin(20 * x) * np.cos(17 * y)
    inside = (np.maximum(np.abs(x), np.abs(y)) < 0.45) & (heights > -0.1)
    return surface_of(10 * x, 10 * y, 10 * (heights - lower * inside))


def basin(points=129):
    return actor_of(basin_data(points))


def of_basin(is_automatic, position, level=0.0, clear=False):
    view = wt.View((240, 180), (0.6, 0.7, 0.8))
    view.renderer.AddActor(basin())
    water = vtkWaterActor()
    water.SetLevel(level)
    water.GetWaterProperty().SetRefraction(clear)
    if is_automatic:
        water.SetSheetToAutomatic()
    view.renderer.AddActor(water)
    wt.place_camera(view.renderer, position, (0, 0, 0), (0.5, 60))
    return view, water


@pytest.mark.parametrize("clear", (False, True))
@pytest.mark.parametrize("level", (0.0, -1.0, 0.8))
def test_no_water_is_seen_under_the_land(level, clear):
    """From above the picture is that of a whole sheet; from the side, under the land's border, next to nothing of it is seen."""
    whole, _ = of_basin(False, (0.5, -1, 18), level, clear)
    automatic, _ = of_basin(True, (0.5, -1, 18), level, clear)
    off = np.abs(whole.picture() - automatic.picture()).max(axis=2) > 1
    wt.check_at_most("from above: share of pixels that differ", float(off.mean()), 0.0005)
    side = (3, -14, level - 0.5)
    seen = [int(wt.water_mask(*of_basin(is_automatic, side, level)).sum()) for is_automatic in (False, True)]
    wt.check_at_least("from the side: pixels of a whole sheet", seen[0], 300)
    wt.check_at_most("of an automatic one, share of those", seen[1] / seen[0], 0.02)


def test_the_sheet_has_few_parts_and_no_gap():
    """A vertex inside another part's edge would leave a gap where their pixels meet."""
    view, water = of_basin(True, (0.5, -1, 18))
    view.picture()
    sheet = water.GetMapper().GetInput()
    cleaner = vtkCleanPolyData()
    cleaner.SetInputData(sheet)
    cleaner.SetTolerance(0)
    edges = vtkFeatureEdges()
    edges.SetInputConnection(cleaner.GetOutputPort())
    edges.FeatureEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.Update()
    border = edges.GetOutput()
    places = vtk_to_numpy(cleaner.GetOutput().GetPoints().GetData())[:, :2]
    assert 100 < border.GetNumberOfCells()
    assert sheet.GetNumberOfCells() < 900
    for i in range(border.GetNumberOfCells()):
        ends = [np.array(border.GetPoint(border.GetCell(i).GetPointId(end))[:2]) for end in (0, 1)]
        along = ends[1] - ends[0]
        share = (places - ends[0]) @ along / (along @ along)
        off = np.linalg.norm(places - ends[0] - share[:, None] * along, axis=1)
        assert not ((off < 1e-9) & (share > 1e-6) & (share < 1 - 1e-6)).any()


def test_water_that_rises_covers_more():
    view, water = of_basin(True, (4, -9, 14))
    seen = []
    for level in (-1.5, 0.0, 1.5, 6.0):
        water.SetLevel(level)
        seen.append(int(wt.water_mask(view, water).sum()))
    wt.check_equal("pixels of water grow with the level", seen == sorted(set(seen)) and seen[0] > 0, True)


def test_land_that_changes_within_its_bounds_is_looked_at_again():
    """Where land sinks that was dry there is water: the picture is that of a whole sheet."""
    pictures = []
    for is_automatic in (False, True):
        view, water = of_basin(is_automatic, (0.5, -1, 18))
        view.picture()
        land = next(actor for actor in view.renderer.GetActors() if actor is not water)
        before = np.array(land.GetBounds())
        land.GetMapper().SetInputData(basin_data(lower=0.1))
        wt.check_at_most("bounds change by", float(np.abs(land.GetBounds() - before).max()), 1e-6)
        pictures.append(view.picture())
    off = np.abs(pictures[0] - pictures[1]).max(axis=2) > 1
    wt.check_at_most("share of pixels that differ", float(off.mean()), 0.0005)


def test_area_pickers_pass_endless_water():
    """They ask each pickable prop for its bounds, which a sheet to the horizon has not."""
    view, water = scene_of(SEA["sphere"]())
    picker = vtkAreaPicker()
    picker.AreaPick(0, 0, 63, 47, view.renderer)
    wt.check_equal("props found", picker.GetProp3Ds().GetNumberOfItems(), 1)
    wt.check_equal("pickable", (water.GetPickable(), water.GetSheetToHorizon()), (0, True))
    water.ResetSheetBounds()
    wt.check_equal("a sheet with bounds is pickable", water.GetPickable(), 1)


@pytest.mark.parametrize("points", (20, 46, 55, 60, 64, 90, 128))
def test_no_grid_of_bars_hangs_under_coarse_land(points):
    """Wherever a mesh's points lie in the cells, land that is dry has no water under it."""
    view = wt.View((240, 180), (0.6, 0.7, 0.8))
    view.renderer.AddActor(basin(points))
    water = vtkWaterActor()
    water.SetSheetToAutomatic()
    view.renderer.AddActor(water)
    wt.place_camera(view.renderer, (3, -14, -4), (0, 0, 0), (0.5, 60))
    view.picture()
    low, high = np.array(water.GetBounds())[:4].reshape(2, 2).T
    wt.check_at_most("width of the water, of the land's 10", float((high - low).max()), 7.5)


@pytest.mark.parametrize("size", (1e-3, 1.0, 1e6))
@pytest.mark.parametrize("lowest, share", ((0.0, (0.4, 1.0)), (0.2, (0.0, 0.15))))
def test_the_floor_of_a_tank_is_seen(size, lowest, share):
    """The bed of unknown unit that is flat is there to be seen; of another one, deep places are hidden."""
    pictures = []
    for grey in (0.1, 0.9):
        x, y = np.meshgrid(*[np.linspace(-0.5, 0.5, 129)] * 2)
        inside = np.maximum(np.abs(x), np.abs(y)) < 0.45
        heights = np.where(inside, -0.2 + lowest * np.hypot(x, y), 0.05)
        land = actor_of(surface_of(size * x, size * y, size * heights))
        land.GetProperty().SetColor(grey, grey, grey)
        land.GetProperty().LightingOff()
        view = wt.View((120, 90), (0.6, 0.7, 0.8))
        view.renderer.AddActor(land)
        water = vtkWaterActor()
        water.GetWaterProperty().RefractionOn()
        water.GetWaterProperty().SetUnits("automatic")
        water.SetSheetToAutomatic()
        view.renderer.AddActor(water)
        wt.place_camera(view.renderer, (0, -0.01 * size, 2 * size), (0, 0, 0), (0.5 * size, 4 * size))
        pictures.append(view.picture()[45, 60] / 255)
    through = float((pictures[1] - pictures[0])[1])
    wt.check_at_least("a white floor against a black one, green", through, share[0])
    wt.check_at_most("the same", through, share[1])


@pytest.mark.parametrize("samples", (0, 4))
def test_ground_behind_its_own_rim_is_not_deep_water(samples):
    """At a low angle the rim of a basin hides the bed that rays through the water behind it meet."""
    x, y = np.meshgrid(*[np.linspace(-0.5, 0.5, 129)] * 2)
    rim = np.clip((np.maximum(np.abs(x), np.abs(y)) - 0.4) / 0.1, 0, 1)
    land = actor_of(surface_of(10 * x, 10 * y, 10 * (-0.1 + 0.08 * rim)))
    land.GetProperty().SetColor(0.2, 0.9, 0.2)
    view = wt.View((240, 180), (1, 1, 1), samples)
    view.renderer.AddActor(land)
    water = vtkWaterActor()
    water.SetSheetToAutomatic()
    look = water.GetWaterProperty()
    look.RefractionOn()
    look.SetAbsorption(0.01, 0.01, 0.01)
    look.SetScattering(0.01, 0.01, 0.01)
    look.SetDeepColor(1, 0, 1)
    view.renderer.AddActor(water)
    wt.place_camera(view.renderer, (7, -9, 1.4), (0, 0, 0), (1, 60))
    picture = view.picture()
    deep = int((picture[:, :, 0] - picture[:, :, 1] > 30).sum())
    wt.check_at_least("pixels of the water's bed", int((picture[:, :, 1] - picture[:, :, 0] > 10).sum()), 2000)
    wt.check_at_most("pixels of deep water", deep, 30)

# SPDX-License-Identifier: BSD-3-Clause
"""Displaced waves are where GetWaveHeight says, whoever looks: in depth, outline, picks and bounds.

Depths of a parallel view are linear; a pixel's depth is a height. The views are small, so that the
chords of the grid (an error of amplitude (k step)^2 / 8) stay under what is tested.

The environment may ask for more headings around a pole: WATER_POLE_HEADINGS, a number.
"""

import os

import numpy as np
import pytest
import ray_caster
import water_test as wt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkHardwareSelector, vtkPolyDataMapper
from vtkwater import vtkWaterProperty

SINES = ((0.25, 12.0, 80.0, 30.0, 0.0), (0.25, 7.0, 40.0, 100.0, 0.0), (0.2, 4.0, 120.0, 0.0, 0.0))
STEEP = ((0.5, 6.0, 20.0, 30.0, 0.9), (0.2, 5.0, 75.0, 0.0, 0.9))
SHEET = (-60, 60, -60, 60)
HEADINGS = int(os.environ.get("WATER_POLE_HEADINGS", 24))


def scene(waves, size=(200, 150), sheet=SHEET, reflectance=1.0, plane=None):
    made = wt.View(size, (1.0, 0.0, 1.0))
    water = wt.add_water(made.renderer, plane, sheet, reflectance)
    for wave in waves:
        water.GetWaterProperty().AddWave(*wave)
    water.GetWaterProperty().WaveGeometryOn()
    return made, water


def look(made, position, focal_point, up=(0, 0, 1), near_far=(0.5, 150)):
    return wt.place_camera(made.renderer, position, focal_point, near_far, view_up=up)


def depths(made):
    made.picture()
    width, height = made.window.GetSize()
    values = vtkFloatArray()
    made.window.GetZbufferData(0, 0, width - 1, height - 1, values)
    return vtk_to_numpy(values).reshape(height, width).astype(float)


def height_errors(waves, time, center, scale, below=False, offset=(0, 0, 0)):
    """Heights in the picture of a straight look at 2 scale x 2 scale metres, less GetWaveHeight."""
    side = 50
    plane = wt.plane(offset, (0, 0, 1))
    made, water = scene(waves, (side, side), plane=plane)
    water.SetTime(time)
    sign = -1 if below else 1
    position = np.asarray(offset) + (*center, sign * 5.0)
    camera = look(made, position, position - (0, 0, sign), (0, 1, 0), (4.0, 6.0))
    camera.ParallelProjectionOn()
    camera.SetParallelScale(scale)
    found = sign * (5.0 - (4.0 + 2.0 * depths(made)))
    step = (np.arange(side) + 0.5) / side * 2 - 1
    x, y = np.meshgrid(center[0] + sign * scale * step, center[1] + scale * step)
    right = np.array([water.GetWaveHeight(*place) for place in zip(x.ravel(), y.ravel())]).reshape(x.shape)
    return np.abs(found - right).max(), right


ALL_WAVES = pytest.mark.parametrize("name, waves", (("sines", SINES), ("steep waves", STEEP)), ids=("sines", "steep"))


def amplitude_of(waves):
    return sum(wave[0] for wave in waves)


@pytest.mark.parametrize("time", (0.0, 3.7, 1e4, 1e6))
@ALL_WAVES
def test_the_surface_is_where_the_height_says(name, waves, time):
    """Early and late, a pixel's depth is the height that GetWaveHeight says of its place."""
    worst = max(height_errors(waves, time, center, 0.6)[0] for center in ((0, 0), (-17.3, 9.1), (31.0, -44.0)))
    wt.check_at_most(f"{name} at {time:g} s: largest error of a height, of the amplitude",
                     float(worst / amplitude_of(waves)), 1e-4)


@ALL_WAVES
def test_from_below_the_surface_is_where_it_is_from_above(name, waves):
    """Seen from below, the surface is where GetWaveHeight says."""
    worst = height_errors(waves, 2.5, (3.0, -7.0), 0.6, below=True)[0]
    wt.check_at_most(f"{name} from below: largest error, of the amplitude", float(worst / amplitude_of(waves)), 1e-4)


@ALL_WAVES
def test_far_from_the_origin_the_surface_is_where_the_height_says(name, waves):
    """Three thousand kilometres from the origin, the surface is where GetWaveHeight says."""
    worst = height_errors(waves, 2.5, (3.0, -7.0), 0.6, offset=(4e5, -3e6, 250.0))[0]
    wt.check_at_most(f"{name} far from the origin: largest error, of the amplitude",
                     float(worst / amplitude_of(waves)), 1e-4)


def two_waves(steepness):
    """The largest error of a height over two waves, and the share of the water over the level."""
    error, heights = height_errors(((0.5, 4.0, 0.0, 0.0, steepness),), 0.0, (0, 0), 4.0)
    return float(error), float((heights > 0).mean())


@pytest.mark.parametrize("steepness", (0.0, 0.95))
def test_every_steepness_has_its_height(steepness):
    """Over two whole waves of any steepness the surface is where GetWaveHeight says."""
    wt.check_at_most(f"steepness {steepness}: height over two waves, largest error, m", two_waves(steepness)[0], 0.02)


def test_steep_waves_have_flat_troughs():
    """Steep waves have sharp crests and flat troughs: over them most of the water is low."""
    wt.check_at_most("steepness 0.95: share of the water over the level", two_waves(0.95)[1], two_waves(0.0)[1] - 0.1)


def outline_error(waves):
    """How far, in px, the outline against the sky is from the highest points before it."""
    made, water = scene(waves, (120, 60), sheet=(-3, 3, -4, 4))
    camera = look(made, (0, -10, 0.5), (0, 0, 0), (0, 0, 1), (4.0, 16.0))
    up, away = 10 / np.hypot(10, 0.5), 0.5 / np.hypot(10, 0.5)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(1.0)
    top = 60 - np.argmax(wt.water_mask(made, water)[::-1], axis=0)
    errors = []
    for x, row in enumerate(top):
        place = (x + 0.5) / 120 * 4 - 2
        highest = max(up * water.GetWaveHeight(place, y) + away * y for y in np.linspace(-4, 4, 101))
        errors.append(abs(row - (highest + 1) * 30))
    return max(errors)


@pytest.mark.parametrize("name, waves", (("sines", SINES), ("a steep wave", ((0.5, 4.0, 0.0, 30.0, 0.95),))),
                         ids=("sines", "a_steep_wave"))
def test_the_outline_is_that_of_the_highest_points(name, waves):
    """The outline against the sky is that of the highest points."""
    wt.check_at_most(f"{name}: outline, largest error, px", float(outline_error(waves)), 1.0)


def picks(geometry):
    """On a grid of places in the window: where a pick meets the water, and where the picture shows it."""
    made, water = scene(((0.5, 4.0, 90.0, 0.0),), sheet=(-3, 3, -3, 3))
    water.GetWaterProperty().SetWaveGeometry(geometry)
    water.GetWaterProperty().SetWaveGridSize(64)
    look(made, (0, -14, 1.2), (0, 0, 0))
    made.picture()
    is_water = wt.water_mask(made, water)
    selector = vtkHardwareSelector()
    selector.SetRenderer(made.renderer)
    selector.SetArea(20, 30, 179, 119)
    selector.CaptureBuffers()  # drawn once for all places
    picked = np.zeros_like(is_water)
    for y in range(30, 120, 3):
        for x in range(20, 180, 16):
            picked[y, x] = selector.GenerateSelection(x, y, x, y).GetNumberOfNodes() > 0
    grid = np.ix_(range(30, 120, 3), range(20, 180, 16))
    return picked[grid], is_water[grid]


def test_picks_meet_the_waves_and_not_the_level():
    """A pick meets the water where the picture shows its waves, also where the level water is not."""
    picked, seen = picks(True)
    wt.check_equal("picks: places where picture and pick differ", int((picked != seen).sum()), 0)
    flat, _ = picks(False)
    wt.check_at_least("picks: places that only the waves cover", int((picked & ~flat).sum()), 20)


POLE = ray_caster.Box((0.3, 0.2, 1), (0.6, 0.6, 8), (0, 0.4, 0))
POLE_WAVES = ((0.3, 12.0, 20.0, 0.0), (0.12, 7.0, 75.0, 0.0), (0.05, 4.0, 130.0, 0.0))


def shows_water(made, water):
    """Which pixels show the water, from one picture: nothing else here is blue and not red."""
    look = water.GetWaterProperty()
    look.SetReflectance(0)
    look.SetDeepColor(0, 0, 1)
    picture = made.picture()
    look.SetReflectance(1)
    return np.abs(picture - (0, 0, 255)).max(axis=2) < 128


def reflects_pole(camera, time, size, x, y):
    start, ray = ray_caster.rays_at(camera, size, np.array([(2 * x + 1) / size[0] - 1]), np.array([(2 * y + 1) / size[1] - 1]))
    way = ray_caster.meet_waves(start, ray, POLE_WAVES, time, 150)
    place = start + np.where(np.isfinite(way), way, 0)[:, None] * ray
    _, slope_x, slope_y = ray_caster.heights_and_slopes(POLE_WAVES, place[:, 0], place[:, 1], time)
    normal = np.stack([-slope_x, -slope_y, np.ones_like(slope_x)], axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    away = ray - 2 * (ray * normal).sum(axis=1, keepdims=True) * normal
    return bool(np.isfinite(way[0]) and np.isfinite(POLE.distance(place, away)[0]))


def count_gaps(headings):
    """Of the columns in which the pole ends on the water: their number, how many show the background under it and
    should not, how many have no water under it, how many show the background and should."""
    made, water = scene(POLE_WAVES, sheet=(-90, 90, -90, 90))
    wt.add_actor(made.renderer, wt.box((0.3, 0.2, 1), (0.6, 0.6, 8)), (0, 0.4, 0), lit=False)
    columns = gaps = holes = elsewhere = 0
    for heading in headings:
        angle = np.radians(heading)
        camera = look(made, (12 * np.sin(angle), -12 * np.cos(angle), 2.4), (0, 0, 0.3))
        water.SetTime(0.1 * heading)
        picture = made.picture()
        is_water = shows_water(made, water)
        is_pole = (np.abs(picture - (0, 102, 0)).max(axis=2) < 3) & ~is_water
        is_sky = (np.abs(picture - (255, 0, 255)).max(axis=2) < 3)
        for x in range(2, 198):
            rows = np.nonzero(is_pole[:, x])[0]
            if len(rows) < 3:
                continue
            y = rows[0]
            if is_pole[y:y + 2, x - 2].any() and is_pole[y:y + 2, x + 2].any():
                columns += 1
                holes += not is_water[y - 1, x]
                if is_sky[y - 1, x]:
                    is_gap = reflects_pole(camera, 0.1 * heading, (200, 150), x, y - 1)
                    gaps += is_gap
                    elsewhere += not is_gap
    return columns, gaps, holes, elsewhere


def test_what_stands_in_waves_touches_its_reflection():
    """What stands in waves touches its reflection from every heading, unless it is hidden by a crest before it,
    whose reflection may be another."""
    columns, gaps, holes, elsewhere = count_gaps(np.arange(HEADINGS) * 360 / HEADINGS)
    wt.check_at_least(f"pole: columns in which it ends on the water, of each of {HEADINGS} headings", columns / HEADINGS, 8)
    print(f"pole: {elsewhere} columns under which the ray caster sees the background, too")
    wt.check_equal("pole: columns with no water under it", int(holes), 0)
    wt.check_equal("pole: columns with the background between it and its reflection", int(gaps), 0)


def test_a_sand_bank_under_the_surface_is_no_reflection():
    """What lies under the surface, but over the deepest trough, is not reflected: a sand bank."""
    made, water = scene(((0.4, 9.0, 20.0), (0.2, 6.0, 75.0)), sheet=(-90, 90, -90, 90))
    wt.add_actor(made.renderer, wt.box((0, 0, -0.7), (30, 30, 0.2)), (1, 1, 0), lit=False)
    wt.add_actor(made.renderer, wt.box((0, 8, 0), (20, 0.5, 8)), (0, 0.4, 0), lit=False)
    look(made, (1, -12, 4), (0, 0, 0))
    picture = made.picture()
    shown = (np.abs(picture - (255, 255, 0)).max(axis=2) < 90) & wt.water_mask(made, water)
    wt.check_equal("sand bank under the waves: pixels that reflect it", int(shown.sum()), 0)


def water_picture(waves, geometry):
    made, water = scene(waves)
    water.GetWaterProperty().SetWaveGeometry(geometry)
    water.GetWaterProperty().SetRayTraceRays(1)
    for data, color in wt.columns_and_pyramids():
        wt.add_actor(made.renderer, data, color)
    look(made, (2, -13, 4), (0, 0, 0))
    return made.picture()


def test_waves_without_height_are_calm_water():
    """Waves of amplitude 0 show calm water, with one ray a pixel: of several the edges are smoother."""
    off = 100 * (np.abs(water_picture(((0.0, 3.0),), True) - water_picture((), False)).max(axis=2) > 1).mean()
    wt.check_at_most("amplitude 0: % of pixels that are not calm", float(off), 0.02)


def test_without_waves_nothing_is_displaced():
    """Without waves, wave geometry changes nothing."""
    change = np.abs(water_picture((), True) - water_picture((), False)).max()
    wt.check_equal("no waves: largest change", int(change), 0)


def tilted_picture(degrees, mesh=False, side=1):
    """The reflectance in a world that is tilted about x, and which pixels are water."""
    angle = np.radians(degrees)
    rotation = np.array([[1, 0, 0], [0, np.cos(angle), -np.sin(angle)], [0, np.sin(angle), np.cos(angle)]])
    made, water = scene(SINES[:2], sheet=(-20, 20, -20, 20), plane=wt.plane((0, 0, 0), rotation @ (0, 0, 1)))
    for center in ((0, 2, 0.5), (-3, 5, -0.5), (4, 9, 1)):
        wt.add_actor(made.renderer, wt.sphere(center, 1.5, 96), (0, 0.4, 0), lit=False).RotateX(degrees)
    if mesh:
        source = vtkPlaneSource()
        source.SetOrigin(-20, -20, 0)
        source.SetPoint1(20, -20, 0)
        source.SetPoint2(-20, 20, 0)
        source.SetResolution(500, 500)
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        water.SetMapper(mapper)
    look(made, rotation @ (2, -13, side * 4), rotation @ (0, 0, 0), rotation @ (0, 0, 1))
    mask = wt.water_mask(made, water)
    water.GetWaterProperty().SetReflectanceModeToFresnel()
    water.GetWaterProperty().SetOutputToReflectance()  # the surface itself, not what it shows
    picture = made.picture()
    return (256 * picture[:, :, 0] + picture[:, :, 1]) / 65535, mask


def differing(a, b, mask):
    return float(100 * (np.abs(a - b) > 0.005)[mask].mean())


@pytest.mark.parametrize("side, name", ((1, "above"), (-1, "below")), ids=("above", "below"))
@pytest.mark.parametrize("what, degrees, mesh", (("tilted by 40 degrees", 40, False),
                                                  ("a mesh of 500 x 500", 0, True)),
                         ids=("tilted", "a_mesh"))
def test_a_tilted_world_and_a_fine_mesh_look_alike(what, degrees, mesh, side, name):
    """A tilted world looks like the level one, and a fine mesh of the user's like the water's own sheet."""
    level, is_water = tilted_picture(0, side=side)
    picture, mask = tilted_picture(degrees, mesh, side)
    wt.check_at_most(f"{what}, from {name}: % of pixels on one of the two waters only",
                     float(100 * (mask != is_water).mean()), 0.05)
    wt.check_at_most(f"{what}, from {name}: % of its pixels whose reflectance differs",
                     differing(picture, level, mask & is_water), 1.0)


def rounded(bounds):
    return [round(bound, 9) for bound in bounds]


def test_bounds_hold_what_is_displaced():
    """Bounds hold what is displaced, to the side and in height; those of the flat sheet are the sheet's."""
    _, water = scene(STEEP, sheet=(-3, 3, -4, 4))
    wt.check_equal("bounds", rounded(water.GetBounds()), [-3.63, 3.63, -4.63, 4.63, -0.7, 0.7])
    wt.check_equal("bounds, asked again", rounded(water.GetBounds()), [-3.63, 3.63, -4.63, 4.63, -0.7, 0.7])
    water.GetWaterProperty().WaveGeometryOff()
    wt.check_equal("bounds of the flat sheet", list(water.GetBounds()), [-3, 3, -4, 4, 0, 0])


def test_waves_are_flat_unless_they_are_asked_for():
    """By default waves do not displace the surface; the grid has 256 cells on a side."""
    look = vtkWaterProperty()
    wt.check_equal("default: geometry, grid", (look.GetWaveGeometry(), look.GetWaveGridSize()), (False, 256))


def test_a_bad_grid_size_is_refused():
    """A grid size out of range is an error that names it and the range, and the size stays."""
    look = vtkWaterProperty()
    errors = wt.errors_of(look)
    for size in (15, 0, -3, 2049):
        look.SetWaveGridSize(size)
    wt.check_equal("bad grid sizes: errors", len(errors), 4)
    wt.check_equal("bad grid sizes: the size stays", look.GetWaveGridSize(), 256)
    wt.check_equal("bad grid sizes: the error names the range", "[16, 2048]" in errors[0] and "15" in errors[0], True)


def test_the_same_value_again_modifies_nothing():
    """Setting what is set is no change."""
    look = vtkWaterProperty()
    modified = look.GetMTime()
    look.WaveGeometryOff()
    wt.check_equal("the same value again modifies nothing", look.GetMTime(), modified)

# SPDX-License-Identifier: BSD-3-Clause
"""A sheet to the horizon fills what each eye sees of the plane, whatever the near and far planes, the order of calls
and the scale; it is no part of the scene's bounds. Where the horizon is, and what is seen under it, are computed here."""

import itertools

import numpy as np
import pytest
import water_test as wt
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingAnnotation import vtkCubeAxesActor
from vtkmodules.vtkRenderingCore import vtkAssembly
from vtkwater import vtkWaterActor

SIZE = (320, 240)
SKY = (0.2, 0.3, 0.4)
EYE, TARGET = (-2.0, -6.0, 0.8), (0.0, 0.0, 0.3)
LEVEL = -0.2
GREEN = (0.0, 1.0, 0.0)
WIDE = (-3000.0, 3000.0, -3000.0, 3000.0)
DEPTHS = (0.05, 400.0)  # wider than what the scene needs
TIGHT = (4.5, 9.0)  # between the near water and the far one, about all meshes


def things(scale=1.0, shift=(0, 0, 0)):
    matrix = vtkMatrix4x4()
    for i in range(3):
        matrix.SetElement(i, i, scale)
        matrix.SetElement(i, 3, shift[i])
    made = [(wt.pyramid((0, 0, 0.1), 1.2, 32), (0.9, 0.5, 0.2)), (wt.box((1.2, 1.0, 0.2), (0.6, 0.6, 1.6)), (0.3, 0.7, 0.4))]
    return [(wt.transformed(data, matrix), color) for data, color in made]


def horizon_water(level=LEVEL, plain=None):
    """Water to the horizon; of one plain colour, or with Fresnel's reflection."""
    water = vtkWaterActor()
    water.SetLevel(level)
    water.SetSheetToHorizon()
    if plain:
        make_plain(water, plain)
    return water


def make_plain(water, color=GREEN):
    water.GetWaterProperty().SetReflectanceModeToConstant()
    water.GetWaterProperty().SetReflectance(0)
    water.GetWaterProperty().SetDeepColor(color)


def place(view, position=EYE, target=TARGET, depths=None, up=(0, 0, 1), angle=50):
    camera = view.renderer.GetActiveCamera()
    camera.SetPosition(position)
    camera.SetFocalPoint(target)
    camera.SetViewUp(up)
    camera.SetViewAngle(angle)
    if depths:
        camera.SetClippingRange(depths)
    else:
        view.renderer.ResetCameraClippingRange()


def scene(water, depths=DEPTHS, with_things=True, **camera):
    view = wt.View(SIZE, SKY)
    if with_things:
        for data, color in things():
            wt.add_actor(view.renderer, data, color)
    view.renderer.AddActor(water)
    place(view, depths=depths, **camera)
    return view


def check_same(name, first, second, most=2, tolerance=0):
    """But for pixels on an edge, whose depths are rounded otherwise."""
    differs = np.abs(first - second).max(axis=2) > tolerance
    wt.check_at_most(f"{name}: pixels that differ", int(differs.sum()), most)


def pixel_rays(camera, size=SIZE):
    """The view ray of each pixel's middle, of any length."""
    width, height = size
    half = np.tan(np.radians(0.5 * camera.GetViewAngle()))
    x = ((np.arange(width) + 0.5) / width * 2 - 1) * half * width / height
    y = ((np.arange(height) + 0.5) / height * 2 - 1) * half
    forward = wt.unit(camera.GetDirectionOfProjection())
    right = wt.unit(np.cross(forward, camera.GetViewUp()))
    up = np.cross(right, forward)
    return forward + x[None, :, None] * right + y[:, None, None] * up


# No part of the scene's bounds

def test_bounds_are_those_without_the_water():
    """Bounds, the reset camera, its clipping range and axes are those of the scene without the water."""
    water = horizon_water()
    views = []
    for has_water in (True, False):
        view = wt.View(SIZE, SKY)
        for data, color in things():
            wt.add_actor(view.renderer, data, color)
        if has_water:
            view.renderer.AddActor(water)
            view.picture()
        view.renderer.ResetCamera()
        camera = view.renderer.GetActiveCamera()
        axes = vtkCubeAxesActor()
        axes.SetBounds(view.renderer.ComputeVisiblePropBounds())
        camera.Azimuth(30)
        view.renderer.ResetCameraClippingRange()
        views.append((view.renderer.ComputeVisiblePropBounds(), camera.GetPosition(), camera.GetClippingRange(),
                      axes.GetBounds()))
    wt.check_equal("bounds, camera, clipping range and axes with the water", views[0], views[1])
    wt.check_equal("bounds of the water", water.GetBounds(), None)


def test_the_water_is_drawn_without_bounds():
    """Nothing culls it, nor does its actor's own place move it; in an assembly it is drawn with the other parts."""
    reference = scene(horizon_water(plain=GREEN)).picture()
    moved = horizon_water(plain=GREEN)
    moved.SetPosition(100, 50, 7)
    moved.SetScale(2, 3, 0.5)
    check_same("moved actor", scene(moved).picture(), reference)
    assembly = vtkAssembly()
    assembly.AddPart(horizon_water(plain=GREEN))
    view = scene(assembly)
    part = wt.add_actor(view.renderer, *things()[0])  # by whose bounds VTK culls an assembly
    view.renderer.RemoveActor(part)
    assembly.AddPart(part)
    check_same("in an assembly", view.picture(), reference)
    wt.check_at_least("pixels of water", int((reference == (0, 255, 0)).all(axis=2).sum()), 20000)


# Any order of calls

@pytest.mark.parametrize("is_endless", [True, False], ids=["horizon", "bounds"])
def test_every_order_of_calls_gives_the_same_picture(is_endless):
    """Camera, water and meshes may be set in any order."""
    pictures = []
    for order in itertools.permutations(("camera", "water", "things")):
        view = wt.View(SIZE, SKY)
        for step in order:
            if step == "camera":
                place(view, depths=DEPTHS)
            elif step == "water":
                water = horizon_water()
                if not is_endless:
                    water.SetSheetBounds(-9, 9, -9, 9)
                view.renderer.AddActor(water)
            else:
                for data, color in things():
                    wt.add_actor(view.renderer, data, color)
        pictures.append(view.picture())
        check_same(f"{', '.join(order)}", pictures[-1], pictures[0], 0)


def test_a_reset_clipping_range_cuts_no_water():
    """With the clipping range that VTK sets for the meshes alone, the picture is the one with a wide range."""
    for name, eye in (("over", EYE), ("close to the surface", (-2.0, -6.0, -0.1)), ("under", (-2.0, -6.0, -1.0))):
        wide = scene(horizon_water(), position=eye)
        tight = scene(horizon_water(), depths=None, position=eye)
        tight.renderer.GetActiveCamera().SetClippingRange(TIGHT)
        check_same(f"{name}, {TIGHT}", tight.picture(), wide.picture(), 30)


# The picture is filled up to the horizon

PLANES = {
    "level": ((0, 0, LEVEL), (0, 0, 1)),
    "tilted": ((0, 0, LEVEL), (0.25, -0.1, 1.0)),
    "upright": ((0, 9, 0), (0.1, -1.0, 0.15)),
}


@pytest.mark.parametrize("name", PLANES)
@pytest.mark.parametrize("depths", [DEPTHS, TIGHT], ids=["wide", "tight"])
def test_water_is_where_view_rays_meet_the_plane(name, depths):
    """A pixel shows the plane's water exactly where its ray meets the plane, from both sides of it, turned and rolled."""
    origin, normal = PLANES[name]
    for position, up in ((EYE, (0, 0, 1)), ((1.0, -4.0, 5.0), (0.3, 0, 1)), ((-2.0, -6.0, -1.5), (0, 0.2, 1))):
        water = horizon_water(plain=GREEN)
        water.SetPlane(wt.plane(origin, normal))
        view = scene(water, depths, False, position=position, up=up)
        fall = pixel_rays(view.renderer.GetActiveCamera()) @ wt.unit(normal)
        height = (np.asarray(position) - origin) @ wt.unit(normal)
        expected = -height / fall > 0
        got = (view.picture() == (0, 255, 0)).all(axis=2)
        wt.check_at_most(f"{name}, eye at {position}: wrong pixels", int((got != expected).sum()), 1)


def test_parallel_views_are_filled():
    """A parallel view that looks down is full of water, and one along the plane has none, and no error."""
    for target, share in ((TARGET, 1.0), ((0.0, 0.0, 0.8), 0.0)):
        water = horizon_water(plain=GREEN)
        view = scene(water, TIGHT, False, target=target)
        view.renderer.GetActiveCamera().ParallelProjectionOn()
        view.renderer.GetActiveCamera().SetParallelScale(3)
        got = (view.picture() == (0, 255, 0)).all(axis=2).mean()
        wt.check_equal(f"parallel view to {target}: share of water", float(got), share)
        wt.check_equal(f"parallel view to {target}: error", water.GetLastError(), "")


@pytest.mark.parametrize("scale, shift", [(1e-3, (0, 0, 0)), (1e7, (0, 0, 0)), (1.0, (1e6, -1e6, 2e5)), (1e-3, (1e3, -1e3, 200))],
                         ids=["millimetres", "continents", "far", "millimetres_far"])
def test_every_scale_gives_the_same_picture(scale, shift):
    """A scene of a millimetre, of 10,000 km, and one 1,000 km from the origin look as the one of a metre."""
    pictures = []
    for one, to in ((1.0, (0, 0, 0)), (scale, shift)):
        view = wt.View(SIZE, SKY)
        for data, color in things(one, to):
            wt.add_actor(view.renderer, data, color)
        view.renderer.AddActor(horizon_water(LEVEL * one + to[2]))
        where = [tuple(to[i] + one * point[i] for i in range(3)) for point in (EYE, TARGET)]
        place(view, *where, depths=[one * depth for depth in TIGHT])
        pictures.append(view.picture())
    check_same(f"times {scale:g}, from {shift}", pictures[1], pictures[0], 8, 2)


def test_an_eye_on_the_plane_has_a_picture():
    """An eye exactly on the plane sees water under the horizon and sky over it, and there is no error; a sheet with an
    end is seen edge-on: the picture is the one without it."""
    water = horizon_water(plain=GREEN)
    errors = wt.errors_of(water)
    view = scene(water, TIGHT, False, position=(-2, -6, LEVEL), target=(0, 0, LEVEL))
    picture = view.picture()
    wt.check_equal("rows of water", (picture == (0, 255, 0)).all(axis=2).all(axis=1).sum(), SIZE[1] // 2)
    wt.check_equal("rows of sky", (np.abs(picture - np.round(255 * np.array(SKY))) <= 1).all(axis=2).all(axis=1).sum(),
                   SIZE[1] // 2)
    without = scene(vtkAssembly(), position=(-2, -6, LEVEL), target=(0, 0, LEVEL)).picture()
    view.renderer.RemoveActor(water)  # VTK draws an actor in one window
    water = horizon_water(plain=GREEN)
    water.SetSheetBounds(-9, 9, -9, 9)
    errors += wt.errors_of(water)
    check_same("edge-on", scene(water, position=(-2, -6, LEVEL), target=(0, 0, LEVEL)).picture(), without, 0)
    wt.check_equal("errors", (errors, water.GetLastError()), ([], ""))


# Depths of all sizes

def shores(columns=3):
    """Blocks with upright walls in the water, from 0.1 m to 100 km away."""
    made = []
    for i, distance in enumerate((0.1, 10.0, 1e3, 3e4, 1e5)):
        for k in range(columns):
            side = 0.12 * distance
            center = ((k - 1) * 0.28 * distance + 0.05 * distance * (i - 2), distance + 0.5 * side, 0.0)
            made.append((np.array(center), np.array((side, side, 2 * side)), (1.0, (i + 1) / 6, (k + 1) / 4)))
    return made


def waterlines(classes, count):
    """Row of the waterline, by thing and column."""
    found = {}
    for thing in range(count):
        is_line = (classes[1:] == 2 + thing) & (classes[:-1] == 1)
        for column in np.flatnonzero(is_line.any(axis=0)):
            found[thing, column] = int(np.argmax(is_line[:, column]))
    return found


def cast(start, rays, blocks):
    """What each ray meets first: 0 sky, 1 water, from 2 on the blocks."""
    with np.errstate(divide="ignore", invalid="ignore"):
        nearest = np.where(rays[..., 2] < 0, -start[2] / rays[..., 2], np.inf)
        classes = np.where(np.isfinite(nearest), 1, 0)
        for i, (center, lengths, _) in enumerate(blocks):
            sides = np.stack([(center - 0.5 * lengths - start) / rays, (center + 0.5 * lengths - start) / rays])
            enters, leaves = sides.min(axis=0).max(axis=-1), sides.max(axis=0).min(axis=-1)
            is_met = (enters <= leaves) & (enters > 0) & (enters < nearest)
            nearest = np.where(is_met, enters, nearest)
            classes = np.where(is_met, 2 + i, classes)
    return classes


@pytest.mark.parametrize("height, fall", [(0.06, 0.3), (2.0, 0.1), (50.0, 0.1), (500.0, 0.1)])
def test_waterlines_are_right_from_a_hand_to_the_horizon(height, fall):
    """With a near plane at 0.05 m and a far one at 200 km, at most 0.5 % of the waterline is off by more than a pixel."""
    size = (640, 480)
    view = wt.View(size, SKY)
    blocks = shores()
    for center, lengths, color in blocks:
        wt.add_actor(view.renderer, wt.box(center, lengths), color, lit=False)
    view.renderer.AddActor(horizon_water(0.0, (0, 0, 1)))
    start = np.array((0.0, 0.0, height))
    place(view, start, start + (0, 1, -fall), (0.05, 2e5))
    expected = waterlines(cast(start, pixel_rays(view.renderer.GetActiveCamera(), size), blocks), len(blocks))
    picture = view.picture()
    classes = np.where((picture == (0, 0, 255)).all(axis=2), 1, 0)
    for i, (_, _, color) in enumerate(blocks):
        classes[(np.abs(picture - 255 * np.array(color)) <= 1).all(axis=2)] = 2 + i
    got = waterlines(classes, len(blocks))
    is_off = [place not in got or abs(got[place] - row) > 1 for place, row in expected.items()]
    wt.check_at_least(f"{height} m: pixels of the waterline", len(is_off), 300)
    wt.check_at_most(f"{height} m: share that is off by more than a pixel", float(np.mean(is_off)), 0.005)


# All kinds of water

def waves(water):
    look = water.GetWaterProperty()
    look.AddWave(0.06, 1.2, 30)
    look.AddWave(0.03, 0.6, 80)


def displaced(water):
    waves(water)
    water.GetWaterProperty().WaveGeometryOn()


def clear(water):
    water.GetWaterProperty().SetPreset("clear tropical")
    water.GetWaterProperty().RemoveAllWaves()
    water.GetWaterProperty().SeaOff()


KINDS = {
    "calm": (lambda water: None, 4),
    "waves": (waves, 40),
    "displaced": (displaced, 400),
    "clear": (clear, 40),
    "sea": (lambda water: water.GetWaterProperty().SetPreset("ocean wind 5"), 100),
    "translucent": (lambda water: water.GetWaterProperty().SetOpacity(0.5), 4),
}


@pytest.mark.parametrize("kind", KINDS)
def test_every_water_is_the_same_with_close_planes(kind):
    """Every kind of water shows the same whether the near and far planes are about the meshes or wide."""
    prepare, most = KINDS[kind]
    pictures = []
    # what clear water shows at the edges of a bed that the far plane is close behind is another matter
    for depths in (DEPTHS, (TIGHT[0], 40.0) if kind in ("clear", "sea") else TIGHT):
        water = horizon_water()
        prepare(water)
        view = scene(water, depths)
        bed = wt.add_actor(view.renderer, wt.box((0, 0, -0.8), (3, 3, 0.2)), (0.9, 0.8, 0.6))
        bed.GetProperty().LightingOff()
        pictures.append(view.picture())
        wt.save(pictures[-1], wt.output_folder() / f"Horizon-{kind}-{depths[0]}.png")
    check_same(kind, pictures[1], pictures[0], most, 16)


def test_no_line_is_along_the_horizon_under_water():
    """With samples, an eye under water sees the same haze at the horizon as without: no line of the sky behind it."""
    pictures = []
    for samples in (0, 4, 8):
        view = wt.View(SIZE, (1, 1, 1), samples)
        water = horizon_water()
        water.GetWaterProperty().SetPreset("clear tropical")
        water.GetWaterProperty().SeaOff()
        view.renderer.AddActor(water)
        view.renderer.SetBackground(1, 1, 1)
        place(view, (0, 0, LEVEL - 1.7), (0.0, 1.0, LEVEL - 1.7 - 0.31), DEPTHS)
        pictures.append(view.picture().astype(int))
    for samples, picture in zip((4, 8), pictures[1:]):
        wt.check_at_most(f"{samples} samples, largest difference", np.abs(picture - pictures[0]).max(), 8)


@pytest.mark.parametrize("kind", ["calm", "clear", "displaced"])
def test_an_endless_sheet_is_a_very_wide_one(kind):
    """Where a sheet of bounds fills the view, the picture is the same."""
    pictures = []
    for is_endless in (True, False):
        water = horizon_water()
        KINDS[kind][0](water)
        if not is_endless:
            water.SetSheetBounds(-60, 60, -60, 60)
        pictures.append(scene(water, target=(0, 0, -1.0), position=(-2, -6, 2.5), angle=25).picture())
    check_same(kind, pictures[1], pictures[0], 600 if kind == "displaced" else 4, 16)


def test_peeled_water_reaches_beyond_the_far_plane():
    """VTK's depth peeling leaves out what is as deep as the background; water beyond the far plane is not."""
    water = horizon_water(plain=GREEN)
    water.GetWaterProperty().SetOpacity(0.5)
    view = scene(water, TIGHT, False)
    view.renderer.UseDepthPeelingOn()
    view.renderer.SetMaximumNumberOfPeels(4)
    view.window.SetAlphaBitPlanes(1)
    picture = view.picture()
    fall = pixel_rays(view.renderer.GetActiveCamera())[..., 2]
    is_green = picture[..., 1] > 140
    wt.check_at_most("wrong pixels", int((is_green != (fall < 0)).sum()), 0)


def test_waves_hide_each_other_before_the_near_plane():
    """Crests before the near plane hide what is behind them, as they do when the near plane is close to the eye."""
    pictures = []
    for depths in ((0.05, 400.0), (40.0, 60.0)):
        water = horizon_water()
        displaced(water)
        pictures.append(scene(water, depths, False, position=(0, 0, 0.15), target=(0, 5, -0.3)).picture())
    check_same("all before the near plane", pictures[1], pictures[0], 300, 24)


# Several views

def other_water_scene(is_endless, depths):
    """A leaning mirror over the endless water, which is seen in it."""
    view = wt.View(SIZE, SKY)
    for data, color in things():
        wt.add_actor(view.renderer, data, color)
    water = vtkWaterActor()
    water.SetLevel(LEVEL)
    make_plain(water)
    if is_endless:
        water.SetSheetToHorizon()
    else:
        water.SetSheetBounds(*WIDE)
    view.renderer.AddActor(water)
    mirror = wt.add_water(view.renderer, wt.plane((0, 2.5, 0), (0, -1, -0.2)), (-2, 2, -0.1, 3))
    place(view, depths=depths)
    return view, mirror


def test_endless_water_is_seen_in_another_water():
    """In the mirrored view of another water it is the very wide sheet that it stands for."""
    reference, _ = other_water_scene(False, DEPTHS)
    expected = reference.picture()
    for depths in (DEPTHS, TIGHT):
        view, mirror = other_water_scene(True, depths)
        picture = view.picture()
        wt.save(picture, wt.output_folder() / f"Horizon-mirror-{depths[0]}.png")
        is_mirror = wt.water_mask(view, mirror)
        is_seen = (picture == (0, 255, 0)).all(axis=2) & is_mirror
        was_seen = (expected == (0, 255, 0)).all(axis=2) & is_mirror
        wt.check_at_least(f"{depths}: pixels of water in the mirror", int(is_seen.sum()), 500)
        wt.check_at_most(f"{depths}: of these wrong", int((is_seen != was_seen).sum()), 40)


def test_every_renderer_and_eye_has_its_own_sheet():
    """One actor in two renderers, and seen by two eyes, fills what each of them sees."""
    water = horizon_water(plain=GREEN)
    view = wt.View((400, 200), SKY)
    view.renderer.SetViewport(0, 0, 0.5, 1)
    second = view.add_renderer(SKY, (0.5, 0, 1, 1))
    for renderer, position in ((view.renderer, EYE), (second, (9, 4, 6))):
        renderer.AddActor(water)
        wt.place_camera(renderer, position, (0, 0, 1), TIGHT)
    for _ in range(2):
        picture = view.picture()
        for i, renderer in enumerate((view.renderer, second)):
            fall = pixel_rays(renderer.GetActiveCamera(), (200, 200))[..., 2]
            got = (picture[:, 200 * i:200 * (i + 1)] == (0, 255, 0)).all(axis=2)
            wt.check_at_most(f"renderer {i}: wrong pixels", int((got != (fall < 0)).sum()), 0)
    eyes = scene(horizon_water(plain=GREEN), TIGHT, False)
    eyes.window.SetStereoTypeToLeft()
    eyes.window.StereoRenderOn()
    for name in ("Left", "Right"):
        getattr(eyes.window, f"SetStereoTypeTo{name}")()
        picture = eyes.picture()
        rows = (picture == (0, 255, 0)).all(axis=2).any(axis=0)
        wt.check_equal(f"{name} eye: every column has water", bool(rows.all()), True)
        corner = [tuple(picture[0, column]) for column in (0, SIZE[0] - 1)]
        wt.check_equal(f"{name} eye: corners", corner, [(0, 255, 0)] * 2)


def test_skips_never_show():
    """What is left out changes no pixel: water that is hidden, beyond the far plane, or out of view."""
    wall = wt.box((0, 3, 0), (40, 0.2, 40))
    for name, depths, target, has_wall in (
            ("plain", DEPTHS, TARGET, False), ("beyond the far plane", TIGHT, TARGET, False),
            ("behind a wall", DEPTHS, TARGET, True), ("looks up", TIGHT, (0, 0, 9), False)):
        pictures = []
        for has_skips in (True, False):
            water = horizon_water()
            if not has_skips:
                for method in [name for name in dir(water.GetReflectionPass()) if name.startswith("SetSkip")]:
                    getattr(water.GetReflectionPass(), method)(False)
            view = scene(water, depths, target=target)
            if has_wall:
                wt.add_actor(view.renderer, wall, (0.5, 0.5, 0.5))
            for _ in range(3):  # what is skipped is learnt from frames
                picture = view.picture()
            pictures.append(picture)
        check_same(name, pictures[1], pictures[0], 0)
        wt.check_equal(f"{name}: decision", wt.decision_of(water) != "NO_REFLECT_FAILED", True)


def test_reflections_are_not_cut_at_the_near_plane():
    """A tower's mirror image comes nearer to an eye that looks up than the tower: all of it is seen."""
    pictures = []
    for has_near_plane in (False, True):
        view = wt.View(SIZE, SKY)
        wt.add_actor(view.renderer, wt.box((0, 12, 4), (2, 2, 9)), (1, 0, 0), lit=False)
        water = horizon_water(0.0)
        water.GetWaterProperty().SetReflectanceModeToConstant()
        water.GetWaterProperty().SetReflectance(1.0)
        view.renderer.AddActor(water)
        place(view, (0, 0, 1.0), (0, 12, 5.0), DEPTHS, angle=80)
        if has_near_plane:
            view.renderer.ResetCameraClippingRange()
            view.renderer.GetActiveCamera().SetClippingRange(10.3, 60)
        pictures.append(view.picture())
    check_same("tower", pictures[1], pictures[0], 4)
    wt.check_at_least("red pixels", int((pictures[0][..., 0] > 200).sum()), 1000)


# Settings

def text_of(water):
    return next(line for line in str(water).splitlines() if "SheetBounds" in line).strip()


def test_bounds_and_horizon_replace_each_other():
    """The last that was set holds; a mapper of the user's takes precedence as long as there is one; a copy has the same."""
    water = vtkWaterActor()
    wt.check_equal("at first", (water.GetSheetToHorizon(), text_of(water)), (False, "SheetBounds: those of the scene"))
    water.SetSheetBounds(*WIDE)
    water.SetSheetToHorizon()
    wt.check_equal("to the horizon", (water.GetSheetToHorizon(), water.GetUseSheetBounds(), text_of(water)),
                   (True, False, "SheetBounds: to the horizon"))
    time = water.GetMTime()
    water.SetSheetToHorizon()
    wt.check_equal("the same once more: modified", water.GetMTime() > time, False)
    copy = vtkWaterActor()
    copy.ShallowCopy(water)
    wt.check_equal("copy", copy.GetSheetToHorizon(), True)
    water.SetSheetBounds(*WIDE)
    wt.check_equal("bounds again", (water.GetSheetToHorizon(), water.GetUseSheetBounds()), (False, True))
    copy.ShallowCopy(water)
    wt.check_equal("copy again", copy.GetSheetToHorizon(), False)
    water.SetSheetToHorizon()
    water.ResetSheetBounds()
    wt.check_equal("reset", (water.GetSheetToHorizon(), water.GetUseSheetBounds()), (False, False))


def test_a_mapper_of_the_users_takes_precedence():
    """A mesh of the user's is drawn in place of the endless sheet, with its bounds, until it is taken away."""
    water = horizon_water(plain=GREEN)
    view = scene(water, with_things=False)
    first = view.picture()
    sheet = wt.box((0, 0, LEVEL), (1, 1, 0))
    actor = wt.add_actor(view.renderer, sheet, GREEN)
    view.renderer.RemoveActor(actor)
    water.SetMapper(actor.GetMapper())
    wt.check_equal("bounds of the mesh", np.allclose(water.GetBounds(), (-0.5, 0.5, -0.5, 0.5, LEVEL, LEVEL)), True)
    picture = view.picture()
    wt.check_at_most("pixels of the mesh", int((picture == (0, 255, 0)).all(axis=2).sum()), 2000)
    water.SetMapper(None)
    check_same("without it", view.picture(), first, 0)


def test_a_bad_plane_is_an_error_and_no_sheet():
    """A plane without a normal is one error, and nothing is drawn; a good one brings the water back."""
    water = horizon_water(plain=GREEN)
    errors = wt.errors_of(water)
    view = scene(water, with_things=False)
    first = view.picture()
    good = water.GetPlane()
    water.SetPlane(wt.plane((0, 0, 0), (0, 0, 0)))
    for _ in range(3):
        picture = view.picture()
    wt.check_equal("errors", len(errors), 1)
    wt.check_equal("pixels of water", int((picture == (0, 255, 0)).all(axis=2).sum()), 0)
    water.SetPlane(good)
    check_same("good again", view.picture(), first, 0)
    wt.check_equal("last error", water.GetLastError(), "")


def test_a_transform_of_the_user_is_followed_by_nothing():
    """The plane alone moves the sheet."""
    water = horizon_water(plain=GREEN)
    first = scene(water).picture()
    transform = vtkTransform()
    transform.RotateX(30)
    transform.Translate(5, 6, 7)
    water.SetUserTransform(transform)
    check_same("turned actor", scene(water).picture(), first, 2)


def test_far_waves_along_the_view_have_no_step(monkeypatch):
    """A wave whose crests run away from the eye is ever rougher to both sides: below the horizon its colour changes
    evenly. Pixels with few slopes had one facet, and rectangles with hard edges."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "1")  # the shader for GPUs had smaller steps, 3 here
    view = wt.View((400, 200), (0.9, 0.9, 0.9))
    water = horizon_water(0.0)
    water.GetWaterProperty().AddWave(0.05, 3, 0)
    view.renderer.AddActor(water)
    place(view, (0, -15, 2), (0, 0, 0), (0.1, 2000), angle=30)
    picture = view.picture()[:, :, 0]
    horizon = int(np.flatnonzero(np.abs(np.diff(picture[:, 20])) > 20)[-1])
    below = picture[horizon - 4:horizon - 1]
    wt.check_at_least("the waves darken the water to the side by", int((below[:, 200] - below[:, 10]).min()), 25)
    wt.check_at_most("largest step from pixel to pixel", int(np.abs(np.diff(below, axis=1)).max()), 6)

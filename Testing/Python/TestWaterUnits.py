# SPDX-License-Identifier: BSD-3-Clause
"""The same water in another unit is the same picture; a scene whose unit nobody knows counts as one of natural size."""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkwater import vtkWaterProperty

UNITS = {"um": 1e-6, "mm": 1e-3, "cm": 1e-2, "m": 1.0, "km": 1e3, "in": 0.0254, "ft": 0.3048, "mi": 1609.344}
SIZE = (160, 120)
SAME = 0.005  # share of pixels that single precision may change by more than 1 of 255


def sines(look):
    look.AddWave(0.02, 1.5, 20, 10)
    look.AddWave(0.01, 0.7, 80, 50)


def everything(look):
    """Clear water with waves, foam at the shore, caustics, glitter and a normal map's ripples."""
    sines(look)
    look.RefractionOn()
    look.SetAbsorption(0.6, 0.3, 0.2)
    look.SetScattering(0.02, 0.03, 0.05)
    look.SetFoamDepth(0.5)
    look.SetCaustics(0.8)
    look.SetShoreSoftness(0.3)
    look.AddNormalMap(None, 3.0, 0.5, 30)


def sea(look):
    look.SetPreset("lake")
    look.SetSeaTileSize(64)


def displaced(look):
    look.AddWave(0.1, 3.0, 20, 10)
    look.WaveGeometryOn()


def scene(metres, set_look, units=None, time=1.5):
    """A bed and two boxes, 12 m wide, in a unit of so many metres."""
    view = wt.View(SIZE, (0.6, 0.75, 0.9))
    for middle, sizes, color in (((0, 2, -1.6), (12, 14, 1), (0.8, 0.7, 0.5)), ((1, 2, 0.5), (1, 1, 3), (0.8, 0.2, 0.1)),
                                 ((-2, 0, -0.5), (1.5, 1.5, 2), (0.2, 0.5, 0.2))):
        actor = wt.add_actor(view.renderer, wt.box(middle, sizes), color)
        place = vtkTransform()
        place.Scale(*[1 / metres] * 3)
        place.RotateX(5)
        actor.SetUserTransform(place)
    wt.add_scene_light(view.renderer, (0.3, 0.5, 0.8))
    water = wt.add_water(view.renderer, None, [edge / metres for edge in (-6, 6, -5, 9)], None)
    set_look(water.GetWaterProperty())
    if units is None:
        water.GetWaterProperty().SetMetresPerUnit(metres)
    else:
        water.GetWaterProperty().SetUnits(units)
    water.SetTime(time)
    wt.place_camera(view.renderer, [x / metres for x in (1, -9, 3)], [x / metres for x in (0, 1, 0)],
                    (0.5 / metres, 60 / metres))
    return view, water


@pytest.mark.parametrize("set_look", (sines, everything, sea, displaced))
@pytest.mark.parametrize("units", ("mm", "ft", "km"))
def test_the_same_water_in_another_unit_is_the_same_picture(set_look, units):
    metres, _ = scene(1.0, set_look)
    others, _ = scene(UNITS[units], set_look, units)
    off = np.abs(metres.picture() - others.picture()).max(axis=2) > 1
    wt.check_at_most(f"{units}: share of the pixels that differ", float(off.mean()), SAME)
    look = others.renderer.GetActors().GetLastActor().GetWaterProperty()
    look.SetUnits("m")
    off = np.abs(metres.picture() - others.picture()).max(axis=2) > 1
    wt.check_at_least(f"{units} as metres: share of the pixels that differ", float(off.mean()), 2 * SAME)


@pytest.mark.parametrize("set_look", (sines, sea))
def test_heights_and_normals_are_in_the_scenes_unit(set_look):
    _, metres = scene(1.0, set_look)
    _, feet = scene(UNITS["ft"], set_look, "ft")
    for x, y in ((0, 0), (1.2, 0.4), (-3, 5)):
        height = metres.GetWaveHeight(x, y)
        wt.check_at_most(f"height at {x}, {y}: off by, m", abs(
            UNITS["ft"] * feet.GetWaveHeight(x / UNITS["ft"], y / UNITS["ft"]) - height), 1e-9)
        normals = np.zeros((2, 3))
        metres.GetWaveNormal(x, y, normals[0])
        feet.GetWaveNormal(x / UNITS["ft"], y / UNITS["ft"], normals[1])
        wt.check_at_most("normal off by", float(np.abs(normals[0] - normals[1]).max()), 1e-9)


def test_units_by_name():
    look = vtkWaterProperty()
    wt.check_equal("default", look.GetMetresPerUnit(), 1.0)
    for name, metres in UNITS.items():
        wt.check_equal(f"{name} is one", look.SetUnits(name), True)
        wt.check_equal(f"metres of {name}", look.GetMetresPerUnit(), metres)
    wt.check_equal("automatic is one", look.SetUnits("automatic"), True)
    wt.check_equal("metres", look.GetMetresPerUnit(), 0.0)


@pytest.mark.parametrize("name", ("furlong", "", None))
def test_other_names_are_refused(name):
    look = vtkWaterProperty()
    said = wt.errors_of(look)
    look.SetUnits("ft")
    wt.check_equal("it is none", look.SetUnits(name), False)
    wt.check_equal("errors", len(said), 1)
    wt.check_equal("they name the accepted ones", all(f"{unit}, " in said[0] for unit in UNITS), True)
    wt.check_equal("it stays", look.GetMetresPerUnit(), UNITS["ft"])


@pytest.mark.parametrize("metres", (-1.0, 1e-10, 1e10, float("nan"), float("inf")))
def test_numbers_out_of_range_are_refused(metres):
    look = vtkWaterProperty()
    said = wt.errors_of(look)
    look.SetMetresPerUnit(metres)
    wt.check_equal("errors", len(said), 1)
    wt.check_equal("names the range", "[1e-09, 1e+09]" in said[0], True)
    wt.check_equal("it stays", look.GetMetresPerUnit(), 1.0)


def slope():
    """It falls from 0 to -4 along x."""
    source = vtkPlaneSource()
    source.SetOrigin(-5, -4, 0)
    source.SetPoint1(5, -4, -4)
    source.SetPoint2(-5, 4, 0)
    source.Update()
    return source.GetOutput()


def slope_from_above(exaggeration, foam=0.0):
    """A white bed that falls from 0 to 4 m of depth along x, drawn deeper, under water that absorbs; straight down."""
    view = wt.View(SIZE, (0, 0, 0))
    actor = wt.add_actor(view.renderer, slope(),
                         (1, 1, 1), lit=False)
    actor.SetScale(1, 1, exaggeration)
    water = wt.add_water(view.renderer, None, (-5, 5, -4, 4), 0.0)
    look = water.GetWaterProperty()
    look.RefractionOn()
    look.SetAbsorption(0.2, 0.5, 0.9)
    look.SetScattering(0, 0, 0)
    look.SetDeepColor(0, 0, 0)
    look.SetShoreSoftness(0.0)
    look.SetFoamDepth(foam)
    look.SetVerticalExaggeration(exaggeration)
    camera = wt.place_camera(view.renderer, (0, 0, 50), (0, 0, 0), (1, 120), (0, 1, 0))
    camera.ParallelProjectionOn()
    camera.SetParallelScale(3.5)
    return view.picture()


@pytest.mark.parametrize("exaggeration", (1.0, 4.0, 0.25))
def test_exaggerated_depths_are_as_clear_as_true_ones(exaggeration):
    """What is left of the white bed is exp(-a d) of its true depth, however deep it is drawn; and the foam ends where
    it does without exaggeration."""
    picture = slope_from_above(exaggeration)
    x = (np.arange(SIZE[0]) + 0.5 - 0.5 * SIZE[0]) * 7.0 / SIZE[1]
    depth = 0.4 * (x + 5.0)
    inside = np.abs(x) < 4.5
    expected = 255 * np.exp(-np.array((0.2, 0.5, 0.9)) * depth[inside, None])
    wt.check_at_most("colour off by, of 255", float(np.abs(picture[60, inside] - expected).max()), 2.0)
    foamy = slope_from_above(exaggeration, foam=1.0)
    wt.check_at_most("pixels of foam that differ",
                     int((np.abs(foamy - slope_from_above(1.0, foam=1.0)).max(axis=2) > 4).sum()), 20)


@pytest.mark.parametrize("factor", (0.0, -2.0, float("nan"), 1e7))
def test_an_exaggeration_out_of_range_is_refused(factor):
    look = vtkWaterProperty()
    said = wt.errors_of(look)
    look.SetVerticalExaggeration(factor)
    wt.check_equal("errors that name the range", ["must lie in [1e-06, 1e+06]" in text for text in said], [True])
    wt.check_equal("it stays", look.GetVerticalExaggeration(), 1.0)


def printed(water):
    return next(line for line in str(water).splitlines() if "MetresPerUnit in use" in line)


@pytest.mark.parametrize("size", (1e-3, 1.0, 1e3, 1e7))
def test_automatic_water_counts_as_natural_at_any_size(size):
    """From a millimetre to a continent a scene counts as one of natural size, as is printed."""
    other, water = scene(1.0 / size, everything, "automatic")
    metres = float(printed(water).split(":")[1].split(";")[0])
    diagonal = np.linalg.norm(np.diff(np.array(bounds_of(other.renderer)).reshape(3, 2)))
    wt.check_at_least("m across", metres * diagonal, 199.9)
    wt.check_at_most("m across", metres * diagonal, 2000.1)


def bounds_of(renderer):
    """Of all but the water."""
    boxes = np.array([actor.GetBounds() for actor in renderer.GetActors() if not actor.IsA("vtkWaterActor")])
    low, high = boxes[:, ::2].min(axis=0), boxes[:, 1::2].max(axis=0)
    return np.stack([low, high], axis=1).ravel()


def test_waves_that_are_too_short_for_the_scene_are_calm():
    """Waves of 0.7 and 1.5 m in a scene that counts as 2000 m: it is calm, heights and the printout say so."""
    view, water = scene(0.001, sines, "automatic")  # 12,000 units wide
    wt.check_equal("height", water.GetWaveHeight(100.0, 200.0), 0.0)
    wt.check_equal("printed", "too short" in printed(water), True)
    calm, still = scene(0.001, lambda look: None, "automatic")
    wt.check_equal("difference from calm water", wt.difference(view.picture(), calm.picture()), 0)
    water.GetWaterProperty().AddWave(0.5, 20.0)
    wt.check_equal("longer ones are seen", "too short" in printed(water), False)
    wt.check_at_least("and differ", wt.difference(view.picture(), calm.picture()), 5)
    wt.check_equal("no error", still.GetLastError(), "")


def test_automatic_units_follow_the_scene_whenever_it_comes():
    """Water before the meshes, or after: the same."""
    first, _ = scene(1.0, everything, "automatic")
    late, water = scene(1.0, everything, "automatic")
    actors = [actor for actor in late.renderer.GetActors() if not actor.IsA("vtkWaterActor")]
    for actor in actors:
        late.renderer.RemoveActor(actor)
    late.window.Render()
    for actor in actors:
        late.renderer.AddActor(actor)
    wt.check_equal("difference", wt.difference(first.picture(), late.picture()), 0)


def test_units_stay_while_a_thing_moves():
    """Also if the scene grows a little with it."""
    view, water = scene(1.0, everything, "automatic")
    ball = wt.add_actor(view.renderer, wt.sphere((0, 0, 0), 0.1), (1, 0, 0))
    seen, sizes = set(), set()
    for x in np.linspace(6, 8, 5):
        ball.SetPosition(x, 0, 0)
        view.picture()
        seen.add(printed(water))
        sizes.add(bounds_of(view.renderer)[1])
    wt.check_equal("sizes of the scene", len(sizes), 5)
    wt.check_equal("units", len(seen), 1)


def test_bounds_of_displaced_water_are_in_the_scenes_unit():
    """How far steep waves move points up, down and aside."""
    def steep(look):
        look.AddWave(0.1, 3.0, 20, 10, 1.0)
        look.WaveGeometryOn()
    _, metres = scene(1.0, steep)
    _, feet = scene(UNITS["ft"], steep, "ft")
    off = np.abs(np.array(metres.GetBounds()) - UNITS["ft"] * np.array(feet.GetBounds())).max()
    wt.check_at_most("off by, m", float(off), 1e-6)


def bed_seen(depth, units):
    """The colour of a red bed at a depth, in a scene 100 units wide, from above."""
    view = wt.View((60, 40), (0.5, 0.6, 0.8))
    wt.add_actor(view.renderer, wt.box((0, 0, -depth - 0.5), (100, 100, 1)), (0.8, 0.1, 0.1), lit=False)
    water = wt.add_water(view.renderer, None, (-50, 50, -50, 50), None)
    water.GetWaterProperty().RefractionOn()
    water.GetWaterProperty().SetUnits(units)
    wt.place_camera(view.renderer, (0, -1, 60), (0, 0, 0), (1, 200))
    return view.picture()[20, 30].astype(int)


def test_shallow_beds_of_unknown_units_count_as_deep():
    """Half a unit of water hides a bed where the scene's unit is not known; as half a metre it does not."""
    deep = bed_seen(20, "automatic")
    wt.check_at_most("automatic: red over that of deep water", int((bed_seen(0.5, "automatic") - deep)[0]), 8)
    wt.check_at_least("metres: red over that of deep water", int((bed_seen(0.5, "m") - deep)[0]), 80)


@pytest.mark.parametrize("size", (1e-3, 1.0, 1e5))
def test_objects_in_open_water_are_seen_to_their_foot(size):
    """The foot of a pyramid in open water of an unknown unit is as good as 10 m deep. It differs from the water beside it
    all along its edge: what is as good as 30 m deep shows a glow at the waterline that fades before the foot."""
    view = wt.View((160, 120), (1.0, 1.0, 1.0))
    wt.add_actor(view.renderer, wt.pyramid((0, 0, 0.2 * size), size, radius=0.5 * size), (1.0, 0.55, 0.0), lit=False)
    water = wt.add_water(view.renderer, None, None, None)
    water.SetSheetToAutomatic()
    look = water.GetWaterProperty()
    look.RefractionOn()
    look.SetUnits("automatic")
    wt.place_camera(view.renderer, (0, -2.0 * size, 2.2 * size), (0, 0, -0.2 * size), (0.1 * size, 100 * size))
    picture = view.picture()
    wt.save(picture, wt.output_folder() / f"foot_{size:g}.png")
    off = np.abs(picture[:, 80].astype(int) - picture[:, 20]).max(axis=1)  # through the foot, and beside it
    foot = int((off > 4).argmax())
    wt.check_at_least("the foot's row from below", foot, 10)
    wt.check_at_least("the foot over the water beside it, of 255", int(off[foot + 1]), 50)


def test_calm_water_has_no_waves_to_hide():
    view, water = scene(1.0, lambda look: None, "automatic")
    view.picture()
    wt.check_equal("printed", "too short" in printed(water), False)


def test_heights_of_waves_do_not_ask_the_scene_again():
    """Between frames they are those of the last one."""
    view, water = scene(1.0, sines, "automatic")
    view.picture()
    before = water.GetWaveHeight(0.3, 0.2)
    wt.add_actor(view.renderer, wt.sphere((500, 0, 0), 1), (1, 0, 0))
    wt.check_equal("before the next frame", water.GetWaveHeight(0.3, 0.2), before)
    view.picture()
    wt.check_equal("after it", water.GetWaveHeight(0.3, 0.2) == before, False)


def test_small_things_have_a_reflection():
    """A ball of 2 cm in clear water, as dark for its size as that of a ball of 20 m, looks like this."""
    pictures = []
    for radius in (0.01, 10.0):
        view = wt.View((240, 180))
        view.renderer.SetBackground(0.9, 0.9, 0.9)
        wt.add_actor(view.renderer, wt.sphere((0, 0, 0), radius), (1, 0.5, 0.2), lit=False)
        water = wt.add_water(view.renderer, sheet=(-20 * radius, 20 * radius, -20 * radius, 20 * radius), reflectance=0.5)
        look = water.GetWaterProperty()
        look.RefractionOn()
        look.SetDeepColor(0.1, 0.2, 0.3)
        look.SetAbsorption(2 / radius, 2 / radius, 2 / radius)
        wt.place_camera(view.renderer, (4 * radius, -5 * radius, 1.2 * radius), (0, 0, 0), (0.1 * radius, 60 * radius))
        pictures.append(view.picture().astype(int))
    share = (np.abs(pictures[0] - pictures[1]).max(axis=2) > 10).mean()
    wt.check_at_most("share of pixels in which a small ball differs from a large one", share, 0.02)

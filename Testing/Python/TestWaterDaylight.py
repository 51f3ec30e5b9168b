# SPDX-License-Identifier: BSD-3-Clause
"""Deep water has the colour that its medium sends back of the scene's light: of its sky and of its lights."""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.vtkRenderingCore import vtkLight
from vtkwater import vtkWaterProperty
from vtkwater.scenes import Scene

ABSORPTION, SCATTERING = (0.3, 0.06, 0.02), (0.002, 0.004, 0.01)
SIZE = (32, 24)


def encoded(linear):
    """As the display shows it (IEC 61966-2-1)."""
    linear = np.clip(linear, 0, 1)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * np.power(linear, 1 / 2.4) - 0.055)


def decoded(shown):
    shown = np.asarray(shown, float)
    return np.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)


def shown_under(daylight, absorption=ABSORPTION, scattering=SCATTERING):
    """The colour of infinitely deep water, 0 to 255: 0.33 b / (a + b) of the light."""
    a, b = np.array(absorption), np.array(scattering)
    return 255 * encoded(0.33 * b / (a + b) * np.asarray(daylight))


def pool(background=(0, 0, 0), top=None, elevation=30, refraction=False):
    """Water that reflects nothing, seen from above, under a sky and without lights."""
    view = wt.View(SIZE, background)
    if top is not None:
        view.renderer.GradientBackgroundOn()
        view.renderer.SetBackground2(top)
    view.renderer.AutomaticLightCreationOff()
    view.renderer.RemoveAllLights()
    water = wt.add_water(view.renderer, None, (-50, 50, -50, 50), 0.0)
    look = water.GetWaterProperty()
    look.SetAbsorption(ABSORPTION)
    look.SetScattering(SCATTERING)
    look.SetRefraction(refraction)
    angle = np.radians(elevation)
    wt.place_camera(view.renderer, (0, -8 * np.cos(angle), 8 * np.sin(angle)), (0, 0, 0), (0.1, 100))
    return view, water


def add_light(view, elevation, intensity=1.0, color=(1, 1, 1), kind="SceneLight"):
    light = vtkLight()
    getattr(light, f"SetLightTypeTo{kind}")()
    angle = np.radians(elevation)
    light.SetPosition(0, np.cos(angle), np.sin(angle))
    light.SetFocalPoint(0, 0, 0)
    light.SetIntensity(intensity)
    light.SetDiffuseColor(color)
    view.renderer.AddLight(light)
    return light


def check_color(name, view, expected):
    shown = view.picture()[SIZE[1] // 2, SIZE[0] // 2]
    wt.check_at_most(f"{name}: off by, of 255", float(np.abs(shown - expected).max()), 0.51)


@pytest.mark.parametrize("refraction", (False, True))
def test_the_sky_lights_deep_water(refraction):
    """The mean of the sky's light, with and without a view into the water."""
    view, _ = pool((0.9, 0.8, 0.7), (0.2, 0.4, 0.9), refraction=refraction)
    daylight = 0.5 * (decoded((0.9, 0.8, 0.7)) + decoded((0.2, 0.4, 0.9)))
    check_color("gradient", view, shown_under(daylight))
    view.renderer.GradientBackgroundOff()
    check_color("one colour", view, shown_under(decoded((0.9, 0.8, 0.7))))


def test_lights_add_to_the_sky():
    """Each by its height, colour and intensity; what is off, or under the horizon, adds nothing."""
    view, _ = pool()
    check_color("no light", view, np.zeros(3))
    add_light(view, 30, 2.0, (1.0, 0.5, 0.25))
    daylight = np.array((1.0, 0.5, 0.25))
    check_color("a light at 30 degrees", view, shown_under(daylight))
    second = add_light(view, 90)
    check_color("and one at the zenith", view, shown_under(daylight + 1.0))
    second.SetSwitch(False)
    check_color("which is off", view, shown_under(daylight))
    second.SetSwitch(True)
    second.SetPosition(0, 0, -1)
    check_color("or under water", view, shown_under(daylight))


def test_lamps_are_no_daylight():
    view, _ = pool()
    add_light(view, 90).PositionalOn()
    check_color("a positional light", view, np.zeros(3))


@pytest.mark.parametrize("elevation", (20, 60))
def test_a_headlight_stands_where_the_eye_is(elevation):
    view, _ = pool(elevation=elevation)
    light = vtkLight()
    light.SetLightTypeToHeadlight()
    view.renderer.AddLight(light)
    check_color(f"{elevation} degrees", view, shown_under(np.full(3, np.sin(np.radians(elevation)))))


def test_tilted_water_counts_from_its_own_normal():
    view, water = pool()
    add_light(view, 90)
    water.GetPlane().SetNormal(0, -np.sin(np.radians(60)), 0.5)
    wt.place_camera(view.renderer, (0, -8, 4), (0, 0, 0), (0.1, 100))
    check_color("60 degrees to the light", view, shown_under(np.full(3, 0.5)))


def test_a_color_that_is_given_is_not_lit():
    view, water = pool((0.9, 0.8, 0.7))
    look = water.GetWaterProperty()
    wt.check_equal("by default", look.GetDeepColorModeAsString(), "MEDIUM")
    look.SetDeepColor(0.2, 0.4, 0.6)
    wt.check_equal("after SetDeepColor", look.GetDeepColorMode(), vtkWaterProperty.GIVEN)
    check_color("given", view, 255 * np.array((0.2, 0.4, 0.6)))
    add_light(view, 90)
    check_color("in another light", view, 255 * np.array((0.2, 0.4, 0.6)))
    look.SetDeepColorModeToMedium()
    check_color("of the medium again", view, shown_under(decoded((0.9, 0.8, 0.7)) + 1.0))
    wt.check_at_most("what is said of it, off by", np.abs(
        255 * np.array(look.GetDeepColor()) - shown_under(np.ones(3))).max(), 1e-9)


def test_presets_and_types_bring_their_own_color():
    look = vtkWaterProperty()
    look.SetDeepColor(1, 0, 0)
    look.SetWaterType("IB")
    wt.check_equal("a type", look.GetDeepColorModeAsString(), "MEDIUM")
    look.SetDeepColor(1, 0, 0)
    look.SetPreset("lake")
    wt.check_equal("a preset", look.GetDeepColorModeAsString(), "MEDIUM")
    wt.check_equal("is not red", look.GetDeepColor()[0] < 0.5, True)


def test_bad_modes_are_refused():
    look = vtkWaterProperty()
    said = wt.errors_of(look)
    look.SetDeepColorMode(2)
    wt.check_equal("errors", len(said), 1)
    wt.check_equal("names the range", "[0, 1]" in said[0], True)
    wt.check_equal("it stays", look.GetDeepColorModeAsString(), "MEDIUM")


def test_water_in_a_mirror_has_its_light_too():
    """A perfect mirror shows tilted water in the light that this has."""
    view, first = pool()
    view.renderer.RemoveViewProp(first)
    add_light(view, 90)
    wt.add_water(view.renderer, None, (-50, 50, -50, 50), 1.0).SetLevel(-1)
    wall = wt.add_water(view.renderer, None, (-50, 50, -50, 50), 0.0)
    look = wall.GetWaterProperty()
    look.SetAbsorption(ABSORPTION)
    look.SetScattering(SCATTERING)
    wall.GetPlane().SetOrigin(0, 5, 0)
    wall.GetPlane().SetNormal(0, -1, 1)
    wt.place_camera(view.renderer, (0, -8, 3), (0, 0, -1), (0.1, 100))
    check_color("45 degrees to the light", view, shown_under(np.full(3, np.sqrt(0.5))))


def tropical(eye, look, elevation, deep=None):
    """The median colour of "clear tropical", from a depth of -eye, under a clear sky with its sun at 150 degrees."""
    scene = Scene((80, 60))
    scene.set_clear_sky(150.0, elevation, 2.5)
    water = scene.add_water(0.0, "clear tropical")
    water.SetSheetToHorizon()
    if deep is not None:
        water.GetWaterProperty().SetDeepColor(deep)
    scene.set_camera((0.0, 0.0, eye), tuple(np.add((0.0, 0.0, eye), look)), 60.0)
    return np.median(np.asarray(scene.picture()).reshape(-1, 3), axis=0)


@pytest.mark.parametrize("azimuth", (0, 90, 150, 270))
@pytest.mark.parametrize("elevation", (60, 75))
def test_clear_water_is_blue_to_an_eye_in_it(elevation, azimuth):
    """A level look from a depth of 5 m in "clear tropical", under a clear sky with its sun, is blue, and not black."""
    turn = np.radians(azimuth)
    red, green, blue = tropical(-5.0, (10 * np.sin(turn), 10 * np.cos(turn), 0.0), elevation)
    name = f"clear tropical at 5 m, sun at {elevation} degrees, look to {azimuth}"
    wt.check_at_least(f"{name}: blue of 255", float(blue), 61)
    wt.check_at_least(f"{name}: green of 255", float(green), 61)
    wt.check_at_least(f"{name}: green less red", float(green - red), 20)
    wt.check_at_least(f"{name}: blue less green", float(blue - green), 20)


def test_haze_depends_on_depth_and_direction():
    """Deeper is darker, down is darker than level, towards the sun is brighter than away from it."""
    away = (0.0, 10.0, 0.0)
    shallow, deep = tropical(-2.0, away, 60), tropical(-12.0, away, 60)
    towards = tropical(-5.0, (5.0, -8.66, 0.0), 60)
    level = tropical(-5.0, away, 60)
    steep = tropical(-5.0, (0.0, 1.0, -8.0), 60)
    wt.check_at_least("2 m over 12 m: green", float(shallow[1] - deep[1]), 15)
    wt.check_at_least("towards the sun over away from it: green", float(towards[1] - level[1]), 8)
    wt.check_at_least("level over down: green", float(level[1] - steep[1]), 10)


def test_a_color_that_is_given_is_the_haze():
    """In all directions and depths."""
    for eye, look in ((-2.0, (0, 1, 0)), (-12.0, (0, 1, 0)), (-5.0, (0, 0.1, -1))):
        shown = tropical(eye, look, 60, (0.2, 0.4, 0.6))
        wt.check_at_most(f"at {-eye} m: off by, of 255", float(np.abs(shown - (51, 102, 153)).max()), 1.0)


def test_straight_down_under_the_surface_is_the_deep_color():
    """An eye just under the water sees of water without an end, straight down, what one over it sees."""
    view, _ = pool((0.9, 0.8, 0.7), refraction=True)
    expected = shown_under(decoded((0.9, 0.8, 0.7)))
    check_color("from above", view, expected)
    wt.place_camera(view.renderer, (0, -0.001, -0.02), (0, 0, -8), (0.01, 100))
    check_color("from just under it", view, expected)

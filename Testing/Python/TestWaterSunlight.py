# SPDX-License-Identifier: BSD-3-Clause
"""The sun glitters on waves that are too small to be drawn as the formula says, and its shadows and caustics lie
where rays, cast and counted, have them."""

import math

import numpy as np
import pytest
import ray_caster
import water_test as wt
from dark_water import SIZE, add_dark_water, check_refused, look_at, pixel_rays
from vtkmodules.util.misc import calldata_type
from vtkmodules.vtkCommonCore import VTK_OBJECT
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkToneMappingPass
from vtkwater import vtkWaterActor

INDEX = 1.333
SUN = np.array((0.3, 0.6, 0.55))
TO_SUN = SUN / np.linalg.norm(SUN)
# slope variances along and across the wind, direction of the wind in degrees
WINDS = ((0.02, 0.02, 0.0), (0.03, 0.012, 0.0), (0.03, 0.012, 40.0))
WAVE, DEPTH = (0.03, 1.5, 0.0, 0.0), 1.5  # amplitude, wavelength, direction, phase; of the bed


def glittering(along, across, wind):
    """Dark water under the sun, its look, and the camera."""
    view = wt.View(SIZE, (0, 0, 0))
    wt.add_scene_light(view.renderer, SUN)
    view.renderer.GetLights().GetItemAsObject(0).SetIntensity(0.5)
    look = add_dark_water(view).GetWaterProperty()
    look.SetSlopeVariance(along, across, wind)
    look.HighlightRollOffOff()
    return view, look, look_at(view, (1, -10, 6), angle=60)


def hidden(way, axes, along, across):
    """How many times as many facets face directions (n x 3) as are seen from there, less 1: Smith's formula."""
    spread = np.sqrt(2 * (along * (way[:, :2] @ axes[0]) ** 2 + across * (way[:, :2] @ axes[1]) ** 2))
    nu = np.clip(way[:, 2] / spread, 1e-3, 20)
    return 0.5 * (np.exp(-nu**2) / (nu * np.sqrt(np.pi)) - np.array([math.erfc(number) for number in nu]))


@pytest.mark.parametrize("along, across, wind", WINDS)
def test_glitter_is_that_of_the_formula(along, across, wind):
    """Glitter of small slopes is Cox and Munk's Gaussian along and across the wind.

    It is written here again; the radiance is pi I F p / (4 cos(eye) cos^4(facet)), less what waves hide of each other
    from the sun and from the eye (Smith).
    """
    view, _, camera = glittering(along, across, wind)
    _, ray = pixel_rays(camera)
    facet = TO_SUN - ray
    facet /= np.linalg.norm(facet, axis=1, keepdims=True)
    slope = -facet[:, :2] / facet[:, 2:]
    turn = np.radians(wind)
    first = slope @ (np.cos(turn), np.sin(turn))
    second = slope @ (-np.sin(turn), np.cos(turn))
    density = np.exp(-0.5 * (first**2 / along + second**2 / across)) / (2 * np.pi * np.sqrt(along * across))
    expected = np.pi * 0.5 * ray_caster.fresnel(facet @ TO_SUN) * density / (4 * -ray[:, 2] * facet[:, 2] ** 4)
    axes = np.array(((np.cos(turn), np.sin(turn)), (-np.sin(turn), np.cos(turn))))
    expected /= 1 + hidden(-ray, axes, along, across) + hidden(TO_SUN[None], axes, along, across)
    shown = view.picture()[:, :, 0].ravel() / 255
    good = (ray[:, 2] < -0.05) & (expected < 0.99)
    name = f"glitter, variances {along}, {across}, wind {wind:g} degrees"
    wt.check_at_most(f"{name}: largest error", float(np.abs(shown - expected)[good].max()), 0.01)
    wt.check_at_least(f"{name}: brightest pixel that is compared", float(shown[good].max()), 0.25)


def test_highlights_roll_off():
    """No pixel of the glitter is white; what is not bright stays as it is; what is clipped without it has shapes."""
    view, look, _ = glittering(0.003, 0.003, 0.0)
    view.renderer.GetLights().GetItemAsObject(0).SetIntensity(1.5)
    clipped = view.picture()[:, :, 0].astype(int)
    look.HighlightRollOffOn()
    rolled = view.picture()[:, :, 0].astype(int)
    is_clipped = clipped == 255
    wt.check_at_least("share that is clipped without it", float(is_clipped.mean()), 0.01)
    wt.check_at_most("brightest of 255", int(rolled.max()), 253)
    wt.check_at_least("brightest against darkest where it was clipped", int(np.ptp(rolled[is_clipped])), 20)
    wt.check_at_most("what is below 0.6 differs by", int(np.abs(rolled - clipped)[clipped < 153].max()), 1)
    wt.check_at_most("radiance that is lost", float(1 - rolled.sum() / clipped.sum()), 0.05)


def test_highlights_keep_their_range_before_a_tone_mapping():
    """Where a pass maps tones nothing rolls off: the picture is the same with it and without."""
    view, look, _ = glittering(0.003, 0.003, 0.0)
    view.renderer.GetLights().GetItemAsObject(0).SetIntensity(1.5)
    tones = vtkToneMappingPass()
    tones.SetDelegatePass(vtkRenderStepsPass())
    view.renderer.SetPass(tones)
    pictures = []
    for rolls in (False, True):
        look.SetHighlightRollOff(rolls)
        pictures.append(view.picture().astype(int))
    wt.check_equal("pixels that differ", int((pictures[0] != pictures[1]).any(axis=2).sum()), 0)


def test_glitter_can_be_switched_off():
    """Without glitter the dark water is black."""
    view, look, _ = glittering(*WINDS[-1])
    view.picture()
    look.GlitterOff()
    wt.check_equal("glitter off: brightest pixel", int(view.picture().max()), 0)


def test_without_a_light_foam_shows_the_sky_alone():
    """Without a light there are no caustics and no shadows, foam shows the sky's light, and nothing is an error."""
    pictures = {}
    for name, settings in (("plain", {}), ("caustics", {"Caustics": 1.0}), ("shadows", {"Shadows": True}),
                           ("foam", {"FoamDepth": 40.0})):
        view = wt.View((120, 90), (0.5, 0.6, 0.7))
        view.renderer.AutomaticLightCreationOff()
        wt.add_actor(view.renderer, wt.box((0, 0, -1.05), (60, 60, 0.1)), (0.6, 0.5, 0.4), lit=False)
        water = vtkWaterActor()
        water.SetSheetBounds(-25, 25, -25, 25)
        look = water.GetWaterProperty()
        look.RefractionOn()
        look.AddWave(0.03, 2.0, 20.0)
        for setting, value in settings.items():
            getattr(look, f"Set{setting}")(value)
        errors = wt.errors_of(water)
        view.renderer.AddActor(water)
        wt.place_camera(view.renderer, (0, -6, 6), (0, 0, 0), (0.5, 90))
        pictures[name] = view.picture()
        wt.check_equal(f"{name}: errors", errors, [])
    for name in ("caustics", "shadows"):
        wt.check_equal(f"{name}: pixels that change", int((pictures[name] != pictures["plain"]).any(axis=2).sum()), 0)
    foam = np.array(look.GetFoamColor()) * (0.5, 0.6, 0.7) * 255
    is_foam = np.abs(pictures["foam"] - foam).max(axis=2) <= 2
    wt.check_at_least("pixels of foam", int(is_foam.sum()), 100)


def test_headlight_is_no_sun():
    """A headlight makes no glitter."""
    view, _, _ = glittering(*WINDS[-1])
    view.picture()
    view.renderer.RemoveAllLights()
    view.renderer.CreateLight()
    wt.check_equal("a headlight is no sun: brightest pixel", int(view.picture().max()), 0)


def test_without_a_sun_the_shader_has_no_glitter():
    """A shader has the code of glitter while a scene light shines, whether it was there at first or comes later."""
    view, look, _ = glittering(*WINDS[-1])
    light = view.renderer.GetLights().GetItemAsObject(0)
    used = []

    @calldata_type(VTK_OBJECT)
    def ask(mapper, event, program):
        used.append(program.IsUniformUsed("waterRollsOff"))

    water = next(prop for prop in view.renderer.GetViewProps() if prop.IsA("vtkWaterActor"))
    water.GetMapper().AddObserver("UpdateShaderEvent", ask)
    bright = []
    for is_on in (False, True, False, True):
        light.SetSwitch(is_on)
        bright.append(int(view.picture().max()) > 60)
        wt.check_equal(f"sun {'on' if is_on else 'off'}: the shader has glitter", used[-1], is_on)
    wt.check_equal("glitter is seen with the sun alone", bright, [False, True, False, True])


def test_wind_gives_cox_and_munks_variances():
    """A wind of 10 m/s gives the slope variances that Cox and Munk measured."""
    _, look, _ = glittering(*WINDS[-1])
    look.SetSlopeVarianceToWind(10.0, 30.0)
    given = [0.0, 0.0, 0.0]
    look.GetSlopeVariance(given)
    wt.check_at_most("wind of 10 m/s: error of Cox and Munk's variances",
                     float(np.abs(np.array(given) - (0.0316, 0.0222, 30)).max()), 1e-12)


def test_shadow_on_glitter_is_where_rays_to_the_sun_are_stopped():
    """A post's shadow lies on the glitter where the ray from the water to the sun meets the post."""
    view = wt.View(SIZE, (0, 0, 0))
    post = ray_caster.Box((0.4, 1.0, 1), (0.8, 0.8, 3), (0, 0, 0))
    wt.add_actor(view.renderer, wt.box(0.5 * (post.low + post.high), post.high - post.low), (0, 0, 0), lit=False)
    wt.add_scene_light(view.renderer, SUN)
    view.renderer.GetLights().GetItemAsObject(0).SetIntensity(6)
    look = add_dark_water(view).GetWaterProperty()
    look.SetReflectanceModeToFresnel()
    look.SetSlopeVariance(0.08, 0.08)
    camera = look_at(view, (1, -10, 6))
    bright = view.picture()[:, :, 0]
    look.ShadowsOn()
    shadowed = view.picture()[:, :, 0]
    place, ray = pixel_rays(camera)
    _, way = ray_caster.cast([post], (0, 0, 0), place + 1e-6 * TO_SUN, np.tile(TO_SUN, (len(place), 1)))
    _, seen = ray_caster.cast([post], (0, 0, 0), np.tile(camera.GetPosition(), (len(place), 1)), ray)
    is_shaded = (np.isfinite(way) & ~np.isfinite(seen)).reshape(SIZE[1], SIZE[0]) & (bright > 30)
    is_lit = (~np.isfinite(way) & ~np.isfinite(seen)).reshape(SIZE[1], SIZE[0]) & (bright > 30)
    wt.check_at_least("shadow: pixels of glitter in it", int(is_shaded.sum()), 300)
    wt.check_at_least("shadow: % of them that are dark", 100 * float((shadowed < 10)[is_shaded].mean()), 90)
    # a shadow's edge is soft over a pixel
    wt.check_at_least("shadow: % of the lit glitter that stays", 100 * float((shadowed == bright)[is_lit].mean()), 94)


def test_caustics_are_where_rays_gather():
    """Of one wave over a level bed, light gathers where the rays from the surface do, counted."""
    view = wt.View(SIZE, (0, 0, 0))
    wt.add_actor(view.renderer, wt.box((0, 0, -DEPTH - 0.5), (300, 300, 1)), (0.4, 0.4, 0.4), lit=False)
    wt.add_scene_light(view.renderer, (0, 0, 1))
    look = add_dark_water(view).GetWaterProperty()
    look.RefractionOn()
    look.SetAbsorption(0, 0, 0)
    look.SetScattering(0, 0, 0)
    look.GlitterOff()
    look.AddWave(*WAVE)
    look_at(view, (0, 0, 12), angle=20, up=(0, 1, 0))
    plain = view.picture()[110, :, 0].astype(float)
    look.SetCaustics(1.0)
    row = view.picture()[110, :, 0] / plain
    x = np.linspace(-6, 6, 400001)
    _, slope, _ = ray_caster.heights_and_slopes((WAVE,), x, np.zeros_like(x), 0.0)
    tilt = np.arctan(slope)
    lands = x + DEPTH * np.tan(tilt - np.arcsin(np.sin(tilt) / INDEX))
    edges = np.linspace(-2.2, 2.2, 111)
    light = np.histogram(lands, edges)[0] / (len(x) / 12 * (edges[1] - edges[0]))
    apparent = DEPTH / INDEX  # straight down: the bed seems nearer
    pixel = 2 * (12 + apparent) * np.tan(np.radians(10)) / SIZE[1]
    at = (np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2) * pixel
    shown = np.interp(0.5 * (edges[1:] + edges[:-1]), at, row)
    wt.check_at_least("caustics: correlation with counted rays", float(np.corrcoef(shown, light)[0, 1]), 0.9)
    wt.check_at_most("caustics: error of the mean light", abs(float(shown.mean()) - float(light.mean())), 0.05)
    wt.check_at_least("caustics: brightest over darkest", float(shown.max() / shown.min()), 1.4)


@pytest.mark.parametrize("setter, value, words", (
    ("SetSlopeVariance", (-0.1, 0.1), ("-0.1", "must lie in [0, ")),
    ("SetSlopeVariance", (0.1, float("nan")), ("nan", "finite")),
    ("SetSlopeVarianceToWind", (0.0,), ("0 m/s", "[0.1, 100]")),
    ("SetCaustics", (2.0,), ("2", "[0, 1]")),
), ids=("a negative variance", "a variance that is no number", "no wind", "caustics over 1"))
def test_bad_values_are_refused(setter, value, words):
    """A bad value gives one clear error and changes nothing."""
    check_refused(setter, value, words)

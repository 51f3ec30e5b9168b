# SPDX-License-Identifier: BSD-3-Clause
"""The water finds its sky by itself: rays that leave the mirrored view, water in other water, and an eye under
water see what VTK itself shows in their direction.

The environment may ask for more skies of each kind: WATER_SKY_SEEDS, a number.
"""

import os

import numpy as np
import pytest
import ray_caster
import sky_scenes
import water_test as wt
from dark_water import look_at
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkSkybox, vtkTexture

SIZE, LEVEL = sky_scenes.SIZE, sky_scenes.LEVEL
KINDS = sky_scenes.PROJECTIONS + sky_scenes.SCREENS
SEEDS = int(os.environ.get("WATER_SKY_SEEDS", 1))  # odd ones are gamma corrected
RAYS = 40  # of each picture that are looked at: the truth of a ray is a picture, too
LIMIT = 2.0  # of 255


def wavy_scene(kind, seed, waves, rays):
    view = wt.View(SIZE)
    box = sky_scenes.give_sky(view.renderer, kind, seed)
    water = wt.add_water(view.renderer, wt.plane((0, 0, LEVEL), (0, 0, 1)), (-300, 300, -300, 300))
    look = water.GetWaterProperty()
    look.SetDeepColor(0, 0, 0)
    look.SetRayTraceRays(rays)
    for wave in waves:
        look.AddWave(*wave)
    look_at(view, (0, -6, LEVEL + 9), (0.5, 0, LEVEL), 45)
    return view, water, box


def reflected_rays(view, waves, shift=(0, 0)):
    """Of all pixels that look at the water: their number, place, and the reflected ray.

    shift: from the pixels' middle, pixels
    """
    width, height = SIZE
    y, x = (each.ravel() for each in np.mgrid[0:height, 0:width])
    start, ray = ray_caster.rays_at(view.renderer.GetActiveCamera(), SIZE, (2 * (x + shift[0]) + 1) / width - 1,
                                    (2 * (y + shift[1]) + 1) / height - 1)
    place = start - ((start[:, 2] - LEVEL) / ray[:, 2])[:, None] * ray
    _, sx, sy = ray_caster.heights_and_slopes(waves, place[:, 0], place[:, 1], 0.0)
    normal = np.stack([-sx, -sy, np.ones_like(sx)], axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    away = ray - 2 * (ray * normal).sum(axis=1, keepdims=True) * normal
    return np.flatnonzero((ray[:, 2] < -0.15) & (away[:, 2] > 0.05)), place, away


def check_colours(name, shown, expected, limit=LIMIT):
    error = np.abs(shown - expected).max(axis=1)
    wt.check_at_least(f"{name}: rays", len(error), 20)
    wt.check_at_most(f"{name}: error of 255", round(float(error.max()), 2), limit)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("rays", (1, 4))
def test_rays_that_leave_the_picture_see_the_sky(kind, rays):
    """Waves seen from above send rays to all sides, and few of them into the picture. A pixel of several rays is compared
    where the sky changes little in it."""
    first = 3 if rays == 1 else 4
    for seed in range(first, first + SEEDS):
        chance = np.random.default_rng(seed)
        waves = ((0.5, 9.0, float(chance.uniform(0, 360)), 10.0),)
        view, _, _ = wavy_scene(kind, seed, waves, rays)
        shown = view.picture().reshape(-1, 3)
        number, place, away = reflected_rays(view, waves)
        number = chance.choice(number, RAYS, replace=False)
        expected = sky_scenes.truth(view, kind, seed, place[number], away[number])
        is_even = np.ones(len(number), bool)
        if rays > 1:
            for shift in ((-0.5, -0.5), (0.5, 0.5), (-0.5, 0.5), (0.5, -0.5)):
                _, moved, turned = reflected_rays(view, waves, shift)
                other = sky_scenes.truth(view, kind, seed, moved[number], turned[number])
                is_even &= np.abs(other - expected).max(axis=1) <= 8
        check_colours(f"{kind}, {seed}", shown[number[is_even]], expected[is_even])


def water_at(kind, seed, reflectance=0.0):
    """Clear, calm water of no colour, seen from below."""
    view = wt.View(SIZE)
    box = sky_scenes.give_sky(view.renderer, kind, seed)
    water = wt.add_water(view.renderer, wt.plane((0, 0, LEVEL), (0, 0, 1)), (-300, 300, -300, 300), reflectance)
    look = water.GetWaterProperty()
    look.RefractionOn()
    look.SetAbsorption(0, 0, 0)
    look.SetScattering(0, 0, 0)
    return view, water, box


@pytest.mark.parametrize("kind", KINDS)
def test_an_eye_under_water_sees_the_sky(kind):
    """Through Snell's window the whole sky is seen, to the horizon. The eye looks up, and to the side."""
    for seed, target in ((3, (0.5, 1, 5)), (4, (2, 1, 3))):
        view, _, _ = water_at(kind, seed)
        look_at(view, (0, 0, LEVEL - 5), (target[0], target[1], LEVEL - 5 + target[2]), 70, (0, 1, 0))
        shown = view.picture().reshape(-1, 3)
        start, ray = ray_caster.eye_rays(view.renderer.GetActiveCamera(), SIZE, 1)
        side = 1.333 * ray[:, :2]
        height = 1 - (side**2).sum(axis=1)
        number = np.flatnonzero((ray[:, 2] > 0.1) & (height > 0.02))
        number = np.random.default_rng(seed).choice(number, 60, replace=False)
        away = np.concatenate([side[number], np.sqrt(height[number])[:, None]], axis=1)
        place = start[number] + ((LEVEL - start[number, 2]) / ray[number, 2])[:, None] * ray[number]
        check_colours(f"under water, {kind}, {seed}", shown[number], sky_scenes.truth(view, kind, seed, place, away))


@pytest.mark.parametrize("kind", KINDS)
def test_water_in_other_water_sees_the_sky(kind):
    """Calm water mirrors a tilted sheet that is a mirror, too: rays that both have turned see the sky."""
    for seed in range(4, 4 + SEEDS):
        chance = np.random.default_rng(seed)
        view = wt.View(SIZE)
        sky_scenes.give_sky(view.renderer, kind, seed)
        wt.add_water(view.renderer, wt.plane((0, 0, LEVEL), (0, 0, 1)), (-100, 100, -100, 100))
        normal = np.array((chance.uniform(-0.3, 0.3), -1.0, chance.uniform(-0.2, 0.4)))
        normal /= np.linalg.norm(normal)
        middle = np.array((0, 8, LEVEL + 4.0))
        wt.add_water(view.renderer, wt.plane(middle, normal), (-6, 6, -3, 3))
        look_at(view, (0, -9, LEVEL + 5), (0, 5, LEVEL - 3), 35)
        shown = view.picture().reshape(-1, 3)
        start, ray = ray_caster.eye_rays(view.renderer.GetActiveCamera(), SIZE, 1)
        with np.errstate(all="ignore"):
            way = (LEVEL - start[:, 2]) / ray[:, 2]
            place = start + way[:, None] * ray
            up = ray * (1, 1, -1)
            met = ((middle - place) @ normal) / (up @ normal)
            hit = place + met[:, None] * up
        away = up - 2 * (up @ normal)[:, None] * normal
        apart = hit - middle
        # of a sheet 12 by 6 in whatever axes: what is certainly on it
        is_met = (way > 0) & (met > 0) & (up @ normal < 0) & (np.linalg.norm(apart, axis=1) < 2.5) & (away[:, 2] > -0.9)
        # the sheet itself does not stand before the water
        straight = ((middle - start) @ normal) / (ray @ normal)
        is_met &= ~((straight > 0) & (straight < way))
        number = chance.choice(np.flatnonzero(is_met), RAYS, replace=False)
        check_colours(f"water in water, {kind}, {seed}", shown[number],
                      sky_scenes.truth(view, kind, seed, hit[number], away[number]))


def plain_map(colour):
    return sky_scenes.texture_of(np.full((8, 16, 3), colour, np.uint8))


def sphere_box(colour):
    box = vtkSkybox()
    box.SetTexture(plain_map(colour))
    box.SetProjectionToSphere()
    return box


WAVE = ((0.5, 9.0, 30.0, 10.0),)


def mean_shown(view):
    return view.picture()[:40].reshape(-1, 3).mean(axis=0)


def check_is(name, view, colour):
    wt.check_at_most(f"{name}: difference of 255", round(float(np.abs(mean_shown(view) - colour).max()), 2), 1.0)


def test_the_sky_is_the_waters_own_picture_then_a_skybox_then_the_background():
    """What the user gives the water comes first, then what a skybox shows, then the background; a texture that lights
    the scene alone is not seen."""
    view, water, _ = wavy_scene("colour", 3, WAVE, 1)
    view.renderer.SetEnvironmentTexture(plain_map((255, 0, 0)))
    check_is("a background", view, np.array((0.3, 0.5, 0.6)) * 255)
    box = sphere_box((10, 200, 30))
    view.renderer.AddActor(box)
    check_is("a skybox", view, (10, 200, 30))
    water.GetWaterProperty().SetEnvironmentTexture(plain_map((240, 20, 220)))
    check_is("the water's own picture", view, (240, 20, 220))
    water.GetWaterProperty().SetEnvironmentTexture(None)
    check_is("a skybox again", view, (10, 200, 30))


def test_changes_of_the_sky_are_seen():
    """A skybox that comes, changes its texture, is another one, goes out of sight or leaves, and a background."""
    view, water, _ = wavy_scene("colour", 3, WAVE, 1)
    background = np.array((0.3, 0.5, 0.6)) * 255
    box = sphere_box((10, 200, 30))
    view.renderer.AddActor(box)
    check_is("it comes", view, (10, 200, 30))
    image = box.GetTexture().GetInput()
    image.DeepCopy(sky_scenes.image_of(np.full((8, 16, 3), (90, 20, 30), np.uint8)))
    image.Modified()
    check_is("its texture changes", view, (90, 20, 30))
    box.SetTexture(plain_map((50, 60, 170)))
    check_is("it has another texture", view, (50, 60, 170))
    box.VisibilityOff()
    check_is("it is not visible", view, background)
    box.VisibilityOn()
    check_is("it is visible", view, (50, 60, 170))
    box.SetGammaCorrect(True)
    check_is("it is gamma corrected", view, 255 * (np.array((50, 60, 170)) / 255) ** (1 / 2.2))
    other = sphere_box((5, 15, 25))
    view.renderer.AddActor(other)
    check_is("another one is over it", view, (5, 15, 25))
    view.renderer.RemoveActor(other)
    view.renderer.RemoveActor(box)
    check_is("it leaves", view, background)
    view.renderer.SetBackgroundTexture(plain_map((70, 80, 90)))
    view.renderer.TexturedBackgroundOn()
    check_is("the background is a picture", view, (70, 80, 90))
    view.renderer.TexturedBackgroundOff()
    view.renderer.SetBackground(0, 1, 0)
    check_is("the background has another colour", view, (0, 255, 0))


def test_a_still_sky_costs_nothing():
    """With nothing changed the mirrored view is used again, under every kind of sky; a change of it is drawn once."""
    for kind in KINDS:
        view, water, box = wavy_scene(kind, 3, WAVE, 1)
        reflection = water.GetReflectionPass()
        view.picture()
        renders = reflection.GetNumberOfReflectionRenders()
        for time in (1.0, 2.0):
            water.SetTime(time)
            view.picture()
        wt.check_equal(f"{kind}: mirrored views more", reflection.GetNumberOfReflectionRenders() - renders, 0)
        if box:
            box.Modified()
            view.picture()
            view.picture()
            wt.check_equal(f"{kind}: mirrored views after a change", reflection.GetNumberOfReflectionRenders() - renders, 1)


def test_a_skybox_without_data_is_said_once():
    """A texture without an input, an empty one, and a picture where a cube map is wanted: one error, and the
    background in its place."""
    empty = vtkTexture()
    empty.SetInputData(vtkImageData())
    for name, texture, projection in (("no input", vtkTexture(), "Sphere"),
                                      ("no pixels", empty, "Sphere"), ("no cube map", plain_map((9, 9, 9)), "Cube")):
        view, water, _ = wavy_scene("colour", 3, WAVE, 1)
        box = vtkSkybox()
        box.SetTexture(texture)
        getattr(box, f"SetProjectionTo{projection}")()
        view.renderer.AddActor(box)
        errors = wt.errors_of(water)
        with wt.unheard():  # VTK speaks of it, too
            for _ in range(3):
                view.picture()
        wt.check_equal(f"{name}: errors", len(errors), 1)
        for word in ("vtkSkybox", "texture", "at least one pixel", "background"):
            wt.check_equal(f"{name}: the error says '{word}'", word in "".join(errors), True)
        view.renderer.RemoveActor(box)
        check_is(f"{name}, it has gone", view, np.array((0.3, 0.5, 0.6)) * 255)
        wt.check_equal(f"{name}: errors in all", len(errors), 1)


def test_the_picture_has_no_seam_and_no_poles():
    """Rough water under a picture with mip levels shows no line where the picture's sides meet, and nothing of the
    ground at the zenith."""
    texels = np.full((64, 128, 3), (40, 90, 200), np.uint8)
    texels[:16] = (255, 0, 0)  # the ground, which no slope reflects
    view, water, _ = wavy_scene("colour", 3, (), 1)
    texture = sky_scenes.texture_of(texels)
    texture.MipmapOn()
    water.GetWaterProperty().SetEnvironmentTexture(texture)
    water.GetWaterProperty().SetSlopeVariance(0.02, 0.02, 0.0)
    view.renderer.SetEnvironmentUp(0, 0, 1)
    for name, right in (("its sides are before the eye", (0, -1, 0)), ("behind", (0, 1, 0))):
        view.renderer.SetEnvironmentRight(*right)
        shown = view.picture().reshape(-1, 3)
        start, ray = ray_caster.eye_rays(view.renderer.GetActiveCamera(), SIZE, 1)
        steep = ray[:, 2] < -0.8  # its slopes reflect sky and no ground
        wt.check_at_least(f"{name}: pixels", int(steep.sum()), 200)
        wt.check_at_most(f"{name}: difference of 255", int(np.abs(shown[steep] - (40, 90, 200)).max()), 1)


def test_anisotropic_filters_of_the_users_texture_show_nothing():
    """Facets of neighbours look in directions that differ by chance, which a filter that asks for the change from pixel to
    pixel shows as dashes; the user's texture keeps its filter."""
    pictures = []
    for most in (1.0, 16.0):
        view, water, _ = wavy_scene("colour", 3, (), 1)
        texture = sky_scenes.texture_of(sky_scenes.on_sphere())
        texture.MipmapOn()
        texture.SetMaximumAnisotropicFiltering(most)
        water.GetWaterProperty().SetPreset("ocean wind 10")
        water.GetWaterProperty().SetEnvironmentTexture(texture)  # VTK itself is slow with that filter
        look_at(view, (0, -10, LEVEL + 6), (0, 30, LEVEL - 8), 60)
        pictures.append(view.picture())
        wt.check_equal(f"{most}: the texture has", texture.GetMaximumAnisotropicFiltering(), most)
    wt.check_at_most("difference of 255", wt.difference(*pictures), 1)


@pytest.mark.parametrize("has_mip_levels", (False, True))
def test_the_users_texture_keeps_its_filter(has_mip_levels):
    """VTK filters anisotropically with mip levels only. Mesa takes a minute for a floor whose horizon it filters so."""
    found = []
    for has_water in (True, False):
        view = wt.View((40, 30))  # a filter is set, however few pixels it fills
        texture = sky_scenes.give_sky(view.renderer, "floor", 4).GetTexture()
        texture.SetMipmap(has_mip_levels)
        if has_water:
            water = wt.add_water(view.renderer, wt.plane((0, 0, LEVEL), (0, 0, 1)), (-100, 100, -100, 100))
            water.GetWaterProperty().AddWave(*WAVE[0])
        look_at(view, (0, -9, LEVEL + 5), (0, 5, LEVEL - 3), 35)
        view.picture()
        found.append(texture.GetTextureObject().GetMaximumAnisotropicFiltering())
    wt.check_at_most("anisotropy, from that without water", abs(found[0] - found[1]), 0)


def plain_texture(color):
    image = vtkImageData()
    image.SetDimensions(2, 2, 1)
    image.AllocateScalars(3, 3)  # unsigned char
    for component in range(3):
        for i in range(4):
            image.GetPointData().GetScalars().SetComponent(i, component, color[component])
    texture = vtkTexture()
    texture.SetInputDataObject(image)
    return texture


def test_a_kept_background_is_reflected_while_the_renderers_is_blanked():
    """As engines do that composite pictures of ranks: the water shows what was kept, and follows its changes."""
    view = wt.View(SIZE, background=(0.8, 0.3, 0.1))
    water = wt.add_water(view.renderer, wt.plane((0, 0, LEVEL), (0, 0, 1)), (-300, 300, -300, 300))
    reflection = water.GetReflectionPass()
    look_at(view, (0, -6, LEVEL + 2), (0, 0, LEVEL), 45)
    view.renderer.GradientBackgroundOn()
    view.renderer.SetBackground2(0.1, 0.2, 0.9)
    mask = wt.water_mask(view, water)
    seen = view.picture()[mask].astype(float)
    reflection.KeepBackground(view.renderer)
    view.renderer.SetBackground(0, 0, 0)
    view.renderer.GradientBackgroundOff()
    wt.check_at_most("kept, of 255", float(np.abs(view.picture()[mask] - seen).max()), 0)
    renders = reflection.GetNumberOfReflectionRenders()
    view.picture()
    wt.check_equal("mirrored views of a still frame", reflection.GetNumberOfReflectionRenders() - renders, 0)
    reflection.KeepBackground(view.renderer)
    wt.check_at_most("kept anew: black, of 255", float(view.picture()[mask].max()), 0)
    pictures = []
    for color in ((0, 0, 255), (255, 255, 0)):
        view.renderer.SetBackgroundTexture(plain_texture(color))
        view.renderer.TexturedBackgroundOn()
        reflection.KeepBackground(view.renderer)
        view.renderer.TexturedBackgroundOff()
        view.renderer.SetBackgroundTexture(None)
        pictures.append(view.picture()[mask].astype(float))
    wt.check_at_least("a kept blue picture, of 255: blue", float(pictures[0][:, 2].min()), 150)
    wt.check_at_least("a yellow one after it: red", float(pictures[1][:, 0].min()), 150)
    reflection.KeepBackground(None)
    view.renderer.SetBackground(0.8, 0.3, 0.1)
    shown = view.picture()[mask].astype(float)
    wt.check_at_least("its own again, of 255", float(shown[:, 0].min()), 150)

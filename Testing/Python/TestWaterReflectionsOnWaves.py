# SPDX-License-Identifier: BSD-3-Clause
"""Reflections on waves are those of a ray caster, touch the things that they are of, and are the same on planes that
are turned, seen from below or share their reflection texture with others."""

import functools

import numpy as np
import pytest
import ray_caster
import water_test as wt
import wave_scenes
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkSkybox, vtkTexture
from vtkwater import vtkWaterProperty, vtkWaterReflectionPass
from wave_scenes import POSTS_VIEWS, POSTS_WAVES, SKY, posts, rmse

SIZE = (280, 210)  # half of the pixels that the accuracy reports have


def post_scene(view, **options):
    return wave_scenes.post_scene(view, size=SIZE, **options)


@functools.lru_cache(None)  # several tests need the same, and each takes seconds
def cast(view, parallel, samples, size):
    made, _ = wave_scenes.post_scene(view, parallel=parallel, size=size)
    return ray_caster.picture(made.renderer.GetActiveCamera(), size, posts(), SKY, POSTS_WAVES, 0.0, samples)


def truth_of(view, made, water, parallel=False, samples=4):
    """The ray caster's picture, and the pixels that are water and nothing else there and here."""
    truth, mask = cast(view, parallel, samples, tuple(made.window.GetSize()))
    return truth, mask & wt.water_mask(made, water)


def errors_of_view(view):
    """RMSE of the ray traced lookup and of the best constant offset of a search; prints those of all lookups."""
    folder = wt.output_folder()
    made, water = post_scene(view)
    truth, mask = truth_of(view, made, water)
    once, _ = truth_of(view, made, water, samples=1)
    look = water.GetWaterProperty()
    errors = []
    for quality in ("Fast", "High", "Default"):
        getattr(look, f"SetRayTraceQualityTo{quality}")()
        errors.append(f"{quality.lower()} {rmse(made.picture(), truth, mask):.2f}")
    traced = rmse(made.picture(), truth, mask)
    wt.save(made.picture(), folder / f"TestWaterReflectionsOnWaves-{view}.png")
    wt.save(np.clip(truth, 0, 255), folder / f"TestWaterReflectionsOnWaves-{view}-truth.png")
    for lookup, scales in (("ViewScaledOffset", np.linspace(0, 10, 11)), ("FixedOffset", np.linspace(0, 1, 11))):
        getattr(look, f"SetLookupTo{lookup}")()
        found = []
        for scale in scales:
            look.SetOffsetScale(scale)
            found.append(rmse(made.picture(), truth, mask))
        best = int(np.argmin(found))
        errors.append(f"{lookup} {found[best]:.2f} at {scales[best]:.2f} (0: {found[0]:.2f})")
    print(f"{view}: RMSE of 255 over {mask.mean():.0%} of the picture: ray traced {', '.join(errors)}; "
          f"a perfect tracer at one sample a pixel {rmse(once, truth, mask):.2f}", flush=True)
    return traced, min(found)


def test_ray_traced_lookup_is_far_closer_than_the_best_offset():
    """The ray traced lookup is closer to the ray caster than the best constant offset of each view, by far."""
    traced, offset = np.transpose([errors_of_view(view) for view in POSTS_VIEWS])
    wt.check_at_least("RMSE of the best fixed offset of each view / ray traced, all views together",
                      np.linalg.norm(offset) / np.linalg.norm(traced), 3.0)


def test_more_rays_where_neighbours_differ_are_closer(monkeypatch):
    """Four rays at edges are closer to the ray caster than one, by an eighth of the error at least; eight not farther.
    Where no neighbour differs next to nothing changes: what turns evenly over a pixel is left to the rays."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "1")  # a GPU has one ray
    errors = {}
    for view in POSTS_VIEWS:
        made, water = post_scene(view)
        truth, mask = truth_of(view, made, water)
        look = water.GetWaterProperty()
        pictures = {}
        for rays in (1, 4, 8):
            look.SetRayTraceRays(rays)
            pictures[rays] = made.picture().astype(float)
            errors.setdefault(rays, []).append(rmse(pictures[rays], truth, mask))
        one = pictures[1]
        step = np.maximum(np.abs(np.diff(one, axis=0, append=one[-1:])), np.abs(np.diff(one, axis=0, prepend=one[:1])))
        across = np.maximum(np.abs(np.diff(one, axis=1, append=one[:, -1:])),
                            np.abs(np.diff(one, axis=1, prepend=one[:, :1])))
        is_even = (np.maximum(step, across).max(axis=2) < 15) & mask  # of 255: a sixteenth of it is an edge
        for axis in (0, 1):  # one for all of two by two pixels, of which some may lie behind a thing
            is_even = is_even & np.roll(is_even, 1, axis) & np.roll(is_even, -1, axis)
        changed = (np.abs(pictures[4] - one).max(axis=2) > 15)[is_even]
        wt.check_at_most(f"{view}: % of the pixels without an edge that more rays change by more than 15 of 255",
                         100 * float(changed.mean()), 0.5)
    print(errors)
    one, four, eight = (np.linalg.norm(errors[rays]) for rays in (1, 4, 8))
    wt.check_at_most("RMSE of four rays at edges / of one ray everywhere", four / one, 0.875)
    wt.check_at_most("RMSE of eight rays at edges / of four", eight / four, 1.0)


def test_ray_traced_lookup_is_closer_in_parallel_projection():
    """In parallel projection the ray traced lookup is closer to the ray caster than the lookup of calm water."""
    made, water = post_scene("middle", parallel=True)
    truth, mask = truth_of("middle", made, water, parallel=True)
    error = rmse(made.picture(), truth, mask)
    water.GetWaterProperty().SetLookupToFixedOffset()
    water.GetWaterProperty().SetOffsetScale(0)
    wt.check_at_least(f"parallel: RMSE of the calm lookup / ray traced ({error:.2f})",
                      rmse(made.picture(), truth, mask) / error, 2.5)


# height of the camera, normal of the plane, whether the projection is parallel
CALM_VIEWS = {
    "above": (4, (0, 0, 1), False),
    "below": (-4, (0, 0, 1), False),
    "tilted": (4, (0.1, 0.05, 1), False),
    "parallel": (4, (0, 0, 1), True),
}


@pytest.mark.parametrize("name", CALM_VIEWS)
def test_waves_of_no_height_are_calm_water(name):
    """Waves of no height, and waves that are removed again, leave water that looks calm, seen with one ray a pixel: of
    several the edges are smoother."""
    camera_z, normal, parallel = CALM_VIEWS[name]
    made, water = post_scene("middle", waves=(), parallel=parallel)
    water.SetPlane(wt.plane((0, 0, 0.1), normal))
    camera = made.renderer.GetActiveCamera()
    camera.SetPosition(2, -13, camera_z)
    calm = made.picture()
    water.GetWaterProperty().AddWave(0.0, 1.0)
    water.GetWaterProperty().SetRayTraceRays(1)
    flat = made.picture()
    wt.check_at_most(f"no waves, {name}: % of pixels off by more than 1/255 from calm water",
                     100 * float((np.abs(flat - calm).max(axis=2) > 1).mean()), 0.02)
    water.GetWaterProperty().RemoveAllWaves()
    wt.check_equal(f"waves removed, {name}: error", wt.difference(made.picture(), calm), 0)


def count_gaps(lookup, headings):
    """Columns in which a thing ends on the water, and those of them whose next pixel is not the
    thing's reflection. A column counts when the thing is there beside it, too. One ray a pixel: of
    several some pass beside the thing, and the pixel is a mixture."""
    made = wt.View((200, 150), SKY)
    wt.add_actor(made.renderer, wt.box((0.3, 0.2, 1), (0.5, 0.9, 3)), (1, 0, 0), lit=False)
    wt.add_actor(made.renderer, wt.pyramid((-1.2, 0.4, 0.5), 2, 24, 0.6), (1, 0, 0), lit=False)
    water = wt.add_water(made.renderer, None, (-60, 60, -60, 60))
    for wave in POSTS_WAVES:
        water.GetWaterProperty().AddWave(*wave)
    getattr(water.GetWaterProperty(), f"SetLookupTo{lookup}")()
    water.GetWaterProperty().SetRayTraceRays(1)
    camera = made.renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0.3)
    camera.SetViewUp(0, 0, 1)
    camera.SetClippingRange(0.5, 150)
    look = water.GetWaterProperty()
    columns = gaps = 0
    for heading in headings:
        angle = np.radians(heading)
        camera.SetPosition(9 * np.sin(angle), -9 * np.cos(angle), 2.2)
        picture = made.picture()
        is_red = (picture[:, :, 0] > 200) & (picture[:, :, 1] < 60)
        look.SetReflectance(0)
        look.SetDeepColor(0, 1, 0)  # nothing else is green alone
        is_water = np.abs(made.picture() - (0, 255, 0)).max(axis=2) < 120
        look.SetReflectance(1)
        is_thing = is_red & ~is_water
        for x in range(2, 198):
            rows = np.nonzero(is_thing[:, x])[0]
            if len(rows) < 3 or not is_water[rows[0] - 1, x]:
                continue
            y = rows[0]
            if is_thing[y:y + 2, x - 2].any() and is_thing[y:y + 2, x + 2].any():
                columns += 1
                gaps += not is_red[y - 1, x]
    return columns, gaps


def test_things_in_the_water_touch_their_reflections():
    """From every heading, the reflection of a thing that stands in the water begins where the thing ends."""
    headings = range(0, 360, 3)
    columns, gaps = count_gaps("RayTraced", headings)
    wt.check_at_least("contact: columns in which a thing ends on the water, of each heading", columns / len(headings), 27)
    wt.check_equal("contact: columns with a gap under the thing", gaps, 0)
    columns, gaps = count_gaps("FixedOffset", range(0, 360, 36))
    print(f"contact: with a fixed offset {gaps} of {columns} columns have a gap")


def test_confidence_says_why_and_where():
    """Each pixel of the water has a reason: sky where the sky is seen, a hit where a thing is."""
    made, water = post_scene("middle")
    _, mask = truth_of("middle", made, water)
    color = made.picture()
    water.GetWaterProperty().SetOutputToConfidence()
    reasons = made.picture()
    shares = [float((reasons[:, :, 0][mask] == reason).mean()) for reason in range(6)]
    print("confidence: shares of none, hit, sky, off the texture, hidden, downward:", np.round(shares, 4).tolist())
    wt.check_equal("confidence: all pixels have a reason", round(sum(shares[1:]), 12), 1.0)
    is_sky = mask & (np.abs(color - 255 * np.asarray(SKY)).max(axis=2) < 1)
    seen_as_sky = np.isin(reasons[:, :, 0], (vtkWaterProperty.SKY, vtkWaterProperty.OFF_MAP, vtkWaterProperty.HIDDEN))
    wt.check_at_least("confidence: sky-coloured pixels that are sky, off the texture or hidden",
                      float(seen_as_sky[is_sky].mean()), 0.98)
    is_thing = mask & (np.abs(color - 255 * np.asarray(SKY)).max(axis=2) > 60)
    wt.check_at_least("confidence: pixels that show things and are hits",
                      float((reasons[:, :, 0] == vtkWaterProperty.HIT)[is_thing].mean()), 0.75)


def test_scene_turned_as_a_whole_looks_the_same():
    """On a tilted plane whose axes begin elsewhere, the same scene, turned as a whole, gives the same picture."""
    made, water = post_scene("middle")
    level = made.picture()
    turn = vtkTransform()
    turn.Translate(3, -2, 5)
    turn.RotateX(25)
    turn.RotateY(-10)
    rows = np.array([[turn.GetMatrix().GetElement(i, j) for j in range(4)] for i in range(4)])
    tilted = wt.View(SIZE, SKY)
    for actor in made.renderer.GetActors():
        if not actor.IsA("vtkWaterActor"):
            wt.add_actor(tilted.renderer, wt.transformed(actor.GetMapper().GetInput(), turn.GetMatrix()),
                         actor.GetProperty().GetColor(), lit=False)
    other = wt.add_water(tilted.renderer, wt.plane(rows[:3, 3], rows[:3, 2]))
    # the plane's first axis is the world's x projected onto it: turn the waves from the old axis to that
    first = np.array((1.0, 0, 0)) - rows[0, 2] * rows[:3, 2]
    first /= np.linalg.norm(first)
    angle = np.degrees(np.arctan2(rows[:3, 1] @ first, rows[:3, 0] @ first))
    other.SetSheetBounds(-90, 90, -90, 90)
    for amplitude, wavelength, direction, phase in POSTS_WAVES:
        other.GetWaterProperty().AddWave(amplitude, wavelength, direction - angle, phase)
    camera = tilted.renderer.GetActiveCamera()
    camera.DeepCopy(made.renderer.GetActiveCamera())
    for name in ("Position", "FocalPoint"):
        getattr(camera, f"Set{name}")(rows[:3, :3] @ getattr(camera, f"Get{name}")() + rows[:3, 3])
    camera.SetViewUp(rows[:3, :3] @ camera.GetViewUp())
    both = wt.water_mask(made, water) & wt.water_mask(tilted, other)
    wt.check_at_most("tilted, elsewhere: % of the water off by more than 4 of 255 from the level scene",
                     100 * float((np.abs(tilted.picture() - level).max(axis=2) > 4)[both].mean()), 0.5)


def test_waves_seen_from_below_reflect_the_things_under_water():
    """The scene with its water turned over, and the waves with it, gives the same picture."""
    made, water = post_scene("middle")
    below = wt.View(SIZE, SKY)
    for actor in made.renderer.GetActors():
        if not actor.IsA("vtkWaterActor"):
            wt.add_actor(below.renderer, actor.GetMapper().GetInput(), actor.GetProperty().GetColor(), lit=False)
    other = wt.add_water(below.renderer, wt.plane((0, 0, 0), (0, 0, -1)), (-60, 60, -60, 60))
    for amplitude, wavelength, direction, phase in POSTS_WAVES:  # its second axis is -y; up is down
        other.GetWaterProperty().AddWave(amplitude, wavelength, -direction, phase + 180)
    below.renderer.GetActiveCamera().DeepCopy(made.renderer.GetActiveCamera())
    both = wt.water_mask(made, water) & wt.water_mask(below, other)
    wt.check_at_most("from below: % of the water off by more than 4 of 255 from the same waves from above",
                     100 * float((np.abs(below.picture() - made.picture()).max(axis=2) > 4)[both].mean()), 0.5)


def test_guard_band_keeps_rays_on_the_map():
    """Of the rays that waves turn out of the picture, far fewer leave the reflection texture with a guard band."""
    made, water = post_scene("low")
    water.GetWaterProperty().SetOutputToConfidence()
    water.GetReflectionPass().SetGuardBand(1.0)
    without = int((made.picture()[:, :, 0] == vtkWaterProperty.OFF_MAP).sum())
    water.GetReflectionPass().SetGuardBand(0.0)
    automatic = int((made.picture()[:, :, 0] == vtkWaterProperty.OFF_MAP).sum())
    wt.check_at_least(f"guard band: pixels off the texture without / with it ({automatic})",
                      without / max(automatic, 1), 3)


def test_calm_water_beside_waves_is_as_calm_as_alone():
    """Calm water that shares its reflection texture with wavy water in the same plane looks as it does alone."""
    made, wavy = post_scene("middle")
    wavy.SetSheetBounds(-60, 0, -60, 60)
    calm = wt.add_water(made.renderer, None, (0, 60, -60, 60))
    alone = made.picture()
    is_calm = wt.water_mask(made, calm)
    shared = vtkWaterReflectionPass()
    made.renderer.SetPass(shared)
    together = made.picture()
    wt.check_equal("one reflection texture: both waters are in the pass's charge",
                   calm.GetReflectionPass() == shared, True)
    wt.check_at_most("one reflection texture: % of the calm water off by more than 1 of 255",
                     100 * float((np.abs(together - alone).max(axis=2) > 1)[is_calm].mean()), 0.1)


def test_rays_off_the_map_meet_the_skybox():
    """Under a skybox, what rays off the reflection texture meet is not the renderer's background."""
    made, water = post_scene("middle")
    image = vtkImageData()
    image.SetDimensions(2, 2, 1)
    image.AllocateScalars(3, 3)  # unsigned char
    image.GetPointData().GetScalars().Fill(255)
    texture = vtkTexture()
    texture.CubeMapOn()
    for face in range(6):
        texture.SetInputDataObject(face, image)
    sky = vtkSkybox()
    sky.SetTexture(texture)
    made.renderer.AddActor(sky)
    made.renderer.SetBackground(0, 0, 0)
    picture = made.picture()
    is_sky = wt.water_mask(made, water) & (picture.max(axis=2) == picture.min(axis=2))
    wt.check_at_most("skybox: water that shows the background under it, pixels", int((picture[is_sky] < 128).sum()), 0)


def beach_color(place):
    return np.stack([np.full(len(place), 40), 120 + 2 * (place[:, 1] - 10), np.full(len(place), 120)], axis=1).astype(np.uint8)


def beach(rise):
    """A plane that rises from the water at y = 10, and its colour, which changes along it; wider than what is seen."""
    source = vtkPlaneSource()
    source.SetOrigin(-150, 5, -5 * rise)
    source.SetPoint1(150, 5, -5 * rise)
    source.SetPoint2(-150, 60, 50 * rise)
    source.SetYResolution(55)
    source.Update()
    data = source.GetOutput()
    data.GetPointData().SetScalars(numpy_to_vtk(beach_color(vtk_to_numpy(data.GetPoints().GetData())), deep=True))
    return data


@pytest.mark.parametrize("is_software", (0, 1))
def test_a_low_beach_is_reflected_where_the_mirrored_eye_sees_it_from_inside(is_software, monkeypatch):
    """Rays that waves turn to a beach pass behind its waterline, as the mirrored eye sees it, before they meet it."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    rise, wave, size = 0.1, (0.4, 20.0, 60.0, 0.0), (200, 150)
    made = wt.View(size, (1, 1, 1))
    wt.add_actor(made.renderer, beach(rise), (1, 1, 1), lit=False).GetMapper().ScalarVisibilityOn()
    water = wt.add_water(made.renderer, None, (-150, 150, -100, 60), reflectance=1.0)
    water.GetWaterProperty().AddWave(*wave)
    camera = made.renderer.GetActiveCamera()
    camera.SetPosition(0, -25, 10)
    camera.SetFocalPoint(0, 10, 0)
    camera.SetViewUp(0, 0, 1)
    camera.SetClippingRange(0.1, 500)
    shown, mask = made.picture().astype(float), wt.water_mask(made, water)
    place, away = wave_scenes.reflected_rays(camera, size, (wave,))
    over, falls = place[:, 2] - rise * (place[:, 1] - 10), away[:, 2] - rise * away[:, 1]
    met = place + np.where(falls < 0, -over / np.where(falls < 0, falls, -1), 0)[:, None] * away
    is_met = (falls < 0) & (over > 0) & (met[:, 1] < 60) & (np.abs(met[:, 0]) < 150)
    right = np.where(is_met[:, None], beach_color(met), 255).reshape(*mask.shape, 3)
    wt.check_at_least("water that reflects the beach, %", 100 * is_met.reshape(mask.shape)[mask].mean(), 4)
    off = (np.abs(shown - right).max(axis=2) > 40)[mask]
    wt.check_at_most("water that shows the sky for the beach, or the beach for the sky, %", 100 * off.mean(), 2.5)


@pytest.mark.parametrize("is_software", (0, 1))
def test_a_wall_is_reflected_down_to_its_waterline(is_software, monkeypatch):
    """Next to a wall of one colour the water shows nothing else: the wall's foot is at the end of what the mirrored view has."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    made = wt.View((200, 150), (1, 1, 1))
    wall = vtkPlaneSource()
    wall.SetOrigin(-60, 10, -5)
    wall.SetPoint1(60, 14, -5)  # not along the rows of pixels
    wall.SetPoint2(-60, 10, 8)
    wall.Update()
    wt.add_actor(made.renderer, wall.GetOutput(), (160 / 255, 40 / 255, 40 / 255), lit=False)
    water = wt.add_water(made.renderer, None, (-60, 60, -60, 20), reflectance=1.0)
    water.GetWaterProperty().AddWave(0.01, 3.0, 50.0, 0.0)
    water.GetWaterProperty().SetRayTraceQualityToFast()  # one ray: others of a pixel may start behind the wall
    camera = made.renderer.GetActiveCamera()
    camera.SetPosition(0, -12, 5)
    camera.SetFocalPoint(0, 9, 0)
    camera.SetViewUp(0, 0, 1)
    camera.SetClippingRange(0.1, 500)
    water.GetReflectionPass().SetMultiSamples(0)
    shown, mask = made.picture().astype(float), wt.water_mask(made, water)
    rows = np.arange(mask.shape[0])[:, None]
    foot = np.where(mask, rows, -1).max(axis=0)  # the first row is the lowest
    off = np.abs(shown[foot, np.arange(mask.shape[1])] - (160, 40, 40)).max(axis=1)
    wt.check_at_most("columns in which the water at the wall's foot is not the wall's colour, %", 100 * (off > 2).mean(), 0)

@pytest.mark.parametrize("side", [1, -1])
def test_what_lies_at_the_top_is_reflected(side):
    """A flat ceiling is the highest thing, or a flat bed the lowest for an eye under water: rays end there, and meet it.

    With a ball beyond it, which the mirrored view shows and no ray of the pixels meets, the picture is the same.
    """
    pictures = []
    for has_ball in (False, True):
        view = wt.View((240, 180))
        view.renderer.SetBackground(0.2, 0.4, 0.9)
        flat = vtkPlaneSource()
        flat.SetOrigin(-30, -30, 3 * side)
        flat.SetPoint1(30, -30, 3 * side)
        flat.SetPoint2(-30, 30, 3 * side)
        flat.Update()
        wt.add_actor(view.renderer, flat.GetOutput(), (0.9, 0.7, 0.4), lit=False)
        if has_ball:
            wt.add_actor(view.renderer, wt.sphere((0, 29, 5 * side), 0.1), (1, 0, 0), lit=False)
        water = wt.add_water(view.renderer, sheet=(-30, 30, -30, 30))
        water.GetWaterProperty().AddWave(0.05, 2, 20)
        wt.place_camera(view.renderer, (0, -6, 0.4 * side), (0, 4, 0.3 * side), (0.05, 80))
        pictures.append(view.picture())
    share = (np.abs(pictures[0].astype(int) - pictures[1]).max(axis=2) > 40).mean()
    wt.check_at_most(f"side {side}: share of pixels that a ball beyond the flat thing changes", share, 0.005)


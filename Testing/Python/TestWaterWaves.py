# SPDX-License-Identifier: BSD-3-Clause
"""Reflections on waves against a ray caster; the waves themselves; time, queries and bad input."""

import numpy as np
import ray_caster
import water_test as wt
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingCore import vtkSkybox, vtkTexture
from vtkwater import vtkWaterActor, vtkWaterProperty, vtkWaterReflectionPass
from wave_scenes import POSTS_SIZE, POSTS_VIEWS, POSTS_WAVES, SKY, post_scene, posts, rmse


def truth_of(made, water, samples=4):
    """The ray caster's picture, and the pixels that are water and nothing else there and here."""
    camera = made.renderer.GetActiveCamera()
    truth, mask = ray_caster.picture(camera, POSTS_SIZE, posts(), SKY, POSTS_WAVES, 0.0, samples)
    return truth, mask & wt.water_mask(made, water)


# Colour against the ray caster, and against the best constant offset that a search finds.
folder = wt.output_folder()
traced, offset = [], []
for view in POSTS_VIEWS:
    made, water = post_scene(view)
    truth, mask = truth_of(made, water)
    once, _ = truth_of(made, water, samples=1)
    look = water.GetWaterProperty()
    errors = []
    for quality in ("Fast", "High", "Default"):
        getattr(look, f"SetRayTraceQualityTo{quality}")()
        errors.append(f"{quality.lower()} {rmse(made.picture(), truth, mask):.2f}")
    traced.append(rmse(made.picture(), truth, mask))
    wt.save(made.picture(), folder / f"TestWaterWaves-{view}.png")
    wt.save(np.clip(truth, 0, 255), folder / f"TestWaterWaves-{view}-truth.png")
    for lookup, scales in (("ViewScaledOffset", np.linspace(0, 10, 21)), ("FixedOffset", np.linspace(0, 1, 21))):
        getattr(look, f"SetLookupTo{lookup}")()
        found = []
        for scale in scales:
            look.SetOffsetScale(scale)
            found.append(rmse(made.picture(), truth, mask))
        best = int(np.argmin(found))
        errors.append(f"{lookup} {found[best]:.2f} at {scales[best]:.2f} (0: {found[0]:.2f})")
    offset.append(min(found))
    print(f"{view}: RMSE of 255 over {mask.mean():.0%} of the picture: ray traced {', '.join(errors)}; "
          f"a perfect tracer at one sample a pixel {rmse(once, truth, mask):.2f}", flush=True)
wt.check_at_least("RMSE of the best fixed offset of each view / ray traced, all views together",
                  np.linalg.norm(offset) / np.linalg.norm(traced), 3.0)

# Parallel projection.
made, water = post_scene("middle", parallel=True)
truth, mask = truth_of(made, water)
error = rmse(made.picture(), truth, mask)
water.GetWaterProperty().SetLookupToFixedOffset()
water.GetWaterProperty().SetOffsetScale(0)
wt.check_at_least(f"parallel: RMSE of the calm lookup / ray traced ({error:.2f})",
                  rmse(made.picture(), truth, mask) / error, 2.5)

# Waves of no height are calm water: from above, from below, tilted, in parallel projection.
for name, camera_z, normal, parallel in (("above", 4, (0, 0, 1), False), ("below", -4, (0, 0, 1), False),
                                         ("tilted", 4, (0.1, 0.05, 1), False), ("parallel", 4, (0, 0, 1), True)):
    made, water = post_scene("middle", waves=(), parallel=parallel)
    water.SetPlane(wt.plane((0, 0, 0.1), normal))
    camera = made.renderer.GetActiveCamera()
    camera.SetPosition(2, -13, camera_z)
    calm = made.picture()
    water.GetWaterProperty().AddWave(0.0, 1.0)
    flat = made.picture()
    wt.check_at_most(f"no waves, {name}: % of pixels off by more than 1/255 from calm water",
                     100 * float((np.abs(flat - calm).max(axis=2) > 1).mean()), 0.02)
    water.GetWaterProperty().RemoveAllWaves()
    wt.check_equal(f"waves removed, {name}: error", int(np.abs(made.picture() - calm).max()), 0)

# Things that stand in the water touch their reflections, from every heading.
def count_gaps(lookup, headings):
    """Columns in which a thing ends on the water, and those of them whose next pixel is not the
    thing's reflection. A column counts when the thing is there beside it, too."""
    made = wt.View((200, 150), SKY)
    wt.add_actor(made.renderer, wt.box((0.3, 0.2, 1), (0.5, 0.9, 3)), (1, 0, 0), lit=False)
    wt.add_actor(made.renderer, wt.pyramid((-1.2, 0.4, 0.5), 2, 24, 0.6), (1, 0, 0), lit=False)
    water = wt.add_water(made.renderer, None, (-60, 60, -60, 60))
    for wave in POSTS_WAVES:
        water.GetWaterProperty().AddWave(*wave)
    getattr(water.GetWaterProperty(), f"SetLookupTo{lookup}")()
    camera = made.renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0.3)
    camera.SetViewUp(0, 0, 1)
    camera.SetClippingRange(0.5, 150)
    columns = gaps = 0
    for heading in headings:
        angle = np.radians(heading)
        camera.SetPosition(9 * np.sin(angle), -9 * np.cos(angle), 2.2)
        picture = made.picture()
        is_red = (picture[:, :, 0] > 200) & (picture[:, :, 1] < 60)
        is_water = wt.water_mask(made, water)
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


columns, gaps = count_gaps("RayTraced", range(360))
wt.check_at_least("contact: columns in which a thing ends on the water, 360 headings", columns, 10000)
wt.check_equal("contact: columns with a gap under the thing", gaps, 0)
columns, gaps = count_gaps("FixedOffset", range(0, 360, 12))
print(f"contact: with a fixed offset {gaps} of {columns} columns have a gap")

# The confidence channel says why, and where: a calm pixel of the sky, a box, the picture's border.
made, water = post_scene("middle")
_, mask = truth_of(made, water)
color = made.picture()
water.GetWaterProperty().SetOutputToConfidence()
reasons = made.picture()
shares = [float((reasons[:, :, 0][mask] == reason).mean()) for reason in range(6)]
print("confidence: shares of none, hit, sky, off the map, hidden, downward:", np.round(shares, 4).tolist())
wt.check_equal("confidence: all pixels have a reason", round(sum(shares[1:]), 12), 1.0)
is_sky = mask & (np.abs(color - 255 * np.asarray(SKY)).max(axis=2) < 1)
seen_as_sky = np.isin(reasons[:, :, 0], (vtkWaterProperty.SKY, vtkWaterProperty.OFF_MAP, vtkWaterProperty.HIDDEN))
wt.check_at_least("confidence: sky-coloured pixels that are sky, off the map or hidden",
                  float(seen_as_sky[is_sky].mean()), 0.98)
is_thing = mask & (np.abs(color - 255 * np.asarray(SKY)).max(axis=2) > 60)
wt.check_at_least("confidence: pixels that show things and are hits",
                  float((reasons[:, :, 0] == vtkWaterProperty.HIT)[is_thing].mean()), 0.75)

# Time alone makes the picture; phases are as exact at 1e7 s as at 0.
made, water = post_scene("middle")
water.SetTime(1e6)
straight = made.picture()
for time in (0.0, 3.7, 12345.6):
    water.SetTime(time)
    made.picture()
water.SetTime(1e6)
wt.check_equal("time: 1e6 s after other frames, error", int(np.abs(made.picture() - straight).max()), 0)
water.SetTime(1.0)
wt.check_at_least("time: 1 s makes another picture", int(np.abs(made.picture() - straight).max()), 50)
x, y = np.meshgrid(np.linspace(-7, 7, 9), np.linspace(-5, 9, 9))
for time in (0.0, 17.3, 1e4):
    water.SetTime(time)
    height, slope_x, slope_y = ray_caster.heights_and_slopes(POSTS_WAVES, x, y, time)
    found = np.array([water.GetWaveHeight(*place) for place in zip(x.ravel(), y.ravel())])
    wt.check_at_most(f"height at {time:g} s: largest error, m", float(np.abs(found - height.ravel()).max()), 1e-11)
    largest = 0.0
    for place, sx, sy in zip(zip(x.ravel(), y.ravel()), slope_x.ravel(), slope_y.ravel()):
        normal = [0.0, 0.0, 0.0]
        water.GetWaveNormal(*place, normal)
        largest = max(largest, abs(normal[0] / normal[2] + sx), abs(normal[1] / normal[2] + sy))
    wt.check_at_most(f"slope at {time:g} s: largest error", largest, 1e-10)
water.SetTime(1e7)
period = 2 * np.pi / ray_caster.angular_frequency(POSTS_WAVES[0][1])
alone = vtkWaterActor()
alone.GetWaterProperty().AddWave(*POSTS_WAVES[0])
alone.SetTime(0.25 * period)
near = alone.GetWaveHeight(0.3, 0.4)
turns = np.round(1e7 / period)
alone.SetTime((turns + 0.25) * period)
wt.check_at_most("time: the same phase at 1e7 s, error of the height, m",
                 abs(alone.GetWaveHeight(0.3, 0.4) - near), 1e-9)

# Steep waves move their points: the ray caster looks for the point at rest by bisection.
STEEP = (0.08, 2.0, 30.0, 0.0, 0.9)


def steep_slopes(x, y):
    """Of one Gerstner wave: the point at rest is u along the wave with u + Q A cos(k u) = place."""
    amplitude, wavelength, direction, phase, steepness = STEEP
    k = 2 * np.pi / wavelength
    along = np.array((np.cos(np.radians(direction)), np.sin(np.radians(direction))))
    place = x * along[0] + y * along[1]
    low, high = place - amplitude, place + amplitude
    for _ in range(60):
        rest = 0.5 * (low + high)
        is_left = rest + steepness * amplitude * np.cos(k * rest + np.radians(phase)) < place
        low, high = np.where(is_left, rest, low), np.where(is_left, high, rest)
    angle = k * rest + np.radians(phase)
    slope = amplitude * k * np.cos(angle) / (1 - steepness * amplitude * k * np.sin(angle))
    return along[0] * slope, along[1] * slope


made, water = post_scene("high", waves=(STEEP,))
look = water.GetWaterProperty()
look.SetReflectanceModeToFresnel()
is_water = wt.water_mask(made, water).ravel()
start, ray = ray_caster.eye_rays(made.renderer.GetActiveCamera(), POSTS_SIZE, 1)
place = start - (start[:, 2] / ray[:, 2])[:, None] * ray
normal = np.stack([*(-slope for slope in steep_slopes(place[:, 0], place[:, 1])), np.ones(len(ray))], axis=1)
normal /= np.linalg.norm(normal, axis=1, keepdims=True)
expected = ray_caster.fresnel(np.clip(-(ray * normal).sum(axis=1), 0, 1))
look.SetOutputToReflectance()


def reflectance_error():
    shown = made.picture().reshape(-1, 3)
    return float(np.percentile(np.abs((256 * shown[:, 0] + shown[:, 1]) / 65535 - expected)[is_water], 99))


wt.check_at_most("a steep wave: error of the reflectance, 99 % of the pixels", reflectance_error(), 2e-3)
look.RemoveAllWaves()
look.AddWave(*STEEP[:4])
wt.check_at_least("the same wave as a sine: error of the reflectance", reflectance_error(), 1e-2)

# A tilted plane whose axes begin elsewhere: the same scene, turned as a whole, gives the same picture.
made, water = post_scene("middle")
level = made.picture()
turn = vtkTransform()
turn.Translate(3, -2, 5)
turn.RotateX(25)
turn.RotateY(-10)
rows = np.array([[turn.GetMatrix().GetElement(i, j) for j in range(4)] for i in range(4)])
tilted = wt.View(POSTS_SIZE, SKY)
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

# Waves seen from below reflect the things under water: the scene turned over, with waves turned over.
made, water = post_scene("middle")
below = wt.View(POSTS_SIZE, SKY)
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

# Depth slows long waves down: at 1 s the picture is that of deep waves at the time of the same phase.
made, water = post_scene("middle", waves=POSTS_WAVES[:1])
water.GetWaterProperty().SetDepth(0.1)
water.SetTime(1.0)
shallow = made.picture()
water.GetWaterProperty().SetDepth(float("inf"))
deep_same_time = made.picture()
length = POSTS_WAVES[0][1]
water.SetTime(ray_caster.angular_frequency(length, 0.1) / ray_caster.angular_frequency(length))
wt.check_at_most("depth: largest difference from the same phase in deep water",
                 int(np.abs(made.picture() - shallow).max()), 1)
wt.check_at_least("depth: difference from the same time in deep water", int(np.abs(deep_same_time - shallow).max()), 50)

# Rays that waves turn out of the picture: with a guard band fewer leave the map.
made, water = post_scene("low")
water.GetWaterProperty().SetOutputToConfidence()
water.GetReflectionPass().SetGuardBand(1.0)
without = int((made.picture()[:, :, 0] == vtkWaterProperty.OFF_MAP).sum())
water.GetReflectionPass().SetGuardBand(0.0)
automatic = int((made.picture()[:, :, 0] == vtkWaterProperty.OFF_MAP).sum())
wt.check_at_least(f"guard band: pixels off the map without / with it ({automatic})", without / max(automatic, 1), 3)

# Calm water that shares its map with wavy water in the same plane is as calm as alone.
made, wavy = post_scene("middle")
wavy.SetSheetBounds(-60, 0, -60, 60)
calm = wt.add_water(made.renderer, None, (0, 60, -60, 60))
alone = made.picture()
is_calm = wt.water_mask(made, calm)
shared = vtkWaterReflectionPass()
made.renderer.SetPass(shared)
together = made.picture()
wt.check_equal("one map: both waters are in the pass's charge", calm.GetReflectionPass() == shared, True)
wt.check_at_most("one map: % of the calm water off by more than 1 of 255",
                 100 * float((np.abs(together - alone).max(axis=2) > 1)[is_calm].mean()), 0.1)

# A skybox: what rays off the map meet is not the renderer's background.
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


# Bad input.
def refused(name, do, words):
    thing = do[0]
    errors = wt.errors_of(thing)
    result = do[1](thing)
    wt.check_equal(f"{name}: errors", len(errors), 1)
    for word in words:
        wt.check_equal(f"{name}: the error says '{word}'", word in "".join(errors), True)
    return result


NAN, INFINITY = float("nan"), float("inf")
for wave, words in (((-1.0, 2.0), ("-1", "not negative")), ((0.1, 0.0), ("Wavelength 0", "greater than 0")),
                    ((NAN, 2.0), ("nan", "finite")), ((0.1, 2.0, INFINITY), ("inf", "Direction")),
                    ((0.1, 2.0, 0.0, NAN), ("nan", "Phase")), ((0.1, 2.0, 0.0, 0.0, 1.5), ("1.5", "[0, 1]")),
                    ((1.0, 2.0, 0.0, 0.0, 1.0), ("fold", "exceed 1"))):
    look = vtkWaterProperty()
    wt.check_equal(f"wave {wave}: refused", refused(f"wave {wave}", (look, lambda it: it.AddWave(*wave)), words), -1)
    wt.check_equal(f"wave {wave}: none added", look.GetNumberOfWaves(), 0)
for time in (NAN, INFINITY):
    water = vtkWaterActor()
    refused(f"time {time}", (water, lambda it: it.SetTime(time)), (str(time), "finite"))
    wt.check_equal(f"time {time}: the last good one stays", water.GetTime(), 0.0)
for setter, value, words in (("SetDepth", 0.0, ("greater than 0",)), ("SetDepth", NAN, ("nan",)),
                             ("SetLookup", 4, ("[0, 3]",)), ("SetRayTraceSteps", 0, ("[1, 256]",)),
                             ("SetRayTraceProbes", -1, ("[0, 64]",)), ("SetOffsetScale", NAN, ("nan",)),
                             ("SetOutput", 4, ("[0, 3]",))):
    refused(f"{setter}({value})", (vtkWaterProperty(), lambda it: getattr(it, setter)(value)), words)
wt.finish()

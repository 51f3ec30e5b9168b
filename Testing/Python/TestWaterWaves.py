# SPDX-License-Identifier: BSD-3-Clause
"""Reflections on waves against a ray caster; the waves themselves; time, queries and bad input."""

import numpy as np
import ray_caster
import water_test as wt
from vtkwater import vtkWaterActor, vtkWaterProperty
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

# Steep waves: the shader finds the point at rest as the core does. Truth: crests are sharper.
made, water = post_scene("middle", waves=())
water.GetWaterProperty().AddWave(0.05, 2.0, 30.0, 0.0, 1.0)
steep = made.picture()
water.GetWaterProperty().RemoveAllWaves()
water.GetWaterProperty().AddWave(0.05, 2.0, 30.0, 0.0, 0.0)
wt.check_at_least("steepness changes the picture", int(np.abs(made.picture() - steep).max()), 50)


# Bad input.
def refused(name, do, words):
    errors = []

    class Text:
        CallDataType = "string0"

        def __call__(self, caller, event, text):
            errors.append(text)

    thing = do[0]
    thing.AddObserver("ErrorEvent", Text())
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
                             ("SetLookup", 3, ("[0, 2]",)), ("SetRayTraceSteps", 0, ("[1, 256]",)),
                             ("SetRayTraceProbes", -1, ("[0, 64]",)), ("SetOffsetScale", NAN, ("nan",)),
                             ("SetOutput", 3, ("[0, 2]",))):
    refused(f"{setter}({value})", (vtkWaterProperty(), lambda it: getattr(it, setter)(value)), words)
wt.finish()

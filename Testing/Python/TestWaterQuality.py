# SPDX-License-Identifier: BSD-3-Clause
"""The texture's scale by a target error, a time budget, the window's update rate; values that are
refused; a budget that waters share."""

import water_test as wt
from vtkwater import vtkWaterReflectionPass as Pass

SIZE = (200, 150)


def make(count=1):
    view = wt.View(SIZE)
    wt.add_actor(view.renderer, wt.box((0, 3, 1), (2, 2, 2)), (0.9, 0.4, 0.2))
    waters = [wt.add_water(view.renderer, wt.plane((0, 0, -0.01 * i), (0, 0, 1)), (-9 + 9 * i, 9 * i, -9, 9), 0.9)
              for i in range(count)]
    wt.place_camera(view.renderer, (0, -14, 5), (0, 0, 0), (0.5, 80))
    return view, waters, [water.GetReflectionPass() for water in waters]


def frames(view, count):
    for _ in range(count):
        view.renderer.GetActiveCamera().Azimuth(0.05)
        view.window.Render()
        view.window.WaitForCompletion()


def width(reflection):
    return reflection.GetReflectionTexture().GetWidth()


# fixed
view, (water,), (reflection,) = make()
frames(view, 1)
wt.check_equal("fixed: step, scale, texels", (reflection.GetQualityStep(), reflection.GetTextureScaleInUse(), width(reflection)),
               (-1, 1.0, SIZE[0]))
exact = view.picture()

# target error: calm water is off by 0.4 / scale; a coarser step wants a tenth of reserve
reflection.SetQualityToTargetError()
for target, texels in ((0.45, 200), (0.9, 100), (1.8, 50)):
    reflection.SetTargetError(0.1)
    frames(view, 1)
    reflection.SetTargetError(target)
    frames(view, 1)
    wt.check_equal(f"target error {target}: texels", width(reflection), texels)
wt.check_equal("target error: scale as it was set", reflection.GetTextureScale(), 1.0)
wt.check_equal("target error: scale in use", reflection.GetTextureScaleInUse(), 0.25)

# time budget: one that nothing can meet ends at the coarsest step, another leads back
reflection.SetQualityToTimeBudget()
reflection.SetTimeBudget(1e-3)
frames(view, 60)
wt.check_equal("no time: step", reflection.GetQualityStep(), 7)
reflection.SetTimeBudget(1e6)
frames(view, 150)
wt.check_equal("all the time: step", reflection.GetQualityStep(), 0)

# update rate: coarse while somebody interacts, and the one still frame afterwards is fine
reflection.SetQualityToUpdateRate()
view.window.SetDesiredUpdateRate(1e5)
frames(view, 60)
wt.check_equal("interactive: step", reflection.GetQualityStep(), 7)
view.window.SetDesiredUpdateRate(0.0001)
frames(view, 1)
wt.check_equal("still: step of the first frame", reflection.GetQualityStep(), 0)
wt.check_equal("still: texels of the first frame", width(reflection), SIZE[0])
reflection.SetQualityToFixed()
frames(view, 1)
wt.check_equal("fixed again: texels", width(reflection), SIZE[0])

# two waters share: the time of both together decides, not that of each
view, waters, passes = make(2)
for reflection in passes:
    reflection.SetQualityToTimeBudget()
    reflection.SetTimeBudget(1e-3)
frames(view, 80)
wt.check_equal("two waters, no time: steps", [reflection.GetQualityStep() for reflection in passes], [7, 7])

# values that are refused, by their names, and stay
for setter, getter, bad, low in (("SetTimeBudget", "GetTimeBudget", (0.0, -1.0, float("nan")), "0.001"),
                                 ("SetTargetError", "GetTargetError", (0.0, float("nan"), float("inf")), "0.001"),
                                 ("SetQuality", "GetQuality", (-1, 4), "0")):
    reflection = Pass()
    before = getattr(reflection, getter)()
    errors = wt.errors_of(reflection)
    for value in bad:
        getattr(reflection, setter)(value)
    wt.check_equal(f"{setter}: errors", len(errors), len(bad))
    text = " ".join(errors)
    missing = [word for word in (setter[3:], low, "must lie in") if word not in text]
    wt.check_equal(f"{setter}: not named", missing, [])
    wt.check_equal(f"{setter}: stays", getattr(reflection, getter)(), before)
wt.finish()

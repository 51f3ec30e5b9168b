# SPDX-License-Identifier: BSD-3-Clause
"""The texture's scale by a target error, a time budget, the window's update rate; values that are
refused; a budget that waters share."""

import pytest
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


def test_the_scale_is_fixed_by_default():
    """By default the texture has the window's size, and no step of quality is taken."""
    view, _, (reflection,) = make()
    frames(view, 1)
    wt.check_equal("fixed: step, scale, texels",
                   (reflection.GetQualityStep(), reflection.GetTextureScaleInUse(), width(reflection)),
                   (-1, 1.0, SIZE[0]))


def test_a_target_error_decides_the_scale():
    """With a target error the scale in use is the coarsest that keeps it, and the scale as it was set stays."""
    # calm water is off by 0.4 / scale; a coarser step wants a tenth of reserve
    view, _, (reflection,) = make()
    reflection.SetQualityToTargetError()
    for target, texels in ((0.45, 200), (0.9, 100), (1.8, 50)):
        reflection.SetTargetError(0.1)
        frames(view, 1)
        reflection.SetTargetError(target)
        frames(view, 1)
        wt.check_equal(f"target error {target}: texels", width(reflection), texels)
    wt.check_equal("target error: scale as it was set", reflection.GetTextureScale(), 1.0)
    wt.check_equal("target error: scale in use", reflection.GetTextureScaleInUse(), 0.25)


def test_a_time_budget_decides_the_step():
    """A time budget that nothing can meet ends at the coarsest step, and a large one leads back to the finest."""
    view, _, (reflection,) = make()
    reflection.SetQualityToTimeBudget()
    reflection.SetTimeBudget(1e-3)
    frames(view, 60)
    wt.check_equal("no time: step", reflection.GetQualityStep(), 7)
    reflection.SetTimeBudget(1e6)
    frames(view, 150)
    wt.check_equal("all the time: step", reflection.GetQualityStep(), 0)


def test_the_windows_update_rate_decides_the_step():
    """The reflection is coarse while somebody interacts, and fine in the one still frame afterwards."""
    view, _, (reflection,) = make()
    reflection.SetQualityToUpdateRate()
    view.window.SetDesiredUpdateRate(1e5)
    frames(view, 60)
    wt.check_equal("interactive: step", reflection.GetQualityStep(), 7)
    view.window.SetDesiredUpdateRate(0.0001)
    frames(view, 1)
    wt.check_equal("still: step of the first frame", reflection.GetQualityStep(), 0)
    wt.check_equal("still: texels of the first frame", width(reflection), SIZE[0])


def test_a_fixed_scale_comes_back():
    """When the quality is fixed again, the next frame has the scale as it was set."""
    view, _, (reflection,) = make()
    reflection.SetQualityToTargetError()
    reflection.SetTargetError(1.8)
    frames(view, 2)
    assert width(reflection) < SIZE[0]
    reflection.SetQualityToFixed()
    frames(view, 1)
    wt.check_equal("fixed again: texels", width(reflection), SIZE[0])


def test_two_waters_share_a_time_budget():
    """The time of both waters together decides their steps, not that of each."""
    view, _, passes = make(2)
    for reflection in passes:
        reflection.SetQualityToTimeBudget()
        reflection.SetTimeBudget(1e-3)
    frames(view, 80)
    wt.check_equal("two waters, no time: steps", [reflection.GetQualityStep() for reflection in passes], [7, 7])


@pytest.mark.parametrize("name, bad, low", [
    ("TimeBudget", (0.0, -1.0, float("nan")), "0.001"),
    ("TargetError", (0.0, float("nan"), float("inf")), "0.001"),
    ("Quality", (-1, 4), "0"),
], ids=["TimeBudget", "TargetError", "Quality"])
def test_values_out_of_range_are_refused(name, bad, low):
    """A value out of range is refused with an error that names it and its range, and the last good one stays."""
    reflection = Pass()
    before = getattr(reflection, f"Get{name}")()
    errors = wt.errors_of(reflection)
    for value in bad:
        getattr(reflection, f"Set{name}")(value)
    wt.check_equal(f"Set{name}: errors", len(errors), len(bad))
    text = " ".join(errors)
    missing = [word for word in (name, low, "must lie in") if word not in text]
    wt.check_equal(f"Set{name}: not named", missing, [])
    wt.check_equal(f"Set{name}: stays", getattr(reflection, f"Get{name}")(), before)

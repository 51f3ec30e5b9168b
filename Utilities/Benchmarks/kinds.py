# SPDX-License-Identifier: BSD-3-Clause
"""kinds: how the water finds its reflection: each lookup and quality step, each texture scale."""

from dataclasses import dataclass

import wave_scenes
from formulas import FORMULAS

WAVES = wave_scenes.POSTS_WAVES
SCALES = (1.0, 0.5, 0.25)


@dataclass(frozen=True)
class Step:
    """A lookup; formula: the name in Accuracy/formulas.py whose best constant it takes."""

    name: str
    setting: str = ""  # of vtkWaterProperty: Set...
    formula: str = ""
    has_waves: bool = True

    def apply(self, water, scale, constants):
        """constants: by name of the formula."""
        look = water.GetWaterProperty()
        set_waves(water, WAVES if self.has_waves else ())
        look.SetLookupToRayTraced()
        if self.setting:
            getattr(look, f"Set{self.setting}")()
        look.SetOffsetScale(constants.get(self.formula, 0.0))
        water.GetReflectionPass().SetTextureScale(scale)


CALM = Step("calm water", has_waves=False)
FIXED = Step("FIXED_OFFSET", "LookupToFixedOffset", "constant offset")
MOVED = Step("MOVED_POINT", "LookupToMovedPoint", "moved surface point")
SCALED = Step("VIEW_SCALED_OFFSET", "LookupToViewScaledOffset", "offset over depth")
TRACED = Step("RAY_TRACED default", "RayTraceQualityToDefault")
STEPS = (
    CALM,
    Step("FIXED_OFFSET, s = 0", "LookupToFixedOffset"),
    FIXED,
    MOVED,
    SCALED,
    Step("RAY_TRACED fast", "RayTraceQualityToFast"),
    TRACED,
    Step("RAY_TRACED high", "RayTraceQualityToHigh"),
)


def formula_of(step):
    return next(formula for formula in FORMULAS if formula.name == step.formula)


def set_waves(water, waves):
    look = water.GetWaterProperty()
    if look.GetNumberOfWaves() != len(waves):  # those there are never change
        look.RemoveAllWaves()
        for wave in waves:
            look.AddWave(*wave)


def cases():
    """(step, scale) pairs of the matrix."""
    return [(step, scale) for scale in SCALES for step in STEPS]


def quick_cases(is_main, is_slow):
    """All steps for the main scene, at scale 1; the calm and the default for others."""
    if is_main:
        return [*((step, 1.0) for step in STEPS), (CALM, 0.5), (TRACED, 0.5), (TRACED, 0.25)]
    return [(CALM, 1.0)] if is_slow else [(CALM, 1.0), (TRACED, 1.0)]

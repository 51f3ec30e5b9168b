# SPDX-License-Identifier: BSD-3-Clause
"""In random scenes clear water shows nothing where the picture has what is right that is not near by in the truth."""

import pathlib
import sys

import numpy as np
import pytest
import water_test as wt

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "Accuracy"))

import refraction_generator  # noqa: E402
import refraction_truth  # noqa: E402

SIZE = (108, 81)
# seeds: the most % of strange pixels, and the RMSE of 255, where the picture has what is right
LIMITS = {29: (1.0, 12.0), 31: (1.0, 6.0), 47: (1.0, 6.0)}
BED_ENDS = {9004: (1.0, 13.0), 9009: (2.5, 13.0)}  # parallel beams at a low angle that see the end of a bed
OUTSIDE = (9316,)


@pytest.mark.parametrize("is_software", (1, 0))
@pytest.mark.parametrize("seed", [*LIMITS, *BED_ENDS])
def test_what_the_picture_has_is_shown_without_notches(seed, is_software, monkeypatch):
    """Where the picture has what a refracted ray meets, notches and blocks of other colours are next to none."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    scene = refraction_generator.make(seed, SIZE)
    look = scene.water.GetWaterProperty()
    look.RefractionOff()
    mask = wt.water_mask(scene.made, scene.water)
    look.RefractionOn()
    picture = scene.made.picture()
    tracer = refraction_truth.LocatorTracer(scene.made.renderer, scene.origin)
    truth = refraction_truth.Truth(scene, tracer, SIZE, 1)
    chosen = truth.mask & mask & (truth.reasons == 0)
    strange = 100 * float(truth.is_strange(picture)[chosen].mean())
    error = float(np.sqrt(((picture - truth.picture)[chosen] ** 2).mean()))
    wt.check_at_least(f"seed {seed}: pixels", int(chosen.sum()), 1000)
    wt.check_at_most(f"seed {seed}: % of strange pixels", strange, (LIMITS | BED_ENDS)[seed][0])
    wt.check_at_most(f"seed {seed}: RMSE of 255", error, (LIMITS | BED_ENDS)[seed][1])


@pytest.mark.parametrize("seed", OUTSIDE)
def test_an_own_view_has_what_lies_outside_the_picture(seed):
    """Colours of what lies outside the picture are guessed, and often wrong; a view of its own has nearly all of them."""
    scene = refraction_generator.make(seed, SIZE)
    look = scene.water.GetWaterProperty()
    look.RefractionOff()
    mask = wt.water_mask(scene.made, scene.water)
    look.RefractionOn()
    tracer = refraction_truth.LocatorTracer(scene.made.renderer, scene.origin)
    truth = refraction_truth.Truth(scene, tracer, SIZE, 1)
    chosen = truth.mask & mask & (truth.reasons == refraction_truth.REASONS.index("out of the picture"))
    strange = {}
    for source in (look.PICTURE, look.OWN_VIEW):
        look.SetRefractionSource(source)
        strange[source] = 100 * float(truth.is_strange(scene.made.picture())[chosen].mean())
    wt.check_at_least(f"seed {seed}: pixels", int(chosen.sum()), 500)
    wt.check_at_least(f"seed {seed}: % of strange pixels, picture", strange[look.PICTURE], 20.0)
    wt.check_at_most(f"seed {seed}: % of strange pixels, own view", strange[look.OWN_VIEW], 2.0)

# SPDX-License-Identifier: BSD-3-Clause
"""Reflections are linear light: a card reflected at reflectance F reads F times itself, also when it
is brighter than white and a tone mapping follows."""

import numpy as np
import pytest
import water_test as wt
from vtkmodules import vtkRenderingOpenGL2
from vtkmodules.vtkRenderingCore import vtkLight
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkRenderPassCollection,
    vtkRenderStepsPass,
    vtkSequencePass,
    vtkToneMappingPass,
)
from vtkwater import vtkWaterReflectionPass

SIZE = (200, 150)
EIGHT_BIT, HALF_FLOAT = vtkWaterReflectionPass.EIGHT_BIT, vtkWaterReflectionPass.HALF_FLOAT


def card_and_water(gray, reflectance, light=1.0):
    """A card on end behind the water, lit from the front; the water is black but for the card."""
    made = wt.View(SIZE, (0, 0, 0))
    wt.add_actor(made.renderer, wt.box((0, 6, 5), (60, 0.1, 10)), (gray, gray, gray))
    source = vtkLight()
    source.SetLightTypeToSceneLight()
    source.SetPosition(0, -1, 0)
    source.SetFocalPoint(0, 0, 0)
    source.SetIntensity(light)
    made.renderer.AddLight(source)
    water = wt.add_water(made.renderer, None, (-60, 60, -60, 60), reflectance)
    water.GetWaterProperty().SetDeepColor(0, 0, 0)
    wt.place_camera(made.renderer, (0, -12, 3), (0, 0, 1.5), (0.5, 100))
    return made, water


def read(made):
    """The card and its reflection, as numbers of 255."""
    picture = made.picture()
    return int(picture[140, 100, 0]), int(picture[25, 100, 0])


@pytest.mark.parametrize("reflectance", (0.1, 0.5, 1.0))
@pytest.mark.parametrize("gray", (0.18, 0.5, 0.9))
@pytest.mark.parametrize("precision", (EIGHT_BIT, HALF_FLOAT), ids=("eight_bits", "half_floats"))
def test_a_card_is_reflected_at_its_share(precision, gray, reflectance):
    """A gray card is reflected as the reflectance's share of it, in reflection textures of either precision."""
    made, water = card_and_water(gray, reflectance)
    water.GetReflectionPass().SetColorPrecision(precision)
    wt.check_at_most(f"gray {gray}, precision {precision}, F = {reflectance}: |reflection - F card|",
                     abs(read(made)[1] - reflectance * 255 * gray), 1.0)


@pytest.mark.parametrize("precision, expected, name", (
    (HALF_FLOAT, 0.4 * 255, "half floats: error of 255"),
    (EIGHT_BIT, 0.1 * 255, "8 bits: error from the clipped 25.5"),
), ids=("half_floats", "eight_bits"))
def test_half_floats_know_what_is_brighter_than_white(precision, expected, name):
    """Light of 8 on a card of 0.5 is 4: a tenth of it is 0.4 by half floats; 8 bits cannot know more than 0.1."""
    made, water = card_and_water(0.5, 0.1, light=8.0)
    water.GetReflectionPass().SetColorPrecision(precision)
    wt.check_at_most(f"card of 4, F = 0.1, {name}", abs(read(made)[1] - expected), 1.0)


def mapped(with_water):
    """The card and its reflection under a tone mapping; or the light that the reflection should have."""
    made, water = card_and_water(0.5, 0.1, light=8.0)
    if not with_water:  # as a plain card in the water's place
        made.renderer.RemoveActor(water)
        wt.add_actor(made.renderer, wt.box((0, 0, -0.05), (120, 120, 0.1)), (0.4, 0.4, 0.4), lit=False)
    tone = vtkToneMappingPass()
    tone.SetToneMappingType(vtkToneMappingPass.Reinhard)
    tone.SetDelegatePass(vtkRenderStepsPass())
    made.renderer.SetPass(tone)
    return read(made)


def test_a_tone_mapping_maps_the_reflection_once():
    """Under a tone mapping a reflection is mapped once: the curve of F times the card's light, by itself."""
    card, expected = mapped(False)
    same_card, reflection = mapped(True)
    wt.check_at_most("tone mapped: change of the card itself", abs(card - same_card), 0)
    wt.check_at_most("tone mapped: |reflection - the curve of its light|", abs(reflection - expected), 1.0)


def chain(*names):
    """A pass of VTK by its name, over the next, over VTK's usual steps."""
    inner = chain(*names[1:]) if names[1:] else vtkRenderStepsPass()
    if names[0] == "steps":
        return inner
    if names[0] == "steps, then tone mapping":
        inner.SetPostProcessPass(vtkToneMappingPass())
        return inner
    if names[0] == "sequence":
        parts = vtkRenderPassCollection()
        parts.AddItem(inner)
        made = vtkSequencePass()
        made.SetPasses(parts)
        return made
    made = getattr(vtkRenderingOpenGL2, names[0])() if names[0] != "water" else vtkWaterReflectionPass()
    made.SetDelegatePass(inner)
    return made


@pytest.mark.parametrize("names, precision", (
    (("steps",), EIGHT_BIT), (("sequence",), EIGHT_BIT), (("vtkCameraPass", "sequence"), EIGHT_BIT),
    (("vtkGaussianBlurPass",), EIGHT_BIT), (("vtkOpenGLFXAAPass",), EIGHT_BIT), (("water",), EIGHT_BIT),
    (("vtkToneMappingPass",), HALF_FLOAT), (("vtkGaussianBlurPass", "vtkToneMappingPass"), HALF_FLOAT),
    (("sequence", "steps, then tone mapping"), HALF_FLOAT), (("water", "vtkToneMappingPass"), HALF_FLOAT),
    (("vtkEDLShading",), HALF_FLOAT),
), ids=lambda value: "-".join(value).replace(" ", "_") if isinstance(value, tuple) else str(value))
def test_half_floats_are_for_passes_that_keep_more(names, precision):
    """Left to itself, the reflection keeps more than 8 bits where a pass of the renderer's does, and only there."""
    pictures = []
    for one in (vtkWaterReflectionPass.AUTOMATIC, precision, EIGHT_BIT + HALF_FLOAT - precision):
        made, water = card_and_water(0.5, 0.1, light=8.0)
        water.GetReflectionPass().SetColorPrecision(one)
        made.renderer.SetPass(chain(*names))
        if names[0] == "water":
            made.renderer.GetPass().SetColorPrecision(one)
        pictures.append(made.picture())
    label = ", ".join(names)
    wt.check_equal(f"{label}: difference from precision {precision}", wt.difference(pictures[0], pictures[1]), 0)
    wt.check_at_least(f"{label}: difference from the other", wt.difference(pictures[0], pictures[2]), 10)


def test_another_precision_leaves_no_trace_of_the_last():
    """Another precision makes the texture anew: back at the first, the picture is the first."""
    made, water = card_and_water(0.5, 1.0)
    pictures = []
    for precision in (0, 2, 1, 0):
        water.GetReflectionPass().SetColorPrecision(precision)
        pictures.append(made.picture())
    wt.check_equal("switching there and back: largest difference", int(np.abs(pictures[0] - pictures[3]).max()), 0)


def test_a_precision_that_there_is_not_is_refused():
    """A precision out of range is one error, and the last good one stays."""
    mirror = vtkWaterReflectionPass()
    errors = wt.errors_of(mirror)
    mirror.SetColorPrecision(3)
    wt.check_equal("precision 3: errors", len(errors), 1)
    wt.check_equal("precision 3: the last good one stays", mirror.GetColorPrecision(), 0)

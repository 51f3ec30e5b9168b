# SPDX-License-Identifier: BSD-3-Clause
"""Reflections are linear light: a card reflected at reflectance F reads F times itself, also when it
is brighter than white and a tone mapping follows."""

import numpy as np
import water_test as wt
from vtkmodules.vtkRenderingCore import vtkLight
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass, vtkToneMappingPass
from vtkwater import vtkWaterReflectionPass

SIZE = (200, 150)


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
    return picture[140, 100, 0], picture[25, 100, 0]


for precision in (vtkWaterReflectionPass.EIGHT_BIT, vtkWaterReflectionPass.HALF_FLOAT):
    for gray in (0.18, 0.5, 0.9):
        for reflectance in (0.1, 0.5, 1.0):
            made, water = card_and_water(gray, reflectance)
            water.GetReflectionPass().SetColorPrecision(precision)
            card, reflection = read(made)
            wt.check_at_most(f"gray {gray}, precision {precision}, F = {reflectance}: |reflection - F card|",
                             abs(reflection - reflectance * 255 * gray), 1.0)

# Light of 8 on a card of 0.5 is 4: a tenth of it is 0.4, which 8 bits cannot know.
made, water = card_and_water(0.5, 0.1, light=8.0)
water.GetReflectionPass().SetColorPrecision(vtkWaterReflectionPass.HALF_FLOAT)
wt.check_at_most("card of 4, F = 0.1, half floats: error of 255", abs(read(made)[1] - 102), 1.0)
water.GetReflectionPass().SetColorPrecision(vtkWaterReflectionPass.EIGHT_BIT)
wt.check_at_most("card of 4, F = 0.1, 8 bits: error from the clipped 25.5", abs(read(made)[1] - 25.5), 1.0)


# Under a tone mapping the reflection is mapped once: the curve of F times the card's light, by itself.
def mapped(with_water):
    made, water = card_and_water(0.5, 0.1, light=8.0)
    if not with_water:  # the light that the reflection should have, as a plain card in the water's place
        made.renderer.RemoveActor(water)
        wt.add_actor(made.renderer, wt.box((0, 0, -0.05), (120, 120, 0.1)), (0.4, 0.4, 0.4), lit=False)
    tone = vtkToneMappingPass()
    tone.SetToneMappingType(vtkToneMappingPass.Reinhard)
    tone.SetDelegatePass(vtkRenderStepsPass())
    made.renderer.SetPass(tone)
    return read(made)


card, expected = mapped(False)
same_card, reflection = mapped(True)
wt.check_at_most("tone mapped: change of the card itself", abs(int(card) - int(same_card)), 0)
wt.check_at_most("tone mapped: |reflection - the curve of its light|", abs(int(reflection) - int(expected)), 1.0)

# Another precision makes the texture anew, without a trace of the last.
made, water = card_and_water(0.5, 1.0)
pictures = []
for precision in (0, 2, 1, 0):
    water.GetReflectionPass().SetColorPrecision(precision)
    pictures.append(made.picture())
wt.check_equal("switching there and back: largest difference", int(np.abs(pictures[0] - pictures[3]).max()), 0)
errors = wt.errors_of(water.GetReflectionPass())
water.GetReflectionPass().SetColorPrecision(3)
wt.check_equal("precision 3: errors", len(errors), 1)
wt.check_equal("precision 3: the last good one stays", water.GetReflectionPass().GetColorPrecision(), 0)
wt.finish()

# SPDX-License-Identifier: BSD-3-Clause
"""The shares of reflection, water and background in a pixel are those of the formulas.

White sky over black water: the pixel is 255 times the reflectance. The expected values come from the
sine and tangent form of the Fresnel equations (Born and Wolf, "Principles of Optics", 1.5.2, eq. 21a),
evaluated apart from this project, whose code uses another form.
"""

import math

import numpy as np
import pytest
import water_test as wt


def centre(angle, look, deep=(0, 0, 0), behind=None, below=False):
    """The colour of the pixel that looks at the water under an angle (degrees from the normal)."""
    view = wt.View((41, 41), background=(1, 1, 1))
    water = wt.add_water(view.renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-400, 400, -400, 400), None)
    water.GetWaterProperty().SetDeepColor(deep)
    look(water.GetWaterProperty())
    if behind:
        floor = wt.add_actor(view.renderer, wt.box((0, 0, -2), (900, 900, 1)), behind, lit=False)
        floor.GetProperty().SetAmbient(1)
    camera = view.renderer.GetActiveCamera()
    height = math.cos(math.radians(angle)) * 10 * (-1 if below else 1)
    camera.SetPosition(0, -math.sin(math.radians(angle)) * 10, height)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0.001, 1 if angle > 1 else 0)
    if angle < 1:
        camera.SetViewUp(0, 1, 0)
    camera.SetViewAngle(1)
    camera.SetClippingRange(0.1, 900)
    return view.picture()[20, 20]


def fresnel(look):
    look.SetReflectanceModeToFresnel()


def constant(reflectance):
    def set_look(look):
        look.SetReflectanceModeToConstant()
        look.SetReflectance(reflectance)

    return set_look


def half_opaque(look):
    constant(0.5)(look)
    look.SetOpacity(0.4)


# angle in degrees: reflectance of a surface of index 1.333, from above
ABOVE = {0: 0.020373, 30: 0.021436, 45: 0.027898, 60: 0.059691, 75: 0.212378, 80: 0.347917, 85: 0.583523}
# from below: index 1 / 1.333; total from 48.61 degrees on
BELOW = {0: 0.020373, 30: 0.025519, 45: 0.139458, 49: 1.0, 70: 1.0}


@pytest.mark.parametrize("angle, expected", ABOVE.items(), ids=[f"{angle}_degrees" for angle in ABOVE])
def test_from_above_it_reflects_the_share_of_fresnels_equations(angle, expected):
    """Seen from above, water reflects what the Fresnel equations say for the angle."""
    value = centre(angle, fresnel)
    wt.check_at_most(f"from above, {angle} degrees: |pixel - 255 F| ({value[0]})",
                     float(np.abs(value - 255 * expected).max()), 1.0)


@pytest.mark.parametrize("angle, expected", BELOW.items(), ids=[f"{angle}_degrees" for angle in BELOW])
def test_from_below_it_reflects_the_share_of_fresnels_equations(angle, expected):
    """Seen from below, water reflects what the Fresnel equations say, and all beyond the critical angle."""
    value = centre(angle, fresnel, below=True)
    wt.check_at_most(f"from below, {angle} degrees: |pixel - 255 F| ({value[0]})",
                     float(np.abs(value - 255 * expected).max()), 1.0)


def test_a_constant_share_mixes_reflection_and_deep_colour():
    """With a constant reflectance of one half, a pixel is half reflection and half the water's colour."""
    wt.check_at_most("constant 0.5 over red water: error",
                     float(np.abs(centre(45, constant(0.5), (1, 0, 0)) - (255, 127.5, 127.5)).max()), 1.0)


def test_a_constant_share_of_one_is_a_mirror():
    """With a constant reflectance of 1, a pixel is the reflection and nothing else."""
    wt.check_equal("constant 1: the reflection and nothing else",
                   centre(45, constant(1), (1, 0, 0)).tolist(), [255] * 3)


def test_opacity_mixes_the_water_with_what_is_behind():
    """Water of opacity 0.4 is 0.4 of a pixel, and what is behind it the rest."""
    # 0.4 of (half white, half black) and 0.6 of the green floor
    wt.check_at_most("opacity 0.4 over a green floor: error",
                     float(np.abs(centre(45, half_opaque, behind=(0, 1, 0)) - (51, 204, 51)).max()), 2.0)

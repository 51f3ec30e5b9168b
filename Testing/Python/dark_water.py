# SPDX-License-Identifier: BSD-3-Clause
"""dark_water: black water, so that all there is to see is what shines on it or is reflected."""

import ray_caster
import water_test as wt
from vtkwater import vtkWaterProperty

SIZE = (300, 220)


def look_at(view, position, target=(0, 0, 0), angle=30, up=(0, 0, 1)):
    camera = wt.place_camera(view.renderer, position, target, (0.1, 400), up)
    camera.SetViewAngle(angle)
    return camera


def add_dark_water(view, reflectance=0.0):
    water = wt.add_water(view.renderer, None, (-200, 200, -200, 200), reflectance)
    water.GetWaterProperty().SetDeepColor(0, 0, 0)
    return water


def pixel_rays(camera, samples=1):
    """Of each pixel: where its ray meets the water, and the ray."""
    start, ray = ray_caster.eye_rays(camera, SIZE, samples)
    return start - (start[:, 2] / ray[:, 2])[:, None] * ray, ray


def check_refused(setter, value, words):
    """A setter of vtkWaterProperty says one error with these words, and changes nothing."""
    look = vtkWaterProperty()
    before = str(look).split("ReflectanceMode")[1]
    errors = wt.errors_of(look)
    getattr(look, setter)(*value)
    wt.check_equal(f"{setter}{value}: errors", len(errors), 1)
    for word in words:
        wt.check_equal(f"{setter}{value}: the error says '{word}'", word in "".join(errors), True)
    wt.check_equal(f"{setter}{value}: all stays", str(look).split("ReflectanceMode")[1] == before, True)

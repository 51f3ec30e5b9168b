# SPDX-License-Identifier: BSD-3-Clause
"""A static environment in place of the mirrored scene: the water shows the texel in the reflected direction, and
nothing is rendered for it."""

import numpy as np
import pytest
import ray_caster
import water_test as wt
from dark_water import SIZE, add_dark_water, check_refused, look_at, pixel_rays
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkTexture
from vtkwater import vtkWaterReflectionPass

WAVES = {"calm": (), "with a wave": ((0.02, 2.0, 20.0, 10.0),)}


def panorama(width=512, height=256):
    """A texture whose red is the longitude and whose green is the latitude."""
    u, v = np.meshgrid((np.arange(width) + 0.5) / width, (np.arange(height) + 0.5) / height)
    texels = np.stack([255 * u, 255 * v, 128 + 127 * np.sin(6 * np.pi * u)], axis=2).astype(np.uint8)
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(texels.reshape(-1, 3), deep=True))
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.InterpolateOn()
    return texture


class Scene:
    """A box, and perfectly reflecting water whose environment is the panorama."""

    def __init__(self, waves):
        self.waves = waves
        self.view = wt.View(SIZE, (0, 0, 0))
        wt.add_actor(self.view.renderer, wt.box((0, 3, 1), (1, 1, 1)), (1, 1, 1), lit=False)
        self.view.renderer.SetEnvironmentUp(0, 0, 1)
        self.view.renderer.SetEnvironmentRight(1, 0, 0)
        self.water = add_dark_water(self.view, 1.0)
        look = self.water.GetWaterProperty()
        look.SetReflectionSourceToEnvironment()
        look.SetEnvironmentTexture(panorama())
        for wave in waves:
            look.AddWave(*wave)
        self.camera = look_at(self.view, (1, -10, 4), (1, 0, 0))
        self.place, self.ray = pixel_rays(self.camera)

    def mask(self):
        """Pixels of the water, but for those near the horizon."""
        return wt.water_mask(self.view, self.water).ravel() & (self.ray[:, 2] < -0.1)

    def expected(self):
        """u and v of the reflected direction."""
        _, sx, sy = ray_caster.heights_and_slopes(self.waves, self.place[:, 0], self.place[:, 1], 0.0)
        normal = np.stack([-sx, -sy, np.ones_like(sx)], axis=1)
        normal /= np.linalg.norm(normal, axis=1, keepdims=True)
        away = self.ray - 2 * (self.ray * normal).sum(axis=1, keepdims=True) * normal
        right, up, back = away[:, 0], np.abs(away[:, 2]), -away[:, 1]  # right x up
        return 0.5 + np.arctan2(back, right) / (2 * np.pi), 0.5 + np.arctan2(up, np.hypot(right, back)) / np.pi


@pytest.mark.parametrize("kind", WAVES)
def test_environment_is_looked_up_in_the_reflected_direction(kind):
    """The water shows the texel in the reflected direction, and no mirrored view is rendered."""
    scene = Scene(WAVES[kind])
    shown = scene.view.picture().reshape(-1, 3)
    reflection = scene.water.GetReflectionPass()
    name = f"environment, {len(scene.waves)} waves"
    wt.check_equal(f"{name}: mirrored views", reflection.GetNumberOfReflectionRenders(), 0)
    wt.check_equal(f"{name}: decision", reflection.GetDecision(), vtkWaterReflectionPass.STATIC_ENVIRONMENT)
    u, v = scene.expected()
    error = np.maximum(np.abs(shown[:, 0] - 255 * u), np.abs(shown[:, 1] - 255 * v))[scene.mask()]
    wt.check_at_most(f"{name}: error of 255, 99 % of the water", float(np.percentile(error, 99)), 2.0)


def test_without_a_texture_the_background_is_reflected():
    """Water whose environment has no texture shows the renderer's background."""
    scene = Scene(WAVES["with a wave"])
    scene.view.picture()
    mask = scene.mask()
    scene.water.GetWaterProperty().SetEnvironmentTexture(None)
    scene.view.renderer.SetBackground(0.2, 0.4, 0.6)
    error = np.abs(scene.view.picture().reshape(-1, 3)[mask] - 255 * np.array((0.2, 0.4, 0.6)))
    wt.check_at_most("environment without a texture: error from the background", float(error.max()), 1.0)


def test_unknown_source_is_refused():
    """A source of reflections that there is not gives one clear error and changes nothing."""
    check_refused("SetReflectionSource", (2,), ("2", "[0, 1]"))


def test_cube_map_is_refused():
    """A cube map, which is no panorama, gives one clear error and changes nothing."""
    cube = vtkTexture()
    cube.CubeMapOn()
    check_refused("SetEnvironmentTexture", (cube,), ("cube map", "latitude"))

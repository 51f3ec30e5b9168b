# SPDX-License-Identifier: BSD-3-Clause
"""Calm and wavy water looks the same at 1e5, 5e6 and 1e7 m from the origin, a million times smaller and
larger, and after 1e9 s; also while the camera moves: no reflection shifts by 0.1 px, but where one ray in
10,000 passes an edge so closely that its last bit decides whether it meets. An edge of a thing may itself pass
a texel of the mirrored view that closely, and the rays of up to five pixels end on that texel.
"""

from decimal import Decimal, getcontext

import numpy as np
import pytest
import water_test as wt
from ray_caster import Box
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from wave_scenes import POSTS_WAVES, SKY, looked_up, posts

SIZE = (320, 240)
SHIFT = 0.1  # px
EDGES = 0.02  # % of the pixels
# of vtkOpenGLVertexBufferObject; the two left out shift nothing, and VTK's own picture falls apart
MODES = {1: "AUTO_SHIFT_SCALE", 2: "ALWAYS_AUTO_SHIFT_SCALE", 4: "AUTO_SHIFT", 5: "NEAR_PLANE_SHIFT_SCALE",
         6: "FOCAL_POINT_SHIFT_SCALE"}
WAVES = {"calm": (), "wavy": POSTS_WAVES}
LATE = 10**9  # s
PI = Decimal("3.14159265358979323846264338327950288419716939937510")
getcontext().prec = 50


def placed(data, offset, scale):
    matrix = vtkMatrix4x4()
    for i in range(3):
        matrix.SetElement(i, i, scale)
        matrix.SetElement(i, 3, offset[i])
    return wt.transformed(data, matrix)


class Scene:
    def __init__(self, offset=(0, 0, 0), scale=1.0, waves=(), mode=None):
        self.offset, self.scale = np.asarray(offset, float), scale
        self.view = wt.View(SIZE, SKY)
        for thing in posts():
            data = (wt.box(0.5 * (thing.low + thing.high), thing.high - thing.low) if isinstance(thing, Box)
                    else wt.sphere(thing.center, thing.radius, 48))
            actor = wt.add_actor(self.view.renderer, placed(data, offset, scale), thing.color, lit=False)
            if mode is not None:
                actor.GetMapper().SetVBOShiftScaleMethod(mode)
        self.water = wt.add_water(self.view.renderer, wt.plane(self.offset, (0, 0, 1)),
                                  np.array((-60, 60, -60, 60)) * scale)
        if mode is not None:
            self.water.GetMapper().SetVBOShiftScaleMethod(mode)
        for amplitude, length, direction, phase in waves:
            self.water.GetWaterProperty().AddWave(amplitude * scale, length * scale, direction, phase)
        self.look(0)

    def look(self, step):
        """A camera that moves by fractions of a pixel."""
        camera = self.view.renderer.GetActiveCamera()
        camera.SetPosition(np.array((2 + 0.003 * step, -13 + 0.004 * step, 4 - 0.002 * step)) * self.scale
                           + self.offset)
        camera.SetFocalPoint(self.offset)
        camera.SetViewUp(0, 0, 1)
        camera.SetClippingRange(0.5 * self.scale, 150 * self.scale)

    def seen(self):
        picture = self.view.picture()
        texture = self.water.GetReflectionPass().GetReflectionTexture()
        return picture, looked_up(self.view, self.water) * (texture.GetWidth(), texture.GetHeight())


def compare(name, scene, right, mask):
    picture, places = scene.seen()
    shift = np.linalg.norm(places - right[1], axis=1)[mask]
    wt.check_at_most(f"{name}: px that a reflection shifts by, 99.9 %", round(float(np.percentile(shift, 99.9)), 3),
                     SHIFT)
    wt.check_at_most(f"{name}: % of reflections shifted by more", round(float((shift > SHIFT).mean() * 100), 3), EDGES)
    wt.check_at_most(f"{name}: % of pixels off by more than 1/255",
                     round(float((np.abs(picture - right[0]).max(axis=2) > 1).mean() * 100), 3), EDGES)


class AtOrigin:
    """The scene at the origin, in three places of the camera: what the others must look like."""

    def __init__(self, name):
        self.name, self.waves = name, WAVES[name]
        scene = Scene(waves=self.waves)
        self.steps = []
        for step in range(3):
            scene.look(step)
            self.steps.append(scene.seen())
        self.mask = wt.water_mask(scene.view, scene.water).ravel()


@pytest.fixture(scope="module", params=WAVES)
def origin(request):
    return AtOrigin(request.param)


def test_most_of_the_picture_is_water(origin):
    """Most of the compared picture is water."""
    wt.check_at_least(f"{origin.name}: pixels of water", int(origin.mask.sum()), 50000)


@pytest.mark.parametrize("distance", [1e5, 5e6, 1e7], ids="{:g}_m".format)
def test_far_from_the_origin_nothing_shifts(origin, distance):
    """Far from the origin water looks as it does there, also while the camera moves."""
    far = Scene((distance, 0.8 * distance, 1e-5 * distance), waves=origin.waves)
    for step, right in enumerate(origin.steps):
        far.look(step)
        compare(f"{origin.name} at {distance:g} m, step {step}", far, right, origin.mask)


@pytest.mark.parametrize("scale", [1e-6, 1e6], ids="{:g}".format)
def test_a_scaled_scene_looks_the_same(origin, scale):
    """A scene a million times smaller or larger looks the same."""
    compare(f"{origin.name}, scale {scale:g}", Scene(scale=scale, waves=origin.waves), origin.steps[0], origin.mask)


@pytest.mark.parametrize("mode", MODES, ids=MODES.get)
def test_shifted_buffers_look_the_same(origin, mode):
    """Far from the origin water looks as it does there with each way of VTK's to shift and scale its buffers."""
    scene = Scene((1e7, 8e6, 0), waves=origin.waves, mode=mode)
    compare(f"{origin.name} at 1e7 m, {MODES[mode]}", scene, origin.steps[0], origin.mask)


def phase_late(length, phase):
    """The phase of a wave at the late time, in degrees."""
    omega = (Decimal("9.80665") * 2 * PI / Decimal(length)).sqrt()
    turns = Decimal(phase) / 360 - omega * LATE / (2 * PI)
    return float((turns - turns.to_integral_value()) * 360)


def test_late_waves_have_the_phase_of_50_digits():
    """A wave after 1e9 s is one that has the phase which 50 digits give."""
    late = Scene(waves=POSTS_WAVES)
    late.water.SetTime(LATE)
    right = Scene(waves=[(a, length, d, phase_late(length, phase)) for a, length, d, phase in POSTS_WAVES])
    mask = wt.water_mask(right.view, right.water).ravel()
    compare("after 1e9 s", late, right.seen(), mask)

# SPDX-License-Identifier: BSD-3-Clause
"""Caustics have the light that photons bring, counted: none is lost, and it lies where it is gathered."""

import caustics_truth as truth
import numpy as np
import pytest
import water_test as wt

PHOTONS = 6_000_000
WAVES = ((0.03, 3.0, 165.0, 10.0), (0.012, 1.5, 215.0, 50.0))  # whose light pixels of the small picture resolve


def check_light(scene, name):
    view, look = truth.view_of(scene)
    light = truth.shown(view, look)
    expected = truth.truth(scene, view, PHOTONS)
    mean, rmse = truth.errors(light, expected)
    wt.check_at_least(f"{name}: contrast of the truth", float(expected.std()), 0.03)
    wt.check_at_most(f"{name}: error of the mean light", abs(mean), 0.02)
    wt.check_at_most(f"{name}: error over the mean", rmse, 0.10)


@pytest.mark.parametrize("depth, sun", ((1.0, 90.0), (1.0, 25.0), (3.0, 50.0), (8.0, 90.0)))
def test_light_is_that_of_photons(depth, sun):
    """On level beds of several depths, under high suns and low ones, the light is that of photons."""
    check_light(truth.Scene(WAVES, depth, sun, size=(160, 120), width=6.0),
                f"bed at {depth:g} m, sun at {sun:g} degrees")


@pytest.mark.parametrize("hardware", (False, True), ids=("software", "hardware"))
@pytest.mark.parametrize("depth, sun", ((1.0, 50.0), (3.0, 50.0), (3.0, 25.0)))
def test_an_eye_behind_a_dome_port_sees_the_light_of_photons(depth, sun, hardware, monkeypatch):
    """An eye close over the water that sees the bed through its dome port sees the same light as others."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "0" if hardware else "1")
    check_light(truth.Scene(WAVES, depth, sun, size=(160, 120), width=2.5 * depth, eye=35.0, port=0.3),
                f"through a port, bed at {depth:g} m, sun at {sun:g} degrees")


@pytest.mark.parametrize("eye", (90.0, 45.0, 20.0))
def test_calm_light_is_even(eye):
    """Waves without a height gather no light, up to the picture's borders and to the horizon."""
    scene = truth.Scene(((1e-7, 3.0, 0.0, 0.0),), 3.0, 50.0, width=10.0, eye=eye)
    view, look = truth.view_of(scene)
    light = truth.shown(view, look)
    wt.check_at_most(f"eye at {eye:g} degrees: largest error", float(np.abs(light - 1).max()), 0.04)
    wt.check_at_most(f"eye at {eye:g} degrees: error of the mean", abs(float(light.mean()) - 1), 0.01)


def test_light_stands_still_where_things_stand_on_the_bed():
    """A thing on the bed changes nothing beside it: no halo, no seam."""
    scene = truth.Scene(WAVES, 3.0, 50.0, size=(240, 180), width=8.0, eye=60.0)
    view, look = truth.view_of(scene)
    before = truth.shown(view, look)
    wt.add_actor(view.renderer, wt.box((0, 0, -2.7), (0.6, 0.6, 0.6)), (truth.GREY,) * 3, lit=False)
    after = truth.shown(view, look)
    apart = np.abs(after - before) > 0.06
    rows, columns = np.nonzero(apart)
    wt.check_at_least("thing on the bed: pixels that it changes", len(rows), 50)
    far = np.hypot(columns - np.median(columns), rows - np.median(rows)) > 40
    wt.check_at_most("thing on the bed: pixels that change far from it", int(far.sum()), 20)


def light_to_the_border(bed):
    """Light on a level bed of that half width under a sheet of 6 m, seen from 20 degrees up to the sheet's far border."""
    view = wt.View((160, 120), (0, 0, 0))
    wt.add_actor(view.renderer, wt.box((0, 0, -2.0), (2 * bed, 2 * bed, 1)), (truth.GREY,) * 3, lit=False)
    wt.add_scene_light(view.renderer, tuple(1000 * truth.Scene(WAVES, 1.5, 50.0).sun_direction()))
    water = wt.add_water(view.renderer, None, (-6, 6, -6, 6), 0.0)
    look = water.GetWaterProperty()
    look.RefractionOn()
    look.SetAbsorption(0, 0, 0)
    look.SetScattering(0, 0, 0)
    look.GlitterOff()
    for wave in WAVES:
        look.AddWave(*wave)
    wt.place_camera(view.renderer, (0, -12, 6), (0, 3, 0), (0.1, 100))
    is_seen = view.picture()[:, :, 0] > 0
    return truth.shown(view, look), is_seen


def test_light_goes_on_under_the_border():
    """Where rays leave the water under its border, the bed is lit as if it went on: no stripes, and no seam."""
    ends, is_seen = light_to_the_border(6.0)
    goes_on, _ = light_to_the_border(30.0)
    wt.check_at_least("contrast of the light", float(goes_on[is_seen].std()), 0.05)
    rows = [float(np.abs(ends - goes_on)[row][is_seen[row]].mean()) for row in np.nonzero(is_seen.sum(axis=1) > 40)[0]]
    wt.check_at_most("difference in a row of the picture", max(rows), 0.04)


def test_light_is_a_function_of_time():
    """A time that is drawn again shows the same picture, whatever was drawn meanwhile."""
    scene = truth.Scene(WAVES, 3.0, 50.0, size=(160, 120))
    view, look = truth.view_of(scene)
    look.SetCaustics(1.0)
    water = next(a for a in view.renderer.GetActors() if a.IsA("vtkWaterActor"))
    water.SetTime(2.0)
    first = view.picture()
    water.SetTime(9.0)
    wt.check_at_least("another time: differing values", int((view.picture() != first).sum()), 1000)
    water.SetTime(2.0)
    wt.check_equal("the same time again: differing values", int((view.picture() != first).sum()), 0)


def grid_strength(light):
    """Power of the strongest period of 2.4 to 16 pixels in where the light bends, over the median of all: tens in
    light without a grid, thousands with blocks, whether they are even or interpolated."""
    strongest = 0.0
    for lines in (light, light.T):
        bends = np.abs(lines[:, 2:] - 2 * lines[:, 1:-1] + lines[:, :-2]).mean(axis=0)
        around = np.convolve(np.pad(bends, 16, mode="edge"), np.ones(33) / 33, "valid")
        power = np.abs(np.fft.rfft((bends / around - 1) * np.hanning(len(bends)))) ** 2
        frequency = np.fft.rfftfreq(len(bends))
        power = power[(frequency > 1 / 16) & (frequency < 1 / 2.4)]
        strongest = max(strongest, power.max() / np.median(power))
    return strongest


def in_blocks(light, side):
    """The same light from texels of so many pixels, linear between their middles."""
    rows, columns = light.shape[0] // side, light.shape[1] // side
    light = light[:rows * side, :columns * side].reshape(rows, side, columns, side).mean(axis=(1, 3))
    for count in (columns, rows):
        at = (np.arange(count * side) + 0.5) / side - 0.5
        light = np.array([np.interp(at, np.arange(count), line) for line in light]).T
    return light


@pytest.mark.parametrize("depth, sun, eye, width", ((1.0, 50.0, 90.0, 4.0), (3.0, 25.0, 90.0, 8.0), (8.0, 50.0, 90.0, 12.0),
                                                    (3.0, 50.0, 45.0, 8.0)))
def test_no_block_is_seen(depth, sun, eye, width):
    """Nothing coarser than two pixels is visible as a block."""
    scene = truth.Scene(truth.COVE, depth, sun, size=(320, 240), width=width, eye=eye)
    light = truth.shown(*truth.view_of(scene))
    name = f"bed at {depth:g} m, sun at {sun:g} degrees, eye at {eye:g}"
    wt.check_at_most(f"{name}: strength of a grid", grid_strength(light), 300.0)
    wt.check_at_least(f"{name}: the same of blocks of 3 pixels", grid_strength(in_blocks(light, 3)), 2000.0)

# SPDX-License-Identifier: BSD-3-Clause
"""The shader for hardware, which reads in batches, shows what the one for software renderers shows, in all kinds of
water, views and outputs."""

import numpy as np
import pytest
import wave_scenes
import water_test as wt
from vtkmodules.util.misc import calldata_type
from vtkmodules.vtkCommonCore import VTK_OBJECT

SIZE = (240, 180)
VIEWS = {"middle": (2, -13, 4), "low": (3, -12, 1.2), "high": (1, -9, 9), "near": (1, -4, 0.8), "far": (5, -45, 5),
         "below": (1, -6, -1.0)}
LONG = ((0.0127, 2.0, 20.0, 10.0), (0.0064, 1.2, 80.0, 200.0), (0.0032, 0.75, 140.0, 90.0))
SHORT = ((0.0012, 0.12, 20, 10), (0.001, 0.1, 80, 10), (0.0011, 0.11, 130, 10))


def add_waves(look, waves=LONG):
    for wave in waves:
        look.AddWave(*wave)


def sines(look):
    add_waves(look)


def short_sines(look):
    add_waves(look, SHORT)


def steep(look):
    add_waves(look)
    look.SetSlopeVariance(0.01, 0.006, 30.0)


def sea(look):
    look.SetSea(True)
    look.SetWindSpeed(5)
    look.SetSeaTileSize(64)


def normal_maps(look):
    from TestWaterNormalMaps import LAYERS, normal_map, texture_of
    for size, speed, direction, strength in LAYERS:
        look.AddNormalMap(texture_of(normal_map()), size, speed, direction, strength)


def displaced(look):
    look.AddWave(0.15, 5.0, 20.0, 10.0)
    look.AddWave(0.05, 2.2, 80.0, 60.0)
    look.WaveGeometryOn()
    look.SetWaveGridSize(96)


def clear(look):
    add_waves(look)
    look.RefractionOn()
    look.SetAbsorption(0.5, 0.2, 0.1)
    look.SetScattering(0.02, 0.02, 0.02)
    look.SetCaustics(1.0)


def clear_and_calm(look):
    look.RefractionOn()
    look.SetAbsorption(0.5, 0.2, 0.1)
    look.SetScattering(0.02, 0.03, 0.03)


def shadows(look):
    add_waves(look, SHORT)
    look.SetSlopeVariance(0.01, 0.01)
    look.ShadowsOn()
    look.SetFoamDepth(1.0)


def many_steps(look):
    add_waves(look)
    look.SetRayTraceSteps(37)
    look.SetRayTraceProbes(13)


def few_steps(look):
    add_waves(look)
    look.SetRayTraceSteps(3)
    look.SetRayTraceProbes(1)


def lake(look):
    look.SetPreset("lake")
    look.SetSeaTileSize(64)


def ocean(look):
    look.SetPreset("ocean wind 5")
    look.SetSeaTileSize(64)


def pool(look):
    look.SetPreset("pool")


# Share of pixels that may differ by more than 1 of 255: a tile's looks and the looks at a bed are fewer, rays of
# reflections end in the same place. Where looks at a tile differ, so do the edges between facets.
SAME = 0.00003
CLOSE = 0.002
GRAZING = 0.01  # far waves that are seen through: software renderers go on where a ray passes close over the bed
SEEN_THROUGH = (clear, clear_and_calm, lake, ocean, pool)
WATERS = (sines, short_sines, steep, sea, normal_maps, displaced, clear, clear_and_calm, shadows, many_steps, few_steps,
          lake, ocean, pool)


def made_of(set_look, translucent=False, samples=0, parallel=False):
    view = wt.View(SIZE, (0.55, 0.7, 0.9), samples)
    if set_look in SEEN_THROUGH:
        # nothing that hides the bed, which software renderers alone pass: spheres over the horizon
        for x in range(-40, 41, 4):
            wt.add_actor(view.renderer, wt.sphere((x, 25, 12), 1.5), (0.6 + 0.01 * x, 0.4, 0.2))
    for thing in () if set_look in SEEN_THROUGH else wave_scenes.posts():
        if isinstance(thing, wave_scenes.ray_caster.Box):
            data = wt.box(0.5 * (thing.low + thing.high), thing.high - thing.low)
        else:
            data = wt.sphere(thing.center, thing.radius, 48)
        wt.add_actor(view.renderer, data, thing.color)
    width = 600 if set_look in SEEN_THROUGH else 60
    wt.add_actor(view.renderer, wt.box((0, 0, -2.5), (width, width, 1)), (0.8, 0.7, 0.5))  # the bed
    if translucent:
        wt.add_actor(view.renderer, wt.box((0, 3, 1.5), (7, 0.2, 2.5)), (0.8, 0.2, 0.2), opacity=0.4)
    wt.add_scene_light(view.renderer, (0.3, 0.6, 0.55))
    water = wt.add_water(view.renderer, None, (-60, 60, -60, 60), None)
    set_look(water.GetWaterProperty())
    water.GetWaterProperty().SetRayTraceRays(1)  # several are for software renderers alone
    camera = view.renderer.GetActiveCamera()
    camera.SetParallelProjection(parallel)
    camera.SetParallelScale(4)
    return view, water


def pictures(is_software, monkeypatch, set_look, positions, output="Color", **more):
    """Of one scene from several places: the shaders are built once."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    view, water = made_of(set_look, **more)
    getattr(water.GetWaterProperty(), f"SetOutputTo{output}")()
    wt.place_camera(view.renderer, next(iter(positions)), (0, 0, 0), (0.3, 200))
    water.SetTime(0.0)
    view.picture()  # the first picture below uses its mirrored view again
    water.SetTime(0.7)
    made = []
    for position in positions:
        wt.place_camera(view.renderer, position, (0, 0, 0), (0.3, 200))
        made.append(view.picture())
    return made


def compare(monkeypatch, title, limit, set_look, position, **more):
    one, = pictures(1, monkeypatch, set_look, [position], **more)
    other, = pictures(0, monkeypatch, set_look, [position], **more)
    judge(title, limit, one, other)


def judge(title, limit, one, other):
    error = np.abs(one - other).max(axis=2)
    wt.check_at_least(f"{title}: colours of the picture", wt.count_colors(one), 20)
    wt.check_at_most(f"{title}: share of pixels that differ by more than 1 of 255", float((error > 1).mean()), limit)


@pytest.mark.parametrize("set_look", WATERS, ids=lambda look: look.__name__)
def test_hardware_shows_the_same(set_look, monkeypatch):
    """Each kind of water looks the same from above, near, far and below."""
    ones = pictures(1, monkeypatch, set_look, VIEWS.values())
    others = pictures(0, monkeypatch, set_look, VIEWS.values())
    for view, one, other in zip(VIEWS, ones, others):
        limit = CLOSE if set_look in (sea, normal_maps, *SEEN_THROUGH) else SAME
        limit = GRAZING if set_look in SEEN_THROUGH and view == "far" else limit
        judge(f"{set_look.__name__}, {view}", limit, one, other)


@pytest.mark.parametrize("output", ["Confidence", "Lookup", "Reflectance"])
@pytest.mark.parametrize("set_look", [steep, displaced], ids=lambda look: look.__name__)
def test_hardware_finds_the_same(set_look, output, monkeypatch):
    """Confidence, place of the lookup and reflectance are the same."""
    compare(monkeypatch, f"{set_look.__name__}, {output}", SAME, set_look, VIEWS["middle"], output=output)


@pytest.mark.parametrize("set_look, more", [
    (sines, {"translucent": True}), (shadows, {"translucent": True}), (short_sines, {"samples": 4}),
    (displaced, {"samples": 4}), (sines, {"parallel": True}), (shadows, {"parallel": True}),
], ids=lambda value: next(iter(value)) if isinstance(value, dict) else value.__name__)
def test_hardware_shows_the_same_among_other_things(set_look, more, monkeypatch):
    """With translucent things, with several samples a pixel and in parallel projection pictures are the same."""
    compare(monkeypatch, f"{set_look.__name__}, {next(iter(more))}", SAME, set_look, VIEWS["low"], **more)


@pytest.mark.parametrize("hardware", [False, True])
def test_each_has_its_own_shader(hardware, monkeypatch):
    """The surface's fragments are those for hardware where a GPU draws, and those for software elsewhere."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "0" if hardware else "1")
    view = wt.View(SIZE)
    water = wt.add_water(view.renderer, None, (-9, 9, -9, 9))
    add_waves(water.GetWaterProperty())
    sources = []

    @calldata_type(VTK_OBJECT)
    def keep(caller, event, program):
        sources.append(program.GetFragmentShader().GetSource())

    water.GetMapper().AddObserver("UpdateShaderEvent", keep)
    wt.place_camera(view.renderer, VIEWS["middle"], (0, 0, 0), (0.1, 100))
    view.picture()
    wt.check_equal("hardware's facets are in the shader", ["waterOneFacet" in text for text in sources[-1:]], [hardware])

# SPDX-License-Identifier: BSD-3-Clause
"""effects: what each effect of a water costs, on and off: caustics, foam, shadows, refraction, whitecaps and others."""

import os

import numpy as np
import scenes
import water_test as wt
from report import table
from timing import Frame, measure

SIZE = (800, 600)
ROUNDS, QUICK_ROUNDS = 30, 5
BUDGET_S, QUICK_BUDGET_S = 12.0, 2.0  # a pair
TILE = 128
KINDS = {"software": "1", "hardware": "0"}  # of shader; values of VTK_WATER_SOFTWARE
SUN = (-300.0, -120.0, 55.0)  # before the eye: it glitters, and land shades water
MOST_SHADOWS = 1.5  # a frame with the walk to the sun, over one without

TEXT = """
The terrain, $width x $height pixels, on this machine. Each effect is switched on and off in one
window, the frames in turns; only the time of the waves moves on, and for secondary reflections the
camera. What a water has beside the effect
is the same in both. "Hardware" is the shader for GPUs, drawn by the same renderer.

$tables
"""


def _waves(look):
    look.AddWave(0.10, 6.0, 20.0, 0.0)
    look.AddWave(0.04, 2.5, 80.0, 70.0)


def _clear(look):
    _waves(look)
    look.RefractionOn()


def _from_below(look):
    _clear(look)
    look.SetAbsorption(0.25, 0.06, 0.03)


def _foam_and_glitter(look):
    _clear(look)
    look.SetSlopeVariance(0.02, 0.02)
    look.SetFoamDepth(1.0)


def _sea(look):
    look.SetSea(True)
    look.SetWindSpeed(10)
    look.SetSeaTileSize(TILE)
    look.SetWhitecaps(False)
    look.SetWhitecapLifeTime(0.0)
    look.SetWaveGeometry(False)


def _white_sea(look):
    _sea(look)
    look.SetWhitecaps(True)


def _add_fall(scene):
    """Another water, whose plane leans over the first one, which reflects it."""
    wt.add_water(scene.renderer, wt.plane((24, 9, 0), (1, 0.7, -0.25)), (-7, 7, -1, 4), 0.7)


# effect: (what the water has beside it, the effect on or off)
EFFECTS = {
    "refraction": (_waves, lambda look, on: look.SetRefraction(on)),
    "caustics": (_clear, lambda look, on: look.SetCaustics(1.0 if on else 0.0)),
    "glitter": (lambda look: (_waves(look), look.SetSlopeVariance(0.02, 0.02)), lambda look, on: look.SetGlitter(on)),
    "foam": (_clear, lambda look, on: look.SetFoamDepth(1.0 if on else 0.0)),
    "shadows": (_foam_and_glitter, lambda look, on: look.SetShadows(on)),
    "whitecaps": (_sea, lambda look, on: look.SetWhitecaps(on)),
    "life time of whitecaps": (_white_sea, lambda look, on: look.SetWhitecapLifeTime(3.5 if on else 0.0)),
    "displaced waves": (_waves, lambda look, on: look.SetWaveGeometry(on)),
    "light shafts": (_from_below, lambda look, on: look.SetLightShafts(1.0 if on else 0.0)),
    "dome port": (_clear, lambda look, on: look.SetDomePortRadius(10.0 if on else 0.0)),
}
SECONDARY = "secondary reflections"  # of the reflection, and not of the look
EYES = {"light shafts": (45.0, 17.6, -1.5)}  # else as in the terrain's scene


def _pair(name):
    kind = scenes.kinds(True)["terrain"]
    scene = scenes.Scene(kind, SIZE)
    wt.add_scene_light(scene.renderer, SUN)
    if name in EYES:
        scene.look(EYES[name], kind.target, kind.angle)
    prepare, switch = EFFECTS.get(name, (None, None))
    look = scene.water.GetWaterProperty()
    if name == SECONDARY:
        _add_fall(scene)
    else:
        prepare(look)

    def frame(is_on):
        def choose():
            if name == SECONDARY:
                scene.water.GetReflectionPass().SetSecondaryReflections(is_on)
                scene.renderer.GetActiveCamera().Azimuth(0.01)  # or the secondary view would be used again
            else:
                switch(look, is_on)

        return Frame("on" if is_on else "off", scene.window, scene.pass_time, choose)

    return scene, [frame(False), frame(True)]


def _measure(results, effect, kind):
    scene, frames = _pair(effect)
    pictures = []
    for frame in frames:
        frame.choose()
        pictures.append(scene.view.picture())
    changed = float((np.abs(pictures[1] - pictures[0]).max(axis=2) > 1).mean())
    results.check_at_least(f"{effect}, {kind}: share of pixels that it changes", changed, 0.0005)
    measure(frames, results.rounds(ROUNDS, QUICK_ROUNDS), QUICK_BUDGET_S if results.is_quick else BUDGET_S)
    off, on = frames
    ratio = on.median / off.median
    for frame in frames:
        results.row("effects", kind, f"{effect} {frame.name}", **frame.row, ratio=frame.median / off.median)
    if effect == "shadows" and kind == "software":
        results.check_at_most(f"{effect}, {kind}: on / off", ratio, MOST_SHADOWS)
    print(f"{effect}, {kind}: off {off} ms, on {on} ms, {ratio:.2f}", flush=True)
    return effect, str(off), str(on), f"{ratio:.2f}"


def run(results):
    kept = os.environ.get("VTK_WATER_SOFTWARE")
    tables = []
    for kind, value in KINDS.items():
        os.environ["VTK_WATER_SOFTWARE"] = value
        rows = [_measure(results, effect, kind) for effect in (*EFFECTS, SECONDARY)]
        tables.append(f"**{kind}**\n\n" + table(("effect", "off, ms", "on, ms", "on / off"), rows))
    if kept is None:
        del os.environ["VTK_WATER_SOFTWARE"]
    else:
        os.environ["VTK_WATER_SOFTWARE"] = kept
    results.add("Each effect, on and off", TEXT, width=SIZE[0], height=SIZE[1], tables="\n\n".join(tables))

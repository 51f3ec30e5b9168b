# SPDX-License-Identifier: BSD-3-Clause
"""confidence: what the module says about its reflections, against what the tracer knows."""

import numpy as np
import water_test as wt
import wave_scenes
from reference import Pixels
from report import table
from tracer import Tracer
from vtkwater import vtkWaterProperty

KINDS = {"hit": vtkWaterProperty.HIT, "sky": vtkWaterProperty.SKY, "off the texture": vtkWaterProperty.OFF_MAP,
         "hidden": vtkWaterProperty.HIDDEN, "downward": vtkWaterProperty.DOWNWARD}
BEHIND = 100  # a kind of the tracer alone: sky, but behind something on its way
LIMIT = 1.0  # % of the pixels

TEXT = """
The module reports for every pixel the reason for its colour (`SetOutputToConfidence`). The tracer classifies the same
reflected rays by the definitions in vtkWaterProperty.h: **downward**, the ray would meet the water again; **hit**, it
meets a surface that is visible in the mirrored view; **hidden**, it meets a surface that something else hides in the
mirrored view; **sky**, it meets nothing and rises above the highest object within the mirrored view; **off the
texture**, it leaves the mirrored view before meeting anything or rising above everything. Shares of the water's
pixels, three views together:

$shares

**Sky, behind** can be determined only by the tracer: the ray meets nothing, but passes behind an object in the
mirrored view. The mirrored view cannot tell whether the ray meets the back of that object, so "hidden" is the correct reason for the module to report, and the figures with limits count these pixels as hidden.

$matrices
"""


def _classify(pixels, tracer):
    sky = np.where(pixels.is_passing_behind(tracer), BEHIND, KINDS["sky"])
    kind = np.where(pixels.is_hit, np.where(pixels.is_seen, KINDS["hit"], KINDS["hidden"]), sky)
    kind = np.where(pixels.is_on_map, kind, KINDS["off the texture"])
    return np.where(pixels.is_downward, KINDS["downward"], kind)


def _both(scenes, waves, size):
    """What the tracer and the module say of all water pixels of some views."""
    right, said = [], []
    for made, water in scenes:
        made.picture()
        tracer = Tracer(made.renderer)
        pixels = Pixels(tracer, made, water, waves, size)
        mask = wt.water_mask(made, water).ravel() & pixels.is_water
        water.GetWaterProperty().SetOutputToConfidence()
        said.append(made.picture()[:, :, 0].ravel()[mask])
        right.append(_classify(pixels.only(mask), tracer))
    return np.concatenate(right), np.concatenate(said)


def _matrix(name, right, said):
    rows = [(f"**{kind}**", *(f"{100 * ((right == number) & (said == other)).mean():.2f}" for other in KINDS.values()))
            for kind, number in {**KINDS, "sky, behind": BEHIND}.items()]
    return f"{name}, % of the pixels; rows: the tracer, columns: the module\n\n" + table(("", *KINDS), rows)


def run(report):
    scenes = {}
    for slope in (0.05, 0.10):
        waves = wave_scenes.island_waves(slope)
        scenes[f"islands, slope {slope:.2f}"] = _both(
            [wave_scenes.island_scene(view, waves) for view in wave_scenes.ISLANDS_VIEWS], waves,
            wave_scenes.ISLANDS_SIZE)
    scenes["posts"] = _both([wave_scenes.post_scene(view) for view in wave_scenes.POSTS_VIEWS],
                            wave_scenes.POSTS_WAVES, wave_scenes.POSTS_SIZE)
    rows = []
    for name, (right, said) in scenes.items():
        for who, kinds in (("tracer", right), ("module", said)):
            shares = (100 * (kinds == number).mean() for number in (*KINDS.values(), BEHIND))
            rows.append((name, who, *(f"{share:.2f} %" for share in shares)))
            print(" | ".join(rows[-1]), flush=True)
        known = np.where(right == BEHIND, KINDS["hidden"], right)
        for kind, number in KINDS.items():
            apart = float((said == number).mean() - (known == number).mean())
            report.check_at_most(
                f"{name}: {kind}, pixels by which module and tracer differ, %", 100 * abs(apart), LIMIT, 2)
    report.add("Confidence", TEXT, shares=table(("scene", "", *KINDS, "sky, behind"), rows),
               matrices="\n\n".join(_matrix(name, *both) for name, both in scenes.items()))

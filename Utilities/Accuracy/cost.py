# SPDX-License-Identifier: BSD-3-Clause
"""cost: what the shading of the water costs, against the error that is left.

As Utilities/Benchmarks/BenchmarkLookup.cxx: the time of a lookup is that of a frame with the lake
less that of a frame with a puddle, in which the mirrored view is drawn just the same. Kinds of frames
take turns, in another random order in every round; the camera moves before every frame.
"""

import time

import numpy as np
import wave_scenes
from colour import PERFECT
from colour import measure as measure_colour
from report import plt, table

SIZE = (800, 600)
ROUNDS = 150
WARM_UP = 5
SEED = 20261121
PUDDLE = 0.01
# name in colour: settings
KINDS = {
    "calm lookup": ("LookupToFixedOffset", 0.0),
    "constant offset, best": ("LookupToFixedOffset", 0.25),
    "offset over depth, best": ("LookupToViewScaledOffset", 3.0),
    "ray traced, fast": ("RayTraceQualityToFast", 0.0),
    "ray traced, default": ("RayTraceQualityToDefault", 0.0),
    "ray traced, high": ("RayTraceQualityToHigh", 0.0),
}

TEXT = """
Shading time of the water alone, relative to the calm lookup on the same waves: medians of $rounds interleaved frames
of each kind, minus the frame with a puddle instead of the lake, $width x $height pixels, the middle view. The three
lookups without tracing run the same shader: their differences are noise. This is a software renderer; other renderers
have other ratios. The errors are those above, all views together.

$table

$plot
"""


class Frame:
    def __init__(self, setting, scale, is_puddle=False):
        self._made, water = wave_scenes.post_scene("middle", size=SIZE)
        look = water.GetWaterProperty()
        getattr(look, f"Set{setting}")()
        look.SetOffsetScale(scale)
        if is_puddle:
            water.SetSheetBounds(-PUDDLE, PUDDLE, -PUDDLE, PUDDLE)
        self.times = []

    def render(self):
        self._made.renderer.GetActiveCamera().Azimuth(0.1)
        begin = time.perf_counter()
        self._made.window.Render()
        self._made.window.WaitForCompletion()
        return time.perf_counter() - begin


def measure():
    """Time of each kind's shading over that of the calm lookup."""
    frames = {name: Frame(*settings) for name, settings in KINDS.items()}
    frames["puddle"] = Frame("LookupToFixedOffset", 0.0, is_puddle=True)
    order = list(frames.values())
    random = np.random.default_rng(SEED)
    for turn in range(-WARM_UP, ROUNDS):
        random.shuffle(order)
        for frame in order:
            took = frame.render()
            if turn >= 0:
                frame.times.append(took)
    medians = {name: float(np.median(frame.times)) for name, frame in frames.items()}
    calm = medians["calm lookup"] - medians["puddle"]
    return {name: (medians[name] - medians["puddle"]) / calm for name in KINDS}


def _plot(costs, errors):
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.8))
    for axis, number, what in zip(axes, (0, 1), ("RMSE of 255", "FLIP")):
        for (name, cost), marker in zip(costs.items(), "svDo^*"):
            axis.plot(cost, errors[name].together()[number], marker, markersize=8, linestyle="none", label=name,
                      color="C0" if name.startswith("ray") else "C1")
        axis.axhline(errors[PERFECT].together()[number], color="0.5", linestyle="--", linewidth=1, label=PERFECT)
        axis.set(xlabel="time of the shading / calm lookup's", ylabel=what, xlim=(0.5, None), ylim=(0, None))
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=4)
    return figure


def run(report):
    _, errors = measure_colour()
    costs = measure()
    rows = []
    for name, cost in costs.items():
        rmse, flip = errors[name].together()
        rows.append((name, f"{cost:.2f}", f"{rmse:.2f}", f"{flip:.4f}"))
        print(f"{name}: {cost:.2f} times the calm lookup's time, RMSE {rmse:.2f}, FLIP {flip:.4f}", flush=True)
    report.check_at_most("time of the shading, ray traced, default / calm lookup", costs["ray traced, default"], 2.2, 2)
    report.add("Error against cost", TEXT, rounds=ROUNDS, width=SIZE[0], height=SIZE[1],
               table=table(("lookup", "time", "RMSE of 255", "FLIP"), rows),
               plot=report.save(_plot(costs, errors), "cost", "Error against the time of the shading"))

# SPDX-License-Identifier: BSD-3-Clause
"""scaling: time against the number of props, the texture scale, the share of water in view."""

import kinds
import plots
import scenes
import water_test as wt
from timing import Frame, measure

SIZE = (800, 600)
ROUNDS, QUICK_ROUNDS = 15, 3
BUDGET_S, QUICK_BUDGET_S = 12.0, 0.5  # a point of a curve
COUNTS, QUICK_COUNTS = (1, 10, 100, 1000, 3000, 10_000), (10, 100, 1000)
SCALES, QUICK_SCALES = (2.0, 1.5, 1.0, 0.75, 0.5, 0.25, 0.125), (1.0, 0.5, 0.25)
EDGES, QUICK_EDGES = (-9, -5, -3, -1, 1, 3, 5, 60), (-4, 0, 60)  # of the water, in x
STEPS, QUICK_STEPS = (kinds.CALM, kinds.FIXED, kinds.TRACED), (kinds.CALM, kinds.TRACED)

TEXT = """
Props: those of the scene of 1,000 props, $width x $height pixels, moving camera. Scales: the terrain. Share of water:
1,000 props, with the water's edge moved through the picture. Lines: medians; bands: quartiles.

$props

$scales

$share
"""


def _steps(results):
    return QUICK_STEPS if results.is_quick else STEPS


def _times(results, scene, cases, name):
    """cases: (step or None, scale). The frames, by case."""

    def choose(step, scale):
        scene.water.SetVisibility(step is not None)
        if step:
            step.apply(scene.water, scale, {kinds.FIXED.formula: 0.2})

    frames = {
        (step, scale): Frame(
            step.name if step else "no water",
            scene.window,
            scene.step,
            lambda step=step, scale=scale: choose(step, scale),
        )
        for step, scale in cases
    }
    measure(
        list(frames.values()),
        results.rounds(ROUNDS, QUICK_ROUNDS),
        QUICK_BUDGET_S if results.is_quick else BUDGET_S,
        warm_up=0,
    )
    for (_, scale), frame in frames.items():
        results.row("scaling", name, frame.name, scale=scale, **frame.row)
    print(
        f"{name}: "
        + ", ".join(f"{frame.name}, {scale:g}: {frame} ms" for (_, scale), frame in frames.items()),
        flush=True,
    )
    return frames


def _add(series, x, frame):
    series.setdefault(frame.name, []).append((x, frame.median, *frame.quartiles))


def _by_props(results):
    series = {}
    for count in QUICK_COUNTS if results.is_quick else COUNTS:
        kind = scenes.kinds(True)["1,000 props"]
        kind = scenes.Kind(
            **{**vars(kind), "fill": scenes.make_props(count, 0.5 if count <= 1000 else 0.22)}
        )
        scene = scenes.Scene(kind, SIZE)
        for frame in _times(
            results,
            scene,
            [(None, 1.0), *((step, 1.0) for step in _steps(results))],
            f"{count} props",
        ).values():
            _add(series, count, frame)
    return plots.curves(series, "props", "frame, ms", is_log=True)


def _by_scale(results):
    scales = QUICK_SCALES if results.is_quick else SCALES
    scene = scenes.Scene(scenes.kinds(True)["terrain"], SIZE)
    frames = _times(
        results,
        scene,
        [(None, 1.0), *((step, scale) for step in _steps(results) for scale in scales)],
        "terrain",
    )
    series = {}
    for (step, scale), frame in frames.items():
        for x in (scale,) if step else (min(scales), max(scales)):
            _add(series, x, frame)
    return plots.curves(series, "texture scale", "frame, ms")


def _by_share(results):
    series = {}
    scene = scenes.Scene(scenes.kinds(True)["1,000 props"], SIZE)
    west, _, south, north = scene.kind.sheet
    for edge in QUICK_EDGES if results.is_quick else EDGES:
        scene.water.SetSheetBounds(west, edge, south, north)
        scene.water.VisibilityOn()
        scene.stand(0)
        share = 100 * float(wt.water_mask(scene.view, scene.water).mean())
        frames = _times(
            results,
            scene,
            [(None, 1.0), *((step, 1.0) for step in _steps(results))],
            f"{share:.0f} % water",
        )
        for frame in frames.values():
            _add(series, share, frame)
    return plots.curves(series, "% of the picture that is water", "frame, ms")


def run(results):
    shown = {}
    for name, make, alt in (
        ("props", _by_props, "Time against the number of props"),
        ("scales", _by_scale, "Time against the texture scale"),
        ("share", _by_share, "Time against the share of water in view"),
    ):
        shown[name] = results.save(make(results), name, alt)
    results.add("Scaling", TEXT, width=SIZE[0], height=SIZE[1], **shown)

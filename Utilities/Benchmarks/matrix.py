# SPDX-License-Identifier: BSD-3-Clause
"""matrix: for each scene, lookup, quality step and texture scale: time, what was drawn, errors."""

import errors
import instruments
import kinds
import plots
import scenes
from instruments import text
from report import table
from timing import Frame, measure

SIZE = (800, 600)
ERROR_SIZE, QUICK_ERROR_SIZE = (400, 304), (200, 152)
PLUME_SIZE = (200, 152)  # its truth has four times as many pixels along each axis
BUDGET_S, QUICK_BUDGET_S = 15.0, 2.0  # a scene
ROUNDS, QUICK_ROUNDS = 9, 5
MAIN = "terrain"  # the scene that has all steps in a quick run
SLOW = ("10,000 props", "plume")  # scenes that have calm water only in a quick run
UNTRACED = "10,000 props"  # the scene that has no errors then

TEXT = """
Times: $width x $height pixels, lit, water with Fresnel reflectance; all kinds of frames share one window, and one
uncounted frame follows each change. Errors: $error_width x $error_height pixels, unlit, perfectly reflecting water,
compared with the ray tracer at 16 rays per pixel. The plume, which the tracer does not support, is compared at
$plume_width x $plume_height with the scene and its explicit mirror image, rendered at 16 samples per pixel, for calm
water only. Calm water is compared with calm water, everything else with the waves. The offsets have the constant with
the smallest median error of the lookup, from a search that knows the truth. Lookup: median, and the error that 95 %
of the pixels do not exceed, in pixels of the picture.

$tables
"""


def _frames(kind, cases, constants):
    """Frames of one window, and the window: without water, and by step and scale."""
    scene = scenes.Scene(kind, SIZE)

    def choose(step=None, scale=1.0):
        scene.water.SetVisibility(step is not None)
        if step:
            step.apply(scene.water, scale, constants)

    plain = Frame("no water", scene.window, scene.step, choose)
    found = {
        (step, scale): Frame(
            f"{step.name}, {scale:g}",
            scene.window,
            scene.step,
            lambda step=step, scale=scale: choose(step, scale),
        )
        for step, scale in cases
    }
    return scene, plain, found


def _counts(scene, frame):
    """What the pass says of one more frame, which is not timed."""
    instruments.turn_on(scene.water)
    frame.choose()
    for turn in (1, 0):  # the last frame's view would be shown again if the camera stood still
        frame.render(turn)
    said = instruments.read(scene.water)
    instruments.turn_on(scene.water, False)
    return said


def _measure(results, kind):
    """Times without water, rows of a scene, and its reference."""
    cases = (
        kinds.quick_cases(kind.name == MAIN, kind.name in SLOW)
        if results.is_quick
        else kinds.cases()
    )
    size = QUICK_ERROR_SIZE if results.is_quick else ERROR_SIZE
    truth = None
    if not (results.is_quick and kind.name == UNTRACED):
        truth = errors.Reference(kind, size if kind.has_tracer else PLUME_SIZE)
    scene, plain, frames = _frames(kind, cases, truth.constants if truth else {})
    budget = QUICK_BUDGET_S if results.is_quick else BUDGET_S
    measure([plain, *frames.values()], results.rounds(ROUNDS, QUICK_ROUNDS), budget, warm_up=0)
    results.row("matrix", kind.name, "no water", **plain.row)
    print(f"{kind.name}: no water {plain} ms, {len(plain.times)} frames of each kind", flush=True)
    rows = []
    for (step, scale), frame in frames.items():
        rmse, flip, middle, most = truth.errors(step, scale) if truth else (errors.UNKNOWN,) * 4
        row = {
            **frame.row,
            "ratio": frame.median / plain.median,
            **_counts(scene, frame),
            "rmse": rmse,
            "flip": flip,
            "lookup_px": middle,
            "lookup_95_px": most,
        }
        results.row("matrix", kind.name, step.name, scale=scale, **row)
        rows.append((step, scale, frame, row))
        print(
            f"  {frame.name}: {frame} ms, {row['ratio']:.2f}; RMSE {rmse:.2f}, FLIP {flip:.4f}, "
            f"lookup {middle:.3f} px",
            flush=True,
        )
    return plain, rows, truth


def _table(plain, rows):
    cells = [("no water", "", str(plain), "1", *[""] * 6)]
    for step, scale, frame, row in rows:
        cells.append(
            (
                step.name,
                f"{scale:g}",
                str(frame),
                f"{row['ratio']:.2f}",
                text(row["props"]),
                text(row["fragments"]),
                text(row["rmse"], "{:.2f}"),
                text(row["flip"], "{:.4f}"),
                text(row["lookup_px"], "{:.3f}"),
                text(row["lookup_95_px"], "{:.2f}"),
            )
        )
    return table(
        (
            "kind",
            "scale",
            "frame, ms",
            "/ no water",
            "props",
            "fragments",
            "RMSE of 255",
            "FLIP",
            "lookup, px",
            "95 %",
        ),
        cells,
    )


def _classics(results, kind, rows, truth):
    """(formula, who, RMSE, FLIP, ratio of time); what the module lacks costs a fixed offset."""
    ratios = {
        step.formula: row["ratio"] for step, scale, _, row in rows if scale == 1 and step.formula
    }
    found = []
    for name, who, rmse, flip, middle in truth.classics():
        ratio = ratios.get(name, ratios.get(kinds.FIXED.formula))
        found.append((name, who, rmse, flip, ratio))
        results.row(
            "matrix",
            kind.name,
            f"{name}: {who}",
            scale=1.0,
            ratio=ratio,
            rmse=rmse,
            flip=flip,
            lookup_px=middle,
        )
    return found


def run(results):
    tables = []
    for number, kind in enumerate(scenes.kinds(results.is_quick).values()):
        plain, rows, truth = _measure(results, kind)
        tables.append(
            f"### {kind.name.capitalize()}\n"
            f"{kind.text[0].upper()}{kind.text[1:]}.\n\n{_table(plain, rows)}"
        )
        if not truth:
            continue
        tables.append(
            results.save(
                plots.pictures(truth),
                f"scene-{number}",
                f"{kind.name}: reference and picture",
                has_pictures=True,
            )
        )
        if kind.has_tracer and (not results.is_quick or kind.name == MAIN):
            front = plots.pareto(rows, _classics(results, kind, rows, truth))
            tables.append(
                results.save(front, f"pareto-{number}", f"{kind.name}: error against time")
            )
            tables.append(plots.PARETO_TEXT)
    size = QUICK_ERROR_SIZE if results.is_quick else ERROR_SIZE
    results.add(
        "Time against error",
        TEXT,
        width=SIZE[0],
        height=SIZE[1],
        error_width=size[0],
        error_height=size[1],
        plume_width=PLUME_SIZE[0],
        plume_height=PLUME_SIZE[1],
        tables="\n\n".join(tables),
    )

# SPDX-License-Identifier: BSD-3-Clause
"""gpu_limits: what water may cost on a GPU, as ratios, and whether the rows of gpu_frames keep to it."""

import gpu_data
from effect_scenes import LEAST_CHANGE
from gpu_kinds import CALM, FACING_AWAY, HALF, HIDDEN, LAKE, MOVING, OCEAN, OUT_OF_VIEW, SINES, TIME

# Frame with water / frame without; of data: a step as water / as VTK's plain surface.
FRAMES = {
    ("2 M", MOVING): {CALM: 1.5, SINES: 1.8, LAKE: 2.2, OCEAN: 2.2, OUT_OF_VIEW: 1.02, HIDDEN: 1.02,
                      FACING_AWAY: 1.02},
    ("2 M", TIME): {CALM: 1.03, HALF: 1.03, SINES: 1.3, LAKE: 1.6, OCEAN: 1.6},
    ("18 M", MOVING): {CALM: 1.4, SINES: 1.6, LAKE: 1.9, OCEAN: 1.9},
    ("1,000 props", MOVING): {CALM: 1.6, SINES: 1.8, LAKE: 2.1, OCEAN: 2.1},
    ("1,000 props", TIME): {CALM: 1.06, HALF: 1.06, SINES: 1.2, LAKE: 1.4, OCEAN: 1.4},
    ("data", gpu_data.STEPS): {gpu_data.COLOURED: 1.5, gpu_data.CLEAR: 1.5},
    ("data, threads", gpu_data.STEPS): {gpu_data.COLOURED: 1.5, gpu_data.CLEAR: 1.5},
}
# A kind / another one of the same scene and motion.
HALF_OVER_CALM = 1.0
CALM_OVER_SECOND_PASS = 1.0
SKIP = 1.03  # all skips / all but one
PIXELS = 0  # that unseen water changes
OK, FAILED = "ok", "NOT MET"


def _is_there(row):
    """An effect that changes no pixel is not the one that was to be measured."""
    return {"figure": f"{row['kind']}: share of pixels that it changes", "value": f"{row['changed']:.4f}",
            "limit": f">= {LEAST_CHANGE:g}", "verdict": OK if row["changed"] >= LEAST_CHANGE else FAILED}


def check(rows, is_quick=False):
    """Figures with their limits, as the report shows them. Times of a quick run are none."""
    found = []

    def add(figure, value, limit, digits=3):
        if value is not None:
            found.append({"figure": figure, "value": f"{value:.{digits}f}", "limit": f"<= {limit:g}",
                          "verdict": OK if value <= limit else FAILED})

    for row in rows:
        scene, motion, kind = row["scene"], row["motion"], row["kind"]
        title = f"{scene}, {motion}: {kind}"
        add(f"{title}: pixels that it changes", row.get("pixels"), PIXELS, 0)
        if row["section"] == "effects":
            found.append(_is_there(row))
        if is_quick:
            continue
        if row["section"] == "skips":
            if row["skip"]:
                add(f"{title}, with {row['skip']} / without", row["ratio"], SKIP)
            continue
        limit = FRAMES.get((scene, motion), {}).get(kind)
        if limit:
            add(f"{title} / {row['base']}", row["ratio"], limit)
        if motion == MOVING and kind == HALF:
            add(f"{title} / calm", row.get("over_calm"), HALF_OVER_CALM)
        if motion == MOVING and kind == CALM:
            add(f"{title} / second pass", row.get("over_second_pass"), CALM_OVER_SECOND_PASS)
    return found

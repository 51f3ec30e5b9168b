# SPDX-License-Identifier: BSD-3-Clause
"""effects: what each effect of a water costs, on and off: caustics, foam, shadows, refraction, whitecaps and others.

    script/benchmark --only effects     three minutes; the section goes into build/benchmark
    script/gpu benchmark --scenes effects   the same list on a machine with a GPU
"""

import os

from effect_scenes import EFFECTS, LEAST_CHANGE, measured
from tables import table

SIZE = (800, 600)
ROUNDS, QUICK_ROUNDS = 20, 4
BUDGET_S, QUICK_BUDGET_S = 3.0, 0.5  # a pair
KINDS = {"software": "1", "hardware": "0"}  # of shader; values of VTK_WATER_SOFTWARE
MOST_SHADOWS = 1.5  # a frame with them, over one without

TEXT = """
The terrain, $width x $height pixels. Each effect is switched on and off in one
window; frames with and without it take turns, and the camera and the time of the waves move on in every frame.
All other settings of the water are the same with and without the effect. "Under water" compares an eye below the surface with
one that sees no water, and "clear sky" includes the sky's own picture. "Hardware" is the shader for
GPUs, drawn by the same renderer.

$table
"""


def run(results):
    kept = os.environ.get("VTK_WATER_SOFTWARE")
    cells = {effect.name: [effect.name] for effect in EFFECTS}
    rounds, budget_s = results.rounds(ROUNDS, QUICK_ROUNDS), QUICK_BUDGET_S if results.is_quick else BUDGET_S
    for kind, value in KINDS.items():
        os.environ["VTK_WATER_SOFTWARE"] = value
        for effect in EFFECTS:
            found = measured(effect, SIZE, rounds, budget_s)
            results.check_at_least(f"{found.name}, {kind}: share of pixels that it changes", found.changed, LEAST_CHANGE)
            for frame in (found.off, found.on):
                results.row("effects", kind, f"{found.name} {frame.name}", **frame.row,
                            ratio=frame.median / found.off.median)
            if found.name == "shadows" and kind == "software":
                results.check_at_most(f"{found.name}, {kind}: on / off", found.ratio, MOST_SHADOWS)
            print(f"{found.name}, {kind}: off {found.off} ms, on {found.on} ms, {found.ratio:.2f}", flush=True)
            cells[found.name] += [str(found.off), str(found.on), f"{found.ratio:.2f}"]
    if kept is None:
        del os.environ["VTK_WATER_SOFTWARE"]
    else:
        os.environ["VTK_WATER_SOFTWARE"] = kept
    columns = [f"{kind}: {what}" for kind in KINDS for what in ("off, ms", "on, ms", "on / off")]
    results.add("Each effect, on and off", TEXT, width=SIZE[0], height=SIZE[1],
                table=table(("effect", *columns), cells.values()))

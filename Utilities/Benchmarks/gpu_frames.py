# SPDX-License-Identifier: BSD-3-Clause
"""gpu_frames: what water costs where a GPU is busy: large meshes, many props, large pictures.

    script/gpu benchmark                          all frames: some minutes
    script/gpu benchmark --skips                  and each skip against the same frame without it
    script/gpu benchmark --only-skips             the latter alone
    script/gpu benchmark --scenes '2 M' --kinds calm sines
    script/gpu benchmark --scenes effects         each effect of a water, on and off, without the rest
    script/gpu benchmark --quick                  small everything: does it run?

Writes benchmarks-gpu.json into $OUT or --folder; kept as Documentation/benchmarks-gpu.json, `gpu` puts
it into the report. Exit status 1: a limit was exceeded; those of a quick run are on pixels alone.

    gpu_scenes    what is drawn
    gpu_kinds     without water, with each water, and what a user could do in its place
    gpu_data      a solver's data, with new arrays in every frame
    effect_scenes each effect of a water, on and off; also those of script/benchmark
    gpu_rounds    frames that take turns
    gpu_clock     the GPU's own time
    gpu_rates     how much the GPU can draw
    gpu_limits    what is allowed
"""

import argparse
import json
import os
import pathlib
import sys
import time

PROJECT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(PROJECT / "Utilities" / "Accuracy"))  # driver
sys.path.append(str(PROJECT / "Testing" / "Python"))  # water_test

import effect_scenes  # noqa: E402  after their paths
import gpu_data  # noqa: E402
import gpu_kinds  # noqa: E402
import gpu_limits  # noqa: E402
import gpu_rates  # noqa: E402
import gpu_rounds  # noqa: E402
import gpu_scenes  # noqa: E402
import machine  # noqa: E402
import numpy as np  # noqa: E402
import water_test as wt  # noqa: E402
from gpu_clock import Clock  # noqa: E402
from gpu_kinds import CALM, COPIES, HALF, LAKE, MOVING, OCEAN, PLAIN, SECOND_PASS, SINES, TIME  # noqa: E402
from gpu_rounds import Shot  # noqa: E402
from vtkwater import vtkWaterReflectionPass  # noqa: E402

WATERS = (CALM, HALF, SINES, LAKE, OCEAN)
ALL = {MOVING: (PLAIN, SECOND_PASS, *WATERS), TIME: (PLAIN, *WATERS)}
FEW = {MOVING: (PLAIN, SECOND_PASS, CALM, HALF, SINES)}
SHOTS = {
    "2 M": {MOVING: (*ALL[MOVING], *gpu_kinds.OTHER_PRESETS, COPIES, *gpu_kinds.UNSEEN), TIME: ALL[TIME]},
    "18 M": {MOVING: ALL[MOVING]},
    "1,000 props": ALL,
    "data": {gpu_data.STEPS: gpu_data.KINDS},
    "data, threads": {gpu_data.STEPS: gpu_data.KINDS},
}
BASES = dict.fromkeys(("data", "data, threads"), gpu_data.SURFACE)  # what a scene's frames are compared with; the others': without water
SKIPPED = (CALM, SINES)
SKIPS = {
    MOVING: ("UNSEEN_WATER", "HIDDEN_WATER", "FAINT_WATER", "UNCHANGED_VIEWS", "SHARED_VIEWS", "PROPS", "PIECES",
             "PIXELS"),
    TIME: ("HIDDEN_WATER", "UNCHANGED_VIEWS"),  # the last one leaves the others nothing to do
}
ROUNDS, QUICK_ROUNDS = 100, 4
QUICK_BUDGET_S = 3.0  # of measuring a scene
BUDGET_S, BUDGETS_S = 20.0, {"1,000 props": 45.0, "data": 45.0, "data, threads": 45.0}  # what the processor does varies more
SKIP_BUDGETS_S = {"2 M": 22.0, "18 M": 30.0, "1,000 props": 60.0}
SHEET_WIDTH, SHEET_COLUMNS = 480, 3  # of a sheet of pictures: px of one, how many in a row
WAKE_S = 2.0  # of frames before a scene's first round: an idle GPU raises its clock only then
EFFECTS = "effects"  # in place of a scene
EFFECTS_TEXT = "the terrain, each effect of the water on and off"
EFFECT_ROUNDS, EFFECT_BUDGET_S, QUICK_EFFECT_BUDGET_S = 60, 1.5, 0.2  # a pair


def arguments_of():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    names = [*gpu_scenes.scenes(False), EFFECTS]
    parser.add_argument("--scenes", nargs="+", choices=names, default=names)
    parser.add_argument("--kinds", nargs="+", choices=[*gpu_kinds.TEXTS], help="beside what they are compared with")
    parser.add_argument("--rounds", type=int, help=f"at most; without it {ROUNDS}, or what the time allows")
    parser.add_argument("--budget", type=float, help="s of measuring a scene; it sets up longer")
    parser.add_argument("--skips", action="store_true", help="measure each skip, too")
    parser.add_argument("--only-skips", action="store_true", help="and nothing else")
    parser.add_argument("--quick", action="store_true", help="small scenes, few rounds: does it run?")
    parser.add_argument("--pictures", action="store_true", help="write a sheet of pictures a scene, too")
    parser.add_argument("--folder", type=pathlib.Path, default=os.environ.get("OUT") or
                        PROJECT / "build" / "benchmark")
    arguments = parser.parse_args()
    arguments.rounds = arguments.rounds or (QUICK_ROUNDS if arguments.quick else ROUNDS)
    arguments.budget = arguments.budget or (QUICK_BUDGET_S if arguments.quick else None)
    arguments.wake = 0.0 if arguments.quick else WAKE_S
    return arguments


def shots_of(scene, wanted):
    return [
        Shot(kind, motion)
        for motion, kinds in SHOTS.get(scene, FEW).items()
        for kind in kinds
        if kind == base_of(scene) or not wanted or kind in wanted
    ]


def base_of(scene):
    return BASES.get(scene, PLAIN)


def skip_shots(wanted):
    """(skip's name, shot) for calm water and sines; of no name: with all skips."""
    every = vtkWaterReflectionPass.SKIP_ALL
    return [
        (skip, Shot(kind, motion, every & ~int(getattr(vtkWaterReflectionPass, skip)) if skip else every))
        for motion, skips in SKIPS.items()
        for kind in SKIPPED
        if not wanted or kind in wanted
        for skip in ("", *skips)
    ]


def row_of(section, scene, shot, base):
    low, median, high = np.percentile(shot.times, (25, 50, 75))
    ratio_low, ratio, ratio_high = gpu_rounds.ratios(shot, base)
    return {
        "section": section,
        "scene": scene.name,
        "motion": shot.motion,
        "kind": shot.kind,
        "base": base.kind,
        "width": scene.size[0],
        "height": scene.size[1],
        "rounds": len(shot.times),
        "median_ms": median,
        "q1_ms": low,
        "q3_ms": high,
        "work_ms": float(np.median(shot.works)),
        "ratio": ratio,
        "ratio_q1": ratio_low,
        "ratio_q3": ratio_high,
        **{name: None if value != value else value for name, value in shot.said.items()},
    }


def say(row):
    name = f"{row['motion']}, {row['kind']}" + (f", {row['skip'] or 'all skips'}" if "skip" in row else "")
    extra = "".join(
        f"  {key[:-3]} {row[key]:.2f}"
        for key in ("work_ms", "gpu_ms", "gather_ms", "plan_ms", "reflection_ms", "surface_ms")
        if row.get(key) is not None
    )
    print(f"  {name:34} {row['median_ms']:8.2f} ms  {row['ratio']:.3f} ({row['ratio_q1']:.3f} to "
          f"{row['ratio_q3']:.3f}){extra}  {row.get('decision', '')}", flush=True)


def measure_frames(stage, arguments, clock):
    shots = shots_of(stage.scene.name, arguments.kinds)
    budget = arguments.budget or BUDGETS_S.get(stage.scene.name, BUDGET_S)
    gpu_rounds.measure(stage, shots, arguments.rounds, budget, arguments.wake)
    gpu_rounds.ask(stage, shots, clock)
    by_name = {(shot.motion, shot.kind): shot for shot in shots}
    for shot in shots:
        row = row_of("frames", stage.scene, shot, by_name[shot.motion, base_of(stage.scene.name)])
        for name, other in (("over_calm", CALM), ("over_second_pass", SECOND_PASS)):
            if (shot.motion, other) in by_name and other != shot.kind:
                row[name] = gpu_rounds.ratios(shot, by_name[shot.motion, other])[1]
        if shot.kind in gpu_kinds.UNSEEN:
            row["pixels"] = int((picture(stage, shot.kind) != picture(stage, PLAIN)).any(axis=2).sum())
        say(row)
        yield row


def measure_skips(stage, arguments):
    named = skip_shots(arguments.kinds)
    budget = arguments.budget or SKIP_BUDGETS_S[stage.scene.name]
    gpu_rounds.measure(stage, [shot for _, shot in named], arguments.rounds, budget, arguments.wake)
    for skip, shot in named:
        whole = next(other for name, other in named
                     if not name and (other.kind, other.motion) == (shot.kind, shot.motion))
        row = row_of("skips", stage.scene, shot, shot)
        row["skip"] = skip
        row["ratio_q1"], row["ratio"], row["ratio_q3"] = gpu_rounds.ratios(whole, shot)
        say(row)
        yield row


def measure_effects(arguments):
    size = gpu_scenes.QUICK_SIZE if arguments.quick else gpu_scenes.FULL_HD
    rounds = QUICK_ROUNDS if arguments.quick else EFFECT_ROUNDS
    budget_s = QUICK_EFFECT_BUDGET_S if arguments.quick else EFFECT_BUDGET_S
    for effect in effect_scenes.EFFECTS:
        found = effect_scenes.measured(effect, size, rounds, budget_s)
        ratios = np.array(found.on.times) / np.array(found.off.times)
        low, ratio, high = np.percentile(ratios, (25, 50, 75))
        yield {"section": EFFECTS, "scene": EFFECTS, "motion": MOVING, "kind": found.name, "base": "off",
               "width": size[0], "height": size[1], "rounds": len(ratios), "off_ms": found.off.median,
               "median_ms": found.on.median, "work_ms": found.on.work, "ratio": ratio, "ratio_q1": low,
               "ratio_q3": high, "changed": found.changed}


def picture(stage, name):
    kind = stage.choose(name)
    motion = next(iter(SHOTS.get(stage.scene.name, FEW)))
    for turn in range(gpu_rounds.SETTLING, -1, -1):
        kind.step(motion, turn)
        kind.bring()
        stage.window.Render()
    return stage.view.shown()


def save_pictures(stage, folder):
    """One sheet of small pictures, in the order of the kinds' names."""
    if stage.scene.tide:
        names = gpu_data.KINDS
    else:
        names = [name for name in gpu_kinds.TEXTS if name not in gpu_data.KINDS
                 and (name != COPIES or stage.scene.name == "2 M")]
    coarse = max(1, stage.scene.size[0] // SHEET_WIDTH)
    small = [picture(stage, name)[::coarse, ::coarse] for name in names]
    small += [np.zeros_like(small[0])] * (-len(small) % SHEET_COLUMNS)
    rows = [np.hstack(small[i:i + SHEET_COLUMNS]) for i in range(0, len(small), SHEET_COLUMNS)]
    wt.save(np.vstack(rows[::-1]), folder / f"{stage.scene.name.replace(' ', '-').replace(',', '')}.png")


def write(arguments, results):
    """After each scene: a run that is stopped has measured something, too."""
    path = arguments.folder / "benchmarks-gpu.json"
    path.write_text(json.dumps(results, indent=1, default=float) + "\n")


def main():
    arguments = arguments_of()
    arguments.folder = pathlib.Path(arguments.folder)
    arguments.folder.mkdir(parents=True, exist_ok=True)
    small = wt.View(gpu_scenes.QUICK_SIZE)
    small.window.Render()
    found = {**machine.describe(), "draws": gpu_rates.text_of(gpu_rates.measure(small.window))}
    print(*(f"{name}: {value}" for name, value in found.items()), sep="\n", flush=True)
    scenes, rows, limits = gpu_scenes.scenes(arguments.quick), [], []
    texts = {name: scene.text for name, scene in scenes.items()} | {EFFECTS: EFFECTS_TEXT}

    def keep():
        write(arguments, {"machine": found, "quick": arguments.quick, "scenes": texts, "kinds": gpu_kinds.TEXTS,
                          "limits": limits, "rows": rows})

    for name in arguments.scenes:
        begin = time.perf_counter()
        if name == EFFECTS:
            print(f"{name}: {EFFECTS_TEXT}", flush=True)
            for row in measure_effects(arguments):
                say(row)
                rows.append(row)
            limits = gpu_limits.check(rows, arguments.quick)
            keep()
            print(f"  {time.perf_counter() - begin:.0f} s", flush=True)
            continue
        print(f"{name}: {scenes[name].text}", flush=True)
        view = wt.View(scenes[name].size)
        view.renderer.DrawOff()
        stage = gpu_kinds.Stage(view, scenes[name])
        stage.choose(base_of(name)).step(MOVING, 0)
        view.window.Render()
        if not arguments.only_skips:
            rows += measure_frames(stage, arguments, Clock(view.window))
        if (arguments.skips or arguments.only_skips) and name in SKIP_BUDGETS_S:
            rows += measure_skips(stage, arguments)
        if arguments.pictures:
            save_pictures(stage, arguments.folder)
        stage.close()
        limits = gpu_limits.check(rows, arguments.quick)
        keep()
        print(f"  {time.perf_counter() - begin:.0f} s", flush=True)

    for limit in limits:
        print("{figure}: {value} (limit {limit}) {verdict}".format(**limit))
    return 1 if any(limit["verdict"] == gpu_limits.FAILED for limit in limits) else 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: BSD-3-Clause
"""first_frame: the first frame with water in view, beside the first frame of the scene itself.

    first_frame.py [--quick] [--folder FOLDER] [--scenes NAME...]

Both build shaders, upload meshes and allocate textures. The scene's is the first one of a fresh window with fresh
actors. The water's comes in another fresh window, when the scene with water out of view (behind the eye) has
settled; or without water, which is added then. Shaders are counted as the programs that OpenGL has. The drivers'
caches on disk are off, so that they are compiled. `script/gpu benchmark` runs it, and `script/benchmark` as a
section. Exit status 1: a limit was exceeded; times of a quick run are not judged.
"""

import os

os.environ.setdefault("MESA_SHADER_CACHE_DISABLE", "true")
os.environ.setdefault("__GL_SHADER_DISK_CACHE", "0")

import argparse  # noqa: E402  OpenGL's libraries read the environment as they are loaded
import ctypes  # noqa: E402
import json  # noqa: E402
import pathlib  # noqa: E402
import sys  # noqa: E402
import time  # noqa: E402

PROJECT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(PROJECT / "Utilities" / "Accuracy"))
sys.path.append(str(PROJECT / "Testing" / "Python"))

import gpu_clock  # noqa: E402
import gpu_kinds  # noqa: E402
import gpu_scenes  # noqa: E402
import numpy as np  # noqa: E402
import water_test as wt  # noqa: E402
from gpu_kinds import CALM, LAKE, PLAIN, SINES  # noqa: E402

SCENES = ("2 M", "1,000 props")
WATERS = (CALM, SINES, LAKE)
COMES, ADDED = "comes into view", "is added"
WAYS = (COMES, ADDED)
LIMIT = 1.5  # of COMES
ROUNDS, QUICK_ROUNDS = 5, 1
SETTLING = 4  # frames
PROGRAMS = 2000  # names of OpenGL's are small numbers

TEXT = """
The first frame with water in view, relative to the first frame of the scene itself, in new windows; medians of
$rounds. The programs are those that OpenGL has in addition after the frame: the shaders of props, built once for the
first water, and those of the water itself, its background and its visibility test.

$table
"""


class Programs:
    """Those of a window, which has rendered. None: nobody knows."""

    def __init__(self, window):
        self._window = window
        self._is_program = gpu_clock.find(window.GetClassName(), {"glIsProgram": (ctypes.c_uint,)},
                                          ctypes.c_ubyte).get("glIsProgram")

    def names(self):
        if not self._is_program:
            return None
        self._window.MakeCurrent()
        return {name for name in range(1, PROGRAMS) if self._is_program(name)}


def _timed(stage):
    begin = time.perf_counter()
    stage.window.Render()
    stage.window.WaitForCompletion()
    return 1000 * (time.perf_counter() - begin)


def _stage(scene):
    """Fresh window, actors and data."""
    view = wt.View(scene.size)
    view.renderer.DrawOff()
    return gpu_kinds.Stage(view, scene)


def scene_alone(scene):
    """(ms, programs)"""
    stage = _stage(scene)
    stage.choose(PLAIN).stand(0)
    took = _timed(stage)
    programs = Programs(stage.window).names()
    stage.close()
    stage.window.Finalize()
    return took, programs and len(programs)


def with_water(scene, name, way):
    """(ms, programs that it built)"""
    stage = _stage(scene)
    kind = stage.choose(name)
    renderer = kind.renderers[0]
    if way == ADDED:
        renderer.RemoveActor(kind.water)
    else:
        kind.water.SetSheetBounds(*gpu_scenes.behind_the_eye())
    kind.stand(0)
    for _ in range(SETTLING):
        stage.window.Render()
    programs = Programs(stage.window)
    before = programs.names()
    if way == ADDED:
        renderer.AddActor(kind.water)
    else:
        kind.water.SetSheetBounds(*gpu_scenes.SHEET)
    took = _timed(stage)
    built = None if before is None else len(programs.names() - before)
    stage.close()
    stage.window.Finalize()
    return took, built


def measure(scene, rounds):
    """Rows of a scene."""
    alone = [scene_alone(scene) for _ in range(rounds)]
    plain = float(np.median([took for took, _ in alone]))
    yield {"section": "first frame", "scene": scene.name, "way": "the scene itself", "kind": PLAIN, "ms": plain,
           "programs": alone[0][1]}
    for way in WAYS:
        for name in WATERS:
            found = [with_water(scene, name, way) for _ in range(rounds)]
            took = float(np.median([took for took, _ in found]))
            yield {"section": "first frame", "scene": scene.name, "way": way, "kind": name, "ms": took,
                   "programs": found[0][1], "ratio": took / plain}


def _say(row):
    ratio = f"{row['ratio']:6.2f}" if "ratio" in row else ""
    print(f"  {row['scene']:12} {row['way']:16} {row['kind']:9} {row['ms']:9.1f} ms {ratio}  "
          f"{row['programs']} programs", flush=True)


def _limited(rows):
    for row in rows:
        if row["way"] == COMES:
            yield f"{row['scene']}: {row['kind']} {row['way']} / first frame of the scene", row["ratio"]


def _rows(names, is_quick, rounds):
    scenes = gpu_scenes.scenes(is_quick)
    scene_alone(scenes["volume"] if is_quick else scenes[SCENES[0]])  # libraries, fonts
    for name in names:
        for row in measure(scenes[name], rounds):
            _say(row)
            yield row


def run(results):
    """As a section of `benchmark`."""
    from report import table

    rounds = results.rounds(ROUNDS, QUICK_ROUNDS)
    rows = list(_rows(SCENES, results.is_quick, rounds))
    for row in rows:
        results.row(row["section"], row["scene"], f"{row['kind']}, {row['way']}", ms=row["ms"],
                    ratio=row.get("ratio"), programs=row["programs"])
    for title, ratio in () if results.is_quick else _limited(rows):
        results.check_at_most(title, ratio, LIMIT)
    shown = [(row["scene"], row["way"], row["kind"], f"{row['ms']:.0f}", str(row["programs"]),
              f"{row['ratio']:.2f}" if "ratio" in row else "") for row in rows]
    results.add("First frames", TEXT, rounds=rounds,
                table=table(("scene", "water", "kind", "ms", "programs built", "ratio"), shown))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scenes", nargs="+", choices=SCENES, default=SCENES)
    parser.add_argument("--quick", action="store_true", help="small scenes, one round: does it run?")
    parser.add_argument("--rounds", type=int)
    parser.add_argument("--folder", type=pathlib.Path, default=os.environ.get("OUT") or PROJECT / "build" / "benchmark")
    arguments = parser.parse_args()
    rounds = arguments.rounds or (QUICK_ROUNDS if arguments.quick else ROUNDS)
    print("first frames", flush=True)
    rows = list(_rows(arguments.scenes, arguments.quick, rounds))
    folder = pathlib.Path(arguments.folder)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "first-frame.json").write_text(json.dumps(rows, indent=1) + "\n")
    is_over = False
    for title, ratio in () if arguments.quick else _limited(rows):
        is_over = is_over or ratio > LIMIT
        print(f"{title}: {ratio:.3f} (limit <= {LIMIT:g}) {'over' if ratio > LIMIT else 'ok'}")
    return 1 if is_over else 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: BSD-3-Clause
"""long_run: a camera flies over an animated flood for many frames. Memory, descriptors and the time of
a frame must stay where they are, and the last frame be, byte for byte, the first one.

    long_run.py [--frames 20000] [--size 160 120]

The first frame is rendered, then the flight, which ends where it began; before it a short one, in which
the driver compiles what it needs (llvmpipe's memory grows for some 120 frames of these). Prints a row for each tenth of
the run; ends with 1 when something has grown. Times are given, and judged only with --judge-time.

The driver's own memory grows, too, with what it draws: the same flight without water, in a process of its own, says how
much. What the water's grows by more is judged.
"""

import argparse
import math
import os
import pathlib
import resource
import subprocess
import sys
import time

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Testing" / "Python"))
import water_test as wt  # noqa: E402
from wave_scenes import POSTS_WAVES, post_scene  # noqa: E402

WARM_UP = 200  # frames
MEMORY_LIMIT = 16.0  # MB over the second half of the run, more than without water
TIME_LIMIT = 1.10  # median of the last tenth over that of the second


def parse():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--frames", type=int, default=20000)
    parser.add_argument("--size", type=int, nargs=2, default=(160, 120))
    parser.add_argument("--judge-time", action="store_true")
    parser.add_argument("--dry", action="store_true", help="without water; judges nothing")
    return parser.parse_known_args()[0]


def megabytes():
    pages = int(pathlib.Path("/proc/self/statm").read_text().split()[1])
    return pages * resource.getpagesize() / 2**20


def show(made, water, share):
    """The frame at a share of the flight; 0 and 1 are the same."""
    turn = 2 * math.pi * share
    camera = made.renderer.GetActiveCamera()
    camera.SetPosition(13 * math.sin(3 * turn), -13 * math.cos(3 * turn), 4 + 3 * math.sin(5 * turn))
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    water.SetLevel(0.8 * (1 - math.cos(turn)))  # the flood comes and goes
    water.SetTime(40 * (1 - math.cos(turn)))
    return made.picture()


def growth_of(rows):
    """MB over the second half of a run."""
    return round(rows[-1][0] - rows[len(rows) // 2][0], 1)


def dry_growth(wanted):
    """The same of a process that has no water."""
    command = [sys.executable, __file__, "--dry", "--frames", str(wanted.frames), "--size", *map(str, wanted.size)]
    said = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    print(said, end="", flush=True)
    return float(said.split()[-1])


def main():
    wanted = parse()
    dry = 0.0 if wanted.dry else dry_growth(wanted)
    made, water = post_scene("middle", POSTS_WAVES, size=tuple(wanted.size))
    look = water.GetWaterProperty()
    look.SetReflectanceModeToFresnel()
    look.RefractionOn()
    errors = wt.errors_of(water)
    if wanted.dry:
        made.renderer.RemoveActor(water)
    first = show(made, water, 0.0)
    for frame in range(WARM_UP):
        show(made, water, frame / WARM_UP)
    tenth = max(wanted.frames // 10, 1)
    times, rows = [], []
    for frame in range(1, wanted.frames + 1):
        begun = time.perf_counter()
        # the last one exactly: a cosine of 2 pi is 1, its sine is not 0
        last = show(made, water, 0.0 if frame == wanted.frames else frame / wanted.frames)
        times.append(time.perf_counter() - begun)
        if frame % tenth == 0:
            rows.append((megabytes(), len(os.listdir("/proc/self/fd")), 1000 * np.median(times[-tenth:])))
            print(f"{'dry, ' if wanted.dry else ''}frame {frame}: {rows[-1][0]:.1f} MB, {rows[-1][1]} descriptors, "
                  f"median {rows[-1][2]:.2f} ms", flush=True)
    if wanted.dry:
        print(f"without water, memory, MB over the second half: {growth_of(rows)}")
        return
    wt.check_equal("mirrored views", water.GetReflectionPass().GetNumberOfReflectionRenders() > wanted.frames // 2,
                   True)
    wt.check_equal("last frame, bytes unlike the first", int((last != first).sum()), 0)
    print(f"memory, MB over the second half: {growth_of(rows)}")
    wt.check_at_most("the same, more than without water", round(growth_of(rows) - dry, 1), MEMORY_LIMIT)
    wt.check_equal("descriptors grown by", rows[-1][1] - rows[0][1], 0)
    wt.check_equal("errors", errors, [])
    growth = rows[-1][2] / rows[1][2]
    if wanted.judge_time:
        wt.check_at_most("time of a frame, last tenth over second", round(growth, 3), TIME_LIMIT)
    else:
        print(f"time of a frame, last tenth over second: {growth:.3f}")
    wt.finish()


if __name__ == "__main__":
    main()

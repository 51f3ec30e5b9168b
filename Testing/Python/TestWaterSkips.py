# SPDX-License-Identifier: BSD-3-Clause
"""Skips never show: random walks of a camera and changes of a scene, picture by picture equal to those
with all skips off.

Another walk: TestWaterSkips.py -S <seed>; a longer one: -N <steps>, a multiple of the usual number.
"""

import argparse
import collections
import time

import numpy as np
import skip_changes
import skip_scenes
import water_test as wt
from vtkwater import vtkWaterReflectionPass as Pass

LARGEST_ERROR = 1  # of 255
DEFAULT_SEED = 1

# steps, kind of scene, samples per pixel of the window
WALKS = (
    (120, "levels", 0),
    (110, "one plane", 0),
    (30, "clear", 0),
    (15, "levels", 4),
    (15, "one plane", 8),
)
# what makes a skip likely is likelier
OFTEN = {"nothing": 4, "wall before the eye": 4, "camera creeps": 5, "wall leaves": 2, "camera behind a hill": 2,
         "camera orbits": 3, "camera under water": 3, "levels again": 3, "reflects next to nothing": 2,
         "environment": 3, "reflects nothing": 3, "culled below": 2}

DECISIONS = ("RENDERED", "REUSED", "WATER_OUT_OF_VIEW", "NO_REFLECTANCE", "STATIC_ENVIRONMENT", "EDGE_ON",
             "FACING_AWAY", "HIDDEN", "FAINT", "SHARED")
FATES = ("DRAWN", "INVISIBLE", "WATER_ITSELF", "MARKED_NOT_REFLECTED", "OVERLAY", "LABEL", "EMPTY", "BEHIND_PLANE",
         "OUT_OF_VIEW", "OUT_OF_WATER")


def walk(kind, samples, steps, random, decisions, fates, folder):
    both = [skip_scenes.Scene(kind, skips, samples) for skips in (Pass.SKIP_ALL, Pass.SKIP_NONE)]
    names = [name for name in skip_changes.CHANGES for _ in range(OFTEN.get(name, 1))]
    name = "the first picture"
    worst, masks = 0, 0
    views = both[0].record_views()
    for step in range(steps):
        pictures = [scene.picture() for scene in both]
        errors = np.abs(pictures[0] - pictures[1]).max(axis=2)
        worst = max(worst, int(errors.max()))
        masks += kind == "one plane" and samples == 0 and name.startswith("camera") and views == ["main", "mirrored"]
        views.clear()
        if errors.max() > LARGEST_ERROR:
            off = int((errors > LARGEST_ERROR).sum())
            y, x = np.argwhere(errors > LARGEST_ERROR)[0]
            print(f"  {kind}, {samples} samples, step {step}, {name}: {off} pixels off, by {errors.max()} at most, "
                  f"the first at ({x}, {y}); decisions {both[0].reasons()}", flush=True)
            for picture, skips in zip(pictures, ("skipping", "full")):
                wt.save(picture, folder / f"skips_{kind.replace(' ', '_')}_{samples}_{step}_{skips}.png")
        for water, decision in zip(both[0].waters, both[0].decisions()):
            decisions[decision] += 1
            if decision == Pass.RENDERED:
                for fate in range(Pass.NUMBER_OF_FATES):
                    fates[fate] += water.GetReflectionPass().GetFateCount(fate)
        name = names[random.integers(len(names))]
        numbers = skip_changes.numbers(random)
        for scene in both:
            skip_changes.CHANGES[name](scene, numbers)
    renders = [sum(water.GetReflectionPass().GetNumberOfReflectionRenders() for water in scene.waters) for scene in both]
    wt.check_at_most(f"{kind}, {samples} samples: largest error of {steps} pictures", worst, LARGEST_ERROR)
    wt.check_at_most(f"{kind}, {samples} samples: mirrored views, of {renders[1]} without skips", renders[0],
                     0.8 * renders[1])
    if kind == "one plane" and samples == 0:
        wt.check_at_least(f"{kind}: mirrored views that waited for what hides them", masks, 1)


parser = argparse.ArgumentParser()
parser.add_argument("-S", type=int, default=DEFAULT_SEED)
parser.add_argument("-N", type=float, default=1)
options = parser.parse_known_args()[0]
print("seed", options.S)
random = np.random.default_rng(options.S)
decisions, fates = collections.Counter(), collections.Counter()
for steps, kind, samples in WALKS:
    begun = time.monotonic()
    walk(kind, samples, int(steps * options.N), random, decisions, fates, wt.output_folder())
    print(f"  {time.monotonic() - begun:.1f} s")
usual = options.S == DEFAULT_SEED  # other walks need not come by everything
for name in DECISIONS if usual else ():
    wt.check_at_least(f"decision {name}: times", decisions[getattr(Pass, name)], 1)
for name in FATES if usual else ():
    wt.check_at_least(f"fate {name}: times", fates[getattr(Pass, name)], 1)
wt.finish()

# SPDX-License-Identifier: BSD-3-Clause
"""Skips never show: random walks of a camera and changes of a scene, picture by picture equal to those
with all skips off.

The environment may ask for other walks: WATER_SKIPS_SEED, a number; and for longer ones: WATER_SKIPS_LENGTH, a
multiple of all steps of the walks. Without it most of them are taken, and a third where another VTK takes most of them
(WATER_TESTS_ONCE=0).
"""

import collections
import functools
import os
import time

import numpy as np
import pytest
import skip_changes
import skip_scenes
import water_test as wt
from vtkwater import vtkWaterReflectionPass as Pass

LARGEST_ERROR = 0
USUAL_SEED = 1
SEED = int(os.environ.get("WATER_SKIPS_SEED", USUAL_SEED))
IS_WHOLE = os.environ.get("WATER_TESTS_ONCE") != "0"
LENGTH = float(os.environ.get("WATER_SKIPS_LENGTH", 1))
SHARE = 1.0 if "WATER_SKIPS_LENGTH" in os.environ else 0.75 if IS_WHOLE else 1 / 3  # of the steps, from the first on

# kind of scene, samples per pixel of the window: steps
WALKS = {
    ("levels", 0): 120,
    ("one plane", 0): 110,
    ("clear", 0): 30,
    ("levels", 4): 15,
    ("one plane", 8): 15,
    ("fall", 0): 25,
    ("fall", 4): 3,
}
# what makes a skip likely is likelier
OFTEN = {"nothing": 4, "wall before the eye": 4, "camera creeps": 5, "wall leaves": 2, "camera behind a hill": 2,
         "camera orbits": 3, "camera under water": 3, "levels again": 3, "reflects next to nothing": 2,
         "environment": 3, "reflects nothing": 3, "culled below": 2}

SINGLE_SKIPS = {name: getattr(Pass, name) for name in (
    "UNSEEN_WATER", "HIDDEN_WATER", "FAINT_WATER", "UNCHANGED_VIEWS", "SHARED_VIEWS", "PROPS", "PIECES", "PIXELS")}
DECISIONS = ("RENDERED", "REUSED", "WATER_OUT_OF_VIEW", "NO_REFLECTANCE", "STATIC_ENVIRONMENT", "EDGE_ON",
             "FACING_AWAY", "HIDDEN", "SHARED")
FATES = ("DRAWN", "INVISIBLE", "WATER_ITSELF", "MARKED_NOT_REFLECTED", "OVERLAY", "LABEL", "EMPTY", "BEHIND_PLANE",
         "OUT_OF_VIEW", "OUT_OF_WATER")


class Walked:
    """What came of a walk."""

    def __init__(self, steps):
        self.steps = steps
        self.largest_error = 0
        self.waiting = 0  # mirrored views that waited for what hides them
        self.decisions, self.fates = collections.Counter(), collections.Counter()
        self.renders = 0, 0  # with all skips, with none


def changes_of(kind, samples):
    """The names and the numbers of a walk's changes: one sequence of random numbers serves all walks in turn."""
    names = [name for name in skip_changes.CHANGES for _ in range(OFTEN.get(name, 1))]
    random = np.random.default_rng(SEED)
    for walk, steps in WALKS.items():
        changes = [(names[random.integers(len(names))], skip_changes.numbers(random))
                   for _ in range(int(steps * LENGTH))]
        if walk == (kind, samples):
            return changes[:int(SHARE * len(changes))]


@functools.lru_cache(maxsize=None)
def walk(kind, samples):
    """Walks, and compares picture by picture; what differs is printed and saved."""
    print("seed", SEED)
    begun = time.monotonic()
    changes = changes_of(kind, samples)
    walked = Walked(len(changes))
    both = [skip_scenes.Scene(kind, skips, samples) for skips in (Pass.SKIP_ALL, Pass.SKIP_NONE)]
    name = "the first picture"
    views = both[0].record_views()
    for step, (next_name, numbers) in enumerate(changes):
        pictures = [scene.picture() for scene in both]
        errors = np.abs(pictures[0] - pictures[1]).max(axis=2)
        walked.largest_error = max(walked.largest_error, int(errors.max()))
        walked.waiting += (kind == "one plane" and samples == 0 and name.startswith("camera")
                           and views == ["main", "mirrored"])
        views.clear()
        if errors.max() > LARGEST_ERROR:
            off = int((errors > LARGEST_ERROR).sum())
            y, x = np.argwhere(errors > LARGEST_ERROR)[0]
            print(f"  {kind}, {samples} samples, step {step}, {name}: {off} pixels off, by {errors.max()} at most, "
                  f"the first at ({x}, {y}); decisions {both[0].reasons()}", flush=True)
            for picture, skips in zip(pictures, ("skipping", "full")):
                wt.save(picture, wt.output_folder() / f"skips_{kind.replace(' ', '_')}_{samples}_{step}_{skips}.png")
        for water, decision in zip(both[0].waters, both[0].decisions()):
            walked.decisions[decision] += 1
            if decision == Pass.RENDERED:
                for fate in range(Pass.NUMBER_OF_FATES):
                    walked.fates[fate] += water.GetReflectionPass().GetFateCount(fate)
        name = next_name
        for scene in both:
            skip_changes.CHANGES[name](scene, numbers)
    walked.renders = [
        sum(water.GetReflectionPass().GetNumberOfReflectionRenders() +
            water.GetReflectionPass().GetNumberOfSecondaryRenders() for water in scene.waters) for scene in both]
    print(f"  {time.monotonic() - begun:.1f} s")
    return walked


def times(counts, value):
    """How often a decision or a fate was met on all walks."""
    return sum(getattr(walk(*one), counts)[value] for one in WALKS)


every_walk = pytest.mark.parametrize("kind, samples", WALKS)
on_whole_walks = pytest.mark.skipif(not IS_WHOLE, reason="another VTK takes the whole walks")
# other walks need not come by everything
on_the_usual_walks = pytest.mark.skipif(SEED != USUAL_SEED or not IS_WHOLE, reason="not the usual walks")


@every_walk
def test_pictures_are_those_without_skips(kind, samples):
    """Every picture of the walk is that of the scene with all skips off."""
    walked = walk(kind, samples)
    wt.check_at_most(f"{kind}, {samples} samples: largest error of {walked.steps} pictures", walked.largest_error,
                     LARGEST_ERROR)


@on_whole_walks
@pytest.mark.parametrize("kind", ["levels", "clear"])
def test_no_skip_alone_shows(kind):
    """Each alone: together, one may hide what another does. The two waters of a plane each cover one side of the picture."""
    views = {name: skip_scenes.Scene(kind, skip) for name, skip in {**SINGLE_SKIPS, "none": Pass.SKIP_NONE}.items()}
    truth = views.pop("none").view.picture()
    for name, scene in views.items():
        wt.check_at_most(f"{kind}, {name} alone: largest difference", wt.difference(scene.view.picture(), truth), LARGEST_ERROR)


@on_whole_walks
@pytest.mark.parametrize("kind, samples", [one for one, steps in WALKS.items() if steps >= 10])
def test_mirrored_views_are_saved(kind, samples):
    """The walk needs fewer mirrored and secondary views than without skips."""
    renders = walk(kind, samples).renders
    wt.check_at_most(f"{kind}, {samples} samples: mirrored views, of {renders[1]} without skips", renders[0],
                     (0.9 if kind == "fall" else 0.8) * renders[1])


@on_whole_walks
def test_mirrored_views_wait_for_what_hides_them():
    """Where a camera moves over one plane, some mirrored views are drawn after what may hide them."""
    wt.check_at_least("one plane: mirrored views that waited for what hides them", walk("one plane", 0).waiting, 1)


@on_the_usual_walks
@pytest.mark.parametrize("name", DECISIONS)
def test_walks_come_by_decision(name):
    """The walks meet every decision."""
    wt.check_at_least(f"decision {name}: times", times("decisions", getattr(Pass, name)), 1)


@on_the_usual_walks
@pytest.mark.parametrize("name", FATES)
def test_walks_come_by_fate(name):
    """The walks meet every fate."""
    wt.check_at_least(f"fate {name}: times", times("fates", getattr(Pass, name)), 1)

# SPDX-License-Identifier: BSD-3-Clause
"""props: what water costs for each prop of a scene, beside what it draws.

In a window in which pixels cost nothing, against the same scene without water. What water costs in a scene
of a few props, its own draw and what is read of the picture, counts for none of them. Times are those that
the rendering thread works: what else the machine does, and rasterisers beside it, count for nothing; the
fastest twentieth, which other programs disturb least.
"""

import gc
import time

import numpy as np
import water_test as wt
from report import table
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

SIZE = (32, 24)
FEW = 10
COUNTS, QUICK_COUNTS = (1000, 10_000), (1000,)
RUNS, QUICK_RUNS = 24, 8  # of each kind, which take turns; a tenth of it for 10,000 props
FRAMES = 6  # of a run, of which the first do not count: the window was another one
SETTLING = 2
LIMIT_STILL_US, LIMIT_MOVING_US = 0.5, 1.0
PERCENTILE = 5
STILL, MOVING = "under water, still", "under water, moving camera"
STILL_OVER = "over water, still"

TEXT = """
Cost of water per prop: microseconds of the rendering thread per frame, in a window of $width x $height pixels. It is
the difference between alternating frames with and without water (the fastest twentieth of both), minus what water
adds to a scene of $few props. No reflection is rendered in any of these frames: in two the camera is still and only
the water's time changes; in the other the props are under the water.

$table
"""


class Scene:
    """A window with props over the water or under it."""

    def __init__(self, count, height, has_water):
        self.view = wt.View(SIZE, (0.5, 0.6, 0.8))
        renderer = self.view.renderer
        self.camera = renderer.GetActiveCamera()
        side = int(np.ceil(np.sqrt(count)))
        shape = wt.box((0, 0, 0), (0.5, 0.5, 0.5))
        for i in range(count):
            data = vtkPolyData()
            data.DeepCopy(shape)
            mapper = vtkPolyDataMapper()
            mapper.SetInputData(data)
            actor = vtkActor()
            actor.SetMapper(mapper)
            actor.SetPosition(20.0 * (i % side) / side - 10, 20.0 * (i // side) / side - 10, height)
            renderer.AddActor(actor)
        self.water = wt.add_water(renderer, None, (-12, 12, -12, 12)) if has_water else None
        self.stand(0)
        self.time = 0.0

    def stand(self, turn):
        self.camera.SetPosition(0.02 * (turn % 40), -25, 14)
        self.camera.SetFocalPoint(0, 0, 0)
        self.camera.SetViewUp(0, 0, 1)
        self.camera.SetClippingRange(1, 80)

    def run(self, is_moving):
        """us of the frames that count"""
        times = []
        for frame in range(FRAMES):
            self.time += 0.04
            if self.water:
                self.water.SetTime(self.time)
            if is_moving:
                self.stand(int(self.time / 0.04))
            begin = time.thread_time()
            self.view.window.Render()
            self.view.window.WaitForCompletion()
            if frame >= SETTLING:
                times.append(1e6 * (time.thread_time() - begin))
        return times


def _take_turns(scenes, is_moving, runs):
    """us of each, of runs in turn."""
    times = [[] for _ in scenes]
    gc.collect()
    gc.disable()
    for run in range(-1, runs):
        for scene, own in zip(scenes, times):
            taken = scene.run(is_moving)
            if run >= 0:
                own.extend(taken)
    gc.enable()
    return [float(np.percentile(own, PERCENTILE)) for own in times]


def _measure(count, runs):
    """{case: us that water adds, us of the frame without}"""
    measured = {}
    for height, cases in ((-1.0, (STILL, MOVING)), (1.0, (STILL_OVER,))):
        scenes = [Scene(count, height, has_water) for has_water in (False, True)]
        for case in cases:
            none, water = _take_turns(scenes, case == MOVING, runs)
            measured[case] = (water - none, none)
    return measured


def run(results):
    runs = results.rounds(RUNS, QUICK_RUNS)
    few = _measure(FEW, runs)
    rows = []
    for count in QUICK_COUNTS if results.is_quick else COUNTS:
        for case, (added, none) in _measure(count, max(3, runs * 1000 // count)).items():
            each = (added - few[case][0]) / (count - FEW)
            results.row("props", case, f"{count} props", us_a_prop=each, median_ms=none / 1000)
            rows.append((case, f"{count:,}", f"{none / count:.2f}", f"{each:.3f}"))
            limit = LIMIT_MOVING_US if case == MOVING else LIMIT_STILL_US
            results.check_at_most(f"{count:,} props, {case}: us a prop that water adds", each, limit, 3)
    results.add(
        "What each prop costs",
        TEXT,
        width=SIZE[0],
        height=SIZE[1],
        few=FEW,
        table=table(("case", "props", "without water, us a prop", "water adds, us a prop"), rows),
    )

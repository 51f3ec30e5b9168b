# SPDX-License-Identifier: BSD-3-Clause
"""props: what water costs for each prop of a scene, beside what it draws.

In a window in which pixels cost nothing, against the same scene without water. What water costs in a scene
of a few props, its own draw and what is read of the picture, counts for none of them.
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
COUNTS, QUICK_COUNTS = (1000, 10_000, 100_000), (1000,)
RUNS, QUICK_RUNS = 24, 8  # of each kind, in turns
FRAMES = 6  # of a run, of which the first do not count: the window was another one
SETTLING = 2
LIMIT_STILL_US, LIMIT_MOVING_US = 0.5, 1.0
CHECKED = 10_000  # props: what is larger leaves the processor's caches, in VTK as well

TEXT = """
What water adds to a frame for each prop, microseconds, in a window of $width x $height pixels: medians of the runs of
both, without and with water, that took turns. Still: nothing moves but the water's time, and nothing is rendered. Moving
camera: the props are under the water and none is drawn in the mirrored view; reflected: all of them may be, and as
much as a second renderer with the same props takes is taken off. What water takes in a scene of $few props is taken off, too.

$table
"""


class Scene:
    """A window with props over the water or under it, and with water or a second renderer."""

    def __init__(self, count, height, has_water, has_second=False):
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
        if has_second:
            self.add_second()
        self.stand(0)
        self.time = 0.0

    def add_second(self):
        from vtkmodules.vtkRenderingCore import vtkRenderer

        first = self.view.renderer
        second = vtkRenderer()
        second.SetActiveCamera(self.camera)
        props = first.GetViewProps()
        for i in range(props.GetNumberOfItems()):
            second.AddViewProp(props.GetItemAsObject(i))
        self.view.window.AddRenderer(second)

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
    """The medians, us, of runs in turn."""
    times = [[] for _ in scenes]
    gc.collect()
    gc.disable()
    for run in range(-1, runs):
        for scene, own in zip(scenes, times):
            taken = scene.run(is_moving)
            if run >= 0:
                own.extend(taken)
    gc.enable()
    return [float(np.median(own)) for own in times]


def _measure(count, runs):
    """What water adds, us: {case: us of the frame}"""
    under = [Scene(count, -1.0, has) for has in (False, True)]
    added = {}
    for name, is_moving in (("still", False), ("moving camera", True)):
        none, water = _take_turns(under, is_moving, runs)
        added[name] = (water - none, none)
    del under
    over = [Scene(count, 1.0, False), Scene(count, 1.0, True), Scene(count, 1.0, False, True)]
    none, water = _take_turns(over[:2], False, runs)
    added["still, reflected"] = (water - none, none)
    none, water, twice = _take_turns(over, True, runs)
    added["moving camera, reflected"] = (water - twice, none)
    return added


def run(results):
    runs = results.rounds(RUNS, QUICK_RUNS)
    few = _measure(FEW, runs)
    rows = []
    for count in QUICK_COUNTS if results.is_quick else COUNTS:
        for case, (added, none) in _measure(count, runs if count < 100_000 else 3).items():
            each = (added - few[case][0]) / (count - FEW)
            results.row("props", case, f"{count} props", us_a_prop=each, median_ms=none / 1000)
            rows.append((case, f"{count:,}", f"{none / count:.2f}", f"{each:.3f}"))
            print(f"props: {count:,}, {case}: {each:.3f} us a prop; the frame without water {none / count:.2f}",
                  flush=True)
            if count <= CHECKED:
                limit = LIMIT_MOVING_US if case.startswith("moving") else LIMIT_STILL_US
                results.check_at_most(f"{count:,} props, {case}: us a prop", each, limit, 3)
    results.add(
        "What each prop costs",
        TEXT,
        width=SIZE[0],
        height=SIZE[1],
        few=FEW,
        table=table(("case", "props", "without water, us a prop", "water adds, us a prop"), rows),
    )

# SPDX-License-Identifier: BSD-3-Clause
"""lakes: a frame with 50 lakes of one mesh, 6 of them in view, over the frame with 6 hand-placed waters.

    PYTHONPATH=<folder of vtkwater>:Testing/Python python Utilities/Benchmarks/lakes.py [--frames 40]

The camera moves in every frame, and the two windows take turns. The ratio is that of the medians of the work: CPU
time of all threads, which other load on the machine changes little. Exit status 1: a limit was not met.
"""

import argparse
import statistics
import time

import numpy as np
import water_test as wt
from TestWaterLakes import mesh_of
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper

from vtkwater import vtkWaterActor, vtkWaterLakes

SIZE = (800, 600)
LAKES = 50
IN_VIEW = 6
MOST_RATIO = 1.15
LEVELS = [0.05 * (7 * i % LAKES) for i in range(LAKES)]


def hills():
    """Of 300,000 triangles, behind and between the lakes."""
    for i, x in enumerate(np.linspace(-50, 50, 60)):
        yield wt.sphere((x, 2.6 + 0.4 * (i % 3), 0.0), 0.6 + 0.3 * (i % 4), 50), (0.3 + 0.01 * i, 0.6, 0.3)


def view_of():
    view = wt.View(SIZE)
    for data, color in hills():
        wt.add_actor(view.renderer, data, color)
    wt.place_camera(view.renderer, (0, -10, 8), (0, 0, 1.2), (1, 60))
    view.renderer.GetActiveCamera().SetViewAngle(24)
    return view


def mapper_of(heights):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh_of(heights))
    return mapper


def lakes_of_one_mesh():
    view, lakes = view_of(), vtkWaterLakes()
    lakes.SetMapper(mapper_of(LEVELS))
    lakes.SetMaximumNumberOfPlanes(LAKES)
    lakes.AddTo(view.renderer)
    view.picture()
    return view, [lakes.GetWater(i) for i in range(lakes.GetNumberOfWaters())]


def hand_placed():
    """The six in the middle, each an actor with its part of the mesh."""
    view, waters = view_of(), []
    for number in range((LAKES - IN_VIEW) // 2, (LAKES + IN_VIEW) // 2):
        part = mesh_of([LEVELS[number]], step=0.0)
        points = part.GetPoints()
        for i in range(points.GetNumberOfPoints()):
            x, y, z = points.GetPoint(i)
            points.SetPoint(i, x + 2.0 * (number - 0.5 * (LAKES - 1)), y, z)
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(part)
        water = vtkWaterActor()
        water.SetLevel(LEVELS[number])
        water.SetMapper(mapper)
        view.renderer.AddActor(water)
        waters.append(water)
    view.picture()
    return view, waters


def renders_of(waters):
    return sum(water.GetReflectionPass().GetNumberOfReflectionRenders() for water in waters)


def compare(frames):
    """Of both: a frame in ms, its work in ms, mirrored views a frame; and the pixels that differ by more than 1 of 255."""
    runs = [lakes_of_one_mesh(), hand_placed()]
    pictures = [view.shown() for view, _ in runs]
    times, works, before = ([], []), ([], []), [renders_of(waters) for _, waters in runs]
    for frame in range(frames):
        for number, (view, _) in enumerate(runs):
            view.renderer.GetActiveCamera().SetPosition(0, -10, 8 + 0.002 * frame)
            start, work = time.perf_counter(), time.process_time()
            view.window.Render()
            view.window.WaitForCompletion()
            times[number].append(time.perf_counter() - start)
            works[number].append(time.process_time() - work)
    views = [(renders_of(waters) - first) / frames for (_, waters), first in zip(runs, before)]
    medians, works = ([1000 * statistics.median(each) for each in measured] for measured in (times, works))
    return medians, works, views, int((np.abs(pictures[0] - pictures[1]).max(axis=2) > 1).sum())


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--frames", type=int, default=40, help="of each; default: %(default)s")
    medians, works, views, different = compare(parser.parse_args().frames)
    wt.check_at_most("pixels that differ by more than 1/255", different, 0)
    print(f"50 lakes of one mesh: {medians[0]:.1f} ms, {views[0]:.1f} mirrored views a frame; "
          f"6 placed by hand: {medians[1]:.1f} ms, {views[1]:.1f}; work {works[0]:.1f} and {works[1]:.1f} ms")
    wt.check_at_most("mirrored views a frame", views[0], IN_VIEW)
    wt.check_at_most("frame over that of 6 lakes placed by hand", works[0] / works[1], MOST_RATIO)
    wt.finish()


if __name__ == "__main__":
    main()

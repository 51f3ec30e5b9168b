# SPDX-License-Identifier: BSD-3-Clause
"""data: what a step of a solver's data costs as water, over VTK's plain surface of the same data; memory, first
picture, many lakes, values read back."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

import data_steps
import lakes
import numpy as np
import TestWaterDataColor as color
from data_steps import CELLS as OF_CELLS
from data_steps import CLEAR, COLOURED, KINDS, PLAIN, ROWS
from report import table
from timing import Frame, measure

CELLS, QUICK_CELLS = 1_000_000, 40_000
FILE_CELLS, QUICK_FILE_CELLS = 10_000_000, 90_000
ROUNDS, QUICK_ROUNDS = 12, 3
GRID_ROUNDS = 6
BUDGET_S, QUICK_BUDGET_S = 180.0, 5.0
STEPS, QUICK_STEPS = 100, 12
PICTURES, QUICK_PICTURES = 3, 1  # of each kind, which take turns
SERIES, QUICK_SERIES = 12, 5  # steps
PLAYS, QUICK_PLAYS = 3, 1  # of each, which take turns
FRAMES, QUICK_FRAMES = 40, 6  # of the lakes
PLACES = 100_000  # whose values are read back
FEW_CELLS, QUICK_FEW_CELLS = 10_000, 2_500  # whose triangles are larger than pixels
MOST_COLOR = 1.0  # steps of the table that a value read back is off by
MOST_STEP = 1.6  # a step of coloured water, over VTK's plain surface
MOST_FIRST = 1.5  # the same for the first picture of a file
MOST_MEMORY = 16.0  # MB up or down, over the second half of the steps
# llvmpipe's threads keep the lists of triangles of pictures that they have finished, 64 KB at a time, until it draws
# another one in their place: 330 to 390 MB, as the threads happen to be scheduled. Without threads it keeps none.
NO_THREADS = {"LP_NUM_THREADS": "0"}

TEXT = """
A tide in a basin of $cells cells, $width x $height pixels, with its bed. Every step has new arrays of level and depth, and the shore
moves. "plain" is VTK's surface of the same data: the points at the level, coloured by depth. "coloured" is
`add_water(mesh, level=..., depth=..., bed=..., color_by=...)`, "clear" the same without colours. A step is the frame
with all work for its new data: filters, uploads, the mirrored view. Work is the CPU time of all threads,
which other load on the machine does not change; limits apply to it. The load average at the start was $load.

$steps

The same with $few cells, whose triangles cover many pixels each:

$few_steps

llvmpipe shades several neighbouring pixels at once, so a triangle that covers one pixel costs as much as a group of
pixels. Water of a mesh with small triangles is therefore shaded once per pixel, from a buffer (decision 024). The mesh of
$cells cells, in a picture with a quarter of the pixels:

$small_steps

Coloured water of the same cells in other data sets, divided by VTK's plain surface of the same data set:

$grids

The first picture of an uncompressed file of $file_cells cells, for each surface in a new process that is given the
file's name:

$first

Reading and drawing a step of a series of compressed files of $series_cells cells takes $ahead

The memory that a process has allocated goes up and down over the second half of $count steps, by the MB in the table.
It is measured without llvmpipe's threads, which keep lists of triangles of finished pictures for an arbitrary time. The
memory that water uses follows its area.

$memory

50 lakes of one mesh at 50 levels, 6 of them in view, take $lakes_ms ms per frame with $lakes_views mirrored views. 6 waters that are placed by hand take $placed_ms ms with $placed_views views (ratio of the work $lakes_ratio). Pixels that differ: $lakes_pixels.

Values at $places random places of a coloured surface, read back from the picture's pixels with optics off, differ from
the data by at most $color_error steps of the colour table.
"""


def _measure_steps(results, cells, scene="step", size=data_steps.SIZE):
    frames = []
    for kind in KINDS:
        view = data_steps.View(kind, data_steps.Tide(cells), size=size)
        frames.append(Frame(kind, view.window, lambda turn, view=view: view.choose(turn + 1)))
    measure(frames, results.rounds(ROUNDS, QUICK_ROUNDS), QUICK_BUDGET_S if results.is_quick else BUDGET_S, 1)
    plain = frames[0]
    for frame in frames:
        results.row("data", scene, frame.name, **frame.row, ratio=frame.work / plain.work)
    if not results.is_quick and scene == "step":  # small meshes: the pixels are what costs
        for frame in frames[1:]:
            results.check_at_most(f"data: work of a step, {frame.name} / plain", frame.work / plain.work, MOST_STEP)
    return table(("surface", "step, ms", "work, ms", "work / plain"),
                 [(frame.name, str(frame), f"{frame.work:.0f}", f"{frame.work / plain.work:.2f}")
                  for frame in frames])


def _measure_grids(results, cells):
    """VTK lists the surface of a grid anew in each step; the water lists it once."""
    rows = []
    for data in (OF_CELLS, ROWS):
        frames = []
        for kind in (PLAIN, COLOURED):
            view = data_steps.View(kind, data_steps.Tide(cells), data=data)
            frames.append(Frame(kind, view.window, lambda turn, view=view: view.choose(turn + 1)))
        measure(frames, results.rounds(GRID_ROUNDS, QUICK_ROUNDS), QUICK_BUDGET_S if results.is_quick else BUDGET_S, 1)
        plain, coloured = frames
        ratio = coloured.work / plain.work
        for frame in frames:
            results.row("data", data, frame.name, **frame.row, ratio=frame.work / plain.work)
        if not results.is_quick:
            results.check_at_most(f"data: work of a step of a {data}, coloured / plain", ratio, MOST_STEP)
        rows.append((data, f"{plain.work:.0f}", f"{coloured.work:.0f}", f"{ratio:.2f}"))
    return table(("data set", "work of plain, ms", "work of coloured, ms", "coloured / plain"), rows)


def _measure_lakes(results):
    medians, works, views, different = lakes.compare(results.rounds(FRAMES, QUICK_FRAMES))
    ratio = works[0] / works[1]
    results.row("data", "50 lakes", "of one mesh", median_ms=medians[0], work_ms=works[0], ratio=ratio, views=views[0])
    results.row("data", "50 lakes", "6 placed by hand", median_ms=medians[1], work_ms=works[1], views=views[1])
    results.check_at_most("data: mirrored views of 50 lakes, 6 in view", views[0], lakes.IN_VIEW)
    results.check_at_most("data: pixels of 50 lakes that differ from 6 placed by hand", different, 0)
    if not results.is_quick:
        results.check_at_most("data: work of a frame of 50 lakes / 6 placed by hand", ratio, lakes.MOST_RATIO)
    return {"lakes_ms": f"{medians[0]:.1f}", "placed_ms": f"{medians[1]:.1f}", "lakes_views": f"{views[0]:g}",
            "placed_views": f"{views[1]:g}", "lakes_ratio": f"{ratio:.2f}", "lakes_pixels": different}


def _measure_color(results):
    """Of x, which is linear: what differs is the picture's, not the mesh's."""
    view, _ = color.water_of(color.mesh_of(lambda x, y: x))
    steps = color.steps_of(view.picture())
    read = -color.HALF + (steps + 0.5) / color.STEPS * 2 * color.HALF
    x = color.x_of_columns()
    random = np.random.default_rng(1)
    inside = np.flatnonzero(np.abs(x) < color.HALF - 0.2)
    columns, rows = random.choice(inside, PLACES), random.integers(0, read.shape[0], PLACES)
    worst = float(np.abs(read[rows, columns] - x[columns]).max() / (2 * color.HALF / color.STEPS))
    results.row("data", "color read back", f"{PLACES} places", error_steps=worst)
    results.check_at_most("data: value read back, steps of the table", worst, MOST_COLOR)
    return worst


def _process(*arguments, **environment):
    """What data_steps prints in a process of its own."""
    command = [sys.executable, str(pathlib.Path(data_steps.__file__)), *map(str, arguments)]
    made = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, env={**os.environ, **environment})
    return json.loads(made.stdout.splitlines()[-1])


def _measure_first(results):
    found = {kind: [] for kind in (PLAIN, COLOURED, CLEAR)}
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "tide.vtp"
        data_steps.write_file(path, results.rounds(FILE_CELLS, QUICK_FILE_CELLS))
        for _ in range(results.rounds(PICTURES, QUICK_PICTURES)):
            for kind, times in found.items():
                times.append(_process(kind, path))
    medians = {kind: np.median(times, axis=0) for kind, times in found.items()}
    for kind, (took, work) in medians.items():
        results.row("data", "first picture", kind, median_ms=1000 * took, work_ms=1000 * work,
                    ratio=work / medians[PLAIN][1])
    if not results.is_quick:
        results.check_at_most("data: work of the first picture, coloured / plain",
                              medians[COLOURED][1] / medians[PLAIN][1], MOST_FIRST)
    return table(("surface", "first picture, s", "work, s", "work / plain"),
                 [(kind, f"{took:.2f}", f"{work:.2f}", f"{work / medians[PLAIN][1]:.2f}")
                  for kind, (took, work) in medians.items()])


def _change_of(kind, results, **environment):
    """MB up or down over the second half of the steps, and MB after the last one."""
    steps = results.rounds(STEPS, QUICK_STEPS)
    held = _process(kind, "--cells", results.rounds(CELLS, QUICK_CELLS), "--steps", steps, **environment)
    later = np.array(held[steps // 2:]) / 2**20
    return float(later.max() - later.min()) / 2, float(later[-1])


def _measure_memory(results):
    rows = []
    for kind in (PLAIN, COLOURED):
        change, held = _change_of(kind, results, **NO_THREADS)
        results.row("data", "memory", kind, change_mb=change, held_mb=held)
        with_threads, _ = _change_of(kind, results)
        results.row("data", "memory with llvmpipe's threads", kind, change_mb=with_threads)
        rows.append((kind, f"{change:.1f}", f"{held:.0f}", f"{with_threads:.1f}"))
    results.check_at_most("data: memory over the second half of the steps, MB up or down", change, MOST_MEMORY)
    return table(("surface", "up or down, MB", "after the last step, MB", "up or down with llvmpipe's threads, MB"), rows)


def _measure_ahead(results):
    cells, found = results.rounds(CELLS, QUICK_CELLS) // 4, {False: [], True: []}
    with tempfile.TemporaryDirectory() as folder:
        path = data_steps.write_series(pathlib.Path(folder), cells, results.rounds(SERIES, QUICK_SERIES))
        for _ in range(results.rounds(PLAYS, QUICK_PLAYS)):
            for read_ahead, times in found.items():
                times.append(data_steps.play(path, cells, read_ahead))
    plain, ahead = (float(np.median(times)) for times in found.values())
    results.row("data", "series", "read when asked for", median_ms=1000 * plain)
    results.row("data", "series", "read ahead", median_ms=1000 * ahead, ratio=ahead / plain)
    print(f"data: a step of a series: {plain:.3f} s, read ahead {ahead:.3f} s, {ahead / plain:.2f}", flush=True)
    return (f"{1000 * plain:.0f} ms if the step is read when it is needed, and {1000 * ahead:.0f} ms if another process "
            f"reads it ahead ({ahead / plain:.2f}).")


def run(results):
    cells = results.rounds(CELLS, QUICK_CELLS)
    few = results.rounds(FEW_CELLS, QUICK_FEW_CELLS)
    half = tuple(side // 2 for side in data_steps.SIZE)
    results.add("Data", TEXT, load=results.machine["load"], cells=f"{cells:,}", series_cells=f"{cells // 4:,}",
                width=data_steps.SIZE[0], height=data_steps.SIZE[1], steps=_measure_steps(results, cells), few=f"{few:,}",
                few_steps=_measure_steps(results, few, "few cells"), small_steps=_measure_steps(results, cells, "small picture", half),
                grids=_measure_grids(results, cells), first=_measure_first(results),
                file_cells=f"{results.rounds(FILE_CELLS, QUICK_FILE_CELLS):,}", ahead=_measure_ahead(results),
                count=results.rounds(STEPS, QUICK_STEPS), memory=_measure_memory(results),
                places=f"{PLACES:,}", color_error=f"{_measure_color(results):.2f}", **_measure_lakes(results))

# SPDX-License-Identifier: BSD-3-Clause
"""sea: what a wind sea costs for each step of time, made by the processor and by the GPU."""

import os

import water_test as wt
from report import table
from timing import Frame, measure
from vtkwater import vtkWaterActor

SIZE = (32, 24)  # so small that the pixels cost next to nothing
TILES, QUICK_TILES = (128, 256, 512), (256,)
ROUNDS, QUICK_ROUNDS = 60, 10
BUDGET_S, QUICK_BUDGET_S = 15.0, 2.0  # a tile
WAYS = {"processor": "1", "GPU": "0"}  # values of VTK_WATER_SOFTWARE
STEP_S = 0.04

TEXT = """
A sea to the horizon in a picture of $width x $height pixels, with a still camera. If the time changes, the slopes are
recomputed, on the CPU or on the GPU. VTK_WATER_SOFTWARE selects one of them here; by default a software renderer uses
the CPU. The last column is the cost of a buoy that queries its height at a new time.

$tables
"""


class _Scene:
    def __init__(self, tile):
        self.water = vtkWaterActor()
        self.water.GetWaterProperty().SetSea(True)
        self.water.GetWaterProperty().SetSeaTileSize(tile)
        self.water.SetSheetBounds(-500, 500, -500, 500)
        self.view = wt.View(SIZE, (0.5, 0.6, 0.7))
        self.view.renderer.AddActor(self.water)
        camera = self.view.renderer.GetActiveCamera()
        camera.SetPosition(1, -20, 4)
        camera.SetFocalPoint(0, 0, 2)
        camera.SetViewUp(0, 0, 1)
        camera.SetClippingRange(0.5, 900)

    def go_on(self):
        self.water.SetTime(self.water.GetTime() + STEP_S)


class _Buoy:
    """Is asked for its height in place of a frame."""

    def __init__(self, water):
        self._water = water

    def Render(self):  # noqa: N802  as a window has it
        self._water.GetWaveHeight(1.5, 2.0)

    def WaitForCompletion(self):  # noqa: N802
        pass


def _frames(tile):
    def frame(name, software, goes_on):
        scene = _Scene(tile)

        def before(_):
            os.environ["VTK_WATER_SOFTWARE"] = software
            if goes_on:
                scene.go_on()
            else:
                scene.water.Modified()

        return Frame(name, scene.view.window, before)

    buoy = _Scene(tile)
    return [
        frame("time stands still", WAYS["processor"], False),
        *(frame(f"made by the {way}", software, True) for way, software in WAYS.items()),
        Frame("height", _Buoy(buoy.water), lambda _: buoy.go_on()),
    ]


def run(results):
    rows = []
    kept = os.environ.get("VTK_WATER_SOFTWARE")
    for tile in QUICK_TILES if results.is_quick else TILES:
        frames = measure(
            _frames(tile),
            results.rounds(ROUNDS, QUICK_ROUNDS),
            QUICK_BUDGET_S if results.is_quick else BUDGET_S,
        )
        for frame in frames:
            results.row("sea", f"tile of {tile}", frame.name, **frame.row)
        print(f"sea, tile of {tile}: " + ", ".join(f"{f.name}: {f} ms" for f in frames), flush=True)
        rows.append((f"{tile} x {tile}", *(str(frame) for frame in frames)))
    if kept is None:
        del os.environ["VTK_WATER_SOFTWARE"]
    else:
        os.environ["VTK_WATER_SOFTWARE"] = kept
    names = ("time stands still", "the processor's sea", "the GPU's sea", "a height")
    results.add(
        "A wind sea's time step",
        TEXT,
        width=SIZE[0],
        height=SIZE[1],
        tables=table(("tile", *(f"{name}, ms" for name in names)), rows),
    )

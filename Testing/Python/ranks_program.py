#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""ranks_program: what TestWaterRanks starts with mpirun: a scene that is split over ranks, and its serial picture.

usage: mpirun -np N ranks_program.py [FOLDER | --missing | --frames NUMBER | --controller KIND]

Every rank renders its part; the pictures are put together by depth, as a sort-last renderer does, and
compared on rank 0 with the picture of a window that has all of it. Prints a line of JSON a case on rank 0.
FOLDER: where pictures go. --frames: random frames alone, so many. --missing: the last rank has no
controller, and the others may wait for 2 s. --controller: all have one that is not initialised, or is
finalised, or they end MPI under it, or each has one of its own; each rank prints a line.
"""

import ctypes
import json
import sys
import time

import numpy as np
import volumes
import water_test as wt
from vtkmodules import vtkParallelMPI
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray

from vtkwater import vtkWaterActor, vtkWaterProperty

SIZE = (320, 240)
SHEET = (-9, 9, -9, 9)
PAINT = (0.2, 0.5, 0.9)  # far from the colours of most things
PRESETS = ("pool", "lake", "clear tropical", "ocean wind 5", "turbid river", "mirror floor")


class Ranks:
    """What this process knows of the others."""

    def __init__(self):
        # Python's controller wants MPI to run already: the same MPI, found through VTK's own library
        self.mpi = ctypes.CDLL(vtkParallelMPI.__file__)
        self.mpi.MPI_Init(None, None)
        self.controller = vtkParallelMPI.vtkMPIController()
        self.controller.Initialize()
        self.rank = self.controller.GetLocalProcessId()
        self.count = self.controller.GetNumberOfProcesses()

    def end(self):
        self.controller.Finalize(1)  # MPI itself is ended by who began it
        self.mpi.MPI_Finalize()

    def gather(self, numbers):
        """The same number of 32-bit floats from each: ranks x numbers; None but on rank 0."""
        sent = numpy_to_vtk(np.ascontiguousarray(numbers, np.float32).ravel(), deep=True)
        received = vtkFloatArray()
        received.SetNumberOfTuples(self.count * sent.GetNumberOfTuples() if self.rank == 0 else 0)
        self.controller.Gather(sent, received, 0)
        return vtk_to_numpy(received).reshape(self.count, -1) if self.rank == 0 else None


def things(look=None):
    """Posts of many colours and heights, in and at the water, and a bed in four parts: data and colour of each.

    For a sheet without bounds posts in two corners alone: it covers more than the ranks' own sheets do.
    """
    is_unbounded = (look or "").startswith("unbounded")
    made = []
    for i in range(7):
        for j in range(7):
            if is_unbounded and not (max(i, j) < 3 or min(i, j) > 3):
                continue
            x, y = 2.4 * (i - 3) + 0.3 * (j % 2), 2.4 * (j - 3)
            height = 0.8 + 0.35 * ((3 * i + 5 * j) % 7)
            color = ((i + 1) / 7, (j + 1) / 7, ((i * j) % 5) / 4)
            made.append((wt.pyramid((x, y, 0.5 * height - 0.2), height, 4 + (i + j) % 3, 0.7), color))
    for x, y in () if is_unbounded else ((-4.5, -4.5), (4.5, -4.5), (-4.5, 4.5), (4.5, 4.5)):
        made.append((wt.box((x, y, -1), (9, 9, 0.5 + 0.02 * x)), (0.7, 0.5 + 0.05 * y, 0.4)))
    return made


RANDOM = np.random.default_rng(3).integers(0, 840, 60).tolist()  # 840: any number of ranks up to 8 divides it
SPLITS = {
    "blocks": lambda number, total, ranks: number * ranks // total,
    "interleaved": lambda number, total, ranks: number % ranks,
    "one empty": lambda number, total, ranks: number % max(1, ranks - 1),
    "all on the last": lambda number, total, ranks: ranks - 1,
    "random": lambda number, total, ranks: RANDOM[number] % ranks,
}


def make_waves(water):
    water.GetWaterProperty().AddWave(0.05, 2.1, 30)
    water.GetWaterProperty().AddWave(0.03, 1.3, 75)


def make_painted(water):
    """Nothing of what ranks join is in it: only its shape is as it was."""
    water.GetWaterProperty().SetReflectanceModeToConstant()
    water.GetWaterProperty().SetReflectance(0)
    water.GetWaterProperty().SetDeepColor(*PAINT)


def make_half_float(water):
    water.GetReflectionPass().SetColorPrecisionToHalfFloat()


def make_unbounded(water):
    water.ResetSheetBounds()


def make_clear(water):
    water.GetWaterProperty().RefractionOn()


def make_clear_waves(water):
    make_waves(water)
    make_clear(water)
    water.GetWaterProperty().SetCaustics(0.8)


def make_displaced_waves(water):
    make_waves(water)
    water.GetWaterProperty().WaveGeometryOn()


def make_sea(water):
    water.GetWaterProperty().SetMetresPerUnit(1)  # the automatic one is of a rank's own scene
    water.GetWaterProperty().SeaOn()
    water.GetWaterProperty().SetWindSpeed(4)
    water.GetWaterProperty().SetSeaTileSize(64)


def make_displaced_sea(water):
    make_sea(water)
    water.GetWaterProperty().WaveGeometryOn()


def make_clear_sea(water):
    make_sea(water)
    make_clear(water)


def make_clear_displaced_waves(water):
    make_displaced_waves(water)
    make_clear(water)


def make_clear_displaced_sea(water):
    make_displaced_sea(water)
    make_clear(water)


def make_shadowed(water):
    make_waves(water)
    water.GetWaterProperty().SetSlopeVariance(0.3, 0.3)
    water.GetWaterProperty().ShadowsOn()


def make_own_view(water):
    make_waves(water)
    make_clear(water)
    water.GetWaterProperty().SetRefractionSourceToOwnView()


LOOKS = {
    "calm": lambda water: None,
    "waves": make_waves,
    "half float": make_half_float,
    "unbounded": make_unbounded,
    "clear": make_clear,
    "clear waves": make_clear_waves,
}
SEAS = {
    "displaced waves": make_displaced_waves,
    "sea": make_sea,
    "displaced sea": make_displaced_sea,
    "clear displaced waves": make_clear_displaced_waves,
    "clear sea": make_clear_sea,
    "clear displaced sea": make_clear_displaced_sea,
    "shadows": make_shadowed,
    "own view": make_own_view,
}


def make_view(mine, look, samples=0, size=SIZE):
    """A window with those things whose number is mine, and water; look "dry": none; "sheet": a plane of VTK's."""
    view = wt.View(size, samples=samples)
    view.renderer.GradientBackgroundOn()
    view.renderer.SetBackground2(0.9, 0.6, 0.3)
    wt.place_camera(view.renderer, (14, -11, 3.5), (0, 0, 0.3), (0.5, 80))
    wt.add_scene_light(view.renderer, (5, -9, 12))
    view.actors = {
        number: wt.add_actor(view.renderer, data, color)
        for number, (data, color) in enumerate(things(look))
        if mine(number)
    }
    view.water = None
    if look == "sheet":
        wt.add_actor(view.renderer, wt.box((0, 0, -0.05), (18, 18, 0.1)), PAINT)
    elif not look.endswith("dry"):
        view.water = vtkWaterActor()
        view.water.SetSheetBounds(*SHEET)
        if look.startswith("unbounded"):
            make_unbounded(view.water)
        kind = look.removeprefix("unbounded ").removeprefix("painted ")
        {**LOOKS, **SEAS}[kind](view.water)
        if "painted" in look:
            make_painted(view.water)
        view.renderer.AddActor(view.water)
    return view


def composed(ranks, view):
    """The picture that all ranks render together, on rank 0."""
    picture = view.picture()
    depths = vtkFloatArray()
    width, height = view.window.GetSize()
    view.window.GetZbufferData(0, 0, width - 1, height - 1, depths)
    all_colors = ranks.gather(picture)
    all_depths = ranks.gather(vtk_to_numpy(depths))
    if ranks.rank != 0:
        return None
    nearest = all_depths.argmin(axis=0)  # the first of equal ones
    colors = all_colors.reshape(ranks.count, -1, 3)
    return colors[nearest, np.arange(nearest.size)].reshape(picture.shape).astype(int)


def off(first, second):
    """Share of the pixels that differ by more than 1 of 255 in any colour."""
    return float((np.abs(first - second).max(axis=2) > 1).mean())


def own_part(ranks, split, look=None):
    total = len(things(look))
    return lambda number: SPLITS[split](number, total, ranks.count) == ranks.rank


def say(ranks, **figures):
    if ranks.rank == 0:
        print("FIGURES " + json.dumps(figures), flush=True)


def serial_picture(ranks, look, samples=0):
    """What one process shows of all, on rank 0."""
    return make_view(lambda number: True, look, samples).picture() if ranks.rank == 0 else None


def rank_view(ranks, mine, look, samples=0):
    """make_view, with a controller."""
    view = make_view(mine, look, samples)
    view.errors = []
    if view.water:
        view.errors = wt.errors_of(view.water)
        view.water.GetReflectionPass().SetController(ranks.controller)
    return view


def compare(ranks, split, look, folder, samples, serial, view=None):
    """One picture of all ranks against the serial one, and what each rank did.

    view: that has all things, of which each rank shows its own now; None: a new one.
    """
    mine = own_part(ranks, split, look)
    if view is None:
        view = rank_view(ranks, mine, look, samples)
    for number, actor in view.actors.items():
        actor.SetVisibility(mine(number))
    heard = view.errors
    together = composed(ranks, view)
    facts = [0, 0, len(heard)]
    if view.water:
        reflection = view.water.GetReflectionPass()
        facts = [reflection.GetDecision(), reflection.GetNumberOfPixelsJoined(), len(heard)]
    facts = ranks.gather(facts)
    if ranks.rank == 0:
        if folder:
            wt.save(together, f"{folder}/ranks-{ranks.count}-{split}-{look}-{samples}.png")
            wt.save(serial, f"{folder}/ranks-serial-{look}-{samples}.png")
        say(ranks, case="compare", split=split, look=look, samples=samples, off=off(together, serial),
            facts=facts.tolist())


def block_of(number, ranks, what):
    """What one rank has above the water, in its part of the way from the eye: actors or a volume."""
    depth = 12 / ranks.count
    y = -5 + depth * (number + 0.5)
    size = 0.7 * depth
    if what == "volume":
        middle, half = np.array((0.6 * number - 0.7, y, 5)), np.array((2, size / 2, 1.6))
        data = volumes.block(middle - half, middle + half)
        color = (100, (number + 1) / ranks.count, 0.3, 1 - number / ranks.count)
        return [volumes.ray_cast(data, 0.05, [color], [(100, 0.4)])]
    color = ((number + 1) / ranks.count, 0.3, 1 - number / ranks.count)
    scene = wt.vtkRenderer()
    return [wt.add_actor(scene, wt.pyramid((2.5 - number, y, 4.5), 3, 5, 0.3), (0.9, 0.8, 0.1)),
            wt.add_actor(scene, wt.box((0.6 * number - 1, y, 5), (4, size, 3)), color, opacity=0.45),
            wt.add_actor(scene, wt.box((0.6 * number, y, 5), (2, 0.5 * size, 2)), (0.1, 1, 0.4), opacity=0.6)]


def blend_view(ranks, numbers, what, is_half):
    """A window that shows the water alone, with the reflection of what these ranks have."""
    view = wt.View(SIZE)
    view.renderer.SetUseDepthPeeling(True)  # or polygons are blended in the order of their drawing
    view.renderer.SetMaximumNumberOfPeels(20)
    view.renderer.SetOcclusionRatio(0)
    view.renderer.SetBackground(0.2, 0.5, 0.9)
    wt.place_camera(view.renderer, (0, -14, 5), (0, -8, 0), (0.5, 80))
    wt.add_scene_light(view.renderer, (5, -9, 12))
    for number in numbers:
        for prop in block_of(number, ranks, what):
            view.renderer.AddViewProp(prop)
    view.water = vtkWaterActor()
    view.water.SetSheetBounds(-40, 40, -40, 40)
    view.water.GetWaterProperty().SetReflectanceModeToConstant()
    view.water.GetWaterProperty().SetReflectance(1)
    if is_half:
        make_half_float(view.water)
    view.renderer.AddActor(view.water)
    return view


def blend(ranks, folder):
    """Translucent props and volumes that each rank has in its part of space: RMSE against the serial picture."""
    order = range(ranks.count)
    for what in ("translucent", "volume"):
        for is_half in (False, True):
            for is_reversed in (False, True):  # which rank is near
                mine = ranks.count - 1 - ranks.rank if is_reversed else ranks.rank
                view = blend_view(ranks, [mine], what, is_half)
                view.water.GetReflectionPass().SetController(ranks.controller)
                together = view.picture().astype(float)
                if ranks.rank == 0:
                    # volumes are blended in the order of their drawing: far ones first
                    serial = blend_view(ranks, reversed(order), what, is_half).picture().astype(float)
                    dry = blend_view(ranks, [], what, is_half).picture().astype(float)
                    if folder:
                        wt.save(together.astype(int), f"{folder}/ranks-{ranks.count}-{what}-{int(is_reversed)}.png")
                        wt.save(serial.astype(int), f"{folder}/ranks-serial-{what}.png")
                    say(ranks, case="blend", what=what, half=is_half, reversed=is_reversed,
                        rmse=float(np.sqrt(((together - serial) ** 2).mean())),
                        shown=float(np.sqrt(((dry - serial) ** 2).mean())), error=view.water.GetLastError())


def use_again(ranks):
    """Frames that stand still, and one in which a thing of one rank alone moves."""
    view = make_view(own_part(ranks, "blocks"), "calm")
    reflection = view.water.GetReflectionPass()
    reflection.SetController(ranks.controller)
    rows = []
    for frame in range(4):
        if frame == 2 and 24 in view.actors:
            view.actors[24].SetPosition(0, 0, 1)
        together = composed(ranks, view)
        rows.append(ranks.gather([reflection.GetDecision(), reflection.GetNumberOfPixelsJoined()]))
    if ranks.rank == 0:
        serial = make_view(lambda number: True, "calm")
        serial.actors[24].SetPosition(0, 0, 1)
        say(ranks, case="use again", frames=[row.tolist() for row in rows], off=off(together, serial.picture()))


def reflect_once(ranks):
    """Secondary reflections have no effect on ranks, and each says so once."""
    view = make_view(own_part(ranks, "blocks"), "calm")
    fall = wt.add_water(view.renderer, wt.plane((0, 6, 0), (0, -1, 0.1)), (-6, 6, -2, 4), 0.7)
    reflection = view.water.GetReflectionPass()
    for water in (view.water, fall):
        water.GetReflectionPass().SetController(ranks.controller)
    plain = composed(ranks, view)
    warnings = []
    view.water.AddObserver("WarningEvent", lambda *_: warnings.append(True))
    reflection.SecondaryReflectionsOn()
    for azimuth in (1, -1):
        view.renderer.GetActiveCamera().Azimuth(azimuth)
        shown = composed(ranks, view)
    said = ranks.gather([len(warnings), reflection.GetNumberOfSecondaryRenders(), len(view.water.GetLastError())])
    if ranks.rank == 0:
        say(ranks, case="secondary", said=said.tolist(), off=off(plain, shown))


def part_company(ranks):
    """Ranks that differ: every one says so, none waits; and they come together again."""
    view = make_view(own_part(ranks, "blocks"), "calm")
    heard = wt.errors_of(view.water)
    heard_by_renderer = wt.errors_of(view.renderer)
    water, last = view.water, ranks.rank == ranks.count - 1
    water.GetReflectionPass().SetController(ranks.controller)
    second = vtkWaterActor()
    second.SetSheetBounds(*SHEET)
    second.SetLevel(1.0)
    second.GetReflectionPass().SetController(ranks.controller)
    wt.errors_of(second)  # they are not for the log
    look, lake = water.GetWaterProperty(), vtkWaterProperty()
    lake.SetPreset("lake")
    faults = {
        "preset": (lambda: water.SetWaterProperty(lake), lambda: water.SetWaterProperty(look)),
        "look": (lambda: water.GetWaterProperty().SetIndexOfRefraction(1.5),
                 lambda: water.GetWaterProperty().SetIndexOfRefraction(1.333)),
        "time": (lambda: water.SetTime(3), lambda: water.SetTime(0)),
        "setting": (lambda: water.GetReflectionPass().SetTextureScale(0.5),
                    lambda: water.GetReflectionPass().SetTextureScale(1)),
        "hidden": (lambda: water.SetVisibility(False), lambda: water.SetVisibility(True)),
        "removed": (lambda: view.renderer.RemoveActor(water), lambda: view.renderer.AddActor(water)),
        "two": (lambda: view.renderer.AddActor(second), lambda: view.renderer.RemoveActor(second)),
    }
    before = composed(ranks, view)
    for name, (break_it, mend_it) in faults.items():
        heard.clear()
        heard_by_renderer.clear()
        if last:
            break_it()
        composed(ranks, view)
        composed(ranks, view)
        said = [len(heard) + len(heard_by_renderer), "rank" in "".join(heard + heard_by_renderer)]
        if last:
            mend_it()
        after = composed(ranks, view)
        said = ranks.gather(said + [water.GetReflectionPass().GetDecision(), len(water.GetLastError())])
        if ranks.rank == 0:
            say(ranks, case="fault", fault=name, said=said.tolist(), off=off(before, after))


def change(view, kind, number, value):
    """A change of a view: of its water, its camera, its window, or of one thing, which it may not have."""
    if kind == 0:
        view.water.SetVisibility(not view.water.GetVisibility())
    elif kind == 1 and number in view.actors:
        view.actors[number].SetVisibility(value > 0.5)
    elif kind == 2:
        view.renderer.GetActiveCamera().Azimuth(20 * value)
    elif kind == 3:
        view.water.SetLevel(0.5 * value)
    elif kind == 4:
        view.window.SetSize(80 + 4 * number, 60 + 3 * number)
    elif kind == 5:
        look = view.water.GetWaterProperty()
        look.SetPreset(PRESETS[number % len(PRESETS)])
        look.SetShadows(value < 0.5)  # views of their own come and go
        look.SetRefractionSource(look.OWN_VIEW if value % 0.5 < 0.25 else look.PICTURE)
    elif kind == 6:
        view.water.SetTime(10 * value)


def local_picture(view, serial):
    """How far a rank that renders by itself, as a client does, is from one that has no more than its part."""
    alone = view.picture()
    if serial is None:
        return 0.0
    hidden = [actor for number, actor in serial.actors.items() if number not in view.actors and actor.GetVisibility()]
    for actor in hidden:
        actor.VisibilityOff()
    difference = off(alone, serial.picture())
    for actor in hidden:
        actor.VisibilityOn()
    return difference


def toggle(ranks, frames):
    """Many frames of random changes, the same on all ranks or on one where that is allowed."""
    dice = np.random.default_rng(5)
    view = make_view(own_part(ranks, "interleaved"), "calm")
    reflection = view.water.GetReflectionPass()
    reflection.SetController(ranks.controller)
    serial = make_view(lambda number: True, "calm") if ranks.rank == 0 else None
    for one in filter(None, (view, serial)):
        one.water.GetWaterProperty().SetMetresPerUnit(1)  # the automatic ones are of a rank's own scene
    worst, done = 0.0, [0] * 9
    for _ in range(frames):
        kind, number, value = int(dice.integers(9)), int(dice.integers(49)), float(dice.uniform())
        done[kind] += 1
        for one in filter(None, (view, serial)):
            change(one, kind, number, value)
        if kind == 8:  # every rank by itself, and together again
            reflection.SetController(None)
            worst = max(worst, local_picture(view, serial))
            reflection.SetController(ranks.controller)
        together = composed(ranks, view)
        if ranks.rank == 0:
            worst = max(worst, off(together, serial.picture()))
    say(ranks, case="toggle", frames=frames, kinds=done, off=worst)


def be_missing(ranks):
    """The others wait for a rank that has no controller: they are ended, and so is it."""
    view = make_view(own_part(ranks, "blocks"), "calm")
    view.water.GetReflectionPass().SetRankWaitLimit(2)
    if ranks.rank < ranks.count - 1:
        view.water.GetReflectionPass().SetController(ranks.controller)
    view.picture()
    time.sleep(60)


def settle_apart(kind):
    """A controller that cannot join the ranks: what each says, whether its picture is right, and that of no controller."""
    ranks = None if kind == "uninitialised" else Ranks()
    rank = ranks.rank if ranks else 0
    mine = lambda number: number % 2 == rank  # noqa: E731
    view, alone = make_view(mine, "calm"), make_view(mine, "calm")
    reflection = view.water.GetReflectionPass()
    reflection.SetRankWaitLimit(20)
    heard, heard_by_pass = wt.errors_of(view.water), wt.errors_of(reflection)
    if kind == "uninitialised":
        reflection.SetController(vtkParallelMPI.vtkMPIController())
    elif kind == "one each":
        reflection.SetController(ranks.controller.PartitionController(rank, 0))
    else:
        reflection.SetController(ranks.controller)
        view.picture()
        if kind == "finalised":
            ranks.end()
        else:
            ranks.mpi.MPI_Finalize()
    for _ in range(3):
        view.renderer.GetActiveCamera().Azimuth(1)
        shown = view.picture()
    text = view.water.GetLastError()
    printed = str(reflection)
    reflection.SetController(None)
    again = view.picture()
    alone.renderer.GetActiveCamera().DeepCopy(view.renderer.GetActiveCamera())
    own = alone.picture()
    print("FIGURES " + json.dumps({
        "case": kind, "heard": heard, "heard by pass": heard_by_pass, "left": text, "decision": wt.decision_of(view.water),
        "printed": "no communicator" in printed, "off own part": off(shown, own), "off afterwards": off(again, own),
        "left afterwards": view.water.GetLastError()}), flush=True)
    if kind == "one each":
        ranks.end()


def main():
    if "--controller" in sys.argv:
        settle_apart(sys.argv[2])
        return
    ranks = Ranks()
    if "--missing" in sys.argv:
        be_missing(ranks)
    folder = sys.argv[1] if len(sys.argv) > 1 else None
    if "--frames" in sys.argv:
        toggle(ranks, int(sys.argv[2]))
    elif ranks.count == 1:
        view = make_view(lambda number: True, "calm")
        view.water.GetReflectionPass().SetController(ranks.controller)
        say(ranks, case="alone", off=off(view.picture(), make_view(lambda number: True, "calm").picture()),
            pixels=view.water.GetReflectionPass().GetNumberOfPixelsJoined(), error=view.water.GetLastError())
    else:
        for look in ("dry", *LOOKS):
            serial = serial_picture(ranks, look)
            for split in SPLITS if look in ("dry", "calm") else ("blocks", "interleaved"):
                compare(ranks, split, look, folder, 0, serial)
        blend(ranks, folder)
        use_again(ranks)
        reflect_once(ranks)
        part_company(ranks)
        toggle(ranks, 120)
    ranks.end()


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""ranks_features: what TestWaterRankFeatures starts with mpirun: what a renderer may have on beside water.

usage: mpirun -np N ranks_features.py [--whole] [--only FEATURE,FEATURE] [--folder FOLDER]

For each feature, the scene of ranks_program is shown without water, with a plane of VTK's in its place, and with
waters; by all ranks together, and serially. Some features make the ranks' engine differ from the serial picture
by itself: ambient occlusion and filters of the finished picture see a rank's own part. Where a picture without
water differs, and as far from there as the feature reaches, a picture with water is not judged: what it is off by
elsewhere is water's. Prints a line of JSON for each look on rank 0. --whole: looks that take no way of their own
through the module, too.
"""

import argparse

import numpy as np
import ranks_program as program
import water_test as wt
from vtkmodules.vtkRenderingCore import vtkLODProp3D, vtkPolyDataMapper, vtkProperty

from vtkwater import vtkWaterActor

SIZE = (200, 150)
FLOORS = ("dry", "sheet", "painted calm")
WHITE = (1, 1, 1)  # shows any shade


def make_occluded(view):
    view.renderer.UseSSAOOn()
    view.renderer.SetSSAORadius(0.5)
    view.renderer.SetSSAOBias(0.01)
    view.renderer.SetSSAOKernelSize(32)
    view.renderer.SSAOBlurOn()


def make_filtered(view):
    view.renderer.UseFXAAOn()


def make_peeled(view):
    """The root's things alone are translucent: VTK's engine compares depths, and does not blend ranks' pictures."""
    view.window.SetAlphaBitPlanes(True)
    view.renderer.UseDepthPeelingOn()
    view.renderer.SetMaximumNumberOfPeels(20)
    view.renderer.SetOcclusionRatio(0)
    for number, actor in view.actors.items():
        if number < 10 and number % 2 == 0:
            actor.GetProperty().SetOpacity(0.5)


def make_layered(view):
    """The same by framebuffers of VTK's own, in any order."""
    make_peeled(view)
    view.renderer.UseDepthPeelingOff()


def make_two_layers(view):
    """Rays go on behind edges."""
    if view.water:
        view.water.GetWaterProperty().SetRayTraceLayers(2)


# name: what is set, how many pixels far it reaches, looks, looks of the whole
FEATURES = {
    "SSAO": (make_occluded, 4, ("clear waves",), ("calm", "displaced waves")),
    "FXAA": (make_filtered, 8, ("clear waves",), ("calm", "displaced waves")),
    "depth peeling": (make_peeled, 0, ("clear", "displaced waves"), ("calm", "clear waves")),
    "translucent in any order": (make_layered, 0, ("clear waves",), ("calm",)),
    "rays behind edges": (make_two_layers, 0, ("clear waves",), ("waves", "half float", "displaced sea")),
}


def add_sheet(view, look, bounds, level=None, plane=None):
    water = vtkWaterActor()
    water.SetSheetBounds(*bounds)
    if plane is not None:
        water.SetPlane(plane)
    elif level is not None:
        water.SetLevel(level)
    {**program.LOOKS, **program.SEAS}[look](water)
    view.renderer.AddActor(water)
    view.waters.append(water)


# name: sheets: a look, bounds, level or plane
WATERS = {
    "one plane, other looks": (("waves", (-9, -1, -9, 9), 0), ("clear", (1, 9, -9, 9), 0)),
    "a lake below a pool": (("clear waves", (-9, 9, -9, 9), 0), ("clear", (2, 8, -6, 2), 0.9)),
    "a lake and a fall": (("calm", (-9, 9, -9, 9), 0), ("waves", (-6, 6, -2, 4), ((0, 6, 0), (0, -1, 0.1)))),
}
MORE_WATERS = {
    "two sheets of one plane": (("calm", (-9, -1, -9, 9), 0), ("calm", (1, 9, -9, 9), 0)),
    "two levels": (("waves", (-9, 0, -9, 9), 0), ("calm", (0.5, 9, -9, 9), 0.6)),
    "four lakes": tuple(("waves" if i % 2 else "calm", (9 * (i % 2) - 9, 9 * (i % 2), 9 * (i // 2) - 9, 9 * (i // 2)),
                         0.2 * i) for i in range(4)),
}


def waters_view(mine, name, is_painted):
    view = program.make_view(mine, "dry", size=SIZE)
    view.waters = []
    for look, bounds, place in {**WATERS, **MORE_WATERS}[name]:
        plane = wt.plane(*place) if isinstance(place, tuple) else None
        add_sheet(view, look, bounds, None if plane else place, plane)
    for water in view.waters if is_painted else ():
        program.make_painted(water)
        water.GetWaterProperty().RefractionOff()
    return view


def feature_view(mine, name, look):
    view = program.make_view(mine, look, size=SIZE)
    FEATURES[name][0](view)
    view.waters = [view.water] if view.water else []
    if "painted" in look:
        view.water.GetWaterProperty().SetDeepColor(*WHITE)
    return view


def detailed_view(mine, _):
    """Balls of two levels of detail; which of them is shown is set, as an interactor does by its rates."""
    view = program.make_view(lambda number: False, "waves", size=SIZE)
    view.waters = [view.water]
    view.balls = []
    for number in range(16):
        if not mine(number):
            continue
        ball = vtkLODProp3D()
        ball.AutomaticLODSelectionOff()
        look = vtkProperty()
        look.SetColor(0.2 + 0.05 * number, 0.9 - 0.05 * number, 0.4)
        levels = []
        for resolution in (40, 5):
            mapper = vtkPolyDataMapper()
            mapper.SetInputData(wt.sphere((4 * (number % 4) - 6, 4 * (number // 4) - 6, 1), 1.3, resolution))
            levels.append(ball.AddLOD(mapper, look, 0.0))
        view.balls.append((ball, levels))
        view.renderer.AddViewProp(ball)
    return view


def joined(ranks, view, is_joined=True):
    view.errors = []
    for water in view.waters:
        view.errors.append(wt.errors_of(water))
        if is_joined:
            water.GetReflectionPass().SetController(ranks.controller)
    return view


def facts_of(ranks, view):
    """Of each rank: errors, and the least of the pixels that a water has joined; a sheet may share another's view."""
    pixels = [water.GetReflectionPass().GetNumberOfPixelsJoined() for water in view.waters]
    return ranks.gather([sum(map(len, view.errors)), max(pixels, default=0)])


def mask_of(first, second):
    return np.abs(first - second).max(axis=2) > 1


def grown(mask, reach):
    """What is at most so many pixels away from a mask, along rows and columns."""
    for axis in (0, 1):
        sides = [np.roll(mask, step, axis) for step in range(-reach, reach + 1)]
        mask = np.logical_or.reduce(sides)
    return mask


def compare(ranks, build, case, look, floor, reach, folder):
    """One picture of all ranks against the serial one. Returns where it is off, on rank 0."""
    total = len(program.things(look))
    view = joined(ranks, build(lambda number: number * ranks.count // total == ranks.rank, look))
    together = program.composed(ranks, view)
    facts = facts_of(ranks, view)
    is_water = floor is not None
    apart = None
    if is_water:
        apart = program.composed(ranks, joined(ranks, build(
            lambda number: number * ranks.count // total == ranks.rank, look), False))
    if ranks.rank != 0:
        return np.zeros(1, bool)
    serial = build(lambda number: True, look).picture()
    is_off = mask_of(together, serial)
    if folder:
        name = f"{folder}/features-{ranks.count}-{case}-{look}".replace(" ", "-").replace(",", "")
        wt.save(together, name + ".png")
        wt.save(serial, name + "-serial.png")
        wt.save(np.repeat(255 * is_off[:, :, None], 3, axis=2), name + "-off.png")
    if is_water:
        judged = ~grown(floor, reach)
        program.say(ranks, case=case, look=look, off=float((is_off & judged).mean()), judged=float(judged.mean()),
                    whole=float(is_off.mean()), floor=float(floor.mean()), facts=facts.tolist(),
                    apart=float((mask_of(apart, serial) & judged).mean()))
    return is_off


def show_features(ranks, given):
    for case, (_, reach, looks, more) in FEATURES.items():
        looks = looks + more if given.whole else looks
        if not looks or not is_wanted(given, case):
            continue

        def build(mine, look, case=case):
            return feature_view(mine, case, look)
        painted = tuple("painted " + look for look in looks if "displaced" in look)
        floor = np.logical_or.reduce([compare(ranks, build, case, look, None, 0, given.folder)
                                      for look in (*FLOORS, *painted)])
        for look in looks:
            compare(ranks, build, case, look, floor, reach, given.folder)


def make_shadowed(view):
    view.renderer.SetUseShadows(True)


SHADES = {"shadow maps": make_shadowed, "SSAO": make_occluded}


def show_shades(ranks, given):
    """What VTK computes of a rank's own part alone: how much of the picture differs for it, with and without water."""
    for case, change in SHADES.items() if is_wanted(given, "shades") else ():
        for look in ("dry", "sheet", "calm", "clear waves", *(("clear", "waves") if given.whole else ())):

            def build(mine, look=look, change=change):
                view = program.make_view(mine, look, size=SIZE)
                view.waters = [view.water] if view.water else []
                change(view)
                return view
            total = len(program.things(look))
            shown = [program.composed(ranks, joined(ranks, build(
                lambda number, total=total: number * ranks.count // total == ranks.rank), is_joined))
                for is_joined in (True, False)]
            if ranks.rank != 0:
                continue
            serial = build(lambda number: True).picture()
            if given.folder:
                name = f"{given.folder}/shades-{ranks.count}-{case}-{look}".replace(" ", "-")
                wt.save(shown[0], name + ".png")
                wt.save(serial, name + "-serial.png")
            program.say(ranks, case="shades", what=case, look=look, off=program.off(shown[0], serial),
                        apart=program.off(shown[1], serial), rmse=rms(shown[0], serial))


def show_waters(ranks, given):
    for case in {**WATERS, **MORE_WATERS} if given.whole else WATERS:
        if not is_wanted(given, case):
            continue
        floor = compare(ranks, lambda mine, _, case=case: waters_view(mine, case, True), case, "painted", None, 0,
                        given.folder)
        compare(ranks, lambda mine, _, case=case: waters_view(mine, case, False), case, "waters", floor, 0,
                given.folder)


def show_blends(ranks, given):
    """Translucent props and volumes of all ranks in waves, whose rays find them where they are."""
    for what in ("translucent", "volume"):
        for is_half in (False, True) if given.whole else (False,):
            if not is_wanted(given, "blended in waves"):
                continue

            def build(numbers):
                view = program.blend_view(ranks, numbers, what, is_half)
                program.make_waves(view.water)
                view.waters = [view.water]
                return view
            view = joined(ranks, build([ranks.rank]))
            together = view.picture().astype(float)
            facts = facts_of(ranks, view)
            if ranks.rank != 0:
                continue
            serial = build(reversed(range(ranks.count))).picture()
            if given.folder:
                name = f"{given.folder}/blends-{ranks.count}-{what}-{int(is_half)}"
                wt.save(together, name + ".png")
                wt.save(serial, name + "-serial.png")
            program.say(ranks, case="blended in waves", what=what, half=is_half, facts=facts.tolist(),
                        rmse=rms(together, serial), shown=rms(build([]).picture(), serial))


def rms(first, second):
    return float(np.sqrt(((first - second) ** 2).mean()))


def show_details(ranks):
    """Frames at rest, during an interaction, and at rest again: each is the serial one."""
    view = joined(ranks, detailed_view(lambda number: number % ranks.count == ranks.rank, None))
    serial = detailed_view(lambda number: True, None) if ranks.rank == 0 else None
    frames = []
    before = None
    for level, azimuth in ((0, 0), (0, 0), (1, 2), (1, 0), (1, 3), (0, 0), (0, 0)):
        for one in filter(None, (view, serial)):
            one.renderer.GetActiveCamera().Azimuth(azimuth)
            for ball, levels in one.balls:
                ball.SetSelectedLODID(levels[level])
        together = program.composed(ranks, view)
        decided = ranks.gather([view.water.GetReflectionPass().GetDecision(),
                                view.water.GetReflectionPass().GetNumberOfPixelsJoined()])
        if ranks.rank == 0:
            expected = serial.picture()
            frames.append({"level": level, "off": program.off(together, expected), "decided": decided.tolist(),
                           "changed": 0.0 if before is None else program.off(before, expected)})
            before = expected
    program.say(ranks, case="levels of detail", frames=frames)


def is_wanted(given, case):
    return not given.only or case in given.only.split(",")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--whole", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--folder")
    given = parser.parse_args()
    ranks = program.Ranks()
    show_features(ranks, given)
    show_shades(ranks, given)
    show_waters(ranks, given)
    show_blends(ranks, given)
    if is_wanted(given, "levels of detail"):
        show_details(ranks)
    ranks.end()


if __name__ == "__main__":
    main()

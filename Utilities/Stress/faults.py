# SPDX-License-Identifier: BSD-3-Clause
"""faults: a window that is closed, released or loses its context in the middle of a frame, shaders that never
build, and forks: what a scene with water makes of them, beside the same scene without. VTK alone does not
survive all of them; water must never make it worse.

    faults.py [FAULT...]
    faults.py --list      their names

Each fault is done in a process of its own, twice: dry and wet. Prints a row of Markdown for each: how the
process ended, and whether the next picture was right (byte for byte the one before the fault). Ends with 1 when
water made something worse. Faults: those of `faults()` below; without any, all.
"""

import os
import pathlib
import signal
import subprocess
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Testing" / "Python"))
import water_test as wt  # noqa: E402
from vtkmodules.vtkCommonCore import vtkVersion  # noqa: E402

SECONDS = 30  # a child that hangs is ended then
SIZE = (160, 120)


class Scene:
    """Four pyramids, in water or not."""

    def __init__(self, is_wet):
        self.view = wt.View(SIZE)
        self.actors = [wt.add_actor(self.view.renderer, wt.pyramid((1.5 * i - 2, 0, 0.4), 1.2), (1, 0.6, 0.2 * i))
                       for i in range(4)]
        self.errors = []
        if is_wet:
            water = wt.add_water(self.view.renderer, None, (-9, 9, -9, 9), reflectance=0.7)
            self.errors = wt.errors_of(water)
        wt.place_camera(self.view.renderer, (4, -5, 2), (0, 0, 0), (0.1, 100))

    def once(self, moment, do):
        """Does something once, at a moment of the next frame."""
        where, event = MOMENTS[moment]
        caller = self.view.renderer if where == "renderer" else self.actors[1].GetMapper()

        def on_event(_, __):
            is_mirrored = self.view.renderer.GetActiveCamera().GetPosition()[2] < 0
            if is_mirrored == (where == "mirror"):
                caller.RemoveObserver(tag)
                do()

        tag = caller.AddObserver(event, on_event)


MOMENTS = {
    "frame begins": ("renderer", "StartEvent"),
    "before a prop": ("prop", "StartEvent"),
    "in a prop's draw": ("prop", "UpdateShaderEvent"),
    "frame ends": ("renderer", "EndEvent"),
    "before a prop, mirrored": ("mirror", "StartEvent"),
    "in a prop's draw, mirrored": ("mirror", "UpdateShaderEvent"),
}
ACTIONS = {
    "Finalize()": lambda view: view.window.Finalize(),
    "window's ReleaseGraphicsResources()": lambda view: view.window.ReleaseGraphicsResources(view.window),
    "renderer's ReleaseGraphicsResources()": lambda view: view.renderer.ReleaseGraphicsResources(view.window),
    "ReleaseCurrent()": lambda view: view.window.ReleaseCurrent(),
    "SetOffScreenRendering() off, on": lambda view: (view.window.SetOffScreenRendering(False),
                                                     view.window.SetOffScreenRendering(True)),
    "SetOffScreenRendering() off": lambda view: view.window.SetOffScreenRendering(False),
    "SetSize() to half": lambda view: view.window.SetSize(SIZE[0] // 2, SIZE[1] // 2),
}
SHADERS = ("a prop's shader never builds", "a prop's shader never builds, nor did one before")
FORKS = ("child exits by os._exit()", "child exits by sys.exit()", "child renders into its own window",
         "child renders into the parent's window", "parent renders on")


def faults():
    made = [f"{action}, {moment}" for action in ACTIONS for moment in MOMENTS]
    return [*made, *SHADERS, *(f"fork: {fork}" for fork in FORKS)]


def say(text):
    print(text, flush=True)


def compare(picture, right):
    if picture.shape != right.shape:
        say("picture of another size")
        return
    off = int((picture != right).any(axis=2).sum())
    say("next right" if off == 0 else f"next picture: {off} pixels off")


def forked(scene, fork, is_wet, right):
    pid = os.fork()
    if pid == 0:
        signal.alarm(SECONDS // 2)  # a child that hangs
        if fork == "child renders into its own window":
            compare_child = Scene(is_wet).view.picture()
            os._exit(0 if np.array_equal(compare_child, right) else 9)
        if fork == "child renders into the parent's window":
            os._exit(0 if np.array_equal(scene.view.picture(), right) else 9)
        if fork == "child exits by sys.exit()":
            sys.exit(0)
        os._exit(0)
    if fork == "parent renders on":
        compare(scene.view.picture(), right)
    say("child " + ended(os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])))
    compare(scene.view.picture(), right)


def broken(is_wet, is_new, right):
    """Three frames with a prop whose own shader is wrong, then one without the error."""
    scene = Scene(is_wet)
    if not is_new:
        scene.view.picture()
    shaders = scene.actors[1].GetShaderProperty()
    shaders.AddFragmentShaderReplacement("//VTK::Normal::Dec", True, "#error of the user\n", False)
    for _ in range(3):
        scene.view.picture()
    shaders.ClearAllFragmentShaderReplacements()
    compare(scene.view.picture(), right)


def as_child(fault, is_wet):
    scene = Scene(is_wet)
    right = scene.view.picture()
    if fault in SHADERS:
        broken(is_wet, fault == SHADERS[1], right)
    elif fault.startswith("fork: "):
        forked(scene, fault[len("fork: "):], is_wet, right)
    else:
        action, moment = fault.split(", ", 1) if not fault.startswith("SetOffScreenRendering() off, on") else (
            "SetOffScreenRendering() off, on", fault[len("SetOffScreenRendering() off, on, "):])
        if not is_wet:
            moment = moment.removesuffix(", mirrored")  # there is no mirrored view
        done = []
        scene.once(moment, lambda: (done.append(1), ACTIONS[action](scene.view)))
        scene.view.renderer.GetActiveCamera().Azimuth(1)  # or there is no mirrored view
        scene.view.window.Render()
        scene.view.renderer.GetActiveCamera().Azimuth(-1)
        if not done:
            say("never came to it")
        scene.view.window.SetOffScreenRendering(True)
        scene.view.window.SetSize(SIZE)
        compare(scene.view.picture(), right)
    for error in scene.errors:
        say("says: " + error.strip().splitlines()[-1])
    sys.stdout.flush()


def ended(code):
    return "ends" if code == 0 else signal.Signals(-code).name if code < 0 else f"exits with {code}"


def run(fault, is_wet):
    """How it ended, in words, and whether nothing was wrong."""
    command = [sys.executable, __file__, "--child", fault, "wet" if is_wet else "dry"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return "hangs", 0
    said = [line for line in done.stdout.splitlines() if line.startswith(("next", "child", "picture", "never", "says"))]
    text = "; ".join([*said, ended(done.returncode)])
    if done.returncode != 0:
        return text, 1 if "next right" in text else 0
    is_right = "next right" in text and "off" not in text and "child ends" in text.replace("next", "child ends", 1)
    return text, 3 if is_right and not ("child" in text and "child ends" not in text) else 2


def main():
    if "--child" in sys.argv:
        as_child(sys.argv[-2], sys.argv[-1] == "wet")
        return
    if sys.argv[1:] == ["--list"]:
        print(*faults(), sep="\n")
        return
    window = wt.View().window.GetClassName()
    print(f"VTK {vtkVersion.GetVTKVersion()}, {window}\n\n| fault | dry | wet |\n|---|---|---|")
    worse = []
    for fault in sys.argv[1:] or faults():
        (dry, dry_rank), (wet, wet_rank) = run(fault, False), run(fault, True)
        is_worse = wet_rank < dry_rank
        print(f"| {fault} | {dry} | {wet}{' **worse**' if is_worse else ''} |", flush=True)
        if is_worse:
            worse.append(fault)
    wt.check_equal("faults that water makes worse", worse, [])
    wt.finish()


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: BSD-3-Clause
"""What goes wrong in the middle of a frame costs that frame's reflection and no more: the next picture is
right again. Faults of the driver are in ../Cxx/TestWaterDriverFaults.cxx.
"""

import gc
import os
import subprocess
import sys
import threading

import numpy as np
import skip_scenes
import water_test as wt
from vtkmodules.vtkCommonCore import vtkInformation
from vtkwater import vtkWaterReflectionPass as Pass

SHEET = (-9, 9, -9, 9)


class Scene:
    def __init__(self, size=(160, 120), actors=None):
        self.view = wt.View(size)
        self.view.picture()  # VTK's window before its actors: see shared_actors
        self.actors = actors or [wt.add_actor(self.view.renderer, wt.pyramid((1.5 * i - 2, 0, 0.4), 1.2),
                                              (1, 0.6, 0.2 * i)) for i in range(4)]
        for actor in actors or ():
            self.view.renderer.AddActor(actor)
        self.water = wt.add_water(self.view.renderer, None, SHEET, reflectance=0.7)
        self.errors = wt.errors_of(self.water)
        wt.place_camera(self.view.renderer, (4, -5, 2), (0, 0, 0), (0.1, 100))

    def picture(self):
        return self.view.picture()

    def is_mirrored(self):
        return self.view.renderer.GetActiveCamera().GetPosition()[2] < 0

    def once_in_mirror(self, do, actor=1):
        """Does something when the mirrored view comes to an actor."""
        def on_start(caller, event):
            if self.is_mirrored():
                caller.RemoveObserver(tag[0])
                do()

        mapper = self.actors[actor].GetMapper()
        tag = [mapper.AddObserver("StartEvent", on_start)]


def as_child(what):
    scene = Scene()
    if what == "exit":
        scene.once_in_mirror(lambda: sys.exit(3))
        scene.picture()
    elif what == "fork":
        # VTK's own windows crash or hang at the end of a process that was forked after they rendered,
        # with water or without it: such a child leaves by _exit
        scene.picture()
        pid = os.fork()
        if pid == 0:
            scene.water.SetLevel(0.3)
            os._exit(4)
        print("child ended with", os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]))
        print("error", wt.difference(scene.picture(), right))


right = Scene().picture()
if "--child" in sys.argv:
    as_child(sys.argv[-1])
    sys.exit(0)
dry = Scene()
dry.view.renderer.RemoveActor(dry.water)
wt.check_at_least("the water is seen", wt.difference(right, dry.picture()), 50)


def frame_with(name, do, actor=1):
    scene = Scene()
    scene.once_in_mirror(lambda: do(scene), actor)
    scene.picture()
    wt.check_equal(f"{name}: next picture, error", wt.difference(scene.picture(), right), 0)
    wt.check_equal(f"{name}: errors", scene.errors, [])
    return scene


# Mappers draw nothing after an abort: the mirrored view lacks what comes after it.
frame_with("aborted in the mirrored view", lambda scene: scene.view.window.SetAbortRender(1))


def throw(scene):
    raise RuntimeError("thrown by an observer: this is part of the test")


frame_with("exception in the mirrored view", throw)


# Props that are still to be drawn, or are being drawn, are gone for good.
def prop_deleted(which):
    scene = Scene()
    other = Scene()
    died = []
    scene.actors[which].AddObserver("DeleteEvent", lambda caller, event: died.append(which))

    def drop():
        scene.view.renderer.RemoveActor(scene.actors.pop(which))

    scene.once_in_mirror(drop)
    scene.picture()
    other.view.renderer.RemoveActor(other.actors[which])
    wt.check_equal(f"prop {which} deleted in the mirrored view of prop 1: next picture, error",
                   wt.difference(scene.picture(), other.picture()), 0)
    gc.collect()
    wt.check_equal(f"prop {which} deleted: died", died, [which])


for which in (0, 1, 3):
    prop_deleted(which)


# A prop that stands in for itself is as one without a stand-in, and dies.
def own_stand_in():
    scene = Scene()
    actor = scene.actors[0]
    actor.SetPropertyKeys(vtkInformation())
    actor.GetPropertyKeys().Set(Pass.STAND_IN(), actor)
    wt.check_equal("own stand-in: picture, error", wt.difference(scene.picture(), right), 0)
    died = []
    actor.AddObserver("DeleteEvent", lambda caller, event: died.append(True))
    scene.view.renderer.RemoveActor(actor)
    scene.actors.clear()
    del actor
    gc.collect()
    wt.check_equal("own stand-in: it died", died, [True])


own_stand_in()


# VTK's mappers free what they hold for another window in the middle of their draw. A window must have
# been rendered before it gets actors of another: its first frame frees them, too.
def shared_actors():
    first = Scene()
    second = Scene((180, 120), first.actors)
    alone = Scene((180, 120)).picture()
    for frame in range(3):
        wt.check_equal(f"actors in two windows, frame {frame}: error in the first", wt.difference(first.picture(), right), 0)
        wt.check_equal(f"actors in two windows, frame {frame}: error in the second",
                       wt.difference(second.picture(), alone), 0)


shared_actors()


def shared_with_dry_window():
    """Nothing but the props' own state tells that a window without water has drawn them."""
    first = Scene()
    first.picture()
    dry = wt.View((180, 120))
    dry.picture()
    for actor in first.actors:
        dry.renderer.AddActor(actor)
    alone = None
    for frame in range(3):
        picture = dry.picture()
        alone = picture if alone is None else alone
        wt.check_equal(f"actors in a dry window, frame {frame}: error there", wt.difference(picture, alone), 0)
        wt.check_equal(f"actors in a dry window, frame {frame}: error with water", wt.difference(first.picture(), right), 0)


shared_with_dry_window()


def first_window_goes():
    """What a window frees when it goes is its own, and not what another window has by the same numbers."""
    views, hills = [], None
    for size in ((160, 120), (180, 120)):
        view = wt.View(size)
        view.picture()
        if hills is None:
            hills = wt.add_actor(view.renderer, skip_scenes.terrain((-14, 5), (14, 20), lambda x, y: 2 + np.sin(x) * np.cos(y)), (0.8, 0.3, 0.2))
        else:
            view.renderer.AddActor(hills)
        wt.add_water(view.renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-14, 14, -14, 14))
        wt.place_camera(view.renderer, (0, -14, 4), (0, 0, 0), (0.5, 80))
        views.append(view)
    for turn in range(3):  # pieces of the mesh are left out in both
        for view in views:
            view.renderer.GetActiveCamera().Azimuth(3)
            before = view.picture()
    views[0].window.Finalize()
    wt.check_equal("after the first window is gone: error in the second", wt.difference(views[1].picture(), before), 0)


first_window_goes()


# Two threads, each with a window of its own.
def threads():
    pictures = {}

    def render(number):
        scene = Scene()
        for _ in range(8):
            scene.view.renderer.GetActiveCamera().Azimuth(1)
            scene.picture()
        scene.view.renderer.GetActiveCamera().Azimuth(-8)
        pictures[number] = scene.picture()
        scene.view.window.Finalize()

    workers = [threading.Thread(target=render, args=(number,)) for number in range(2)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    wt.check_equal("two threads: pictures", len(pictures), 2)
    for number, picture in pictures.items():
        wt.check_at_most(f"two threads: error of picture {number}", wt.difference(picture, right), 1)


threads()


# A process that ends in the middle of a mirrored view, or closes its window there.
def child(what):
    program = [sys.executable, __file__, "--child", what]
    run = subprocess.run(program, capture_output=True, text=True, timeout=100, check=False)
    return run.returncode, run.stdout


wt.check_equal("the process ends in the mirrored view: exit code", child("exit")[0], 3)
wt.check_equal("fork", child("fork"), (0, "child ended with 4\nerror 0\n"))
wt.finish()

# SPDX-License-Identifier: BSD-3-Clause
"""What goes wrong in the middle of a frame costs that frame's reflection and no more: the next picture is
right again. Faults of the driver are in ../Cxx/TestWaterDriverFaults.cxx and TestWaterWrongDriver.cxx.
"""

import gc
import os
import pathlib
import subprocess
import sys
import threading

import numpy as np
import pytest
import skip_scenes
import water_test as wt
from vtkmodules.vtkCommonCore import vtkInformation
from vtkwater import vtkWaterReflectionPass as Pass

SHEET = (-9, 9, -9, 9)


class Scene:
    """A row of pyramids in water that reflects most of the light."""

    def __init__(self, size=(160, 120), actors=None):
        self.view = wt.View(size)
        self.view.picture()  # VTK's window before its actors: see test_actors_may_be_in_two_windows_with_water
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


@pytest.fixture(scope="module")
def right():
    """The picture without a fault."""
    return Scene().picture()


def test_the_water_is_seen(right):
    """The scene's picture would tell of a lost reflection: without the water it is another."""
    dry = Scene()
    dry.view.renderer.RemoveActor(dry.water)
    wt.check_at_least("the water is seen", wt.difference(right, dry.picture()), 50)


def judge_frame_with(name, do, right):
    scene = Scene()
    scene.once_in_mirror(lambda: do(scene))
    scene.picture()
    wt.check_equal(f"{name}: next picture, error", wt.difference(scene.picture(), right), 0)
    wt.check_equal(f"{name}: errors", scene.errors, [])


def test_an_aborted_mirrored_view_is_made_up_for(right):
    """Mappers draw nothing after an abort; the mirrored view that lacks what comes after it is made anew."""
    judge_frame_with("aborted in the mirrored view", lambda scene: scene.view.window.SetAbortRender(1), right)


def test_an_exception_in_the_mirrored_view_costs_nothing(right):
    """An observer that throws in the mirrored view does no harm to the next picture."""
    def throw(scene):
        raise RuntimeError("thrown by an observer: this is part of the test")

    judge_frame_with("exception in the mirrored view", throw, right)


@pytest.mark.parametrize("which", (0, 1, 3), ids=("already_drawn", "being_drawn", "still_to_be_drawn"))
def test_a_prop_deleted_in_the_mirrored_view_is_gone(which):
    """A prop that is deleted in the mirrored view, of prop 1, is gone for good, and dies."""
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


def test_a_prop_that_stands_in_for_itself_is_as_any_other(right):
    """A prop that stands in for itself is as one without a stand-in, and dies."""
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


def test_actors_may_be_in_two_windows_with_water(right):
    """Actors in two windows with water give each its picture."""
    # VTK's mappers free what they hold for another window in the middle of their draw. A window must have
    # been rendered before it gets actors of another: its first frame frees them, too.
    first = Scene()
    second = Scene((180, 120), first.actors)
    alone = Scene((180, 120)).picture()
    for frame in range(3):
        wt.check_equal(f"actors in two windows, frame {frame}: error in the first",
                       wt.difference(first.picture(), right), 0)
        wt.check_equal(f"actors in two windows, frame {frame}: error in the second",
                       wt.difference(second.picture(), alone), 0)


def shared_with_a_dry_window(is_wet):
    """Three pictures each of a window, with water or without, and of another without, of the same actors."""
    first = Scene()
    if not is_wet:
        first.view.renderer.RemoveActor(first.water)
    first.picture()
    dry = wt.View((180, 120))
    wt.place_camera(dry.renderer, (4, -5, 2), (0, 0, 0), (0.1, 100))
    dry.picture()
    for actor in first.actors:
        dry.renderer.AddActor(actor)
    return [(dry.picture(), first.picture()) for _ in range(3)]


def test_actors_may_be_in_a_window_without_water(right):
    """Actors in a window with water and in one without give each its own picture."""
    # nothing but the props' own state tells that a window without water has drawn them; the truth shares them, too:
    # VTK's OSMesa and EGL windows show nothing of actors that another window draws, with water or without it; our own
    # EGL window, with VTK 9.1, does (Documentation/stress.md, "Actors in two windows")
    truth = shared_with_a_dry_window(is_wet=False)
    for frame, ((dry, wet), (alone, _)) in enumerate(zip(shared_with_a_dry_window(is_wet=True), truth)):
        wt.check_equal(f"actors in a dry window, frame {frame}: error there", wt.difference(dry, alone), 0)
        wt.check_equal(f"actors in a dry window, frame {frame}: error with water", wt.difference(wet, right), 0)


def test_a_window_that_goes_frees_its_own():
    """What a window frees when it goes is its own, and not what another window has by the same numbers."""
    views, hills = [], None
    for size in ((160, 120), (180, 120)):
        view = wt.View(size)
        view.picture()
        if hills is None:
            terrain = skip_scenes.terrain((-14, 5), (14, 20), lambda x, y: 2 + np.sin(x) * np.cos(y))
            hills = wt.add_actor(view.renderer, terrain, (0.8, 0.3, 0.2))
        else:
            view.renderer.AddActor(hills)
        wt.add_water(view.renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-14, 14, -14, 14))
        wt.place_camera(view.renderer, (0, -14, 4), (0, 0, 0), (0.5, 80))
        views.append(view)
    for _ in range(3):  # pieces of the mesh are left out in both
        for view in views:
            view.renderer.GetActiveCamera().Azimuth(3)
            before = view.picture()
    views[0].window.Finalize()
    wt.check_equal("after the first window is gone: error in the second", wt.difference(views[1].picture(), before), 0)


def test_two_threads_may_render_windows_of_their_own(right):
    """Two threads that render at once, each into a window of its own, give the right picture each."""
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


def exit_in_the_mirrored_view():
    scene = Scene()
    scene.once_in_mirror(lambda: sys.exit(3))
    scene.picture()


def fork_after_a_frame():
    # VTK's own windows crash or hang at the end of a process that was forked after they rendered,
    # with water or without it: such a child exits by _exit
    before = Scene().picture()
    scene = Scene()
    scene.picture()
    pid = os.fork()
    if pid == 0:
        scene.water.SetLevel(0.3)
        os._exit(4)
    print("child ended with", os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]))
    print("error", wt.difference(scene.picture(), before))


def run_by_itself(function):
    """Exit status and output of a process that calls a function of this file and ends."""
    program = f"import {pathlib.Path(__file__).stem} as faults; faults.{function.__name__}()"
    run = subprocess.run([sys.executable, "-c", program], cwd=pathlib.Path(__file__).parent, capture_output=True,
                         text=True, timeout=100, check=False)
    return run.returncode, run.stdout


def test_a_process_may_end_in_the_mirrored_view():
    """A process that ends in the middle of a mirrored view ends with the status that it wants."""
    wt.check_equal("the process ends in the mirrored view: exit code", run_by_itself(exit_in_the_mirrored_view)[0], 3)


def test_a_process_may_fork_after_a_frame():
    """After a fork the child may change its water, and the parent renders on as before."""
    wt.check_equal("fork", run_by_itself(fork_after_a_frame), (0, "child ended with 4\nerror 0\n"))

# SPDX-License-Identifier: BSD-3-Clause
"""A user's observers may do anything in the middle of a frame, as with any other prop of VTK.

A mapper's StartEvent fires in the mirrored view and in the main view: in that order, or the other
way round when the mirrored view waits for the scene before the water. What an observer did there
must have happened afterwards, and the picture after the frame must be right.
"""

import os
import subprocess
import sys

import pytest
import water_test as wt
from vtkmodules.vtkRenderingCore import vtkCamera
from vtkwater import vtkWaterReflectionPass as Pass

pytestmark = pytest.mark.usefixtures("in_software")  # on a GPU the mirrored view is never drawn first

SHEET = (-9, 9, -9, 9)
MIRRORED, MAIN = "mirrored", "main"  # which view of a frame
FIRST, LATE = "first", "late"  # when the mirrored view is drawn


class Scene:
    def __init__(self, order=FIRST):
        self.view = wt.View((200, 150))
        self.actor = wt.add_actor(self.view.renderer, wt.pyramid((0, 0, 0.4), 1.2), (1, 0.6, 0.2))
        self.water = wt.add_water(self.view.renderer, None, SHEET)
        self.water.GetReflectionPass().SetSkips(Pass.SKIP_ALL & ~Pass.UNCHANGED_VIEWS)
        if order == LATE:  # few pixels of the water are seen: waiting for them pays
            for center in ((2.4, -4.2, 1.5), (3.62, -3.22, 1.5)):
                wall = wt.add_actor(self.view.renderer, wt.box(center, (0.9, 0.9, 2)), (0, 0, 1))
                wt.leave_out(wall)
        wt.place_camera(self.view.renderer, (4, -5, 2), (0, 0, 0), (0.1, 100))

    def picture(self):
        return self.view.picture()

    def reflections(self):
        return self.water.GetReflectionPass().GetNumberOfReflectionRenders()


def is_mirrored(scene):
    return scene.view.renderer.GetActiveCamera().GetPosition()[2] < 0


def order_of_views(scene):
    seen = []
    tag = scene.actor.GetMapper().AddObserver(
        "StartEvent", lambda caller, event: seen.append(MIRRORED if is_mirrored(scene) else MAIN))
    scene.picture()
    scene.actor.GetMapper().RemoveObserver(tag)
    return seen


def in_view(view, order, do):
    """A scene, and the picture after a frame in which an observer did something in a view."""
    scene = Scene(order)
    scene.picture()
    done = []

    def on_start(caller, event):
        if not done and is_mirrored(scene) == (view == MIRRORED):
            done.append(True)
            do(scene)

    scene.actor.GetMapper().AddObserver("StartEvent", on_start)
    scene.picture()
    wt.check_equal(f"{view} view, {order}: the observer was called", len(done), 1)
    return scene, scene.picture()


def dry_picture(order=FIRST):
    """The scene without its water."""
    scene = Scene(order)
    scene.view.renderer.RemoveActor(scene.water)
    return scene.picture()


ORDERS = pytest.mark.parametrize("order", [FIRST, LATE])
VIEWS = pytest.mark.parametrize("view", [MIRRORED, MAIN])


@ORDERS
def test_the_views_are_drawn_in_this_order(order):
    """The mirrored view is drawn before the main one, or after it when it waits for the scene before the water."""
    scene = Scene(order)
    right = scene.picture()
    wt.check_equal(f"drawn {order}: order of the views", order_of_views(scene),
                   [MIRRORED, MAIN] if order == FIRST else [MAIN, MIRRORED])
    wt.check_at_least(f"drawn {order}: the water is seen", wt.difference(right, dry_picture(order)), 50)


def test_a_gpu_draws_the_main_view_first(monkeypatch):
    """Where a GPU draws, the mirrored view is planned while it draws the main one."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "0")
    wt.check_equal("on a GPU: order of the views", order_of_views(Scene()), [MAIN, MIRRORED])


@VIEWS
@ORDERS
def test_the_water_may_be_removed(order, view):
    """When an observer removes the water in the middle of a frame, the next picture has none."""
    _, picture = in_view(view, order, lambda scene: scene.view.renderer.RemoveActor(scene.water))
    wt.check_equal(f"water removed in the {view} view, drawn {order}: next picture, error",
                   wt.difference(picture, dry_picture(order)), 0)


@VIEWS
@ORDERS
def test_resources_may_be_released(order, view):
    """When an observer releases the water's graphics resources in the middle of a frame, the next picture is right."""
    _, picture = in_view(view, order, lambda scene: scene.water.ReleaseGraphicsResources(scene.view.window))
    wt.check_equal(f"resources released in the {view} view, drawn {order}: next picture, error",
                   wt.difference(picture, Scene(order).picture()), 0)


@VIEWS
@ORDERS
def test_the_camera_may_be_replaced(order, view):
    """When an observer sets another camera in the middle of a frame, it is the active one afterwards."""
    other = vtkCamera()
    other.DeepCopy(Scene().view.renderer.GetActiveCamera())
    scene, _ = in_view(view, order, lambda scene: scene.view.renderer.SetActiveCamera(other))
    wt.check_equal(f"camera set in the {view} view, drawn {order}: it is the active one",
                   scene.view.renderer.GetActiveCamera() is other, True)


def test_the_last_reference_to_the_water_may_be_dropped():
    """When the last reference to the only water is dropped as the frame ends, the next picture has none."""
    scene = Scene()

    def drop(caller, event):
        if scene.water:
            scene.view.renderer.RemoveActor(scene.water)
            scene.water = None

    scene.view.renderer.AddObserver("EndEvent", drop, 1.0)
    scene.picture()
    wt.check_equal("water dropped at the frame's end: next picture, error",
                   wt.difference(scene.picture(), dry_picture()), 0)


def remove_all(renderer, tag):
    renderer.RemoveObservers("EndEvent")


def abort(renderer, tag):
    command = renderer.GetCommand(tag)
    if command:
        command.SetAbortFlag(1)


@pytest.mark.parametrize("name, do", [("observers of EndEvent removed", remove_all), ("EndEvent aborted", abort)],
                         ids=["removed", "aborted"])
def test_observers_of_the_frames_end_may_be_silenced(name, do):
    """An observer may remove all observers of the frame's end, or keep others from hearing of it."""
    scene = Scene()
    tag = [0]
    tag[0] = scene.view.renderer.AddObserver("EndEvent", lambda caller, event: do(caller, tag[0]), 1.0)
    scene.picture()
    before = scene.reflections()
    scene.actor.SetPosition(0.5, 0, 0)
    moved = scene.picture()
    fresh = Scene()
    fresh.actor.SetPosition(0.5, 0, 0)
    wt.check_equal(f"{name}: reflections in the next frame", scene.reflections() - before, 1)
    wt.check_equal(f"{name}: next picture, error", wt.difference(moved, fresh.picture()), 0)


DROP_WATER = """
import water_test as wt
view = wt.View((64, 48))
wt.add_actor(view.renderer, wt.pyramid((0, 0, 0.4), 1.2), (1, 0.6, 0.2))
water = wt.add_water(view.renderer, None, (-9, 9, -9, 9))
wt.place_camera(view.renderer, (4, -5, 2), (0, 0, 0), (0.1, 100))
view.picture()
water.GetMapper().AddObserver({event!r}, lambda caller, event: {drop})
for _ in range(3):
    view.picture()
print("done")
"""


@pytest.mark.parametrize("event", ("StartEvent", "UpdateShaderEvent", "EndEvent"))
@pytest.mark.parametrize("drop", ("water.ReleaseGraphicsResources(view.window)",
                                  "water.GetReflectionPass().ReleaseGraphicsResources(view.window)",
                                  "view.renderer.RemoveActor(water)"), ids=("released", "pass_released", "removed"))
def test_water_may_be_dropped_while_it_is_drawn(drop, event):
    """A water's own draw may release or remove it: what it has freed is not used. Freed memory is overwritten here."""
    environment = {**os.environ, "MALLOC_PERTURB_": "165", "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run([sys.executable, "-c", DROP_WATER.format(event=event, drop=drop)], capture_output=True,
                          text=True, env=environment, check=False)
    wt.check_equal(f"{drop} in its {event}: exit status", done.returncode, 0)
    wt.check_equal(f"{drop} in its {event}: it goes on", done.stdout.split()[-1:], ["done"])

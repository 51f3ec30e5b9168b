# SPDX-License-Identifier: BSD-3-Clause
"""A user's observers may do anything in the middle of a frame, as with any other prop of VTK.

A mapper's StartEvent fires in the mirrored view and in the main view: in that order, or the other
way round when the mirrored view waits for the scene before the water. What an observer did there
must have happened afterwards, and the picture after the frame must be right.
"""

import water_test as wt
from vtkmodules.vtkRenderingCore import vtkCamera
from vtkwater import vtkWaterReflectionPass as Pass

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


for order in (FIRST, LATE):
    scene = Scene(order)
    right = scene.picture()
    wt.check_equal(f"drawn {order}: order of the views", order_of_views(scene),
                   [MIRRORED, MAIN] if order == FIRST else [MAIN, MIRRORED])
    dry = Scene(order)
    dry.view.renderer.RemoveActor(dry.water)
    dry = dry.picture()
    wt.check_at_least(f"drawn {order}: the water is seen", wt.difference(right, dry), 50)
    for view in (MIRRORED, MAIN):
        name = f"in the {view} view, drawn {order}: next picture, error"
        scene, picture = in_view(view, order, lambda scene: scene.view.renderer.RemoveActor(scene.water))
        wt.check_equal(f"water removed {name}", wt.difference(picture, dry), 0)
        scene, picture = in_view(
            view, order, lambda scene: scene.water.ReleaseGraphicsResources(scene.view.window))
        wt.check_equal(f"resources released {name}", wt.difference(picture, right), 0)

        other = vtkCamera()
        other.DeepCopy(Scene().view.renderer.GetActiveCamera())
        scene, picture = in_view(view, order, lambda scene: scene.view.renderer.SetActiveCamera(other))
        wt.check_equal(f"camera set in the {view} view, drawn {order}: it is the active one",
                       scene.view.renderer.GetActiveCamera() is other, True)
right = Scene().picture()
dry = Scene()
dry.view.renderer.RemoveActor(dry.water)
dry = dry.picture()

# The last reference to the only water is dropped as the frame ends.
scene = Scene()


def drop(caller, event):
    if scene.water:
        scene.view.renderer.RemoveActor(scene.water)
        scene.water = None


scene.view.renderer.AddObserver("EndEvent", drop, 1.0)
scene.picture()
wt.check_equal("water dropped at the frame's end: next picture, error", wt.difference(scene.picture(), dry), 0)


# An observer that takes all observers of the frame's end away, or keeps others from hearing of it.
def end_of_frame(name, do):
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


def abort(renderer, tag):
    command = renderer.GetCommand(tag)
    if command:
        command.SetAbortFlag(1)


end_of_frame("observers of EndEvent removed", lambda renderer, tag: renderer.RemoveObservers("EndEvent"))
end_of_frame("EndEvent aborted", abort)
wt.finish()

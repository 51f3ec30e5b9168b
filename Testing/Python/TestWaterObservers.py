# SPDX-License-Identifier: BSD-3-Clause
"""A user's observers may do anything in the middle of a frame, as with any other prop of VTK.

A mapper's StartEvent fires in the mirrored view first and in the main view second. What an observer
did there must have happened afterwards, and the picture after the frame must be right.
"""

import numpy as np
import water_test as wt
from vtkmodules.vtkRenderingCore import vtkCamera

SHEET = (-9, 9, -9, 9)
MIRRORED, MAIN = 1, 2  # which view of a frame


class Scene:
    def __init__(self):
        self.view = wt.View((200, 150))
        self.actor = wt.add_actor(self.view.renderer, wt.pyramid((0, 0, 0.4), 1.2), (1, 0.6, 0.2))
        self.water = wt.add_water(self.view.renderer, None, SHEET)
        camera = self.view.renderer.GetActiveCamera()
        camera.SetPosition(4, -5, 2)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetViewUp(0, 0, 1)
        camera.SetClippingRange(0.1, 100)

    def picture(self):
        return self.view.picture()

    def reflections(self):
        return self.water.GetReflectionPass().GetNumberOfReflectionRenders()


def error(first, second):
    return int(np.abs(first - second).max())


def in_view(view, do):
    """A scene, and the picture after a frame in which an observer did something in a view."""
    scene = Scene()
    scene.picture()
    count = [0]

    def on_start(caller, event):
        count[0] += 1
        if count[0] == view:
            do(scene)

    scene.actor.GetMapper().AddObserver("StartEvent", on_start)
    scene.picture()
    return scene, scene.picture()


right = Scene().picture()
dry = Scene()
dry.view.renderer.RemoveActor(dry.water)
dry = dry.picture()
wt.check_at_least("the water is seen", error(right, dry), 50)

for view, name in ((MIRRORED, "mirrored"), (MAIN, "main")):
    scene, picture = in_view(view, lambda scene: scene.view.renderer.RemoveActor(scene.water))
    wt.check_equal(f"water removed in the {name} view: next picture, error", error(picture, dry), 0)
    scene, picture = in_view(view, lambda scene: scene.water.ReleaseGraphicsResources(scene.view.window))
    wt.check_equal(f"resources released in the {name} view: next picture, error", error(picture, right), 0)

    other = vtkCamera()
    other.DeepCopy(Scene().view.renderer.GetActiveCamera())
    scene, picture = in_view(view, lambda scene: scene.view.renderer.SetActiveCamera(other))
    wt.check_equal(f"camera set in the {name} view: it is the active one",
                   scene.view.renderer.GetActiveCamera() is other, True)

# The last reference to the only water is dropped as the frame ends.
scene = Scene()


def drop(caller, event):
    if scene.water:
        scene.view.renderer.RemoveActor(scene.water)
        scene.water = None


scene.view.renderer.AddObserver("EndEvent", drop, 1.0)
scene.picture()
wt.check_equal("water dropped at the frame's end: next picture, error", error(scene.picture(), dry), 0)


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
    wt.check_equal(f"{name}: next picture, error", error(moved, fresh.picture()), 0)


def abort(renderer, tag):
    command = renderer.GetCommand(tag)
    if command:
        command.SetAbortFlag(1)


end_of_frame("observers of EndEvent removed", lambda renderer, tag: renderer.RemoveObservers("EndEvent"))
end_of_frame("EndEvent aborted", abort)
wt.finish()

# SPDX-License-Identifier: BSD-3-Clause
"""A mouse that drags the slider floods the scene to where it lets go; one that drags the plane takes the water
along."""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import vtkRenderWindow
from vtkmodules.vtkRenderingUI import vtkGenericRenderWindowInteractor
from vtkwater.scenes import Scene
from vtkwater.widgets import LevelSlider, PlaneWidget

SIZE = (400, 300)


def make():
    view = wt.View(SIZE)
    for data, color in wt.columns_and_pyramids():
        wt.add_actor(view.renderer, data, color)
    water = wt.add_water(view.renderer, sheet=(-6, 6, -5, 7))
    camera = view.renderer.GetActiveCamera()
    camera.SetPosition(2, -14, 5)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)
    view.renderer.ResetCameraClippingRange()
    interactor = vtkGenericRenderWindowInteractor()
    interactor.SetRenderWindow(view.window)
    interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
    view.picture()
    return view, water, interactor


def drag(interactor, start, stop, steps=4):
    """A left mouse button goes down at a pixel, along a line, and up."""
    start, stop = np.array(start), np.array(stop)
    interactor.SetEventInformation(*map(int, start))
    interactor.MouseMoveEvent()
    interactor.LeftButtonPressEvent()
    for i in range(1, steps + 1):
        interactor.SetEventInformation(*map(int, start + (stop - start) * i // steps))
        interactor.MouseMoveEvent()
    interactor.LeftButtonReleaseEvent()


def error_of(make_widget):
    """What a ValueError says; nothing: there was none."""
    try:
        make_widget()
    except ValueError as error:
        return str(error)
    return ""


def make_slider(interactor, water):
    return LevelSlider(interactor, water, -1.0, 1.0)


# Before any other: what crashed is OpenGL that was never loaded.
def test_slider_made_before_the_first_frame():
    """A slider can be made before anything is rendered and the interactor is initialised.

    A picture taken by vtkWindowToImageFilter crashed in VTK then.
    """
    scene = Scene(SIZE)
    scene.add_box((-1, 1, -1, 1, -1, 1), (1, 0, 0))
    water = scene.add_water(0.0)
    water.SetSheetBounds(-6, 6, -5, 7)
    scene.set_camera((2, -14, 5), (0, 0, 0))
    interactor = vtkGenericRenderWindowInteractor()
    interactor.SetRenderWindow(scene.window)
    slider = LevelSlider(interactor, water, -1.0, 1.0)
    picture = wt.output_folder() / "FirstFrame.png"
    scene.write(picture)
    wt.check_equal("enabled", slider.widget.GetEnabled(), 1)
    wt.check_at_least("bytes of the first frame", picture.stat().st_size, 1000)


# the tube reaches from 6 to 44 per cent of the width: level 0 is in its middle
MIDDLE, QUARTER = (0.25 * SIZE[0], 0.1 * SIZE[1]), (0.345 * SIZE[0], 0.1 * SIZE[1])


def test_slider_that_is_dragged_floods_the_scene():
    """A drag over a quarter of the slider raises the level by a quarter of its range, and leaves the camera alone."""
    view, water, interactor = make()
    levels = []
    slider = LevelSlider(interactor, water, -1.0, 1.0, changed=levels.append)
    before = view.picture()
    wt.save(before, wt.output_folder() / "LevelSlider.png")
    position = view.renderer.GetActiveCamera().GetPosition()
    drag(interactor, MIDDLE, QUARTER)
    wt.check_at_most("level after a drag over a quarter of it, less 0.5", abs(water.GetLevel() - 0.5), 0.06)
    wt.check_equal("the last level told", levels[-1], water.GetLevel())
    wt.check_equal("the camera stays", view.renderer.GetActiveCamera().GetPosition(), position)
    wt.check_at_least("pixels that change", int((np.abs(view.picture() - before).max(axis=2) > 20).sum()), 2000)
    drag(interactor, QUARTER, (SIZE[0] - 1, QUARTER[1]))
    wt.check_equal("dragged beyond its end", water.GetLevel(), 1.0)
    slider.set_level(-0.25)
    wt.check_equal("set by the program", (water.GetLevel(), slider.widget.GetRepresentation().GetValue()),
                   (-0.25, -0.25))


@pytest.mark.usefixtures("on_a_gpu")
def test_water_behind_a_wall_is_not_mirrored_beside_a_slider():
    """A slider, which is drawn over the picture, leaves the module free to ask first whether the water is seen."""
    view, water, interactor = make()
    slider = LevelSlider(interactor, water, -1.0, 1.0)
    wall = wt.add_actor(view.renderer, wt.box((0, -10, 0), (40, 0.2, 40)), (0.6, 0.5, 0.5), lit=False)
    wt.leave_out(wall)
    view.renderer.ResetCameraClippingRange()
    decisions = []
    for _ in range(5):  # the first frames cannot know
        view.renderer.GetActiveCamera().Azimuth(0.5)
        view.picture()
        decisions.append(wt.decision_of(water))
    wt.check_equal("enabled", slider.widget.GetEnabled(), 1)
    wt.check_equal("decisions of the last frames", decisions[-3:], ["HIDDEN"] * 3)


@pytest.mark.parametrize("low, high", ((1.0, 0.0), (2.0, 3.0), (float("nan"), 1.0), (-float("inf"), 1.0)))
def test_slider_refuses_bad_ends(low, high):
    """A slider whose ends are in the wrong order, without the level between them, or not finite is refused."""
    _, water, interactor = make()
    water.SetLevel(-0.25)
    said = error_of(lambda: LevelSlider(interactor, water, low, high))
    wt.check_equal(f"ends {low}, {high}: {said}", f"low {low}" in said, True)


def test_plane_that_is_dragged_takes_the_water_along():
    """A plane widget takes the water's plane, and a drag of its arrow turns the water."""
    view, water, interactor = make()
    planes = []
    widget = PlaneWidget(interactor, water, (-5, 5, -4, 6, -3, 4), planes.append)
    before = view.picture()
    wt.save(before, wt.output_folder() / "PlaneWidget.png")
    wt.check_equal("it takes the water's plane", (widget.widget.GetRepresentation().GetOrigin(),
                                                  widget.widget.GetRepresentation().GetNormal()),
                   (water.GetPlane().GetOrigin(), water.GetPlane().GetNormal()))
    # the arrow's point: the normal's end, in pixels
    view.renderer.SetWorldPoint(0, 0, 1.5, 1)
    view.renderer.WorldToDisplay()
    x, y, _ = view.renderer.GetDisplayPoint()
    drag(interactor, (x, y), (x + 40, y))
    normal = np.array(water.GetPlane().GetNormal())
    wt.check_at_least("turned: degrees", float(np.degrees(np.arccos(normal[2]))), 5.0)
    wt.check_equal("the plane told is the water's", planes[-1] is water.GetPlane(), True)
    wt.check_at_least("pixels that change", int((np.abs(view.picture() - before).max(axis=2) > 20).sum()), 2000)
    wt.check_equal("the water is right", water.GetLastError(), "")


@pytest.mark.parametrize("bounds", ((0, 0, 0, 1, 0, 1), (-np.inf, np.inf, 0, 1, 0, 1)), ids=("empty", "infinite"))
def test_plane_refuses_bad_boxes(bounds):
    """A plane widget refuses a box that is empty, and an infinite one, at which VTK crashes."""
    _, water, interactor = make()
    said = error_of(lambda: PlaneWidget(interactor, water, bounds))
    wt.check_equal(f"a box: {said}", "xmin < xmax" in said, True)


@pytest.mark.parametrize("make_widget", (make_slider, PlaneWidget), ids=("slider", "plane"))
@pytest.mark.parametrize("has_window, words", ((False, "has no window"), (True, "has no renderer")),
                         ids=("without a window", "without a renderer"))
def test_widget_needs_a_renderer(has_window, words, make_widget):
    """An interactor without a window, or whose window has no renderer, is refused."""
    interactor, water = vtkGenericRenderWindowInteractor(), make()[1]
    if has_window:
        interactor.SetRenderWindow(vtkRenderWindow())
    said = error_of(lambda: make_widget(interactor, water))
    wt.check_equal(f"cannot be: {said}", words in said, True)

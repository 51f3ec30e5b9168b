# SPDX-License-Identifier: BSD-3-Clause
"""A mouse that drags the slider floods the scene to where it lets go; one that drags the plane takes the water along."""

import numpy as np
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


def check_slider():
    view, water, interactor = make()
    levels = []
    slider = LevelSlider(interactor, water, -1.0, 1.0, changed=levels.append)
    before = view.picture()
    wt.save(before, wt.output_folder() / "LevelSlider.png")
    position = view.renderer.GetActiveCamera().GetPosition()
    # the tube reaches from 6 to 44 per cent of the width: level 0 is in its middle
    middle, quarter = (0.25 * SIZE[0], 0.1 * SIZE[1]), (0.345 * SIZE[0], 0.1 * SIZE[1])
    drag(interactor, middle, quarter)
    wt.check_at_most("level after a drag over a quarter of it, less 0.5", abs(water.GetLevel() - 0.5), 0.06)
    wt.check_equal("the last level told", levels[-1], water.GetLevel())
    wt.check_equal("the camera stays", view.renderer.GetActiveCamera().GetPosition(), position)
    wt.check_at_least("pixels that change", int((np.abs(view.picture() - before).max(axis=2) > 20).sum()), 2000)
    drag(interactor, quarter, (SIZE[0] - 1, quarter[1]))
    wt.check_equal("dragged beyond its end", water.GetLevel(), 1.0)
    slider.set_level(-0.25)
    wt.check_equal("set by the program", (water.GetLevel(), slider.widget.GetRepresentation().GetValue()), (-0.25, -0.25))
    for low, high in ((1.0, 0.0), (2.0, 3.0), (float("nan"), 1.0), (-float("inf"), 1.0)):
        try:
            LevelSlider(interactor, water, low, high)
            said = ""
        except ValueError as error:
            said = str(error)
        wt.check_equal(f"ends {low}, {high}: {said}", f"low {low}" in said, True)


def check_plane():
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
    for bounds in ((0, 0, 0, 1, 0, 1), (-np.inf, np.inf, 0, 1, 0, 1)):  # VTK crashes at infinite ones
        try:
            PlaneWidget(interactor, water, bounds)
            said = ""
        except ValueError as error:
            said = str(error)
        wt.check_equal(f"a box: {said}", "xmin < xmax" in said, True)


def check_before_the_first_frame():
    """Made before anything was rendered, and the interactor not initialised: a picture
    taken by vtkWindowToImageFilter crashes in VTK then."""
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


def check_no_window():
    bare, water = vtkGenericRenderWindowInteractor(), make()[1]
    blind = vtkGenericRenderWindowInteractor()
    blind.SetRenderWindow(vtkRenderWindow())
    for interactor, words in ((bare, "has no window"), (blind, "has no renderer")):
        for make_widget in (lambda: LevelSlider(interactor, water, -1.0, 1.0), lambda: PlaneWidget(interactor, water)):
            try:
                make_widget()
                said = ""
            except ValueError as error:
                said = str(error)
            wt.check_equal(f"cannot be: {said}", words in said, True)


check_before_the_first_frame()  # before any other: what crashed is OpenGL that was never loaded
check_slider()
check_plane()
check_no_window()
wt.finish()

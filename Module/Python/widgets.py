# SPDX-License-Identifier: BSD-3-Clause
"""VTK's own widgets for water: a slider for its level, and a plane to drag and rotate.

    slider = LevelSlider(interactor, water, 350.0, 400.0)
    plane = PlaneWidget(interactor, water)

Keep a reference to the object, or the widget is destroyed. Set the interactor's window first. These classes initialise
the interactor if necessary, because VTK otherwise crashes when a picture is taken.
"""
import math

import vtkmodules.vtkRenderingFreeType  # noqa: F401  the slider's text
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkInteractionWidgets import (
    vtkImplicitPlaneRepresentation,
    vtkImplicitPlaneWidget2,
    vtkSliderRepresentation2D,
    vtkSliderWidget,
)

from .errors import raising

__all__ = ["LevelSlider", "PlaneWidget"]


def initialize(interactor):
    if not interactor.GetRenderWindow():
        raise ValueError("the interactor has no window: call SetRenderWindow first")
    if not interactor.GetRenderWindow().GetRenderers().GetFirstRenderer():
        raise ValueError("the interactor's window has no renderer: call AddRenderer first")
    if not interactor.GetInitialized():
        interactor.Initialize()


def check_ends(low, high, level):
    """Raise a ValueError for an invalid range, or one that does not contain the level."""
    if not -math.inf < low <= level <= high < math.inf or not low < high:
        raise ValueError(
            f"low {low} and high {high}: low must be less than high, both finite, and "
            f"the water's level {level} between them"
        )


class LevelSlider:
    """A slider for the level of a horizontal water, along the window's lower edge.

    Parameters
    ----------
    interactor : :vtk:`vtkRenderWindowInteractor`
    water : vtkwater.vtkWaterActor
        It keeps its level, which must lie between the ends.
    low, high : float
        The ends of the slider, in the scene's unit: finite, low < high. Other values raise a ValueError.
    title : str, default: 'water level'
    changed : callable, optional
        Called with the new level after each change.
    """

    def __init__(self, interactor, water, low, high, title="water level", changed=None):
        initialize(interactor)
        level = water.GetLevel()
        check_ends(low, high, level)
        self._water, self._changed = water, changed
        representation = vtkSliderRepresentation2D()
        representation.SetMinimumValue(low)
        representation.SetMaximumValue(high)
        representation.SetValue(level)
        representation.SetTitleText(title)
        representation.SetLabelFormat("%.4g")
        representation.GetPoint1Coordinate().SetCoordinateSystemToNormalizedDisplay()
        representation.GetPoint1Coordinate().SetValue(0.06, 0.1)
        representation.GetPoint2Coordinate().SetCoordinateSystemToNormalizedDisplay()
        representation.GetPoint2Coordinate().SetValue(0.44, 0.1)
        representation.SetSliderLength(0.03)
        representation.SetTubeWidth(0.006)
        for text in (representation.GetTitleProperty(), representation.GetLabelProperty()):
            text.ShadowOff()
            text.ItalicOff()
        self.widget = vtkSliderWidget()
        self.widget.SetInteractor(interactor)
        self.widget.SetRepresentation(representation)
        self.widget.SetAnimationModeToJump()
        self.widget.AddObserver("InteractionEvent", self._slid)
        self.widget.AddObserver("EndInteractionEvent", self._slid)  # a click on the tube
        self.widget.EnabledOn()

    def set_level(self, level):
        """Moves water and slider; a level beyond the ends is clamped."""
        self.widget.GetRepresentation().SetValue(level)
        self._slid(self.widget, None)

    def _slid(self, widget, event):
        level = widget.GetRepresentation().GetValue()
        if level == self._water.GetLevel():
            return
        with raising(self._water):
            self._water.SetLevel(level)
        if self._changed:
            self._changed(level)


class PlaneWidget:
    """A plane to drag along its normal, and to rotate by dragging the normal; the water follows.

    Parameters
    ----------
    interactor : :vtk:`vtkRenderWindowInteractor`
    water : vtkwater.vtkWaterActor
    bounds : sequence[float], optional
        xmin, xmax, ymin, ymax, zmin, zmax of the box in which the plane stays: finite, each min < max. Other values
        raise a ValueError. The default is the bounds of the scene.
    changed : callable, optional
        Called with the water's :vtk:`vtkPlane` after each change.
    """

    def __init__(self, interactor, water, bounds=None, changed=None):
        initialize(interactor)
        self._water, self._changed = water, changed
        if bounds is None:
            renderer = interactor.GetRenderWindow().GetRenderers().GetFirstRenderer()
            bounds = renderer.ComputeVisiblePropBounds()
        if len(bounds) != 6 or not all(
                -math.inf < low < high < math.inf for low, high in zip(bounds[::2], bounds[1::2])):
            raise ValueError(f"bounds {tuple(bounds)}: they must be finite, xmin < xmax, ymin < ymax, zmin < zmax")
        representation = vtkImplicitPlaneRepresentation()
        representation.SetPlaceFactor(1.0)
        representation.OutlineTranslationOff()
        representation.DrawPlaneOff()  # the water is there
        representation.PlaceWidget(list(bounds))
        representation.SetOrigin(water.GetPlane().GetOrigin())
        representation.SetNormal(water.GetPlane().GetNormal())
        self.widget = vtkImplicitPlaneWidget2()
        self.widget.SetInteractor(interactor)
        self.widget.SetRepresentation(representation)
        self.widget.AddObserver("InteractionEvent", self._moved)
        self.widget.On()

    def _moved(self, widget, event):
        plane = vtkPlane()
        widget.GetRepresentation().GetPlane(plane)
        self._water.SetPlane(plane)
        if self._changed:
            self._changed(plane)

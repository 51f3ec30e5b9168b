# SPDX-License-Identifier: BSD-3-Clause
"""Tells the caller of add_water what would have no visible effect: an argument by an error, a position by a warning."""
import math
import warnings

from vtkmodules.vtkCommonCore import vtkMath
from vtkmodules.vtkCommonDataModel import vtkBoundingBox

from .surfaces import axis_of, plane_of

__all__ = ["check_has_effect", "heights_along", "tell_distance", "tell_level"]


def check_has_effect(surface, is_one_water, color_by, max_mirrors, **of_colors):
    """Raise a ValueError if an argument is given that has no effect without another one.

    is_one_water  whether all of the surface lies in one plane, because the level is a number
    """
    for name, value in of_colors.items():
        if value is not None and color_by is None:
            raise ValueError(f"{name} is {value!r}, but color_by is not given: {name} applies only to the colours of "
                             "an array")
    if max_mirrors is not None and surface is None:
        raise ValueError(f"max_mirrors is {max_mirrors}, but surface is not given: the built-in sheet is one water, "
                         "with one mirrored view")
    if max_mirrors is not None and is_one_water:
        raise ValueError(f"max_mirrors is {max_mirrors}, but level is a number: the surface is then one water, with "
                         "one mirrored view")


def heights_along(renderer, unit, normal, origin):
    """Lowest and highest height of the visible props over the origin, and their diagonal; None if there are none.

    unit  normal of the plane in the renderer's own coordinates, which are scaled
    """
    bounds = renderer.ComputeVisiblePropBounds()
    if not vtkMath.AreBoundsInitialized(bounds):
        return None
    scale = renderer.scale
    length = math.hypot(*axis_of(normal))
    base = vtkMath.Dot(plane_of(0.0, normal, origin, scale)[0], unit)
    ends = [sorted((part * bounds[2 * i], part * bounds[2 * i + 1])) for i, part in enumerate(unit)]
    low, high = ((sum(end[i] for end in ends) - base) / length for i in range(2))
    return low, high, math.hypot(*[(bounds[2 * i + 1] - bounds[2 * i]) / scale[i] for i in range(3)])


def tell_level(level, heights, is_sheet):
    """Warn of a level at which land hides all water, or water all land; is_sheet: the water ends with the scene."""
    low, high, diagonal = heights
    scene = f"heights in the scene lie in [{low:g}, {high:g}]"
    if is_sheet and low > level:
        warnings.warn(f"level is {level:g}, which is below the whole scene: the land hides the water; {scene}. Use a "
                      "higher level", stacklevel=3)
    if level - high > diagonal:
        warnings.warn(f"level is {level:g}, which is far above the whole scene: the water hides it; {scene}. Use a "
                      "lower level", stacklevel=3)


def tell_distance(surface, renderer):
    """Warn if a surface and the props other than water are farther apart than the sum of their diagonals.

    surface  its bounds in the renderer's own coordinates
    """
    box = vtkBoundingBox()
    for prop in renderer.GetViewProps():
        if prop.GetVisibility() and prop.GetUseBounds() and not prop.IsA("vtkWaterActor") and prop.GetBounds():
            box.AddBounds(prop.GetBounds())
    if not box.IsValid():
        return
    scene = [0.0] * 6
    box.GetBounds(scene)
    axes = [(surface[2 * i: 2 * i + 2], scene[2 * i: 2 * i + 2]) for i in range(3)]
    gap = math.hypot(*[max(ours[0] - theirs[1], theirs[0] - ours[1], 0.0) for ours, theirs in axes])
    sizes = sum(math.hypot(*[bounds[2 * i + 1] - bounds[2 * i] for i in range(3)]) for bounds in (surface, scene))
    if gap > sizes:
        where = "; ".join(f"{name} {ours[0]:g} to {ours[1]:g} and {theirs[0]:g} to {theirs[1]:g}"
                          for name, (ours, theirs) in zip("xyz", axes))
        warnings.warn(f"surface lies {gap:.3g} away from the scene, more than both diagonals together, and does not "
                      f"reflect it. Surface and scene lie in {where}. Do they have the same unit and origin?",
                      stacklevel=3)

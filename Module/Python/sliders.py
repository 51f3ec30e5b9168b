# SPDX-License-Identifier: BSD-3-Clause
"""The slider of a PyVista plotter that moves the level of a water."""
import math

from . import vtkWaterActor
from .widgets import check_ends
from .words import numbers

__all__ = ["add_water_level_slider"]

ROUNDING = 1e-12  # of a level that was set and is asked for


def add_water_level_slider(
    self, water, rng=None, *, origin=(0.0, 0.0, 0.0), title="water level", callback=None, **more
):
    """Add a slider to the active subplot that moves the level of a water.

    Parameters
    ----------
    water : vtkwater.vtkWaterActor
        The return value of ``add_water``. It keeps its level, which must lie between the slider's ends. The slider
        moves its plane along the normal, together with its ``surface`` if it has one.

    rng : sequence[float], optional
        The lowest and the highest level, in the unit of the scene's data, above ``origin`` along the water's normal.
        The default is the extent of the scene's bounds.

    origin : sequence[float], default: (0.0, 0.0, 0.0)
        The point from which the level is measured, as for ``add_water``.

    title : str, default: 'water level'

    callback : callable, optional
        Called with the new level after each change.

    **more
        Other arguments of ``Plotter.add_slider_widget``: ``pointa``, ``pointb``, ``color``, ``style``, ``fmt``, ...

    Returns
    -------
    vtkmodules.vtkInteractionWidgets.vtkSliderWidget
        The slider. The plotter keeps it; ``plotter.clear_slider_widgets()`` removes it.

    Raises
    ------
    TypeError
        If the water is not a vtkWaterActor, or an argument has the wrong type.

    ValueError
        If the ends are not finite or in the wrong order, or if the level is not between them; the text names them.
        Without ``rng`` also if the scene is flat.

    Examples
    --------
    >>> import pyvista as pv
    >>> import vtkwater.pyvista
    >>> plotter = pv.Plotter()
    >>> _ = plotter.add_mesh(pv.Cone(direction=(0, 0, 1)))
    >>> water = plotter.add_water(level=-0.2)
    >>> slider = plotter.add_water_level_slider(water, (-0.5, 0.5))  # doctest: +SKIP
    """
    if not isinstance(water, vtkWaterActor):
        raise TypeError(f"water must be a vtkWaterActor, not {type(water).__name__}")
    level = Level(water, numbers("origin", origin, 3), self.renderer.scale)
    at = level.get()
    low, high = heights_of(self.renderer, level) if rng is None else numbers("rng", rng, 2)
    check_ends(low, high, at)
    more.setdefault("interaction_event", "always")

    def moved(value, *widget):
        if math.isclose(value, level.get(), rel_tol=ROUNDING, abs_tol=ROUNDING * (high - low)):
            return
        level.set(value)
        if callback:
            callback(value, *widget)

    return self.add_slider_widget(moved, (low, high), value=at, title=title, **more)


class Level:
    """The level of a water in a renderer with a scaled scene."""

    def __init__(self, water, origin, scale):
        self._water, self._origin, self._scale = water, origin, scale
        normal = [part * factor for part, factor in zip(water.GetPlane().GetNormal(), scale)]
        self.normal = [part / math.hypot(*normal) for part in normal]

    def height(self, point):
        """Height of a point of the scaled scene."""
        return sum((at / factor - start) * part
                   for at, factor, start, part in zip(point, self._scale, self._origin, self.normal))

    def get(self):
        return self.height(self._water.GetPlane().GetOrigin())

    def set(self, value):
        way = [(value - self.get()) * part * factor for part, factor in zip(self.normal, self._scale)]
        plane = self._water.GetPlane()
        plane.SetOrigin([at + part for at, part in zip(plane.GetOrigin(), way)])
        if self._water.GetMeshPlacement([0.0] * 4):
            self._water.AddPosition(way)


def heights_of(renderer, level):
    """The lowest and the highest point of the bounds of all visible props."""
    bounds = renderer.ComputeVisiblePropBounds()
    heights = [level.height((x, y, z)) for x in bounds[:2] for y in bounds[2:4] for z in bounds[4:]]
    return min(heights), max(heights)

# SPDX-License-Identifier: BSD-3-Clause
"""The surface of a solver's water as the surface of a vtkWaterActor: what add_water does with arrays.

    surface = DataSurface(dataset, level="zeta", bed="zb")
    water.SetMapper(surface.mapper)
    surface.follow(water, renderer)  # each frame shows the arrays as they are then
"""
import math
import weakref

import numpy as np
import pyvista as pv

from . import vtkWaterSurfaceFilter
from .errors import raising

__all__ = ["DataSurface", "show_array"]


class DataSurface:
    """The wet part of a dataset at the level of its water (vtkWaterSurfaceFilter), and the mapper that draws it.

    Parameters
    ----------
    dataset : pyvista.DataSet
        Of two-dimensional cells.
    level, depth, bed : str, optional
        Names of arrays; the level or the depth is needed.

    Raises
    ------
    ValueError
        When there is no such array; the text lists those there are.
    """

    def __init__(self, dataset, level=None, depth=None, bed=None):
        self.filter = vtkWaterSurfaceFilter()
        self.filter.SetInputData(dataset)
        self.filter.SetLevelArrayName(level or "")
        self.filter.SetDepthArrayName(depth or "")
        self.filter.SetBedArrayName(bed or "")
        with raising(self.filter, LevelArrayName="level", DepthArrayName="depth"):
            self.filter.Update()
        self.mapper = pv.DataSetMapper()
        self.mapper.SetInputConnection(self.filter.GetOutputPort())
        self.mapper.ScalarVisibilityOff()

    def follow(self, water, renderer):
        """Keep the water's level at the mean of the surface, from frame to frame, while both are there."""
        known = weakref.ref(water)

        shown = self.filter.GetMeanLevel()

        def update(caller, event):
            nonlocal shown
            actor = known()
            if actor is None or not renderer.HasViewProp(actor):
                renderer.RemoveObserver(tag)
                return
            self.filter.Update()
            level = self.filter.GetMeanLevel()
            if level != shown:  # what the user sets meanwhile stays until the data change
                shown = level
                actor.SetLevel(level * actor.GetScale()[2])

        tag = renderer.AddObserver("StartEvent", update)


def show_array(mapper, dataset, name, cmap=None, clim=None):
    """Colour a mapper's surface by an array of points or cells.

    Parameters
    ----------
    mapper : vtkMapper
    dataset : pyvista.DataSet
        What the range is taken of, and the array's association.
    name : str
        Of an array of one component.
    cmap : str, optional
        A colour map of matplotlib's; by default that of PyVista's theme.
    clim : sequence[float], optional
        The least and the largest value with a colour of their own; by default those of the array.

    Raises
    ------
    ValueError
        When there is no such array, or it has several components, or the range is none.
    """
    arrays = [*dataset.point_data, *dataset.cell_data]
    if name not in arrays:
        raise ValueError(f"color_by is {name!r}; it must be one of the arrays {', '.join(arrays) or '(there is none)'}")
    is_of_points = name in dataset.point_data
    values = (dataset.point_data if is_of_points else dataset.cell_data)[name]
    if values.ndim != 1:
        raise ValueError(f"color_by is {name!r}, which has {values.shape[1]} components; it must have 1")
    if values.dtype.kind not in "buif":
        raise ValueError(f"color_by is {name!r}, an array of {values.dtype}; it must be one of real numbers")
    if clim is None and not np.isfinite(values).any():
        raise ValueError(f"color_by is {name!r}, which has no finite value; say clim")
    low, high = dataset.get_data_range(name) if clim is None else clim
    if not (low <= high and math.isfinite(high - low)):
        raise ValueError(f"clim is ({low:g}, {high:g}); it must be a lower and an upper value, both finite")
    if is_of_points:
        mapper.SetScalarModeToUsePointFieldData()
    else:
        mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray(name)
    mapper.SetColorModeToMapScalars()  # bytes are no colours
    mapper.SetLookupTable(pv.LookupTable(cmap or pv.global_theme.cmap, scalar_range=(low, high)))
    mapper.SetScalarRange(low, high)
    mapper.SetUseLookupTableScalarRange(True)
    mapper.SetInterpolateScalarsBeforeMapping(is_of_points)
    mapper.ScalarVisibilityOn()

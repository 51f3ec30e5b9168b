# SPDX-License-Identifier: BSD-3-Clause
"""The surface and the plane of add_water; a solver's mesh by the names of its arrays.

    surface = DataSurface(dataset, level="zeta", bed="zb")
    lakes = lakes_of(surface.mapper, "z")
    lakes.AddTo(renderer)  # each frame shows the current arrays
"""
import math
import warnings
from numbers import Real

import numpy as np
import pyvista as pv

from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkPolyData

from . import vtkWaterActor, vtkWaterLakes, vtkWaterSurfaceFilter
from .errors import heed, raising
from .readers import polygons_of, wrong_cell_of
from .words import numbers, of_type

__all__ = ["DataSurface", "check_has_water", "check_level", "color_surface", "exaggeration_of", "lakes_of",
           "level_and_surface", "plane_of", "surface_of"]


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
        If there is no such array; the text lists the existing ones.
    """

    def __init__(self, dataset, level=None, depth=None, bed=None):
        self.filter = vtkWaterSurfaceFilter()
        self.filter.SetInputData(dataset)
        self.filter.SetLevelArrayName(level or "")
        self.filter.SetDepthArrayName(depth or "")
        self.filter.SetBedArrayName(bed or "")
        self.told = []
        heed(self.filter, self._tell)
        with raising(self.filter, LevelArrayName="level", DepthArrayName="depth"):
            self.filter.Update()
        self.mapper = pv.DataSetMapper()
        self.mapper.SetInputConnection(self.filter.GetOutputPort())
        self.mapper.ScalarVisibilityOff()

    def _tell(self, text):
        self.told.append(text)
        warnings.warn(text, stacklevel=2)


def show_array(mapper, dataset, name, cmap=None, clim=None, log_scale=False):
    """Colour a mapper's surface by an array of points or cells.

    Parameters
    ----------
    mapper : vtkMapper
    dataset : pyvista.DataSet
        Source of the range, and of the array's association.
    name : str
        Name of an array with one component.
    cmap : str | vtkScalarsToColors, optional
        A matplotlib colour map; default: that of PyVista's theme. Or a lookup table, used as it is.
    clim : sequence[float], optional
        The smallest and the largest value of the colour map; default: those of the array.
    log_scale : bool, default: False
        Whether equal ratios, not equal differences, are equal steps of the colour map.

    Raises
    ------
    ValueError
        If there is no such array, if it has several components, if the range is invalid, or if a lookup table is
        given together with a range or a scale, which it has itself.
    """
    arrays = [*dataset.point_data, *dataset.cell_data]
    if name not in arrays:
        known = ", ".join(arrays) or "(there is none)"
        raise ValueError(f"color_by is {name!r}; it must be one of the arrays {known}")
    is_of_points = name in dataset.point_data
    values = (dataset.point_data if is_of_points else dataset.cell_data)[name]
    if values.ndim != 1:
        raise ValueError(f"color_by is {name!r}, which has {values.shape[1]} components; it must have 1 (for "
                         "vectors, add their magnitude as an array)")
    if values.dtype.kind not in "buif":
        raise ValueError(f"color_by is {name!r}, an array of {values.dtype}; it must hold real numbers")
    table = table_for(values, name, cmap, clim, log_scale)
    if is_of_points:
        mapper.SetScalarModeToUsePointFieldData()
    else:
        mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray(name)
    mapper.SetColorModeToMapScalars()  # bytes are no colours
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(table.GetRange())
    mapper.SetUseLookupTableScalarRange(True)
    mapper.SetInterpolateScalarsBeforeMapping(is_of_points)
    mapper.ScalarVisibilityOn()


def table_for(values, name, cmap, clim, log_scale):
    """The lookup table of an array's values."""
    if hasattr(cmap, "IsA") and cmap.IsA("vtkScalarsToColors"):
        if clim is not None or log_scale:
            word = "clim" if clim is not None else "log_scale"
            raise ValueError(f"{word} is given, and cmap is a {cmap.GetClassName()}, which has its own range and "
                             "scale; set them there")
        return cmap
    shown = values[np.isfinite(values)]
    if log_scale:
        shown = shown[shown > 0]
    if clim is None and not shown.size:
        raise ValueError(f"color_by is {name!r}, which has no finite value{' above 0' if log_scale else ''}; set clim")
    low, high = (float(shown.min()), float(shown.max())) if clim is None else clim
    if not (low <= high and math.isfinite(high - low)):
        raise ValueError(f"clim is ({low:g}, {high:g}); both must be finite, and the first must not exceed the second")
    if log_scale and low <= 0:
        raise ValueError(f"clim is ({low:g}, {high:g}); with log_scale both must be above 0")
    return table_of(pv.global_theme.cmap if cmap is None else cmap, low, high, bool(log_scale))


def table_of(cmap, low, high, log_scale=False):
    try:
        return pv.LookupTable(cmap, scalar_range=(low, high), log_scale=log_scale)
    except (TypeError, ValueError):
        raise ValueError(f"cmap is {cmap!r}; it must be the name of one of matplotlib's colour maps, such as "
                         "'viridis', a list of colours, or a lookup table") from None


def level_and_surface(water, level, surface):
    """Level and surface; one of them may be given as the positional argument."""
    if water is None:
        return level, surface
    if isinstance(water, pv.DataSet):
        if surface is not None:
            raise ValueError("surface is given twice: as the first argument and by name")
        return level, water
    if isinstance(water, pv.MultiBlock):
        raise TypeError("water must be a number or a pyvista.DataSet, not MultiBlock; "
                        "combine() merges its blocks into one")
    if level is not None:
        raise ValueError(f"level is given twice: {water!r} as the first argument, and level={level!r}")
    if isinstance(water, bool) or not isinstance(water, Real):
        raise TypeError(f"water must be a number or a pyvista.DataSet, not {type(water).__name__}")
    return float(water), surface


def surface_of(surface, level, depth, bed, normal, origin):
    """The mapper of a surface and, with arrays, its DataSurface; None for what does not exist."""
    names = {"level": level if isinstance(level, str) else None, "depth": depth, "bed": bed}
    given = {word: of_type(word, name, str) for word, name in names.items() if name is not None}
    if not given:
        return (None if surface is None else mapper_of(surface)), None
    word, name = next(iter(given.items()))
    if surface is None:
        raise ValueError(f"{word} is {name!r}, an array's name; it needs a surface with this array")
    if not isinstance(surface, pv.DataSet):
        raise TypeError(f"surface must be a pyvista.DataSet, not {type(surface).__name__}")
    if level is not None and "level" not in given:
        raise ValueError(f"level is {level!r}; together with {word}={name!r} it must be the name of an array")
    if normal != "z":
        raise ValueError(f"normal is {normal!r}; with arrays of heights it must be 'z'")
    if any(numbers("origin", origin, 3)):
        raise ValueError(f"origin is {tuple(origin)}; arrays of heights are measured from 0")
    if surface.n_cells == 0:
        raise ValueError("surface has no cells")
    check_cells_of(surface)
    data = DataSurface(surface, **given)
    is_known, texts = True, []
    for word, name in given.items():  # water may follow later
        values = np.asarray(surface[name], dtype=float)
        values = values[np.isfinite(values)]
        if not values.size:
            is_known = False
            warnings.warn(f"{word} is {name!r}, an array without a finite value: there is no water yet", stacklevel=3)
        else:
            texts.append(f"{name!r} is {values.min():g} to {values.max():g}")
    is_told = any("There is no water" in text for text in data.told)
    if is_known and not is_told and not data.filter.GetOutput().GetNumberOfCells():
        warnings.warn(f"nothing is wet yet: {', '.join(texts)}", stacklevel=3)
    return data.mapper, data


def color_surface(mapper, surface, name, cmap, clim, log_scale):
    if mapper is None:
        raise ValueError(f"color_by is {name!r}; it needs a surface with this array")
    ends = None if clim is None else numbers("clim", clim, 2)
    show_array(mapper, surface, of_type("color_by", name, str), cmap, ends, log_scale)


def lakes_of(mapper, normal):
    """The waters of a surface, one for each plane that its parts lie in."""
    lakes = vtkWaterLakes()
    lakes.SetUpDirection(*axis_of(normal))
    lakes.SetMapper(mapper)
    lakes.Update()
    return lakes


def check_has_water(mapper, lakes, normal):
    """Raises ValueError if no part of a surface can be water; lakes is None if one level applies to all of it."""
    mesh = pv.wrap(mapper.GetInput())
    if mesh.GetNumberOfPolys() + mesh.GetNumberOfStrips() == 0:
        raise ValueError(f"surface has no polygons, only {mesh.GetNumberOfVerts()} vertices and "
                         f"{mesh.GetNumberOfLines()} lines; water needs polygons")
    if not np.isfinite(mesh.points).all(axis=1).any():
        raise ValueError("surface has no point with finite coordinates")
    if lakes is not None and not lakes.GetWater().GetMapper().GetInput().GetNumberOfCells():
        x, y, z = axis_of(normal)
        raise ValueError(f"surface has no finite polygon with an area along the normal ({x:g}, {y:g}, {z:g}); a "
                         "surface that is parallel to this normal needs another normal")


def check_level(mapper, level, normal, origin):
    """Raises ValueError unless a surface's mean height over the origin along the normal is near the level."""
    water = vtkWaterActor()
    place, up = plane_of(level, normal, origin, (1.0, 1.0, 1.0))
    water.GetPlane().SetOrigin(place)
    water.GetPlane().SetNormal(up)
    water.SetMapper(mapper)
    placement = [0.0] * 4
    if water.GetMeshPlacement(placement) and abs(placement[0]) > placement[1]:
        raise ValueError(
            f"level is {level:g}, but the mean height of the surface along the normal is {level + placement[0]:g}; "
            f"the largest accepted difference is {placement[1]:g}, 1 % of the surface's diagonal. Omit level to use "
            "the mean"
        )


def axis_of(normal):
    """A direction, given by the name of an axis or by three numbers, which may have any length but 0."""
    axes = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1), "-x": (-1, 0, 0), "-y": (0, -1, 0), "-z": (0, 0, -1)}
    if isinstance(normal, str):
        if normal.lower() not in axes:
            raise ValueError(f"normal is {normal!r}; it must be one of {', '.join(axes)}, or three numbers")
        normal = axes[normal.lower()]
    normal = numbers("normal", normal, 3)
    if not 0.0 < math.hypot(*normal) < math.inf:
        raise ValueError(f"normal is {tuple(normal)}; it must be finite and not zero")
    return normal


def exaggeration_of(normal, scale):
    """The factor by which a scaled renderer draws depths along the normal deeper; 1 where there is no such factor."""
    along = [part != 0.0 for part in axis_of(normal)]
    if sum(along) != 1:
        return 1.0
    across = {factor for factor, is_along in zip(scale, along) if not is_along}
    return scale[along.index(True)] / across.pop() if len(across) == 1 else 1.0


def plane_of(level, normal, origin, scale):
    """Origin and normal of the water's plane in the renderer's own coordinates, which are scaled."""
    normal = axis_of(normal)
    length = math.hypot(*normal)
    origin = numbers("origin", origin, 3)
    point = [at + level * part / length for at, part in zip(origin, normal)]
    if not all(abs(part) < float("inf") for part in point):
        raise ValueError(f"origin is {tuple(origin)} and level is {level:g}; the plane's place must be finite")
    return [at * factor for at, factor in zip(point, scale)], [part / factor for part, factor in zip(normal, scale)]


class Outside(VTKPythonAlgorithmBase):
    """The polygons of a grid without its hidden cells, as a filter."""

    def __init__(self):
        super().__init__(nInputPorts=1, inputType="vtkDataSet", nOutputPorts=1, outputType="vtkPolyData")

    def RequestData(self, request, inputs, outputs):
        vtkPolyData.GetData(outputs).ShallowCopy(polygons_of(vtkDataSet.GetData(inputs[0])))
        return 1


def check_cells_of(surface):
    wrong = wrong_cell_of(surface)
    if wrong:
        raise ValueError(f"surface is not valid: {wrong}")


def mapper_of(surface):
    if not isinstance(surface, pv.DataSet):
        raise TypeError(f"surface must be a pyvista.DataSet, not {type(surface).__name__}")
    check_cells_of(surface)
    mapper = pv.DataSetMapper()
    if isinstance(surface, pv.PolyData):
        mapper.SetInputDataObject(surface)
    else:  # still connected: its points may move, and its arrays change
        outside = Outside()  # PyVista's extract_surface is about to do something else
        outside.SetInputDataObject(surface)
        outside.Update()
        mapper.SetInputConnection(outside.GetOutputPort())
    if mapper.GetInput().GetNumberOfCells() == 0:
        raise ValueError("surface has no cells")
    mapper.ScalarVisibilityOff()
    return mapper

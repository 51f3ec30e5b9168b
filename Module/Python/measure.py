# SPDX-License-Identifier: BSD-3-Clause
"""Measures the water of a solver's mesh: values at places, the shoreline, the flooded area and the volume.

    mesh = surface(water)                                    # vtkPolyData of all lakes, to export and to filter
    values = probe(water, [(120.0, 45.0), (130.0, 45.0)])    # {"WaterLevel": ..., "WaterDepth": ..., every array}
    values = profile(water, (120.0, 45.0), (130.0, 80.0))    # the same along a line, with "distance"
    values = gauges(solution, [(120.0, 45.0)], depth="h", bed="zb")  # the same at all steps of a file, with "time"
    line = shoreline(water, mesh)                            # vtkPolyData, polylines
    area, volume = flooded(water)                           # of the water as it is shown
    area, volume = flooded_cells(mesh, "depth")              # of the solver's own cells

Everything is measured in plan, over x and y, in the units of the mesh; vertical exaggeration of the picture
(VerticalScale, a scale of the actor) has no effect, except that the z of returned points, and "z" of probe, include
VerticalScale. The argument water is the output of a vtkWaterSurfaceFilter, or a vtkWaterActor that shows it. A
vtkWaterLakes, or the actor that PyVista's add_water returns, stands for all of its lakes. An actor that is taken from a
vtkWaterLakes (GetWater) stands for one lake, and so does the mesh of any actor's mapper.
"""
import warnings

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import reference, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkCellLocator, vtkGenericCell, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkFeatureEdges, vtkStripper
from vtkmodules.vtkRenderingCore import vtkMapper

from . import vtkWaterSurfaceFilter
from .errors import raising
from .readers import HIGHEST, polygons_of

__all__ = ["flooded", "flooded_cells", "gauges", "probe", "profile", "shoreline", "surface"]

COLORS = "WaterColors"
DEPTH = "WaterDepth"
# field data of vtkWaterPlanesFilter, for one lake
PLANES = "WaterPlaneOrigin", "WaterPlaneNormal", "WaterArea", "WaterPartBounds", "WaterIsRest"
WHOLE = "_vtkwater_whole"  # attribute of an actor: the mapper of all lakes that it stands for
RGB = 3  # VTK_RGB, a format of colours
NEAR = 1e-6  # of the diagonal of the bounds: places that are nearer are one


def surface(water):
    """Return the surface of a water as it is now, all lakes in one mesh, for writers and filters.

    The mesh of one actor's mapper, ``actor.GetMapper().GetInput()``, is only one of several lakes.

    Parameters
    ----------
    water : vtkWaterActor, vtkWaterLakes or vtkPolyData

    Returns
    -------
    vtkPolyData
        The wet part as it is shown, in the coordinates of the mesh: heights include VerticalScale, but no scale or
        transformation of the actor or the plotter. It has all arrays of the points and cells. If scalars colour the
        water, their array is the active one, and the array "WaterColors" (3 bytes for each point or cell, as for the
        scalars) has their colours, without reflections and light. The mesh shares its arrays with the water: copy
        it (DeepCopy) before you change them.

    Raises
    ------
    TypeError
        If water has the wrong type.
    ValueError
        If a point of the water is not finite.
    """
    shown = vtkPolyData()
    shown.ShallowCopy(surface_of(water))
    for name in PLANES:
        shown.GetFieldData().RemoveArray(name)
    if not water.IsA("vtkPolyData"):
        add_colors(shown, mapper_of(water))
    return shown


def probe(water, points):
    """Return the values of all arrays of the water at given places.

    Parameters
    ----------
    water : vtkWaterActor, vtkWaterLakes or vtkPolyData
    points : array_like
        n x 2 or n x 3: x and y of each place, in the coordinates of the mesh; z is ignored.

    Returns
    -------
    dict[str, numpy.ndarray]
        The n values of each array, NaN where there is no water. Arrays of points are interpolated linearly. If points
        and cells have an array of the same name, the values are those of the points. Arrays without a name are left
        out. "z" is the height of the surface as it is drawn; if the water has an array named "z", "z" is that array,
        and the height is "WaterZ".

    Raises
    ------
    ValueError
        If points has the wrong shape or is not finite, if a point of the water is not finite, or if an array has fewer
        values than the water has points or cells.
    TypeError
        If water has the wrong type.
    """
    places = places_of(points)
    surface = surface_of(water)
    arrays = arrays_of(surface)
    found = {name: np.full((len(places), *values.shape[1:]), np.nan) for name, (values, _) in arrays.items()}
    flat = flattened(surface)
    locator = locator_of(flat)
    near = NEAR * flat.GetLength()
    first = surface.GetNumberOfVerts() + surface.GetNumberOfLines()  # of the polygons
    cell, closest, corners = vtkGenericCell(), [0.0] * 3, [0.0] * 3
    for i, (x, y) in enumerate(places):
        number, part, distance = reference(0), reference(0), reference(0.0)
        if locator is None or not locator.FindClosestPointWithinRadius((x, y, 0.0), near, closest, cell, number, part,
                                                                       distance):
            continue
        weights = [0.0] * cell.GetNumberOfPoints()
        cell.EvaluatePosition(closest, [0.0] * 3, part, corners, distance, weights)
        ids = [cell.GetPointId(j) for j in range(cell.GetNumberOfPoints())]
        for name, (values, is_of_points) in arrays.items():
            found[name][i] = np.tensordot(weights, values[ids], 1) if is_of_points else values[first + int(number)]
    return found


def profile(water, start, end, count=200):
    """Return the values of all arrays of the water along a straight line in plan.

    Parameters
    ----------
    water : vtkWaterActor, vtkWaterLakes or vtkPolyData
    start, end : sequence[float]
        x and y of the line's ends, in the coordinates of the mesh.
    count : int
        Number of places along the line, including both ends; 2 or more.

    Returns
    -------
    dict[str, numpy.ndarray]
        The arrays of probe, and "distance", the distance of each place from the start. If the water itself has an
        array "distance", this name keeps the water's array, and the distance from the start is "WaterDistance".

    Raises
    ------
    TypeError, ValueError
        As probe; also if the count is below 2.
    """
    if not (isinstance(count, (int, np.integer)) and count >= 2):
        raise ValueError(f"count is {count!r}; it must be a whole number, 2 or more")
    ends = places_of([start, end])
    share = np.linspace(0.0, 1.0, count)
    values = probe(water, ends[0] + share[:, None] * (ends[1] - ends[0]))
    values["WaterDistance" if "distance" in values else "distance"] = share * np.hypot(*(ends[1] - ends[0]))
    return values


def gauges(solution, points, *, level=None, depth=None, bed=None, dry_depth=None, times=None):
    """Return the values of all arrays of the water at given places over time.

    Parameters
    ----------
    solution : vtkwater.solutions.Solution
        It must read the arrays that are named below; its other arrays are probed, too. It converts lengths
        that the file states in other units to metres.
    points : array_like
        n x 2 or n x 3: x and y of each place, in the coordinates of the mesh; z is ignored.
    level, depth, bed : str, optional
        Names of arrays, as in vtkWaterSurfaceFilter: two of them define the water.
    dry_depth : float, optional
        DryDepth of the filter.
    times : sequence[float], optional
        Default: those of the solution's steps.

    Returns
    -------
    dict[str, numpy.ndarray]
        "time" (m times), and for each array m x n values, NaN where or while there is no water. If the water has an
        array named "time", "time" is that array, and the times are "WaterTime".

    Raises
    ------
    TypeError, ValueError
        As probe; also if there is no such array.
    FileError
        If the file cannot be read at one of the times, or if a time is not among those of the file.

    Warns
    -----
    UserWarning
        If the file states a unit for one of the named arrays that is not a known unit of length.
    """
    from .solutions import odd_units  # it needs more of VTK than the others here

    places = places_of(points)
    for text in odd_units(solution, (level, depth, bed)):
        warnings.warn(f"{solution.path}: {text}", stacklevel=2)
    surface = vtkWaterSurfaceFilter()
    times = solution.times if times is None else times
    steps = []
    with raising(surface, LevelArrayName="level", DepthArrayName="depth", DryDepth="dry_depth"):
        surface.SetLevelArrayName(level or "")
        surface.SetDepthArrayName(depth or "")
        surface.SetBedArrayName(bed or "")
        if dry_depth is not None:
            surface.SetDryDepth(dry_depth)
        for time in times:
            surface.SetInputData(solution.at(time))
            surface.Update()
            steps.append(probe(surface.GetOutput(), places))
    # a step without water has no arrays
    shapes = {name: values.shape for step in steps for name, values in step.items()}
    found = {name: np.array([step.get(name, np.full(shape, np.nan)) for step in steps])
             for name, shape in shapes.items()}
    found["WaterTime" if "time" in found else "time"] = np.array(times, dtype=float)
    return found


def shoreline(water, mesh):
    """Return the lines along which the water ends within a solver's mesh: at its shores, and at dry land behind a dyke.

    Parameters
    ----------
    water : vtkWaterActor, vtkWaterLakes or vtkPolyData
    mesh : vtkDataSet
        The solver's mesh, the input of the filter. Where the water ends at the border of this mesh, there is no shore.

    Returns
    -------
    vtkPolyData
        Lines with the arrays of points of the water, at its heights as they are drawn.

    Raises
    ------
    TypeError
        If water or mesh has the wrong type.
    ValueError
        If a point of the water is not finite.
    """
    if not (hasattr(mesh, "IsA") and mesh.IsA("vtkDataSet")):
        raise TypeError(f"mesh must be a vtkDataSet, not {type(mesh).__name__}")
    edges = boundary(surface_of(water))
    border = boundary(flattened(polygons_of(mesh)))
    line = vtkPolyData()
    line.ShallowCopy(edges)
    count = edges.GetNumberOfLines()
    if count == 0:
        return line
    ends = vtk_to_numpy(edges.GetLines().GetConnectivityArray()).reshape(-1, 2)
    if border.GetNumberOfCells():
        locator = locator_of(border)
        near = NEAR * border.GetLength()
        middles = vtk_to_numpy(edges.GetPoints().GetData())[ends].mean(axis=1) * (1.0, 1.0, 0.0)
        cell, closest = vtkGenericCell(), [0.0] * 3
        ends = ends[[not locator.FindClosestPointWithinRadius(middle, near, closest, cell, reference(0), reference(0),
                                                              reference(0.0)) for middle in middles]]
    lines = vtkCellArray()
    for one, two in ends:
        lines.InsertNextCell(2, [int(one), int(two)])
    line.SetLines(lines)
    line.GetCellData().Initialize()
    joined = vtkStripper()
    joined.SetInputData(line)
    joined.JoinContiguousSegmentsOn()
    clean = vtkCleanPolyData()  # without the points of the border
    clean.PointMergingOff()
    clean.SetInputConnection(joined.GetOutputPort())
    clean.Update()
    return clean.GetOutput()


def flooded(water):
    """Return the area that is under water, in plan, and the volume of the water over its bed.

    The water ends where the bed rises above its level, as in the picture. In streams that are one or two
    cells wide, this volume is much smaller than that of the solver's whole cells, which flooded_cells measures.

    Parameters
    ----------
    water : vtkWaterActor, vtkWaterLakes or vtkPolyData

    Returns
    -------
    tuple[float, float]
        In square and cubic units of the mesh. The volume is NaN if no depth is known.

    Raises
    ------
    TypeError
        If water has the wrong type.
    ValueError
        If a point of the water is not finite, or if there are fewer depths than points.
    """
    surface = surface_of(water)
    if surface.GetNumberOfPoints() == 0:
        return 0.0, 0.0
    places = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    depth = surface.GetPointData().GetArray(DEPTH)
    depth = None if depth is None else values_of(depth, DEPTH, len(places), "points")
    area, volume = 0.0, 0.0
    for corners, _ in polygons_by_size(surface):
        middle = 0 if depth is None else depth[corners]
        x, y = (places[corners, axis] - places[corners[:, :1], axis] for axis in (0, 1))
        whole, filled = 0.0, 0.0
        for i in range(2, corners.shape[1]):  # a fan: where it leaves a concave polygon, its triangles are negative
            part = 0.5 * (x[:, i - 1] * y[:, i] - x[:, i] * y[:, i - 1])
            whole = whole + part
            if depth is not None:
                filled = filled + part * middle[:, [0, i - 1, i]].mean(axis=1)
        area += float(np.abs(whole).sum())
        volume += float("nan") if depth is None else float((np.sign(whole) * filled).sum())
    return area, volume


def flooded_cells(mesh, depth, dry_depth=0.0):
    """Return the area and the volume of a solver's wet cells: each cell has one depth.

    If the depths are those of points, the cell of a point is its share of the polygons around it: each polygon is
    divided equally among its corners, as in finite volumes on a median dual mesh (Barth and Jespersen 1989, "The Design
    and Application of Upwind Schemes on Unstructured Meshes").

    Parameters
    ----------
    mesh : vtkDataSet
        The solver's mesh, the input of the filter.
    depth : str
        Name of the array of depths, of points or cells; of points if both have one. NaN is dry, and so
        are depths beyond 1e9, the fill values of files.
    dry_depth : float
        Cells that are not deeper are dry; 0 or more, in the units of the mesh.

    Returns
    -------
    tuple[float, float]
        In square and cubic units of the mesh.

    Raises
    ------
    TypeError
        If mesh has the wrong type.
    ValueError
        If mesh has no such array, if that array has several components or fewer values than points or cells, or if
        dry_depth is negative or not finite.
    """
    if not (hasattr(mesh, "IsA") and mesh.IsA("vtkDataSet")):
        raise TypeError(f"mesh must be a vtkDataSet, not {type(mesh).__name__}")
    if not (np.isfinite(dry_depth) and dry_depth >= 0.0):
        raise ValueError(f"dry_depth is {dry_depth!r}; it must be 0 or more, and finite")
    surface = polygons_of(mesh)
    of_points = surface.GetPointData().GetArray(depth)
    array = of_points or surface.GetCellData().GetArray(depth)
    if array is None:
        names = [data.GetArrayName(i) for data in (surface.GetPointData(), surface.GetCellData())
                 for i in range(data.GetNumberOfArrays()) if data.GetArrayName(i)]
        raise ValueError(f"the mesh has no array '{depth}'; it has " + (", ".join(names) or "none"))
    if array.GetNumberOfComponents() != 1:
        raise ValueError(f"the array '{depth}' has {array.GetNumberOfComponents()} components; it must have 1")
    count, what = ((surface.GetNumberOfPoints(), "points") if of_points else (surface.GetNumberOfCells(), "cells"))
    depths = values_of(array, depth, count, what)
    areas = np.zeros(count)
    if count:
        places = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
        for corners, numbers in polygons_by_size(surface):
            x, y = (places[corners, axis] - places[corners[:, :1], axis] for axis in (0, 1))
            whole = 0.5 * np.abs((x * np.roll(y, -1, axis=1) - np.roll(x, -1, axis=1) * y).sum(axis=1))
            if of_points:
                np.add.at(areas, corners, whole[:, None] / corners.shape[1])
            else:
                np.add.at(areas, numbers, whole)
    wet = (depths > dry_depth) & (depths <= HIGHEST)
    return float(areas[wet].sum()), float((depths[wet] * areas[wet]).sum())


def places_of(points):
    """x and y of places, n x 2."""
    try:
        places = np.asarray(points, dtype=float)
    except (TypeError, ValueError):
        raise ValueError(f"points is {points!r:.80}; it must be n x 2 or n x 3 finite numbers") from None
    places = places.reshape(0, 2) if places.shape == (0,) else np.atleast_2d(places)
    if places.ndim != 2 or places.shape[1] not in (2, 3):
        raise ValueError(f"points are of shape {np.shape(points)}; they must be n x 2 or n x 3 finite numbers")
    wrong = np.flatnonzero(~np.isfinite(places[:, :2]).all(axis=1))
    if wrong.size:
        x, y = places[wrong[0], :2]
        raise ValueError(f"points has ({x:g}, {y:g}) at {wrong[0]}; they must be n x 2 or n x 3 finite numbers")
    return places[:, :2]


def arrays_of(surface):
    """The named numeric arrays of a surface, and its heights; for each, whether it belongs to points."""
    found = {}
    for data, count, what in ((surface.GetCellData(), surface.GetNumberOfCells(), "cells"),
                              (surface.GetPointData(), surface.GetNumberOfPoints(), "points")):
        for i in range(data.GetNumberOfArrays()):
            array = data.GetArray(i)
            if array is not None and array.GetName():
                found[array.GetName()] = values_of(array, array.GetName(), count, what), what == "points"
    heights = (vtk_to_numpy(surface.GetPoints().GetData())[:, 2].astype(float) if surface.GetNumberOfPoints() else
               np.zeros(0))
    found["WaterZ" if "z" in found else "z"] = heights, True
    return found


def values_of(array, name, count, what):
    """An array's values, one for each point or cell."""
    if array.GetNumberOfTuples() < count:
        raise ValueError(f"the array '{name}' has {array.GetNumberOfTuples()} values; the water has {count} {what}")
    return vtk_to_numpy(array).astype(float)


def surface_of(water):
    """The surface that a water shows, as it is now; polygons as they are."""
    surface = water
    if not (hasattr(water, "IsA") and water.IsA("vtkPolyData")):
        mapper = mapper_of(water)
        if mapper is None:
            raise TypeError("water must be a vtkWaterActor, vtkWaterLakes or vtkPolyData that has a mesh, "
                            f"not {type(water).__name__}")
        mapper.Update()
        if mapper.GetInput() is None:
            raise ValueError("water has a mapper without a mesh")
        surface = mapper.GetInput()
    surface = polygons_of(surface)
    if surface.GetNumberOfPoints():
        places = vtk_to_numpy(surface.GetPoints().GetData())
        wrong = np.flatnonzero(~np.isfinite(places).all(axis=1))
        if wrong.size:
            raise ValueError(f"point {wrong[0]} of the water is at ({', '.join(f'{x:g}' for x in places[wrong[0]])}); "
                             "it must be finite")
    return surface


def mapper_of(water):
    """The mapper of a water, or of all lakes that it stands for; None: it has none."""
    return getattr(water, WHOLE, None) or (water.GetMapper() if hasattr(water, "GetMapper") else None)


def add_colors(shown, mapper):
    """Gives a mesh the colours that a mapper shows; none, if its scalars do not colour it."""
    if not mapper.GetScalarVisibility():
        return
    is_of_cells = reference(0)
    array = vtkMapper.GetAbstractScalars(shown, mapper.GetScalarMode(), mapper.GetArrayAccessMode(), mapper.GetArrayId(),
                                         mapper.GetArrayName(), is_of_cells)
    if array is None or int(is_of_cells) not in (0, 1):
        return
    table = mapper.GetLookupTable()
    if not mapper.GetUseLookupTableScalarRange():
        table.SetRange(mapper.GetScalarRange())  # as the mapper does before it draws
    colors = table.MapScalars(array, mapper.GetColorMode(), mapper.GetArrayComponent(), RGB)
    colors.SetName(COLORS)
    data = shown.GetCellData() if int(is_of_cells) else shown.GetPointData()
    data.AddArray(colors)
    data.SetActiveScalars(array.GetName())


def flattened(surface):
    """The polygons and strips of a surface at z = 0, without arrays."""
    flat = vtkPolyData()
    flat.CopyStructure(surface)
    flat.SetVerts(vtkCellArray())
    flat.SetLines(vtkCellArray())
    if surface.GetNumberOfPoints() == 0:
        return flat
    places = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    places[:, 2] = 0.0
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(places, deep=True))
    flat.SetPoints(points)
    return flat


def locator_of(surface):
    if surface.GetNumberOfCells() == 0:
        return None
    locator = vtkCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    return locator


def boundary(surface):
    """The edges that belong to only one cell."""
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.BoundaryEdgesOn()
    edges.FeatureEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.ManifoldEdgesOff()
    edges.ColoringOff()
    edges.Update()
    return edges.GetOutput()


def polygons_by_size(surface):
    """Points of the polygons, polygons x corners for each number of corners, and the numbers of their cells; strips as
    triangles."""
    first = surface.GetNumberOfVerts() + surface.GetNumberOfLines()
    for cells, is_strips in ((surface.GetPolys(), False), (surface.GetStrips(), True)):
        ends = vtk_to_numpy(cells.GetOffsetsArray())
        points = vtk_to_numpy(cells.GetConnectivityArray())
        sizes = np.diff(ends)
        for size in np.unique(sizes[sizes >= 3]):
            corners = points[ends[:-1][sizes == size][:, None] + np.arange(size)]
            numbers = first + np.flatnonzero(sizes == size)
            if not is_strips:
                yield corners, numbers
                continue
            for i in range(2, size):
                yield corners[:, i - 2:i + 1], numbers
        first += cells.GetNumberOfCells()

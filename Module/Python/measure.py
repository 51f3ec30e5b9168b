# SPDX-License-Identifier: BSD-3-Clause
"""Measures the water of a solver's mesh: values at places, the shoreline, the flooded area and the volume.

    values = probe(water, [(120.0, 45.0), (130.0, 45.0)])    # {"WaterLevel": ..., "WaterDepth": ..., every array}
    line = shoreline(water, mesh)                            # vtkPolyData, polylines
    area, volume = flooded(water)

All is over x and y, in the units of the mesh: how high it is drawn (VerticalScale, a scale of the actor) changes
nothing. The water is a vtkWaterActor that shows the output of a vtkWaterSurfaceFilter, or that output.
"""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import reference, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkCellLocator, vtkGenericCell, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkFeatureEdges, vtkStripper
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

__all__ = ["flooded", "probe", "shoreline"]

DEPTH = "WaterDepth"
NEAR = 1e-6  # of the diagonal of the bounds: places that are nearer are one


def probe(water, points):
    """Values of all arrays of the water at places of it.

    Parameters
    ----------
    water : vtkWaterActor or vtkPolyData
    points : array_like
        n x 2 or n x 3: x and y of each place, in the coordinates of the mesh; z is not asked for.

    Returns
    -------
    dict[str, numpy.ndarray]
        For each array of points (linear between them) and of cells its n values, NaN where there is no water. "z" is
        the height of the surface as it is drawn.

    Raises
    ------
    ValueError
        When the points are no such array, or not finite.
    """
    places = np.atleast_2d(np.asarray(points, dtype=float))
    if places.ndim != 2 or places.shape[1] not in (2, 3) or not np.isfinite(places[:, :2]).all():
        raise ValueError(f"points are of shape {np.shape(points)}; they must be n x 2 or n x 3 finite numbers")
    surface = surface_of(water)
    arrays = {data.GetArrayName(i): (vtk_to_numpy(data.GetArray(i)).astype(float), data is surface.GetPointData())
              for data in (surface.GetCellData(), surface.GetPointData())
              for i in range(data.GetNumberOfArrays()) if data.GetArray(i) is not None}
    arrays["z"] = vtk_to_numpy(surface.GetPoints().GetData())[:, 2].astype(float), True
    found = {name: np.full((len(places), *values.shape[1:]), np.nan) for name, (values, _) in arrays.items()}
    flat = flattened(surface)
    locator = locator_of(flat)
    near = NEAR * flat.GetLength()
    cell, closest, corners = vtkGenericCell(), [0.0] * 3, [0.0] * 3
    for i, (x, y) in enumerate(places[:, :2]):
        number, part, distance = reference(0), reference(0), reference(0.0)
        if locator is None or not locator.FindClosestPointWithinRadius((x, y, 0.0), near, closest, cell, number, part,
                                                                       distance):
            continue
        weights = [0.0] * cell.GetNumberOfPoints()
        cell.EvaluatePosition(closest, [0.0] * 3, part, corners, distance, weights)
        ids = [cell.GetPointId(j) for j in range(cell.GetNumberOfPoints())]
        for name, (values, is_of_points) in arrays.items():
            found[name][i] = np.tensordot(weights, values[ids], 1) if is_of_points else values[int(number)]
    return found


def shoreline(water, mesh):
    """Where the water ends within a solver's mesh, as polylines: at its shores, and at dry land behind a dyke.

    Parameters
    ----------
    water : vtkWaterActor or vtkPolyData
    mesh : vtkDataSet
        The solver's mesh, the input of the filter. Where the water ends with it is no shore.

    Returns
    -------
    vtkPolyData
        Lines with the arrays of points of the water, at its heights as they are drawn.
    """
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
    """The area that is under water, in plan, and the volume of the water over its bed.

    Parameters
    ----------
    water : vtkWaterActor or vtkPolyData

    Returns
    -------
    tuple[float, float]
        Square and cubic units of the mesh. The volume is NaN where no depth is known.
    """
    surface = surface_of(water)
    places = vtk_to_numpy(surface.GetPoints().GetData()).astype(float) if surface.GetNumberOfPoints() else None
    depth = surface.GetPointData().GetArray(DEPTH)
    depth = None if depth is None else vtk_to_numpy(depth)
    area, volume = 0.0, 0.0
    for corners in fans_of(surface) if places is not None else ():
        x, y = places[corners, 0], places[corners, 1]
        part = 0.5 * np.abs((x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0]))
        area += float(part.sum())
        volume += float("nan") if depth is None else float((part * depth[corners].mean(axis=1)).sum())
    return area, volume


def surface_of(water):
    """The surface that a water shows, as it is now; polygons as they are."""
    if hasattr(water, "IsA") and water.IsA("vtkPolyData"):
        return water
    mapper = water.GetMapper() if hasattr(water, "GetMapper") else None
    if mapper is None:
        raise TypeError(f"water must be a vtkWaterActor or vtkPolyData, not {type(water).__name__}")
    mapper.Update()
    return polygons_of(mapper.GetInput())


def polygons_of(data):
    if data.IsA("vtkPolyData"):
        return data
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(data)
    surface.Update()
    return surface.GetOutput()


def flattened(surface):
    """The same at z = 0, without arrays."""
    flat = vtkPolyData()
    flat.CopyStructure(surface)
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
    """Edges of one cell only."""
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.BoundaryEdgesOn()
    edges.FeatureEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.ManifoldEdgesOff()
    edges.ColoringOff()
    edges.Update()
    return edges.GetOutput()


def fans_of(surface):
    """Triangles of the polygons, n x 3 points each: the polygons with as many corners, as fans."""
    polygons = surface.GetPolys()
    ends = vtk_to_numpy(polygons.GetOffsetsArray())
    points = vtk_to_numpy(polygons.GetConnectivityArray())
    sizes = np.diff(ends)
    for size in np.unique(sizes[sizes >= 3]):
        corners = points[ends[:-1][sizes == size][:, None] + np.arange(size)]
        for i in range(2, size):
            yield corners[:, [0, i - 1, i]]

# SPDX-License-Identifier: BSD-3-Clause
"""Reads meshes and elevation models as surfaces.

    ground = read("terrain.tif")    # a Surface
    ground.data                     # vtkPolyData, z up
    ground.is_terrain               # True: heights over a map, with the point array "Elevation"

A FileError is raised if the file is missing, empty, of an unknown type, or not of the type that its suffix claims.
"""
import contextlib
import math
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkPoints, vtkStringOutputWindow, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkDataSetAttributes,
    vtkGenericCell,
    vtkImageData,
    vtkPolyData,
)
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

from .ply import missing_of

__all__ = ["ELEVATION", "FileError", "KINDS", "Surface", "calm_around", "read", "surface_of_heights"]

ELEVATION = "Elevation"  # the point array of a terrain: heights in the file's unit
MOST_POINTS = 4_000_000  # of an elevation model; of a larger one every n-th row and column is taken
# Over and under 0, of levels, too: what formats write where they know no height lies far beyond.
HIGHEST = 1e9
METRES_PER_DEGREE = 6371008.8 * math.pi / 180  # of a great circle, mean radius of the Earth (IUGG 1980)
# Tags of TIFF: "OGC GeoTIFF Standard 1.1" (2019), and GDAL's for holes
TIFF_PIXEL_SCALE, TIFF_TIEPOINT, TIFF_GEO_KEYS, TIFF_NO_DATA = 33550, 33922, 34735, 42113
TIFF_TRANSFORMATION = 34264  # in place of scale and tie point
TIFF_BEGINS = (b"II*\0", b"MM\0*")
ONE_BAND = "write one file per band, such as velocity_x_0.tif and velocity_y_0.tif"
GEO_KEY_MODEL_TYPE, MODEL_TYPE_GEOGRAPHIC = 1024, 2
GEO_KEY_LINEAR_UNITS, GEO_KEY_VERTICAL_UNITS = 3076, 4099
METRES_OF_CODE = {9002: 0.3048, 9003: 1200 / 3937}  # EPSG's international foot and US survey foot


class FileError(ValueError):
    """A file that cannot be used, and why."""


@dataclass
class Surface:
    """The surface in a file, with z up."""

    data: vtkPolyData
    is_terrain: bool = False
    note: str = ""  # what was left out while reading


def read(file, no_data=None):
    """Read the surface in a file. The suffix selects the type; KINDS lists the known ones.

    Parameters
    ----------
    file : str or pathlib.Path
    no_data : float, optional
        An additional no-data value of an elevation model. NaN and the file's own no-data value are always holes.

    Returns
    -------
    Surface

    Raises
    ------
    FileError
        If the file is missing, empty, of an unknown type, or not of the type that its suffix claims.
    """
    path = Path(file)
    return kind_of(path, KINDS)(path, no_data)


def kind_of(path, kinds):
    """The entry of kinds for a file's suffix; a FileError if the file does not exist or the suffix is unknown."""
    kind = kinds.get(path.suffix.lower())
    if path.is_dir():
        raise FileError(f"{path}: is a folder, not a file")
    if not path.is_file():
        raise FileError(f"{path}: no such file")
    if not kind:
        raise FileError(f"{path}: unknown file type {path.suffix or '(no suffix)'}; "
                        f"known types are {', '.join(kinds)}")
    return kind


def is_no_data(values, no_data):
    """Which numbers are the no-data value. Files state this value with more digits than pixels of 32 bits have."""
    if values.dtype != np.float32:
        return values == no_data
    with np.errstate(over="ignore"):
        return values == np.float32(no_data)


def surface_of_heights(heights, spacing=(1.0, 1.0), origin=(0.0, 0.0), no_data=None):
    """The surface over a grid of heights: rows x columns, from south to north and west to east.

    Heights that are not finite, or equal to no_data, are holes and are not filled. Heights beyond HIGHEST are holes
    too; the note counts them. Raises a FileError if nothing is left.
    """
    given = np.asarray(heights)
    heights = np.array(heights, dtype=float)
    if heights.ndim != 2 or min(heights.shape) < 2:
        raise FileError(f"{' x '.join(map(str, heights.shape))} heights are not a grid; at least 2 x 2 are required")
    step = math.ceil(math.sqrt(heights.size / MOST_POINTS))
    notes = []
    if step > 1:
        notes.append(f"of {heights.shape[1]} x {heights.shape[0]} heights, one row and column in {step} is used")
    heights = heights[::step, ::step]
    known = np.isfinite(heights)
    if no_data is not None and math.isfinite(no_data):
        known &= ~is_no_data(given[::step, ::step], no_data)
    beyond = known & (np.abs(heights) > HIGHEST)
    if beyond.any():
        notes.append(f"{beyond.sum()} of its heights, the first is {heights[beyond][0]:g}, are treated as holes; "
                     f"valid heights lie in [{-HIGHEST:g}, {HIGHEST:g}]")
    known &= ~beyond
    is_cell = known[:-1, :-1] & known[:-1, 1:] & known[1:, 1:] & known[1:, :-1]
    if not is_cell.any():
        raise FileError("; ".join(["has no elevations, only holes", *notes]))

    rows, columns = np.nonzero(is_cell)
    first = rows * heights.shape[1] + columns
    corners = np.stack([first, first + 1, first + heights.shape[1] + 1, first + heights.shape[1]], axis=1)
    used, corners = np.unique(corners, return_inverse=True)  # points of holes would spoil the bounds
    z = heights.ravel()[used]
    places = np.stack([origin[0] + step * spacing[0] * (used % heights.shape[1]),
                       origin[1] + step * spacing[1] * (used // heights.shape[1]), z], axis=1)
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(places, deep=True))
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(np.arange(0, corners.size + 1, 4, dtype=np.int64), deep=True),
                  numpy_to_vtkIdTypeArray(corners.ravel().astype(np.int64), deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(cells)
    elevation = numpy_to_vtk(z, deep=True)
    elevation.SetName(ELEVATION)
    data.GetPointData().SetScalars(elevation)
    return Surface(data, is_terrain=True, note="; ".join(notes))


def calm_around(bounds, reach):
    """The level z = 0 around a surface with these bounds, to a distance from the origin along both axes."""
    west, east, south, north = bounds[:4]
    data = surface_of_heights(np.zeros((4, 4))).data
    x, y = np.meshgrid((-reach, west, east, reach), (-reach, south, north, reach))
    data.GetPoints().SetData(numpy_to_vtk(np.stack([x, y, 0.0 * x], axis=2).reshape(-1, 3), deep=True))
    data.BuildCells()
    data.DeleteCell(4)  # the middle one: there is the surface
    data.RemoveDeletedCells()
    return data


def polygons_of(data):
    """The polygons of a data set: its surface if it has cells of volume.

    Hidden cells of grids are left out. vtkPolyData is as it is: VTK draws them.
    """
    wrong = wrong_cell_of(data)
    if wrong:
        raise ValueError(f"the mesh is not valid: {wrong}")
    if data.IsA("vtkPolyData"):
        return data
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(data)
    surface.Update()
    polygons = surface.GetOutput()
    if not data.IsA("vtkUnstructuredGrid"):  # of the others VTK's filter keeps them, and leaves them to mappers
        leave_hidden(polygons)
    return polygons


def leave_hidden(polygons):
    """Delete hidden cells, and those with a hidden point. Points stay."""
    hidden = marked(polygons.GetCellData(), polygons.GetNumberOfCells(), vtkDataSetAttributes.HIDDENCELL)
    points = marked(polygons.GetPointData(), polygons.GetNumberOfPoints(), vtkDataSetAttributes.HIDDENPOINT)
    if points.any():
        first = 0
        for cells in (polygons.GetVerts(), polygons.GetLines(), polygons.GetPolys(), polygons.GetStrips()):
            starts, corners = (vtk_to_numpy(part) for part in (cells.GetOffsetsArray(), cells.GetConnectivityArray()))
            owners = np.repeat(np.arange(len(starts) - 1), np.diff(starts))
            hidden[first + owners[points[corners]]] = True
            first += len(starts) - 1
    if hidden.any():
        polygons.BuildCells()
        for cell in np.flatnonzero(hidden).tolist():
            polygons.DeleteCell(cell)
        polygons.RemoveDeletedCells()


def marked(attributes, count, bit):
    """For each point or cell, whether VTK's marks of ghosts have a bit."""
    found = np.zeros(count, bool)
    marks = attributes.GetArray(vtkDataSetAttributes.GhostArrayName())
    if marks is not None and marks.IsA("vtkUnsignedCharArray"):
        values = vtk_to_numpy(marks).ravel()[:count]
        found[:len(values)] = values & bit != 0
    return found


@contextlib.contextmanager
def heard(path, what):
    """Turn an error that VTK reports in the block into a FileError, which says that the file is not a ``what``."""
    log = vtkStringOutputWindow()
    shown, verbosity = vtkOutputWindow.GetInstance(), vtkLogger.GetCurrentVerbosityCutoff()
    vtkOutputWindow.SetInstance(log)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # it has the same texts again
    try:
        yield
    finally:
        vtkOutputWindow.SetInstance(shown)
        vtkLogger.SetStderrVerbosity(verbosity)
    if "ERROR" in log.GetOutput().upper():
        lines = [line for line in log.GetOutput().splitlines()
                 if line and not re.match(r"(ERROR|Warning|Generic Warning): In ", line)]
        reason = lines[0].partition("): ")[2] or lines[0] if lines else "reading stopped before its end"
        raise FileError(f"{path}: not {what}: {reason}")


def run(reader, path, what):
    """The reader's output; errors that VTK reports meanwhile become a FileError."""
    with heard(path, what):
        if hasattr(reader, "CanReadFile") and not reader.CanReadFile(str(path)):
            raise FileError(f"{path}: not {what}")
        reader.SetFileName(str(path))
        reader.Update()
    if reader.GetErrorCode():
        raise FileError(f"{path}: not {what}: reading stopped before its end")
    return reader.GetOutput()


def reader_of(module, name):
    """VTK's reader of this name; None if this version of VTK has none."""
    made = getattr(__import__(f"vtkmodules.{module}", fromlist=[name]), name, None)
    return made() if made else None


def read_mesh(module, name, what):
    """Return a function that reads meshes with VTK's reader of this name."""
    def read_it(path, no_data):
        data = run(reader_of(module, name), path, what)
        if data is None:
            raise FileError(f"{path}: has no data set that can be shown")
        if data.IsA("vtkImageData"):
            return surface_of_image(data, path, no_data)
        check_cells(data, path)
        normals = vtkPolyDataNormals()
        normals.SetInputData(polygons_of(data))
        normals.SetFeatureAngle(40.0)
        normals.Update()
        if normals.GetOutput().GetNumberOfCells() == 0:
            raise FileError(f"{path}: is empty: it has no cells")
        places = vtk_to_numpy(normals.GetOutput().GetPoints().GetData())
        beyond = ~(np.abs(places) <= HIGHEST).all(axis=1)  # also NaN
        if beyond.any():
            raise FileError(f"{path}: has a point at ({', '.join(f'{part:g}' for part in places[beyond][0])}); "
                            f"coordinates must lie in [{-HIGHEST:g}, {HIGHEST:g}]")
        return Surface(normals.GetOutput())
    return read_it


def read_ply(path, no_data):
    missing = missing_of(path)
    if missing:
        raise FileError(f"{path}: not a PLY mesh: {missing}")
    return read_mesh("vtkIOPLY", "vtkPLYReader", "a PLY mesh")(path, no_data)


def check_cells(data, path):
    """Raise FileError for wrong cells: readers accept any, and filters crash on them."""
    wrong = wrong_cell_of(data)
    if wrong:
        raise FileError(f"{path}: {wrong}")


def dimensions_of(grid):
    dimensions = [0, 0, 0]
    try:
        grid.GetDimensions(dimensions)
    except TypeError:  # VTK 9.1, of rectilinear grids
        dimensions = grid.GetDimensions()
    return dimensions


def wrong_cell_of(data):
    """What VTK's filters would crash on: a point that does not exist, or a cell with fewer points than its type has."""
    count = data.GetNumberOfPoints()
    if data.IsA("vtkStructuredGrid"):
        dimensions = dimensions_of(data)
        wanted = math.prod(dimensions)
        return "" if count >= wanted else f"the grid has {count} points; its dimensions need {wanted}"
    if data.IsA("vtkRectilinearGrid"):
        dimensions = dimensions_of(data)
        axes = (data.GetXCoordinates(), data.GetYCoordinates(), data.GetZCoordinates())
        has = [axis.GetNumberOfTuples() if axis else 0 for axis in axes]
        return next((f"the grid has {has[i]} coordinates along axis {i}; its dimensions need {dimensions[i]}"
                     for i in range(3) if has[i] < dimensions[i]), "")
    if data.IsA("vtkPolyData"):
        arrays = [data.GetVerts(), data.GetLines(), data.GetPolys(), data.GetStrips()]
    elif data.IsA("vtkUnstructuredGrid"):
        arrays = [data.GetCells()] if data.GetCells() else []  # none if the file has no types of cells
    else:
        return ""
    first = 0
    for cells in arrays:
        points = vtk_to_numpy(cells.GetConnectivityArray())
        offsets = vtk_to_numpy(cells.GetOffsetsArray())
        if offsets.size and (offsets[0] != 0 or (np.diff(offsets) < 0).any() or offsets[-1] > points.size):
            return f"offsets of its cells are wrong; they must ascend from 0 to at most {points.size}"
        wrong = np.flatnonzero((points < 0) | (points >= count))
        if wrong.size:
            cell = first + int(np.searchsorted(offsets, wrong[0], side="right")) - 1
            return f"cell {cell} refers to point {points[wrong[0]]}; there are {count}, from 0"
        first += cells.GetNumberOfCells()
    return missing_corner_of(data) if data.IsA("vtkUnstructuredGrid") and data.GetNumberOfCells() else ""


def missing_corner_of(grid):
    sizes = np.diff(vtk_to_numpy(grid.GetCells().GetOffsetsArray()))
    kept = vtkUnsignedCharArray()  # since 9.6 VTK may have them as one number for all cells
    kept.DeepCopy(grid.GetCellTypes() if hasattr(grid, "GetDistinctCellTypes") else grid.GetCellTypesArray())
    types = vtk_to_numpy(kept)
    if types.size < sizes.size:
        return f"the grid has {types.size} cell types; it has {sizes.size} cells"
    for number in np.unique(types):
        cell = vtkGenericCell.InstantiateCell(int(number))
        wanted = cell.GetNumberOfPoints() if cell else 0  # 0: any number
        wrong = np.flatnonzero((types == number) & (sizes < wanted))
        if wrong.size:
            return (f"cell {wrong[0]} has {sizes[wrong[0]]} point{'' if sizes[wrong[0]] == 1 else 's'}; "
                    f"cells of its type ({number}) have {wanted}")
    return ""


def surface_of_image(image: vtkImageData, path, no_data):
    scalars = image.GetPointData().GetScalars()
    columns, rows, layers = image.GetDimensions()
    if not scalars or scalars.GetNumberOfComponents() != 1 or layers != 1:
        raise FileError(f"{path}: has no elevations; it must be an image of one layer with one number per point")
    heights = vtk_to_numpy(scalars).reshape(rows, columns).astype(float)
    ghosts = image.GetPointGhostArray()
    if ghosts:
        hidden = vtk_to_numpy(ghosts).reshape(rows, columns) & vtkDataSetAttributes.HIDDENPOINT
        heights[hidden != 0] = math.nan
    return with_path(path, heights, image.GetSpacing()[:2], image.GetOrigin()[:2], no_data)


def read_tiff(path, no_data):
    heights, spacing, origin, no_data, _ = grid_of_tiff(path, no_data)
    return with_path(path, heights, spacing, origin, no_data)


def grid_of_tiff(path, no_data=None):
    """The numbers of a GeoTIFF file: rows from south to north, spacing, origin, no-data value or None, place.

    Lengths in feet, and numbers whose vertical unit is feet, are converted to metres. The place is the position of
    the first pixel, in metres or degrees. For degrees the origin is (0, 0).
    """
    try:
        from PIL import Image
    except ImportError:
        raise FileError(f"{path}: reading TIFF needs Pillow: pip install pillow (Debian: python3-pil)") from None
    Image.MAX_IMAGE_PIXELS = None  # elevation models are large
    try:
        with Image.open(path) as image:
            if image.format != "TIFF":
                raise FileError(f"{path}: not a TIFF image but {image.format}")
            no_data_tag = image.tag_v2.get(TIFF_NO_DATA)
            spacing, tie, keys, matrix = (
                numbers_of(image.tag_v2.get(tag), tag, path)
                for tag in (TIFF_PIXEL_SCALE, TIFF_TIEPOINT, TIFF_GEO_KEYS, TIFF_TRANSFORMATION))
            heights = np.asarray(image)
    except Image.UnidentifiedImageError as error:
        with open(path, "rb") as file:
            hint = f", or of several bands: {ONE_BAND}" if file.read(4) in TIFF_BEGINS else ""
        raise FileError(f"{path}: not a readable TIFF image: {error}{hint}") from None
    except OSError as error:
        raise FileError(f"{path}: not a readable TIFF image: {error}") from None
    if heights.ndim != 2:
        raise FileError(f"{path}: has no elevations: it has {heights.shape[2]} numbers per pixel instead of one; "
                        f"{ONE_BAND}")
    if no_data is None and no_data_tag:
        try:
            no_data = float(str(no_data_tag).strip("\0 "))
        except ValueError:
            raise FileError(f"{path}: its no-data value {no_data_tag!r} is not a number") from None
    if matrix and not spacing:
        spacing, tie = scale_and_tie_of(matrix, path)
    spacing = (spacing or (1.0, 1.0))[:2]
    if len(spacing) != 2 or not all(0.0 < part < math.inf for part in spacing):
        raise FileError(f"{path}: its pixel size is {' x '.join(map(str, spacing))}; "
                        "it must be two numbers greater than 0")
    tie += (0.0,) * 6
    if not all(map(math.isfinite, tie)):
        raise FileError(f"{path}: its tie point {tie[:6]} is not finite")
    upright = metres_of(keys, GEO_KEY_VERTICAL_UNITS)
    if upright != 1.0:
        heights = upright * heights.astype(float)
        no_data = None if no_data is None else upright * no_data
    south = tie[4] - spacing[1] * (heights.shape[0] - 1 - tie[1])
    place = (tie[3] - spacing[0] * tie[0], south)
    if (GEO_KEY_MODEL_TYPE, 0, 1, MODEL_TYPE_GEOGRAPHIC) in zip(*(keys[i::4] for i in range(4))):
        # degrees: metres on a plane that touches the Earth in the middle of the map
        latitude = south + 0.5 * spacing[1] * (heights.shape[0] - 1)
        if not -90.0 < latitude < 90.0:
            raise FileError(f"{path}: its centre is at latitude {latitude:g}; it must lie between -90 and 90 degrees")
        middle = math.radians(latitude)
        spacing = (spacing[0] * METRES_PER_DEGREE * math.cos(middle), spacing[1] * METRES_PER_DEGREE)
        return heights[::-1], spacing, (0.0, 0.0), no_data, place
    metres = metres_of(keys, GEO_KEY_LINEAR_UNITS)
    spacing, place = (tuple(metres * part for part in pair) for pair in (spacing, place))
    return heights[::-1], spacing, place, no_data, place


def scale_and_tie_of(matrix, path):
    """Pixel size and tie point of a matrix from column and row to place, by rows."""
    if len(matrix) != 16:
        raise FileError(f"{path}: its transformation has {len(matrix)} numbers; it must have 16")
    x_columns, x_rows, _, west, y_columns, y_rows, _, north = matrix[:8]
    turn = max(abs(x_rows), abs(y_columns))
    if not (x_columns > 0.0 and y_rows < 0.0 and turn <= 1e-9 * min(x_columns, -y_rows)):
        raise FileError(f"{path}: its pixels are not in rows from west to east and north to south: x is {x_columns:g} "
                        f"column {x_rows:+g} row, y is {y_columns:g} column {y_rows:+g} row; gdalwarp corrects this")
    return (x_columns, -y_rows), (0.0, 0.0, 0.0, west, north, 0.0)


def metres_of(keys, key):
    """Metres in the unit that one of the keys of a GeoTIFF file names; 1 without such a key, and for other units."""
    return next((METRES_OF_CODE.get(value, 1.0) for found, where, count, value in zip(*(keys[i::4] for i in range(4)))
                 if (found, where, count) == (key, 0, 1)), 1.0)


def numbers_of(value, tag, path):
    """The numbers of a tag, which Pillow gives as nothing, a value, or a tuple."""
    values = value if isinstance(value, tuple) else () if value is None else (value,)
    try:
        return tuple(map(float, values))
    except (TypeError, ValueError):
        raise FileError(f"{path}: its tag {tag} is {value!r}; it must be numbers") from None


def with_path(path, heights, spacing, origin, no_data):
    try:
        return surface_of_heights(heights, spacing, origin, no_data)
    except FileError as error:
        raise FileError(f"{path}: {error}") from None


KINDS = {
    ".tif": read_tiff,
    ".tiff": read_tiff,
    ".vti": read_mesh("vtkIOXML", "vtkXMLImageDataReader", "a VTK image (.vti)"),
    ".vtp": read_mesh("vtkIOXML", "vtkXMLPolyDataReader", "VTK polygonal data (.vtp)"),
    ".vtu": read_mesh("vtkIOXML", "vtkXMLUnstructuredGridReader", "a VTK unstructured grid (.vtu)"),
    ".vts": read_mesh("vtkIOXML", "vtkXMLStructuredGridReader", "a VTK structured grid (.vts)"),
    ".vtk": read_mesh("vtkIOLegacy", "vtkDataSetReader", "a VTK data set (.vtk)"),
    ".stl": read_mesh("vtkIOGeometry", "vtkSTLReader", "an STL mesh"),
    ".obj": read_mesh("vtkIOGeometry", "vtkOBJReader", "an OBJ mesh"),
    ".ply": read_ply,
}

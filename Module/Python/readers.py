# SPDX-License-Identifier: BSD-3-Clause
"""Reads what water may be put into: meshes, and elevation models, as surfaces.

    ground = read("terrain.tif")    # a Surface
    ground.data                     # vtkPolyData, z up
    ground.is_terrain               # True: heights over a map, with the point array "Elevation"

A file that is missing, of no known kind, not what its name claims, or empty raises a FileError.
"""
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkPoints, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

__all__ = ["ELEVATION", "FileError", "KINDS", "Surface", "read", "surface_of_heights"]

ELEVATION = "Elevation"  # the point array of a terrain: heights in the file's unit
MOST_POINTS = 4_000_000  # of an elevation model; of a larger one every n-th row and column is taken
# Over and under 0, of levels, too: what formats write where they know no height lies far beyond.
HIGHEST = 1e9
METRES_PER_DEGREE = 6371008.8 * math.pi / 180  # of a great circle, mean radius of the Earth (IUGG 1980)
# Tags of TIFF: "OGC GeoTIFF Standard 1.1" (2019), and GDAL's for holes
TIFF_PIXEL_SCALE, TIFF_TIEPOINT, TIFF_GEO_KEYS, TIFF_NO_DATA = 33550, 33922, 34735, 42113
GEO_KEY_MODEL_TYPE, MODEL_TYPE_GEOGRAPHIC = 1024, 2


class FileError(ValueError):
    """A file that cannot be used, and why."""


@dataclass
class Surface:
    """What a file shows, with z up."""

    data: vtkPolyData
    is_terrain: bool = False
    note: str = ""  # what was left out on the way


def read(file, no_data=None):
    """The surface in a file; KINDS are known, by their suffix.

    Parameters
    ----------
    file : str or pathlib.Path
    no_data : float, optional
        A height that stands for a hole in an elevation model, beside NaN and what the file says.

    Returns
    -------
    Surface

    Raises
    ------
    FileError
        When the file is missing, of no known kind, not what its name claims, or empty.
    """
    path = Path(file)
    kind = KINDS.get(path.suffix.lower())
    if path.is_dir():
        raise FileError(f"{file}: is a folder, not a file")
    if not path.is_file():
        raise FileError(f"{file}: no such file")
    if not kind:
        raise FileError(f"{file}: kind {path.suffix or 'without a suffix'} is not known; known are {', '.join(KINDS)}")
    return kind(path, no_data)


def surface_of_heights(heights, spacing=(1.0, 1.0), origin=(0.0, 0.0), no_data=None):
    """The surface over a grid of heights: rows x columns, from south to north and west to east.

    Heights that are not finite, or equal no_data, are holes and stay holes; so are those beyond HIGHEST, of which
    the note tells. Raises a FileError when nothing is left.
    """
    heights = np.array(heights, dtype=float)
    if heights.ndim != 2 or min(heights.shape) < 2:
        raise FileError(f"{' x '.join(map(str, heights.shape))} heights are no grid: at least 2 x 2 are wanted")
    step = math.ceil(math.sqrt(heights.size / MOST_POINTS))
    notes = []
    if step > 1:
        notes.append(f"every {step}th row and column of {heights.shape[1]} x {heights.shape[0]} heights are taken")
    heights = heights[::step, ::step]
    known = np.isfinite(heights)
    if no_data is not None and math.isfinite(no_data):
        known &= heights != no_data
    beyond = known & (np.abs(heights) > HIGHEST)
    if beyond.any():
        notes.append(f"{beyond.sum()} of its heights, {heights[beyond][0]:g} is the first, are taken for holes; "
                     f"known heights lie in [{-HIGHEST:g}, {HIGHEST:g}]")
    known &= ~beyond
    is_cell = known[:-1, :-1] & known[:-1, 1:] & known[1:, 1:] & known[1:, :-1]
    if not is_cell.any():
        raise FileError("; ".join(["holds no elevations, only holes", *notes]))

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


def run(reader, path, what):
    """The reader's output; what VTK says on the way becomes the error."""
    log = vtkStringOutputWindow()
    shown, verbosity = vtkOutputWindow.GetInstance(), vtkLogger.GetCurrentVerbosityCutoff()
    vtkOutputWindow.SetInstance(log)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # it has the same texts again
    try:
        if hasattr(reader, "CanReadFile") and not reader.CanReadFile(str(path)):
            raise FileError(f"{path}: not {what}")
        reader.SetFileName(str(path))
        reader.Update()
    finally:
        vtkOutputWindow.SetInstance(shown)
        vtkLogger.SetStderrVerbosity(verbosity)
    if reader.GetErrorCode() or "ERROR" in log.GetOutput().upper():
        lines = [line for line in log.GetOutput().splitlines() if line and not line.startswith("ERROR: In ")]
        reason = lines[0].partition("): ")[2] or lines[0] if lines else "it cannot be read to its end"
        raise FileError(f"{path}: not {what}: {reason}")
    return reader.GetOutput()


def read_mesh(module, name, what):
    """A function that reads meshes with VTK's reader of this name."""
    def read_it(path, no_data):
        reader = getattr(__import__(f"vtkmodules.{module}", fromlist=[name]), name)()
        data = run(reader, path, what)
        if data is None:
            raise FileError(f"{path}: holds no data set of a kind that can be shown")
        if data.IsA("vtkImageData"):
            return surface_of_image(data, path, no_data)
        check_cells(data, path)
        surface = vtkDataSetSurfaceFilter()
        surface.SetInputData(data)
        normals = vtkPolyDataNormals()
        normals.SetInputConnection(surface.GetOutputPort())
        normals.SetFeatureAngle(40.0)
        normals.Update()
        if normals.GetOutput().GetNumberOfCells() == 0:
            raise FileError(f"{path}: is empty, it has no cells")
        places = vtk_to_numpy(normals.GetOutput().GetPoints().GetData())
        beyond = ~(np.abs(places) <= HIGHEST).all(axis=1)  # also NaN
        if beyond.any():
            raise FileError(f"{path}: has a point at ({', '.join(f'{part:g}' for part in places[beyond][0])}); "
                            f"coordinates must lie in [{-HIGHEST:g}, {HIGHEST:g}]")
        return Surface(normals.GetOutput())
    return read_it


def check_cells(data, path):
    """Readers take cells as they are; filters crash at those of points that there are not."""
    if data.IsA("vtkPolyData"):
        arrays = [data.GetVerts(), data.GetLines(), data.GetPolys(), data.GetStrips()]
    elif data.IsA("vtkUnstructuredGrid"):
        arrays = [data.GetCells()]
    else:
        return
    for cells in arrays:
        points = vtk_to_numpy(cells.GetConnectivityArray())
        wrong = points[(points < 0) | (points >= data.GetNumberOfPoints())]
        if wrong.size:
            raise FileError(f"{path}: a cell names point {wrong[0]}; there are {data.GetNumberOfPoints()}, from 0 on")


def surface_of_image(image: vtkImageData, path, no_data):
    scalars = image.GetPointData().GetScalars()
    columns, rows, layers = image.GetDimensions()
    if not scalars or scalars.GetNumberOfComponents() != 1 or layers != 1:
        raise FileError(f"{path}: holds no elevations: wanted is an image of one layer with one number a point")
    heights = vtk_to_numpy(scalars).reshape(rows, columns).astype(float)
    ghosts = image.GetPointGhostArray()
    if ghosts:
        hidden = vtk_to_numpy(ghosts).reshape(rows, columns) & vtkDataSetAttributes.HIDDENPOINT
        heights[hidden != 0] = math.nan
    return with_path(path, heights, image.GetSpacing()[:2], image.GetOrigin()[:2], no_data)


def read_tiff(path, no_data):
    try:
        from PIL import Image
    except ImportError:
        raise FileError(f"{path}: reading TIFF wants Pillow: pip install pillow (Debian: python3-pil)") from None
    Image.MAX_IMAGE_PIXELS = None  # elevation models are large
    try:
        with Image.open(path) as image:
            if image.format != "TIFF":
                raise FileError(f"{path}: not a TIFF image but {image.format}")
            no_data_tag = image.tag_v2.get(TIFF_NO_DATA)
            spacing, tie, keys = (numbers_of(image.tag_v2.get(tag), tag, path)
                                  for tag in (TIFF_PIXEL_SCALE, TIFF_TIEPOINT, TIFF_GEO_KEYS))
            heights = np.asarray(image)
    except OSError as error:
        raise FileError(f"{path}: not a TIFF image that can be read: {error}") from None
    if heights.ndim != 2:
        raise FileError(f"{path}: holds no elevations: it has {heights.shape[2]} numbers a pixel, wanted is one")
    if no_data is None and no_data_tag:
        try:
            no_data = float(str(no_data_tag).strip("\0 "))
        except ValueError:
            raise FileError(f"{path}: its no-data value {no_data_tag!r} is no number") from None
    spacing = (spacing or (1.0, 1.0))[:2]
    if len(spacing) != 2 or not all(0.0 < part < math.inf for part in spacing):
        raise FileError(f"{path}: its pixels are {' x '.join(map(str, spacing))} large; "
                        "wanted are two numbers greater than 0")
    tie += (0.0,) * 6
    if not all(map(math.isfinite, tie)):
        raise FileError(f"{path}: its tie point {tie[:6]} is not finite")
    south = tie[4] - spacing[1] * (heights.shape[0] - 1 - tie[1])
    if (GEO_KEY_MODEL_TYPE, 0, 1, MODEL_TYPE_GEOGRAPHIC) in zip(*(keys[i::4] for i in range(4))):
        # degrees: metres on a plane that touches the Earth in the middle of the map
        latitude = south + 0.5 * spacing[1] * (heights.shape[0] - 1)
        if not -90.0 < latitude < 90.0:
            raise FileError(f"{path}: its middle is at latitude {latitude:g}; it must lie between -90 and 90 degrees")
        middle = math.radians(latitude)
        spacing = (spacing[0] * METRES_PER_DEGREE * math.cos(middle), spacing[1] * METRES_PER_DEGREE)
        return with_path(path, heights[::-1], spacing, (0.0, 0.0), no_data)
    return with_path(path, heights[::-1], spacing, (tie[3] - spacing[0] * tie[0], south), no_data)


def numbers_of(value, tag, path):
    """What Pillow makes of a tag: nothing, a value, or a tuple of them."""
    values = value if isinstance(value, tuple) else () if value is None else (value,)
    try:
        return tuple(map(float, values))
    except (TypeError, ValueError):
        raise FileError(f"{path}: its tag {tag} is {value!r}; wanted are numbers") from None


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
    ".ply": read_mesh("vtkIOPLY", "vtkPLYReader", "a PLY mesh"),
}

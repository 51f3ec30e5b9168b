# SPDX-License-Identifier: BSD-3-Clause
"""Reads NetCDF files and their units with VTK's readers: a mesh of the UGRID conventions, otherwise a grid of CF's.

    source = open_netcdf(Path("tide.nc"))
    source.is_lonlat        # do its coordinates have the units degrees_east and degrees_north?
    source.unit_of("zeta")  # "cm"; empty if the file states none

UGRID: https://ugrid-conventions.github.io/ugrid-conventions. CF: http://cfconventions.org
"""
import functools
import re

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from .readers import FileError, heard, reader_of
from .steps import Reader, TimesError, check_times
from .ugrid import NoMesh, UgridMesh, is_east, is_north

__all__ = ["open_netcdf"]

NO_UGRID = "; meshes of the UGRID conventions need VTK 9.2 or later, or the package netCDF4"
NO_MESH_OF_VTK = ("does not contain a mesh", "Failed to open file")  # its UGRID reader's words where it finds none
GRID, MESH = "a NetCDF grid of the CF conventions", "a NetCDF mesh of the UGRID conventions"
SAME = 1e-6  # of the width of a mesh: coordinates that differ less are the same


def open_netcdf(path):
    """A UGRID mesh, read by VTK (from 9.2 on) or by the package netCDF4; otherwise a grid of the CF conventions."""
    hint = ""
    try:
        ugrid = reader_of("vtkIONetCDF", "vtkNetCDFUGRIDReader")
        if not ugrid:
            return UgridMesh(path)
        ugrid.ReplaceFillValueWithNanOn()
        return Mesh(path, ugrid)
    except ImportError:
        hint = NO_UGRID
    except (NoMesh, OSError):
        pass  # a grid, or no NetCDF at all
    except TimesError:  # of a mesh
        raise
    except (FileError, RuntimeError) as error:  # netCDF4's, of damaged data
        text = str(error)
        if not any(words in text for words in NO_MESH_OF_VTK):
            hint = f"; {text.removeprefix(f'{path}: ')}"
    check_dimensions(path)
    reader = cf_reader(path)
    check_times(path, times_of(path))
    names = names_of(reader)
    sizes = dict(zip(names, values_of(reader.GetVariableDimensions())))
    grids = [dimensions for dimensions in values_of(reader.GetAllDimensions()) if dimensions.count(",") == 1]
    hint += hint_of_time(values_of(reader.GetAllDimensions()))
    if not grids:
        raise FileError(f"{path}: no variable has two spatial dimensions{hint}")
    # the grid that most variables are on
    grid = max(grids, key=lambda dimensions: sum(size == dimensions for size in sizes.values()))
    for name in names:
        reader.SetVariableArrayStatus(name, sizes[name] == grid)
    return Grid(path, reader, grid, hint)


class Grid(Reader):
    """The steps of a grid. dimensions: the names of its rows and columns, such as "(lat, lon)"."""

    def __init__(self, path, reader, dimensions, hint):
        super().__init__(path, reader, GRID, hint=hint)
        self._dimensions = dimensions

    @functools.cached_property
    def is_lonlat(self):
        """Whether x and y are degrees: the dimensions have such names, or VTK puts the points on a sphere."""
        north, east = (name.strip() for name in self._dimensions.strip("()").split(","))
        if re.match("lat", north, re.IGNORECASE) and re.match("lon", east, re.IGNORECASE):
            return True
        flat = self.read(0)
        if not are_degrees(flat.GetBounds()):
            return False
        reader = cf_reader(self._path)
        names = names_of(reader)
        sizes = values_of(reader.GetVariableDimensions())
        for name, size in zip(names, sizes):
            reader.SetVariableArrayStatus(name, size == self._dimensions)
        reader.SphericalCoordinatesOn()
        with heard(self._path, GRID):
            reader.Update()
        return not np.allclose(reader.GetOutputDataObject(0).GetBounds(), flat.GetBounds())

    def unit_of(self, name):
        return stated(self.read(0), name)


class Mesh(Reader):
    """The steps of a mesh, which VTK reads without its attributes: its reader of grids knows the units."""

    def __init__(self, path, reader):
        super().__init__(path, reader, MESH, may_repeat=False)

    @functools.cached_property
    def is_lonlat(self):
        """Whether variables in degrees_east and degrees_north have the range of the points' x and y."""
        bounds = self.read(0).GetBounds()
        if not are_degrees(bounds):
            return False
        found = [False, False]
        reader = cf_reader(self._path)
        dimensions = values_of(reader.GetVariableDimensions())
        for lines in {each for each in dimensions if re.fullmatch(r"\([^,]+\)", each)}:
            data = self._variables([name for name, each in zip(names_of(reader), dimensions) if each == lines])
            arrays = data.GetPointData()
            for i in range(arrays.GetNumberOfArrays()):
                name = arrays.GetArrayName(i)
                unit, values = stated(data, name), vtk_to_numpy(arrays.GetArray(i))
                for axis, is_unit in enumerate((is_east, is_north)):
                    ends = bounds[2 * axis:2 * axis + 2]
                    near = SAME * (ends[1] - ends[0])
                    found[axis] |= is_unit(unit) and bool(np.abs(ends - np.array((values.min(), values.max()))).max() <=
                                                          near)
        return all(found)

    def unit_of(self, name):
        return stated(self._variables([name]), name)

    def _variables(self, names):
        """Variables of one size as VTK's reader of grids reads them, with their units."""
        reader = cf_reader(self._path)
        for each in names_of(reader):
            reader.SetVariableArrayStatus(each, each in names)
        with heard(self._path, MESH):
            reader.Update()
        return reader.GetOutputDataObject(0)


def cf_reader(path):
    """VTK's reader of grids, which has read the names in a file."""
    reader = reader_of("vtkIONetCDF", "vtkNetCDFCFReader")
    reader.SphericalCoordinatesOff()
    reader.ReplaceFillValueWithNanOn()
    with heard(path, GRID):
        if not reader.CanReadFile(str(path)):
            raise FileError(f"{path}: not {GRID}")
        reader.SetFileName(str(path))
        reader.UpdateMetaData()
    return reader


def check_dimensions(path):
    """Raise a FileError if every variable of two or more dimensions has a dimension of length 0,
    as in a run that has just begun:
    VTK's reader would crash.

    Needs the package netCDF4.
    """
    try:
        from netCDF4 import Dataset
    except ImportError:
        return
    try:
        with Dataset(path) as file:
            sizes = {name: len(dimension) for name, dimension in file.dimensions.items()}
            used = [variable.dimensions for variable in file.variables.values() if len(variable.dimensions) > 1]
    except (OSError, RuntimeError):  # VTK's reader tells what is wrong
        return
    empty = [[name for name in dimensions if sizes.get(name) == 0] for dimensions in used]
    if empty and all(empty):
        raise FileError(f"{path}: has no step or no place: the dimension '{empty[0][0]}' is empty")


def times_of(path):
    """The times of a grid as the file has them: VTK's reader silently leaves out all that do not ascend.

    Empty without the package netCDF4, or if the file has no times.
    """
    try:
        from netCDF4 import Dataset
    except ImportError:
        return ()
    try:
        with Dataset(path) as file:
            for name, variable in file.variables.items():
                if variable.dimensions == (name,) and " since " in str(getattr(variable, "units", "")):
                    return np.ma.filled(variable[:].astype(float), np.nan).tolist()
    except (OSError, RuntimeError):  # VTK's reader tells what is wrong
        pass
    return ()


def stated(data, name):
    """The unit of an array that VTK's reader of grids has read; empty if the file states none."""
    units = data.GetFieldData().GetAbstractArray(f"{name}_units")
    return units.GetValue(0).strip() if units and units.GetNumberOfValues() else ""


def are_degrees(bounds):
    """Whether x and y may be longitude and latitude."""
    return -360.0 <= bounds[0] <= bounds[1] <= 360.0 and -90.0 <= bounds[2] <= bounds[3] <= 90.0


def names_of(reader):
    return [reader.GetVariableArrayName(i) for i in range(reader.GetNumberOfVariableArrays())]


def values_of(strings):
    return [strings.GetValue(i) for i in range(strings.GetNumberOfValues())]


def hint_of_time(grids):
    """A hint that VTK treats a time without units as a dimension of space; empty if there is no such time."""
    names = [name for grid in grids for name in re.findall(r"\w+", grid) if name.lower() in ("t", "time")]
    return (f"; the time {names[0]!r} has no units and counts as a dimension of space: give its variable the "
            "attribute units, such as 'seconds since 2000-01-01'" if names else "")

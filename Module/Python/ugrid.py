# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of the UGRID conventions by the package netCDF4, for a VTK that has no reader of them (before 9.2).

UGRID 1.0: https://ugrid-conventions.github.io/ugrid-conventions
"""
import re

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from .readers import FileError
from .steps import TimesError

__all__ = ["NoMesh", "UgridMesh", "is_east", "is_north"]

WHAT = "a NetCDF mesh of the UGRID conventions"


def is_east(unit):
    """Whether a unit is that of longitudes, in one of CF's spellings (1.8, section 4.2)."""
    return re.fullmatch("degrees?(_east|_?E)", unit) is not None


def is_north(unit):
    """Whether a unit is that of latitudes (section 4.1)."""
    return re.fullmatch("degrees?(_north|_?N)", unit) is not None


class NoMesh(FileError):
    """A NetCDF file that contains no mesh."""


class UgridMesh:
    """The steps of the first two-dimensional mesh in a file, in the order of their times.

    Parameters
    ----------
    path : str or pathlib.Path

    Raises
    ------
    ImportError
        If netCDF4 is not installed.
    OSError
        If the file is not NetCDF.
    NoMesh
        If it contains no mesh.
    FileError
        If the mesh does not follow the conventions, or if a time is not finite.
    """

    hint = ""

    def __init__(self, path):
        from netCDF4 import Dataset

        self._path, self._open = path, Dataset
        with Dataset(path) as file:
            mesh = self._topology(file)
            self._mesh = mesh.name
            self._points = self._nodes(file, mesh)
            units = [unit_of(place) for place in self._named(file, mesh, "node_coordinates", 2)]
            self.is_lonlat = is_east(units[0]) and is_north(units[1])
            self._corners, self._ends = self._faces(file, mesh)
            times = file.variables.get("time")
            self._time_of = times.dimensions[0] if times is not None and times.dimensions else None
            values = [] if self._time_of is None else np.ma.filled(times[:].astype(float), np.nan)
        for i, time in enumerate(values):
            if not np.isfinite(time):
                raise self._not(f"its time {i} is {time:g}; it must be finite")
        sorted_times, self._order = np.unique(values, return_index=True)
        self.times = sorted_times.tolist()
        repeated = np.setdiff1d(np.arange(len(values)), self._order)  # those in order are the first of each time
        if repeated.size:
            i = repeated[0]
            raise TimesError(f"{path}: its time {i} is {values[i]:g}, like an earlier one; times must differ")

    def files_of(self, i):
        return ()

    def unit_of(self, name):
        """The unit that the file states for an array; empty if it states none."""
        with self._open(self._path) as file:
            return unit_of(file.variables[name]) if name in file.variables else ""

    def read(self, i):
        """The mesh of a step; missing values are NaN. Raises FileError if an array does not have the mesh's size."""
        points, cells, data = vtkPoints(), vtkCellArray(), vtkPolyData()
        points.SetDataTypeToDouble()
        points.SetData(numpy_to_vtk(self._points, deep=True))
        cells.SetData(*(numpy_to_vtkIdTypeArray(part, deep=True) for part in (self._ends, self._corners)))
        data.SetPoints(points)
        data.SetPolys(cells)
        with self._open(self._path) as file:
            for variable in file.variables.values():
                place = getattr(variable, "location", "")
                if getattr(variable, "mesh", "") != self._mesh or place not in ("node", "face"):
                    continue
                values = self._values(variable, i)
                if values is None:
                    continue
                count = len(self._points) if place == "node" else len(self._ends) - 1
                if len(values) != count:
                    raise self._not(f"the variable '{variable.name}' has {len(values)} values; "
                                    f"the mesh has {count} {place}s")
                array = numpy_to_vtk(values, deep=True)
                array.SetName(variable.name)
                (data.GetPointData() if place == "node" else data.GetCellData()).AddArray(array)
        return data

    def _values(self, variable, i):
        """A variable's values at a step, one per node or face; None for one value, for layers, and for text."""
        if variable.dtype is str or variable.dtype.kind not in "biuf" or not variable.dimensions:
            return None
        if variable.dimensions[0] == self._time_of:
            if not self.times:
                raise self._not("has no step: the dimension of its times is empty")
            values = variable[self._order[i]]
        else:
            values = variable[:]
        return np.ma.filled(values.astype(float), np.nan) if np.ndim(values) == 1 else None

    def _topology(self, file):
        """The variable that describes the mesh."""
        found = [variable for variable in file.variables.values()
                 if getattr(variable, "cf_role", "") == "mesh_topology"]
        if not found:
            raise NoMesh(f"{self._path}: not {WHAT}: holds no mesh")
        for variable in found:
            if getattr(variable, "topology_dimension", None) == 2:
                return variable
        raise self._not("; ".join(f"the topology_dimension of '{variable.name}' is "
                                  f"{getattr(variable, 'topology_dimension', 'missing')}" for variable in found)
                        + "; it must be 2")

    def _named(self, file, mesh, attribute, count):
        """The variables that an attribute of the mesh names."""
        names = str(getattr(mesh, attribute, "")).split()
        if len(names) != count:
            raise self._not(f"the {attribute} of '{mesh.name}' is {' '.join(names)!r}; it must name {count} "
                            f"variable{'s' if count > 1 else ''}")
        for name in names:
            if name not in file.variables:
                raise self._not(f"there is no variable '{name}', the {attribute} of '{mesh.name}'")
        return [file.variables[name] for name in names]

    def _nodes(self, file, mesh):
        x, y = (np.ma.filled(variable[:].astype(float), np.nan)
                for variable in self._named(file, mesh, "node_coordinates", 2))
        if x.ndim != 1 or x.shape != y.shape:
            raise self._not(f"the node_coordinates of '{mesh.name}' are of shape {x.shape} and {y.shape}; x and y "
                            "must have the same length")
        return np.stack([x, y, np.zeros(len(x))], axis=1)

    def _faces(self, file, mesh):
        """Nodes of all faces, and where in them each face ends."""
        (faces,) = self._named(file, mesh, "face_node_connectivity", 1)
        corners = np.ma.masked_invalid(faces[:]) - getattr(faces, "start_index", 0)
        if corners.ndim != 2:
            raise self._not(f"the face_node_connectivity of '{mesh.name}' has {corners.ndim} dimensions; "
                            "it must have 2")
        is_corner = ~np.ma.getmaskarray(corners) & (np.ma.filled(corners, 0) >= 0)
        nodes = np.ma.filled(corners, 0)[is_corner].astype(np.int64)
        if nodes.size and nodes.max() >= len(self._points):
            raise self._not(f"a face names node {nodes.max()}; there are {len(self._points)}, from 0 on")
        return nodes, np.concatenate([[0], np.cumsum(is_corner.sum(axis=1))]).astype(np.int64)

    def _not(self, why):
        return FileError(f"{self._path}: not {WHAT}: {why}")


def unit_of(variable):
    return str(getattr(variable, "units", "")).strip()

# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of the UGRID conventions by the package netCDF4, for a VTK that has no reader of them (before 9.2).

UGRID 1.0: https://ugrid-conventions.github.io/ugrid-conventions
"""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

__all__ = ["UgridMesh"]


class UgridMesh:
    """The steps of the first two-dimensional mesh in a file; ImportError without netCDF4, OSError or ValueError where
    the file holds none."""

    is_lonlat, hint = False, ""

    def __init__(self, path):
        from netCDF4 import Dataset

        self._file = Dataset(path)
        topologies = [variable for variable in self._file.variables.values()
                      if getattr(variable, "cf_role", "") == "mesh_topology" and variable.topology_dimension == 2]
        if not topologies:
            raise ValueError(f"{path}: holds no mesh of two dimensions")
        (mesh, *_) = topologies
        x, y = (self._file[name][:].astype(float) for name in mesh.node_coordinates.split())
        self._points = np.stack([x, y, 0.0 * x], axis=1)
        faces = self._file[mesh.face_node_connectivity]
        corners = np.ma.masked_invalid(faces[:]) - getattr(faces, "start_index", 0)
        is_corner = ~np.ma.getmaskarray(corners) & (np.ma.filled(corners, 0) >= 0)
        if not ((np.ma.filled(corners, 0) < len(x)) | ~is_corner).all():
            raise ValueError(f"{path}: a face names node {corners.max()}; there are {len(x)}, from 0 on")
        self._corners = np.ma.filled(corners, 0)[is_corner].astype(np.int64)
        self._ends = np.concatenate([[0], np.cumsum(is_corner.sum(axis=1))]).astype(np.int64)
        self._arrays = [variable for variable in self._file.variables.values()
                        if getattr(variable, "mesh", "") == mesh.name
                        and getattr(variable, "location", "") in ("node", "face")]
        times = self._file.variables.get("time")
        self.times = [] if times is None else [float(time) for time in np.ma.filled(times[:].astype(float), np.nan)]

    def read(self, i):
        """The mesh of a step; what is missing is NaN."""
        points, cells, data = vtkPoints(), vtkCellArray(), vtkPolyData()
        points.SetDataTypeToDouble()
        points.SetData(numpy_to_vtk(self._points, deep=True))
        cells.SetData(*(numpy_to_vtkIdTypeArray(part, deep=True) for part in (self._ends, self._corners)))
        data.SetPoints(points)
        data.SetPolys(cells)
        for variable in self._arrays:
            values = variable[i] if variable.dimensions[0] == "time" else variable[:]
            if values.ndim != 1:
                continue  # of layers
            array = numpy_to_vtk(np.ma.filled(values.astype(float), np.nan), deep=True)
            array.SetName(variable.name)
            (data.GetPointData() if variable.location == "node" else data.GetCellData()).AddArray(array)
        return data

# SPDX-License-Identifier: BSD-3-Clause
"""Read a solver's file: a mesh with arrays of points or cells, over time.

    solution = Solution("flood.pvd", ["h", "zb"])
    solution.times            # the file's own, in its unit: (0.0, 600.0, ...); (0.0,) where it has none
    mesh = solution.at(300.0)  # vtkPolyData, between two steps by vtkTemporalInterpolator

VTK's readers read the files (sources.py); KINDS maps suffixes to readers. A FileError is raised if a file is missing,
of an unknown type, not of the type that its suffix claims, or lacks one of the arrays; the text lists the existing
ones.
"""
import bisect
import math
import warnings
import weakref
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellTypes, vtkDataObject, vtkDataSetAttributes, vtkGenericCell
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkAppendPolyData
from vtkmodules.vtkFiltersHybrid import vtkTemporalInterpolator

from .ahead import Ahead
from .readers import HIGHEST, METRES_PER_DEGREE, FileError, check_cells, heard, marked, polygons_of
from .sources import KINDS, open_source
from .words import counted

__all__ = ["KINDS", "Solution"]

# Units of lengths, in lower case, as files spell them: https://docs.unidata.ucar.edu/udunits
METRES = {**dict.fromkeys(("m", "meter", "metre", "meters", "metres"), 1.0),
          **dict.fromkeys(("mm", "millimeter", "millimetre", "millimeters", "millimetres"), 0.001),
          **dict.fromkeys(("cm", "centimeter", "centimetre", "centimeters", "centimetres"), 0.01),
          **dict.fromkeys(("km", "kilometer", "kilometre", "kilometers", "kilometres"), 1000.0),
          **dict.fromkeys(("ft", "foot", "feet", "international_foot", "international_feet"), 0.3048),
          **dict.fromkeys(("us_survey_foot", "us_survey_feet"), 1200.0 / 3937.0)}
KEPT_STEPS = 2  # in memory: what lies between them is interpolated


class Solution:
    """The contents of a solver's file at any time.

    Parameters
    ----------
    file : str, pathlib.Path or Mapping
        One of KINDS, by its suffix; a folder of GeoTIFF files; or a mapping of each array to one such file, or to its
        files by time (TiffStack): ``{"depth": {0.0: "a.tif", 600.0: "b.tif"}, "bed": "bed.tif"}``. A mapping is not
        read ahead.
    arrays : sequence[str]
        Names of the arrays to read, of points or cells. Others are not kept. An array whose unit, as a NetCDF file
        states it, is a length other than the metre (cm, ft, US_survey_foot, ...: METRES) is converted to metres; a
        GeoTIFF file in feet is, too. All others keep the file's values.
    is_volume : bool, default: False
        Read cells of three dimensions, as an unstructured grid.
    is_lonlat : bool, optional
        Whether x and y are longitude and latitude in degrees. They are converted to metres from the south-western
        corner, on a plane that touches the Earth in the middle of the mesh. The default follows from the units of the
        coordinates of a NetCDF file (degrees_east, degrees_north) or the names of its dimensions, and from the
        coordinate system of a GeoTIFF file.
    read_ahead : bool, default: False
        Read the next step in another process while this one is shown; for series of many steps. Meshes and errors stay
        the same; an error is raised when its step is requested. A step whose file changes after it was read ahead is
        read again, but the parts that a file lists (.pvtp, .pvtu, .vtm, .foam) must not change. The process needs
        memory for some steps, and ends with the solution. Steps are not read ahead if Python is embedded in an
        application, in a process created by os.fork(), and after a step that took longer than a minute.

    Attributes
    ----------
    times : tuple[float]
        Times of the steps, ascending, in the file's unit; (0.0,) if it has no time.
    start : datetime.datetime or None
        The date of time 0, if the names of GeoTIFF files end with dates.
    note : str
        A message about an unexpected result, such as steps that cannot be interpolated; empty if there is none.

    Warns
    -----
    UserWarning
        If two files of one time in a .pvd file have the same bounds and number of points.

    Raises
    ------
    FileError
    """

    def __init__(self, file, arrays=(), is_volume=False, is_lonlat=None, read_ahead=False):
        is_list = isinstance(file, Mapping)
        self.path = "GeoTIFF files" if is_list else Path(file)
        self._differ = ""
        self._arrays = tuple(arrays)
        self._is_volume = is_volume
        self._factors = {}
        # before the file is read: it sees later changes
        ahead = None if is_list else Ahead(self.path, self._arrays, is_volume, is_lonlat)
        self._source = open_source(file if is_list else self.path)
        self.start = getattr(self._source, "start", None)
        self._is_lonlat = self._source.is_lonlat if is_lonlat is None else is_lonlat
        self.times = tuple(self._source.times) or (0.0,)
        self._steps = {}
        self._middle = None
        self._ahead = None
        self._last = 0  # the step that was made last
        kind = self.step(0).GetClassName()
        self._pipeline = StepsSource(self, kind)
        self._between = vtkTemporalInterpolator()
        self._between.SetInputConnection(self._pipeline.GetOutputPort())
        if read_ahead and len(self.times) > KEPT_STEPS:
            self._ahead = ahead

    @property
    def note(self):
        return "; ".join(filter(None, (getattr(self._source, "note", ""), self._differ)))

    def step(self, i):
        """Return the mesh of a step, from 0: vtkPolyData, or vtkUnstructuredGrid of a volume. Do not change it."""
        mesh = self._steps.get(i)
        if mesh is None:
            while len(self._steps) >= KEPT_STEPS:
                self._steps.pop(next(iter(self._steps), None), None)  # another thread may have taken it away
            mesh = (self._ahead.take(i) if self._ahead else None) or self._made(i)
            self._steps[i] = mesh
            if self._ahead:
                following = i + 1 if i >= self._last else i - 1
                if 0 <= following < len(self.times) and following not in self._steps:
                    self._ahead.ask(following, self._files_of(following))
            self._last = i
        return mesh

    def forget(self):
        """Forget all steps, so that each is read again when it is requested."""
        self._steps.clear()

    def check_time(self, time):
        """Raise FileError if a time lies before the first step or after the last."""
        first, last = self.times[0], self.times[-1]
        if not first <= time <= last:
            raise FileError(f"{self.path}: time is {time:g}; it must lie in [{first:g}, {last:g}]")

    def at(self, time):
        """Return the mesh at a time: that of a step, or an interpolation between two (vtkTemporalInterpolator).

        Two steps are interpolated only if both have the same cells. Otherwise the earlier step is returned, and note
        says so. The time must not lie before the first step, nor after the last.
        """
        self.check_time(time)
        i = bisect.bisect_right(self.times, time) - 1
        mesh = self.step(i)
        if time == self.times[i]:
            return mesh
        if not have_same_cells(mesh, self.step(i + 1)):
            self._differ = (f"the meshes of steps {i} and {i + 1} differ: "
                            "between them, the earlier step is shown")
            return mesh
        with heard(self.path, "a series whose steps can be interpolated"):
            self._between.UpdateTimeStep(time)
        between = self._between.GetOutputDataObject(0)
        made = between.NewInstance()
        made.ShallowCopy(between)
        return made

    def range_of(self, name, is_positive=False):
        """The smallest and largest finite value of an array, as the meshes have it, over all steps; for vectors, of
        their magnitude.

        is_positive  whether only values above 0 count
        """
        ends = []
        for i in range(len(self.times)):
            values = vtk_to_numpy(array_of(self.step(i), name))
            values = values if values.ndim == 1 else np.linalg.norm(values, axis=1)
            values = values[np.isfinite(values) & ((values > 0) | (not is_positive))]
            if values.size:
                ends += [float(values.min()), float(values.max())]
        return (min(ends), max(ends)) if ends else None

    def unit_of(self, name):
        """The unit of an array as a NetCDF file states it, such as "cm"; empty if the file states none.

        In the meshes, lengths are in metres: factor_of(name) times the file's values.
        """
        return self._source.unit_of(name)

    def factor_of(self, name):
        """Metres per unit of an array that has another unit of length; 1 for all others."""
        if name not in self._factors:
            self._factors[name] = METRES.get(self.unit_of(name).lower(), 1.0)
        return self._factors[name]

    def _made(self, i):
        noted = self.note
        data = self._source.read(i)
        if self.note != noted:
            warnings.warn(f"{self.path}: {self._source.note}", stacklevel=4)
        try:
            mesh = mesh_of(data, self.path, self._is_volume)
        except FileError as error:
            raise FileError(f"{error}{self._source.hint}") from None
        kept = mesh.NewInstance()
        kept.CopyStructure(mesh)
        for name in self._arrays:
            array = array_of(mesh, name)
            if array is None:
                is_texts = is_text(mesh, name)
                wrong = f"the array '{name}' has text instead of numbers" if is_texts else f"there is no array '{name}'"
                raise FileError(f"{self.path}: {wrong}{self._of_step(i)}; arrays are: "
                                f"{names_of(mesh)}{self._source.hint}")
            of_cells = mesh.GetPointData().GetArray(name) is None
            factor = self.factor_of(name)
            if factor != 1.0:
                array = numpy_to_vtk(factor * vtk_to_numpy(array).astype(float), deep=True)
                array.SetName(name)
            (kept.GetCellData() if of_cells else kept.GetPointData()).AddArray(array)
        self._place(kept)
        return kept

    def _files_of(self, i):
        return self._source.files_of(i)

    def _of_step(self, i):
        return f" at time {self.times[i]:g}" if i else ""

    def _place(self, mesh):
        """Convert degrees to metres, and check that no point is too far away."""
        places = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
        if self._is_lonlat:
            west, south, north = places[:, 0].min(), places[:, 1].min(), places[:, 1].max()
            if self._middle is None:
                if not -90.0 <= south <= north <= 90.0:
                    raise FileError(f"{self.path}: y is {south:g} to {north:g}; latitudes must lie between "
                                    "-90 and 90 degrees")
                self._middle = west, south, np.cos(np.radians(0.5 * (south + north)))
            west, south, shrink = self._middle
            places[:, 0] = (places[:, 0] - west) * METRES_PER_DEGREE * shrink
            places[:, 1] = (places[:, 1] - south) * METRES_PER_DEGREE
            points = vtkPoints()
            points.SetData(numpy_to_vtk(places, deep=True))
            mesh.SetPoints(points)
        beyond = ~(np.abs(places) <= HIGHEST).all(axis=1)  # also NaN
        if beyond.any():
            raise FileError(f"{self.path}: has a point at ({', '.join(f'{part:g}' for part in places[beyond][0])}); "
                            f"coordinates must lie in [{-HIGHEST:g}, {HIGHEST:g}]")


class StepsSource(VTKPythonAlgorithmBase):
    """A solution's steps as a source for vtkTemporalInterpolator; the solution already holds them."""

    def __init__(self, solution, kind):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType=kind)
        self._solution = weakref.ref(solution)  # VTK keeps what Python's collector cannot see: no cycle
        self._times = solution.times

    def RequestInformation(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        times = list(self._times)
        info.Set(vtkStreamingDemandDrivenPipeline.TIME_STEPS(), times, len(times))
        info.Set(vtkStreamingDemandDrivenPipeline.TIME_RANGE(), [times[0], times[-1]], 2)
        return 1

    def RequestData(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        time = info.Get(vtkStreamingDemandDrivenPipeline.UPDATE_TIME_STEP())
        i = max(bisect.bisect_right(self._times, time) - 1, 0)
        output = vtkDataObject.GetData(info)
        output.ShallowCopy(self._solution().step(i))
        output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), self._times[i])
        return 1


def array_of(mesh, name):
    """An array of points, otherwise of cells; None if there is no such array of numbers."""
    return mesh.GetPointData().GetArray(name) or mesh.GetCellData().GetArray(name)


def odd_units(solution, names):
    """Warnings of arrays of heights whose unit is not a known unit of length, one text for each."""
    units = {name: solution.unit_of(name) for name in names if isinstance(name, str)}
    return [f"the unit of '{name}' is '{unit}', which is not a known unit of length; its values are taken as metres. "
            f"Known units: {', '.join(METRES)}" for name, unit in units.items() if unit and unit.lower() not in METRES]


def is_text(mesh, name):
    """Whether an array of this name has text instead of numbers."""
    return any(data.GetAbstractArray(name) is not None for data in (mesh.GetPointData(), mesh.GetCellData()))


def names_of(mesh):
    """Names of all arrays of numbers, for an error."""
    names = [f"{data.GetArrayName(i)} ({what})"
             for data, what in ((mesh.GetPointData(), "points"), (mesh.GetCellData(), "cells"))
             for i in range(data.GetNumberOfArrays()) if data.GetArray(i) is not None]
    return ", ".join(names) or "none"


def have_same_cells(one, other):
    if (one.GetNumberOfPoints(), one.GetNumberOfCells()) != (other.GetNumberOfPoints(), other.GetNumberOfCells()):
        return False
    return all(np.array_equal(vtk_to_numpy(a), vtk_to_numpy(b)) for a, b in zip(lists_of(one), lists_of(other)))


def lists_of(mesh):
    """The arrays that define the cells of a mesh: their points, the offset of each cell's points, and their types."""
    parts = ("GetVerts", "GetLines", "GetPolys", "GetStrips") if mesh.IsA("vtkPolyData") else ("GetCells",)
    cells = [getattr(mesh, part)() for part in parts]
    lists = [array for part in cells for array in (part.GetConnectivityArray(), part.GetOffsetsArray())]
    if mesh.IsA("vtkUnstructuredGrid"):
        is_new = hasattr(mesh, "GetDistinctCellTypes")  # VTK 9.6
        lists.append(mesh.GetCellTypes() if is_new else mesh.GetCellTypesArray())
    return lists


def leaves_of(data):
    """The data sets with cells in a data object."""
    if data is None:
        return []
    if data.IsA("vtkDataSet"):
        return [data] if data.GetNumberOfCells() else []
    leaves = []
    if data.IsA("vtkCompositeDataSet"):
        pieces = data.NewIterator()
        pieces.InitTraversal()
        while not pieces.IsDoneWithTraversal():
            leaves += leaves_of(pieces.GetCurrentDataObject())
            pieces.GoToNextItem()
    return leaves


def dimension_of(data):
    """The largest number of dimensions of a data set's cells."""
    types, cell, most = vtkCellTypes(), vtkGenericCell(), 0
    (data.GetDistinctCellTypes if hasattr(data, "GetDistinctCellTypes") else data.GetCellTypes)(types)  # VTK 9.6
    for i in range(types.GetNumberOfTypes()):
        cell.SetCellType(types.GetCellType(i))
        most = max(most, cell.GetCellDimension())
    return most


def mesh_of(data, path, is_volume):
    """One mesh from a reader's output: polygons, or an unstructured grid of a volume."""
    leaves = leaves_of(data)
    if not leaves:
        raise FileError(f"{path}: is empty: it has no cells")
    for leaf in leaves:
        check_cells(leaf, path)
    leaves = [leaf for leaf in leaves if leaf.IsA("vtkPolyData") or
              not marked(leaf.GetCellData(), leaf.GetNumberOfCells(), vtkDataSetAttributes.HIDDENCELL).all()]
    if not leaves:
        raise FileError(f"{path}: has no water: all of its cells are hidden")
    wanted = 3 if is_volume else 2
    found = [dimension_of(leaf) for leaf in leaves]
    if is_volume or max(found) < 3:  # walls of a volume are no surface of water
        leaves = [leaf for leaf, dimension in zip(leaves, found) if dimension == wanted]
    if not leaves or (max(found) == 3 and not is_volume):
        of_volume = "; use --contour for the surface of a volume fraction" if max(found) == 3 else ""
        found_most = counted(max(found), "dimension")
        raise FileError(f"{path}: its cells have {found_most}; they must have {wanted}{of_volume}")
    append = vtkAppendFilter() if is_volume else vtkAppendPolyData()
    for leaf in leaves:
        append.AddInputData(leaf if is_volume else polygons_of(leaf))
    append.Update()
    return append.GetOutput()

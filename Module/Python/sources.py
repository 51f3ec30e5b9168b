# SPDX-License-Identifier: BSD-3-Clause
"""The steps of a solver's file, each as VTK's data object; KINDS maps suffixes to what opens a file.

    source = open_source(Path("flood.pvd"))
    source.times    # ascending; empty if the file has no time
    source.read(0)  # the first step

Each has is_lonlat (are x and y degrees?), hint (what may be wrong where a mesh or an array is missing) and
files_of(i): the files of a step besides the one that was opened.
"""
import math
import re
from collections.abc import Mapping
from xml.etree import ElementTree

from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

from .readers import FileError, heard, kind_of, reader_of
from .tiff_stack import TiffStack
from .ugrid import NoMesh, UgridMesh

__all__ = ["KINDS", "open_source"]

NO_UGRID = "; meshes of the UGRID conventions need VTK 9.2 or later, or the package netCDF4"
NO_MESH_OF_VTK = ("does not contain a mesh", "Failed to open file")  # its UGRID reader's words where it finds none


def open_source(path):
    """The steps of a file, of a folder of GeoTIFF files or of a list of them (TiffStack). Raises a FileError."""
    return TiffStack(path) if isinstance(path, Mapping) or path.is_dir() else kind_of(path, KINDS)(path)


class Reader:
    """The steps of one of VTK's readers; hint: what may be wrong where a mesh or array is missing."""

    def __init__(self, path, reader, what, is_lonlat=False, hint=""):
        self._path, self._reader, self._what = path, reader, what
        self.is_lonlat, self.hint = is_lonlat, hint
        with heard(path, what):
            if hasattr(reader, "CanReadFile") and not reader.CanReadFile(str(path)):
                raise FileError(f"{path}: not {what}")
            reader.SetFileName(str(path))
            reader.UpdateInformation()
        times = reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS()) or ()
        for i, time in enumerate(times):
            if not math.isfinite(time):
                raise FileError(f"{path}: its time {i} is {time:g}; it must be finite")
            if i and time < times[i - 1]:  # VTK would read other steps
                raise FileError(f"{path}: its time {i} is {time:g}, after {times[i - 1]:g}; times must ascend")
        self.times = sorted(set(times))

    def files_of(self, i):
        return ()

    def read(self, i):
        with heard(self._path, self._what):
            if self.times:
                self._reader.UpdateTimeStep(self.times[i])
            else:
                self._reader.Update()
        if hasattr(self._reader, "GetErrorCode") and self._reader.GetErrorCode():
            raise FileError(f"{self._path}: not {self._what}: reading stopped before its end")
        return self._reader.GetOutputDataObject(0)


class Collection:
    """The steps of a ParaView collection (.pvd): a file or some for each of its times."""

    is_lonlat, hint = False, ""

    def __init__(self, path):
        self._path = path
        try:
            entries = [entry.attrib for entry in ElementTree.parse(path).iter("DataSet")]
        except ElementTree.ParseError as error:
            raise FileError(f"{path}: not a ParaView collection (.pvd): {error}") from None
        files = {}
        for entry in entries:
            if "file" not in entry:
                raise FileError(f"{path}: not a ParaView collection (.pvd): a DataSet names no file")
            try:
                time = float(entry.get("timestep", 0.0))
            except ValueError:
                time = math.nan
            if not math.isfinite(time):
                raise FileError(f"{path}: the time of {entry['file']} is {entry['timestep']!r}; "
                                "it must be a finite number")
            files.setdefault(time, []).append(path.parent / entry["file"])
        if not files:
            raise FileError(f"{path}: is empty: it lists no files")
        self.times = sorted(files)
        self._files = files

    def files_of(self, i):
        """The files of a step, besides the collection."""
        return self._files[self.times[i]]

    def read(self, i):
        append = vtkMultiBlockDataSet()
        for j, file in enumerate(self._files[self.times[i]]):
            try:
                read = kind_of(file, {kind: make for kind, make in KINDS.items() if kind != ".pvd"})(file)
            except FileError as error:
                raise FileError(f"{self._path}: at time {self.times[i]:g}: {error}") from None
            append.SetBlock(j, read.read(0))
        return append


def simple(module, name, what):
    """A function that opens a file with VTK's reader of this name."""
    def open_it(path):
        reader = reader_of(module, name)
        if hasattr(reader, "SetReadAllScalars"):
            reader.ReadAllScalarsOn()
            reader.ReadAllFieldsOn()
        return Reader(path, reader, what)
    return open_it


def open_netcdf(path):
    """A mesh of UGRID's conventions by VTK (from 9.2 on) or the package netCDF4, else a grid of CF's."""
    hint = ""
    try:
        ugrid = reader_of("vtkIONetCDF", "vtkNetCDFUGRIDReader")
        if not ugrid:
            return UgridMesh(path)
        ugrid.ReplaceFillValueWithNanOn()
        return Reader(path, ugrid, "a NetCDF mesh of the UGRID conventions")
    except ImportError:
        hint = NO_UGRID
    except (NoMesh, OSError):
        pass  # a grid, or no NetCDF at all
    except (FileError, RuntimeError) as error:  # netCDF4's, of damaged data
        text = str(error)
        if not any(words in text for words in NO_MESH_OF_VTK):
            hint = f"; {text.removeprefix(f'{path}: ')}"
    what = "a NetCDF grid of the CF conventions"
    reader = reader_of("vtkIONetCDF", "vtkNetCDFCFReader")
    reader.SphericalCoordinatesOff()
    reader.ReplaceFillValueWithNanOn()
    with heard(path, what):
        if not reader.CanReadFile(str(path)):
            raise FileError(f"{path}: not {what}")
        reader.SetFileName(str(path))
        reader.UpdateMetaData()
    names = [reader.GetVariableArrayName(i) for i in range(reader.GetNumberOfVariableArrays())]
    sizes = dict(zip(names, values_of(reader.GetVariableDimensions())))
    grids = [dimensions for dimensions in values_of(reader.GetAllDimensions()) if dimensions.count(",") == 1]
    hint += hint_of_time(values_of(reader.GetAllDimensions()))
    if not grids:
        raise FileError(f"{path}: no variable has two spatial dimensions{hint}")
    # the grid that most variables are on
    grid = max(grids, key=lambda dimensions: sum(size == dimensions for size in sizes.values()))
    for name in names:
        reader.SetVariableArrayStatus(name, sizes[name] == grid)
    north, east = re.findall(r"\w+", grid)
    is_lonlat = bool(re.match("lat", north, re.IGNORECASE) and re.match("lon", east, re.IGNORECASE))
    return Reader(path, reader, what, is_lonlat, hint)


def hint_of_time(grids):
    """VTK counts a time without units as a dimension of space."""
    names = [name for grid in grids for name in re.findall(r"\w+", grid) if name.lower() in ("t", "time")]
    return (f"; the time {names[0]!r} has no units and counts as a dimension of space: give its variable the "
            "attribute units, such as 'seconds since 2000-01-01'" if names else "")


def values_of(strings):
    return [strings.GetValue(i) for i in range(strings.GetNumberOfValues())]


def open_exodus(path):
    reader = reader_of("vtkIOExodus", "vtkExodusIIReader")
    what = "an Exodus II file"
    with heard(path, what):
        if not reader.CanReadFile(str(path)):
            raise FileError(f"{path}: not {what}")
        reader.SetFileName(str(path))
        reader.UpdateInformation()
        for kind in (reader.NODAL, reader.ELEM_BLOCK):
            reader.SetAllArrayStatus(kind, 1)
    return Reader(path, reader, what)


def xml(kind, what):
    return simple("vtkIOXML", f"vtkXML{kind}Reader", what)


KINDS = {
    ".pvd": Collection,
    ".nc": open_netcdf,
    ".vti": xml("ImageData", "a VTK image (.vti)"),
    ".vtr": xml("RectilinearGrid", "a VTK rectilinear grid (.vtr)"),
    ".vts": xml("StructuredGrid", "a VTK structured grid (.vts)"),
    ".vtp": xml("PolyData", "VTK polygonal data (.vtp)"),
    ".vtu": xml("UnstructuredGrid", "a VTK unstructured grid (.vtu)"),
    ".pvtp": xml("PPolyData", "VTK polygonal data in parts (.pvtp)"),
    ".pvtu": xml("PUnstructuredGrid", "a VTK unstructured grid in parts (.pvtu)"),
    ".vtm": xml("MultiBlockData", "VTK blocks (.vtm)"),
    ".vtk": simple("vtkIOLegacy", "vtkDataSetReader", "a VTK data set (.vtk)"),
    ".vtkhdf": simple("vtkIOHDF", "vtkHDFReader", "a VTK HDF file (.vtkhdf)"),
    ".foam": simple("vtkIOGeometry", "vtkOpenFOAMReader", "an OpenFOAM case"),
    ".e": open_exodus,
    ".exo": open_exodus,
}

# SPDX-License-Identifier: BSD-3-Clause
"""The steps of a solver's file, each as VTK's data object; KINDS maps suffixes to what opens a file.

    source = open_source(Path("flood.pvd"))
    source.times    # ascending; empty if the file has no time
    source.read(0)  # the first step

Each has is_lonlat (are x and y degrees?), hint (what may be wrong where a mesh or an array is missing), files_of(i):
the files of a step besides the one that was opened, and unit_of(name): the unit that the file states for an array.
"""
import math
from collections.abc import Mapping
from xml.etree import ElementTree

from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

from .netcdf import open_netcdf
from .readers import FileError, heard, kind_of, reader_of
from .steps import Reader
from .tiff_stack import TiffStack

__all__ = ["KINDS", "open_source"]


def open_source(path):
    """The steps of a file, of a folder of GeoTIFF files or of a list of them (TiffStack). Raises a FileError."""
    return TiffStack(path) if isinstance(path, Mapping) or path.is_dir() else kind_of(path, KINDS)(path)


class Collection:
    """The steps of a ParaView collection (.pvd): one file or several for each of its times.

    note: a warning that two files of one time look like two steps; empty at first
    """

    is_lonlat, hint = False, ""

    def __init__(self, path):
        self._path = path
        try:
            entries = [entry.attrib for entry in ElementTree.parse(path).iter("DataSet")]
        except (ElementTree.ParseError, LookupError) as error:  # or an encoding that does not exist
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
        self.note = ""

    def files_of(self, i):
        """The files of a step, besides the collection."""
        return self._files[self.times[i]]

    def unit_of(self, name):
        return ""

    def read(self, i):
        append, places = vtkMultiBlockDataSet(), {}
        for j, file in enumerate(self._files[self.times[i]]):
            try:
                read = kind_of(file, {kind: make for kind, make in KINDS.items() if kind != ".pvd"})(file)
            except FileError as error:
                raise FileError(f"{self._path}: at time {self.times[i]:g}: {error}") from None
            data = read.read(0)
            append.SetBlock(j, data)
            if data.IsA("vtkDataSet") and data.GetNumberOfPoints():
                other = places.setdefault((data.GetNumberOfPoints(), data.GetBounds()), file)
                if other is not file and not self.note:
                    self.note = (f"at time {self.times[i]:g}, {other.name} and {file.name} have the same bounds and "
                                 "number of points; both are shown, as parts of one step")
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

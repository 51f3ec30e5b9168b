# SPDX-License-Identifier: BSD-3-Clause
"""A folder of GeoTIFF files as the steps of a solver: a grid with an array for each name.

    depth_0.tif  depth_600.tif  depth_1200.tif  bed.tif

A file's name ends with its time, after a _ or a -; the part before it is the array's name. A file without a time holds
for all times.
"""
import math
import re

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

from .readers import MOST_POINTS, FileError, grid_of_tiff

__all__ = ["TiffStack"]

SUFFIXES = (".tif", ".tiff")
NAMED = re.compile(r"(?P<array>.+?)[_-](?P<time>[0-9]+(?:\.[0-9]+)?)")
MOST_OFF = 1e-6  # of a pixel, between the places of two files


class TiffStack:
    """The steps of such a folder. All files must have the same pixels and place, and each array that has
    times must have all of them.

    Places without data, by the file's own no-data value, are NaN, which is dry.

    Raises
    ------
    FileError
    """

    is_lonlat = False  # degrees become metres when a file is read

    def __init__(self, path):
        self._path = path
        self._files = {}  # array: {time, or None for all times: file}
        for file in sorted(path.iterdir()):
            if file.suffix.lower() in SUFFIXES and not file.name.startswith("."):  # macOS's, with metadata
                self._add(file)
        if not self._files:
            raise FileError(f"{path}: has no GeoTIFF files ({', '.join(SUFFIXES)})")
        self.times = sorted({time for files in self._files.values() for time in files if time is not None})
        for array, files in self._files.items():
            missing = [time for time in self.times if time not in files]
            if None not in files and missing:
                raise FileError(f"{path}: '{array}' has no file for the time {missing[0]:g}; it has "
                                f"{', '.join(f'{time:g}' for time in sorted(files))} (the number at the end of a name "
                                "is its time)")
        self.hint = "; the names of its files begin with those of the arrays, such as depth_600.tif"
        self._grid = None  # of the file read first: size, spacing, origin, the file, its place in its own unit
        self._constant = {}

    def files_of(self, i):
        """The files of a step."""
        return [files.get(self._time_of(i), files.get(None)) for files in self._files.values()]

    def read(self, i):
        arrays = {name: self._values(name, self._time_of(i)) for name in self._files}
        (rows, columns), spacing, origin, _, _ = self._grid
        step = math.ceil(math.sqrt(rows * columns / MOST_POINTS))
        image = vtkImageData()
        image.SetDimensions(-(-columns // step), -(-rows // step), 1)
        image.SetSpacing(step * spacing[0], step * spacing[1], 1.0)
        image.SetOrigin(*origin, 0.0)
        for name, values in arrays.items():
            array = numpy_to_vtk(values[::step, ::step].ravel(), deep=True)
            array.SetName(name)
            image.GetPointData().AddArray(array)
        return image

    def _add(self, file):
        named = NAMED.fullmatch(file.stem)
        array = named["array"] if named else file.stem
        time = float(named["time"]) if named else None
        files = self._files.setdefault(array, {})
        if time in files or (files and (None in files) != (time is None)):
            other = next(iter(files.values())).name if time not in files else files[time].name
            raise FileError(f"{self._path}: {other} and {file.name} are both of '{array}'"
                            f"{'' if time is None or time not in files else f' at the time {time:g}'}")
        files[time] = file

    def _time_of(self, i):
        return self.times[i] if self.times else None

    def _values(self, name, time):
        files = self._files[name]
        if time in files:
            return self._read(files[time])
        if name not in self._constant:
            self._constant[name] = self._read(files[None])
        return self._constant[name]

    def _read(self, file):
        values, spacing, origin, no_data, place = grid_of_tiff(file)
        grid = values.shape, spacing, origin, file, place
        if self._grid is None:
            self._grid = grid
        first = self._grid
        if first[0] != grid[0]:
            raise FileError(f"{file}: has {grid[0][1]} x {grid[0][0]} pixels; {first[3].name} has "
                            f"{first[0][1]} x {first[0][0]}, and all files of a folder must have as many")
        size = max(first[0])
        for what, one, other, scale in (("pixel size", first[1], spacing, 1.0 / size),
                                        ("place", first[4], place, 1.0)):
            if max(abs(a - b) for a, b in zip(one, other)) > MOST_OFF * scale * max(first[1]):
                raise FileError(f"{file}: its {what} is {other[0]:g}, {other[1]:g}; that of {first[3].name} is "
                                f"{one[0]:g}, {one[1]:g}, and all files of a folder must lie in one place")
        values = np.array(values, dtype=float)
        if no_data is not None:
            values[values == no_data] = np.nan
        return values

# SPDX-License-Identifier: BSD-3-Clause
"""GeoTIFF files as the steps of a solver: a grid with an array for each name.

    depth_0.tif  depth_600.tif  depth_1200.tif  bed.tif

A file's name in a folder ends with its time, after a _ or a -; the part before it is the array's name. The time is a
number, or a date (date_of). A file without a time holds for all times. Files that are not in one folder are listed with
their times.
"""
import datetime
import math
import re
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

from .readers import MOST_POINTS, FileError, grid_of_tiff, is_no_data

__all__ = ["TiffStack", "is_stack"]

SUFFIXES = (".tif", ".tiff")
NAMED = re.compile(r"(?P<array>.+?)[_-](?P<time>[0-9]+(?:\.[0-9]+)?)")
DATED = re.compile(r"(?P<array>.+?)[_-](?P<year>\d{4})-?(?P<month>\d\d)-?(?P<day>\d\d)"
                   r"(?:[T_-]?(?P<hour>\d\d)[:-]?(?P<minute>\d\d)(?:[:-]?(?P<second>\d\d))?)?Z?")
YEARS = range(1800, 2200)  # of dates in names; others are numbers
PARTS = ("xy", "uv")  # the last letters of two arrays that are the components of a vector
MOST_OFF = 1e-6  # of a pixel, between the places of two files


def files_of(folder):
    """The GeoTIFF files of a folder, sorted; without those that begin with a dot, which are metadata of macOS."""
    return [file for file in sorted(Path(folder).iterdir())
            if file.suffix.lower() in SUFFIXES and not file.name.startswith(".")]


def is_stack(path):
    """Whether the path is a folder with GeoTIFF files."""
    return Path(path).is_dir() and bool(files_of(path))


def date_of(stem):
    """The array's name and the date at the end of a file's name; None if it does not end with a date.

    20240115, 2024-01-15, 20240115T0630, 2024-01-15_06-30-00, 20240115063000Z, from the year 1800 to 2199.
    """
    named = DATED.fullmatch(stem)
    if not named or int(named["year"]) not in YEARS:
        return None
    parts = [int(named[part] or 0) for part in ("year", "month", "day", "hour", "minute", "second")]
    try:
        return named["array"], datetime.datetime(*parts)
    except ValueError:
        return None  # such as a month 13


class TiffStack:
    """The steps of such files. All must have the same pixels and position, and each array that has times must have all
    of them.

    Places without data, by the file's own no-data value, are NaN, which is dry. Two arrays whose names end with _x and
    _y, or with _u and _v, are also the vector of the name before that.

    Parameters
    ----------
    path : pathlib.Path or Mapping
        A folder; or for each array's name a file of all times, or its files by their times:
        ``{"depth": {0.0: "a.tif", 600.0: "b.tif"}, "bed": "bed.tif"}``.

    Attributes
    ----------
    times : list[float]
        Numbers of the names, or seconds since the first of their dates.
    start : datetime.datetime or None
        That date.

    Raises
    ------
    FileError
    """

    is_lonlat = False  # degrees become metres when a file is read

    def __init__(self, path):
        self._path = "GeoTIFF files" if isinstance(path, Mapping) else path
        self._files = {}  # array: {time, or None for all times: file}
        self.start = None
        if isinstance(path, Mapping):
            self._list(path)
        else:
            self._find(path)
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

    def unit_of(self, name):
        return ""

    def read(self, i):
        arrays = {name: self._values(name, self._time_of(i)) for name in self._files}
        for first, second in PARTS:
            for name in [name.removesuffix(f"_{first}") for name in self._files if name.endswith(f"_{first}")]:
                if f"{name}_{second}" in self._files and name not in arrays:
                    arrays[name] = np.stack([arrays[f"{name}_{first}"], arrays[f"{name}_{second}"]], axis=-1)
        (rows, columns), spacing, origin, _, _ = self._grid
        step = math.ceil(math.sqrt(rows * columns / MOST_POINTS))
        image = vtkImageData()
        image.SetDimensions(-(-columns // step), -(-rows // step), 1)
        image.SetSpacing(step * spacing[0], step * spacing[1], 1.0)
        image.SetOrigin(*origin, 0.0)
        for name, values in arrays.items():
            array = numpy_to_vtk(values[::step, ::step].reshape(-1, *values.shape[2:]), deep=True)
            array.SetName(name)
            image.GetPointData().AddArray(array)
        return image

    def _find(self, path):
        """The files of a folder. Times are dates if all of them can be read as such."""
        files = files_of(path)
        if not files:
            raise FileError(f"{path}: has no GeoTIFF files ({', '.join(SUFFIXES)})")
        dates = {file: date_of(file.stem) for file in files}
        timed = [file for file in files if dates[file] or NAMED.fullmatch(file.stem)]
        other = next((file for file in timed if not dates[file]), None)
        certain = next((file for file in timed if dates[file] and not file.stem.rpartition("_")[2].isdigit()), None)
        if other and certain:
            raise FileError(f"{path}: the name of {certain.name} ends with a date, and that of {other.name} with a "
                            "number; the times of all files must be of one kind")
        if timed and not other:
            self.start = min(dates[file][1] for file in timed)
        for file in files:
            if self.start and dates[file]:
                array, date = dates[file]
                self._add(file, array, (date - self.start).total_seconds())
                continue
            named = NAMED.fullmatch(file.stem)
            self._add(file, named["array"] if named else file.stem, float(named["time"]) if named else None)

    def _list(self, files):
        """The files that a user lists."""
        for array, given in files.items():
            for time, file in (given if isinstance(given, Mapping) else {None: given}).items():
                if time is not None and not (isinstance(time, (int, float)) and math.isfinite(time)):
                    raise FileError(f"{file}: its time is {time!r}; it must be a finite number")
                self._add(Path(file), array, time)
            if array not in self._files:
                raise FileError(f"'{array}' has no files")
        if not files:
            raise FileError("the list of GeoTIFF files is empty")

    def _add(self, file, array, time):
        files = self._files.setdefault(array, {})
        if time in files or (files and (None in files) != (time is None)):
            other = next(iter(files.values())).name if time not in files else files[time].name
            raise FileError(f"{self._path}: {other} and {file.name} both hold '{array}'"
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
                            f"{first[0][1]} x {first[0][0]}, and all files must have the same size")
        size = max(first[0])
        for what, one, other, scale in (("pixel size", first[1], spacing, 1.0 / size),
                                        ("place", first[4], place, 1.0)):
            if max(abs(a - b) for a, b in zip(one, other)) > MOST_OFF * scale * max(first[1]):
                raise FileError(f"{file}: its {what} is {other[0]:g}, {other[1]:g}; that of {first[3].name} is "
                                f"{one[0]:g}, {one[1]:g}, and all files must have the same {what}")
        heights = np.array(values, dtype=float)
        if no_data is not None:
            heights[is_no_data(np.asarray(values), no_data)] = np.nan
        return heights

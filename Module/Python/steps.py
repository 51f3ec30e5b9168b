# SPDX-License-Identifier: BSD-3-Clause
"""The steps of a file that one of VTK's readers reads (sources.py says what a source has)."""
import math

from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

from .readers import FileError, heard

__all__ = ["Reader", "TimesError", "check_times"]


class TimesError(FileError):
    """The times of a file do not ascend, or are not finite."""


def check_times(path, times, may_repeat=False):
    """Raise a TimesError unless times are finite and ascend."""
    for i, time in enumerate(times):
        if not math.isfinite(time):
            raise TimesError(f"{path}: its time {i} is {time:g}; it must be finite")
        if i and (time < times[i - 1] or (time == times[i - 1] and not may_repeat)):
            raise TimesError(f"{path}: its time {i} is {time:g}, after {times[i - 1]:g}; times must ascend")


class Reader:
    """The steps of one of VTK's readers.

    hint: what may be wrong where a mesh or array is missing; may_repeat: whether two steps may have
    the same time; only one of them is then read
    """

    is_lonlat = False

    def __init__(self, path, reader, what, hint="", may_repeat=True):
        self._path, self._reader, self._what, self.hint = path, reader, what, hint
        with heard(path, what):
            if hasattr(reader, "CanReadFile") and not reader.CanReadFile(str(path)):
                raise FileError(f"{path}: not {what}")
            reader.SetFileName(str(path))
            reader.UpdateInformation()
        times = reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS()) or ()
        check_times(path, times, may_repeat)  # VTK would read other steps
        self.times = sorted(set(times))

    def files_of(self, i):
        return ()

    def unit_of(self, name):
        return ""

    def read(self, i):
        with heard(self._path, self._what):
            if self.times:
                self._reader.UpdateTimeStep(self.times[i])
            else:
                self._reader.Update()
        if hasattr(self._reader, "GetErrorCode") and self._reader.GetErrorCode():
            raise FileError(f"{self._path}: not {self._what}: reading stopped before its end")
        return self._reader.GetOutputDataObject(0)

# SPDX-License-Identifier: BSD-3-Clause
"""A wind sea looks the same whether the GPU makes its slopes or the processor does.

A software renderer is taken for a GPU by VTK_WATER_SOFTWARE=0; its surface's shader is then that for GPUs, too,
whose pictures are within 1 of 255 in 99.9 % of the pixels. Texel by texel the two are compared in
../Cxx/TestWaterSeaPasses.cxx, for sizes that a user cannot set, too.
"""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.vtkCommonCore import vtkLogger
from vtkwater import vtkWaterActor

TIMES = (0.0, 1e3, -2500.75, 1e6, 1.7e9)  # the last: seconds since 1970
STEP = 1 / 255
FEW = 0.001  # of the pixels


class Scene:
    """Water up to the horizon, so that the mip levels are looked up, too."""

    def __init__(self, size, period):
        self.water = vtkWaterActor()
        look = self.water.GetWaterProperty()
        look.SetSea(True)
        look.SetSeaTileSize(size)
        look.SetSeaPeriod(period)
        look.SetOutputToReflectance()
        self.water.SetSheetBounds(-500, 500, -500, 500)
        self.view = wt.View((120, 80), (0.5, 0.6, 0.7))
        self.view.renderer.AddActor(self.water)
        camera = self.view.renderer.GetActiveCamera()
        camera.SetPosition(1, -20, 4)
        camera.SetFocalPoint(0, 0, 2)
        camera.SetViewUp(0, 0, 1)
        camera.SetClippingRange(0.5, 900)

    def reflectance(self, time):
        self.water.SetTime(time)
        picture = self.view.picture()
        return (256 * picture[:, :, 0] + picture[:, :, 1]) / 65535


def pictures(software, size, period, monkeypatch, times=TIMES):
    monkeypatch.setenv("VTK_WATER_SOFTWARE", software)
    scene = Scene(size, period)
    return [scene.reflectance(time) for time in times]


def share_apart(pairs):
    """The share of pixels whose reflectance differs by more than a step."""
    return float(np.mean([np.abs(one - other) > STEP for one, other in pairs]))


@pytest.fixture
def logged(tmp_path):
    """What VTK logs at its lowest level, asked for after a picture."""
    path = str(tmp_path / "log.txt")
    vtkLogger.LogToFile(path, vtkLogger.TRUNCATE, vtkLogger.VERBOSITY_TRACE)

    def lines():
        vtkLogger.EndLogToFile(path)  # it is written then
        with open(path) as file:
            return [line for line in file if "computes the fields of the wind sea" in line]

    return lines


@pytest.mark.parametrize("size", [32, 64, 128, 256, 512])
@pytest.mark.parametrize("period", [0.0, 30.0], ids="period_{:g}".format)
def test_the_gpu_makes_the_processors_sea(size, period, monkeypatch, logged):
    """The picture is that of the processor's sea, now and after years, and the GPU made it."""
    title = f"size {size}, period {period:g}"
    found = pictures("0", size, period, monkeypatch)
    detours = logged()
    right = pictures("1", size, period, monkeypatch)
    wt.check_equal(f"{title}: the processor helped", detours, [])
    wt.check_at_most(f"{title}: share of pixels apart", share_apart(zip(found, right)), FEW)
    wt.check_at_least(f"{title}: change from one time to the next, of the reflectance",
                      min(float(np.abs(one - other).max()) for one, other in zip(found, found[1:])), 0.01)


def test_for_huge_times_the_processor_makes_the_sea(monkeypatch, logged):
    """At a time too large for the GPU's phases the picture is the processor's own; the log says why, once."""
    times = (5.0, 9e14, 1e15, 6.0)
    found = pictures("0", 64, 0.0, monkeypatch, times)
    detours = logged()
    right = pictures("1", 64, 0.0, monkeypatch, times)
    wt.check_at_most("share of pixels apart, huge times and others", share_apart(zip(found, right)), FEW)
    wt.check_equal("lines of the log", len(detours), 1)
    wt.check_equal("which say why", all("the time is too large" in line for line in detours), True)

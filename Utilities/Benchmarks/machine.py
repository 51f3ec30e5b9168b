# SPDX-License-Identifier: BSD-3-Clause
"""machine: what the times were measured on."""

import os
import pathlib
import platform

from driver import driver
from vtkmodules.vtkCommonCore import vtkVersion


def describe():
    return {
        "cpu": _cpu(),
        "cores": (
            len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
        ),
        "renderer": driver(),
        "window": os.environ.get("VTK_DEFAULT_OPENGL_WINDOW", "VTK's choice"),
        "vtk": vtkVersion.GetVTKVersion(),
        "python": platform.python_version(),
        "system": f"{platform.system()} {platform.machine()}",
        "load": round(os.getloadavg()[0], 2) if hasattr(os, "getloadavg") else None,
    }


def _cpu():
    info = pathlib.Path("/proc/cpuinfo")
    if info.is_file():
        for line in info.read_text().splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    return platform.processor() or platform.machine()

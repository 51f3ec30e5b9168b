# SPDX-License-Identifier: BSD-3-Clause
"""build_backend: scikit-build-core, told where VTK's headers are. For pip and build, by pyproject.toml.

A wheel is built against, whichever is there first:

1. the VTK that the environment variable VTK_DIR names (the folder of vtk-config.cmake); it must be a
   VTK for this Python whose libraries are those of PyPI's vtk;
2. the SDK that assemble.sh puts into build/sdk, Kitware's vtk-sdk or a stand-in. It is assembled when
   it is not there, which takes a minute and loads 200 MB.
"""
import os
import subprocess
import sys
from pathlib import Path

from scikit_build_core import build as scikit
from scikit_build_core.build import (  # noqa: F401  as they are
    build_sdist,
    get_requires_for_build_editable,
    get_requires_for_build_sdist,
    get_requires_for_build_wheel,
    prepare_metadata_for_build_editable,
    prepare_metadata_for_build_wheel,
)

HERE = Path(__file__).resolve().parent


def find_vtk():
    """The folder of VTK's CMake package."""
    if os.environ.get("VTK_DIR"):
        return os.environ["VTK_DIR"]
    sdk = HERE.parents[1] / "build" / ("sdk-%d%d" % sys.version_info[:2])
    found = sdk / "vtk-dir"
    if not found.is_file():
        environment = dict(os.environ, WATER_PYTHON=sys.executable)
        environment.pop("PYTHONPATH", None)  # pip's, for this process
        if subprocess.call(["bash", str(HERE / "assemble.sh"), str(sdk)], env=environment):
            raise SystemExit("vtkwater: no headers of PyPI's VTK (reason above); name the folder of its "
                             "vtk-config.cmake in the environment variable VTK_DIR")
    return found.read_text().strip()


def with_vtk(config_settings):
    return {**(config_settings or {}), "cmake.define.VTK_DIR": find_vtk()}


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    return scikit.build_wheel(wheel_directory, with_vtk(config_settings), metadata_directory)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    return scikit.build_editable(wheel_directory, with_vtk(config_settings), metadata_directory)

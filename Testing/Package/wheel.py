# SPDX-License-Identifier: BSD-3-Clause
"""The source distribution gives a wheel, and the wheel works beside PyPI's vtk without this tree.

usage: wheel.py SOURCE VTK_DIR VTKMODULES WORK    VTKMODULES: the folder of that VTK's Python package
"""
import os
import re
import shutil
import subprocess
import sys
import venv
import zipfile
from pathlib import Path

import installed_wheel
from installed_wheel import check, run

# many files at a time, and not optimised: what it draws is compared with nothing. script/wheels builds what is shipped
FAST = "-DCMAKE_UNITY_BUILD=ON -DCMAKE_CXX_FLAGS_RELEASE=-O0 -DCMAKE_C_FLAGS_RELEASE=-O0"
LIMIT_BYTES = 5 * 2**20
USE = """
import vtkwater
from vtkmodules.vtkRenderingCore import vtkActor
water = vtkwater.vtkWaterActor(level=2.5)
assert isinstance(water, vtkActor)
water.water_property.wind_speed = 7.0
print("level", water.level, "wind", water.water_property.GetWindSpeed())
"""


def build(source, vtk_dir, work):
    """The wheel of the tree's source distribution."""
    venv.create(work / "venv", with_pip=True)
    python = work / "venv/bin/python"
    run(python, "-m", "pip", "--disable-pip-version-check", "install", "-q", "build")
    run(python, "-m", "build", "--sdist", "--outdir", work / "dist", source)
    archive = next((work / "dist").glob("*.tar.gz"))
    run(python, "-m", "pip", "--disable-pip-version-check", "wheel", "-q", "--no-deps", archive, "-w", work / "dist",
        env=dict(os.environ, VTK_DIR=vtk_dir, CMAKE_ARGS=FAST))
    return next((work / "dist").glob("*.whl"))


def check_versions(source, wheel):
    cmake = re.search(r"project\(vtkWater VERSION ([0-9.]+)", (source / "CMakeLists.txt").read_text()).group(1)
    check("version of CMakeLists.txt in the wheel's name", wheel.name, f"-{cmake}-" in wheel.name)
    check("and in CITATION.cff", cmake, f"\nversion: {cmake}\n" in (source / "CITATION.cff").read_text())


def check_stubs(folder):
    """Every public method of the classes is in the stub, and the properties of VTK 9.4 are."""
    stub = (folder / "vtkwater/vtkRenderingWater.pyi").read_text()
    check("methods in the stub", stub.count("    def "), "def SetLevel(self, z:float)" in stub)
    check("keywords and properties in the stub", "level, water_property",
          "def __init__(self, **properties:Any)" in stub and "    level:" in stub and "    water_property:" in stub)


def main():
    source, vtk_dir, vtkmodules, work = (Path(argument) for argument in sys.argv[1:5])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    wheel = build(source, vtk_dir, work)
    check("bytes of the wheel", wheel.stat().st_size, wheel.stat().st_size < LIMIT_BYTES)
    check_versions(source, wheel)

    # as pip lays it: the package beside vtkmodules
    site = work / "site-packages"
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(site)
    (site / "vtkmodules").symlink_to(vtkmodules)
    check_stubs(site)
    for library in (site / "vtkwater").glob("*.so"):
        paths = re.search(rb"\$ORIGIN[^\0]*", library.read_bytes()).group().decode()
        check(f"paths in {library.name}", paths, "/../vtkmodules" in paths and str(vtkmodules) not in paths)

    # The copied library alone must serve: nothing of the build tree is on a path.
    environment = dict(os.environ, PYTHONPATH=str(site), LD_LIBRARY_PATH="")
    output = run(sys.executable, "-c", USE, env=environment, cwd=work, stdout=subprocess.PIPE).stdout
    check("classes of the wheel", output.strip(), output.strip() == "level 2.5 wind 7.0")
    run(sys.executable, "-m", "vtkwater", "--version", env=environment, cwd=work)
    picture = work / "first_water.png"
    run(sys.executable, source / "Examples/Python/first_water.py", picture, env=environment, cwd=work)
    check("bytes of the picture", picture.stat().st_size, picture.stat().st_size > 5000)
    installed_wheel.check_cmake_files(site / "vtkwater", source)
    os.environ["LD_LIBRARY_PATH"] = ""
    installed_wheel.build_consumer(source, vtk_dir, site / "vtkwater", work)


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: BSD-3-Clause
"""The installed wheel works: it renders, the command answers, and C and C++ programs are built against it.

usage: installed_wheel.py SOURCE VTK_DIR WORK    run by a Python that has the wheel and its dependencies
"""
import importlib.metadata
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path


def run(*command, **options):
    print("+", *command, flush=True)
    return subprocess.run([str(part) for part in command], check=True, text=True, **options)


def check(name, value, holds):
    print(f"{name}: {value} {'ok' if holds else 'FAILED'}", flush=True)
    if not holds:
        sys.exit(f"failed: {name}")


def check_cmake_files(package, source):
    """The wheel brings headers and CMake files, and these name no folder of the machine that built it."""
    headers = sorted((package / "include/vtk-water").rglob("*.h"))
    names = {file.name for file in headers}
    check("headers", len(headers), {"vtkWaterActor.h", "vtkWaterC.h", "water_plan.h"} <= names)
    files = list(package.rglob("*.cmake"))
    check("CMake files", len(files), any(file.name == "vtkWaterConfig.cmake" for file in files))
    named = [file.name for file in [*files, *package.rglob("*.pc")]
             if re.search(rf"{re.escape(str(source))}|/tmp/|/home/|/root/", file.read_text())]
    check("files that name a folder of the builder", named, not named)


def build_consumer(source, vtk_dir, package, work):
    """The consumer's programs in C and C++, as a user's project finds the wheel."""
    cmake = shutil.which("cmake")
    if not cmake:
        print("cmake is not here: nothing is built against the wheel")
        return
    run(cmake, "-S", source / "Testing/Package/Consumer", "-B", work / "consumer", "-DCMAKE_BUILD_TYPE=Release",
        f"-DCMAKE_PREFIX_PATH={package}", f"-DVTK_DIR={vtk_dir}", f"-DPython3_EXECUTABLE={sys.executable}")
    run(cmake, "--build", work / "consumer")
    run(work / "consumer/consumer_c")
    output = run(work / "consumer/consumer_cxx", stdout=subprocess.PIPE).stdout
    check("C++ program", output.strip().splitlines()[-1], "mirror rendered 1" in output)


def main():
    source, vtk_dir, work = (Path(argument).resolve() for argument in sys.argv[1:4])
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    import vtkwater

    package = Path(vtkwater.__file__).parent
    check("package", package, source not in package.parents or "build" in package.relative_to(source).parts)
    metadata = importlib.metadata.metadata("vtkwater")
    text = metadata.get_payload() or metadata["Description"]
    relative = re.findall(r"\]\((?!https?:|#)[^)]*\)", text)  # PyPI has no such files
    check("links of the README that PyPI cannot follow", relative, len(text) > 1000 and not relative)
    check("version", vtkwater.__version__, vtkwater.__version__ == importlib.metadata.version("vtkwater"))
    check_cmake_files(package, source)
    environment = dict(os.environ, DISPLAY="")
    run(sys.executable, "-m", "vtkwater", "info", env=environment, cwd=work)
    picture = work / "first_water.png"
    run(sys.executable, source / "Examples/Python/first_water.py", picture, env=environment, cwd=work)
    check("bytes of the picture", picture.stat().st_size, picture.stat().st_size > 5000)
    build_consumer(source, vtk_dir, package, work)


if __name__ == "__main__":
    main()

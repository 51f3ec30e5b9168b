# SPDX-License-Identifier: BSD-3-Clause
"""test: runs the Python and C++ tests in the pack's environment, several at a time, and says what failed.

    script/gpu test                     all but those of NOT_HERE, the faults, and COMMANDS
    script/gpu test Matrix Skips        those with one of these in their names
    script/gpu test --jobs 4 --list

They are run as ctest runs them (cmake/WaterTesting.cmake): a process a file, what VTK's own tests are
failed by fails them. Into $OUT: tests-gpu.txt, all that they said; mirror-matrix.md, when all of the
matrix ran; pictures.tar.gz, what the tests that failed have left. Exit status 1: something failed.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tarfile
import time
from concurrent.futures import ThreadPoolExecutor

PROJECT = pathlib.Path(__file__).resolve().parents[2]
TESTING = PROJECT / "Testing"
PACK = pathlib.Path(os.environ["WATER_GPU_PACK"])
NOT_HERE = {
    "TestWaterPyVista": "PyVista is not in the pack",
    **dict.fromkeys(("TestExampleBreakwater", "TestWaterCommandData", "TestWaterFileUnits", "TestWaterSolutionFaults", "TestWaterSolutions"),
                    "VTK's readers of NetCDF and HDF are not in the pack"),
    "TestMatrixNamesEveryClass": "the pack has a part of VTK",
    **dict.fromkeys(("TestWaterRanks", "TestWaterRankFeatures", "TestWaterRanksTable"), "MPI is not in the pack"),
}
FAULTS = "Utilities/Stress/faults.py"  # starts two processes for each fault: several share them
FAULTS_A_TEST = 8
COMMANDS = {
    "LongRun": ["Utilities/Stress/long_run.py", "--frames", "150", "--size", "64", "48"],
}
# As in cmake/WaterTesting.cmake.
FAILS = re.compile(r"(^|\n)ERROR: |ERR\||Error in cache state|instances? still around|Failed Image Test|ImageNotFound")
SKIPPED = re.compile(r"No module named '?(numpy|PIL|pytest|pyvista)")
LEFT_OUT = 125
SAYS = re.compile(r"FAILED|^E  |^ERROR: |\*\*worse\*\*|Error in cache state|Failed Image Test|ERR\|", re.M)
LINES = 12  # of a failure in the summary
TIMEOUT_S = 300
PICTURES_MB = 15  # of pictures.tar.gz


class Test:
    """A command, and what came of it."""

    def __init__(self, name, command, output, libraries=()):
        self.name, self.command, self.folder, self._libraries = name, command, output / name, libraries
        self.text, self.verdict, self.seconds = "", "not run", 0.0

    def run(self):
        self.folder.mkdir(parents=True, exist_ok=True)
        environment = {
            **os.environ,
            "VTK_TESTING": "1",
            "VTK_DATA_ROOT": str(TESTING / "Data"),
            "VTK_BASELINE_ROOT": str(TESTING / "Data" / "Baseline"),
            "WATER_TEST_OUTPUT": str(self.folder),
            "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",
            "LD_LIBRARY_PATH": ":".join([*map(str, self._libraries), os.environ.get("LD_LIBRARY_PATH", "")]),
        }
        begin = time.monotonic()
        try:
            done = subprocess.run(
                self.command, cwd=PROJECT, env=environment, timeout=TIMEOUT_S,
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False, errors="replace", text=True
            )
            self.text, code = done.stdout, done.returncode
        except subprocess.TimeoutExpired as error:
            self.text, code = (error.stdout or b"").decode(errors="replace"), f"after {TIMEOUT_S} s"
        self.seconds = time.monotonic() - begin
        if code == LEFT_OUT or SKIPPED.search(self.text):
            self.verdict = "left out"
        elif code:
            self.verdict = f"FAILED ({code})"
        else:
            self.verdict = "FAILED (by what it says)" if FAILS.search(self.text) else "passed"
        print(f"{self.name:40} {self.verdict:24} {self.seconds:6.1f} s", flush=True)

    @property
    def has_failed(self):
        return self.verdict.startswith("FAILED")

    def summary(self):
        lines = [line for line in self.text.splitlines() if SAYS.search(line)] or self.text.splitlines()[-LINES:]
        more = [f"... and {len(lines) - LINES} more"] if len(lines) > LINES else []
        return "\n    ".join([f"{self.name}: {self.verdict}", *lines[:LINES], *more])


def tests_of(output):
    python = sys.executable
    found = [Test(name, [python, *arguments], output) for name, arguments in COMMANDS.items()]
    faults = subprocess.run([python, FAULTS, "--list"], cwd=PROJECT, stdout=subprocess.PIPE, text=True,
                            check=True).stdout.splitlines()
    found += [Test(f"Faults{i + 1}", [python, FAULTS, *faults[first:first + FAULTS_A_TEST]], output)
              for i, first in enumerate(range(0, len(faults), FAULTS_A_TEST))]
    for path in sorted((TESTING / "Cxx").glob("Test*.cxx")):
        found.append(Test(path.stem, [
            PACK / "bin" / "vtkRenderingWaterCxxTests", path.stem, "-D", TESTING / "Data", "-T", output / path.stem,
            "-V", TESTING / "Data" / "Baseline" / f"{path.stem}.png"
        ], output, (PACK / "site" / "vtkwater", PACK / "site" / "vtkmodules")))
    for path in sorted((TESTING / "Python").rglob("Test*.py")):
        if path.stem not in NOT_HERE:
            pytest = ["-m", "pytest", "-s", "-q", "--tb=short", "-p", "no:cacheprovider"]
            found.append(Test(path.stem, [python, *pytest, path], output))
    return found


def write_matrix(output, folder):
    """The page of the matrix, of this machine alone; no harm if rows of it did not run."""
    subprocess.run([sys.executable, "Utilities/Scripts/mirror_matrix.py", "--out", str(folder / "mirror-matrix.md"),
                    *(str(path) for path in output.iterdir())], cwd=PROJECT, check=False)


def keep_pictures(failed, folder):
    path = folder / "pictures.tar.gz"
    size = 0
    with tarfile.open(path, "w:gz") as archive:
        for test in failed:
            for picture in sorted(test.folder.rglob("*.png")):
                size += picture.stat().st_size
                if size < 1e6 * PICTURES_MB:
                    archive.add(picture, picture.relative_to(test.folder.parent))
    if not size:
        path.unlink()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", help="parts of tests' names")
    parser.add_argument("--jobs", type=int, default=min(8, os.cpu_count() or 1))
    parser.add_argument("--list", action="store_true", help="what would be run")
    arguments = parser.parse_args()
    folder = pathlib.Path(os.environ.get("OUT") or PROJECT / "build" / "gpu" / "out")
    output = PROJECT / "build" / "gpu" / "Testing"
    tests = [test for test in tests_of(output)
             if not arguments.names or any(name in test.name for name in arguments.names)]
    if arguments.list:
        print(*(test.name for test in tests), sep="\n")
        return 0
    subprocess.run([sys.executable, "-m", "vtkwater", "info"], check=False)
    folder.mkdir(parents=True, exist_ok=True)
    begin = time.monotonic()
    with ThreadPoolExecutor(arguments.jobs) as pool:
        list(pool.map(Test.run, tests))
    (folder / "tests-gpu.txt").write_text(
        "\n".join(f"==== {test.name}: {test.verdict}, {test.seconds:.1f} s\n{test.text}" for test in tests))
    if any("TestMatrix" in test.name for test in tests):
        write_matrix(output, folder)
    failed = [test for test in tests if test.has_failed]
    keep_pictures(failed, folder)
    for name, reason in NOT_HERE.items():
        print(f"{name}: left out: {reason}")
    print("\n".join(["", *(test.summary() for test in failed)]))
    print(f"\n{len(tests)} tests in {time.monotonic() - begin:.0f} s, {len(failed)} failed"
          + (": " + ", ".join(test.name for test in failed) if failed else ""))
    return 1 if failed or not tests else 0


if __name__ == "__main__":
    sys.exit(main())

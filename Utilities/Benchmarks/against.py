# SPDX-License-Identifier: BSD-3-Clause
"""against: tells whether this build of the module is slower than another one, with the same frames.

    script/benchmark --against FOLDER [--sections SECTION...] [--runs N]

FOLDER holds the other build: <FOLDER>/lib/python3.11/site-packages/vtkwater. Two processes, one for
each build, run `benchmark.py --quick` and take turns, frame by frame, so that what slows the
machine down slows both down. Every run begins with the other one of them. Prints, for each kind of
frame, the CPU's and the clock's time over the other build's: medians over the runs of the
ratios of the runs' medians. Exit status 1: a ratio is over LIMIT.
"""

import argparse
import collections
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

LIMIT = 1.02
SECTIONS = ("ratios", "scaling")


def _python_path(build):
    found = next(pathlib.Path(build).resolve().glob("lib/**/vtkwater/__init__.py"), None)
    if not found:
        sys.exit(f"against: no vtkwater in {build}/lib")
    return found.parents[1]


def _run(builds, sections, folder):
    """Both builds at once; the first one's turn comes first. Returns the rows of each."""
    ends = [os.pipe(), os.pipe()]  # read by the first, read by the second
    os.write(ends[0][1], b".")
    processes, folders = [], []
    for i, build in enumerate(builds):
        folders.append(folder / str(i))
        folders[i].mkdir()
        mine, other = ends[i][0], ends[1 - i][1]
        environment = {
            **os.environ,
            "PYTHONPATH": str(_python_path(build)),
            "LD_LIBRARY_PATH": str(pathlib.Path(build).resolve() / "lib"),
            "WATER_BENCHMARK_TURNS": f"{mine},{other}",
        }
        benchmark = pathlib.Path(__file__).parent / "benchmark.py"
        with open(folders[i] / "log", "w") as log:
            processes.append(
                subprocess.Popen(
                    [sys.executable, benchmark, "--quick", "--folder", folders[i], "--only", *sections],
                    env=environment,
                    pass_fds=(mine, other),
                    stdout=log,
                    stderr=subprocess.STDOUT,
                )
            )
    for end in (*ends[0], *ends[1]):
        os.close(end)
    for process, where in zip(processes, folders):
        process.wait()  # a limit may be exceeded: that is another test
        if not (where / "benchmarks.json").exists():
            sys.exit((where / "log").read_text())
    return [json.loads((where / "benchmarks.json").read_text())["rows"] for where in folders]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("other", help="folder of the other build")
    parser.add_argument("--sections", nargs="+", default=SECTIONS)
    parser.add_argument("--runs", type=int, default=4)
    parser.add_argument("--build", default="build/wheel", help="folder of this build")
    arguments = parser.parse_args()

    ratios = collections.defaultdict(list)
    for run in range(arguments.runs):
        builds = [arguments.build, arguments.other]
        if run % 2:
            builds.reverse()
        with tempfile.TemporaryDirectory() as folder:
            rows = _run(builds, arguments.sections, pathlib.Path(folder))
        if run % 2:
            rows.reverse()
        for ours, theirs in zip(*rows):
            if ours.get("median_ms"):
                key = " / ".join(str(ours[name]) for name in ("section", "scene", "step", "scale") if name in ours)
                ratios[key].append((ours["work_ms"] / theirs["work_ms"], ours["median_ms"] / theirs["median_ms"]))
        print(f"run {run + 1} of {arguments.runs}", flush=True)

    failed = 0
    print("      CPU  clock  frame")
    for key, found in ratios.items():
        work, clock = (statistics.median(column) for column in zip(*found))
        is_over = work > LIMIT
        failed += is_over
        print(f"{work:9.3f}  {clock:5.3f}  {key}{'  over' if is_over else ''}")
    print(f"{len(ratios)} kinds of frames, {failed} over {LIMIT}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

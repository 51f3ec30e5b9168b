# SPDX-License-Identifier: BSD-3-Clause
"""frame_digests: proves that a change of the library changes no picture: digests of every frame, before and after.

    frame_digests.py write OUT.json [--tests DIR] [--only REGEX]   runs the scripts, one after the other
    frame_digests.py compare A.json B.json [--only REGEX]          exit status 1: something differs
    frame_digests.py run SCRIPT FRAMES ARGUMENT...                 one script: what write calls

The scripts are the Python tests, the Python examples and the sections of Utilities/Accuracy that render. DIR is
the root of the checkout that they come from, by default this one: a new library is to be tried with the scripts
that the old one was tried with. Interpreter, library and window are those of the environment; ctest's is in
cmake/WaterTesting.cmake. C++ tests have baselines, and are not run.

A script's list holds the MD5 of each picture that water_test.View.shown returned (shape and bytes), in their
order, then those of the picture files that it left, with their names. A list is compared as it stands; one that
differs is compared without its order, which tells how many frames are missing and how many are new. What is not
the same in two runs of one library is left out by name, see UNSTEADY and UNORDERED.

What reads its window in another way and leaves no file is not seen: vtkWindowToImageFilter, vtkTesting,
GetRGBACharPixelData, PyVista's screenshots, processes that a test starts.
"""
import argparse
import collections
import fnmatch
import hashlib
import importlib
import json
import os
import pathlib
import re
import runpy
import signal
import subprocess
import sys
import tempfile
import time

TIMEOUT_S = 300
PATTERNS = ("Testing/Python/TestWater*.py", "Testing/Python/Matrix/TestMatrix*.py", "Examples/Python/*.py")
SECTIONS = ("lookup", "colour", "confidence")  # of the accuracy suite; the others measure time
PICTURES = {".avi", ".bmp", ".gif", ".jpg", ".mp4", ".ogv", ".png", ".ppm", ".tif"}

# example -> its arguments, as in Examples/CMakeLists.txt; all others get the name of their picture alone
EXAMPLES = {
    "batch": ["--out", "FOLDER", "--make", "4"],
    "flood": ["--picture", "FOLDER/flood.png"],
    "lake": ["ROOT/Examples/Data/jacksboro.vti", "FOLDER"],
    "tide": ["FOLDER/tide.gif", "--frames", "6", "--picture", "FOLDER/tide.png"],
    **{name: [f"FOLDER/{name}.png", "2.0"] for name in ("cove", "sea", "swell", "waves")},
}

# script, or script:file (* stands for anything) -> why two runs of one library differ
UNSTEADY = {
    "Testing/Python/TestWaterCommand.py:Command/frames/*": "a movie that the test stops by a signal: how many of its "
                                                           "frames are made depends on time",
}
# script -> why its frames come in another order
UNORDERED = {
    "Testing/Python/TestWaterFaults.py": "two threads render at the same time",
}


# ---- run: in a process of its own

def record_frames(frames):
    """From here on, writes the digest of each picture that a view shows into a file."""
    import numpy as np
    import water_test

    shown = water_test.View.shown

    def shown_and_recorded(view, *arguments, **values):
        picture = shown(view, *arguments, **values)
        pixels = np.ascontiguousarray(picture, dtype=np.uint8)
        digest = hashlib.md5(repr(pixels.shape).encode() + pixels.tobytes()).hexdigest()
        with open(frames, "a") as file:  # at once: a crash loses none
            file.write(digest + "\n")
        return picture

    water_test.View.shown = shown_and_recorded


class Recorder:
    """pytest's plugin: records before a file is imported, which may render, and after conftest.py."""

    def __init__(self, frames):
        self._frames = frames

    def pytest_collection(self):
        record_frames(self._frames)


def run_section(script, folder):
    """A section of the accuracy suite; accuracy.py itself would write into the checkout."""
    from report import Report

    report = Report(folder)
    importlib.import_module(script.stem).run(report)
    return 1 if report.has_failed() else 0


def run(script, frames, arguments):
    """Returns the exit status, or ends with it."""
    root = root_of(script)
    # in place of this file's folder
    sys.path[0:1] = [str(script.parent), *([] if "Examples" in script.parts else [str(root / "Testing/Python")])]
    sys.argv = [str(script), *arguments]
    if any(line.startswith("def test_") for line in script.read_text().splitlines()):
        import pytest

        return pytest.main(["-s", "-q", "-p", "no:cacheprovider", str(script)], plugins=[Recorder(frames)])
    if script.match("Examples/Python/*.py"):
        runpy.run_path(str(script), run_name="__main__")
        return 0
    record_frames(frames)
    if script.match("Utilities/Accuracy/*.py"):
        return run_section(script, pathlib.Path.cwd())
    runpy.run_path(str(script), run_name="__main__")
    return 0


# ---- write

def root_of(script):
    """The checkout that a script is in."""
    return next(folder for folder in script.parents if (folder / "vtk.module").exists())


def scripts_in(root):
    """What to run, relative to the checkout."""
    found = [path.relative_to(root).as_posix() for pattern in PATTERNS for path in sorted(root.glob(pattern))]
    return found + [f"Utilities/Accuracy/{section}.py" for section in SECTIONS]


def arguments_of(script, root, folder):
    if not script.startswith("Examples/"):
        data = root / "Testing/Data"
        name = pathlib.Path(script).stem
        return ["-D", str(data), "-T", folder, "-V", str(data / "Baseline" / f"{name}.png")]
    name = pathlib.Path(script).stem
    return [argument.replace("FOLDER", folder).replace("ROOT", str(root))
            for argument in EXAMPLES.get(name, [f"FOLDER/{name}.png"])]


def status_of(command, log, **how):
    """The exit status of a command, or that it took too long; nothing of it stays behind."""
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT,
                               start_new_session=True, **how)
    try:
        return process.wait(TIMEOUT_S)
    except subprocess.TimeoutExpired:
        return f"more than {TIMEOUT_S} s"
    finally:
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:  # as it should be
            pass
        process.wait()


def digests_of(script, root):
    """{status, frames} of a script, and the last line that it said."""
    with tempfile.TemporaryDirectory() as place, tempfile.TemporaryFile("w+", errors="replace") as log:
        folder, frames = pathlib.Path(place, "output"), pathlib.Path(place, "frames")
        folder.mkdir()
        frames.touch()
        data = root / "Testing/Data"
        environment = {**os.environ, "VTK_DATA_ROOT": str(data), "VTK_BASELINE_ROOT": str(data / "Baseline"),
                       "WATER_TEST_OUTPUT": str(folder), "PYTHONDONTWRITEBYTECODE": "1"}
        command = [sys.executable, __file__, "run", root / script, frames, *arguments_of(script, root, str(folder))]
        status = status_of(command, log, cwd=folder, env=environment)
        files = sorted(path for path in folder.rglob("*") if path.suffix in PICTURES and path.is_file())
        found = frames.read_text().split() + [f"{hashlib.md5(path.read_bytes()).hexdigest()} "
                                              f"{path.relative_to(folder).as_posix()}" for path in files]
        log.seek(0)
        said = [line.strip() for line in log if line.strip()]
    return {"status": status, "frames": found}, said[-1] if said else "it said nothing"


def write(out, root, only):
    results = {}
    for script in scripts_in(root):
        if not re.search(only, script):
            continue
        begin = time.monotonic()
        results[script], last_line = digests_of(script, root)
        status, count = results[script]["status"], len(results[script]["frames"])
        trouble = "" if status == 0 else f", status {status}: {last_line}"
        print(f"{script}: {count} frames, {time.monotonic() - begin:.0f} s{trouble}", flush=True)
        out.write_text(json.dumps(results, indent=1) + "\n")  # at once: to stop it loses none
    print(f"{len(results)} scripts, {sum(len(result['frames']) for result in results.values())} frames")
    return 0


# ---- compare

def compared(script, frames):
    """What of a script's list is the same in each run of one library."""
    kept = [frame for frame in frames
            if not any(fnmatch.fnmatchcase(f"{script}:{frame.partition(' ')[2]}", name) for name in UNSTEADY)]
    return sorted(kept) if script in UNORDERED else kept


def difference(script, then, now):
    """In words what differs between two runs of a script; empty: nothing."""
    words = []
    if then["status"] != now["status"]:
        words.append(f"status {now['status']}, was {then['status']}")
    before, after = (compared(script, result["frames"]) for result in (then, now))
    if before != after:
        missing, new = (sum((collections.Counter(a) - collections.Counter(b)).values())
                        for a, b in ((before, after), (after, before)))
        first = next((i for i, (a, b) in enumerate(zip(before, after)) if a != b), min(len(before), len(after)))
        what = (f"{missing} of {len(before)} frames missing, {new} new" if missing or new
                else f"the same {len(before)} frames in another order")
        words.append(f"{what}, from frame {first} on")
    return "; ".join(words)


def compare(old_file, new_file, only):
    old, new = ({script: result for script, result in json.loads(file.read_text()).items() if re.search(only, script)}
                for file in (old_file, new_file))
    differs = same = frames = 0
    for what, names in (("left out", UNSTEADY), ("in any order", UNORDERED)):
        for name, reason in names.items():
            if re.search(only, name):
                print(f"{name}: {what}: {reason}")
    for script in sorted({*old, *new} - {*UNSTEADY}):
        if script not in old or script not in new:
            words = f"only in {(new_file if script in new else old_file).name}"
        else:
            words = difference(script, old[script], new[script])
        if words:
            print(f"{script}: {words}")
            differs += 1
        else:
            same += 1
            frames += len(compared(script, old[script]["frames"]))
    print(f"{differs} scripts differ, {same} with {frames} frames do not")
    return 1 if differs or not same else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    verbs = parser.add_subparsers(dest="verb", required=True)
    only = argparse.ArgumentParser(add_help=False)
    only.add_argument("--only", default="", metavar="REGEX", help="scripts with this in their path")
    verb = verbs.add_parser("write", parents=[only])
    verb.add_argument("out", type=pathlib.Path)
    verb.add_argument("--tests", type=pathlib.Path, default=pathlib.Path(__file__).parents[2], metavar="DIR",
                      help="the root of the checkout with the scripts; default: this one")
    verb = verbs.add_parser("compare", parents=[only])
    verb.add_argument("files", type=pathlib.Path, nargs=2)
    verb = verbs.add_parser("run")
    verb.add_argument("script", type=pathlib.Path)
    verb.add_argument("frames", type=pathlib.Path)
    verb.add_argument("arguments", nargs=argparse.REMAINDER)
    given = parser.parse_args()
    if given.verb == "run":
        return run(given.script.resolve(), given.frames.resolve(), given.arguments)
    if given.verb == "write":
        return write(given.out, given.tests.resolve(), given.only)
    return compare(*given.files, given.only)


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: BSD-3-Clause
"""TestWaterRanks: a scene that is split over the ranks of a parallel program shows the serial picture.

ranks_program.py is started by mpirun; this file judges the figures that it prints. Without mpirun, or VTK's
module of MPI, there is nothing to test with, and the tests are skipped.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

import pytest
import water_test as wt

MPIRUN = shutil.which("mpirun")
pytest.importorskip("vtkmodules.vtkParallelMPI", reason="this VTK has no vtkParallelMPI")
pytestmark = pytest.mark.skipif(not MPIRUN, reason="no mpirun (Debian: openmpi-bin)")

PROGRAM = pathlib.Path(__file__).with_name("ranks_program.py")
OF_ALL_PIXELS = 0.0002
RENDERED, FAILED, REUSED = 1, 2, 8


def mpirun_command(count):
    """What starts so many ranks; empty without mpirun. A rank that waits leaves the processor to the others."""
    as_root = ["--allow-run-as-root"] if os.geteuid() == 0 else []
    waiting = ["--mca", "mpi_yield_when_idle", "1"]
    return [MPIRUN, *as_root, "--oversubscribe", "--bind-to", "none", *waiting, "-np", str(count)] if MPIRUN else []


def start(count, *arguments):
    """What so many ranks come to."""
    return subprocess.run([*mpirun_command(count), sys.executable, str(PROGRAM), *arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, timeout=280, check=False)


def run(count):
    """The figures that so many ranks print, by case."""
    done = start(count, *([str(wt.output_folder())] if "WATER_TEST_OUTPUT" in os.environ else []))
    assert done.returncode == 0, done.stdout + done.stderr
    return cases_of(done.stdout)


def cases_of(text):
    """The figures in a text, by case; mpirun may have joined the lines of two ranks."""
    cases = {}
    for part in text.split("FIGURES ")[1:]:
        figures, _ = json.JSONDecoder().raw_decode(part)
        cases.setdefault(figures.pop("case"), []).append(figures)
    return cases


@pytest.fixture(scope="module", params=[2, 4])
def cases(request):
    return run(request.param)


def test_ranks_show_the_serial_picture(cases):
    """Whatever the split and the look, beyond what the engine is off by without water."""
    floor = max(case["off"] for case in cases["compare"] if case["look"] == "dry")
    wt.check_equal("looks and splits", len(cases["compare"]), 20)
    for case in cases["compare"]:
        wt.check_at_most(f"{case['look']}, {case['split']}: share of pixels off", case["off"], floor + OF_ALL_PIXELS)
        for decision, pixels, errors in case["facts"] if case["look"] != "dry" else ():
            wt.check_equal("  decision", decision, RENDERED)
            wt.check_at_least("  pixels joined", pixels, 1)
            wt.check_equal("  errors", errors, 0)


def test_translucent_props_and_volumes_are_blended_in_order(cases):
    """Where the ranks' parts are apart, whichever of them is near; 8 bits a rank round it."""
    wt.check_equal("scenes", len(cases["blend"]), 8)
    for case in cases["blend"]:
        name = f"{case['what']}, {'half floats' if case['half'] else '8 bits'}, reversed {case['reversed']}"
        wt.check_at_most(f"{name}: RMSE of 255", case["rmse"], 1)
        wt.check_at_least("  RMSE without them", case["shown"], 10)
        wt.check_equal("  error", case["error"], "")


def test_secondary_reflections_are_left_out_and_each_rank_says_so(cases):
    """Once, and the picture is that without them."""
    (case,) = cases["secondary"]
    wt.check_equal("warnings, secondary views, errors of each rank", [said == [1, 0, 0] for said in case["said"]],
                   [True] * len(case["said"]))
    wt.check_at_most("share of pixels off", case["off"], 0.0)


def test_nothing_is_sent_while_nothing_changes(cases):
    """A change on one rank has all of them render again."""
    (case,) = cases["use again"]
    for frame, decision in enumerate((RENDERED, REUSED, RENDERED, REUSED)):
        for rank, (decided, pixels) in enumerate(case["frames"][frame]):
            wt.check_equal(f"frame {frame}, rank {rank}", decided, decision)
            wt.check("  pixels joined", pixels, "0 where it is used again", (pixels > 0) == (decision == RENDERED))
    wt.check_at_most("share of pixels off", case["off"], OF_ALL_PIXELS)


def test_ranks_that_differ_say_so(cases):
    """Every rank says it once, none waits, and the picture is as before when they are the same again."""
    wt.check_equal("faults", len(cases["fault"]), 7)
    for case in cases["fault"]:
        for rank, (said, names_rank, decision, left) in enumerate(case["said"]):
            wt.check_equal(f"{case['fault']}, rank {rank}: errors", said, 1)
            wt.check_equal("  names a rank", names_rank, 1)
            wt.check("  afterwards", decision, "rendered or used again", decision in (RENDERED, REUSED))
            wt.check_equal("  error left", left, 0)
        wt.check_at_most(f"{case['fault']}: share of pixels off afterwards", case["off"], 0)


def test_ranks_that_wait_for_one_without_a_controller_are_ended():
    """By the limit that they have set, with an error, and the one that they wait for by mpirun."""
    begun = time.monotonic()
    done = start(3, "--missing")
    wt.check("exit status", done.returncode, "not 0", done.returncode != 0)
    wt.check_at_most("seconds", time.monotonic() - begun, 30)  # with the start of MPI and Python
    wt.check("says", done.stderr[-300:], "has waited 2 s", "has waited 2 s for the other ranks" in done.stderr)


@pytest.mark.parametrize("kind", ("uninitialised", "finalised"))
def test_controller_that_cannot_speak_is_an_error_of_every_rank(kind):
    """Said once by the water, not by VTK in every frame; the plain colour is shown, and all is well without it."""
    done = start(2, "--controller", kind)
    wt.check_equal(f"{kind}: exit status", done.returncode, 0)
    wt.check_equal("  errors of VTK", done.stderr.count("Communicator not set"), 0)
    said = cases_of(done.stdout).get(kind, [])
    wt.check_equal("  ranks that say something", len(said), 2)
    for rank in said:
        wt.check_equal("  errors of the water", len(rank["heard"]), 1)
        wt.check("  error", rank["left"], "names what to do", "Initialize" in rank["left"] and "Finalize" in rank["left"])
        wt.check_equal("  the pass prints that it has no communicator", rank["printed"], True)
        wt.check_at_least("  pixels off the reflection of its part", rank["off own part"], 0.02)
        wt.check_equal("  error without a controller", rank["left afterwards"], "")
        wt.check_equal("  pixels off then", rank["off afterwards"], 0)


def test_controller_of_one_process_among_several_is_an_error_of_every_rank():
    """It is set all the same: the rank reflects its own part."""
    done = start(2, "--controller", "one each")
    wt.check_equal("exit status", done.returncode, 0)
    said = cases_of(done.stdout).get("one each", [])
    wt.check_equal("ranks that say something", len(said), 2)
    for rank in said:
        wt.check_equal("errors of the pass", len(rank["heard by pass"]), 1)
        wt.check("  error", rank["heard by pass"], "names both numbers",
                 "has 1 process" in rank["heard by pass"][0] and "has started 2" in rank["heard by pass"][0])
        wt.check_equal("  errors of the water", rank["heard"], [])
        wt.check_equal("  pixels off the reflection of its part", rank["off own part"], 0)


def test_ranks_that_end_mpi_under_a_controller_are_ended():
    """By MPI itself, which names the call; no rank waits."""
    begun = time.monotonic()
    done = start(2, "--controller", "ended")
    wt.check("exit status", done.returncode, "not 0", done.returncode != 0)
    wt.check("says", done.stderr[-300:], "MPI_FINALIZE", "MPI_FINALIZE" in done.stderr.upper())
    wt.check_equal("ranks that go on", cases_of(done.stdout), {})
    wt.check_at_most("seconds", time.monotonic() - begun, 20)  # the limit of waiting is as long


def test_random_frames_are_the_serial_ones(cases):
    """Water on and off, presets, props shown by their rank, sizes, ranks that render alone; script/ranks has 500."""
    (case,) = cases["toggle"]
    wt.check_at_least("the rarest kind of change, frames", min(case["kinds"]), 5)
    wt.check_at_most(f"{case['frames']} frames: share of pixels off", case["off"], OF_ALL_PIXELS)


def test_one_rank_is_as_good_as_none():
    (case,) = run(1)["alone"]
    wt.check_equal("pixels off", case["off"], 0)
    wt.check_equal("pixels joined", case["pixels"], 0)
    wt.check_equal("error", case["error"], "")

# SPDX-License-Identifier: BSD-3-Clause
"""TestWaterRankFeatures: what a renderer may have on beside water is on ranks as in one process.

Ambient occlusion, FXAA, depth peeling and other translucency, several waters, clear ones among them, rays that go on
behind edges, levels of detail. ranks_features.py is started by mpirun; this file judges the figures that it prints.
script/ranks has it with 2 and 4 ranks and more looks (WATER_RANKS_ALL=1).
"""

import os

import pytest
import water_test as wt
from TestWaterRanks import OF_ALL_PIXELS, mpirun_command
from TestWaterRanksTable import run

IS_WHOLE = os.environ.get("WATER_RANKS_ALL") == "1"
COUNTS = (2, 4) if IS_WHOLE else (2,)
LOOKS = 22 if IS_WHOLE else 9

pytest.importorskip("vtkmodules.vtkParallelMPI", reason="this VTK has no vtkParallelMPI")
pytestmark = pytest.mark.skipif(not mpirun_command(1), reason="no mpirun (Debian: openmpi-bin)")


@pytest.fixture(scope="module", params=COUNTS)
def cases(request):
    whole = ["--whole"] if IS_WHOLE else []
    folder = ["--folder", str(wt.output_folder())] if "WATER_TEST_OUTPUT" in os.environ else []
    return run(request.param, "ranks_features.py", *whole, *folder)


def check_facts(case):
    for errors, pixels in case["facts"]:
        wt.check_equal("  errors", errors, 0)
        wt.check_at_least("  pixels joined", pixels, 1)


def test_features_and_several_waters_are_the_serial_ones(cases):
    """Where the engine without water is; pixels that it has wrong by itself are not judged, nor their neighbours."""
    compared = [case for case in cases if "judged" in case]
    wt.check_equal("features, waters and looks", len(compared), LOOKS)
    for case in compared:
        wt.check_at_most(f"{case['case']}, {case['look']}: share of pixels off", case["off"], OF_ALL_PIXELS)
        wt.check_at_least("  share of pixels judged", case["judged"], 0.25)
        check_facts(case)
    for name in {case["case"] for case in compared}:
        apart = max(case["apart"] for case in compared if case["case"] == name)
        wt.check_at_least(f"{name}: share off if ranks do not join their views", apart, 20 * OF_ALL_PIXELS)


def test_shades_are_off_no_more_than_the_engine_has_them(cases):
    """VTK's shadow maps and ambient occlusion are those of a rank's own part, also on a plane of VTK's in the water's place."""
    for what in ("shadow maps", "SSAO"):
        found = {case["look"]: case for case in cases if case["case"] == "shades" and case["what"] == what}
        wt.check_equal(f"{what}: looks", len(found), 6 if IS_WHOLE else 4)
        dry, plane = found.pop("dry"), found.pop("sheet")
        print(f"{what}: % of the pixels off: {100 * dry['off']:.1f} without water, {100 * plane['off']:.1f} with a plane")
        for look, case in found.items():
            wt.check_at_most(f"{what}, {look}: share of pixels off", case["off"], plane["off"])
            wt.check_at_most("  share off / share off if ranks do not join their views", case["off"] / case["apart"], 0.9)


def test_waves_find_what_is_blended(cases):
    """Translucent props and volumes of all ranks, by rays that look for their depth."""
    blended = [case for case in cases if case["case"] == "blended in waves"]
    wt.check_equal("scenes", len(blended), 4 if IS_WHOLE else 2)
    for case in blended:
        wt.check_at_most(f"{case['what']}, half floats {case['half']}: RMSE of 255", case["rmse"], 1)
        wt.check_at_least("  RMSE without them", case["shown"], 10)
        check_facts(case)


def test_levels_of_detail_are_the_serial_ones(cases):
    """Coarse during an interaction, fine before and after it."""
    (case,) = [case for case in cases if case["case"] == "levels of detail"]
    levels = [frame["level"] for frame in case["frames"]]
    for i, frame in enumerate(case["frames"]):
        wt.check_at_most(f"frame {i}, level {frame['level']}: share of pixels off", frame["off"], OF_ALL_PIXELS)
        if i and levels[i] != levels[i - 1]:
            wt.check_at_least("  share of pixels that another level changes", frame["changed"], 0.05)

# SPDX-License-Identifier: BSD-3-Clause
"""TestWaterRanksTable: water of every kind, in every split, is as near to the serial picture as ranks without it.

Prints a table: share of the pixels, in percent, that are off by more than 1 of 255. ranks_table.py is started by
mpirun. script/ranks has it with 1, 2, 4 and 8 ranks and all looks (WATER_RANKS_ALL=1), and 500 random frames;
without that 2 ranks show the looks that take all ways through the module.
"""

import json
import os
import pathlib
import subprocess
import sys

import pytest
import water_test as wt
from TestWaterRanks import OF_ALL_PIXELS, mpirun_command

IS_WHOLE = os.environ.get("WATER_RANKS_ALL") == "1"
COUNTS = (1, 2, 4, 8) if IS_WHOLE else (2,)
SOME_LOOKS = ("dry", "sheet", "painted displaced sea", "unbounded dry", "clear waves", "sea", "displaced sea",
              "clear displaced sea", "unbounded clear", "shadows", "own view")
SOME_SPLITS = ("blocks", "one empty", "random")

pytest.importorskip("vtkmodules.vtkParallelMPI", reason="this VTK has no vtkParallelMPI")
pytestmark = pytest.mark.skipif(not mpirun_command(1), reason="no mpirun (Debian: openmpi-bin)")


def floors_of(look):
    """The looks that show what the ranks' engine is off by without the water: same place, same shape."""
    place = "unbounded dry" if look.startswith("unbounded") else "dry"
    shape = next((kind for kind in ("displaced waves", "displaced sea") if look.endswith(kind)), None)
    if place == "unbounded dry":
        return (place, f"unbounded painted {shape or 'calm'}")
    return (place, f"painted {shape}" if shape else "sheet")


def run(count, name, *arguments):
    program = pathlib.Path(__file__).with_name(name)
    done = subprocess.run([*mpirun_command(count), sys.executable, str(program), *arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, timeout=7200 if IS_WHOLE else 400, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    lines = [line for line in done.stdout.splitlines() if line.startswith("FIGURES ")]
    return [json.loads(line[len("FIGURES "):]) for line in lines]


def print_table(count, samples, shares):
    """A row a look, a column a split."""
    splits = list(dict.fromkeys(split for _, split in shares))
    print(f"\n{count} ranks, {samples} samples a pixel: % of the pixels off by more than 1 of 255")
    print(f"| {'look':34}| " + " | ".join(f"{split:15}" for split in splits) + " |")
    for look in dict.fromkeys(look for look, _ in shares):
        print(f"| {look:34}| " + " | ".join(f"{100 * shares[look, split]:<15.4f}" for split in splits) + " |")


@pytest.mark.parametrize("count", COUNTS)
def test_every_water_in_every_split(count):
    arguments = () if IS_WHOLE else ("--looks", ",".join(SOME_LOOKS), "--splits", ",".join(SOME_SPLITS))
    cases = run(count, "ranks_table.py", "0,8", *arguments)
    for samples in (0, 8):
        chosen = [case for case in cases if case["samples"] == samples]
        shares = {(case["look"], case["split"]): case["off"] for case in chosen}
        print_table(count, samples, shares)
        waters = [case for case in chosen if not any(word in case["look"] for word in ("dry", "sheet", "painted"))]
        wt.check_at_least("waters and splits", len(waters), 15)
        for case in waters:
            look, split = case["look"], case["split"]
            floor = max(shares.get((name, split), 0) for name in floors_of(look))
            name = f"{count} ranks, {samples} samples, {look}, {split}"
            wt.check_at_most(f"{name}: share of pixels off", case["off"], floor + OF_ALL_PIXELS)
            for decision, pixels, errors in case["facts"]:
                wt.check_equal("  errors", errors, 0)
                wt.check("  pixels joined", pixels, "0 with one rank alone", (pixels > 0) == (count > 1))
                wt.check("  decision", decision, "rendered, or used again", decision in (1, 8))


@pytest.mark.skipif(not IS_WHOLE, reason="script/ranks; TestWaterRanks has fewer")
@pytest.mark.parametrize("count", (2, 4))
def test_500_random_frames(count):
    (case,) = run(count, "ranks_program.py", "--frames", "500")
    print(case)
    wt.check_equal("frames", case["frames"], 500)
    wt.check_at_most("share of pixels off, at worst", case["off"], OF_ALL_PIXELS)

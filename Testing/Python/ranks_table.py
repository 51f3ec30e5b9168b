#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""ranks_table: what TestWaterRanksTable starts with mpirun: waters of all kinds, split in all ways.

usage: mpirun -np N ranks_table.py SAMPLES[,SAMPLES...] [--looks LOOK,LOOK] [--splits SPLIT,SPLIT] [--folder FOLDER]

Prints a line of JSON for each number of samples, look and split on rank 0, as ranks_program does.
FOLDER: where pictures go.
"""

import argparse

import ranks_program as program

# what the engine is off by itself: without water, with a plane of VTK's, with surfaces that show nothing of others
FLOORS = ("dry", "sheet", "painted displaced waves", "painted displaced sea", "unbounded dry",
          "unbounded painted calm", "unbounded painted displaced sea")
WATERS = (*program.LOOKS, *program.SEAS, "unbounded waves", "unbounded clear", "unbounded displaced sea")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("samples")
    parser.add_argument("--looks", default=",".join(FLOORS + WATERS))
    parser.add_argument("--splits", default=",".join(program.SPLITS))
    parser.add_argument("--folder")
    given = parser.parse_args()
    ranks = program.Ranks()
    for samples in map(int, given.samples.split(",")):
        for look in given.looks.split(","):
            serial = program.serial_picture(ranks, look, samples)
            view = program.rank_view(ranks, lambda number: True, look, samples)
            for split in given.splits.split(","):
                program.compare(ranks, split, look, given.folder, samples, serial, view)
    ranks.end()


if __name__ == "__main__":
    main()

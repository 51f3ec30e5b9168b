# SPDX-License-Identifier: BSD-3-Clause
"""compare: what reflective water costs here and elsewhere, the same scene, one run, one machine.

    script/compare                   everything, into Documentation/comparison.md and its images
    script/compare --quick           fewer frames, into build/compare
    script/compare --only PEER...    some peers, into build/compare

How it is put together:

    scene       the terrain, the cameras, the sun: what every peer draws
    peer        the lines that compare and the peers exchange
    workers     the peers as processes
    vtk_water, vtk_copies, f3d_grid, three_chromium, osg_mirror
                the peers; a new one is a program that speaks peer's lines, added to PEERS
    report      ratios, table, plot, pictures, the text

The figure is a ratio: frame with water / frame of the same program without. All frames of all
programs take turns, in another random order every turn, so that whatever else the machine does
falls on all alike. Within a block the case stays, so that "static" is a frame after equal frames. A
peer that does not run is left out, and the report says why; exit status 1: our own was.
"""

import argparse
import json
import pathlib
import random
import sys
import time

import matplotlib.pyplot as plt
import numpy as np
from report import Report
from scene import SIZE, STEPS, Scene
from workers import PeerFailed, Worker

PROJECT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
FOLDER = PROJECT / "build" / "compare"
CASES = ("moving", "static", "away")
SEED = 20261121
BLOCKS, QUICK_BLOCKS = 12, 3  # of every case
BLOCKS_S, QUICK_BLOCKS_S = 330.0, 75.0  # no third or further block that would end later
TURNS, QUICK_TURNS = 6, 4  # counted, in a block
NO_WATER = 0.01  # mean change of the picture's lower half, where the water is; 1 is white
SETTLING = 2  # frames before them that do not count: of another case, the shaders' first


def python_peer(file, *rest):
    return [sys.executable, HERE / file, FOLDER / "scene.txt", *rest]


PEERS = {
    "vtk-water": python_peer("vtk_water.py"),
    "vtk-copies": python_peer("vtk_copies.py"),
    "f3d": [FOLDER / "venv" / "bin" / "python", HERE / "f3d_grid.py", FOLDER / "scene.txt"],
    "three": python_peer("three_chromium.py", FOLDER),
    "osg": [FOLDER / "osg_mirror", FOLDER / "scene.txt"],
}
OURS = "vtk-water"


class Comparison:
    """The peers that run, by name; left_out: why the others do not; rows: (block, turn, case, peer,
    variant, ms)."""

    def __init__(self, names, left_out):
        self.workers, self.left_out, self.rows = {}, dict(left_out), []
        for name in names:
            if name not in self.left_out:
                self._guarded(name, self._start)

    def _start(self, name):
        self.workers[name] = Worker(name, list(map(str, PEERS[name])), FOLDER / f"{name}.log")
        self.workers[name].wait()
        print(f"{name}: {self.workers[name].program}, {self.workers[name].renderer}", flush=True)

    def _guarded(self, name, do, *arguments):
        """What do returns, or None, and the peer is left out from then on."""
        try:
            return do(name, *arguments)
        except PeerFailed as problem:
            self.left_out[name] = str(problem)
            print(f"{name}: left out: {problem}", flush=True)
            if name in self.workers:
                self.workers.pop(name).end()
            self.rows = [row for row in self.rows if row[3] != name]
            return None

    def _everything(self):
        return [(name, variant) for name, worker in self.workers.items()
                for variant in worker.variants]

    def save_pictures(self, scene, folder):
        folder.mkdir(parents=True, exist_ok=True)
        for name, variant in self._everything():
            if name in self.workers:
                self._guarded(name, self._save_picture, variant, scene.still, folder)

    def _save_picture(self, name, variant, camera, folder):
        file = folder / f"{name}-{variant}.png"
        self.workers[name].picture(variant, camera, file)
        picture = plt.imread(file)[..., :3]
        if picture.shape != (SIZE[1], SIZE[0], 3):
            raise PeerFailed(f"its picture {variant} is of another size")
        without = self.workers[name].variants[0]
        plain = plt.imread(folder / f"{name}-{without}.png")[..., :3]
        change = np.abs(picture - plain)[SIZE[1] // 2:].mean()
        if variant != without and change < NO_WATER:
            raise PeerFailed(f"its picture {variant} shows no water")

    def _turn(self, camera, order):
        """Milliseconds by (peer, variant)."""
        found = {}
        for name, variant in order:
            if name in self.workers:
                took = self._guarded(name, lambda name: self.workers[name].frame(variant, camera))
                if took is not None:
                    found[name, variant] = took
        return found

    def measure(self, scene, blocks, turns, limit_s):
        chance = random.Random(SEED)
        step, begin = 0, time.monotonic()
        for block in range(blocks):
            if block >= 2 and (time.monotonic() - begin) * (block + 1) / block > limit_s:
                print(f"a slow machine: {block} blocks have to do", flush=True)
                break
            for case in chance.sample(CASES, len(CASES)):
                for turn in range(-SETTLING, turns):
                    camera = {"moving": scene.path[step % STEPS], "static": scene.still,
                              "away": scene.away}[case]
                    step += case == "moving"
                    order = self._everything()
                    chance.shuffle(order)
                    found = self._turn(camera, order)
                    if turn >= 0:
                        self.rows += [(block, turn, case, *key, took) for key, took in found.items()
                                      if key[0] in self.workers]
            print(f"block {block + 1} of {blocks}", flush=True)

    def about(self):
        return {name: {"variants": worker.variants, "program": worker.program,
                       "renderer": worker.renderer} for name, worker in self.workers.items()}

    def end(self):
        for worker in self.workers.values():
            worker.end()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="fewer frames, into build/compare")
    parser.add_argument("--only", nargs="+", choices=PEERS, help="only these, into build/compare")
    parser.add_argument("--left-out", type=pathlib.Path, metavar="FILE",
                        help="peers that could not be installed: a JSON object of reasons")
    arguments = parser.parse_args()
    names = [name for name in PEERS if name in (arguments.only or PEERS)]
    left_out = json.loads(arguments.left_out.read_text()) if arguments.left_out else {}

    FOLDER.mkdir(parents=True, exist_ok=True)
    scene = Scene()
    scene.write(FOLDER)
    comparison = Comparison(names, {name: left_out[name] for name in names if name in left_out})
    try:
        comparison.save_pictures(scene, FOLDER / "pictures")
        comparison.measure(scene, QUICK_BLOCKS if arguments.quick else BLOCKS,
                           QUICK_TURNS if arguments.quick else TURNS,
                           QUICK_BLOCKS_S if arguments.quick else BLOCKS_S)
    finally:
        comparison.end()
    is_whole = not arguments.quick and not arguments.only
    report = Report(scene, comparison.about(), comparison.left_out, comparison.rows)
    report.write_data(FOLDER)
    report.write_text(PROJECT / "Documentation" if is_whole else FOLDER, FOLDER / "pictures")
    return 1 if OURS in comparison.left_out else 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: BSD-3-Clause
"""timing: times of frames that take turns, in another random order in every round.

What slows the machine down slows all kinds of frames down. The first frames of each kind do not
count. Several kinds may share a window: after each change some frames settle it, uncounted.
"""

import gc
import os
import time
from dataclasses import dataclass, field

import numpy as np

WARM_UP = 2  # rounds
# A GPU that has been idle raises its clock only after a second or two of frames: an H200's take
# four times as long until then.
WAKE_S = float(os.environ.get("WATER_BENCHMARK_WAKE", 0))
LEAST = 3  # rounds, whatever the budget
TURN_OF_SETTLING = 17  # another place on the path than that of the frame that counts
SEED = 20261121
# Two pipes' ends, "read,write", if another process with another build renders the same frames in turn
# with this one (against.py).
TURNS = [int(end) for end in os.environ.get("WATER_BENCHMARK_TURNS", "").split(",") if end]


@dataclass
class Frame:
    """One kind of frame. before(turn): what is new, untimed; choose(): makes a window its own."""

    name: str
    window: object
    before: object
    choose: object = None
    times: list = field(default_factory=list)  # s
    works: list = field(default_factory=list)  # s that all threads of the processor worked

    def render(self, turn):
        self.before(turn)
        begin, work = time.perf_counter(), time.process_time()
        self.window.Render()
        self.window.WaitForCompletion()
        return time.perf_counter() - begin, time.process_time() - work

    @property
    def median(self):
        """ms"""
        return 1000 * float(np.median(self.times))

    @property
    def work(self):
        """ms, the median"""
        return 1000 * float(np.median(self.works))

    @property
    def quartiles(self):
        """ms"""
        return tuple(1000 * float(share) for share in np.percentile(self.times, (25, 75)))

    @property
    def row(self):
        """For the CSV. What else the machine does lengthens the median, but hardly the fastest."""
        low, high = self.quartiles
        return {
            "median_ms": self.median,
            "q1_ms": low,
            "q3_ms": high,
            "fastest_ms": 1000 * min(self.times),
            "work_ms": self.work,
            "frames": len(self.times),
        }

    def __str__(self):
        low, high = self.quartiles
        digits = 1 if self.median >= 10 else 2  # a GPU's frame takes about one millisecond
        return f"{self.median:.{digits}f} ({low:.{digits}f} to {high:.{digits}f})"


def measure(frames, rounds, budget_s, warm_up=WARM_UP):
    """Renders all kinds, which take turns: so many rounds, fewer when the time is over, at least LEAST."""
    random = np.random.default_rng(SEED)
    order = list(frames)
    gc.collect()
    gc.disable()  # a collection would fall into somebody's frame
    _wake(frames)
    begin = time.perf_counter()
    for turn in range(-warm_up, rounds):
        if turn >= LEAST and not TURNS and time.perf_counter() - begin > budget_s:
            break
        random.shuffle(order)
        for frame in order:
            _wait_for_turn()
            if frame.choose:
                frame.choose()
                frame.render(turn + TURN_OF_SETTLING)
            took, work = frame.render(turn + warm_up)
            _pass_turn()
            if turn >= 0:
                frame.times.append(took)
                frame.works.append(work)
    gc.enable()
    return frames


def _wait_for_turn():
    if TURNS:
        os.read(TURNS[0], 1)  # at once, and nothing, when the other process has ended


def _pass_turn():
    if TURNS:
        try:
            os.write(TURNS[1], b".")
        except BrokenPipeError:
            pass


def _wake(frames):
    begin, turn = time.perf_counter(), 0
    while time.perf_counter() - begin < WAKE_S:
        turn += 1
        for frame in frames:
            if frame.choose:
                frame.choose()
            frame.render(turn)

# SPDX-License-Identifier: BSD-3-Clause
"""gpu_rounds: times of kinds of frames that take turns in one window, in a new random order in every round.

A turn is some frames that settle what the change of the kind upset (queries of hidden water are answered
a frame or two later, shaders are built), and then those that count. Ratios are taken within a round, so
that what slows the machine down for a while slows both down.
"""

import gc
import time
from dataclasses import dataclass, field

import instruments
import numpy as np
from timing import SEED

SETTLING, COUNTED = 3, 4  # frames of a turn
LEAST = 4  # rounds, whatever the budget
COUNTS = ("props", "triangles", "fragments")


@dataclass
class Shot:
    """A kind of frame, what moves in it, and what its water may leave out (None: everything)."""

    kind: str
    motion: str
    skips: int = None
    times: list = field(default_factory=list)  # ms, one a round
    works: list = field(default_factory=list)  # ms that all threads of the processor worked, likewise
    said: dict = field(default_factory=dict)  # gpu_ms, and what the reflection pass says


def _turn(stage, shot, number, draw):
    """Renders the frames of a turn; yields what draw returns for those that count."""
    kind = stage.choose(shot.kind)
    if kind.water:
        reflection = kind.water.GetReflectionPass()
        reflection.SetSkips(reflection.SKIP_ALL if shot.skips is None else shot.skips)
    for i in range(SETTLING + COUNTED):
        kind.step(shot.motion, number * COUNTED + i)
        result = draw(kind)
        if i >= SETTLING:
            yield result


def measure(stage, shots, rounds, budget_s, wake_s):
    """Fills the shots' times."""
    random = np.random.default_rng(SEED)
    order = list(shots)

    def draw(kind):
        begin, work = time.perf_counter(), time.process_time()
        kind.bring()
        stage.window.Render()
        stage.window.WaitForCompletion()
        return 1000 * (time.perf_counter() - begin), 1000 * (time.process_time() - work)

    for shot in order:  # uploads, shaders
        list(_turn(stage, shot, 0, draw))
    gc.collect()
    gc.disable()  # a collection would fall into somebody's frame
    begin = time.perf_counter()
    while time.perf_counter() - begin < wake_s:
        list(_turn(stage, order[0], 0, draw))
    begin = time.perf_counter()
    for number in range(rounds):
        if number >= LEAST and time.perf_counter() - begin > budget_s:
            break
        random.shuffle(order)
        for shot in order:
            took, work = zip(*_turn(stage, shot, number, draw))
            shot.times.append(float(np.median(took)))
            shot.works.append(float(np.median(work)))
    gc.enable()


def ask(stage, shots, clock):
    """Fills in what is said of frames that are not timed: instruments wait for the GPU."""

    def draw(kind):
        kind.bring()
        stage.window.Render()
        stage.window.WaitForCompletion()

    for shot in shots:
        if clock.is_there:
            spans = list(_turn(stage, shot, 0, lambda kind: clock.time(lambda: draw(kind))))
            shot.said["gpu_ms"] = float(np.median(spans))
        water = stage.kind(shot.kind).water
        if not water:
            continue

        def read(kind, water=water):
            draw(kind)
            return instruments.read(water)

        instruments.turn_on(water)
        read_of = list(_turn(stage, shot, 0, read))
        instruments.turn_on(water, False)
        for name in instruments.SAYS:
            values = [said[name] for said in read_of]
            shot.said[name] = values[-1] if name in COUNTS else _median(values)
        shot.said["decision"] = water.GetReflectionPass().GetDecisionAsString()


def _median(values):
    known = [value for value in values if value is not None and value == value]
    return float(np.median(known)) if known else None


def ratios(shot, base):
    """Quartiles of the ratios within the rounds: low, median, high."""
    return tuple(float(value) for value in
                 np.percentile(np.array(shot.times) / np.array(base.times), (25, 50, 75)))

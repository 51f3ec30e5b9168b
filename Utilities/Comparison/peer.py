# SPDX-License-Identifier: BSD-3-Clause
"""peer: how compare.py talks to a peer: lines to its standard input, answers that begin with "> ".

    > {"variants": [...], "program": ..., "renderer": ...}     when it is ready
    frame VARIANT EYE TARGET            six numbers; answer: milliseconds, the drawing finished
    picture VARIANT EYE TARGET FILE     answer: done

serve() is the other end, for peers in Python. The peers in other languages do the same.
"""

import json
import pathlib
import sys
import time


def read_scene(file):
    """scene.txt: numbers, several as a tuple; names of files as they are."""
    scene = {}
    for line in pathlib.Path(file).read_text().splitlines():
        name, rest = line.split(" ", 1)
        if name.startswith("terrain"):
            scene[name] = rest
        else:
            values = tuple(map(float, rest.split()))
            scene[name] = values if len(values) > 1 else values[0]
    scene["size"] = tuple(map(int, scene["size"]))
    return scene


def answer(text):
    print("> " + text, flush=True)


def serve(views, program, renderer):
    """views: by variant, each with render(eye, target), which returns when all is drawn, and
    save(file) of the last frame."""
    answer(json.dumps({"variants": list(views), "program": program, "renderer": renderer}))
    for line in sys.stdin:
        what, name, *rest = line.split()
        view = views[name]
        eye, target = tuple(map(float, rest[:3])), tuple(map(float, rest[3:6]))
        begin = time.perf_counter()
        view.render(eye, target)
        took_ms = 1000.0 * (time.perf_counter() - begin)
        if what == "picture":
            view.save(rest[6])
            answer("done")
        else:
            answer(f"{took_ms:.4f}")

# SPDX-License-Identifier: BSD-3-Clause
"""gpu: what gpu_frames found on a GPU, kept in Documentation/benchmarks-gpu.json, as a section of the report.

The machine that writes the report need not have a GPU. On one that has, with a network or without:

    script/gpu pack                     where there is a network; carry build/gpu/pack.tar.xz along
    script/gpu benchmark --skips        there; copy its benchmarks-gpu.json to Documentation
    python3 Utilities/Benchmarks/gpu.py puts it into Documentation/benchmarks.md, whose other sections stay
"""

import json
import pathlib
import string
import sys

DOCUMENTATION = pathlib.Path(__file__).resolve().parents[2] / "Documentation"
sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "Accuracy"))  # tables

from instruments import text  # noqa: E402  after its path
from tables import table  # noqa: E402

KEPT = DOCUMENTATION / "benchmarks-gpu.json"
TITLE = "On a GPU"
PLAIN, MOVING = "no water", "moving"
MOTIONS = {MOVING: "Camera and time change", "time": "Only the time changes",
           "steps": "Every frame has a new step of a solver's data"}
PHASES = ("work_ms", "gpu_ms", "gather_ms", "plan_ms", "reflection_ms", "surface_ms")

TEXT = """
$note
Measured on $renderer ($window, VTK $vtk, $cpu, $cores cores) by `script/gpu benchmark --skips`
(`Utilities/Benchmarks/gpu_frames.py`), in one window whose kinds of frames take turns in a new random order in every
round. Each turn has three frames to settle, then four that count. Ratios compare medians within a round with the same
scene without water, or with VTK's plain surface of the same data; the quartiles of all rounds are in brackets.

How fast this GPU draws (`Utilities/Benchmarks/gpu_rates.py`): $draws. An H200 draws with 4 of its 132 multiprocessors.
Cards made for graphics draw with all of theirs: the shader of the water then takes a smaller part of a frame.

$scenes

$kinds

$frames

Breakdown of the time with a moving camera, and of a step of data, in ms. "work" is the CPU time of all threads. "GPU"
is the time from a frame's first GPU command to its last, including waits for the next command. Parts of these are
"gather" (reading the scene) and "plan", CPU times, and "reflection" (the mirrored view) and "surface", GPU times. They
were measured in separate frames, which are not part of the tables above.

$phases

$effects
$skips
Limits:

$limits
"""

EFFECTS = """Each effect of the water, on and off in one window, in frames that take turns, over the terrain of the effects' section;
the ratio with its quartiles.

$table
"""

SKIPS = """A frame with all skips / the same frame without one of them, in the same round: below 1 the skip saves time.

$table
"""


def _spread(row):
    return f"{row['ratio']:.2f} ({row['ratio_q1']:.2f} to {row['ratio_q3']:.2f})"


def _unique(values):
    return list(dict.fromkeys(values))


def _frames(rows, motion):
    """Kinds by scenes: ms without water, then ratios."""
    rows = {(row["scene"], row["kind"]): row for row in rows if row["motion"] == motion}
    scenes, kinds = _unique(scene for scene, _ in rows), _unique(kind for _, kind in rows)
    bases = {row.get("base", PLAIN) for row in rows.values()}
    lines = [
        (
            kind + (", ms" if kind in bases else ""),
            *(
                "" if not row else text(row["median_ms"], "{:.2f}") if kind in bases else _spread(row)
                for row in (rows.get((scene, kind)) for scene in scenes)
            ),
        )
        for kind in kinds
    ]
    return table(("kind", *scenes), lines)


def _phases(rows):
    lines = [
        (row["scene"], row["kind"], *(
            "" if row.get(name) is None else text(row[name], "{:.2f}") for name in ("median_ms", *PHASES)))
        for row in rows if row["motion"] in (MOVING, "steps")
    ]
    return table(("scene", "kind", "frame", "work", "GPU", "gather", "plan", "reflection", "surface"), lines)


def _skips(rows):
    if not rows:
        return ""
    names = _unique(row["skip"] for row in rows if row["skip"])
    cells = {}
    for row in rows:
        cells.setdefault((row["scene"], row["motion"], row["kind"]), {})[row["skip"]] = row
    lines = [
        (*key, *(_spread(of[name]) if name in of else "" for name in names)) for key, of in cells.items()
    ]
    return string.Template(SKIPS).substitute(table=table(("scene", "moves", "kind", *names), lines))


def _effects(rows):
    if not rows:
        return ""
    lines = [(row["kind"], f"{row['off_ms']:.2f}", f"{row['median_ms']:.2f}", _spread(row)) for row in rows]
    return string.Template(EFFECTS).substitute(table=table(("effect", "off, ms", "on, ms", "on / off"), lines))


def section():
    """The section's text; None: nothing is kept."""
    kept = json.loads(KEPT.read_text()) if KEPT.is_file() else {}
    if "kinds" not in kept:
        print(f"no {KEPT.name} of gpu_frames: the report is without a GPU")
        return None
    frames = [row for row in kept["rows"] if row["section"] == "frames"]
    motions = [motion for motion in MOTIONS if any(row["motion"] == motion for row in frames)]
    sizes = {row["scene"]: f"{row['width']} x {row['height']}" for row in kept["rows"]}
    return string.Template(TEXT).substitute(
        {"draws": "not measured", **kept["machine"]},
        note="A quick run, of small scenes." if kept["quick"] else kept.get("note", ""),
        scenes=table(("scene", "pixels", ""), [(name, size, kept["scenes"][name]) for name, size in sizes.items()]),
        kinds=table(("kind", ""), kept["kinds"].items()),
        frames="\n\n".join(f"**{MOTIONS[motion]}**\n\n{_frames(frames, motion)}" for motion in motions),
        phases=_phases(frames),
        effects=_effects([row for row in kept["rows"] if row["section"] == "effects"]),
        skips=_skips([row for row in kept["rows"] if row["section"] == "skips"]),
        limits=table(("figure", "value", "limit", ""), [
            tuple(each[name] for name in ("figure", "value", "limit", "verdict")) for each in kept["limits"]]),
    ).strip()


def run(results):
    found = section()
    if found:
        results.add(TITLE, found.replace("$", "$$"))


def main():
    """Puts the section into the page that is there, in place of the one that it had."""
    found, page = section(), DOCUMENTATION / "benchmarks.md"
    if found is None:
        return 1
    before, heading, rest = page.read_text().partition(f"## {TITLE}\n")
    _, next_heading, after = rest.partition("\n## ")
    if not heading:
        before = before.rstrip() + "\n\n"
    page.write_text((f"{before}## {TITLE}\n{found}\n" + (f"{next_heading}{after}" if next_heading else "")).rstrip() + "\n")
    print(page)
    return 0


if __name__ == "__main__":
    sys.exit(main())

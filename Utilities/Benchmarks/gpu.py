# SPDX-License-Identifier: BSD-3-Clause
"""gpu: what an earlier run on a GPU found, kept in Documentation/benchmarks-gpu.json.

The machine that writes the report need not have a GPU. On one that has:

    export WATER_BENCHMARK_WAKE=2 VTK_DEFAULT_OPENGL_WINDOW=vtkEGLRenderWindow
    script/benchmark --only ratios draws bound matrix scaling
    cp build/benchmark/benchmarks.json Documentation/benchmarks-gpu.json
"""

import json
import pathlib

from instruments import text
from report import table

KEPT = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "benchmarks-gpu.json"
SCALES = (1.0, 0.5)
STEPS = ("no water", "calm water", "FIXED_OFFSET", "RAY_TRACED default")
PHASES = ("gather_ms", "plan_ms", "reflection_ms", "surface_ms")

TEXT = """
The same frames, measured earlier on a $renderer ($window, VTK $vtk, $cpu, $cores cores).

$groups

The limits above are on ratios whatever draws the frames; here they came out like this:

$limits

The matrix, the camera moving. Gather and plan are times of the processor; reflection and surface
pass on the GPU between the first command and the last, its waiting for the next command included.
These four are of one frame, all others are medians.

$matrix
"""


def _ms(row, name="median_ms"):
    value = row.get(name)
    return "" if value is None else text(value, "{:.2f}")


def _time(row):
    return f"{_ms(row)} ({_ms(row, 'q1_ms')} to {_ms(row, 'q3_ms')})"


def _groups(rows):
    return table(
        ("group", "frame", "ms", "/ the group's first"),
        [
            (row["scene"], row["step"], _time(row), f"{row['ratio']:.2f}")
            for row in rows
            if row["section"] == "ratios"
        ],
    )


def _matrix(rows):
    return table(
        ("scene", "step", "scale", "ms", "/ no water", *(name[:-3] for name in PHASES)),
        [
            (
                row["scene"],
                row["step"],
                f"{row['scale']:g}" if "scale" in row else "",
                _time(row),
                text(row.get("ratio", 1.0), "{:.2f}"),
                *(_ms(row, name) for name in PHASES),
            )
            for row in rows
            if row["section"] == "matrix"
            and "median_ms" in row
            and row["step"] in STEPS
            and row.get("scale", 1.0) in SCALES
        ],
    )


def run(results):
    if not KEPT.is_file():
        print(f"no {KEPT.name}: the report is without a GPU")
        return
    kept = json.loads(KEPT.read_text())
    results.add(
        "On a GPU",
        TEXT,
        **kept["machine"],
        groups=_groups(kept["rows"]),
        limits=table(
            ("figure", "value", "limit", ""),
            [
                tuple(each[name] for name in ("figure", "value", "limit", "verdict"))
                for each in kept["limits"]
            ],
        ),
        matrix=_matrix(kept["rows"]),
    )

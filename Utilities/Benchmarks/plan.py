# SPDX-License-Identifier: BSD-3-Clause
"""plan: the time that the C core takes to plan a frame, by Google Benchmark (Core/BenchmarkPlan)."""

import os
import re
import subprocess

from report import table

LIMIT_MS = 3.0  # of 100,000 props
PROPS = 100_000

TEXT = """
`water_plan_make` alone, without VTK, on one core: all skips on, random props of which a third are drawn (CPU time,
Google Benchmark).

$tables
"""

ROW = re.compile(r"^Plan/(\w+)/(\d+)\s+[\d.]+ us\s+([\d.]+) us", re.MULTILINE)


def run(results):
    program = os.environ.get("WATER_BENCHMARK_PLAN")
    title = f"plan of {PROPS:,} props, ms"
    if not program:
        results.check_unknown(title, f"<= {LIMIT_MS:g}", "Google Benchmark (libbenchmark-dev) lacks")
        return
    said = subprocess.run([program], capture_output=True, text=True, check=False).stdout
    cells = []
    for water, props, microseconds in ROW.findall(said):
        took = float(microseconds) / 1000
        results.row("plan", water, f"{props} props", median_ms=took)
        cells.append((water, f"{int(props):,}", f"{took:.4f}", f"{1e6 * took / int(props):.0f}"))
        if int(props) == PROPS:
            results.check_at_most(f"{title}, {water}", took, LIMIT_MS, 2)
    results.add(
        "The plan", TEXT, tables=table(("water", "props", "plan, ms", "ns a prop"), cells)
    )

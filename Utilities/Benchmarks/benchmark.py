# SPDX-License-Identifier: BSD-3-Clause
"""benchmark: measures what the water costs, against the error that is left, and writes a report.

    script/benchmark                      everything, into Documentation/benchmarks.md, its images
    script/benchmark --quick              less of everything in two minutes, into build/benchmark
    script/benchmark --only ratios [...]  some sections, into build/benchmark

How it is put together:

    geometry, scenes   what is drawn, and from where
    kinds              lookups, quality steps, texture scales
    timing             frames that take turns; medians and quartiles
    errors             the truth, by the tracer of Utilities/Accuracy
    instruments        what the reflection pass says about its last frame
    results            CSV, JSON, and the report, which is that of Utilities/Accuracy
    plots              the pictures
    plan, props, matrix, scaling, sea, data, ratios, effects, draws, bound, first_frame, gpu
                       the sections. Each has run(results) and its own prose; a new one is a module
                       with the same, added to SECTIONS

Exit status 1: a limit was exceeded. The report is written all the same.
"""

import argparse
import importlib
import pathlib
import sys
import time

PROJECT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(PROJECT / "Utilities" / "Accuracy"))  # tracer, reference, formulas, report
sys.path.append(str(PROJECT / "Testing" / "Python"))  # scenes of the tests, ray_caster

SECTIONS = ("plan", "props", "ratios", "effects", "draws", "bound", "matrix", "scaling", "sea", "data", "first_frame",
            "gpu")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "--only", nargs="+", choices=SECTIONS, help="only these sections, into build/benchmark"
    )
    parser.add_argument(
        "--quick", action="store_true", help="under two minutes, into build/benchmark"
    )
    parser.add_argument("--folder", type=pathlib.Path, help="what is written goes here")
    arguments = parser.parse_args()

    from results import (
        Results,
    )  # VTK and the plots take seconds to load; a wrong argument should not

    is_all = not arguments.only and not arguments.quick
    folder = arguments.folder or PROJECT / ("Documentation" if is_all else "build/benchmark")
    results = Results(folder, arguments.quick)
    print(*(f"{name}: {value}" for name, value in results.machine.items()), sep="\n", flush=True)
    for section in arguments.only or SECTIONS:
        begin = time.perf_counter()
        importlib.import_module(section).run(results)
        print(f"{section}: {time.perf_counter() - begin:.0f} s", flush=True)
    results.write()
    return 1 if results.has_failed() else 0


if __name__ == "__main__":
    sys.exit(main())

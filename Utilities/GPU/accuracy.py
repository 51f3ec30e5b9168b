# SPDX-License-Identifier: BSD-3-Clause
"""accuracy: the accuracy suite (Utilities/Accuracy) on a machine with a GPU, and nothing but what the pack has.

    script/gpu accuracy

Its sections are those that compare pictures and places with a ray tracer: times have a benchmark of their
own. Plots are left out: matplotlib is not in the pack. Into $OUT: accuracy.md. Exit status 1: a limit was
not met.
"""

import importlib
import os
import pathlib
import sys
from unittest.mock import MagicMock

import numpy as np

PROJECT = pathlib.Path(__file__).resolve().parents[2]
SECTIONS = ("lookup", "colour", "confidence")


def subplots(rows=1, columns=1, **_):
    axes = np.empty((rows, columns), dtype=object)
    for place in np.ndindex(axes.shape):
        axes[place] = MagicMock(**{"get_legend_handles_labels.return_value": ([], [])})
    return MagicMock(), axes.squeeze()


def main():
    sys.path[:0] = [str(PROJECT / "Utilities" / "Accuracy"), str(PROJECT / "Testing" / "Python")]
    plots = MagicMock(subplots=subplots)
    sys.modules.update({"matplotlib": MagicMock(pyplot=plots), "matplotlib.pyplot": plots})
    from report import Report

    report = Report(pathlib.Path(os.environ.get("OUT") or PROJECT / "build" / "gpu" / "out"))
    for section in SECTIONS:
        importlib.import_module(section).run(report)
    report.write()
    return 1 if report.has_failed() else 0


if __name__ == "__main__":
    sys.exit(main())

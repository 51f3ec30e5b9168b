# SPDX-License-Identifier: BSD-3-Clause
"""results: what the sections find: the report's figures with limits, and rows for CSV and JSON."""

import csv
import json
import pathlib

import machine
from report import Report, table

TEMPLATE = pathlib.Path(__file__).parent / "benchmarks.md.in"
UNKNOWN = "n/a"


class Results(Report):
    """is_quick: fewer frames, fewer steps, smaller pictures."""

    def __init__(self, folder, is_quick):
        super().__init__(folder, TEMPLATE)
        self.is_quick = is_quick
        self.machine = machine.describe()
        self._rows = []

    def rounds(self, full, quick):
        return quick if self.is_quick else full

    def row(self, section, scene, step, **values):
        """A line of the CSV."""
        self._rows.append({"section": section, "scene": scene, "step": step, **values})

    def check_unknown(self, name, limit, why):
        """A figure that this module does not know yet: it fails nothing."""
        self._checks.append((name, UNKNOWN, limit, why))
        print(f"{name}: {UNKNOWN} (limit {limit}) {why}", flush=True)

    def write(self):
        columns = list(dict.fromkeys(name for row in self._rows for name in row))
        with open(self._folder / "benchmarks.csv", "w", newline="") as file:
            writer = csv.DictWriter(file, columns, restval="", lineterminator="\n")
            writer.writeheader()
            writer.writerows(
                {name: _short(value) for name, value in row.items()} for row in self._rows
            )
        checks = [dict(zip(("figure", "value", "limit", "verdict"), each)) for each in self._checks]
        (self._folder / "benchmarks.json").write_text(
            json.dumps(
                {
                    "machine": self.machine,
                    "quick": self.is_quick,
                    "limits": checks,
                    "rows": self._rows,
                },
                indent=1,
                default=float,
            )
            + "\n"
        )
        names = ("cpu", "cores", "renderer", "window", "vtk", "python", "system", "load")
        super().write(
            machine=table(("", ""), [(name, str(self.machine[name])) for name in names]),
            how="`--quick`: few frames, a small mesh, some of the steps. " if self.is_quick else "",
        )


def _short(value):
    if value is None or value != value:
        return UNKNOWN
    return f"{value:.6g}" if isinstance(value, float) else value

#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""report: Documentation/stability.md and its images, from the tables of water_core_stress.

  report.py FOLDER SCENES SEED
"""
import collections
import pathlib
import re
import string
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt  # noqa: E402

PROJECT = pathlib.Path(__file__).resolve().parents[2]
IMAGES = PROJECT / "Documentation/images"
HERE = pathlib.Path(__file__).resolve().parent
U = 2.0**-53
FIRST_DECADE = -20  # STRESS_FIRST_DECADE of record.h

# The plots: what a reader asks for, and the properties that answer it, with the bound as a function
# of the condition where it is one.
PICTURES = (
    ("stability-pixel", "How far a point of the water is off its own pixel",
     ("a point of the water on its own pixel", "the same by the texture matrix")),
    ("stability-mirror", "The mirrored camera",
     ("mirrored twice, matrix", "mirrored twice, camera",
      "determinant of the mirrored view - 1", "a point of the water in mirrored view space")),
    ("stability-clip", "The clip at the water, in shares of its bound",
     ("height over the clip in mirrored view space", "height over the clip in clip space")),
    ("stability-fresnel", "Fresnel's reflectance",
     ("reflectance", "reflectance falls with the cosine")),
)

Property = collections.namedtuple("Property", "condition unit bins")  # bins: decade -> 3 numbers


def read(folder):
    """Property by name, all parts together; a bin is [count, largest error, largest ratio]."""
    found = {}
    for path in folder.glob("part-*.tsv"):
        for line in path.read_text().splitlines():
            name, condition, unit, decade, count, error, ratio = line.split("\t")
            bins = found.setdefault(name, Property(condition, unit, {})).bins
            entry = bins.setdefault(int(decade), [0, 0.0, 0.0])
            entry[0] += int(count)
            entry[1] = max(entry[1], float(error))
            entry[2] = max(entry[2], float(ratio))
    return found


def failures(folder):
    """Number of failures that the logs tell; a part without its line counts as one."""
    total = 0
    for path in folder.glob("part-*.log"):
        match = re.search(r"^(\d+) failures$", path.read_text(), re.M)
        total += int(match.group(1)) if match else 1
    return total


def number(value):
    """A number for the tables: short, and without a sign of the exponent that nobody reads."""
    return "0" if value == 0.0 else f"{value:.2g}"


def plot(name, title, properties, found):
    """Largest error, and largest share of the bound, in each decade of the condition."""
    figure, (errors, ratios) = plt.subplots(1, 2, figsize=(10, 4.2), layout="constrained")
    conditions = {}
    for text in properties:
        # the first bin holds conditions of 0, which have no place on a logarithmic axis
        bins = [each for each in sorted(found[text].bins.items()) if each[0] > FIRST_DECADE]
        conditions.setdefault(found[text].condition, len(conditions))
        decades = [10.0**(decade + 0.5) for decade, _ in bins]
        errors.plot(decades, [max(entry[1], 1e-17) for _, entry in bins], "o-", ms=3, label=text)
        ratios.plot(decades, [max(entry[2], 1e-6) for _, entry in bins], "o-", ms=3, label=text)
    for axes in (errors, ratios):
        axes.set_xscale("log")
        axes.set_xlabel("condition: " + "; ".join(conditions), fontsize=8)
        axes.grid(alpha=0.3)
    errors.set_yscale("log")
    errors.set_ylabel("largest error (units: see the table)")
    errors.axhline(U, color="grey", ls=":", lw=1)
    errors.text(0.01, U * 1.2, "u", color="grey", transform=errors.get_yaxis_transform())
    ratios.set_ylim(0.0, 1.05)
    ratios.axhline(1.0, color="black", lw=1)
    ratios.set_ylabel("largest error / bound")
    errors.legend(fontsize=7)
    figure.suptitle(title)
    figure.savefig(IMAGES / f"{name}.png", dpi=100)
    plt.close(figure)


def summary(found):
    """The table of all properties."""
    lines = ["| property | cases | largest error | unit | error / bound |", "|---|---|---|---|---|"]
    for name, each in found.items():
        entries = each.bins.values()
        lines.append(f"| {name} | {sum(entry[0] for entry in entries):,} | "
                     f"{number(max(entry[1] for entry in entries))} | {each.unit} | "
                     f"{number(max(entry[2] for entry in entries))} |")
    return "\n".join(lines)


def by_condition(name, found):
    """The table of one property: a row for every two decades of its condition."""
    each = found[name]
    rows = collections.OrderedDict()
    for decade, entry in sorted(each.bins.items()):
        row = rows.setdefault(decade // 2 * 2, [0, 0.0, 0.0])
        row[0] += entry[0]
        row[1] = max(row[1], entry[1])
        row[2] = max(row[2], entry[2])
    lines = [f"| {each.condition} | cases | largest error, {each.unit} | error / bound |",
             "|---|---|---|---|"]
    for decade, (count, error, ratio) in rows.items():
        lines.append(f"| 1e{decade} to 1e{decade + 2} | {count:,} | {number(error)} | "
                     f"{number(ratio)} |")
    return "\n".join(lines)


def main():
    folder, scenes, seed = pathlib.Path(sys.argv[1]), int(sys.argv[2]), sys.argv[3]
    found = read(folder)
    order = re.findall(r'X\(\w+,\s*"([^"]*)"',
                       (PROJECT / "Testing/Core/Stability/record.h").read_text())
    found = {name: found[name] for name in order if name in found}
    for name, title, properties in PICTURES:
        plot(name, title, properties, found)
    cases = sum(entry[0] for each in found.values() for entry in each.bins.values())
    failed = failures(folder)
    text = string.Template((HERE / "stability.md.in").read_text()).substitute(
        scenes=f"{scenes:,}", cases=f"{cases:,}", seed=seed, failures=failed,
        summary=summary(found),
        pixel=by_condition("a point of the water on its own pixel", found),
        fresnel=by_condition("reflectance", found))
    (PROJECT / "Documentation/stability.md").write_text(text)
    print(f"{scenes} scenes, {cases} cases, {failed} failures: Documentation/stability.md")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

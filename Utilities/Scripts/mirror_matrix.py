#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes Documentation/mirror-matrix.md from the results of the tests with the label matrix in build trees.

usage: mirror_matrix.py [--out FILE] FOLDER...     e.g. mirror_matrix.py build/system build/wheel
"""

import argparse
import json
import pathlib
import sys
import textwrap

ROWS = ("Surfaces", "Props", "Labels", "Blending", "Light", "View", "Window", "Passes", "Background", "Waters",
        "WaterInWater", "SecondaryReflections", "BadInput", "PropClasses", "MapperClasses", "WidgetClasses", "PassClasses")
PLACES = ("Testing/Temporary*/", "")  # in a build tree, or a folder that is a test's own
ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "Documentation" / "mirror-matrix.md"
CLASSES = ROOT / "Testing" / "Python" / "Matrix" / "class_cells.tsv"
HEAD = """# Reflection conformance

*Written by `script/matrix`; every number in it is measured. To change the text, edit `Testing/Python/Matrix`
or `Utilities/Scripts/mirror_matrix.py`.*

This page lists which of VTK's props, lights, views, windows, passes and backgrounds are reflected exactly. Each cell is
rendered twice. The first picture shows the scene through calm water of reflectance 1. The second, the truth, uses no
code of this project: VTK's own camera, mirrored, renders the scene, cut at the water by VTK's clipping planes, with the
lights where the user's camera puts them. An ordinary sheet in place of the water shows this picture pixel by pixel,
flipped left to right, so that VTK composes what lies in front of, above and behind it. If a cell uses another truth,
its test states it (`Testing/Python/Matrix`).

The figures are the share of the water's pixels that differ by more than 1/255, and the RMSE (of 255) over all of the
water's pixels. In an exact cell, at most 0.05 % of these pixels differ. For every other cell, the last column gives
the reason. Its RMSE is then at most 1, unless the reason begins with *Wrong*, which means that the reflection is known
to be wrong. In every cell that is not *Wrong*, the pixels beside
the water equal, within 1/255, those of the scene without the water; those of the scene with an ordinary sheet, if any
sheet changes them (shadow maps, hidden line removal); or those of the composed picture (the one with the sheet), if a
filter mixes them with the water. *Without it* is the same share for a picture that lacks the feature under test; if it
were 0, the cell could not fail. With two windows (OSMesa and EGL), the worse figure is given. Some cells test a
statement instead of comparing pictures; for them the table shows *true* or *false*. Pairs of pictures are kept in the build tree, under `Testing/Temporary*/mirror-matrix`.
"""


def read(folders):
    """{test: (row, {cell: {version: [results]}})} and the versions, in their order."""
    tests, versions = {}, []
    for folder in folders:
        found = [path for pattern in PLACES for path in pathlib.Path(folder).glob(f"{pattern}mirror-matrix/*/*/cells.json")]
        for path in sorted(found):
            result = json.loads(path.read_text())
            version = result["vtk"]
            if version not in versions:
                versions.append(version)
            _, cells = tests.setdefault(path.parent.name, (result["row"], {}))
            for cell in result["cells"]:
                cells.setdefault(cell["cell"], {}).setdefault(version, []).append(cell)
    return tests, versions


def figure(results):
    """The worst result of one version."""
    if not results:
        return "-"
    if "percent" in results[0]:
        worst = max(results, key=lambda result: (result["percent"], result["rmse"]))
        return f"{worst['percent']:.3g} %, {worst['rmse']:.2g}"
    if results[0]["holds"] is None:
        return "left out"
    return "true" if all(result["holds"] for result in results) else "**false**"


def why(by_version, versions):
    """The reason, with its version where the others have none."""
    reasons = {version: {result["reason"] for result in by_version.get(version, [])} - {None} for version in versions}
    texts = {text for some in reasons.values() for text in some}
    if len(texts) == 1 and not all(reasons.values()):
        names = [version for version in versions if reasons[version]]
        return f"{' and '.join(names)}: {texts.pop()}"
    return " ".join(sorted(texts))


def classes_without():
    """The section on classes of VTK without a cell."""
    rows = [line.split("\t") for line in CLASSES.read_text().splitlines() if not line.startswith("#")]
    kinds = [row[2] for row in rows]
    names = {kind: [row[0] for row in rows if row[2] == kind] for kind in kinds}
    text = (f"VTK has {len(rows)} concrete props, mappers and passes; `Testing/Python/Matrix/{CLASSES.name}` names the "
            f"cells of {kinds.count('cell')}. {kinds.count('made by')} others are created by the `New()` of one of "
            "these. "
            f"{kinds.count('overlay')} are 2D overlays, drawn over the finished picture: "
            f"{', '.join(names['overlay'])}. The remaining ones have no cell, for these reasons:")
    lines = ["## Classes of VTK without a cell", "", *textwrap.wrap(text, 120), "", "| class | VTK | reason |",
             "|---|---|---|"]
    return lines + [f"| {name} | {versions.replace(' ', ', ')} | {text} |" for name, versions, kind, text in rows
                    if kind == "none"]


def main(folders, page):
    tests, versions = read(folders)
    missing = [name for name in ROWS if f"TestMatrix{name}" not in tests]
    if missing or not versions:
        sys.exit(f"mirror_matrix: no results of {', '.join(missing)}: run ctest -L matrix first")
    lines = [HEAD]
    total = exact = 0
    for name in ROWS:
        row, cells = tests[f"TestMatrix{name}"]
        lines += [f"## {row}", "", "| cell | without it | " + " | ".join(f"VTK {v}" for v in versions) + " | why |",
                  "|---" * (3 + len(versions)) + "|"]
        for cell, by_version in cells.items():
            results = [result for some in by_version.values() for result in some]
            controls = [result["control"] for result in results if result.get("control") is not None]
            control = f"{min(controls):.2g} %" if controls else ""
            figures = [figure(by_version.get(version, [])) for version in versions]
            lines.append(f"| {cell} | {control} | {' | '.join(figures)} | {why(by_version, versions)} |")
            total += 1
            exact += all(result.get("percent", 0) <= 0.05 and result.get("holds", True) for result in results)
        lines.append("")
    lines += classes_without()
    lines.insert(1, f"**{total} cells, {exact} of them within 0.05 % or true on every VTK.**\n")
    page.write_text("\n".join(lines).rstrip() + "\n")
    print(f"mirror_matrix: {page.name}: {total} cells, {exact} exact or true on every VTK")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="+", help="build trees, or folders that tests wrote into")
    parser.add_argument("--out", type=pathlib.Path, default=PAGE, help="the page to write")
    arguments = parser.parse_args()
    main(arguments.folders, arguments.out)

#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes Documentation/mirror-matrix.md out of what the tests with the label matrix left in build trees.

usage: mirror_matrix.py [--out FILE] FOLDER...     e.g. mirror_matrix.py build/system build/wheel
"""

import argparse
import json
import pathlib
import sys

ROWS = ("Surfaces", "Props", "Labels", "Blending", "Light", "View", "Window", "Passes", "Background", "Waters",
        "WaterInWater", "BadInput", "PropClasses", "MapperClasses", "WidgetClasses", "PassClasses")
PLACES = ("Testing/Temporary*/", "")  # in a build tree, or a folder that is a test's own
ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "Documentation" / "mirror-matrix.md"
CLASSES = ROOT / "Testing" / "Python" / "Matrix" / "class_cells.tsv"
HEAD = """# What stands right in the water

*Written by `script/matrix`; every number in it is measured. To change the words, change `Testing/Python/Matrix`.*

Each cell is rendered twice: through calm water of reflectance 1, and without any of this project's code: VTK's own
camera, mirrored, looks at the scene, which VTK's clipping planes cut at the water, under the lights that the user's
camera has placed; an ordinary sheet in the water's place shows that picture, turned left to right, pixel by pixel, so that VTK
composes what lies before, over and behind it. Other truths are named in the cell's test (`Testing/Python/Matrix`).

The figures are the share of the water's pixels that differ by more than 1/255, and the RMSE of 255 over them. At most 0.05 %
may differ, or the last column says why, and then the RMSE is at most 1; where it begins with *Wrong*, the reflection is known to be wrong. In every other cell no other pixel differs from the scene
without the water by more than 1/255, or from the composed picture, where a filter mixes them with the water. *Without it* is the same share for a picture that lacks what the cell is about:
a cell that could not fail would have 0 there. The worse one of two windows stands where there are two (OSMesa and EGL).
Statements are true or false. Pairs of pictures stay in the build tree, under `Testing/Temporary*/mirror-matrix`.
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
    """The section on classes of VTK that no cell draws."""
    rows = [line.split("\t") for line in CLASSES.read_text().splitlines() if not line.startswith("#")]
    kinds = [row[2] for row in rows]
    names = {kind: [row[0] for row in rows if row[2] == kind] for kind in kinds}
    lines = ["## Classes of VTK without a cell", "",
             f"VTK has {len(rows)} props, mappers and passes that can be made; `Testing/Python/Matrix/{CLASSES.name}` names the "
             f"cells of {kinds.count('cell')}. {kinds.count('made by')} more are what the `New()` of one of these makes, and "
             f"{kinds.count('overlay')} are 2D by their class, which is drawn over the finished picture: "
             f"{', '.join(names['overlay'])}. The others:", "", "| class | VTK | why it has no cell |", "|---|---|---|"]
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

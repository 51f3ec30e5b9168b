# SPDX-License-Identifier: BSD-3-Clause
"""figures: one table of the target figures, with their limits, in Documentation/accuracy.md.

    PYTHONPATH=<folder of vtkwater> python Utilities/Accuracy/figures.py --scenes DIR... --refraction DIR
        [--reference 9000:9008] [--meshes SEED] [--to FILE]

DIR is a folder that random_scenes.py or random_refraction.py has written. With --reference, scenes of these seeds
are drawn in quality "reference"; with --meshes, users' meshes are compared with mirrored scenes
(Testing/Python/TestWaterUsersMeshes).
The figures of the lookup are those that script/accuracy has written in FILE (default: Documentation/accuracy.md).
The table replaces what is between the two marks in FILE; script/accuracy keeps it.
"""

import argparse
import json
import os
import pathlib
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "Testing" / "Python"))

import numpy as np  # noqa: E402
from tables import put_figures, table  # noqa: E402

FRAMES = 64
MOST_REFERENCE = 1.5  # RMSE of 255
MOST_REFRACTION = 4.0  # RMSE of 255
MOST_MESHES = 0.02  # % of the pixels
DISTANCES = (0, 1e3, 1e4, 1e5, 1e6)  # from the origin; the test has some of them
LOOKUPS = ("slope 0.05, ray traced, default: median error, px",
           "slope 0.05, ray traced, default: 95 % of pixels within, px")


def row_of(name, value, limit, digits=2):
    return name, f"{value:.{digits}f}", f"<= {limit:g}", "ok" if value <= limit else "NOT MET"


def of_lookup(text):
    """The rows of the lookup in a report. A table of figures that is there already may have old ones: the last counts."""
    lines = [line for line in text.splitlines() if line.startswith("| ")]
    rows = [tuple(cell.strip() for cell in line.strip("|").split("|")) for line in lines]
    return list({row[0]: row for row in rows if row[0] in LOOKUPS}.values())


def of_scenes(rows):
    from random_scenes import LIMITS

    found = []
    name = f"reflection, {len(rows)} scenes (seeds {rows[0]['seed']} to {rows[-1]['seed']})"
    for quality, (middle, most) in LIMITS.items():
        for measure in ("RMSE", "FLIP"):
            ratios = [row[f"{measure} ratio {quality}"] for row in rows]
            what = f"{name}, {quality}: {measure} / one perfect ray's"
            found.append(row_of(f"{what}, median", np.median(ratios), middle))
            found.append(row_of(f"{what}, 95 % of scenes within", np.percentile(ratios, 95), most))
        background = sum(row.get(f"background {quality}", 0) for row in rows)
        found.append(row_of(f"{name}, {quality}: pixels that show a hidden background", background, 0, 0))
    return found


def of_refraction(rows):
    name = f"refraction, {len(rows)} scenes (seeds {rows[0]['seed']} to {rows[-1]['seed']})"
    pixels = np.array([row["water"] for row in rows])
    errors = np.array([row["RMSE"] for row in rows])
    strange = 100 * sum(row["strange"] for row in rows) / pixels.sum()
    return [row_of(f"{name}: % of pixels with a colour that the truth does not have nearby", strange, 0),
            row_of(f"{name}: RMSE, all pixels together", np.sqrt(np.average(errors**2, weights=pixels)),
                   MOST_REFRACTION),
            row_of(f"{name}: RMSE, median of the scenes", np.median(errors), MOST_REFRACTION),
            row_of(f"{name}: RMSE, worst scene", errors.max(), MOST_REFRACTION)]


def of_reference(seeds):
    import scene_generator
    import water_test as wt
    from random_scenes import SAMPLES, Truth
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkwater import vtkWaterFrameAverage

    errors = []
    for seed in seeds:
        scene = scene_generator.make(seed)
        truth = Truth(scene, SAMPLES)
        mask = truth.mask & wt.water_mask(scene.made, scene.water)
        scene.water.GetWaterProperty().SetRayTraceQualityToReference()
        average = vtkWaterFrameAverage()
        average.SetRenderWindow(scene.made.window)
        average.SetNumberOfFrames(FRAMES)
        average.Update()
        picture = vtk_to_numpy(average.GetOutput().GetPointData().GetScalars()).reshape(truth.picture.shape)
        errors.append(float(np.sqrt(((picture - truth.picture)[mask] ** 2).mean())))
        print(f"reference, seed {seed}: RMSE of 255 {errors[-1]:.2f}", flush=True)
    name = f"reference, {len(errors)} scenes (seeds {seeds[0]} to {seeds[-1]}), {FRAMES} frames: RMSE"
    return [row_of(f"{name}, median", np.median(errors), MOST_REFERENCE),
            row_of(f"{name}, worst", max(errors), MOST_REFERENCE)]


def of_meshes(seed):
    os.environ["WATER_MESHES_SEED"] = str(seed)
    import TestWaterUsersMeshes as meshes

    found = []
    for distance in DISTANCES:
        tally = meshes.Tally()
        truth, scenes = meshes.flat_scenes(0, distance)
        for name, scene in scenes:
            picture, mask = scene.seen()
            tally.add(name, np.abs(picture - truth).max(axis=2)[mask])
        found.append(row_of(f"calm, users' meshes (seed {seed}), {distance:g} from the origin: % of pixels off by more "
                            "than 1/255", 100 * tally.off / max(1, tally.pixels), MOST_MESHES, 3))
        print(*found[-1], flush=True)
    return found


def seeds_of(text):
    first, _, end = text.partition(":")
    return range(int(first), int(end) if end else int(first) + 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scenes", type=pathlib.Path, nargs="+", required=True, help="folders of random_scenes.py")
    parser.add_argument("--refraction", type=pathlib.Path, required=True, help="folder of random_refraction.py")
    parser.add_argument("--reference", type=seeds_of, help="FIRST:END, the end not included, or one seed")
    parser.add_argument("--meshes", type=int, metavar="SEED", help="of the users' meshes")
    parser.add_argument("--to", type=pathlib.Path, default=PROJECT / "Documentation" / "accuracy.md")
    arguments = parser.parse_args()
    rows = of_lookup(arguments.to.read_text())
    rows += of_scenes([row for folder in arguments.scenes for row in json.loads((folder / "scenes.json").read_text())])
    rows += of_reference(arguments.reference) if arguments.reference else []
    rows += of_meshes(arguments.meshes) if arguments.meshes is not None else []
    rows += of_refraction(json.loads((arguments.refraction / "refraction.json").read_text()))
    text = table(("target figure", "value", "limit", ""), rows)
    put_figures(arguments.to, text)
    print(text)


if __name__ == "__main__":
    main()

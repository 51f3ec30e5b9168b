# SPDX-License-Identifier: BSD-3-Clause
"""random_refraction: random scenes seen through water, drawn by the module and by the tracer; the section "refraction".

    PYTHONPATH=<folder of vtkwater> python Utilities/Accuracy/random_refraction.py --seeds 0:50 --folder DIR
        [--samples 16] [--worst 10] [--own-view] [--own-views FACTOR...]

--own-view also draws each scene with the module's own view of what lies below (SetRefractionSourceToOwnView).
--own-views measures what such a view of any width would bring: the module draws a picture FACTOR times as wide and
high, without all that is over the water's plane, and its middle is compared.

Prints a line for each scene, writes DIR/refraction.json and the worst scenes as pictures: the truth, the module, their
difference, and strange pixels in white over why the picture may lack what is right (refraction_truth.REASONS).
Exit status 1: a limit was not met.

A pixel is strange when its colour is none that the truth has within a few pixels: blocks, notches and hard edges are.
"""

import argparse
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Testing" / "Python"))

import numpy as np  # noqa: E402
import refraction_generator  # noqa: E402
import refraction_truth  # noqa: E402
import water_test as wt  # noqa: E402
from refraction_truth import REASONS  # noqa: E402
from report import Report, table  # noqa: E402
from tracer import Tracer  # noqa: E402

SIZE = (400, 300)
SEEDS = range(50)  # of the report
SAMPLES = 16  # rays a pixel
MOST_RMSE = 4.0  # of 255
SHOWN = 3  # scenes in the report
SEEN = "refracted rays whose correct colour is in the picture"
MOST_STRANGE = 0.2  # % of the pixels for which the picture has what is right
TEXT = """
$count scenes of clear water over a bed, with objects standing in it, lying under it, floating, or hanging over it,
with and without waves ($seeds); $width x $height pixels, $samples rays per pixel in the truth. A pixel is strange if
the truth does not contain its colour within a few pixels. Sometimes the picture without water does not contain
what a refracted ray meets:

$summary

$pictures

*The truth and the module; below, their difference, and where the correct colour is: seen (green), hidden by what is
over the water (red), hidden under the water (yellow), out of the picture (blue). Strange pixels are white.*
"""
REASON_COLORS = ((60, 110, 60), (150, 50, 40), (190, 150, 40), (60, 70, 150))
STRANGE_COLOR = (255, 255, 255)


class Result:
    def __init__(self, seed, samples, own_views=(), has_own_view=False):
        scene = refraction_generator.make(seed, SIZE)
        look = scene.water.GetWaterProperty()
        look.RefractionOff()
        mask = wt.water_mask(scene.made, scene.water)
        look.RefractionOn()
        self.picture = scene.made.picture()
        self.of_own_view = None
        truth = self.truth = refraction_truth.Truth(scene, Tracer(scene.made.renderer, scene.origin), SIZE, samples)
        mask = truth.mask = truth.mask & mask
        self.strange = truth.is_strange(self.picture)
        self.row = {"seed": seed, **scene.facts, "water": int(mask.sum()), "RMSE": self._rmse(self.picture),
                    "RMSE perfect": self._rmse(truth.once), "strange": int(self.strange.sum()),
                    "strange perfect": int(truth.is_strange(truth.once).sum())}
        self._measure_reasons(self.row, self.picture)
        if has_own_view:
            look.SetRefractionSourceToOwnView()
            self.of_own_view = scene.made.picture()
            look.SetRefractionSourceToPicture()
            self.row["own view"] = self._row_of(self.of_own_view)
        for factor in own_views:
            _show_own_view(scene, factor)
            self.row[f"own view {factor}"] = self._row_of(_middle_of(scene.made.picture(), SIZE))

    def _row_of(self, picture):
        row = {"RMSE": self._rmse(picture), "strange": int(self.truth.is_strange(picture).sum()),
               **{name: self.row[name] for name in ("water", "RMSE perfect", "strange perfect")}}
        self._measure_reasons(row, picture)
        return row

    def _measure_reasons(self, row, picture):
        """Figures of a picture, by what the picture without water has of refracted rays."""
        squared = ((picture - self.truth.picture) ** 2).mean(axis=2)
        strange = self.truth.is_strange(picture)
        for number, reason in enumerate(REASONS):
            chosen = self.truth.mask & (self.truth.reasons == number)
            row[f"pixels {reason}"] = int(chosen.sum())
            row[f"strange {reason}"] = int((strange & chosen).sum())
            row[f"RMSE {reason}"] = float(np.sqrt(squared[chosen].mean())) if chosen.any() else 0.0

    def _rmse(self, picture):
        return float(np.sqrt(((picture - self.truth.picture)[self.truth.mask] ** 2).mean()))

    def line(self):
        row = self.row
        return (f"seed {row['seed']}: RMSE of 255 {row['RMSE']:.2f} (one ray {row['RMSE perfect']:.2f}), strange "
                f"{row['strange']} of {row['water']} pixels; " + "; ".join(
                    f"{reason}: {row[f'pixels {reason}']} pixels, {row[f'strange {reason}']} strange, "
                    f"RMSE {row[f'RMSE {reason}']:.1f}" for reason in REASONS if row[f"pixels {reason}"]))

    def panels(self):
        truth, mask = self.truth, self.truth.mask
        why = np.full((*mask.shape, 3), 30)
        for number, color in enumerate(REASON_COLORS):
            why[mask & (truth.reasons == number)] = color
        why[self.strange] = STRANGE_COLOR
        apart = np.abs(self.picture - truth.picture) * mask[..., None]
        upper = np.concatenate([truth.picture, self.picture], axis=1)
        rows = [np.concatenate([apart, why], axis=1), upper]
        if self.of_own_view is not None:
            rows[0:0] = [np.concatenate([np.abs(self.of_own_view - truth.picture) * mask[..., None],
                                         self.of_own_view], axis=1)]
        return np.concatenate(rows).clip(0, 255)


def _show_own_view(scene, factor):
    """Makes the window and the camera's frustum so many times SIZE, and cuts all that is over the water's plane off.

    The pixels of the middle are those of the picture.
    """
    camera = scene.made.renderer.GetActiveCamera()
    if not hasattr(scene, "center"):
        scene.center, scene.angle = camera.GetWindowCenter(), camera.GetViewAngle()
        scene.scale = camera.GetParallelScale()
        for actor in scene.made.renderer.GetActors():
            if not actor.IsA("vtkWaterActor"):
                actor.GetMapper().AddClippingPlane(wt.plane(scene.origin, (0, 0, -1)))
    scene.made.window.SetSize(*(factor * length for length in SIZE))
    camera.SetWindowCenter(*(each / factor for each in scene.center))
    camera.SetViewAngle(np.degrees(2 * np.arctan(factor * np.tan(np.radians(scene.angle) / 2))))
    camera.SetParallelScale(factor * scene.scale)


def _middle_of(picture, size):
    top, left = ((whole - part) // 2 for whole, part in zip(picture.shape, size[::-1]))
    return picture[top:top + size[1], left:left + size[0]]


def measure(seeds, samples=SAMPLES, own_views=(), has_own_view=False):
    rows, pictures = [], []
    for seed in seeds:
        result = Result(seed, samples, own_views, has_own_view)
        print(result.line(), flush=True)
        rows.append(result.row)
        pictures.append(result.panels().astype(np.uint8))
    return rows, pictures


def _judge(report, rows):
    pixels = sum(row["pixels seen"] for row in rows)
    error = sum(row["pixels seen"] * row["RMSE seen"] ** 2 for row in rows)
    report.check_at_most(f"{SEEN}: % of strange pixels", 100 * sum(row["strange seen"] for row in rows) / pixels,
                         MOST_STRANGE)
    report.check_at_most(f"{SEEN}: RMSE of 255", (error / pixels) ** 0.5, MOST_RMSE)


def run(report):
    rows, pictures = measure(SEEDS)
    _judge(report, rows)
    chosen = _by_strange(rows)[:SHOWN]
    figure = report.rows_of([pictures[number] for number in chosen],
                            [f"seed {rows[number]['seed']}" for number in chosen], (8, 6))
    report.add("Refraction in random scenes", TEXT, count=len(rows), seeds=f"seeds {SEEDS[0]} to {SEEDS[-1]}",
               width=SIZE[0], height=SIZE[1], samples=SAMPLES, summary=_summary(rows),
               pictures=report.save(figure, "refraction", "The random scenes with the most strange pixels", True))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", default="0:50", help="FIRST:END, the end not included, or one seed")
    parser.add_argument("--folder", type=pathlib.Path, required=True)
    parser.add_argument("--samples", type=int, default=SAMPLES, help="rays a pixel of the truth: a square number")
    parser.add_argument("--worst", type=int, default=10, help="scenes to save as pictures")
    parser.add_argument("--own-view", action="store_true", help="also with the module's own view of what lies below")
    parser.add_argument("--own-views", type=int, nargs="+", default=(), metavar="FACTOR",
                        help="also as a view of its own of what lies below, FACTOR times as wide and high")
    arguments = parser.parse_args()
    first, _, end = arguments.seeds.partition(":")
    seeds = range(int(first), int(end) if end else int(first) + 1)
    arguments.folder.mkdir(parents=True, exist_ok=True)
    rows, pictures = measure(seeds, arguments.samples, arguments.own_views, arguments.own_view)
    (arguments.folder / "refraction.json").write_text(json.dumps(rows, indent=1) + "\n")
    for rank, number in enumerate(_by_strange(rows)[:arguments.worst]):
        wt.save(pictures[number], arguments.folder / f"worst-{rank:02}-seed-{rows[number]['seed']}.png")
    print(_summary(rows))
    if arguments.own_view:
        print("\nthe module's own view:", _summary([row["own view"] for row in rows]), sep="\n\n")
    for factor in arguments.own_views:
        summary = _summary([row[f"own view {factor}"] for row in rows])
        print(f"\nown view, {factor} times the picture:", summary, sep="\n\n")
    report = Report(arguments.folder)
    _judge(report, rows)
    return 1 if report.has_failed() else 0


def _by_strange(rows):
    return sorted(range(len(rows)), key=lambda number: -rows[number]["strange"])


def _summary(rows):
    cells = []
    water = sum(row["water"] for row in rows)
    for reason in REASONS:
        pixels = sum(row[f"pixels {reason}"] for row in rows)
        error = sum(row[f"pixels {reason}"] * row[f"RMSE {reason}"] ** 2 for row in rows)
        cells.append((reason, f"{100 * pixels / water:.2f} %", str(sum(row[f"strange {reason}"] for row in rows)),
                      f"{(error / max(pixels, 1)) ** 0.5:.2f}", str(sum(row[f"strange {reason}"] > 0 for row in rows))))
    text = table(("the correct colour is", "share of the pixels", "strange pixels", "RMSE of 255",
                  "scenes with strange pixels"), cells)
    return text + (f"\n\nTogether, {sum(row['strange'] for row in rows)} of {water} pixels are strange "
                   f"({sum(row['strange perfect'] for row in rows)} with one perfect ray per pixel). "
                   f"The RMSE is at most {MOST_RMSE:g}\n"
                   f"in {sum(row['RMSE'] <= MOST_RMSE for row in rows)} of {len(rows)} scenes ("
                   f"{sum(row['RMSE perfect'] <= MOST_RMSE for row in rows)} with one perfect ray). "
                   f"{sum(row['strange'] == 0 for row in rows)} scenes have no strange pixels.")


if __name__ == "__main__":
    sys.exit(main())

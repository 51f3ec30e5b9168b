# SPDX-License-Identifier: BSD-3-Clause
"""random_scenes: random scenes, drawn by the module and by the tracer; the section "scenes" of the report.

    PYTHONPATH=<folder of vtkwater> python Utilities/Accuracy/random_scenes.py --seeds 0:200 --folder DIR
        [--samples 64] [--qualities fast default high] [--worst 10] [--jobs 1]

Writes DIR/scenes.json, a row for each scene, and the worst scenes as pictures: the truth, the module's
default quality, their difference, and the reasons that the module gives (confidence.KINDS). Exit status 1: a limit
was not met.

The truth has so many rays a pixel; a perfect tracer has one, through the pixel's middle. A ratio is the
module's error over the perfect tracer's: 1 is as good as one ray can be. Counted are pixels that are water alone.
"""

import argparse
import json
import multiprocessing
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Testing" / "Python"))

import numpy as np  # noqa: E402
import ray_caster  # noqa: E402
import scene_generator  # noqa: E402
import water_test as wt  # noqa: E402
from colour import flip_map  # noqa: E402
from confidence import KINDS  # noqa: E402
from reference import reflected  # noqa: E402
from report import Report, table  # noqa: E402
from tracer import Tracer  # noqa: E402

QUALITIES = ("fast", "default", "high")
SEEDS = range(40)  # of the report
SAMPLES = 64  # rays a pixel
FLOORS = {"RMSE": 0.5, "FLIP": 0.002}  # smaller errors count as these: pictures are of whole 255ths
LIMITS = {"fast": (1.5, 2.0), "default": (1.05, 1.4), "high": (0.7, 0.9)}  # of the RMSE's ratio: median, 95 %
BLUER = 16  # of 255; a mixture with so much of the background is seen
APART = 3  # of 255
MOST_APART = 0.2  # % of a picture without water
SHOWN = 3  # scenes in the report
MAP = 1.25  # half the width of a mirrored view, of the picture's: the widest guard band
REASON_COLORS = {"hit": ("green", (60, 150, 60)), "sky": ("blue", (120, 180, 235)),
                 "off the texture": ("yellow", (235, 200, 60)), "hidden": ("red", (215, 60, 50)),
                 "downward": ("violet", (150, 80, 190))}

TEXT = """
$count scenes of random terrain and objects ($seeds) under a plain sky or a coloured dome, with random cameras, in
calm water and in up to four waves (`Utilities/Accuracy/scene_generator.py`); $width x $height pixels, $samples rays
per pixel in the truth. A ratio is the module's error divided by that of a perfect tracer with one ray per pixel;
errors below $rmse_floor (RMSE) and $flip_floor (FLIP) are rounded up to these values. In $domes scenes a dome hides
the background, so no ray can meet it: "background" counts pixels in which the module shows it nevertheless.

$summary

Reasons that the module reports, all scenes together, default quality:

$reasons

The scenes with the largest ratios, default quality. In the column "from what the mirrored view
lacks", every pixel whose ray meets a point that the mirrored view shows has its correct colour, so this ratio
comes from the other pixels. "Pixels that it lacks" is the share of these.

$worst

$pictures

*The truth, the module's default quality, their difference, the reasons: $legend.*
"""


class Truth:
    """What is right of a scene: its picture, the water's pixels, and what is seen without water."""

    def __init__(self, scene, samples, size=scene_generator.SIZE):
        self.size, self.scene = size, scene
        self.tracer = Tracer(scene.made.renderer, scene.origin)
        side = round(np.sqrt(samples))
        self.once, first, self.mask = self._picture((0.5, 0.5))
        self.low, self.high, total = first, first, 0.0
        for shift in np.stack(np.meshgrid(*[(np.arange(side) + 0.5) / side] * 2), axis=-1).reshape(-1, 2):
            seen, first, is_water = self._picture(shift)
            total = total + seen
            self.mask = self.mask & is_water
            self.low, self.high = np.minimum(self.low, first), np.maximum(self.high, first)
        self.picture, self.once = np.rint(total / side**2), np.rint(self.once)
        self.is_in_map = self._is_in_map()
        self.doubtful = 100 * self.tracer.doubtful_count / max(self.tracer.hit_count, 1)

    def rays(self, shift):
        """Rays through a place (0 to 1) of each pixel: colours that they see without water, whether they meet water, and
        of those that do, where, and the ways on."""
        start, ray = self.scene.rays(self.size, shift)
        colors, distance = self.tracer.cast(start, ray)
        is_water, place = self.scene.meet_water(start, ray, distance)
        place = place[is_water]
        _, *slopes = ray_caster.heights_and_slopes(self.scene.waves, place[:, 0], place[:, 1], 0.0)
        _, away = reflected(ray[is_water], *slopes)
        away[:, 2] = np.abs(away[:, 2])  # one that would meet the water again is bounced off it once more
        return colors, is_water, place, away

    def _picture(self, shift):
        """With one ray a pixel: 255 RGB with and without water, and whether the ray meets water."""
        width, height = self.size
        colors, is_water, place, away = self.rays(shift)
        first = 255 * colors.reshape(height, width, 3)
        colors[is_water] = self.tracer.cast(place, away)[0]
        return 255 * colors.reshape(height, width, 3), first, is_water.reshape(height, width)

    def _is_in_map(self):
        """Pixels of whose middle reflected ray one mirrored view shows the end; of one that meets nothing, too."""
        width, height = self.size
        scene, found = self.scene, np.ones(width * height, dtype=bool)
        _, is_water, place, away = self.rays((0.5, 0.5))
        length = self.tracer.cast(place, away)[1]
        end = place + np.where(np.isfinite(length), length, 1.0)[:, None] * away
        camera = scene.made.renderer.GetActiveCamera()
        matrix = ray_caster._array(camera.GetCompositeProjectionTransformMatrix(width / height, -1, 1))
        clip = np.concatenate([end * (1, 1, -1) + scene.origin, np.ones((len(end), 1))], axis=1) @ matrix.T
        x, y = (clip[:, :2] / clip[:, 3:]).T
        eye, down = ray_caster.rays_at(camera, self.size, x, y)
        eye = eye - scene.origin
        surface = eye - (eye[:, 2] / down[:, 2])[:, None] * down  # from there on the mirrored view has something
        free = self.tracer.cast(surface, down * (1, 1, -1))[1]
        is_seen = free > (1 - 2e-3) * np.linalg.norm(end - surface, axis=1)
        is_inside = (clip[:, 3] > 0) & (np.abs(x) < MAP) & (np.abs(y) < MAP)
        found[is_water] = (is_seen & is_inside & (down[:, 2] < 0)) | ~np.isfinite(length)
        return found.reshape(height, width)


class Result:
    """One scene: pictures and figures."""

    def __init__(self, seed, samples, qualities):
        scene = scene_generator.make(seed)
        look = scene.water.GetWaterProperty()
        self.truth = Truth(scene, samples)
        mask = self.mask = self.truth.mask & wt.water_mask(scene.made, scene.water)
        pictures = {"perfect": self.truth.once}
        for quality in sorted({*qualities, "default"}, key="default".__eq__):  # the reasons are the last one's
            getattr(look, f"SetRayTraceQualityTo{quality.capitalize()}")()
            pictures[quality] = self.picture = scene.made.picture()
        look.SetOutputToConfidence()
        self.said = scene.made.picture()[..., 0]
        look.SetOutputToColor()
        scene.water.VisibilityOff()
        bare = scene.made.picture()
        self.row = {"seed": seed, **scene.facts, "water": float(mask.mean()),
                    "apart": 100 * self._apart(bare), "doubtful": self.truth.doubtful}
        self._measure(pictures)
        if scene.has_dome:
            self._find_background(pictures)

    def _measure(self, pictures):
        row, mask, truth = self.row, self.mask, self.truth.picture
        for name, picture in pictures.items():
            row[f"RMSE {name}"] = float(np.sqrt(((picture - truth)[mask] ** 2).mean()))
            row[f"FLIP {name}"] = float(flip_map(picture, truth, mask)[mask].mean())
        # the module's picture with the truth wherever one mirrored view has what is right: no lookup does better there
        oracle = np.where(self.truth.is_in_map[..., None], truth, self.picture)
        row["RMSE one map"] = float(np.sqrt(((oracle - truth)[mask] ** 2).mean()))
        row["missing"] = float(1 - self.truth.is_in_map[mask].mean())
        for measure, floor in FLOORS.items():
            for name in pictures:
                row[f"{measure} ratio {name}"] = max(row[f"{measure} {name}"], floor) / max(
                    row[f"{measure} perfect"], floor)
        squared = ((self.picture - truth) ** 2).sum(axis=2)[mask]
        for kind, number in KINDS.items():
            chosen = (self.said == number)[mask]
            row[f"share {kind}"] = float(chosen.mean())
            row[f"error {kind}"] = float(squared[chosen].sum() / max(squared.sum(), 1))

    def _find_background(self, pictures):
        """Nothing in front of the background is bluer than green, and so no mixture of what is in front is."""
        for name, picture in {"truth": self.truth.picture, **pictures}.items():
            bluer = (picture[..., 2] - picture[..., 1] > BLUER)[self.mask]
            self.row[f"background {name}"] = int(bluer.sum())

    def _apart(self, bare):
        """Share of pixels that VTK draws otherwise, without water, than any of the tracer's rays in them."""
        low, high = self.truth.low - APART, self.truth.high + APART
        return float(((bare < low) | (bare > high)).any(axis=2).mean())

    def panels(self):
        """The truth, the module, their difference and the reasons, side by side."""
        reasons = np.full((*self.mask.shape, 3), 30)
        for kind, number in KINDS.items():
            reasons[self.mask & (self.said == number)] = REASON_COLORS[kind][1]
        apart = np.abs(self.picture - self.truth.picture) * self.mask[..., None]
        return np.concatenate([self.truth.picture, self.picture, apart, reasons], axis=1).clip(0, 255)


def _measured(job):
    """A row, and the pictures to show; in a process of its own."""
    seed, samples, qualities = job
    result = Result(seed, samples, qualities)
    row = result.row
    print(f"seed {seed}: RMSE of 255: perfect {row['RMSE perfect']:.2f}; " + ", ".join(
        f"{name} {row[f'RMSE {name}']:.2f} ({row[f'RMSE ratio {name}']:.2f})" for name in qualities)
        + f"; background {max((row.get(f'background {name}', 0) for name in qualities))}"
        + f"; apart {row['apart']:.3f} %, water {row['water']:.0%}", flush=True)
    return row, result.panels().astype(np.uint8)


def measure(seeds, samples=SAMPLES, qualities=QUALITIES, jobs=1):
    """Rows and pictures of all seeds, in their order."""
    work = [(seed, samples, qualities) for seed in seeds]
    if jobs == 1:
        found = [_measured(job) for job in work]
    else:
        with multiprocessing.get_context("spawn").Pool(jobs) as pool:
            found = pool.map(_measured, work, chunksize=1)
    return [row for row, _ in found], [panels for _, panels in found]


def _judge(report, rows, qualities):
    """The figures with limits."""
    name = f"{len(rows)} random scenes"
    for quality in qualities:
        ratios = [row[f"RMSE ratio {quality}"] for row in rows]
        middle, most = LIMITS[quality]
        report.check_at_most(f"{name}, {quality}: RMSE / one perfect ray's, median", float(np.median(ratios)), middle)
        report.check_at_most(f"{name}, {quality}: RMSE / one perfect ray's, 95 % of scenes within",
                             float(np.percentile(ratios, 95)), most)
        report.check_at_most(f"{name}, {quality}: pixels that show a hidden background",
                             sum(row.get(f"background {quality}", 0) for row in rows), 0, 0)
    report.check_at_most(f"{name}, truth: pixels that show a hidden background", sum(row.get("background truth", 0) for row in rows), 0, 0)
    report.check_at_most(f"{name}: % of pixels in which VTK without water and the tracer differ, worst scene",
                         max(row["apart"] for row in rows), MOST_APART)
    report.check_at_most(f"{name}: % of the tracer's hits off their triangle's plane, mean",
                         float(np.mean([row["doubtful"] for row in rows])), 0.1)


def _summary(rows, qualities):
    cells = []
    for quality in (*qualities, "perfect"):
        cell = [quality]
        for measure in FLOORS:
            ratios = [row[f"{measure} ratio {quality}"] for row in rows]
            cell += [f"{np.median([row[f'{measure} {quality}'] for row in rows]):.4g}", f"{np.median(ratios):.3f}",
                     f"{np.percentile(ratios, 95):.3f}", f"{max(ratios):.3f}"]
        cells.append((*cell, str(sum(row.get(f"background {quality}", 0) for row in rows))))
    titles = (": median", " ratio: median", " ratio: 95 %", " ratio: worst")
    header = [f"{measure}{title}" for measure in FLOORS for title in titles]
    return table(("", *header, "background"), cells)


def _reasons(rows):
    """Shares of all water pixels, and of their squared error."""
    pixels = np.array([row["water"] for row in rows])
    errors = pixels * np.square([row["RMSE default"] for row in rows])
    return table(("reason", "share of the pixels", "share of the squared error"), [
        (kind, *(f"{100 * np.average([row[f'{what} {kind}'] for row in rows], weights=weights):.1f} %"
                 for what, weights in (("share", pixels), ("error", errors)))) for kind in KINDS])


def _by_ratio(rows):
    """Numbers of rows, the largest ratio of the default quality first."""
    return sorted(range(len(rows)), key=lambda number: -rows[number]["RMSE ratio default"])


def _worst(rows, count):
    cells = []
    for number in _by_ratio(rows)[:count]:
        row = rows[number]
        least = max(row["RMSE one map"], FLOORS["RMSE"]) / max(row["RMSE perfect"], FLOORS["RMSE"])
        kind = max(KINDS, key=lambda kind: row[f"error {kind}"])
        camera = ", ".join(name for name in ("parallel", "off axis") if row[name])
        cells.append((str(row["seed"]), f"{row['RMSE perfect']:.2f}", f"{row['RMSE default']:.2f}",
                      f"{row['RMSE ratio default']:.2f}",
                      f"{least:.2f}", f"{row['missing']:.1%}", f"{kind}, {row[f'error {kind}']:.0%}",
                      f"{row['reach']:.3g} m, {row['elevation']:.0f} degrees, near {row['near']:.2g} m"
                      + (f", {camera}" if camera else ""),
                      f"{row['waves']}, slope {row['slope']:.2f}",
                      f"{row['dome']:.3g} m" if row["dome"] else "none"))
    return table(("seed", "RMSE, perfect", "default", "ratio", "from what the mirrored view lacks", "pixels that it lacks",
                  "largest share of the squared error", "eye", "waves", "dome"),
                 cells)


def _show(report, rows, pictures):
    chosen = _by_ratio(rows)[:SHOWN]
    return report.rows_of([pictures[number] for number in chosen],
                          [f"seed {rows[number]['seed']}" for number in chosen], (12, 2.4))


def run(report):
    rows, pictures = measure(SEEDS, jobs=min(4, os.cpu_count()))
    _judge(report, rows, QUALITIES)
    report.add("Random scenes", TEXT, count=len(rows), seeds=f"seeds {SEEDS[0]} to {SEEDS[-1]}", samples=SAMPLES,
               width=scene_generator.SIZE[0], height=scene_generator.SIZE[1], rmse_floor=FLOORS["RMSE"],
               flip_floor=FLOORS["FLIP"], domes=sum(row["dome"] > 0 for row in rows), reasons=_reasons(rows),
               summary=_summary(rows, QUALITIES), worst=_worst(rows, 2 * SHOWN),
               legend=", ".join(f"{kind} {name}" for kind, (name, _) in REASON_COLORS.items()),
               pictures=report.save(_show(report, rows, pictures), "scenes", "The worst random scenes"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", default="0:40", help="FIRST:END, the end not included, or one seed")
    parser.add_argument("--folder", type=pathlib.Path, required=True)
    parser.add_argument("--samples", type=int, default=SAMPLES, help="rays a pixel of the truth: a square number")
    parser.add_argument("--qualities", nargs="+", choices=QUALITIES, default=QUALITIES, help="some of them")
    parser.add_argument("--worst", type=int, default=10, help="scenes to save as pictures")
    parser.add_argument("--jobs", type=int, default=1, help="processes")
    arguments = parser.parse_args()
    first, _, end = arguments.seeds.partition(":")
    seeds = range(int(first), int(end) if end else int(first) + 1)
    arguments.folder.mkdir(parents=True, exist_ok=True)
    rows, pictures = measure(seeds, arguments.samples, arguments.qualities, arguments.jobs)
    (arguments.folder / "scenes.json").write_text(json.dumps(rows, indent=1) + "\n")
    for rank, number in enumerate(_by_ratio(rows)[:arguments.worst]):
        wt.save(pictures[number], arguments.folder / f"worst-{rank:02}-seed-{rows[number]['seed']}.png")
    report = Report(arguments.folder)
    print(_summary(rows, arguments.qualities), _reasons(rows), _worst(rows, arguments.worst), sep="\n\n")
    _judge(report, rows, arguments.qualities)
    return 1 if report.has_failed() else 0


if __name__ == "__main__":
    sys.exit(main())

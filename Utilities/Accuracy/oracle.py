# SPDX-License-Identifier: BSD-3-Clause
"""oracle: the errors of lookups in the mirrored view that are right wherever they can be, in random scenes, beside the module's.

    PYTHONPATH=<folder of vtkwater> python Utilities/Accuracy/oracle.py --seeds 9000:9040 --folder DIR
        [--samples 64] [--qualities default high] [--scale 1] [--jobs 1]

Traces the mirrored view itself: one ray through the middle of each texel, as wide as the module's, with one layer and,
for "high", a second one behind it (what is deeper by more than a tenth). The rays of the water's pixels are those of
the truth. What each of them meets is

    seen         in the mirrored view
    second       not in the first layer, but in the second
    hidden       behind something in the mirrored view, and in no layer
    outside      beyond the border of the mirrored view
    dome         a mesh that is the sky: the sky view shows it wherever it is
    dome behind  the same, or the background, but the ray passes behind something on its way: what the mirrored view has
                 cannot tell whether the ray meets that
    sky          nothing, and passes behind nothing

Each oracle is a picture:

    exact        every ray has its true colour: a perfect tracer
    one sample   seen (and second) colours are read in the mirrored view at exactly the right place, filtered or the
                 nearest texel, whichever is closer to the ray's true colour; all others are true: what the
                 resolution of the mirrored view costs
    best         the same, but hidden and outside take the colour closest to the true one that the mirrored view has
                 anywhere along the ray's way, which only one that knows the truth can choose
    front        the same, but without the truth: filtered colours, and the last texel before the ray goes behind something
    open         the same, but the sky where the mirrored view has the sky at the ray's end

with one ray a pixel, and with those of the quality: 4 ("default") or 8 ("high") where neighbours differ. What the second
layer shows is not sampled: it is true. "Best" is no strict bound: another colour than the ray's own may be closer to the
mean of the pixel. Prints a line for each scene and writes DIR/oracle.json, with the share of the module's squared error
in pixels of each kind. "FLIP, 1 of 255 apart" leaves out differences of 1.
"""

import argparse
import json
import multiprocessing
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Testing" / "Python"))

import numpy as np  # noqa: E402
import ray_caster  # noqa: E402
import scene_generator  # noqa: E402
import water_test as wt  # noqa: E402
from colour import flip_map  # noqa: E402
from random_scenes import FLOORS, LIMITS, Truth  # noqa: E402
from tables import table  # noqa: E402

KINDS = ("seen", "second", "hidden", "outside", "dome", "dome behind", "sky")
SEEN, SECOND, HIDDEN, OUTSIDE, DOME, BEHIND, SKY = range(len(KINDS))
ORACLES = ("exact", "one sample", "best", "front", "open")
RAYS = {"fast": 1, "default": 4, "high": 8}
CONTRAST = 255 / 16  # between neighbours: more rays
WAY = 64  # places on a ray's way
SLACK = 2e-3  # of a length: the same surface
LAYER_APART = 0.1  # of the depth behind: the second layer's surfaces are so much deeper
IS_DOME = 0.9  # of its radius


class Map:
    """The mirrored view: colours of 255 and distances from the water's plane, of the middles of its texels; two layers."""

    def __init__(self, truth, scale):
        self._truth, self._scene = truth, truth.scene
        camera = self._camera = self._scene.made.renderer.GetActiveCamera()
        reflection = self._scene.water.GetReflectionPass()
        texture = reflection.GetReflectionTexture()
        self.size = np.array((texture.GetWidth(), texture.GetHeight()))
        inner = np.floor(np.array(truth.size) * reflection.GetTextureScaleInUse() + 0.5)
        self.band = self.size / inner
        self.size = np.rint(self.size * scale / reflection.GetTextureScaleInUse()).astype(int)
        matrix = camera.GetCompositeProjectionTransformMatrix(truth.size[0] / truth.size[1], -1, 1)
        self._to_clip = ray_caster._array(matrix)
        middles = [((np.arange(count) + 0.5) / count * 2 - 1) * band for count, band in zip(self.size, self.band)]
        x, y = (each.ravel() for each in np.meshgrid(*middles))
        shape = (self.size[1], self.size[0])
        start, up, is_up = self._rays(x, y)
        color, self.way = self._truth.tracer.cast(start, up)
        self.color = np.rint(255 * color).reshape(*shape, 3)
        self.way = np.where(is_up, self.way, np.inf).reshape(shape)
        self.depth = self._depth(start, up, self.way.ravel()).reshape(shape)

    def _rays(self, x, y):
        """From the plane to what the mirrored view shows at places of the picture, and whether they leave the plane."""
        eye, down = ray_caster.rays_at(self._camera, self._truth.size, x, y)
        eye = eye - self._scene.origin
        is_up = down[:, 2] < -1e-9
        start = eye - (eye[:, 2] / np.where(is_up, down[:, 2], -1.0))[:, None] * down
        return np.where(is_up[:, None], start, 0.0), np.where(is_up[:, None], down * (1, 1, -1), (0, 0, 1.0)), is_up

    def _depth(self, start, up, way):
        """Along the mirrored camera's axis, of places that far from the plane."""
        place = start + np.where(np.isfinite(way), way, 0)[:, None] * up
        return np.where(np.isfinite(way), self.depth_of(place), np.inf)

    def depth_of(self, place):
        eye = np.array(self._camera.GetPosition()) - self._scene.origin
        ahead = np.array(self._camera.GetDirectionOfProjection())
        return (place * (1, 1, -1) - eye) @ ahead

    def places(self, points):
        """Texels (x, y; whole numbers are their middles) that show points, and whether they are within the view."""
        clip = np.concatenate([points * (1, 1, -1) + self._scene.origin, np.ones((len(points), 1))], axis=1)
        clip = clip @ self._to_clip.T
        ahead = clip[:, 3:] > 1e-12
        ndc = clip[:, :2] / np.where(ahead, clip[:, 3:], 1.0)
        at = (ndc / self.band + 1) * 0.5 * self.size - 0.5
        return at, ahead[:, 0] & (np.abs(ndc) < self.band).all(axis=1)

    def nearest(self, image, at):
        x, y = (np.clip(np.rint(at[:, axis]), 0, self.size[axis] - 1).astype(int) for axis in (0, 1))
        return image[y, x]

    def filtered(self, at):
        low = np.floor(at)
        part = at - low
        found = 0.0
        for dy in (0, 1):
            for dx in (0, 1):
                weight = (part[:, 0] if dx else 1 - part[:, 0]) * (part[:, 1] if dy else 1 - part[:, 1])
                found = found + weight[:, None] * self.nearest(self.color, low + (dx, dy))
        return found

    def is_seen(self, points, is_second):
        """Whether the mirrored eye sees points above the plane, or would behind its first layer."""
        at, is_inside = self.places(points)
        ndc = ((at + 0.5) / self.size * 2 - 1) * self.band
        start, up, is_up = self._rays(ndc[:, 0], ndc[:, 1])
        whole = np.linalg.norm(points - start, axis=1)
        if is_second:
            _, first = self._truth.tracer.cast(start, up)
            eye = np.array(self._camera.GetPosition()) - self._scene.origin
            before = 0 if self._camera.GetParallelProjection() else np.linalg.norm(start - eye, axis=1)
            skipped = np.minimum((first + before) / (1 - LAYER_APART) - before, whole * (1 + SLACK))
            skipped = np.where(np.isfinite(first), skipped, 0)
            start = start + skipped[:, None] * up
            whole = whole - skipped
            is_up &= whole > 0
        _, free = self._truth.tracer.cast(start, up)
        return is_inside & is_up & (free > whole - SLACK * np.linalg.norm(points - start, axis=1) - 1e-9) & (whole > 0)


def _closest(candidates, true):
    """Of colours, those closest to others."""
    apart = [((candidate - true) ** 2).sum(axis=1) for candidate in candidates]
    chosen = np.argmin(apart, axis=0)
    return np.stack(candidates)[chosen, np.arange(len(true))]


class Rays:
    """What the oracles make of one ray a pixel: colours by oracle's name, and kinds."""

    def __init__(self, truth, mirrored, shift, has_second):
        self._truth = truth
        colors, is_water, place, away = truth.rays(shift)
        shape = (truth.size[1], truth.size[0])
        true, length = truth.tracer.cast(place, away)
        true = 255 * true
        kinds = np.zeros(len(place), dtype=int)
        is_hit = np.isfinite(length)
        ends = place + np.where(is_hit, length, 0)[:, None] * away
        radius = truth.scene.facts["dome"]
        is_dome = is_hit & (np.linalg.norm(ends, axis=1) > IS_DOME * radius) if radius else np.zeros(len(place), dtype=bool)
        # a ray that meets nothing ends where it is over all other things
        top = self._top(truth)
        climb = np.clip((top - place[:, 2]) / np.maximum(away[:, 2], 1e-9), 0, 1e3 * truth.scene.sheet)
        is_sky = is_dome | ~is_hit
        far = np.where(is_sky, climb, length)
        seen = np.zeros(len(place), dtype=bool)
        thing = np.flatnonzero(~is_sky)
        seen[thing] = mirrored.is_seen(ends[thing], False)
        kinds[:] = SEEN
        _, is_inside = mirrored.places(ends)
        kinds[~is_sky & ~seen] = np.where(is_inside[~is_sky & ~seen], HIDDEN, OUTSIDE)
        if has_second:
            rest = np.flatnonzero(kinds == HIDDEN)
            kinds[rest[mirrored.is_seen(ends[rest], True)]] = SECOND
        is_behind, _, best, _ = self._along(mirrored, place, away, far, true)
        kinds[is_sky] = np.where(is_behind[is_sky], BEHIND, np.where(is_dome[is_sky], DOME, SKY))
        at, _ = mirrored.places(ends)
        filtered, nearest = mirrored.filtered(at), mirrored.nearest(mirrored.color, at)
        if has_second:  # of the second layer only the resolution is not modelled
            filtered, nearest = (np.where((kinds == SECOND)[:, None], true, each) for each in (filtered, nearest))
        is_read = ((kinds == SEEN) | (kinds == SECOND))[:, None]
        rounded = np.rint(true)
        lost = np.isin(kinds, (HIDDEN, OUTSIDE, BEHIND))
        sampled = np.where(is_read, _closest([filtered, nearest], true), rounded)
        # the sky is known by its direction: it is always one of the choices of a ray that may be behind
        best = np.where((kinds == BEHIND)[:, None], rounded, best)
        front, open_sky = sampled.copy(), sampled.copy()
        rows = np.flatnonzero(lost)
        front[rows], open_sky[rows] = self._guessed(mirrored, place[rows], away[rows], climb[rows], radius)
        read = np.where(is_read, filtered, rounded)
        lost = lost[:, None]
        found = {"exact": rounded, "one sample": sampled, "best": np.where(lost, best, sampled),
                 "front": np.where(lost, front, read), "open": np.where(lost, open_sky, read)}
        self.kinds = np.full(len(is_water), -1)
        self.kinds[is_water] = kinds
        self.kinds = self.kinds.reshape(shape)
        self.colors = {}
        for name, values in found.items():
            whole = 255 * colors
            whole[is_water] = values
            self.colors[name] = whole.reshape(*shape, 3)

    @staticmethod
    def _top(truth):
        """The height of all but a dome."""
        tops = [actor.GetBounds()[5] for actor in truth.scene.made.renderer.GetActors() if not actor.IsA("vtkWaterActor")]
        radius = truth.scene.facts["dome"]
        tops = [top - truth.scene.origin[2] for top in tops]
        return max([top for top in tops if not radius or top < IS_DOME * radius] + [0.0])

    def _guessed(self, mirrored, place, away, climb, radius):
        """Colours that rays may be given that go behind something, or outside, and nothing more is known: the last one
        before, and that of the sky where the mirrored view has the sky at the ray's end."""
        _, front, _, end = self._along(mirrored, place, away, climb, np.zeros((len(place), 3)))
        is_open = ~np.isfinite(mirrored.nearest(mirrored.depth, end))
        sky = np.tile(255 * np.array(self._truth.scene.made.renderer.GetBackground()), (len(place), 1))
        if radius:
            is_open |= mirrored.nearest(mirrored.depth, end) > 0.5 * radius
            sky = 255 * self._truth.tracer.cast(away * (IS_DOME + 0.05) * radius * np.cos(np.pi / 48) ** 2, away)[0]
        return front, np.where(is_open[:, None], np.rint(sky), front)

    @staticmethod
    def _along(mirrored, place, away, far, true):
        """Of the ways through the mirrored view: whether they go behind something; the colour of the last texel before
        that, or at the end; the colour closest to the true one; and where the mirrored view has the end."""
        first, last = mirrored.depth_of(place), mirrored.depth_of(place + far[:, None] * away)
        is_behind, was_inside = np.zeros(len(place), dtype=bool), np.ones(len(place), dtype=bool)
        front = mirrored.nearest(mirrored.color, mirrored.places(place)[0])
        end = mirrored.places(place)[0]
        best, least = front.copy(), ((front - true) ** 2).sum(axis=1)
        for share in (np.arange(WAY) + 0.5) / WAY:
            with np.errstate(divide="ignore", invalid="ignore"):
                part = np.where(last > 0, share * first / (share * first + (1 - share) * last), share)
            part = np.clip(np.nan_to_num(part, nan=share), 0, 1)
            point = place + (part * far)[:, None] * away
            at, is_inside = mirrored.places(point)
            was_inside &= is_inside
            end = np.where(was_inside[:, None], at, end)
            depth = mirrored.depth_of(point)
            color = mirrored.nearest(mirrored.color, at)
            is_behind |= is_inside & (depth > (1 + SLACK) * mirrored.nearest(mirrored.depth, at))
            front = np.where((~is_behind & was_inside)[:, None], color, front)
            apart = ((color - true) ** 2).sum(axis=1)
            is_closer = (apart < least) & is_inside
            best, least = np.where(is_closer[:, None], color, best), np.where(is_closer, apart, least)
        return is_behind, front, best, end


def ray_places(count):
    """As in vtkWaterRaysFS.glsl, from the pixel's corner."""
    found = [(0.5, 0.5)]
    for ray in range(1, count + 1):
        number = (count if ray == 2 else 2 if ray == count else ray) - 0.5
        found.append((number / count, (0.618034 * number) % 1))
    return found


def _differing(picture):
    """Pixels of which a neighbour within 2 x 2 differs."""
    apart = np.zeros(picture.shape[:2])
    for axis in (0, 1):
        pairs = np.abs(np.diff(picture, axis=axis)).max(axis=2)
        pairs = pairs[::2] if axis == 0 else pairs[:, ::2]
        wide = np.repeat(pairs, 2, axis=axis)
        rest = [(0, apart.shape[0] - wide.shape[0]), (0, apart.shape[1] - wide.shape[1])]
        apart = np.maximum(apart, np.pad(wide, rest))
    return apart > CONTRAST


class Result:
    def __init__(self, seed, samples, qualities, scale):
        scene = scene_generator.make(seed)
        look = scene.water.GetWaterProperty()
        self.truth = truth = Truth(scene, samples)
        mask = self.mask = truth.mask & wt.water_mask(scene.made, scene.water)
        self.pictures = {}
        for quality in qualities:
            getattr(look, f"SetRayTraceQualityTo{quality.capitalize()}")()
            self.pictures[quality] = scene.made.picture()
        look.SetOutputToConfidence()
        self.said = scene.made.picture()[..., 0]
        look.SetOutputToColor()
        mirrored = Map(truth, scale)
        self.row = {"seed": seed, **scene.facts, "water": int(mask.sum()), "map": [int(each) for each in mirrored.size]}
        for quality in qualities:
            self._oracles(mirrored, quality)
        for name, picture in {"perfect": truth.once, **self.pictures}.items():
            self._measure(name, picture)
        squared = {name: ((picture - truth.picture) ** 2).sum(axis=2) for name, picture in self.pictures.items()}
        for number, kind in enumerate(KINDS):
            chosen = mask & (self.kinds == number)
            self.row[f"share {kind}"] = float(chosen.sum() / mask.sum())
            for name, errors in squared.items():
                self.row[f"error {name} {kind}"] = float(errors[chosen].sum())

    def _oracles(self, mirrored, quality):
        count = RAYS[quality]
        middle = Rays(self.truth, mirrored, (0.5, 0.5), quality == "high")
        self.kinds = middle.kinds
        sums = {name: 0.0 for name in ORACLES}
        if count > 1:
            for shift in ray_places(count)[1:]:
                rays = Rays(self.truth, mirrored, shift, quality == "high")
                for name in ORACLES:
                    sums[name] = sums[name] + rays.colors[name] / count
        for name in ORACLES:
            one = middle.colors[name]
            self.pictures[f"{quality}, {name}, 1 ray"] = np.rint(one)
            if count > 1:
                several = np.where(_differing(one)[..., None], sums[name], one)
                self.pictures[f"{quality}, {name}"] = np.rint(several)
                self.pictures[f"{quality}, {name}, everywhere"] = np.rint(sums[name])

    def _measure(self, name, picture):
        truth, mask, row = self.truth.picture, self.mask, self.row
        row[f"RMSE {name}"] = float(np.sqrt(((picture - truth)[mask] ** 2).mean()))
        row[f"FLIP {name}"] = float(flip_map(picture, truth, mask)[mask].mean())
        apart = np.where(np.abs(picture - truth).max(axis=2, keepdims=True) <= 1, truth, picture)
        row[f"FLIP 1 apart {name}"] = float(flip_map(apart, truth, mask)[mask].mean())


def ratio(row, measure, name):
    floor = FLOORS[measure.split()[0]]
    return max(row[f"{measure} {name}"], floor) / max(row[f"{measure} perfect"], floor)


def _measured(job):
    seed, samples, qualities, scale, folder = job
    result = Result(seed, samples, qualities, scale)
    row = result.row
    keep = {name.replace(" ", "_").replace(",", ""): picture.astype(np.float32) for name, picture in result.pictures.items()
            if "," not in name}
    np.savez_compressed(folder / f"seed-{seed}.npz", truth=result.truth.picture.astype(np.float32), mask=result.mask,
                        kinds=result.kinds, said=result.said, perfect=result.truth.once, **keep)
    for quality in qualities:
        whole = max(sum(row[f"error {quality} {kind}"] for kind in KINDS), 1)
        rays = ", 1 ray" if RAYS[quality] == 1 else ""
        print(f"seed {seed} {quality}: RMSE {row['RMSE ' + quality]:.2f} (perfect {row['RMSE perfect']:.2f}); ratio "
              f"{ratio(row, 'RMSE', quality):.2f}; oracles " + ", ".join(
                  f"{oracle} {ratio(row, 'RMSE', f'{quality}, {oracle}{rays}'):.2f}" for oracle in ORACLES)
              + "; pixels (squared error) " + ", ".join(
                  f"{kind} {row['share ' + kind]:.1%} ({row[f'error {quality} {kind}'] / whole:.0%})"
                  for kind in KINDS if row["share " + kind] > 0), flush=True)
    return row


def summary(rows, qualities):
    """Ratios of all pictures, and where the errors are."""
    cells = []
    names = sorted({key[5:] for key in rows[0] if key.startswith("RMSE ")})
    for name in names:
        cell = [name]
        for measure in ("RMSE", "FLIP", "FLIP 1 apart"):
            ratios = [ratio(row, measure, name) for row in rows]
            cell += [f"{np.median(ratios):.3f}", f"{np.percentile(ratios, 95):.3f}", f"{max(ratios):.2f}"]
        cells.append(cell)
    header = [f"{measure}: {what}" for measure in ("RMSE", "FLIP", "FLIP, 1 of 255 apart") for what in ("median", "95 %", "most")]
    limits = "; ".join(f"{quality} {LIMITS[quality][0]}, {LIMITS[quality][1]}" for quality in qualities)
    return "\n\n".join((table(("", *header), cells), _kinds(rows, qualities), f"limits of the ratios: {limits}"))


def _kinds(rows, qualities):
    """Shares of the pixels of all scenes, and of the squared error of their pictures."""
    pixels = sum(row["water"] for row in rows)
    cells = []
    for kind in KINDS:
        cell = [kind, f"{100 * sum(row['water'] * row['share ' + kind] for row in rows) / pixels:.1f} %"]
        for quality in qualities:
            whole = sum(row[f"error {quality} {each}"] for row in rows for each in KINDS)
            cell.append(f"{100 * sum(row[f'error {quality} {kind}'] for row in rows) / max(whole, 1):.1f} %")
        cells.append(cell)
    return table(("the middle ray's end", "pixels", *(f"squared error, {quality}" for quality in qualities)), cells)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", default="0:40", help="FIRST:END, the end not included, or one seed; several with commas")
    parser.add_argument("--folder", type=pathlib.Path, required=True)
    parser.add_argument("--samples", type=int, default=64, help="rays a pixel of the truth: a square number")
    parser.add_argument("--qualities", nargs="+", choices=RAYS, default=("default",))
    parser.add_argument("--scale", type=float, default=1.0, help="texels of the oracle's mirrored view per pixel")
    parser.add_argument("--jobs", type=int, default=1, help="processes")
    arguments = parser.parse_args()
    seeds = []
    for part in arguments.seeds.split(","):
        first, _, end = part.partition(":")
        seeds += range(int(first), int(end) if end else int(first) + 1)
    arguments.folder.mkdir(parents=True, exist_ok=True)
    jobs = [(seed, arguments.samples, arguments.qualities, arguments.scale, arguments.folder) for seed in seeds]
    if arguments.jobs == 1:
        rows = [_measured(job) for job in jobs]
    else:
        with multiprocessing.get_context("spawn").Pool(arguments.jobs) as pool:
            rows = pool.map(_measured, jobs, chunksize=1)
    (arguments.folder / "oracle.json").write_text(json.dumps(rows, indent=1) + "\n")
    print(summary(rows, arguments.qualities))


if __name__ == "__main__":
    main()

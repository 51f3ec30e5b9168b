# SPDX-License-Identifier: BSD-3-Clause
"""colour: how far the water's pixels are from the tracer's, as RMSE and as FLIP sees it."""

import functools

import flip_evaluator
import numpy as np
import ray_caster
import reference
import water_test as wt
import wave_scenes
from report import plt, table
from tracer import Tracer

SIZE = (640, 480)
SMALL_SIZE = (400, 300)  # edges are a larger part of it
SAMPLES = 4  # squared: rays per pixel of the truth
# setting of the module, constants to try
OFFSETS = {"constant offset": ("FixedOffset", 1.0), "offset over depth": ("ViewScaledOffset", 10.0)}
SEARCH_STEPS = 21
QUALITIES = ("Fast", "Default", "High")
NEAR = 3  # pixels
OFF = 16  # of 255
PERFECT = "a perfect tracer, one ray a pixel"

TEXT = """
Poles, boxes and floating objects with hard edges ($triangles triangles), slopes of the waves up to 0.10, $width x
$height pixels, one sample per pixel, a mirrored view of the same scale; perfect reflection, unlit. The truth has
$samples rays per pixel. Only pixels that show nothing but water in both pictures count ($shares of the picture in the
views $views). For FLIP (version 1.7, 67 pixels per degree) all other pixels are set to the truth in both pictures, and
the mean of FLIP's error map is taken over the water's pixels. For comparison, the last row has a perfect tracer with one ray
per pixel: its FLIP is $ceiling times smaller than that of the best constant offset. Each
view has constants of its own for the offsets, the first optimal for RMSE and the second for FLIP, from a search that
knows the truth ($constants).

$table

In a smaller picture, edges cover a larger part, and one sample cannot resolve them. At $small_width x $small_height
pixels the best constant offset has $small_rmse times the RMSE and $small_flip times the FLIP of the ray-traced
default, and $small_ceiling times the FLIP of the perfect tracer.

$pictures

*Centre of the $view view. Above: the pictures; below: FLIP's error maps (black: no error).*

FLIP of the ray-traced default, mean of the pixels of all views (the table above has the mean of the views):

$kinds

An "edge" is a pixel whose $samples rays do not all see the same colour. FLIP filters like the human eye, so an error
there also shows in the pixels around it. A single ray sees only one side of an edge, and the mirrored view, also with
one sample per pixel, locates an edge to half a pixel. In $only of the water's pixels the error exceeds $off of
255 but that of the perfect tracer's single ray does not; in $both both do.
"""


def flip_map(picture, truth, mask):
    """FLIP's error map of two pictures of 255, where the mask is; all other pixels are the truth's in both."""
    shown = np.where(mask[..., None], picture, truth)
    first, second = (np.ascontiguousarray(each[::-1] / 255, dtype=np.float32) for each in (truth, shown))
    found, _, _ = flip_evaluator.evaluate(first, second, "LDR", applyMagma=False, computeMeanError=False)
    return found.reshape(mask.shape)[::-1]


class View:
    """One view: the truth, and the errors of pictures against it."""

    def __init__(self, name, size=SIZE):
        self.name = name
        self.made, self.water = wave_scenes.post_scene(name, size=size)
        self.tracer = Tracer(self.made.renderer)
        camera, waves = self.made.renderer.GetActiveCamera(), wave_scenes.POSTS_WAVES
        self.truth, is_water = reference.picture(self.tracer, camera, size, waves, SAMPLES)
        self.mask = is_water & wt.water_mask(self.made, self.water)
        self.once = reference.picture(self.tracer, camera, size, waves, 1)[0]
        self.spread = self._spread(camera, size, waves)

    def _spread(self, camera, size, waves):
        """The largest difference between the rays of a pixel, of 255."""
        rays = reference.picture(self.tracer, camera, (size[0] * SAMPLES, size[1] * SAMPLES), waves, 1)[0]
        rays = rays.reshape(size[1], SAMPLES, size[0], SAMPLES, 3)
        return (rays.max(axis=(1, 3)) - rays.min(axis=(1, 3))).max(axis=2)

    def picture(self, setting, scale=0.0):
        look = self.water.GetWaterProperty()
        getattr(look, f"Set{setting}")()
        look.SetOffsetScale(scale)
        return self.made.picture()

    def thorough_picture(self, texture_scale):
        look, reflection = self.water.GetWaterProperty(), self.water.GetReflectionPass()
        look.SetRayTraceSteps(64)
        look.SetRayTraceProbes(16)
        reflection.SetTextureScale(texture_scale)
        picture = self.made.picture()
        reflection.SetTextureScale(1)
        return picture

    def rmse(self, picture):
        return wave_scenes.rmse(picture, self.truth, self.mask)

    def flip_map(self, picture):
        return flip_map(picture, self.truth, self.mask)

    def flip(self, picture):
        return float(self.flip_map(picture)[self.mask].mean())


class Errors:
    """RMSE and FLIP of one way to find reflections, per view; constants where a search found some."""

    def __init__(self):
        self.rmse, self.flip, self.constants = [], [], []

    def together(self):
        return float(np.sqrt(np.mean(np.square(self.rmse)))), float(np.mean(self.flip))


def _search(error_of, largest):
    """The smallest error and its constant: on a grid, then on a finer one between its neighbours."""
    scales = np.linspace(0, largest, SEARCH_STEPS)
    error, best = min((error_of(scale), scale) for scale in scales)
    finer = np.linspace(max(best - scales[1], 0), best + scales[1], 9)
    return min((error, best), *((error_of(scale), scale) for scale in finer))


@functools.lru_cache
def measure():
    """The views, and Errors by name, in the order of the table."""
    views = [View(name) for name in wave_scenes.POSTS_VIEWS]
    found = {}

    def add(name, view, picture):
        errors = found.setdefault(name, Errors())
        errors.rmse.append(view.rmse(picture))
        errors.flip.append(view.flip(picture))

    for view in views:
        add("calm lookup", view, view.picture("LookupToFixedOffset"))
        for name, (setting, largest) in OFFSETS.items():
            errors = found.setdefault(f"{name}, best", Errors())
            rmse, by_rmse = _search(lambda scale: view.rmse(view.picture(f"LookupTo{setting}", scale)), largest)
            flip, by_flip = _search(lambda scale: view.flip(view.picture(f"LookupTo{setting}", scale)), largest)
            errors.rmse.append(rmse)
            errors.flip.append(flip)
            errors.constants.append((by_rmse, by_flip))
        view.picture("LookupToRayTraced")
        for quality in QUALITIES:
            add(f"ray traced, {quality.lower()}", view, view.picture(f"RayTraceQualityTo{quality}"))
        for scale in (1, 2):
            name = "ray traced, 64 steps, 16 probes" + (", mirrored view of twice the scale" if scale == 2 else "")
            add(name, view, view.thorough_picture(scale))
        add(PERFECT, view, view.once)
        print(f"{view.name} view: RMSE of 255, FLIP: " + "; ".join(
            f"{name} {errors.rmse[-1]:.2f}, {errors.flip[-1]:.4f}" for name, errors in found.items()), flush=True)
    return views, found


def _small_ratios():
    """RMSE and FLIP of the best constant offset over ray traced, and FLIP over a perfect tracer, in a
    smaller picture."""
    offset, traced, perfect = Errors(), Errors(), Errors()
    for name in wave_scenes.POSTS_VIEWS:
        view = View(name, SMALL_SIZE)
        for errors, measure_of in ((offset.rmse, view.rmse), (offset.flip, view.flip)):
            errors.append(_search(lambda scale: measure_of(view.picture("LookupToFixedOffset", scale)), 1.0)[0])
        for errors, picture in ((traced, _default_picture(view)), (perfect, view.once)):
            errors.rmse.append(view.rmse(picture))
            errors.flip.append(view.flip(picture))
    by_traced = np.array(offset.together()) / traced.together()
    return (*by_traced, offset.together()[1] / perfect.together()[1])


def _default_picture(view):
    view.picture("LookupToRayTraced")
    return view.picture("RayTraceQualityToDefault")


def _grown(mask, pixels):
    """A mask with all that is so near to it."""
    steps = range(-pixels, pixels + 1)
    return np.logical_or.reduce([np.roll(mask, (y, x), axis=(0, 1)) for y in steps for x in steps])


def _kinds(views):
    """Rows: kinds of pixels, their share, and what they add to FLIP, ours and the perfect tracer's."""
    maps, edges, nears = [], [], []
    for view in views:
        maps.append([view.flip_map(picture)[view.mask] for picture in (_default_picture(view), view.once)])
        edges.append((view.spread > 0)[view.mask])
        nears.append(_grown(view.spread > 0, NEAR)[view.mask])
    (ours, perfect), edge, near = np.concatenate(maps, axis=1), np.concatenate(edges), np.concatenate(nears)
    return [(name, f"{100 * kind.mean():.1f} %", f"{100 * ours[kind].sum() / ours.sum():.1f} %",
             f"{ours[kind].sum() / len(kind):.4f}", f"{perfect[kind].sum() / len(kind):.4f}")
            for name, kind in (("edges", edge), (f"within {NEAR} pixels of edges", near & ~edge), ("the rest", ~near))]


def _wrong(views):
    """Shares of pixels that are off in the ray traced picture alone, and also in the perfect tracer's."""
    pairs = np.concatenate([
        [(np.abs(picture - view.truth).max(axis=2) > OFF)[view.mask] for picture in (_default_picture(view), view.once)]
        for view in views], axis=1)
    return float((pairs[0] & ~pairs[1]).mean()), float((pairs[0] & pairs[1]).mean())


def _show(view, constant):
    """Pictures over their error maps, of the middle of a view."""
    pictures = (("tracer, 16 rays a pixel", view.truth), ("tracer, 1 ray a pixel", view.once),
                ("ray traced, default", _default_picture(view)),
                ("best constant offset", view.picture("LookupToFixedOffset", constant)))
    height, width = view.mask.shape
    part = (slice(height // 8, height * 5 // 8), slice(width // 4, width * 3 // 4))
    figure, axes = plt.subplots(2, len(pictures), figsize=(12, 4.8))
    for (above, below), (name, picture) in zip(axes.T, pictures):
        above.imshow((picture[part] / 255).clip(0, 1), origin="lower", interpolation="nearest")
        below.imshow(view.flip_map(picture)[part], origin="lower", interpolation="nearest", cmap="magma",
                     vmin=0, vmax=0.8)
        above.set_title(name)
        above.axis("off")
        below.axis("off")
    return figure


def _tracers_apart(view):
    """Share of the pixels that Embree and the tests' ray caster, of ideal spheres, see otherwise."""
    camera = view.made.renderer.GetActiveCamera()
    other, _ = ray_caster.picture(
        camera, SIZE, wave_scenes.posts(), wave_scenes.SKY, wave_scenes.POSTS_WAVES, 0.0, 1)
    return float((np.abs(other - view.once).max(axis=2) > 1).mean())


def run(report):
    views, found = measure()
    report.check_at_most("Embree and the tests' own ray caster: largest % of pixels apart in a view",
                         100 * max(_tracers_apart(view) for view in views), 0.2)
    traced_rmse, traced_flip = found["ray traced, default"].together()
    offset = found["constant offset, best"]
    offset_rmse, offset_flip = offset.together()
    report.check_at_least("RMSE of the best constant offset of each view / ray traced, default",
                          offset_rmse / traced_rmse, 3, 2)
    ceiling = offset_flip / found[PERFECT].together()[1]
    report.check_at_least("FLIP of the best constant offset of each view / ray traced, default",
                          offset_flip / traced_flip, 5, 2)
    only, both = _wrong(views)
    rows = []
    for name, errors in found.items():
        rmse, flip = errors.together()
        rows.append((f"**{name}**" if name.startswith("ray") else name, *(f"{each:.2f}" for each in errors.rmse),
                     f"{rmse:.2f}", *(f"{each:.4f}" for each in errors.flip), f"{flip:.4f}"))
    names = [view.name for view in views]
    header = ("lookup", *(f"RMSE of 255: {name}" if name == names[0] else name for name in names), "together",
              *(f"FLIP: {name}" if name == names[0] else name for name in names), "together")
    constants = "; ".join(
        f"{name}: " + ", ".join(f"{by_rmse:.3g} and {by_flip:.3g}" for by_rmse, by_flip in errors.constants)
        for name, errors in found.items() if errors.constants)
    report.add(
        "Colour", TEXT, triangles=views[0].tracer.triangle_count,
        width=SIZE[0], height=SIZE[1], samples=SAMPLES**2, small_width=SMALL_SIZE[0], small_height=SMALL_SIZE[1],
        **dict(zip(("small_rmse", "small_flip", "small_ceiling"), (f"{ratio:.2f}" for ratio in _small_ratios()))),
        shares=", ".join(f"{view.mask.mean():.0%}" for view in views), views=", ".join(names), constants=constants, table=table(header, rows),
        ceiling=f"{ceiling:.2f}", off=OFF, only=f"{100 * only:.2f} %", both=f"{100 * both:.2f} %",
        view=views[0].name,
        pictures=report.save(_show(views[0], offset.constants[0][0]), "colour", "Pictures and error maps"),
        kinds=table(("pixels", "share", "share of the FLIP", "adds to the mean", "perfect tracer, one ray: adds"),
                    _kinds(views)))

# SPDX-License-Identifier: BSD-3-Clause
"""lookup: how far, in pixels, from its right place a reflection is looked up."""

import numpy as np
import water_test as wt
import wave_scenes
from confidence import KINDS
from formulas import FORMULAS, axes_of
from reference import Pixels
from report import plt, table
from tracer import Tracer

SLOPES = (0.05, 0.10)
QUALITIES = ("Fast", "Default", "High")
SEARCH_STEPS = 61

TEXT = """
The tracer follows the reflected ray of each pixel to the point that it meets. The correct lookup is the place where
the mirrored view shows this point. Only pixels whose point is visible in the mirrored view count: for other pixels
there is no correct lookup. Smooth islands ($triangles triangles), $width x $height pixels, a mirrored view of the
same scale, three views together; waves of three lengths with the given rms slope. The module's lookups are read back
(`SetOutputToLookup`) in steps of 1/4095 of the texture, about $step pixels: differences below that are rounding.

$table

$plot

*Share of the pixels (vertical axis) whose lookup error is below a number of pixels (horizontal axis). Solid lines:
ray traced, and each formula with its best constant; dashed lines: with published constants.*

Lookups of the default quality, by the reason that the module reports (see [Confidence](#confidence)): all, and
those off by 2 pixels or more:

$reasons

The published formulas use the same normals, points and mirrored view as the ray-traced lookup:

$formulas

uv: the calm lookup, in fractions of the picture; n: the normal, its third component upwards; P: the point on the
water; R: the reflected ray; map: the place where the mirrored view shows a point.
"Stronger upright": y counts four times as much as x. "Best" is the constant with the
smallest median over all three views, from a search that knows the truth. If a formula uses the axes of its program's
world, the best of the 8 ways to exchange and negate them is used, for published constants too. Constants in units
depend on the size of the scene.
"""


class Case:
    """One view with waves of a slope: its picture, and the truth."""

    def __init__(self, view, slope):
        waves = wave_scenes.island_waves(slope)
        self.made, self.water = wave_scenes.island_scene(view, waves)
        self.made.picture()
        self.tracer = Tracer(self.made.renderer)
        pixels = Pixels(self.tracer, self.made, self.water, waves, wave_scenes.ISLANDS_SIZE)
        is_water = wt.water_mask(self.made, self.water).ravel() & pixels.is_water
        self._counts = is_water & pixels.is_hit & pixels.is_on_map & pixels.is_seen
        self.pixels = pixels.only(self._counts)

    def errors(self, uv):
        """Distances in pixels; a lookup beyond the texture takes its border."""
        inside = np.clip(np.nan_to_num(uv, nan=0.0), 0, 1)
        return np.linalg.norm((inside - self.pixels.right) * self.pixels.texture_size, axis=1)

    def looked_up(self, setting, scale=0.0):
        look = self.water.GetWaterProperty()
        getattr(look, f"Set{setting}")()
        look.SetOffsetScale(scale)
        return wave_scenes.looked_up(self.made, self.water)[self._counts]

    def reasons(self):
        """The kind (confidence.KINDS) that the module calls its lookup."""
        look = self.water.GetWaterProperty()
        look.SetOutputToConfidence()
        said = self.made.picture()[:, :, 0].ravel()[self._counts]
        look.SetOutputToColor()
        return said


def formula_errors(cases, formula, axes, scale):
    return np.concatenate(
        [case.errors(formula.place(case.pixels, case.pixels.normal @ axes.T, scale)) for case in cases])


def best_axes(cases, formula, scale):
    """The errors with the most favourable axes."""
    return min((formula_errors(cases, formula, axes, scale) for axes in axes_of(formula)), key=np.median)


def search(cases, formula):
    """The errors with the best constant, and that constant: on a grid, then on a finer one."""
    scales = np.geomspace(*formula.search, SEARCH_STEPS)
    for _ in range(2):
        found = [(np.median(best_axes(cases, formula, scale)), scale) for scale in scales]
        best = min(found)[1]
        step = scales[1] / scales[0]
        scales = np.geomspace(best / step, best * step, 21)
    return best_axes(cases, formula, best), best


def _row(name, errors):
    return (name, f"{np.median(errors):.3f}", f"{np.percentile(errors, 95):.2f}", f"{100 * (errors < 2).mean():.1f} %")


def _measure(slope, report):
    """The cases; rows of the table; curves: (name, errors, color, is published); and for each kind that
    the module names, its share of the pixels and that of its errors over 2 pixels."""
    cases = [Case(view, slope) for view in wave_scenes.ISLANDS_VIEWS]
    rows, curves = [], []
    for case in cases:
        case.looked_up("LookupToRayTraced")
    for i, quality in enumerate(QUALITIES):
        errors = np.concatenate(
            [case.errors(case.looked_up(f"RayTraceQualityTo{quality}")) for case in cases])
        name = f"ray traced, {quality.lower()}"
        rows.append(_row(f"**{name}**", errors))
        curves.append((name, errors, ("0.6", "0.0", "0.35")[i], False))
        if quality == "Default":
            traced = errors
            said = np.concatenate([case.reasons() for case in cases])
            shares = [[f"{100 * pixels.mean():.2f} %" for pixels in (said == number, (said == number) & (errors >= 2))]
                      for number in KINDS.values()]
    name = f"slope {slope:.2f}, ray traced, default:"
    report.check_at_least(f"{name} pixels counted", len(traced), 5000, 0)
    report.check_at_most(f"{name} median error, px", float(np.median(traced)), 0.1)
    if slope == 0.05:
        report.check_at_most(f"{name} 95 % of pixels within, px", float(np.percentile(traced, 95)), 0.5)
    report.check_at_least(f"{name} % of pixels under 2 px", 100 * float((traced < 2).mean()),
                          97 if slope == 0.05 else 96, 2)
    rows.append(_row("calm lookup", formula_errors(cases, FORMULAS[0], np.eye(3), 0)))
    for number, formula in enumerate(FORMULAS):
        errors, best = search(cases, formula)
        rows.append(_row(f"{formula.name}, best: s = {best:.3g}", errors))
        curves.append((formula.name, errors, f"C{number}", False))
        for who, scale in formula.published:
            errors = best_axes(cases, formula, scale)
            rows.append(_row(who, errors))
            curves.append((who, errors, f"C{number}", True))
        print(f"slope {slope:.2f}: {formula.name}, best s = {best:.3g}: median of "
              f"{float(np.median(curves[-1 - len(formula.published)][1])):.3f} px", flush=True)
    _check_formulas(cases, slope, report)
    return cases, rows, curves, shares


def _check_formulas(cases, slope, report):
    """The two formulas that the module has, too, say the same there."""
    for formula, setting, scale in ((FORMULAS[0], "FixedOffset", 0.3), (FORMULAS[3], "ViewScaledOffset", 3.0)):
        largest = 0.0
        for case in cases:
            here = formula.place(case.pixels, case.pixels.normal, scale)
            there = case.looked_up(f"LookupTo{setting}", scale)
            apart = np.linalg.norm((np.clip(here, 0, 1) - there) * case.pixels.texture_size, axis=1)
            largest = max(largest, float(apart.max()))
        report.check_at_most(f"slope {slope:.2f}, {formula.name}, report and module, px apart", largest, 0.1)


def _plot(all_curves):
    figure, axes = plt.subplots(1, len(SLOPES), figsize=(9, 4.6), sharey=True)
    share = np.linspace(0, 100, 401)
    for axis, slope in zip(axes, SLOPES):
        for name, errors, color, is_published in all_curves[slope]:
            axis.plot(np.percentile(errors, share), share, color=color, label=None if is_published else name,
                      linestyle="--" if is_published else "-", linewidth=0.8 if is_published else 1.5)
        axis.set(xscale="log", xlim=(0.01, 300), ylim=(0, 100), xlabel="lookup error, pixels",
                 title=f"rms slope {slope:.2f}")
    axes[0].set_ylabel("% of pixels")
    handles, names = axes[0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside lower center", ncols=3)
    return figure


def run(report):
    header = ["lookup"]
    tables, curves, shares = [], {}, {}
    for slope in SLOPES:
        cases, rows, curves[slope], shares[slope] = _measure(slope, report)
        header += [f"slope {slope:.2f}: median, px", "95 % within", "under 2 px"]
        tables.append(rows)
        hits, doubtful = (sum(getattr(case.tracer, f"{what}_count") for case in cases) for what in ("hit", "doubtful"))
        report.check_at_most(
            f"slope {slope:.2f}, tracer: % of hits off their triangle's plane", 100 * doubtful / hits, 0.1)
    rows = []
    for first, second in zip(*tables):
        name = first[0]
        if first[0] != second[0]:  # the best constant is another for every slope
            name = f"{first[0]} and {second[0].rsplit('= ', 1)[1]}"
        rows.append((name, *first[1:], *second[1:]))
    report.add(
        "Accuracy of the lookup", TEXT,
        triangles=cases[0].tracer.triangle_count, width=cases[0].pixels.size[0], height=cases[0].pixels.size[1],
        step=f"{cases[0].pixels.texture_size.max() / 4095:.2f}", table=table(header, rows),
        plot=report.save(_plot(curves), "lookup", "How many pixels are off by how much"),
        reasons=table(
            ("reason", *(title for slope in SLOPES for title in (f"slope {slope:.2f}: all", "off by 2 px or more"))),
            [(kind, *(cell for slope in SLOPES for cell in shares[slope][number]))
             for number, kind in enumerate(KINDS)]),
        formulas=table(("formula", "", "published constants"), [
            (formula.name, f"`{formula.text}`", "; ".join(who for who, _ in formula.published))
            for formula in FORMULAS]))

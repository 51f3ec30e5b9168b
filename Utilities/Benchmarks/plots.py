# SPDX-License-Identifier: BSD-3-Clause
"""plots: the benchmark's pictures: errors against time, time against what there is to draw."""

import kinds
import numpy as np
from report import plt

PARETO_TEXT = """*Solid line: the Pareto front. Small marks: the formulas of other programs, dark
with their best constant, light with published constants. Formulas that the
module does not have are shown at the time of the module's fixed offset, whose
shader costs at least as much. The ray tracer renders their pictures, so that
they lose no detail in a reflection texture.*"""
MARKERS = {1.0: "o", 0.5: "s", 0.25: "^"}


def _front(points):
    """Of (time, error) points those that no other beats in both."""
    best, front = np.inf, []
    for time, error in sorted(points):
        if error < best:
            best = error
            front.append((time, error))
    return front


def pareto(rows, classics):
    """rows: (step, scale, frame, row); classics: (formula, who, RMSE, FLIP, ratio)."""
    figure, axes = plt.subplots(1, 2, figsize=(10, 5.2))
    waves = [each for each in rows if each[0].has_waves]
    colors = {
        name: f"C{number}"
        for number, name in enumerate(dict.fromkeys(step.name for step, *_ in waves))
    }
    formulas = list(dict.fromkeys(name for name, *_ in classics))
    for axis, what, label in zip(axes, ("rmse", "flip"), ("RMSE of 255", "FLIP")):
        points = []
        for step, scale, _, row in waves:
            axis.plot(
                row["ratio"],
                row[what],
                MARKERS[scale],
                color=colors[step.name],
                markersize=8,
                label=step.name if scale == 1 else None,
            )
            points.append((row["ratio"], row[what]))
        for name, who, rmse, flip, ratio in classics:
            marker = "1234+x"[formulas.index(name) % 6]
            axis.plot(
                ratio,
                rmse if what == "rmse" else flip,
                marker,
                color="0.35" if who.startswith("best") else "0.65",
                markersize=7,
                label=name if who.startswith("best") else None,
            )
            points.append((ratio, rmse if what == "rmse" else flip))
        axis.plot(*zip(*_front(points)), color="0.2", linewidth=1, zorder=0)
        axis.set(xlabel="time of a frame / without water", ylabel=label, ylim=(0, None))
    for scale, marker in MARKERS.items():
        if any(other == scale for _, other, *_ in waves):
            axes[0].plot([], [], marker, color="0.6", label=f"texture scale {scale:g}")
    figure.legend(
        *axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=4, fontsize=8
    )
    return figure


def pictures(reference):
    """The truth, and the module's picture of it."""
    truth = reference.truth
    step = kinds.TRACED if reference.tracer else kinds.CALM
    step.apply(reference.scene.water, 1.0, reference.constants)
    shown = reference.scene.view.picture()
    apart = truth.flip_map(shown)
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.4))
    for axis, name, picture in zip(
        axes, ("reference", step.name, "FLIP (black: none)"), (truth.truth, shown, apart)
    ):
        is_map = picture.ndim == 2
        axis.imshow(
            picture if is_map else (picture / 255).clip(0, 1),
            origin="lower",
            interpolation="nearest",
            **({"cmap": "magma", "vmin": 0, "vmax": 0.8} if is_map else {}),
        )
        axis.set_title(name)
        axis.axis("off")
    return figure


def curves(series, xlabel, ylabel, is_log=False, limit=None):
    """series: name -> [(x, y, lower quartile, upper quartile)]."""
    figure, axis = plt.subplots(figsize=(6.4, 3.8))
    for number, (name, points) in enumerate(series.items()):
        x, y, low, high = np.array(sorted(points)).T
        axis.plot(x, y, "o-", color=f"C{number}", markersize=4, label=name)
        axis.fill_between(x, low, high, color=f"C{number}", alpha=0.15, linewidth=0)
    if is_log:
        axis.set(xscale="log", yscale="log")
    else:
        axis.set_ylim(0, None)
    if limit:
        axis.axhline(limit, color="0.5", linestyle="--", linewidth=1)
    axis.set(xlabel=xlabel, ylabel=ylabel)
    axis.legend()
    return figure

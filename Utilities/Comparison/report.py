# SPDX-License-Identifier: BSD-3-Clause
"""report: ratios out of times; as data, table, plot, sheet of pictures, and text."""

import csv
import json
import os
import pathlib
import platform
import string

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  after the choice of its backend
import numpy as np  # noqa: E402

plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "axes.spines.top": False,
                     "axes.spines.right": False, "figure.constrained_layout.use": True})

CASES = {"moving": "camera moving", "static": "nothing changing", "away": "water out of view"}
LABELS = {
    ("vtk-water", "calm"): "this project, calm",
    ("vtk-water", "calm-half"): "this project, calm, texture scale 1/2",
    ("vtk-water", "waves"): "this project, waves, ray traced",
    ("vtk-water", "waves-half"): "this project, waves, texture scale 1/2",
    ("vtk-copies", "copies"): "VTK, mirrored copy under a sheet",
    ("f3d", "grid"): "F3D, reflecting grid",
    ("three", "reflector"): "three.js Reflector",
    ("three", "reflector-half"): "three.js Reflector, texture scale 1/2",
    ("three", "water"): "three.js Water",
    ("three", "water-half"): "three.js Water, texture scale 1/2",
    ("osg", "mirror"): "OpenSceneGraph, mirrored camera",
    ("osg", "mirror-half"): "OpenSceneGraph, texture scale 1/2",
}
PLAIN = "plain"
RESAMPLES = 2000
SEED = 20261121


def table(header, rows):
    """A table in Markdown; numbers are to be formatted already."""
    lines = ["| " + " | ".join(cells) + " |" for cells in (header, *rows)]
    return "\n".join([lines[0], "|---" * len(header) + "|", *lines[1:]])


def machine():
    """The processor as it calls itself, cores, system."""
    try:
        lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines()
        line = next(line for line in lines if line.startswith("model name"))
        model = line.split(":", 1)[1].strip()
    except (OSError, StopIteration):
        model = platform.processor() or platform.machine()
    try:
        system = platform.freedesktop_os_release()["PRETTY_NAME"]
    except OSError:
        system = platform.system()
    return {"processor": model, "cores": os.cpu_count(), "system": system}


class Ratio:
    """Median with water over median without, and 95 % of what resampled turns give."""

    def __init__(self, watery, plain):
        watery, plain = np.asarray(watery), np.asarray(plain)
        self.value = float(np.median(watery) / np.median(plain))
        turns = np.random.default_rng(SEED).integers(0, len(plain), (RESAMPLES, len(plain)))
        ratios = np.median(watery[turns], axis=1) / np.median(plain[turns], axis=1)
        self.low, self.high = map(float, np.percentile(ratios, (2.5, 97.5)))

    def __str__(self):
        return f"**{self.value:.2f}** ({self.low:.2f} to {self.high:.2f})"


class Report:
    def __init__(self, scene, about, left_out, rows):
        self._scene, self._about, self._left_out, self._rows = scene, about, left_out, rows
        self._machine = machine()
        self._times = {}
        for _, _, case, peer, variant, took in rows:
            self._times.setdefault((case, peer, variant), []).append(took)
        self._watery = [(peer, variant) for peer, what in about.items()
                        for variant in what["variants"] if variant != PLAIN]
        self._ratios = {
            (case, *key): Ratio(self._times[case, *key], self._times[case, key[0], PLAIN])
            for case in CASES for key in self._watery}

    def write_data(self, folder):
        """compare.csv: every frame; compare.json: the rest."""
        with open(folder / "compare.csv", "w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(("block", "turn", "case", "peer", "variant", "ms"))
            writer.writerows(self._rows)
        medians = [{"case": case, "peer": peer, "variant": variant, "frames": len(times),
                    "median_ms": float(np.median(times))}
                   for (case, peer, variant), times in sorted(self._times.items())]
        ratios = [{"case": case, "peer": peer, "variant": variant, **vars(ratio)}
                  for (case, peer, variant), ratio in self._ratios.items()]
        (folder / "compare.json").write_text(json.dumps(
            {"machine": self._machine, "peers": self._about, "left_out": self._left_out,
             "medians": medians, "ratios": ratios}, indent=1) + "\n")

    def write_text(self, folder, pictures):
        """comparison.md, and images/comparison-* beside it."""
        images = folder / "images"
        images.mkdir(parents=True, exist_ok=True)
        self._plot(images / "comparison-ratios.png")
        self._sheet(images / "comparison-pictures.jpg", pictures)
        left_out = [f"- {peer}: {why}" for peer, why in self._left_out.items()]
        frame = string.Template((pathlib.Path(__file__).parent / "comparison.md.in").read_text())
        text = frame.substitute(
            ratios=self._ratio_table(), programs=self._program_table(),
            left_out="\n".join(left_out) or "None: every peer ran.",
            triangles=f"{len(self._scene.triangles):,}",
            frames=min((len(times) for times in self._times.values()), default=0), **self._machine)
        path = folder / "comparison.md"
        path.write_text(text.rstrip() + "\n")
        print(f"the report: {path}")

    def _ratio_table(self):
        rows = [(_label(*key), *(str(self._ratios[case, *key]) for case in CASES))
                for key in self._watery]
        for row in rows:
            print("; ".join(row).replace("**", ""), flush=True)
        return table(("frame with water / without", *CASES.values()), rows)

    def _program_table(self):
        rows = []
        for peer, what in self._about.items():
            plain = (f"{np.median(self._times[case, peer, PLAIN]):.0f}" for case in CASES)
            rows.append((peer, what["program"], what["renderer"], *plain))
        return table(("peer", "program", "OpenGL renderer",
                      *(f"without water, ms: {title}" for title in CASES.values())), rows)

    def _plot(self, file):
        size = (10, 1.2 + 0.28 * len(self._watery))
        figure, axes = plt.subplots(1, len(CASES), figsize=size, sharex=True, sharey=True)
        places = np.arange(len(self._watery))
        for axis, (case, title) in zip(axes, CASES.items()):
            ratios = [self._ratios[case, *key] for key in self._watery]
            values = np.array([ratio.value for ratio in ratios])
            spread = np.abs([[ratio.value - ratio.low for ratio in ratios],
                             [ratio.high - ratio.value for ratio in ratios]])
            colors = ["C0" if peer == "vtk-water" else "0.65" for peer, _ in self._watery]
            axis.barh(places, values, xerr=spread, color=colors, error_kw={"linewidth": 0.8})
            axis.axvline(1.0, color="0.2", linewidth=0.8)
            axis.set(title=title, xlabel="frame with water / without")
            axis.grid(False, axis="y")
        axes[0].set_yticks(places, [_label(*key) for key in self._watery])
        axes[0].invert_yaxis()
        figure.savefig(file, dpi=110, metadata={"Software": None})
        plt.close(figure)

    def _sheet(self, file, pictures):
        """Every variant's picture, a row a peer, first the one without water."""
        columns = max((len(what["variants"]) for what in self._about.values()), default=1)
        count = max(len(self._about), 1)
        size = (3 * columns, 2.5 * count)
        figure, axes = plt.subplots(count, columns, figsize=size, squeeze=False)
        for axis in axes.flat:
            axis.axis("off")
        for row, (peer, what) in zip(axes, self._about.items()):
            for axis, variant in zip(row, what["variants"]):
                axis.imshow(plt.imread(pictures / f"{peer}-{variant}.png"))
                axis.set_title(_label(peer, variant), fontsize=8)
        figure.savefig(file, dpi=100, pil_kwargs={"quality": 85})
        plt.close(figure)


def _label(peer, variant):
    if variant == PLAIN:
        return f"{peer}, without water"
    return LABELS.get((peer, variant), f"{peer} {variant}")

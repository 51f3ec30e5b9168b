# SPDX-License-Identifier: BSD-3-Clause
"""report: figures with their limits, tables and plots, and the text they make."""

import pathlib
import string

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  after the choice of its backend
from driver import driver  # noqa: E402
from tables import FIGURES, figures_in, table  # noqa: E402
from vtkmodules.vtkCommonCore import vtkVersion  # noqa: E402

plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "axes.spines.top": False,
                     "axes.spines.right": False, "legend.frameon": False, "figure.constrained_layout.use": True})


class Report:
    """Collects the sections. The template is NAME.md.in; folder gets NAME.md, and images/NAME-*."""

    FAILED = "NOT MET"

    def __init__(self, folder, template=pathlib.Path(__file__).parent / "accuracy.md.in"):
        self._folder, self._template = folder, template
        self._name = template.name.split(".")[0]
        self._sections, self._checks = [], []
        (folder / "images").mkdir(parents=True, exist_ok=True)

    def check_at_most(self, name, value, limit, digits=3):
        self._check(name, value, f"<= {limit:g}", value <= limit, digits)

    def check_at_least(self, name, value, limit, digits=3):
        self._check(name, value, f">= {limit:g}", value >= limit, digits)

    def _check(self, name, value, limit, holds, digits):
        verdict = "ok" if holds else self.FAILED
        self._checks.append((name, f"{value:.{digits}f}", limit, verdict))
        print(f"{name}: {value:.{digits}f} (limit {limit}) {verdict}", flush=True)

    def has_failed(self):
        return any(verdict == self.FAILED for *_, verdict in self._checks)

    @staticmethod
    def rows_of(pictures, titles, size):
        """A figure of pictures one below the other, bottom row first, each of so many inches."""
        figure, axes = plt.subplots(len(pictures), 1, figsize=(size[0], size[1] * len(pictures)), squeeze=False)
        for axis, picture, title in zip(axes[:, 0], pictures, titles):
            axis.imshow(picture, origin="lower", interpolation="nearest")
            axis.set_title(title)
            axis.axis("off")
        return figure

    def save(self, figure, name, alt, has_pictures=False):
        """Saves a plot, or one with pictures in it; returns the Markdown that shows it."""
        path = pathlib.Path("images") / f"{self._name}-{name}.{'jpg' if has_pictures else 'png'}"
        how = {"pil_kwargs": {"quality": 85}} if has_pictures else {"metadata": {"Software": None}}
        figure.savefig(self._folder / path, dpi=110, **how)
        plt.close(figure)
        return f"![{alt}]({path})"

    def add(self, title, text, **values):
        """A section: prose with $name where a value goes."""
        self._sections.append(f"## {title}\n" + string.Template(text).substitute(values).strip())

    def write(self, **values):
        """Fills the template in; values: what it wants beside the following."""
        frame = string.Template(self._template.read_text())
        path = self._folder / f"{self._name}.md"
        former = path.read_text() if path.exists() else ""
        text = frame.substitute(
            checks=table(("figure", "value", "limit", ""), self._checks),
            vtk=vtkVersion.GetVTKVersion(),
            driver=driver(),
            sections="\n\n".join(self._sections),
            figures="\n".join((FIGURES[0], figures_in(former), FIGURES[1])),
            **values,
        )
        path.write_text(text.rstrip() + "\n")
        print(f"the report: {path}")

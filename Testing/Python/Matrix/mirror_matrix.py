# SPDX-License-Identifier: BSD-3-Clause
"""mirror_matrix: what the cells of Documentation/mirror-matrix.md share.

A cell is a function that fills a scene. It is rendered through calm water of reflectance 1, and
without any of our code, in two steps:

1. the mirrored picture: VTK's own camera, mirrored at the plane, looks at the same scene, whose mappers
   cut it with a clipping plane of VTK's, under the lights where the user's camera has put them; the
   picture is turned left to right;
2. the composed picture: the same scene with an ordinary sheet in the water's place, which shows the
   mirrored picture pixel by pixel. What stands before, over or behind the water is so composed by VTK.

The water's pixels of the two must be the same, and all others those of the scene without water. The same
two steps with what a cell is about taken out (its base) must give another picture: a cell that cannot
fail proves nothing. Of two VTKs that are tested together one shows that.

A file of cells registers them in its Results, and has one test for all, which has a case for each of them:

    row = mm.Results("View", __file__)
    row.cell("parallel projection", fill)     a scene
    row.register("two levels", several, ...)  a function that renders by itself, and makes cells by compare and say
    @row.makes("picking")                     the same, where it is written for this name alone
    test_cell = row.test()

A case is named by its cell, in small letters and underscores: -k parallel_projection runs one. The row is written
for the table when all of its cells have run.
"""

import functools
import inspect
import json
import os
import pathlib
import re

import numpy as np
import pytest
import water_test as wt
from mirror_scene import (  # noqa: F401  for the tests, too
    COMPOSED,
    MIRRORED,
    SEEN,
    SHEET,
    SIZE,
    UP,
    Scene,
    add_sheet,
    axes_of,
    composed_picture,
    image_of,
    matrix_of,
    mirror,
    mirrored_picture,
    water_pixels,
)
from vtkmodules.vtkCommonCore import vtkVersion

EXACT_PERCENT = 0.05  # of the water's pixels may be off by more than 1/255
LARGEST_RMSE = 1.0  # of 255, of a cell that says why it is not exact
VTK_VERSION = tuple(int(x) for x in re.findall(r"\d+", vtkVersion.GetVTKVersion())[:2])
REFLECTED, UNREFLECTED, BEHIND = "reflected", "unreflected", "behind"
HAS_CONTROLS = os.environ.get("WATER_TESTS_ONCE") != "0"
ALONE, BESIDE, FILTERED = "alone", "beside", "filtered"


class Results:
    """The cells of one row of the table: registered, then rendered, checked, printed, and written for the table."""

    def __init__(self, row, file):
        """file: that of the test, for which the results are named."""
        self.row = row
        self.window = os.environ.get("VTK_DEFAULT_OPENGL_WINDOW", "vtkWaterEGLRenderWindow")
        self.name = pathlib.Path(file).stem
        self.makers = {}  # name: function that makes the cells of this name
        self.made = {}  # name: what it made
        self.cells = []  # of the name that is being made

    def register(self, name, make, *arguments, **options):
        """Registers a function that is called as make(name, ...) and makes cells with show, compare, say and note.

        The name is that of its cell, or what the names of its cells have in common.
        """
        assert file_name(name) not in map(file_name, self.makers), f"two cells are named {name}"
        self.makers[name] = functools.partial(make, name, *arguments, **options)

    def makes(self, name):
        """Registers the function after it, which takes no arguments, in the same way."""

        def remember(make):
            self.register(name, lambda _: make())
            return make

        return remember

    def cell(self, name, *arguments, **options):
        """Registers one cell; arguments as those of show."""
        self.register(name, self.show, *arguments, **options)

    def test(self):
        """The test of all cells registered so far, with a case for each name."""

        @pytest.mark.parametrize("name", list(self.makers), ids=file_name)
        def test_cell(name):
            """What the water shows is what the mirrored scene is, or the cell says why not."""
            self.make(name)

        return test_cell

    def make(self, name):
        """Makes the cells of a name; with the last of all names, writes the row."""
        self.cells = []
        self.makers[name]()
        self.made[name] = self.cells
        if len(self.made) == len(self.makers):
            self.write()

    def folder(self):
        """Where the row and its pictures go."""
        folder = wt.output_folder() / "mirror-matrix" / self.window / self.name
        folder.mkdir(parents=True, exist_ok=True)
        return folder

    def write(self):
        """Writes the row for the table, in the order in which the cells were registered."""
        cells = [cell for name in self.makers for cell in self.made[name]]
        result = dict(row=self.row, vtk=vtkVersion.GetVTKVersion(), window=self.window, cells=cells)
        (self.folder() / "cells.json").write_text(json.dumps(result, indent=1))

    def add(self, name, pixels, percent, rmse, outside, control=None, reason=None, exact=True, wrong=False):
        """Remembers a cell and checks its figures; those of inexact cells only against LARGEST_RMSE.

        wrong: what is shown is known to be wrong, as the reason says; the cell fails once it is right.
        """
        wt.check_at_least(f"{name}: water pixels", pixels, 300)
        if wrong:
            assert reason
            print(f"{name}: known to be wrong: {reason}")
            wt.check_at_least(f"{name}: % of water pixels off by more than 1/255", round(percent, 4), EXACT_PERCENT)
            reason = f"**Wrong:** {reason}"
        elif exact:
            wt.check_at_most(f"{name}: % of water pixels off by more than 1/255", round(percent, 4), EXACT_PERCENT)
        else:
            print(f"{name}: {percent:.3f} % of water pixels off by more than 1/255, because: {reason}")
            wt.check_at_most(f"{name}: RMSE of 255", round(rmse, 4), LARGEST_RMSE)
        if not wrong:
            wt.check_equal(f"{name}: other pixels off by more than 1/255", outside, 0)
        if control is not None:
            wt.check_at_least(f"{name}: % of water pixels that it changes", round(control, 3), 0.5)
        self.cells.append(dict(cell=name, percent=percent, rmse=rmse, outside=outside, control=control,
                               reason=reason, exact=exact))

    def say(self, name, holds, reason=None):
        """A cell that is true or false."""
        wt.check_equal(name, bool(holds), True)
        self.cells.append(dict(cell=name, holds=bool(holds), reason=reason, exact=True))

    def note(self, name, reason):
        """A cell that this VTK cannot show; the reason is printed."""
        print(f"{name}: left out: {reason}", flush=True)
        self.cells.append(dict(cell=name, holds=None, reason=reason, exact=True))

    def compare(self, name, seen, expected, without, water, control=None, reason=None, exact=True, wrong=False):
        """Adds a cell by its pictures; water: which pixels show some of it."""
        error = np.abs(seen - expected)[water]
        changed = None
        if control is not None:
            changed = 100.0 * float((np.abs(control - expected)[water].max(axis=1) > 1).mean())
        percent = 100.0 * float((error.max(axis=1) > 1).mean()) if len(error) else 100.0
        rmse = float(np.sqrt((error.astype(float) ** 2).mean())) if len(error) else 255.0
        outside = 0 if without is None else int((np.abs(seen - without).max(axis=2) > 1)[~water].sum())
        self.add(name, int(water.sum()), percent, rmse, outside, changed, reason, exact, wrong)
        wt.save(seen, self.folder() / f"{file_name(name)}_water.png")
        wt.save(expected, self.folder() / f"{file_name(name)}_truth.png")

    def show(self, name, fill, truth=None, reason=None, exact=True, bounds=SHEET, prepare=None,
             control=REFLECTED, opacity=1.0, others=ALONE, wrong=False, **options):
        """Makes one cell of a scene.

        fill     fills a Scene; called as fill(scene), or as fill(scene, True) and, for the control, as
                 fill(scene, False) without what the cell is about. Without the second argument the
                 control is the empty scene.
        truth    fills the mirrored and the composed picture, where that needs other means; None: fill
        prepare  (scene, water), called before the water is seen for the first time
        control  what the control differs in: REFLECTED, what the cell is about is not in the mirrored
                 picture; UNREFLECTED, it is, and must not be; BEHIND, it is not seen through the water
        opacity  of the water
        others   what pixels beside the water are compared with: ALONE, without water; BESIDE, with an
                 ordinary sheet, where any sheet changes them; FILTERED, with the composed picture, where a
                 filter mixes them with the water's
        wrong    what is shown is known to be wrong, as the reason says
        options  of Scene: size, background, samples, origin, normal
        """
        base = (lambda scene: fill(scene, False)) if takes_two(fill) else without_props(fill)
        full = (lambda scene: fill(scene, True)) if takes_two(fill) else fill
        scene = Scene(SEEN, **options)
        full(scene)
        water = wt.add_water(scene.renderer, wt.plane(scene.origin, scene.normal), bounds)
        water.GetWaterProperty().SetOpacity(opacity)
        if prepare:
            prepare(scene, water)
        errors = wt.errors_of(water)
        seen = scene.pixels()
        if errors:
            wt.check_equal(f"{name}: errors", errors, [])
        pixels = water_pixels(scene, water)
        water.VisibilityOff()
        without = scene.pixels()
        truth = truth or full
        composed = base if control is BEHIND else truth
        mirrored, other = (base, truth) if control is UNREFLECTED else (truth, base)
        expected = composed_picture(truth, mirrored_picture(mirrored, **options), bounds, opacity, **options)
        control_picture = None
        if HAS_CONTROLS:
            control_picture = composed_picture(composed, mirrored_picture(other, **options), bounds, opacity, **options)
        if others is BESIDE:
            without = composed_picture(truth, None, bounds, opacity, **options)
        elif others is FILTERED:
            without = expected
        self.compare(name, seen, expected, without, pixels, control_picture, reason, exact, wrong)

    def show_picture(self, name, fill, mirrored, reason=None, exact=True, bounds=SHEET, prepare=None, **options):
        """Makes a cell whose mirrored picture is known; its control is that of the scene's plain background."""

        def plain(scene):
            fill(scene)
            scene.renderer.GradientBackgroundOff()

        scene = Scene(SEEN, **options)
        fill(scene)
        water = wt.add_water(scene.renderer, wt.plane(scene.origin, scene.normal), bounds)
        if prepare:
            prepare(scene, water)
        seen = scene.pixels()
        pixels = water_pixels(scene, water)
        water.VisibilityOff()
        without = scene.pixels()
        wrong = composed_picture(fill, mirrored_picture(plain, **options), bounds, **options) if HAS_CONTROLS else None
        expected = composed_picture(fill, mirrored, bounds, **options)
        self.compare(name, seen, expected, without, pixels, wrong, reason, exact)


def file_name(name):
    """A cell's name in small letters and underscores."""
    return re.sub(r"[^a-z0-9]+", "_", name.lower()).strip("_")


def takes_two(fill):
    """Does a fill take whether what the cell is about is on?"""
    return "on" in inspect.signature(fill).parameters


def without_props(fill):
    """A fill that takes a fill's camera and background, and no props."""

    def empty(scene):
        fill(scene)
        scene.renderer.RemoveAllViewProps()

    return empty

# SPDX-License-Identifier: BSD-3-Clause
"""A gallery picture that shows something else than the kept one is found, and noise is not. Whether each example makes
its kept picture is a test of its own, ExampleGallery_NAME."""

import os
import pathlib
import re
import sys

import numpy as np
import pytest
import water_test as wt
from dark_water import SIZE, add_dark_water, look_at
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "Utilities/Scripts"), str(ROOT / "Examples/Python")]

import clipped  # noqa: E402
import compare_pictures  # noqa: E402
import cove  # noqa: E402
import gallery  # noqa: E402


def cove_with(monkeypatch, tmp_path, change):
    """The example's picture, its water's look changed."""
    make_water = cove.make_water

    def make_other_water(time):
        water = make_water(time)
        change(water.GetWaterProperty())
        return water

    picture = tmp_path / "cove.png"
    monkeypatch.setattr(cove, "make_water", make_other_water)
    monkeypatch.setattr(sys, "argv", ["cove.py", str(picture), "1"])
    cove.main()
    return picture


def test_changed_water_is_found(monkeypatch, tmp_path):
    """Foam that is missing along the shore, in few of the blocks, is found."""
    picture = cove_with(monkeypatch, tmp_path, lambda look: look.SetFoamDepth(0.0))
    wt.check_equal("no foam: same", compare_pictures.check(picture, gallery.kept("cove")), False)


def test_noise_and_edges_do_not_count():
    """Noise of a few levels, and a picture that is a fraction of a pixel off, are the same picture."""
    kept = compare_pictures.read(gallery.kept("cove"))
    noise = np.random.default_rng(1).normal(0.0, 8.0, kept.shape)
    for name, other in (("noise", kept + noise), ("a third of a pixel", (2 * kept + np.roll(kept, 1, axis=1)) / 3)):
        mean, worst = compare_pictures.difference(other, kept)
        wt.check_at_most(f"{name}: mean difference", mean, compare_pictures.MEAN_LIMIT)
        wt.check_at_most(f"{name}: difference of the worst blocks", worst, compare_pictures.WORST_LIMIT)


def test_other_sizes_and_no_pictures_are_told(tmp_path):
    """A picture of another size is another one; a file that is none is an error that names it."""
    kept = compare_pictures.read(gallery.kept("cove"))
    wt.check_equal("another size", compare_pictures.difference(kept[1:], kept), (np.inf, np.inf))
    with pytest.raises(ValueError, match="missing.png: no such file"):
        compare_pictures.read(tmp_path / "missing.png")
    wt.check_equal("exit code", compare_pictures.main([str(tmp_path / "missing.png"), str(gallery.kept("cove"))]), 2)


def test_every_picture_of_the_gallery_is_compared():
    """Each picture of the gallery's page has an example here, and each example a test."""
    page = (ROOT / "Documentation/gallery.md").read_text()
    shown = set(re.findall(r"\(images/(\w+)[.](?:jpg|png)\)", page))
    tests = (ROOT / "Examples/CMakeLists.txt").read_text()
    tested = set(" ".join(re.findall(r"add_gallery_tests\(([a-z_\s]+)\)", tests)).split())
    wt.check_equal("pictures without an example", sorted(shown - set(gallery.EXAMPLES)), [])
    wt.check_equal("examples without a test", sorted(set(gallery.EXAMPLES) - tested), [])
    missing = [name for name in gallery.EXAMPLES if not gallery.kept(name).exists()]
    wt.check_equal("examples without a kept picture", missing, [])


def test_a_slow_example_is_found():
    """An example is too slow if it keeps the processor busy over the limit; waiting for other programs does not count."""
    limit = gallery.LIMIT_S
    wt.check_equal("slow", gallery.is_in_time("slow", limit + 2, limit + 1), False)
    wt.check_equal("on a busy machine", gallery.is_in_time("waits", limit + 9, limit - 1), True)
    wt.check_equal("on two cores", gallery.is_in_time("two", limit - 1, limit + 9), True)


def test_burnt_glitter_is_found(tmp_path):
    """Glitter that no longer rolls off is clipped, and so is counted; so is a slab as bright as the roll-off ends, however
    far below 255. White water without glitter is not counted. Light that the roll-off takes is counted, too."""
    view = wt.View(SIZE, (0, 0, 0))
    wt.add_scene_light(view.renderer, (0.3, 0.6, 0.55))
    view.renderer.GetLights().GetItemAsObject(0).SetIntensity(1.5)
    look = add_dark_water(view).GetWaterProperty()
    look.SetSlopeVariance(0.003, 0.003)
    look_at(view, (1, -10, 6), angle=60)
    for rolls, glitters, intensity in ((True, True, 1.5), (True, True, 1000), (False, True, 1.5), (False, False, 1.5)):
        view.renderer.GetLights().GetItemAsObject(0).SetIntensity(intensity)
        look.SetHighlightRollOff(rolls)
        look.SetGlitter(glitters)
        view.picture()
        water, _, burnt, kept = clipped.measure(view.window, vtkWindowToImageFilter)
        name = f"rolls off: {rolls}, glitter: {glitters}, sun of {intensity:g}"
        wt.check_equal(f"{name}: settings as before", (look.GetGlitter(), look.GetOutput(), look.GetHighlightRollOff()), (glitters, look.COLOR, rolls))
        wt.check_at_least(f"{name}: light that is kept, %", kept, clipped.LEAST_KEPT)
        wt.check_equal(f"{name}: light is taken", kept < 99.0, rolls and glitters)
        if glitters:
            wt.check_at_least(f"{name}: pixels of water", water, 1000)
        measured = tmp_path / "clipped.txt"
        measured.write_text(f"{water} {burnt} {burnt} 95.0 0.5")
        wt.check_equal(f"{name}: is too much", clipped.share(name, measured)[0] > clipped.LIMIT, glitters and not (rolls and intensity < 10))
        if rolls and intensity > 10:
            wt.check_at_most(f"{name}: brightest", int(view.picture().max()), 254)  # nothing is white, and yet all is flat
    measured.write_text("1000 0 0 94.9 0.5")
    wt.check_equal("too little light kept", clipped.share("dark", measured), (100.0, 0.5))
    wt.check_equal("nothing measured", clipped.share("none", tmp_path / "none.txt"), (100.0, 0.0))


def test_an_example_is_measured(tmp_path):
    """The picture that an example writes is measured while it is made, and what it sees of Python is as before."""
    paths = os.environ.get("PYTHONPATH")
    with clipped.watching() as measured:
        gallery.render("first_water", tmp_path)
        counts = [float(word) for word in measured.read_text().split()]
    wt.check_equal("PYTHONPATH afterwards", os.environ.get("PYTHONPATH"), paths)
    wt.check_at_least("pixels of water", counts[0], 50000)
    wt.check_at_most("pixels that are white", counts[1], 0)

# SPDX-License-Identifier: BSD-3-Clause
"""A gallery picture that shows something else than the kept one is found, and noise is not. Whether each example makes
its kept picture is a test of its own, ExampleGallery_NAME."""

import pathlib
import re
import sys

import numpy as np
import pytest
import water_test as wt

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "Utilities/Scripts"), str(ROOT / "Examples/Python")]

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

# SPDX-License-Identifier: BSD-3-Clause
"""Every recipe, and the code in README, runs as pasted: it ends well, and writes the picture that is shown with it.

The pictures are compared with those of the documentation, made smaller: a recipe that shows something else than its
page fails.
"""

import dataclasses
import re
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Utilities/Site"))
import recipes  # noqa: E402

try:
    import pyvista  # noqa: F401
    from PIL import Image
except ImportError as error:
    reason = f"{error}; Testing/Python/requirements.txt says what to install"
    print(f"skipped: {reason}")
    pytest.skip(reason, allow_module_level=True)

RECIPES = recipes.read(ROOT / "Documentation/recipes.md")
README = recipes.read(ROOT / "README.md")
SMALL = (48, 27)
MOST_RMSE = 3.0  # of 255, on small pictures: JPEG makes 0.6
FEWER = "--size 160x100 --frames 2"  # of a movie: the pictures are TestWaterCommand's


def small(path):
    with Image.open(path) as picture:
        return np.asarray(picture.convert("RGB").resize(SMALL, Image.Resampling.BOX), dtype=float)


@pytest.mark.parametrize("recipe", RECIPES, ids=lambda recipe: recipe.title.replace(" ", "_"))
def test_a_recipe_makes_its_picture(recipe, tmp_path):
    print(recipes.run(recipe, tmp_path))
    for name in recipe.pictures:
        assert f"{name}.png" in recipe.code
        shown = small(ROOT / f"Documentation/images/{name}.jpg")
        rmse = np.sqrt(np.mean((small(tmp_path / f"{name}.png") - shown) ** 2))
        print(f"{name}: RMSE {rmse:.2f}")
        assert rmse < MOST_RMSE, f"{name}: render it anew with Utilities/Scripts/gallery.py {name}, and look at it"


def test_almost_every_recipe_has_a_picture_of_its_own():
    pictures = [name for recipe in RECIPES for name in recipe.pictures]
    assert len(RECIPES) >= 11 and len(pictures) >= len(RECIPES) - 1
    assert len(set(pictures)) == len(pictures)


@pytest.mark.parametrize("recipe", [recipe for recipe in README if recipe.language == "python"],
                         ids=lambda recipe: recipe.title)
def test_python_of_the_readme_runs(recipe, tmp_path):
    if recipe.title == "Python":  # its text says so
        recipe = dataclasses.replace(recipe, code="from vtkmodules.all import *\n" + recipe.code)
    recipes.run(recipe, tmp_path)


def test_commands_of_the_readme_run(tmp_path):
    commands = [line for recipe in README for line in recipe.code.splitlines() if line.startswith("vtkwater ")]
    assert len(commands) >= 3
    for line in commands:
        line = re.sub(r"\s+#.*", "", line)
        if line.startswith("vtkwater animate"):
            line = f"{line} {FEWER}"
        print(recipes.run(recipes.Recipe("", "sh", line, ()), tmp_path))
    assert (tmp_path / "lake.png").stat().st_size > 100000 and (tmp_path / "flood.gif").exists()

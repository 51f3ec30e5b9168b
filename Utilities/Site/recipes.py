# SPDX-License-Identifier: BSD-3-Clause
"""The programs of a Markdown page, and how they are run: as a reader would who pastes them."""
import os
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Recipe:
    """A section of level 2: its program, and the pictures that the section shows."""

    title: str
    language: str  # python or sh
    code: str
    pictures: tuple  # names of files in Documentation/images, without suffix


def read(page):
    """All programs of a page. Sections without one are left out."""
    found = []
    for section in re.split(r"^## ", Path(page).read_text(), flags=re.MULTILINE)[1:]:
        for language, code in re.findall(r"^```(python|sh)\n(.*?)^```", section, flags=re.MULTILINE | re.DOTALL):
            pictures = tuple(re.findall(r"\(images/(recipe_\w+)\.jpg\)", section))
            found.append(Recipe(section.partition("\n")[0], language, code, pictures))
    return found


def run(recipe, folder):
    """Run a program in a folder that has the project's examples, without windows. Returns its output and errors.

    Raises subprocess.CalledProcessError if it fails.
    """
    if not (folder / "Examples").exists():
        (folder / "Examples").symlink_to(ROOT / "Examples")
    tools = folder / "tools"
    tools.mkdir(exist_ok=True)
    command = tools / "vtkwater"
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m vtkwater "$@"\n')
    command.chmod(0o755)
    environment = dict(os.environ, PYVISTA_OFF_SCREEN="true", PATH=f"{tools}:{os.environ['PATH']}")
    program = [sys.executable, "-c"] if recipe.language == "python" else ["sh", "-e", "-c"]
    done = subprocess.run([*program, recipe.code], cwd=folder, env=environment, text=True, check=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return done.stdout

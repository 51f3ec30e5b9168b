# SPDX-License-Identifier: BSD-3-Clause
"""Every example says how it is used, and says in a line what is wrong with its file, its folder or its numbers.

All run in one process: to start Python and VTK takes longer than what is tested.
"""

import pathlib
import runpy
import sys

import pytest

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "Examples/Python"
OF_PYVISTA = ("pyvista_water", "strait")  # they import it before all else
SCRIPTS = sorted(file.stem for file in FOLDER.glob("*.py") if file.stem not in OF_PYVISTA)
ELEVATION = FOLDER.parent / "Data/jacksboro.vti"
NO_IMAGE = FOLDER.parent / "CMakeLists.txt"
OTHER_USE = ("batch", "breakwater", "flood", "lake", "lakes", "rain_flood", "tide")  # they refuse a folder in other ways


def run(name, arguments, monkeypatch, capfd, folder):
    """Runs a script as a program of its own would be; returns its exit code and what it said."""
    monkeypatch.chdir(folder)
    monkeypatch.setattr(sys, "argv", [f"{name}.py", *arguments])
    monkeypatch.syspath_prepend(str(FOLDER))
    with pytest.raises(SystemExit) as ended:
        runpy.run_path(str(FOLDER / f"{name}.py"), run_name="__main__")
    code = ended.value.code
    if isinstance(code, str):  # Python prints it, and ends with 1
        print(code)
        code = 1
    said = "".join(capfd.readouterr())
    print(said)
    return code or 0, said


@pytest.mark.parametrize("name", SCRIPTS)
def test_help_is_printed(name, monkeypatch, capfd, tmp_path):
    """--help prints the usage, ends well, and is no file's name."""
    code, said = run(name, ["--help"], monkeypatch, capfd, tmp_path)
    assert code == 0 and "usage:" in said
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", [name for name in SCRIPTS if name not in OTHER_USE])
def test_a_folder_that_does_not_exist_is_refused(name, monkeypatch, capfd, tmp_path):
    """A picture that cannot be written is an error before anything is rendered."""
    code, said = run(name, [str(tmp_path / "no_such_folder/picture.png")], monkeypatch, capfd, tmp_path)
    assert code in (1, 2) and "no such folder" in said


@pytest.mark.parametrize("name, arguments, text", (
    ("lake", ["missing.vti", "."], "no such file"),
    ("lake", [".", "."], "is a folder"),
    ("lake", [NO_IMAGE, "."], "not a VTK image"),
    ("lake", [ELEVATION, ".", "5000"], "outside the terrain"),
    ("flood", ["missing.vti"], "no such file"),
    ("flood", ["."], "is a folder"),
    ("flood", ["--level", "5000"], "outside of the terrain"),
    ("batch", ["--out", "none", NO_IMAGE], "CMakeLists.txt: unknown file type .txt"),
    ("first_water", ["first_water.jpg"], "ends with .png"),
), ids=lambda value: value if isinstance(value, str) else "")
def test_what_is_wrong_is_said(name, arguments, text, monkeypatch, capfd, tmp_path):
    """A file that is missing, a folder or of another kind, a level outside the terrain, a picture that is no PNG."""
    code, said = run(name, map(str, arguments), monkeypatch, capfd, tmp_path)
    assert code in (1, 2) and text in said

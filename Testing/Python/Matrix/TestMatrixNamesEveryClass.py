# SPDX-License-Identifier: BSD-3-Clause
"""Every prop, mapper and pass of this VTK stands in class_cells.tsv, with the cells of the mirror matrix that draw it
or the reason why none does; and what the table says is so."""

import importlib
import pathlib

import pytest
import vtk_classes
from mirror_matrix import VTK_VERSION, file_name

FOLDER = pathlib.Path(__file__).parent
VERSION = ".".join(map(str, VTK_VERSION))
KINDS = ("cell", "made by", "overlay", "none")
OVERLAYS = ("vtkActor2D", "vtkMapper2D")


@pytest.fixture(scope="module")
def table():
    """{class: (versions, kind, text)}"""
    lines = (FOLDER / "class_cells.tsv").read_text().splitlines()
    rows = [line.split("\t") for line in lines if not line.startswith("#")]
    assert all(len(row) == 4 and row[2] in KINDS and bool(row[3]) == (row[2] != "overlay") for row in rows)
    names = [row[0] for row in rows]
    assert names == sorted(set(names)), "each class once, in their order"
    if not any(VERSION in row[1].split() for row in rows):
        pytest.skip(f"the table does not know VTK {VERSION}")
    return {name: (versions.split(), kind, text) for name, versions, kind, text in rows}


@pytest.fixture(scope="module")
def cells():
    """{row: names of its cells}, found before all modules of VTK are there: some change what factories make."""
    names = [path.stem for path in sorted(FOLDER.glob("TestMatrix*.py")) if path.stem != pathlib.Path(__file__).stem]
    return {name[len("TestMatrix"):]: set(map(file_name, importlib.import_module(name).row.makers)) for name in names}


@pytest.fixture(scope="module")
def classes(cells):
    return vtk_classes.classes()


def cells_of(text):
    """(row, name of a cell's file) of each cell in a text of the table."""
    return [(row, file_name(cell)) for row, cell in (one.split("/", 1) for one in text.split("; "))]


def test_classes_are_those_of_the_table(table, classes):
    """A class that VTK brings is not forgotten, and the table names none that it does not have."""
    known = {name for name, (versions, _, _) in table.items() if VERSION in versions}
    assert not set(classes) - known, f"no line for VTK {VERSION} in class_cells.tsv"
    assert not known - set(classes), f"VTK {VERSION} does not have them"


def test_cells_are_there(table, cells, classes):
    """The matrix has each cell that the table names for a class of this VTK."""
    named = [(name, cell) for name, (_, kind, text) in table.items() if kind == "cell" and name in classes
             for cell in cells_of(text)]
    assert not [(name, row, cell) for name, (row, cell) in named if cell not in cells.get(row, ())]


def test_cells_of_classes_are_named(table, cells):
    """The table names each cell of the rows of classes."""
    named = {cell for _, kind, text in table.values() if kind == "cell" for cell in cells_of(text)}
    assert not {(row, cell) for row in cells if row.endswith("Classes") for cell in cells[row]} - named


def test_reasons_hold(table, classes):
    """An overlay is one by its class, and what is said to be made by another class's New() is."""
    for name in set(table) & set(classes):
        (_, cls, _), (_, kind, text) = classes[name], table[name]
        if kind == "overlay":
            assert any(base.__name__ in OVERLAYS for base in cls.__mro__), f"{name} is no overlay"
        elif kind == "made by":
            assert classes[text][2] == name, f"{text}'s New() makes {classes[text][2]}, and not {name}"

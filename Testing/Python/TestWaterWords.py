# SPDX-License-Identifier: BSD-3-Clause
"""The guide's table of words names what there is: each name is an argument, an option, a method or a function, and no
word of add_water or of the command is left out."""

import ast
import ctypes
import pathlib
import re

import pytest
import water_test as wt
import vtkwater
from TestWaterCInterface import lib  # noqa: F401  a fixture
from vtkwater import (command, vtkWaterActor, vtkWaterLakes, vtkWaterProperty, vtkWaterReflectionPass,
                      vtkWaterSurfaceFilter)

GUIDE = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "guide.md"
OF_THE_ACTOR = {"SetLevel", "SetPlane", "SetMapper", "SetSheetBounds", "SetSheetToHorizon", "SetSheetToAutomatic",
                "SetTime", "GetSkyDirection", "AddHull", "SetFlowArrayName", "SetFlowPeriod",
                "SetMatterArrayName", "SetMatterAbsorption", "SetMatterScattering", "SetFoamArrayName", "SetFoamMeasure"}
OF_THE_PASS = {"SetTimeBudget", "SetQualityToTimeBudget", "SetSecondaryReflections"}
OF_THE_LAKES = {"SetMaximumNumberOfMirrors"}
OF_THE_FILTER = {"SetLevelArrayName", "SetDepthArrayName", "SetBedArrayName"}
# of the plotter and of the picture, not of the water
NOT_OF_WATER = {"self", "name", "pickable", "reset_camera", "render"}


def table():
    """The rows' cells, each as the names in it."""
    text = GUIDE.read_text()
    begin, end = text.index("<!-- table of words"), text.index("<!-- end of the table of words")
    rows = [line.strip("|").split("|") for line in text[begin:end].splitlines() if line.startswith("|")][2:]
    return [[cell.strip() for cell in row[:1]] + [re.findall(r"`([^`]+)`", cell) for cell in row[1:]] for row in rows]


ROWS = table()


def of_column(number):
    return [name for row in ROWS for name in row[number]]


def arguments_of_add_water():
    """From the text: PyVista need not be here."""
    tree = ast.parse((pathlib.Path(vtkwater.__file__).parent / "pyvista.py").read_text())
    (function,) = (node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == "add_water")
    return {argument.arg for argument in function.args.args + function.args.kwonlyargs}


def options_of(name):
    """Of a subcommand, all of them, and those of the water's group."""
    commands = next(
        action for action in command.make_parser()._actions if hasattr(action, "choices") and action.choices
    )
    parser = commands.choices[name]
    water = next(group for group in parser._action_groups if group.title == "the water")
    return ({option for action in parser._actions for option in action.option_strings},
            {action.option_strings[0] for action in water._group_actions})


def test_the_table_is_read():
    """The table has rows with a name in every column."""
    wt.check_at_least("rows", len(ROWS), 15)
    for column in range(1, 5):
        wt.check_at_least(f"names in column {column}", len(of_column(column)), 10)
    wt.check_equal("cells of each row", {len(row) for row in ROWS}, {5})


def test_every_argument_is_one_of_add_water():
    """PyVista's names are arguments of add_water, and all of its arguments that are of the water are in the table."""
    wt.check_equal("differ", sorted(set(of_column(1)) ^ (arguments_of_add_water() - NOT_OF_WATER)), [])


@pytest.mark.parametrize("name", ("render", "animate"))
def test_every_option_is_one_of_the_command(name):
    """The command's names are its options, and all options of the water are in the table."""
    every, of_water = options_of(name)
    wanted = set(of_column(2)) - ({"--time"} if name == "animate" else set())  # an animation has its own times
    wt.check_equal("no options", sorted(wanted - every), [])
    wt.check_equal("options left out", sorted(of_water - wanted), [])


@pytest.mark.parametrize("name", of_column(3))
def test_every_method_is_one_of_its_class(name):
    """The classes' names are methods of the class that the text names."""
    classes = {vtkWaterActor: OF_THE_ACTOR, vtkWaterReflectionPass: OF_THE_PASS, vtkWaterSurfaceFilter: OF_THE_FILTER,
               vtkWaterLakes: OF_THE_LAKES}
    cls = next((cls for cls, names in classes.items() if name in names), vtkWaterProperty)
    wt.check_equal(f"{cls.__name__}.{name}", hasattr(cls, name), True)


@pytest.mark.parametrize("name", of_column(4))
def test_every_function_is_in_the_library(name, lib):  # noqa: F811
    """C's names are functions of the library."""
    wt.check_equal(f"vtk_water_{name}", isinstance(getattr(lib, f"vtk_water_{name}", None), ctypes._CFuncPtr), True)

# SPDX-License-Identifier: BSD-3-Clause
"""Every public class, method and function says what it does; what sets a number says its range and its default.

VTK's wrapping gives the text of a group (///@{) to its first method alone, in VTK's own classes too. So what sets
something begins its group and has the text; its bare accessors (Get, On, Off, To) have the nearest text before them in
the header, which must speak of them.
"""

import importlib
import inspect
import re

import pytest
import water_test as wt
import vtkwater

CLASSES = (vtkwater.vtkWaterActor, vtkwater.vtkWaterProperty, vtkwater.vtkWaterReflectionPass,
           vtkwater.vtkWaterOffScreen, vtkwater.vtkWaterFrameAverage, vtkwater.vtkWaterSurfaceFilter,
           vtkwater.vtkWaterClearSkySource, vtkwater.vtkWaterLakes, vtkwater.vtkWaterPlanesFilter)
MODULES = ("backend", "command", "deprecation", "errors", "pictures", "view", "movies", "readers", "scenes", "widgets", "words")
OF_VTK = {"SafeDownCast", "NewInstance", "IsA", "IsTypeOf", "GetNumberOfGenerationsFromBase", "New",
          "GetNumberOfGenerationsFromBaseType"}
LEAST = 25  # letters of a sentence
# how a text tells which values are taken
RANGE = re.compile(r"\[[^]]*\d[^]]*\]|finite|any integer|must |one of|nullptr|null|true|Whether|\b[A-Z_]{5,}\b|"
                   r"power of two|or-ed|on, or|is on|is off|Finite|greater than|at least|not negative|-1|environment|"
                   r"Let times", re.S)
DEFAULT = re.compile(r"default", re.I)
# what they set is no number with a default
NO_DEFAULT = {"SetWaterType", "SetPreset", "SetSlopeVarianceToWind", "SetMapper", "SetAllocatedRenderTime",
              "SetRayTraceQuality", "SetWave"}


def text_of(name, doc):
    """A wrapped method's docstring without its signatures."""
    paragraphs = re.split(r"\n\s*\n", doc or "")
    return " ".join(part for part in paragraphs if not part.startswith((name + "(", "C++:")))


def methods(cls):
    """Names of the class's own public methods with their texts, in the header's order."""
    for name, value in vars(cls).items():
        if not name.startswith("_") and name not in OF_VTK and inspect.isroutine(value):
            yield name, text_of(name, value.__doc__)


def stem(name):
    """What an accessor is about: Set, Get, On, ToX and the like taken off."""
    return re.sub(r"^(Set|Get|Add|RemoveAll|Reset|Use|GetUse|GetNumberOf)|(On|Off|AsString|To[A-Z]\w+)$", "", name)


def told(cls):
    """Of each method: its name, its own text, the text that speaks of it, and which method that is the text of."""
    group, group_name = "", ""
    for name, text in methods(cls):
        if len(text) >= LEAST:
            group, group_name = text, name
        yield name, text, group, group_name


def is_setter(name):
    return name.startswith("Set")


OF_EVERY_CLASS = pytest.mark.parametrize("cls", CLASSES, ids=lambda cls: cls.__name__)
OF_EVERY_MODULE = pytest.mark.parametrize("name", MODULES)


@OF_EVERY_CLASS
def test_a_class_has_a_text(cls):
    """Every class says what it is, and its methods are found."""
    wt.check_at_least(f"{cls.__name__}: letters", len(text_of(cls.__name__, cls.__doc__)), 100)
    wt.check_at_least(f"{cls.__name__}: methods read", len(list(methods(cls))), 5)


@OF_EVERY_CLASS
def test_every_method_is_told_of(cls):
    """Every method has a text of its own, or the nearest one before it speaks of it."""
    for name, text, group, group_name in told(cls):
        if len(group) < LEAST:
            wt.check_equal(f"{cls.__name__}.{name} has a text", False, True)
        if name != group_name:
            about = stem(name).rstrip("s")
            words = re.sub(r"\W", "", group).lower()
            known = about.lower() in words or stem(group_name).rstrip("s") in about or about in group_name or any(
                part.lower() in words for part in re.findall(r"[A-Z][a-z]+", about))
            wt.check_equal(f"{cls.__name__}.{name} is told of by {group_name}", known, True)


@OF_EVERY_CLASS
def test_what_sets_something_has_a_text_of_its_own(cls):
    """What sets something begins its group and has the group's text."""
    for name, _, _, group_name in told(cls):
        if is_setter(name) and not re.search(r"To[A-Z]\w+$", name):
            wt.check_equal(f"{cls.__name__}.{name} has a text of its own", name, group_name)


@OF_EVERY_CLASS
def test_what_sets_something_says_its_default_and_its_range(cls):
    """What sets something says which values it takes, and its default."""
    for name, text, _, group_name in told(cls):
        if is_setter(name) and name == group_name and name not in NO_DEFAULT:
            wt.check_equal(f"{cls.__name__}.{name} says a default", bool(DEFAULT.search(text)), True)
            wt.check_equal(f"{cls.__name__}.{name} says what it takes", bool(RANGE.search(text)), True)


@OF_EVERY_MODULE
def test_a_module_has_a_text(name):
    """Every module of the package says what it is for."""
    wt.check_at_least(f"{name}: letters", len(importlib.import_module(f"vtkwater.{name}").__doc__ or ""), 60)


@OF_EVERY_MODULE
def test_what_a_module_gives_has_a_text(name):
    """Every public class, method and function of a module says what it does."""
    module = importlib.import_module(f"vtkwater.{name}")
    for public in module.__all__:
        thing = getattr(module, public)
        if not (inspect.isclass(thing) or inspect.isfunction(thing)):
            continue
        wt.check_at_least(f"{name}.{public}: letters", len(thing.__doc__ or module.__doc__), LEAST)
        for method, value in vars(thing).items() if inspect.isclass(thing) else ():
            if not method.startswith("_") and inspect.isfunction(value):
                wt.check_at_least(f"{name}.{public}.{method}: letters", len(value.__doc__ or ""), LEAST)

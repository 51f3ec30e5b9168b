# SPDX-License-Identifier: BSD-3-Clause
"""Deprecated names work as before, and warn: with their name, what replaces them, and when they go.

Documentation/deprecation.md has the list; each name of it is called here.
"""

import re
import warnings
from pathlib import Path

import pytest
import water_test as wt
from vtkwater import deprecation, pictures

LIST = Path(__file__).resolve().parents[2] / "Documentation/deprecation.md"
# deprecated name -> a call of it with its value, and one that it rejects
CALLS = {
    "vtkwater.pictures.check_png": (lambda: pictures.check_png("x.png"), None, lambda: pictures.check_png("x.jpg")),
}


def rows():
    """Name, replacement and version of the removal, by the list."""
    text = LIST.read_text().partition("Deprecated at present:")[2]
    return re.findall(r"^\| `([\w.]+)` \| `([\w.]+)` \| ([\d.]+) \|$", text, flags=re.MULTILINE)


def test_every_name_of_the_list_is_called_here():
    wt.check_equal("names", sorted(name for name, _, _ in rows()), sorted(CALLS))


@pytest.mark.parametrize("name, replacement, version", rows(), ids=lambda value: value)
def test_a_deprecated_name_works_and_warns(name, replacement, version):
    call, value, bad = CALLS[name]
    with pytest.warns(DeprecationWarning) as caught:
        wt.check_equal("value", call(), value)
    text = str(caught[0].message)
    wt.check_equal(text, text, f"{name} is deprecated and will be removed in version {version}; use {replacement}")
    wt.check_equal("at the line of the caller", Path(caught[0].filename).name, Path(__file__).name)
    with pytest.warns(DeprecationWarning), pytest.raises(ValueError):
        bad()


def test_nothing_else_of_the_package_warns():
    """What replaces a deprecated name does not use it."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        pictures.check_picture("x.png")
        pictures.png_name("x.png")
    wt.check_equal("exported", deprecation.__all__, ["warn_of"])

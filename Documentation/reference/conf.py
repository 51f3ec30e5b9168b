# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx's settings for the Python reference; script/docs gives the version in WATER_VERSION."""
import inspect
import os
import pathlib
import re

import vtkwater

project = "vtkwater"
copyright = "the vtkWater contributors"
release = version = os.environ.get("WATER_VERSION", vtkwater.__version__)
extensions = ["sphinx.ext.autodoc", "sphinx.ext.extlinks", "numpydoc"]
numpydoc_show_class_members = False
html_theme = "alabaster"
highlight_language = "none"  # the texts of VTK's wrapping are no Python
# PyVista's role for a class of VTK, and where that is documented
extlinks = {"vtk": ("https://vtk.org/doc/nightly/html/class%s.html", "%s")}

CLASSES = ("vtkWaterActor", "vtkWaterProperty", "vtkWaterReflectionPass", "vtkWaterOffScreen")
OF_VTK = {"SafeDownCast", "NewInstance", "IsA", "IsTypeOf", "GetNumberOfGenerationsFromBase",
          "GetNumberOfGenerationsFromBaseType"}


def indented(text, width):
    return "\n".join(" " * width + line if line.strip() else "" for line in text.strip().splitlines())


def class_page(name):
    """A wrapped class: VTK's texts are plain, and stay so, as literal blocks."""
    cls = getattr(vtkwater, name)
    base = cls.__mro__[1].__name__
    lines = [name, "=" * len(name), "", f".. py:class:: vtkwater.{name}(**properties)", "",
             f"   Superclass: :vtk:`{base}`. The properties of VTK 9.4 and later are its Set and Get methods in "
             "snake_case.", "", "   ::", "", indented(cls.__doc__, 6), ""]
    for method, value in vars(cls).items():
        if method.startswith("_") or method in OF_VTK or not inspect.isroutine(value):
            continue
        signatures, _, text = (value.__doc__ or "").partition("\n\n")
        python = re.sub(r"\s+", " ", signatures.split("C++:")[0]).strip()
        lines += [f"   .. py:method:: {method}(...)", "", "      ::", "", indented(python, 9),
                  indented(text, 9), ""]
    return "\n".join(lines)


def write_class_pages(app):
    folder = pathlib.Path(app.srcdir) / "classes"
    folder.mkdir(exist_ok=True)
    for name in CLASSES:
        (folder / f"{name}.rst").write_text(class_page(name))


def setup(app):
    app.connect("builder-inited", write_class_pages)

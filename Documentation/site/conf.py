# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx's settings for the site. script/docs gives WATER_VERSION, and the folder that has Doxygen's pages in cxx/."""
import importlib.util
import inspect
import os
import pathlib
import re

import vtkwater
from docutils import nodes

project = "Water for VTK"
copyright = "the vtkWater contributors"
release = version = os.environ["WATER_VERSION"]
extensions = ["sphinx.ext.autodoc", "numpydoc", "myst_parser", "sphinx_design",
              "sphinx_copybutton"]
if importlib.util.find_spec("pyvista") is None:  # beside the distribution's VTK
    autodoc_mock_imports = ["pyvista"]
numpydoc_show_class_members = False
myst_enable_extensions = ["colon_fence", "dollarmath"]
myst_heading_anchors = 5
html_theme = "furo"
html_title = f"Water for VTK {version}"
html_static_path = ["style.css"]
html_css_files = ["style.css"]
html_copy_source = False
html_extra_path = [os.environ["WATER_DOXYGEN"]]
highlight_language = "none"  # the texts of VTK's wrapping are no Python
exclude_patterns = ["_build"]
VTK_PAGES = "https://vtk.org/doc/nightly/html/class{}.html"

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
    folder = pathlib.Path(app.srcdir) / "api/classes"
    folder.mkdir(exist_ok=True)
    for name in dir(vtkwater):
        if name.startswith("vtkWater") and inspect.isclass(getattr(vtkwater, name)):
            (folder / f"{name}.rst").write_text(class_page(name))


def vtk_role(name, rawtext, text, lineno, inliner, options=None, content=None):
    """PyVista's role :vtk: for a class: of this project, or of VTK."""
    ours = hasattr(vtkwater, text)
    page = "/".join([".."] * inliner.document.settings.env.docname.count("/") + [f"cxx/class{text}.html"])
    return [nodes.reference(rawtext, text, refuri=page if ours else VTK_PAGES.format(text))], []


def setup(app):
    app.add_role("vtk", vtk_role)
    app.connect("builder-inited", write_class_pages)

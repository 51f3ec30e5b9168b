#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vtk_classes: the classes of the installed VTK that can stand in a scene: its props, mappers and passes.

usage: vtk_classes.py     one line for each: root, class, module, and the class that its New() makes, if another

vtkStandardNewMacro stands in .cxx files, which an installation lacks, and headers are no part of PyPI's vtk. But
VTK wraps every class of a module with wrapping, and a wrapped class can be called if, and only if, it has a
public New() that is no stub: one that is abstract raises a TypeError. So the list is that of all wrapped classes
that derive from one of ROOTS and can be made. What it misses are classes that VTK excludes from wrapping, which
are parts of one class's own implementation, and modules that this installation does not have.
"""

import importlib
import pkgutil
import warnings

import vtkmodules

ROOTS = ("vtkProp", "vtkAbstractMapper", "vtkRenderPass")  # volumes' and images' mappers are vtkAbstractMapper3D


def modules():
    """All modules of VTK that can be imported here: Qt's or MPI's may lack their libraries."""
    for found in pkgutil.iter_modules(vtkmodules.__path__):
        if found.name.startswith("vtk"):
            try:
                yield importlib.import_module(f"vtkmodules.{found.name}")
            except ImportError:
                continue


def made(cls):
    """The name of the class that New() makes, which may be the object factory's; None: there is no New()."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of deprecated classes
        try:
            return cls().GetClassName()
        except TypeError:
            return None


def classes():
    """{name: (root, class, name of the class that New() makes)} of all that can be made."""
    core = importlib.import_module("vtkmodules.vtkRenderingCore")
    roots = [getattr(core, name) for name in ROOTS]
    found = {}
    for module in list(modules()):  # all are there before a class is made: some need what another one overrides
        for name, cls in vars(module).items():
            root = [r.__name__ for r in roots if isinstance(cls, type) and issubclass(cls, r)]
            if root and cls.__name__ == name and (product := made(cls)):
                found[name] = (root[0], cls, product)
    return dict(sorted(found.items()))


def find(path):
    """The class of a path as RenderingCore.vtkActor; None: this VTK does not have it."""
    module, name = path.split(".")
    try:
        return getattr(importlib.import_module(f"vtkmodules.vtk{module}"), name, None)
    except ImportError:
        return None


if __name__ == "__main__":
    for name, (root, cls, product) in classes().items():
        print(root, name, cls.__module__.split(".")[-1], "" if product == name else product)

# SPDX-License-Identifier: BSD-3-Clause
"""Writes what a window shows as a PNG, and says why it cannot.

    parser.add_argument("picture", type=png_name)    # refuses other names, and folders that are not there
    write_png(window, picture)
"""
import argparse
from pathlib import Path

from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

__all__ = ["check_png", "png_name", "write_png"]


def check_png(file):
    """Raises ValueError for a name that no PNG can be written to: another kind, a folder that is not there."""
    path = Path(file)
    if path.suffix.lower() != ".png":
        raise ValueError(f"{file}: a picture is a PNG; give a name that ends with .png")
    if path.is_dir():
        raise ValueError(f"{file}: a folder has that name")
    if not path.parent.is_dir():
        raise ValueError(f"{file}: no such folder: {path.parent}")


def png_name(text):
    """The same as a type of argparse: a wrong name is said before anything is rendered."""
    try:
        check_png(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(error) from None
    return text


def write_png(window, file):
    """Renders a window into a PNG; raises ValueError as check_png does, and OSError when it cannot be written."""
    check_png(file)
    with open(file, "ab"):
        pass  # the reason, in Python's words
    capture = vtkWindowToImageFilter()
    capture.SetInput(window)
    capture.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(capture.GetOutputPort())
    writer.SetFileName(str(file))
    writer.Write()
    if writer.GetErrorCode():
        raise OSError(f"{file}: cannot be written to its end")

# SPDX-License-Identifier: BSD-3-Clause
"""Writes the picture of a window as a PNG, with a clear error if that fails.

    parser.add_argument("picture", type=png_name)    # rejects other suffixes, and missing folders
    write_png(window, picture)
"""
import argparse
from pathlib import Path

from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

__all__ = ["check_png", "png_name", "write_png"]


def check_png(file):
    """Raise ValueError for a name to which no PNG can be written: another suffix, or a missing folder."""
    path = Path(file)
    if path.suffix.lower() != ".png":
        raise ValueError(f"{file}: pictures are PNG files; use a name that ends with .png")
    if path.is_dir():
        raise ValueError(f"{file}: is a folder")
    if not path.parent.is_dir():
        raise ValueError(f"{file}: no such folder: {path.parent}")


def png_name(text):
    """The same check as a type for argparse: it reports a wrong name before anything is rendered."""
    try:
        check_png(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(error) from None
    return text


def write_png(window, file):
    """Render a window into a PNG. Raises ValueError like check_png, and OSError if it cannot be written."""
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
        raise OSError(f"{file}: cannot be written completely")

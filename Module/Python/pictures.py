# SPDX-License-Identifier: BSD-3-Clause
"""Writes the picture of a window as a PNG, JPEG or WebP file, with a clear error if that fails.

    parser.add_argument("picture", type=png_name)    # rejects other suffixes, and missing folders
    write_png(window, picture)
    write_picture(window, "lake.webp")
"""
import argparse
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkIOImage import vtkJPEGWriter, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

from .deprecation import warn_of

__all__ = ["KINDS", "check_picture", "check_png", "png_name", "write_picture", "write_png"]

KINDS = (".png", ".jpg", ".jpeg", ".webp")
JPEG_QUALITY = WEBP_QUALITY = 90  # of 100


def check(file, kinds, what):
    path = Path(file)
    if path.suffix.lower() not in kinds:
        raise ValueError(f"{file}: {what}; use a name that ends with {' or '.join(kinds)}")
    if path.is_dir():
        raise ValueError(f"{file}: is a folder")
    if not path.parent.is_dir():
        raise ValueError(f"{file}: no such folder: {path.parent}")


def check_picture(file):
    """Raise ValueError for a name to which no picture can be written: another suffix, a missing folder or package."""
    check(file, KINDS, "pictures are PNG, JPEG or WebP files")
    if Path(file).suffix.lower() == ".webp":
        webp_image(file)


def check_png(file):
    """Deprecated: use ``check_picture``. Raise ValueError for a name to which no PNG can be written."""
    warn_of("vtkwater.pictures.check_png", "vtkwater.pictures.check_picture", "0.3")
    check(file, KINDS[:1], "pictures are PNG files")


def png_name(text):
    """A type for argparse: it rejects names that are not those of PNG files before anything is rendered."""
    try:
        check(text, KINDS[:1], "pictures are PNG files")
    except ValueError as error:
        raise argparse.ArgumentTypeError(error) from None
    return text


def webp_image(file):
    """Pillow's module that writes WebP."""
    try:
        from PIL import Image, features
    except ImportError:
        raise ValueError(f"{file}: writing WebP needs Pillow: pip install pillow (Debian: python3-pil)") from None
    if not features.check("webp"):
        raise ValueError(f"{file}: this Pillow cannot write WebP; use PNG or JPEG")
    return Image


def write_png(window, file):
    """Render a window into a PNG. Raises ValueError for another suffix, and OSError if it cannot be written."""
    check(file, KINDS[:1], "pictures are PNG files")
    write_picture(window, file)


def write_picture(window, file):
    """Render a window into a PNG, a JPEG or a WebP, by the file's suffix. JPEG and WebP have a quality of 90.

    Raises ValueError like check_picture, and OSError if the file cannot be written.
    """
    check_picture(file)
    with open(file, "ab"):
        pass  # the reason, in Python's words
    suffix = Path(file).suffix.lower()
    if suffix == ".webp":
        window.Render()
        webp_image(file).fromarray(pixels_of(window)).save(file, "WEBP", quality=WEBP_QUALITY, method=4)
        return
    capture = vtkWindowToImageFilter()
    capture.SetInput(window)
    capture.ReadFrontBufferOff()
    if suffix == ".png":
        writer = vtkPNGWriter()
    else:
        writer = vtkJPEGWriter()
        writer.SetQuality(JPEG_QUALITY)
    writer.SetInputConnection(capture.GetOutputPort())
    writer.SetFileName(str(file))
    writer.Write()
    if writer.GetErrorCode():
        raise OSError(f"{file}: cannot be written completely")


def pixels_of(window):
    """The window's picture as it is: rows x columns x RGB of 8 bits, top row first."""
    import numpy as np
    from vtkmodules.util.numpy_support import vtk_to_numpy

    width, height = window.GetSize()
    pixels = vtkUnsignedCharArray()
    window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels)
    return np.ascontiguousarray(vtk_to_numpy(pixels).reshape(height, width, 4)[::-1, :, :3])

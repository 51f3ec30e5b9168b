# SPDX-License-Identifier: BSD-3-Clause
"""Names that are going to be removed: they work as before, and warn (Documentation/deprecation.md).

    def check_png(file):
        warn_of("vtkwater.pictures.check_png", "check_picture", "0.3")
        ...
"""
import warnings

__all__ = ["warn_of"]


def warn_of(name, replacement, removed_in):
    """Warn that a function is deprecated: call this first in it. The warning is at the line of the caller.

    Parameters
    ----------
    name : str
        The deprecated name.
    replacement : str
        What to use instead.
    removed_in : str
        The version that no longer has the name.
    """
    warnings.warn(f"{name} is deprecated and will be removed in version {removed_in}; use {replacement}",
                  DeprecationWarning, stacklevel=3)

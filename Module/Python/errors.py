# SPDX-License-Identifier: BSD-3-Clause
"""Errors of VTK objects as Python exceptions: for what is written in Python around the classes.

The classes themselves report a bad value by an ErrorEvent, as VTK's do, and keep the last good one.
"""
import contextlib
import re

__all__ = ["ending", "raising", "text_of"]


@contextlib.contextmanager
def ending(program):
    """End the program with one line, and exit status 1, when a file or a value in the block is refused."""
    try:
        yield
    except (OSError, ValueError) as error:
        raise SystemExit(f"{program}: {text_of(error)}") from None


def text_of(error):
    """What an exception says; of an OSError the reason without its number, after the file if it knows one."""
    if not getattr(error, "strerror", None):
        return str(error)
    return f"{error.filename}: {error.strerror}" if error.filename else error.strerror


# What an error says of the object that keeps its value; the exception leaves it out.
KEPT = re.compile(r" (It stays|They stay|The water stays|It is not added).*$", re.DOTALL)


@contextlib.contextmanager
def raising(*things, **words):
    """Raise a ValueError after the block when one of the VTK objects has reported an error in it.

    Parameters
    ----------
    *things : vtkObject
    **words : str
        What the caller calls a property, such as ``Opacity="opacity"``.

    Raises
    ------
    ValueError
        The text is that of the first error, in the caller's words: the value and the accepted range.
    """
    texts = []

    def remember(caller, event, text):
        texts.append(re.sub(r"^ERROR: In .*\n\w+ \(0x[0-9a-f]+\): ", "", text).strip())

    remember.CallDataType = "string0"
    tags = [(thing, thing.AddObserver("ErrorEvent", remember)) for thing in things]
    try:
        yield
    finally:
        for thing, tag in tags:
            thing.RemoveObserver(tag)
    if texts:
        text = KEPT.sub("", texts[0])
        raise ValueError(re.sub(r"\w+", lambda word: words.get(word.group(), word.group()), text))

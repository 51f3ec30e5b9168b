# SPDX-License-Identifier: BSD-3-Clause
"""Turns errors of VTK objects into Python exceptions, for the Python code around the classes.

The classes themselves report a bad value by an ErrorEvent, like VTK's own, and keep the last valid one.
"""
import contextlib
import re

__all__ = ["ending", "heed", "raising", "text_of"]


@contextlib.contextmanager
def ending(program):
    """End the program with one line and exit status 1 if a file or a value in the block is rejected."""
    try:
        yield
    except (OSError, ValueError) as error:
        raise SystemExit(f"{program}: {text_of(error)}") from None


def text_of(error):
    """Text of an exception; for an OSError the file, if known, and the reason, without the error's number."""
    if not getattr(error, "strerror", None):
        return str(error)
    return f"{error.filename}: {error.strerror}" if error.filename else error.strerror


# What VTK writes before a text of its own.
PREFIX = re.compile(r"^(ERROR|Warning): In .*\n\w+ \(0x[0-9a-f]+\): ")


def heed(thing, tell):
    """Call tell(text) with each warning of a VTK object, in place of VTK's output window."""
    def pass_on(caller, event, text):
        tell(PREFIX.sub("", text).strip())

    pass_on.CallDataType = "string0"
    thing.AddObserver("WarningEvent", pass_on)


WORD = re.compile(r"'[^']*'|\"[^\"]*\"|\w+")  # what is quoted is the user's
# The part of an error that says which value stays; the exception leaves it out.
KEPT = re.compile(r" (It stays|They stay|The water stays|It is not added).*$", re.DOTALL)


@contextlib.contextmanager
def raising(*objects, **words):
    """Raise a ValueError after the block if one of the VTK objects reported an error in it.

    Parameters
    ----------
    *objects : vtkObject
    **words : str
        The caller's names of properties, such as ``Opacity="opacity"``.

    Raises
    ------
    ValueError
        With the text of the first error, in the caller's names: the value and the accepted range.
    """
    texts = []

    def remember(caller, event, text):
        texts.append(PREFIX.sub("", text).strip())

    remember.CallDataType = "string0"
    tags = [(thing, thing.AddObserver("ErrorEvent", remember)) for thing in objects]
    try:
        yield
    finally:
        for thing, tag in tags:
            thing.RemoveObserver(tag)
    if texts:
        text = KEPT.sub("", texts[0])
        raise ValueError(WORD.sub(lambda word: words.get(word.group(), word.group()), text))

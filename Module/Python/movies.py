# SPDX-License-Identifier: BSD-3-Clause
"""Writes the pictures of an animation: a GIF, an MP4, or numbered PNGs in a folder.

    with open_movie("tide.gif", frames_per_second=12) as movie:
        movie.add(picture)    # rows x columns x RGB of 8 bits

Finished pictures are kept, even if an exception ends the block. If no picture was finished, an existing file of
that name does not change.
`interrupts()` makes Ctrl-C wait until the current picture is complete:

    with interrupts() as is_stopped:
        for step in steps:
            if is_stopped():
                break
"""
import contextlib
import math
import signal
from pathlib import Path

from .words import number

__all__ = ["KINDS", "interrupts", "open_movie"]

KINDS = (".gif", ".mp4", "a folder")
LEAST_RATE = 0.002  # pictures a second: GIF knows no longer time of a picture than 655 s


@contextlib.contextmanager
def interrupts():
    """Yield a function that returns whether Ctrl-C was pressed. A second Ctrl-C interrupts as usual."""
    pressed = []

    def remember(number, frame):
        pressed.append(number)
        signal.signal(signal.SIGINT, before)

    before = signal.signal(signal.SIGINT, remember)
    try:
        yield lambda: bool(pressed)
    finally:
        signal.signal(signal.SIGINT, before)


def open_movie(file, frames_per_second):
    """Open a movie for writing.

    Raises ValueError for an unknown file type, a missing package, or frames per second that are not finite or less than
    LEAST_RATE; TypeError if they are not a number; OSError like open.
    """
    frames_per_second = number("frames_per_second", frames_per_second)
    if not (math.isfinite(frames_per_second) and frames_per_second >= LEAST_RATE):
        raise ValueError(f"frames_per_second is {frames_per_second:g}; it must be at least {LEAST_RATE:g}, and finite")
    suffix = Path(file).suffix.lower()
    if not suffix:
        return Folder(file)
    if suffix == ".gif":
        return Gif(file, frames_per_second)
    if suffix == ".mp4":
        return Mp4(file, frames_per_second)
    raise ValueError(f"{file}: unknown file type {suffix}; known types are {', '.join(KINDS)}")


def pillow(file):
    try:
        from PIL import Image
    except ImportError:
        raise ValueError(f"{file}: writing needs Pillow: pip install pillow (Debian: python3-pil)") from None
    return Image


class Place:
    """The file of a movie. An existing file is kept until the first picture is written."""

    def __init__(self, file):
        self.file = Path(file)
        self._is_new = not self.file.exists()
        with open(file, "ab"):
            pass  # an error is reported now, in Python's words

    def leave(self):
        """Delete the empty file of a movie without pictures."""
        if self._is_new:
            self.file.unlink(missing_ok=True)


class Movie:
    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()


class Folder(Movie):
    def __init__(self, folder):
        self._image = pillow(folder)
        self._folder = Path(folder)
        self._folder.mkdir(parents=True, exist_ok=True)
        self._count = 0

    def add(self, picture):
        self._image.fromarray(picture).save(self._folder / f"{self._count:04d}.png")
        self._count += 1

    def close(self):
        pass


class Gif(Movie):
    def __init__(self, file, frames_per_second):
        self._image = pillow(file)
        self._place = Place(file)
        self._duration_ms = round(1000.0 / frames_per_second)
        self._frames = []

    def add(self, picture):
        # 8 bits a pixel now: a long animation stays small in memory
        # the palette that covers all colours: the usual one makes snow on few pixels blue
        method = self._image.Quantize.MAXCOVERAGE
        self._frames.append(self._image.fromarray(picture).quantize(colors=256, method=method))

    def close(self):
        if not self._frames:
            self._place.leave()
            return
        self._frames[0].save(self._place.file, format="GIF", save_all=True, append_images=self._frames[1:],
                             duration=self._duration_ms, loop=0)


class Mp4(Movie):
    def __init__(self, file, frames_per_second):
        try:
            import imageio.v2 as imageio
            import imageio_ffmpeg  # noqa: F401  the encoder
        except ImportError:
            raise ValueError(f"{file}: writing MP4 needs imageio: pip install imageio imageio-ffmpeg") from None
        self._place = Place(file)
        self._open = lambda: imageio.get_writer(file, fps=frames_per_second, macro_block_size=2)
        self._writer = None

    def add(self, picture):
        self._writer = self._writer or self._open()
        self._writer.append_data(picture)

    def close(self):
        if self._writer is None:
            self._place.leave()
        else:
            self._writer.close()

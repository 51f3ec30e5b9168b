# SPDX-License-Identifier: BSD-3-Clause
"""clipped: the share of the water's pixels that are clipped to white in each picture of the gallery and the recipes.

usage: clipped.py [PICTURE...]    default: all of them

A pixel is the water's if it changes when the waters are hidden. It is clipped if no channel is further than 3 from the
brightest value that the roll-off of highlights shows, 0.99 of 255: there a pixel no longer tells how bright the light
is, and an area of such pixels is as flat as a white one. "glitter" leaves out those that are white without the sun's
glitter, too. "Kept" is the light of
the water's pixels, the sum of their values, over what it is without the roll-off of highlights. Ends with 1 if more than
1 % of the water's pixels are glitter that is clipped, or less than 95 % of the light is kept. Run it with a Python that
has vtkwater. gallery.py --check, which the tests ExampleGallery_NAME run, asks the same of each picture that it makes.
"""
import contextlib
import os
import pathlib
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
WHITE = 0.99 * 255 - 3  # of 255: what is brighter has no shape left (vtkWaterHighlights.glsl)
LIMIT = 1.0  # % of the water's pixels
SMALL_PX = 500  # a side: of larger windows, the light is measured in pictures of half their size
LEAST_KEPT = 95.0  # % of the water's light
# what sitecustomize does in each example's Python: it watches where pictures are taken from
HOOK = f"import sys; sys.path.insert(0, {str(HERE)!r}); import clipped; clipped.watch()"


def waters_of(window):
    from vtkwater import vtkWaterActor

    found = []
    for renderer in list(window.GetRenderers()):
        props = renderer.GetViewProps()
        found += [prop for prop in (props.GetItemAsObject(i) for i in range(props.GetNumberOfItems()))
                  if isinstance(prop, vtkWaterActor) and prop.GetVisibility()]
    return found


def measure(window, grabber, shown=None):
    """Numbers of the picture that a window shows: water's pixels, those that are clipped, those clipped by glitter; % of the light kept.

    shown: the picture, if it has just been taken, as a vtkImageData
    """
    import numpy as np
    from vtkmodules.util.numpy_support import vtk_to_numpy

    def pixels_of(image):
        return vtk_to_numpy(image.GetPointData().GetScalars())[:, :3].astype(int)

    def picture(is_rendered=True):
        grab = grabber()
        grab.SetInput(window)
        grab.ReadFrontBufferOff()
        grab.SetShouldRerender(is_rendered)
        grab.Update()
        return pixels_of(grab.GetOutput())

    waters = waters_of(window)
    if not waters:
        return None
    looks = [water.GetWaterProperty() for water in waters]
    states = [(look.GetGlitter(), look.GetHighlightRollOff()) for look in looks]

    def set_looks(has_glitter=True, rolls_off=True):
        for look, (glitter, rolls) in zip(looks, states):
            look.SetGlitter(glitter and has_glitter)
            look.SetHighlightRollOff(rolls and rolls_off)

    def picture_without_water():
        for water in waters:
            water.VisibilityOff()
        dry = picture()
        for water in waters:
            water.VisibilityOn()
        return dry

    plain = picture(is_rendered=False) if shown is None else pixels_of(shown)  # it is in the window
    is_white = (plain > WHITE).all(axis=1)
    glitter_count = 0
    if is_white.any():
        is_white &= (plain != picture_without_water()).any(axis=1)
        set_looks(has_glitter=False, rolls_off=False)
        glitter_count = int((is_white & ~(picture() > WHITE).all(axis=1)).sum())
        set_looks()
    # shares of light are those of a smaller picture, which takes a fraction of the time
    size = tuple(window.GetSize())
    scale = 1 if max(size) < SMALL_PX else 2
    window.SetSize(size[0] // scale, size[1] // scale)
    small = picture() if scale > 1 else plain
    is_water = (small != picture_without_water()).any(axis=1)
    kept = 100.0
    if any(rolls for _, rolls in states):
        set_looks(rolls_off=False)
        light = picture()[is_water].sum()
        kept = 100 * small[is_water].sum() / light if light else kept
    set_looks()
    window.SetSize(*size)
    return int(is_water.sum()) * scale * scale, int(is_white.sum()), glitter_count, float(kept)


def watch():
    """Measure what the last picture of this process is taken from, and write it to WATER_CLIPPED."""
    import atexit

    import vtkmodules.vtkRenderingCore as core

    grabber = core.vtkWindowToImageFilter
    windows, results = [], []
    took = 0.0

    def take(shown=None):
        nonlocal took
        start = time.process_time()
        window = windows[0]
        size = shown.GetDimensions()[:2] if shown else window.GetSize()
        found = measure(window, grabber, shown) if tuple(size) == tuple(window.GetSize()) else None
        results[:] = [found] if found else results
        took += time.process_time() - start

    class Watched(grabber):
        def SetInput(self, window):
            windows[:] = [window]
            super().SetInput(window)

        def Update(self, *arguments):
            super().Update(*arguments)
            if windows:
                take(self.GetOutput())
                if not self.GetShouldRerender():  # the window's own picture is taken again
                    windows[0].Render()

    def finish():
        if not windows:  # something else has taken the picture
            windows[:] = [value for value in vars(sys.modules["__main__"]).values()
                          if isinstance(value, core.vtkRenderWindow)][:1]
        if windows and not results:
            take()
        if results:
            pathlib.Path(os.environ["WATER_CLIPPED"]).write_text(" ".join(map(str, (*results[0], took))))

    core.vtkWindowToImageFilter = Watched
    atexit.register(finish)


@contextlib.contextmanager
def watching():
    """While it lasts, Pythons that are started measure their last picture. Yields the file that they write it to."""
    kept = os.environ.get("PYTHONPATH")
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "sitecustomize.py").write_text(HOOK)
        os.environ["PYTHONPATH"] = os.pathsep.join([str(folder), *([kept] if kept else [])])
        os.environ["WATER_CLIPPED"] = str(folder / "clipped.txt")
        try:
            yield folder / "clipped.txt"
        finally:
            del os.environ["WATER_CLIPPED"], os.environ["PYTHONPATH"]
            os.environ.update({"PYTHONPATH": kept} if kept else {})


def share(name, measured):
    """Print what was measured of a picture. Returns the share of its water that glitter clips, %, and the processor's
    seconds for that. 100 %: nothing was measured, or too little of the light is kept."""
    if not measured.exists():
        print(f"{name:18} no picture of a window with water was taken", flush=True)
        return 100.0, 0.0
    *counts, kept, took = measured.read_text().split()
    count, white, glitter = map(int, counts)
    clipped = 100 * glitter / max(count, 1)
    print(f"{name:18} {count:8} pixels of water, {100 * white / max(count, 1):6.3f} % white, {clipped:6.3f} % by glitter "
          f"(at most {LIMIT:g}) {'ok' if clipped <= LIMIT else 'FAILED'}", flush=True)
    is_kept = float(kept) >= LEAST_KEPT
    print(f"{name:18} {float(kept):.2f} % of the light kept (at least {LEAST_KEPT:g}) {'ok' if is_kept else 'FAILED'}", flush=True)
    return clipped if is_kept else 100.0, float(took)


def main():
    import gallery

    names = sys.argv[1:] or [*gallery.EXAMPLES, *gallery.PROGRAMS]
    worst = 0.0
    with tempfile.TemporaryDirectory() as folder, watching() as measured:
        for name in names:
            measured.unlink(missing_ok=True)
            try:
                gallery.render(name, pathlib.Path(folder) / name)
            except subprocess.CalledProcessError:
                print(f"{name:18} failed", flush=True)
                worst = 100.0
                continue
            worst = max(worst, share(name, measured)[0])
    print(f"largest share of the water that glitter clips: {worst:.3f} % (at most {LIMIT:g} %)")
    return int(worst > LIMIT)


if __name__ == "__main__":
    sys.exit(main())

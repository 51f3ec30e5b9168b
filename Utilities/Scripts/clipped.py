# SPDX-License-Identifier: BSD-3-Clause
"""clipped: the share of the water's pixels that are clipped to white in each picture of the gallery and the recipes.

usage: clipped.py [PICTURE...]    default: all of them

A pixel is the water's if it changes when the waters are hidden, or show their reflectance. It is clipped if
all channels are 255; "glitter" leaves out those that are white without the sun's glitter, too. Ends with 1 if more than
1 % of the water's pixels are glitter that is clipped. Run it with a Python that has vtkwater.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
LIMIT = 1.0  # % of the water's pixels
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


def measure(window, grabber):
    """Shares of a window's picture: water's pixels, those that are clipped, and those clipped by glitter."""
    import numpy as np
    from vtkmodules.util.numpy_support import vtk_to_numpy

    def picture():
        window.Render()
        grab = grabber()
        grab.SetInput(window)
        grab.ReadFrontBufferOff()
        grab.Update()
        return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)

    waters = waters_of(window)
    if not waters:
        return None
    looks = [water.GetWaterProperty() for water in waters]
    outputs = [look.GetOutput() for look in looks]
    glitters = [look.GetGlitter() for look in looks]
    plain = picture()
    for look in looks:
        look.GlitterOff()
    calm = picture()
    for look, glitter in zip(looks, glitters):
        look.SetGlitter(glitter)
        look.SetOutputToReflectance()
    reflectance = picture()
    for water, look, output in zip(waters, looks, outputs):
        look.SetOutput(output)
        water.VisibilityOff()
    without = picture()
    for water in waters:
        water.VisibilityOn()
    window.Render()
    is_water = (plain != without).any(axis=1) | (reflectance != without).any(axis=1)
    is_white = is_water & (plain >= 255).all(axis=1)
    return int(is_water.sum()), int(is_white.sum()), int((is_white & ~(calm >= 255).all(axis=1)).sum())


def watch():
    """Measure what the last picture of this process is taken from, and write it to WATER_CLIPPED."""
    import atexit

    import vtkmodules.vtkRenderingCore as core

    grabber = core.vtkWindowToImageFilter
    windows, results = [], []

    class Watched(grabber):
        def SetInput(self, window):
            windows[:] = [window]
            super().SetInput(window)

        def Update(self, *arguments):
            super().Update(*arguments)
            self.take()

        def take(self):
            found = measure(windows[0], grabber) if windows else None
            results[:] = [found] if found else results

    def finish():
        if windows and not results:
            found = measure(windows[0], grabber)
            results[:] = [found] if found else []
        if results:
            pathlib.Path(os.environ["WATER_CLIPPED"]).write_text(" ".join(map(str, results[0])))

    core.vtkWindowToImageFilter = Watched
    atexit.register(finish)


def main():
    import gallery

    names = sys.argv[1:] or [*gallery.EXAMPLES, *gallery.PROGRAMS]
    worst = 0.0
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "sitecustomize.py").write_text(HOOK)
        os.environ["PYTHONPATH"] = os.pathsep.join([str(folder), os.environ.get("PYTHONPATH", "")])
        os.environ["WATER_CLIPPED"] = str(folder / "clipped.txt")
        for name in names:
            (folder / "clipped.txt").unlink(missing_ok=True)
            try:
                gallery.render(name, folder / name)
            except subprocess.CalledProcessError:
                print(f"{name:18} failed", flush=True)
                worst = 100.0
                continue
            if not (folder / "clipped.txt").exists():
                print(f"{name:18} no picture of a window with water was taken", flush=True)
                worst = 100.0
                continue
            count, white, glitter = map(int, (folder / "clipped.txt").read_text().split())
            worst = max(worst, 100 * glitter / max(count, 1))
            print(f"{name:18} {count:8} pixels of water, {100 * white / max(count, 1):6.3f} % white, "
                  f"{100 * glitter / max(count, 1):6.3f} % by glitter", flush=True)
    print(f"largest share of the water that glitter clips: {worst:.3f} % (at most {LIMIT} %)")
    return int(worst > LIMIT)


if __name__ == "__main__":
    sys.exit(main())

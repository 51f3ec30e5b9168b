# SPDX-License-Identifier: BSD-3-Clause
"""quality: the lookup's error by texture scale, slope and steps: the table of Documentation/decisions/010-quality.md.

    PYTHONPATH=<folder of vtkwater> python Utilities/Accuracy/quality.py [--size 240 180]

The scene, the truth and the readings are those of the section `lookup`; here the mirrored view is
coarser than the picture. Errors are in pixels of the picture, of two places:

    lookup  the place that the shader looks up, however large a texel is
    texel   the middle of the texel that this place lies in: what can be known of an edge there

Prints a row for each slope, scale and quality, three views together: the median, 90th and 95th
percentile of both, the share of lookups that are off by 4 pixels and more, and how many were counted.

    ... quality.py --time

prints what a frame of the posts takes instead, in waves and in calm water, with the water less without:
medians of frames that take turns, and a + b scale^2 fitted to them.
"""

import argparse
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Testing" / "Python"))

import numpy as np  # noqa: E402
import water_test as wt  # noqa: E402
import wave_scenes  # noqa: E402
from reference import Pixels  # noqa: E402
from tracer import Tracer  # noqa: E402

SLOPES = (0.0, 0.02, 0.05, 0.10, 0.20)
SCALES = (1.0, 0.71, 0.5, 0.35, 0.25)
STEPS = ((1.0, 24, 12), (0.84, 16, 6), (0.71, 16, 6), (0.59, 16, 6), (0.5, 16, 6), (0.42, 16, 6), (0.35, 12, 4),
         (0.25, 8, 3))  # the ladder of Core/quality/water_quality.c: scale, steps, probes
QUALITIES = {"fast": (8, 3), "default": (16, 6), "high": (24, 12)}  # steps, probes


class Case:
    """One view with waves of a slope, and the truth."""

    def __init__(self, view, slope):
        waves = wave_scenes.island_waves(slope) if slope > 0 else ()
        self.made, self.water = wave_scenes.island_scene(view, waves)
        self.size = np.array(wave_scenes.ISLANDS_SIZE)
        self.made.picture()
        tracer = Tracer(self.made.renderer)
        pixels = Pixels(tracer, self.made, self.water, waves, wave_scenes.ISLANDS_SIZE)
        is_water = wt.water_mask(self.made, self.water).ravel() & pixels.is_water
        self._counts = is_water & pixels.is_hit & pixels.is_on_map & pixels.is_seen
        self._end = pixels.end[self._counts]

    def errors(self, scale, steps, probes):
        """Distances in pixels of the picture from the right place: of the lookup, and of its texel."""
        self.water.GetReflectionPass().SetTextureScale(scale)
        look = self.water.GetWaterProperty()
        look.SetRayTraceSteps(steps)
        look.SetRayTraceProbes(probes)
        there = wave_scenes.looked_up(self.made, self.water)[self._counts]
        right, texture = wave_scenes.map_places(
            self.made.renderer.GetActiveCamera(), self.water, self._end, wave_scenes.ISLANDS_SIZE)
        per_pixel = np.floor(self.size * scale + 0.5) / self.size  # texels
        right = 0.5 + (right - 0.5) * per_pixel
        texel = (np.minimum(np.floor(there * texture), texture - 1) + 0.5) / texture
        return [np.linalg.norm((np.clip(place, 0, 1) - right) * texture / per_pixel, axis=1)
                for place in (there, texel)]


def print_times(name, waves, size=(800, 600), rounds=15):
    """Frames take turns, so that what else the machine does hits all alike."""
    made, water = wave_scenes.post_scene("middle", waves, size=size)
    camera = made.renderer.GetActiveCamera()
    settings = {None: STEPS[0], **{step[0]: step for step in STEPS}}
    times = {scale: [] for scale in settings}
    for _ in range(rounds):
        for scale, quality in settings.items():
            water.SetVisibility(scale is not None)
            water.GetReflectionPass().SetTextureScale(quality[0])
            water.GetWaterProperty().SetRayTraceSteps(quality[1])
            water.GetWaterProperty().SetRayTraceProbes(quality[2])
            made.window.Render()  # makes the textures
            made.window.Render()
            camera.Azimuth(0.01)
            start = time.perf_counter()
            made.window.Render()
            made.window.WaitForCompletion()
            times[scale].append(1e3 * (time.perf_counter() - start))
    without = np.median(times.pop(None))
    measured = {scale: np.median(some) - without for scale, some in times.items()}
    scales = np.array(list(measured))
    (b, a) = np.polyfit(scales ** 2, np.array(list(measured.values())), 1)
    print(f"{name}, {size[0]} x {size[1]}: {without:.1f} ms without water; a = {a:.1f} ms, b = {b:.1f} ms")
    for scale, milliseconds in measured.items():
        print(f"scale {scale:.2f}: {milliseconds:.1f} ms, fitted {a + b * scale ** 2:.1f} ms", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", nargs=2, type=int, default=wave_scenes.ISLANDS_SIZE, help="of the picture, pixels")
    parser.add_argument("--time", action="store_true", help="time the steps of the ladder instead")
    arguments = parser.parse_args()
    if arguments.time:
        print_times("waves", wave_scenes.POSTS_WAVES)
        print_times("calm", ())
        return
    wave_scenes.ISLANDS_SIZE = tuple(arguments.size)
    width, height = wave_scenes.ISLANDS_SIZE
    print(f"{width} x {height} pixels, {0.5 * height / np.tan(np.radians(15)):.0f} pixels per radian")
    print("slope scale quality | lookup: median, 90 %, 95 % | texel: median, 90 %, 95 % | lost, % | pixels")
    for slope in SLOPES:
        cases = [Case(view, slope) for view in wave_scenes.ISLANDS_VIEWS]
        for scale in SCALES:
            for name, (steps, probes) in QUALITIES.items():
                if slope == 0 and name != "default":
                    continue  # calm water is not traced
                lookup, texel = (np.concatenate(errors) for errors in zip(
                    *(case.errors(scale, steps, probes) for case in cases)))
                figures = " | ".join(" ".join(f"{figure:6.3f}" for figure in np.percentile(errors, (50, 90, 95)))
                                     for errors in (lookup, texel))
                print(f"{slope:.2f} {scale:.2f} {name:7s} | {figures} | {100 * (lookup >= 4).mean():5.2f} | "
                      f"{len(lookup)}", flush=True)


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: BSD-3-Clause
"""The command vtkwater: renders terrains and meshes in water from the command line.

Exit status: 0, success; 1, failure (a file, no OpenGL); 2, wrong command line; 130, stopped by the user: finished
frames are kept.
"""
import argparse
import math
import os
import re
import sys
import warnings

from . import __version__, backend, movies, readers, vtkWaterProperty
from .data_command import add_data_arguments, check_data, is_data, make_data_water, report, time_of, time_range
from .errors import text_of
from .pictures import check_png
from .words import QUALITIES, TURBIDITY, set_look

__all__ = ["main"]

DONE, FAILED, WRONG_USAGE, STOPPED = 0, 1, 2, 130
EXAMPLES = """examples:
  vtkwater render terrain.tif --level 355 --preset lake --out lake.png
  vtkwater render ship.stl --level 0 --wind 8 --out ship.png
  vtkwater animate terrain.vti --level 350:400 --frames 60 --out flood.gif
  vtkwater render flood.pvd --depth h --bed zb --color-by speed --time 3600 --out flood.png
  vtkwater info
"""


class Failure(Exception):
    """An error that is reported to the user in one line."""


def number(least=-math.inf, most=math.inf, kind=float):
    def parse(text):
        try:
            value = kind(text)
        except ValueError:
            wanted = f"; it must lie in [{least:g}, {most:g}]" if math.isfinite(least) else ""
            number_kind = "whole number" if kind is int else "number"
            raise argparse.ArgumentTypeError(f"{text!r} is not a {number_kind}{wanted}") from None
        if not least <= value <= most:  # also NaN
            raise argparse.ArgumentTypeError(f"{text} must lie in [{least:g}, {most:g}]")
        return value
    return parse


def wind(text):
    try:
        return number(0.0, 0.0)(text)
    except argparse.ArgumentTypeError:
        pass
    try:
        return number(0.1, 100.0)(text)
    except argparse.ArgumentTypeError as error:
        raise argparse.ArgumentTypeError(f"{error} m/s, or be 0") from None


def wave(text):
    parts = text.split(",")
    if not 2 <= len(parts) <= 5:
        raise argparse.ArgumentTypeError(f"{text!r} must have 2 to 5 numbers, separated by commas")
    return tuple(number()(part) for part in parts)


def color(text):
    from vtkmodules.vtkCommonColor import vtkNamedColors

    colors = vtkNamedColors()
    if not colors.ColorExists(text) and not re.fullmatch("#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})", text):
        raise argparse.ArgumentTypeError(f"{text!r} is not a colour; use a name such as navy, or #rrggbb")
    return tuple(part / 255.0 for part in colors.HTMLColorToRGB(text))


def level(text):
    """A number, otherwise the name of an array."""
    try:
        float(text)
    except ValueError:
        return text
    return number(-readers.HIGHEST, readers.HIGHEST)(text)


def level_range(text):
    """Two numbers, otherwise the name of an array."""
    first, colon, last = text.partition(":")
    ends = level(first), level(last if colon else first)
    return text if any(isinstance(end, str) for end in ends) else ends


def size(text):
    width, cross, height = text.lower().partition("x")
    if not cross:
        raise argparse.ArgumentTypeError(f"{text!r} is not a size such as 960x600")
    one = number(16, 16384, int)
    return one(width), one(height)


def preset(text):
    names = [vtkWaterProperty.GetPresetName(i) for i in range(vtkWaterProperty.GetNumberOfPresets())]
    if text not in names:
        raise argparse.ArgumentTypeError(f"{text!r} must be one of {', '.join(names)}")
    return text


def units(text):
    try:
        return float(text)
    except ValueError:
        return text


def add_scene_arguments(parser):
    water = parser.add_argument_group("the water")
    water.add_argument("--preset", type=preset, metavar="NAME",
                       help="pool, lake, 'clear tropical', 'ocean wind 5', 'ocean wind 10', 'ocean wind 15', "
                            "'turbid river' or 'mirror floor'; default: a calm, deep lake")
    water.add_argument("--wind", type=wind, metavar="M/S",
                       help="wind sea for this wind speed, 0.1 to 100; replaces the preset's waves; "
                            "0: calm water")
    water.add_argument("--wind-direction", type=number(-360.0, 360.0), metavar="DEG",
                       help="direction in which the wind blows, from x (east, 0) towards y (north, 90); default 0")
    water.add_argument(
        "--waves",
        type=wave,
        action="append",
        metavar="A,L[,D[,P[,S]]]",
        help="a wave that replaces the preset's: amplitude and wavelength (m), direction of travel and "
        "phase (degrees), steepness (0 to 1); repeat for more waves; not together with --wind",
    )
    water.add_argument("--color", type=color, metavar="COLOR",
                       help="colour of deep water: a name such as navy, or #rrggbb")
    water.add_argument("--opacity", type=number(0.0, 1.0), metavar="SHARE",
                       help="opacity, 0 to 1; below 1 the water is blended with what lies behind it")
    water.add_argument("--refraction", action=argparse.BooleanOptionalAction,
                       help="whether the scene is visible through the surface; default: as in the preset; "
                            "without a preset yes, unless --color or --opacity is given")
    water.add_argument("--foam", type=number(0.0, 1e9), nargs="?", const=True, metavar="M",
                       help="depth in metres below which the shore foams; without a number 0.25, and with "
                            "automatic units at least 1/400 of the scene's diagonal; turns refraction on")
    water.add_argument(
        "--caustics",
        type=number(0.0, 1.0),
        nargs="?",
        const=True,
        metavar="SHARE",
        help="strength of the light that waves focus under the surface, 0 to 1, 0.8 without a number; turns "
        "refraction on",
    )
    water.add_argument("--shadows", action=argparse.BooleanOptionalAction,
                       help="whether objects cast shadows on the water's glitter and foam; default no")
    water.add_argument("--quality", choices=QUALITIES, help="quality of reflections on waves; default: default")
    water.add_argument("--units", type=units, metavar="UNIT",
                       help="length unit of the file: um, mm, cm, m, km, in, ft, mi or a number of metres; default: m "
                            "for terrains and with --waves, otherwise automatic, from the file's size")
    water.add_argument("--horizon", action="store_true",
                       help="extend the water to the horizon; by default it extends 50 times the width of the "
                            "ground")
    view = parser.add_argument_group("the view")
    view.add_argument("--azimuth", type=number(-360.0, 360.0), default=200.0, metavar="DEG",
                      help="direction of the eye, from north (0) towards east (90); default %(default)s")
    view.add_argument("--elevation", type=number(0.5, 90.0), default=8.0, metavar="DEG",
                      help="elevation of the eye above the horizon; default %(default)s")
    view.add_argument("--zoom", type=number(0.01, 1000.0), default=1.0, metavar="X",
                      help="2 shows half of the width; default 1: everything above the water, and its reflection")
    view.add_argument("--sun", type=number(-360.0, 360.0), default=None, metavar="DEG",
                      help="azimuth of the sun, from north towards east; default: to the right of the eye")
    view.add_argument("--sky", type=number(2.0, 10.0), nargs="?", const=TURBIDITY, metavar="TURBIDITY",
                      help="show a clear sky instead of the gradient, with this turbidity: 2 (very clear) to 10 "
                           "(hazy), 3 without a number")
    view.add_argument("--size", type=size, default=(960, 600), metavar="WxH", help="pixels; default 960x600")
    ground = parser.add_argument_group("the ground")
    ground.add_argument("--exaggeration", type=number(1e-6, 1e6), default=1.0, metavar="X",
                        help="factor of the heights; terrains only")
    ground.add_argument("--no-data", type=number(), metavar="HEIGHT",
                        help="additional no-data value; NaN, values beyond 1e9 and the file's own no-data value are "
                             "always holes, and holes are not filled")


def make_parser():
    parser = argparse.ArgumentParser(
        prog="vtkwater", description="Renders terrains and meshes in water that reflects them.", epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--version", action="version", version=f"vtkwater {__version__}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    kinds = f"a terrain or mesh: {' '.join(readers.KINDS)}"

    render = commands.add_parser("render", help="render a picture of a file in water", epilog=EXAMPLES,
                                 formatter_class=argparse.RawDescriptionHelpFormatter)
    render.add_argument("file", help=kinds)
    render.add_argument("--level", type=level, metavar="LEVEL|ARRAY",
                        help="height of the water, in the file's unit: a number, or an array of a solver's file")
    render.add_argument("--out", default="water.png", metavar="FILE",
                        help="output picture, a PNG; default %(default)s")
    render.add_argument("--time", type=number(-1e15, 1e15), metavar="S",
                        help="time of the waves in s, default 0; for a solver's file its time, in the file's unit, "
                             "also between its steps, default the first step")
    render.add_argument("--step", type=number(-100000, 100000, int), metavar="N",
                        help="step of a solver's file, instead of the time: 0 is the first, -1 the last")
    add_scene_arguments(render)
    add_data_arguments(render, number)

    animate = commands.add_parser("animate", help="render a movie with waves and a changing level", epilog=EXAMPLES,
                                  formatter_class=argparse.RawDescriptionHelpFormatter)
    animate.add_argument("file", help=kinds)
    animate.add_argument("--level", type=level_range, metavar="LEVEL[:LAST]|ARRAY",
                         help="height of the water, in the file's unit: a number, or the first and "
                              "the last of the animation, or an array of a solver's file")
    animate.add_argument("--times", type=time_range, metavar="FIRST:LAST",
                         help="times of a solver's file, in its unit; default: all of it")
    animate.add_argument("--frames", type=number(1, 100000, int), default=48, metavar="N",
                         help="number of frames; default %(default)s")
    animate.add_argument("--fps", type=number(0.1, 100.0), default=12.0, metavar="N",
                         help="frames per second of the movie and the waves; default 12")
    animate.add_argument("--out", default="water.gif", metavar="FILE",
                         help=f"{', '.join(movies.KINDS)} (a name without a suffix); default %(default)s. "
                              "Ctrl-C stops, and keeps the finished frames")
    add_scene_arguments(animate)
    add_data_arguments(animate, number)

    commands.add_parser("info", help="print versions, and the renderer in use")
    return parser


def words_of(arguments):
    """The command line's settings of the look, for set_look."""
    blows = arguments.wind if arguments.wind_direction is None else (arguments.wind, arguments.wind_direction)
    same = ("preset", "waves", "color", "opacity", "refraction", "foam", "caustics", "shadows", "quality", "units")
    return {"wind": blows, **{word: getattr(arguments, word) for word in same}}


def words_for(ground, arguments):
    """The same with the defaults that depend on the file: the unit of a mesh is unknown, and the bed is visible."""
    words = words_of(arguments)
    if words["units"] is None and not words["waves"] and not ground.is_terrain:
        words["units"] = "automatic"
    if all(words[word] is None for word in ("refraction", "preset", "color", "opacity")):
        words["refraction"] = True
    return words


def check_words(parser, arguments):
    """Ends the program if two options contradict each other."""
    if arguments.wind_direction is not None and arguments.wind is None:
        parser.error(f"--wind-direction is {arguments.wind_direction:g}, but there is no --wind")
    try:
        set_look(vtkWaterProperty(), **words_of(arguments))
    except ValueError as error:
        parser.error(str(error))


def progress(steps):
    """The steps, with a bar on a terminal's stderr."""
    try:
        from tqdm import tqdm
    except ImportError:
        return steps
    return tqdm(steps, unit="frame", disable=not sys.stderr.isatty() or None)


def empty_scene(arguments):
    """A scene with its light and sky."""
    from .scenes import Scene

    found = backend.find()
    if found.error:
        raise Failure(found.error)
    if found.window:
        os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", found.window)  # VTK tries X first and says so
    scene = Scene(arguments.size)
    sun = arguments.azimuth - 70.0 if arguments.sun is None else arguments.sun
    if arguments.sky is None:
        scene.set_sun(sun, 35.0)
    else:
        scene.set_clear_sky(sun, 35.0, arguments.sky)
    return scene


def make_scene(arguments, levels):
    """A scene whose ground has its shore at the first level; walls, water and view fit all levels."""
    ground = readers.read(arguments.file, arguments.no_data)
    if ground.note:
        print(f"vtkwater: {arguments.file}: {ground.note}", file=sys.stderr)
    scene = empty_scene(arguments)
    exaggeration = arguments.exaggeration if ground.is_terrain else 1.0
    scene.add_ground(ground, levels[0], exaggeration)
    scene.add_water(min(levels), exaggeration=exaggeration, **words_for(ground, arguments))
    scene.make_island(arguments.horizon)
    scene.look(arguments.azimuth, arguments.elevation, arguments.zoom, max(levels))
    return scene, ground, exaggeration


def warn_of_level(ground, level):
    low, high = ground.data.GetBounds()[4:]
    if not low <= level <= high:
        what = "below the ground: nothing is flooded" if level < low else "above the ground: all of it is flooded"
        print(f"vtkwater: level {level:g} is {what} (its heights are {low:g} to {high:g})", file=sys.stderr)


def render(arguments):
    check_png(arguments.out)
    if is_data(arguments):
        return render_data(arguments)
    scene, ground, _ = make_scene(arguments, [arguments.level])
    warn_of_level(ground, arguments.level)
    scene.water.SetTime(arguments.time or 0.0)
    scene.write(arguments.out)
    print(f"{arguments.out}: {arguments.size[0]} x {arguments.size[1]}, "
          f"reflection {scene.water.GetReflectionPass().GetDecisionAsString()}")
    return DONE


def render_data(arguments):
    water = make_data_water(arguments, words_of(arguments), empty_scene)
    scene = water.scene
    time = time_of(water.solution, arguments)
    is_wet = water.show(time)
    water.water.SetTime(time)
    scene.write(arguments.out)
    report(water, is_wet, time)
    print(f"{arguments.out}: {arguments.size[0]} x {arguments.size[1]}, {water.times_text(time)}, "
          f"reflection {scene.water.GetReflectionPass().GetDecisionAsString()}")
    return DONE


def animate(arguments):
    if is_data(arguments):
        water = make_data_water(arguments, words_of(arguments), empty_scene)
        scene = water.scene
        first, last = arguments.times or (water.solution.times[0], water.solution.times[-1])

        def show(share):
            water.show(first + (last - first) * share)
    else:
        first, last = arguments.level
        scene, ground, exaggeration = make_scene(arguments, arguments.level)
        for level in sorted({first, last}):
            warn_of_level(ground, level)

        def show(share):
            scene.water.SetLevel(exaggeration * (first + (last - first) * share))

    return write_movie(arguments, scene, show)


def write_movie(arguments, scene, show):
    """The frames of an animation; show(share) sets the scene to a share of its length, in [0, 1]."""
    done = 0
    with movies.open_movie(arguments.out, arguments.fps) as movie, movies.interrupts() as is_stopped:
        for i in progress(range(arguments.frames)):
            if is_stopped():
                break
            show(i / max(arguments.frames - 1, 1))
            scene.water.SetTime(i / arguments.fps)
            movie.add(scene.picture())
            done += 1
    print(f"{arguments.out}: {done} of {arguments.frames} frames" + (", stopped" if is_stopped() else ""))
    return STOPPED if is_stopped() else DONE


def info(_):
    from vtkmodules.vtkCommonCore import vtkVersion

    print(f"vtkwater {__version__}\nVTK {vtkVersion.GetVTKVersion()}\nPython {sys.version.split()[0]}")
    found = backend.find()
    if found.error:
        raise Failure(found.error)
    print(f"window {found.window}\nrenderer {found.renderer}\nOpenGL {found.version}")
    return DONE


def main(arguments=None):
    """Runs the command line; returns the exit status."""
    parser = make_parser()
    arguments = parser.parse_args(arguments)
    if arguments.command != "info":
        check_words(parser, arguments)
        check_data(parser, arguments)
    warnings.simplefilter("ignore")  # of the packages beneath
    try:
        return {"render": render, "animate": animate, "info": info}[arguments.command](arguments)
    except (Failure, OSError, ValueError, ImportError) as error:
        print(f"vtkwater: {text_of(error)}", file=sys.stderr)
    except MemoryError:
        print(f"vtkwater: {arguments.file}: does not fit into memory", file=sys.stderr)
    except KeyboardInterrupt:
        print("vtkwater: stopped", file=sys.stderr)
        return STOPPED
    return FAILED

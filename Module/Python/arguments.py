# SPDX-License-Identifier: BSD-3-Clause
"""The options of the command vtkwater, and what they accept."""
import argparse
import difflib
import json
import math
import re

from . import __version__, movies, pictures, readers, vtkWaterProperty
from .data_command import DATA_ELEVATION, add_data_arguments, time_range
from .words import QUALITIES, TURBIDITY

__all__ = ["TERRAIN_ELEVATION", "Parser", "make_parser"]

TERRAIN_ELEVATION = 8  # degrees; it shows the reflections
EXAMPLES = """examples:
  vtkwater render terrain.tif --level 355 --preset lake --out lake.png
  vtkwater render ship.stl --level 0 --wind 8 --out ship.png
  vtkwater animate terrain.vti --level 350:400 --frames 60 --out flood.gif
  vtkwater render flood.pvd --depth h --bed zb --color-by speed --time 3600 --out flood.png
  vtkwater view terrain.tif --level 355 --preset lake
  vtkwater info terrain.tif
"""
WRONG_USAGE = 2  # exit status


class Parser(argparse.ArgumentParser):
    """Accepts options only by their full names; for an unknown one, the error suggests the closest."""

    is_json = False  # are errors JSON?

    def __init__(self, *arguments, **words):
        super().__init__(*arguments, allow_abbrev=False, **words)

    def options(self, has_value=False):
        """The names of its options, and of its commands' options; has_value: of those that take a value."""
        for action in self._actions:
            if not has_value or action.nargs != 0:
                yield from (name for name in action.option_strings if name.startswith("--"))
            if isinstance(action, argparse._SubParsersAction):
                for parser in action.choices.values():
                    yield from parser.options(has_value)

    def of(self, command):
        """The parser of a command."""
        commands = next(action for action in self._actions if isinstance(action, argparse._SubParsersAction))
        return commands.choices[command]

    def parse_args(self, *arguments):
        found, unknown = self.parse_known_args(*arguments)
        if unknown:
            self.of(found.command).error("unrecognized arguments: " + " ".join(unknown))
        return found

    def error(self, message):
        """Print one line: the error, and how to get help. The usage would take another twenty lines."""
        unknown = re.match(r"unrecognized arguments: .*?(--[^\s=]+)", message)
        if unknown:
            close = difflib.get_close_matches(unknown.group(1), sorted(set(self.options())), 1)
            message = f"{unknown.group(1)} is not an option" + (f"; did you mean {close[0]}?" if close else "")
        if Parser.is_json:
            print(json.dumps({"error": message}, ensure_ascii=False), flush=True)
        self.exit(WRONG_USAGE, f"{self.prog}: error: {message}; see {self.prog} --help\n")


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
                            "'turbid river' or 'mirror floor'; default: a calm, clear lake")
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
                       help="whether the scene is visible through the surface; default: no with --color-by, whose "
                            "colours hide the bed; otherwise as in the preset; without a preset yes, unless --color or "
                            "--opacity is given")
    water.add_argument("--own-view", action=argparse.BooleanOptionalAction,
                       help="whether the refracted colours come from an additional view of what lies below the water, "
                            "wider than the picture; turns refraction on; default no")
    water.add_argument("--whitecaps", type=number(0.0, 10.0), nargs="?", const=True, metavar="S",
                       help="foam where the crests of a wind sea break; the number is the time in seconds after which "
                            "1/e of it is left, 3.5 without a number, 0: it vanishes with the crest")
    water.add_argument("--foam", type=number(0.0, 1e9), nargs="?", const=True, metavar="M",
                       help="foam at the shore where the water is shallower than this, in metres; without a number "
                            "0.25, and with automatic units at least 1/400 of the scene's diagonal; turns refraction on")
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
    water.add_argument("--dome-port", type=number(0.0, 1e9), metavar="M",
                       help="radius of a dome port around the camera, m: if the camera is less than this above the "
                            "water, the picture is half above and half under water; turns refraction on; "
                            "default 0: no port")
    water.add_argument("--quality", choices=QUALITIES,
                       help="quality of reflections on waves; without this option: default")
    water.add_argument("--units", type=units, metavar="UNIT",
                       help="length unit of the file: um, mm, cm, m, km, in, ft, mi or a number of metres; default: m "
                            "for terrains, for a solver's file and with --waves; for other meshes automatic, from the "
                            "file's size")
    water.add_argument("--horizon", action="store_true",
                       help="extend the water to the horizon; by default it extends 50 times the width of the "
                            "ground")
    view = parser.add_argument_group("the view")
    view.add_argument("--azimuth", type=number(-360.0, 360.0), default=200.0, metavar="DEG",
                      help="direction of the eye, from north (0) towards east (90); default %(default)s")
    view.add_argument("--elevation", type=number(0.5, 90.0), default=None, metavar="DEG",
                      help=f"elevation of the eye above the horizon; default {TERRAIN_ELEVATION}, and "
                           f"{DATA_ELEVATION} for a solver's file")
    view.add_argument("--zoom", type=number(0.01, 1000.0), default=1.0, metavar="X",
                      help="zoom factor; the default 1 shows everything above the water and its reflection, 2 half "
                           "of that width")
    view.add_argument("--sun", type=number(-360.0, 360.0), default=None, metavar="DEG",
                      help="azimuth of the sun, from north towards east; default: to the right of the eye")
    view.add_argument("--sky", type=number(2.0, 10.0), nargs="?", const=TURBIDITY, metavar="TURBIDITY",
                      help="show a clear sky instead of the gradient, with this turbidity: 2 (very clear) to 10 "
                           "(hazy), 2 without a number; it is seen above the horizon and in reflections; in a view "
                           "from above, the background is the haze below the horizon")
    view.add_argument("--size", type=size, default=(960, 600), metavar="WxH", help="pixels; default 960x600")
    ground = parser.add_argument_group("the ground")
    ground.add_argument("--exaggeration", type=number(1e-6, 1e6), default=1.0, metavar="X",
                        help="factor of the heights; for terrains, and for a solver's file without --contour")
    ground.add_argument("--no-data", type=number(), metavar="HEIGHT",
                        help="additional no-data value; NaN, values beyond 1e9 and the file's own no-data value are "
                             "always holes, and holes are not filled")


def make_parser():
    parser = Parser(
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
                        help=f"output picture: {', '.join(pictures.KINDS)}; default %(default)s")
    add_json(render)
    render.add_argument("--time", type=number(-1e15, 1e15), metavar="S",
                        help="time of the waves in s, default 0; for a solver's file: time of its data in the file's "
                             "unit, which may lie between two steps, default: the first step")
    render.add_argument("--step", type=number(-100000, 100000, int), metavar="N",
                        help="step of a solver's file, instead of the time: 0 is the first, -1 the last")
    add_scene_arguments(render)
    add_data_arguments(render, number)

    animate = commands.add_parser("animate", help="render a movie with waves and a changing level", epilog=EXAMPLES,
                                  formatter_class=argparse.RawDescriptionHelpFormatter)
    animate.add_argument("file", help=kinds)
    animate.add_argument("--level", type=level_range, metavar="LEVEL[:LAST]|ARRAY",
                         help="height of the water, in the file's unit: a number, two numbers for the first and the "
                              "last frame, or an array of a solver's file")
    animate.add_argument("--times", type=time_range, metavar="FIRST:LAST",
                         help="times of a solver's file, in its unit; default: all")
    animate.add_argument("--frames", type=number(1, 100000, int), default=48, metavar="N",
                         help="number of frames; default %(default)s")
    animate.add_argument("--fps", type=number(0.1, 100.0), default=12.0, metavar="N",
                         help="frames per second of the movie and the waves; default 12")
    animate.add_argument("--out", default="water.gif", metavar="FILE",
                         help=f"{', '.join(movies.KINDS)} (a name without a suffix); default %(default)s. "
                              "Ctrl-C stops, and keeps the finished frames")
    add_json(animate)
    add_scene_arguments(animate)
    add_data_arguments(animate, number)

    view = commands.add_parser("view", help="show a file in water in a window, to turn it and change the level",
                               epilog=EXAMPLES, formatter_class=argparse.RawDescriptionHelpFormatter)
    view.add_argument("file", help=kinds)
    view.add_argument("--level", type=level, metavar="LEVEL|ARRAY",
                      help="initial height of the water, in the file's unit: a number, or an array of a solver's "
                           "file")
    view.add_argument("--out", default="water.png", metavar="FILE",
                      help="picture that the key Return writes; default %(default)s")
    view.add_argument("--time", type=number(-1e15, 1e15), metavar="S",
                      help="initial time of the waves in s, default 0; for a solver's file: initial time of its data in "
                           "the file's unit, default: the first step")
    view.add_argument("--step", type=number(-100000, 100000, int), metavar="N",
                      help="step of a solver's file, instead of the time: 0 is the first, -1 the last")
    add_scene_arguments(view)
    add_data_arguments(view, number)

    info = commands.add_parser("info", help="print what a file holds; without a file, versions, the renderer and, for "
                                             "a wheel, the folder for CMake")
    info.add_argument("file", nargs="?",
                      help="a file, or a folder of GeoTIFF files: print its bounds, unit, steps and arrays, and "
                           "options to try; without it, versions and the renderer")
    add_json(info)
    return parser


def add_json(parser):
    parser.add_argument("--json", action="store_true",
                        help="print the result, or the error, as one JSON object; messages stay on stderr")

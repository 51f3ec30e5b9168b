# SPDX-License-Identifier: BSD-3-Clause
"""The part of the command vtkwater that shows what a solver wrote: its options, and the scene they make."""
import argparse
import pathlib
import sys

from . import readers, solutions, tiff_stack
from .data_scenes import COLOR_MAPS, DataWater
from .vertex_data import FOAM_MEASURES, VertexData

__all__ = ["DATA_ELEVATION", "add_data_arguments", "check_data", "is_data", "make_data_water", "report", "time_of",
           "time_range"]

DATA_ELEVATION = 30  # degrees; it shows the data on the water
ELSEWHERE = {"horizon": False, "no_data": None}  # options that a solver's mesh has no use for


def add_data_arguments(parser, number):
    """number(least, most): the type of a number in a range."""
    group = parser.add_argument_group(
        "the data", "A solver's file: arrays of its points or cells define the water; two of level, depth and bed are "
        "enough. A folder of GeoTIFF files is a series: depth_0 and depth_600 are the array depth at two "
        "times, and bed is the array bed. More file types: "
        + " ".join(kind for kind in solutions.KINDS if kind not in readers.KINDS))
    group.add_argument("--depth", metavar="ARRAY", help="depth of the water")
    group.add_argument("--bed", metavar="ARRAY", help="height of the bed; default: the level minus the depth or, "
                       "with the depth alone, the mesh's own z")
    group.add_argument("--dry-depth", type=number(0.0, 1e9), metavar="DEPTH",
                       help="depth up to which a place is dry; default 0.001")
    group.add_argument("--contour", metavar="ARRAY",
                       help="array of a volume, instead of level, depth and bed: the water's surface is its contour "
                            "at --contour-value")
    group.add_argument("--contour-value", type=number(), metavar="VALUE",
                       help="value of the contour; default 0.5, for a volume fraction")
    group.add_argument("--color-by", metavar="ARRAY", help="array that colours the water; vectors by their "
                       "magnitude")
    group.add_argument("--flow", metavar="ARRAY", help="velocity of a current, m/s, that carries the small waves; "
                       "give the water some with --preset, --wind or --waves")
    group.add_argument("--matter", metavar="ARRAY", help="concentration of matter that the water carries, such as "
                       "sediment or a dye: it absorbs and scatters light, and colours deep water")
    for word, what, default in (("absorption", "absorbs", "0.0032,0.0110,0.0376"),
                                ("scattering", "scatters back", "0.012,0.012,0.012")):
        group.add_argument(f"--matter-{word}", type=three_numbers, metavar="R,G,B",
                           help=f"what the matter {what} at 650, 550 and 450 nm, 1/m per unit of its concentration; "
                                f"default {default}, for mineral sediment in g/m^3")
    group.add_argument("--foam-by", metavar="ARRAY", help="array that says how much foam there is")
    group.add_argument("--foam-measure", choices=FOAM_MEASURES, help="what the values of --foam-by are: the share of "
                       "the surface that foam covers (the default), Froude numbers, or heights of waves over the depth")
    group.add_argument("--cmap", metavar="NAME", help=f"colour map: {', '.join(COLOR_MAPS)}, or any of matplotlib's "
                       "if it is installed; default viridis")
    group.add_argument("--clim", type=color_range, metavar="LOW:HIGH",
                       help="values of the first and the last colour; default: the range over all steps of the file, "
                            "which must all be read")
    group.add_argument("--log-scale", action="store_true", default=None,
                       help="colours on a logarithmic scale; the range then begins with the smallest value above 0")
    group.add_argument("--scalar-bar", action=argparse.BooleanOptionalAction, default=None,
                       help="show a scalar bar; default: with --color-by")
    group.add_argument("--lonlat", action=argparse.BooleanOptionalAction, default=None,
                       help="whether x and y are longitude and latitude in degrees; default: by the units of a NetCDF "
                            "file's coordinates or the names of its dimensions")


def pair(text, what):
    first, colon, last = text.partition(":")
    try:
        if colon:
            return float(first), float(last)
    except ValueError:
        pass
    raise argparse.ArgumentTypeError(f"{text!r} must be {what}, separated by a colon")


def three_numbers(text):
    try:
        red, green, blue = map(float, text.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} must be three numbers such as 0.1,0.3,0.9") from None
    return red, green, blue


def color_range(text):
    return pair(text, "two values such as 0:3")


def time_range(text):
    return pair(text, "two times such as 0:3600")


def is_data(arguments):
    return isinstance(arguments.level, str) or any((arguments.depth, arguments.bed, arguments.contour))


def check_data(parser, arguments):
    """End the program if options of data contradict each other, or are used without data."""
    kind = pathlib.Path(arguments.file).suffix.lower()
    if not is_data(arguments):
        for word in ("dry_depth", "contour_value", "color_by", "flow", "matter", "matter_absorption",
                     "matter_scattering", "foam_by", "foam_measure", "cmap", "clim", "log_scale", "scalar_bar", "lonlat",
                     "step", "times"):
            if getattr(arguments, word, None) is not None:
                parser.error(f"--{word.replace('_', '-')} needs an array that defines the water: add "
                             "--depth, --level with --bed, --contour, or the name of an array as --level")
        if tiff_stack.is_stack(arguments.file):
            parser.error(f"{arguments.file} is a folder; a folder of GeoTIFF files needs two of its arrays, such "
                         f"as --depth depth --bed bed (vtkwater info {arguments.file} lists its arrays)")
        if arguments.level is None:
            if not pathlib.Path(arguments.file).exists():
                parser.error(f"{arguments.file}: no such file")
            parser.error("--level is missing: the height of the water in the file's unit, or for a solver's file the "
                         f"name of an array (vtkwater info {arguments.file} suggests one)")
        return
    is_stack = pathlib.Path(arguments.file).is_dir()
    if kind not in solutions.KINDS and not is_stack:
        if isinstance(arguments.level, str):
            parser.error(f"argument --level: {arguments.level!r} is not a number, and a file "
                         f"{f'of the type {kind}' if kind else 'without a suffix'} has no arrays")
        parser.error(f"{arguments.file}: arrays can be read only from {', '.join(solutions.KINDS)}")
    for word, default in ELSEWHERE.items():
        if getattr(arguments, word) != default:
            parser.error(f"--{word.replace('_', '-')} does not apply to the water of a solver's mesh")
    if isinstance(arguments.level, tuple) and arguments.level[0] != arguments.level[1]:
        parser.error("--level is a range; with data of a solver it must be one number or the name of an array")
    if arguments.contour and any((arguments.level is not None, arguments.depth, arguments.bed)):
        parser.error("--contour defines the surface; remove --level, --depth and --bed")
    if arguments.contour_value is not None and not arguments.contour:
        parser.error("--contour-value needs --contour")
    if arguments.bed and arguments.level is None and not arguments.depth:
        parser.error("--bed alone does not define the water: add --level or --depth")
    if not arguments.color_by:
        for word in ("cmap", "clim", "log_scale", "scalar_bar"):
            if getattr(arguments, word) is not None:
                parser.error(f"--{word.replace('_', '-')} needs --color-by")
    try:
        vertex_data_of(arguments).check_colors(arguments.color_by, None)
    except ValueError as error:
        parser.error(str(error))
    if getattr(arguments, "step", None) is not None and arguments.time is not None:
        parser.error("--step and --time are both given; use only one of them")


def vertex_data_of(arguments):
    return VertexData(**{word: getattr(arguments, word) for word in (
        "flow", "matter", "matter_absorption", "matter_scattering", "foam_by", "foam_measure")})


def make_data_water(arguments, words, make_scene):
    """The water of a solver's file, its bed, and the view, in a scene that is made when the file is read."""
    level = arguments.level[0] if isinstance(arguments.level, tuple) else arguments.level
    names = {"level": level if isinstance(level, str) else None, "depth": arguments.depth, "bed": arguments.bed,
             "contour": arguments.contour, "color_by": arguments.color_by}
    data = vertex_data_of(arguments)
    read = [*filter(None, names.values()), *data.given().values()]
    solution = solutions.Solution(arguments.file, dict.fromkeys(read),
                                  bool(arguments.contour), arguments.lonlat,
                                  read_ahead=arguments.command == "animate")
    scene = make_scene(arguments)
    words["units"] = words["units"] or "m"
    hides = arguments.color_by and not any(words[word] for word in ("foam", "caustics", "dome_port", "matter"))
    if words["refraction"] is None and hides:
        words["refraction"] = False  # the data hide what it would show
    value = 0.5 if arguments.contour_value is None else arguments.contour_value
    names.update(level=level, data=data, contour=(arguments.contour, value) if arguments.contour else None)
    water = DataWater(scene, solution, cmap=arguments.cmap, clim=arguments.clim,
                      log_scale=bool(arguments.log_scale), dry_depth=arguments.dry_depth,
                      exaggeration=1.0 if arguments.contour else arguments.exaggeration, **names, **words)
    if arguments.color_by and arguments.scalar_bar is not False:
        unit = solution.unit_of(arguments.color_by)
        water.bar(arguments.color_by + (f", {unit}" if unit not in ("", "1") else ""))
    elevation = DATA_ELEVATION if arguments.elevation is None else arguments.elevation
    scene.look(arguments.azimuth, elevation, arguments.zoom, all_of_it=True)
    for note in water.notes:
        print(f"vtkwater: {solution.path}: {note}", file=sys.stderr)
    return water


def report(water, is_wet, time):
    """Print what a user may not expect of a picture."""
    if not is_wet:
        print(f"vtkwater: nothing is wet at time {time:g}", file=sys.stderr)
    if water.solution.note:
        print(f"vtkwater: {water.solution.path}: {water.solution.note}", file=sys.stderr)


def time_of(solution, arguments):
    """The time that a picture shows: that of --step, or --time, or the first."""
    step = arguments.step
    if step is None:
        return solution.times[0] if arguments.time is None else arguments.time
    count = len(solution.times)
    if not -count <= step < count:
        raise readers.FileError(f"{solution.path}: there is no step {step}; steps are 0 to {count - 1}")
    return solution.times[step]

# SPDX-License-Identifier: BSD-3-Clause
"""The command vtkwater: renders terrains and meshes in water from the command line.

Exit status: 0, success; 1, failure (a file, no OpenGL); 2, wrong command line; 130, stopped by the user: finished
frames are kept.
"""
import json
import os
import re
import select
import sys
import warnings
from pathlib import Path

from . import __version__, backend, movies, readers, solutions, vtkWaterProperty
from .arguments import TERRAIN_ELEVATION, Parser, make_parser
from .data_command import check_data, is_data, make_data_water, report, time_of
from .errors import text_of
from .pictures import check_picture
from .words import set_look

__all__ = ["main"]

DONE, FAILED, WRONG_USAGE, STOPPED = 0, 1, 2, 130


class Failure(Exception):
    """An error that is reported to the user in one line."""


def words_of(arguments):
    """The command line's settings of the look, for set_look."""
    blows = arguments.wind if arguments.wind_direction is None else (arguments.wind, arguments.wind_direction)
    same = ("preset", "waves", "whitecaps", "color", "opacity", "refraction", "own_view", "foam", "caustics",
            "shadows", "dome_port", "quality", "units")
    return {"wind": blows, "matter": getattr(arguments, "matter", None),
            **{word: getattr(arguments, word) for word in same}}


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
    with warnings.catch_warnings(record=True) as advice:
        warnings.simplefilter("always")
        try:
            set_look(vtkWaterProperty(), **words_of(arguments))
        except ValueError as error:
            parser.error(str(error))
    for warning in advice:
        print(f"vtkwater: {warning.message}", file=sys.stderr)


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
    if found.window and arguments.command != "view":
        os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", found.window)  # VTK tries X first and says so
    scene = Scene(arguments.size)
    sun = arguments.azimuth - 70.0 if arguments.sun is None else arguments.sun
    if arguments.sky is None:
        scene.set_sun(sun, 35.0)
    else:
        scene.set_clear_sky(sun, 35.0, arguments.sky)
    return scene


def check_ground(file):
    """Raise a Failure if only a solver writes files of this type: the water is defined by its arrays."""
    path = Path(file)
    kind = path.suffix.lower()
    if kind in solutions.KINDS and kind not in readers.KINDS and path.is_file():
        from .contents import contents_of

        arrays = [f"{array['name']} ({array['of']})" for array in contents_of(path)["arrays"]]
        raise Failure(f"{file}: a solver's file needs --depth, --level with --bed, or --contour for a volume; its "
                      f"arrays are: {', '.join(arrays) or 'none'}")


def make_scene(arguments, levels):
    """A scene whose ground has its shore at the first level; walls, water and view fit all levels."""
    check_ground(arguments.file)
    ground = readers.read(arguments.file, arguments.no_data)
    if ground.note:
        print(f"vtkwater: {arguments.file}: {ground.note}", file=sys.stderr)
    scene = empty_scene(arguments)
    exaggeration = arguments.exaggeration if ground.is_terrain else 1.0
    scene.add_ground(ground, levels[0], exaggeration)
    scene.add_water(min(levels), exaggeration=exaggeration, **words_for(ground, arguments))
    scene.make_island(arguments.horizon)
    elevation = TERRAIN_ELEVATION if arguments.elevation is None else arguments.elevation
    scene.look(arguments.azimuth, elevation, arguments.zoom, max(levels))
    return scene, ground, exaggeration


def warn_of_level(ground, level):
    low, high = ground.data.GetBounds()[4:]
    if not low <= level <= high:
        what = "below the ground: nothing is flooded" if level < low else "above the ground: all of it is flooded"
        print(f"vtkwater: level {level:g} is {what} (its heights are {low:g} to {high:g})", file=sys.stderr)


def render(arguments):
    check_picture(arguments.out)
    if is_data(arguments):
        return render_data(arguments)
    scene, ground, _ = make_scene(arguments, [arguments.level])
    warn_of_level(ground, arguments.level)
    scene.water.SetTime(arguments.time or 0.0)
    scene.write(arguments.out)
    tell_picture(arguments, scene, arguments.time or 0.0, arguments.level)
    return DONE


def tell_picture(arguments, scene, time, level, times_text=""):
    """Print what was written; a number for each value with --json."""
    decision = scene.water.GetReflectionPass().GetDecisionAsString()
    width, height = arguments.size
    if arguments.json:
        print_json({"file": arguments.out, "width": width, "height": height, "time": time,
                    "level": level,
                    "reflection": decision})
    else:
        print(f"{arguments.out}: {width} x {height}, {times_text}reflection {decision}")


def print_json(facts):
    print(json.dumps(facts, ensure_ascii=False), flush=True)


def render_data(arguments):
    water = make_data_water(arguments, words_of(arguments), empty_scene)
    scene = water.scene
    time = time_of(water.solution, arguments)
    is_wet = water.show(time)
    water.water.SetTime(time)
    scene.write(arguments.out)
    report(water, is_wet, time)
    level = arguments.level if isinstance(arguments.level, float) else water.level
    tell_picture(arguments, scene, time, level, f"{water.times_text(time)}, ")
    return DONE


def animate(arguments):
    if is_data(arguments):
        water = make_data_water(arguments, words_of(arguments), empty_scene)
        scene = water.scene
        first, last = arguments.times or (water.solution.times[0], water.solution.times[-1])
        water.solution.check_time(first)
        water.solution.check_time(last)

        def show(share):
            water.show(first + (last - first) * share)
    else:
        first, last = arguments.level
        scene, ground, exaggeration = make_scene(arguments, arguments.level)
        for level in sorted({first, last}):
            warn_of_level(ground, level)

        def show(share):
            scene.water.SetLevel(exaggeration * (first + (last - first) * share))

    status = write_movie(arguments, scene, show)
    if is_data(arguments) and water.solution.note:
        print(f"vtkwater: {water.solution.path}: {water.solution.note}", file=sys.stderr)
    return status


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
    if arguments.json:
        print_json({"file": arguments.out, "frames": done, "of": arguments.frames, "stopped": bool(is_stopped())})
    else:
        print(f"{arguments.out}: {done} of {arguments.frames} frames" + (", stopped" if is_stopped() else ""))
    return STOPPED if is_stopped() else DONE


def view(arguments):
    from .view import Viewer, interactor_of

    check_picture(arguments.out)
    if is_data(arguments):
        water = make_data_water(arguments, words_of(arguments), empty_scene)
        scene, levels, exaggeration = water.scene, None, 1.0
        time = time_of(water.solution, arguments)
        report(water, water.show(time), time)
    else:
        water, time = None, arguments.time or 0.0
        scene, ground, exaggeration = make_scene(arguments, [arguments.level])
        warn_of_level(ground, arguments.level)
        low, high = ground.data.GetBounds()[4:]
        levels = min(low, arguments.level), max(high, arguments.level)
    backend.check_display(scene.window, "write a picture: vtkwater render")
    viewer = Viewer(scene, interactor_of(scene), arguments.out, levels=levels, exaggeration=exaggeration,
                    data=water, time=time)
    print(viewer.help)
    viewer.run()
    return DONE


def info(arguments):
    if arguments.file is not None:
        from .contents import contents_of, text_of as lines_of

        facts = contents_of(arguments.file)
        print_json(facts) if arguments.json else print(lines_of(facts))
        return DONE
    return info_of_machine(arguments)


def info_of_machine(arguments):
    from vtkmodules.vtkCommonCore import vtkVersion

    facts = {"vtkwater": __version__, "VTK": vtkVersion.GetVTKVersion(), "Python": sys.version.split()[0]}
    here = Path(__file__).parent
    if (here / "lib/cmake/vtkWater").is_dir():  # of a wheel
        facts["CMAKE_PREFIX_PATH"] = str(here)
    found = backend.find()
    if found.error:
        print("\n".join(f"{name} {value}" for name, value in facts.items()), file=sys.stderr)
        raise Failure(found.error)
    facts.update(window=found.window, renderer=found.renderer, OpenGL=found.version)
    if arguments.json:
        print_json(facts)
    else:
        print("\n".join(f"{name} {value}" for name, value in facts.items()))
    return DONE


def tell_failure(arguments, text):
    print(f"vtkwater: {text}", file=sys.stderr)
    if getattr(arguments, "json", False):
        print_json({"error": text})


def main(arguments=None):
    """Runs the command line; returns the exit status."""
    try:
        return run(arguments)
    except BrokenPipeError:
        if has_no_reader():
            return DONE
        raise
    finally:
        if has_no_reader():  # nor has what Python writes when it ends
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def has_no_reader():
    """Whether the program that reads the output has ended, such as head."""
    try:
        sys.stdout.flush()
        output = sys.stdout.fileno()
    except BrokenPipeError:
        return True
    except (AttributeError, OSError, ValueError):  # no file, as in a test
        return False
    if not hasattr(select, "poll"):  # Windows
        return False
    poll = select.poll()
    poll.register(output, 0)
    return any(event & select.POLLERR for _, event in poll.poll(0))


NUMBERS = re.compile(r"-[\d.][\d.eE+:,-]*")  # that begin with a minus, such as -1:1


def joined(arguments, options):
    """With --option=-1:1 for --option -1:1, which is two options to argparse; options: those that take a value."""
    made = []
    for argument in arguments:
        if made and made[-1] in options and NUMBERS.fullmatch(argument):
            made[-1] += f"={argument}"
        else:
            made.append(argument)
    return made


def run(arguments):
    parser = make_parser()
    arguments = sys.argv[1:] if arguments is None else arguments
    Parser.is_json = "--json" in arguments
    arguments = parser.parse_args(joined(arguments, set(parser.options(has_value=True))))
    if arguments.command != "info":
        check_words(parser.of(arguments.command), arguments)
        check_data(parser.of(arguments.command), arguments)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of the packages beneath
            return {"render": render, "animate": animate, "view": view, "info": info}[arguments.command](arguments)
    except (Failure, OSError, ValueError, ImportError) as error:
        if isinstance(error, BrokenPipeError) and has_no_reader():
            return DONE
        tell_failure(arguments, text_of(error))
    except MemoryError:
        tell_failure(arguments, f"{arguments.file}: does not fit into memory")
    except KeyboardInterrupt:
        print("vtkwater: stopped", file=sys.stderr)
        return STOPPED
    return FAILED

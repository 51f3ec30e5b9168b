# SPDX-License-Identifier: BSD-3-Clause
"""gallery: renders the pictures of Documentation/gallery.md and recipes.md, or compares them with the kept ones.

usage: gallery.py [--check FOLDER] [PICTURE...]    default: all of them

--check FOLDER writes what the examples make under FOLDER, and compares it with Documentation/images
(compare_pictures.py). It ends with 1 if a picture differs, if an example takes longer than LIMIT_S, or if glitter clips
more than 1 % of the water's pixels (clipped.py). Run it with a Python that has vtkwater (and Pillow, without --check),
and a window to render in.
"""
import argparse
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

import clipped
import compare_pictures

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Utilities/Site"))
import recipes  # noqa: E402

# picture -> the script, when its name is another, and the arguments; PICTURE is the file to write
EXAMPLES = {
    "lake": ["Examples/Data/jacksboro.vti", "FOLDER"],
    "lakes": ["PICTURE"],
    "flood": ["--picture", "PICTURE"],
    "tide": ["FOLDER/tide.gif", "--frames", "10", "--picture", "PICTURE"],
    "rain_flood": ["FOLDER/rain_flood.gif", "--frames", "2", "--picture", "PICTURE"],
    "dam_flood": ["FOLDER/dam_flood.gif", "--dam", "--frames", "2", "--picture", "PICTURE"],
    "wake": ["PICTURE"],
    "strait": ["PICTURE", "--movie", "FOLDER/strait.gif", "--frames", "2"],
    "breakwater": ["PICTURE", "--movie", "FOLDER/breakwater.gif", "--frames", "2"],
    "dam_break": ["PICTURE", "--movie", "FOLDER/dam_break.gif", "--frames", "2"],
    "hull": ["PICTURE"],
    "reservoir": ["PICTURE"],
    "harbour": ["PICTURE"],
    "molecule": ["PICTURE"],
    "batch": ["--out", "FOLDER", "--make", "4"],
    "sea": ["PICTURE", "2"],
    "wind_farm": ["PICTURE", "3"],
    "waves": ["PICTURE", "2"],
    "swell": ["PICTURE", "2.4"],
    "cove": ["PICTURE", "1"],
    "cove_below": ["PICTURE", "1", "below"],
    "cove_split": ["PICTURE", "1", "split"],
    "first_water": ["PICTURE"],
    "pyvista_water": ["PICTURE"],
}
SCRIPTS = {"cove_below": "cove", "cove_split": "cove", "dam_flood": "rain_flood"}
MADE = {"batch": "step_003.png", "lake": "lake.png"}  # where the picture's name is not ours to give
LOSSLESS = ("first_water", "pyvista_water")
QUALITY = 88
MOVIE_BYTES = 40000  # frames of one colour stay far below
LIMIT_S = 30.0  # for each example, with software rendering on two cores

PROGRAMS = {name: recipe for recipe in recipes.read(ROOT / "Documentation/recipes.md") for name in recipe.pictures}


def render(name, folder):
    """Run the example or recipe; returns the picture that it made under the folder."""
    folder.mkdir(parents=True, exist_ok=True)
    if name in PROGRAMS:
        recipes.run(PROGRAMS[name], folder)
        return folder / f"{name}.png"
    picture = folder / MADE.get(name, f"{name}.png")
    arguments = [argument.replace("PICTURE", str(picture)).replace("FOLDER", str(folder))
                 for argument in EXAMPLES[name]]
    movies = [pathlib.Path(argument) for argument in arguments if argument.endswith(".gif")]
    for file in (picture, *movies):
        file.unlink(missing_ok=True)  # of an earlier run
    script = ROOT / f"Examples/Python/{SCRIPTS.get(name, name)}.py"
    subprocess.run([sys.executable, script, *arguments], check=True, cwd=ROOT)
    for movie in movies:
        if not movie.is_file() or movie.stat().st_size < MOVIE_BYTES:
            sys.exit(f"gallery: {movie}: no movie of {MOVIE_BYTES} bytes or more was written")
    return picture


def kept(name):
    return ROOT / f"Documentation/images/{name}.{'png' if name in LOSSLESS else 'jpg'}"


def processor_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def is_in_time(name, seconds, processor):
    """Whether an example keeps the limit. A busy machine lengthens the run, but not its time on the processor."""
    took = min(seconds, processor)
    print(f"{name}: {seconds:.1f} s, {processor:.1f} s on the processor (limit {LIMIT_S:.0f}) "
          f"{'ok' if took <= LIMIT_S else 'FAILED'}")
    return took <= LIMIT_S


def check(name, folder):
    """Render a picture. Returns whether it shows what the kept one shows, was rendered in time, and is not burnt out."""
    start, processor = time.monotonic(), processor_seconds()
    with clipped.watching() as measured:
        picture = render(name, folder)
        share, measuring = clipped.share(name, measured)
    in_time = is_in_time(name, time.monotonic() - start, processor_seconds() - processor - measuring)
    return compare_pictures.check(picture, kept(name)) and in_time and share <= clipped.LIMIT


def keep(name):
    """Render a picture, and keep it in Documentation/images."""
    from PIL import Image

    with tempfile.TemporaryDirectory() as folder:
        Image.open(render(name, pathlib.Path(folder))).convert("RGB").save(kept(name), quality=QUALITY, optimize=True)
    print(kept(name).relative_to(ROOT), kept(name).stat().st_size)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("pictures", nargs="*", choices=[[], *EXAMPLES, *PROGRAMS], metavar="PICTURE",
                        help="default: all")
    parser.add_argument("--check", metavar="FOLDER", type=pathlib.Path, help="compare with the kept pictures instead")
    arguments = parser.parse_args()
    names = arguments.pictures or [*EXAMPLES, *PROGRAMS]
    if not arguments.check:
        for name in names:
            keep(name)
        return 0
    folder = arguments.check.resolve()
    return min(1, sum(not check(name, folder / name) for name in names))


if __name__ == "__main__":
    try:
        sys.exit(main())
    except subprocess.CalledProcessError as error:
        print(error.output or "", end="", file=sys.stderr)  # of a recipe; others have said why
        sys.exit(error.returncode)

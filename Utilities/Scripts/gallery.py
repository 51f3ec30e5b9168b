# SPDX-License-Identifier: BSD-3-Clause
"""gallery: renders the examples' pictures for Documentation/gallery.md.

usage: gallery.py [PICTURE...]    default: all of the gallery

Run it with a Python that has vtkwater and Pillow, and a window to render in.
"""
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image

ROOT = pathlib.Path(__file__).resolve().parents[2]
# picture -> the script, when its name is another, and the arguments; PICTURE is the file to write
EXAMPLES = {
    "lake": ["Examples/Data/jacksboro.vti", "FOLDER"],
    "lakes": ["PICTURE"],
    "flood": ["--picture", "PICTURE"],
    "tide": ["FOLDER/tide.gif", "--frames", "30", "--picture", "PICTURE"],
    "rain_flood": ["FOLDER/rain_flood.gif", "--frames", "4", "--picture", "PICTURE"],
    "wake": ["PICTURE"],
    "strait": ["PICTURE"],
    "breakwater": ["PICTURE"],
    "dam_break": ["PICTURE"],
    "hull": ["PICTURE"],
    "reservoir": ["PICTURE"],
    "harbour": ["PICTURE"],
    "molecule": ["PICTURE"],
    "batch": ["--out", "FOLDER", "--make", "6"],
    "sea": ["PICTURE", "2"],
    "waves": ["PICTURE", "2"],
    "swell": ["PICTURE", "2.4"],
    "cove": ["PICTURE", "1"],
    "cove_below": ["PICTURE", "1", "below"],
    "first_water": ["PICTURE"],
    "pyvista_water": ["PICTURE"],
}
SCRIPTS = {"cove_below": "cove"}
MADE = {"batch": "step_003.png", "lake": "lake.png"}  # where the picture's name is not ours to give
LOSSLESS = ("first_water", "pyvista_water")
QUALITY = 88


def main():
    for name in sys.argv[1:] or EXAMPLES:
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder) / MADE.get(name, "picture.png")
            arguments = [argument.replace("PICTURE", str(picture)).replace("FOLDER", folder)
                         for argument in EXAMPLES[name]]
            script = ROOT / f"Examples/Python/{SCRIPTS.get(name, name)}.py"
            subprocess.run([sys.executable, script, *arguments], check=True, cwd=ROOT)
            target = ROOT / f"Documentation/images/{name}.{'png' if name in LOSSLESS else 'jpg'}"
            Image.open(picture).convert("RGB").save(target, quality=QUALITY, optimize=True)
            print(target.relative_to(ROOT), target.stat().st_size)


if __name__ == "__main__":
    main()

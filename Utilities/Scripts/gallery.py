# SPDX-License-Identifier: BSD-3-Clause
"""gallery: renders the examples' pictures for Documentation/gallery.md.

usage: gallery.py [EXAMPLE...]    names of scripts in Examples/Python; default: all in the gallery

Run it with a Python that has vtkwater and Pillow, and a window to render in.
"""
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image

ROOT = pathlib.Path(__file__).resolve().parents[2]
# example -> its arguments; PICTURE is the file to write
EXAMPLES = {
    "flood": ["--picture", "PICTURE"],
    "tide": ["FOLDER/tide.gif", "--frames", "30", "--picture", "PICTURE"],
    "rain_flood": ["FOLDER/rain_flood.gif", "--frames", "4", "--picture", "PICTURE"],
    "hull": ["PICTURE"],
    "reservoir": ["PICTURE"],
    "harbour": ["PICTURE"],
    "molecule": ["PICTURE"],
    "batch": ["--out", "FOLDER", "--make", "6"],
}
MADE = {"batch": "step_003.png"}  # where the picture's name is not ours to give
QUALITY = 88


def main():
    for name in sys.argv[1:] or EXAMPLES:
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder) / MADE.get(name, "picture.png")
            arguments = [argument.replace("PICTURE", str(picture)).replace("FOLDER", folder)
                         for argument in EXAMPLES[name]]
            subprocess.run([sys.executable, ROOT / f"Examples/Python/{name}.py", *arguments], check=True)
            target = ROOT / f"Documentation/images/{name}.jpg"
            Image.open(picture).convert("RGB").save(target, quality=QUALITY, optimize=True)
            print(target.relative_to(ROOT), target.stat().st_size)


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: BSD-3-Clause
"""The first pictures of a newcomer: 24 scenes, three cameras, water without an argument and three presets.

    contact_sheet.py [--out FOLDER] [--only NAME...] [--size WxH]

Beside each stands what people do without this module: a translucent plane. Each picture is a file of its own, and each
scene has a sheet of them.
"""
import argparse
from pathlib import Path

import numpy as np
import pyvista as pv
import vtkwater.pyvista  # noqa: F401  add_water
from first_scenes import SCENES
from PIL import Image, ImageDraw

NOTHING = "none"  # no water at all, for comparison
WATERS = {"plane": None, "water": {}, "lake": {"preset": "lake"}, "ocean": {"preset": "ocean wind 5"},
          "pool": {"preset": "pool"}}
CAMERAS = ("first", "low", "above")
LOW, ABOVE = 7.0, 60.0  # degrees over the horizon
CAPTION = 16  # pixels


def look(plotter, camera):
    """Places the camera: PyVista's first, or one at another height that looks at the same middle from as far."""
    if camera == "first":
        return
    plotter.reset_camera()
    middle = np.array(plotter.camera.focal_point)
    far = np.linalg.norm(np.array(plotter.camera.position) - middle)
    height = np.radians(LOW if camera == "low" else ABOVE)
    way = np.array([np.cos(height) * 0.6, -np.cos(height) * 0.8, np.sin(height)])
    plotter.camera.position = middle + (0.7 if camera == "low" else 1.0) * far * way
    plotter.camera.up = (0, 0, 1)
    plotter.renderer.reset_camera_clipping_range()


def plane_of(plotter, level):
    """The translucent plane that this is compared with: as wide as the scene."""
    x0, x1, y0, y1, _, _ = plotter.bounds
    plane = pv.Plane(center=((x0 + x1) / 2, (y0 + y1) / 2, level), i_size=x1 - x0, j_size=y1 - y0)
    plotter.add_mesh(plane, color="steelblue", opacity=0.6)


def picture_of(scene, camera, water, size):
    plotter = pv.Plotter(off_screen=True, window_size=size)
    level = SCENES[scene](plotter)
    if water == NOTHING:
        pass
    elif WATERS[water] is None:
        plane_of(plotter, level)
    else:
        plotter.add_water(level=level, **WATERS[water])
    look(plotter, camera)
    picture = plotter.screenshot(return_img=True)
    plotter.close()
    return picture


def name_of(*words):
    return "-".join(words).replace(" ", "_")


def sheet_of(scene, size, folder):
    """One scene: a row for each camera, a column for each water."""
    width, height = size
    sheet = Image.new("RGB", (len(WATERS) * width, CAPTION + len(CAMERAS) * height), "white")
    draw = ImageDraw.Draw(sheet)
    for column, water in enumerate(WATERS):
        draw.text((column * width + 4, 2), f"{scene}: {water}", fill="black")
        for row, camera in enumerate(CAMERAS):
            picture = Image.fromarray(picture_of(scene, camera, water, size))
            picture.save(folder / f"{name_of(scene, camera, water)}.png")
            sheet.paste(picture, (column * width, CAPTION + row * height))
    sheet.save(folder / f"{name_of(scene)}.png")
    return sheet


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=Path("first-look"), help="folder of the pictures; default %(default)s")
    parser.add_argument("--only", nargs="+", choices=SCENES, metavar="NAME", default=list(SCENES), help="some scenes")
    parser.add_argument("--size", default="480x360", help="of a picture, pixels; default %(default)s")
    given = parser.parse_args()
    given.out.mkdir(parents=True, exist_ok=True)
    size = [int(part) for part in given.size.split("x")]
    sheets = [sheet_of(scene, size, given.out) for scene in given.only]
    whole = Image.new("RGB", (sheets[0].width, sum(sheet.height for sheet in sheets)))
    top = 0
    for sheet in sheets:
        whole.paste(sheet, (0, top))
        top += sheet.height
    whole.save(given.out / "contact_sheet.png")
    print(given.out / "contact_sheet.png")


if __name__ == "__main__":
    main()

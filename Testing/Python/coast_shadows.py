# SPDX-License-Identifier: BSD-3-Clause
"""coast_shadows: random coasts under random suns, and the truth about shadows on their water, by rays.

Land is a height over (x, y), and posts and rocks stand in it. A place on the water is in shadow where a ray from it
to the sun meets either: the height is compared along the ray in double precision, and posts and rocks are met by
ray_caster's formulas.

usage: coast_shadows.py [--coasts 50] [--limit 0.5]: the figures of that many coasts, by one command
"""

import argparse
import dataclasses
import typing

import numpy as np
import ray_caster
import water_test as wt
from dark_water import add_dark_water
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

SIZE = (300, 220)
REACH = 60.0  # of the land, to each side
STEPS = 400   # of a ray under the land's top
BLACK = (0, 0, 0)


@dataclasses.dataclass
class Coast:
    """Land, what stands there, a direction to the sun, and an eye."""

    height: typing.Callable  # of (x, y)
    things: list             # of ray_caster
    to_sun: np.ndarray
    eye: tuple
    target: tuple = (0.0, 0.0, 0.0)
    angle: float = 40.0


def sun_at(high, turn):
    high, turn = np.radians(high), np.radians(turn)
    return np.array((np.cos(high) * np.cos(turn), np.cos(high) * np.sin(turn), np.sin(high)))


def beach_height(x, y):
    return 0.1 * x + 0.5 * np.sin(y / 5)


def beach(eye, target=(0.0, 0.0, 0.0)):
    """A beach whose slope is a tenth, under a sun 45 degrees high, which shades nothing."""
    return Coast(beach_height, [], sun_at(45, 0), eye, target)


def random_coast(seed, has_things=True):
    """A beach that turns with the seed, up to four hills in the land or before it; posts and balls, if wanted."""
    random = np.random.default_rng(seed)
    slope, turn = random.uniform(0.03, 0.3), random.uniform(0, 2 * np.pi)
    along, across = np.array((np.cos(turn), np.sin(turn))), np.array((-np.sin(turn), np.cos(turn)))
    bays = [(random.uniform(0.2, 1.0), random.uniform(3, 9), random.uniform(0, 6)) for _ in range(2)]
    hills = [(random.uniform(-20, 20, 2), random.uniform(1, 5), random.uniform(2, 5))
             for _ in range(random.integers(0, 5))]

    def height(x, y):
        z = np.maximum(slope * (along[0] * x + along[1] * y - 4), -1.5)
        for amplitude, length, phase in bays:
            z = z + amplitude * np.sin((across[0] * x + across[1] * y) / length + phase)
        for middle, top, width in hills:
            z = z + top * np.exp(-((x - middle[0]) ** 2 + (y - middle[1]) ** 2) / (2 * width**2))
        return z

    things = []
    for _ in range(random.integers(0, 4)):
        x, y = random.uniform(-12, 12, 2)
        wide, tall = random.uniform(0.5, 2), random.uniform(1, 5)
        things.append(ray_caster.Box((x, y, 0), (wide, wide, 2 * tall), BLACK))
    for _ in range(random.integers(0, 3)):
        x, y = random.uniform(-12, 12, 2)
        things.append(ray_caster.Sphere((x, y, random.uniform(0, 1)), random.uniform(0.8, 2), BLACK))
    look, far = random.uniform(0, 2 * np.pi), random.uniform(15, 40)
    high = np.radians(random.uniform(12, 50))
    eye = far * np.array((np.cos(look) * np.cos(high), np.sin(look) * np.cos(high), np.sin(high)))
    eye[2] = max(eye[2], float(height(eye[0], eye[1])) + 2)
    return Coast(height, things if has_things else [], sun_at(random.uniform(12, 75), random.uniform(0, 360)), tuple(eye))


def mesh_of(height, count=481):
    """The land, as triangles."""
    x, y = np.meshgrid(np.linspace(-REACH, REACH, count), np.linspace(-REACH, REACH, count))
    points = np.stack((x, y, height(x, y)), axis=-1).reshape(-1, 3)
    first = (np.arange(count - 1)[:, None] * count + np.arange(count - 1)).ravel()
    ids = np.stack((first, first + 1, first + count + 1, first, first + count + 1, first + count), axis=1)
    data, places, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetDataTypeToDouble()
    places.SetData(numpy_to_vtk(points, deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(ids.ravel().astype(np.int64), deep=True))
    data.SetPoints(places)
    data.SetPolys(cells)
    return data


def view_of(coast):
    """A view of all that in black, on water that glitters everywhere; its look."""
    view = wt.View(SIZE, BLACK)
    wt.add_actor(view.renderer, mesh_of(coast.height), BLACK, lit=False)
    for thing in coast.things:
        data = (wt.box(0.5 * (thing.low + thing.high), thing.high - thing.low) if isinstance(thing, ray_caster.Box)
                else wt.sphere(thing.center, thing.radius, 96))
        wt.add_actor(view.renderer, data, BLACK, lit=False)
    wt.add_scene_light(view.renderer, 1000 * coast.to_sun)
    view.renderer.GetLights().GetItemAsObject(0).SetIntensity(20)
    look = add_dark_water(view).GetWaterProperty()
    look.SetReflectanceModeToFresnel()
    look.SetSlopeVariance(0.3, 0.3)
    camera = wt.place_camera(view.renderer, coast.eye, coast.target, (0.3, 300))
    camera.SetViewAngle(coast.angle)
    return view, look


def meets_land(coast, start, ray, farthest):
    """Which rays meet the land, from their start to the farthest."""
    return ray_caster.in_blocks(lambda *rows: _meets_land(coast, *rows), start, farthest[:, None] * ray)


def _meets_land(coast, start, way):
    met = np.zeros(len(start), dtype=bool)
    left = np.arange(len(start))  # those that have met nothing yet
    places, ways = start.T, way.T
    found = np.zeros(len(left), dtype=bool)
    for number, part in enumerate((np.arange(STEPS) + 0.5) / STEPS):
        x, y, z = (place + part * each for place, each in zip(places, ways))
        found |= (np.abs(x) < REACH) & (np.abs(y) < REACH) & (z < coast.height(x, y))
        if number % 8 == 7:  # to leave them out costs, too
            met[left[found]] = True
            left, places, ways = left[~found], places[:, ~found], ways[:, ~found]
            found = np.zeros(len(left), dtype=bool)
    met[left[found]] = True
    return met


def truth(coast, view):
    """Per pixel: is its middle water and nothing before it; does the sun not reach it."""
    start, ray = ray_caster.eye_rays(view.renderer.GetActiveCamera(), SIZE, 1)
    with np.errstate(divide="ignore"):
        way = np.where(ray[:, 2] < -1e-6, -start[:, 2] / ray[:, 2], 0)
    place = start + way[:, None] * ray
    is_water = (way > 0) & (np.abs(place[:, :2]) < 1.5 * REACH).all(axis=1)
    at = np.flatnonzero(is_water)
    place = place[at]
    hidden = meets_land(coast, start[at], ray[at], way[at])
    if coast.things:
        hidden |= ray_caster.cast(coast.things, BLACK, start[at], ray[at])[1] < way[at]
    is_water[at] = ~hidden
    at, place = at[~hidden], place[~hidden]
    sun = np.tile(coast.to_sun, (len(at), 1))
    grid = np.linspace(-REACH, REACH, 241)
    top = float(coast.height(*np.meshgrid(grid, grid)).max()) + 0.1
    dark = meets_land(coast, place, sun, np.full(len(at), top / coast.to_sun[2]))
    if coast.things:
        dark |= np.isfinite(ray_caster.cast(coast.things, BLACK, place + 1e-6 * sun, sun)[1])
    shaded = np.zeros(len(is_water), dtype=bool)
    shaded[at] = dark
    shape = (SIZE[1], SIZE[0])
    return is_water.reshape(shape), shaded.reshape(shape)


def around(mask):
    """Pixels that are in a mask, or beside one that is."""
    wide = np.pad(mask, 1)
    height, width = mask.shape
    return np.any([wide[i:i + height, j:j + width] for i in range(3) for j in range(3)], axis=0)


def compared(coast, has_refraction=False, known=None):
    """Shares of the water's pixels that are wrongly dark, and wrongly lit; the share in shadow; a picture of it all.

    known: what truth says of the coast, if it was asked before
    """
    view, look = view_of(coast)
    if has_refraction:
        look.RefractionOn()
    bright = view.picture()[:, :, 0]
    look.ShadowsOn()
    shown = view.picture()[:, :, 0]
    is_water, shaded = known or truth(coast, view)
    is_seen = is_water & (bright > 15)
    is_dark = shown < 0.5 * bright
    is_clear = is_seen & ~(around(is_water & shaded) & around(is_water & ~shaded))
    dark, lit = is_clear & is_dark & ~shaded, is_clear & ~is_dark & shaded
    count = max(int(is_seen.sum()), 1)
    picture = np.zeros((*bright.shape, 3), dtype=int)
    picture[is_seen] = (120, 160, 200)
    picture[is_seen & shaded] = (40, 60, 90)
    picture[dark], picture[lit] = (255, 40, 40), (255, 230, 40)
    return dark.sum() / count, lit.sum() / count, (is_seen & shaded).sum() / count, picture


def main():
    """Print the shares of wrong pixels of many coasts, those over the limit one by one."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("--coasts", type=int, default=50, help="how many, of each kind (default 50)")
    parser.add_argument("--limit", type=float, default=0.5, help="%% of the water's pixels (default 0.5)")
    arguments = parser.parse_args()
    for kind, has_things in (("land", False), ("land, posts and balls", True)):
        wrong = {"opaque": [], "clear": []}
        for seed in range(arguments.coasts):
            coast = random_coast(seed, has_things)
            known = truth(coast, view_of(coast)[0])
            for water, shares in wrong.items():
                dark, lit, _, _ = compared(coast, water == "clear", known)
                shares.append(100 * (dark + lit))
                if shares[-1] > arguments.limit:
                    print(f"{kind}, {seed}, {water} water: {100 * dark:.2f} % wrongly dark, {100 * lit:.2f} % wrongly lit",
                          flush=True)
        for water, shares in wrong.items():
            over = sum(share > arguments.limit for share in shares)
            print(f"{kind}, {water} water: {over} of {len(shares)} over {arguments.limit} %; median {np.median(shares):.3f} %, "
                  f"mean {np.mean(shares):.3f} %, largest {max(shares):.2f} %", flush=True)


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: BSD-3-Clause
"""A newcomer's first pictures: water without a setting is neither black nor a hole, in scenes of all sizes."""

import sys
from pathlib import Path

import numpy as np
import pytest
import water_test as wt

sys.path.insert(0, str(Path(__file__).parents[2] / "Utilities" / "FirstLook"))
try:
    import pyvista  # noqa: F401
except ImportError as error:
    reason = f"{error}; Testing/Python/requirements.txt says what to install"
    print(f"skipped: {reason}")
    pytest.skip(reason, allow_module_level=True)
import contact_sheet
from first_scenes import SCENES

SIZE = (160, 120)
SOLID = {"hexahedral beam"}  # all of the water may be in it
DARK, BLACK = 40, 12


@pytest.mark.parametrize("name", SCENES, ids=lambda name: name.replace(" ", "_"))
def test_water_without_a_setting_is_not_black(name):
    """Half of the water is no darker than a deep lake, and next to nothing of it is black."""
    seen = 0
    for camera in contact_sheet.CAMERAS:
        water, none = (contact_sheet.picture_of(name, camera, kind, SIZE).astype(int) for kind in ("water", "none"))
        mask = np.abs(water - none).max(axis=2) > 3
        seen += int(mask.sum())
        if mask.sum() < 50:
            continue
        brightest = water.max(axis=2)[mask]
        wt.check_at_least(f"{camera}: median of the water, of 255", float(np.median(brightest)), DARK)
        black = (brightest < BLACK) & (none.max(axis=2)[mask] >= BLACK)
        wt.check_at_most(f"{camera}: % that is black", 100 * float(black.mean()), 1.0)
    wt.check_at_least("pixels of water in three pictures", seen, 0 if name in SOLID else 300)


def picture(name, camera, wider=1, has_water=True, **words):
    """A scene in 320 x 240 pixels: the middle of a picture that is so many times as wide and high."""
    plotter = pyvista.Plotter(off_screen=True, window_size=[320 * wider, 240 * wider])
    plotter.disable_anti_aliasing()
    level = SCENES[name](plotter)
    if has_water:
        plotter.add_water(level=level, **words)
    contact_sheet.look(plotter, camera)
    plotter.camera.view_angle = np.degrees(2 * np.arctan(wider * np.tan(np.radians(plotter.camera.view_angle / 2))))
    shown = plotter.screenshot(return_img=True).astype(int)
    plotter.close()
    x, y = 160 * (wider - 1), 120 * (wider - 1)
    return shown[y:y + 240, x:x + 320]


def test_a_low_eye_sees_whole_objects_in_open_water():
    """What the picture's lower border cuts off a cone under water is seen, as in the middle of a wider picture."""
    whole = picture("cone", "low", wider=2, own_view=False)
    wrong = {}
    for kind, words in (("default", {}), ("picture", {"own_view": False})):
        shown = picture("cone", "low", **words)
        wt.save(shown.astype(np.uint8), wt.output_folder() / f"TestWaterFirstLook-cone-{kind}.png")
        wrong[kind] = 100 * float((np.abs(shown - whole).max(axis=2) > 12).mean())
    wt.check_at_most("% of wrong pixels", wrong["default"], 0.1)
    wt.check_at_least("% of wrong pixels from the picture", wrong["picture"], 0.5)


def test_the_hidden_side_of_a_cone_is_no_specks():
    """Seen from above, the far side of a cone is hidden: it has no teeth at the cone's edge."""
    shown = picture("cone", "above")
    wt.save(shown.astype(np.uint8), wt.output_folder() / "TestWaterFirstLook-cone-above.png")
    none = picture("cone", "above", has_water=False)
    beside = (none == none[0, 0]).all(axis=2) & (np.abs(shown - shown[100, 60]).max(axis=2) > 12)
    wt.check_at_most("pixels beside the cone that are not deep water", int(beside[:122, :150].sum()), 3)


ISLAND = 50.0  # radius of an island with the slope around it that lies under water
STEP = 0.02


def island_height(x, y):
    """Of an island 12 high, whose slope ends 6 under the water; far below beyond its end."""
    r = np.hypot(x, y) / ISLAND
    return np.where(r <= 1.0, -6.0 + 18.0 * np.exp(-(r / 0.45) ** 2), -1e9)


def add_island(plotter):
    disc = pyvista.Disc(inner=0.01, outer=ISLAND, r_res=60, c_res=120)
    points = disc.points
    points[:, 2] = island_height(0.9999 * points[:, 0], 0.9999 * points[:, 1])
    disc.points = points
    plotter.add_mesh(disc, color="tan", smooth_shading=True)


def what_refracted_rays_meet(eye, size, angle):
    """For each pixel of a camera that looks at the origin: 0, not water; 1, the island; 2, nothing; and the way, m."""
    ahead = -eye / np.linalg.norm(eye)
    right = np.cross(ahead, (0, 0, 1)) / np.linalg.norm(np.cross(ahead, (0, 0, 1)))
    half = np.tan(np.radians(angle / 2))
    x, y = np.meshgrid((np.arange(size[0]) + 0.5) / size[0] * 2 - 1, 1 - (np.arange(size[1]) + 0.5) / size[1] * 2)
    ray = ahead + half * (size[0] / size[1] * x[..., None] * right + y[..., None] * np.cross(right, ahead))
    ray /= np.linalg.norm(ray, axis=2)[..., None]
    start = eye - (eye[2] / np.minimum(ray[..., 2], -1e-9))[..., None] * ray
    is_water = (ray[..., 2] < 0) & (np.abs(start).max(axis=2) < 1e4)
    for part in np.linspace(0.0, 1.0, 500):  # of the way to the water
        at = eye + part * (start - eye)
        is_water &= (island_height(at[..., 0], at[..., 1]) < at[..., 2]) | (at[..., 2] <= 1e-9)
    down = ray / 1.333
    down[..., 2] = -np.sqrt(1.0 - (1.0 - ray[..., 2] ** 2) / 1.333 ** 2)
    met = np.where(is_water, 2, 0)
    way = np.zeros(met.shape)
    for far in np.arange(0.0, 10.0, STEP):
        at = start + far * down
        height = island_height(at[..., 0], at[..., 1])
        is_met = (met == 2) & (height >= at[..., 2]) & (height < at[..., 2] + 10 * STEP)
        met[is_met] = 1
        way[is_met] = far
    return met, way


@pytest.mark.parametrize("degrees, bounds, most", ((20, "horizon", 0.7), (28, "horizon", 0.3), (33, None, 0.3)))
def test_the_slope_of_an_island_in_water_to_the_horizon_is_whole(degrees, bounds, most):
    """No blue patches beside the island, nor where the picture's border cuts its slope under water."""
    size, angle, far = (200, 150), 30.0, 120.0
    plotter = pyvista.Plotter(off_screen=True, window_size=list(size))
    plotter.disable_anti_aliasing()
    add_island(plotter)
    plotter.add_water(level=0.0, bounds=bounds, units="m")
    eye = far * np.array([0.0, -np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])
    plotter.camera_position = [eye, (0, 0, 0), (0, 0, 1)]
    plotter.camera.view_angle = angle
    plotter.renderer.reset_camera_clipping_range()
    shown = plotter.screenshot(return_img=True).astype(int)
    plotter.close()
    wt.save(shown.astype(np.uint8), wt.output_folder() / f"TestWaterFirstLook-island-{degrees}.png")
    met, way = what_refracted_rays_meet(eye, size, angle)
    wrong = 0
    for row, meets, ways in zip(shown, met, way):
        deep = row[meets == 2]
        if len(deep) > 5:
            is_deep = np.abs(row - np.median(deep, axis=0)).max(axis=1) <= 4
            wrong += int((is_deep & (meets == 1) & (ways < 9.0)).sum() + (~is_deep & (meets == 2)).sum())
    wt.check_at_least("pixels with the island's slope under water", int((met == 1).sum()), 10000)
    wt.check_at_most("% of the water that is wrong", 100 * wrong / float((met > 0).sum()), most)

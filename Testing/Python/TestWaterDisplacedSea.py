# SPDX-License-Identifier: BSD-3-Clause
"""A wind sea that displaces the surface is where GetWaveHeight says, whoever looks: as a mesh that the processor moves.

Depths of a parallel view are linear; a pixel's depth is a height. The surface is a fine mesh of the user's, whose
points are all moved, or the own sheet, near the eye.
"""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper

SEA = {"WindSpeed": 6.0, "Fetch": 20000.0, "WindDirection": 30.0, "SeaTileSize": 64, "SeaTileLength": 40.0,
       "Depth": 50.0}
SWELL = (0.3, 12.0, 80.0, 30.0, 0.5)


def scene(size=(200, 150), sheet=(-60, 60, -60, 60), sea=True, **settings):
    made = wt.View(size, (1.0, 0.0, 1.0))
    water = wt.add_water(made.renderer, None, sheet, 1.0)
    look = water.GetWaterProperty()
    look.SetSea(sea)
    look.WaveGeometryOn()
    for name, value in {**SEA, **settings}.items():
        getattr(look, f"Set{name}")(value)
    return made, water


def depths(made):
    made.picture()
    width, height = made.window.GetSize()
    values = vtkFloatArray()
    made.window.GetZbufferData(0, 0, width - 1, height - 1, values)
    return vtk_to_numpy(values).reshape(height, width).astype(float)


def use_mesh(water, side=3.6, resolution=400):
    source = vtkPlaneSource()
    source.SetOrigin(-side, -side, 0)
    source.SetPoint1(side, -side, 0)
    source.SetPoint2(-side, side, 0)
    source.SetResolution(resolution, resolution)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    water.SetMapper(mapper)


def straight_down(made, center, scale, near_far=(4.0, 16.0)):
    camera = wt.place_camera(made.renderer, (*center, 10.0), (*center, 0.0), near_far, view_up=(0, 1, 0))
    camera.ParallelProjectionOn()
    camera.SetParallelScale(scale)


def height_errors(time=3.0, mesh=True, waves=(), center=(0.0, 0.0), scale=2.0, fine=None, **settings):
    """Heights in the picture of a straight look, less GetWaveHeight, and that; fine: side and resolution of the mesh."""
    side = 40
    made, water = scene((side, side), **settings)
    for wave in waves:
        water.GetWaterProperty().AddWave(*wave)
    if mesh:
        use_mesh(water, *(fine or ()))
    water.SetTime(time)
    straight_down(made, center, scale)
    found = 10.0 - (4.0 + 12.0 * depths(made))
    step = (np.arange(side) + 0.5) / side * 2 - 1
    x, y = np.meshgrid(center[0] + scale * step, center[1] + scale * step)
    right = np.array([water.GetWaveHeight(*place) for place in zip(x.ravel(), y.ravel())]).reshape(x.shape)
    return found - right, right


KINDS = pytest.mark.parametrize("name, settings, waves", [
    ("one tile", {"SeaCascades": 1}, ()),
    ("three tiles", {"SeaCascades": 3}, ()),
    ("heights only", {"SeaChoppiness": 0.0}, ()),
    ("half of the chop", {"SeaChoppiness": 0.5}, ()),
    ("with a swell", {}, (SWELL,)),
    ("in feet", {"MetresPerUnit": 0.3048, "SeaTileLength": 30.0}, ()),
], ids=lambda value: value.replace(" ", "_") if isinstance(value, str) else "")


@KINDS
@pytest.mark.parametrize("time", (0.0, 1e6))
def test_the_surface_is_where_the_height_says(name, settings, waves, time):
    """Early and late, a pixel's depth is the height that GetWaveHeight says of its place."""
    errors, right = height_errors(time, waves=waves, **settings)
    wt.check_at_least(f"{name}: heights differ, standard deviation", float(right.std()), 0.02)
    # a chord of the mesh misses short waves, and pixels on steep fronts their middle
    wt.check_at_most(f"{name} at {time:g} s: median error of a height, of the heights",
                     float(np.median(np.abs(errors)) / right.std()), 0.003)
    wt.check_at_most(f"{name} at {time:g} s: rms error of a height, of the heights",
                     float(np.sqrt((errors**2).mean()) / right.std()), 0.01)


@pytest.mark.parametrize("time", (0.0, 1e6))
def test_the_height_is_that_of_the_drawn_sea_within_a_ten_thousandth(time):
    """Where cells are short beside the shortest waves, GetWaveHeight is that of the drawn sea of three tiles within 1e-4 of
    the significant height. What is left is the chords of the cells: it goes down with them."""
    errors = {}
    for resolution in (500, 2000):  # cells of 10 and 2.5 mm
        off, right = height_errors(time, SeaCascades=3, fine=(2.5, resolution))
        errors[resolution] = float(np.sqrt((off**2).mean()) / (4 * right.std()))  # the sea's own is higher than this place's
    wt.check_at_most(f"three tiles at {time:g} s: rms error of a height, of the significant height", errors[2000], 1e-4)
    wt.check_at_least("the same with cells four times as long, of that", errors[500] / errors[2000], 4.0)


def test_the_sheets_grid_has_what_its_cells_can_hold():
    """The own sheet, near the eye, has the sea's heights but for waves shorter than its cells."""
    errors, right = height_errors(mesh=False, scale=3.0, SeaTileSize=32, SeaCascades=1)
    wt.check_at_most("own sheet: rms error of a height, of the heights",
                     float(np.sqrt((errors**2).mean()) / right.std()), 0.003)


def test_chop_gathers_points_on_crests():
    """Chop gathers points on crests, so that there is more room for troughs: the mean height over places falls by
    the sum of k |h|^2 over the sea's waves."""
    step = 40.0 / 64
    fields = []
    for choppiness in (0.0, 0.5):
        _, water = scene(SeaCascades=1, SeaChoppiness=choppiness, WindSpeed=9.0)
        places = np.arange(128) * step / 2
        fields.append(np.array([[water.GetWaveHeight(x, y) for x in places] for y in places]))
    spectrum = np.fft.fft2(fields[0]) / 128**2
    k = 2 * np.pi * np.fft.fftfreq(128, step / 2)
    fall = 0.5 * float((np.hypot(k[np.newaxis, :], k[:, np.newaxis]) * np.abs(spectrum) ** 2).sum())
    wt.check_at_least("fall of the mean height, m", fall, 0.004)
    wt.check_at_most(f"fall of the mean height ({fields[0].mean() - fields[1].mean():.5f} m) against the spectrum's "
                     f"({fall:.5f} m), relative", abs((fields[0].mean() - fields[1].mean()) / fall - 1), 0.05)


def test_a_buoys_place_is_met_within_its_share():
    """The surface over a place is the point that chop moves there: its height changes evenly with the place."""
    _, water = scene(SeaCascades=1, SeaTileSize=256)
    line = np.linspace(-3.0, 3.0, 1201)
    heights = np.array([water.GetWaveHeight(x, 0.7) for x in line])
    slopes = np.diff(heights) / np.diff(line)
    normals = np.array([normal_at(water, x, 0.7) for x in 0.5 * (line[1:] + line[:-1])])
    apart = np.abs(slopes + normals[:, 0] / normals[:, 2])
    wt.check_at_most("median miss of the slope along a line against GetWaveNormal", float(np.median(apart)), 0.02)


def normal_at(water, x, y):
    normal = [0.0, 0.0, 0.0]
    water.GetWaveNormal(x, y, normal)
    return normal


def test_without_geometry_the_sea_is_flat():
    """Without WaveGeometry the sheet lies in its plane, and heights are those at their own places."""
    made, water = scene((40, 40))
    water.GetWaterProperty().WaveGeometryOff()
    straight_down(made, (0, 0), 2.0)
    wt.check_at_most("flat: largest height", float(np.abs(10.0 - (4.0 + 12.0 * depths(made))).max()), 1e-5)
    flat = water.GetWaveHeight(1.0, 2.0)
    water.GetWaterProperty().WaveGeometryOn()
    water.GetWaterProperty().SetSeaChoppiness(0.0)
    wt.check_at_most("height without chop, displaced or not",
                     abs(water.GetWaveHeight(1.0, 2.0) - flat), 1e-9)


def test_bounds_hold_the_waves():
    """The actor's bounds hold each height that the sea has, and GetWaveHeightMax is their reach."""
    _, water = scene()
    bounds = water.GetBounds()
    highest = max(abs(water.GetWaveHeight(x, y)) for x in np.linspace(-20, 20, 40) for y in np.linspace(-20, 20, 40))
    most = water.GetWaterProperty().GetWaveHeightMax()
    wt.check_at_most("highest of 1600 places, of GetWaveHeightMax", highest / most, 0.95)
    wt.check_at_least("GetWaveHeightMax, of the highest", most / highest, 1.0)
    wt.check_at_most("top of the bounds less GetWaveHeightMax", abs(bounds[5] - most), 1e-9)
    wt.check_at_most("side of the bounds less the sheet's and the chop's reach", abs(bounds[1] - 60.0 - most), 1e-9)


@pytest.mark.parametrize("eye", (1.0, 4.0, 20.0))
def test_no_hole_to_the_horizon(eye):
    """Over a sheet to the horizon every pixel under it is water, whatever the waves."""
    made, water = scene((160, 120), WindSpeed=12.0, Fetch=float("inf"), SeaTileLength=0.0, SeaTileSize=128)
    water.SetSheetToHorizon()
    water.GetWaterProperty().SetReflectance(0.5)
    for heading in range(0, 360, 45):
        angle = np.radians(heading)
        height = water.GetWaveHeight(0, 0) + eye
        wt.place_camera(made.renderer, (0, 0, height), (np.cos(angle), np.sin(angle), height - 0.2), (0.3, 5000),
                        view_up=(0, 0, 1))
        mask = wt.water_mask(made, water)
        # waves may stand over the horizon, and troughs may be under it by as much as they are deep near the eye
        rows = [int(np.argmax(column[::-1])) for column in mask.T]
        tops = [len(column) - row for column, row in zip(mask.T, rows)]
        holes = sum(int((~column[:top]).sum()) for column, top in zip(mask.T, tops))
        wt.check_equal(f"eye {eye} m, heading {heading}: pixels of no water under it", holes, 0)

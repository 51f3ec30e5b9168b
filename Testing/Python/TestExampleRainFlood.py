# SPDX-License-Identifier: BSD-3-Clause
"""The example's rain flood draws its area and volume over time beside the picture, and those of the solver's cells."""

import pathlib
import sys

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkwater import measure

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Examples/Python"))
import rain_flood  # noqa: E402

SIZE = (900, 500)
STEPS = 12  # of the solver's, evenly


class Flood:
    """The example's scene with its plot, at some steps of the solver."""

    def __init__(self):
        self.depths, self.hours, bed, self.spacing = rain_flood.read_flood()
        self.mesh = rain_flood.solvers_mesh(bed, self.spacing)
        self.scene = rain_flood.Scene(SIZE)
        rain_flood.set_array(self.mesh, "arrival", 0 * bed)
        rain_flood.set_array(self.mesh, "depth", self.depths[0])
        self.scene.add_ground(rain_flood.surface_of_heights(bed, self.spacing), bed.min(), rain_flood.EXAGGERATION)
        self.water, self.surface = rain_flood.add_water(self.scene, self.mesh, rain_flood.times_table(self.hours[-1]))
        self.scene.look(azimuth=110.0, height=42.0, zoom=1.0)
        wet = self.depths > rain_flood.WET  # each cell of the solver is as deep as its point
        self.of_cells = np.prod(self.spacing) * np.array((wet.sum((1, 2)), np.where(wet, self.depths, 0.0).sum((1, 2)))).T
        self.most = self.of_cells.max(axis=0)
        self.plot = rain_flood.Plot(self.scene, self.hours[-1], *self.most)
        self.steps = np.linspace(0, len(self.hours) - 1, STEPS).astype(int)
        self.found, self.found_cells, self.pictures = [], [], []
        for step in self.steps:
            rain_flood.set_array(self.mesh, "depth", self.depths[step])
            self.surface.Update()
            self.water.SetLevel(self.surface.GetMeanLevel())
            self.found.append(measure.flooded(self.water))
            self.found_cells.append(measure.flooded_cells(self.mesh, "depth", rain_flood.WET))
            self.plot.add(self.hours[step], self.found[-1], self.of_cells[step])
            self.pictures.append(np.asarray(self.scene.picture()).astype(int))
        self.found = np.array(self.found)


@pytest.fixture(scope="module")
def flood():
    return Flood()


def is_of(picture, color):
    return np.abs(picture - color).max(axis=2) <= 40


def test_water_in_the_picture_is_less_than_that_of_whole_cells(flood):
    """About half: streams are a cell or two wide, and the picture's water ends where the bed rises above its level."""
    share = (flood.found / flood.of_cells[flood.steps].clip(1e-9))[1:]
    print(np.round(share, 3).tolist())
    wt.check_at_most("share of the volume of cells", float(share[:, 1].max()), 1.0)
    wt.check_at_least("share of it at the end", float(share[-1, 1]), 0.4)
    wt.check_at_most("share of the area of cells", float(share[:, 0].max()), 1.0)


def test_cells_hold_what_the_solver_counts(flood):
    """But for the border of the mesh, whose points have half a cell inside it."""
    off = np.abs(np.array(flood.found_cells) / flood.of_cells[flood.steps].clip(1e-9) - 1.0)[1:]
    wt.check_at_most("areas and volumes off by", float(off.max()), 1e-3)


def test_the_plot_has_each_value(flood):
    columns = [vtk_to_numpy(flood.plot.table.GetColumn(i)) for i in range(5)]
    wanted = [flood.hours[flood.steps], *(flood.found.T / 1e6), *(flood.of_cells[flood.steps].T / 1e6)]
    for i, name in enumerate(("hours", "areas, km2", "volumes, million m3", "areas of cells", "volumes of cells")):
        wt.check_at_most(f"{name} off by", float(np.abs(columns[i] - wanted[i]).max()), 1e-5)


@pytest.mark.parametrize("column, color", ((0, rain_flood.AREA_COLOR), (1, rain_flood.VOLUME_COLOR)),
                         ids=("area", "volume"))
def test_curves_end_at_the_value_of_their_picture(flood, column, color):
    """Their right end moves with the hours, and lies as high as its value; nothing of them is over the scene."""
    inner = round(SIZE[0] * (1 - rain_flood.PLOT_WIDTH))
    top = column * SIZE[1] // 2
    ends = []
    for picture in flood.pictures[1:]:
        part = is_of(picture[top + 30:top + SIZE[1] // 2, inner:], color)  # without the title
        x = np.flatnonzero(part.any(axis=0)).max()
        ends.append((x, np.flatnonzero(part[:, x]).mean()))
    ends, steps = np.array(ends), flood.steps[1:]
    for name, places, values in (("to the right", ends[:, 0], flood.hours[steps]),
                                 ("up", ends[:, 1], flood.found[1:, column])):
        rate, start = np.polyfit(values, places, 1)
        wt.check_at_least(f"{name}: pixels that the ends cover", float(np.ptp(places)), 60)
        wt.check_at_most(f"{name}: off by, pixels", float(np.abs(rate * values + start - places).max()), 3.0)
    blank = flood.pictures[0][top + 30:top + SIZE[1] // 2, inner:]
    wt.check_equal("pixels of a curve before there are two values", int(is_of(blank, color).sum()), 0)


def test_the_dams_lake_runs_down_the_valley():
    """No water is lost until it leaves over the border; the lake is level at first, falls, and the front goes on: more
    places have become wet at each time."""
    depths, hours, bed, spacing = rain_flood.read_flood(rain_flood.DAM_FLOOD)
    volumes = depths.sum((1, 2)) * np.prod(spacing)
    edge = depths.copy()
    edge[:, 3:-3, 3:-3] = 0.0  # points of the border itself stay dry: the water leaves there
    inside = edge.max(axis=(1, 2)) < rain_flood.WET
    wt.check_at_least("steps before it leaves", int(inside.sum()), 10)
    wt.check_at_most("volume then off by, of it", float(np.abs(volumes[inside] / volumes[0] - 1.0).max()), 0.01)
    lake = depths[0] > rain_flood.WET
    wt.check_at_most("the lake is level within, m", float(np.ptp((bed + depths[0])[lake])), 0.02)
    wt.check_at_most("of its depth is left at the end", float(depths[-1][lake].mean() / depths[0][lake].mean()), 0.5)
    arrival = rain_flood.arrivals(depths, hours)
    reached = np.array([(arrival <= hour).sum() for hour in hours[inside]])
    wt.check_at_least("places that become wet from step to step", int(np.diff(reached).min()), 1)

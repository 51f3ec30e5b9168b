# SPDX-License-Identifier: BSD-3-Clause
"""A folder of GeoTIFF files is a series: names have arrays and times, and what does not fit together is said."""

import numpy as np
import pytest
import water_test as wt
from PIL import Image, TiffImagePlugin
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkwater import command
from vtkwater.readers import (GEO_KEY_MODEL_TYPE, MODEL_TYPE_GEOGRAPHIC, TIFF_GEO_KEYS, TIFF_NO_DATA, TIFF_PIXEL_SCALE,
                              TIFF_TIEPOINT, FileError)
from vtkwater.solutions import Solution

ROWS, COLUMNS, PIXEL = 12, 20, 10.0
HOLE = -9999.0


def write(path, values, pixel=PIXEL, west=500.0, north=800.0, is_geographic=False):
    """Rows from north to south, as in a TIFF."""
    tags = TiffImagePlugin.ImageFileDirectory_v2()
    keys = (1, 1, 0, 1, GEO_KEY_MODEL_TYPE, 0, 1, MODEL_TYPE_GEOGRAPHIC) if is_geographic else (1, 1, 0, 0)
    for tag, kind, value in ((TIFF_GEO_KEYS, 3, keys), (TIFF_PIXEL_SCALE, 12, (pixel, pixel, 0.0)),
                             (TIFF_TIEPOINT, 12, (0.0, 0.0, 0.0, west, north, 0.0)), (TIFF_NO_DATA, 2, str(HOLE))):
        tags.tagtype[tag] = kind
        tags[tag] = value
    Image.fromarray(np.asarray(values, dtype=np.float32)).save(path, tiffinfo=tags)


def bed():
    return np.tile(np.linspace(-1.0, 1.0, COLUMNS), (ROWS, 1)) + 0.01 * np.arange(ROWS)[:, None]


def depth(level):
    return np.maximum(level - bed(), 0.0)


@pytest.fixture
def folder(tmp_path):
    """A bed, and depths at three times, named in no order."""
    write(tmp_path / "bed.tif", bed())
    for time, level in ((600, 0.2), (0, 0.0), (1200.5, 0.5)):
        write(tmp_path / f"depth_{time}.TIF", depth(level))
    (tmp_path / "readme.txt").write_text("nothing of the series")
    (tmp_path / "._depth_0.tif").write_text("metadata of macOS")
    return tmp_path


def values_of(mesh, name):
    """Rows from north to south, by the places of the points."""
    places = vtk_to_numpy(mesh.GetPoints().GetData())
    columns, rows = np.rint((places[:, 0] - 500.0) / PIXEL).astype(int), np.rint((800.0 - places[:, 1]) / PIXEL)
    values = np.full((ROWS, COLUMNS), np.nan)
    values[rows.astype(int), columns] = vtk_to_numpy(mesh.GetPointData().GetArray(name))
    return values


@pytest.mark.parametrize("read_ahead", (False, True))
def test_names_have_arrays_and_times(folder, read_ahead):
    solution = Solution(folder, ["depth", "bed"], read_ahead=read_ahead)
    wt.check_equal("times", solution.times, (0.0, 600.0, 1200.5))
    for i, level in enumerate((0.0, 0.2, 0.5)):
        mesh = solution.step(i)
        wt.check_at_most("depth off by", float(np.abs(values_of(mesh, "depth") - depth(level)).max()), 1e-6)
        wt.check_at_most("bed off by", float(np.abs(values_of(mesh, "bed") - bed()).max()), 1e-6)
    wt.check_equal("bounds", solution.step(0).GetBounds()[:4],
                   (500.0, 500.0 + PIXEL * (COLUMNS - 1), 800.0 - PIXEL * (ROWS - 1), 800.0))
    between = values_of(solution.at(300.0), "depth")
    wt.check_at_most("between two off by", float(np.abs(between - 0.5 * (depth(0.0) + depth(0.2))).max()), 1e-6)


def test_pixels_without_data_are_no_numbers(folder):
    holed = depth(0.5)
    holed[3, 4] = HOLE
    write(folder / "depth_1200.5.TIF", holed)
    values = values_of(Solution(folder, ["depth"]).step(2), "depth")
    wt.check_equal("holes", np.argwhere(~np.isfinite(values)).tolist(), [[3, 4]])


def other_size(folder):
    write(folder / "depth_600.TIF", depth(0.2)[:-1])


def other_pixels(folder):
    write(folder / "depth_600.TIF", depth(0.2), pixel=PIXEL * 1.01)


def other_place(folder):
    write(folder / "depth_600.TIF", depth(0.2), west=501.0)


def other_place_in_degrees(folder):
    write(folder / "bed.tif", bed(), pixel=0.001, west=70.0, north=40.0, is_geographic=True)
    for file in folder.glob("depth_*"):
        write(file, depth(0.2), pixel=0.001, west=10.0, north=40.0, is_geographic=True)


def one_time_less(folder):
    write(folder / "speed_0.tif", depth(0.2))


def with_and_without(folder):
    write(folder / "depth.tif", depth(0.2))


def twice(folder):
    write(folder / "depth-600.0.tif", depth(0.2))


def no_files(folder):
    for file in folder.glob("*.[tT][iI][fF]"):
        file.unlink()


def no_picture(folder):
    (folder / "depth_600.TIF").write_text("not a TIFF")


@pytest.mark.parametrize("spoil, words", (
    (other_size, ("depth_600.TIF", "20 x 11 pixels", "20 x 12")),
    (other_pixels, ("depth_600.TIF", "pixel size", "10.1")),
    (other_place, ("depth_600.TIF", "place", "501")), (other_place_in_degrees, ("depth_0.TIF", "place", "10, ", "70, ")),
    (one_time_less, ("'speed' has no file for the time 600", "0")),
    (with_and_without, ("depth.tif", "both of 'depth'")), (twice, ("depth-600.0.tif", "depth_600.TIF", "time 600")),
    (no_files, ("no GeoTIFF files", ".tif")), (no_picture, ("depth_600.TIF", "not a readable TIFF"))),
    ids=lambda value: getattr(value, "__name__", ""))
def test_what_does_not_fit_is_an_error(folder, spoil, words):
    """It names the file; steps before it can be read."""
    spoil(folder)
    with pytest.raises(FileError) as told:
        solution = Solution(folder, ["depth", "bed"])
        wt.check_equal("the first step", solution.step(0).GetNumberOfPoints(), ROWS * COLUMNS)
        solution.step(1)
    for word in words:
        wt.check(f"'{word}' is in the error", str(told.value), word, word in str(told.value))


def test_a_missing_array_is_an_error_that_lists_all(folder):
    with pytest.raises(FileError, match=r"no array 'zeta'.*bed \(points\), depth \(points\).*names of its files"):
        Solution(folder, ["zeta"])


def test_the_command_draws_a_folder(folder, tmp_path):
    """Other times are other pictures."""
    pictures = []
    for time in (0, 1200.5):
        out = tmp_path / f"{time}.png"
        options = ("--depth", "depth", "--bed", "bed", "--time", time, "--size", "160x120", "--exaggeration", 20)
        status = command.main(["render", str(folder), *map(str, options), "--out", str(out)])
        wt.check_equal("status", status, 0)
        pictures.append(np.asarray(Image.open(out)).astype(int))
    wt.check_at_least("pixels that differ", int((pictures[0] != pictures[1]).any(axis=2).sum()), 300)

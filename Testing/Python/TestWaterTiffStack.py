# SPDX-License-Identifier: BSD-3-Clause
"""A folder of GeoTIFF files is a series: names have arrays and times, and what does not fit together is said."""

import datetime

import numpy as np
import pytest
import water_test as wt
from PIL import Image, TiffImagePlugin
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkIOImage import vtkTIFFWriter
from vtkwater import command, vtkWaterSurfaceFilter
from vtkwater.readers import (GEO_KEY_MODEL_TYPE, GEO_KEY_VERTICAL_UNITS, MODEL_TYPE_GEOGRAPHIC, TIFF_GEO_KEYS,
                              TIFF_NO_DATA, TIFF_PIXEL_SCALE, TIFF_TIEPOINT, FileError)
from vtkwater.solutions import Solution

ROWS, COLUMNS, PIXEL = 12, 20, 10.0
HOLE = -9999.0


def write(path, values, pixel=PIXEL, west=500.0, north=800.0, is_geographic=False, is_up_in_feet=False):
    """Rows from north to south, as in a TIFF."""
    tags = TiffImagePlugin.ImageFileDirectory_v2()
    keys = (1, 1, 0, 1, GEO_KEY_MODEL_TYPE, 0, 1, MODEL_TYPE_GEOGRAPHIC) if is_geographic else (1, 1, 0, 0)
    if is_up_in_feet:
        keys = (1, 1, 0, 1, GEO_KEY_VERTICAL_UNITS, 0, 1, 9002)
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


def dated(folder, dates):
    for file in folder.glob("depth_*"):
        file.unlink()
    for i, date in enumerate(dates):
        write(folder / f"depth_{date}.tif", depth(0.1 * i))


@pytest.mark.parametrize("dates, times, start", (
    (("20240228", "20240301", "20240229"), (0.0, 86400.0, 172800.0), (2024, 2, 28)),
    (("2024-01-15T0630", "2024-01-15T0600"), (0.0, 1800.0), (2024, 1, 15, 6)),
    (("20240115_060000", "20240115T060130Z"), (0.0, 90.0), (2024, 1, 15, 6)),
    (("2024-01-15_06-30-00", "20231231235959"), (0.0, 1233001.0), (2023, 12, 31, 23, 59, 59)),
    (("20241315", "20240100", "600"), (600.0, 20240100.0, 20241315.0), None)), ids=lambda value: str(value)[:24])
def test_dates_are_times(folder, dates, times, start):
    """Seconds since the first of them; numbers that are no dates stay numbers."""
    dated(folder, dates)
    solution = Solution(folder, ["depth", "bed"])
    wt.check_equal("times", solution.times, times)
    wt.check_equal("start", solution.start, start and datetime.datetime(*start))
    first = np.argsort([date.replace("-", "").replace("_", "T") for date in dates])[0] if start else dates.index("600")
    found = values_of(solution.step(0), "depth")
    wt.check_at_most("depth off by", float(np.abs(found - depth(0.1 * first)).max()), 1e-6)


def test_files_may_be_listed_with_their_times(folder, tmp_path):
    """From any folders, under any names."""
    (tmp_path / "other").mkdir()
    write(tmp_path / "other" / "last_20.tif", depth(0.7))
    solution = Solution({"h": {-1.5: folder / "depth_0.TIF", 3600: str(tmp_path / "other" / "last_20.tif")},
                         "zb": folder / "bed.tif"}, ["h", "zb"], read_ahead=True)
    wt.check_equal("times", solution.times, (-1.5, 3600.0))
    for i, level in enumerate((0.0, 0.7)):
        wt.check_at_most("depth", float(np.abs(values_of(solution.step(i), "h") - depth(level)).max()), 1e-6)
        wt.check_at_most("bed", float(np.abs(values_of(solution.step(i), "zb") - bed()).max()), 1e-6)


@pytest.mark.parametrize("listed, words", (
    ({}, "the list of GeoTIFF files is empty"), ({"h": {}}, "'h' has no files"),
    ({"h": {float("nan"): "a.tif"}}, "a.tif: its time is nan; it must be a finite number"),
    ({"h": {"0": "a.tif"}}, "its time is '0'"), ({"h": "nowhere.tif"}, "nowhere.tif.*No such file"),
    ({"h": {0: "a.tif", 1: "b.tif"}, "v": {0: "c.tif"}}, "'v' has no file for the time 1")))
def test_a_wrong_list_is_an_error(listed, words):
    with pytest.raises(FileError, match=words):
        Solution(listed, ["h"])


@pytest.mark.parametrize("parts", ("xy", "uv"))
def test_two_bands_are_a_vector(folder, parts):
    """A file for each component, as a current has."""
    for time in ("0", "600", "1200.5"):
        write(folder / f"velocity_{parts[0]}_{time}.tif", depth(0.2))
        write(folder / f"velocity_{parts[1]}_{time}.tif", -depth(0.5))
    mesh = Solution(folder, ["velocity", f"velocity_{parts[0]}"]).step(1)
    found = vtk_to_numpy(mesh.GetPointData().GetArray("velocity"))
    wt.check_equal("components", found.shape, (ROWS * COLUMNS, 2))
    wt.check_equal("the first", found[:, 0].tolist(),
                   vtk_to_numpy(mesh.GetPointData().GetArray(f"velocity_{parts[0]}")).tolist())
    wt.check_at_most("the second", float(np.abs(np.sort(found[:, 1]) - np.sort(-depth(0.5).ravel())).max()), 1e-6)


def several_bands(folder):
    """Two of real numbers, which Pillow cannot read."""
    image = vtkImageData()
    image.SetDimensions(COLUMNS, ROWS, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.zeros((ROWS * COLUMNS, 2), dtype=np.float32), deep=True))
    writer = vtkTIFFWriter()
    writer.SetInputData(image)
    writer.SetFileName(str(folder / "depth_600.TIF"))
    writer.Write()


def bands_of_colors(folder):
    Image.fromarray(np.zeros((ROWS, COLUMNS, 3), dtype=np.uint8)).save(folder / "depth_600.TIF")


def date_and_number(folder):
    write(folder / "depth_2024-01-15.tif", depth(0.2))


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
    (with_and_without, ("depth.tif", "both hold 'depth'")), (twice, ("depth-600.0.tif", "depth_600.TIF", "time 600")),
    (several_bands, ("depth_600.TIF", "several bands", "velocity_x_0.tif")),
    (bands_of_colors, ("depth_600.TIF", "3 numbers per pixel", "velocity_x_0.tif")),
    (date_and_number, ("depth_2024-01-15.tif ends with a date", "depth_0.TIF with a number")),
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


@pytest.mark.parametrize("what", ("bed", "depth"))
def test_land_without_data_is_a_hole(folder, tmp_path, what):
    """A hole in the bed, or in the depth of wet land, is dry, and the rest is as without it."""
    hole = (slice(3, 6), slice(2, 5))  # wet
    mesh = Solution(folder, ["depth", "bed"]).step(2)
    whole = surface_of(mesh)
    values = bed() if what == "bed" else depth(0.5)
    values[hole] = HOLE
    write(folder / ("bed.tif" if what == "bed" else "depth_1200.5.TIF"), values)
    holed = surface_of(Solution(folder, ["depth", "bed"]).step(2))
    write(folder / "bed.tif", bed())
    write(folder / "depth_1200.5.TIF", depth(0.5))
    wt.check("finite", holed.GetBounds(), "finite", bool(np.isfinite(holed.GetBounds()).all()))
    lost = (area_of(whole) - area_of(holed)) / PIXEL**2
    wt.check_at_least("cells that are lost", lost, 2 * 2)
    wt.check_at_most("cells that are lost", lost, 4 * 4)
    whole_picture = picture_of(folder, tmp_path / "whole.png")
    values = bed() if what == "bed" else depth(0.5)
    values[hole] = HOLE
    write(folder / ("bed.tif" if what == "bed" else "depth_1200.5.TIF"), values)
    different = (np.abs(picture_of(folder, tmp_path / f"holed-{what}.png") - whole_picture) > 8).any(axis=2).mean()
    wt.check_at_least("share of the picture that the hole changes", float(different), 0.005)
    wt.check_at_most("share of the picture that the hole changes", float(different), 0.15)


def picture_of(folder, out):
    status = command.main(["render", str(folder), "--depth", "depth", "--bed", "bed", "--time", "1200.5", "--size",
                           "160x120", "--exaggeration", "20", "--out", str(out)])
    wt.check_equal("status", status, 0)
    return np.asarray(Image.open(out)).astype(int)


def surface_of(mesh):
    made = vtkWaterSurfaceFilter()
    made.SetInputData(mesh)
    made.SetDepthArrayName("depth")
    made.SetBedArrayName("bed")
    made.Update()
    return made.GetOutput()


def area_of(surface):
    triangles = vtkTriangleFilter()
    triangles.SetInputData(surface)
    triangles.Update()
    points = vtk_to_numpy(triangles.GetOutput().GetPoints().GetData())
    corners = points[vtk_to_numpy(triangles.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    along, across = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return float(0.5 * np.abs(along[:, 0] * across[:, 1] - along[:, 1] * across[:, 0]).sum())


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


def test_heights_in_feet_become_metres(tmp_path):
    write(tmp_path / "bed.tif", bed())
    for time, level in ((0, 0.0), (600, 0.5)):
        write(tmp_path / f"level_{time}.tif", np.full((ROWS, COLUMNS), level / 0.3048), is_up_in_feet=True)
    solution = Solution(tmp_path, ["level", "bed"])
    for time, level in ((0.0, 0.0), (300.0, 0.25), (600.0, 0.5)):
        values = vtk_to_numpy(solution.at(time).GetPointData().GetArray("level"))
        wt.check_at_most(f"level at {time} off by", float(np.abs(values - level).max()), 1e-6)

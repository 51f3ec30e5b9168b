# SPDX-License-Identifier: BSD-3-Clause
"""The filter tells of levels, depths and beds that cannot be: of another unit, of the wrong sign, in contradiction."""

import numpy as np
import pytest
import water_test as wt
from TestWaterSurfaceFilter import add_array, bed_at, flooded, mesh_of, places_of
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkwater import vtkWaterSurfaceFilter


def warnings_of(mesh, **names):
    """What the filter says of a mesh in three updates."""
    made = vtkWaterSurfaceFilter()
    made.SetInputData(mesh)
    for name, value in names.items():
        getattr(made, f"Set{name}")(value)
    texts = []

    def remember(caller, event, text):
        texts.append(text)

    remember.CallDataType = "string0"
    made.AddObserver("WarningEvent", remember)
    for _ in range(3):
        mesh.Modified()
        made.Update()
    return texts


def with_unit(name, factor, of_cells=False):
    """A flooded valley, 320 to 400 m high, with one of its arrays in another unit."""
    mesh = mesh_of()
    for part in (mesh,):
        bed = 360.0 + 20.0 * bed_at(places_of(part, of_cells))
        depth = np.maximum(365.0 - bed, 0.0)
        values = {"zb": bed, "h": depth, "zeta": bed + depth}
        values[name] = values[name] * factor
        for array, numbers in values.items():
            add_array(part, array, numbers, of_cells)
    return mesh


LEVEL_DEPTH_BED = {"LevelArrayName": "zeta", "DepthArrayName": "h", "BedArrayName": "zb"}
LEVEL_BED = {"LevelArrayName": "zeta", "BedArrayName": "zb"}


@pytest.mark.parametrize("of_cells", (False, True), ids=("points", "cells"))
@pytest.mark.parametrize("name, factor, names, words", (
    ("zeta", 100.0, LEVEL_DEPTH_BED, ("'zeta' seems", "are 100 times", "'zeta' is 3", "'zb' is 3", "'h' is 0 to ")),
    ("h", 1.0 / 0.3048, LEVEL_DEPTH_BED, ("'h' seems", "3.28084 times")),
    ("zb", 0.001, LEVEL_DEPTH_BED, ("'zb' seems", "0.001 times")),
    ("zeta", 100.0, LEVEL_BED, ("'zeta' seems", "are 100 times", "'zb' is 3")),
), ids=("level", "depth", "bed", "without_depth"))
def test_another_unit_is_told_once(name, factor, names, words, of_cells):
    """With the names and the ranges of the arrays."""
    said = warnings_of(with_unit(name, factor, of_cells), **names)
    wt.check_equal("warnings", len(said), 1)
    wt.check_equal(f"words in: {said[0]}", [word for word in words if word not in said[0]], [])


@pytest.mark.parametrize("name, names", [
    (name, names) for names in (LEVEL_DEPTH_BED, LEVEL_BED, {"DepthArrayName": "h", "BedArrayName": "zb"})
    for name in names.values()], ids=lambda value: value if isinstance(value, str) else "of_" + "_".join(value.values()))
def test_fill_values_are_of_no_unit(name, names):
    """Of places without data nothing is known: a right mesh is not told to be wrong, and a wrong one is."""
    for factor, count in ((1.0, 0), (100.0, 1)):
        mesh = with_unit(next(iter(names.values())), factor, False)
        values = vtk_to_numpy(mesh.GetPointData().GetArray(name)).copy()
        values[::3] = 9.96921e36
        add_array(mesh, name, values)
        wt.check_equal(f"warnings, {factor:g}", len(warnings_of(mesh, **names)), count)


@pytest.mark.parametrize("bed, sea, wave", (
    (lambda x: -5000.0 + x, 0.0, 0.5), (lambda x: 300.0 * x - 1200.0, 0.0, 30.0), (lambda x: 20.0 + x, 0.0, 0.0),
    (lambda x: x * x, -3.0, 0.0), (lambda x: 0.0 * x, 1.0, 0.1), (lambda x: 1400.0 + x, 1897.0, 0.0),
), ids=("deep_sea", "tsunami", "dry_land", "dry_basin", "tank", "mountain_lake"))
@pytest.mark.parametrize("names", (LEVEL_DEPTH_BED, LEVEL_BED, {"LevelArrayName": "zeta", "DepthArrayName": "h"}),
                         ids=lambda names: "_".join(names))
def test_real_water_has_one_unit(bed, sea, wave, names):
    mesh = mesh_of()
    places = places_of(mesh, False)
    heights = bed(places[:, 0])
    level = np.maximum(sea + wave * np.sin(3.0 * places[:, 0] + places[:, 1]), heights)
    for name, values in (("zb", heights), ("h", level - heights), ("zeta", level)):
        add_array(mesh, name, values)
    wt.check_equal("warnings", warnings_of(mesh, **names), [])


def test_levels_of_cells_that_are_their_beds_are_told_once():
    """Where the cells' own bed is not the mean of their corners, as in hills, dry cells would be water: a warning says
    so. There is none with the depth or with the bed of the cells, for levels of wet cells alone, and on plane slopes."""
    mesh = flooded(0.4, True)
    level = vtk_to_numpy(mesh.GetCellData().GetArray("zeta"))
    depth = vtk_to_numpy(mesh.GetCellData().GetArray("h"))
    names = {"LevelArrayName": "zeta", "BedArrayName": "zb"}
    wt.check_equal("warnings on a plane slope", warnings_of(mesh, **names), [])
    level += np.where(depth > 0.0, 0.0, np.random.default_rng(1).uniform(-0.005, 0.005, len(level)))
    mesh.GetCellData().GetArray("zeta").Modified()
    said = warnings_of(mesh, **names)
    wt.check_equal("warnings", len(said), 1)
    words = ("'zeta'", "'zb'", "Name the array of depths")
    wt.check_equal(f"words in: {said[0]}", [word for word in words if word not in said[0]], [])
    wt.check_equal("with the depth", warnings_of(mesh, LevelArrayName="zeta", DepthArrayName="h"), [])
    wt.check_equal("with depth and bed", warnings_of(mesh, DepthArrayName="h", BedArrayName="zb"), [])
    level[depth <= 0.0] = np.nan
    mesh.GetCellData().GetArray("zeta").Modified()
    wt.check_equal("of wet cells alone", warnings_of(mesh, **names), [])


@pytest.mark.parametrize("of_cells", (False, True), ids=("points", "cells"))
def test_depths_that_are_all_negative_are_told_once(of_cells):
    """By a warning with the array's name and range; it is no matter of units. A dry step is all 0, or NaN."""
    mesh = with_unit("h", -1.0, of_cells)
    data = mesh.GetCellData() if of_cells else mesh.GetPointData()
    depths = vtk_to_numpy(data.GetArray("h"))
    depths[:] = np.linspace(-3.0, -0.5, len(depths))
    depths[0] = np.nan
    said = warnings_of(mesh, **LEVEL_DEPTH_BED)
    wt.check_equal("warnings", len(said), 1)
    words = ("'h' is -", " to -0.5", "must be positive", "There is no water")
    wt.check_equal(f"words in: {said[0]}", [word for word in words if word not in said[0]], [])
    for dry in (0.0, np.nan):
        depths[:] = dry
        data.GetArray("h").Modified()
        wt.check_equal(f"warnings of depths of {dry}", warnings_of(mesh, DepthArrayName="h"), [])
    depths[:] = -1.0
    depths[1] = 0.5
    data.GetArray("h").Modified()
    wt.check_equal("warnings of a wet place among negative depths", warnings_of(mesh, DepthArrayName="h"), [])


@pytest.mark.parametrize("of_cells", (False, True), ids=("points", "cells"))
def test_depths_of_the_wrong_sign_are_told_with_zeros_on_dry_land(of_cells):
    """Once; thin films below 0 of a dry step are no mistake."""
    mesh = with_unit("h", -1.0, of_cells)  # 0 on dry land
    said = warnings_of(mesh, **LEVEL_DEPTH_BED)
    wt.check_equal("warnings", len(said), 1)
    words = ("'h' is -", " to 0;", "must be positive", "There is no water")
    wt.check_equal(f"words in: {said[0]}", [word for word in words if word not in said[0]], [])
    array = (mesh.GetCellData() if of_cells else mesh.GetPointData()).GetArray("h")
    vtk_to_numpy(array)[:] *= 1e-9
    array.Modified()
    wt.check_equal("warnings of a dry step", warnings_of(mesh, DepthArrayName="h"), [])


@pytest.mark.parametrize("name, off, count", (("zeta", 5.0, 1), ("zb", -2.0, 1), ("h", 0.0, 0), ("zeta", 0.02, 0)))
def test_three_arrays_that_contradict_each_other_are_told_once(name, off, count):
    """With the largest difference. It must exceed a hundredth of the largest depth."""
    mesh = with_unit("h", 1.0)
    add_array(mesh, name, vtk_to_numpy(mesh.GetPointData().GetArray(name)) + off)
    said = warnings_of(mesh, **LEVEL_DEPTH_BED)
    wt.check_equal("warnings", len(said), count)
    for text in said:
        words = ("'h' differs", f"by up to {abs(off):g} ", "'zeta'", "'zb'", "Name two of them")
        wt.check_equal(f"words in: {text}", [word for word in words if word not in text], [])

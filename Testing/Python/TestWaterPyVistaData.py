# SPDX-License-Identifier: BSD-3-Clause
"""A solver's mesh in PyVista: one call makes its water, coloured by its data, and follows them."""

import gc
import warnings
import weakref

import numpy as np
import pytest
import water_test as wt
from TestWaterDataBar import along_bar, check_steps, pixels_at
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkVariant
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes
from vtkmodules.vtkFiltersPoints import vtkSPHInterpolator, vtkSPHQuinticKernel

try:
    import pyvista as pv
except ImportError as error:
    reason = f"{error}; Testing/Python/requirements.txt says what to install"
    print(f"skipped: {reason}")
    pytest.skip(reason, allow_module_level=True)
import vtkwater.pyvista  # noqa: F401  add_water
from vtkwater import measure

SIZE = (320, 240)


@pytest.fixture
def plotter():
    made = pv.Plotter(off_screen=True, window_size=SIZE, lighting="none")
    yield made
    made.close()


def solution(level=0.4):
    """A slope that rises towards +x, and the water on it."""
    x, y = np.meshgrid(np.linspace(-5, 5, 41), np.linspace(-5, 5, 41))
    mesh = pv.StructuredGrid(x, y, np.zeros_like(x))
    mesh["zb"] = 0.3 * mesh.points[:, 0]
    mesh["h"] = np.maximum(level - mesh["zb"], 0.0)
    mesh["zeta"] = mesh["zb"] + mesh["h"]
    mesh["c"] = mesh.points[:, 1].astype(float)
    mesh["nothing"] = np.full(mesh.n_points, np.nan)
    mesh["dry"] = np.zeros(mesh.n_points)
    return mesh


def from_above(plotter):
    plotter.camera_position = [(0, 0, 20), (0, 0, 0), (0, 1, 0)]
    plotter.renderer.reset_camera_clipping_range()
    plotter.render()
    return plotter.screenshot(None, return_img=True)


def share_of_water(plotter, water):
    shown = from_above(plotter)
    water.VisibilityOff()
    without = from_above(plotter)
    water.VisibilityOn()
    return float((shown != without).any(axis=2).mean())


@pytest.mark.parametrize("words", ({"level": "zeta", "bed": "zb"}, {"depth": "h", "bed": "zb"},
                                   {"level": "zeta", "depth": "h"}), ids=lambda words: "_".join(words))
def test_arrays_say_where_the_water_is(words, plotter):
    water = plotter.add_water(solution(), **words)
    wt.check_at_most("level off by", abs(water.GetLevel() - 0.4), 1e-6)
    bounds = water.GetBounds()
    wt.check_at_most("end off by", abs(bounds[1] - 0.4 / 0.3), 1e-4)
    wt.check_at_most("begin off by", abs(bounds[0] + 5), 1e-6)


def test_water_follows_its_arrays(plotter):
    """Shore and level are those of the arrays in each frame."""
    mesh = solution()
    water = plotter.add_water(mesh, depth="h", bed="zb")
    shares = []
    for level in (-0.6, 0.0, 0.6):
        mesh["h"] = np.maximum(level - mesh["zb"], 0.0)
        shares.append(share_of_water(plotter, water))
        wt.check_at_most(f"level at {level}: off by", abs(water.GetLevel() - level), 1e-6)
        wt.check_at_most(f"end at {level}: off by", abs(water.GetBounds()[1] - level / 0.3), 1e-4)
    wt.check_equal("shares of the picture grow", shares == sorted(set(shares)), True)


@pytest.mark.parametrize("kind", ("polygons", "rows", "cells"))
def test_a_surface_that_moves_is_followed(kind, plotter):
    """Without arrays of heights, its points are the water; its colours are those of the frame, too."""
    rows = solution()
    mesh = {"polygons": lambda: rows.extract_surface(algorithm=None), "rows": lambda: rows,
            "cells": rows.cast_to_unstructured_grid}[kind]()
    water = plotter.add_water(mesh, color_by="c", clim=(-5, 5), scalar_bar=False)
    places = mesh.points.copy()
    for height in (0.5, -1.0):
        mesh.points = places + (0, 0, height)
        before = from_above(plotter)
        wt.check_at_most(f"level at {height}: off by", abs(water.GetLevel() - height), 1e-6)
        mesh["c"] = -np.asarray(mesh["c"])
        changed = (from_above(plotter) != before).any(axis=2).mean()
        wt.check_at_least(f"other colours at {height}: pixels that change, %", 100 * changed, 20)


@pytest.mark.parametrize("kind", ("rows", "image", "cells"))
def test_hidden_cells_are_no_water(kind, plotter):
    """Without arrays of heights, too; and those that are hidden later."""
    rows = solution()
    mesh = {"rows": lambda: rows, "cells": rows.cast_to_unstructured_grid,
            "image": lambda: pv.ImageData(dimensions=(41, 41, 1), spacing=(0.25, 0.25, 1), origin=(-5, -5, 0))}[kind]()
    marks = np.zeros(mesh.n_cells, np.uint8)
    marks[mesh.cell_centers().points[:, 0] > 0] = vtkDataSetAttributes.HIDDENCELL
    if kind != "image":
        mesh.cell_data["vtkGhostType"] = marks
    water = plotter.add_water(mesh)
    if kind == "image":
        wt.check_equal("bounds, nothing hidden", water.GetBounds()[:2], (-5, 5))
        mesh.cell_data["vtkGhostType"] = marks
        from_above(plotter)
    wt.check_equal("bounds", water.GetBounds()[:2], (-5, 0))
    wt.check_equal("area", measure.flooded(water)[0], 50.0)


def pools(levels, scale=1.0):
    """Squares of 2 x 2 side by side, not joined; an array of their levels."""
    squares = [pv.Plane(center=(3 * i, 0, scale * level), i_size=2, j_size=2, i_resolution=1, j_resolution=1)
               for i, level in enumerate(levels)]
    mesh = pv.merge(squares, merge_points=False).extract_surface()
    mesh["zeta"] = mesh.points[:, 2] / scale
    return mesh


def waters_in(plotter):
    return [actor for actor in plotter.renderer.GetActors() if actor.IsA("vtkWaterActor")]


@pytest.mark.parametrize("words", ({}, {"level": "zeta"}), ids=("of_the_mesh", "of_an_array"))
def test_each_pool_has_its_level(words, plotter):
    water = plotter.add_water(pools((0.0, 1.0, 0.5, 1.0)), preset="mirror floor", **words)
    waters = waters_in(plotter)
    wt.check_equal("the water is one of them", water is waters[0], True)
    wt.check_equal("levels", sorted(each.GetLevel() for each in waters), [0.0, 0.5, 1.0])
    from_above(plotter)
    wt.check_equal("looks", len({each.GetWaterProperty() for each in waters}), 1)
    plotter.remove_actor(water)
    from_above(plotter)
    wt.check_equal("waters left", len(waters_in(plotter)), 0)


def test_all_pools_are_measured(plotter):
    """By the actor that add_water returns; also when nothing but the renderer kept it, and when the level falls."""
    mesh = pools((1.0, 2.0))
    mesh["zb"] = np.zeros(mesh.n_points)
    plotter.add_water(mesh, level="zeta", bed="zb")
    gc.collect()
    water = waters_in(plotter)[0]
    wt.check_equal("area, volume", np.round(measure.flooded(water), 5).tolist(), [8.0, 12.0])
    wt.check_equal("levels", measure.probe(water, [(0, 0), (3, 0)])["WaterLevel"].tolist(), [1.0, 2.0])
    wt.check_equal("shores are the mesh's border", measure.shoreline(water, mesh).GetNumberOfLines(), 0)
    mesh["zeta"] = 0.5 * mesh["zeta"]
    wt.check_equal("area, volume later", np.round(measure.flooded(water), 5).tolist(), [8.0, 6.0])


def test_in_a_scaled_scene_each_pool_has_its_level(plotter):
    plotter.set_scale(zscale=4)
    plotter.add_water(pools((0.0, 1.0)))
    from_above(plotter)
    wt.check_equal("levels", sorted(each.GetLevel() for each in waters_in(plotter)), [0.0, 4.0])


def test_a_level_makes_one_water_of_all(plotter):
    plotter.add_water(pools((0.5, 0.501)), level=0.5)
    wt.check_equal("levels", [each.GetLevel() for each in waters_in(plotter)], [0.5])


def test_mirrors_are_limited(plotter):
    plotter.add_water(pools((0.0, 1.0, 0.5)), max_mirrors=1)
    from_above(plotter)
    renders = [each.GetReflectionPass().GetNumberOfReflectionRenders() for each in waters_in(plotter)]
    wt.check_equal("mirrored", sum(count > 0 for count in renders), 1)
    with pytest.raises(ValueError, match=r"max_mirrors is -1; it must lie in \[0, 4096\]"):
        plotter.add_water(pools((0.0, 1.0)), max_mirrors=-1)


def test_a_removed_water_is_followed_no_more(plotter):
    mesh = solution()
    water = plotter.add_water(mesh, depth="h", bed="zb")
    mesh["h"] = np.maximum(0.2 - mesh["zb"], 0.0)
    from_above(plotter)
    wt.check_at_most("followed: level off by", abs(water.GetLevel() - 0.2), 1e-6)
    known = weakref.ref(water.GetMapper().GetInputAlgorithm())
    plotter.remove_actor(water)
    mesh["h"] = np.maximum(0.1 - mesh["zb"], 0.0)
    from_above(plotter)
    wt.check_at_most("removed: level off by", abs(water.GetLevel() - 0.2), 1e-6)
    del water
    gc.collect()
    wt.check_equal("the filter is kept", known() is not None, False)


def test_a_level_that_the_user_sets_stays_until_the_data_change(plotter):
    mesh = solution()
    water = plotter.add_water(mesh, depth="h", bed="zb")
    water.SetLevel(0.7)
    from_above(plotter)
    wt.check_equal("level", water.GetLevel(), 0.7)
    mesh["h"] = np.maximum(0.1 - mesh["zb"], 0.0)
    from_above(plotter)
    wt.check_at_most("level off by", abs(water.GetLevel() - 0.1), 1e-6)


@pytest.mark.parametrize("normal, scale, expected", (
    ("z", (1, 1, 5), 5.0), ("z", (2, 2, 5), 2.5), ("y", (1, 5, 1), 5.0), ("z", (1, 2, 5), 1.0), ((0, 1, 1), (1, 1, 5), 1.0)
), ids=str)
def test_in_a_scaled_scene_depths_are_exaggerated(normal, scale, expected, plotter):
    """The water knows by how much, so that it is as clear as without the scale."""
    plotter.set_scale(*scale)
    water = plotter.add_water(level=0.0, normal=normal, bounds=(-1, 1, -1, 1))
    wt.check_equal("exaggeration", water.GetWaterProperty().GetVerticalExaggeration(), expected)


def test_in_a_scaled_scene_the_plane_is_scaled(plotter):
    plotter.set_scale(zscale=5)
    mesh = solution()
    water = plotter.add_water(mesh, depth="h", bed="zb")
    for level in (0.4, 0.2):
        mesh["h"] = np.maximum(level - mesh["zb"], 0.0)
        from_above(plotter)
        wt.check_at_most(f"level {level}: off by", abs(water.GetLevel() - 5 * level), 1e-6)


def test_bytes_go_through_the_colour_map(plotter):
    mesh = solution(level=9.0)
    mesh["wet"] = (mesh.points[:, 0] > 0).astype(np.uint8)
    water = plotter.add_water(mesh, level="zeta", color_by="wet", cmap="coolwarm", scalar_bar=False)
    water.GetWaterProperty().SetReflectanceModeToConstant()
    water.GetWaterProperty().SetReflectance(0.0)
    shown = from_above(plotter)[SIZE[1] // 2]
    wt.check_at_least("red minus blue at the right", int(shown[200, 0]) - int(shown[200, 2]), 100)
    wt.check_at_least("blue minus red at the left", int(shown[120, 2]) - int(shown[120, 0]), 100)


@pytest.mark.parametrize("of_cells", (False, True))
def test_an_array_colours_the_water(of_cells, plotter):
    """As add_mesh colours a mesh, where nothing is reflected; with a scalar bar of the same range."""
    mesh = solution(level=9.0)
    name = "c"
    if of_cells:
        mesh = mesh.point_data_to_cell_data()
    water = plotter.add_water(mesh, level="zeta", color_by=name, cmap="viridis", clim=(-4, 4))
    water.GetWaterProperty().SetReflectanceModeToConstant()
    water.GetWaterProperty().SetReflectance(0.0)
    wt.check_equal("scalar bars", list(plotter.scalar_bars.keys()), [name])
    wt.check_equal("its range", plotter.scalar_bars[name].GetLookupTable().GetRange(), (-4.0, 4.0))
    plotter.remove_scalar_bar(name)
    shown = from_above(plotter).astype(int)
    plotter.remove_actor(water)
    plotter.add_mesh(mesh.translate((0, 0, water.GetLevel())), scalars=name, cmap="viridis", clim=(-4, 4), lighting=False,
                     show_scalar_bar=False, interpolate_before_map=True)
    off = np.abs(shown - from_above(plotter)).max(axis=2)
    wt.check_at_most("share of pixels that differ from the mesh's by more than 3", float((off > 3).mean()), 0.01)


@pytest.mark.parametrize("is_log", (False, True), ids=("linear", "log"))
def test_scalar_bar_and_water_agree(is_log, plotter):
    """Pixels of both, within a step of the table; on a logarithmic scale the range begins above 0."""
    plotter.window_size = (2 * SIZE[0], 2 * SIZE[1])  # the table has a pixel or more for each of its steps
    x, y = np.meshgrid(np.linspace(-5, 5, 401), np.linspace(-5, 5, 11))
    mesh = pv.StructuredGrid(x, y, np.zeros_like(x))
    mesh["zeta"] = np.zeros(mesh.n_points)
    exponents = 0.4 * mesh.points[:, 0].astype(float)
    mesh["c"] = np.where(exponents < -1.999, 0.0, 10.0**exponents) if is_log else exponents
    water = plotter.add_water(mesh, level="zeta", color_by="c", cmap="gist_rainbow", log_scale=is_log)
    water.GetWaterProperty().SetReflectanceModeToConstant()
    water.GetWaterProperty().SetReflectance(0.0)
    bar = plotter.scalar_bars["c"]
    table = bar.GetLookupTable()
    low, high = table.GetRange()
    wt.check_equal("logarithmic", bool(table.GetScale()), is_log)
    wt.check_equal("the range begins above 0", low > 0, is_log)
    shown = from_above(plotter)[::-1]
    shares, of_bar = along_bar(bar, plotter.renderer, shown, 40)
    first, last = (np.log10((low, high)) if is_log else (low, high))
    x, of_water = pixels_at(plotter.renderer, shown, (first + shares * (last - first)) / 0.4, water.GetLevel())
    check_steps(table, bar=(shares, of_bar), water=((0.4 * x - first) / (last - first), of_water))


def test_a_table_of_the_users_is_used_as_it_is(plotter):
    """Its categories, and its colour of NaN."""
    mesh = solution()
    mesh["zeta"] = np.zeros(mesh.n_points)
    x = mesh.cell_centers().points[:, 0]
    mesh.cell_data["class"] = np.where(x < -1.0, 3.0, np.where(x < 1.0, np.nan, 7.0))
    colors = {3.0: (255, 0, 0), 7.0: (0, 255, 0)}
    table = vtkLookupTable()
    table.SetNumberOfTableValues(2)
    table.IndexedLookupOn()
    table.SetNanColor(0, 0, 1, 1)
    for i, (value, color) in enumerate(colors.items()):
        table.SetAnnotation(vtkVariant(value), f"class {value:g}")
        table.SetTableValue(i, *(part / 255 for part in color), 1.0)
    water = plotter.add_water(mesh, level="zeta", color_by="class", cmap=table, scalar_bar=False)
    water.GetWaterProperty().SetReflectanceModeToConstant()
    water.GetWaterProperty().SetReflectance(0.0)
    shown = from_above(plotter)[::-1]
    wt.check_equal("low, NaN, high", pixels_at(plotter.renderer, shown, (-3.0, 0.0, 3.0))[1].tolist(),
                   [[255, 0, 0], [0, 0, 255], [0, 255, 0]])


def test_words_that_colour_arrive(plotter):
    water = plotter.add_water(solution(), depth="h", bed="zb", color_by="c", data_opacity=0.5, scalar_bar=False)
    wt.check_equal("scalar bars", list(plotter.scalar_bars.keys()), [])
    wt.check_equal("share of data", water.GetWaterProperty().GetDataOpacity(), 0.5)
    wt.check_equal("the bed is seen", bool(water.GetWaterProperty().GetRefraction()), True)
    other = plotter.add_water(solution(), depth="h", bed="zb", color_by="c")
    wt.check_equal("data hide the bed", bool(other.GetWaterProperty().GetRefraction()), False)
    wt.check_equal("their range", other.GetMapper().GetLookupTable().GetRange(), (-5.0, 5.0))


@pytest.mark.parametrize("kind, texts, words", (
    (ValueError, ("'eta'", "zb (points)"), {"level": "eta"}),
    (ValueError, ("level", "depth", "zeta (points)"), {"bed": "zb"}),
    (ValueError, ("color_by is 'speed'", "zb, h, zeta, c, nothing, dry"), {"depth": "h", "color_by": "speed"}),
    (ValueError, ("cmap is 'virids'; it must be the name",), {"depth": "h", "color_by": "c", "cmap": "virids"}),
    (ValueError, ("level is 2", "depth='h'"), {"level": 2, "depth": "h"}),
    (ValueError, ("normal is 'x'",), {"depth": "h", "normal": "x"}),
    (ValueError, ("origin is (0, 0, 2)",), {"depth": "h", "origin": (0, 0, 2)}),
    (ValueError, ("color_by is 'nothing'", "no finite value"), {"depth": "h", "color_by": "nothing"}),
    (ValueError, ("clim is (0, inf)", "finite"), {"depth": "h", "color_by": "c", "clim": (0, float("inf"))}),
    (ValueError, ("clim is (3, 1)",), {"depth": "h", "color_by": "c", "clim": (3, 1)}),
    (ValueError, ("clim is (0, 1); with log_scale both must be above 0",),
     {"depth": "h", "color_by": "c", "clim": (0, 1), "log_scale": True}),
    (ValueError, ("color_by is 'dry', which has no finite value above 0",),
     {"depth": "h", "color_by": "dry", "log_scale": True}),
    (ValueError, ("clim is given, and cmap is a vtkLookupTable, which has its own range",),
     {"depth": "h", "color_by": "c", "clim": (0, 1), "cmap": pv.LookupTable("viridis")}),
    (ValueError, ("clim is (3, 1, 2); it must have 2 numbers",), {"depth": "h", "color_by": "c", "clim": (3, 1, 2)}),
    (TypeError, ("depth must be str",), {"depth": 3}),
    (TypeError, ("color_by must be str",), {"depth": "h", "color_by": 3}),
    (ValueError, ("data_opacity is 2", "[0, 1]"), {"depth": "h", "color_by": "c", "data_opacity": 2}),
), ids=lambda value: "_".join(value) if isinstance(value, dict) else "")
def test_wrong_words_raise_and_add_nothing(kind, texts, words, plotter):
    raised = None
    try:
        plotter.add_water(solution(), **words)
    except (TypeError, ValueError) as error:
        raised = error
    wt.check_equal(f"{words}: {raised}", (type(raised), [text for text in texts if text not in str(raised)]), (kind, []))
    wt.check_equal("actors", len(plotter.actors), 0)


def test_an_array_without_a_finite_value_is_told(plotter):
    """It may be a surface that gets its water later: no error."""
    with pytest.warns(UserWarning, match="level is 'nothing', an array without a finite value: there is no water yet"):
        plotter.add_water(solution(), level="nothing", bed="zb")
    with pytest.warns(UserWarning, match="nothing is wet yet"):
        plotter.add_water(solution(-9.0), level="zeta", bed="zb")  # dry


@pytest.mark.parametrize("texts, call", (
    (("level is given twice",), lambda plotter: plotter.add_water(1.0, level=2.0)),
    (("surface is given twice",), lambda plotter: plotter.add_water(solution(), surface=solution())),
    (("depth is 'h'", "surface"), lambda plotter: plotter.add_water(depth="h")),
    (("color_by is 'c'", "surface"), lambda plotter: plotter.add_water(color_by="c")),
), ids=("level", "surface", "depth", "color_by"))
def test_contradictions_are_told(texts, call, plotter):
    raised = ""
    try:
        call(plotter)
    except ValueError as error:
        raised = str(error)
    wt.check_equal(f"in: {raised}", [text for text in texts if text not in raised], [])


def test_another_unit_is_warned_of(plotter):
    """Once, when the water is added, and not again in its frames."""
    mesh = solution()
    mesh["zeta"] = 100.0 * np.asarray(mesh["zeta"])
    with pytest.warns(UserWarning, match="'zeta' seems to differ in unit.*'zb' is -1.5 to 1.5") as caught:
        plotter.add_water(mesh, level="zeta", depth="h", bed="zb")
    mesh["zeta"] = np.asarray(mesh["zeta"]) + 1.0
    from_above(plotter)
    wt.check_equal("warnings", len(caught), 1)


def test_negative_depths_are_warned_of(plotter):
    """Once, with the array's name and range."""
    mesh = solution()
    mesh["h"] = np.linspace(-2.0, -0.25, mesh.n_points)
    with pytest.warns(UserWarning, match="'h' is -2 to -0.25; depths must be positive") as caught:
        plotter.add_water(mesh, depth="h", bed="zb")
    wt.check_equal("warnings", len(caught), 1)


def warnings_of(plotter, mesh, **words):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        plotter.add_water(mesh, **words)
        from_above(plotter)
    return [str(each.message) for each in caught]


def test_wrong_signs_with_dry_land_are_warned_of(plotter):
    mesh = solution()
    mesh["h"] = -mesh["h"]
    said = warnings_of(plotter, mesh, depth="h", bed="zb")
    wt.check_equal(said, ["'h' is -1.9 to 0; depths must be positive" in text for text in said], [True])


@pytest.mark.parametrize("names, text", (
    ({"depth": "dry", "bed": "zb"}, "nothing is wet yet: 'dry' is 0 to 0, 'zb' is -1.5 to 1.5"),
    ({"level": "below", "bed": "zb"}, "nothing is wet yet: 'below' is -2.5 to 0.5, 'zb' is -1.5 to 1.5")))
def test_nothing_wet_is_warned_of(names, text, plotter):
    mesh = solution()
    mesh["below"] = mesh["zb"] - 1.0
    wt.check_equal("warnings", warnings_of(plotter, mesh, **names), [text])


def test_contradicting_arrays_are_warned_of(plotter):
    mesh = solution()
    mesh["zeta"] = mesh["zeta"] + 0.25
    said = warnings_of(plotter, mesh, level="zeta", depth="h", bed="zb")
    wt.check_equal(said, ["'h' differs by up to 0.25 " in text for text in said], [True])


def test_a_current_carries_the_waves(plotter):
    """Over time the waves are elsewhere than without it; a still one changes nothing; the lakes of a mesh share it."""
    mesh = solution()
    mesh["velocity"] = np.column_stack([0.0 * mesh["h"] + 0.3, 0.2 + 0.0 * mesh["h"], 0.0 * mesh["h"]])
    mesh["still"] = 0.0 * mesh["velocity"]
    pictures = {}
    for name in (None, "still", "velocity"):
        water = plotter.add_water(mesh, depth="h", bed="zb", waves=[(0.04, 1.2, 20)], flow=name, name="water")
        water.time = 1.3
        pictures[name] = from_above(plotter)
    wt.check_equal("pixels that a still one changes", int((pictures["still"] != pictures[None]).sum()), 0)
    wt.check_at_least("pixels that a current changes", int((pictures["velocity"] != pictures[None]).sum()), 1000)


@pytest.mark.parametrize("error, words, flow", (
    (ValueError, ("flow is 'speed'", "zb, h"), "speed"), (ValueError, ("flow is 'h'", "1 component;", "2 or 3"), "h"),
    (TypeError, ("flow must be",), 3.0)))
def test_a_wrong_current_is_an_error(error, words, flow, plotter):
    with pytest.raises(error) as told:
        plotter.add_water(solution(), depth="h", bed="zb", flow=flow)
    for word in words:
        wt.check(f"'{word}' is in the error", str(told.value), word, word in str(told.value))
    with pytest.raises(ValueError, match="needs a surface"):
        plotter.add_water(level=0.0, flow="velocity")
    mesh = solution()
    mesh["velocity"] = np.ones((mesh.n_points, 2))
    with pytest.raises(ValueError, match="flow is 'velocity', but the water is calm: add wind"):
        plotter.add_water(mesh, depth="h", bed="zb", flow="velocity")


def test_matter_and_foam_of_data(plotter):
    """Matter darkens the bed where there is some, as the classes show it; foam is white where a flow is fast; both are
    cut at the shore with the water."""
    mesh = solution()
    plotter.add_mesh(pv.Plane(center=(0, 0, -2), i_size=40, j_size=40), color="white", lighting=False)
    mesh["silt"] = np.where(mesh.points[:, 1] > 0, 200.0, 0.0)
    mesh["fr"] = np.where(mesh.points[:, 1] > 0, 0.0, 3.0)
    words = {"depth": "h", "bed": "zb", "name": "water", "units": "m", "sun": (0, 90)}
    clear = from_above_with(plotter, mesh, words).astype(int)
    silty = from_above_with(plotter, mesh, {**words, "matter": "silt", "matter_absorption": (0, 0.1, 0.3),
                                            "matter_scattering": (0, 0, 0)}).astype(int)
    foamy = from_above_with(plotter, mesh, {**words, "foam_by": "fr", "foam_measure": "froude"}).astype(int)
    middle, far = (slice(60, 100), slice(100, 140)), (slice(140, 180), slice(100, 140))  # y > 0, and y < 0
    wt.check_at_least("blue that matter takes", float((clear - silty)[middle][..., 2].mean()), 20)
    wt.check_equal("pixels that it changes where there is none", int((clear != silty)[far].sum()), 0)
    wt.check_at_least("foam brightens", float((foamy - clear)[far].mean()), 10)
    wt.check_equal("pixels that it changes where the flow is slow", int((clear != foamy)[middle].sum()), 0)
    wt.check_equal("dry pixels that change", int((clear != silty)[:, 230:].sum() + (clear != foamy)[:, 230:].sum()), 0)


def from_above_with(plotter, mesh, words):
    water = plotter.add_water(mesh, **words)
    look = water.GetWaterProperty()
    look.SetReflectanceModeToConstant()
    look.SetReflectance(0)
    return from_above(plotter)


@pytest.mark.parametrize("error, words, given", (
    (ValueError, ("matter is 'silt'", "arrays zb, h"), {"matter": "silt"}),
    (ValueError, ("matter is 'v', which has 3 components; it must have 1",), {"matter": "v"}),
    (TypeError, ("matter must be str",), {"matter": 3.0}),
    (ValueError, ("foam_by is 'fr'", "arrays zb, h"), {"foam_by": "fr"}),
    (ValueError, ("foam_by is 'v', which has 3 components",), {"foam_by": "v"}),
    (ValueError, ("foam_measure is 'Froude'", "cover, froude, breaking"), {"foam_by": "c", "foam_measure": "Froude"}),
    (ValueError, ("foam_measure is 'froude', but foam_by is not given",), {"foam_measure": "froude"}),
    (ValueError, ("matter_absorption is (1, 2, 3), but matter is not given",), {"matter_absorption": (1, 2, 3)}),
    (ValueError, ("matter_scattering is (1, 2)", "must have 3"), {"matter": "c", "matter_scattering": (1, 2)}),
    (ValueError, ("matter_absorption is (-1.0, 0.0, 0.0)", "not negative"),
     {"matter": "c", "matter_absorption": (-1, 0, 0)}),
    (ValueError, ("matter is 'c', but refraction is False",), {"matter": "c", "refraction": False}),
    (ValueError, ("matter is 'c', but opacity is 0.5",), {"matter": "c", "opacity": 0.5}),
    (ValueError, ("matter is 'c', but color_by is 'h'", "data_opacity"), {"matter": "c", "color_by": "h"})))
def test_wrong_matter_and_foam_are_errors(error, words, given, plotter):
    """The text names the argument, and the arrays that there are; no water is added."""
    mesh = solution()
    mesh["v"] = np.ones((mesh.n_points, 3))
    with pytest.raises(error) as told:
        plotter.add_water(mesh, depth="h", bed="zb", **given)
    for word in words:
        wt.check(f"'{word}' is in the error", str(told.value), word, word in str(told.value))
    wt.check_equal("actors", len(plotter.renderer.actors), 0)
    with pytest.raises(ValueError, match="needs a surface"):
        plotter.add_water(level=0.0, matter="c")


def particles_of(spacing):
    """A swell as a solver of smoothed particles writes it: places, densities and masses."""
    sides = np.arange(-1.0, 1.0 + 0.5 * spacing, spacing)
    x, y, z = np.meshgrid(sides, sides, np.arange(-0.6, 0.5, spacing))
    wet = z < swell(x)
    places = np.c_[x[wet], y[wet], z[wet]]
    places += np.random.default_rng(1).uniform(-0.1 * spacing, 0.1 * spacing, places.shape)
    cloud = pv.PolyData(places)
    cloud["Rho"], cloud["Mass"] = np.full(len(places), 1000.0), np.full(len(places), 1000.0 * spacing**3)
    return cloud


def swell(x):
    return 0.1 * np.sin(3.0 * x)


def test_particles_are_a_surface_by_vtks_filters(plotter):
    """VTK's interpolator of smoothed particles gives the share of water, and its contour is the water's surface: its
    points are within 0.6 of a particle's spacing of the swell, and it reflects."""
    spacing = 0.1
    grid = pv.ImageData(dimensions=(37, 37, 17), spacing=3 * (spacing / 2,), origin=(-0.9, -0.9, -0.4))
    kernel, share = vtkSPHQuinticKernel(), vtkSPHInterpolator()
    kernel.SetSpatialStep(1.3 * spacing)
    share.SetKernel(kernel)
    share.SetInputData(grid)
    share.SetSourceData(particles_of(spacing))
    share.SetDensityArrayName("Rho")
    share.SetMassArrayName("Mass")
    share.ComputeShepardSumOn()
    share.SetShepardSumArrayName("share")
    share.SetNullPointsStrategyToNullValue()
    share.Update()
    surface = pv.wrap(share.GetOutput()).contour([0.5], scalars="share")
    inside = np.abs(surface.points[:, :2]).max(axis=1) < 0.75
    off = np.abs(surface.points[inside, 2] - swell(surface.points[inside, 0]))
    wt.check_at_least("points of the surface", int(inside.sum()), 500)
    wt.check_at_most("worst point, spacings", float(off.max() / spacing), 0.6)
    ball = plotter.add_mesh(pv.Sphere(radius=0.25, center=(0, 0.9, 0.5)), color="red", lighting=False)
    water = plotter.add_water(surface, refraction=False)
    plotter.camera_position = [(0, -2, 0.5), (0, 0, 0.2), (0, 0, 1)]
    pictures = []
    for is_there in (True, False):
        ball.SetVisibility(is_there)
        plotter.render()
        pictures.append(plotter.screenshot(return_img=True).astype(int))
    wt.save(pictures[0][::-1], wt.output_folder() / "Particles.png")
    wt.check_at_most("level off by", abs(water.GetLevel()), 0.02)
    wt.check_at_least("mirrored views", water.GetReflectionPass().GetNumberOfReflectionRenders(), 1)
    change = np.abs(pictures[0] - pictures[1]).max(axis=2)[int(0.6 * SIZE[1]):]
    wt.check_at_least("pixels of the reflected ball", int((change > 10).sum()), 500)

# SPDX-License-Identifier: BSD-3-Clause
"""The command shows what a solver wrote, at every time, and lists what it does not find."""

import warnings

import numpy as np
import pytest
import water_test as wt
from PIL import Image
from solution_files import (COLUMNS, FILES, ROWS, SIZE, add_array, folder, image, polygons, structured, write,
                            write_collection, write_xml)
from vtkmodules import vtkIOXML
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkStructuredGrid
from vtkwater import command, measure, solutions
from vtkwater.data_scenes import COLOR_MAPS, known_cells, table_of
from vtkwater.scenes import Scene


def test_a_polygon_without_points_beside_holes_of_the_bed(tmp_path, capsys):
    """The last cell of the mesh has none: it is no part of the ground."""
    if vtkVersion.GetVTKMajorVersion() == 9 and vtkVersion.GetVTKMinorVersion() < 2:
        pytest.skip("VTK 9.1 crashes when it copies a polygon without points")
    mesh = polygons(0.5)
    mesh.GetPolys().InsertNextCell(0)
    heights = vtk_to_numpy(mesh.GetPointData().GetArray("zb"))
    heights[0] = np.nan
    wt.check_equal("known cells", known_cells(mesh, heights.astype(float))[[0, 1, -2, -1]].tolist(),
                   [False, True, True, False])
    for name in [mesh.GetCellData().GetArrayName(i) for i in range(mesh.GetCellData().GetNumberOfArrays())]:
        mesh.GetCellData().RemoveArray(name)
    write_xml(tmp_path / "hole.vtp", mesh)
    status, _, told = run(tmp_path, capsys, "render", tmp_path / "hole.vtp", *DATA, *LOOK, "--out",
                          tmp_path / "hole.png")
    wt.check_equal("status, errors", (status, told), (0, ""))


def run(folder, capsys, *arguments):
    """Exit status, and what was said to the user and of errors."""
    try:
        status = command.main([*map(str, arguments)])
    except SystemExit as end:
        status = end.code
    said = capsys.readouterr()
    return status, said.out, said.err


def pixels_of(path):
    return np.asarray(Image.open(path)).astype(int)[:, :, :3]


DATA = ("--depth", "h", "--bed", "zb")
LOOK = ("--exaggeration", 20, "--elevation", 30, "--size", SIZE)


@pytest.mark.parametrize("times", ("100:200", "0:200", "-5:20"))
def test_times_beyond_the_steps_leave_an_old_movie(times, folder, tmp_path, capsys):
    """The times are checked before a file is opened."""
    old = tmp_path / "old.gif"
    old.write_bytes(b"old")
    status, _, told = run(folder, capsys, "animate", folder / "slope.pvd", *DATA, *LOOK, "--times", times, "--frames", 2,
                          "--out", old)
    wt.check_equal(f"{told.strip()}: status, the error", (status, "it must lie in [0, 30]" in told), (1, True))
    wt.check_equal("the old one", old.read_bytes(), b"old")


def test_a_picture_is_a_function_of_time_alone(folder, capsys):
    """The frames of a movie are the pictures of their times, colours included."""
    options = (*DATA, "--color-by", "h", *LOOK)
    status, said, _ = run(folder, capsys, "animate", folder / "slope.pvd", *options, "--times", "0:20", "--frames", 3,
                          "--fps", 0.1, "--out", folder / "frames")
    wt.check_equal("status, said", (status, "3 of 3 frames" in said), (0, True))
    for i in range(3):
        out = folder / f"at{i}.png"
        wt.check_equal("status", run(folder, capsys, "render", folder / "slope.pvd", *options, "--time", 10 * i,
                                     "--out", out)[0], 0)
        # 1: VTK uploads coordinates relative to the bounds of what it drew first, which rounds them
        wt.check_at_most(f"frame {i} less the picture of its time, of 255",
                         wt.difference(pixels_of(folder / f"frames/{i:04d}.png"), pixels_of(out)), 1)
    wt.check_at_least("frame 2 less frame 0",
                      wt.difference(pixels_of(folder / "at0.png"), pixels_of(folder / "at2.png")), 20)


def test_an_array_of_texts_is_told_once(tmp_path, capsys):
    """An array of texts has no numbers to show: the error says so, and does not list it among those that have."""
    mesh = structured()
    names = vtkStringArray()
    names.SetName("label")
    names.SetNumberOfValues(mesh.GetNumberOfPoints())
    mesh.GetPointData().AddArray(names)
    write_xml(tmp_path / "labels.vts", mesh)
    status, _, told = run(tmp_path, capsys, "render", tmp_path / "labels.vts", "--depth", "label", "--bed", "zb", *LOOK)
    wt.check_equal(f"status, lines: {told}", (status, len(told.strip().splitlines())), (1, 1))
    wanted = "labels.vts: the array 'label' has text instead of numbers; arrays are: zb (points)"
    wt.check_equal("said", wanted in told, True)
    wt.check_equal("named", told.count("label ") + told.count("'label'"), 1)


def test_filters_of_warnings_are_the_callers(folder, capsys):
    """A program that calls the command has its own filters of warnings afterwards, also if the command fails."""
    for name, wanted in (("slope.pvd", 0), ("none.pvd", 1)):
        with warnings.catch_warnings():
            warnings.simplefilter("error", UserWarning)
            before = list(warnings.filters)
            status = run(folder, capsys, "render", folder / name, *DATA, *LOOK, "--out", folder / "filters.png")[0]
            wt.check_equal(f"{name}: status", status, wanted)
            wt.check_equal(f"{name}: the filters are as before", warnings.filters == before, True)
            with pytest.raises(UserWarning):
                warnings.warn("of the caller", UserWarning, stacklevel=1)


def test_steps_are_times(folder, capsys):
    for step, time in ((-1, 30), (1, 10)):
        for option, value in (("--step", step), ("--time", time)):
            status, said, _ = run(folder, capsys, "render", folder / "slope.pvd", *DATA, *LOOK, option, value, "--out",
                                  folder / f"{option[2:]}.png")
            wt.check_equal(f"{option}: status, time", (status, f"time {time} of 0 to 30" in said), (0, True))
        wt.check_equal(f"step {step}",
                       wt.difference(pixels_of(folder / "step.png"), pixels_of(folder / "time.png")), 0)


def water_of(folder, *options):
    """The water that a command line makes."""
    arguments = command.make_parser().parse_args(["render", *map(str, options)])
    return command.make_data_water(arguments, command.words_of(arguments), lambda _: Scene(arguments.size))


@pytest.mark.parametrize("options", (("--level", "zeta", "--bed", "zb"), ("--level", "zeta", "--depth", "h"), DATA,
                                     ("--level", 0.5, "--bed", "zb")), ids=lambda options: "_".join(map(str, options)))
def test_two_arrays_say_where_the_water_is(folder, options):
    water = water_of(folder, folder / "slope.pvd", *options, "--exaggeration", 20)
    wt.check_equal("wet", water.show(30.0), True)
    wt.check_equal("exaggeration", water.water.GetWaterProperty().GetVerticalExaggeration(), 20.0)
    wt.check_at_most("level off by", abs(water.water.GetLevel() - 10.0), 1e-6)
    wt.check_at_most("shore off by", abs(water.water.GetBounds()[1] - 150.0), 1e-3)
    ground = water.scene._ground.data.GetBounds()
    wt.check_at_most("the bed is the ground, off by",
                     float(np.abs(np.array(ground) - (0, 200, 0, 100, -1, 1)).max()), 1e-6)


def river(slope=0.001):
    """A straight channel, 1 m deep in its middle, that falls along x."""
    mesh = vtkStructuredGrid()
    mesh.SetDimensions(101, 61, 1)
    y, x = (places.ravel() for places in np.meshgrid(np.linspace(0, 1200, 61), np.linspace(0, 2000, 101), indexing="ij"))
    bed = 10.0 + 12.0 * ((y - 600.0) / 600.0) ** 2 - slope * x
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.stack([x, y, bed], axis=1), deep=True))
    mesh.SetPoints(points)
    add_array(mesh, "zb", bed)
    add_array(mesh, "h", np.maximum(11.0 - slope * x - bed, 0.0))
    return mesh


@pytest.mark.parametrize("options", (("--no-refraction",), ()), ids=("opaque", "clear"))
def test_a_calm_river_on_a_slope_has_no_patches(folder, options):
    """Its plane has its slope: a level plane, 1 m over or under the water, reflects the bed that lies under the water.
    Along the river the colours of opaque water hardly vary, and those of clear water have no steps."""
    write_xml(folder / "river.vts", river())
    water = water_of(folder, folder / "river.vts", *DATA, *options, "--size", "480x300")
    water.show(0.0)
    picture = water.scene.picture().astype(int)
    x = np.linspace(100.0, 1900.0, 150)
    widest, steepest = 0, 0
    for y in (540.0, 600.0, 660.0):
        colors = []
        for place in x:
            water.scene.renderer.SetWorldPoint(place, y, 11.0 - 0.001 * place, 1.0)
            water.scene.renderer.WorldToDisplay()
            column, row, _ = water.scene.renderer.GetDisplayPoint()
            colors.append(picture[picture.shape[0] - 1 - int(row), int(column)])
        widest = max(widest, int(np.ptp(colors, axis=0).max()))
        steepest = max(steepest, int(np.abs(np.diff(colors, axis=0)).max()))
    if options:
        wt.check_at_most("range of the colours, of 255", widest, 6)
    wt.check_at_most("largest step of the colours, of 255", steepest, 5)
    wt.check_at_most("mean level off by", abs(water.level - 10.0), 0.01)


def test_lakes_at_two_levels_have_their_own_planes(folder):
    """And are measured, and followed by the view, as one water."""
    mesh = river(0.0)
    x = np.array([mesh.GetPoint(i)[0] for i in range(mesh.GetNumberOfPoints())])
    add_array(mesh, "zb", vtk_to_numpy(mesh.GetPointData().GetArray("zb")) + np.where(np.abs(x - 1000.0) < 50.0, 9.0, 0.0))
    add_array(mesh, "h", np.where(np.abs(x - 1000.0) < 50.0, 0.0, np.maximum(
        np.where(x < 1000.0, 11.0, 13.0) - vtk_to_numpy(mesh.GetPointData().GetArray("zb")), 0.0)))
    write_xml(folder / "lakes.vts", mesh)
    water = water_of(folder, folder / "lakes.vts", *DATA, "--size", SIZE)
    water.show(0.0)
    waters = [actor for actor in water.scene.renderer.GetActors() if actor.IsA("vtkWaterActor")]
    wt.check_equal("levels", sorted(round(actor.GetLevel(), 6) for actor in waters), [11.0, 13.0])
    wt.check_equal("area", measure.flooded(water.water), measure.flooded(water.filter.GetOutput()))


def test_a_bed_that_moves_is_followed(folder):
    """As where a flood scours it; between the steps, too."""
    mesh = structured(0.5)
    add_array(mesh, "zb", vtk_to_numpy(mesh.GetPointData().GetArray("zb")) - 0.5)
    write_xml(folder / "scoured.vts", mesh)
    path = write_collection(folder / "scour.pvd", [(0.0, "s2.vts"), (10.0, "scoured.vts")])
    water = water_of(folder, path, "--level", "zeta", "--bed", "zb")
    for time, lowest in ((10.0, -1.5), (5.0, -1.25), (0.0, -1.0)):
        water.show(time)
        bounds = water.scene._ground.data.GetBounds()
        wt.check_at_most(f"lowest at {time} off by", abs(bounds[4] - lowest), 1e-6)


@pytest.mark.parametrize("level", (0.5, 60.0, 600.0))
def test_all_of_the_water_is_in_view(folder, level):
    """However high it stands over its bed."""
    for options in (("--level", level, "--bed", "zb"), ("--level", "zeta", "--bed", "zb", "--exaggeration", level)):
        water = water_of(folder, folder / "slope.pvd", *options, "--size", SIZE)
        renderer = water.scene.renderer
        renderer.GetRenderWindow().Render()
        worst = 0.0
        for place in vtk_to_numpy(water.filter.GetOutput().GetPoints().GetData()):
            renderer.SetWorldPoint(*place, 1.0)
            renderer.WorldToView()
            worst = max(worst, *np.abs(renderer.GetViewPoint()[:2]))
        wt.check_at_most("water outside of the picture, 1 its border", worst, 1.0)


def test_the_surface_has_normals(folder):
    """By which its slopes turn what it reflects."""
    water = water_of(folder, folder / "slope.pvd", *DATA)
    water.show(30.0)
    water.water.GetMapper().Update()
    normals = vtk_to_numpy(water.water.GetMapper().GetInput().GetPointData().GetNormals())
    wt.check_at_most("of level water off by", float(np.abs(np.abs(normals) - (0.0, 0.0, 1.0)).max()), 1e-6)


def test_the_level_alone_is_a_surface(folder):
    water = water_of(folder, folder / "slope.pvd", "--level", "zeta")
    wt.check_equal("points", water.filter.GetOutput().GetNumberOfPoints(), COLUMNS * ROWS)


def test_a_contour_is_a_surface(folder):
    """Of a volume fraction of points or of cells, at the value that is asked for."""
    for of_cells in (False, True):
        mesh = image(0.0, 5)
        cells = vtkImageData()
        cells.CopyStructure(mesh)
        z = np.arange(5.0)[:, None].repeat(COLUMNS * ROWS, axis=1).ravel() / 4.0
        middles = (np.arange(4.0) + 0.5)[:, None].repeat((COLUMNS - 1) * (ROWS - 1), axis=1).ravel() / 4.0
        add_array(mesh, "alpha", 1.0 - (middles if of_cells else z), of_cells)
        mesh.GetCellData().RemoveArray("fraction")
        write_xml(folder / "alpha.vti", mesh)
        for value in (0.5, 0.25):
            water = water_of(folder, folder / "alpha.vti", "--contour", "alpha", "--contour-value", value,
                             "--color-by", "v")
            water.show(0.0)
            wt.check_at_most(f"of cells {of_cells}: level off by",
                             abs(water.water.GetLevel() - 40.0 * (1.0 - value)), 1e-4)


def test_an_openfoam_case_is_read_and_contoured():
    """Of sixteen cells, half full of water at first and three quarters later: the surface rises between the steps."""
    water = water_of(None, FILES / "tank/tank.foam", "--contour", "alpha.water")
    wt.check_equal("times", water.solution.times, (0.0, 1.0))
    levels = []
    for time in (0.0, 0.5, 1.0):
        wt.check_equal(f"at {time}: wet", water.show(time), True)
        levels.append(water.water.GetLevel())
    # alpha of points is the mean of the cells around them
    wt.check_at_most("first and last off by", max(abs(levels[0] - 0.5), abs(levels[2] - 0.75)), 1e-6)
    wt.check_equal("rises", levels == sorted(levels) and levels[0] < levels[1] < levels[2], True)


def test_a_current_carries_the_waves(folder, capsys):
    """--flow moves what a preset's waves reflect; an array that is no velocity, or is not there, is an error."""
    options = (*DATA, "--units", "m", "--wind", 6, *LOOK, "--step", 2)
    for name, more in (("without", ()), ("with", ("--flow", "v"))):
        wt.check_equal("status", run(folder, capsys, "render", folder / "slope.pvd", *options, *more, "--out",
                                     folder / f"flow_{name}.png")[0], 0)
    wt.check_at_least("pixels that change", int((pixels_of(folder / "flow_with.png") !=
                                                 pixels_of(folder / "flow_without.png")).any(axis=2).sum()), 100)
    for name, words in (("h", "the array 'h' has 1 component;"), ("speed", "there is no array 'speed'")):
        status, _, told = run(folder, capsys, "render", folder / "slope.pvd", *options, "--flow", name, "--out",
                              folder / "flow.png")
        wt.check(f"{name}: error", told, words, status not in (0, None) and words in told)


def test_matter_and_foam_are_those_of_arrays(folder, capsys):
    """--matter and --foam-by change the picture; what contradicts itself, or is not there, is an error."""
    options = (*DATA, "--units", "m", *LOOK, "--step", 2)
    pictures = {}
    for name, more in (("none", ()), ("matter", ("--matter", "h", "--matter-absorption", "1,2,5")),
                       ("foam", ("--foam-by", "h", "--foam-measure", "froude"))):
        wt.check_equal("status", run(folder, capsys, "render", folder / "slope.pvd", *options, *more, "--out",
                                     folder / f"{name}.png")[0], 0)
        pictures[name] = pixels_of(folder / f"{name}.png")
    for name in ("matter", "foam"):
        wt.check_at_least(f"pixels that {name} changes",
                          int((pictures[name] != pictures["none"]).any(axis=2).sum()), 100)
    for more, words in ((("--matter", "v"), "the array 'v' has 3 components; it must have 1 for matter"),
                        (("--foam-by", "air"), "there is no array 'air'"),
                        (("--foam-measure", "froude"), "foam_measure is 'froude', but foam_by is not given"),
                        (("--matter", "h", "--matter-absorption", "1,2"), "three numbers such as"),
                        (("--matter", "h", "--no-refraction"), "matter needs refraction"),
                        (("--matter", "h", "--color-by", "h"), "the colours hide the matter")):
        status, _, told = run(folder, capsys, "render", folder / "slope.pvd", *options, *more, "--out",
                              folder / "wrong.png")
        wt.check(f"{more}: error", told, words, status not in (0, None) and words in told)


def test_colours_are_those_of_all_steps(folder):
    """A vector by its length, at every time through one table; --clim says another."""
    water = water_of(folder, folder / "slope.pvd", *DATA, "--color-by", "v")
    table = water._mapper.GetLookupTable()
    wt.check_equal("range", table.GetRange(), (0.0, 2.5))
    wt.check_equal("by the length", table.GetVectorMode(), table.MAGNITUDE)
    wt.check_equal("bars", [prop.GetTitle().strip() for prop in water.scene.renderer.GetActors2D()], ["v"])
    water = water_of(folder, folder / "slope.pvd", *DATA, "--color-by", "h", "--clim", "0:9", "--no-scalar-bar")
    wt.check_equal("a range of one's own", water._mapper.GetLookupTable().GetRange(), (0.0, 9.0))
    wt.check_equal("bars", water.scene.renderer.GetActors2D().GetNumberOfItems(), 0)


def test_a_pixel_has_its_values_colour(folder, capsys):
    """Where the optics are off, and from above: red of the table's place."""
    water = water_of(folder, folder / "slope.pvd", *DATA, "--color-by", "h", "--clim", "0:1.5", "--no-scalar-bar",
                     "--elevation", 90, "--size", SIZE)
    look = water.water.GetWaterProperty()
    look.SetReflectanceModeToConstant()
    look.SetReflectance(0.0)
    look.GlitterOff()
    water.show(30.0)
    shown = water.scene.picture().astype(int)
    renderer = water.scene.renderer
    worst = 0
    for x in range(10, 140, 10):
        renderer.SetWorldPoint(x, 51.0, 0.5, 1.0)
        renderer.WorldToDisplay()
        column, row, _ = renderer.GetDisplayPoint()
        color = [0.0] * 3
        water._mapper.GetLookupTable().GetColor(1.5 - x / 100.0, color)
        worst = max(worst, int(np.abs(shown[119 - int(row), int(column)] - 255 * np.array(color)).max()))
    wt.check_at_most("worst colour off by, of 255", worst, 6)


@pytest.mark.parametrize("size", ("960x600", "480x320", "320x200"))
def test_a_bars_title_is_in_the_picture(folder, size):
    """A picture of any size has all of the title: the rows above it are as they are without a bar."""
    options = (folder / "slope.pvd", *DATA, "--color-by", "h", "--size", size)
    with_bar, without = (water_of(folder, *options, *more).scene.picture().astype(int)
                         for more in ((), ("--no-scalar-bar",)))
    rows = np.abs(with_bar - without).max(axis=(1, 2)) > 30
    wt.check_equal("rows of it in the uppermost five", int(rows[:5].sum()), 0)
    wt.check_at_least("rows of it", int(rows.sum()), 25)


def test_the_first_view_of_data_is_steeper(folder):
    """From 30 degrees over the horizon unless another elevation is given."""
    for options, wanted in (((), 30.0), (("--elevation", 8), 8.0)):
        camera = water_of(folder, folder / "slope.pvd", *DATA, *options).scene.renderer.GetActiveCamera()
        way = np.array(camera.GetPosition()) - camera.GetFocalPoint()
        wt.check_at_most("off by, degrees", abs(np.degrees(np.arcsin(way[2] / np.linalg.norm(way))) - wanted), 1e-6)


def test_help_names_each_file_type_once(capsys):
    with pytest.raises(SystemExit):
        command.main(["render", "--help"])
    words = capsys.readouterr().out.replace(",", " ").split()
    for kind in {*command.readers.KINDS, *solutions.KINDS}:
        wt.check_equal(kind, words.count(kind), 1)


@pytest.mark.parametrize("name", COLOR_MAPS)
def test_colour_maps_are_matplotlibs(name):
    colormaps = pytest.importorskip("matplotlib").colormaps
    table = table_of(name, (0.0, 1.0))
    colors = np.array([table.GetTableValue(i)[:3] for i in range(256)])
    off = float(np.abs(colors - colormaps[name](np.linspace(0.0, 1.0, 256))[:, :3]).max())
    wt.check_at_most(f"{name}: off by, of 255", 255.0 * off, 9.0)
    wt.check_equal("others of it are known, too", table_of("magma", (0, 1)).GetNumberOfTableValues(), 256)


FAILS = (
    (("slope.pvd", "--depth", "d"), ("there is no array 'd'", "zb (points), h (points)", "fraction (cells)")),
    (("slope.pvd", "--level", "high"), ("there is no array 'high'", "zeta (points)")),
    (("slope.pvd", *DATA, "--color-by", "speed"), ("there is no array 'speed'", "v (points)")),
    (("slope.pvd", *DATA, "--time", 31), ("time is 31; it must lie in [0, 30]",)),
    (("slope.pvd", *DATA, "--step", 3), ("there is no step 3; steps are 0 to 2",)),
    (("gap.pvd", *DATA, "--time", 5), ("gap.pvd: at time 10:", "lost.vts: no such file")),
    (("none.pvd", *DATA), ("none.pvd: is empty",)),
    (("late.pvd", *DATA), ("the time of s0.vts is 'soon'; it must be a finite number",)),
    (("nan.pvd", *DATA), ("nan.pvd: the time of s0.vts is 'nan'; it must be a finite number",)),
    (("endless.pvd", *DATA), ("endless.pvd: the time of s1.vts is '-inf'; it must be a finite number",)),
    (("text.pvd", *DATA), ("text.pvd: not a ParaView collection",)),
    (("text.nc", *DATA), ("text.nc: not a NetCDF grid",)),
    (("missing.nc", *DATA), ("missing.nc: no such file",)),
    (("volume.vti", *DATA), ("cells have 3 dimensions", "--contour")),
    (("slope.pvd", "--contour", "h"), ("cells have 2 dimensions; they must have 3",)),
    (("dry.vts", *DATA), ("no place is wet: 'h' is ",)),
    (("slope.pvd", *DATA, "--color-by", "h", "--cmap", "mud"), ("unknown colour map 'mud'", "viridis")),
    (("slope.pvd", *DATA, "--color-by", "h", "--clim", "3:1"), ("(3, 1)", "both must be finite")),
    (("slope.pvd", *DATA, "--color-by", "h", "--log-scale", "--clim", "0:1"), ("(0, 1)", "both must be above 0")),
    (("slope.pvd", "--level", "v", "--bed", "zb"), ("'v' has 3 components; it must have 1",)),
)


@pytest.mark.parametrize("options, words", FAILS, ids=lambda value: "_".join(map(str, value)))
def test_what_cannot_be_shown_is_one_line(folder, capsys, options, words):
    status, _, said = run(folder, capsys, "render", folder / options[0], *options[1:], "--out", folder / "x.png")
    wt.check_equal(f"status, lines of: {said}", (status, len(said.strip().splitlines())), (1, 1))
    wt.check_equal("words that it has not", [word for word in words if word not in said], [])


WRONG = (
    (("slope.pvd", "--level", 3, "--color-by", "h"), ("--color-by needs an array that defines the water",)),
    (("slope.pvd", "--level", 3, "--step", 1), ("--step needs an array that defines",)),
    (("a.tif", "--level", "high"), ("'high' is not a number, and a file of the type .tif has no arrays",)),
    (("run.v2/case", "--level", "high"), ("'high' is not a number, and a file without a suffix has no arrays",)),
    (("case", "--depth", "h"), ("case: arrays can be read only from .pvd",)),
    (("a.stl", "--depth", "h"), ("arrays can be read only from .pvd",)),
    (("slope.pvd", "--bed", "zb"), ("--bed alone",)),
    (("slope.pvd", "--contour", "a", "--depth", "h"), ("--contour defines",)),
    (("slope.pvd", *DATA, "--contour-value", 0.3), ("--contour-value needs --contour",)),
    (("slope.pvd", *DATA, "--clim", "0:1"), ("needs --color-by",)),
    (("slope.pvd", *DATA, "--log-scale"), ("--log-scale needs --color-by",)),
    (("slope.pvd", *DATA, "--clim", "wide"), ("'wide' must be two values",)),
    (("slope.pvd", *DATA, "--horizon"), ("--horizon does not apply",)),
    (("slope.pvd", *DATA, "--step", 1, "--time", 0), ("--step and --time",)),
)


@pytest.mark.parametrize("options, words", WRONG, ids=lambda value: "_".join(map(str, value)))
def test_a_contradiction_is_a_wrong_use(folder, capsys, options, words):
    status, _, said = run(folder, capsys, "render", folder / options[0], *options[1:])
    wt.check_equal(f"status; said {said}", status, 2)
    wt.check_equal("words that it has not", [word for word in words if word not in said], [])


def test_a_time_without_water_is_told(folder, capsys):
    files = [(0, "s2.vts"), (5, "dry.vts")]
    status, _, said = run(folder, capsys, "render", write_collection(folder / "ebb.pvd", files), *DATA, "--time", 5,
                          "--size", SIZE, "--out", folder / "ebb.png")
    wt.check_equal("status, said", (status, said.strip()), (0, "vtkwater: nothing is wet at time 5"))


def test_depths_of_the_wrong_sign_are_told(folder, capsys):
    """Also with zeros on dry land; at any time, and with their range."""
    mesh = polygons()
    depths = vtk_to_numpy(mesh.GetPointData().GetArray("h"))
    depths *= -1.0
    write(vtkIOXML.vtkXMLPolyDataWriter(), mesh, folder / "sign.vtp")
    status, _, said = run(folder, capsys, "render", folder / "sign.vtp", *DATA, "--out", folder / "sign.png")
    wt.check_equal("status", status, 1)
    for word in ("sign.vtp: no place is wet: ", "'h' is -", " to 0; depths must be positive", "change its sign"):
        wt.check_equal(f"{said!r} says {word!r} once", said.count(word), 1)


def test_contradicting_arrays_are_told(folder, capsys):
    mesh = polygons()
    vtk_to_numpy(mesh.GetPointData().GetArray("zeta"))[:] += 0.25
    write(vtkIOXML.vtkXMLPolyDataWriter(), mesh, folder / "three.vtp")
    status, _, said = run(folder, capsys, "render", folder / "three.vtp", "--level", "zeta", *DATA, *LOOK,
                          "--out", folder / "three.png")
    wt.check_equal("status", status, 0)
    wt.check_equal(f"told in: {said}", said.count("'h' differs by up to 0.25 "), 1)


def test_a_level_alone_of_a_solvers_file_lists_its_arrays(folder, capsys):
    status, _, said = run(folder, capsys, "render", folder / "slope.pvd", "--level", 12, "--out", folder / "x.png")
    wt.check_equal("status, lines", (status, len(said.strip().splitlines())), (1, 1))
    for word in ("slope.pvd: a solver's file needs --depth, --level with --bed", "h (points)", "zb (points)"):
        wt.check_equal(f"{said!r} says {word!r}", word in said, True)


def test_two_steps_with_one_time_are_told(folder, capsys):
    """Once; parts with other bounds are not."""
    twice = write_collection(folder / "twice.pvd", [(0, "s0.vts"), (10, "s1.vts"), (10, "s0.vts")])
    apart = folder / "apart.vts"
    write(vtkIOXML.vtkXMLStructuredGridWriter(), structured(0.0, shift=10.0), apart)
    parts = write_collection(folder / "parts.pvd", [(0, "s0.vts"), (0, "apart.vts")])
    for path, count in ((twice, 1), (parts, 0)):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            solution = solutions.Solution(path, ["h"])
            for time in (*solution.times, *solution.times):
                solution.forget()
                solution.at(time)
        wt.check_equal("warnings", ["same bounds" in str(each.message) for each in caught], [True] * count)
    status, _, said = run(folder, capsys, "render", twice, *DATA, *LOOK, "--step", 1, "--out", folder / "x.png")
    wt.check_equal(f"said: {said}", (status, said.count("at time 10, s1.vts and s0.vts have the same bounds")), (0, 1))


def test_another_unit_is_warned_of(folder, capsys):
    """The picture is made all the same."""
    mesh = polygons()
    levels = numpy_to_vtk(100.0 * vtk_to_numpy(mesh.GetPointData().GetArray("zeta")), deep=True)
    levels.SetName("zeta")
    mesh.GetPointData().AddArray(levels)
    write(vtkIOXML.vtkXMLPolyDataWriter(), mesh, folder / "cm.vtp")
    status, _, said = run(folder, capsys, "render", folder / "cm.vtp", "--level", "zeta", "--depth", "h", "--bed", "zb",
                          *LOOK, "--out", folder / "cm.png")
    wt.check_equal("status", status, 0)
    wt.check_equal(f"warned of in: {said}", said.count("'zeta' seems to differ in unit"), 1)

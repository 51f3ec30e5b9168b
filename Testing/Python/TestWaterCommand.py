# SPDX-License-Identifier: BSD-3-Clause
"""The command vtkwater makes pictures of every kind of file, keeps holes, and says what is wrong in one line."""

import json
import signal
import subprocess
import sys
import time
import warnings

import numpy as np
import pytest
import water_test as wt
from command_runs import Commands
from PIL import Image, TiffImagePlugin
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    VTK_TRIANGLE,
    vtkCellArray,
    vtkDataSetAttributes,
    vtkImageData,
    vtkPolyData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter
from vtkwater import command, movies, readers
from vtkwater.errors import ending
from vtkwater.scenes import Scene

SIZE = (240, 160)
NO_DATA = -9999.0


COMMANDS = Commands()
run = COMMANDS.run  # exit status and all that was said


def valley(side=40):
    """Heights 0 to 100 of a valley from south to north, falling to its middle; a hole in one corner."""
    x = np.linspace(-1.0, 1.0, side)
    heights = np.tile(100.0 * np.abs(x), (side, 1)).astype(np.float32)
    heights[:5, :5] = NO_DATA
    return heights


def write_vti(path, heights, blanked=()):
    image = vtkImageData()
    image.SetDimensions(heights.shape[1], heights.shape[0], 1)
    image.SetSpacing(10.0, 10.0, 1.0)
    image.GetPointData().SetScalars(numpy_to_vtk(heights.ravel(), deep=True))
    if blanked:
        ghosts = np.zeros(heights.size, dtype=np.uint8)
        ghosts[list(blanked)] = vtkDataSetAttributes.HIDDENPOINT
        array = numpy_to_vtk(ghosts, deep=True)
        array.SetName(vtkDataSetAttributes.GhostArrayName())
        image.GetPointData().AddArray(array)
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.Write()


def write_tiff(path, heights, keys=(), scale=(10.0, 10.0, 0.0), tie=(0.0, 0.0, 0.0, 500.0, 9000.0, 0.0),
               matrix=()):
    tags = TiffImagePlugin.ImageFileDirectory_v2()
    for tag, value, kind in ((33550, scale, 12), (33922, tie, 12), (34735, keys, 3), (42113, str(NO_DATA), 2),
                             (34264, matrix, 12)):
        if value:
            tags[tag] = value
            tags.tagtype[tag] = kind
    Image.fromarray(heights[::-1]).save(path, tiffinfo=tags)


def pixels_of(path):
    return np.asarray(Image.open(path)).astype(int)


@pytest.fixture(scope="module")
def folder():
    """A folder with a good file of every kind, and with many that are not what they seem."""
    made = wt.output_folder() / "Command"
    made.mkdir(exist_ok=True)
    (made / "frames").mkdir(exist_ok=True)
    write_good_files(made)
    write_bad_files(made)
    return made


def write_good_files(folder):
    write_vti(folder / "valley.vti", valley())
    write_tiff(folder / "valley.tif", valley())
    cone = vtkConeSource()
    cone.SetDirection(0.0, 0.0, 1.0)
    for name, writer in (("cone.stl", vtkSTLWriter()), ("cone.vtp", vtkXMLPolyDataWriter())):
        writer.SetInputConnection(cone.GetOutputPort())
        writer.SetFileName(str(folder / name))
        writer.Write()


def write_bad_files(folder):
    empty = vtkXMLPolyDataWriter()
    empty.SetInputData(vtkPolyData())
    empty.SetFileName(str(folder / "empty.vtp"))
    empty.Write()
    write_vti(folder / "holes.vti", np.full((4, 4), np.nan, dtype=np.float32))
    write_vti(folder / "row.vti", np.zeros((1, 5), dtype=np.float32))
    Image.new("RGB", (4, 4)).save(folder / "colours.tif")
    for name in ("text.vti", "text.vtp", "text.stl", "text.tif", "text.vtk", "text.ply", "text.xyz"):
        (folder / name).write_text("not what its name claims\n")
    write_tiff(folder / "scale.tif", valley(), scale=(10.0,))
    write_tiff(folder / "nowhere.tif", valley(), tie=(0.0, 0.0, 0.0, np.nan, 9000.0, 0.0))
    write_tiff(folder / "pole.tif", valley(), keys=(1, 1, 0, 1, 1024, 0, 1, 2), tie=(0.0, 0.0, 0.0, 0.0, 9000.0, 0.0))
    triangle = "v 0 0 0\nv {0} 0 0\nv 0 {0} 0\nf 1 2 {1}\n"
    (folder / "index.obj").write_text(triangle.format(1, 9))
    (folder / "dot.obj").write_text(triangle.format(0, 3))
    (folder / "far.obj").write_text(triangle.format(1e30, 3))
    (folder / "half.vti").write_bytes((folder / "valley.vti").read_bytes()[:900])


SIZE_OPTION = ("--size", f"{SIZE[0]}x{SIZE[1]}")
DEGREES = (1, 1, 0, 1, 1024, 0, 1, 2)  # a TIFF's key: geographic


@pytest.mark.parametrize("name, low", (("valley.vti", [0.0, 0.0]), ("valley.tif", [500.0, 8610.0])),
                         ids=("vti", "tif"))
def test_elevations_are_read_where_they_lie(folder, name, low):
    """Elevations of either kind of file lie where the file says, with holes where it has no data."""
    ground = readers.read(folder / name, NO_DATA)
    bounds = ground.data.GetBounds()
    wt.check_equal(f"{name}: west, south, lowest, highest", [bounds[0], bounds[2], round(bounds[4], 3), bounds[5]],
                   [*low, 2.564, 100.0])
    wt.check_equal(f"{name}: cells, less those at the hole", ground.data.GetNumberOfCells(), 39 * 39 - 25)


def test_a_tiffs_transformation_is_its_scale_and_place(tmp_path):
    """A file may have a matrix in place of scale and tie point; if it turns the pixels, that is an error."""
    heights = np.arange(12.0, dtype=np.float32).reshape(3, 4)
    write_tiff(tmp_path / "scale.tif", heights)
    matrix = (10.0, 0, 0, 500.0, 0, -10.0, 0, 9000.0, 0, 0, 0, 0, 0, 0, 0, 1.0)
    write_tiff(tmp_path / "matrix.tif", heights, scale=(), tie=(), matrix=matrix)
    bounds = [readers.read(tmp_path / name).data.GetBounds() for name in ("scale.tif", "matrix.tif")]
    wt.check_equal("bounds", bounds[1], bounds[0])
    write_tiff(tmp_path / "turned.tif", heights, scale=(), tie=(), matrix=(8.0, 6.0, *matrix[2:4], 6.0, -8.0, *matrix[6:]))
    with pytest.raises(readers.FileError) as raised:
        readers.read(tmp_path / "turned.tif")
    wt.check_equal("the error", "its pixels are not in rows from west to east" in str(raised.value), True)


def test_no_data_may_have_more_digits_than_pixels(tmp_path):
    """GDAL writes -9999.9 of 64 bits for pixels of 32."""
    heights = np.full((3, 4), -9999.9, dtype=np.float32)
    heights[:, :2] = 5.0
    write_tiff(tmp_path / "holes.tif", heights)
    wt.check_equal("heights", readers.read(tmp_path / "holes.tif", no_data=-9999.9).data.GetBounds()[4:], (5.0, 5.0))


def test_no_data_of_whole_numbers_is_exact():
    """Rounded to 32 bits, 16777217 is 16777216."""
    heights = np.array([[16777216, 16777217], [5, 6]])
    wt.check_equal("holes", readers.is_no_data(heights, 16777217).tolist(), [[False, True], [False, False]])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        wt.check_equal("the lowest number", bool(readers.is_no_data(heights.astype(np.float32), -1.8e308 / 1.01).any()), False)


def test_a_tiff_knows_its_own_holes(folder):
    """A TIFF's own no-data value makes its holes."""
    wt.check_equal("the TIFF's own holes", readers.read(folder / "valley.tif").data.GetNumberOfCells(), 39 * 39 - 25)


def test_a_blanked_point_is_a_hole(folder):
    """The cells at a blanked point of a VTK image are left out."""
    write_vti(folder / "blanked.vti", np.ones((10, 10), dtype=np.float32), blanked=(33,))
    ground = readers.read(folder / "blanked.vti")
    wt.check_equal("cells, less those at a blanked point", ground.data.GetNumberOfCells(), 81 - 4)


def test_a_map_in_degrees_is_read_in_metres(folder):
    """At 60 north a degree of longitude is half of one of latitude, which is 111.2 km."""
    write_tiff(folder / "degrees.tif", valley(), keys=DEGREES, scale=(0.1, 0.1, 0.0),
               tie=(0.0, 0.0, 0.0, 10.0, 61.95, 0.0))
    bounds = readers.read(folder / "degrees.tif").data.GetBounds()
    wt.check_at_most("a map in degrees: width over half of its height, less 1",
                     abs(2 * bounds[1] / bounds[3] - 1), 1e-6)
    wt.check_at_most("a map in degrees: km of 3.9 degrees, error", abs(bounds[3] / 1000.0 - 3.9 * 111.195), 0.1)


@pytest.mark.parametrize("linear, across, vertical, up", (
    (9001, 1.0, 9001, 1.0), (9002, 0.3048, None, 1.0), (9003, 1200 / 3937, 9002, 0.3048), (None, 1.0, 9003, 1200 / 3937)))
def test_a_map_in_feet_is_read_in_metres(folder, linear, across, vertical, up):
    """Places by the linear unit of the coordinate system, heights by the vertical one; without one they are metres."""
    keys = [(1024, 0, 1, 1)] + [(key, 0, 1, code) for key, code in ((3076, linear), (4099, vertical)) if code]
    write_tiff(folder / "feet.tif", valley(), keys=(1, 1, 0, len(keys), *sum(keys, ())))
    write_tiff(folder / "metres.tif", valley())
    feet, metres = (readers.read(folder / name).data for name in ("feet.tif", "metres.tif"))
    wanted = np.array(metres.GetBounds()) * np.repeat((across, across, up), 2)
    wt.check_at_most("bounds off by, of them", float(np.abs(np.array(feet.GetBounds()) / wanted - 1.0).max()), 1e-6)
    wt.check_equal("cells, less those at the hole", feet.GetNumberOfCells(), metres.GetNumberOfCells())


@pytest.mark.parametrize("name, level",
                         (("valley.vti", 40.0), ("valley.tif", 40.0), ("cone.stl", 0.0), ("cone.vtp", 0.0)))
def test_every_kind_of_file_makes_a_picture(folder, name, level):
    """A file of every kind is rendered with its reflection, in the size that is asked for."""
    out = folder / f"{name}.png"
    out.unlink(missing_ok=True)
    status, said = run(folder, "render", name, "--level", level, "--no-data", NO_DATA, *SIZE_OPTION, "--out", out.name)
    wt.check_equal(f"{name}: status, rendered", (status, "reflection rendered" in said), (0, True))
    picture = pixels_of(out)
    wt.check_equal(f"{name}: shape", picture.shape, (SIZE[1], SIZE[0], 3))
    wt.check_at_least(f"{name}: colours", wt.count_colors(picture), 100)


@pytest.mark.parametrize("name, level", (("valley.vti", 40.0), ("cone.stl", 0.0)))
def test_water_reaches_to_the_horizon(folder, name, level):
    """With --horizon the water goes on, up to the true horizon, and is the same before."""
    pictures = []
    for options in ((), ("--horizon",)):
        status, said = run(folder, "render", name, "--level", level, "--no-data", NO_DATA, *SIZE_OPTION, "--elevation", 14,
                           "--out", "horizon.png", *options)
        wt.check_equal(f"{name} {options}: status, rendered", (status, "reflection rendered" in said), (0, True))
        pictures.append(pixels_of(folder / "horizon.png"))
    rows = np.flatnonzero((np.abs(pictures[1] - pictures[0]).max(axis=2) > 2).mean(axis=1) > 0.5)
    # of the picture's 30 degrees: the horizon lies 14 over its middle
    horizon = 0.5 * SIZE[1] * (1 - np.tan(np.radians(14)) / np.tan(np.radians(15)))
    wt.check_at_most(f"{name}: first row that differs, from the horizon's", float(abs(rows[0] - horizon)), 1.0)
    wt.check_at_most(f"{name}: last row that differs, from the horizon's", float(rows[-1] - horizon), 12.0)


def test_heights_that_no_eye_can_see_are_holes(folder):
    """Heights beyond all measure are taken for holes, with a warning, and the picture is that without them."""
    spikes = valley()
    spikes[30, 30], spikes[30, 31] = 1e30, -3.4e38
    write_vti(folder / "spikes.vti", spikes)
    options = ("--level", 40, "--no-data", NO_DATA, *SIZE_OPTION, "--out")
    status, said = run(folder, "render", "spikes.vti", *options, "spikes.png")
    warned = ("spikes.vti: 2 of its heights, the first is 1e+30, are treated as holes; "
              "valid heights lie in [-1e+09, 1e+09]")
    wt.check_equal("heights no eye can see: status, warned", (status, warned in said), (0, True))
    run(folder, "render", "valley.vti", *options, "no_spikes.png")
    apart = np.abs(pixels_of(folder / "spikes.png") - pixels_of(folder / "no_spikes.png")).max(axis=2) > 2
    wt.check_at_most("heights no eye can see: of the pixels, as of two holes", float(apart.mean()), 0.02)


def test_a_picture_without_a_name_is_water_png(folder):
    """Without --out the picture is water.png."""
    (folder / "water.png").unlink(missing_ok=True)
    status, _ = run(folder, "render", "cone.stl", "--level", 0, *SIZE_OPTION)
    wt.check_equal("without --out: status, water.png is there", (status, (folder / "water.png").exists()), (0, True))


@pytest.mark.parametrize("level, words", ((-50.0, "nothing is flooded"), (500.0, "all of it is flooded")),
                         ids=("under_all", "over_all"))
def test_a_level_beside_the_ground_is_warned_of(folder, level, words):
    """A level that floods nothing, or all, makes a picture with a warning."""
    status, said = run(folder, "render", "valley.tif", "--level", level, *SIZE_OPTION)
    wt.check_equal(f"level {level}: status, warned", (status, words in said), (0, True))


@pytest.mark.parametrize("size, relief, wide", ((1.0, 0.3, 1.0), (9e3, 40.0, 1.0), (3e5, 3e3, 0.2), (10.0, 60.0, 1.0)))
def test_the_view_holds_all_that_stands_out_of_the_water(size, relief, wide):
    """All that stands out of the water and its mirror image are in the picture, of any size and relief, and the
    horizon is level."""
    x = np.linspace(-1.0, 1.0, 81)
    hills = relief * np.clip(1.0 - np.hypot(x[None, :], x[:, None]), -0.1, None)
    scene = Scene((240, 150))
    scene.add_ground(readers.surface_of_heights(hills, (size / 80, wide * size / 80)), 0.0)
    scene.add_water(0.0, refraction=False)  # what stands in the water may end out of the picture
    scene.make_island()
    scene.look(height=8.0)
    with_it = scene.picture().astype(int)
    name = f"{size:g} x {wide * size:g}, {relief:g} high"
    for i in range(scene.renderer.GetActors().GetNumberOfItems()):
        actor = scene.renderer.GetActors().GetItemAsObject(i)
        actor.SetVisibility(actor is scene.water)
    without = scene.picture().astype(int)
    changed = np.abs(with_it - without).max(axis=2) > 2
    rows, columns = np.nonzero(changed)
    wt.check_at_least(f"{name}: of the picture's width, or height, filled",
                      max(np.ptp(columns) / 240, np.ptp(rows) / 150), 0.8)
    at_border = changed[[0, -1]].any() or changed[:, [0, -1]].any()
    wt.check_equal(f"{name}: at the picture's border", bool(at_border), False)
    # all but as bright from left to right in every row (the angle is not quite the same): no edge of the water, no
    # slanted horizon
    wt.check_at_most(f"{name}: brightness along a row, without the ground",
                     max(np.ptp(row.sum(axis=1)) for row in without), 20)


@pytest.mark.parametrize("exaggeration", (1.0, 3.0))
def test_the_walls_of_high_ground_stand_in_the_water(exaggeration):
    """The walls of a terrain that is all over the water stand in it."""
    scene = Scene((240, 150))
    scene.add_ground(readers.surface_of_heights(np.full((5, 5), 7.0), (1.0, 1.0)), 2.0, exaggeration)
    scene.add_water(2.0, exaggeration=exaggeration)
    scene.make_island()
    lowest = min(actor.GetBounds()[4] for actor in scene.renderer.GetActors() if actor is not scene.water)
    wt.check_at_most(f"walls, {exaggeration:g} times as high: lowest, over the water",
                     round(lowest - 2.0 * exaggeration, 9), 0)


def color_of_a_bed(exaggeration, told=None):
    """Seen from straight above through clear water of 4 m. told: what the water is told, if not the same."""
    scene = Scene((64, 48))
    scene.add_ground(readers.surface_of_heights(np.full((5, 5), -4.0), (10.0, 10.0)), 0.0, exaggeration)
    scene.add_water(0.0, exaggeration=told or exaggeration, refraction=True)
    wt.place_camera(scene.renderer, (20, 20, 60), (20, 20, 0), (1, 200), view_up=(0, 1, 0))
    return scene.picture()[24, 32].astype(int)


def test_water_over_exaggerated_ground_is_as_clear():
    """The bed of a terrain that is drawn deeper has its colour."""
    plain = color_of_a_bed(1.0)
    wt.check_at_most("colour of the bed 3 times as deep, off by", int(np.abs(color_of_a_bed(3.0) - plain).max()), 2)
    wt.check_at_least("off by if the water were not told", int(np.abs(color_of_a_bed(3.0, 1.0) - plain).max()), 10)


LEVEL_1, LEVEL_50 = ("--level", 1), ("--level", 50)
BAD_FILES = (
    ("missing.vti: no such file", ("missing.vti", *LEVEL_1)),
    ("frames: is a folder, not a file", ("frames", *LEVEL_1)),
    ("text.xyz: unknown file type .xyz; known types are .tif", ("text.xyz", *LEVEL_1)),
    *((f"text.{kind}: not ", (f"text.{kind}", *LEVEL_1)) for kind in ("vti", "vtp", "stl", "tif", "vtk", "ply")),
    ("half.vti: not a VTK image", ("half.vti", *LEVEL_1)),
    ("empty.vtp: ", ("empty.vtp", *LEVEL_1)),
    ("holes.vti: has no elevations, only holes", ("holes.vti", *LEVEL_1)),
    ("row.vti: 1 x 5 heights are not a grid", ("row.vti", *LEVEL_1)),
    ("colours.tif: has no elevations: it has 3 numbers per pixel", ("colours.tif", *LEVEL_1)),
    ("scale.tif: its pixel size is 10.0; it must be two", ("scale.tif", *LEVEL_1)),
    ("nowhere.tif: its tie point (0.0, 0.0, 0.0, nan", ("nowhere.tif", *LEVEL_1)),
    ("pole.tif: its centre is at latitude", ("pole.tif", *LEVEL_1)),
    ("index.obj: cell 0 refers to point 8; there are 3", ("index.obj", *LEVEL_1)),
    ("far.obj: has a point at (1e+30, 0, 0); coordinates must lie in [-1e+09, 1e+09]", ("far.obj", *LEVEL_1)),
    ("SheetBounds are (0, 0, 0, 0)", ("dot.obj", "--level", 0)),
)
BAD_OUTPUTS = (
    ("no such folder: no/such", ("render", "valley.tif", *LEVEL_50, "--out", "no/such/folder.png")),
    ("ends with .png or .jpg or .jpeg or .webp", ("render", "valley.tif", *LEVEL_50, "--out", "x.bmp")),
    ("unknown file type .avi", ("animate", "valley.tif", *LEVEL_50, "--out", "x.avi")),
)
BAD_ARGUMENTS = (
    ("--level", ("render", "valley.tif")),
    ("'high' is not a number", ("render", "valley.tif", "--level", "high")),
    ("nan must lie in", ("render", "valley.tif", "--level", "nan")),
    ("'swamp' must be one of pool", ("render", "valley.tif", *LEVEL_1, "--preset", "swamp")),
    ("is not a size", ("render", "valley.tif", *LEVEL_1, "--size", "big")),
    *(("must lie in [0.1, 100] m/s, or be 0", ("render", "valley.tif", *LEVEL_1, "--wind", wind))
      for wind in (200, 0.05, "fast")),
    ("COMMAND", ()),
)


def judge_refusal(folder, status, words, arguments):
    """Runs the command; returns all that it said."""
    got, said = run(folder, *arguments)
    last = said.strip().splitlines()[-1]
    wt.check_equal(f"{' '.join(map(str, arguments))}: '{last}'", (got, words in last, "Traceback" in said),
                   (status, True, False))
    return said.strip().splitlines()


@pytest.mark.parametrize("words, arguments", BAD_FILES, ids=[arguments[0] for _, arguments in BAD_FILES])
def test_a_bad_file_is_one_line(folder, words, arguments):
    """A file that cannot be used ends the command with one line that names it and what is wrong."""
    wt.check_equal("  in one line", len(judge_refusal(folder, 1, words, ("render", *arguments))), 1)


LEGACY = "# vtk DataFile Version {}\nx\nASCII\nDATASET {}\n"
SQUARE = "POINTS 4 double\n0 0 0 1 0 0 1 1 0 0 1 0\n"
WRONG_CELLS = (  # VTK's reader accepts these files; its filters would crash
    (LEGACY.format(5.1, "POLYDATA") + SQUARE + "POLYGONS 3 6\nOFFSETS vtktypeint64\n0 5 3\n"
     "CONNECTIVITY vtktypeint64\n0 1 2 0 2 3\n", "offsets of its cells are wrong; they must ascend from 0 to at most 6"),
    (LEGACY.format(3.0, "RECTILINEAR_GRID") + "DIMENSIONS 3 2 1\n",
     "the grid has 0 coordinates along axis 0; its dimensions need 3"),
    (LEGACY.format(3.0, "RECTILINEAR_GRID") + "DIMENSIONS 3 2 1\nX_COORDINATES 3 double\n0 1 2\n"
     "Y_COORDINATES 1 double\n0\n", "the grid has 1 coordinates along axis 1; its dimensions need 2"),
    (LEGACY.format(3.0, "UNSTRUCTURED_GRID") + SQUARE + "CELLS 2 8\n3 0 1 2 3 0 2 3\n", "is empty: it has no cells"),
)


@pytest.mark.parametrize("text, words", WRONG_CELLS, ids=("offsets", "no coordinates", "few coordinates", "no types"))
def test_wrong_cells_of_a_file_are_told(text, words, tmp_path):
    """A file whose cells cannot be is refused with what is wrong with them."""
    path = tmp_path / "mesh.vtk"
    path.write_text(text)
    with pytest.raises(readers.FileError) as caught:
        readers.read(path)
    wt.check_equal("said", str(caught.value), f"{path}: {words}")


def ply_of(is_binary, is_big, faces):
    """A square's bytes: four places, and faces of those."""
    kind = f"binary_{'big' if is_big else 'little'}_endian" if is_binary else "ascii"
    header = (f"ply\nformat {kind} 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
              f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n").encode()
    places = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    if not is_binary:
        lines = places + [(len(face), *face) for face in faces]
        return header + "".join(" ".join(map(str, line)) + "\n" for line in lines).encode()
    order = ">" if is_big else "<"
    lists = b"".join(bytes([len(face)]) + np.array(face, order + "i4").tobytes() for face in faces)
    return header + np.array(places, order + "f4").tobytes() + lists


@pytest.mark.parametrize("faces", (((0, 1, 2), (0, 2, 3)), ((0, 1, 2, 3), (0, 1, 2))), ids=("even", "uneven"))
@pytest.mark.parametrize("is_binary, is_big", ((False, False), (True, False), (True, True)),
                         ids=("text", "little", "big"))
def test_a_ply_file_that_is_cut_off_is_told(is_binary, is_big, faces, tmp_path):
    """Wherever it ends, it is an error that says so; VTK's reader shows a part of it, or crashes."""
    whole, path = ply_of(is_binary, is_big, faces), tmp_path / "square.ply"
    path.write_bytes(whole)
    wt.check_equal("faces of the whole", readers.read(path).data.GetNumberOfCells(), 2)
    header = whole.index(b"end_header")
    shortest = 1 if is_binary else 2  # the end of the last line may be missing
    for size in (*range(4, header, 30), header + 5, *range(header + 11, len(whole) - shortest + 1)):
        path.write_bytes(whole[:size])
        with pytest.raises(readers.FileError) as caught:
            readers.read(path)
        words = "no end" if size < header + 10 else "is cut off; its header names 4 of the element 'vertex', 2 of"
        if words not in str(caught.value):
            wt.check_equal(f"{size} bytes: {caught.value}", "said", words)
    path.write_bytes(whole)


@pytest.mark.parametrize("is_binary", (False, True), ids=("text", "binary"))
@pytest.mark.parametrize("old, new, words", (
    (b"element vertex 4", b"element vertex -4", "the file is damaged"),
    (b"element face 2", b"element face -2", "the file is damaged"),
    (b"uchar int vertex_indices", b"uchar int parts", "its faces have no property vertex_indices"),
), ids=("vertices", "faces", "corners"))
def test_a_damaged_ply_file_is_told(is_binary, old, new, words, tmp_path):
    """VTK's reader crashes with such headers."""
    path = tmp_path / "square.ply"
    path.write_bytes(ply_of(is_binary, False, ((0, 1, 2), (0, 2, 3))).replace(old, new))
    with pytest.raises(readers.FileError, match=words):
        readers.read(path)


@pytest.mark.parametrize("is_binary", (False, True), ids=("text", "binary"))
def test_a_ply_face_of_fewer_than_no_corners_is_told(is_binary, tmp_path):
    """VTK's reader crashes with it."""
    path = tmp_path / "square.ply"
    whole = ply_of(is_binary, False, ((0, 1, 2), (0, 2, 3))).replace(b"list uchar", b"list char")
    old, new = (bytes((3, 0, 0, 0, 0)), bytes((255, 0, 0, 0, 0))) if is_binary else (b"\n3 0 1 2", b"\n-3 0 1 2")
    path.write_bytes(whole.replace(old, new, 1))
    wt.check_equal("changed", path.read_bytes() != whole, True)
    with pytest.raises(readers.FileError, match="the file is damaged"):
        readers.read(path)


def test_cells_without_types_are_told():
    """A grid with fewer types than cells is refused, with both numbers."""
    points, cells, grid = vtkPoints(), vtkCellArray(), vtkUnstructuredGrid()
    points.SetData(numpy_to_vtk(np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], float), deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.array((0, 1, 2, 0, 2, 3), np.int64), deep=True))
    grid.SetPoints(points)
    grid.SetCells(numpy_to_vtk(np.array([VTK_TRIANGLE], np.uint8), deep=True, array_type=VTK_UNSIGNED_CHAR), cells)
    with pytest.raises(readers.FileError, match="^mesh: the grid has 1 cell types; it has 2 cells$"):
        readers.check_cells(grid, "mesh")


@pytest.mark.parametrize("words, arguments", BAD_OUTPUTS, ids=("no_folder", "bmp", "avi"))
def test_a_bad_output_is_one_line(folder, words, arguments):
    """A file that cannot be written ends the command with one line that says why."""
    wt.check_equal("  in one line", len(judge_refusal(folder, 1, words, arguments)), 1)


@pytest.mark.parametrize("words, arguments", BAD_ARGUMENTS,
                         ids=("no_level", "level_high", "level_nan", "preset", "size", "wind_200", "wind_0.05",
                              "wind_fast", "no_command"))
def test_a_bad_argument_is_a_wrong_use(folder, words, arguments):
    """An argument that is missing or bad is a wrong use, exit status 2, and the last line names it."""
    judge_refusal(folder, 2, words, arguments)


def test_a_full_disk_is_one_line(folder):
    """A disk that fills up, an error that knows no file, ends the command with one line."""
    (folder / "full.gif").unlink(missing_ok=True)
    (folder / "full.gif").symlink_to("/dev/full")
    status, said = run(folder, "animate", "cone.stl", "--level", 0, "--frames", 2, "--size", "64x48",
                       "--out", "full.gif")
    wt.check_equal("a full disk", (status, said.splitlines()[-1]), (1, "vtkwater: No space left on device"))


@pytest.mark.parametrize("error, text", (
    (OSError(28, "No space left"), "here: No space left"),
    (OSError(2, "Not there", "x.png"), "here: x.png: Not there"),
    (OSError("x.png: half"), "here: x.png: half"), (ValueError("3 is odd"), "here: 3 is odd"),
), ids=("no_file", "file", "text", "value"))
def test_a_program_ends_with_the_errors_text(error, text):
    """A program that an error ends says where and what in one line."""
    with pytest.raises(SystemExit) as end:
        with ending("here"):
            raise error
    wt.check_equal(f"a program that ends with {error!r}", end.value.code, text)


def test_a_movie_has_its_frames(folder):
    """A movie of a rising level has as many frames as are asked for, and says so."""
    status, said = run(folder, "animate", "valley.tif", "--level", "20:60", "--frames", 3, *SIZE_OPTION,
                       "--out", "rise.gif")
    wt.check_equal(f"a movie: {said.strip()}", (status, "3 of 3 frames" in said), (0, True))
    with Image.open(folder / "rise.gif") as movie:
        wt.check_equal("frames in it", movie.n_frames, 3)


def test_numbers_may_begin_with_a_minus(folder):
    """Without =, argparse takes them for options."""
    status, said = run(folder, "animate", "valley.tif", "--level", "-1:60", "--frames", 2, *SIZE_OPTION, "--out", "minus.gif")
    wt.check_equal(f"a movie: {said.strip()}", (status, "2 of 2 frames" in said), (0, True))


@pytest.mark.parametrize("rate", (0.0, -1.0, float("nan")))
def test_a_movie_that_has_no_frame_leaves_files_as_they_are(rate, tmp_path):
    """An old movie stays, and no empty one is made."""
    old = tmp_path / "old.gif"
    old.write_bytes(b"old")
    with movies.open_movie(old, 5), movies.open_movie(tmp_path / "new.gif", 5):
        pass
    with pytest.raises(ValueError) as raised:
        movies.open_movie(old, rate)
    wt.check_equal("the error", str(raised.value), f"frames_per_second is {rate:g}; it must be at least 0.002, and finite")
    wt.check_equal("the old one, a new one", (old.read_bytes(), (tmp_path / "new.gif").exists()), (b"old", False))


def test_a_falling_level_bares_what_a_rising_one_floods(folder):
    """Walls, and the view, reach what a falling level bares: its pictures are those of a rise, from last to first."""
    write_vti(folder / "plateau.vti", np.full((5, 5), 70.0, dtype=np.float32))
    movies = {}
    for name, levels in (("fall", (60, 20)), ("rise", (20, 60))):
        arguments = ["animate", "plateau.vti", "--level", "{}:{}".format(*levels), "--frames", 2, *SIZE_OPTION,
                     "--out", name]
        wt.check_equal(f"{name}: status", run(folder, *arguments)[0], 0)
        movies[name] = [pixels_of(folder / name / f"000{i}.png") for i in range(2)]
        arguments[1] = folder / arguments[1]
        scene = command.make_scene(command.make_parser().parse_args([*map(str, arguments)]), levels)[0]
        wt.check_at_least(f"{name}: the eye's height over the highest level",
                          scene.renderer.GetActiveCamera().GetPosition()[2] - 60, 1)
    for i in range(2):
        wt.check_equal(f"a level that falls, less one that rises, picture {i}",
                       int(np.abs(movies["fall"][i] - movies["rise"][1 - i]).max()), 0)


def test_an_animation_that_is_stopped_keeps_whole_pictures(folder):
    """An animation that is stopped keeps the pictures made so far, each whole, and says how many."""
    frames = folder / "frames"
    for old in frames.glob("*.png"):
        old.unlink()
    process = subprocess.Popen([sys.executable, "-m", "vtkwater", "animate", "valley.tif", "--level", "20:60",
                                "--frames", "5000", *SIZE_OPTION, "--out", "frames"],
                               cwd=folder, stdout=subprocess.PIPE, text=True)
    end = time.monotonic() + 60.0
    while len(list(frames.glob("*.png"))) < 3 and time.monotonic() < end:
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    said = process.communicate(timeout=60)[0]
    kept = sorted(frames.glob("*.png"))
    wt.check_equal(f"stopped: status of '{said.strip()}'", process.returncode, 130)
    wt.check_at_least("stopped: pictures kept", len(kept), 3)
    wt.check_equal("stopped: it says how many", f"{len(kept)} of 5000 frames, stopped" in said, True)
    wt.check_equal("stopped: the last is whole", pixels_of(kept[-1]).shape, (SIZE[1], SIZE[0], 3))


def test_info_tells_what_is_used(folder):
    """info tells the versions, the window and the renderer."""
    status, said = run(folder, "info")
    tells = all(word in said for word in ("vtkwater ", "VTK ", "window vtk", "renderer "))
    wt.check_equal("info", (status, tells), (0, True))


@pytest.fixture(scope="module")
def of_a_kind(folder):
    """Makes the picture of one scene as a file of a suffix's kind. The PNG is made once."""
    def make(kind):
        status, said = run(folder, "render", "valley.vti", *LEVEL_50, "--size", "240x160", "--out", f"kinds.{kind}")
        wt.check_equal(f"{kind}: status of '{said.strip()}'", status, 0)
    make("png")
    return make


@pytest.mark.parametrize("kind, begins", (("jpg", b"\xff\xd8\xff"), ("JPEG", b"\xff\xd8\xff"), ("webp", b"RIFF")))
def test_a_picture_is_of_its_suffixs_kind(folder, of_a_kind, kind, begins):
    """JPEG and WebP files show what the PNG shows."""
    of_a_kind(kind)
    wt.check_equal("first bytes", (folder / f"kinds.{kind}").read_bytes()[:len(begins)], begins)
    apart = np.abs(pixels_of(folder / "kinds.png").astype(int) - pixels_of(folder / f"kinds.{kind}"))
    wt.check_at_most("mean distance to the PNG, of 255", apart.mean(), 2.0)
    wt.check_equal("and it is another file", (folder / f"kinds.{kind}").stat().st_size
                   < (folder / "kinds.png").stat().st_size, True)


def json_of(folder, *arguments):
    """Exit status, the JSON on stdout, and what stderr has."""
    status, out, err = COMMANDS.run_apart(folder, *arguments, "--json")
    return status, json.loads(out), err


def test_results_are_json_for_pipelines(folder):
    """With --json stdout is one object: of a picture, a movie, a failure, the versions. Messages stay on stderr."""
    small = ("--size", "64x48")
    status, facts, _ = json_of(folder, "render", "valley.tif", *LEVEL_50, *small, "--time", 2, "--out", "json.png")
    wt.check_equal("render", (status, facts), (0, {"file": "json.png", "width": 64, "height": 48, "time": 2.0,
                                                   "level": 50.0, "reflection": "rendered"}))
    status, facts, err = json_of(folder, "render", "valley.tif", "--level", "high", *small)
    wt.check_equal("a wrong option", (status, list(facts), facts["error"] in err), (2, ["error"], True))
    status, facts, _ = json_of(folder, "animate", "cone.stl", "--level", 0, *small, "--frames", 2, "--out", "json.gif")
    wt.check_equal("animate", (status, facts), (0, {"file": "json.gif", "frames": 2, "of": 2, "stopped": False}))
    status, facts, said = json_of(folder, "render", "missing.vti", *LEVEL_50)
    wt.check_equal("failure", (status, facts, said),
                   (1, {"error": "missing.vti: no such file"}, "vtkwater: missing.vti: no such file\n"))
    status, facts, said = json_of(folder, "render", "valley.tif", "--level", 5000, *small, "--out", "json.png")
    wt.check_equal("warning on stderr", (status, "level 5000 is above the ground" in said), (0, True))
    status, facts, _ = json_of(folder, "info")
    wt.check_equal("info", (status, {"vtkwater", "VTK", "Python", "window", "renderer", "OpenGL"} <= set(facts)),
                   (0, True))


def test_a_view_without_a_display_says_so(folder):
    """view needs a display; without one it ends and names the command that needs none."""
    status, said = run(folder, "view", "valley.tif", *LEVEL_50)
    wt.check_equal(said, (status, "there is no display" in said, "vtkwater render" in said), (1, True, True))


@pytest.mark.parametrize("arguments", (["--help"], ["render", "--help"], ["animate", "--help"], ["view", "--help"]), ids=" ".join)
def test_help_has_an_example(folder, arguments):
    """Help has an example, and leaves no file of its option's name."""
    status, said = run(folder, *arguments)
    wt.check_equal(f"{arguments}: status, an example", (status, "--level 355 --preset lake" in said), (0, True))
    wt.check_equal("no file called --help", (folder / "--help").exists(), False)

# SPDX-License-Identifier: BSD-3-Clause
"""The command vtkwater: pictures of every kind of file, holes that stay holes, and one clear line for what is wrong."""

import pathlib
import signal
import subprocess
import sys
import time

import numpy as np
import water_test as wt
from PIL import Image
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter
from vtkwater import command, readers
from vtkwater.errors import ending
from vtkwater.scenes import Scene

FOLDER = wt.output_folder() / "Command"
FOLDER.mkdir(exist_ok=True)
SIZE = (240, 160)
NO_DATA = -9999.0


def run(*arguments):
    """Exit status and all that was said."""
    done = subprocess.run([sys.executable, "-m", "vtkwater", *map(str, arguments)], capture_output=True, text=True,
                          cwd=FOLDER, timeout=120)
    return done.returncode, done.stdout + done.stderr


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


def write_tiff(path, heights, keys=(), scale=(10.0, 10.0, 0.0), tie=(0.0, 0.0, 0.0, 500.0, 9000.0, 0.0)):
    from PIL import TiffImagePlugin

    tags = TiffImagePlugin.ImageFileDirectory_v2()
    for tag, value, kind in ((33550, scale, 12), (33922, tie, 12), (34735, keys, 3), (42113, str(NO_DATA), 2)):
        if value:
            tags[tag] = value
            tags.tagtype[tag] = kind
    Image.fromarray(heights[::-1]).save(path, tiffinfo=tags)


def write_files():
    write_vti(FOLDER / "valley.vti", valley())
    write_tiff(FOLDER / "valley.tif", valley())
    cone = vtkConeSource()
    cone.SetDirection(0.0, 0.0, 1.0)
    for name, writer in (("cone.stl", vtkSTLWriter()), ("cone.vtp", vtkXMLPolyDataWriter())):
        writer.SetInputConnection(cone.GetOutputPort())
        writer.SetFileName(str(FOLDER / name))
        writer.Write()
    empty = vtkXMLPolyDataWriter()
    empty.SetInputData(vtkPolyData())
    empty.SetFileName(str(FOLDER / "empty.vtp"))
    empty.Write()
    write_vti(FOLDER / "holes.vti", np.full((4, 4), np.nan, dtype=np.float32))
    write_vti(FOLDER / "row.vti", np.zeros((1, 5), dtype=np.float32))
    Image.new("RGB", (4, 4)).save(FOLDER / "colours.tif")
    for name in ("text.vti", "text.vtp", "text.stl", "text.tif", "text.vtk", "text.ply", "text.xyz"):
        (FOLDER / name).write_text("not what its name claims\n")
    write_tiff(FOLDER / "scale.tif", valley(), scale=(10.0,))
    write_tiff(FOLDER / "nowhere.tif", valley(), tie=(0.0, 0.0, 0.0, np.nan, 9000.0, 0.0))
    write_tiff(FOLDER / "pole.tif", valley(), keys=(1, 1, 0, 1, 1024, 0, 1, 2), tie=(0.0, 0.0, 0.0, 0.0, 9000.0, 0.0))
    triangle = "v 0 0 0\nv {0} 0 0\nv 0 {0} 0\nf 1 2 {1}\n"
    (FOLDER / "index.obj").write_text(triangle.format(1, 9))
    (FOLDER / "dot.obj").write_text(triangle.format(0, 3))
    (FOLDER / "far.obj").write_text(triangle.format(1e30, 3))
    (FOLDER / "half.vti").write_bytes((FOLDER / "valley.vti").read_bytes()[:900])


def check_readers():
    for name in ("valley.vti", "valley.tif"):
        ground = readers.read(FOLDER / name, NO_DATA)
        low = [500.0, 8610.0] if name.endswith("tif") else [0.0, 0.0]
        bounds = ground.data.GetBounds()
        wt.check_equal(f"{name}: west, south, lowest, highest", [bounds[0], bounds[2], round(bounds[4], 3), bounds[5]],
                       [*low, 2.564, 100.0])
        wt.check_equal(f"{name}: cells, less those at the hole", ground.data.GetNumberOfCells(), 39 * 39 - 25)
    # its own no-data value is in the TIFF
    wt.check_equal("the TIFF's own holes", readers.read(FOLDER / "valley.tif").data.GetNumberOfCells(), 39 * 39 - 25)
    write_vti(FOLDER / "blanked.vti", np.ones((10, 10), dtype=np.float32), blanked=(33,))
    wt.check_equal("cells, less those at a blanked point", readers.read(FOLDER / "blanked.vti").data.GetNumberOfCells(), 81 - 4)
    # In degrees, at 60 north: a degree of longitude is half of one of latitude, which is 111.2 km.
    write_tiff(FOLDER / "degrees.tif", valley(), keys=(1, 1, 0, 1, 1024, 0, 1, 2), scale=(0.1, 0.1, 0.0),
               tie=(0.0, 0.0, 0.0, 10.0, 61.95, 0.0))
    bounds = readers.read(FOLDER / "degrees.tif").data.GetBounds()
    wt.check_at_most("a map in degrees: width over half of its height, less 1", abs(2 * bounds[1] / bounds[3] - 1), 1e-6)
    wt.check_at_most("a map in degrees: km of 3.9 degrees, error", abs(bounds[3] / 1000.0 - 3.9 * 111.195), 0.1)


def check_pictures():
    for name, level in (("valley.vti", 40.0), ("valley.tif", 40.0), ("cone.stl", 0.0), ("cone.vtp", 0.0)):
        out = FOLDER / f"{name}.png"
        out.unlink(missing_ok=True)
        status, said = run("render", name, "--level", level, "--no-data", NO_DATA, "--size", "240x160", "--out", out.name)
        wt.check_equal(f"{name}: status, rendered", (status, "reflection rendered" in said), (0, True))
        picture = np.asarray(Image.open(out))
        wt.check_equal(f"{name}: shape", picture.shape, (SIZE[1], SIZE[0], 3))
        wt.check_at_least(f"{name}: colours", len(np.unique(picture.reshape(-1, 3), axis=0)), 100)
    spikes = valley()
    spikes[30, 30], spikes[30, 31] = 1e30, -3.4e38
    write_vti(FOLDER / "spikes.vti", spikes)
    status, said = run("render", "spikes.vti", "--level", 40, "--no-data", NO_DATA, "--size", "240x160")
    warned = "spikes.vti: 2 of its heights, 1e+30 is the first, are taken for holes; known heights lie in [-1e+09, 1e+09]"
    wt.check_equal("heights no eye can see: status, warned", (status, warned in said), (0, True))
    picture, without = (np.asarray(Image.open(FOLDER / name)).astype(int) for name in ("water.png", "valley.vti.png"))
    wt.check_at_most("heights no eye can see: of the pixels, as of two holes",
                     float((np.abs(picture - without).max(axis=2) > 2).mean()), 0.02)
    for level, words in ((-50.0, "nothing is flooded"), (500.0, "all of it is flooded")):
        status, said = run("render", "valley.tif", "--level", level, "--size", "240x160")
        wt.check_equal(f"level {level}: status, warned", (status, words in said), (0, True))


def check_view():
    """All that stands out of the water and its mirror image are in the picture, of any size and relief; the horizon is level."""
    for size, relief, wide in ((1.0, 0.3, 1.0), (9e3, 40.0, 1.0), (3e5, 3e3, 0.2), (10.0, 60.0, 1.0)):
        x = np.linspace(-1.0, 1.0, 81)
        hills = relief * np.clip(1.0 - np.hypot(x[None, :], x[:, None]), -0.1, None)
        scene = Scene((240, 150))
        scene.add_ground(readers.surface_of_heights(hills, (size / 80, wide * size / 80)), 0.0)
        scene.add_water(0.0)
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
        wt.check_equal(f"{name}: at the picture's border", bool(changed[[0, -1]].any() or changed[:, [0, -1]].any()), False)
        # all but as bright from left to right in every row (the angle is not quite the same): no edge of the water, no slanted horizon
        wt.check_at_most(f"{name}: brightness along a row, without the ground",
                         max(np.ptp(row.sum(axis=1)) for row in without), 20)


def check_walls():
    """The walls of a terrain that is all over the water stand in it."""
    for exaggeration in (1.0, 3.0):
        scene = Scene((240, 150))
        scene.add_ground(readers.surface_of_heights(np.full((5, 5), 7.0), (1.0, 1.0)), 2.0, exaggeration)
        scene.add_water(2.0, exaggeration=exaggeration)
        scene.make_island()
        lowest = min(actor.GetBounds()[4] for actor in scene.renderer.GetActors() if actor is not scene.water)
        wt.check_at_most(f"walls, {exaggeration:g} times as high: lowest, over the water", round(lowest - 2.0 * exaggeration, 9), 0)


def check_errors():
    cases = [
        (1, "missing.vti: no such file", ["render", "missing.vti", "--level", 1]),
        (1, "frames: is a folder, not a file", ["render", "frames", "--level", 1]),
        (1, "text.xyz: kind .xyz is not known; known are .tif", ["render", "text.xyz", "--level", 1]),
        *((1, f"text.{kind}: not ", ["render", f"text.{kind}", "--level", 1])
          for kind in ("vti", "vtp", "stl", "tif", "vtk", "ply")),
        (1, "half.vti: not a VTK image", ["render", "half.vti", "--level", 1]),
        (1, "empty.vtp: ", ["render", "empty.vtp", "--level", 1]),
        (1, "holes.vti: holds no elevations, only holes", ["render", "holes.vti", "--level", 1]),
        (1, "row.vti: 1 x 5 heights are no grid", ["render", "row.vti", "--level", 1]),
        (1, "colours.tif: holds no elevations: it has 3 numbers a pixel", ["render", "colours.tif", "--level", 1]),
        (1, "scale.tif: its pixels are 10.0 large; wanted are two", ["render", "scale.tif", "--level", 1]),
        (1, "nowhere.tif: its tie point (0.0, 0.0, 0.0, nan", ["render", "nowhere.tif", "--level", 1]),
        (1, "pole.tif: its middle is at latitude", ["render", "pole.tif", "--level", 1]),
        (1, "index.obj: a cell names point 8; there are 3", ["render", "index.obj", "--level", 1]),
        (1, "far.obj: has a point at (1e+30, 0, 0); coordinates must lie in [-1e+09, 1e+09]", ["render", "far.obj", "--level", 1]),
        (1, "SheetBounds are (0, 0, 0, 0)", ["render", "dot.obj", "--level", 0]),
        (1, "no such folder: no/such", ["render", "valley.tif", "--level", 50, "--out", "no/such/folder.png"]),
        (1, "ends with .png", ["render", "valley.tif", "--level", 50, "--out", "x.jpg"]),
        (1, "kind .avi is not known", ["animate", "valley.tif", "--level", 50, "--out", "x.avi"]),
        (2, "--level", ["render", "valley.tif"]),
        (2, "'high' is no number", ["render", "valley.tif", "--level", "high"]),
        (2, "nan must lie in", ["render", "valley.tif", "--level", "nan"]),
        (2, "'swamp' must be one of pool", ["render", "valley.tif", "--level", 1, "--preset", "swamp"]),
        (2, "is no size", ["render", "valley.tif", "--level", 1, "--size", "big"]),
        *((2, "must lie in [0.1, 100] m/s, or be 0", ["render", "valley.tif", "--level", 1, "--wind", wind])
          for wind in (200, 0.05, "fast")),
        (2, "COMMAND", []),
    ]
    for status, words, arguments in cases:
        got, said = run(*arguments)
        last = said.strip().splitlines()[-1]
        wt.check_equal(f"{' '.join(map(str, arguments))}: '{last}'", (got, words in last, "Traceback" in said),
                       (status, True, False))
        if status == 1:
            wt.check_equal("  in one line", len(said.strip().splitlines()), 1)
    # a disk that fills up: an OSError that knows no file
    (FOLDER / "full.gif").unlink(missing_ok=True)
    (FOLDER / "full.gif").symlink_to("/dev/full")
    status, said = run("animate", "cone.stl", "--level", 0, "--frames", 2, "--size", "64x48", "--out", "full.gif")
    wt.check_equal("a full disk", (status, said.splitlines()[-1]), (1, "vtkwater: No space left on device"))
    for error, text in ((OSError(28, "No space left"), "here: No space left"), (OSError(2, "Not there", "x.png"), "here: x.png: Not there"),
                        (OSError("x.png: half"), "here: x.png: half"), (ValueError("3 is odd"), "here: 3 is odd")):
        try:
            with ending("here"):
                raise error
        except SystemExit as end:
            wt.check_equal(f"a program that ends with {error!r}", end.code, text)


def check_animation():
    status, said = run("animate", "valley.tif", "--level", "20:60", "--frames", 3, "--size", "240x160", "--out", "rise.gif")
    wt.check_equal(f"a movie: {said.strip()}", (status, "3 of 3 frames" in said), (0, True))
    with Image.open(FOLDER / "rise.gif") as movie:
        wt.check_equal("frames in it", movie.n_frames, 3)

    # walls, and the view, reach what a falling level bares: as where it rises
    write_vti(FOLDER / "plateau.vti", np.full((5, 5), 70.0, dtype=np.float32))
    movies = {}
    for name, levels in (("fall", (60, 20)), ("rise", (20, 60))):
        arguments = ["animate", "plateau.vti", "--level", "{}:{}".format(*levels), "--frames", 2, "--size", "240x160", "--out", name]
        wt.check_equal(f"{name}: status", run(*arguments)[0], 0)
        movies[name] = [np.asarray(Image.open(FOLDER / name / f"000{i}.png")).astype(int) for i in range(2)]
        arguments[1] = FOLDER / arguments[1]
        scene = command.make_scene(command.make_parser().parse_args([*map(str, arguments)]), levels)[0]
        wt.check_at_least(f"{name}: the eye's height over the highest level", scene.renderer.GetActiveCamera().GetPosition()[2] - 60, 1)
    for i in range(2):
        wt.check_equal(f"a level that falls, less one that rises, picture {i}",
                       int(np.abs(movies["fall"][i] - movies["rise"][1 - i]).max()), 0)

    frames = FOLDER / "frames"
    for old in frames.glob("*.png"):
        old.unlink()
    process = subprocess.Popen([sys.executable, "-m", "vtkwater", "animate", "valley.tif", "--level", "20:60", "--frames",
                                "5000", "--size", "240x160", "--out", "frames"], cwd=FOLDER, stdout=subprocess.PIPE, text=True)
    end = time.monotonic() + 60.0
    while len(list(frames.glob("*.png"))) < 3 and time.monotonic() < end:
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    said = process.communicate(timeout=60)[0]
    kept = sorted(frames.glob("*.png"))
    wt.check_equal(f"stopped: status of '{said.strip()}'", process.returncode, 130)
    wt.check_at_least("stopped: pictures kept", len(kept), 3)
    wt.check_equal("stopped: it says how many", f"{len(kept)} of 5000 frames, stopped" in said, True)
    wt.check_equal("stopped: the last is whole", np.asarray(Image.open(kept[-1])).shape, (SIZE[1], SIZE[0], 3))


def check_info_and_help():
    status, said = run("info")
    wt.check_equal("info", (status, all(word in said for word in ("vtkwater ", "VTK ", "window vtk", "renderer "))), (0, True))
    for arguments in (["--help"], ["render", "--help"], ["animate", "--help"]):
        status, said = run(*arguments)
        wt.check_equal(f"{arguments}: status, an example", (status, "--level 355 --preset lake" in said), (0, True))
    wt.check_equal("no file called --help", pathlib.Path(FOLDER / "--help").exists(), False)


write_files()
check_readers()
check_pictures()
check_view()
check_walls()
(FOLDER / "frames").mkdir(exist_ok=True)
check_errors()
check_animation()
check_info_and_help()
wt.finish()

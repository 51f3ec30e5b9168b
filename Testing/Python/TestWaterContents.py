# SPDX-License-Identifier: BSD-3-Clause
"""vtkwater info FILE tells what a file holds, and the commands that it suggests render it; errors are one line."""

import json
import os
import shlex
import subprocess
import sys

import numpy as np
import pytest
import water_test as wt
from TestWaterCommand import write_tiff
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkPlaneSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter
from vtkwater import command
from vtkwater.contents import contents_of, text_of


def add_array(data, name, values):
    array = numpy_to_vtk(np.asarray(values, dtype=float), deep=True)
    array.SetName(name)
    data.AddArray(array)


def write(writer, file, data):
    writer.SetFileName(str(file))
    writer.SetInputData(data)
    writer.Write()


def flood():
    """A slope under a level of 1: depth, bed, and a current of 3 m/s, of 4 x 3 points."""
    plane = vtkPlaneSource()
    plane.SetOrigin(0.0, 0.0, 0.0)
    plane.SetPoint1(30.0, 0.0, 0.0)
    plane.SetPoint2(0.0, 20.0, 0.0)
    plane.SetResolution(3, 2)
    plane.Update()
    mesh = plane.GetOutput()
    bed = np.tile((-2.0, -1.0, 0.0, 2.0), 3)
    add_array(mesh.GetPointData(), "zb", bed)
    add_array(mesh.GetPointData(), "H", np.maximum(1.0 - bed, 0.0))
    add_array(mesh.GetCellData(), "velocity", np.tile((0.0, 3.0, 0.0), (6, 1)))
    return mesh


@pytest.fixture(scope="module")
def folder():
    made = wt.output_folder() / "Contents"
    (made / "depths").mkdir(parents=True, exist_ok=True)
    (made / "empty").mkdir(exist_ok=True)
    write(vtkXMLPolyDataWriter(), made / "flood.vtp", flood())
    (made / "flood.pvd").write_text('<VTKFile type="Collection"><Collection><DataSet timestep="0" file="flood.vtp"/>'
                                    '<DataSet timestep="600" file="flood.vtp"/></Collection></VTKFile>')
    slope = np.tile(np.linspace(0.0, 100.0, 41), (21, 1)).astype(np.float32)
    write_tiff(made / "slope.tif", slope)
    for name, values in (("depth_0", 60.0 - slope), ("depth_60", 80.0 - slope), ("bed", slope)):
        write_tiff(made / "depths" / f"{name}.tif", np.maximum(values, 0.0) if "depth" in name else values)
    cone = vtkConeSource()
    cone.Update()
    write(vtkSTLWriter(), made / "cone of steel.stl", cone.GetOutput())
    image = vtkImageData()
    image.SetDimensions(4, 4, 4)
    add_array(image.GetPointData(), "alpha.water", np.repeat((1.0, 1.0, 0.0, 0.0), 16))
    write(vtkXMLImageDataWriter(), made / "tank.vti", image)
    return made


def test_arrays_steps_bounds_and_unit_are_told(folder):
    facts = contents_of(folder / "flood.pvd")
    wt.check_equal("kind, size", (facts["kind"], facts["points"], facts["cells"]), ("solver's mesh", 12, 6))
    wt.check_equal("bounds", facts["bounds"], [0.0, 30.0, 0.0, 20.0, 0.0, 0.0])
    wt.check_equal("times", facts["times"], [0.0, 600.0])
    arrays = {array["name"]: (array["of"], array["components"], array["range"]) for array in facts["arrays"]}
    wt.check_equal("depth", arrays["H"], ("points", 1, [0.0, 3.0]))
    wt.check_equal("bed", arrays["zb"], ("points", 1, [-2.0, 2.0]))
    wt.check_equal("current, by its magnitude", arrays["velocity"], ("cells", 3, [3.0, 3.0]))
    text = text_of(facts)
    for words in ("x 0 to 30; y 0 to 20; z 0 to 0", "units: metres", "steps: 2, times 0 to 600", "H (points) 0 to 3",
                  "velocity (cells, 3 components, magnitude) 3 to 3", "--depth H --bed zb --flow velocity"):
        wt.check_equal(f"the text says '{words}'", words in text, True)


def test_the_level_of_a_terrain_floods_a_quarter_of_it(folder):
    facts = contents_of(folder / "slope.tif")
    wt.check_equal("kind", facts["kind"], "terrain")
    wt.check_equal("command", facts["try"][-1].endswith("--level 25"), True)


def test_the_level_of_a_mesh_cuts_it_in_half(folder):
    facts = contents_of(folder / "cone of steel.stl")
    wt.check_equal("kind, level", (facts["kind"], shlex.split(facts["try"][-1])[-1]), ("mesh", "0"))


def suggested(file):
    """The level of each suggested command; None: it has none."""
    for words in map(shlex.split, contents_of(file)["try"]):
        yield float(words[words.index("--level") + 1]) if "--level" in words else None


def test_a_level_lies_among_the_heights(folder):
    """Also if most of the land is a sea, and far from 0; never outside, as 0 is for a flat mesh over a bed at 300."""
    coast = np.zeros((20, 30), dtype=np.float32)
    coast[:, 20:] = np.linspace(1.0, 40.0, 10)
    write_tiff(folder / "coast.tif", coast)
    write_tiff(folder / "plateau.tif", np.where(coast > 0, -coast, coast))
    write_tiff(folder / "low.tif", np.tile(np.linspace(-6e-5, 0.0, 41, dtype=np.float32), (21, 1)))
    cone = vtkConeSource()
    cone.SetOutputPointsPrecision(1)
    cone.SetCenter(0.0, 0.0, 1234567.5)
    cone.SetRadius(0.125)
    cone.Update()
    write(vtkXMLPolyDataWriter(), folder / "far.vtp", cone.GetOutput())
    for name in ("coast.tif", "plateau.tif", "low.tif", "far.vtp"):
        low, high = contents_of(folder / name)["bounds"][4:]
        for level in suggested(folder / name):
            wt.check_equal(f"{name}: {level:.9g} lies inside ({low:.9g}, {high:.9g})", low < level < high, True)
            wt.check_equal(f"{name}: without exponent", "e" in contents_of(folder / name)["try"][0].split()[-1], False)
    mesh = flood()
    mesh.GetPointData().GetArray("zb").FillComponent(0, 300.0)
    mesh.GetPointData().GetArray("zb").SetTuple1(0, 310.0)
    write(vtkXMLPolyDataWriter(), folder / "flat.vtp", mesh)
    wt.check_equal("levels of a flat mesh with a depth", list(suggested(folder / "flat.vtp")), [None])
    mesh.GetPointData().RemoveArray("H")
    write(vtkXMLPolyDataWriter(), folder / "flat.vtp", mesh)
    wt.check_equal("levels of a flat mesh with a bed alone", list(suggested(folder / "flat.vtp")), [305.0])
    write(vtkSTLWriter(), folder / "flat.stl", mesh)
    facts = contents_of(folder / "flat.stl")
    wt.check_equal("commands for a flat mesh", facts["try"], [])
    wt.check_equal("a note", facts["notes"], ["all heights are 0: no level lies between them"])


def test_a_volume_is_shown_by_a_contour(folder):
    facts = contents_of(folder / "tank.vti")
    wt.check_equal("kind", facts["kind"], "solver's volume")
    wt.check_equal("command", facts["try"][0].endswith("--contour alpha.water"), True)


@pytest.mark.parametrize("name", ("flood.pvd", "slope.tif", "depths", "cone of steel.stl", "tank.vti"))
def test_what_is_suggested_renders(folder, name, capsys):
    line = contents_of(folder / name)["try"][0]
    program, *arguments = shlex.split(line)
    picture = folder / "suggested.png"
    picture.unlink(missing_ok=True)
    status = command.main([*arguments, "--size", "160x100", "--out", str(picture)])
    wt.check_equal(f"{line}: {capsys.readouterr().err}", (program, status, picture.exists()), ("vtkwater", 0, True))


def test_a_bed_is_suggested_as_ground(tmp_path):
    """Of level, depth and bed, the last two: without its bed, the water would have no ground."""
    mesh = flood()
    add_array(mesh.GetPointData(), "level", np.ones(12))
    write(vtkXMLPolyDataWriter(), tmp_path / "a.vtp", mesh)
    (line,) = [line for line in contents_of(tmp_path / "a.vtp")["try"] if "--depth" in line]
    wt.check_equal(line, "--depth H --bed zb" in line and "--level" not in line, True)


def test_a_closed_pipe_is_a_silent_end(folder):
    """As of ``vtkwater info FILE | head -0``."""
    for arguments in (("info", str(folder / "slope.tif")), ("info", str(folder / "slope.tif"), "--json"), ("--help",)):
        reading, writing = os.pipe()
        os.close(reading)
        ended = subprocess.run([sys.executable, "-m", "vtkwater", *arguments], stdout=writing, stderr=subprocess.PIPE)
        os.close(writing)
        wt.check_equal(f"{arguments}: status, said", (ended.returncode, ended.stderr.decode()), (0, ""))


def test_unknown_names_ask_for_the_arrays(folder):
    mesh = flood()
    for name in ("zb", "H"):
        mesh.GetPointData().GetArray(name).SetName(f"my_{name}_7")
    write(vtkXMLPolyDataWriter(), folder / "odd.vtp", mesh)
    (folder / "odd.pvd").write_text('<VTKFile type="Collection"><Collection><DataSet file="odd.vtp"/></Collection>'
                                    "</VTKFile>")
    facts = contents_of(folder / "odd.pvd")
    wt.check_equal("no command", facts["try"], [])
    wt.check_equal("a note", ["--level, --depth and --bed" in note for note in facts["notes"]], [True])


def test_json_has_the_same(folder, capsys):
    status = command.main(["info", str(folder / "flood.pvd"), "--json"])
    wt.check_equal("status, facts", (status, json.loads(capsys.readouterr().out)),
                   (0, contents_of(folder / "flood.pvd")))


@pytest.mark.parametrize("name, words", (
    ("nothing.tif", ("nothing.tif", "no such file")),
    ("empty", ("has no GeoTIFF files",)),
    ("coded.pvd", ("not a ParaView collection", "unknown encoding")),
    ("flood.doc", ("unknown file type .doc", ".tif", ".pvd"))))
def test_what_cannot_be_read_is_an_error_in_a_line(folder, name, words, capsys):
    (folder / "flood.doc").write_text("no data")
    (folder / "coded.pvd").write_text('<?xml version="1.0" encoding="foo"?><VTKFile/>')
    status = command.main(["info", str(folder / name)])
    said = capsys.readouterr().err
    wt.check_equal(f"{said!r}: status, lines", (status, said.count("\n")), (1, 1))
    for word in words:
        wt.check_equal(f"{said!r} says {word!r}", word in said, True)


@pytest.mark.parametrize("arguments, words", (
    (("render", "depths", "--level", "8"), ("depths is a folder", "--depth depth --bed bed", "vtkwater info depths")),
    (("render", "slope.tif"), ("--level is missing", "vtkwater info slope.tif")),
    (("render", "missing.vtp"), ("missing.vtp: no such file",)),
    (("render", "slope.tif", "--level", "8", "--zoom", "0"), ("--zoom", "0.01", "1000")),
    (("animate", "slope.tif", "--level", "8", "--frames", "x"), ("--frames", "'x'")),
    (("render", "slope.tif", "--level", "8", "--wind-direction", "30"), ("--wind",))))
def test_a_wrong_command_line_is_one_line_that_names_the_help(folder, monkeypatch, arguments, words, capsys):
    monkeypatch.chdir(folder)
    with pytest.raises(SystemExit) as ended:
        command.main(list(arguments))
    said = capsys.readouterr().err
    wt.check_equal(f"{said!r}: status, lines", (ended.value.code, said.count("\n")), (2, 1))
    for word in (*words, f"vtkwater {arguments[0]}: error", f"see vtkwater {arguments[0]} --help"):
        wt.check_equal(f"{said!r} says {word!r}", word in said, True)

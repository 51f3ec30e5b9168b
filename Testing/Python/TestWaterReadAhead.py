# SPDX-License-Identifier: BSD-3-Clause
"""Steps that another process reads ahead are those that this one would have read, and so are their errors."""

import gc
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, VTK_TETRA, vtkUnstructuredGrid
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter
from vtkwater import ahead, solutions
from vtkwater.readers import FileError

STEPS = 6


def add_array(data, name, values):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    data.AddArray(array)


def flood(step):
    """A plane whose points, depths and speeds change from step to step, in single and double precision."""
    source = vtkPlaneSource()
    source.SetResolution(8, 8)
    source.Update()
    mesh = source.GetOutput()
    places = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    places[:, 2] = 0.1 * step
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    mesh.SetPoints(points)
    add_array(mesh.GetPointData(), "h", np.float32(places[:, 0] + step))
    add_array(mesh.GetCellData(), "v", np.full((64, 3), float(step)))
    add_array(mesh.GetCellData(), "unused", np.zeros(64))
    return mesh


def grid(step):
    """A tetrahedron."""
    mesh = vtkUnstructuredGrid()
    points = vtkPoints()
    for place in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)):
        points.InsertNextPoint(place)
    mesh.SetPoints(points)
    mesh.InsertNextCell(VTK_TETRA, 4, [0, 1, 2, 3])
    add_array(mesh.GetPointData(), "h", np.arange(4.0) + step)
    return mesh


def write_series(folder, mesh_of=flood, kind="vtp"):
    writer = vtkXMLPolyDataWriter() if kind == "vtp" else vtkXMLUnstructuredGridWriter()
    entries = []
    for step in range(STEPS):
        writer.SetFileName(str(folder / f"{step}.{kind}"))
        writer.SetInputData(mesh_of(step))
        writer.Write()
        entries.append(f'<DataSet timestep="{10.0 * step}" file="{step}.{kind}"/>')
    path = folder / "series.pvd"
    path.write_text(f'<VTKFile type="Collection"><Collection>{"".join(entries)}</Collection></VTKFile>')
    return path


def contents(mesh):
    """All of a mesh, for a comparison."""
    cells = mesh.GetPolys() if mesh.IsA("vtkPolyData") else mesh.GetCells()
    made = [mesh.GetClassName(), vtk_to_numpy(mesh.GetPoints().GetData()), vtk_to_numpy(cells.GetOffsetsArray()),
            vtk_to_numpy(cells.GetConnectivityArray())]
    for data in (mesh.GetPointData(), mesh.GetCellData()):
        for i in range(data.GetNumberOfArrays()):
            made += [data.GetArrayName(i), vtk_to_numpy(data.GetArray(i))]
    return made


def are_equal(one, other):
    one, other = contents(one), contents(other)
    return len(one) == len(other) and all(
        np.array_equal(a, b) and getattr(a, "dtype", None) == getattr(b, "dtype", None) for a, b in zip(one, other))


def h_of(mesh):
    """The number of a step of flood, by its first depth."""
    return float(vtk_to_numpy(mesh.GetPointData().GetArray("h"))[0]) + 0.5


def wait_for_answer(solution):
    solution._ahead._thread.join(20)
    assert not solution._ahead._thread.is_alive()


def run(tmp_path, code):
    """What a program of its own prints, on both outputs, with a series in path."""
    begin = (f"import sys\nsys.path[:] = {sys.path!r}\n"
             "import gc, os, signal\nfrom vtkwater import ahead, solutions\n"
             "from TestWaterReadAhead import h_of, wait_for_answer, STEPS\n"
             f"path = {str(write_series(tmp_path))!r}\n")
    done = subprocess.run([sys.executable, "-c", begin + code], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, timeout=60)
    return done.stdout.strip()


def read_here(monkeypatch):
    """The numbers of the steps that are read in this process from now on."""
    numbers, made = [], solutions.Solution._made

    def remember(self, i):
        numbers.append(i)
        return made(self, i)

    monkeypatch.setattr(solutions.Solution, "_made", remember)
    return numbers


@pytest.mark.parametrize("mesh_of, kind, arrays, is_volume", (
    (flood, "vtp", ["h", "v"], False), (grid, "vtu", ["h"], True)), ids=("surface", "volume"))
def test_a_time_has_the_same_mesh_whatever_was_read_ahead(tmp_path, mesh_of, kind, arrays, is_volume):
    """Forwards, backwards, and in leaps; at steps, and between them."""
    path = write_series(tmp_path, mesh_of, kind)
    times = np.concatenate([np.linspace(0, 50, 11), np.linspace(50, 0, 11),
                            np.random.default_rng(1).uniform(0, 50, 12)])
    plain = solutions.Solution(path, arrays, is_volume)
    with_ahead = solutions.Solution(path, arrays, is_volume, read_ahead=True)
    wt.check_equal("times with the same mesh",
                   sum(are_equal(plain.at(at), with_ahead.at(at)) for at in times), len(times))


def test_the_next_step_comes_from_the_other_process(tmp_path, monkeypatch):
    """Played forwards all but the first steps do, and backwards all but the last."""
    solution = solutions.Solution(write_series(tmp_path), ["h"], read_ahead=True)
    numbers = read_here(monkeypatch)
    for step in range(STEPS):
        solution.step(step)
    wt.check_equal("steps read here", numbers, [1])  # 0 when it was opened, and nothing was ahead yet
    for step in reversed(range(STEPS)):
        solution.step(step)
    wt.check_equal("steps read here, and backwards", numbers, [1, STEPS - 3])


def test_an_error_is_raised_when_its_step_is_asked_for(tmp_path):
    """And again each time, with the text that it has without reading ahead; the steps around it are well."""
    path = write_series(tmp_path)
    (tmp_path / "3.vtp").write_text("damaged")
    plain, texts = solutions.Solution(path, ["h"]), []
    with pytest.raises(FileError) as caught:
        plain.step(3)
    solution = solutions.Solution(path, ["h"], read_ahead=True)
    for step in (0, 1, 2, 3, 4, 5, 3):
        try:
            solution.step(step)
        except FileError as error:
            texts.append((step, str(error)))
    wt.check_equal("errors", texts, [(3, str(caught.value)), (3, str(caught.value))])


def test_steps_are_read_without_the_other_process(tmp_path, monkeypatch):
    """When it has been ended."""
    path = write_series(tmp_path)
    solution = solutions.Solution(path, ["h"], read_ahead=True)
    solution.step(1)
    solution._ahead._process.kill()
    numbers = read_here(monkeypatch)
    for step in range(2, STEPS):
        wt.check_equal(f"h of step {step}", h_of(solution.step(step)), step)
    wt.check_at_least("steps read here", len(numbers), STEPS - 3)


@pytest.mark.parametrize("program", (None, "", "{folder}/python", "{folder}/application"),
                         ids=("none", "empty", "not there", "not Python"))
def test_steps_are_read_where_python_is_no_program(tmp_path, monkeypatch, program):
    """And an application that has Python inside is not started again."""
    application = tmp_path / "application"
    application.write_text(f"#!/bin/sh\ntouch {tmp_path}/started\n")
    application.chmod(0o755)
    monkeypatch.setattr(ahead.sys, "executable", program and program.format(folder=tmp_path))
    solution = solutions.Solution(write_series(tmp_path), ["h"], read_ahead=True)
    wt.check_equal("steps", [h_of(solution.step(step)) for step in range(STEPS)], list(range(STEPS)))
    time.sleep(0.2)
    wt.check_equal("started", (tmp_path / "started").exists(), False)


def test_the_other_process_ends_with_the_solution(tmp_path):
    solution = solutions.Solution(write_series(tmp_path), ["h"], read_ahead=True)
    solution.step(1)
    process = solution._ahead._process
    ahead.end(process, os.getpid() + 1)  # as in a fork, which does not own it
    wt.check_equal("runs", process.poll() is None, True)
    del solution
    gc.collect()
    begin = time.monotonic()
    while process.poll() is None and time.monotonic() - begin < 10:
        time.sleep(0.05)
    wt.check_equal("has ended", process.poll() is not None, True)


def test_short_series_need_no_other_process(tmp_path):
    path = write_series(tmp_path)
    solution = solutions.Solution(tmp_path / "0.vtp", ["h"], read_ahead=True)
    wt.check_equal("one step", solution._ahead, None)
    wt.check_equal("by default", solutions.Solution(path, ["h"])._ahead, None)


def test_what_arrays_do_not_hold_is_not_sent():
    mesh = grid(0)
    wt.check_equal("a tetrahedron", ahead.pack(mesh) is not None, True)
    faces = [4, 3, 0, 1, 2, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 2, 3]
    ids = vtkIdList()
    for value in faces:
        ids.InsertNextId(value)
    mesh.InsertNextCell(VTK_POLYHEDRON, ids)
    wt.check_equal("a polyhedron", ahead.pack(mesh), None)


def test_an_answer_to_another_question_is_not_used(tmp_path, monkeypatch):
    """As when two processes ask in the same pipe. It ends the other process: nothing that follows can be trusted."""
    solution = solutions.Solution(write_series(tmp_path), ["h"], read_ahead=True)
    solution.step(1)
    wait_for_answer(solution)
    process = solution._ahead._process
    process.stdin.write(b"5\n")  # asked by somebody else: its answer comes first
    process.stdin.flush()
    solution.step(2)
    wait_for_answer(solution)
    wt.check_equal("step 3", h_of(solution.step(3)), 3)
    wt.check_equal("has ended", process.poll() is not None, True)
    wt.check_equal("step 4", h_of(solution.step(4)), 4)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")
def test_a_fork_reads_its_steps_itself(tmp_path):
    """And neither takes the answers of the process that it comes from nor ends its reader."""
    text = run(tmp_path, """
solution = solutions.Solution(path, ["h"], read_ahead=True)
solution.step(1)
wait_for_answer(solution)
child = os.fork()
signal.alarm(20)  # each of the two ends, whatever happens
if not child:
    solution._ahead._lock.acquire(False)  # as a thread may have held it
    print([h_of(solution.step(step)) for step in (2, 3, 2, 1, 0)], flush=True)
    del solution
    gc.collect()
    os._exit(0)
os.waitpid(child, 0)
print(solution._ahead._process.poll())
numbers, made = [], solutions.Solution._made
solutions.Solution._made = lambda self, i: numbers.append(i) or made(self, i)
print([h_of(solution.step(step)) for step in (2, 3, 4)], numbers)
""")
    wt.check_equal("steps of the fork, and after it", text.splitlines(),
                   ["[2.0, 3.0, 2.0, 1.0, 0.0]", "None", "[2.0, 3.0, 4.0] []"])


def test_threads_get_the_steps_they_ask_for(tmp_path):
    """What several threads take from the other process is of the step that each has asked for, or nothing."""
    other = ahead.Ahead(write_series(tmp_path), ["h"], False, None)
    wrong, taken = [], []

    def ask_and_take(seed):
        for step in np.random.default_rng(seed).integers(0, STEPS, 60):
            try:
                other.ask(int(step))
                mesh = other.take(int(step))
                if mesh:
                    (taken if h_of(mesh) == step else wrong).append(step)
            except Exception as error:
                wrong.append(repr(error))

    threads = [threading.Thread(target=ask_and_take, args=(seed,)) for seed in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    wt.check_equal("wrong meshes and errors", wrong, [])
    wt.check_at_least("meshes", len(taken), 30)


def test_threads_share_a_solution(tmp_path, monkeypatch):
    """A step that another thread drops from memory while the next one is asked for is still returned."""
    solution = solutions.Solution(write_series(tmp_path), ["h"], read_ahead=True)
    monkeypatch.setattr(solution._ahead, "ask", lambda number, files: solution.forget())
    wt.check_equal("step 2", h_of(solution.step(2)), 2)


def test_components_keep_their_names(tmp_path, monkeypatch):
    def named(step):
        mesh = flood(step)
        for i, name in ((0, "east"), (2, "up")):
            mesh.GetCellData().GetArray("v").SetComponentName(i, name)
        return mesh

    path = write_series(tmp_path, named)
    solution = solutions.Solution(path, ["v"], read_ahead=True)
    plain = solutions.Solution(path, ["v"])
    solution.step(1)
    here = read_here(monkeypatch)
    ahead_of, of_plain = ([mesh.GetCellData().GetArray("v").GetComponentName(i) for i in range(3)]
                          for mesh in (solution.step(2), plain.step(2)))
    wt.check_equal("names", ahead_of, of_plain)
    wt.check_equal("the first", ahead_of[0], "east")
    wt.check_equal("steps read here", here, [2])  # by plain


def test_a_reader_that_died_leaves_no_text(tmp_path):
    """Neither when it is asked in vain, nor when the program ends."""
    text = run(tmp_path, """
solution = solutions.Solution(path, ["h"], read_ahead=True)
solution.step(1)
wait_for_answer(solution)
process = solution._ahead._process
process.kill()
os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT)  # has died, but nobody knows
print([h_of(solution.step(step)) for step in (2, 3)], process.returncode)
""")
    wt.check_equal("all that it says", text, "[2.0, 3.0] -9")  # its end was seen as soon as it was of no use


@pytest.mark.skipif(not hasattr(signal, "SIGSTOP"), reason="this system cannot stop a process")
def test_a_reader_that_does_not_answer_is_ended(tmp_path, monkeypatch):
    monkeypatch.setattr(ahead, "LIMIT_S", 0.5)
    solution = solutions.Solution(write_series(tmp_path), ["h"], read_ahead=True)
    solution.step(1)
    wait_for_answer(solution)
    process = solution._ahead._process
    process.send_signal(signal.SIGSTOP)
    solution.step(2)
    answers = []
    thread = threading.Thread(target=lambda: answers.append(h_of(solution.step(3))), daemon=True)
    thread.start()
    thread.join(20)
    is_stuck = thread.is_alive()
    process.send_signal(signal.SIGCONT)
    wt.check_equal("waits for ever", is_stuck, False)
    wt.check_equal("step 3", answers, [3])
    wt.check_equal("has ended", process.poll() is not None, True)


@pytest.mark.parametrize("text", ("hello\\n", "no end of line"))
def test_what_python_prints_when_it_starts_is_no_answer(tmp_path, monkeypatch, text):
    (tmp_path / "sitecustomize.py").write_text(f"import sys\nsys.stdout.write('{text}')\nsys.stdout.flush()\n")
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(tmp_path), os.environ.get("PYTHONPATH", "")]))
    solution = solutions.Solution(write_series(tmp_path), ["h"], read_ahead=True)
    solution.step(1)
    numbers = read_here(monkeypatch)
    wt.check_equal("steps", [h_of(solution.step(step)) for step in range(2, STEPS)], list(range(2, STEPS)))
    wt.check_equal("steps read here", numbers, [])


def test_what_an_import_prints_is_no_answer(tmp_path, monkeypatch):
    """Not even the line that begins an answer."""
    (tmp_path / "json.py").write_text("import os\nos.write(1, b'vtkwater: a step\\nnot a mesh')\n"
                                      "import sys\nsys.path.remove(os.path.dirname(__file__))\n"
                                      "del sys.modules['json']\nimport json\n")
    monkeypatch.setattr(sys, "path", [str(tmp_path), *sys.path])
    solution = solutions.Solution(write_series(tmp_path), ["h"], read_ahead=True)
    solution.step(1)
    numbers = read_here(monkeypatch)
    wt.check_equal("step", h_of(solution.step(2)), 2)
    wt.check_equal("steps read here", numbers, [])


@pytest.mark.parametrize("is_collection", (False, True), ids=("a step's file", "the collection"))
def test_a_file_that_changes_is_read_again(tmp_path, monkeypatch, is_collection):
    """A step's, after it was read ahead; of the collection, before it was opened there, too."""
    path = write_series(tmp_path)
    solution = solutions.Solution(path, ["h"], read_ahead=True)
    if is_collection:
        text = path.read_text()
        path.write_text(text.replace("2.vtp", "5.vtp") + "\n")
    solution.step(1)
    if not is_collection:
        wait_for_answer(solution)
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(tmp_path / "2.vtp"))
        writer.SetInputData(flood(100))
        writer.Write()
    numbers = read_here(monkeypatch)
    wt.check_equal("step 2", h_of(solution.step(2)), 2 if is_collection else 100)
    wt.check_equal("steps read here", numbers, [2])


def test_the_other_process_keeps_no_step(tmp_path):
    """It may have changed when it is asked for again."""
    other = ahead.Ahead(write_series(tmp_path), ["h"], False, None)
    other.ask(2)
    wt.check_equal("step 2", h_of(other.take(2)), 2)
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(str(tmp_path / "2.vtp"))
    writer.SetInputData(flood(100))
    writer.Write()
    other.ask(2)
    wt.check_equal("step 2, later", h_of(other.take(2)), 100)

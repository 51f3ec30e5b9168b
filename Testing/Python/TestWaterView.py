# SPDX-License-Identifier: BSD-3-Clause
"""The window of vtkwater view: its slider moves the water, its keys write, pause and step, time moves the waves."""

import time

import numpy as np
import water_test as wt
from PIL import Image
from vtkmodules.vtkRenderingUI import vtkGenericRenderWindowInteractor
from vtkwater import readers
from vtkwater.scenes import Scene
from vtkwater.view import Viewer

SIZE = (400, 300)
LEVELS = (0.0, 80.0)
# the slider's tube reaches from 6 to 44 per cent of the width
START, END = (0.06 + 0.38 * 50.0 / 80.0, 0.1), (0.06 + 0.38 * 10.0 / 80.0, 0.1)


def valley_scene(**look):
    scene = Scene(SIZE)
    heights = np.tile(80.0 * np.abs(np.linspace(-1.0, 1.0, 40)), (40, 1))
    scene.add_ground(readers.surface_of_heights(heights, (10.0, 10.0)), 50.0, 2.0)
    scene.add_water(50.0, exaggeration=2.0, **look)
    scene.make_island()
    scene.look(150.0, 20.0)
    return scene


def make(tmp_path, **look):
    scene = valley_scene(**look)
    interactor = vtkGenericRenderWindowInteractor()  # the events of a user, without a display
    interactor.SetRenderWindow(scene.window)
    viewer = Viewer(scene, interactor, str(tmp_path / "saved.png"), levels=LEVELS, exaggeration=2.0, time=1.0)
    interactor.Initialize()
    return scene, interactor, viewer


def press(interactor, key):
    interactor.SetKeySym(key)
    interactor.InvokeEvent("KeyPressEvent")


def drag(interactor, start, stop):
    for share, event in ((0.0, interactor.MouseMoveEvent), (0.0, interactor.LeftButtonPressEvent),
                         (0.5, interactor.MouseMoveEvent), (1.0, interactor.MouseMoveEvent),
                         (1.0, interactor.LeftButtonReleaseEvent)):
        interactor.SetEventInformation(*(round(size * (a + (b - a) * share)) for size, a, b in zip(SIZE, start, stop)))
        event()


def test_the_slider_moves_the_water(tmp_path):
    """A mouse that drags the slider lowers the water, in the heights of the data, and the picture shows it."""
    scene, interactor, viewer = make(tmp_path, wind=0)
    before = scene.picture().astype(int)
    drag(interactor, START, END)
    level = scene.water.GetLevel() / 2.0
    wt.check_at_most("level, from 10; the slider has caps", abs(level - 10.0), 5.0)
    shown = np.abs(scene.picture().astype(int) - before).max(axis=2) > 8
    wt.check_at_least("of the pixels changed", shown.mean(), 0.05)
    title = viewer._slider.widget.GetRepresentation().GetTitleText()
    wt.check_equal("title", title, f"water level {level:.4g}")


def test_a_drag_beside_the_slider_turns_the_scene(tmp_path):
    scene, interactor, _ = make(tmp_path, wind=0)
    eye, level = scene.renderer.GetActiveCamera().GetPosition(), scene.water.GetLevel()
    drag(interactor, (0.5, 0.6), (0.7, 0.65))
    moved = np.linalg.norm(np.subtract(scene.renderer.GetActiveCamera().GetPosition(), eye))
    wt.check_at_least("the eye moved", moved, 1.0)
    wt.check_equal("level", scene.water.GetLevel(), level)


def test_return_writes_the_picture_without_the_slider(tmp_path):
    """The key Return writes what vtkwater render would, and other keys write nothing."""
    scene, interactor, _ = make(tmp_path, wind=0)
    press(interactor, "x")
    wt.check_equal("after another key", (tmp_path / "saved.png").exists(), False)
    press(interactor, "Return")
    with Image.open(tmp_path / "saved.png") as picture:
        saved = np.asarray(picture.convert("RGB"), dtype=int)
    plain = valley_scene(wind=0)
    plain.water.SetTime(1.0)
    wt.check_at_most("distance to the picture without a slider", np.abs(saved - plain.picture()).max(), 1)
    wt.check_at_least("the slider is there again", np.abs(scene.picture().astype(int) - saved).max(), 50)


def test_a_picture_that_cannot_be_written_does_not_end_the_view(tmp_path, capsys):
    _, interactor, viewer = make(tmp_path, wind=0)
    viewer._picture = str(tmp_path / "none/saved.png")
    press(interactor, "Return")
    wt.check_equal("it says so", "no such folder" in capsys.readouterr().out, True)


def test_waves_move_with_the_clock_until_space(tmp_path):
    """Ticks of the timer move the waves; the key space stops and starts them."""
    scene, interactor, _ = make(tmp_path, preset="lake")
    times = []
    for key in (None, "space", "space"):
        if key:
            press(interactor, key)
        interactor.InvokeEvent("TimerEvent")
        begin = scene.water.GetTime()
        time.sleep(0.05)
        interactor.InvokeEvent("TimerEvent")
        times.append(scene.water.GetTime() - begin)
    wt.check_at_least("running", times[0], 0.05)
    wt.check_equal("stopped", times[1], 0.0)
    wt.check_at_least("running again", times[2], 0.05)


def test_calm_water_draws_no_frames_of_its_own(tmp_path):
    scene, interactor, viewer = make(tmp_path, wind=0)
    interactor.InvokeEvent("TimerEvent")
    time.sleep(0.02)
    interactor.InvokeEvent("TimerEvent")
    wt.check_equal("time", scene.water.GetTime(), 1.0)
    wt.check_equal("help", all(word in viewer.help for word in ("slider", "space", "Return", "q: ends")), True)


class Steps:
    """A solver's water as the viewer uses it."""

    def __init__(self, times):
        self.solution, self.shown = self, []
        self.times = times

    def show(self, time):
        self.shown.append(time)


def test_arrows_show_the_steps_of_a_solvers_file(tmp_path):
    """Left and Right show the steps before and after, and stop at both ends."""
    scene = valley_scene(wind=0)
    interactor = vtkGenericRenderWindowInteractor()
    interactor.SetRenderWindow(scene.window)
    data = Steps([0.0, 10.0, 30.0])
    viewer = Viewer(scene, interactor, str(tmp_path / "saved.png"), data=data, time=10.0)
    interactor.Initialize()
    for key in ("Right", "Right", "Left", "Left", "Left"):
        press(interactor, key)
    wt.check_equal("steps", data.shown, [30.0, 30.0, 10.0, 0.0, 0.0])
    wt.check_equal("help", "steps" in viewer.help and "slider" not in viewer.help, True)


class DamagedSteps(Steps):
    """Steps of which one cannot be read."""

    def show(self, time):
        super().show(time)
        if time == 10.0:
            raise readers.FileError("1.vtp: is damaged")


def test_a_damaged_step_is_said_and_the_old_one_stays(tmp_path, capsys):
    scene = valley_scene(wind=0)
    interactor = vtkGenericRenderWindowInteractor()
    interactor.SetRenderWindow(scene.window)
    data = DamagedSteps([0.0, 10.0, 30.0])
    Viewer(scene, interactor, str(tmp_path / "saved.png"), data=data)
    interactor.Initialize()
    for _ in range(2):
        press(interactor, "Right")
    output = capsys.readouterr()
    wt.check_equal("it says", (output.out, output.err), ("vtkwater: 1.vtp: is damaged\n" * 2, ""))
    wt.check_equal("shown", data.shown, [10.0, 0.0, 10.0, 0.0])
    wt.check_equal("time", scene.water.GetTime(), 0.0)

# SPDX-License-Identifier: BSD-3-Clause
"""The window of `vtkwater view`: turn the scene, move the water, step through a solver's file.

    viewer = Viewer(scene, interactor_of(scene), "water.png", levels=(350.0, 400.0))
    print(viewer.help)
    viewer.run()
"""
import contextlib
import time as clock

from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import vtkRenderWindowInteractor

from .widgets import LevelSlider

__all__ = ["Viewer", "interactor_of"]

TICK_MS = 40


def interactor_of(scene):
    """An interactor for the scene's window, which is shown on the display."""
    scene.window.SetOffScreenRendering(False)
    scene.window.SetWindowName("vtkwater")
    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(scene.window)
    return interactor


def is_moving(look):
    return bool(look.GetSea()) or look.GetNumberOfWaves() > 0 or look.GetNumberOfNormalMaps() > 0


class Viewer:
    """What the mouse and the keys do in a window with water.

    Parameters
    ----------
    scene : scenes.Scene
        With ground, water and camera.
    interactor : :vtk:`vtkRenderWindowInteractor`
        Of the scene's window.
    picture : str
        File that the key Return writes.
    levels : tuple[float, float], optional
        The ends of a slider for the level, in the data's unit. Without it there is no slider.
    exaggeration : float, default: 1.0
        Factor of the heights, as the scene draws them. Slider and title show the data's heights.
    data : data_scenes.DataWater, optional
        Water of a solver's file: the keys Left and Right show its other steps.
    time : float, default: 0.0
        Time that is shown at first.
    """

    def __init__(self, scene, interactor, picture, *, levels=None, exaggeration=1.0, data=None, time=0.0):
        self._scene, self._interactor, self._picture, self._data = scene, interactor, picture, data
        self._exaggeration = exaggeration
        self._time, self._last_tick = time, None
        self.is_running = data is None and is_moving(scene.water.GetWaterProperty())
        interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
        scene.water.SetTime(time)
        self._slider = None
        if levels and levels[0] < levels[1]:
            self._slider = LevelSlider(interactor, scene.water, exaggeration * levels[0], exaggeration * levels[1],
                                       changed=self._name_level)
            self._slider.widget.GetRepresentation().ShowSliderLabelOff()  # it would be of the heights as drawn
            self._name_level(scene.water.GetLevel())
        self._keys = {"Return": self._write, "space": self._pause}
        if data is not None:
            self._keys.update(Left=lambda: self._step(-1), Right=lambda: self._step(1))
        interactor.AddObserver("KeyPressEvent", self._pressed)
        interactor.AddObserver("TimerEvent", self._ticked)

    @property
    def help(self):
        """One line about mouse and keys."""
        parts = ["drag to turn", "wheel to zoom"]
        parts += ["slider: level"] if self._slider else []
        parts += ["Left and Right: steps"] if self._data is not None else ["space: stops and starts the waves"]
        return ", ".join([*parts, f"Return: writes {self._picture}", "q: ends"])

    def run(self):
        """Show the window until the user closes it."""
        if not self._interactor.GetInitialized():
            self._interactor.Initialize()
        self._interactor.CreateRepeatingTimer(TICK_MS)
        self._scene.window.Render()
        self._interactor.Start()

    def _name_level(self, drawn):
        self._slider.widget.GetRepresentation().SetTitleText(f"water level {drawn / self._exaggeration:.4g}")

    def _pressed(self, interactor, event):
        action = self._keys.get(interactor.GetKeySym())
        if action:
            action()

    def _ticked(self, interactor, event):
        now = clock.monotonic()
        if self.is_running:
            self._time += now - (now if self._last_tick is None else self._last_tick)
            self._scene.water.SetTime(self._time)
            self._scene.window.Render()
        self._last_tick = now

    def _pause(self):
        self.is_running = not self.is_running and self._data is None

    def _step(self, by):
        times = self._data.solution.times
        at = min(range(len(times)), key=lambda i: abs(times[i] - self._time))
        time = times[min(max(at + by, 0), len(times) - 1)]
        try:
            self._data.show(time)
        except (OSError, RuntimeError, ValueError) as error:  # a damaged step; RuntimeError is netCDF4's
            print(f"vtkwater: {error}")
            with contextlib.suppress(OSError, RuntimeError, ValueError):
                self._data.show(self._time)  # the water may have got a part of what failed
            return
        self._time = time
        self._scene.water.SetTime(self._time)
        self._scene.window.Render()

    def _write(self):
        is_shown = self._slider is not None
        if is_shown:
            self._slider.widget.EnabledOff()  # a picture of the water, not of the slider
        try:
            self._scene.write(self._picture)
            print(self._picture)
        except (OSError, ValueError) as error:
            print(f"vtkwater: {error}")
        if is_shown:
            self._slider.widget.EnabledOn()

# SPDX-License-Identifier: BSD-3-Clause
"""effect_scenes: each effect of the water, on and off in one window, in frames that take turns; needs no plots.

All other settings of the water are the same with and without the effect. The camera and the time of the waves move on in every frame:
of a view that stands still, what the water looks up is used again.
"""

from dataclasses import dataclass

import data_tide
import gpu_data
import numpy as np
import scenes
import water_test as wt
from timing import Frame, measure
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper, vtkSkybox
from vtkwater import vtkWaterClearSkySource, vtkWaterProperty

TILE = 128
SUN = (-300.0, -120.0, 55.0)  # before the eye: it glitters, and land shades water
UNDER_WATER = (45.0, 17.6, -1.5)
LEAST_CHANGE = 0.0005  # of the pixels, or the effect is not there
CELLS = 40_000  # of the mesh that carries data


def _nothing(scene, look):
    pass


@dataclass(frozen=True)
class Effect:
    """prepare(scene, look): what is there beside it; switch(scene, look, is_on)."""

    name: str
    prepare: object
    switch: object
    eye: tuple = None  # else as in the terrain's scene


def _waves(scene, look):
    look.AddWave(0.10, 6.0, 20.0, 0.0)
    look.AddWave(0.04, 2.5, 80.0, 70.0)


def _clear(scene, look):
    _waves(scene, look)
    look.RefractionOn()


def _from_below(scene, look):
    _clear(scene, look)
    look.SetAbsorption(0.25, 0.06, 0.03)


def _foam_and_glitter(scene, look):
    _clear(scene, look)
    look.SetSlopeVariance(0.02, 0.02)
    look.SetFoamDepth(1.0)


def _slopes(scene, look):
    _waves(scene, look)
    look.SetSlopeVariance(0.02, 0.02)


def _sea(scene, look):
    look.SetSea(True)
    look.SetWindSpeed(10)
    look.SetSeaTileSize(TILE)
    look.SetWhitecaps(False)
    look.SetWhitecapLifeTime(0.0)
    look.SetWaveGeometry(False)


def _white_sea(scene, look):
    _sea(scene, look)
    look.SetWhitecaps(True)


def _sky(scene, look):
    _waves(scene, look)
    source = vtkWaterClearSkySource()
    scene.skybox = vtkSkybox()
    source.ConfigureSkybox(scene.skybox, scene.renderer)
    scene.renderer.AddActor(scene.skybox)


def _fall(scene, look):
    """Another water, whose plane leans over the first one, which reflects it."""
    wt.add_water(scene.renderer, wt.plane((24, 9, 0), (1, 0.7, -0.25)), (-7, 7, -1, 4), 0.7)


def _data(scene, look):
    """The water is a mesh with a number per point."""
    tide = data_tide.Tide(CELLS)
    points = tide.points(np.zeros(tide.side**2)) * (80 / data_tide.HALF_WIDTH, 90 / data_tide.HALF_WIDTH, 1)
    mesh = gpu_data.mesh_of(tide, points[:, 2])
    mesh.GetPoints().SetData(numpy_to_vtk(points + (0, 50, 0), deep=True))
    gpu_data.set_array(mesh, "h", np.abs(tide.step(0)[1]))
    scene.mapper = vtkPolyDataMapper()
    scene.mapper.SetInputData(mesh)
    gpu_data.color(scene.mapper)
    scene.water.SetMapper(scene.mapper)


def _of_look(name):
    return lambda scene, look, is_on: getattr(look, f"Set{name}")(is_on)


def _amount(name, amount):
    return lambda scene, look, is_on: getattr(look, f"Set{name}")(amount if is_on else 0.0)


def _own_view(scene, look, is_on):
    look.SetRefractionSource(vtkWaterProperty.OWN_VIEW if is_on else vtkWaterProperty.PICTURE)


EFFECTS = (
    Effect("refraction", _waves, _of_look("Refraction")),
    Effect("refraction's own view", _clear, _own_view),
    Effect("caustics", _clear, _amount("Caustics", 1.0)),
    Effect("glitter", _slopes, _of_look("Glitter")),
    Effect("glitter that rolls off", _slopes, _of_look("HighlightRollOff")),
    Effect("foam", _clear, _amount("FoamDepth", 1.0)),
    Effect("shadows", _foam_and_glitter, _of_look("Shadows")),
    Effect("displaced waves", _waves, _of_look("WaveGeometry")),
    Effect("displaced sea", _sea, _of_look("WaveGeometry")),
    Effect("whitecaps", _sea, _of_look("Whitecaps")),
    Effect("lifetime of whitecaps", _white_sea, _amount("WhitecapLifeTime", 3.5)),
    Effect("clear sky", _sky, lambda scene, look, is_on: scene.skybox.SetVisibility(is_on)),
    Effect("secondary reflections", _fall,
           lambda scene, look, is_on: scene.water.GetReflectionPass().SetSecondaryReflections(is_on)),
    Effect("data colours", _data, lambda scene, look, is_on: scene.mapper.SetScalarVisibility(is_on)),
    Effect("under water", _from_below, lambda scene, look, is_on: scene.water.SetVisibility(is_on), UNDER_WATER),
    Effect("light shafts", _from_below, _amount("LightShafts", 1.0), UNDER_WATER),
    Effect("dome port", _clear, _amount("DomePortRadius", 10.0)),
)


@dataclass
class Measured:
    """An effect's two kinds of frame, and the share of the pixels that it changes."""

    name: str
    off: Frame
    on: Frame
    changed: float

    @property
    def ratio(self):
        return self.on.median / self.off.median


def measured(effect, size, rounds, budget_s):
    """Measures an effect in a window of its own."""
    kind = scenes.kinds(True)["terrain"]
    scene = scenes.Scene(kind, size)
    wt.add_scene_light(scene.renderer, SUN)
    if effect.eye:
        scene.look(effect.eye, kind.target, kind.angle)
    look = scene.water.GetWaterProperty()
    effect.prepare(scene, look)

    def frame(is_on):
        return Frame("on" if is_on else "off", scene.window, scene.step, lambda: effect.switch(scene, look, is_on))

    frames = [frame(False), frame(True)]
    pictures = []
    for each in frames:
        each.choose()
        scene.step(0)
        pictures.append(scene.view.picture().astype(int))
    measure(frames, rounds, budget_s, warm_up=1)
    return Measured(effect.name, *frames, float((np.abs(pictures[1] - pictures[0]).max(axis=2) > 1).mean()))

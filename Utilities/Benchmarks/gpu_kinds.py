# SPDX-License-Identifier: BSD-3-Clause
"""gpu_kinds: the kinds of frames of a scene: without water, with each water, and what a user could do.

All are drawn by one renderer, which has all waters: those whose turn it is not are invisible. The second
pass has a renderer of its own beside it, over the same props.
"""

import functools
from dataclasses import dataclass

import gpu_data
import gpu_scenes
import kinds
import water_test as wt
import wave_scenes
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer, vtkVolume
from vtkwater import vtkWaterActor

PLAIN, SECOND_PASS, COPIES = "no water", "second pass", "mirrored copies"
CALM, HALF, SINES, LAKE, OCEAN = "calm", "calm, half", "sines", "lake", "ocean"
OUT_OF_VIEW, HIDDEN, FACING_AWAY = "out of view", "hidden", "facing away"
UNSEEN = (OUT_OF_VIEW, HIDDEN, FACING_AWAY)
OTHER_PRESETS = ("pool", "clear tropical", "ocean wind 10", "ocean wind 15", "turbid river", "mirror floor")
MOVING, TIME = "moving", "time"
STEP_S = 0.04  # s of the water's time from frame to frame

TEXTS = {
    PLAIN: "the scene",
    SECOND_PASS: "first the scene from a mirrored camera, drawn by a renderer of its own, then the scene: "
                 "what any user could write. The first picture is not used",
    COPIES: "the scene, its mirror image as an actor, and a translucent plane between them",
    CALM: "calm water",
    HALF: "calm water, TextureScale 0.5",
    SINES: "three sines, ray traced",
    LAKE: 'the preset "lake"',
    OCEAN: 'the preset "ocean wind 5"',
    OUT_OF_VIEW: "water behind the eye",
    HIDDEN: "water inside a hill",
    FACING_AWAY: "water seen from its culled side",
    **{name: f'the preset "{name}"' for name in OTHER_PRESETS},
    **gpu_data.TEXTS,
}


@dataclass
class Kind:
    """A kind of frame: the renderers that draw it, the last one the picture; the water, what only it shows, and its
    data."""

    name: str
    scene: gpu_scenes.Scene
    renderers: list
    water: object = None
    props: tuple = ()
    data: gpu_data.Data = None

    def show(self, is_shown):
        for prop in (*self.props, *([self.water] if self.water else [])):
            prop.SetVisibility(is_shown)

    def stand(self, turn):
        """A place on the camera's path: the same for the same turn, whoever goes there."""
        for i, renderer in enumerate(self.renderers):
            side = -1 if i + 1 < len(self.renderers) else 1  # all but the last one are mirrored
            camera = renderer.GetActiveCamera()
            camera.SetViewUp(0, 0, side)
            x, y, z = self.scene.target
            camera.SetFocalPoint(x, y, side * z)
            x, y, z = self.scene.eye
            camera.SetPosition(x, y, side * z)
            camera.Azimuth(side * gpu_scenes.TURN * (turn % gpu_scenes.TURNS))
            camera.SetClippingRange(self.scene.range)

    def step(self, motion, turn):
        self.stand(turn if motion == MOVING else 0)
        if self.data and motion == gpu_data.STEPS:
            self.data.solve(turn + 1)
        elif self.water:
            self.water.SetTime(STEP_S * turn)

    def bring(self):
        """What a frame has to do before it is drawn, and is timed with it."""
        if self.data:
            self.data.show()


class Stage:
    """A scene in the window, and its kinds of frames as they are asked for."""

    def __init__(self, view, scene):
        self.view, self.window, self.scene = view, view.window, scene
        self.props = scene.make()
        self.renderer = self._renderer()
        self.mirrored = None  # that of the second pass
        self._kinds = {}

    def close(self):
        for renderer in filter(None, (self.renderer, self.mirrored)):
            self.window.RemoveRenderer(renderer)
        self._kinds.clear()

    def kind(self, name):
        if name not in self._kinds:
            self._kinds[name] = self._make(name)
        return self._kinds[name]

    def choose(self, name):
        """The next frames are of this kind."""
        chosen = self.kind(name)
        for kind in self._kinds.values():
            kind.show(kind is chosen)
        if self.mirrored:
            self.mirrored.SetDraw(self.mirrored in chosen.renderers)
        return chosen

    def _renderer(self):
        renderer = vtkRenderer()
        renderer.SetBackground(wave_scenes.SKY)
        for prop in self.props:
            renderer.AddVolume(prop) if isinstance(prop, vtkVolume) else renderer.AddActor(prop)
        camera = vtkCamera()
        camera.SetViewAngle(self.scene.angle)
        renderer.SetActiveCamera(camera)
        self.scene.prepare(renderer)
        self.window.AddRenderer(renderer)
        return renderer

    def _make(self, name):
        if name == PLAIN:
            return Kind(name, self.scene, [self.renderer])
        if name == SECOND_PASS:
            # first in the window: the picture is drawn last
            self.window.RemoveRenderer(self.renderer)
            self.mirrored = self._renderer()
            self.window.AddRenderer(self.renderer)
            return Kind(name, self.scene, [self.mirrored, self.renderer])
        if name == COPIES:
            return Kind(name, self.scene, [self.renderer], props=tuple(self._copies()))
        if name in gpu_data.KINDS:
            data = gpu_data.Data(name, self.scene.tide, self.renderer)
            return Kind(name, self.scene, [self.renderer], data.water, data.props, data)
        water = vtkWaterActor()
        water.SetSheetBounds(*gpu_scenes.SHEET)
        self.renderer.AddActor(water)
        _LOOKS[name](water)
        return Kind(name, self.scene, [self.renderer], water)

    def _copies(self):
        low_x, high_x, low_y, high_y = gpu_scenes.SHEET
        source = vtkPlaneSource()
        source.SetOrigin(low_x, low_y, 0)
        source.SetPoint1(high_x, low_y, 0)
        source.SetPoint2(low_x, high_y, 0)
        source.Update()
        sheet = gpu_scenes.actor_of(source.GetOutput(), (0.1, 0.3, 0.5))
        sheet.GetProperty().SetOpacity(0.5)
        copies = [*map(gpu_scenes.mirrored, self.props), sheet]
        for prop in copies:
            self.renderer.AddActor(prop)
        return copies


def _set_preset(name, water):
    water.GetWaterProperty().SetPreset(name)


def _face_away(water):
    water.SetPlane(wt.plane((0, 0, 0), (0, 0, -1)))
    water.GetProperty().BackfaceCullingOn()


_LOOKS = {
    CALM: lambda water: None,
    HALF: lambda water: water.GetReflectionPass().SetTextureScale(0.5),
    SINES: lambda water: kinds.set_waves(water, kinds.WAVES),
    LAKE: functools.partial(_set_preset, "lake"),
    OCEAN: functools.partial(_set_preset, "ocean wind 5"),
    OUT_OF_VIEW: lambda water: water.SetSheetBounds(*gpu_scenes.behind_the_eye()),
    HIDDEN: lambda water: water.SetSheetBounds(*gpu_scenes.inside_a_hill()),
    FACING_AWAY: _face_away,
    **{name: functools.partial(_set_preset, name) for name in OTHER_PRESETS},
}

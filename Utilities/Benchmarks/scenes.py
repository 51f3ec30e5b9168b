# SPDX-License-Identifier: BSD-3-Clause
"""scenes: what the benchmark draws. The water is at z = 0, its waves are the posts' (wave_scenes).

A scene is timed lit, in water as it comes, and its errors are taken unlit, in water that reflects
everything: that is what the tracer knows.
"""

from dataclasses import dataclass

import geometry
import numpy as np
import water_test as wt
import wave_scenes
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper, vtkActor

LEVEL = 384.0  # m over sea level; the lake of Examples/Python/lake.py
FLOOD_LEVEL = 396.0  # m
FLOOD = 0.3  # units that the flood moves up and down
FAR = 150.0
TURN = 0.05  # degrees that the camera goes around from frame to frame
TURNS = 30  # frames, then it goes there again


@dataclass(frozen=True)
class Kind:
    """What a scene is made of, and from where it is seen."""

    name: str
    text: str
    fill: object  # (scene) -> None: adds the props
    sheet: tuple
    eye: tuple
    target: tuple = (0, 0, 0)
    angle: float = 32
    has_tracer: bool = True
    is_flood: bool = False


class Scene:
    """A window of its own with a scene, and with water unless it is not wanted."""

    def __init__(self, kind, size, has_water=True, is_lit=True):
        self.kind, self.size, self._is_lit = kind, size, is_lit
        self.view = wt.View(size, wave_scenes.SKY)
        self.window, self.renderer = self.view.window, self.view.renderer
        self.water = None
        kind.fill(self)
        if has_water:
            self.water = self.add_water(kind.sheet)
        self.camera = self.renderer.GetActiveCamera()
        self.look(kind.eye, kind.target, kind.angle)

    def add(self, data, color=None):
        """An actor of one colour, or of the colours of its points."""
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(data)
        mapper.SetScalarVisibility(color is None)
        actor = vtkActor()
        actor.SetMapper(mapper)
        if color is not None:
            actor.GetProperty().SetColor(color)
        actor.GetProperty().SetLighting(self._is_lit)
        self.renderer.AddActor(actor)
        return actor

    def add_things(self, *arguments):
        return [self.add(*thing) for thing in geometry.things(*arguments)]

    def add_water(self, sheet):
        return wt.add_water(self.renderer, None, sheet, reflectance=None if self._is_lit else 1.0)

    def look(self, eye, target, angle):
        self._from = np.array(eye, dtype=float)
        self.camera.SetFocalPoint(target)
        self.camera.SetViewUp(0, 0, 1)
        self.camera.SetViewAngle(angle)
        self.stand(0)

    def stand(self, turn):
        """The place on the camera's path: the same for the same turn, whoever goes there."""
        self.camera.SetPosition(self._from)
        self.camera.Azimuth(TURN * (turn % TURNS))
        self.camera.SetClippingRange(0.25, FAR)

    def step(self, turn):
        """Everything new: the camera is elsewhere, the waves have moved on, the flood has risen."""
        self.stand(turn)
        self.pass_time(turn)
        if self.water and self.kind.is_flood:
            self.water.SetLevel(FLOOD * np.sin(0.3 * turn))

    def pass_time(self, turn):
        """Nothing but time."""
        if self.water:
            self.water.SetTime(0.04 * turn)


def make_terrain(tiles=1, level=LEVEL):
    def fill(scene):
        for tile in geometry.terrain(level, tiles):
            scene.add(tile)

    return fill


def _fill_plume(scene):
    geometry_of_plume(scene)
    scene.renderer.AddVolume(geometry.plume())


def geometry_of_plume(scene):
    """What stands around the plume."""
    for i in range(6):
        scene.add(
            wt.box((-6 + 2.4 * i, 7 - 0.8 * (i % 3), 0.5 + 0.2 * i), (0.8, 0.8, 2 + 0.5 * i)),
            (0.3 + 0.1 * i, 0.5, 0.7 - 0.1 * i),
        )


def make_props(count, size):
    return lambda scene: scene.add_things(count, (-14, -9, -0.3), (14, 26, 3.0), size)


TERRAIN_EYE, TERRAIN_TARGET = (45.0, 17.6, 2.5), (0, 0, 1.0)  # as Examples/Python/lake.py, higher
TERRAIN_SHEET = (-80, 80, -40, 140)
SMALL_SHEET, SMALL_EYE, SMALL_TARGET = (-60, 60, -60, 60), (2, -19, 5), (0, 0, 0.3)


def kinds(is_quick):
    """The scenes of the matrix by name."""
    count = 500_000 if is_quick else 5_000_000
    found = (
        Kind(
            "terrain",
            "the land of Examples/Data, one actor of 275,772 triangles",
            make_terrain(),
            TERRAIN_SHEET,
            TERRAIN_EYE,
            TERRAIN_TARGET,
        ),
        Kind(
            "1,000 props",
            "boxes, pyramids and balls, an actor each",
            make_props(1000, 0.5),
            SMALL_SHEET,
            SMALL_EYE,
            SMALL_TARGET,
        ),
        Kind(
            "10,000 props",
            "the same, ten times as many and smaller",
            make_props(10_000, 0.22),
            SMALL_SHEET,
            SMALL_EYE,
            SMALL_TARGET,
        ),
        Kind(
            "big mesh",
            f"hills, one actor of about {count:,} triangles",
            lambda scene: scene.add(geometry.big_mesh(count)),
            SMALL_SHEET,
            SMALL_EYE,
            SMALL_TARGET,
        ),
        Kind(
            "plume",
            f"a volume of {geometry.PLUME_SIZE}^3 voxels over the water and six boxes",
            _fill_plume,
            SMALL_SHEET,
            (2, -17, 4),
            (0, 0, 1.2),
            has_tracer=False,
        ),
        Kind(
            "flood",
            "the terrain, the water's level moving from frame to frame",
            make_terrain(level=FLOOD_LEVEL),
            TERRAIN_SHEET,
            TERRAIN_EYE,
            TERRAIN_TARGET,
            is_flood=True,
        ),
    )
    return {kind.name: kind for kind in found}

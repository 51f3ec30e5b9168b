# SPDX-License-Identifier: BSD-3-Clause
"""What only hidden water would reflect is left out: props and pieces of large meshes behind a wall
and beside it, at several texture scales; no picture changes, and no map of that kind is used again."""

import itertools
import os

import numpy as np
import skip_scenes
import water_test as wt
from vtkmodules.vtkRenderingCore import VTK_RESOLVE_OFF, VTK_RESOLVE_POLYGON_OFFSET, vtkMapper
from vtkwater import vtkWaterReflectionPass as Pass

SIZE = (400, 300)
LAKE = (-14, 14, -14, 14)
BOXES = 150


class Scene:
    def __init__(self, scale, skips):
        self.view = wt.View(SIZE)
        renderer = self.view.renderer
        hills = skip_scenes.terrain((-14, 5), (14, 20), lambda x, y: 1 + np.sin(x) * np.cos(y))
        wt.add_actor(renderer, hills, (0.6, 0.5, 0.3))
        wt.add_actor(renderer, wt.box((-4, -8, 4), (12, 0.2, 8)), (0.5, 0.5, 0.6))
        places = np.random.default_rng(5).uniform((-12, -4, 0.3), (12, 12, 4), (BOXES, 3))
        for number, place in enumerate(places):
            wt.add_actor(renderer, wt.box(place, (0.5, 0.5, 0.5)), (number / BOXES, 0.7, 1 - number / BOXES))
        self.water = wt.add_water(renderer, wt.plane((0, 0, 0), (0, 0, 1)), LAKE, 1.0)
        self.reflection = self.water.GetReflectionPass()
        self.reflection.SetSkips(skips)
        self.reflection.SetTextureScale(scale)
        self.reflection.InstrumentationOn()
        self.camera = wt.place_camera(renderer, (0, -14, 4), (0, 0, 0), (0.5, 80))

    def pictures(self, turn=3):
        for _ in range(4):
            self.camera.Azimuth(turn)
            self.camera.Roll(2 * turn)  # or a mistaken side would not show
            yield self.view.picture()

    def drawn(self):
        return (self.reflection.GetNumberOfPropsReflected(), self.reflection.GetNumberOfTrianglesReflected(),
                self.reflection.GetNumberOfFragmentsReflected())


for is_software, scale in itertools.product((1, 0), (1.0, 0.5, 0.3, 2.0)):
    os.environ["VTK_WATER_SOFTWARE"] = str(is_software)
    title = f"{'software' if is_software else 'GPU'}, scale {scale:g}"
    full = list(Scene(scale, Pass.SKIP_NONE).pictures())
    cases = {"all": Pass.SKIP_ALL, "no PIXELS": Pass.SKIP_ALL & ~Pass.PIXELS, "no PROPS": Pass.SKIP_ALL & ~Pass.PROPS}
    drawn = {}
    for name, skips in cases.items():
        scene = Scene(scale, skips)
        errors = [int(np.abs(one - other).max()) for one, other in zip(scene.pictures(), full)]
        drawn[name] = scene.drawn()
        wt.check_equal(f"{title}, {name}: decision", wt.decision_of(scene.water), "RENDERED")
        wt.check_at_most(f"{title}, {name}: largest error", max(errors), 1)
    wt.check_at_most(f"{title}: props, of those drawn without PIXELS", drawn["all"][0] / drawn["no PIXELS"][0], 0.8)
    wt.check_at_most(f"{title}: triangles, of those drawn without PIXELS", drawn["all"][1] / drawn["no PIXELS"][1], 0.8)
    wt.check_at_most(f"{title}: fragments, of those drawn without PIXELS", drawn["all"][2] / drawn["no PIXELS"][2], 0.45)
    wt.check_equal(f"{title}: props drawn without PROPS", drawn["no PROPS"][0], BOXES + 2)

os.environ.pop("VTK_WATER_SOFTWARE")

# Water that is drawn nearer than it is, by an offset against coincident surfaces or by the user's own
# shader, is seen before things that are in front of it.
PULL = "//VTK::PositionVC::Impl\n  gl_Position.z -= 0.02 * gl_Position.w;\n"


def add_offset(water):
    water.GetMapper().SetRelativeCoincidentTopologyPolygonOffsetParameters(-1, -1)


def add_shader(water):
    water.GetShaderProperty().AddVertexShaderReplacement("//VTK::PositionVC::Impl", True, PULL, False)


def pulled_pictures(skips, pull):
    scene = Scene(1.0, skips)
    wt.add_actor(scene.view.renderer, skip_scenes.terrain((-14, -14), (14, 14), lambda x, y: 0.05 * np.sin(x) * np.cos(y)),
                 (0.4, 0.7, 0.2))
    pull(scene.water)
    return list(scene.pictures())


for pull, resolution in ((add_offset, VTK_RESOLVE_POLYGON_OFFSET), (add_shader, VTK_RESOLVE_OFF)):
    vtkMapper.SetResolveCoincidentTopology(resolution)
    pairs = zip(pulled_pictures(Pass.SKIP_ALL, pull), pulled_pictures(Pass.SKIP_NONE, pull))
    error = max(int(np.abs(one - other).max()) for one, other in pairs)
    wt.check_at_most(f"{pull.__name__} to the water: largest error", error, 1)
vtkMapper.SetResolveCoincidentTopologyToDefault()

# A view that stands still has a whole map in its second frame, and uses it from then on, also when
# what hid a part of the water is gone.
scene = Scene(1.0, Pass.SKIP_ALL)
list(scene.pictures())
decisions = []
for _ in range(3):
    scene.view.picture()
    decisions.append(wt.decision_of(scene.water))
wt.check_equal("standing still: decisions", decisions, ["RENDERED", "REUSED", "REUSED"])
wt.finish()

# SPDX-License-Identifier: BSD-3-Clause
"""What only hidden water would reflect is left out: props and clusters of large meshes behind a wall
and beside it, at several texture scales; no picture changes, and no reflection texture of that kind is used again."""

import numpy as np
import pytest
import skip_scenes
import water_test as wt
from vtkmodules.vtkRenderingCore import VTK_RESOLVE_OFF, VTK_RESOLVE_POLYGON_OFFSET, vtkMapper
from vtkwater import vtkWaterReflectionPass as Pass

pytestmark = pytest.mark.usefixtures("in_software")  # a GPU draws sooner than it tells what is seen

SIZE = (400, 300)
LAKE = (-14, 14, -14, 14)
BOXES = 150
CASES = {"all": Pass.SKIP_ALL, "no PIXELS": Pass.SKIP_ALL & ~Pass.PIXELS, "no PROPS": Pass.SKIP_ALL & ~Pass.PROPS}
PULL = "//VTK::PositionVC::Impl\n  gl_Position.z -= 0.02 * gl_Position.w;\n"  # of a vertex shader


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


@pytest.mark.parametrize("scale", [1.0, 0.5, 0.3, 2.0], ids="scale_{:g}".format)
def test_what_only_hidden_water_would_reflect_is_left_out(scale):
    """Props, triangles and fragments that only hidden water would reflect are left out, and no picture changes."""
    title = f"scale {scale:g}"
    full = list(Scene(scale, Pass.SKIP_NONE).pictures())
    drawn = {}
    for name, skips in CASES.items():
        scene = Scene(scale, skips)
        errors = [int(np.abs(one - other).max()) for one, other in zip(scene.pictures(), full)]
        drawn[name] = scene.drawn()
        wt.check_equal(f"{title}, {name}: decision", wt.decision_of(scene.water), "RENDERED")
        wt.check_at_most(f"{title}, {name}: largest error", max(errors), 1)
    for number, (what, share) in enumerate((("props", 0.8), ("triangles", 0.8), ("fragments", 0.45))):
        wt.check_at_most(f"{title}: {what}, of those drawn without PIXELS",
                         drawn["all"][number] / drawn["no PIXELS"][number], share)
    wt.check_equal(f"{title}: props drawn without PROPS", drawn["no PROPS"][0], BOXES + 2)


def add_offset(water):
    water.GetMapper().SetRelativeCoincidentTopologyPolygonOffsetParameters(-1, -1)


def add_shader(water):
    water.GetShaderProperty().AddVertexShaderReplacement("//VTK::PositionVC::Impl", True, PULL, False)


def pulled_pictures(skips, pull):
    scene = Scene(1.0, skips)
    wt.add_actor(scene.view.renderer,
                 skip_scenes.terrain((-14, -14), (14, 14), lambda x, y: 0.05 * np.sin(x) * np.cos(y)), (0.4, 0.7, 0.2))
    pull(scene.water)
    return list(scene.pictures())


@pytest.fixture
def coincident_topology():
    """Sets how VTK resolves coincident topology, and sets it back after the test."""
    yield vtkMapper.SetResolveCoincidentTopology
    vtkMapper.SetResolveCoincidentTopologyToDefault()


@pytest.mark.parametrize("pull, resolution", [(add_offset, VTK_RESOLVE_POLYGON_OFFSET), (add_shader, VTK_RESOLVE_OFF)],
                         ids=["add_offset", "add_shader"])
def test_water_that_is_drawn_nearer_is_not_taken_for_hidden(pull, resolution, coincident_topology):
    """Water that is drawn nearer than it is, and so before things in front of it, looks the same with skips."""
    # By an offset against coincident surfaces, or by the user's own shader.
    coincident_topology(resolution)
    pairs = zip(pulled_pictures(Pass.SKIP_ALL, pull), pulled_pictures(Pass.SKIP_NONE, pull))
    error = max(int(np.abs(one - other).max()) for one, other in pairs)
    wt.check_at_most(f"{pull.__name__} to the water: largest error", error, 1)


def test_a_view_that_stands_still_uses_a_whole_map():
    """A view that stands still has a whole reflection texture in its second frame, and uses it from then on."""
    # That is right also when what hid a part of the water is gone.
    scene = Scene(1.0, Pass.SKIP_ALL)
    list(scene.pictures())
    decisions = []
    for _ in range(3):
        scene.view.picture()
        decisions.append(wt.decision_of(scene.water))
    wt.check_equal("standing still: decisions", decisions, ["RENDERED", "REUSED", "REUSED"])

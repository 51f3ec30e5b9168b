# SPDX-License-Identifier: BSD-3-Clause
"""Textures of water may come, change and go at any time, even while the water is drawn."""

import gc

import pytest
import water_test as wt
from vtkmodules.vtkRenderingCore import vtkRendererSource, vtkTexture
from vtkwater import vtkWaterActor


def checker_texture():
    texture = vtkTexture()
    texture.SetInputData(wt.checker())
    return texture


def scene():
    """Clear water, which reflects its environment, over a bed, with a pole that stands in it."""
    made = wt.View((200, 150), (0.5, 0.7, 0.9))
    water = wt.add_water(made.renderer, None, (-40, 40, -40, 40), None)
    water.GetWaterProperty().RefractionOn()
    water.GetWaterProperty().SetAbsorption(0.3, 0.1, 0.05)
    water.GetWaterProperty().SetScattering(0, 0, 0)
    water.GetWaterProperty().SetReflectionSourceToEnvironment()
    wt.add_actor(made.renderer, wt.box((0, 0, -3), (40, 40, 1)), (0.8, 0.7, 0.5), lit=False)
    wt.add_actor(made.renderer, wt.box((0, 0, -0.5), (1, 1, 4)), (0.9, 0.2, 0.1), lit=False)
    wt.place_camera(made.renderer, (3, -8, 4), (0, 0, 0), (0.1, 200))
    return made, water


@pytest.mark.parametrize("name, drop", (
    ("property", lambda water: water.SetWaterProperty(None)),
    ("environment", lambda water: water.GetWaterProperty().SetEnvironmentTexture(None)),
    ("normal maps", lambda water: water.GetWaterProperty().RemoveAllNormalMaps()),
), ids=("property", "environment", "normal_maps"))
def test_an_observer_may_drop_what_is_being_drawn(name, drop):
    """Observers may take away what is being drawn: there is no error, the frame shows what it began with, and the
    next one shows what was done."""
    made, water = scene()
    water.GetWaterProperty().SetEnvironmentTexture(checker_texture())
    water.GetWaterProperty().AddNormalMap(None, 2.0)
    before = made.picture()
    heard = []

    def observe(caller, event):
        heard.append(event)
        drop(water)

    for event in ("StartEvent", "UpdateShaderEvent"):
        water.GetMapper().AddObserver(event, observe)
    wt.check_equal(f"an observer drops the {name}: difference in that frame",
                   wt.difference(made.picture(), before), 0)
    wt.check_at_least(f"an observer drops the {name}: difference in the next frame",
                      wt.difference(made.picture(), before), 10)
    made.picture()
    wt.check_equal(f"an observer drops the {name}: when", sorted(set(heard)), ["StartEvent", "UpdateShaderEvent"])
    wt.check_equal(f"an observer drops the {name}: it is drawn", bool(water.GetLastError()), False)


def test_an_environment_that_loses_its_picture_leaves_the_background():
    """An environment is reflected; one whose picture is taken away leaves what is seen without one."""
    made, water = scene()
    background = made.picture()
    environment = checker_texture()
    water.GetWaterProperty().SetEnvironmentTexture(environment)
    wt.check_at_least("environment: it is reflected", wt.difference(made.picture(), background), 10)
    environment.RemoveAllInputConnections(0)
    wt.check_equal("environment without a picture: difference from the background",
                   wt.difference(made.picture(), background), 0)


def test_a_change_of_a_texture_is_a_change_of_the_water():
    """Water is modified when one of its textures is."""
    water = vtkWaterActor()
    texture = checker_texture()
    water.GetWaterProperty().SetEnvironmentTexture(texture)
    before = water.GetMTime()
    texture.Modified()
    wt.check_equal("a texture's change is the water's", water.GetMTime() > before, True)


def test_what_is_taken_away_is_let_go():
    """Between frames a water keeps nothing that the user has taken away from it."""
    made, water = scene()
    look = water.GetWaterProperty()
    gone = []
    for name, give in (("environment", look.SetEnvironmentTexture),
                       ("normal map", lambda given: look.AddNormalMap(given, 2.0))):
        texture = checker_texture()
        texture.AddObserver("DeleteEvent", lambda caller, event, name=name: gone.append(name))
        give(texture)
    del texture
    made.picture()
    look.SetEnvironmentTexture(None)
    look.RemoveAllNormalMaps()
    gc.collect()
    wt.check_equal("taken away: textures that are gone", gone, ["environment", "normal map"])
    look.AddObserver("DeleteEvent", lambda caller, event: gone.append("property"))
    water.SetWaterProperty(None)
    del look
    gc.collect()
    wt.check_equal("taken away: and the property", gone[2:], ["property"])


def test_a_water_that_reflected_its_own_renderer_can_go():
    """An environment that is the renderer's own picture is a ring of references; once it is taken away, all can go."""
    made, water = scene()
    source = vtkRendererSource()
    source.SetInput(made.renderer)
    source.WholeWindowOff()
    made.picture()
    texture = vtkTexture()
    texture.SetInputConnection(source.GetOutputPort())
    source.Update()
    water.GetWaterProperty().SetEnvironmentTexture(texture)
    made.picture()
    water.GetWaterProperty().SetEnvironmentTexture(None)
    gone = []
    for name, thing in (("water", water), ("renderer", made.renderer), ("texture", texture)):
        thing.AddObserver("DeleteEvent", lambda caller, event, name=name: gone.append(name))
    made.window.RemoveRenderer(made.renderer)
    made.window.Finalize()
    del water, source, texture, thing, made
    gc.collect()
    wt.check_equal("ring of references: what is gone", sorted(gone), ["renderer", "texture", "water"])

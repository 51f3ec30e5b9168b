# SPDX-License-Identifier: BSD-3-Clause
"""The colour of vtkActor's own property is the water's own colour, as of any actor, unless the look has a colour that
was set."""

import pytest
import water_test as wt
from vtkmodules.vtkRenderingCore import vtkProperty
from vtkwater import vtkWaterActor, vtkWaterProperty

RED, BLUE = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)
DARK = (0.02, 0.09, 0.13)
MEDIUM = None  # no colour is set: that of the water's medium, in the light there is


def make():
    """Water that reflects next to nothing, from above."""
    view = wt.View((80, 60), background=(0.5, 0.5, 0.5))
    water = wt.add_water(view.renderer, sheet=(-4, 4, -4, 4), reflectance=None)
    wt.place_camera(view.renderer, (0, -1, 8), (0, 0, 0), (0.5, 20))
    return view, water


def picture_of_color(color):
    """With this colour of the look itself."""
    view, water = make()
    if color is not MEDIUM:
        water.GetWaterProperty().SetDeepColor(color)
    return view.picture()


def check(name, change, color):
    view, water = make()
    change(water)
    wt.check_equal(f"{name}: difference to water of the colour {color}",
                   wt.difference(view.picture(), picture_of_color(color)), 0)


def given_in_a_property(water):
    own = vtkProperty()
    own.SetColor(RED)
    water.SetProperty(own)


def by_a_look_that_was_set(water):
    water.GetProperty().SetColor(RED)
    water.GetWaterProperty().SetDeepColor(BLUE)


def by_a_look_that_was_set_to_what_it_was(water):
    water.GetProperty().SetColor(RED)
    water.GetWaterProperty().SetDeepColor(water.GetWaterProperty().GetDeepColor())


def by_a_preset_after_the_look(water):
    water.GetWaterProperty().SetDeepColor(BLUE)
    water.GetWaterProperty().SetPreset("lake")
    water.GetWaterProperty().SeaOff()
    water.GetWaterProperty().RefractionOff()
    water.GetProperty().SetColor(RED)


def by_a_type_after_the_look(water):
    water.GetWaterProperty().SetDeepColor(BLUE)
    water.GetWaterProperty().SetWaterType("II")
    water.GetProperty().SetColor(RED)


def refused_by_the_look(water):
    water.GetProperty().SetColor(RED)
    water.GetWaterProperty().AddObserver("ErrorEvent", lambda *_: None)
    water.GetWaterProperty().SetDeepColor(2.0, 0.0, 0.0)


def by_a_copy_of_the_look(water):
    water.GetProperty().SetColor(RED)
    other = vtkWaterProperty()
    other.SetDeepColor(DARK)
    water.GetWaterProperty().DeepCopy(other)


CASES = {
    "of SetColor": (lambda water: water.GetProperty().SetColor(RED), RED),
    "of SetDiffuseColor": (lambda water: water.GetProperty().SetDiffuseColor(RED), RED),
    "of SetProperty": (given_in_a_property, RED),
    "not of white, which VTK begins with": (lambda water: water.GetProperty().SetColor(1, 1, 1), MEDIUM),
    "not of the colour of highlights": (lambda water: water.GetProperty().SetSpecularColor(RED), MEDIUM),
    "of the look that was set": (by_a_look_that_was_set, BLUE),
    "of the look that was set to what it was": (by_a_look_that_was_set_to_what_it_was, vtkWaterProperty().GetDeepColor()),
    "of the actor after a preset": (by_a_preset_after_the_look, RED),
    "of the actor after a water type": (by_a_type_after_the_look, RED),
    "of the actor when the look refuses one": (refused_by_the_look, RED),
    "of the look whose copy was set": (by_a_copy_of_the_look, DARK),
}


@pytest.mark.parametrize("name", CASES, ids=lambda name: name.replace(" ", "_"))
def test_the_color_is(name):
    """The water's own colour is that of the look if that was set, else that of the actor unless it is white."""
    check(name, *CASES[name])


def test_the_colors_differ():
    """The colours that are compared here are told apart by the pictures."""
    for one, other in ((RED, BLUE), (RED, MEDIUM), (BLUE, MEDIUM), (RED, DARK)):
        wt.check_at_least(f"{one} and {other}", wt.difference(picture_of_color(one), picture_of_color(other)), 100)


def test_a_color_that_is_set_between_frames_is_seen():
    """A colour that the actor gets after a frame is in the next one."""
    view, water = make()
    view.picture()
    water.GetProperty().SetColor(RED)
    wt.check_equal("difference", wt.difference(view.picture(), picture_of_color(RED)), 0)
    water.GetWaterProperty().SetDeepColor(DARK)
    wt.check_equal("difference, the look's again", wt.difference(view.picture(), picture_of_color(DARK)), 0)


def test_opacity_multiplies():
    """The opacity of the actor's own property multiplies the look's."""
    pictures = []
    for of_actor, of_look in ((0.5, 0.8), (1.0, 0.4)):
        view, water = make()
        water.GetProperty().SetOpacity(of_actor)
        water.GetWaterProperty().SetOpacity(of_look)
        pictures.append(view.picture())
    wt.check_at_most("difference", wt.difference(*pictures), 1)


def test_clear_water_without_an_end_has_the_color():
    """With refraction the colour is that of water without an end."""
    pictures = []
    for set_color in (lambda water: water.GetProperty().SetColor(RED),
                      lambda water: water.GetWaterProperty().SetDeepColor(RED)):
        view, water = make()
        wt.add_actor(view.renderer, wt.box((0, 0, -2), (9, 9, 0.1)), (0.8, 0.8, 0.8))
        water.GetWaterProperty().RefractionOn()
        water.GetWaterProperty().SetAbsorption(0.5, 0.5, 0.5)
        set_color(water)
        pictures.append(view.picture())
    wt.check_equal("difference", wt.difference(*pictures), 0)
    wt.check_at_least("red, less green, in the middle", int(pictures[0][30, 40, 0] - pictures[0][30, 40, 1]), 30)


def test_a_copy_of_the_actor_has_the_color():
    """ShallowCopy takes the actor's own property along, and so its colour."""
    view, water = make()
    water.GetProperty().SetColor(RED)
    copy = vtkWaterActor()
    copy.ShallowCopy(water)
    view.renderer.RemoveActor(water)
    view.renderer.AddActor(copy)
    wt.check_equal("difference", wt.difference(view.picture(), picture_of_color(RED)), 0)


def test_a_color_that_is_set_to_what_it_was_is_a_change_once():
    """A colour that is set to the value it has is a change the first time: it wins from then on."""
    look = vtkWaterProperty()
    times = [look.GetMTime()]
    for _ in range(2):
        look.SetDeepColor(look.GetDeepColor())
        times.append(look.GetMTime())
    wt.check_equal("later the first time, and the second", (times[1] > times[0], times[2] > times[1]), (True, False))

# SPDX-License-Identifier: BSD-3-Clause
"""Sheets of one plane share one mirrored view, if it would be the same for all of them, and each of them
looks as if it had its own."""

import pytest
import water_test as wt
from vtkwater import vtkWaterProperty
from vtkwater import vtkWaterReflectionPass as Pass

SIZE = (200, 150)
SHEETS = ((-6, -2, -6, 6), (-2, 2, -6, 6), (2.5, 6, -6, 6))
ONE = ["RENDERED", "SHARED", "SHARED"]
NONE = ["RENDERED"] * 3
LAST_ALONE = ["RENDERED", "SHARED", "RENDERED"]


class Scene:
    def __init__(self, skips=Pass.SKIP_ALL, samples=0, clear=False):
        self.view = wt.View(SIZE, samples=samples)
        self.renderer = self.view.renderer
        self.renderer.GradientBackgroundOn()
        self.renderer.SetBackground2(0.9, 0.6, 0.4)
        wt.add_actor(self.renderer, wt.box((0, 0, -2), (20, 20, 0.5)), (0.7, 0.6, 0.4))
        self.thing = wt.add_actor(self.renderer, wt.pyramid((0, 0, 1), 2, radius=2), (1, 0.6, 0.2))
        wt.add_actor(self.renderer, wt.box((3, 2, 0.8), (1, 1, 3)), (0.3, 0.7, 0.4))
        self.waters = [wt.add_water(self.renderer, wt.plane((0, 0, 0), (0, 0, 1)), sheet, 0.9) for sheet in SHEETS]
        for water in self.waters:
            water.GetReflectionPass().SetSkips(skips)
            water.GetWaterProperty().SetRefraction(clear)
        self.camera = self.renderer.GetActiveCamera()
        self.camera.SetPosition(1, -14, 5)
        self.camera.SetViewUp(0, 0, 1)
        self.camera.SetViewAngle(45)
        self.camera.SetClippingRange(0.5, 60)

    def reflections(self):
        return [water.GetReflectionPass() for water in self.waters]

    def renders(self):
        return sum(reflection.GetNumberOfReflectionRenders() for reflection in self.reflections())


def compare(name, prepare, expected, frames=3, **settings):
    """The decisions and the pictures, while the thing moves."""
    shared, alone = (Scene(skips, **settings) for skips in (Pass.SKIP_ALL, Pass.SKIP_NONE))
    errors = []
    for scene in (shared, alone):
        prepare(scene)
    for frame in range(frames):
        pictures = [scene.view.picture() for scene in (shared, alone)]
        errors.append(wt.difference(*pictures))
        for scene in (shared, alone):
            scene.thing.AddPosition(0.1, 0.1, 0)
    wt.check_equal(f"{name}: decisions", [wt.decision_of(water) for water in shared.waters], expected)
    wt.check_equal(f"{name}: mirrored views a frame", shared.renders() / frames, expected.count("RENDERED"))
    wt.check_at_most(f"{name}: largest error", max(errors), 0)
    return shared


def same_property(scene):
    look = vtkWaterProperty()
    look.AddWave(0.05, 2, 20)
    for water in scene.waters:
        water.SetWaterProperty(look)


def waves_from_elsewhere(scene):
    same_property(scene)
    scene.waters[2].GetPlane().SetOrigin(0.7, 0.3, 0)


def look(scene):
    return scene.waters[2].GetWaterProperty()


def first_look(scene):
    return scene.waters[0].GetWaterProperty()


def from_below(scene):
    scene.camera.SetPosition(1, -5.5, -1)
    scene.camera.SetFocalPoint(0, 0, -0.4)


def other_index(scene):
    for water, index in zip(scene.waters, (1.0, 1.33, 1.9)):
        water.GetWaterProperty().SetReflectanceModeToFresnel()
        water.GetWaterProperty().SetIndexOfRefraction(index)


def faint_first(scene):
    other_index(scene)
    scene.waters[1].GetWaterProperty().SetReflectanceModeToConstant()
    scene.camera.SetPosition(0, 0, 16)
    scene.camera.SetViewUp(0, 1, 0)


@pytest.mark.parametrize("samples", (0, 8))
def test_sheets_of_one_plane_share_one_view(samples):
    """Three sheets of one plane have one mirrored view, with and without multisampling."""
    compare(f"three sheets, {samples} samples", lambda scene: None, ONE, samples=samples)


def test_sheets_seen_from_below_share_one_view():
    """From under the water the sheets share a view, too."""
    compare("seen from below", from_below, ONE)


def test_clear_sheets_share_one_view():
    """Sheets that are seen through share the view that they reflect."""
    compare("clear", lambda scene: None, ONE, clear=True)


def test_clear_sheets_seen_from_below_share_none():
    """From under the water, sheets that are seen through have a view each."""
    compare("clear, seen from below", from_below, NONE, clear=True)


def test_waves_of_one_property_share_one_view():
    """Sheets whose waves are those of one property share a view."""
    compare("waves of one property", same_property, ONE)


LOOKS = {
    "other colour": lambda scene: look(scene).SetDeepColor(0.4, 0.1, 0.1),
    "other reflectance": lambda scene: look(scene).SetReflectance(0.4),
    "the first reflects nothing": lambda scene: first_look(scene).SetReflectance(0),
    "Fresnel's law for one": lambda scene: look(scene).SetReflectanceModeToFresnel(),
    "Fresnel's law for the first": lambda scene: first_look(scene).SetReflectanceModeToFresnel(),
    "other indices": other_index,
    "the first is faint": faint_first,
}


@pytest.mark.parametrize("name", LOOKS)
def test_each_has_a_look_of_its_own(name):
    """Sheets that differ in their look alone share a view, and each still looks as it should."""
    compare(name, LOOKS[name], ONE)


VIEWS = {
    "other level": lambda scene: scene.waters[2].SetLevel(0.1),
    "tilted": lambda scene: scene.waters[2].GetPlane().SetNormal(0, 0.05, 1),
    "turned over": lambda scene: scene.waters[2].GetPlane().SetNormal(0, 0, -1),
    "other texture scale": lambda scene: scene.reflections()[2].SetTextureScale(0.5),
    "other samples": lambda scene: scene.reflections()[2].SetMultiSamples(4),
    "other colour precision": lambda scene: scene.reflections()[2].SetColorPrecision(Pass.HALF_FLOAT),
    "other clip margin": lambda scene: scene.reflections()[2].SetClipMargin(0.2),
    "other guard band": lambda scene: scene.reflections()[2].SetGuardBand(1.5),
    "waves on one": lambda scene: look(scene).AddWave(0.05, 2, 20),
    "waves that count from elsewhere": waves_from_elsewhere,
    "one is translucent": lambda scene: look(scene).SetOpacity(0.5),
    "a smallest prop": lambda scene: scene.reflections()[2].SetMinimumPropSize(0.001),
}


@pytest.mark.parametrize("name", VIEWS)
def test_another_view_is_not_shared(name):
    """A sheet whose mirrored view would be another one has it to itself."""
    compare(name, VIEWS[name], LAST_ALONE)


def test_environment_of_one_needs_no_view():
    """A sheet that reflects its environment takes no part; the others still share."""
    compare("environment on one", lambda scene: look(scene).SetReflectionSourceToEnvironment(),
            ["RENDERED", "SHARED", "STATIC_ENVIRONMENT"])


def test_no_view_is_shared_when_that_is_switched_off():
    """Without SHARED_VIEWS each sheet has a view of its own."""
    scene = Scene(Pass.SKIP_ALL & ~Pass.SHARED_VIEWS)
    scene.view.picture()
    wt.check_equal("without SHARED_VIEWS: mirrored views", scene.renders(), 3)


def without_the_first():
    """A scene whose first sheet, which had the view, is gone after some frames, and one that shares nothing."""
    shared = compare("before", lambda scene: None, ONE)
    shared.renderer.RemoveActor(shared.waters[0])
    shared.view.picture()
    alone = Scene(Pass.SKIP_NONE)
    alone.renderer.RemoveActor(alone.waters[0])
    alone.thing.SetPosition(shared.thing.GetPosition())
    return shared, alone


def test_the_next_sheet_takes_over_from_one_that_is_removed():
    """When the sheet that has the view is removed, the next one has it."""
    shared, alone = without_the_first()
    wt.check_equal("the first is removed: decisions", [wt.decision_of(water) for water in shared.waters[1:]],
                   ["RENDERED", "SHARED"])
    wt.check_equal("the first is removed: largest error",
                   wt.difference(shared.view.picture(), alone.view.picture()), 0)


def test_the_next_sheet_takes_over_from_one_that_is_invisible():
    """When the sheet that has the view turns invisible, the next one has it."""
    shared, alone = without_the_first()
    for scene in (shared, alone):
        scene.view.picture()
        scene.waters[1].VisibilityOff()
    wt.check_equal("the second is invisible: largest error",
                   wt.difference(shared.view.picture(), alone.view.picture()), 0)
    wt.check_equal("the second is invisible: decision", wt.decision_of(shared.waters[2]), "RENDERED")

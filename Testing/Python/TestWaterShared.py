# SPDX-License-Identifier: BSD-3-Clause
"""Sheets of one plane share one mirrored view, if it would be the same for all of them, and each of them
looks as if it had its own."""

import numpy as np
import water_test as wt
from vtkwater import vtkWaterProperty
from vtkwater import vtkWaterReflectionPass as Pass

SIZE = (200, 150)
SHEETS = ((-6, -2, -6, 6), (-2, 2, -6, 6), (2.5, 6, -6, 6))


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
        errors.append(int(np.abs(pictures[0] - pictures[1]).max()))
        for scene in (shared, alone):
            scene.thing.AddPosition(0.1, 0.1, 0)
    wt.check_equal(f"{name}: decisions", [wt.decision_of(water) for water in shared.waters], expected)
    wt.check_equal(f"{name}: mirrored views a frame", shared.renders() / frames, expected.count("RENDERED"))
    wt.check_at_most(f"{name}: largest error", max(errors), 0)
    return shared, pictures[0]


ONE = ["RENDERED", "SHARED", "SHARED"]
NONE = ["RENDERED"] * 3
LAST_ALONE = ["RENDERED", "SHARED", "RENDERED"]


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


def from_below(scene):
    scene.camera.SetPosition(1, -5.5, -1)
    scene.camera.SetFocalPoint(0, 0, -0.4)


for samples in (0, 8):
    compare(f"three sheets, {samples} samples", lambda s: None, ONE, samples=samples)
compare("seen from below", from_below, ONE)
compare("clear", lambda s: None, ONE, clear=True)
compare("clear, seen from below", from_below, NONE, clear=True)
compare("waves of one property", same_property, ONE)
# each has a look of its own all the same
compare("other colour", lambda s: look(s).SetDeepColor(0.4, 0.1, 0.1), ONE)
compare("other reflectance", lambda s: look(s).SetReflectance(0.4), ONE)
compare("the first reflects nothing", lambda s: s.waters[0].GetWaterProperty().SetReflectance(0), ONE)
compare("Fresnel's law for one", lambda s: look(s).SetReflectanceModeToFresnel(), ONE)
compare("Fresnel's law for the first", lambda s: s.waters[0].GetWaterProperty().SetReflectanceModeToFresnel(), ONE)


def other_index(scene):
    for water, index in zip(scene.waters, (1.0, 1.33, 1.9)):
        water.GetWaterProperty().SetReflectanceModeToFresnel()
        water.GetWaterProperty().SetIndexOfRefraction(index)


compare("other indices", other_index, ONE)


def faint_first(scene):
    other_index(scene)
    scene.waters[1].GetWaterProperty().SetReflectanceModeToConstant()
    scene.camera.SetPosition(0, 0, 16)
    scene.camera.SetViewUp(0, 1, 0)


compare("the first is faint", faint_first, ONE)

# What would be another view is not shared.
compare("other level", lambda s: s.waters[2].SetLevel(0.1), LAST_ALONE)
compare("tilted", lambda s: s.waters[2].GetPlane().SetNormal(0, 0.05, 1), LAST_ALONE)
compare("turned over", lambda s: s.waters[2].GetPlane().SetNormal(0, 0, -1), LAST_ALONE)
compare("other texture scale", lambda s: s.reflections()[2].SetTextureScale(0.5), LAST_ALONE)
compare("other samples", lambda s: s.reflections()[2].SetMultiSamples(4), LAST_ALONE)
compare("other colour precision", lambda s: s.reflections()[2].SetColorPrecision(Pass.HALF_FLOAT), LAST_ALONE)
compare("other clip margin", lambda s: s.reflections()[2].SetClipMargin(0.2), LAST_ALONE)
compare("other guard band", lambda s: s.reflections()[2].SetGuardBand(1.5), LAST_ALONE)
compare("waves on one", lambda s: look(s).AddWave(0.05, 2, 20), LAST_ALONE)
compare("waves that count from elsewhere", waves_from_elsewhere, LAST_ALONE)
compare("one is translucent", lambda s: look(s).SetOpacity(0.5), LAST_ALONE)
compare("environment on one", lambda s: look(s).SetReflectionSourceToEnvironment(),
        ["RENDERED", "SHARED", "STATIC_ENVIRONMENT"])
compare("a smallest prop", lambda s: s.reflections()[2].SetMinimumPropSize(0.001), LAST_ALONE)

# Forced off; or for one of them.
scene = Scene(Pass.SKIP_ALL & ~Pass.SHARED_VIEWS)
scene.view.picture()
wt.check_equal("without SHARED_VIEWS: mirrored views", scene.renders(), 3)

# The one that has the view is taken away.
scene, picture = compare("before", lambda s: None, ONE)
renders = scene.renders()
scene.renderer.RemoveActor(scene.waters[0])
scene.view.picture()
rest = scene.waters[1:]
wt.check_equal("the first is removed: decisions", [wt.decision_of(water) for water in rest], ["RENDERED", "SHARED"])
alone = Scene(Pass.SKIP_NONE)
alone.renderer.RemoveActor(alone.waters[0])
alone.thing.SetPosition(scene.thing.GetPosition())
wt.check_equal("the first is removed: largest error",
               int(np.abs(scene.view.picture() - alone.view.picture()).max()), 0)
scene.waters[1].VisibilityOff()
alone.waters[1].VisibilityOff()
wt.check_equal("the second is invisible: largest error",
               int(np.abs(scene.view.picture() - alone.view.picture()).max()), 0)
wt.check_equal("the second is invisible: decision", wt.decision_of(scene.waters[2]), "RENDERED")
wt.finish()

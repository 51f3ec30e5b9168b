# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong is said once, by an ErrorEvent that names it; the water turns plain, the rest stays.

Each case is rendered three times: one error, however many frames. Then the cause is removed and the
next frame is right again. Props with NaN bounds: TestWaterBadBounds.cxx.
"""

import math

import numpy as np
import water_test as wt
from vtkmodules.vtkCommonDataModel import vtkPlane

NAN, INFINITY = float("nan"), float("inf")
DEEP = (0.0, 0.2, 0.6)


class Scene:
    def __init__(self):
        self.view = wt.View((320, 240), background=(0.5, 0.7, 0.9))
        for data, color in wt.columns_and_pyramids():
            wt.add_actor(self.view.renderer, data, color)
        self.water = wt.add_water(self.view.renderer, None, (-9, 9, -6, 9))
        self.water.GetWaterProperty().SetDeepColor(DEEP)
        self.camera = self.view.renderer.GetActiveCamera()
        self.place_camera()
        self.errors = []
        self.water.AddObserver("ErrorEvent", lambda caller, event: self.errors.append(caller.GetLastError()))

    def place_camera(self, height=4):
        self.camera.SetPosition(2, -13, height)
        self.camera.SetFocalPoint(0, 0, 0)
        self.camera.SetViewUp(0, 0, 1)
        self.camera.SetClippingRange(0.1, 60)

    def frames(self):
        self.errors.clear()
        return [self.view.picture() for _ in range(3)][-1]


def case(name, words, spoil, mend, plain_water=True):
    """spoil(scene) makes the scene wrong, mend(scene) right again; words must be in the error."""
    scene = Scene()
    good = scene.frames()
    mask = wt.water_mask(scene.view, scene.water)
    wt.check_equal(f"{name}: errors before", scene.errors, [])
    spoil(scene)
    picture = scene.frames()
    wt.check_equal(f"{name}: errors in three frames", len(scene.errors), 1)
    for word in words:
        wt.check_equal(f"{name}: the error names '{word}'", word in "".join(scene.errors), True)
    if plain_water:
        color = np.round(255 * np.asarray(DEEP))
        wt.check_at_most(f"{name}: water is its plain colour, error",
                         float(np.abs(picture - color).max(axis=2)[mask].max()), 1.0)
        wt.check_equal(f"{name}: the rest, largest error", int(np.abs(picture - good)[~mask].max()), 0)
    mend(scene)
    picture = scene.frames()
    wt.check_equal(f"{name}: errors after", scene.errors, [])
    wt.check_equal(f"{name}: next picture, largest error", int(np.abs(picture - good).max()), 0)


def set_normal(*normal):
    def spoil(scene):
        plane = vtkPlane()
        plane.SetOrigin(0, 0, 0)
        plane.SetNormal(normal)
        scene.water.SetPlane(plane)

    return spoil


def level_0(scene):
    scene.water.SetLevel(0)


case("zero normal", ["(0, 0, 0)", "not zero"], set_normal(0, 0, 0), level_0)
case("normal with NaN", ["nan", "finite"], set_normal(0, NAN, 1), level_0)
case("infinite normal", ["inf", "finite"], set_normal(0, 0, INFINITY), level_0)
case("camera exactly on the plane", ["exactly on the water plane"],
     lambda scene: scene.place_camera(0), lambda scene: scene.place_camera(), plain_water=False)


def too_large(scene):
    scene.view.window.SetSize(1100, 900)
    scene.water.GetReflectionPass().SetTextureScale(16)


def not_too_large(scene):
    scene.view.window.SetSize(320, 240)
    scene.water.GetReflectionPass().SetTextureScale(1)


case("texture larger than the GPU's limit", ["1100 x 900", "16", "exceeds"], too_large, not_too_large,
     plain_water=False)


def empty(scene):
    props = scene.view.renderer.GetViewProps()
    scene.props = [props.GetItemAsObject(i) for i in range(props.GetNumberOfItems())]
    scene.view.renderer.RemoveAllViewProps()
    scene.view.renderer.AddActor(scene.water)
    scene.water.ResetSheetBounds()


def refill(scene):
    scene.view.renderer.RemoveAllViewProps()
    scene.water.SetSheetBounds(-9, 9, -6, 9)
    for prop in scene.props:
        scene.view.renderer.AddActor(prop)


case("empty scene", ["no surface", "empty"], empty, refill, plain_water=False)

# A window of no size: no crash, and the next frame is right.
scene = Scene()
good = scene.frames()
scene.view.window.SetSize(0, 0)
scene.view.window.Render()
scene.view.window.SetSize(320, 240)
wt.check_equal("zero-size window: next picture, largest error", int(np.abs(scene.frames() - good).max()), 0)

# Setters refuse what is out of range; the last good value stays.
def refuses(thing, setter, getter, value, range_text):
    errors = []
    tag = thing.AddObserver("ErrorEvent", _Text(errors))
    before = getattr(thing, getter)()
    arguments = value if isinstance(value, tuple) else (value,)
    getattr(thing, setter)(*arguments)
    thing.RemoveObserver(tag)
    name = f"{thing.GetClassName()}.{setter}{arguments}"
    wt.check_equal(f"{name}: errors", len(errors), 1)
    named = all(f"{v:g}" in errors[0] for v in arguments if isinstance(v, float) and not math.isinf(v))
    wt.check_equal(f"{name}: names the value", bool(errors) and named, True)
    wt.check_equal(f"{name}: names '{range_text}'", bool(errors) and range_text in errors[0], True)
    wt.check_equal(f"{name}: the last good value stays", getattr(thing, getter)() == before, True)


class _Text:
    """An observer that keeps the text of the error."""

    CallDataType = "string0"

    def __init__(self, errors):
        self.errors = errors

    def __call__(self, caller, event, text):
        self.errors.append(text)


water = wt.vtkWaterActor()
look = water.GetWaterProperty()
mirror = water.GetReflectionPass()
for value in (-0.1, 1.5, NAN):
    refuses(look, "SetReflectance", "GetReflectance", value, "[0, 1]")
    refuses(look, "SetOpacity", "GetOpacity", value, "[0, 1]")
for value in (0.9, NAN, INFINITY):
    refuses(look, "SetIndexOfRefraction", "GetIndexOfRefraction", value, "[1, 10]")
refuses(look, "SetReflectanceMode", "GetReflectanceMode", 7, "[0, 1]")
refuses(look, "SetDeepColor", "GetDeepColor", (0.5, NAN, 0.5), "[0, 1]")
refuses(look, "SetDeepColor", "GetDeepColor", (0.5, 2.0, 0.5), "[0, 1]")
for value in (0.0, -1.0, 17.0, NAN):
    refuses(mirror, "SetTextureScale", "GetTextureScale", value, "16]")
for value in (-1.0, NAN, INFINITY):
    refuses(mirror, "SetClipMargin", "GetClipMargin", value, "[0, ")
for value in (0.5, 2.5, NAN):
    refuses(mirror, "SetGuardBand", "GetGuardBand", value, "[1, 2]")
refuses(mirror, "SetMultiSamples", "GetMultiSamples", -2, "[-1, 32]")
for value in (NAN, INFINITY):
    refuses(water, "SetLevel", "GetLevel", value, "finite")
for value in ((1.0, -1.0, 0.0, 2.0), (0.0, NAN, 0.0, 1.0)):
    refuses(water, "SetSheetBounds", "GetSheetBounds", value, "finite")
wt.finish()

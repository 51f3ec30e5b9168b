# SPDX-License-Identifier: BSD-3-Clause
"""Water among other things of VTK: in assemblies, beside levels of detail, axes, users' shaders.

The truth of each case is a scene in which the same thing is an ordinary actor.
"""

import threading

import numpy as np
import water_test as wt
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingAnnotation import vtkAxesActor
from vtkmodules.vtkRenderingCore import (
    vtkAssembly,
    vtkLODProp3D,
    vtkPropAssembly,
    vtkPropCollection,
)
from vtkwater import vtkWaterActor, vtkWaterReflectionPass

SHEET = (-9, 9, -9, 9)
FAR = (1e7, 2e7, 1e3)


def view(offset=(0, 0, 0)):
    result = wt.View((200, 150))
    wt.place_camera(result.renderer, np.add((4, -5, 2), offset), offset, (0.1, 100))
    return result


def thing(renderer, offset=(0, 0, 0)):
    return wt.add_actor(renderer, wt.moved(wt.pyramid((0, 0, 0.4), 1.2), offset), (1, 0.6, 0.2))


def count_errors(prop):
    errors = []
    prop.AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
    return errors


# In an assembly, alone or with the scene: the sheet covers the scene, and nothing is walked twice.
for assembly in (vtkAssembly(), vtkPropAssembly()):
    for with_scene in (True, False):
        name = f"{assembly.GetClassName()} of water{' and scene' if with_scene else ''}"
        scene = view()
        actor = thing(scene.renderer)
        water = vtkWaterActor()
        assembly = assembly.NewInstance()
        assembly.AddPart(water)
        if with_scene:
            scene.renderer.RemoveActor(actor)
            assembly.AddPart(actor)
        scene.renderer.AddViewProp(assembly)
        errors = count_errors(water)
        for _ in range(3):
            scene.picture()
        wt.check_equal(f"{name}: bounds of the sheet", np.round(water.GetBounds()[:4], 6).tolist(),
                       np.round(actor.GetBounds()[:4], 6).tolist())
        wt.check_equal(f"{name}: errors", len(errors), 0)

# A level of detail that only the mirror sees, or that is chosen after the water is asked.
plain = view()
thing(plain.renderer)
wt.add_water(plain.renderer, None, SHEET)
plain = plain.picture()
scene = view()
wt.add_water(scene.renderer, None, SHEET)
actor = thing(scene.renderer)
scene.renderer.RemoveActor(actor)
levels = vtkLODProp3D()
levels.AddLOD(actor.GetMapper(), actor.GetProperty(), 0.0)
scene.renderer.AddViewProp(levels)
wt.check_equal("vtkLODProp3D after the water: first picture, error", wt.difference(scene.picture(), plain), 0)

# Axes that stand half under water: reflected as the ordinary actors that they are made of.
def axes_scene(in_parts):
    scene = view()
    wt.add_water(scene.renderer, None, SHEET)
    axes = vtkAxesActor()
    axes.AxisLabelsOff()
    axes.SetTotalLength(2, 2, 2)
    transform = vtkTransform()
    transform.Translate(0, 0, -1)
    axes.SetUserTransform(transform)
    scene.renderer.AddActor(axes)
    scene.picture()
    if in_parts:
        parts = vtkPropCollection()
        axes.GetActors(parts)
        scene.renderer.RemoveActor(axes)
        for i in range(parts.GetNumberOfItems()):
            scene.renderer.AddActor(parts.GetItemAsObject(i))
    return scene.picture()


wt.check_equal("vtkAxesActor half under water: error", wt.difference(axes_scene(False), axes_scene(True)), 0)

# A user's own shader that takes the place where water declares its functions.
scene = view()
actor = thing(scene.renderer)
for tag in ("//VTK::Clip::Dec", "//VTK::Clip::Impl"):
    actor.GetShaderProperty().AddFragmentShaderReplacement(tag, True, "// mine\n", True)
wt.add_water(scene.renderer, None, SHEET)
wt.check_equal("user's shader replacement: picture, error", wt.difference(scene.picture(), plain), 0)

# Water made by a thread and water made by another, in one renderer.
halves = []
made = threading.Thread(target=lambda: halves.append(vtkWaterActor()))
made.start()
made.join()
halves.append(vtkWaterActor())
scene = view()
thing(scene.renderer)
for water, sheet in zip(halves, ((-9, 0, -9, 9), (0, 9, -9, 9))):
    water.SetSheetBounds(sheet)
    water.GetWaterProperty().SetReflectanceModeToConstant()
    water.GetWaterProperty().SetReflectance(1)
    scene.renderer.AddActor(water)
wt.check_equal("water of two threads: picture, error", wt.difference(scene.picture(), plain), 0)


# A composed pass takes charge of one plane; water in another keeps its own mirror.
def two_levels(composed):
    scene = view()
    thing(scene.renderer)
    for level, sheet in ((-0.2, (-9, 0, -9, 9)), (-0.6, (0, 9, -9, 9))):
        wt.add_water(scene.renderer, wt.plane((0, 0, level), (0, 0, 1)), sheet)
    if composed:
        scene.renderer.SetPass(vtkWaterReflectionPass())
    return [scene.picture() for _ in range(2)]


for own, composed in zip(two_levels(False), two_levels(True)):
    wt.check_equal("two levels with a composed pass: error", wt.difference(composed, own), 0)

# A chain of passes that leads back is said once, and ends.
first, second = vtkWaterReflectionPass(), vtkWaterReflectionPass()
first.SetDelegatePass(second)
second.SetDelegatePass(first)
errors = count_errors(first)
scene = view()
thing(scene.renderer)
scene.renderer.SetPass(first)
for _ in range(3):
    scene.picture()
wt.check_equal("cycle of passes: errors", len(errors), 1)
wt.check_equal("cycle of passes: printed", "leads back" in str(first), True)
scene.renderer.SetPass(None)
second.SetDelegatePass(None)

# Mappers that shift and scale coordinates by the camera.
pictures = []
for method in (1, 5, 6):  # AUTO_SHIFT_SCALE, NEAR_PLANE_SHIFT_SCALE, FOCAL_POINT_SHIFT_SCALE
    scene = view(FAR)
    thing(scene.renderer, FAR).GetMapper().SetVBOShiftScaleMethod(method)
    wt.add_water(scene.renderer, wt.plane(FAR, (0, 0, 1)), SHEET)
    pictures.append(scene.picture())
for name, picture in zip(("near plane", "focal point"), pictures[1:]):
    wt.check_at_most(f"shift and scale by the {name}: pixels off by more than 1/255",
                     int((np.abs(picture - pictures[0]).max(axis=2) > 1).sum()), 0.0002 * 200 * 150)

# A plane with an offset besides its origin (VTK 9.4 and later).
offset = wt.plane((0, 0, -0.2), (0, 0, 1))
if hasattr(offset, "SetOffset"):
    offset.SetOffset(0.5)
    level = -0.2 - offset.EvaluateFunction((0, 0, -0.2))
    scene = view()
    water = wt.add_water(scene.renderer, offset, SHEET)
    scene.picture()
    wt.check_at_most("plane with an offset: error of the sheet's height",
                     abs(water.GetBounds()[4] - level), 1e-12)

# A copy looks like the original.
water, copy = vtkWaterActor(), vtkWaterActor()
water.GetReflectionPass().SetTextureScale(0.25)
water.GetReflectionPass().SetClipMargin(0.1)
water.GetReflectionPass().SetMultiSamples(4)
copy.ShallowCopy(water)
copied = copy.GetReflectionPass()
wt.check_equal("ShallowCopy: TextureScale, ClipMargin, MultiSamples",
               (copied.GetTextureScale(), copied.GetClipMargin(), copied.GetMultiSamples()), (0.25, 0.1, 4))

# A mapper without input is an error that is said once.
scene = view()
thing(scene.renderer)
water = vtkWaterActor()
water.SetMapper(wt.vtkPolyDataMapper())
errors = count_errors(water)
scene.renderer.AddActor(water)
for _ in range(3):
    scene.picture()
wt.check_equal("mapper without input: errors", len(errors), 1)
wt.check_equal("mapper without input: named", "has no input" in water.GetLastError(), True)

# The same water in two renderers, one of which cannot show it: said once.
scene = view()
thing(scene.renderer)
below = scene.add_renderer((0, 0, 0), (0, 0, 0.3, 0.3))
below.GetActiveCamera().SetPosition(0, -5, 0)
below.GetActiveCamera().SetClippingRange(0.1, 100)
water = wt.add_water(scene.renderer, None, SHEET)
below.AddActor(water)
errors = count_errors(water)
for _ in range(5):
    scene.picture()
wt.check_equal("camera on the plane in one of two renderers: errors in five frames", len(errors), 1)
wt.check_equal("camera on the plane: position named", "(0, -5, 0)" in water.GetLastError(), True)
wt.finish()

# SPDX-License-Identifier: BSD-3-Clause
"""Clear water among other things of VTK: opacity, observers, several sheets, passes with several
buffers, transparent backgrounds, the order of adding."""

import numpy as np
import water_test as wt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkRenderingCore import vtkTexture
from vtkwater import vtkWaterActor

SIZE = (200, 150)
SHEET = (-40, 40, -40, 40)


def scene(eye=(3, -8, 4), target=(0, 0, 0), clear=True):
    made = wt.View(SIZE, (0.5, 0.7, 0.9))
    water = wt.add_water(made.renderer, None, SHEET, None)
    water.GetWaterProperty().SetRefraction(clear)
    water.GetWaterProperty().SetAbsorption(0.3, 0.1, 0.05)
    water.GetWaterProperty().SetScattering(0, 0, 0)
    # added after the water: it must be seen through it all the same
    wt.add_actor(made.renderer, wt.box((0, 0, -3), (40, 40, 1)), (0.8, 0.7, 0.5), lit=False)
    wt.add_actor(made.renderer, wt.box((0, 0, -0.5), (1, 1, 4)), (0.9, 0.2, 0.1), lit=False)
    wt.place_camera(made.renderer, eye, target, (0.1, 200))
    return made, water


UNDER = {"eye": (3, -8, -1.2), "target": (0, 0, -1)}

# The order of adding does not matter.
made, water = scene()
before = made.picture()
made.renderer.RemoveActor(water)
made.renderer.AddActor(water)
wt.check_equal("water added last: difference", wt.difference(made.picture(), before), 0)

# An actor that is made translucent by its own vtkProperty is plain alpha blending, as by the water's.
for peeling in (False, True):
    for name, place in (("above", {}), ("under water", UNDER)):
        pictures = []
        for by_actor in (False, True):
            made, water = scene(**place)
            made.renderer.SetUseDepthPeeling(peeling)
            (water.GetProperty() if by_actor else water.GetWaterProperty()).SetOpacity(0.5)
            pictures.append(made.picture())
        wt.check_at_most(f"opacity by either property, {name}, peeling {peeling}: difference", wt.difference(*pictures), 1)

# Observers that drop what is being drawn.
for name, drop in (("property", lambda water: water.SetWaterProperty(None)),
                   ("environment", lambda water: water.GetWaterProperty().SetEnvironmentTexture(None)),
                   ("normal maps", lambda water: water.GetWaterProperty().RemoveAllNormalMaps())):
    made, water = scene()
    picture = vtkTexture()
    picture.SetInputData(wt.checker())
    water.GetWaterProperty().SetEnvironmentTexture(picture)
    water.GetWaterProperty().SetReflectionSourceToEnvironment()
    water.GetWaterProperty().AddNormalMap(None, 2.0)
    del picture
    made.picture()
    water.GetMapper().AddObserver("StartEvent", lambda caller, event: drop(water))
    water.GetMapper().AddObserver("UpdateShaderEvent", lambda caller, event: drop(water))
    for _ in range(3):
        made.picture()
    wt.check_equal(f"an observer drops the {name}: it is drawn", bool(water.GetLastError()), False)

# An environment that becomes a cube map, or loses its picture, leaves the background.
made, water = scene()
look = water.GetWaterProperty()
look.SetReflectionSourceToEnvironment()
background = made.picture()
picture = vtkTexture()
picture.SetInputData(wt.checker())
look.SetEnvironmentTexture(picture)
wt.check_at_least("environment: it is reflected", wt.difference(made.picture(), background), 10)
picture.RemoveAllInputConnections(0)
wt.check_equal("environment without a picture: difference from the background", wt.difference(made.picture(), background), 0)

# Two sheets over one eye: the water between eye and scene is there once.
made, water = scene(**UNDER)
once = made.picture()
water.SetSheetBounds(-40, 0, -40, 40)
other = vtkWaterActor()
other.SetWaterProperty(water.GetWaterProperty())
other.SetSheetBounds(0, 40, -40, 40)
made.renderer.AddActor(other)
both = made.picture()
wt.check_at_most("two sheets of one water: % of the pixels under it that differ",
                 100 * float((np.abs(both - once).max(axis=2) > 1)[:60].mean()), 0.5)
water.SetSheetBounds(*SHEET)
other.SetSheetBounds(*SHEET)
wt.check_at_most("twice the same sheet: % of the pixels under it that differ",
                 100 * float((np.abs(made.picture() - once).max(axis=2) > 1)[:60].mean()), 0.5)

# Fog through perfectly clear water changes nothing, whatever else is being drawn into.
for name, prepare in (("plain", lambda renderer: None), ("SSAO", lambda renderer: renderer.UseSSAOOn()),
                      ("FXAA", lambda renderer: renderer.UseFXAAOn())):
    pictures = []
    for sheet in (SHEET, (-40, -30, -40, -30)):  # the eye is in it, or not
        made, water = scene(**UNDER)
        water.GetWaterProperty().SetAbsorption(0, 0, 0)
        water.SetSheetBounds(*sheet)
        prepare(made.renderer)
        pictures.append(made.picture())
    wt.check_at_most(f"fog of nothing, {name}: largest difference under the horizon",
                     int(np.abs(pictures[0] - pictures[1])[:40].max()), 1)

# A transparent background stays transparent.
made, water = scene(eye=(3, -8, -1.2), target=(0, 60, 20))
water.SetSheetBounds(-40, 40, -40, -5)  # over the eye, and not over what it sees behind
made.window.SetAlphaBitPlanes(True)
made.renderer.SetBackgroundAlpha(0.0)
made.picture()
pixels = vtkUnsignedCharArray()
made.window.GetRGBACharPixelData(0, 0, SIZE[0] - 1, SIZE[1] - 1, 0, pixels)
alpha = vtk_to_numpy(pixels).reshape(SIZE[1], SIZE[0], 4)[:, :, 3]
water.VisibilityOff()
made.picture()
plain = vtkUnsignedCharArray()
made.window.GetRGBACharPixelData(0, 0, SIZE[0] - 1, SIZE[1] - 1, 0, plain)
is_open = vtk_to_numpy(plain).reshape(SIZE[1], SIZE[0], 4)[:, :, 3] == 0
is_open[90:] = False  # the surface is there
wt.check_at_least("transparent background: pixels beside the surface", int(is_open.sum()), 10000)
wt.check_equal("transparent background: opaque pixels beside the surface", int((alpha[is_open] > 0).sum()), 0)

# A soft shore: the reflectance begins with the depth of the water.
made = wt.View(SIZE, (0, 0, 0))
bed = wt.box((0, 0, -0.5), (40, 40, 1))
points = bed.GetPoints()
for i in range(points.GetNumberOfPoints()):  # dry from x = 0 on, 0.1 m deeper every metre to the left
    px, py, pz = points.GetPoint(i)
    points.SetPoint(i, px, py, pz + 0.1 * px)
wt.add_actor(made.renderer, bed, (0.5, 0.5, 0.5), lit=False)
water = wt.add_water(made.renderer, None, SHEET, 1.0)
look = water.GetWaterProperty()
look.RefractionOn()
look.SetShoreSoftness(0.2)  # full from x = -2 on
look.SetOutputToReflectance()
camera = made.renderer.GetActiveCamera()
camera.ParallelProjectionOn()
camera.SetParallelScale(3)
camera.SetPosition(-1, 0, 20)
camera.SetFocalPoint(-1, 0, 0)
camera.SetViewUp(0, 1, 0)
camera.SetClippingRange(1, 40)
row = made.picture()[75]
x = -1 + (np.arange(SIZE[0]) + 0.5 - SIZE[0] / 2) * 6 / SIZE[1]
shown = (256 * row[:, 0] + row[:, 1]) / 65535
is_water = x < -0.05
wt.check_at_most("soft shore: error of the reflectance",
                 float(np.abs(shown - np.clip(-0.1 * x / 0.2, 0, 1))[is_water].max()), 0.01)

# A rough reflection is one blurred image, not several sharp ones: between the images of an edge the
# brightness rises step by step.
made = wt.View(SIZE, (0, 0, 0))
wt.add_actor(made.renderer, wt.box((0, 20, 4), (200, 0.1, 8)), (1, 1, 1), lit=False)
water = wt.add_water(made.renderer, None, (-90, 90, -90, 90), 1.0)
water.GetWaterProperty().SetSlopeVariance(5e-4, 5e-4)
wt.place_camera(made.renderer, (0, -20, 5), (0, 0, 1), (1, 200))
column = made.picture()[:, 100, 0]
steps = np.abs(np.diff(column))[:70]  # from the bottom up to the foot of the wall
wt.check_at_most("rough reflection: largest step from pixel to pixel, of 255", int(steps.max()), 60)

# A change of a texture is a change of the water.
water = vtkWaterActor()
picture = vtkTexture()
picture.SetInputData(wt.checker())
water.GetWaterProperty().SetEnvironmentTexture(picture)
before = water.GetMTime()
picture.Modified()
wt.check_equal("a texture's change is the water's", water.GetMTime() > before, True)
wt.finish()

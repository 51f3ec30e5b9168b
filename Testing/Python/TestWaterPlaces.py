# SPDX-License-Identifier: BSD-3-Clause
"""Water from below, as the user's mesh, as a composed pass, in two windows, resized, released."""

import gc

import numpy as np
import water_test as wt
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper
from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass
from vtkwater import vtkWaterReflectionPass

LEVEL = ((0, 0, 0), (0, 0, 1))


def build(size=(320, 240), reflectance=1.0, sheet=(-9, 9, -6, 9), background=(0.2, 0.3, 0.4)):
    view = wt.View(size, background)
    for data, color in wt.columns_and_pyramids():
        wt.add_actor(view.renderer, data, color)
    wt.add_scene_light(view.renderer, (3, -5, 8))
    water = wt.add_water(view.renderer, wt.plane(*LEVEL), sheet, reflectance)
    camera = view.renderer.GetActiveCamera()
    camera.SetPosition(2, -13, 4)
    camera.SetViewUp(0, 0, 1)
    camera.SetClippingRange(1, 60)
    return view, water


view, water = build()
reference = view.picture()
mask = wt.water_mask(view, water)

# A flat mesh of the user's in the plane shows what the own sheet shows there, and has its hole.
corners = [(-9, -6), (9, -6), (9, 9), (-9, 9), (-2, -5), (2, -5), (2, -3), (-2, -3)]
points = vtkPoints()
for x, y in corners:
    points.InsertNextPoint(x, y, 0)
cells = vtkCellArray()
for quad in ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)):
    cells.InsertNextCell(4)
    for corner in quad:
        cells.InsertCellPoint(corner)
lake = vtkPolyData()
lake.SetPoints(points)
lake.SetPolys(cells)
mapper = vtkPolyDataMapper()
mapper.SetInputData(lake)
water.SetMapper(mapper)
mesh = view.picture()
mesh_mask = wt.water_mask(view, water)
wt.check_at_least("mesh with an island: pixels of the hole", int((mask & ~mesh_mask).sum()), 300)
off = float((np.abs(mesh - reference).max(axis=2) > 1)[mesh_mask].mean() * 100)
wt.check_at_most("mesh with an island: % of its pixels off", off, 0.02)
water.SetMapper(None)
wt.check_equal("own sheet again: largest error", wt.difference(view.picture(), reference), 0)

# Composed by hand, the pass gives the same picture.
for name, delegate in (("default delegate", None), ("render steps", vtkRenderStepsPass())):
    composed_view, composed_water = build()
    by_hand = vtkWaterReflectionPass()
    by_hand.SetDelegatePass(delegate)
    composed_view.renderer.SetPass(by_hand)
    picture = composed_view.picture()
    wt.check_equal(f"pass composed by hand, {name}: in charge", composed_water.GetReflectionPass() is by_hand, True)
    wt.check_equal(f"pass composed by hand, {name}: renders", by_hand.GetNumberOfReflectionRenders(), 1)
    wt.check_equal(f"pass composed by hand, {name}: largest error", wt.difference(picture, reference), 0)
    composed_view.renderer.SetPass(None)
    wt.check_equal(f"taken out again, {name}: largest error", wt.difference(composed_view.picture(), reference), 0)
    wt.check_equal(f"taken out again, {name}: own pass", composed_water.GetReflectionPass() is by_hand, False)

# From below: the underside shows what is below, whole where reflection is total.
below_view, below_water = build(reflectance=None)
below = below_view.renderer.GetActiveCamera()
below.SetPosition(2, -13, -2)
below_view.renderer.RemoveAllLights()
wt.add_scene_light(below_view.renderer, (3, -5, -8))
seen = below_view.picture()
below_mask = wt.water_mask(below_view, below_water)
mirror = wt.View((320, 240))
for data, color in wt.columns_and_pyramids():
    wt.add_actor(mirror.renderer, wt.mirror_image(data, (0, 0, 0), (0, 0, -1)), color)
wt.add_scene_light(mirror.renderer, (3, -5, 8))
camera = mirror.renderer.GetActiveCamera()
camera.SetPosition(2, -13, -2)
camera.SetViewUp(0, 0, 1)
camera.SetClippingRange(1, 60)
off = float((np.abs(seen - mirror.picture()).max(axis=2) > 1)[below_mask].mean() * 100)
wt.check_at_least("from below: water pixels", int(below_mask.sum()), 3000)
wt.check_at_most("from below, total reflection: % of water pixels off", off, 0.02)

# Resized, released, moved to another window, shared by two.
view.window.SetSize(200, 300)
view.picture()
view.window.SetSize(320, 240)
wt.check_equal("resized and back: largest error", wt.difference(view.picture(), reference), 0)
view.window.Finalize()
wt.check_equal("released and rendered again: largest error", wt.difference(view.picture(), reference), 0)
other = wt.View((320, 240))
other.window.RemoveRenderer(other.renderer)
view.window.RemoveRenderer(view.renderer)
other.window.AddRenderer(view.renderer)
other.renderer = view.renderer
wt.check_equal("in another window: largest error", wt.difference(other.picture(), reference), 0)
# VTK itself draws no prop rightly in two windows of separate contexts (9.6, without any water): each
# window has its own water here, and both of them the one look and plane.
first, shared = build()
second, twin = build()
twin.SetWaterProperty(shared.GetWaterProperty())
twin.SetPlane(shared.GetPlane())
for turn in range(2):
    wt.check_equal(f"two windows in turn, first, turn {turn}: largest error", wt.difference(first.picture(), reference), 0)
    wt.check_equal(f"two windows in turn, second, turn {turn}: largest error", wt.difference(second.picture(), reference), 0)
del twin
del second
gc.collect()
wt.check_equal("after the second window is gone: largest error", wt.difference(first.picture(), reference), 0)

# The debug corner: the map, turned back, in the lower left quarter and nowhere else.
view, water = build()
water.GetReflectionPass().ShowReflectionOn()
corner = view.picture()
wt.check_equal("debug corner: the rest, largest error",
               wt.difference(np.where(np.arange(240)[:, None, None] >= 120, corner, 0),
                             np.where(np.arange(240)[:, None, None] >= 120, reference, 0)), 0)
wt.check_equal("debug corner: right half, largest error", wt.difference(corner[:, 160:], reference[:, 160:]), 0)
# each pixel of the corner is the map at twice its place, where the water looks it up
shown = corner[:120, :160][2:-2, 2:-2]
expected = reference[::2, ::2][2:-2, 2:-2]
inside = mask[::2, ::2][2:-2, 2:-2]
close = float((np.abs(shown - expected).max(axis=2) < 40)[inside].mean())
wt.check_at_least("debug corner: share of the water's pixels that show its reflection", close, 0.9)
wt.finish()

# SPDX-License-Identifier: BSD-3-Clause
"""Every prop meets the fate it should, and the pass says so; no endless mirror."""

import numpy as np
import water_test as wt
from vtkmodules.vtkRenderingCore import vtkActor, vtkBillboardTextActor3D, vtkTextActor
from vtkmodules.vtkRenderingCore import vtkAssembly
from vtkwater import vtkWaterReflectionPass as Pass

RED, GREEN = (1, 0, 0), (0, 1, 0)

view = wt.View((320, 240), background=(0, 0, 0))
renderer = view.renderer
water = wt.add_water(renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-9, 9, -9, 9))
visible = wt.add_actor(renderer, wt.box((0, 3, 2), (2, 2, 2)), RED, lit=False)
invisible = wt.add_actor(renderer, wt.box((3, 3, 2), (2, 2, 2)), GREEN, lit=False)
invisible.VisibilityOff()
marked = wt.add_actor(renderer, wt.box((-3, 3, 2), (2, 2, 2)), GREEN, lit=False)
wt.leave_out(marked)
under = wt.add_actor(renderer, wt.box((0, 3, -2), (2, 2, 2)), GREEN, lit=False)
aside = wt.add_actor(renderer, wt.box((500, 3, 2), (2, 2, 2)), GREEN, lit=False)
renderer.AddActor(vtkActor())  # no mapper: empty
text = vtkTextActor()
text.SetInput("overlay")
renderer.AddActor(text)
label = vtkBillboardTextActor3D()
label.SetInput("label")
label.SetPosition(2, 0, 1)
renderer.AddActor(label)
camera = renderer.GetActiveCamera()
camera.SetPosition(0, -15, 5)
camera.SetViewUp(0, 0, 1)
camera.SetClippingRange(1, 60)
picture = view.picture()

mirror = water.GetReflectionPass()
mirror.SetSkips(Pass.SKIP_ALL & ~Pass.UNCHANGED_VIEWS)
expected = {
    "DRAWN": 1,
    "INVISIBLE": 1,
    "WATER_ITSELF": 1,
    "MARKED_NOT_REFLECTED": 1,
    "OVERLAY": 1,
    "LABEL": 1,
    "EMPTY": None,  # an actor without a mapper has no bounds at all: drawn or empty
    "BEHIND_PLANE": 1,
    "OUT_OF_VIEW": 1,
}
for name, count in expected.items():
    value = mirror.GetFateCount(getattr(Pass, name))
    text_of_fate = Pass.GetFateAsString(getattr(Pass, name))
    if count is not None and name != "DRAWN":
        wt.check_equal(f"fate '{text_of_fate}'", value, count)
wt.check_equal(
    "all props have a fate",
    sum(mirror.GetFateCount(fate) for fate in range(Pass.NUMBER_OF_FATES)),
    renderer.GetViewProps().GetNumberOfItems(),
)
wt.check_equal("unknown fate counts 0", mirror.GetFateCount(99), 0)
wt.check_equal("props reflected", mirror.GetNumberOfPropsReflected(), mirror.GetFateCount(Pass.DRAWN))

mask = wt.water_mask(view, water)
wt.check_at_least("red in the water", int(((picture == (255, 0, 0)).all(axis=2) & mask).sum()), 200)
wt.check_equal("green in the water", int(((picture == (0, 255, 0)).all(axis=2) & mask).sum()), 0)

# A second sheet over the first, facing it: each shows the other's own colour, and nothing recurses.
ceiling = wt.add_water(renderer, wt.plane((0, 0, 6), (0, 0, 1)), (-9, 9, -9, 9))
ceiling.GetWaterProperty().SetDeepColor(0, 0, 1)
renders = mirror.GetNumberOfReflectionRenders()
view.picture()
wt.check_equal("two waters: renders of the first a frame", mirror.GetNumberOfReflectionRenders() - renders, 1)
wt.check_equal("two waters: left out of the mirror", mirror.GetFateCount(Pass.WATER_ITSELF), 1)
renderer.RemoveActor(ceiling)

# Water as a part of an assembly: the assembly is not drawn again while it is being drawn.
renderer.RemoveActor(water)
assembly = vtkAssembly()
part = wt.vtkWaterActor()
part.SetSheetBounds(-9, 9, -9, 9)
part.GetWaterProperty().SetReflectanceModeToConstant()
assembly.AddPart(part)
renderer.AddActor(assembly)
again = view.picture()
wt.check_equal("in an assembly: decision", part.GetReflectionPass().GetDecisionAsString(), "rendered")
off = (np.abs(again - picture).max(axis=2) > 1).mean() * 100
wt.check_at_most("in an assembly: % of pixels off", float(off), 0.02)

# The reasons for not rendering at all.
def decision(prepare, restore):
    prepare()
    view.picture()
    text = part.GetReflectionPass().GetDecisionAsString()
    restore()
    return text


look = part.GetWaterProperty()
wt.check_equal("reflectance 0", decision(lambda: look.SetReflectance(0), lambda: look.SetReflectance(1)),
               "not rendered: the water reflects nothing")


def edge_on():
    camera.SetPosition(0, -15, 0)
    camera.ParallelProjectionOn()


def back():
    camera.SetPosition(0, -15, 5)
    camera.ParallelProjectionOff()


wt.check_equal("edge-on, parallel", decision(edge_on, back), "not rendered: the water is seen edge-on")
wt.finish()

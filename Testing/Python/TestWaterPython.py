# SPDX-License-Identifier: BSD-3-Clause
"""The Python package: every class is there, native to VTK, and PrintSelf shows every parameter."""

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import water_test as wt
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkRenderingCore import vtkActor, vtkProp, vtkRenderPass
import vtkwater

for name in ("vtkWaterActor", "vtkWaterProperty", "vtkWaterReflectionPass", "vtkWaterOffScreen"):
    wt.check_equal(f"{name} is wrapped", hasattr(vtkwater, name), True)
water = vtkwater.vtkWaterActor()
wt.check_equal("water is a vtkActor", isinstance(water, vtkActor) and isinstance(water, vtkProp), True)
wt.check_equal("its pass is a vtkRenderPass", isinstance(water.GetReflectionPass(), vtkRenderPass), True)
wt.check_equal("the package has a version", isinstance(vtkwater.__version__, str), True)

look = water.GetWaterProperty()
mirror = water.GetReflectionPass()
settings = [
    (look, "Reflectance", 0.625), (look, "IndexOfRefraction", 1.375), (look, "Opacity", 0.8125),
    (look, "DeepColor", (0.125, 0.25, 0.375)), (look, "ReflectanceMode", 1),
    (mirror, "TextureScale", 0.4375), (mirror, "ClipMargin", 0.03125), (mirror, "MultiSamples", 4),
    (mirror, "ShowReflection", True), (water, "SheetBounds", (-11.5, 12.5, -13.5, 14.5)),
    (water, "Level", 17.25),
]
for thing, name, value in settings:
    getattr(thing, "Set" + name)(value)
    wt.check_equal(f"{thing.GetClassName()}.{name}", getattr(thing, "Get" + name)(), value)
text = str(water)
for shown in ("CONSTANT", "0.625", "1.375", "0.8125", "(0.125, 0.25, 0.375)", "0.4375", "0.03125",
              "MultiSamples: 4", "ShowReflection: on", "(-11.5, 12.5, -13.5, 14.5)", "17.25"):
    wt.check_equal(f"PrintSelf shows {shown}", shown in text, True)

view = wt.View((160, 120))
wt.add_actor(view.renderer, wt.box((0, 0, 1), (1, 1, 3)), (1, 0, 0))
plain = wt.add_water(view.renderer, reflectance=None)
view.renderer.ResetCamera()
view.picture()
text = str(plain)
for shown in ("Last plan: rendered", "Texture: 160 x 120", "Seen from above", "Props drawn: 1"):
    wt.check_equal(f"PrintSelf shows {shown}", shown in text, True)

copy = vtkwater.vtkWaterActor()
copy.ShallowCopy(water)
wt.check_equal("ShallowCopy takes level, look and bounds",
               (copy.GetLevel(), copy.GetWaterProperty() is look, copy.GetSheetBounds()),
               (17.25, True, (-11.5, 12.5, -13.5, 14.5)))

if vtkVersion.GetVTKMajorVersion() * 100 + vtkVersion.GetVTKMinorVersion() >= 904:
    new = vtkwater.vtkWaterProperty(reflectance=0.25, opacity=0.5)
    wt.check_equal("keywords and snake_case properties", (new.reflectance, new.opacity), (0.25, 0.5))
wt.finish()

# SPDX-License-Identifier: BSD-3-Clause
"""The Python package: every class is there, native to VTK, and PrintSelf shows every parameter."""

import pytest
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkwater
import water_test as wt
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkRenderingCore import vtkActor, vtkProp, vtkRenderPass

VTK_VERSION = (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion())
SETTINGS = {  # what has the setting, its value
    "Reflectance": ("look", 0.625), "IndexOfRefraction": ("look", 1.375), "Opacity": ("look", 0.8125),
    "DeepColor": ("look", (0.125, 0.25, 0.375)), "ReflectanceMode": ("look", 1),
    "TextureScale": ("mirror", 0.4375), "ClipMargin": ("mirror", 0.03125), "MultiSamples": ("mirror", 4),
    "SecondaryReflections": ("mirror", True),
    "ShowReflection": ("mirror", True), "SheetBounds": ("water", (-11.5, 12.5, -13.5, 14.5)),
    "Level": ("water", 17.25),
}


def thing_of(water, thing):
    return {"look": water.GetWaterProperty(), "mirror": water.GetReflectionPass(), "water": water}[thing]


@pytest.fixture
def water():
    """Water with all settings."""
    made = vtkwater.vtkWaterActor()
    for name, (thing, value) in SETTINGS.items():
        getattr(thing_of(made, thing), f"Set{name}")(value)
    return made


@pytest.mark.parametrize("name", ["vtkWaterActor", "vtkWaterProperty", "vtkWaterReflectionPass", "vtkWaterOffScreen"])
def test_the_class_is_wrapped(name):
    """The package has the class."""
    wt.check_equal(f"{name} is wrapped", hasattr(vtkwater, name), True)


def test_the_classes_are_vtks_own_kinds():
    """Water is an actor of VTK's and its pass a render pass."""
    made = vtkwater.vtkWaterActor()
    wt.check_equal("water is a vtkActor", isinstance(made, vtkActor) and isinstance(made, vtkProp), True)
    wt.check_equal("its pass is a vtkRenderPass", isinstance(made.GetReflectionPass(), vtkRenderPass), True)


def test_the_package_has_a_version():
    """The package says its version in a string."""
    wt.check_equal("the package has a version", isinstance(vtkwater.__version__, str), True)


@pytest.mark.parametrize("name", SETTINGS)
def test_a_setting_is_read_back(name):
    """A setting that was set is read back."""
    made = vtkwater.vtkWaterActor()
    thing, value = thing_of(made, SETTINGS[name][0]), SETTINGS[name][1]
    getattr(thing, f"Set{name}")(value)
    wt.check_equal(f"{thing.GetClassName()}.{name}", getattr(thing, f"Get{name}")(), value)


def test_print_self_shows_every_setting(water):
    """PrintSelf shows every setting by its value."""
    text = str(water)
    for shown in ("CONSTANT", "0.625", "1.375", "0.8125", "(0.125, 0.25, 0.375)", "0.4375", "0.03125",
                  "MultiSamples: 4", "ShowReflection: on", "(-11.5, 12.5, -13.5, 14.5)", "17.25"):
        wt.check_equal(f"PrintSelf shows {shown}", shown in text, True)


def test_print_self_shows_what_was_decided():
    """After a frame PrintSelf shows what was decided and drawn in it."""
    view = wt.View((160, 120))
    wt.add_actor(view.renderer, wt.box((0, 0, 1), (1, 1, 3)), (1, 0, 0))
    plain = wt.add_water(view.renderer, reflectance=None)
    view.renderer.ResetCamera()
    view.picture()
    text = str(plain)
    for shown in ("Last plan: rendered", "Texture: 160 x 120", "Seen from above", "Props drawn: 1"):
        wt.check_equal(f"PrintSelf shows {shown}", shown in text, True)


def test_a_shallow_copy_shares_the_look(water):
    """ShallowCopy takes level and bounds, and shares the look."""
    copy = vtkwater.vtkWaterActor()
    copy.ShallowCopy(water)
    wt.check_equal("ShallowCopy takes level, look and bounds",
                   (copy.GetLevel(), copy.GetWaterProperty() is water.GetWaterProperty(), copy.GetSheetBounds()),
                   (17.25, True, (-11.5, 12.5, -13.5, 14.5)))


@pytest.mark.skipif(VTK_VERSION < (9, 4), reason="VTK 9.4 was the first with keywords and snake_case properties")
def test_keywords_and_properties_work_as_vtks():
    """Settings are keywords of a constructor and properties in snake_case, as those of VTK's classes."""
    new = vtkwater.vtkWaterProperty(reflectance=0.25, opacity=0.5)
    wt.check_equal("keywords and snake_case properties", (new.reflectance, new.opacity), (0.25, 0.5))

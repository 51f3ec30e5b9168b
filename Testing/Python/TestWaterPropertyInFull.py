# SPDX-License-Identifier: BSD-3-Clause
"""A look is copied with all that can be set, every choice has a setter and a name, and presets, water types and waves
can be asked for and changed.

What there is to set is found by looking at the class, so that what is added later and forgotten fails here.
"""

import inspect
import re

import pytest
import water_test as wt
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkRenderingCore import vtkTexture
from vtkmodules.vtkImagingSources import vtkImageCanvasSource2D
from vtkwater import vtkWaterActor, vtkWaterProperty, vtkWaterReflectionPass

VTK_VERSION = (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion())
TYPES = ("I", "IA", "IB", "II", "III", "1C", "3C", "5C", "7C", "9C")
PRESETS = [vtkWaterProperty.GetPresetName(i) for i in range(vtkWaterProperty.GetNumberOfPresets())]
# They set several things that have setters of their own, or want a wave's number.
OF_SEVERAL = {"SetPreset", "SetWaterType", "SetRayTraceQuality", "SetSlopeVarianceToWind", "SetWave", "SetUnits"}
WAVES = ((0.03, 4.0, 20.0, 10.0, 0.5), (0.02, 3.0, 40.0, 0.0, 0.0), (0.01, 2.0, -30.0, 90.0, 0.25))


def texture():
    canvas = vtkImageCanvasSource2D()
    canvas.SetScalarTypeToUnsignedChar()
    canvas.SetNumberOfScalarComponents(3)
    canvas.SetExtent(0, 3, 0, 3, 0, 0)
    made = vtkTexture()
    made.SetInputConnection(canvas.GetOutputPort())
    return made


def own_methods(cls, pattern):
    return [name for name, value in vars(cls).items() if re.fullmatch(pattern, name) and inspect.isroutine(value)]


def settings():
    """Names of what can be set one by one."""
    return [name[3:] for name in own_methods(vtkWaterProperty, r"Set\w+")
            if name not in OF_SEVERAL and not re.search(r"[a-z]To[A-Z]\w+$", name)]


def value_of(look, name):
    if name == "SlopeVariance":
        variance = [0.0] * 3
        look.GetSlopeVariance(variance)
        return tuple(variance)
    return getattr(look, f"Get{name}")()


def others_of(value):
    """Values of its kind that differ from it; one of them is taken, whatever the range is."""
    if isinstance(value, bool):
        return [not value]
    if isinstance(value, tuple):
        return [tuple(0.5 * part + 0.25 for part in value)]
    if value is None:
        return [texture()]
    return (
        [2 * value, value + 1, value - 1, 0.5 * value, 0.5, 7.0]
        if isinstance(value, float)
        else [2 * value, value + 1, value - 1]
    )


def change(look, name):
    """Sets something to another value than it has."""
    before = value_of(look, name)
    look.AddObserver("ErrorEvent", lambda *_: None)
    for other in others_of(before):
        setter = getattr(look, f"Set{name}")
        setter(*other) if isinstance(other, tuple) else setter(other)
        if value_of(look, name) != before:
            return
    wt.check_equal(f"{name} is changed from {before}", False, True)


def all_of(look):
    """All that can be asked for without an argument, and the waves and maps."""
    found = {name: value_of(look, name) for name in settings()}
    for name in own_methods(vtkWaterProperty, r"Get\w+"):
        try:
            found[name] = getattr(look, name)()
        except TypeError:
            continue  # it wants arguments
    for i in range(look.GetNumberOfWaves()):
        wave = [0.0] * 5
        look.GetWave(i, wave)
        found[f"wave {i}"] = wave
    for i in range(look.GetNumberOfNormalMaps()):
        numbers = [0.0] * 4
        look.GetNormalMap(i, numbers)
        found[f"map {i}"] = (numbers, look.GetNormalMapTexture(i))
    del found["GetMTime"]
    return found


@pytest.fixture
def look():
    """A look in which everything has another value than the default."""
    made = vtkWaterProperty()
    for name in settings():
        change(made, name)
    for wave in WAVES:
        made.AddWave(*wave)
    made.AddNormalMap(texture(), 3.0, 0.5, 30.0, 2.0)
    made.AddNormalMap(None, 4.0)
    return made


def test_everything_was_changed(look):
    """The look that is copied has another value than the default for every setting: none is left out."""
    default, changed = all_of(vtkWaterProperty()), all_of(look)
    wt.check_at_least("settings", len(settings()), 35)
    wt.check_equal(
        "settings that kept their default", [name for name in settings() if changed[name] == default[name]], []
    )


def test_a_deep_copy_has_everything(look):
    """DeepCopy takes over every setting, every wave and every normal map; what is set afterwards stays apart."""
    copy = vtkWaterProperty()
    before = copy.GetMTime()
    copy.DeepCopy(look)
    wanted, found = all_of(look), all_of(copy)
    wt.check_equal("what differs", [name for name in wanted if found.get(name) != wanted[name]], [])
    wt.check_equal("modified", copy.GetMTime() > before, True)
    copy.RemoveAllWaves()
    copy.SetReflectance(0.125)
    wt.check_equal("the original afterwards", all_of(look), wanted)


@pytest.mark.parametrize("name", settings())
def test_a_deep_copy_has_each_setting_alone(name):
    """Each setting is copied when it alone was changed."""
    look, copy = vtkWaterProperty(), vtkWaterProperty()
    change(look, name)
    copy.DeepCopy(look)
    wt.check_equal(name, value_of(copy, name), value_of(look, name))


def test_a_deep_copy_of_nothing_or_itself_changes_nothing(look):
    """DeepCopy of None, or of the look itself, changes nothing."""
    wanted, before = all_of(look), look.GetMTime()
    look.DeepCopy(None)
    look.DeepCopy(look)
    wt.check_equal("afterwards", (all_of(look), look.GetMTime()), (wanted, before))


CHOICES = [
    (vtkWaterProperty, "DeepColorMode", "DeepColorModes"),
    (vtkWaterProperty, "ReflectanceMode", "ReflectanceModes"),
    (vtkWaterProperty, "ReflectionSource", "ReflectionSources"),
    (vtkWaterProperty, "RefractionSource", "RefractionSources"),
    (vtkWaterProperty, "SeaModel", "SeaModels"),
    (vtkWaterProperty, "Lookup", "Lookups"),
    (vtkWaterProperty, "Output", "Outputs"),
    (vtkWaterActor, "FoamMeasure", "FoamMeasures"),
    (vtkWaterReflectionPass, "ColorPrecision", "ColorPrecisions"),
    (vtkWaterReflectionPass, "Quality", "Qualities"),
]
NOT_SET = {"Confidences", "Fates", "Decisions", "Skips"}  # they are told, or bits


def enums_of(cls):
    return {name for name, value in vars(cls).items() if inspect.isclass(value) and issubclass(value, int)}


def values_of(cls, enum):
    kind = getattr(cls, enum)
    return {name: value for name, value in vars(cls).items() if isinstance(value, kind)}


def test_every_choice_is_known():
    """Every enum of property, pass and actor is one of those that are tried below."""
    for cls in (vtkWaterProperty, vtkWaterReflectionPass, vtkWaterActor):
        known = {enum for owner, _, enum in CHOICES if owner is cls} | NOT_SET
        wt.check_equal(f"{cls.__name__}: enums that are not", sorted(enums_of(cls) - known), [])


@pytest.mark.parametrize("cls, name, enum", CHOICES, ids=[choice[1] for choice in CHOICES])
def test_every_choice_has_a_setter_and_a_name(cls, name, enum):
    """Each value of an enum has a SetXToY, and GetXAsString says the value's name."""
    values = values_of(cls, enum)
    wt.check_at_least(f"{name}: values", len(values), 2)
    setters = own_methods(cls, f"Set{name}To[A-Z]\\w+")
    wt.check_equal(
        f"{name}: setters", len([setter for setter in setters if setter != "SetSlopeVarianceToWind"]), len(values)
    )
    for value_name, value in values.items():
        thing = cls()
        plain = value_name.replace("_", "").lower()
        setter = next(setter for setter in setters if setter.split("To", 1)[1].lower() == plain)
        thing_set = getattr(thing, f"Set{name}")
        thing_set(max(values.values()) if value == min(values.values()) else min(values.values()))
        getattr(thing, setter)()
        wt.check_equal(
            f"{setter}: value, name",
            (getattr(thing, f"Get{name}")(), getattr(thing, f"Get{name}AsString")()),
            (value, value_name),
        )


def said_by(look, call):
    """What the call returns, and what is said of it."""
    said = []

    def remember(caller, event, text):
        said.append(text)

    remember.CallDataType = "string0"
    look.AddObserver("ErrorEvent", remember)
    return call(look), " ".join(said)


def waves_of(look):
    waves = []
    for i in range(look.GetNumberOfWaves()):
        wave = [0.0] * 5
        look.GetWave(i, wave)
        waves.append(tuple(round(part, 9) for part in wave))
    return waves


def of_waves():
    made = vtkWaterProperty()
    for wave in WAVES:
        made.AddWave(*wave)
    return made


def test_a_wave_can_be_set_and_removed():
    """SetWave changes one wave, and RemoveWave takes one away and keeps the order of the others."""
    look = of_waves()
    before = look.GetMTime()
    wt.check_equal("set", look.SetWave(1, 0.05, 5.0, 15.0), True)
    wt.check_equal("waves", waves_of(look), [WAVES[0], (0.05, 5.0, 15.0, 0.0, 0.0), WAVES[2]])
    wt.check_equal("modified by setting", look.GetMTime() > before, True)
    before = look.GetMTime()
    wt.check_equal("removed", look.RemoveWave(0), True)
    wt.check_equal("waves that are left", waves_of(look), [(0.05, 5.0, 15.0, 0.0, 0.0), WAVES[2]])
    wt.check_equal("modified by removing", look.GetMTime() > before, True)


WRONG_WAVES = [
    ("the number must lie in [0, 2]", lambda look: look.SetWave(3, 0.1, 1.0)),
    ("Wave -1 cannot be set", lambda look: look.SetWave(-1, 0.1, 1.0)),
    ("Wave 3 cannot be removed", lambda look: look.RemoveWave(3)),
    ("Wave -1 cannot be removed", lambda look: look.RemoveWave(-1)),
    ("The wave stays as it was", lambda look: look.SetWave(0, -1.0, 1.0)),
    ("Steepness 1", lambda look: look.SetWave(0, 5.0, 1.0, 0.0, 0.0, 1.0)),
]


@pytest.mark.parametrize("words, call", WRONG_WAVES, ids=[re.sub(r"\W+", "_", words) for words, _ in WRONG_WAVES])
def test_a_wrong_wave_is_refused(words, call):
    """A number that no wave has, and numbers that no wave can have, are refused with an error; the waves stay."""
    look = of_waves()
    done, said = said_by(look, call)
    wt.check_equal(f"returned; said: {said}", (done, words in said, waves_of(look)), (False, True, list(WAVES)))


def test_water_without_waves_has_none_to_remove():
    """Without waves the error says that there are none."""
    done, said = said_by(vtkWaterProperty(), lambda look: look.RemoveWave(0))
    wt.check_equal(f"returned; said: {said}", (done, "there are no waves" in said), (False, True))


@pytest.mark.parametrize("name", PRESETS)
def test_a_preset_is_told_until_something_of_it_is_changed(name):
    """GetPreset tells the last preset, until something that it sets is changed by hand; what it leaves alone may
    change."""
    look = vtkWaterProperty()
    wt.check_equal("of the default", look.GetPreset(), None)
    look.SetPreset(name)
    look.SetOpacity(0.5)
    look.SetFoamDepth(0.25)
    wt.check_equal("the preset", look.GetPreset(), name)
    of_it = [
        "ReflectanceMode",
        "Reflectance",
        "IndexOfRefraction",
        "Refraction",
        "Absorption",
        "Scattering",
        "DeepColor",
        "Depth",
        "Sea",
    ]
    if look.GetSea():
        of_it += ["SeaModel", "WindSpeed", "WindDirection", "Fetch", "PeakEnhancement", "SeaTileLength"]
    for setting in of_it:
        look.SetPreset(name)
        if setting == "WindSpeed":
            look.SetWindSpeed(7.25)  # twice that of a preset is another preset
        elif value_of(look, setting) == float("inf"):
            getattr(look, f"Set{setting}")(50.0)
        else:
            change(look, setting)
        wt.check_equal(f"after another {setting}", look.GetPreset(), None)
    look.SetPreset(name)
    look.AddWave(0.01, 1.0)
    wt.check_equal("after another wave", look.GetPreset(), None)


@pytest.mark.parametrize("name", TYPES)
def test_a_water_type_is_told_until_its_medium_is_changed(name):
    """GetWaterType tells the type whose absorption and scattering the water has."""
    look = vtkWaterProperty()
    wt.check_equal("of the default", look.GetWaterType(), None)
    look.SetWaterType(name)
    wt.check_equal("the type", look.GetWaterType(), name)
    look.SetDeepColor(0.1, 0.2, 0.3)
    wt.check_equal("the type, in another colour", look.GetWaterType(), name)
    for setting in ("Absorption", "Scattering"):
        look.SetWaterType(name)
        change(look, setting)
        wt.check_equal(f"after another {setting}", look.GetWaterType(), None)


def test_water_that_is_made_into_another_preset_is_told_as_that():
    """GetPreset goes by what the water is, however that was set."""
    look = vtkWaterProperty()
    look.SetPreset("ocean wind 5")
    look.SetWindSpeed(10.0)
    wt.check_equal("ocean wind 5, with 10 m/s", look.GetPreset(), "ocean wind 10")


def test_a_preset_with_particles_of_its_own_has_no_water_type():
    """Water of a preset that adds particles to a water type is no longer of that type, nor of the one before it."""
    look = vtkWaterProperty()
    look.SetWaterType("IA")
    look.SetPreset("ocean wind 5")
    wt.check_equal("ocean wind 5", look.GetWaterType(), None)


@pytest.mark.skipif(VTK_VERSION < (9, 4), reason="VTK 9.4 was the first with properties in snake_case")
@pytest.mark.parametrize("name", settings())
def test_every_setting_is_a_property_in_snake_case(name):
    """With VTK 9.4 and later every setting is an attribute that is read and written."""
    if name == "SlopeVariance":
        pytest.skip("its getter fills a list")
    look, wanted = vtkWaterProperty(), vtkWaterProperty()
    change(wanted, name)
    snake = re.sub(r"(?<=[a-z])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()
    setattr(look, snake, value_of(wanted, name))
    wt.check_equal(f"look.{snake}", (getattr(look, snake), value_of(look, name)), (value_of(wanted, name),) * 2)


@pytest.mark.skipif(VTK_VERSION < (9, 4), reason="VTK 9.4 was the first with properties in snake_case")
def test_a_wind_is_set_by_an_attribute():
    """The wind of an actor's look is an attribute of an attribute."""
    water = vtkWaterActor()
    water.water_property.wind_speed = 7
    wt.check_equal("wind", water.GetWaterProperty().GetWindSpeed(), 7.0)

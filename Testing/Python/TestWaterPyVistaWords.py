# SPDX-License-Identifier: BSD-3-Clause
"""add_water says in one call what the water looks like: each word arrives at the setting that it names, is checked,
and contradicts no other. A surface says its level, water may be added before the scene, and a slider moves it.
"""

import re
import warnings

import numpy as np
import pytest
import water_test as wt

try:
    import pyvista as pv
    import pyvista.examples
except ImportError as error:
    reason = f"{error}; Testing/Python/requirements.txt says what to install"
    print(f"skipped: {reason}")
    pytest.skip(reason, allow_module_level=True)
import vtkwater.pyvista
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkwater import vtkWaterActor, vtkWaterProperty
from vtkwater.words import QUALITIES

SIZE = (200, 150)
BOUNDS = (-4, 4, -4, 4)


@pytest.fixture
def plotter():
    made = pv.Plotter(off_screen=True, window_size=SIZE)
    yield made
    made.close()


def sliders_of(plotter):
    return getattr(plotter, "widgets", plotter).slider_widgets  # PyVista before 0.49: the plotter's own


def picture_of(plotter):
    plotter.render()
    return plotter.screenshot(None, return_img=True).astype(int)


def rays_of(look):
    return (look.GetRayTraceSteps(), look.GetRayTraceProbes(), look.GetRayTraceRays(), look.GetRayTraceLayers(),
            look.GetRayTraceFootprint())


def rays_of_quality(name):
    look = vtkWaterProperty()
    look.SetRayTraceQuality(name)
    return rays_of(look)


def sea_of(look):
    return look.GetSea(), look.GetWindSpeed(), look.GetWindDirection(), look.GetNumberOfWaves()


ARRIVES = {  # the words, what is asked of the look, the answer
    "wind": ({"wind": 7.5}, sea_of, (True, 7.5, 0.0, 0)),
    "wind from somewhere": ({"wind": (7.5, 40)}, sea_of, (True, 7.5, 40.0, 0)),
    "wind in place of a preset's ripples": ({"preset": "pool", "wind": 3}, sea_of, (True, 3.0, 0.0, 0)),
    "no wind": ({"preset": "lake", "wind": 0}, sea_of, (False, 3.0, 0.0, 0)),
    "an array's wind": ({"wind": np.array([6.0, 10.0])}, sea_of, (True, 6.0, 10.0, 0)),
    "whitecaps": (
        {"wind": 9, "whitecaps": True},
        lambda look: (look.GetWhitecaps(), look.GetWhitecapLifeTime()),
        (True, 3.5),
    ),
    "whitecaps of a life time": (
        {"wind": 9, "whitecaps": np.float32(0)},
        lambda look: (look.GetWhitecaps(), look.GetWhitecapLifeTime()),
        (True, 0.0),
    ),
    "no whitecaps": ({"whitecaps": False}, vtkWaterProperty.GetWhitecaps, False),
    "refraction": ({"refraction": True}, vtkWaterProperty.GetRefraction, True),
    "no refraction": ({"preset": "lake", "refraction": False}, vtkWaterProperty.GetRefraction, False),
    "an own view": (
        {"own_view": True, "color": "navy"},
        lambda look: (look.GetRefractionSourceAsString(), look.GetRefraction()),
        ("OWN_VIEW", True),
    ),
    "no own view": ({"own_view": np.False_}, vtkWaterProperty.GetRefractionSourceAsString, "PICTURE"),
    "refraction of a preset": ({"preset": "lake"}, vtkWaterProperty.GetRefraction, True),
    "units of numpy's wind": ({"wind": np.float32(6)}, vtkWaterProperty.GetMetresPerUnit, 0.0),
    "units of numpy's waves": ({"waves": np.int64(6)}, vtkWaterProperty.GetMetresPerUnit, 0.0),
    "numpy's refraction": ({"refraction": np.True_, "preset": "lake"}, vtkWaterProperty.GetRefraction, True),
    "foam": ({"foam": 0.5}, lambda look: (look.GetFoamDepth(), look.GetFoamFitsScene()), (0.5, False)),
    "foam of the usual depth": (
        {"foam": np.True_},
        lambda look: (look.GetFoamDepth(), look.GetFoamFitsScene(), look.GetRefraction()),
        (0.25, True, True),
    ),
    "no foam": ({"foam": False}, lambda look: (look.GetFoamDepth(), look.GetRefraction()), (0.0, True)),
    "caustics": ({"caustics": 0.3, "wind": 3}, lambda look: (look.GetCaustics(), look.GetRefraction()), (0.3, True)),
    "light shafts": (
        {"light_shafts": True, "preset": "lake"},
        lambda look: (look.GetLightShafts(), look.GetRefraction()),
        (1.0, True),
    ),
    "few light shafts": (
        {"light_shafts": 0.25, "preset": "lake"},
        lambda look: (look.GetLightShafts(), look.GetRefraction()),
        (0.25, True),
    ),
    "dome port": (
        {"dome_port": 0.3, "preset": "lake"},
        lambda look: (look.GetDomePortRadius(), look.GetRefraction()),
        (0.3, True),
    ),
    "no dome port": (
        {"dome_port": 0, "refraction": False},
        lambda look: (look.GetDomePortRadius(), look.GetRefraction()),
        (0.0, False),
    ),
    "shadows": ({"shadows": True}, vtkWaterProperty.GetShadows, True),
    "no shadows": ({"shadows": np.False_}, vtkWaterProperty.GetShadows, False),
    "caustics of the usual strength": ({"caustics": True, "preset": "pool"}, vtkWaterProperty.GetCaustics, 0.8),
    "no caustics": (
        {"caustics": 0, "refraction": False},
        lambda look: (look.GetCaustics(), look.GetRefraction()),
        (0.0, False),
    ),
    **{f"quality {name}": ({"quality": name}, rays_of, rays_of_quality(name)) for name in QUALITIES},
    "units": ({"units": "km"}, vtkWaterProperty.GetMetresPerUnit, 1000.0),
    "no units": ({}, vtkWaterProperty.GetMetresPerUnit, 0.0),
    "refraction by default": ({}, vtkWaterProperty.GetRefraction, True),
    "all of them": (
        {"preset": "clear tropical", "wind": (5, 20), "foam": 0.4, "caustics": 0.6, "quality": "high"},
        lambda look: (sea_of(look), look.GetFoamDepth(), look.GetCaustics(), rays_of(look)),
        ((True, 5.0, 20.0, 0), 0.4, 0.6, rays_of_quality("high")),
    ),
}


@pytest.mark.parametrize("name", ARRIVES, ids=lambda name: re.sub(r"\W+", "_", name))
def test_a_word_arrives(name, plotter):
    """A word of add_water sets what it names."""
    words, ask, wanted = ARRIVES[name]
    wt.check_equal(str(words), ask(plotter.add_water(**words).GetWaterProperty()), wanted)


def test_a_color_wins_over_a_presets(plotter):
    """A colour that is given is the look's own, whatever the actor's property has."""
    water = plotter.add_water(preset="lake", color="navy")
    wt.check_equal("color", np.round(np.multiply(255, water.GetWaterProperty().GetDeepColor())).tolist(), [0, 0, 128])


WRONG = [  # the exception, parts of its text, the words
    (TypeError, ("wind must be a number", "str"), {"wind": "strong"}),
    (TypeError, ("wind must be a number", "bool"), {"wind": True}),
    (TypeError, ("wind[1] must be a number", "str"), {"wind": (3.0, "east")}),
    (ValueError, ("wind is 200", "[0.1, 100] m/s"), {"wind": 200}),
    (ValueError, ("wind is nan", "[0.1, 100] m/s"), {"wind": float("nan")}),
    (ValueError, ("wind is -3", "[0.1, 100] m/s"), {"wind": (-3, 0)}),
    (ValueError, ("wind is (3, 0, 0); it must have 2 numbers, not 3",), {"wind": (3, 0, 0)}),
    (ValueError, ("wind[1] is inf", "finite"), {"wind": (3, float("inf"))}),
    (ValueError, ("waves and wind", "wind is 3"), {"wind": 3, "waves": [(0.1, 2.0)]}),
    (TypeError, ("refraction must be bool", "int"), {"refraction": 1}),
    (TypeError, ("own_view must be bool", "str"), {"own_view": "yes"}),
    (ValueError, ("own_view is True", "refraction is False"), {"own_view": True, "refraction": False}),
    (TypeError, ("shadows must be bool", "str"), {"shadows": "soft"}),
    (TypeError, ("whitecaps must be a number", "str"), {"whitecaps": "many", "wind": 9}),
    (ValueError, ("whitecaps is 11", "[0, 10]"), {"whitecaps": 11, "wind": 9}),
    (ValueError, ("whitecaps is True", "no wind sea"), {"whitecaps": True}),
    (TypeError, ("foam must be a number", "str"), {"foam": "much"}),
    (ValueError, ("foam is -1", "not negative"), {"foam": -1}),
    (ValueError, ("foam is inf", "finite"), {"foam": float("inf")}),
    (ValueError, ("light_shafts is 2", "[0, 1]"), {"light_shafts": 2, "preset": "lake"}),
    (ValueError, ("light_shafts is True", "calm"), {"light_shafts": True}),
    (ValueError, ("light_shafts is 1", "refraction is False"), {"light_shafts": 1, "preset": "lake", "refraction": False}),
    (TypeError, ("dome_port must be a number", "bool"), {"dome_port": True}),
    (ValueError, ("dome_port is -0.3", "finite and not negative"), {"dome_port": -0.3}),
    (ValueError, ("dome_port is inf", "finite"), {"dome_port": float("inf")}),
    (ValueError, ("dome_port is 0.3", "refraction is False"), {"dome_port": 0.3, "refraction": False}),
    (TypeError, ("caustics must be a number", "str"), {"caustics": "bright"}),
    (ValueError, ("caustics is 1.5", "[0, 1]"), {"caustics": 1.5, "wind": 3}),
    (TypeError, ("sun must be a bool", "str"), {"sun": "noon"}),
    (TypeError, ("sun must be a bool", "float"), {"sun": 0.5}),
    (TypeError, ("sun[0] must be a number", "str"), {"sun": ("south", 30)}),
    (ValueError, ("sun is (0, 0, 1); it must have 2 numbers, not 3",), {"sun": (0, 0, 1)}),
    (ValueError, ("sun[0], the azimuth, is 400", "[-360, 360]"), {"sun": (400, 30)}),
    (ValueError, ("sun[1], the elevation, is 100", "[0, 90]"), {"sun": (0, 100)}),
    (ValueError, ("sun[1], the elevation, is -5", "[0, 90]"), {"sun": (0, -5)}),
    (TypeError, ("quality must be str", "int"), {"quality": 2}),
    (ValueError, ("quality is 'ultra'", "fast, default, high, reference"), {"quality": "ultra"}),
    (ValueError, ("units are 'furlong'", "um, mm, cm"), {"units": "furlong"}),
    (ValueError, ("units is 0", "[1e-09, 1e+09]"), {"units": 0}),
    (ValueError, ("units is -1", "[1e-09, 1e+09]"), {"units": -1}),
    (TypeError, ("units must be a number", "list"), {"units": [1]}),
    (ValueError, ("foam is True", "refraction is False"), {"foam": True, "refraction": False}),
    (ValueError, ("caustics is 0.5", "refraction is False"), {"caustics": 0.5, "wind": 3, "refraction": False}),
    (ValueError, ("caustics is 0.5", "calm"), {"caustics": 0.5}),
    (ValueError, ("caustics is 0.5", "calm"), {"caustics": 0.5, "preset": "lake", "wind": 0}),
    (ValueError, ("refraction is True", "opacity is 0.5"), {"refraction": True, "opacity": 0.5}),
    (ValueError, ("foam is 0.5", "opacity is 0.25"), {"foam": 0.5, "opacity": 0.25}),
    (ValueError, ("foam is True", "'mirror floor'"), {"foam": True, "preset": "mirror floor"}),
    (ValueError, ("refraction is True", "'mirror floor'"), {"refraction": True, "preset": "mirror floor"}),
    (TypeError, ("hulls must be a sequence", "PolyData"), {"hulls": pv.Cube()}),
    (TypeError, ("hulls[1] must be a pyvista.DataSet or an actor", "float"), {"hulls": [pv.Cube(), 2.0]}),
    (ValueError, ("hulls[0] has no cells",), {"hulls": [pv.PolyData()]}),
]


@pytest.mark.parametrize(
    "kind, texts, words", WRONG, ids=[re.sub(r"\W+", "_", texts[0] + str(list(words))) for _, texts, words in WRONG]
)
def test_a_wrong_word_raises_and_adds_nothing(kind, texts, words, plotter):
    """A wrong word, or two that contradict each other, raise an error that names word, value and what is accepted;
    neither water nor a light is added."""
    lights, raised = len(plotter.renderer.lights), None
    try:
        plotter.add_water(**words)
    except (TypeError, ValueError) as error:
        raised = error
    wt.check_equal(
        f"{words}: {raised}", (type(raised), [text for text in texts if text not in str(raised)]), (kind, [])
    )
    wt.check_equal(
        "waters, more lights",
        (
            len([actor for actor in plotter.actors.values() if isinstance(actor, vtkWaterActor)]),
            len(plotter.renderer.lights) - lights,
        ),
        (0, 0),
    )


def suns_of(plotter):
    return [light for light in plotter.renderer.lights if isinstance(light, vtkwater.pyvista.Sun)]


@pytest.mark.parametrize(
    "words, wanted",
    [
        ({"sun": (0, 0)}, (0, 1, 0)),
        ({"sun": (90, 0)}, (1, 0, 0)),
        ({"sun": (0, 90)}, (0, 0, 1)),
        (
            {"sun": True},
            (
                np.sin(np.radians(150)) * np.cos(np.radians(35)),
                np.cos(np.radians(150)) * np.cos(np.radians(35)),
                np.sin(np.radians(35)),
            ),
        ),
        ({"sun": (0, 90), "normal": "y"}, (0, 1, 0)),
        ({"sun": (90, 0), "normal": "y"}, (1, 0, 0)),
        ({"sun": (0, 0), "normal": "y"}, (0, 0, -1)),
        ({"sun": (45, 90), "normal": "-x"}, (-1, 0, 0)),
    ],
    ids=lambda value: re.sub(r"\W+", "_", str(value))[:40],
)
def test_the_sun_stands_where_it_is_said(words, wanted, plotter):
    """The sun is a scene light in the direction of its azimuth and elevation, in the water's own axes."""
    plotter.add_water(**words)
    (sun,) = suns_of(plotter)
    way = np.subtract(sun.position, sun.focal_point)
    wt.check_at_most(f"{words}: error of its direction", float(np.abs(way - wanted).max()), 1e-12)
    wt.check_equal("a scene light, far away", (sun.is_scene_light, sun.positional), (True, False))


def test_a_subplot_has_one_sun(plotter):
    """Another sun takes the place of the first; without the word there is none; it stays when the water goes."""
    plotter.add_water(1.0)
    plotter.add_water(1.0, sun=False)
    wt.check_equal("suns without the word", len(suns_of(plotter)), 0)
    plotter.add_water(1.0, sun=True, name="lake")
    water = plotter.add_water(1.0, sun=(90, 0), name="lake")
    wt.check_equal("suns", [np.round(sun.position, 9).tolist() for sun in suns_of(plotter)], [[1.0, 0.0, 0.0]])
    plotter.remove_actor(water)
    wt.check_equal("suns without water", len(suns_of(plotter)), 1)


def test_the_sun_glitters():
    """Before the sun waves glitter, and no longer with a sun behind the eye."""
    bright = []
    for sun in ((0, 20), (180, 20)):
        plotter = pv.Plotter(off_screen=True, window_size=SIZE, lighting="none")
        plotter.set_background("gray")
        plotter.camera_position = [(0.0, -5.0, 1.5), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)]
        plotter.add_water(wind=6, sun=sun, bounds=BOUNDS)
        bright.append(int((picture_of(plotter).min(axis=2) > 200).sum()))
        plotter.close()
    wt.check_at_least("bright pixels before the sun", bright[0], 1000)
    wt.check_at_most("bright pixels with the sun behind the eye", bright[1], 10)


def tilted(height, amplitude=0.0):
    """A surface of 40 x 40 with waves, whose mean height is given."""
    x, y = np.meshgrid(np.linspace(-20, 20, 81), np.linspace(-20, 20, 81))
    return pv.StructuredGrid(x, y, height + amplitude * np.sin(np.pi * x / 10))


@pytest.mark.parametrize(
    "words, level",
    [
        ({"surface": tilted(3.0)}, 3.0),
        ({"surface": tilted(3.0, 0.5)}, 3.0),
        ({"surface": tilted(3.0), "level": 3.2}, 3.2),
        ({"surface": tilted(-2.0, 0.2), "origin": (0, 0, 5)}, -2.0),
        ({}, 0.0),
        ({"origin": (0, 0, 5)}, 5.0),
        ({"surface": pv.Disc(outer=3.0)}, 0.0),
    ],
    ids=lambda value: None,
)
def test_a_surface_says_its_level(words, level, plotter):
    """Without a level it is the surface's mean height, 0 without a surface; one that is near the surface's is
    taken."""
    water = plotter.add_water(**words)
    wt.check_at_most("error of the level", abs(water.GetLevel() - level), 1e-6)


def test_a_surface_of_a_tilted_plane_says_its_level(plotter):
    """The mean height of a surface counts along the normal, in the data of a scaled scene, too."""
    plotter.set_scale(zscale=2.0)
    square = pv.Plane(center=(0, 3, 0), direction=(0, 1, 0), i_size=4, j_size=4)
    water = plotter.add_water(surface=square, normal="y")
    wt.check_at_most("y of the plane, less 3", abs(water.GetPlane().GetOrigin()[1] - 3.0), 1e-6)
    placement = [0.0] * 4
    water.GetMeshPlacement(placement)
    wt.check_at_most("in the scaled scene: height, angle", max(abs(placement[0]), placement[2]), 1e-4)


@pytest.mark.parametrize("level, accepted", ((3.5, True), (3.65, False), (2.35, False), (0.0, False)))
def test_a_level_off_the_surface_is_refused(level, accepted, plotter):
    """A level and a surface that are more than 1 % of its diagonal (0.57) apart are refused; both are named."""
    try:
        plotter.add_water(level, surface=tilted(3.0))
        said = ""
    except ValueError as error:
        said = str(error)
    wt.check_equal(f"said: {said}", (f"level is {level:g}" in said, "surface along the normal is 3;" in said),
                   (not accepted, not accepted))


def test_water_may_be_added_before_the_scene():
    """Water in an empty plotter is silent, and the picture is that of water that was added last."""
    shown, listener = vtkOutputWindow.GetInstance(), vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(listener)
    pictures = []
    try:
        for is_first in (True, False):
            plotter = pv.Plotter(off_screen=True, window_size=SIZE)
            if is_first:
                plotter.add_water(-0.2)
            plotter.add_mesh(pv.Cone(direction=(0, 0, 1)))
            plotter.add_mesh(pv.Cube(center=(3, 1, 0)), color="red")
            if not is_first:
                plotter.add_water(-0.2)
            pictures.append(picture_of(plotter))
            plotter.close()
    finally:
        vtkOutputWindow.SetInstance(shown)
    wt.check_equal("said", listener.GetOutput(), "")
    wt.check_equal("difference", wt.difference(*pictures), 0)


def test_water_may_be_added_to_an_empty_window():
    """Water that is added to a window which is open and empty is silent, and is there when a mesh is."""
    shown, listener = vtkOutputWindow.GetInstance(), vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(listener)
    try:
        plotter = pv.Plotter(off_screen=True, window_size=SIZE)
        plotter.show(auto_close=False)
        water = plotter.add_water(-0.2)
        plotter.render()
        alone = water.GetSheetToHorizon()
        plotter.add_mesh(pv.Cone(direction=(0, 0, 1)))
        plotter.render()
        renders = water.GetReflectionPass().GetNumberOfReflectionRenders()
        plotter.close()
    finally:
        vtkOutputWindow.SetInstance(shown)
    wt.check_equal("said; is reflecting", (listener.GetOutput(), renders > 0), ("", True))
    wt.check_equal("alone it is open water", alone, True)


LEVELS = [  # height of the land, level, what the warning says
    (5.0, 0.0, "below the whole scene: the land hides the water; heights in the scene lie in [5, 5.55]"),
    (5.0, 5.2, ""),
    (-5.0, 0.0, "far above the whole scene: the water hides it; heights in the scene lie in [-5, -4.45]"),
    (-5.0, -3.5, ""),  # less than the diagonal over the land
]


@pytest.mark.parametrize("normal, scale", (("z", 1.0), ((0, 0, 3), 1.0), ("z", 2.0)))
@pytest.mark.parametrize("height, level, said", LEVELS)
def test_a_level_far_off_the_land_is_told(height, level, said, normal, scale, plotter):
    """Once, with the heights of the scene in its own coordinates, over the origin."""
    plotter.set_scale(zscale=scale)
    plotter.add_mesh(pv.Plane(center=(0, 0, height)))
    plotter.add_mesh(pv.Cone(center=(0, 0, height + 0.3), direction=(0, 0, 1), height=0.5))
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        plotter.add_water(level - 1.0, normal=normal, origin=(0, 0, 1))
    texts = [str(warning.message) for warning in told if issubclass(warning.category, UserWarning)]
    low, high = height - 1.0, height - 1.0 + 0.55
    said = said.replace("[5, 5.55]", f"[{low:g}, {high:g}]").replace("[-5, -4.45]", f"[{low:g}, {high:g}]")
    wt.check_equal("number of warnings", len(texts), 1 if said else 0)
    wt.check_equal(f"{texts} says it", all(f"level is {level - 1.0:g}, which is {said}" in text for text in texts), True)


@pytest.mark.parametrize("has_light, sun, suns", [
    (False, None, 1), (True, None, 0), (False, False, 0), (True, True, 1), (False, (90, 20), 1)])
@pytest.mark.parametrize("word", ("caustics", "shadows"))
def test_light_effects_have_a_sun(word, has_light, sun, suns, plotter):
    """Where the subplot has no scene light, and none is refused."""
    if has_light:
        plotter.add_light(pv.Light(position=(1, 0, 1), light_type="scene light"))
    plotter.add_water(-0.2, wind=3, sun=sun, **{word: True})
    wt.check_equal("suns", sum(isinstance(light, vtkwater.pyvista.Sun) for light in plotter.renderer.lights), suns)


def lake(plotter, **words):
    plotter.add_mesh(pv.Cube(center=(0, 0, 0.6)), color="red")
    return plotter.add_water(**{"level": -0.1, "bounds": BOUNDS, **words})


def slide(slider, value):
    """As a user does who drags the slider to a value."""
    slider.GetRepresentation().SetValue(value)
    slider.InvokeEvent("StartInteractionEvent")
    slider.InvokeEvent("InteractionEvent")
    slider.InvokeEvent("EndInteractionEvent")


def test_a_slider_moves_the_level(plotter):
    """The slider begins at the water's level, moves it, and tells each level once; the picture follows."""
    water, told = lake(plotter), []
    slider = plotter.add_water_level_slider(water, (-0.5, 0.5), callback=told.append)
    representation = slider.GetRepresentation()
    wt.check_equal("ends, value, title", (representation.GetMinimumValue(), representation.GetMaximumValue(),
                                          round(representation.GetValue(), 9), representation.GetTitleText()),
                   (-0.5, 0.5, -0.1, "water level"))
    wt.check_equal("told before it is dragged, kept", (told, slider in sliders_of(plotter)), ([], True))
    before = picture_of(plotter)
    slide(slider, 0.3)
    wt.check_at_most("level, less 0.3", abs(water.GetLevel() - 0.3), 1e-12)
    wt.check_equal("told", told, [0.3])
    wt.check_at_least("pixels that change", int((np.abs(picture_of(plotter) - before).max(axis=2) > 20).sum()), 500)


def test_a_slider_has_the_range_of_the_scene(plotter):
    """Without ends the slider has those of the scene along the water's normal."""
    representation = plotter.add_water_level_slider(lake(plotter)).GetRepresentation()
    wt.check_at_most("ends: error", max(abs(representation.GetMinimumValue() + 0.1),
                                        abs(representation.GetMaximumValue() - 1.1)), 1e-6)


def test_a_slider_moves_a_surface_along_the_normal(plotter):
    """In a scaled scene with another up, the slider moves plane and surface along the normal, in the data's unit."""
    plotter.set_scale(yscale=2.0)
    square = pv.Plane(center=(0, 1, 0), direction=(0, 1, 0), i_size=4, j_size=4)
    plotter.add_mesh(pv.Cube(center=(0, 1, 0)))
    water = plotter.add_water(surface=square, normal="y")
    slider = plotter.add_water_level_slider(water, (0.0, 5.0), title="sea", pointa=(0.1, 0.1), pointb=(0.4, 0.1))
    wt.check_equal(
        "value, title",
        (round(slider.GetRepresentation().GetValue(), 6), slider.GetRepresentation().GetTitleText()),
        (1.0, "sea"),
    )
    slide(slider, 2.5)
    wt.check_at_most("y of the plane, less 5", abs(water.GetPlane().GetOrigin()[1] - 5.0), 1e-6)
    wt.check_at_most("y of the surface, less 5", abs(water.GetBounds()[2] - 5.0), 1e-6)


def test_a_slider_counts_from_an_origin(plotter):
    """The level of a slider counts from the origin that the water's does."""
    water = lake(plotter, level=1.0, origin=(0, 0, 10))
    slider = plotter.add_water_level_slider(water, (0, 3), origin=(0, 0, 10))
    slide(slider, 2.0)
    wt.check_at_most("z, less 12", abs(water.GetLevel() - 12.0), 1e-12)


WRONG_SLIDERS = [
    (
        TypeError,
        "water must be a vtkWaterActor, not str",
        lambda plotter, water: plotter.add_water_level_slider("lake"),
    ),
    (TypeError, "rng must be a sequence of numbers", lambda plotter, water: plotter.add_water_level_slider(water, 3)),
    (ValueError, "rng is (3,); it must have 2 numbers, not 1",
     lambda plotter, water: plotter.add_water_level_slider(water, (3,))),
    (ValueError, "low 1.0 and high 2.0", lambda plotter, water: plotter.add_water_level_slider(water, (1, 2))),
    (ValueError, "low 1.0 and high -1.0", lambda plotter, water: plotter.add_water_level_slider(water, (1, -1))),
    (ValueError, "high inf", lambda plotter, water: plotter.add_water_level_slider(water, (-1, float("inf")))),
    (
        ValueError,
        "origin is (1, 2); it must have 3 numbers",
        lambda plotter, water: plotter.add_water_level_slider(water, origin=(1, 2)),
    ),
]


@pytest.mark.parametrize(
    "kind, text, call", WRONG_SLIDERS, ids=[re.sub(r"\W+", "_", text) for _, text, _ in WRONG_SLIDERS]
)
def test_a_wrong_slider_raises(kind, text, call, plotter):
    """What is no water, and ends that are none or do not have the level, raise an error that names them."""
    water, raised = lake(plotter), None
    try:
        call(plotter, water)
    except (TypeError, ValueError) as error:
        raised = error
    wt.check_equal(f"{raised}", (type(raised), text in str(raised), len(sliders_of(plotter))), (kind, True, 0))


def test_bounds_by_default_follow_the_scene(plotter):
    """Without bounds the sheet ends with a terrain, and reaches to the horizon around what stands in the water."""
    plotter.add_mesh(pv.ParametricTorus())
    water = plotter.add_water()
    plotter.render()
    wt.check_equal("around a torus: to the horizon", (water.GetSheetIsAutomatic(), water.GetSheetToHorizon()), (True, True))
    plotter.clear()
    plotter.add_mesh(pv.examples.load_random_hills())
    water = plotter.add_water(level=2)
    plotter.render()
    wt.check_equal("on hills: to the horizon", water.GetSheetToHorizon(), False)
    water = plotter.add_water(level=2, bounds="scene")
    wt.check_equal("bounds='scene': automatic", water.GetSheetIsAutomatic(), False)


def test_open_water_keeps_the_clipping_range(plotter):
    plotter.add_mesh(pv.Sphere())
    plotter.camera.position = (0, -8, 1)
    plotter.camera.clipping_range = (7, 9)
    plotter.add_water()
    wt.check_equal("clipping range", plotter.camera.clipping_range, (7.0, 9.0))


def test_a_clear_sky_is_seen_in_the_water_and_lights_it(plotter):
    """add_clear_sky shows a skybox, which the water reflects, moves the one sun, and takes the place of the last sky."""
    plotter.add_water(bounds=BOUNDS, sun=True)
    dull = picture_of(plotter)
    first = plotter.add_clear_sky(sun=(90, 30), turbidity=2.5)
    plotter.camera_position = [(0, -9, 3), (0, 0, 12), (0, 0, 1)]
    wt.check("a skybox is returned", type(first).__name__, "vtkSkybox", first.IsA("vtkSkybox"))
    suns = [light for light in plotter.renderer.lights if isinstance(light, vtkwater.pyvista.Sun)]
    wt.check_equal("suns", len(suns), 1)
    wt.check_at_least("the sun is in the east", suns[0].position[0], 0.8)
    blue = picture_of(plotter)[:30].mean(axis=(0, 1))
    wt.check("the sky high over the horizon is blue", blue.round(1), "blue > red", blue[2] > blue[0])
    second = plotter.add_clear_sky(sun=(90, 30), turbidity=9)
    skies = [actor for actor in plotter.renderer.actors.values() if actor.IsA("vtkSkybox")]
    wt.check_equal("skies", skies == [second], True)
    wt.check("it is another picture", dull.shape, "differs", (picture_of(plotter) != dull).any())


@pytest.mark.parametrize("words, error, parts", [
    ({"sun": (90, -5)}, ValueError, ("sun", "-5", "[0, 90]", "elevation")),
    ({"sun": (400, 5)}, ValueError, ("sun", "400", "[-360, 360]", "azimuth")),
    ({"sun": False}, ValueError, ("sun", "False")),
    ({"sun": "noon"}, TypeError, ("sun", "str")),
    ({"turbidity": 1.0}, ValueError, ("turbidity", "1", "[2, 10]")),
    ({"turbidity": "haze"}, TypeError, ("turbidity", "str")),
    ({"resolution": 4}, ValueError, ("Width", "4", "[16, 8192]")),
    ({"resolution": 4.5}, TypeError, ("resolution", "float")),
])
def test_a_sky_that_cannot_be_is_refused(plotter, words, error, parts):
    """A wrong word of a clear sky raises, names it, its value and what is accepted, and nothing is added."""
    with pytest.raises(error) as raised:
        plotter.add_clear_sky(**words)
    for part in parts:
        wt.check_equal(f"{words}: the error says '{part}'", part in str(raised.value), True)
    wt.check_equal(f"{words}: actors", len(plotter.renderer.actors), 0)


def test_a_hull_of_several_blocks_is_an_error(plotter):
    """Composite data would be flooded without a word until the first frame: the argument is named at once."""
    blocks = plotter.add_mesh(pv.MultiBlock([pv.Cube(), pv.Cube(center=(3, 0, 0))]))
    blocks = blocks[0] if isinstance(blocks, tuple) else blocks
    with pytest.raises(TypeError, match=r"hulls\[1\] is an actor of a MultiBlock|hulls\[1\] is an actor of a vtkMulti"):
        plotter.add_water(level=0.0, hulls=[pv.Cube(), blocks])


def test_hulls_are_meshes_and_actors(plotter):
    """A mesh and an actor of the plotter's keep the water out of themselves, also under set_scale."""
    plotter.set_scale(zscale=2.0)
    boat = pv.Cube(x_length=4, y_length=2, z_length=2).extract_cells(range(4)).extract_surface(algorithm=None)
    sides = [boat.translate((x, 0, 0)) for x in (-3, 3)]
    actors = [plotter.add_mesh(side, color="red") for side in sides]
    plotter.camera_position = [(0, -6, 20), (0, 0, 0), (0, 0, 1)]
    water = plotter.add_water(level=0.0, bounds=(-8, 8, -8, 8), color=(0.0, 0.0, 1.0))
    wet = picture_of(plotter)
    plotter.remove_actor(water)
    water = plotter.add_water(level=0.0, bounds=(-8, 8, -8, 8), color=(0.0, 0.0, 1.0), hulls=[sides[0], actors[1]])
    shown = picture_of(plotter)
    changed = np.abs(shown.astype(int) - wet).max(axis=2) > 8
    wt.check_equal("hulls", water.GetNumberOfHulls(), 2)
    wt.check_at_least("pixels of the left one", int(changed[:, :SIZE[0] // 2].sum()), 100)
    wt.check_at_least("pixels of the right one", int(changed[:, SIZE[0] // 2:].sum()), 100)
    wt.check_equal("error", water.GetLastError(), "")


@pytest.mark.parametrize("words, parts", [
    ({"data_opacity": 0.5}, ("data_opacity is 0.5", "color_by is not given")),
    ({"cmap": "viridis"}, ("cmap is 'viridis'", "color_by is not given")),
    ({"clim": (0, 2)}, ("clim is (0, 2)", "color_by is not given")),
    ({"log_scale": True}, ("log_scale is True", "color_by is not given")),
    ({"max_mirrors": 3}, ("max_mirrors is 3", "surface is not given")),
    ({"max_mirrors": 3, "surface": pv.Plane(), "level": 0.0}, ("max_mirrors is 3", "level is a number", "one water")),
])
def test_an_argument_without_effect_is_an_error(plotter, words, parts):
    """It names the argument, its value and the one that is missing; nothing is added."""
    with pytest.raises(ValueError) as raised:
        plotter.add_water(**words)
    for part in parts:
        wt.check_equal(f"{words}: the error says '{part}'", part in str(raised.value), True)
    wt.check_equal(f"{words}: actors", len(plotter.renderer.actors), 0)


@pytest.mark.parametrize("as_lakes", (True, False))
def test_a_surface_far_from_everything_warns(plotter, as_lakes):
    """Beyond the sum of both diagonals, with both places. At that distance and in an empty scene it does not."""
    level = {} if as_lakes else {"level": 0.0}
    lake = pv.Plane(i_size=3, j_size=4)  # the diagonal is 5

    def told(**words):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            plotter.add_water(name="lake", **level, **words)
        return [str(warning.message) for warning in caught if "far" in str(warning.message) or
                "away" in str(warning.message)]

    wt.check_equal("an empty scene", told(surface=lake), [])
    plotter.add_mesh(pv.Plane(i_size=3, j_size=4, center=(0, 0, 0.001)))
    wt.check_equal("a gap of 9.9", told(surface=lake.translate((12.9, 0, 0))), [])
    said = told(surface=lake.translate((13.1, 0, 0)))
    wt.check_equal("warnings", len(said), 1)
    for part in ("surface lies 10.1 away", "x 11.6 to 14.6 and -1.5 to 1.5", "unit"):
        wt.check_equal(f"'{said}' says '{part}'", part in "".join(said), True)


def test_lakes_replaced_by_name_leave_with_their_plotter():
    """Closing the plotter deletes the replaced lakes while its renderer removes its observers; that was a crash."""
    made = pv.Plotter(off_screen=True, window_size=SIZE)
    for x in (0.0, 5.0):
        made.add_water(name="lake", surface=pv.Plane(center=(x, 0, 0)))
    made.close()
    wt.check_equal("the plotter is closed", made.render_window, None)


@pytest.mark.parametrize("amplitude, is_told", ((0.070, False), (0.072, True)))
def test_waves_that_would_break_warn(plotter, amplitude, is_told):
    """Waves break at 0.142 of their length from trough to crest (Michell 1893)."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        plotter.add_water(waves=[(0.01, 2.0), (amplitude, 1.0)], bounds=BOUNDS)
    said = [str(warning.message) for warning in caught]
    wt.check_equal(f"{said}: told", len(said), int(is_told))
    for part in ("waves[1]", f"{amplitude:g}", "0.071") if is_told else ():
        wt.check_equal(f"{said} says '{part}'", part in said[0], True)

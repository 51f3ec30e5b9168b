# SPDX-License-Identifier: BSD-3-Clause
"""The C interface says the look and the light by the words that add_water has; each call does what the classes'
setters do, pixel for pixel, and a bad value is a status that names it."""

import ctypes

import numpy as np
import pytest
import water_test as wt
from TestWaterCInterface import (  # noqa: F401  fixtures
    ANGLE,
    BAD_VALUE,
    BOTTOM,
    LEVEL,
    NULL_ARGUMENT,
    OK,
    UP,
    SmallScene,
    by_c,
    doubles,
    lib,
    made,
    number,
    small,
    view_by_classes,
)
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkLight, vtkPolyDataMapper, vtkTexture
from vtkwater import vtkWaterProperty, vtkWaterReflectionPass

COLOR, SUN_COLOR = (0.2, 0.5, 0.3), (1.0, 0.95, 0.87)
GRAY = (0.7, 0.7, 0.7)
BED = np.array([(-4, -4, -0.9), (4, -4, -0.9), (4, 4, 0.4), (-4, 4, 0.4)], dtype=float)
BED_TRIANGLES = np.array([(0, 1, 2), (0, 2, 3)], dtype=np.int64)
PATCH = np.array([(-2, -2.4, -0.63), (2, -2.4, -0.63), (2, -1.75, -0.524), (-2, -1.75, -0.524)], dtype=float)  # on the bed
RED = (0.9, 0.1, 0.1)
SURFACE = np.array([(-3, -3, LEVEL), (3, -3, LEVEL), (3, 3, LEVEL), (-3, 3, LEVEL)], dtype=float)
FLOW = np.array([(0.4, 0.1, 0.0)] * 4)  # m/s
POINT_VALUES = np.array((0.0, 0.4, 1.5, 2.0))  # of matter, and Froude numbers
UNDER_WATER = ((0, -3.5, LEVEL - 0.4), (0, 3, LEVEL - 0.3))  # an eye and what it looks at
SKY = np.add.outer(3 * np.arange(40), 2 * np.arange(60))[:, :, None] + np.array([0, 60, 100])
SKY = np.ascontiguousarray(SKY % 256, dtype=np.uint8)


def texture():
    image = vtkImageData()
    image.SetDimensions(SKY.shape[1], SKY.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(SKY[::-1]).reshape(-1, 3), deep=True))
    made_of_it = vtkTexture()
    made_of_it.SetInputData(image)
    made_of_it.InterpolateOn()
    made_of_it.MipmapOn()
    return made_of_it


def look_up(view, environment):
    view.renderer.SetEnvironmentUp(0, 0, 1)
    view.renderer.SetEnvironmentRight(1, 0, 0)
    look = environment.GetWaterProperty()
    look.SetEnvironmentTexture(texture())
    look.SetReflectionSourceToEnvironment()


def add_sun(view, _, direction=(0.5, 0.5 * 3**0.5, 0.0), color=SUN_COLOR):
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(direction)
    light.SetFocalPoint(0, 0, 0)
    light.SetColor(color)
    view.renderer.AddLight(light)


def add_lamp(view, _):
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.PositionalOn()
    light.SetConeAngle(180)
    light.SetPosition(2, -2, 3)
    light.SetFocalPoint(0, 0, 0)
    light.SetColor(1, 0.5, 0.5)
    light.SetIntensity(0.75)
    view.renderer.AddLight(light)


def look_call(name, *arguments):
    return lambda view, water: getattr(water.GetWaterProperty(), name)(*arguments)


def exaggerated_foam(view, water):
    clear("SetVerticalExaggeration", 3.0)(view, water)
    water.GetWaterProperty().SetFoamDepth(0.1)


def wave_in_cm(view, water):
    water.GetWaterProperty().AddWave(*WAVE)
    water.GetWaterProperty().SetUnits("cm")


def bed(places=BED):
    """Ground that falls from over the water to 0.8 under it, or another quad."""
    data, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(places, deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(BED_TRIANGLES.ravel(), deep=True))
    data.SetPoints(points)
    data.SetPolys(cells)
    return data


def clear(setter, value):
    def change(view, water):
        wt.add_actor(view.renderer, bed(), GRAY)
        add_sun(view, water, (0.3, -0.5, 0.8), (1, 1, 1))
        look = water.GetWaterProperty()
        look.RefractionOn()
        getattr(look, setter)(value)
        view.renderer.ResetCameraClippingRange()
    return change


def c_clear(function, argument):
    """A bed under clear water, a sun, and then one more call."""
    x, y, z = 0.3, -0.5, 0.8
    azimuth, elevation = np.degrees(np.arctan2(x, y)), np.degrees(np.arctan2(z, np.hypot(x, y)))
    return lambda it: [("vtk_water_scene_add_mesh", it.scene, BED.ctypes, ctypes.c_size_t(4), BED_TRIANGLES.ctypes,
                        ctypes.c_size_t(2), doubles(*GRAY)),
                       ("vtk_water_scene_set_sun", it.scene, number(azimuth), number(elevation), doubles(1, 1, 1)),
                       ("vtk_water_actor_set_refraction", it.water, 1), (function, it.water, argument)]


def patch_beside_the_picture(view, water):
    """A red patch that only refracted rays meet, below the picture's border: the own view shows it."""
    wt.add_actor(view.renderer, bed(PATCH), RED)
    clear("SetRefractionSource", 1)(view, water)


def c_patch_beside_the_picture(it):
    return [("vtk_water_scene_add_mesh", it.scene, PATCH.ctypes, ctypes.c_size_t(4), BED_TRIANGLES.ctypes,
             ctypes.c_size_t(2), doubles(*RED)), *c_clear("vtk_water_actor_set_own_view", 1)(it)]


def by_a_mesh(view, water):
    """A surface smaller than the sheet."""
    data, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(SURFACE, deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(BED_TRIANGLES.ravel(), deep=True))
    data.SetPoints(points)
    data.SetPolys(cells)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    water.SetMapper(mapper)
    view.renderer.ResetCameraClippingRange()
    return data


def by_a_current(view, water):
    array = numpy_to_vtk(FLOW, deep=True)
    array.SetName("velocity")
    by_a_mesh(view, water).GetPointData().AddArray(array)
    water.SetFlowArrayName("velocity")
    water.SetFlowPeriod(2.0)


def by_data(view, water, setter):
    """The mesh over a bed in the sun, with values at its points."""
    clear("SetShoreSoftness", 0.05)(view, water)
    array = numpy_to_vtk(POINT_VALUES, deep=True)
    array.SetName("values")
    by_a_mesh(view, water).GetPointData().AddArray(array)
    setter(water)


def with_matter(water):
    water.SetMatterArrayName("values")
    water.SetMatterAbsorption(0.1, 0.5, 2.0)
    water.SetMatterScattering(0.2, 0.1, 0.0)


def with_foam(water):
    water.SetFoamArrayName("values")
    water.SetFoamMeasureToFroudeNumber()


def c_data(*calls):
    """The same by C's functions, each with its arguments."""
    def all_calls(it):
        return [*c_clear("vtk_water_actor_set_refraction", 1)(it), surface_call(it),
                *[(f"vtk_water_actor_set_{name}", it.water, *arguments) for name, *arguments in calls]]
    return all_calls


def surface_call(it):
    return ("vtk_water_actor_set_surface", it.water, SURFACE.ctypes, ctypes.c_size_t(len(SURFACE)),
            BED_TRIANGLES.ctypes, ctypes.c_size_t(len(BED_TRIANGLES)))


def shafts(view, water):
    """Shafts in turbid water, from an eye in it."""
    clear("SetLightShafts", 1.0)(view, water)
    water.GetWaterProperty().SetWaterType("9C")
    camera = view.renderer.GetActiveCamera()
    camera.SetPosition(UNDER_WATER[0])
    camera.SetFocalPoint(UNDER_WATER[1])
    view.renderer.ResetCameraClippingRange()


def c_under_water(function, argument):
    def calls(it):
        *before, last = c_clear(function, argument)(it)
        return [*before, ("vtk_water_actor_set_water_type", it.water, b"9C"),
                ("vtk_water_scene_set_camera", it.scene, *map(lambda place: doubles(*place), UNDER_WATER),
                 doubles(*UP), number(ANGLE)), last]
    return calls


def in_foam(view, water):
    """Foam all over a bed, a low sun, and shadows."""
    clear("SetFoamDepth", 3.0)(view, water)
    water.GetWaterProperty().ShadowsOn()


def white_sea(view, water):
    """A storm, of which foam is left for a while."""
    look = water.GetWaterProperty()
    look.SetWindSpeed(25.0)
    look.SeaOn()
    look.WhitecapsOn()
    look.SetWhitecapLifeTime(2.0)


# name, calls for a CScene, the same by the classes; how many levels the two may differ by
CALLS = {
    "color": (
        lambda it: [("vtk_water_actor_set_color", it.water, doubles(*COLOR))],
        look_call("SetDeepColor", COLOR),
        0,
    ),
    "opacity": (lambda it: [("vtk_water_actor_set_opacity", it.water, number(0.5))], look_call("SetOpacity", 0.5), 0),
    "refraction": (c_clear("vtk_water_actor_set_refraction", 0), clear("SetRefraction", False), 1),
    "own view": (c_patch_beside_the_picture, patch_beside_the_picture, 1),
    "water type": (c_clear("vtk_water_actor_set_water_type", b"9C"), clear("SetWaterType", "9C"), 1),
    "foam": (c_clear("vtk_water_actor_set_foam", number(0.3)), clear("SetFoamDepth", 0.3), 1),
    "caustics": (c_clear("vtk_water_actor_set_caustics", number(0.9)), clear("SetCaustics", 0.9), 1),
    "light shafts": (c_under_water("vtk_water_actor_set_light_shafts", number(1.0)), shafts, 1),
    "dome port": (c_clear("vtk_water_actor_set_dome_port", number(20.0)), clear("SetDomePortRadius", 20.0), 1),
    "whitecaps": (
        lambda it: [("vtk_water_actor_set_wind", it.water, number(25.0)),
                    ("vtk_water_actor_set_whitecaps", it.water, 1),
                    ("vtk_water_actor_set_whitecap_life_time", it.water, number(2.0))],
        white_sea,
        1,
    ),
    "shadows": (
        lambda it: [*c_clear("vtk_water_actor_set_foam", number(3.0))(it),
                    ("vtk_water_actor_set_shadows", it.water, 1)],
        in_foam,
        1,
    ),
    "vertical_exaggeration": (
        lambda it: [*c_clear("vtk_water_actor_set_vertical_exaggeration", number(3.0))(it),
                    ("vtk_water_actor_set_foam", it.water, number(0.1))],
        exaggerated_foam,
        1,
    ),
    "units": (
        lambda it: [
            ("vtk_water_actor_add_wave", it.water, *[number(part) for part in WAVE]),
            ("vtk_water_actor_set_units", it.water, b"cm"),
        ],
        wave_in_cm,
        0,
    ),
    "quality": (
        lambda it: [("vtk_water_actor_set_quality", it.water, b"reference")],
        look_call("SetRayTraceQuality", "reference"),
        0,
    ),
    "environment": (
        lambda it: [("vtk_water_actor_set_environment", it.water, SKY.ctypes, SKY.shape[1], SKY.shape[0])],
        look_up,
        0,
    ),
    "surface": (lambda it: [surface_call(it)], by_a_mesh, 0),
    "flow": (
        lambda it: [surface_call(it), ("vtk_water_actor_set_flow_period", it.water, number(2.0)),
                    ("vtk_water_actor_set_flow", it.water, FLOW.ctypes, ctypes.c_size_t(len(FLOW)))],
        by_a_current,
        0,
    ),
    "matter": (
        c_data(("matter_optics", doubles(0.1, 0.5, 2.0), doubles(0.2, 0.1, 0.0)),
               ("matter", POINT_VALUES.ctypes, ctypes.c_size_t(4))),
        lambda view, water: by_data(view, water, with_matter),
        1,
    ),
    "foam data": (
        c_data(("foam_data", POINT_VALUES.ctypes, ctypes.c_size_t(4), b"froude")),
        lambda view, water: by_data(view, water, with_foam),
        1,
    ),
    "sun": (lambda it: [("vtk_water_scene_set_sun", it.scene, number(30.0), number(0.0), None)], add_sun, 1),
    "lamp": (
        lambda it: [("vtk_water_scene_add_light", it.scene, doubles(2, -2, 3), doubles(1, 0.5, 0.5), number(0.75))],
        add_lamp,
        0,
    ),
}


@pytest.mark.parametrize("name", CALLS, ids=lambda name: name.replace(" ", "_"))
def test_a_call_does_what_the_classes_do(by_c, name):  # noqa: F811
    """A call changes the picture as the classes' setters do."""
    calls, change, most = CALLS[name]
    for function, *arguments in calls(by_c):
        plain = by_c.picture().astype(int)
        by_c.call(getattr(by_c.lib, function), *arguments)
    pixels = by_c.picture().astype(int)
    wt.save(pixels[::-1], wt.output_folder() / f"CWords-{name.replace(' ', '-')}.png")
    view, water = view_by_classes()
    change(view, water)
    wt.check_at_most("largest difference to the classes' picture", wt.difference(pixels, view.picture()[::-1]), most)
    wt.check_at_least("largest difference to the picture before the last call", wt.difference(pixels, plain), 5)


def test_an_environment_can_be_taken_back(by_c):  # noqa: F811
    """Without a picture the scene is reflected again."""
    plain = by_c.picture().astype(int)
    by_c.call(by_c.lib.vtk_water_actor_set_environment, by_c.water, SKY.ctypes, SKY.shape[1], SKY.shape[0])
    by_c.picture()
    by_c.call(by_c.lib.vtk_water_actor_set_environment, by_c.water, None, 0, 0)
    wt.check_equal("difference", wt.difference(by_c.picture().astype(int), plain), 0)


def test_a_surface_can_be_taken_back(by_c):  # noqa: F811
    """Without a surface the water is the sheet again, and has no current; without velocities it has none either."""
    plain = by_c.picture().astype(int)
    name, *arguments = surface_call(by_c)
    by_c.call(getattr(by_c.lib, name), *arguments)
    still = by_c.picture().astype(int)
    by_c.call(by_c.lib.vtk_water_actor_set_flow, by_c.water, FLOW.ctypes, ctypes.c_size_t(4))
    by_c.picture()
    by_c.call(by_c.lib.vtk_water_actor_set_flow, by_c.water, None, ctypes.c_size_t(0))
    wt.check_equal("without a current: difference", wt.difference(by_c.picture().astype(int), still), 0)
    by_c.call(by_c.lib.vtk_water_actor_set_flow, by_c.water, FLOW.ctypes, ctypes.c_size_t(4))
    by_c.call(by_c.lib.vtk_water_actor_set_surface, by_c.water, None, ctypes.c_size_t(0), None, ctypes.c_size_t(0))
    wt.check_equal("without a surface: difference", wt.difference(by_c.picture().astype(int), plain), 0)


def test_a_scene_has_one_sun_and_its_lights_can_be_removed(by_c):  # noqa: F811
    """Another sun takes the first one's place, in a scene that was rendered without a light, too; without all lights
    the scene is lit as at first."""
    plain = by_c.picture().astype(int)
    for azimuth in (200.0, 30.0):
        by_c.call(by_c.lib.vtk_water_scene_set_sun, by_c.scene, number(azimuth), number(0.0), None)
        lit = by_c.picture().astype(int)
    view, water = view_by_classes()
    add_sun(view, water)
    wt.check_at_most("two suns, the last alone: difference", wt.difference(lit, view.picture()[::-1]), 1)
    by_c.call(by_c.lib.vtk_water_scene_add_light, by_c.scene, doubles(2, -2, 3), doubles(1, 0, 0), number(1.0))
    by_c.call(by_c.lib.vtk_water_scene_remove_all_lights, by_c.scene)
    wt.check_equal("without lights: difference", wt.difference(by_c.picture().astype(int), plain), 0)
    by_c.call(by_c.lib.vtk_water_scene_set_sun, by_c.scene, number(30.0), number(0.0), None)
    wt.check_equal("the sun again: difference", wt.difference(by_c.picture().astype(int), lit), 0)


def test_a_wind_has_a_direction(small):  # noqa: F811
    """The wind's speed and direction arrive in the look."""
    small.judge("vtk_water_actor_set_wind", OK, b"", small.water, number(7.0))
    small.judge("vtk_water_actor_set_wind_direction", OK, b"", small.water, number(40.0))
    look = small.native_water().GetWaterProperty()
    wt.check_equal(
        "sea, speed, direction", (look.GetSea(), look.GetWindSpeed(), look.GetWindDirection()), (True, 7.0, 40.0)
    )


def test_a_pass_has_a_time_budget(small):  # noqa: F811
    """A time budget chooses the quality by it; 0 takes it away."""
    small.judge("vtk_water_pass_set_time_budget", OK, b"", small.mirror, number(4.0))
    mirror = small.native_water().GetReflectionPass()
    wt.check_equal(
        "budget, quality", (mirror.GetTimeBudget(), mirror.GetQuality()), (4.0, vtkWaterReflectionPass.TIME_BUDGET)
    )
    small.judge("vtk_water_pass_set_time_budget", BAD_VALUE, b"TimeBudget is -1", small.mirror, number(-1.0))
    wt.check_equal(
        "after a wrong one", (mirror.GetTimeBudget(), mirror.GetQuality()), (4.0, vtkWaterReflectionPass.TIME_BUDGET)
    )
    small.judge("vtk_water_pass_set_time_budget", OK, b"", small.mirror, number(0.0))
    wt.check_equal("quality without", mirror.GetQuality(), vtkWaterReflectionPass.FIXED)


def test_a_pass_has_secondary_reflections(small):  # noqa: F811
    """They are turned on and off; another number is an error."""
    mirror = small.native_water().GetReflectionPass()
    for value in (1, 0, 1):
        small.judge("vtk_water_pass_set_secondary_reflections", OK, b"", small.mirror, value)
        wt.check_equal("on", mirror.GetSecondaryReflections(), value == 1)
    small.judge("vtk_water_pass_set_secondary_reflections", BAD_VALUE,
                b"secondary reflections is 2; it must be 0 or 1", small.mirror, 2)
    small.judge("vtk_water_pass_set_secondary_reflections", NULL_ARGUMENT, b"pass is NULL", None, 1)
    wt.check_equal("on, after wrong ones", mirror.GetSecondaryReflections(), True)


WAVE = (0.0005, 0.03, 20.0, 10.0, 0.0)  # m
NAN, INFINITY = float("nan"), float("inf")
REFUSALS = (  # name, status, words of the error, function, its arguments for a SmallScene
    (
        "direction",
        BAD_VALUE,
        b"WindDirection is inf",
        "vtk_water_actor_set_wind_direction",
        lambda it: (it.water, number(INFINITY)),
    ),
    (
        "color",
        BAD_VALUE,
        b"DeepColor is (2, 0, 0)",
        "vtk_water_actor_set_color",
        lambda it: (it.water, doubles(2, 0, 0)),
    ),
    ("color_null", NULL_ARGUMENT, b"color is NULL", "vtk_water_actor_set_color", lambda it: (it.water, None)),
    (
        "opacity",
        BAD_VALUE,
        b"Opacity is 1.5; it must lie in [0, 1]",
        "vtk_water_actor_set_opacity",
        lambda it: (it.water, number(1.5)),
    ),
    (
        "refraction",
        BAD_VALUE,
        b"refraction is 2; it must be 0 or 1",
        "vtk_water_actor_set_refraction",
        lambda it: (it.water, 2),
    ),
    ("refraction_null", NULL_ARGUMENT, b"actor is NULL", "vtk_water_actor_set_refraction", lambda it: (None, 1)),
    (
        "own_view",
        BAD_VALUE,
        b"own_view is -1; it must be 0 or 1",
        "vtk_water_actor_set_own_view",
        lambda it: (it.water, -1),
    ),
    (
        "water_type",
        BAD_VALUE,
        b"WaterType is 'X'; it must be one of I, IA",
        "vtk_water_actor_set_water_type",
        lambda it: (it.water, b"X"),
    ),
    (
        "water_type_null",
        BAD_VALUE,
        b"WaterType is '(null)'",
        "vtk_water_actor_set_water_type",
        lambda it: (it.water, None),
    ),
    ("foam", BAD_VALUE, b"FoamDepth is -1", "vtk_water_actor_set_foam", lambda it: (it.water, number(-1.0))),
    (
        "caustics",
        BAD_VALUE,
        b"Caustics is nan; it must lie in [0, 1]",
        "vtk_water_actor_set_caustics",
        lambda it: (it.water, number(NAN)),
    ),
    (
        "whitecap_life_time",
        BAD_VALUE,
        b"WhitecapLifeTime is 11; it must lie in [0, 10]",
        "vtk_water_actor_set_whitecap_life_time",
        lambda it: (it.water, number(11.0)),
    ),
    (
        "light_shafts",
        BAD_VALUE,
        b"LightShafts is 2",
        "vtk_water_actor_set_light_shafts",
        lambda it: (it.water, number(2.0)),
    ),
    (
        "dome_port",
        BAD_VALUE,
        b"DomePortRadius is -1",
        "vtk_water_actor_set_dome_port",
        lambda it: (it.water, number(-1.0)),
    ),
    (
        "shadows",
        BAD_VALUE,
        b"shadows is 2; it must be 0 or 1",
        "vtk_water_actor_set_shadows",
        lambda it: (it.water, 2),
    ),
    (
        "quality",
        BAD_VALUE,
        b'RayTraceQuality is "ultra"',
        "vtk_water_actor_set_quality",
        lambda it: (it.water, b"ultra"),
    ),
    ("vertical_exaggeration", BAD_VALUE, b"VerticalExaggeration is 0; it must lie in [1e-06, 1e+06]",
     "vtk_water_actor_set_vertical_exaggeration", lambda it: (it.water, number(0.0))),
    ("units", BAD_VALUE, b"Units are 'furlong'; they must be one of um, mm", "vtk_water_actor_set_units",
     lambda it: (it.water, b"furlong")),
    ("quality_null", BAD_VALUE, b"RayTraceQuality", "vtk_water_actor_set_quality", lambda it: (it.water, None)),
    (
        "environment_size",
        BAD_VALUE,
        b"size is 0 x 5 pixels; both must lie in [1, 16384]",
        "vtk_water_actor_set_environment",
        lambda it: (it.water, SKY.ctypes, 0, 5),
    ),
    ("budget_null", NULL_ARGUMENT, b"pass is NULL", "vtk_water_pass_set_time_budget", lambda it: (None, number(1.0))),
    (
        "sun_elevation",
        BAD_VALUE,
        b"elevation 100",
        "vtk_water_scene_set_sun",
        lambda it: (it.scene, number(0), number(100), None),
    ),
    (
        "sun_at_night",
        BAD_VALUE,
        b"elevation -5 degrees; the azimuth must be finite, and the elevation must lie in [0, 90]",
        "vtk_water_scene_set_sun",
        lambda it: (it.scene, number(0), number(-5), None),
    ),
    (
        "sun_azimuth",
        BAD_VALUE,
        b"azimuth is nan",
        "vtk_water_scene_set_sun",
        lambda it: (it.scene, number(NAN), number(0), None),
    ),
    (
        "sun_color",
        BAD_VALUE,
        b"color is (0, 0, -1); red, green and blue must lie in [0, 1]",
        "vtk_water_scene_set_sun",
        lambda it: (it.scene, number(0), number(0), doubles(0, 0, -1)),
    ),
    (
        "sun_null",
        NULL_ARGUMENT,
        b"scene is NULL",
        "vtk_water_scene_set_sun",
        lambda it: (None, number(0), number(0), None),
    ),
    (
        "light_intensity",
        BAD_VALUE,
        b"intensity is -1; it must be finite and not negative",
        "vtk_water_scene_add_light",
        lambda it: (it.scene, doubles(0, 0, 1), doubles(*BOTTOM), number(-1)),
    ),
    (
        "light_place",
        BAD_VALUE,
        b"position is (0, nan, 1); it must be finite",
        "vtk_water_scene_add_light",
        lambda it: (it.scene, doubles(0, NAN, 1), doubles(*BOTTOM), number(1)),
    ),
    (
        "light_color",
        BAD_VALUE,
        b"color is (0, 0, 3); red, green and blue must lie in [0, 1]",
        "vtk_water_scene_add_light",
        lambda it: (it.scene, doubles(0, 0, 1), doubles(0, 0, 3), number(1)),
    ),
    (
        "light_null",
        NULL_ARGUMENT,
        b"color is NULL",
        "vtk_water_scene_add_light",
        lambda it: (it.scene, doubles(0, 0, 1), None, number(1)),
    ),
    ("surface_point", BAD_VALUE, b"triangle 1 refers to point 3; there are 3", "vtk_water_actor_set_surface",
     lambda it: (it.water, SURFACE.ctypes, ctypes.c_size_t(3), BED_TRIANGLES.ctypes, ctypes.c_size_t(2))),
    ("surface_place", BAD_VALUE, b"points must be finite", "vtk_water_actor_set_surface",
     lambda it: (it.water, doubles(0, 0, NAN), ctypes.c_size_t(1), BED_TRIANGLES.ctypes, ctypes.c_size_t(0))),
    ("surface_null", NULL_ARGUMENT, b"triangles is NULL", "vtk_water_actor_set_surface",
     lambda it: (it.water, SURFACE.ctypes, ctypes.c_size_t(4), None, ctypes.c_size_t(2))),
    ("flow_of_the_sheet", BAD_VALUE, b"velocities of 4 points; first set a surface with as many", "vtk_water_actor_set_flow",
     lambda it: (it.water, FLOW.ctypes, ctypes.c_size_t(4))),
    ("flow_null", NULL_ARGUMENT, b"actor is NULL", "vtk_water_actor_set_flow", lambda it: (None, FLOW.ctypes, 4)),
    ("flow_period", BAD_VALUE, b"FlowPeriod is 0; it must lie in [", "vtk_water_actor_set_flow_period",
     lambda it: (it.water, number(0.0))),
    ("matter_of_the_sheet", BAD_VALUE, b"concentrations of 4 points; first set a surface with as many",
     "vtk_water_actor_set_matter", lambda it: (it.water, POINT_VALUES.ctypes, ctypes.c_size_t(4))),
    ("matter_null", NULL_ARGUMENT, b"actor is NULL", "vtk_water_actor_set_matter",
     lambda it: (None, POINT_VALUES.ctypes, 4)),
    ("matter_absorption", BAD_VALUE, b"MatterAbsorption is (-1, 0, 0)", "vtk_water_actor_set_matter_optics",
     lambda it: (it.water, doubles(-1, 0, 0), doubles(0, 0, 0))),
    ("matter_scattering", NULL_ARGUMENT, b"scattering is NULL", "vtk_water_actor_set_matter_optics",
     lambda it: (it.water, doubles(1, 0, 0), None)),
    ("foam_of_the_sheet", BAD_VALUE, b"values of foam of 4 points; first set", "vtk_water_actor_set_foam_data",
     lambda it: (it.water, POINT_VALUES.ctypes, ctypes.c_size_t(4), b"cover")),
    ("foam_measure", BAD_VALUE, b"measure is 'wet'; it must be cover, froude or breaking",
     "vtk_water_actor_set_foam_data", lambda it: (it.water, POINT_VALUES.ctypes, ctypes.c_size_t(4), b"wet")),
    ("foam_measure_null", NULL_ARGUMENT, b"measure is NULL", "vtk_water_actor_set_foam_data",
     lambda it: (it.water, POINT_VALUES.ctypes, ctypes.c_size_t(4), None)),
    ("lights_null", NULL_ARGUMENT, b"scene is NULL", "vtk_water_scene_remove_all_lights", lambda it: (None,)),
)


@pytest.mark.parametrize("status, words, function, arguments", [case[1:] for case in REFUSALS],
                         ids=[case[0] for case in REFUSALS])
def test_a_bad_call_is_a_status_and_changes_nothing(small, status, words, function, arguments):  # noqa: F811
    """A bad call is a status with a text that names what is wrong, and the look is as it was."""
    small.judge(function, status, words, *arguments(small))
    look, default = small.native_water().GetWaterProperty(), vtkWaterProperty()
    for name in (
        "WindDirection",
        "DeepColor",
        "Opacity",
        "Refraction",
        "Absorption",
        "FoamDepth",
        "Caustics",
        "Shadows",
        "RayTraceSteps",
        "ReflectionSource",
        "EnvironmentTexture",
    ):
        wt.check_equal(f"after it: {name}", getattr(look, f"Get{name}")(), getattr(default, f"Get{name}")())


@pytest.mark.parametrize("absorption, scattering, words", (
    ((0.3, 0.4, 0.5), (0.1, -1.0, 0.1), b"MatterScattering is (0.1, -1, 0.1)"),
    ((0.3, NAN, 0.5), (0.3, 0.2, 0.1), b"MatterAbsorption is (0.3, nan, 0.5)"),
), ids=("scattering", "absorption"))
def test_optics_of_matter_that_are_refused_change_neither_part(small, absorption, scattering, words):  # noqa: F811
    """If one of absorption and scattering is wrong, the other one stays as it was, too."""
    small.judge("vtk_water_actor_set_matter_optics", OK, b"", small.water, doubles(1, 2, 3), doubles(4, 5, 6))
    small.judge("vtk_water_actor_set_matter_optics", BAD_VALUE, words, small.water, doubles(*absorption),
                doubles(*scattering))
    water = small.native_water()
    wt.check_equal("absorption, scattering", (water.GetMatterAbsorption(), water.GetMatterScattering()),
                   ((1.0, 2.0, 3.0), (4.0, 5.0, 6.0)))


def compass_picture():
    """Red in the middle, green at the top, blue elsewhere."""
    picture = np.zeros((60, 120, 3), dtype=np.uint8)
    picture[:, :, 2] = 255
    picture[:, 50:70] = (255, 0, 0)
    picture[:10] = (0, 255, 0)
    return picture


def test_a_picture_of_the_surroundings_lies_as_is_said(lib):  # noqa: F811
    """The middle of a picture is towards +x and its top row overhead, as a mirror shows."""
    picture = compass_picture()
    scene, water = made(lib.vtk_water_scene_new, 40, 40), made(lib.vtk_water_actor_new)
    pixels = np.zeros((40, 40, 3), dtype=np.uint8)
    for function, *arguments in (
        (lib.vtk_water_actor_set_sheet_bounds, water, doubles(-50, 50, -50, 50)),
        (lib.vtk_water_actor_set_preset, water, b"mirror floor"),
        (lib.vtk_water_actor_set_environment, water, picture.ctypes, 120, 60),
        (lib.vtk_water_scene_add_water, scene, water),
    ):
        wt.check_equal(function.__name__, function(*arguments), OK)
    for name, way, wanted in (("+x", (1, 0.01, -0.2), (255, 0, 0)), ("-x", (-1, 0.01, -0.2), (0, 0, 255)),
                              ("+y", (0.01, 1, -0.2), (0, 0, 255)), ("down", (0.1, 0.1, -1), (0, 255, 0))):
        target, up = doubles(way[0], way[1], 2.0 + way[2]), doubles(0.3, 0.8, 0.4)
        wt.check_equal("camera", lib.vtk_water_scene_set_camera(scene, doubles(0, 0, 2), target, up, number(5.0)), OK)
        wt.check_equal("render", lib.vtk_water_scene_render(scene, pixels.ctypes, ctypes.c_size_t(pixels.nbytes)), OK)
        wt.check_at_most(f"mirrored, looking to {name}: difference to {wanted}",
                         int(np.abs(pixels[20, 20].astype(int) - wanted).max()), 2)
    lib.vtk_water_actor_delete(water)
    lib.vtk_water_scene_delete(scene)

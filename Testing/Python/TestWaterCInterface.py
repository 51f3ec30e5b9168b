# SPDX-License-Identifier: BSD-3-Clause
"""The C interface, by ctypes: its picture is that of the same scene made with VTK's classes, pixel for pixel.

A bad value is a status with a text that names it, and changes nothing; nothing throws, nothing is printed.
"""

import ctypes
import sys

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkRenderWindow
from vtkwater import __version__, vtkRenderingWater, vtkWaterActor

WIDTH, HEIGHT = 160, 120
POINTS = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0), (0, 0, 1.5)], dtype=float)
TRIANGLES = np.array([(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)], dtype=np.int64)
COLOR, BOTTOM, TOP = (0.9, 0.4, 0.2), (0.9, 0.9, 0.9), (0.2, 0.4, 0.8)
EYE, TARGET, UP, ANGLE = (1.0, -5.0, 1.2), (0.0, 0.0, 0.2), (0.0, 0.0, 1.0), 35.0
LEVEL, BOUNDS, WAVE = -0.1, (-4.0, 4.0, -4.0, 4.0), (0.02, 1.0, 30.0, 10.0, 0.0)
OK, NULL_ARGUMENT, BAD_VALUE = 0, 1, 2
UNTOUCHED = 77


@pytest.fixture(scope="module")
def lib():
    """The library that Python's classes are in; a program in another language names its file."""
    if sys.platform != "linux":
        loaded = ctypes.CDLL(vtkRenderingWater.__file__)
    else:
        with open("/proc/self/maps") as maps:
            loaded = ctypes.CDLL(next(line.split()[-1] for line in maps if "libvtkRenderingWater" in line))
    loaded.vtk_water_last_error.restype = ctypes.c_char_p
    loaded.vtk_water_status_text.restype = ctypes.c_char_p
    loaded.vtk_water_actor_delete.restype = loaded.vtk_water_scene_delete.restype = None
    return loaded


def doubles(*values):
    return (ctypes.c_double * len(values))(*values)


def number(value):
    return ctypes.c_double(value)


def made(function, *arguments):
    handle = ctypes.c_void_p()
    wt.check_equal(function.__name__, function(*arguments, ctypes.byref(handle)), OK)
    return handle


def value_of(function, handle, kind, *arguments):
    value = kind()
    wt.check_equal(function.__name__, function(handle, *arguments, ctypes.byref(value)), OK)
    return value.value


class CScene:
    """The scene by the C interface: every call is right and says nothing."""

    def __init__(self, lib):
        self.lib = lib
        self.scene = made(lib.vtk_water_scene_new, WIDTH, HEIGHT)
        self.water = made(lib.vtk_water_actor_new)
        for function, *arguments in (
            (lib.vtk_water_scene_set_sky, self.scene, doubles(*BOTTOM), doubles(*TOP)),
            (lib.vtk_water_scene_add_mesh, self.scene, POINTS.ctypes, ctypes.c_size_t(len(POINTS)), TRIANGLES.ctypes,
             ctypes.c_size_t(len(TRIANGLES)), doubles(*COLOR)),
            (lib.vtk_water_actor_set_level, self.water, number(LEVEL)),
            (lib.vtk_water_actor_set_sheet_bounds, self.water, doubles(*BOUNDS)),
            (lib.vtk_water_actor_add_wave, self.water, *map(number, WAVE)),
            (lib.vtk_water_actor_set_time, self.water, number(0.7)),
            (lib.vtk_water_scene_add_water, self.scene, self.water),
            (lib.vtk_water_scene_set_camera, self.scene, doubles(*EYE), doubles(*TARGET), doubles(*UP), number(ANGLE)),
        ):
            self.call(function, *arguments)

    def call(self, function, *arguments):
        said = (function(*arguments), self.lib.vtk_water_last_error())
        wt.check_equal(function.__name__, said, (OK, b""))

    def picture(self):
        pixels = np.zeros((HEIGHT, WIDTH, 3), dtype=np.uint8)
        self.call(self.lib.vtk_water_scene_render, self.scene, pixels.ctypes, ctypes.c_size_t(pixels.nbytes))
        return pixels


@pytest.fixture
def by_c(lib):
    scene = CScene(lib)
    yield scene
    lib.vtk_water_actor_delete(scene.water)
    lib.vtk_water_scene_delete(scene.scene)


def view_by_classes():
    """The same scene by VTK's classes, and its water."""
    view = wt.View((WIDTH, HEIGHT))
    view.window.SetMultiSamples(vtkRenderWindow().GetMultiSamples())  # the default, as there
    view.renderer.GradientBackgroundOn()
    view.renderer.SetBackground(BOTTOM)
    view.renderer.SetBackground2(TOP)
    points, cells, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(POINTS, deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(TRIANGLES.ravel(), deep=True))
    data.SetPoints(points)
    data.SetPolys(cells)
    wt.add_actor(view.renderer, data, COLOR)
    water = wt.add_water(view.renderer, sheet=BOUNDS, reflectance=None)
    water.SetLevel(LEVEL)
    water.GetWaterProperty().AddWave(*WAVE)
    water.SetTime(0.7)
    camera = view.renderer.GetActiveCamera()
    camera.SetPosition(EYE)
    camera.SetFocalPoint(TARGET)
    camera.SetViewUp(UP)
    camera.SetViewAngle(ANGLE)
    view.renderer.ResetCameraClippingRange()
    return view, water


def test_the_interface_has_a_version(lib):
    """The interface's version is 1."""
    wt.check_equal("version of the interface", lib.vtk_water_interface_version(), 1)
    lib.vtk_water_version.restype = ctypes.c_char_p
    wt.check_equal("version of the module", lib.vtk_water_version().decode(), __version__)


def test_the_picture_is_that_of_the_classes(by_c):
    """A scene by the C interface is rendered as the same scene by VTK's classes, pixel for pixel."""
    pixels = by_c.picture()
    wt.save(pixels[::-1], wt.output_folder() / "CInterface.png")
    view, _ = view_by_classes()
    wt.check_equal("largest difference to the classes' picture",
                   int(np.abs(pixels.astype(int) - view.picture()[::-1]).max()), 0)
    wt.check_at_least("colours in it", wt.count_colors(pixels), 500)


def test_the_pass_tells_what_it_did(lib, by_c):
    """After one picture the pass tells of one mirrored view, of the one prop in it, and that it was rendered."""
    by_c.picture()
    mirror = made(lib.vtk_water_actor_get_pass, by_c.water)
    wt.check_equal("mirrored views", value_of(lib.vtk_water_pass_get_render_count, mirror, ctypes.c_int64), 1)
    wt.check_equal("props in it", value_of(lib.vtk_water_pass_get_prop_count, mirror, ctypes.c_int64), 1)
    wt.check_equal("decision", value_of(lib.vtk_water_pass_get_decision, mirror, ctypes.c_char_p), b"rendered")


def test_the_height_of_a_wave_is_that_of_the_classes(lib, by_c):
    """A wave is as high at a place and time by the C interface as by the classes."""
    height = value_of(lib.vtk_water_actor_get_wave_height, by_c.water, ctypes.c_double, number(0.3), number(1.0))
    _, water = view_by_classes()
    wt.check_equal("height of a wave", height, water.GetWaveHeight(0.3, 1.0))


def test_a_scene_keeps_water_whose_handle_is_deleted(lib):
    """A scene still renders the water that was added to it when the water's handle is deleted."""
    by_c = CScene(lib)
    before = by_c.picture()
    lib.vtk_water_actor_delete(by_c.water)
    wt.check_equal("rendered without the handle", lib.vtk_water_scene_render(by_c.scene, None, ctypes.c_size_t(0)), OK)
    wt.check_equal("largest difference without the handle",
                   int(np.abs(by_c.picture().astype(int) - before).max()), 0)
    lib.vtk_water_scene_delete(by_c.scene)


class SmallScene:
    """Handles for wrong calls: of an empty scene, of water in no scene, and of its pass."""

    def __init__(self, lib):
        self.lib = lib
        self.scene = made(lib.vtk_water_scene_new, 32, 16)
        self.water = made(lib.vtk_water_actor_new)
        self.mirror = made(lib.vtk_water_actor_get_pass, self.water)
        self.none = ctypes.c_void_p()

    def judge(self, function, status, words, *arguments):
        """Calls, and judges the status, its text and the text of the error."""
        got = getattr(self.lib, function)(*arguments)
        said = self.lib.vtk_water_last_error()
        wt.check_equal(f"{function}: '{said.decode()}'", (got, words in said), (status, True))
        wt.check_equal("  its text", self.lib.vtk_water_status_text(got) != b"unknown status", True)

    def native_water(self):
        """The water as an object of Python's class."""
        sea = ctypes.c_void_p()
        wt.check_equal("object", self.lib.vtk_water_actor_get_vtk_object(self.water, ctypes.byref(sea)), OK)
        return vtkWaterActor(f"_{sea.value:016x}_p_void")


@pytest.fixture
def small(lib):
    things = SmallScene(lib)
    yield things
    for handle in (things.water, None):
        lib.vtk_water_actor_delete(handle)
    for handle in (things.scene, None):
        lib.vtk_water_scene_delete(handle)


def test_water_to_the_horizon_is_that_of_the_classes(by_c, lib):
    """Water to the horizon by the C interface is rendered as by VTK's classes, and bounds replace it."""
    wt.check_equal("status", lib.vtk_water_actor_set_sheet_to_horizon(by_c.water), OK)
    view, water = view_by_classes()
    bounded = view.picture()
    water.SetSheetToHorizon()
    view.renderer.ResetCameraClippingRange()
    pixels = by_c.picture().astype(int)
    wt.check_at_most("pixels that differ from the classes'",
                     int((np.abs(pixels - view.picture()[::-1]).max(axis=2) > 2).sum()), 20)
    wt.check_at_least("pixels that differ from those with bounds",
                      int((np.abs(pixels - bounded[::-1]).max(axis=2) > 2).sum()), 100)
    wt.check_equal("status of bounds", lib.vtk_water_actor_set_sheet_bounds(by_c.water, doubles(*BOUNDS)), OK)
    wt.check_equal("bounds again: largest difference", int(np.abs(by_c.picture().astype(int) - bounded[::-1]).max()), 0)


BAD_TRIANGLE = np.array([(0, 1, 7)], dtype=np.int64)
SMALL_BUFFER = np.zeros(10, np.uint8)
ORIGIN, HIGH = doubles(0, 0, 0), doubles(0, 0, 1)
# name, status, words of the error, function, its arguments for a SmallScene
REFUSALS = (
    ("no_actor", NULL_ARGUMENT, b"actor is NULL", "vtk_water_actor_set_level", lambda it: (it.none, number(1.0))),
    ("level_nan", BAD_VALUE, b"Level is nan; it must be finite", "vtk_water_actor_set_level",
     lambda it: (it.water, number(float("nan")))),
    ("origin_nan", BAD_VALUE, b"origin is (1, nan, 3); it must be finite", "vtk_water_actor_set_plane",
     lambda it: (it.water, doubles(1, float("nan"), 3), HIGH)),
    ("normal_infinite", BAD_VALUE, b"normal is (0, 0, inf); it must be finite and not zero",
     "vtk_water_actor_set_plane", lambda it: (it.water, ORIGIN, doubles(0, 0, float("inf")))),
    ("normal_zero", BAD_VALUE, b"normal is (0, 0, 0); it must be finite and not zero", "vtk_water_actor_set_plane",
     lambda it: (it.water, ORIGIN, ORIGIN)),
    ("no_actor_to_the_horizon", NULL_ARGUMENT, b"actor is NULL", "vtk_water_actor_set_sheet_to_horizon",
     lambda it: (it.none,)),
    ("bounds_reversed", BAD_VALUE, b"xmin < xmax", "vtk_water_actor_set_sheet_bounds",
     lambda it: (it.water, doubles(1, 0, 0, 1))),
    ("preset_unknown", BAD_VALUE, b"'swamp'; it must be one of pool", "vtk_water_actor_set_preset",
     lambda it: (it.water, b"swamp")),
    ("preset_null", BAD_VALUE, b"Preset is '(null)'", "vtk_water_actor_set_preset", lambda it: (it.water, None)),
    ("wavelength_zero", BAD_VALUE, b"Wavelength", "vtk_water_actor_add_wave",
     lambda it: (it.water, *map(number, (1.0, 0.0, 0.0, 0.0, 0.0)))),
    ("wind_too_strong", BAD_VALUE, b"WindSpeed is 200", "vtk_water_actor_set_wind",
     lambda it: (it.water, number(200.0))),
    ("time_infinite", BAD_VALUE, b"Time is", "vtk_water_actor_set_time", lambda it: (it.water, number(float("inf")))),
    ("texture_too_fine", BAD_VALUE, b"TextureScale is 99", "vtk_water_pass_set_texture_scale",
     lambda it: (it.mirror, number(99.0))),
    ("size_zero", BAD_VALUE, b"size is 0 x 5", "vtk_water_scene_new", lambda it: (0, 5, ctypes.byref(it.none))),
    ("bottom_over_one", BAD_VALUE, b"bottom is (2, 0, 0); red, green and blue must lie in [0, 1]",
     "vtk_water_scene_set_sky", lambda it: (it.scene, doubles(2, 0, 0), ORIGIN)),
    ("top_below_zero", BAD_VALUE, b"top is (0, -0.5, 0); red, green and blue must lie in [0, 1]",
     "vtk_water_scene_set_sky", lambda it: (it.scene, ORIGIN, doubles(0, -0.5, 0))),
    ("point_unknown", BAD_VALUE, b"triangle 0 refers to point 7; there are 5", "vtk_water_scene_add_mesh",
     lambda it: (it.scene, POINTS.ctypes, ctypes.c_size_t(5), BAD_TRIANGLE.ctypes, ctypes.c_size_t(1),
                 doubles(1, 1, 1))),
    ("eye_nan", BAD_VALUE, b"eye is (nan, 0, 0); it must be finite", "vtk_water_scene_set_camera",
     lambda it: (it.scene, doubles(float("nan"), 0, 0), ORIGIN, doubles(0, 1, 0), number(30.0))),
    ("target_at_the_eye", BAD_VALUE, b"eye and target are both (0, 0, 1); they must be apart",
     "vtk_water_scene_set_camera", lambda it: (it.scene, HIGH, HIGH, doubles(0, 1, 0), number(30.0))),
    ("angle_180", BAD_VALUE, b"angle is 180; it must lie in [1, 170] degrees", "vtk_water_scene_set_camera",
     lambda it: (it.scene, HIGH, ORIGIN, doubles(0, 1, 0), number(180.0))),
    ("up_along_the_view", BAD_VALUE, b"; it must be neither zero nor along the view (0, 0, -1)", "vtk_water_scene_set_camera",
     lambda it: (it.scene, HIGH, ORIGIN, doubles(0, 0, 1), number(30.0))),
    ("up_against_the_view", BAD_VALUE, b"; it must be neither zero nor along the view (0, 0, -1)", "vtk_water_scene_set_camera",
     lambda it: (it.scene, HIGH, ORIGIN, doubles(0, 0, -2), number(30.0))),
    ("up_zero", BAD_VALUE, b"; it must be neither zero nor along the view (0, 0, -1)", "vtk_water_scene_set_camera",
     lambda it: (it.scene, HIGH, ORIGIN, ORIGIN, number(30.0))),
    ("buffer_too_small", BAD_VALUE, b"10 bytes are too few for 32 x 16 x 3", "vtk_water_scene_render",
     lambda it: (it.scene, SMALL_BUFFER.ctypes, ctypes.c_size_t(SMALL_BUFFER.nbytes))),
    ("no_place_for_a_pass", NULL_ARGUMENT, b"NULL", "vtk_water_actor_get_pass", lambda it: (it.water, None)),
    ("no_place_for_an_actor", NULL_ARGUMENT, b"NULL", "vtk_water_actor_new", lambda it: (None,)),
)


@pytest.mark.parametrize("status, words, function, arguments", [case[1:] for case in REFUSALS],
                         ids=[case[0] for case in REFUSALS])
def test_a_bad_call_is_a_status_and_changes_nothing(small, status, words, function, arguments):
    """A bad call is a status with a text that names what is wrong, and the water is as it was."""
    small.judge(function, status, words, *arguments(small))
    native = small.native_water()
    look = native.GetWaterProperty()
    wt.check_equal("after it: level, waves, sea, time",
                   (native.GetLevel(), look.GetNumberOfWaves(), look.GetSea(), native.GetTime()), (0.0, 0, False, 0.0))


def test_water_without_a_surface_leaves_the_picture_of_the_rest(small):
    """A scene whose water has no surface is rendered without the water, and the status says so."""
    picture = np.full((16, 32, 3), UNTOUCHED, dtype=np.uint8)
    small.judge("vtk_water_scene_add_water", OK, b"", small.scene, small.water)
    small.judge("vtk_water_scene_render", BAD_VALUE, b"the water has no surface", small.scene, picture.ctypes,
                ctypes.c_size_t(picture.nbytes))
    wt.check_equal("a water without a surface leaves the picture of the rest", (picture != UNTOUCHED).all(), True)


def test_a_status_that_there_is_not_has_a_text(lib):
    """The text of a status that there is not says that it is unknown."""
    wt.check_equal("another status", lib.vtk_water_status_text(99), b"unknown status")

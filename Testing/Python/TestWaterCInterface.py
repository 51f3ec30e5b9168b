# SPDX-License-Identifier: BSD-3-Clause
"""The C interface, by ctypes: its picture is that of the same scene made with VTK's classes, pixel for pixel.

A bad value is a status with a text that names it, and changes nothing; nothing throws, nothing is printed.
"""

import ctypes
import sys

import numpy as np
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkRenderWindow
from vtkwater import vtkRenderingWater, vtkWaterActor

WIDTH, HEIGHT = 160, 120
POINTS = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0), (0, 0, 1.5)], dtype=float)
TRIANGLES = np.array([(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)], dtype=np.int64)
COLOR, BOTTOM, TOP = (0.9, 0.4, 0.2), (0.9, 0.9, 0.9), (0.2, 0.4, 0.8)
EYE, TARGET, UP, ANGLE = (1.0, -5.0, 1.2), (0.0, 0.0, 0.2), (0.0, 0.0, 1.0), 35.0
LEVEL, BOUNDS, WAVE = -0.1, (-4.0, 4.0, -4.0, 4.0), (0.02, 1.0, 30.0, 10.0, 0.0)
OK, NULL_ARGUMENT, BAD_VALUE = 0, 1, 2
UNTOUCHED = 77


def load():
    """The library that Python's classes are in; a program in another language names its file."""
    if sys.platform != "linux":
        return ctypes.CDLL(vtkRenderingWater.__file__)
    with open("/proc/self/maps") as maps:
        return ctypes.CDLL(next(line.split()[-1] for line in maps if "libvtkRenderingWater" in line))


lib = load()
lib.vtk_water_last_error.restype = ctypes.c_char_p
lib.vtk_water_status_text.restype = ctypes.c_char_p
lib.vtk_water_actor_delete.restype = lib.vtk_water_scene_delete.restype = None


def doubles(*values):
    return (ctypes.c_double * len(values))(*values)


def made(function, *arguments):
    handle = ctypes.c_void_p()
    wt.check_equal(function.__name__, function(*arguments, ctypes.byref(handle)), OK)
    return handle


def value_of(function, handle, kind, *arguments):
    value = kind()
    wt.check_equal(function.__name__, function(handle, *arguments, ctypes.byref(value)), OK)
    return value.value


def picture_by_c():
    scene, water = made(lib.vtk_water_scene_new, WIDTH, HEIGHT), made(lib.vtk_water_actor_new)
    pixels = np.zeros((HEIGHT, WIDTH, 3), dtype=np.uint8)
    calls = [
        (lib.vtk_water_scene_set_sky, scene, doubles(*BOTTOM), doubles(*TOP)),
        (lib.vtk_water_scene_add_mesh, scene, POINTS.ctypes, ctypes.c_size_t(len(POINTS)), TRIANGLES.ctypes,
         ctypes.c_size_t(len(TRIANGLES)), doubles(*COLOR)),
        (lib.vtk_water_actor_set_level, water, ctypes.c_double(LEVEL)),
        (lib.vtk_water_actor_set_sheet_bounds, water, doubles(*BOUNDS)),
        (lib.vtk_water_actor_add_wave, water, *map(ctypes.c_double, WAVE)),
        (lib.vtk_water_actor_set_time, water, ctypes.c_double(0.7)),
        (lib.vtk_water_scene_add_water, scene, water),
        (lib.vtk_water_scene_set_camera, scene, doubles(*EYE), doubles(*TARGET), doubles(*UP), ctypes.c_double(ANGLE)),
        (lib.vtk_water_scene_render, scene, pixels.ctypes, ctypes.c_size_t(pixels.nbytes)),
    ]
    for function, *arguments in calls:
        wt.check_equal(function.__name__, (function(*arguments), lib.vtk_water_last_error()), (OK, b""))
    mirror = made(lib.vtk_water_actor_get_pass, water)
    wt.check_equal("mirrored views", value_of(lib.vtk_water_pass_get_render_count, mirror, ctypes.c_int64), 1)
    wt.check_equal("props in it", value_of(lib.vtk_water_pass_get_prop_count, mirror, ctypes.c_int64), 1)
    wt.check_equal("decision", value_of(lib.vtk_water_pass_get_decision, mirror, ctypes.c_char_p), b"rendered")
    height = value_of(lib.vtk_water_actor_get_wave_height, water, ctypes.c_double, ctypes.c_double(0.3), ctypes.c_double(1.0))
    lib.vtk_water_actor_delete(water)  # the scene has it still
    wt.check_equal("rendered without the handle", lib.vtk_water_scene_render(scene, None, ctypes.c_size_t(0)), OK)
    lib.vtk_water_scene_delete(scene)
    return pixels, height


def picture_by_classes():
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
    return view.picture()[::-1], water.GetWaveHeight(0.3, 1.0)


def check_errors():
    scene, water = made(lib.vtk_water_scene_new, 32, 16), made(lib.vtk_water_actor_new)
    mirror = made(lib.vtk_water_actor_get_pass, water)
    number, none = ctypes.c_double, ctypes.c_void_p()
    bad = np.array([(0, 1, 7)], dtype=np.int64)
    picture = np.full((16, 32, 3), UNTOUCHED, dtype=np.uint8)
    cases = [
        (NULL_ARGUMENT, b"actor is NULL", lib.vtk_water_actor_set_level, none, number(1.0)),
        (BAD_VALUE, b"Level is nan; it must be finite", lib.vtk_water_actor_set_level, water, number(float("nan"))),
        (BAD_VALUE, b"the normal not zero", lib.vtk_water_actor_set_plane, water, doubles(0, 0, 0), doubles(0, 0, 0)),
        (BAD_VALUE, b"xmin < xmax", lib.vtk_water_actor_set_sheet_bounds, water, doubles(1, 0, 0, 1)),
        (BAD_VALUE, b"'swamp'; it must be one of pool", lib.vtk_water_actor_set_preset, water, b"swamp"),
        (BAD_VALUE, b"Preset is '(null)'", lib.vtk_water_actor_set_preset, water, None),
        (BAD_VALUE, b"Wavelength", lib.vtk_water_actor_add_wave, water, *map(number, (1.0, 0.0, 0.0, 0.0, 0.0))),
        (BAD_VALUE, b"WindSpeed is 200", lib.vtk_water_actor_set_wind, water, number(200.0)),
        (BAD_VALUE, b"Time is", lib.vtk_water_actor_set_time, water, number(float("inf"))),
        (BAD_VALUE, b"TextureScale is 99", lib.vtk_water_pass_set_texture_scale, mirror, number(99.0)),
        (BAD_VALUE, b"size is 0 x 5", lib.vtk_water_scene_new, 0, 5, ctypes.byref(none)),
        (BAD_VALUE, b"[0, 1]", lib.vtk_water_scene_set_sky, scene, doubles(2, 0, 0), doubles(0, 0, 0)),
        (BAD_VALUE, b"triangle 0 names point 7; there are 5", lib.vtk_water_scene_add_mesh, scene, POINTS.ctypes,
         ctypes.c_size_t(5), bad.ctypes, ctypes.c_size_t(1), doubles(1, 1, 1)),
        (BAD_VALUE, b"in [1, 170]", lib.vtk_water_scene_set_camera, scene, doubles(0, 0, 1), doubles(0, 0, 0),
         doubles(0, 1, 0), number(180.0)),
        *((BAD_VALUE, b"up not zero nor along the view", lib.vtk_water_scene_set_camera, scene, doubles(0, 0, 1),
           doubles(0, 0, 0), up, number(30.0)) for up in (doubles(0, 0, 1), doubles(0, 0, -2), doubles(0, 0, 0))),
        (BAD_VALUE, b"10 bytes are too few for 32 x 16 x 3", lib.vtk_water_scene_render, scene,
         np.zeros(10, np.uint8).ctypes, ctypes.c_size_t(10)),
        (OK, b"", lib.vtk_water_scene_add_water, scene, water),
        (BAD_VALUE, b"the water has no surface", lib.vtk_water_scene_render, scene, picture.ctypes,
         ctypes.c_size_t(picture.nbytes)),
        (NULL_ARGUMENT, b"NULL", lib.vtk_water_actor_get_pass, water, None),
        (NULL_ARGUMENT, b"NULL", lib.vtk_water_actor_new, None),
    ]
    for status, words, function, *arguments in cases:
        got = function(*arguments)
        said = lib.vtk_water_last_error()
        wt.check_equal(f"{function.__name__}: '{said.decode()}'", (got, words in said), (status, True))
        wt.check_equal("  its text", lib.vtk_water_status_text(got) != b"unknown status", True)
    wt.check_equal("a water without a surface leaves the picture of the rest", (picture != UNTOUCHED).all(), True)
    sea = ctypes.c_void_p()
    wt.check_equal("object", lib.vtk_water_actor_get_vtk_object(water, ctypes.byref(sea)), OK)
    native = vtkWaterActor(f"_{sea.value:016x}_p_void")
    wt.check_equal("after all these: level, waves, sea, time",
                   (native.GetLevel(), native.GetWaterProperty().GetNumberOfWaves(), native.GetWaterProperty().GetSea(),
                    native.GetTime()), (0.0, 0, False, 0.0))
    wt.check_equal("another status", lib.vtk_water_status_text(99), b"unknown status")
    for handle in (water, None):
        lib.vtk_water_actor_delete(handle)
    for handle in (scene, None):
        lib.vtk_water_scene_delete(handle)


wt.check_equal("version of the interface", lib.vtk_water_interface_version(), 1)
(by_c, height_by_c), (by_classes, height_by_classes) = picture_by_c(), picture_by_classes()
wt.save(by_c[::-1], wt.output_folder() / "CInterface.png")
wt.check_equal("largest difference to the classes' picture", int(np.abs(by_c.astype(int) - by_classes).max()), 0)
wt.check_at_least("colours in it", len(np.unique(by_c.reshape(-1, 3), axis=0)), 500)
wt.check_equal("height of a wave", height_by_c, height_by_classes)
check_errors()
wt.finish()

# SPDX-License-Identifier: BSD-3-Clause
"""A water actor is made, placed and copied as VTK's other actors are: by any thread, by any plane, with all it has."""

import threading

import pytest
import water_test as wt
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkDataSetMapper, vtkPolyDataMapper
from vtkwater import vtkWaterActor
from water_scenes import SHEET, add_thing, plain_picture, view


def test_any_thread_may_make_water():
    """Water made by a thread and water made by another, in one renderer, show one mirror."""
    halves = []
    maker = threading.Thread(target=lambda: halves.append(vtkWaterActor()))
    maker.start()
    maker.join()
    halves.append(vtkWaterActor())
    scene = view()
    add_thing(scene.renderer)
    for water, sheet in zip(halves, ((-9, 0, -9, 9), (0, 9, -9, 9))):
        water.SetSheetBounds(sheet)
        water.GetWaterProperty().SetReflectanceModeToConstant()
        water.GetWaterProperty().SetReflectance(1)
        scene.renderer.AddActor(water)
    wt.check_equal("water of two threads: picture, error", wt.difference(scene.picture(), plain_picture()), 0)


@pytest.mark.skipif(not hasattr(vtkPlane, "SetOffset"), reason="a plane has an offset from VTK 9.4 on")
def test_a_planes_offset_moves_the_sheet():
    """A plane with an offset besides its origin has its sheet where the plane's function is zero."""
    plane = wt.plane((0, 0, -0.2), (0, 0, 1))
    plane.SetOffset(0.5)
    level = -0.2 - plane.EvaluateFunction((0, 0, -0.2))
    scene = view()
    water = wt.add_water(scene.renderer, plane, SHEET)
    scene.picture()
    wt.check_at_most("plane with an offset: error of the sheet's height", abs(water.GetBounds()[4] - level), 1e-12)


def test_a_copy_has_the_settings_of_its_mirror():
    """A shallow copy of water has what was set on the original's reflection pass."""
    water, copy = vtkWaterActor(), vtkWaterActor()
    water.GetReflectionPass().SetTextureScale(0.25)
    water.GetReflectionPass().SetClipMargin(0.1)
    water.GetReflectionPass().SetMultiSamples(4)
    copy.ShallowCopy(water)
    copied = copy.GetReflectionPass()
    wt.check_equal("ShallowCopy: TextureScale, ClipMargin, MultiSamples",
                   (copied.GetTextureScale(), copied.GetClipMargin(), copied.GetMultiSamples()), (0.25, 0.1, 4))


@pytest.mark.parametrize("azimuth, elevation, wanted", ((0, 0, (0, 1, 0)), (90, 0, (1, 0, 0)), (200, 90, (0, 0, 1)),
                                                        (-90, 45, (-0.5**0.5, 0, 0.5**0.5))))
def test_the_sky_over_level_water_is_that_of_a_compass(azimuth, elevation, wanted):
    """Over level water north is y and east x, whatever its level."""
    water, direction = vtkWaterActor(), [0.0] * 3
    water.SetLevel(7.0)
    water.GetSkyDirection(azimuth, elevation, direction)
    wt.check_at_most("error", max(abs(a - b) for a, b in zip(direction, wanted)), 1e-15)


def test_the_sky_over_other_water_has_its_axes():
    """Over water of another plane the zenith is along its normal; without a direction there is none."""
    water, direction = vtkWaterActor(), [0.0] * 3
    water.SetPlane(wt.plane((1, 2, 3), (0, 2, 0)))
    water.GetSkyDirection(30, 90, direction)
    wt.check_at_most("zenith: error", max(abs(a - b) for a, b in zip(direction, (0, 1, 0))), 1e-15)
    water.GetSkyDirection(90, 0, direction)
    wt.check_at_most("east: error", max(abs(a - b) for a, b in zip(direction, (1, 0, 0))), 1e-15)
    water.GetSkyDirection(float("inf"), 0, direction)
    wt.check_equal("no direction", [part == part for part in direction], [False] * 3)


def square(z):
    """A square of 4 x 4 in a plane."""
    source = vtkPlaneSource()
    source.SetOrigin(-2, -2, z)
    source.SetPoint1(2, -2, z)
    source.SetPoint2(-2, 2, z)
    source.Update()
    return source.GetOutput()


@pytest.mark.parametrize("mapper_class", (vtkPolyDataMapper, vtkDataSetMapper))
def test_a_mesh_tells_how_it_lies(mapper_class):
    """The height and angle of a user's mesh over the plane are told, with what is accepted; a mesh that is off is
    warned of once, of either mapper."""
    mapper = mapper_class()
    mapper.SetInputData(square(0.5))
    scene = view()
    water = wt.add_water(scene.renderer)
    water.SetMapper(mapper)
    water.SetLevel(0.25)
    placement, warnings = [0.0] * 4, []
    wt.check_equal("known", water.GetMeshPlacement(placement), True)
    wanted = (0.25, 0.01 * 32**0.5, 0.0, 30.0)
    wt.check_at_most("height, most, angle, most: error", max(abs(a - b) for a, b in zip(placement, wanted)), 1e-7)
    water.AddObserver("WarningEvent", lambda *_: warnings.append(1))
    scene.picture()
    scene.picture()
    wt.check_equal("warnings", len(warnings), 1)
    water.AddPosition(0, 0, -0.25)
    water.GetMeshPlacement(placement)
    wt.check_at_most("moved into the plane: height", abs(placement[0]), 1e-9)


def test_the_own_sheet_is_no_mesh():
    """The own sheet, and a mapper without polygons, tell no height."""
    water, placement = vtkWaterActor(), [0.0] * 4
    wt.check_equal(
        "own sheet: known", (water.GetMeshPlacement(placement), placement[0] != placement[0]), (False, True)
    )
    water.SetMapper(vtkPolyDataMapper())
    wt.check_equal("no input: known", water.GetMeshPlacement(placement), False)


def test_water_before_the_scene_is_silent_and_fits_itself_to_it():
    """Water that is asked for its bounds in an empty renderer says nothing, and is as wide as what is added later; a
    frame of nothing but water is an error."""
    scene, said = wt.View((40, 30)), []
    water = wt.add_water(scene.renderer)
    water.AddObserver("ErrorEvent", lambda *_: said.append(1))
    scene.renderer.ResetCamera()
    water.GetBounds()
    wt.check_equal("said of bounds; error", (len(said), water.GetLastError()), (0, ""))
    add_thing(scene.renderer)
    scene.renderer.ResetCamera()
    scene.picture()
    things = [prop for prop in scene.renderer.GetActors() if prop is not water]
    wt.check_equal("said of the frame", len(said), 0)
    wt.check_equal("as wide as the scene", water.GetBounds()[:4], things[0].GetBounds()[:4])
    scene.renderer.RemoveActor(things[0])
    scene.picture()
    wt.check_equal("said of a frame of nothing else", len(said), 1)


def test_a_first_frame_of_nothing_but_water_is_an_error():
    """The first frame of a scene in which there is nothing to be as wide as tells so, once."""
    scene, said = wt.View((40, 30)), []
    water = wt.add_water(scene.renderer)
    water.AddObserver("ErrorEvent", lambda *_: said.append(1))
    scene.picture()
    scene.picture()
    wt.check_equal("said; has an error", (len(said), "no surface" in water.GetLastError()), (1, True))

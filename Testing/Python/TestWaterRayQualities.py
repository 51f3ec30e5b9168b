# SPDX-License-Identifier: BSD-3-Clause
"""Each quality of rays is closer to the ray caster than the one before, by the parts that it is made of."""

import numpy as np
import pytest
import water_test as wt
from TestWaterReflectionsOnWaves import truth_of
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer
from vtkwater import vtkWaterFrameAverage, vtkWaterProperty
from wave_scenes import POSTS_VIEWS, SKY, post_scene, rmse

FRAMES = 8


def mean_of(window, frames=FRAMES):
    average = vtkWaterFrameAverage()
    average.SetRenderWindow(window)
    average.SetNumberOfFrames(frames)
    wt.check_equal("the frames are averaged", average.Update(), True)
    image = average.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3).astype(float)


@pytest.fixture(scope="module")
def errors():
    """RMSE to the ray caster of each quality in all views of the posts together."""
    patch = pytest.MonkeyPatch()
    patch.setenv("VTK_WATER_SOFTWARE", "1")  # GPUs have one ray by the default
    found = {}
    for view in POSTS_VIEWS:
        made, water = post_scene(view)
        truth, mask = truth_of(view, made, water)
        look = water.GetWaterProperty()
        for name in ("fast", "default", "high"):
            look.SetRayTraceQuality(name)
            found.setdefault(name, []).append(rmse(made.picture(), truth, mask))
        look.SetRayTraceLayers(1)
        found.setdefault("high, one layer", []).append(rmse(made.picture(), truth, mask))
        look.SetRayTraceQuality("reference")
        found.setdefault("reference", []).append(rmse(mean_of(made.window), truth, mask))
    patch.undo()
    print(found)
    return {name: float(np.linalg.norm(each)) for name, each in found.items()}


# the better one, the other, and the most that its error may be of the other's
STEPS = (("default", "fast", 0.9), ("high", "default", 0.9), ("high", "high, one layer", 0.98),
         ("reference", "high", 0.7))


@pytest.mark.parametrize("better, other, most", STEPS)
def test_a_better_quality_is_closer(errors, better, other, most):
    """A better quality is closer to the ray caster; so are two layers than one."""
    wt.check_at_most(f"RMSE of {better} / of {other}", errors[better] / errors[other], most)


def test_calm_water_of_high_quality_has_smooth_edges():
    """Calm water of high quality is multisampled in a window that is not: its edges are mixtures."""
    colors = {}
    for name in ("default", "high"):
        made, water = post_scene("middle", waves=())
        water.GetWaterProperty().SetRayTraceQuality(name)
        picture = made.picture()
        colors[name] = wt.count_colors(picture[wt.water_mask(made, water)])
    wt.check_at_least("colours in the reflection, high / default", colors["high"] / colors["default"], 2.0)


def test_an_average_is_the_mean_over_the_pixel():
    """The average of a slanted edge's frames is the share of the pixel that lies behind it."""
    view = wt.View((64, 48), background=(0, 0, 0))
    sheet = vtkPlaneSource()
    sheet.SetOrigin(0, -100, 0)
    sheet.SetPoint1(200, -100, 0)
    sheet.SetPoint2(20, 100, 0)
    sheet.Update()
    wt.add_actor(view.renderer, sheet.GetOutput(), (1, 1, 1), lit=False)
    camera = wt.place_camera(view.renderer, (0, 0, 10), (0, 0, 0), (1, 20), view_up=(0, 1, 0))
    camera.ParallelProjectionOn()
    camera.SetParallelScale(24)  # a pixel is 1 wide
    place = (np.arange(2048) + 0.5) / 32
    x, y = np.meshgrid(place - 32, place[:1536] - 24)
    covered = (x > 0.1 * (y + 100)).reshape(48, 32, 64, 32).mean(axis=(1, 3))
    mean = mean_of(view.window, 64)[..., 0] / 255
    wt.check_at_most("the most that a pixel is off, 64 frames", float(np.abs(mean - covered).max()), 2.5 / 64)


def test_slopes_that_face_away_do_not_reflect_all_light():
    """Slopes at the pixel's middle that face away from the eye reflect as those that hide them, and not all light."""
    view = wt.View((120, 90), SKY)
    water = wt.add_water(view.renderer, None, (-300, 300, -300, 300), None)
    look = water.GetWaterProperty()
    for wave in ((0.05, 2.0, 80, 10), (0.03, 1.2, 100, 200)):
        look.AddWave(*wave)
    wt.place_camera(view.renderer, (0, -10, 1.5), (0, 10, 1), (0.3, 800))
    mask = wt.water_mask(view, water)
    look.SetRayTraceQuality("reference")
    look.SetOutputToReflectance()
    picture = view.picture()
    reflectance = (256 * picture[..., 0] + picture[..., 1]) / 65535
    wt.check_at_least("% of the pixels are water", 100 * mask.mean(), 20)
    wt.check_at_most("% of the water reflects all light", 100 * float((reflectance[mask] > 0.999).mean()), 1.0)


def test_an_average_in_the_middle_of_a_frame_is_refused():
    """Update in a render's own observer gives an error: the window cannot be rendered once more."""
    made, _ = post_scene("middle", waves=())
    average = vtkWaterFrameAverage()
    average.SetRenderWindow(made.window)
    said, results = wt.errors_of(average), []
    made.renderer.AddObserver("EndEvent", lambda *_: results.append(average.Update()))
    made.picture()
    wt.check_equal("there is a picture", results, [False])
    wt.check_equal("errors", len(said), 1)


def test_a_window_of_another_size_is_no_average():
    """A window whose size changes meanwhile gives no picture, even if the number of pixels stays; the output stays."""
    made, _ = post_scene("middle", waves=())
    average = vtkWaterFrameAverage()
    average.SetRenderWindow(made.window)
    average.SetNumberOfFrames(3)
    width, height = made.window.GetSize()
    tag = made.window.AddObserver("EndEvent", lambda *_: made.window.SetSize(height, width))
    wt.check_equal("there is a picture", average.Update(), False)
    made.window.RemoveObserver(tag)
    wt.check_equal("size of the output", average.GetOutput().GetDimensions(), (0, 0, 0))


def test_renderers_may_come_and_go_meanwhile():
    """Observers may add and remove renderers and cameras in the middle of an average."""
    made, _ = post_scene("middle", waves=())
    other = vtkRenderer()
    other.SetViewport(0.8, 0.8, 1, 1)
    changes = [lambda: made.window.AddRenderer(other), lambda: made.window.RemoveRenderer(other),
               lambda: made.renderer.SetActiveCamera(vtkCamera())]
    made.window.AddObserver("EndEvent", lambda *_: changes.pop(0)() if changes else None)
    mean_of(made.window, 5)


def test_a_shared_camera_is_shifted_by_pixels_of_the_largest_renderer():
    """A camera that renderers of two sizes share is shifted by less than a pixel of either."""
    def rows(is_shared):
        view = wt.View((200, 40), background=(0, 0, 0))
        narrow = vtkRenderer()
        narrow.SetViewport(0, 0, 0.1, 1)
        view.window.AddRenderer(narrow)
        view.renderer.SetViewport(0.1, 0, 1, 1)
        wt.add_actor(view.renderer, wt.box((5, 0, 0), (10, 100, 1)), (1, 1, 1), lit=False)
        camera = wt.place_camera(view.renderer, (0, 0, 10), (0, 0, 0), (1, 20), view_up=(0, 1, 0))
        camera.ParallelProjectionOn()
        narrow.SetActiveCamera(camera) if is_shared else None
        view.window.GetRenderers().InitTraversal()
        row = mean_of(view.window)[20, 20:, 0]
        return int(((row > 5) & (row < 250)).sum())
    wt.check_at_most("grey pixels of an edge", rows(True), rows(False) + 1)


def test_cameras_are_as_they_were():
    """Afterwards cameras have the transform that they had, and the picture is what it was."""
    made, _ = post_scene("middle")
    camera = made.renderer.GetActiveCamera()
    given = vtkTransform()
    given.Translate(0.1, 0, 0)
    camera.SetUserTransform(given)
    before = made.picture()
    mean_of(made.window, 3)
    wt.check_equal("the transform is the user's", camera.GetUserTransform(), given)
    wt.check_equal("pixels that differ", wt.difference(before, made.picture()), 0)


@pytest.mark.parametrize("name", ("High", "best", "", None))
def test_an_unknown_quality_is_refused(name):
    """A quality by an unknown name gives one error with the names there are, and changes nothing."""
    look = vtkWaterProperty()
    look.SetRayTraceQuality("high")
    said = wt.errors_of(look)
    look.SetRayTraceQuality(name)
    wt.check_equal("errors", len(said), 1)
    wt.check_equal("it names the qualities", "fast, default, high or reference" in said[0], True)
    wt.check_equal("steps, probes, rays, layers", (look.GetRayTraceSteps(), look.GetRayTraceProbes(),
                                                   look.GetRayTraceRays(), look.GetRayTraceLayers()), (24, 12, 8, 2))


def test_an_average_of_nothing_is_refused():
    """No window, and a number of frames out of range, give one error each; the number stays."""
    average = vtkWaterFrameAverage()
    said = wt.errors_of(average)
    wt.check_equal("there is a picture", average.Update(), False)
    wt.check_equal("errors", len(said), 1)
    wt.check_equal("it names the window", "RenderWindow" in said[0], True)
    average.SetNumberOfFrames(0)
    wt.check_equal("it names the range", "[1, 65536]" in said[-1], True)
    wt.check_equal("frames", average.GetNumberOfFrames(), 64)

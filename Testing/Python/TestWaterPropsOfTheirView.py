# SPDX-License-Identifier: BSD-3-Clause
"""Props that make what they show for the view that they are drawn in are right in the main view, also where a GPU
would draw the mirrored view after it."""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkRenderingAnnotation import vtkLegendScaleActor
from vtkmodules.vtkRenderingCore import vtkImageSlice
from vtkmodules.vtkRenderingImage import vtkImageResliceMapper
from vtkwater import vtkWaterReflectionPass as Pass

pytestmark = pytest.mark.usefixtures("on_a_gpu")


def legend():
    return vtkLegendScaleActor()


def slice_that_faces_the_camera():
    source = vtkRTAnalyticSource()
    source.SetWholeExtent(-2, 2, -2, 2, 0, 4)
    mapper = vtkImageResliceMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.SliceFacesCameraOn()
    mapper.SliceAtFocalPointOn()
    prop = vtkImageSlice()
    prop.SetMapper(mapper)
    prop.GetProperty().SetColorWindow(200)
    return prop


def pictures(make, skips):
    view = wt.View((240, 180))
    wt.add_actor(view.renderer, wt.pyramid((1, 2, 0.6), 1.5), (1, 0.6, 0.2))
    view.renderer.AddViewProp(make())
    water = wt.add_water(view.renderer, None, (-9, 9, -9, 9))
    water.GetReflectionPass().SetSkips(skips)
    camera = wt.place_camera(view.renderer, (5, -7, 3), (0, 0, 1), (0.1, 100))
    for _ in range(4):
        camera.Azimuth(7)
        camera.Zoom(1.1)
        yield view.picture()


@pytest.mark.parametrize("make", [legend, slice_that_faces_the_camera])
def test_the_main_view_shows_what_it_would_alone(make):
    """With all skips the pictures are those without any, in which the mirrored view is drawn first."""
    pairs = zip(pictures(make, Pass.SKIP_ALL), pictures(make, Pass.SKIP_NONE))
    wt.check_at_most(f"{make.__name__}: largest difference", max(int(np.abs(a - b).max()) for a, b in pairs), 0)

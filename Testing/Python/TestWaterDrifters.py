# SPDX-License-Identifier: BSD-3-Clause
"""Particles that drift in clear water, glyphs of moving points: each shows where it is, in the colour of its depth."""

import numpy as np
import pytest
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkGlyph3D
from vtkmodules.vtkFiltersSources import vtkRegularPolygonSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkGlyph3DMapper, vtkPolyDataMapper

SIZE = (400, 400)
HALF = 5.0  # the picture shows [-5, 5] x [-5, 5]
RADIUS = 0.4
ABSORPTION, DEEP = np.array((0.5, 0.25, 0.125)), np.array((0.0, 0.2, 0.4))
TIMES = (0.0, 0.5, 1.2, 0.25)  # also back in time
START = np.array(((1.0, 0.3, -0.5), (2.2, 1.0, -1.0), (3.4, -0.7, -2.0), (4.2, 0.8, -4.0)))  # x, y, z
KINDS = ("mapper", "filter")


def places_at(time):
    """The particles in a vortex that turns faster in the middle, which sinks them."""
    x, y, z = START.T
    turned = time * 3.0 / np.hypot(x, y)
    return np.stack([x * np.cos(turned) - y * np.sin(turned), x * np.sin(turned) + y * np.cos(turned),
                     z - 0.3 * time], axis=1)


class Drift:
    """Flat discs at the particles, over a black bed 30 m down, from straight above or aslant."""

    def __init__(self, kind, aslant=False, reflectance=0.0, height=0.0):
        self.view = wt.View(SIZE, (0.2, 0.3, 0.4) if reflectance else (0, 0, 0))
        self.height = height  # the particles are higher by it
        self.cloud = vtkPolyData()
        self.move(TIMES[0])
        disc = vtkRegularPolygonSource()
        disc.SetRadius(RADIUS)
        disc.SetNumberOfSides(24)
        disc.GeneratePolylineOff()
        if kind == "mapper":
            mapper = vtkGlyph3DMapper()
            mapper.SetInputData(self.cloud)
            mapper.SetSourceConnection(disc.GetOutputPort())
            mapper.ScalingOff()
        else:
            self.filter = vtkGlyph3D()
            self.filter.SetInputData(self.cloud)
            self.filter.SetSourceConnection(disc.GetOutputPort())
            self.filter.ScalingOff()
            mapper = vtkPolyDataMapper()
            mapper.SetInputConnection(self.filter.GetOutputPort())
        mapper.ScalarVisibilityOff()
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(1, 1, 1)
        actor.GetProperty().LightingOff()
        self.view.renderer.AddActor(actor)
        wt.add_actor(self.view.renderer, wt.box((0, 0, -30.5), (60, 60, 1)), (0, 0, 0), lit=False)
        self.water = wt.add_water(self.view.renderer, None, (-20, 20, -20, 20), reflectance)
        look = self.water.GetWaterProperty()
        look.RefractionOn()
        look.SetAbsorption(ABSORPTION)
        look.SetScattering(0, 0, 0)
        look.SetDeepColor(DEEP)
        place = ((-6, -14, 5), (0, 0, 1)) if aslant else ((0, 0, 20), (0, 1, 0))
        camera = wt.place_camera(self.view.renderer, place[0], (0, 0, 0), (1, 90), place[1])
        if not aslant:
            camera.ParallelProjectionOn()
            camera.SetParallelScale(HALF)

    def move(self, time):
        points = vtkPoints()
        points.SetDataTypeToDouble()
        points.SetData(numpy_to_vtk(places_at(time) + (0, 0, self.height), deep=True))
        self.cloud.SetPoints(points)

    def picture(self, time):
        self.move(time)
        return self.view.picture()


@pytest.mark.parametrize("kind", KINDS)
def test_a_particle_shows_at_its_place_in_the_colour_of_its_depth(kind):
    """From straight above nothing is displaced, and white leaves exp(-a d) white, and the rest the deep colour."""
    drift = Drift(kind)
    pixel = 2 * HALF / SIZE[0]
    for time in TIMES:
        picture = drift.picture(time)
        at = (np.arange(SIZE[0]) + 0.5) * pixel - HALF
        off, error = [], []
        for x, y, z in places_at(time):
            left = np.exp(ABSORPTION * z)
            wanted = 255 * (left + (1 - left) * DEEP)
            column, row = round((x + HALF) / pixel - 0.5), round((y + HALF) / pixel - 0.5)
            error.append(np.abs(picture[row, column] - wanted).max())
            near = np.hypot(at[None, :] - x, at[:, None] - y) < 1.5 * RADIUS
            shown = near & (picture[:, :, 2] > (wanted[2] + 255 * DEEP[2]) / 2)
            rows, columns = np.nonzero(shown)
            off.append(np.hypot(at[columns].mean() - x, at[rows].mean() - y) / pixel)
        wt.check_at_most(f"at {time} s: off by, pixels", round(float(max(off)), 3), 0.5)
        wt.check_at_most(f"at {time} s: colour off by, of 255", round(float(max(error)), 2), 1.5)
    wt.save(picture, wt.output_folder() / f"drifters_{kind}.png")


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("height", (0.0, 6.0), ids=("under", "over"))
def test_a_picture_depends_on_the_time_alone(kind, height):
    """Of drifters in the water, and of ones above it that it reflects: no frame keeps those of another."""
    drift = Drift(kind, True, 0.5, height)
    before = None
    for time in TIMES:
        shown = drift.picture(time)
        wt.check_equal(f"at {time} s: pixels that differ from a new scene's",
                       int((shown != Drift(kind, True, 0.5, height).picture(time)).any(axis=2).sum()), 0)
        if before is not None:
            wt.check_at_least(f"at {time} s: pixels that have changed", int((shown != before).any(axis=2).sum()), 500)
        before = shown
    if height:
        drift.water.VisibilityOff()
        without = drift.view.picture()
        drift.water.VisibilityOn()
        drift.water.SceneReflectionOff()
        calm = drift.view.picture()
        wt.check_at_least("pixels of their reflections", int((np.abs(before - calm).max(axis=2) > 20).sum()), 300)
        wt.check_at_least("pixels of the drifters", int((without.min(axis=2) == 255).sum()), 100)
    wt.save(before, wt.output_folder() / f"drifters_aslant_{kind}_{height:g}.png")

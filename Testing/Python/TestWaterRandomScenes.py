# SPDX-License-Identifier: BSD-3-Clause
"""A random scene of the accuracy suite is the same whenever it is made, and its rays are those of VTK's camera."""

import pathlib
import sys

import numpy as np
import pytest
import ray_caster
import water_test as wt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkCoordinate

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "Accuracy"))

import scene_generator  # noqa: E402
import tables  # noqa: E402

SIZE = (80, 60)


def points_of(scene):
    return np.concatenate([vtk_to_numpy(actor.GetMapper().GetInput().GetPoints().GetData())
                           for actor in scene.made.renderer.GetActors() if not actor.IsA("vtkWaterActor")])


def test_a_seed_makes_the_same_scene_again():
    """A seed makes the same scene again, whatever others were made between."""
    first, _, again = (scene_generator.make(seed, SIZE) for seed in (5, 6, 5))
    wt.check_equal("facts are the same", first.facts == again.facts and first.waves == again.waves, True)
    wt.check_equal("places are the same", np.array_equal(points_of(first), points_of(again)), True)
    wt.check_equal("difference of the pictures", wt.difference(first.made.picture(), again.made.picture()), 0)


def test_a_seed_makes_another_scene_than_its_neighbour():
    """Another seed makes another scene."""
    first, other = (scene_generator.make(seed, SIZE) for seed in (5, 6))
    wt.check_equal("facts are the same", first.facts == other.facts, False)


@pytest.mark.parametrize("seed", range(3))
def test_no_colour_is_bluer_than_green(seed):
    """No colour of a scene has more blue than green, so that a magenta background is known wherever it shows."""
    scene = scene_generator.make(seed, SIZE)
    for actor in scene.made.renderer.GetActors():
        scalars = None if actor.IsA("vtkWaterActor") else actor.GetMapper().GetInput().GetPointData().GetScalars()
        colors = [actor.GetProperty().GetColor()] if scalars is None else vtk_to_numpy(scalars).astype(int)
        bluer = max(color[2] - color[1] for color in colors)
        wt.check_at_most("the most that blue is over green", bluer, 0)


CAMERAS = {"plain": (False, (0, 0), 0), "off axis": (False, (0.4, -0.3), 0), "rolled": (False, (0, 0), 25),
           "parallel": (True, (0, 0), 0), "parallel, off axis": (True, (-0.3, 0.45), 10)}


@pytest.mark.parametrize("name", CAMERAS)
def test_rays_go_through_what_vtk_shows_there(name):
    """A ray through a place of the picture meets what VTK shows at that place, whatever the camera."""
    is_parallel, center, roll = CAMERAS[name]
    view = wt.View((400, 300))
    camera = wt.place_camera(view.renderer, (2, -13, 4), (0.5, 0, 1), (0.5, 150))
    camera.SetParallelProjection(is_parallel)
    camera.SetParallelScale(4)
    camera.SetWindowCenter(*center)
    camera.Roll(roll)
    x, y = np.array((-0.9, 0.2, 0.7)), np.array((-0.8, 0.9, 0.1))
    start, ray = ray_caster.rays_at(camera, (400, 300), x, y)
    place = vtkCoordinate()
    place.SetCoordinateSystemToWorld()
    found = []
    for point in start + 9 * ray:
        place.SetValue(*point)
        found.append(place.GetComputedDoubleViewportValue(view.renderer))
    right = np.stack([(x + 1) * 200, (y + 1) * 150], axis=1)
    wt.check_at_most("px between a ray and what VTK shows", float(np.abs(np.array(found) - right).max()), 1e-6)


def test_figures_replace_what_is_between_the_marks(tmp_path):
    """The table of figures replaces the former one in a report, whose other text stays; a report must have the marks."""
    report = tmp_path / "report.md"
    report.write_text("before\n" + "\n".join((tables.FIGURES[0], "old", tables.FIGURES[1])) + "\nafter\n")
    tables.put_figures(report, "new")
    text = report.read_text()
    wt.check_equal("what is between the marks", tables.figures_in(text), "new")
    wt.check_equal("the other text", (text.startswith("before\n"), text.endswith("\nafter\n")), (True, True))
    report.write_text("no marks")
    with pytest.raises(ValueError, match="no marks"):
        tables.put_figures(report, "new")
    wt.check_equal("what has no marks", tables.figures_in("no marks"), "")

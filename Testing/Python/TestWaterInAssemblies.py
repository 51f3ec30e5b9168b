# SPDX-License-Identifier: BSD-3-Clause
"""Water, and what it reflects, may be a part of something: of an assembly, of levels of detail, of axes.

The truth of each claim is a scene in which the same thing is an ordinary actor.
"""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingAnnotation import vtkAxesActor
from vtkmodules.vtkRenderingCore import vtkAssembly, vtkLODProp3D, vtkPropAssembly, vtkPropCollection
from vtkwater import vtkWaterActor
from water_scenes import SHEET, add_thing, plain_picture, view


@pytest.mark.parametrize("with_scene", (True, False), ids=("with_the_scene", "alone"))
@pytest.mark.parametrize("assembly_class", (vtkAssembly, vtkPropAssembly))
def test_a_sheet_in_an_assembly_covers_the_scene(assembly_class, with_scene):
    """Water in an assembly, alone or with the scene, covers the scene, and nothing is walked twice."""
    assembly = assembly_class()
    name = f"{assembly.GetClassName()} of water{' and scene' if with_scene else ''}"
    scene = view()
    actor = add_thing(scene.renderer)
    water = vtkWaterActor()
    assembly.AddPart(water)
    if with_scene:
        scene.renderer.RemoveActor(actor)
        assembly.AddPart(actor)
    scene.renderer.AddViewProp(assembly)
    errors = wt.errors_of(water)
    for _ in range(3):
        scene.picture()
    wt.check_equal(f"{name}: bounds of the sheet", np.round(water.GetBounds()[:4], 6).tolist(),
                   np.round(actor.GetBounds()[:4], 6).tolist())
    wt.check_equal(f"{name}: errors", len(errors), 0)


def test_a_level_of_detail_is_reflected_in_the_first_frame():
    """A level of detail that only the mirror sees, or that is chosen after the water is asked, is reflected."""
    scene = view()
    wt.add_water(scene.renderer, None, SHEET)
    actor = add_thing(scene.renderer)
    scene.renderer.RemoveActor(actor)
    levels = vtkLODProp3D()
    levels.AddLOD(actor.GetMapper(), actor.GetProperty(), 0.0)
    scene.renderer.AddViewProp(levels)
    wt.check_equal("vtkLODProp3D after the water: first picture, error",
                   wt.difference(scene.picture(), plain_picture()), 0)


def axes_picture(in_parts):
    scene = view()
    wt.add_water(scene.renderer, None, SHEET)
    axes = vtkAxesActor()
    axes.AxisLabelsOff()
    axes.SetTotalLength(2, 2, 2)
    transform = vtkTransform()
    transform.Translate(0, 0, -1)
    axes.SetUserTransform(transform)
    scene.renderer.AddActor(wt.reflect(axes))
    scene.picture()
    if in_parts:
        parts = vtkPropCollection()
        axes.GetActors(parts)
        scene.renderer.RemoveActor(axes)
        for i in range(parts.GetNumberOfItems()):
            scene.renderer.AddActor(parts.GetItemAsObject(i))
    return scene.picture()


def test_axes_are_reflected_as_their_parts():
    """Axes that stand half under water are reflected as the ordinary actors that they are made of."""
    wt.check_equal("vtkAxesActor half under water: error", wt.difference(axes_picture(False), axes_picture(True)), 0)

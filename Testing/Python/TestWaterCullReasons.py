# SPDX-License-Identifier: BSD-3-Clause
"""Every prop that a mirrored view leaves out is left out for the right reason, and the pass says so.

So does it when there is no mirrored view at all; water never mirrors itself, or other water, without end.
"""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.vtkCommonCore import vtkInformation
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkRenderingAnnotation import vtkAxesActor, vtkCubeAxesActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkAssembly,
    vtkBillboardTextActor3D,
    vtkFollower,
    vtkPolyDataMapper,
    vtkTextActor,
)
from vtkmodules.vtkRenderingFreeType import vtkVectorText
from vtkwater import vtkWaterReflectionPass as Pass

RED, GREEN = (1, 0, 0), (0, 1, 0)
SHEET = (-9, 9, -9, 9)

# How many of Scene's nine props meet each fate.
EXPECTED = {
    "DRAWN": 1,
    "INVISIBLE": 1,
    "WATER_ITSELF": 1,
    "MARKED_NOT_REFLECTED": 1,
    "OVERLAY": 1,
    "LABEL": 1,
    "EMPTY": 1,
    "BEHIND_PLANE": 1,
    "OUT_OF_VIEW": 1,
    "OUT_OF_WATER": 0,  # the red box alone comes so far: the water shows it, it is large, its shader is VTK's
    "TOO_SMALL": 0,
    "REFUSED": 0,
}


class Scene:
    """Water with one prop of each kind: the red one alone is to be seen in it."""

    def __init__(self, in_assembly=False):
        self.view = wt.View((320, 240), background=(0, 0, 0))
        renderer = self.view.renderer
        self.water = wt.add_water(renderer, wt.plane((0, 0, 0), (0, 0, 1)), SHEET)
        if in_assembly:
            renderer.RemoveActor(self.water)
            assembly = vtkAssembly()
            self.water = wt.vtkWaterActor()
            self.water.SetSheetBounds(SHEET)
            self.water.GetWaterProperty().SetReflectanceModeToConstant()
            assembly.AddPart(self.water)
            renderer.AddActor(assembly)
        self.mirror = self.water.GetReflectionPass()
        self.mirror.SetSkips(Pass.SKIP_ALL & ~Pass.UNCHANGED_VIEWS)  # every frame decides anew
        self.add_props()
        self.camera = wt.place_camera(renderer, (0, -15, 5), (0, 0, 0), (1, 60))

    def add_props(self):
        def add_box(center, color):
            return wt.add_actor(self.view.renderer, wt.box(center, (2, 2, 2)), color, lit=False)

        add_box((0, 3, 2), RED)
        add_box((3, 3, 2), GREEN).VisibilityOff()
        wt.leave_out(add_box((-3, 3, 2), GREEN))
        add_box((0, 3, -2), GREEN)  # under the water
        add_box((500, 3, 2), GREEN)  # far aside
        self.view.renderer.AddActor(vtkActor())  # without a mapper its bounds are none: 1, -1 in each direction
        overlay = vtkTextActor()
        overlay.SetInput("overlay")
        self.view.renderer.AddActor(overlay)
        label = vtkBillboardTextActor3D()
        label.SetInput("label")
        label.SetPosition(2, 0, 1)
        self.view.renderer.AddActor(label)

    def decision(self):
        self.view.picture()
        return self.mirror.GetDecisionAsString()


def test_every_fate_is_counted():
    """Of nine props of nine kinds each meets its own fate: one is drawn, one is empty, seven have other reasons."""
    scene = Scene()
    scene.view.picture()
    for name, count in EXPECTED.items():
        fate = getattr(Pass, name)
        wt.check_equal(f"fate '{Pass.GetFateAsString(fate)}'", scene.mirror.GetFateCount(fate), count)
    wt.check_equal("fates", Pass.NUMBER_OF_FATES, len(EXPECTED))
    wt.check_equal("all props have a fate", sum(scene.mirror.GetFateCount(i) for i in range(Pass.NUMBER_OF_FATES)), 9)
    wt.check_equal("props reflected", scene.mirror.GetNumberOfPropsReflected(), 1)


def cube_axes(camera):
    axes = vtkCubeAxesActor()
    axes.SetBounds(-3, 3, -3, 3, 0.2, 3)
    axes.SetCamera(camera)
    return axes


def axes_of(length):
    axes = vtkAxesActor()
    axes.SetTotalLength(length, length, length)
    return axes


def text_of(actor, is_enlarged=False):
    text = vtkVectorText()
    text.SetText("Ripple")
    larger = vtkTransformPolyDataFilter()
    larger.SetTransform(vtkTransform())
    larger.SetInputConnection(text.GetOutputPort())
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection((larger if is_enlarged else text).GetOutputPort())
    actor.SetMapper(mapper)
    actor.SetPosition(-2, 0, 0.5)
    return actor


def turned(actor, camera):
    actor.SetCamera(camera)
    return actor


def upright(actor):
    actor.RotateX(80)
    return actor


def picture_of_a_follower(camera):
    """A tree, for example, as a picture that turns to the camera: an object of the scene."""
    actor = turned(vtkFollower(), camera)
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(wt.box((0, 0, 1), (2, 2, 2)))
    actor.SetMapper(mapper)
    return actor


@pytest.mark.parametrize("make, is_label", (
    (cube_axes, True), (lambda camera: axes_of(3), True), (lambda camera: turned(text_of(vtkFollower()), camera), True),
    (lambda camera: turned(text_of(vtkFollower(), True), camera), True),
    (lambda camera: upright(text_of(vtkActor())), False), (picture_of_a_follower, False)),
    ids=("cube_axes", "axes", "text", "enlarged_text", "text_as_geometry", "picture"))
def test_rulers_and_axes_are_reflected_on_request_alone(make, is_label):
    """Annotations are no objects of the scene. The key with 0 reflects them, with 1 nothing."""
    pictures, fates = {}, {}
    for key in (None, 0, 1):
        view = wt.View((320, 240), background=(0, 0, 0))
        water = wt.add_water(view.renderer, wt.plane((0, 0, 0), (0, 0, 1)), SHEET)
        camera = wt.place_camera(view.renderer, (0, -15, 5), (0, 0, 0), (1, 60))
        prop = make(camera)
        if key is not None:
            (wt.leave_out if key else wt.reflect)(prop)
        view.renderer.AddViewProp(prop)
        pictures[key] = view.picture()
        wt.save(pictures[key], wt.output_folder() / f"annotation_{prop.GetClassName()}_{key}.png")
        fates[key] = water.GetReflectionPass().GetFateCount(Pass.LABEL)
    wt.check_equal("labels without the key, with 0, with 1", list(fates.values()), [int(is_label), 0, 0])
    wt.check_at_least("pixels that its reflection changes", int((pictures[0] != pictures[1]).any(axis=2).sum()), 100)
    wt.check_equal("pixels that differ without the key", int((pictures[None] != pictures[is_label]).any(axis=2).sum()), 0)


def test_a_stand_in_for_axes_is_reflected():
    """Who gives them one wants them in the water."""
    view = wt.View((320, 240), background=(0, 0, 0))
    water = wt.add_water(view.renderer, wt.plane((0, 0, 0), (0, 0, 1)), SHEET)
    wt.place_camera(view.renderer, (0, -15, 5), (0, 0, 0), (1, 60))
    axes, keys = axes_of(3), vtkInformation()
    keys.Set(Pass.STAND_IN(), axes_of(2))
    axes.SetPropertyKeys(keys)
    view.renderer.AddViewProp(axes)
    view.picture()
    wt.check_equal("props reflected", water.GetReflectionPass().GetNumberOfPropsReflected(), 1)


def test_an_unknown_fate_counts_nothing():
    """There are no props of a fate that there is not."""
    scene = Scene()
    scene.view.picture()
    wt.check_equal("unknown fate counts 0", scene.mirror.GetFateCount(99), 0)


def test_water_shows_what_is_drawn_and_nothing_else():
    """The drawn prop is seen in the water, and none of those left out."""
    scene = Scene()
    picture = scene.view.picture()
    mask = wt.water_mask(scene.view, scene.water)
    wt.check_at_least("red in the water", int(((picture == (255, 0, 0)).all(axis=2) & mask).sum()), 200)
    wt.check_equal("green in the water", int(((picture == (0, 255, 0)).all(axis=2) & mask).sum()), 0)


def test_two_waters_do_not_mirror_each_other_without_end():
    """A second sheet over the first, facing it, is one prop more in its mirror: nothing recurses."""
    scene = Scene()
    scene.view.picture()
    ceiling = wt.add_water(scene.view.renderer, wt.plane((0, 0, 6), (0, 0, 1)), SHEET)
    ceiling.GetWaterProperty().SetDeepColor(0, 0, 1)
    renders = scene.mirror.GetNumberOfReflectionRenders()
    scene.view.picture()
    wt.check_equal("two waters: renders of the first a frame",
                   scene.mirror.GetNumberOfReflectionRenders() - renders, 1)
    wt.check_equal("two waters: left out of the mirror", scene.mirror.GetFateCount(Pass.WATER_ITSELF), 1)


def test_an_assembly_with_the_water_is_not_drawn_again():
    """Water in an assembly gives the picture of water by itself: the assembly is not drawn while it is drawn."""
    scene = Scene(in_assembly=True)
    again = scene.view.picture()
    wt.check_equal("in an assembly: decision", scene.mirror.GetDecisionAsString(), "rendered")
    off = (np.abs(again - Scene().view.picture()).max(axis=2) > 1).mean() * 100
    wt.check_at_most("in an assembly: % of pixels off", float(off), 0.02)


@pytest.mark.parametrize("in_assembly", (True, False), ids=("in_an_assembly", "by_itself"))
def test_nothing_is_rendered_for_water_that_reflects_nothing(in_assembly):
    """Water of reflectance 0 needs no mirrored view, and that is the reason given."""
    scene = Scene(in_assembly)
    scene.water.GetWaterProperty().SetReflectance(0)
    wt.check_equal("reflectance 0", scene.decision(), "not rendered: the water reflects nothing")


@pytest.mark.parametrize("in_assembly", (True, False), ids=("in_an_assembly", "by_itself"))
def test_nothing_is_rendered_for_water_seen_edge_on(in_assembly):
    """Water that a parallel view looks along needs no mirrored view, and that is the reason given."""
    scene = Scene(in_assembly)
    scene.camera.SetPosition(0, -15, 0)
    scene.camera.ParallelProjectionOn()
    wt.check_equal("edge-on, parallel", scene.decision(), "not rendered: the water is seen edge-on")

# SPDX-License-Identifier: BSD-3-Clause
"""Hardware selection and stereo work with water in the scene, added alone or with its pass composed."""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.vtkRenderingCore import vtkHardwareSelector
from vtkwater import vtkWaterReflectionPass


def build(composed):
    view = wt.View((200, 150))
    for data, color in wt.columns_and_pyramids():
        wt.add_actor(view.renderer, data, color)
    water = wt.add_water(view.renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-9, 9, -6, 9))
    camera = view.renderer.GetActiveCamera()
    camera.SetPosition(2, -13, 4)
    camera.SetViewUp(0, 0, 1)
    camera.SetClippingRange(1, 60)
    if composed:
        view.renderer.SetPass(vtkWaterReflectionPass())
    return view, water


def selected(view):
    selector = vtkHardwareSelector()
    selector.SetRenderer(view.renderer)
    selector.SetArea(0, 0, 199, 149)
    selection = selector.Select()
    result = {}
    for i in range(selection.GetNumberOfNodes()):
        node = selection.GetNode(i)
        prop = node.GetProperties().Get(node.PROP())
        ids = node.GetSelectionList()
        result[prop] = sorted(ids.GetValue(k) for k in range(ids.GetNumberOfTuples()))
    return result


def mono_picture(view, eye, composed):
    """What a camera in the place of an eye of a view's camera sees, with the same frustum, without stereo."""
    mono, _ = build(composed)
    camera = view.renderer.GetActiveCamera()
    mono_camera = mono.renderer.GetActiveCamera()
    aspect = view.renderer.GetTiledAspectRatio()
    camera.SetLeftEye(eye == "Left")
    mono_camera.SetExplicitProjectionTransformMatrix(camera.GetProjectionTransformMatrix(aspect, -1, 1))
    mono_camera.SetUseExplicitProjectionTransformMatrix(True)
    view_matrix = camera.GetModelViewTransformMatrix()
    inverse = np.linalg.inv([[view_matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    mono_camera.SetPosition(inverse[:3, 3])
    mono_camera.SetFocalPoint(inverse[:3, 3] - inverse[:3, 2])
    mono_camera.SetViewUp(inverse[:3, 1])
    return mono.picture()


COMPOSED = pytest.mark.parametrize("composed, name", [(False, "actor alone"), (True, "pass composed by hand")],
                                   ids=["actor_alone", "composed"])


@COMPOSED
def test_hardware_selection_finds_the_same_props_and_the_water(composed, name):
    """A selection finds what it finds without a mirror, and the water; it mirrors nothing and changes no picture."""
    view, water = build(composed)
    water.GetWaterProperty().SetReflectance(0)
    view.renderer.SetPass(None)
    view.picture()
    plain = selected(view)
    if composed:
        view.renderer.SetPass(vtkWaterReflectionPass())
    water.GetWaterProperty().SetReflectance(1)
    picture = view.picture()
    mirror = water.GetReflectionPass()
    rendered = mirror.GetNumberOfReflectionRenders()
    with_mirror = selected(view)
    wt.check_at_least(f"{name}: mirrors rendered before selecting", rendered, 1)
    wt.check_equal(f"{name}: mirrors rendered while selecting", mirror.GetNumberOfReflectionRenders() - rendered, 0)
    wt.check_equal(f"{name}: decision", mirror.GetDecisionAsString(), "not rendered: hardware selection")
    wt.check_at_least(f"{name}: props selected", len(with_mirror), 8)
    wt.check_equal(f"{name}: same props and ids as without mirror", with_mirror == plain, True)
    wt.check_equal(f"{name}: the water is selectable", water in with_mirror, True)
    water.PickableOff()
    wt.check_equal(f"{name}: not when it is not pickable", water in selected(view), False)
    wt.check_equal(f"{name}: next picture, largest change", int(np.abs(view.picture() - picture).max()), 0)


@COMPOSED
def test_each_eye_has_its_own_reflection(composed, name):
    """Each eye's picture in stereo has its own reflection, equal to that of a camera in that eye's place."""
    eyes = {}
    for eye in ("Left", "Right"):
        view, _ = build(composed)
        view.window.StereoRenderOn()
        getattr(view.window, f"SetStereoTypeTo{eye}")()
        first = view.picture()
        eyes[eye] = view.picture()
        wt.check_equal(f"{name}: {eye} eye, first frame equals later ones, largest error",
                       int(np.abs(first - eyes[eye]).max()), 0)
        off = (np.abs(mono_picture(view, eye, composed) - eyes[eye]).max(axis=2) > 1).mean() * 100
        wt.check_at_most(f"{name}: {eye} eye against a mono camera there, % of pixels off", float(off), 0.02)
    wt.check_at_least(f"{name}: mean difference of the eyes", float(np.abs(eyes["Left"] - eyes["Right"]).mean()), 1.0)

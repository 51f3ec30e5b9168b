# SPDX-License-Identifier: BSD-3-Clause
"""Rendering the mirror changes nothing else: not a pixel outside the water, no flag, no time stamp.

The same frame is rendered with the mirror on (reflectance 1) and off (reflectance 0). Where the water
is not seen, the two must be equal to the bit. SSAO draws from random samples: there the bound is
the difference of two frames without any mirror.
"""

import numpy as np
import pytest
import water_test as wt
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLRenderPass, vtkRenderStepsPass, vtkSSAAPass
from vtkwater import vtkWaterReflectionPass as Pass

ALWAYS_RENDERED = Pass.SKIP_ALL & ~Pass.UNCHANGED_VIEWS

# How many pixels away a filter over the finished picture takes colour from.
FILTER_REACH = {"FXAA": 8, "supersampling pass": 2}

MODES = (
    "plain", "headlight", "multisampling", "FXAA", "SSAO", "translucent", "depth peeling", "parallel",
    "sub-viewport", "two viewports", "pass chain", "supersampling pass", "stereo left", "stereo right",
    "stereo anaglyph",
)


def build(mode):
    view = wt.View((320, 240), samples=8 if mode == "multisampling" else 0, is_new=True)
    renderers = [view.renderer]
    if mode == "two viewports":
        view.renderer.SetViewport(0, 0, 0.5, 1)
        renderers.append(view.add_renderer((0.4, 0.2, 0.1), (0.5, 0, 1, 1)))
    if mode == "sub-viewport":
        view.renderer.SetViewport(0.1, 0.2, 0.8, 0.9)
    waters = []
    for index, renderer in enumerate(renderers):
        for number, (data, color) in enumerate(wt.columns_and_pyramids()):
            translucent = mode in ("translucent", "depth peeling") and number % 3 == 0
            wt.add_actor(renderer, data, color, specular=0.3, opacity=0.5 if translucent else 1)
            if number == 5:  # neither first nor last
                waters.append(wt.add_water(renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-9, 9, -6, 9)))
        wt.add_scene_light(renderer, (3, -5, 8))
        camera = renderer.GetActiveCamera()
        camera.SetPosition(2 + index, -13, 4)
        camera.SetViewUp(0, 0, 1)
        camera.SetClippingRange(1, 60)
        if mode == "parallel":
            camera.ParallelProjectionOn()
            camera.SetParallelScale(5)
        if mode == "FXAA":
            renderer.UseFXAAOn()
        if mode == "SSAO":
            renderer.UseSSAOOn()
            renderer.SetSSAORadius(0.5)
        if mode == "depth peeling":
            renderer.UseDepthPeelingOn()
            view.window.SetAlphaBitPlanes(True)
        if mode == "pass chain":
            renderer.SetPass(vtkRenderStepsPass())
        if mode == "supersampling pass":
            ssaa = vtkSSAAPass()
            ssaa.SetDelegatePass(vtkRenderStepsPass())
            renderer.SetPass(ssaa)
    for water in waters:
        water.GetReflectionPass().SetSkips(ALWAYS_RENDERED)
    if mode == "headlight":
        view.renderer.RemoveAllLights()
    if mode == "two viewports":
        # VTK keeps the light uniforms of a program that two viewports share for the first of them;
        # a changed light list makes it set them again, so that the frames without a mirror are right
        for renderer in renderers:
            renderer.AddObserver("StartEvent", lambda caller, event: caller.GetLights().Modified())
    if mode.startswith("stereo"):
        view.window.StereoRenderOn()
        getattr(view.window, "SetStereoTypeTo" + mode.split()[1].capitalize())()
    return view, waters


def set_reflectance(waters, reflectance):
    for water in waters:
        water.GetWaterProperty().SetReflectance(reflectance)


def flags(view):
    renderer = view.renderer
    return {
        "FXAA": renderer.GetUseFXAA(),
        "SSAO": renderer.GetUseSSAO(),
        "peeling": renderer.GetUseDepthPeeling(),
        "shadows": renderer.GetUseShadows(),
        "pass": renderer.GetPass(),
        "stereo": view.window.GetStereoRender(),
        "samples": view.window.GetMultiSamples(),
        "lights follow": renderer.GetLightFollowCamera(),
        "layers": view.window.GetNumberOfLayers(),
    }


@pytest.mark.parametrize("mode", MODES, ids=[mode.replace(" ", "_") for mode in MODES])
def test_not_a_pixel_outside_the_water_changes(mode):
    """Rendering the mirror changes no pixel outside the water and no flag, nor does using its view again."""
    view, waters = build(mode)
    set_reflectance(waters, 0)
    view.picture()
    before = flags(view)
    off = view.picture()
    noise = np.abs(off - view.picture())
    set_reflectance(waters, 1)
    first = view.picture()  # the first frame with a mirror must be right already
    on = view.picture()
    for water in waters:
        wt.check_equal(f"{mode}: decision", water.GetReflectionPass().GetDecisionAsString(), "rendered")
        water.GetReflectionPass().SetSkips(Pass.SKIP_ALL)
    view.picture()
    reused = view.picture()
    for water in waters:
        # there the lists of lights are modified in every frame
        wt.check_equal(f"{mode}: decision later", water.GetReflectionPass().GetDecision(),
                       Pass.RENDERED if mode == "two viewports" else Pass.REUSED)
    wt.check_equal(f"{mode}: flags unchanged", flags(view) == before, True)

    # the water's pixels, and those that a filter over the whole picture mixes with them
    mask = np.zeros(off.shape[:2], bool)
    for color in ((1, 0, 1), (0, 1, 0)):
        for water in waters:
            water.GetWaterProperty().SetReflectance(0)
            water.GetWaterProperty().SetDeepColor(color)
        mask |= np.abs(view.picture() - off).max(axis=2) > 0
    for _ in range(FILTER_REACH.get(mode, 0)):
        grown = mask.copy()
        grown[1:] |= mask[:-1]
        grown[:-1] |= mask[1:]
        grown[:, 1:] |= mask[:, :-1]
        grown[:, :-1] |= mask[:, 1:]
        mask = grown
    wt.check_at_least(f"{mode}: water pixels", int(mask.sum()), 2000)
    wt.check_at_least(f"{mode}: other pixels", int((~mask).sum()), 2000)
    wt.check_at_least(
        f"{mode}: water pixels that reflect", int((np.abs(on - off).max(axis=2) > 8)[mask].sum()), 500
    )
    bound = int(noise[~mask].max())
    for name, frame in (("first frame", first), ("later frame", on), ("used again", reused)):
        error = np.abs(frame - off)[~mask]
        if mode == "SSAO":
            wt.check_at_most(f"{mode}: {name}, mean error (noise {noise[~mask].mean():.5f})",
                             float(error.mean()), 0.01 + 2 * float(noise[~mask].mean()))
        else:
            wt.check_equal(f"{mode}: run-to-run noise", bound, 0)
            wt.check_equal(f"{mode}: {name}, largest error", int(error.max()), 0)


def test_no_time_stamp_event_or_key_is_left():
    """Camera, props, lights and observers are as a frame without a mirror leaves them."""
    view, waters = build("plain")
    events = []
    for name in ("ActiveCameraEvent", "ModifiedEvent", "ResetCameraClippingRangeEvent"):
        view.renderer.AddObserver(name, lambda caller, event: events.append(event))
        view.renderer.GetActiveCamera().AddObserver(name, lambda caller, event: events.append(event))

    def stamps():
        renderer = view.renderer
        things = [renderer, renderer.GetActiveCamera(), renderer.GetLights(), renderer.GetViewProps(),
                  renderer.GetLights().GetItemAsObject(0), view.window]
        for actor in actors:
            things += [actor, actor.GetProperty(), actor.GetMapper()]
        return [thing.GetMTime() for thing in things]

    actors = [view.renderer.GetViewProps().GetItemAsObject(i) for i in range(13)]
    set_reflectance(waters, 0)
    view.window.Render()
    view.window.Render()
    set_reflectance(waters, 1)
    before = stamps()
    events.clear()
    rendered = waters[0].GetReflectionPass().GetNumberOfReflectionRenders()
    for _ in range(3):
        view.window.Render()
    wt.check_equal(
        "mirrors rendered", waters[0].GetReflectionPass().GetNumberOfReflectionRenders() - rendered, 3
    )
    wt.check_equal("events of renderer and camera in three frames", events, [])
    wt.check_equal("modification times unchanged", stamps() == before, True)
    passes = vtkOpenGLRenderPass.RenderPasses()
    left = [actor.GetPropertyKeys() is not None and actor.GetPropertyKeys().Has(passes)
            for actor in actors if actor not in waters]
    wt.check_equal("keys left on props", sum(bool(one) for one in left), 0)

# SPDX-License-Identifier: BSD-3-Clause
"""Row Passes and flags of the mirror matrix: what a renderer or a user adds to the drawing of a frame.

Filters over the finished picture act on the water as on everything: the composed picture has them, the
mirrored one does not. Flags that were on are on afterwards.
"""

import mirror_matrix as mm
import numpy as np
import water_test as wt
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass,
    vtkEDLShading,
    vtkGaussianBlurPass,
    vtkLightsPass,
    vtkOpaquePass,
    vtkOverlayPass,
    vtkRenderPassCollection,
    vtkRenderStepsPass,
    vtkSequencePass,
    vtkSobelGradientMagnitudePass,
    vtkSSAAPass,
    vtkToneMappingPass,
    vtkTranslucentPass,
)
from vtkwater import vtkWaterReflectionPass

row = mm.Results("Passes and flags", __file__)


def things(scene, has_glass=True):
    """No colour is over 1: what is drawn before a pass may keep more than a picture of 8 bits."""
    scene.add_data(wt.sphere((0, 0, 0.4), 1.5), (1, 0.6, 0.2))
    scene.add_data(wt.box((2.4, 0.8, 0.4), (0.8, 0.8, 2.2)), (0.3, 0.8, 0.4))
    if has_glass:
        scene.add_data(wt.box((-2.4, 0, 0.8), (0.8, 0.8, 1.0)), (0.4, 0.5, 1), opacity=0.5)
    wt.add_scene_light(scene.renderer, (2, -4, 5))


FLAGS = ("UseFXAA", "UseSSAO", "UseDepthPeeling", "UseDepthPeelingForVolumes", "UseShadows", "UseHiddenLineRemoval",
         "UseImageBasedLighting", "TwoSidedLighting", "LightFollowCamera", "AutomaticLightCreation", "Erase",
         "PreserveColorBuffer", "PreserveDepthBuffer", "Pass")


def flags_of(scene):
    values = {name: getattr(scene.renderer, "Get" + name)() for name in FLAGS}
    values["samples"] = scene.window.GetMultiSamples()
    values["alpha"] = scene.window.GetAlphaBitPlanes()
    return values


def show(name, apply, in_mirror=None, others=mm.FILTERED, **options):
    """apply(scene) turns on what the cell is about, in_mirror(scene) what of it is right in the mirrored picture."""
    remembered = {}

    def fill(scene):
        things(scene)
        if scene.kind == mm.SEEN:
            apply(scene)
            scene.pixels()  # before there is water
            remembered["scene"], remembered["flags"] = scene, flags_of(scene)
        elif scene.kind == mm.COMPOSED:
            apply(scene)
        elif in_mirror:
            in_mirror(scene)

    row.show(name, fill, others=others, **options)
    row.say(f"{name}: the renderer's flags are kept", flags_of(remembered["scene"]) == remembered["flags"])


def cell(name, *arguments, **options):
    """Registers a cell; arguments as those of show."""
    row.register(name, show, *arguments, **options)


def filtered(name, apply, reach, scale=1, reason=None, exact=True):
    """A filter of the finished picture: water that is further than its reach from all else shows what the
    filter makes of the mirrored picture."""
    scene = mm.Scene(mm.SEEN)
    things(scene, has_glass=False)
    water = wt.add_water(scene.renderer, wt.plane((0, 0, 0), (0, 0, 1)), mm.SHEET)
    water.GetReflectionPass().SetTextureScale(scale)
    pixels = mm.water_pixels(scene, water)
    apply(scene)
    seen = scene.pixels()
    for _ in range(reach):
        inner = pixels.copy()
        for axis in (0, 1):
            for step in (-1, 1):
                inner &= np.roll(pixels, step, axis)
        pixels = inner

    def mirrored(fill):
        other = mm.Scene(mm.MIRRORED)
        fill(other)
        apply(other)
        mm.mirror(other)
        return other.pixels()[:, ::-1]

    def empty(other):
        things(other, has_glass=False)
        other.renderer.RemoveAllViewProps()

    row.compare(name, seen, mirrored(lambda other: things(other, has_glass=False)), None, pixels, mirrored(empty),
                reason=reason, exact=exact)


def pass_of(pass_class, set_up=lambda made: None):
    def apply(scene):
        made = pass_class()
        set_up(made)
        made.SetDelegatePass(vtkRenderStepsPass())
        scene.renderer.SetPass(made)

    return apply


def peeled(scene):
    scene.renderer.UseDepthPeelingOn()
    scene.renderer.SetMaximumNumberOfPeels(12)
    scene.renderer.SetOcclusionRatio(0)
    scene.window.SetAlphaBitPlanes(True)


def by_hand(scene):
    """A sequence without volumes, put together by hand, with the water's pass in charge or not."""
    passes = vtkRenderPassCollection()
    for one in (vtkLightsPass(), vtkOpaquePass(), vtkTranslucentPass(), vtkOverlayPass()):
        passes.AddItem(one)
    sequence = vtkSequencePass()
    sequence.SetPasses(passes)
    camera = vtkCameraPass()
    camera.SetDelegatePass(sequence)
    scene.renderer.SetPass(camera)


def steps(scene):
    scene.renderer.SetPass(vtkRenderStepsPass())


def composed_pass(scene):
    """The water's pass over VTK's usual steps, which it has by default."""
    scene.renderer.SetPass(vtkWaterReflectionPass() if scene.kind == mm.SEEN else vtkRenderStepsPass())


cell("FXAA", lambda scene: scene.renderer.UseFXAAOn())
cell("depth peeling", peeled, peeled, mm.ALONE)
cell("two-sided lighting off", lambda scene: scene.renderer.TwoSidedLightingOff(),
     lambda scene: scene.renderer.TwoSidedLightingOff(), mm.ALONE)
cell("VTK's render steps as a pass", steps, steps, mm.ALONE)
cell("a user's chain of passes", by_hand, steps, mm.ALONE)
cell("the water's pass as the user's", composed_pass, steps, mm.ALONE)
cell("eye dome lighting", pass_of(vtkEDLShading), steps)
for number, kind in enumerate(("clamped", "Reinhard", "exponential")):
    cell(f"tone mapping, {kind}",
         pass_of(vtkToneMappingPass, lambda made, number=number: made.SetToneMappingType(number)), steps)
row.register("Gaussian blur", filtered, pass_of(vtkGaussianBlurPass), 4)
row.register("Sobel filter", filtered, pass_of(vtkSobelGradientMagnitudePass), 4, exact=False,
             reason="The filter rounds halved differences of neighbours to 8 bits before it doubles and squares them "
                    "(vtkSobelGradientMagnitudePass1FS.glsl and 2FS.glsl).")
row.register("SSAA, with TextureScale sqrt(5)", filtered, pass_of(vtkSSAAPass), 3,
             int(mm.SIZE[0] * 5**0.5) / mm.SIZE[0],
             reason="The mirrored view has the size of the picture, not that of the pass, which is sqrt(5) times as "
                    "large (vtkSSAAPass::Render); TextureScale can increase its resolution.")


def hidden_lines(scene, on):
    """Wireframes, one of them behind another one, and something solid between lines."""
    for place, color in (((0, 0, 0.4), (1, 0.6, 0.2)), ((0.6, 2.2, 0.8), (0.9, 0.9, 0.3))):
        scene.add_data(wt.sphere(place, 1.5, 14), color).GetProperty().SetRepresentationToWireframe()
    scene.add_data(wt.box((2.4, 0.8, 0.4), (0.8, 0.8, 2.2)), (0.3, 0.8, 0.4))
    scene.renderer.SetUseHiddenLineRemoval(on)


def hidden_lines_remain(name):
    """Every wireframe is one afterwards, and nothing of it is kept from frame to frame."""
    scene = mm.Scene(mm.SEEN)
    hidden_lines(scene, True)
    water = wt.add_water(scene.renderer, wt.plane(scene.origin, scene.normal), mm.SHEET)
    on = scene.pixels()
    row.say(f"{name}: nothing changes in the next frame", (scene.pixels() == on).all())
    scene.renderer.UseHiddenLineRemovalOff()
    mask = mm.water_pixels(scene, water)
    off = scene.pixels()
    row.say(f"{name}: turned off, hidden lines are reflected", (np.abs(off - on)[mask] > 1).sum() > 100)
    actors = scene.renderer.GetActors()
    kinds = [actors.GetItemAsObject(i).GetProperty().GetRepresentation() for i in range(actors.GetNumberOfItems())]
    row.say(f"{name}: wireframes are wireframes", kinds.count(1) == 2)


row.cell("hidden line removal", hidden_lines, others=mm.BESIDE)
row.register("hidden line removal, from frame to frame", hidden_lines_remain)
cell("SSAO", lambda scene: scene.renderer.UseSSAOOn())
test_cell = row.test()

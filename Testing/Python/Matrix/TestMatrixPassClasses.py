# SPDX-License-Identifier: BSD-3-Clause
"""Row Classes of passes of the mirror matrix: VTK's passes that have no cell in another row.

Each draws the renderer's picture, the water in it. The composed picture has the same pass; the mirrored one has
what of it decides how props are drawn, and no filter.
"""

import mirror_matrix as mm
import volumes
import water_test as wt
from vtk_classes import find
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass,
    vtkLightsPass,
    vtkOpaquePass,
    vtkOverlayPass,
    vtkRenderPassCollection,
    vtkRenderStepsPass,
    vtkSequencePass,
    vtkTranslucentPass,
)

row = mm.Results("Classes of passes", __file__)


def things(scene):
    """No colour is over 1, as in the row of passes."""
    scene.add_data(wt.sphere((0, 0, 0.4), 1.5), (1, 0.6, 0.2))
    scene.add_data(wt.box((2.4, 0.8, 0.4), (0.8, 0.8, 2.2)), (0.3, 0.8, 0.4))
    for i in range(2):
        scene.add_data(wt.box((-2.4, 1.2 * i, 0.8), (0.8, 0.8, 1.0)), (0.4, 0.5 + 0.4 * i, 1), opacity=0.5)
    wt.add_scene_light(scene.renderer, (2, -4, 5))


def cell(name, make, in_mirror=None, others=mm.FILTERED, add=None, **options):
    """Registers the cell of a class of VTK::RenderingOpenGL2, if this VTK has it.

    make(pass) gives the renderer's pass of it, in_mirror(pass) that of the mirrored picture
    """
    made_class = find(f"RenderingOpenGL2.{name}")
    if made_class is None:
        return

    def fill(scene):
        things(scene)
        if add:
            add(scene)
        chosen = make if scene.kind != mm.MIRRORED else in_mirror or steps
        chain = chosen(made_class())
        scene.renderer.SetPass(chain)
        if chosen is over_steps:
            scene.pixels()  # some filters show nothing in their first frame

    row.cell(name, fill, others=others, **options)


def steps(made):
    return vtkRenderStepsPass()


def over_steps(made):
    made.SetDelegatePass(vtkRenderStepsPass())
    return made


def chain(*passes):
    """A camera's pass over a sequence."""
    listed = vtkRenderPassCollection()
    for one in passes:
        listed.AddItem(one)
    sequence = vtkSequencePass()
    sequence.SetPasses(listed)
    camera = vtkCameraPass()
    camera.SetDelegatePass(sequence)
    return camera


def cleared(made):
    """The background's colour and depth once more, in the place where the camera's pass has just put them."""
    if hasattr(made, "SetBackground"):
        made.SetBackground(0.2, 0.3, 0.4)
    return chain(made, vtkLightsPass(), vtkOpaquePass(), vtkTranslucentPass(), vtkOverlayPass())


def default(made):
    return chain(vtkLightsPass(), made)


def translucent(made):
    """A pass that takes the place of that of what is translucent, in an order of its own."""
    if hasattr(made, "SetTranslucentPass"):
        made.SetTranslucentPass(vtkTranslucentPass())
    if hasattr(made, "SetMaximumNumberOfPeels"):
        made.SetMaximumNumberOfPeels(12)
        made.SetOcclusionRatio(0)
    return chain(vtkLightsPass(), vtkOpaquePass(), made, vtkOverlayPass())


def volumetric(made):
    return chain(vtkLightsPass(), vtkOpaquePass(), vtkTranslucentPass(), made, vtkOverlayPass())


def cloud(scene):
    scene.add(volumes.ray_cast(volumes.ball((-0.6, -1.6, 1.5), 0.9, 30, 1.0, 70), 0.04,
                               ((0, 1, 0.9, 0.2), (100, 0.9, 0.2, 0.1)), ((0, 0.6), (90, 0.2), (105, 0))))


def framebuffer(made):
    made.SetDelegatePass(chain(vtkLightsPass(), vtkOpaquePass(), vtkTranslucentPass()))
    return made


def one_frame(made):
    made.SetSubFrames(1)
    return over_steps(made)


FLAGS = ("The mirrored view orders translucent props by the renderer's flags: it cannot know what a user's pass "
         "does.")
cell("vtkClearRGBPass", cleared, others=mm.ALONE)
cell("vtkClearZPass", cleared, others=mm.ALONE)
cell("vtkDefaultPass", default, others=mm.ALONE)
cell("vtkDepthPeelingPass", translucent, others=mm.ALONE, reason=FLAGS)
cell("vtkDualDepthPeelingPass", translucent, others=mm.ALONE, reason=FLAGS)
cell("vtkFramebufferPass", framebuffer, others=mm.ALONE)
cell("vtkOpenGLFXAAPass", over_steps)
cell("vtkOrderIndependentTranslucentPass", translucent, others=mm.ALONE, reason=FLAGS)
cell("vtkSSAOPass", over_steps)
cell("vtkSimpleMotionBlurPass", one_frame)
cell("vtkVolumetricPass", volumetric, add=cloud, others=mm.ALONE)
test_cell = row.test()

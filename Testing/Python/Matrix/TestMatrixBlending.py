# SPDX-License-Identifier: BSD-3-Clause
"""Rows Props and Composition of the mirror matrix: translucent props and volumes, and their order with the water."""

import mirror_matrix as mm
import volumes
import water_test as wt
from vtkmodules.vtkRenderingVolume import vtkFixedPointVolumeRayCastMapper, vtkGPUVolumeRayCastMapper
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkSmartVolumeMapper

row = mm.Results("Props and composition: translucent props and volumes", __file__)

PLAIN, ORDERED = "plain", "order-independent"
PEELED, PEELED_VOLUMES = "with depth peeling", "with depth peeling of volumes"


def order(scene, kind):
    """How a renderer orders what is translucent."""
    renderer = scene.renderer
    if kind in (PEELED, PEELED_VOLUMES):
        renderer.SetUseDepthPeelingForVolumes(kind == PEELED_VOLUMES)
        renderer.UseDepthPeelingOn()
        renderer.SetMaximumNumberOfPeels(12)
        renderer.SetOcclusionRatio(0)
        scene.window.SetAlphaBitPlanes(True)
    elif hasattr(renderer, "SetUseOIT"):  # VTK 9.5 and later; before, it was always on
        renderer.SetUseOIT(kind == ORDERED)


KINDS = [ORDERED, PEELED] + ([PLAIN] if hasattr(wt.vtkRenderer, "SetUseOIT") else [])


def under(scene):
    """The eye goes under the water."""
    scene.camera.SetPosition(1.5, -9, -4)


def glass(height, count=3, opacity=0.45):
    def fill(scene):
        for i in range(count):
            scene.add_data(wt.box((1.1 * i - 1.1, 0.8 * i - 0.6, height), (1.5, 0.7, 1.5)),
                           (1 - 0.4 * i, 0.2 + 0.3 * i, 0.3), opacity=opacity, specular=0.3)

    return fill


def cloud(height, change=None, mapper_class=vtkGPUVolumeRayCastMapper, at=(0.0, 0.0)):
    def fill(scene):
        volume = volumes.ray_cast(volumes.ball((*at, height), 1.2, 40, 1.5, 70), 0.03,
                                  ((0, 1, 0.9, 0.2), (100, 0.9, 0.2, 0.1)), ((0, 0.6), (90, 0.2), (105, 0)),
                                  mapper_class)
        volume.GetProperty().SetInterpolationTypeToLinear()
        if change:
            change(volume)
        scene.add(volume)

    return fill


def all_of(*fills):
    def fill(scene):
        for one in fills:
            one(scene)

    return fill


def post(scene):
    scene.add_data(wt.box((2.6, 0.8, 0.4), (0.7, 0.7, 2.2)), (0.3, 0.8, 0.4))


def placed(orders, props, heights):
    """Props over, across and under the water, in each order, seen from above and from below.

    Yields order, place, where the eye is, whether the water reflects them, and cell()'s fill and options.
    """
    for kind in orders:
        for place, height in zip(("over", "across", "under"), heights):
            for where, go in (("above", None), ("below", under)):
                def fill(scene, on=True, kind=kind, height=height, go=go):
                    order(scene, kind)
                    if go:
                        go(scene)
                    post(scene)
                    if on:
                        props(height)(scene)

                # what is not on the eye's side is seen through the water, which is half opaque then
                seen_in_it = place == "across" or (place == "over") == (where == "above")
                yield kind, place, where, seen_in_it, fill, dict(
                    control=mm.REFLECTED if seen_in_it else mm.BEHIND, opacity=1.0 if seen_in_it else 0.5)


# Translucent props.
for kind, place, where, seen_in_it, fill, options in placed(KINDS, glass, (1.3, 0.2, -1.3)):
    row.cell(f"translucent props {place} the water, {kind}, seen from {where}", fill, **options)

# Volumes.
CELLS = None if mm.VTK_VERSION >= (9, 6) else (
    "The truth is inexact: clipping planes of VTK 9.1 are displaced by part of a voxel, because ClippingInit "
    "(vtkVolumeShaderComposer.h) omits in_cellToPoint; VTK 9.6 includes it.")
OVER = ("VTK draws volumes over all translucent props, including the half opaque water, unless they are peeled: "
        "vtkOpenGLRenderer::UpdateGeometry.")
for kind, place, where, seen_in_it, fill, options in placed((ORDERED, PEELED_VOLUMES), cloud, (1.6, 0.3, -1.6)):
    how = "" if kind == ORDERED else f" {kind},"
    reason = CELLS if place == "across" else None
    row.cell(f"volume {place} the water,{how} seen from {where}", fill, exact=reason is None,
             reason=reason or (OVER if kind == ORDERED and not seen_in_it else None), **options)


def shaded(volume):
    look = volume.GetProperty()
    look.ShadeOn()
    look.SetAmbient(0.2)
    look.SetDiffuse(0.8)
    look.SetSpecular(0.4)


def shaded_by_headlight(scene, look=shaded):
    """VTK shades a volume by a lamp at the eye. In the mirrored picture a shader of the user's puts it
    where the user's eye is."""
    eye = "vec4({:.9f}, {:.9f}, {:.9f}, 1.0)".format(*scene.camera.GetPosition())

    def change(volume):
        look(volume)
        if scene.kind == mm.MIRRORED:
            scene.freezes_lights = False
            volume.GetShaderProperty().AddFragmentShaderReplacement(
                "//VTK::Base::Init", True,
                "//VTK::Base::Init\n"
                f"  g_ldir[0] = normalize((in_inverseVolumeMatrix[0] * {eye}).xyz - ip_vertexPos);\n"
                "  g_h[0] = normalize(g_ldir[0] + g_vdir[0]);\n", False)

    cloud(1.6, change)(scene)


def scattering(anisotropy):
    """The same of the light that a volume scatters: its lamp stands where the user's eye is, and light is turned."""
    def fill(scene):
        place = "vec4({:.9f}, {:.9f}, {:.9f}, 1.0)".format(*scene.camera.GetPosition())

        def change(volume):
            shaded(volume)
            volume.GetMapper().SetVolumetricScatteringBlending(1.5)
            volume.GetMapper().SetGlobalIlluminationReach(1.0)
            volume.GetProperty().SetScatteringAnisotropy(anisotropy)
            if scene.kind == mm.MIRRORED:
                volume.GetShaderProperty().AddFragmentShaderReplacement(
                    "phase = phase_function(-1);", False,
                    "vec3 eye = tex_light;\n"
                    f"tex_light = (in_inverseTextureDatasetMatrix[0] * in_inverseVolumeMatrix[0] * {place}).xyz;\n"
                    "phase = phase_function(dot(normalize(g_dataPos - tex_light), normalize(eye - g_dataPos)));",
                    False)

        shaded_by_headlight(scene, change)

    return fill


def shaded_by_sun(scene):
    wt.add_scene_light(scene.renderer, (3, -5, 8))
    cloud(1.6, shaded)(scene)


def minimum(volume):
    volume.GetMapper().SetBlendModeToMinimumIntensity()


def cropped(volume):
    volume.GetMapper().CroppingOn()
    volume.GetMapper().SetCroppingRegionPlanes(-0.5, 0.5, -0.5, 0.5, 1.2, 2)


row.cell("volume, shaded by the headlight", shaded_by_headlight)
if hasattr(vtkGPUVolumeRayCastMapper, "SetVolumetricScatteringBlending"):  # VTK 9.2 and later
    row.cell("volume that scatters the headlight", scattering(0))
    row.cell("volume that scatters the headlight forward", scattering(0.6))
row.cell("volume, shaded by a scene light", shaded_by_sun)
row.cell("volume of minimum intensity", cloud(1.6, minimum))
row.cell("volume, cropped", cloud(1.6, cropped))
row.cell("volume of vtkSmartVolumeMapper", cloud(1.6, mapper_class=vtkSmartVolumeMapper))
SQUARE = ("A defect of VTK 9.1: it ray-casts some 4:3 windows as if they were square, also without water: 112 pixels "
          "wide instead of 84.")
for place, height in (("over", 1.6), ("across", 0.3)):
    name = f"volume cast on the CPU, {place} the water"
    if mm.VTK_VERSION >= (9, 6):
        row.cell(name, cloud(height, mapper_class=vtkFixedPointVolumeRayCastMapper))
    else:
        row.register(name, row.note, SQUARE)
row.cell("two volumes and a translucent prop behind each other", all_of(
    post, cloud(1.6, at=(-0.8, 1.2)), glass(0.4, 2), cloud(1.5, at=(0.8, -1.2))))
test_cell = row.test()

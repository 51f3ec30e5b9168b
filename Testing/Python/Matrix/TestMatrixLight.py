# SPDX-License-Identifier: BSD-3-Clause
"""Row Light of the mirror matrix: lights and shadows, and the headlight against its formula."""

import mirror_matrix as mm
import numpy as np
import water_test as wt
from vtkmodules.vtkRenderingCore import vtkAssembly, vtkLight, vtkLightKit, vtkTexture
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass,
    vtkLightsPass,
    vtkRenderPassCollection,
    vtkSequencePass,
    vtkShadowMapPass,
)
from vtkwater import vtkWaterReflectionPass as Pass

row = mm.Results("Light", __file__)


def things(scene, specular=0.6):
    scene.add_data(wt.sphere((0, 0, 0.4), 1.5), (1, 0.6, 0.2), specular=specular)
    scene.add_data(wt.box((2.6, 0.8, 0.4), (0.8, 0.8, 2.2)), (0.3, 0.8, 0.4), specular=specular)
    scene.add_data(wt.pyramid((-2.4, 0.8, 0.6), 2.2), (0.4, 0.5, 1), specular=specular)


def light(kind, position, focal_point=(0, 0, 0), color=(1, 1, 1), cone=None):
    made = vtkLight()
    made.SetLightType(kind)
    made.SetPosition(position)
    made.SetFocalPoint(focal_point)
    made.SetColor(color)
    if cone is not None:
        made.SetPositional(True)
        made.SetConeAngle(cone)
        made.SetExponent(2)
        made.SetAttenuationValues(0.5, 0.05, 0.01)
    return made


HEAD, CAMERA, SCENE = 1, 2, 3  # VTK_LIGHT_TYPE_*


def lit_by(*lights):
    """Each light as arguments of light(); without the cell's lights it is the headlight that lights."""

    def fill(scene, on):
        things(scene)
        if on:
            for arguments in lights:
                scene.renderer.AddLight(light(*arguments[:-1], **arguments[-1]))

    return fill


def unlit(scene, on):
    things(scene)
    if not on:
        for i in range(3):
            scene.renderer.GetViewProps().GetItemAsObject(i).GetProperty().LightingOff()


HIGH, LEFT, RIGHT = (1, -2, 6), (-5, -4, 3), (6, -3, 4)
row.cell("default headlight", unlit)
row.cell("headlight of a colour", lit_by((HEAD, (0, 0, 1), dict(color=(1, 0.4, 0.3)))))
row.cell("camera light", lit_by((CAMERA, (0.8, 0.6, 0.4), dict())))
row.cell("camera light, positional", lit_by((CAMERA, (0.8, 0.6, 0.4), (0, 0, 0), dict(cone=180))))
row.cell("scene light, directional", lit_by((SCENE, LEFT, dict())))
row.cell("scene light, positional", lit_by((SCENE, HIGH, dict(cone=180))))
row.cell("scene light, spot", lit_by((SCENE, HIGH, (0.5, 0, 0), dict(cone=22))))
row.cell("scene light under the water", lit_by((SCENE, (1, -3, -4), dict(cone=180))))
row.cell("headlight, camera light and scene lights at once", lit_by(
    (HEAD, (0, 0, 1), dict(color=(0.3, 0.3, 0.3))), (CAMERA, (-1, 0.5, 0.2), dict(color=(0.5, 0.2, 0.2))),
    (SCENE, RIGHT, dict(color=(0.2, 0.2, 0.7))), (SCENE, HIGH, dict(cone=30))))


def light_kit(scene, on):
    things(scene)
    if on:
        kit = vtkLightKit()
        kit.SetKeyLightWarmth(0.7)
        kit.AddLightsToRenderer(scene.renderer)


row.cell("light kit", light_kit)


def switched_off(scene, on):
    things(scene)
    scene.renderer.AddLight(light(SCENE, LEFT))
    scene.renderer.AddLight(light(SCENE, RIGHT, color=(1, 0.3, 0.3)))
    scene.renderer.GetLights().GetItemAsObject(1).SetSwitch(not on)


row.cell("light switched off", switched_off)


# Shadow maps. In the mirrored picture, too, the water throws a shadow, and counts for what the maps cover.
def unseen_sheet(scene):
    sheet = mm.add_sheet(scene, None)
    sheet.GetProperty().BackfaceCullingOn()  # the mirrored camera sees its back, the lights its front


def shadows(name, *lights, chain=False, moves=False, image_based=False):
    def fill(scene, on):
        things(scene, 0.0)
        scene.add_data(wt.box((0, 0, -0.2), (8, 4, 0.1)), (0.8, 0.8, 0.7))
        scene.add_data(wt.box((0.2, 2.6, 1.4), (7, 0.2, 3.2)), (0.8, 0.8, 0.7))  # a wall that has shadows on it
        scene.add_data(wt.box((-0.8, -1.6, 1.0), (0.5, 0.5, 3.2)), (0.9, 0.3, 0.3))  # crosses the water
        for arguments in lights:
            scene.renderer.AddLight(light(*arguments[:-1], **arguments[-1]))
        if scene.kind == mm.MIRRORED:
            unseen_sheet(scene)
        if image_based:
            light_by_image(scene)
        if not (on or scene.kind != mm.MIRRORED):
            return
        if chain:
            scene.renderer.SetPass(chain_with_shadows(scene))
        else:
            scene.renderer.SetUseShadows(True)

    def before(scene, water):
        scene.pixels()
        part = scene.renderer.GetViewProps().GetItemAsObject(0)
        part.SetPosition(0.3, -0.2, 0.4)

    def moved(scene, on):
        fill(scene, on)
        if scene.kind != mm.SEEN:
            scene.renderer.GetViewProps().GetItemAsObject(0).SetPosition(0.3, -0.2, 0.4)

    row.cell(name, moved if moves else fill, others=mm.BESIDE, prepare=before if moves else None)


def light_by_image(scene):
    """Image-based light is loaded late: the mirrored view is then drawn in the middle of the shadowed picture."""
    v, u = np.mgrid[0:32, 0:64]
    texture = vtkTexture()
    texture.SetInputData(mm.image_of(np.stack([4 * u, 8 * v, 255 - 4 * u], axis=2)))
    texture.MipmapOn()
    texture.InterpolateOn()
    renderer = scene.renderer
    renderer.UseImageBasedLightingOn()
    renderer.SetEnvironmentTexture(texture)
    renderer.GetEnvMapLookupTable().SetLUTSize(64)
    renderer.GetEnvMapLookupTable().SetLUTSamples(64)
    renderer.GetEnvMapPrefiltered().SetPrefilterLevels(3)
    renderer.GetEnvMapPrefiltered().SetPrefilterMaxSamples(32)


def chain_with_shadows(scene):
    """A camera pass, lights, shadow maps and what reads them, as in VTK's own tests."""
    shadow_pass, lights, sequence, camera = vtkShadowMapPass(), vtkLightsPass(), vtkSequencePass(), vtkCameraPass()
    passes = vtkRenderPassCollection()
    for part in (lights, shadow_pass.GetShadowMapBakerPass(), shadow_pass):
        passes.AddItem(part)
    sequence.SetPasses(passes)
    camera.SetDelegatePass(sequence)
    scene.keep += [shadow_pass, camera]
    return camera


SPOT = (SCENE, (-4, -6, 9), (0, 0, 0), dict(cone=40))
DIRECTIONAL = (SCENE, (3, -6, 4), dict())
shadows("shadow maps of a spot light", SPOT)
shadows("shadow maps of a directional light", DIRECTIONAL)
shadows("shadow maps of two lights", SPOT, (SCENE, (3, -6, 4), dict(color=(0.4, 0.4, 0.6))))
shadows("shadow maps of a camera light", (CAMERA, (0.8, 0.6, 1.4), dict()))
shadows("shadow maps in a user's chain", SPOT, chain=True)
shadows("shadow maps, something moved", SPOT, moves=True)
shadows("shadow maps beside image-based light", SPOT, image_based=True)


@row.makes("shadow maps, a mirrored view in the middle of the picture")
def in_the_middle():
    """A mirrored view that is drawn in the middle of the shadowed picture leaves the shadows of the rest alone."""

    def picture(reflectance):
        scene = mm.Scene(mm.SEEN)
        assembly = vtkAssembly()  # drawn in its place, and not after all others
        scene.renderer.AddActor(assembly)
        water = wt.add_water(scene.renderer, wt.plane((0, 0, 0), (0, 0, 1)), mm.SHEET, reflectance)
        scene.renderer.RemoveActor(water)
        assembly.AddPart(water)
        things(scene, 0.0)
        scene.renderer.AddLight(light(*SPOT[:-1], **SPOT[-1]))
        light_by_image(scene)
        scene.renderer.SetUseShadows(True)
        seen = scene.pixels()
        renders = water.GetReflectionPass().GetNumberOfReflectionRenders()
        return seen, mm.water_pixels(scene, water), renders

    seen, pixels, renders = picture(1.0)
    without, _, others = picture(0.0)
    row.say("shadow maps, a mirrored view in the middle of the picture: it is drawn", renders == 1 and others == 0)
    row.say("shadow maps, a mirrored view in the middle of the picture: the rest is as without it",
            (seen == without)[~pixels].all())


@row.makes("shadow maps, when they are kept")
def kept():
    """Shadow maps are drawn again when a caster moves, visible or not, but not when only the time of waves changes."""
    scene = mm.Scene(mm.SEEN)
    things(scene, 0.0)
    scene.renderer.AddLight(light(*SPOT[:-1], **SPOT[-1]))
    unseen = scene.add_data(wt.box((-2.5, -4, 6.5), (1.5, 1.5, 0.2)), (1, 1, 1), cut=False)  # over the picture
    scene.renderer.SetUseShadows(True)
    water = wt.add_water(scene.renderer, wt.plane((0, 0, 0), (0, 0, 1)), mm.SHEET)
    reflection = water.GetReflectionPass()
    before = [scene.pixels() for _ in range(3)][-1]
    row.say("shadow maps, nothing changes: the map is used again", reflection.GetDecision() == Pass.REUSED)
    row.say("shadow maps: the caster is outside the mirrored view",
            reflection.GetFateCount(Pass.OUT_OF_VIEW) + reflection.GetFateCount(Pass.OUT_OF_WATER) > 0)
    unseen.SetPosition(1.5, 1, 0)
    after = scene.pixels()
    row.say("shadow maps, a caster outside the mirrored view moves: the map is drawn again",
            reflection.GetDecision() == Pass.RENDERED)
    changed = np.abs(after - before).max(axis=2) > 1
    row.say("shadow maps, a caster outside the mirrored view moves: the water shows it",
            (changed & mm.water_pixels(scene, water)).sum() > 100)
    scene.pixels()
    water.SetTime(1.0)
    scene.pixels()
    row.say("shadow maps, the time of waves: the map is used again", reflection.GetDecision() == Pass.REUSED)


# The formula: a Lambert sphere's radiance is max(0, N . L) with L against the user's view direction.
@row.makes("a Lambert sphere under the headlight")
def lambert():
    scene = mm.Scene(mm.SEEN, background=(0, 0, 0))
    center, radius = np.array((0.0, 0.0, 2.6)), 1.4
    data = wt.sphere(center, radius, 200)
    actor = scene.add_data(data, (1, 1, 1))
    actor.GetProperty().SetInterpolationToPhong()
    water = wt.add_water(scene.renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-20, 20, -20, 20))
    seen = scene.pixels()
    water_is_there = mm.water_pixels(scene, water)
    camera = scene.camera
    eye, towards = np.asarray(camera.GetPosition()), np.asarray(camera.GetDirectionOfProjection())
    right = wt.unit(np.cross(towards, camera.GetViewUp()))
    up = np.cross(right, towards)
    width, height = mm.SIZE
    y, x = np.mgrid[0:height, 0:width]
    reach = np.tan(np.radians(camera.GetViewAngle()) / 2)
    rays = (towards + ((2 * x + 1) / width - 1)[:, :, None] * reach * width / height * right
            + ((2 * y + 1) / height - 1)[:, :, None] * reach * up)
    rays /= np.linalg.norm(rays, axis=2)[:, :, None]
    with np.errstate(all="ignore"):
        place = eye - rays * (eye[2] / rays[:, :, 2])[:, :, None]
        down = rays * (1, 1, -1)  # reflected
        to_center = center - place
        along = (down * to_center).sum(axis=2)
        inside = radius**2 - (to_center**2).sum(axis=2) + along**2
        normal = (place + down * (along - np.sqrt(inside))[:, :, None] - center) / radius
        truth = 255 * np.maximum(0, -(normal @ towards))
    # not its rim, where facets differ from the sphere, nor where there is no light
    sphere = water_is_there & (rays[:, :, 2] < 0) & (inside > (0.3 * radius) ** 2) & (truth > 40)
    error = np.abs(seen[:, :, 0] - truth)[sphere] / 255
    wt.check_at_least("Lambert sphere: pixels", int(sphere.sum()), 500)
    print(f"Lambert sphere: largest error {100 * error.max():.3f} % of white, mean {100 * error.mean():.3f} %")
    row.say("a Lambert sphere under the headlight: its mirrored radiance is within 1 % of the formula",
            float(error.max()) <= 0.01)


test_cell = row.test()

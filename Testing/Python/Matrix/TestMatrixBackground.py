# SPDX-License-Identifier: BSD-3-Clause
"""Row Background of the mirror matrix: what sky stands in the water."""

import mirror_matrix as mm
import numpy as np
import water_test as wt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkRenderingCore import vtkSkybox, vtkTexture, vtkViewport

row = mm.Results("Background", __file__)
MARK = (255, 0, 255)  # no colour of the scene's


def things(scene):
    scene.add_data(wt.sphere((0, 0, 0.4), 1.5), (1, 0.6, 0.2))
    scene.add_data(wt.box((2.6, 0.8, 0.4), (0.8, 0.8, 2.2)), (0.3, 0.8, 0.4))


def colour(scene, on):
    things(scene)
    if on:
        scene.renderer.SetBackground(0.7, 0.3, 0.5)


row.cell("colour", colour)


def texture_of(picture, mipmap=False):
    texture = vtkTexture()
    texture.SetInputData(mm.image_of(picture))
    texture.InterpolateOn()
    texture.SetMipmap(mipmap)
    return texture


def panorama(width=256, height=128):
    v, u = np.mgrid[0:height, 0:width]
    return np.stack([120 + 100 * np.sin(0.2 * u), 2 * v, 120 + 100 * np.cos(0.1 * v)], axis=2)


def rays_of(scene):
    """Directions of view of all pixels, of unit length, and where they meet the plane z = 0."""
    camera, (width, height) = scene.camera, scene.window.GetSize()
    matrix = camera.GetCompositeProjectionTransformMatrix(width / height, -1, 1)
    to_world = np.linalg.inv([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    y, x = np.mgrid[0:height, 0:width]
    ndc = np.stack([(2 * x + 1) / width - 1, (2 * y + 1) / height - 1], axis=2)
    ends = [np.concatenate([ndc, np.full_like(ndc[:, :, :1], z), np.ones_like(ndc[:, :, :1])], axis=2) @ to_world.T
            for z in (-1.0, 1.0)]
    near, far = (end[:, :, :3] / end[:, :, 3:] for end in ends)
    rays = far - near
    return rays / np.linalg.norm(rays, axis=2)[:, :, None]


def on_screen(look, paint, colours):
    """A gradient or a picture is painted on the screen. A reflected ray has the colour at which the user's camera sees its
    direction, and beyond the screen's edge what is at the edge.

    colours: of places on the screen, from 0 to 1, along and up
    """

    def fill(scene):
        look(scene.camera)
        things(scene)
        paint(scene)

    def marked(scene):
        look(scene.camera)
        things(scene)
        scene.renderer.SetBackground(np.divide(MARK, 255))

    scene = mm.Scene(mm.SEEN)
    look(scene.camera)
    rays = rays_of(scene) * (1, 1, -1)  # reflected
    matrix = scene.camera.GetCompositeProjectionTransformMatrix(mm.SIZE[0] / mm.SIZE[1], -1, 1)
    to_clip = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    x, y, _, w = np.moveaxis(rays @ to_clip[:, :3].T, 2, 0)
    with np.errstate(all="ignore"):
        across = np.where(np.abs(w) > 1e-9, 0.5 + 0.5 * x / np.abs(w), x > 0)  # behind the camera as before it
        up = np.where(w > 1e-9, 0.5 + 0.5 * y / w, y > 0)
    sky = np.round(colours(np.clip(across, 0, 1), np.clip(up, 0, 1))).astype(int)
    picture = mm.mirrored_picture(marked)
    is_sky = (picture == MARK).all(axis=2)[:, :, None]
    return fill, np.where(is_sky, sky, picture)


FIRST, SECOND = np.array((0.1, 0.2, 0.6)), np.array((0.9, 0.7, 0.3))


def gradient(mode, share):
    """A gradient of one of VTK's modes (None: the only one of VTK 9.1), and its colours by the share of the second one."""

    def paint(scene):
        scene.renderer.GradientBackgroundOn()
        scene.renderer.SetBackground(FIRST)
        scene.renderer.SetBackground2(SECOND)
        if mode:
            scene.renderer.SetGradientMode(mode)

    def colours(across, up):
        part = np.minimum(share(across, up), 1)[:, :, None]
        return 255 * ((1 - part) * FIRST + part * SECOND)

    return paint, colours


UPWARDS = gradient(None, lambda across, up: up)
PAINTING = np.stack([128 + 100 * np.sin(0.05 * np.mgrid[0:40, 0:60][1] + 0.1 * np.mgrid[0:40, 0:60][0]),
                     5 * np.mgrid[0:40, 0:60][0], 128 + 100 * np.cos(0.1 * np.mgrid[0:40, 0:60][1])], axis=2)


def paint_texture(scene):
    scene.keep.append(texture_of(PAINTING))
    scene.renderer.SetBackgroundTexture(scene.keep[-1])
    scene.renderer.TexturedBackgroundOn()


def texture_colours(across, up):
    """As VTK paints it in the pixels of the screen's edge, and between texels in proportion."""
    stored = PAINTING.astype(np.uint8).astype(float)
    rows, columns = stored.shape[:2]
    across = np.clip(across, 0.5 / mm.SIZE[0], 1 - 0.5 / mm.SIZE[0]) * columns - 0.5
    up = np.clip(up, 0.5 / mm.SIZE[1], 1 - 0.5 / mm.SIZE[1]) * rows - 0.5
    left, low = np.floor(across).astype(int), np.floor(up).astype(int)
    right_share, high_share = (across - left)[:, :, None], (up - low)[:, :, None]
    lower = stored[low % rows, left % columns] * (1 - right_share) + stored[low % rows, (left + 1) % columns] * right_share
    upper = (stored[(low + 1) % rows, left % columns] * (1 - right_share) +
             stored[(low + 1) % rows, (left + 1) % columns] * right_share)
    return lower * (1 - high_share) + upper * high_share


TEXTURE = paint_texture, texture_colours


def show_screen(name, look, painted=UPWARDS):
    row.show_picture(name, *on_screen(look, *painted))


row.register("gradient", show_screen, lambda camera: None)
row.register("gradient, wide angle", show_screen, lambda camera: camera.SetViewAngle(75))
row.register("gradient, rolled camera", show_screen, lambda camera: camera.SetRoll(35))
row.register("gradient, straight down", show_screen,
             lambda camera: (camera.SetPosition(0.1, 0, 9), camera.SetViewUp(0, 1, 0)))
row.register("texture", show_screen, lambda camera: None, TEXTURE)
row.register("texture, rolled camera", show_screen, lambda camera: camera.SetRoll(35), TEXTURE)
if hasattr(vtkViewport, "SetGradientMode"):
    modes = vtkViewport.GradientModes
    row.register("gradient from left to right", show_screen, lambda camera: None,
                 gradient(modes.VTK_GRADIENT_HORIZONTAL, lambda across, up: across))
    row.register("gradient in an ellipse by the sides", show_screen, lambda camera: None,
                 gradient(modes.VTK_GRADIENT_RADIAL_VIEWPORT_FARTHEST_SIDE,
                          lambda across, up: 2 * np.hypot(across - 0.5, up - 0.5)))
    row.register("gradient in an ellipse by the corners", show_screen, lambda camera: None,
                 gradient(modes.VTK_GRADIENT_RADIAL_VIEWPORT_FARTHEST_CORNER,
                          lambda across, up: 2**0.5 * np.hypot(across - 0.5, up - 0.5)))


def skybox(projection, cut=False):
    def fill(scene):
        box = vtkSkybox()
        if projection == "cube":
            texture = vtkTexture()
            texture.CubeMapOn()
            texture.InterpolateOn()
            for i in range(6):
                picture = panorama(64, 64)[:, :, np.roll((0, 1, 2), i)] * (0.5 + 0.08 * i)
                texture.SetInputDataObject(i, mm.image_of(picture))
            box.SetProjectionToCube()
        else:
            texture = texture_of(panorama())
            box.SetProjectionToSphere()
            box.SetFloorRight(0, 1, 0)
            box.SetFloorPlane(0, 0, 1, 0)
        box.SetTexture(texture)
        scene.add(box, cut=False)
        things(scene)

    return fill


row.cell("skybox, cube", skybox("cube"))
row.cell("skybox, sphere", skybox("sphere"))


def from_below(fill):
    def under(scene):
        scene.camera.SetPosition(1.5, -9, -4)
        fill(scene)

    return under


row.cell("skybox, cube, seen from under water", from_below(skybox("cube")))


@row.makes("environment texture in place of the scene")
def environment():
    """The water looks a panorama up in the reflected direction, with no mirrored view: u is the longitude
    from EnvironmentRight to the front, v the latitude."""
    picture = panorama()

    def fill(scene):
        scene.renderer.SetEnvironmentUp(0, 0, 1)
        scene.renderer.SetEnvironmentRight(0, 1, 0)  # the front is right x up, the world's x

    def look_around(scene, water):
        scene.keep.append(texture_of(picture))
        water.GetWaterProperty().SetEnvironmentTexture(scene.keep[-1])
        water.GetWaterProperty().SetReflectionSourceToEnvironment()

    x, y, z = np.moveaxis(rays_of(mm.Scene(mm.SEEN)) * (1, 1, -1), 2, 0)
    height, width = picture.shape[:2]
    u = width * (0.5 + np.arctan2(x, y) / (2 * np.pi)) - 0.5
    v = height * (0.5 + np.arctan2(z, np.hypot(x, y)) / np.pi) - 0.5
    left, low = np.floor(u).astype(int), np.floor(v).astype(int)
    right_share, high_share = (u - left)[:, :, None], (v - low)[:, :, None]
    stored = picture.astype(np.uint8).astype(float)

    def texel(column, line):
        return stored[np.clip(line, 0, height - 1), column % width]

    lower = texel(left, low) * (1 - right_share) + texel(left + 1, low) * right_share
    upper = texel(left, low + 1) * (1 - right_share) + texel(left + 1, low + 1) * right_share
    row.show_picture("environment texture in place of the scene", fill,
                     np.round(lower * (1 - high_share) + upper * high_share).astype(int), prepare=look_around)


@row.makes("transparent")
def transparent():
    """Where the water is, the picture is opaque; elsewhere it is as without the water."""
    scene = mm.Scene(mm.SEEN)
    scene.window.SetAlphaBitPlanes(True)
    scene.renderer.SetBackgroundAlpha(0)
    things(scene)
    water = wt.add_water(scene.renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-2, 2, -2, 2))

    def alpha():
        scene.pixels()
        values = vtkUnsignedCharArray()
        scene.window.GetRGBACharPixelData(0, 0, mm.SIZE[0] - 1, mm.SIZE[1] - 1, 0, values)
        return vtk_to_numpy(values).reshape(mm.SIZE[1], mm.SIZE[0], 4)[:, :, 3].astype(int)

    is_water = mm.water_pixels(scene, water)
    seen = alpha()
    water.VisibilityOff()
    without = alpha()
    row.say("transparent: alpha is 1 on the water", is_water.sum() > 1000 and (seen[is_water] == 255).all())
    row.say("transparent: alpha elsewhere is as without water",
            (without == 0).any() and (seen == without)[~is_water].all())


test_cell = row.test()

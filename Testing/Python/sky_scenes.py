# SPDX-License-Identifier: BSD-3-Clause
"""sky_scenes: skies of all kinds that VTK has, and their truth: what VTK's own picture has in a direction."""

import numpy as np
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkSkybox, vtkTexture, vtkViewport

SIZE = (160, 120)
LEVEL = -30.0  # of the water: under the floor
PROJECTIONS = ("cube", "sphere", "stereo", "floor")
SCREENS = ("colour", "vertical", "picture") + (
    ("horizontal", "side", "corner") if hasattr(vtkViewport, "SetGradientMode") else ())


def image_of(texels):
    """Rows (the lowest first) x columns x RGB, 0 to 255, or floats."""
    texels = np.ascontiguousarray(texels)
    image = vtkImageData()
    image.SetDimensions(texels.shape[1], texels.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(texels.reshape(-1, 3), deep=True))
    return image


def waves_of_colour(width, height, seed):
    """A smooth picture that repeats over its sides, all of it another one for another seed."""
    chance = np.random.default_rng(seed)
    v, u = np.mgrid[0:height, 0:width]
    x, y = 2 * np.pi * (u + 0.5) / width, 2 * np.pi * (v + 0.5) / height
    texels = np.full((height, width, 3), 0.5)
    for _ in range(6):
        texels += (0.08 * np.sin(chance.integers(-3, 4) * x + chance.integers(-3, 4) * y +
                                 chance.uniform(0, 6, (3, 1, 1)))).transpose(1, 2, 0)
    return np.round(255 * np.clip(texels, 0, 1)).astype(np.uint8)


def texture_of(texels):
    texture = vtkTexture()
    texture.SetInputData(image_of(texels))
    texture.InterpolateOn()
    return texture


def on_sphere(stereo=False, seed=3):
    """A picture in longitude and latitude that is one colour at each pole."""
    texels = waves_of_colour(512, 256, seed).astype(float)
    fade = np.sin(np.pi * (np.arange(256) + 0.5) / 256)[:, None, None]
    texels = np.round(128 + fade * (texels - 128)).astype(np.uint8)
    return np.concatenate([texels, 255 - texels]) if stereo else texels


def on_cube(face, size=128):
    """A face of a smooth cube map: its colours depend on the direction alone (OpenGL 3.2, table 3.21)."""
    t, s = (2 * np.mgrid[0:size, 0:size] + 1) / size - 1
    one = np.ones_like(s)
    toward = ((one, -t, -s), (-one, -t, s), (s, one, t), (s, -one, -t), (s, -t, one), (-s, -t, -one))[face]
    x, y, z = np.array(toward) / np.linalg.norm(toward, axis=0)
    colours = np.stack([0.5 + 0.3 * np.sin(4 * x + y), 0.5 + 0.3 * np.cos(5 * y - z), 0.5 + 0.3 * np.sin(3 * z - 2 * x)])
    return np.round(255 * colours.transpose(1, 2, 0)).astype(np.uint8)


def skybox_of(projection, seed):
    """A skybox turned by chance, and a floor of any slope."""
    chance = np.random.default_rng(seed)
    box = vtkSkybox()
    if projection == "cube":
        texture = vtkTexture()
        texture.CubeMapOn()
        texture.InterpolateOn()
        for i in range(6):
            texture.SetInputDataObject(i, image_of(on_cube(i)))
        box.SetProjectionToCube()
    elif projection == "floor":
        texture = texture_of(waves_of_colour(64, 64, seed))
        box.SetProjectionToFloor()
    else:
        texture = texture_of(on_sphere(projection == "stereo", seed))
        box.SetProjectionToStereoSphere() if projection == "stereo" else box.SetProjectionToSphere()
    box.SetTexture(texture)
    box.SetGammaCorrect(bool(seed % 2))
    axes, _ = np.linalg.qr(chance.normal(size=(3, 3)))
    if projection == "floor":
        up = np.array((0.3, -0.2, -1.0))  # over the scene, and not level
        box.SetFloorPlane(*(2 * up), 0.0)  # VTK places any other in depth as if it went through the origin
        box.SetFloorRight(0.005, 0.002, 0.001)
    else:
        box.SetFloorPlane(*axes[0], 0)
        box.SetFloorRight(*axes[1])
    return box


def give_sky(renderer, kind, seed=3):
    """The renderer's background and skybox are of a kind."""
    renderer.SetBackground(0.3, 0.5, 0.6)
    renderer.SetBackground2(0.9, 0.3, 0.2)
    if kind in PROJECTIONS:
        axes, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
        renderer.SetEnvironmentUp(*axes[0])
        renderer.SetEnvironmentRight(*axes[1])
        box = skybox_of(kind, seed)
        renderer.AddActor(box)
        return box
    if kind == "picture":
        renderer.SetBackgroundTexture(texture_of(waves_of_colour(97, 61, seed)))
        renderer.TexturedBackgroundOn()
    elif kind != "colour":
        renderer.GradientBackgroundOn()
    if kind in ("horizontal", "side", "corner"):
        modes = vtkViewport.GradientModes
        renderer.SetGradientMode({"horizontal": modes.VTK_GRADIENT_HORIZONTAL,
                                  "side": modes.VTK_GRADIENT_RADIAL_VIEWPORT_FARTHEST_SIDE,
                                  "corner": modes.VTK_GRADIENT_RADIAL_VIEWPORT_FARTHEST_CORNER}[kind])
    return None


class Looker:
    """What VTK shows in single directions: a camera looks that way, and the middle pixel is its colour."""

    def __init__(self, kind, seed=3):
        self.view = wt.View((5, 5))
        self.box = give_sky(self.view.renderer, kind, seed)

    def colour(self, start, direction):
        start, direction = np.asarray(start, float), np.asarray(direction, float)
        up = (0, 0, 1) if abs(direction[2]) < 0.9 else (0, 1, 0)
        camera = wt.place_camera(self.view.renderer, start, start + direction, (0.1, 400), up)
        camera.SetViewAngle(0.1)
        return self.view.picture()[2, 2]


def on_screen(view, kind, seed, directions):
    """Colours that a background has where the view's camera sees directions; beyond the screen as at its edge."""
    alone = wt.View(view.window.GetSize())
    give_sky(alone.renderer, kind, seed)
    picture = alone.picture()
    height, width = picture.shape[:2]
    camera = view.renderer.GetActiveCamera()
    matrix = camera.GetCompositeProjectionTransformMatrix(width / height, -1, 1)
    clip = directions @ np.array([[matrix.GetElement(i, j) for j in range(3)] for i in range(4)]).T
    ndc = clip[:, :2] / np.maximum(np.abs(clip[:, 3:]), 1e-9)
    ndc[:, 1] = np.where(clip[:, 3] <= 0, np.sign(clip[:, 1]), ndc[:, 1])  # behind the camera: over it, or under
    place = np.clip((0.5 + 0.5 * ndc) * (width, height) - 0.5, 0, (width - 1, height - 1))
    low = np.minimum(np.floor(place).astype(int), (width - 2, height - 2))
    share = place - low

    def at(dx, dy):
        return picture[low[:, 1] + dy, low[:, 0] + dx]

    x, y = share[:, :1], share[:, 1:]
    return (at(0, 0) * (1 - x) + at(1, 0) * x) * (1 - y) + (at(0, 1) * (1 - x) + at(1, 1) * x) * y


def truth(view, kind, seed, starts, directions):
    """Colours of the sky from points in directions, n x 3."""
    if kind in PROJECTIONS:
        looker = Looker(kind, seed)
        return np.array([looker.colour(*each) for each in zip(starts, directions)])
    return on_screen(view, kind, seed, directions)

# SPDX-License-Identifier: BSD-3-Clause
"""mirror_waters: several waters in one scene, and what one of them is in the mirrored picture of another.

Water in water is a surface with its own colour and, by Fresnel, the background: nothing else is in it, so that
mirrors do not mirror each other for ever. Here that colour is worked out pixel by pixel from the optics' textbook
formulas, and an ordinary sheet in the other water's place shows it in the mirrored picture. With secondary
reflections, the scene is in it in the background's place: VTK's own picture of it, by the camera mirrored twice.
"""

import mirror_scene as ms
import numpy as np
import water_test as wt
from vtkmodules.vtkRenderingCore import vtkTexture

INDEX = 1.333
MARK = (255, 0, 255)  # no colour of a scene's
NODES = 80  # of the mean over slopes


class Sheet:
    """A water's plane, bounds and look.

    reflectance  None: Fresnel's
    variance     of its slopes along and across the view
    data         poly data of its surface in place of the bounds
    sky          colour of its environment texture
    """

    def __init__(self, origin, normal, bounds, color=(0.1, 0.25, 0.3), reflectance=None, opacity=1.0, variance=0.0,
                 data=None, sky=None):
        self.origin, self.normal, self.bounds = np.asarray(origin, float), wt.unit(normal), bounds
        self.color, self.reflectance, self.opacity = np.asarray(color, float), reflectance, opacity
        self.variance, self.data, self.sky = variance, data, sky
        self.options = dict(origin=origin, normal=normal)

    def plane(self):
        """Equal for sheets of one plane."""
        return (*self.normal, self.normal @ self.origin)

    def add_to(self, scene):
        """The water itself."""
        water = wt.add_water(scene.renderer, wt.plane(self.origin, self.normal), self.bounds)
        look = water.GetWaterProperty()
        if self.data is not None:
            water.SetMapper(ms.mapper_of(self.data))
        if self.reflectance is None:
            look.SetReflectanceModeToFresnel()
        else:
            look.SetReflectance(self.reflectance)
        look.SetDeepColor(*self.color)
        look.SetOpacity(self.opacity)
        if self.sky:
            texture = vtkTexture()
            texture.SetInputData(ms.image_of(np.full((4, 8, 3), np.multiply(255, self.sky))))
            look.SetEnvironmentTexture(texture)
        return water


LEVEL = (0, 0, 1)
FIRST = Sheet((0, 0, 0), LEVEL, ms.SHEET, reflectance=1.0)  # whose mirrored picture has the others


def composite_of(scene):
    """World to clip of the scene's camera, 4 x 4."""
    matrix = scene.camera.GetCompositeProjectionTransformMatrix(scene.renderer.GetTiledAspectRatio(), -1, 1)
    return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


def rays_of(scene):
    """Of each pixel, rows x columns, bottom row first: a point of the view ray, and its direction."""
    width, height = scene.window.GetSize()
    back = np.linalg.inv(composite_of(scene))
    y, x = np.mgrid[0:height, 0:width]
    ends = []
    for depth in (-1, 1):
        clip = np.stack([2 * (x + 0.5) / width - 1, 2 * (y + 0.5) / height - 1, np.full(x.shape, depth), 1 + 0 * x], -1)
        world = clip @ back.T
        ends.append(world[..., :3] / world[..., 3:])
    dirs = ends[1] - ends[0]
    return ends[0], dirs / np.linalg.norm(dirs, axis=-1, keepdims=True)


def fresnel(cosine, beyond, here):
    """Reflectance of unpolarised light by Snell's and Fresnel's laws, from one medium to the one beyond."""
    sine = here / beyond * np.sqrt(np.maximum(1 - cosine**2, 0))
    other = np.sqrt((1 - sine**2).astype(complex))
    s = np.abs((here * cosine - beyond * other) / (here * cosine + beyond * other)) ** 2
    p = np.abs((beyond * cosine - here * other) / (beyond * cosine + here * other)) ** 2
    return np.where(sine >= 1, 1.0, 0.5 * (s + p))


def background(scene, user_composite, dirs):
    """The background in directions: a colour, or a gradient that is painted on the user's screen."""
    bottom = np.array(scene.renderer.GetBackground())
    if not scene.renderer.GetGradientBackground():
        return np.broadcast_to(bottom, dirs.shape)
    clip = dirs @ user_composite[:, :3].T
    with np.errstate(all="ignore"):
        height = np.where(clip[..., 3] > 0, 0.5 + 0.5 * clip[..., 1] / clip[..., 3], clip[..., 1] >= 0)
    height = np.clip(height, 0, 1)[..., None]
    return (1 - height) * bottom + height * np.array(scene.renderer.GetBackground2())


def colour_of(scene, sheet, user_composite, around=None):
    """What the sheet shows in each pixel of a scene's view, rows x columns x RGB of 255.

    around  what a calm one reflects in each pixel, of 255; None: the background
    """
    _, rays = rays_of(scene)
    seen = wt.is_above(scene.camera, sheet.origin, sheet.normal)
    normal = sheet.normal if seen else -sheet.normal
    media = (INDEX, 1.0) if seen else (1.0, INDEX)
    facing = -(rays @ normal)
    flat = rays + facing[..., None] * normal  # along the plane
    azimuth = flat / np.maximum(np.linalg.norm(flat, axis=-1, keepdims=True), 1e-9)
    slopes = np.linspace(-6, 6, NODES) * np.sqrt(sheet.variance) if sheet.variance else np.zeros(1)
    shares = np.exp(-0.5 * np.linspace(-6, 6, NODES) ** 2) if sheet.variance else np.ones(1)
    total, weights = 0, 0
    for slope, share in zip(slopes, shares):
        facet = normal - slope * azimuth
        area = -(rays * facet).sum(axis=-1)  # of the facet as it is seen
        facet = facet / np.linalg.norm(facet, axis=-1, keepdims=True)
        cosine = np.clip(-(rays * facet).sum(axis=-1), 0, 1)
        mirrored = rays + 2 * cosine[..., None] * facet
        down = (mirrored @ normal)[..., None]
        mirrored = np.where(down < 0, mirrored - 2 * down * normal, mirrored)  # bounced once more
        part = (fresnel(cosine, *media) if sheet.reflectance is None else np.full(cosine.shape, sheet.reflectance))
        sky = np.array(sheet.sky) if sheet.sky else background(scene, user_composite, mirrored)
        sky = sky if around is None or sheet.sky else around / 255
        colour = part[..., None] * sky + (1 - part[..., None]) * sheet.color
        weight = (share * np.maximum(area, 0))[..., None]
        total, weights = total + weight * colour, weights + weight
    return np.rint(255 * total / np.maximum(weights, 1e-30))


def add_plain(scene, sheet, picture):
    """An ordinary sheet in a water's place that shows a picture by the place in the window."""
    scene.origin, scene.normal = sheet.origin, sheet.normal
    return ms.add_sheet(scene, picture, sheet.data, sheet.bounds, sheet.opacity)


def mirrored_with(fill, sheet, others, bounces=False, **options):
    """The mirrored picture of a sheet, turned left to right, with other sheets as what they are in it.

    A gradient is the only background that half opaque things must not stand before.

    bounces  the other sheets, which are calm, reflect the scene; else only the background
    """
    scene = ms.Scene(ms.MIRRORED, **options, **sheet.options)
    fill(scene)
    user_composite = composite_of(scene)
    above = scene.is_above()
    ms.mirror(scene)
    colours = [
        colour_of(scene, other, user_composite,
                  mirrored_twice_with(fill, sheet, other, [sheet, *others], **options) if bounces else None)
        for other in others]
    return picture_with(scene, user_composite, others, colours, sheet, above)


def mirrored_twice_with(fill, sheet, other, sheets, **options):
    """What another sheet reflects where a sheet's mirrored camera sees it: that camera mirrored in it again.

    sheets  all of them, which show the background there; those in the other's plane are left out
    """
    first = ms.Scene(ms.MIRRORED, **options, **sheet.options)
    fill(first)
    ms.mirror(first)
    above = wt.is_above(first.camera, other.origin, other.normal)
    scene = ms.Scene(ms.MIRRORED, **options, **other.options)
    scene.is_above = lambda: above  # what is added is cut at the other sheet, on the mirrored eye's side
    fill(scene)
    user_composite = composite_of(scene)
    for plane in (sheet, other):
        scene.origin, scene.normal = plane.origin, plane.normal
        ms.mirror(scene)
    seen = [each for each in sheets if not is_same_plane(each, other)]
    colours = [colour_of(scene, each, user_composite) for each in seen]
    return picture_with(scene, user_composite, seen, colours, other, above)


def is_same_plane(one, other):
    return np.allclose(np.abs(one.normal @ other.normal), 1) and abs((one.origin - other.origin) @ other.normal) < 1e-9


def picture_with(scene, user_composite, others, colours, sheet, above):
    """The picture of a mirrored scene, turned left to right, with other sheets that show colours, cut at a sheet."""
    sky = np.rint(255 * background(scene, user_composite, rays_of(scene)[1]))
    is_gradient = scene.renderer.GetGradientBackground()
    if is_gradient:
        scene.renderer.GradientBackgroundOff()
        scene.renderer.SetBackground(np.divide(MARK, 255))
    for other, colour in zip(others, colours):
        added = add_plain(scene, other, colour)
        added.GetProperty().LightingOff()
        added.GetMapper().AddClippingPlane(wt.plane(sheet.origin, sheet.normal if above else -sheet.normal))
    picture = scene.pixels()
    if is_gradient:
        picture = np.where((picture == MARK).all(axis=2)[:, :, None], sky, picture)
    return picture[:, ::-1]


def things(scene):
    """A ball and a post that stand in the water."""
    scene.add_data(wt.sphere((0, 0, 0.4), 1.5), (1, 0.6, 0.2), specular=0.6)
    scene.add_data(wt.box((2.4, 0.8, 0.4), (0.8, 0.8, 2.2)), (0.3, 0.8, 0.4), specular=0.6)


def gradient(scene):
    things(scene)
    scene.renderer.GradientBackgroundOn()
    scene.renderer.SetBackground(0.7, 0.75, 0.6)
    scene.renderer.SetBackground2(0.1, 0.2, 0.7)


def parallel(scene):
    scene.camera.ParallelProjectionOn()
    scene.camera.SetParallelScale(4)
    gradient(scene)


def from_below(scene):
    scene.camera.SetPosition(1.5, -9, -3)
    gradient(scene)


def pixels_of(scene, waters, number):
    """The pixels of one water, which the others may hide."""
    looks = [water.GetWaterProperty() for water in waters]
    before = [(look.GetReflectanceMode(), look.GetReflectance(), look.GetDeepColor()) for look in looks]
    pictures = []
    for color in ((1, 0, 1), (0, 1, 0)):
        for i, look in enumerate(looks):
            look.SetReflectanceModeToConstant()
            look.SetReflectance(0)
            look.SetDeepColor(color if i == number else (0.5, 0.5, 0.5))
        pictures.append(scene.pixels())
    for look, (mode, reflectance, color) in zip(looks, before):
        look.SetReflectanceMode(mode)
        look.SetReflectance(reflectance)
        look.SetDeepColor(color)
    return np.abs(pictures[0] - pictures[1]).max(axis=2) > 0


def apart(scene, waters, seen):
    """The picture without water, but with the others' pixels as seen; the pixels of the first water alone."""
    of_others = np.any([pixels_of(scene, waters, i) for i in range(1, len(waters))], axis=0)
    pixels = pixels_of(scene, waters, 0) & ~of_others
    for water in waters:
        water.VisibilityOff()
    without = scene.pixels()
    without[of_others] = seen[of_others]  # they have a mirrored picture of their own
    return without, pixels


def composed(fill, others, seen, mirrored):
    """The picture with ordinary sheets in place of the waters: the first shows a mirrored picture, the others what is seen."""
    truth = ms.Scene(ms.COMPOSED)
    fill(truth)
    add_plain(truth, FIRST, mirrored)
    for other in others:
        add_plain(truth, other, seen)
    return truth.pixels()

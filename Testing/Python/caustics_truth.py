# SPDX-License-Identifier: BSD-3-Clause
"""caustics_truth: light on a level bed under waves, by photons: counted, and not by a formula for what is counted.

Photons stand on a jittered grid over a part of the surface, which lies in its plane, as it is drawn. Each has a
direction of the sun's disc, is refracted by Snell's law at the slope of the waves there, and is counted where it meets
the bed. A picture of that is taken by rays of the eye that are refracted by the same slopes, some in each pixel.
"""

import dataclasses

import numpy as np
import water_test as wt
from vtkwater import vtkWaterActor

INDEX = 1.333
SUN_RADIUS = np.radians(0.2665)
GREY = 0.16  # of the bed: a light of 6 is white
MOST = 6.0  # light that is compared, and pixels show
BATCH = 1 << 15  # photons at a time, which fit the cache of a processor


@dataclasses.dataclass
class Scene:
    """Waves over a level bed: amplitude, wavelength, direction in degrees, phase in degrees of each."""

    waves: tuple
    depth: float
    sun: float  # degrees over the horizon
    size: tuple = (240, 180)
    width: float = 4.0  # of the surface that is seen, m
    eye: float = 90.0  # degrees over the horizon
    port: float = 0.0  # radius of a dome port, which the eye, a sixth of that over the water, sees all of the picture through

    def sun_direction(self):
        high, turn = np.radians(self.sun), np.radians(25.0)
        return np.array((np.cos(high) * np.cos(turn), np.cos(high) * np.sin(turn), np.sin(high)))


COVE = ((0.035, 5.0, 165.0, 10.0), (0.016, 2.3, 205.0, 50.0), (0.010, 1.4, 130.0, 120.0), (0.006, 0.9, 230.0, 200.0),
        (0.003, 0.5, 170.0, 300.0))


def slopes(waves, x, y):
    """dz/dx and dz/dy of sines at the time 0, from the definition of AddWave."""
    gx, gy = np.zeros_like(x), np.zeros_like(x)
    for amplitude, length, direction, phase in waves:
        k = 2 * np.pi / length
        kx, ky = k * np.cos(np.radians(direction)), k * np.sin(np.radians(direction))
        steep = amplitude * np.cos(kx * x + ky * y + np.radians(phase))
        gx += kx * steep
        gy += ky * steep
    return gx, gy


def refracted(rays, gx, gy):
    """Rays (n, 3) that go down, of any length, on in the water."""
    normal = np.stack((-gx, -gy, np.ones_like(gx)), axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    rays = rays / np.linalg.norm(rays, axis=1, keepdims=True)
    cosine = -np.einsum("ij,ij->i", rays, normal)
    under = np.sqrt(1 - (1 - cosine**2) / INDEX**2)
    return rays / INDEX + (cosine / INDEX - under)[:, None] * normal


def lands(rays, depth):
    return -depth * rays[:, :2] / rays[:, 2:]


def irradiance(scene, low, high, texel, count, seed=1):
    """Light on the bed between two corners, over that of calm water; texels[row, column], row 0 at the lowest y."""
    random = np.random.default_rng(seed)
    sun = scene.sun_direction()
    side = np.cross(sun, (0.3, -0.5, 0.2))
    side /= np.linalg.norm(side)
    other = np.cross(sun, side)
    calm = lands(refracted(-sun[None], np.zeros(1), np.zeros(1)), scene.depth)[0]
    reach = 0.35 * scene.depth + 0.3  # more than any of the slopes moves light
    start, end = np.asarray(low) - calm - reach, np.asarray(high) - calm + reach
    rate = np.sqrt(count / np.prod(end - start))
    columns, rows = (int(np.ceil(side * rate)) for side in end - start)
    shape = np.ceil((np.asarray(high) - low) / texel).astype(int)
    counted = np.zeros(shape[0] * shape[1])
    for first in range(0, columns * rows, BATCH):
        number = np.arange(first, min(first + BATCH, columns * rows))
        u = (number % columns + random.random(len(number))) / columns
        v = (number // columns + random.random(len(number))) / rows
        x, y = start[0] + u * (end - start)[0], start[1] + v * (end - start)[1]
        radius = np.tan(SUN_RADIUS) * np.sqrt(random.random(len(number)))
        turn = 2 * np.pi * random.random(len(number))
        rays = -sun - (radius * np.cos(turn))[:, None] * side - (radius * np.sin(turn))[:, None] * other
        place = np.stack((x, y), axis=1) + lands(refracted(rays, *slopes(scene.waves, x, y)), scene.depth)
        at = np.floor((place - low) / texel).astype(int)
        inside = np.all((at >= 0) & (at < shape), axis=1)
        counted += np.bincount(at[inside, 1] * shape[0] + at[inside, 0], minlength=len(counted))
    return counted.reshape(shape[1], shape[0]) / (columns * rows / np.prod(end - start) * texel**2)


def view_of(scene, time=0.0):
    """The scene as the module draws it, and its look."""
    view = wt.View(scene.size, (0, 0, 0))
    wt.add_actor(view.renderer, wt.box((0, 0, -scene.depth - 0.5), (400, 400, 1)), (GREY,) * 3, lit=False)
    wt.add_scene_light(view.renderer, tuple(1000 * scene.sun_direction()))
    water = vtkWaterActor()
    water.SetLevel(0.0)
    water.SetSheetBounds(-190, 190, -190, 190)
    water.SetTime(time)
    look = water.GetWaterProperty()
    look.SetReflectanceModeToConstant()
    look.SetReflectance(0.0)
    look.RefractionOn()
    look.SetAbsorption(0, 0, 0)
    look.SetScattering(0, 0, 0)
    look.GlitterOff()
    for wave in scene.waves:
        look.AddWave(*wave)
    view.renderer.AddActor(water)
    high = np.radians(scene.eye)
    if scene.port > 0.0:
        look.SetDomePortRadius(scene.port)
    distance = 0.5 * scene.width / np.tan(np.radians(15)) * scene.size[1] / scene.size[0]
    camera = view.renderer.GetActiveCamera()
    camera.SetPosition(0, -distance * np.cos(high), distance * np.sin(high))
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp((0, 1, 0) if scene.eye > 80 else (0, 0, 1))
    camera.SetViewAngle(30)
    camera.SetClippingRange(0.1, 500)
    if scene.port > 0.0:
        camera.SetPosition(0, 0, scene.port / 6)
        camera.SetFocalPoint(0, np.cos(high), scene.port / 6 - np.sin(high))
        camera.SetClippingRange(0.01, 500)
    return view, look


def shown(view, look):
    """Light in the module's picture, row 0 at the bottom."""
    look.SetCaustics(0.0)
    plain = view.picture()[:, :, 0].astype(float)
    look.SetCaustics(1.0)
    return view.picture()[:, :, 0] / np.maximum(plain, 1)


def seen_places(scene, view, samples):
    """Where the eye's rays meet the bed: (rows, columns, samples^2, 2)."""
    camera = view.renderer.GetActiveCamera()
    eye, at = np.array(camera.GetPosition()), np.array(camera.GetFocalPoint())
    forward = (at - eye) / np.linalg.norm(at - eye)
    right = np.cross(forward, camera.GetViewUp())
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    columns, rows = scene.size
    half = np.tan(np.radians(camera.GetViewAngle() / 2))
    part = (np.arange(samples) + 0.5) / samples
    u = ((np.arange(columns)[:, None] + part).ravel() / columns * 2 - 1) * half * columns / rows
    v = ((np.arange(rows)[:, None] + part).ravel() / rows * 2 - 1) * half
    rays = (forward + u[None, :, None] * right + v[:, None, None] * up).reshape(-1, 3)
    if scene.port > 0.0:  # straight on
        place = eye[:2] + lands(rays, eye[2] + scene.depth)
    else:
        place = eye[:2] + lands(rays, eye[2])
        place += lands(refracted(rays, *slopes(scene.waves, place[:, 0], place[:, 1])), scene.depth)
    return place.reshape(rows, samples, columns, samples, 2).swapaxes(1, 2).reshape(rows, columns, -1, 2)


def truth(scene, view, photons, samples=4, seed=1):
    """The picture's light by photons."""
    place = seen_places(scene, view, samples)
    low, high = place.min((0, 1, 2)), place.max((0, 1, 2))
    texel = max(0.5 * scene.width / scene.size[0], np.sqrt(np.prod(high - low) / 4e6))
    light = irradiance(scene, low, high + texel, texel, photons, seed)
    at = np.floor((place - low) / texel).astype(int)
    return light[at[..., 1], at[..., 0]].mean(2)


def errors(light, expected):
    """Error of the mean and root mean square error, both over the mean; pixels that the picture can show."""
    good = (light < MOST) & (expected < MOST)
    return (float(light[good].mean() / expected[good].mean() - 1),
            float(np.sqrt(np.mean((light - expected)[good] ** 2)) / expected[good].mean()))

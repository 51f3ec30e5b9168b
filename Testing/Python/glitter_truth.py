# SPDX-License-Identifier: BSD-3-Clause
"""glitter_truth: the sun's glitter by photons: counted, and not by a formula for what is counted.

Photons meet random facets of a sea whose slopes are Gaussian, are reflected there by the law of reflection, and are
counted in the pixel that looks against them. Facets are met as often as they show the sun; how often is found by
counting, too: the facets that face the sun have, seen from it, the area of the sea and no more, or waves would make
light. The same holds for the way to the eye: of all facets that face it, the eye sees the sea's own area.
"""

import numpy as np
import ray_caster

NODES = 400  # angles at which the area of the facets is counted; between them it is interpolated


def slopes_of(covariance, count, random):
    """Slopes of facets of equal areas on the plane: count x 2."""
    root = np.linalg.cholesky(np.array(((covariance[0], covariance[2]), (covariance[2], covariance[1]))))
    half = random.standard_normal((count // 2, 2)) @ root.T
    return np.concatenate((half, -half))  # no slope on the whole


def hidden(slopes, way):
    """Area of the facets that face a direction, seen from there, over the plane's, less 1: what facets hide.

    way: unit vectors, n x 3
    """
    high = np.hypot(way[:, 0], way[:, 1])
    across = way[:, :2] / np.maximum(high, 1e-12)[:, None]
    found = np.empty(len(way))
    for i in range(len(way)):
        faces = way[i, 2] - high[i] * (slopes @ across[i])
        found[i] = np.maximum(faces, 0).mean() / way[i, 2] - 1
    return found


def radiance(sun, covariance, camera, size, index, count=400_000, seed=1):
    """Radiance over the sun's irradiance (on a plane that faces it) of each pixel: rows x columns, and photons in each.

    sun         towards it, unit length
    covariance  xx, yy, xy of the slopes
    """
    random = np.random.default_rng(seed)
    slopes = slopes_of(covariance, count, random)
    normal = np.column_stack((-slopes, np.ones(count)))
    length = np.linalg.norm(normal, axis=1)
    cosine = normal @ sun / length
    light = np.maximum(normal @ sun, 0)  # the facet's area, seen from the sun, over its area on the plane
    way = 2 * (cosine / length)[:, None] * normal - sun
    light *= ray_caster.fresnel(np.clip(cosine, 0, 1), index) / count
    # pixels look against the way
    eye, at = np.array(camera.GetPosition()), np.array(camera.GetFocalPoint())
    forward = (at - eye) / np.linalg.norm(at - eye)
    right = np.cross(forward, camera.GetViewUp())
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    ahead = -way @ forward
    half = np.tan(np.radians(camera.GetViewAngle() / 2))
    with np.errstate(divide="ignore", invalid="ignore"):
        x = -(way @ right) / ahead / half * size[1] / size[0]
        y = -(way @ up) / ahead / half
    seen = (ahead > 0) & (way[:, 2] > 1e-3) & (light > 0) & (abs(x) < 1) & (abs(y) < 1)
    way, light, ahead = way[seen], light[seen], ahead[seen]
    column = ((x[seen] + 1) / 2 * size[0]).astype(int)
    row = ((y[seen] + 1) / 2 * size[1]).astype(int)
    solid = (2 * half / size[1]) ** 2 * ahead**3  # angle of the pixel
    # what hides the facet from the sun, and from the eye
    few = slopes[:20000]
    towards = hidden(few, np.array([sun]))[0]
    turns, heights = np.meshgrid(np.linspace(-np.pi, np.pi, 25), np.geomspace(1e-3, 1, 40), indexing="ij")
    flat = np.sqrt(1 - heights**2)
    table = hidden(few, np.column_stack((np.ravel(flat * np.cos(turns)), np.ravel(flat * np.sin(turns)), heights.ravel())))
    table = table.reshape(turns.shape)
    turn = (np.arctan2(way[:, 1], way[:, 0]) + np.pi) / (2 * np.pi) * 24
    high = np.log(way[:, 2] / 1e-3) / np.log(1e3) * 39
    i, j = np.minimum(turn.astype(int), 23), np.minimum(high.astype(int), 38)
    u, v = turn - i, high - j
    away = ((1 - u) * (1 - v) * table[i, j] + u * (1 - v) * table[i + 1, j] + (1 - u) * v * table[i, j + 1]
            + u * v * table[i + 1, j + 1])
    counted = light / (1 + towards + away) / (way[:, 2] * solid)
    at = row * size[0] + column
    shape = (size[1], size[0])
    return (np.bincount(at, counted, size[0] * size[1]).reshape(shape),
            np.bincount(at, minlength=size[0] * size[1]).reshape(shape))

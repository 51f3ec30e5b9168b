# SPDX-License-Identifier: BSD-3-Clause
"""formulas: how other programs look a reflection up where waves turn the normal.

Each takes reference.Pixels, normals whose x and y may have been exchanged or negated, and its one
constant, and gives places in the mirrored view's texture. Written from the published formulas; no
code of theirs is here.
"""

import itertools
from dataclasses import dataclass

import numpy as np


def _shifted(pixels, offset):
    """The calm place, shifted by shares of the picture. The texture is flipped in x."""
    return pixels.calm + offset * (-1, 1) * pixels.size / pixels.texture_size


def _constant(pixels, normal, scale):
    return _shifted(pixels, scale * normal[:, :2])


def _upright(pixels, normal, scale):
    return _shifted(pixels, scale * normal[:, :2] * (0.25, 1))


def _over_distance(pixels, normal, scale):
    return _shifted(pixels, scale * normal[:, :2] * (0.001 + 1 / pixels.distance)[:, None])


def _over_depth(pixels, normal, scale):
    return _shifted(pixels, scale * normal[:, :2] / pixels.depth[:, None])


def _moved_point(pixels, normal, scale):
    return pixels.map_places(pixels.place + scale * normal * (1, 1, 0))[0]


def _fixed_distance(pixels, normal, scale):
    return pixels.map_places(pixels.place + scale * pixels.away)[0]


@dataclass(frozen=True)
class Formula:
    name: str
    text: str
    place: object
    published: tuple  # (who, constant) pairs
    search: tuple  # from, to: constants to try
    has_axes: bool  # the offset is in axes of the program's own choice


FORMULAS = (
    Formula("constant offset", "uv + s (n.x, n.y)", _constant,
            (("three.js Water2, s = 0.05", 0.05), ("Babylon.js WaterMaterial, s = 0.2", 0.2)), (0.001, 10), True),
    Formula("constant offset, stronger upright", "uv + s (n.x / 4, n.y)", _upright,
            (("Unity BoatAttack, s = 0.2", 0.2),), (0.001, 10), True),
    Formula("offset over distance", "uv + s (0.001 + 1 / distance) (n.x, n.y)", _over_distance,
            (("three.js Water, s = 20", 20), ("three.js Water as in its example, s = 3.7", 3.7)), (0.01, 100), True),
    Formula("offset over depth", "uv + s (n.x, n.y) / depth", _over_depth,
            (("Crest 4, s = 1", 1),), (0.01, 100), True),
    Formula("moved surface point", "map(P + s (n.x, n.y, 0))", _moved_point,
            (("osgOcean and Lombard's VP_water_1, s = 4 units", 4),), (0.01, 100), False),
    Formula("fixed distance along the ray", "map(P + s R)", _fixed_distance,
            (("Godot mirror plugin, s = 0.7 units", 0.7), ("Unreal PlanarReflection, s = 5 m", 5)), (0.01, 1000),
            False),
)


def axes_of(formula):
    """All ways to assign a normal's x and y to the axes of a formula."""
    if not formula.has_axes:
        return (np.eye(3),)
    ways = []
    for swap, sign_x, sign_y in itertools.product((False, True), (1, -1), (1, -1)):
        way = np.diag((sign_x, sign_y, 1.0))
        ways.append(way[[1, 0, 2]] if swap else way)
    return tuple(ways)

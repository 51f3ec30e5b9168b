# SPDX-License-Identifier: BSD-3-Clause
"""Row Water in water of the mirror matrix: other waters in a mirrored view have their colour and their sky, once."""

import mirror_matrix as mm
import numpy as np
import water_test as wt
from mirror_waters import FIRST, LEVEL, Sheet, apart, composed, from_below, gradient, mirrored_with, parallel, things
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkDiskSource
from vtkwater import vtkWaterReflectionPass as Pass

row = mm.Results("Water in water", __file__)


def show(name, fill, others, prepare=None, reason=None, wrong=(), exact=True):
    """The first water's pixels: the mirrored picture with the others in it; the control has wrong ones, or none."""
    scene = mm.Scene(mm.SEEN)
    fill(scene)
    waters = [sheet.add_to(scene) for sheet in (FIRST, *others)]
    if prepare:
        prepare(waters)
    seen = scene.pixels()
    renders = [water.GetReflectionPass().GetNumberOfReflectionRenders() for water in waters]
    without, pixels = apart(scene, waters, seen)
    truth, control = (composed(fill, others, seen, mirrored_with(fill, FIRST, inside)) for inside in (others, wrong))
    row.compare(name, seen, truth, without, pixels, control, reason, exact)
    return renders


def cell(name, *arguments, **options):
    """Registers a cell; arguments as those of show."""
    row.register(name, show, *arguments, **options)


HIGHER = Sheet((0, 0, 1.4), LEVEL, (-6, -1, -3, 5))
RAMP = Sheet((-2.5, 3, 0.8), (0.2, -0.8, 0.7), (-2.5, 2.5, -2.2, 2.5))
cell("a level over the water, whose underside it sees", gradient, [HIGHER])
cell("a tilted plane that crosses the water", gradient, [RAMP])
cell("a tilted plane, on a plain background", things, [RAMP])
cell("a tilted plane seen from its back", gradient,
     [Sheet(RAMP.origin, (-0.2, 1, -0.1), RAMP.bounds)])
cell("a tilted plane, parallel projection", parallel, [RAMP])
cell("a level under the water, seen from below", from_below, [Sheet((0, 0, -1.6), LEVEL, (-6, 0, -3, 5))])
cell("a constant reflectance", gradient, [Sheet(RAMP.origin, RAMP.normal, RAMP.bounds, reflectance=0.4)])
cell("an environment texture", gradient, [Sheet(RAMP.origin, RAMP.normal, RAMP.bounds, sky=(1.0, 0.6, 0.2))])
cell("half opaque water", things, [Sheet(RAMP.origin, RAMP.normal, RAMP.bounds, opacity=0.5)])


def ring():
    """A mesh of the user's with a hole, in a plane that is not level."""
    disk = vtkDiskSource()
    disk.SetInnerRadius(0.6)
    disk.SetOuterRadius(2.2)
    disk.SetCircumferentialResolution(40)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(disk.GetOutputPort())
    triangles.Update()
    first, second = mm.axes_of(RAMP.normal)
    matrix = mm.matrix_of(*np.column_stack([first, second, RAMP.normal, RAMP.origin]))
    return wt.transformed(triangles.GetOutput(), matrix)


@row.makes("a user's mesh")
def mesh():
    show("a user's mesh", gradient, [Sheet(RAMP.origin, RAMP.normal, RAMP.bounds, data=ring())])


cell("three waters", gradient, [HIGHER, Sheet((2, 4, 1.0), (-0.3, -0.9, 0.5), (-2, 2, -2, 2))])
cell("sheets in the same plane, given by other points or reversed, do not count as other waters", gradient,
     [RAMP, Sheet((5, 5, 0), (0, 0, -3), (3, 4, 3, 4), reflectance=1.0)])


@row.makes("water that the other reflects")
def each_other():
    renders = show("water that the other reflects: no recursion", gradient,
                   [Sheet((0, 5, 0), (0, -1, 0.2), (-6, 6, -3, 3))])
    row.say("water that the other reflects: each is rendered once", renders == [1, 1])


# Waves of other water count as the mean of all times: a roughness without one.
WAVES = [(0.03, 0.9, 30), (0.02, 0.5, 75), (0.012, 0.3, -20)]
VARIANCE = sum((2 * np.pi / length * height) ** 2 / 2 for height, length, _ in WAVES)


def add_waves(waters, geometry=False):
    look = waters[1].GetWaterProperty()
    for height, length, direction in WAVES:
        look.AddWave(height, length, direction)
    look.SetWaveGeometry(geometry)


# Seen at a low angle; the control is the same water, calm.
LOW = Sheet((-1.5, 3, 0.8), (0, -0.5, 0.866), (-3, 3, -2.2, 3))
rough = Sheet(LOW.origin, LOW.normal, LOW.bounds, variance=VARIANCE / 2)
cell("water with waves", gradient, [rough], prepare=add_waves, wrong=[LOW], exact=False,
     reason="Its waves appear as the mean of all times, with three facets; the truth has 80.")
cell("water with waves that displace it", gradient, [rough], prepare=lambda waters: add_waves(waters, True),
     wrong=[LOW], exact=False,
     reason="It is drawn at rest, with its waves as the mean of all times and three facets; the truth has 80.")


# What of other water makes the reflection texture a new one.
def decides(name, expected, change):
    scene = mm.Scene(mm.SEEN)
    gradient(scene)
    first, other = (sheet.add_to(scene) for sheet in (FIRST, RAMP))
    add_waves((first, other))
    for _ in range(2):  # shaders of another kind count as a change once
        scene.pixels()
    change(other)
    scene.pixels()
    row.say(name, first.GetReflectionPass().GetDecision() == expected)


def look(other):
    return other.GetWaterProperty()


for name, expected, change in (
    ("the time of its waves: the reflection texture is used again", Pass.REUSED, lambda other: other.SetTime(3.0)),
    ("no change: the reflection texture is used again", Pass.REUSED, lambda other: None),
    ("another colour: the reflection texture is drawn again", Pass.RENDERED,
     lambda other: look(other).SetDeepColor(0.5, 0.1, 0.1)),
    ("another wave: the reflection texture is drawn again", Pass.RENDERED,
     lambda other: look(other).AddWave(0.01, 0.2)),
    ("another index: the reflection texture is drawn again", Pass.RENDERED,
     lambda other: look(other).SetIndexOfRefraction(1.4)),
    ("another opacity: the reflection texture is drawn again", Pass.RENDERED,
     lambda other: look(other).SetOpacity(0.7)),
    ("another place: the reflection texture is drawn again", Pass.RENDERED,
     lambda other: other.GetPlane().SetOrigin(-2.5, 3.1, 0.8)),
    ("another size: the reflection texture is drawn again", Pass.RENDERED,
     lambda other: other.SetSheetBounds(-2, 2, -2, 2)),
    ("no other water: the reflection texture is drawn again", Pass.RENDERED, lambda other: other.VisibilityOff()),
):
    row.register(name, decides, expected, change)

test_cell = row.test()

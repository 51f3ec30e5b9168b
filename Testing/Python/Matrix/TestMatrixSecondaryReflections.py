# SPDX-License-Identifier: BSD-3-Clause
"""Row Secondary reflections of the mirror matrix: other waters in a mirrored view reflect the scene, with one bounce."""

import mirror_matrix as mm
import water_test as wt
from mirror_waters import FIRST, LEVEL, Sheet, apart, composed, from_below, gradient, mirrored_with, parallel, things
from vtkwater import vtkWaterReflectionPass as Pass

row = mm.Results("Secondary reflections", __file__)
WALL_PLACE = (0, 3, 0), (0.7, -1, -0.25), (-6, 6, -3, 5)  # leans over the things, which it shows from behind
WALL = Sheet(*WALL_PLACE, reflectance=0.7)
RAMP = Sheet((-2.6, 1, 1.2), (0.9, -0.35, -0.3), (-2.5, 2.5, -2.2, 2.5), reflectance=0.7)
SHELF = Sheet((0, 0, 2.6), LEVEL, (-6, 4, -2, 5))  # over them: its underside is seen
FLOOR = Sheet((0, 0, -1.6), LEVEL, (-6, 0, -3, 5))


def show(name, fill, others, prepare=None, reason=None, exact=True):
    """The first water's pixels: in its mirrored picture the others reflect the scene; the control has the sky there."""
    scene = mm.Scene(mm.SEEN)
    fill(scene)
    waters = [sheet.add_to(scene) for sheet in (FIRST, *others)]
    waters[0].GetReflectionPass().SecondaryReflectionsOn()
    if prepare:
        prepare(scene, waters)
    errors = [wt.errors_of(water) for water in waters]
    seen = scene.pixels()
    wt.check_equal(f"{name}: errors", sum(errors, []), [])
    renders = waters[0].GetReflectionPass().GetNumberOfSecondaryRenders()
    without, pixels = apart(scene, waters, seen)
    truth, control = (composed(fill, others, seen, mirrored_with(fill, FIRST, others, bounces)) for bounces in (True, False))
    row.compare(name, seen, truth, without, pixels, control, reason, exact)
    return renders


def cell(name, *arguments, **options):
    """Registers a cell; arguments as those of show."""
    row.register(name, show, *arguments, **options)


cell("a plane that leans over the scene", gradient, [WALL])
cell("a plane that leans over the scene, on a plain background", things, [WALL])
cell("a tilted plane", gradient, [RAMP])
cell("parallel projection", parallel, [WALL])
cell("the underside of a level over the water", gradient, [SHELF])
cell("seen from below: a level under the water", from_below, [FLOOR])
cell("half opaque water", things, [Sheet(*WALL_PLACE, reflectance=0.7, opacity=0.5)])
cell("Fresnel's reflectance", gradient, [Sheet((0, 3, 0), (0.9, -1, -0.3), (-6, 6, -3, 5))])
cell("three planes", gradient, [WALL, RAMP])

test_cell = row.test()

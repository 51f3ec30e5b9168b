# SPDX-License-Identifier: BSD-3-Clause
"""Rows Waters and Picking of the mirror matrix."""

import mirror_matrix as mm
import numpy as np
import water_test as wt
from mirror_waters import Sheet, add_plain, mirrored_with
from vtkmodules.vtkFiltersSources import vtkDiskSource
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkRenderingCore import (
    vtkAreaPicker,
    vtkCellPicker,
    vtkHardwareSelector,
    vtkPointPicker,
    vtkPolyDataMapper,
    vtkPropPicker,
    vtkWorldPointPicker,
)

row = mm.Results("Waters and picking", __file__)


def things(scene):
    scene.add_data(wt.sphere((0, 0, 0.4), 1.5), (1, 0.6, 0.2), specular=0.6)
    scene.add_data(wt.box((2.4, 0.8, 0.4), (0.8, 0.8, 2.2)), (0.3, 0.8, 0.4), specular=0.6)


def several(name, sheets, decisions):
    """Waters in one scene that reflect everything: each must show its own mirrored picture, in which the others
    show the background."""
    scene = mm.Scene(mm.SEEN)
    things(scene)
    waters = [sheet.add_to(scene) for sheet in sheets]
    seen = scene.pixels()
    renders = sum(water.GetReflectionPass().GetNumberOfReflectionRenders() for water in waters)
    pixels = np.any([mm.water_pixels(scene, water) for water in waters], axis=0)
    for water in waters:
        water.VisibilityOff()
    without = scene.pixels()

    def composed(fill):
        truth = mm.Scene(mm.COMPOSED)
        things(truth)
        for sheet in sheets:
            others = [other for other in sheets if other.plane() != sheet.plane()]
            add_plain(truth, sheet, mirrored_with(fill, sheet, others))
        return truth.pixels()

    row.compare(name, seen, composed(things), without, pixels, composed(mm.without_props(things)))
    row.say(f"{name}: mirrored views rendered: {decisions}", renders == decisions)


LEVEL = (0, 0, 1)
LEFT = Sheet((0, 0, 0), LEVEL, (-7, 0, -5, 7), reflectance=1.0)
row.register("several sheets at one level share one reflection texture", several,
             [LEFT, Sheet((0, 0, 0), LEVEL, (0, 7, -5, 2), reflectance=1.0),
              Sheet((0, 0, 0), LEVEL, (0, 7, 2, 7), reflectance=1.0)], 1)
row.register("two levels", several, [LEFT, Sheet((0, 0, -0.4), LEVEL, (0, 7, -5, 7), reflectance=1.0)], 2)
row.register("a level and a tilted plane", several,
             [LEFT, Sheet((3.5, 0, 0), (-0.15, 0.05, 1), (-2.5, 2.5, -4, 5), reflectance=1.0)], 2)


def back(scene):
    """An upright sheet seen from the side its normal does not point to."""
    scene.camera.SetPosition(3, -9, 2)
    things(scene)


row.cell("a sheet whose back is seen", back, origin=(-2.2, 0, 0), normal=(-1, 0.2, 0.1), bounds=(-4, 4, -3, 3))


def lake():
    """A lake of the user's mesh with an island: a ring of triangles."""
    disk = vtkDiskSource()
    disk.SetInnerRadius(1.0)
    disk.SetOuterRadius(4.2)
    disk.SetCircumferentialResolution(40)
    disk.SetRadialResolution(3)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(disk.GetOutputPort())
    triangles.Update()
    return triangles.GetOutput()


@row.makes("a user's lake mesh with an island")
def lake_with_island():
    def fill(scene):
        scene.add_data(wt.pyramid((0, 0, 0.5), 2.2, 24, 1.3), (0.4, 0.7, 0.3))
        scene.add_data(wt.box((2.4, 0.8, 0.4), (0.8, 0.8, 2.2)), (1, 0.6, 0.2))

    scene = mm.Scene(mm.SEEN)
    fill(scene)
    water = wt.add_water(scene.renderer, wt.plane((0, 0, 0), LEVEL))
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(lake())
    water.SetMapper(mapper)
    seen = scene.pixels()
    pixels = mm.water_pixels(scene, water)
    water.VisibilityOff()
    without = scene.pixels()

    def composed(fill_mirrored):
        truth = mm.Scene(mm.COMPOSED)
        fill(truth)
        mm.add_sheet(truth, mm.mirrored_picture(fill_mirrored), lake())
        return truth.pixels()

    row.compare("a user's lake mesh with an island", seen, composed(fill), without, pixels,
                composed(mm.without_props(fill)))


# Picking: what is there is hit, the water too, unless it is not pickable.
ON_BALL, ON_WATER, ON_SKY = (118, 120), (60, 50), (10, 175)


class PickScene(mm.Scene):
    """A ball, the water, and ground under it, after a first frame."""

    def __init__(self):
        super().__init__(mm.SEEN)
        things(self)
        self.ground = self.add_data(wt.box((0, 0, -1.2), (12, 12, 0.4)), (0.6, 0.5, 0.4))
        self.ball = self.renderer.GetViewProps().GetItemAsObject(0)
        self.water = wt.add_water(self.renderer, wt.plane((0, 0, 0), LEVEL), mm.SHEET)
        self.pixels()


def selected(scene, x, y):
    selector = vtkHardwareSelector()
    selector.SetRenderer(scene.renderer)
    selector.SetArea(x, y, x, y)
    selector.SetFieldAssociation(vtkDataObject.FIELD_ASSOCIATION_CELLS)
    selection = selector.Select()
    if selection.GetNumberOfNodes() == 0:
        return None
    return selection.GetNode(0).GetProperties().Get(selection.GetNode(0).PROP())


def picked_by(picker_class):
    def pick(scene, x, y):
        picker = picker_class()
        if picker_class is vtkPointPicker:
            picker.SetTolerance(0.5)  # corners of large faces are far apart
        picker.Pick(x, y, 0, scene.renderer)
        return picker.GetViewProp()

    return pick


def picked_by_area(scene, x, y):
    picker = vtkAreaPicker()
    picker.AreaPick(x - 1, y - 1, x + 1, y + 1, scene.renderer)
    props = picker.GetProp3Ds()
    return [props.GetItemAsObject(i) for i in range(props.GetNumberOfItems())]


PICKERS = {
    "hardware selector": selected,
    "cell picker": picked_by(vtkCellPicker),
    "prop picker": picked_by(vtkPropPicker),
}


def picker(name, pick):
    scene = PickScene()
    row.say(f"{name}: a ball over the water is hit", pick(scene, *ON_BALL) is scene.ball)
    row.say(f"{name}: the water is hit", pick(scene, *ON_WATER) is scene.water)
    row.say(f"{name}: nothing is hit in the sky", pick(scene, *ON_SKY) is None)
    scene.water.PickableOff()
    row.say(f"{name}: the ground is hit through water that is not pickable", pick(scene, *ON_WATER) is scene.ground)
    row.say(f"{name}: a ball is hit beside water that is not pickable", pick(scene, *ON_BALL) is scene.ball)


for name, pick in PICKERS.items():
    row.register(name, picker, pick)


@row.makes("point picker")
def point_picker():
    scene, pick = PickScene(), picked_by(vtkPointPicker)
    row.say("point picker: a point of the ball is hit", pick(scene, *ON_BALL) is scene.ball)
    scene.water.PickableOff()
    row.say("point picker: not the water that is not pickable", pick(scene, *ON_WATER) is not scene.water)


@row.makes("area picker")
def area_picker():
    scene = PickScene()
    scene.water.PickableOff()
    row.say("area picker: not the water that is not pickable", scene.water not in picked_by_area(scene, *ON_WATER))
    scene.water.PickableOn()
    row.say("area picker: the water", scene.water in picked_by_area(scene, *ON_WATER))


@row.makes("world point picker")
def world_point_picker():
    def place(renderer):
        world = vtkWorldPointPicker()
        world.Pick(*ON_WATER, 0, renderer)
        return np.array(world.GetPickPosition())

    scene = PickScene()
    on_it = place(scene.renderer)
    ordinary = mm.Scene(mm.COMPOSED)
    things(ordinary)
    mm.add_sheet(ordinary, None)
    ordinary.pixels()
    row.say("world point picker: where an ordinary sheet is hit",
            np.abs(on_it - place(ordinary.renderer)).max() < 1e-4)


@row.makes("the picture after picking is that before it")
def picture_after_picking():
    scene = PickScene()
    before = scene.pixels()
    for pick in PICKERS.values():
        pick(scene, *ON_WATER)
    row.say("the picture after picking is that before it", np.array_equal(scene.pixels(), before))


test_cell = row.test()

# SPDX-License-Identifier: BSD-3-Clause
"""vtk_copies: VTK without this project: the terrain once more, upside down, and a sheet.

Points are mirrored, triangles turned round and normals left alone, so that the copy is lit as the
ground is. The ground is cut at the water, or its bed would hide the copy; the copy is cut, too, or
the mirrored bed would stand over the water. A sheet like this has the same opacity everywhere.
"""

import sys

from peer import read_scene, serve
from vtk_view import VERSION, View, driver, read_terrain
from vtkmodules.vtkCommonDataModel import vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkReverseSense
from vtkmodules.vtkFiltersGeneral import vtkTransformFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkCommonTransforms import vtkTransform

SHEET_COLOR, SHEET_OPACITY = (0.05, 0.16, 0.22), 0.45


def upside_down(terrain):
    mirror = vtkTransform()
    mirror.Scale(1.0, 1.0, -1.0)
    turned = vtkTransformFilter()
    turned.SetTransform(mirror)
    turned.SetInputData(terrain)
    reversed_ = vtkReverseSense()
    reversed_.SetInputConnection(turned.GetOutputPort())
    reversed_.ReverseCellsOn()
    reversed_.ReverseNormalsOff()
    reversed_.Update()
    copy = vtkPolyData()
    copy.ShallowCopy(reversed_.GetOutput())
    copy.GetPointData().SetNormals(terrain.GetPointData().GetNormals())
    return copy


def cut(actor, up):
    plane = vtkPlane()
    plane.SetNormal(0.0, 0.0, up)
    actor.GetMapper().AddClippingPlane(plane)


def mirrored_view(scene, terrain):
    view = View(scene, terrain)
    cut(view.ground, 1.0)
    cut(view.add_mesh(upside_down(terrain)), -1.0)
    xmin, xmax, ymin, ymax = scene["sheet"]
    sheet = vtkPlaneSource()
    sheet.SetOrigin(xmin, ymin, 0.0)
    sheet.SetPoint1(xmax, ymin, 0.0)
    sheet.SetPoint2(xmin, ymax, 0.0)
    sheet.Update()
    look = view.add_mesh(sheet.GetOutput()).GetProperty()
    look.LightingOff()
    look.SetColor(*SHEET_COLOR)
    look.SetOpacity(SHEET_OPACITY)
    return view


def main():
    scene = read_scene(sys.argv[1])
    terrain = read_terrain(scene["terrain"])
    views = {"plain": View(scene, terrain), "copies": mirrored_view(scene, terrain)}
    serve(views, VERSION, driver(views["plain"]))


if __name__ == "__main__":
    main()

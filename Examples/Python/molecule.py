# SPDX-License-Identifier: BSD-3-Clause
"""molecule: buckminsterfullerene over a mirror floor, which shows its other side.

The floor is a water of the preset "mirror floor", with less than a mirror's reflectance.
"""

import argparse
import itertools

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkGlyph3D, vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkwater.errors import ending
from vtkwater.pictures import png_name
from vtkwater.scenes import Scene

BOND = 1.45  # angstrom, the mean of its two kinds of bonds


def atoms():
    """The 60 corners of a truncated icosahedron with edges of BOND, around the origin."""
    golden = 0.5 * (1.0 + 5.0**0.5)
    corners = set()
    for corner in ((0.0, 1.0, 3.0 * golden), (1.0, 2.0 + golden, 2.0 * golden), (golden, 2.0, 2.0 * golden + 1.0)):
        for signs in itertools.product((-1.0, 1.0), repeat=3):
            signed = [sign * part + 0.0 for sign, part in zip(signs, corner)]
            corners.update(tuple(signed[(i + turn) % 3] for i in range(3)) for turn in range(3))
    return 0.5 * BOND * np.array(sorted(corners))


def bonds(places):
    """Pairs of atoms that are a bond apart."""
    distances = np.linalg.norm(places[:, None] - places[None], axis=2)
    return [(i, j) for i, j in zip(*np.nonzero(distances < 1.1 * BOND)) if i < j]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="molecule.png", type=png_name, help="default: %(default)s")
    arguments = parser.parse_args()

    places = atoms()
    places[:, 2] += 4.4
    points, lines, data = vtkPoints(), vtkCellArray(), vtkPolyData()
    points.SetData(numpy_to_vtk(places, deep=True))
    for i, j in bonds(places):
        lines.InsertNextCell(2)
        lines.InsertCellPoint(int(i))
        lines.InsertCellPoint(int(j))
    data.SetPoints(points)
    data.SetLines(lines)
    ball = vtkSphereSource()
    ball.SetRadius(0.36)
    ball.SetThetaResolution(32)
    ball.SetPhiResolution(32)
    balls = vtkGlyph3D()
    balls.SetInputData(data)
    balls.SetSourceConnection(ball.GetOutputPort())
    sticks = vtkTubeFilter()
    sticks.SetInputData(data)
    sticks.SetRadius(0.13)
    sticks.SetNumberOfSides(20)

    scene = Scene((960, 720))
    scene.renderer.SetBackground(0.88, 0.89, 0.90)
    scene.renderer.SetBackground2(0.97, 0.97, 0.98)
    for part, color in ((balls, (0.22, 0.24, 0.28)), (sticks, (0.85, 0.55, 0.15))):
        actor = scene.add_mesh(part, color)
        actor.GetProperty().SetSpecular(0.5)
        actor.GetProperty().SetSpecularPower(40.0)
    floor = scene.add_water(0.0, "mirror floor")
    floor.GetWaterProperty().SetReflectance(0.55)
    floor.GetWaterProperty().SetDeepColor(0.80, 0.81, 0.83)
    floor.SetSheetBounds(-12.0, 12.0, -12.0, 12.0)
    scene.set_camera((6.0, -17.0, 8.5), (0.0, 0.0, 2.2), 40.0)
    scene.write(arguments.picture)


if __name__ == "__main__":
    with ending("molecule"):
        main()

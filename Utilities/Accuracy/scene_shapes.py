# SPDX-License-Identifier: BSD-3-Clause
"""scene_shapes: the things of a random scene: meshes of triangles, in double precision, about the origin.

A shape is a function of a generator of random numbers and of a size.
"""

import numpy as np
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricTorus
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import (
    vtkConeSource,
    vtkCubeSource,
    vtkCylinderSource,
    vtkParametricFunctionSource,
    vtkPlatonicSolidSource,
    vtkSphereSource,
)

NAMES = ("box", "sphere", "cone", "torus", "pole", "half cylinder", "standing plane", "solid")


def triangles(source):
    """A source's triangles alone: VTK and the tracer are not to cut polygons each in its own way."""
    found = vtkTriangleFilter()
    found.SetInputConnection(source.GetOutputPort())
    found.PassVertsOff()
    found.PassLinesOff()
    found.Update()
    data = vtkPolyData()
    data.SetPoints(found.GetOutput().GetPoints())
    data.SetPolys(found.GetOutput().GetPolys())
    return data


def surface(points):
    """Triangles between points in rows and columns."""
    rows, columns = points.shape[:2]
    first = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    ids = np.concatenate([np.stack([first, first + columns, first + 1], axis=1),
                          np.stack([first + 1, first + columns, first + columns + 1], axis=1)])
    places = vtkPoints()
    places.SetDataTypeToDouble()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points.reshape(-1, 3)), deep=True))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(ids.ravel(), deep=True))
    data = vtkPolyData()
    data.SetPoints(places)
    data.SetPolys(cells)
    return data


def turned(data, tilts, heading):
    """Tilted about x and y, then turned about z, in radians."""
    matrix = wt.vtkMatrix4x4()
    turn = np.eye(3)
    for axis, angle in ((0, tilts[0]), (1, tilts[1]), (2, heading)):
        cosine, sine = np.cos(angle), np.sin(angle)
        one, other = (axis + 1) % 3, (axis + 2) % 3
        step = np.eye(3)
        step[one, one] = step[other, other] = cosine
        step[one, other], step[other, one] = -sine, sine
        turn = step @ turn
    for i in range(3):
        for j in range(3):
            matrix.SetElement(i, j, turn[i, j])
    return wt.transformed(data, matrix)


def _box(random, size):
    source = vtkCubeSource()
    lengths = size * random.uniform(0.4, 1.6, 3)
    source.SetXLength(lengths[0])
    source.SetYLength(lengths[1])
    source.SetZLength(lengths[2])
    return triangles(source)


def _sphere(random, size):
    source = vtkSphereSource()
    source.SetRadius(0.6 * size)
    source.SetThetaResolution(int(random.integers(8, 97)))
    source.SetPhiResolution(int(random.integers(6, 97)))
    return triangles(source)


def _cone(random, size):
    source = vtkConeSource()
    source.SetDirection(0, 0, 1 if random.random() < 0.7 else -1)
    source.SetHeight(size * random.uniform(0.6, 2))
    source.SetRadius(size * random.uniform(0.2, 0.7))
    source.SetResolution(int(random.integers(4, 49)))
    source.SetCapping(random.random() < 0.7)
    return triangles(source)


def _torus(random, size):
    shape = vtkParametricTorus()
    shape.SetRingRadius(0.6 * size)
    shape.SetCrossSectionRadius(size * random.uniform(0.05, 0.3))
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(shape)
    source.SetUResolution(40)
    source.SetVResolution(24)
    source.GenerateNormalsOff()
    return turned(triangles(source), random.uniform(-1.5, 1.5, 2), 0)


def _pole(random, size):
    source = vtkCylinderSource()  # along y
    source.SetRadius(size * random.uniform(0.02, 0.1))
    source.SetHeight(size * random.uniform(2, 6))
    source.SetResolution(int(random.integers(4, 25)))
    return turned(triangles(source), (np.pi / 2, 0), 0)


def _half_cylinder(random, size):
    """Open at its ends and along its side."""
    angle, height = np.meshgrid(np.linspace(0, np.pi, int(random.integers(6, 33))), (0, size * random.uniform(0.5, 2)),
                                indexing="ij")
    radius = size * random.uniform(0.3, 1)
    lying = random.random() < 0.4
    parts = (radius * np.cos(angle), height, radius * np.sin(angle))
    return surface(np.stack(parts if lying else (parts[0], parts[2], parts[1]), axis=-1))


def _standing_plane(random, size):
    x, z = np.meshgrid(size * random.uniform(0.5, 3) * np.linspace(-0.5, 0.5, 5),
                       size * random.uniform(0.3, 2) * np.linspace(0, 1, 3), indexing="ij")
    return surface(np.stack([x, np.zeros_like(x), z], axis=-1))


def _solid(random, size):
    source = vtkPlatonicSolidSource()
    source.SetSolidType(int(random.integers(5)))
    data = triangles(source)
    matrix = wt.vtkMatrix4x4()
    for i in range(3):
        matrix.SetElement(i, i, 0.6 * size)
    return wt.transformed(data, matrix)


SHAPES = dict(zip(NAMES, (_box, _sphere, _cone, _torus, _pole, _half_cylinder, _standing_plane, _solid)))

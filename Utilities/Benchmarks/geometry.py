# SPDX-License-Identifier: BSD-3-Clause
"""geometry: what the benchmark's scenes are made of: fields of heights, scattered things, a plume.

Colours are bytes at the points with the light drawn in, so that a picture without lighting still
looks like something, and a tracer of triangles can know it.
"""

import functools
import pathlib

import numpy as np
import water_test as wt
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401  factory
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkImageData,
    vtkPiecewiseFunction,
    vtkPolyData,
)
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolume
from vtkmodules.vtkRenderingVolume import vtkGPUVolumeRayCastMapper

ELEVATION = pathlib.Path(__file__).resolve().parents[2] / "Examples" / "Data" / "jacksboro.vti"
METRES = (
    200.0  # of the elevation model in a unit of the scene, so that all scenes share their waves
)
EXAGGERATION = 3.0  # of heights
CENTER = (0.530, 0.122)  # the origin, as shares of the map
SUN = np.array((0.66, -0.38, 0.65))
SEED = 20261121
PLUME_SIZE = 64  # voxels along each axis


def _shaded(base, normal):
    """Colour bytes of ground under the sun."""
    light = 0.6 + 0.75 * np.clip(normal @ (SUN / np.linalg.norm(SUN)), 0, 1)
    return np.clip(255 * base * light[..., None], 0, 255).astype(np.uint8)


def height_field(x, y, z, base):
    """Two triangles to a cell of a grid; z and base (colours) in rows of y."""
    rows, columns = z.shape
    down, across = np.gradient(z, y, x)
    normal = np.stack([-across, -down, np.ones_like(z)], axis=-1)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    corner = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    first, second = (
        np.stack([corner, corner + a, corner + b], axis=1)
        for a, b in ((1, columns + 1), (columns + 1, columns))
    )
    return mesh(
        np.stack([*np.meshgrid(x, y), z], axis=-1).reshape(-1, 3),
        np.concatenate([first, second]),
        normal.reshape(-1, 3),
        _shaded(base, normal).reshape(-1, 3),
    )


def mesh(points, triangles, normals, rgb):
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(
        numpy_to_vtk(np.ascontiguousarray(points, dtype=np.float32), deep=True)
    )
    cells = vtkCellArray()
    cells.SetData(
        3,
        numpy_to_vtk(
            np.ascontiguousarray(triangles, dtype=np.int64).ravel(), deep=True, array_type=16
        ),
    )
    data.SetPolys(cells)
    data.GetPointData().SetNormals(
        numpy_to_vtk(np.ascontiguousarray(normals, dtype=np.float32), deep=True)
    )
    data.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(rgb), deep=True))
    return data


@functools.lru_cache
def elevation():
    """x, y and heights over sea level (rows of y) in units of the scene, before exaggeration."""
    reader = vtkXMLImageDataReader()
    reader.SetFileName(str(ELEVATION))
    reader.Update()
    image = reader.GetOutput()
    columns, rows, _ = image.GetDimensions()
    z = (
        vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns).astype(float)
        / METRES
    )
    x, y = (
        spacing / METRES * (np.arange(count) - share * (count - 1))
        for spacing, count, share in zip(image.GetSpacing(), (columns, rows), CENTER)
    )
    return x, y, z


@functools.lru_cache
def terrain(level, tiles=1):
    """The land, level metres at z = 0, in tiles x tiles meshes: about 275,000 triangles."""
    x, y, metres = elevation()
    z = EXAGGERATION * (metres - level / METRES)
    stops = np.array((-1.0, 0.1, 0.4, 3.0, 6.0, 9.0))
    colors = np.array(
        (
            (0.45, 0.40, 0.30),
            (0.50, 0.45, 0.32),
            (0.33, 0.42, 0.20),
            (0.28, 0.40, 0.20),
            (0.50, 0.46, 0.40),
            (0.95, 0.95, 0.96),
        )
    )
    base = np.stack([np.interp(z, stops, colors[:, i]) for i in range(3)], axis=-1)
    found = []
    for rows in _parts(len(y), tiles):
        for columns in _parts(len(x), tiles):
            found.append(height_field(x[columns], y[rows], z[rows, columns], base[rows, columns]))
    return tuple(found)


def _parts(count, parts):
    cuts = np.linspace(0, count - 1, parts + 1).astype(int)
    return [slice(first, last + 1) for first, last in zip(cuts, cuts[1:])]


@functools.lru_cache
def big_mesh(triangles):
    """Hills in the water, as fine as it takes."""
    side = round(np.sqrt(triangles / 2)) + 1
    x = y = np.linspace(-20, 20, side)
    z = np.full((side, side), -1.0)
    random = np.random.default_rng(SEED)
    for _ in range(14):
        east, north = random.uniform(-14, 14), random.uniform(-6, 18)
        height, width = random.uniform(1.5, 4), random.uniform(1.2, 3)
        z += (
            height
            * np.exp(-((y - north) ** 2)[:, None] / width**2)
            * np.exp(-((x - east) ** 2) / width**2)
        )
    z += 0.03 * np.sin(9 * x) * np.sin(8 * y)[:, None]
    base = np.stack(
        [
            np.interp(z, (-1, 0.1, 1, 3), stops)
            for stops in ((0.5, 0.6, 0.3, 0.9), (0.4, 0.5, 0.5, 0.9), (0.3, 0.3, 0.2, 0.95))
        ],
        axis=-1,
    )
    return height_field(x, y, z, base)


@functools.lru_cache
def _templates():
    return (wt.box((0, 0, 0), (1, 1, 1)), wt.pyramid((0, 0, 0), 1), wt.sphere((0, 0, 0), 0.5, 10))


@functools.lru_cache
def things(count, low, high, size):
    """(data, colour) of so many boxes, pyramids and balls between two corners."""
    random = np.random.default_rng(SEED)
    made = []
    for i in range(count):
        template = _templates()[i % 3]
        scale = random.uniform(0.3 * size, size) * np.array((1, 1, random.uniform(1, 3)))
        center = random.uniform(low, high)
        data = vtkPolyData()
        data.ShallowCopy(template)
        points = vtkPoints()
        points.SetData(
            numpy_to_vtk(vtk_to_numpy(template.GetPoints().GetData()) * scale + center, deep=True)
        )
        data.SetPoints(points)
        color = np.rint(255 * random.uniform((0.2, 0.2, 0.2), (1.0, 0.8, 0.7))) / 255
        made.append((data, tuple(color)))
    return made


def plume(is_mirrored=False, size=PLUME_SIZE):
    """A volume of size^3 voxels that rises and bends; or its mirror image under z = 0."""
    z, y, x = np.meshgrid(*[np.linspace(-1, 1, size)] * 3, indexing="ij")
    height = 0.5 * (z + 1)
    width = 0.12 + 0.45 * height
    away = ((x - 0.6 * height**2 + 0.2) ** 2 + (y - 0.1 * np.sin(6 * height)) ** 2) / width**2
    smoke = (
        200
        * np.exp(-2 * away)
        * (0.75 + 0.25 * np.sin(14 * x + 9 * z) * np.sin(11 * y + 7 * z))
        * (1 - height**4)
    )
    if is_mirrored:
        smoke = smoke[::-1]
    image = vtkImageData()
    image.SetDimensions(size, size, size)
    step = 6.0 / (size - 1)
    image.SetSpacing(step, step, step)
    image.SetOrigin(-3, 0, -6.1 if is_mirrored else 0.1)
    image.GetPointData().SetScalars(numpy_to_vtk(smoke.astype(np.uint8).ravel(), deep=True))
    mapper = vtkGPUVolumeRayCastMapper()
    mapper.SetInputData(image)
    mapper.UseJitteringOff()
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetSampleDistance(0.5 * step)
    color, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
    for value, *rgb in ((0, 0.5, 0.45, 0.4), (200, 0.95, 0.9, 0.85)):
        color.AddRGBPoint(value, *rgb)
    for value, share in ((5, 0), (60, 0.5), (150, 1.0)):
        opacity.AddPoint(value, share)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.GetProperty().SetScalarOpacityUnitDistance(0.5)
    volume.GetProperty().SetColor(color)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().SetInterpolationTypeToLinear()
    return volume

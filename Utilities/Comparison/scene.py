# SPDX-License-Identifier: BSD-3-Clause
"""scene: what every peer draws. Writes terrain.ply and scene.txt, which all of them read.

Metres; x east, y north, z up, z = 0 the water, x = y = 0 the middle of the map. terrain.ply is
binary little-endian: x y z nx ny nz as float, red green blue as uchar, then triangles as uchar 3
and three ints. terrain_dry.ply is the same cut at the water, for a peer without a clipping plane.
A line of scene.txt is a name and its values. Cameras come with every frame, from here as well.
"""

import math
import pathlib
import sys

import numpy as np

PROJECT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "Examples" / "Python"))

import lake  # noqa: E402  its terrain, colours, sun and camera are ours
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402
from vtkmodules.vtkCommonCore import VTK_ID_TYPE, vtkPoints  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPolyData  # noqa: E402
from vtkmodules.vtkFiltersCore import vtkClipPolyData, vtkTriangleFilter  # noqa: E402
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction  # noqa: E402

SIZE = (800, 600)
CLIPPING_RANGE = (0.25 * lake.EYE_HEIGHT, 60000.0)
SKY = (0.62, 0.74, 0.86)  # one colour: every peer has that
AMBIENT, DIFFUSE = 0.25, 1.0
# The water, in fractions of the map: what lies before the eye. No wider, so that an eye can turn
# its back on all of it, and on a sphere around it, which is what scene graphs test.
SHEET = (0.50, 0.86, 0.00, 0.30)
# An eye on a ridge west of the water, looking west.
AWAY_EYE, AWAY_TARGET = (0.35, 0.45), (0.00, 0.35)
SLIDE = 400.0  # metres that the moving eye goes to either side of its place
STEPS = 48  # there and back


class Scene:
    """The terrain as arrays, and the cameras: (eye, target), both in metres."""

    def __init__(self):
        elevation = lake.read_elevation(lake.DEFAULT_FILE)
        lake.REFINEMENT = 1  # one mesh of the model's own points
        image = lake.refine(elevation)
        self._bounds = elevation.GetBounds()
        middle = self._place((0.5, 0.5), lake.EXAGGERATION * lake.DEFAULT_LEVEL)
        width, height, _ = image.GetDimensions()
        heights = vtk_to_numpy(image.GetPointData().GetScalars()).astype(float)
        self._heights = lake.EXAGGERATION * heights.reshape(height, width) - middle[2]
        east, north = np.meshgrid(np.linspace(*self._bounds[0:2], width) - middle[0],
                                  np.linspace(*self._bounds[2:4], height) - middle[1])
        self.points = np.stack([east, north, self._heights], axis=2).reshape(-1, 3)
        arrays = image.GetPointData()
        self.normals = vtk_to_numpy(arrays.GetArray("Normals"))
        self.colors = _colors(vtk_to_numpy(arrays.GetArray("cover")))
        first = (np.arange(height - 1)[:, None] * width + np.arange(width - 1)).reshape(-1, 1)
        self.triangles = (first + np.array([[0, 1, width + 1, 0, width + 1, width]])).reshape(-1, 3)
        self._middle = np.array(middle)

        self.still = self._camera(lake.EYE, lake.TARGET, lake.TARGET_HEIGHT)
        self.away = self._camera(AWAY_EYE, AWAY_TARGET, lake.TARGET_HEIGHT)
        self.path = list(map(self._slid, range(STEPS)))

    def _place(self, fraction, z=0.0):
        xmin, xmax, ymin, ymax = self._bounds[0:4]
        return (xmin + fraction[0] * (xmax - xmin), ymin + fraction[1] * (ymax - ymin), z)

    def _camera(self, eye, target, target_height):
        eye_place = np.array(self._place(eye)) - self._middle
        target_place = np.array(self._place(target)) - self._middle
        row, column = (int(round(fraction * (count - 1)))
                       for fraction, count in zip(eye[::-1], self._heights.shape))
        eye_place[2] = max(0.0, self._heights[row, column]) + lake.EYE_HEIGHT
        target_place[2] = target_height
        return eye_place, target_place

    def _slid(self, step):
        """The eye beside its place; what it looks at stays."""
        eye, target = self.still
        ahead = (target - eye)[:2] / np.linalg.norm((target - eye)[:2])
        aside = SLIDE * math.sin(2 * math.pi * (step + 0.5) / STEPS)
        return eye + aside * np.array([-ahead[1], ahead[0], 0.0]), target

    def write(self, folder):
        _write_ply(folder / "terrain.ply", self.points, self.normals, self.colors, self.triangles)
        _write_ply(folder / "terrain_dry.ply", *self._dry())
        southwest, northeast = self._place(SHEET[0::2]), self._place(SHEET[1::2])
        sheet = [corner[axis] - self._middle[axis]
                 for axis in (0, 1) for corner in (southwest, northeast)]
        sun = lake.make_sun()
        lines = {
            "terrain": [(folder / "terrain.ply").resolve()],
            "terrain_dry": [(folder / "terrain_dry.ply").resolve()],
            "size": SIZE, "view_angle": [lake.VIEW_ANGLE_DEG], "clipping_range": CLIPPING_RANGE,
            "sheet": sheet, "to_sun": sun.GetPosition(), "sun_color": sun.GetDiffuseColor(),
            "sky": SKY, "ambient": [AMBIENT], "diffuse": [DIFFUSE],
        }
        file = folder / "scene.txt"
        file.write_text("".join(
            f"{name} {' '.join(map(str, values))}\n" for name, values in lines.items()))
        return file

    def _dry(self):
        """points, normals, colors and triangles, cut at the water."""
        mesh = vtkPolyData()
        points, cells = vtkPoints(), vtkCellArray()
        points.SetData(numpy_to_vtk(self.points, deep=True))
        cells.SetData(3, numpy_to_vtk(self.triangles.ravel(), deep=True, array_type=VTK_ID_TYPE))
        mesh.SetPoints(points)
        mesh.SetPolys(cells)
        mesh.GetPointData().SetNormals(numpy_to_vtk(self.normals, deep=True))
        mesh.GetPointData().SetScalars(numpy_to_vtk(self.colors, deep=True))
        water = vtkPlane()
        water.SetNormal(0.0, 0.0, 1.0)
        clip = vtkClipPolyData()
        clip.SetClipFunction(water)
        clip.SetInputData(mesh)
        triangles = vtkTriangleFilter()
        triangles.SetInputConnection(clip.GetOutputPort())
        triangles.Update()
        dry = triangles.GetOutput()
        arrays = dry.GetPointData()
        return (vtk_to_numpy(dry.GetPoints().GetData()), vtk_to_numpy(arrays.GetNormals()),
                vtk_to_numpy(arrays.GetScalars()),
                vtk_to_numpy(dry.GetPolys().GetConnectivityArray()).reshape(-1, 3))


def _colors(cover):
    ramp = vtkColorTransferFunction()
    for stop in lake.COLORS:
        ramp.AddRGBPoint(*stop)
    table = np.array([ramp.GetColor(metres) for metres in range(2000)])
    return np.rint(255 * table[np.clip(np.rint(cover).astype(int), 0, 1999)]).astype(np.uint8)


def _write_ply(file, points, normals, colors, triangles):
    vertices = np.empty(len(points), dtype=[("place", "<f4", 6), ("color", "u1", 3)])
    vertices["place"][:, :3], vertices["place"][:, 3:] = points, normals
    vertices["color"] = colors
    faces = np.empty(len(triangles), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, triangles
    properties = [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
    properties += [f"property uchar {name}" for name in ("red", "green", "blue")]
    header = ["ply", "format binary_little_endian 1.0",
              f"element vertex {len(points)}", *properties,
              f"element face {len(triangles)}", "property list uchar int vertex_indices",
              "end_header"]
    file.write_bytes("\n".join([*header, ""]).encode() + vertices.tobytes() + faces.tobytes())

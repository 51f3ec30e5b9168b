# SPDX-License-Identifier: BSD-3-Clause
"""gpu_scenes: what fills a GPU. The water is at z = 0, and covers most of the picture's lower half.

A scene makes its props once; all kinds of frames draw the same ones (gpu_kinds).
"""

from dataclasses import dataclass

import data_tide
import geometry
import gpu_data
import numpy as np
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkGlyph3DMapper, vtkPolyDataMapper, vtkTexture

EYE, TARGET, ANGLE = (2.0, -19.0, 2.6), (0.0, 0.0, 2.0), 32.0
SHEET = (-60, 60, -60, 60)
BED = (0.82, 0.71, 0.55)
NEAR, FAR = 0.25, 150.0
DATA_RANGE = (50.0, 2500.0)  # from the nearest to the farthest of the data, and more
FULL_HD, FULL_4K, QUICK_SIZE = (1920, 1080), (3840, 2160), (320, 180)
TURN = 0.05  # degrees that the camera goes around from frame to frame
TURNS = 60  # frames, then it goes there again
HIDDEN = 0.5  # half the width of the water inside a hill
HIDDEN_SAMPLES = 161  # heights along each side that the hill is looked for in


@dataclass(frozen=True)
class Scene:
    """make(): its props; prepare(renderer): what else a renderer needs for them; tide: of a scene of data."""

    name: str
    text: str
    make: object
    size: tuple = FULL_HD
    prepare: object = lambda renderer: None
    eye: tuple = EYE
    target: tuple = TARGET
    angle: float = ANGLE
    range: tuple = (NEAR, FAR)
    tide: data_tide.Tide = None


def actor_of(data, color=None):
    """Of one colour, or of those of its points."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.SetScalarVisibility(color is None)
    actor = vtkActor()
    actor.SetMapper(mapper)
    if color is not None:
        actor.GetProperty().SetColor(color)
    return actor


def _hills(triangles):
    return actor_of(geometry.big_mesh(triangles))


def _things(count, size):
    return [actor_of(*thing) for thing in geometry.things(count, (-14, -9, -0.3), (14, 26, 3.0), size)]


def _balls(count):
    """Metal and paint, from smooth to rough."""
    random = np.random.default_rng(geometry.SEED)
    ball, made = wt.sphere((0, 0, 0), 0.6, 64), []
    for i in range(count):
        actor = actor_of(ball, tuple(random.uniform(0.3, 1.0, 3)))
        actor.SetPosition(*random.uniform((-9, -8, 0.2), (9, 10, 2.0)))
        look = actor.GetProperty()
        look.SetInterpolationToPBR()
        look.SetMetallic(i % 2)
        look.SetRoughness((i % 5) / 5 + 0.1)
        made.append(actor)
    return made


def _lit_by_image(renderer):
    height, width = 128, 256
    up = np.linspace(-1, 1, height)[:, None, None]
    sky = np.clip(0.5 + up * (0.1, 0.2, 0.5), 0, 1) + 0 * np.zeros((height, width, 3))
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.GetPointData().SetScalars(
        numpy_to_vtk((255 * sky).astype(np.uint8).reshape(-1, 3), deep=True)
    )
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.MipmapOn()
    texture.InterpolateOn()
    renderer.SetEnvironmentTexture(texture)
    renderer.UseImageBasedLightingOn()


def _glyphs(count):
    """One prop of many cones."""
    random = np.random.default_rng(geometry.SEED)
    places = random.uniform((-14, -9, 0.05), (14, 26, 3.0), (count, 3))
    data = vtkPolyData()
    data.SetPoints(vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(places.astype(np.float32), deep=True))
    mapper = vtkGlyph3DMapper()
    mapper.SetInputData(data)
    mapper.SetSourceData(wt.pyramid((0, 0, 0), 0.3, 12, 0.08))
    mapper.ScalingOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.9, 0.5, 0.3)
    return actor


def inside_a_hill():
    """Bounds of a sheet that the ground covers."""
    data = geometry.big_mesh(2 * (HIDDEN_SAMPLES - 1) ** 2)
    points = vtk_to_numpy(data.GetPoints().GetData()).reshape(HIDDEN_SAMPLES, HIDDEN_SAMPLES, 3)
    reach = int(np.ceil(1.2 * HIDDEN / (points[0, 1, 0] - points[0, 0, 0])))
    shifts = range(-reach, reach + 1)
    lowest = np.min([np.roll(points[..., 2], (i, j), (0, 1)) for i in shifts for j in shifts], axis=0)
    x, y, _ = points[np.unravel_index(np.argmax(lowest), lowest.shape)]
    assert lowest.max() > 0.1, "no hill is wide enough"
    return (x - HIDDEN, x + HIDDEN, y - HIDDEN, y + HIDDEN)


def behind_the_eye():
    return (EYE[0] - 5, EYE[0] + 5, EYE[1] - 30, EYE[1] - 20)


def mirrored(actor):
    """The part of a mesh that is over the water, mirrored at it: a user's own reflection."""
    data = actor.GetMapper().GetInput()
    points = vtk_to_numpy(data.GetPoints().GetData()) * np.float32((1, 1, -1))
    triangles = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    triangles = triangles[(points[:, 2] < 0)[triangles].any(axis=1)][:, ::-1]
    normals = vtk_to_numpy(data.GetPointData().GetNormals()) * np.float32((1, 1, -1))
    rgb = vtk_to_numpy(data.GetPointData().GetScalars())
    return actor_of(geometry.mesh(points, triangles, normals, rgb))


def scenes(is_quick):
    """By name, in the order in which they are measured."""
    few = 50 if is_quick else 1
    wide = QUICK_SIZE if is_quick else FULL_HD
    hills, fine = 2_000_000 // few, 18_000_000 // few
    props, many = 1000 // (10 if is_quick else 1), 10_000 // few
    plume = 32 if is_quick else 192
    tide = data_tide.Tide(1_000_000 // few)

    def add(scene):
        found[scene.name] = scene

    found = {}
    add(Scene("2 M", f"hills, one actor of {hills:,} triangles", lambda: [_hills(hills)], wide))
    add(Scene("18 M", f"the same hills, of {fine:,} triangles", lambda: [_hills(fine)],
              QUICK_SIZE if is_quick else FULL_4K))
    add(Scene("1,000 props", f"2 M, and {props:,} boxes, pyramids and balls, an actor each",
              lambda: [_hills(hills), *_things(props, 0.5)], wide))
    add(Scene("10,000 props", f"2 M, and {many:,} smaller ones",
              lambda: [_hills(hills), *_things(many, 0.22)], wide))
    add(Scene("PBR", "2 M, and 60 balls of metal and paint, lit by an image",
              lambda: [_hills(hills), *_balls(60)], wide, _lit_by_image))
    add(Scene("volume", f"2 M, and smoke of {plume}^3 voxels",
              lambda: [_hills(hills), geometry.plume(size=plume)], wide))
    add(Scene("glyphs", f"2 M, and {100_000 // few:,} cones of a vtkGlyph3DMapper",
              lambda: [_hills(hills), _glyphs(100_000 // few)], wide))
    for name, backend in (("data", "Sequential"), ("data, threads", "STDThread")):
        text = "one thread, as in PyPI's VTK" if name == "data" else "VTK's filters use all cores"
        add(Scene(name, f"a tide in a basin of {(tide.side - 1)**2:,} cells, with its bed; {text}",
                  lambda: [actor_of(gpu_data.mesh_of(tide, tide.bed), BED)], wide,
                  lambda _, backend=backend: vtkSMPTools.SetBackend(backend), data_tide.EYE, data_tide.TARGET,
                  data_tide.ANGLE, DATA_RANGE, tide))
    return found

# SPDX-License-Identifier: BSD-3-Clause
"""A mesh of the user's that is not flat reflects by its own slopes, from its own points: against rays that are traced
from the surface's formula to a wall whose colours tell where they meet it."""
import functools

import mesh_scenes as ms
import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkRenderingCore import vtkDataSetMapper

from vtkwater import vtkWaterActor

RENDERERS = pytest.mark.parametrize("is_software", (1, 0), ids=("software", "hardware"))
AMPLITUDE = 0.25
WAVE = np.array((0.7, 0.4))  # rad/m along x and y
WITHIN_PX = 1.0
SHARE_WITHIN = 0.95
BOUNDS = ((-8.0, 11.0), (-14.0, 14.0))  # of the mesh, which ends before the wall
CELLS = 240
COARSE = 24


class Level:
    """The plane of the scenes: z = 0."""
    normal, offset, rotation = np.array((0.0, 0.0, 1.0)), np.zeros(3), np.eye(3)

    @staticmethod
    def move(places):
        return np.asarray(places)

    @staticmethod
    def matrix():
        return ms.matrix_of(np.eye(3), np.zeros(3))


class Eye(ms.Eye):
    def __init__(self, position, focal_point):
        self.side, self.is_parallel, self.scale, self.near_far = 1, False, 1.0, (0.3, 500.0)
        self.position, self.focal_point = np.array(position, float), np.array(focal_point, float)


EYE = Eye((-9, 0, 4), (0, 0, 0.5))


def swell(x, y):
    """Heights, and slopes along x and y."""
    angle = WAVE[0] * x + WAVE[1] * y
    slope = AMPLITUDE * np.cos(angle)
    return AMPLITUDE * np.sin(angle), WAVE[0] * slope, WAVE[1] * slope


def mesh_of(cells=CELLS, normals=None):
    """Triangles over a grid of cells x cells; each cell is cut from its first corner to the opposite one."""
    x, y = np.meshgrid(*(np.linspace(low, high, cells + 1) for low, high in BOUNDS))
    height, along, across = swell(x, y)
    first = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).ravel()
    corners = [first, first + 1, first + cells + 2, first, first + cells + 2, first + cells + 1]
    polygons = vtkCellArray()
    for triangle in np.stack(corners, axis=1).reshape(-1, 3):
        polygons.InsertNextCell(3, triangle.tolist())
    mesh = vtkPolyData()
    mesh.SetPoints(ms.points_made(np.stack([x, y, height], axis=-1).reshape(-1, 3), False))
    mesh.SetPolys(polygons)
    if normals is not None:
        given = np.stack([-along, -across, np.ones_like(along)], axis=-1).reshape(-1, 3) * normals
        mesh.GetPointData().SetNormals(numpy_to_vtk(given / np.linalg.norm(given, axis=1)[:, None], deep=1))
    return mesh


def slopes_of_triangles(x, y, cells):
    """Slopes along x and y of the triangle over a place, and the heights there."""
    (left, right), (front, back) = BOUNDS
    width, depth = (right - left) / cells, (back - front) / cells
    column, row = np.floor((x - left) / width), np.floor((y - front) / depth)
    part = (x - left) / width - column, (y - front) / depth - row

    def corner(i, j):
        return swell(left + (column + i) * width, front + (row + j) * depth)[0]

    is_first = part[0] > part[1]
    along = np.where(is_first, corner(1, 0) - corner(0, 0), corner(1, 1) - corner(0, 1)) / width
    across = np.where(is_first, corner(1, 1) - corner(1, 0), corner(0, 1) - corner(0, 0)) / depth
    return corner(0, 0) + part[0] * width * along + part[1] * depth * across, along, across


@functools.lru_cache(None)
def truth(kind, cells=CELLS):
    """Colours of the wall that pixels show, how much they change from pixel to pixel, and where that is known.

    kind: what rays are reflected by: the "swell", the "triangles" of a mesh of it, or the "plane": a point shows then
    what its mirror image hides from the eye in the mirrored scene.
    """
    def surface(points):
        x, y = points[..., 0], points[..., 1]
        return slopes_of_triangles(x, y, cells) if kind == "triangles" else swell(x, y)

    starts, directions, _ = EYE.rays()
    directions = directions / np.linalg.norm(directions, axis=-1, keepdims=True)
    flat_starts, flat_directions = starts.reshape(-1, 3), directions.reshape(-1, 3)

    def is_under(way, rays):
        points = flat_starts[rays] + way[:, None] * flat_directions[rays]
        return points[:, 2] < surface(points)[0]

    with np.errstate(divide="ignore"):  # over the highest crest there is nothing to meet
        enters = np.where(flat_directions[:, 2] < 0, (AMPLITUDE - flat_starts[:, 2]) / flat_directions[:, 2], np.inf)
    low, high = np.zeros(len(enters)), np.full(len(enters), np.nan)
    left = np.flatnonzero(enters < 36.0)  # the rays that have met nothing yet
    for way in np.arange(4.0, 36.0, 0.1):  # the first place under the surface
        here = left[enters[left] <= way]
        hits = here[is_under(np.full(len(here), way), here)]
        high[hits] = way
        left = left[np.isnan(high[left])]
        low[left] = way
    met = np.flatnonzero(np.isfinite(high))
    for _ in range(34):
        middle = 0.5 * (low[met] + high[met])
        under = is_under(middle, met)
        low[met], high[met] = np.where(under, low[met], middle), np.where(under, middle, high[met])
    points = starts + high.reshape(starts.shape[:2])[..., None] * directions
    _, along, across = surface(points)
    normal = np.stack([-along, -across, np.ones_like(along)], axis=-1)
    normal = normal / np.linalg.norm(normal, axis=-1, keepdims=True)
    rays = directions - 2 * (directions * normal).sum(axis=-1, keepdims=True) * normal
    if kind == "plane":
        rays = points - starts * (1, 1, -1)
    with np.errstate(invalid="ignore", divide="ignore"):
        seen = (points + ((ms.WALL_X - points[..., 0]) / rays[..., 0])[..., None] * rays)[..., 1:]
        part = np.mod(seen, 2)
        colors = 255 * np.where(part < 1, part, 2 - part)
        change = 255 * sum(np.abs(np.gradient(seen, axis=axis)) for axis in (0, 1))
        near_turn = np.minimum(colors, 255 - colors) < 2 * change + 2
        leaves = [points + way * rays / np.linalg.norm(rays, axis=-1, keepdims=True) for way in (0.3, 1.0, 2.0)]
        is_free = np.logical_and.reduce([place[..., 2] > swell(place[..., 0], place[..., 1])[0] for place in leaves])
        is_on_wall = (rays[..., 2] > 0.02) & (rays[..., 0] > 0.2) & (np.abs(seen[..., 0]) < 9) & (
            seen[..., 1] > 0.5) & (seen[..., 1] < 8)
        is_on_mesh = (np.abs(points[..., 1]) < BOUNDS[1][1] - 0.5) & (points[..., 0] < BOUNDS[0][1] - 0.5)
    known = is_free & is_on_wall & is_on_mesh & ~near_turn.any(axis=-1) & np.isfinite(change).all(axis=-1)
    return colors, change, known


def scene_of(mapper, matrix=None):
    scene = ms.Scene(Level, EYE, (), mapper, matrix)
    ms.add_wall(scene.view.renderer, Level)
    return scene


def errors_of(scene, kind, cells=CELLS):
    """How far reflected rays miss what they should meet, pixels."""
    colors, change, known = truth(kind, cells)
    picture, mask = scene.seen()
    return ((np.abs(picture[..., :2] - colors) - 0.5) / change).max(axis=-1)[mask & known]


def check_hits(name, scene, kind, cells=CELLS):
    off = errors_of(scene, kind, cells)
    wt.check_at_least(f"{name}: pixels", len(off), 5000)
    wt.check_at_least(f"{name}: share of hits within {WITHIN_PX:g} px", float((off <= WITHIN_PX).mean()), SHARE_WITHIN)


def moved(mesh):
    """A mesh in coordinates of its own, which a matrix squeezes, mirrors and turns back."""
    transform = vtkTransform()
    transform.RotateZ(40)
    transform.Scale(2.0, -0.5, 3.0)
    inverse = transform.GetInverse()
    places = np.array([inverse.TransformPoint(*place) for place in ms.points_of(mesh)])
    made = ms.with_points(mesh, places, False)
    normals = mesh.GetPointData().GetNormals()
    if normals:
        given = np.array([inverse.TransformNormal(*normals.GetTuple(i)) for i in range(len(places))])
        made.GetPointData().SetNormals(numpy_to_vtk(given, deep=1))
    return made, transform.GetMatrix()


@RENDERERS
@pytest.mark.parametrize("normals", (1.0, -1.0), ids=("up", "down"))
def test_rays_are_reflected_by_normals(normals, is_software, monkeypatch):
    """Of either side of the mesh."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    check_hits("normals", scene_of(ms.mapper_of(mesh_of(normals=normals))), "swell")


@RENDERERS
def test_rays_are_reflected_by_triangles_where_there_are_no_normals(is_software, monkeypatch):
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    check_hits("triangles", scene_of(ms.mapper_of(mesh_of(COARSE))), "triangles", COARSE)


@RENDERERS
def test_a_matrix_moves_places_and_normals(is_software, monkeypatch):
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    mesh, matrix = moved(mesh_of(normals=1.0))
    check_hits("moved normals", scene_of(ms.mapper_of(mesh), matrix), "swell")
    mesh, matrix = moved(mesh_of(COARSE))
    check_hits("moved triangles", scene_of(ms.mapper_of(mesh), matrix), "triangles", COARSE)


def test_a_data_set_mapper_is_as_good():
    mapper = vtkDataSetMapper()
    mapper.SetInputData(mesh_of(normals=1.0))
    check_hits("data set mapper", scene_of(mapper), "swell")


def test_without_its_slopes_a_mesh_shows_what_the_plane_reflects():
    scene = scene_of(ms.mapper_of(mesh_of(normals=1.0)))
    scene.water.MeshSlopesOff()
    check_hits("slopes off", scene, "plane")
    wt.check_at_most("share that shows what the swell reflects", float((errors_of(scene, "swell") <= 1).mean()), 0.2)
    copied = vtkWaterActor()
    copied.ShallowCopy(scene.water)
    wt.check_equal("copied", copied.GetMeshSlopes(), False)


def test_a_flat_mesh_with_odd_normals_is_flat():
    """What lies in its plane is as exact as the own sheet, whatever its normals say."""
    flat = ms.grid(4)
    flat.GetPointData().Initialize()
    own = scene_of(None)
    expected, _ = own.seen()
    flat.GetPointData().SetNormals(numpy_to_vtk(np.tile((0.6, 0.0, 0.8), (25, 1)), deep=1))
    picture, _ = scene_of(ms.mapper_of(flat)).seen()
    wt.check_equal("pixels that differ", int((picture != expected).any(axis=2).sum()), 0)


def test_waves_come_on_top():
    """Fine waves on a swell turn its reflections about those without them."""
    scene = scene_of(ms.mapper_of(mesh_of(normals=1.0)))
    calm, mask = scene.seen()
    scene.water.GetWaterProperty().AddWave(0.004, 0.5, 30.0)
    waved = scene.view.picture()
    wt.check_at_least("share of pixels that waves change", float((calm != waved)[mask].any(axis=1).mean()), 0.5)
    scene.water.GetWaterProperty().RemoveAllWaves()
    scene.water.GetWaterProperty().AddWave(1e-7, 0.5, 30.0)
    off = np.abs(scene.view.picture() - calm)[mask].max(axis=1)
    wt.check_at_most("share that waves of no height change by more than 3 of 255", float((off > 3).mean()), 0.02)


def step_of(places):
    """Heights of water that falls by 1 towards +x, over some units."""
    return 0.5 * np.tanh(-places / 2.0)


def step_mesh():
    mesh = mesh_of(normals=1.0)
    places = ms.points_of(mesh)
    places[:, 2] = step_of(places[:, 0])
    mesh.GetPointData().SetNormals(None)
    made = ms.with_points(mesh, places, False)
    slopes = -0.25 / np.cosh(places[:, 0] / 2.0) ** 2
    normals = np.stack([-slopes, 0.0 * slopes, np.ones_like(slopes)], axis=-1)
    made.GetPointData().SetNormals(numpy_to_vtk(normals / np.linalg.norm(normals, axis=1)[:, None], deep=1))
    return made


@RENDERERS
def test_what_is_under_the_surface_is_not_reflected(is_software, monkeypatch):
    """A slab under high water lies over the lowest point of the mesh, so the mirrored view has it; no ray meets it."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    scene = scene_of(ms.mapper_of(step_mesh()))
    dry, mask = scene.seen()
    wt.check_at_most("blue without the slab", float(dry[mask][:, 2].max()), 120)
    slab = wt.box((-3.0, 0.0, 0.1), (0.3, 10.0, 0.1))
    wt.check_at_least("water over the slab", float(step_of(-2.5) - slab.GetBounds()[5]), 0.1)
    actor = wt.add_actor(scene.view.renderer, slab, (0.0, 0.0, 1.0), lit=False)
    wet, mask = scene.seen()
    wt.check_at_least("pixels", int(mask.sum()), 20000)
    wt.check_equal("pixels that show the slab", int((wet[mask][:, 2] > 120).sum()), 0)
    # where it hides from the mirrored eye what they meet, they show the sky
    changed = mask & (np.abs(wet - dry).max(axis=2) > 8)
    is_sky = (np.abs(wet - 255 * np.array(ms.SKY)) < 8).all(axis=2)
    wt.check_at_most("share of pixels that it changes", float(changed[mask].mean()), 0.1)
    wt.check_at_least("share of these that show the sky", float(is_sky[changed].mean()), 0.8)
    # over the water it is reflected
    actor.SetPosition(0.0, 0.0, 1.0)
    over, mask = scene.seen()
    wt.check_at_least("pixels that show it over the water", int((over[mask][:, 2] > 120).sum()), 1000)


@RENDERERS
def test_a_floor_under_a_splash_hides_nothing(is_software, monkeypatch):
    """A splash in a corner is higher than all of the water is deep; the lowest water is a film on the floor."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    mesh = step_mesh()
    places = ms.points_of(mesh)
    places[(places[:, 0] > 10.0) & (places[:, 1] > 13.0), 2] = 3.0
    mesh = ms.with_points(mesh, places, False)
    scene = scene_of(ms.mapper_of(mesh))
    without, mask = scene.seen()
    lowest = float(mesh.GetBounds()[4])
    wt.add_actor(scene.view.renderer, wt.box((0.0, 0.0, lowest - 0.1), (30.0, 40.0, 0.2)), (0.0, 0.0, 1.0), lit=False)
    wt.check_at_least("pixels", int(mask.sum()), 20000)
    changed = np.abs(scene.view.picture() - without)[mask].max(axis=1) > 8
    wt.check_at_most("share of pixels that the floor changes", float(changed.mean()), 0.01)

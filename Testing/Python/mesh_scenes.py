# SPDX-License-Identifier: BSD-3-Clause
"""mesh_scenes: random scenes whose water is a mesh of the user's, and what they must look like.

A scene has a plane of any direction at any distance from the origin, unlit things in it or a wall behind it, and
an eye on either side. All of it is made about the origin, with z = 0 for the plane, and moved in double precision.
Two truths, neither of which knows anything of the mesh's vertices:

mirrored_picture  of flat meshes: the things' mirror image, seen without any water
WallTruth         of meshes of any height: rays of the eye are cast at the triangles and go on to a wall, whose
                  colours are linear between its points, so that a tenth of a pixel is some of 255
"""

import numpy as np
import ray_caster
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkFiltersCore import vtkDelaunay2D, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

SIZE = (400, 300)
HALF_WIDTH = 20.0
SKY = (0.2, 0.3, 0.4)
VIEW_ANGLE = 30.0
WALL_X = 12.0
WALL_REACH = (60, 40)  # across and up, whole numbers


def matrix_of(linear, offset):
    matrix = vtkMatrix4x4()
    for i in range(3):
        for j in range(3):
            matrix.SetElement(i, j, linear[i][j])
        matrix.SetElement(i, 3, offset[i])
    return matrix


def points_of(mesh):
    return vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)


def points_made(places, is_single):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(places, np.float32 if is_single else np.float64), deep=True))
    return points


def with_points(mesh, places, is_single):
    """A mesh with other points, in single or double precision."""
    made = vtkPolyData()
    made.ShallowCopy(mesh)
    made.SetPoints(points_made(places, is_single))
    return made


def rectangle(corner, first, second, cells):
    source = vtkPlaneSource()
    source.SetOrigin(corner)
    source.SetPoint1(first)
    source.SetPoint2(second)
    source.SetResolution(*cells)
    source.SetOutputPointsPrecision(1)
    source.Update()
    return source.GetOutput()


def grid(cells, half_width=HALF_WIDTH):
    """A plane source with cells x cells quads."""
    return rectangle((-half_width, -half_width, 0), (half_width, -half_width, 0), (-half_width, half_width, 0),
                     (cells, cells))


def irregular(generator, count, half_width=HALF_WIDTH):
    """Triangles between random places, and the corners of the same square."""
    places = np.zeros((count + 4, 3))
    places[:, :2] = generator.uniform(-half_width, half_width, (count + 4, 2))
    places[:4, :2] = np.array(((-1, -1), (1, -1), (1, 1), (-1, 1))) * half_width
    cloud = vtkPolyData()
    cloud.SetPoints(points_made(places, False))
    triangles = vtkDelaunay2D()
    triangles.SetInputData(cloud)
    triangles.Update()
    return triangles.GetOutput()


def things(generator):
    """Boxes, pyramids and balls of any size, across z = 0 and on both sides of it.

    None ends or begins within 0.02 of it, where VTK's depths, and far from the origin its clips, cannot tell sides.
    """
    made = []
    while len(made) < 14:
        center = (*generator.uniform(-5, 5, 2), generator.uniform(-1.5, 1.5))
        size = generator.uniform(0.3, 1.3)
        kind = generator.integers(3)
        color = tuple(generator.integers(0, 256, 3) / 255)
        if kind == 0:
            data = wt.box(center, size * generator.uniform(0.5, 1.6, 3))
        elif kind == 1:
            data = wt.pyramid(center, 2 * size, int(generator.integers(3, 9)), size)
        else:
            data = wt.sphere(center, 0.7 * size)
        if min(np.abs(data.GetBounds()[4:])) > 0.02:
            made.append((data, color))
    return made


class Place:
    """Where a scene is: its plane, and what takes points from about the origin there."""

    def __init__(self, generator, distance):
        turn, tilt = generator.uniform(0, 2 * np.pi), generator.uniform(0, 0.5)
        level = generator.random() < 0.3
        self.normal = wt.unit((0, 0, 1) if level else (tilt * np.cos(turn), tilt * np.sin(turn), 1))
        self.offset = wt.unit(generator.normal(size=3)) * distance
        x = np.eye(3)[0] if level else wt.unit(np.cross((0.3, 1, 0.2), self.normal))
        self.rotation = np.stack([x, np.cross(self.normal, x), self.normal], axis=1)

    def move(self, places):
        return np.asarray(places) @ self.rotation.T + self.offset

    def matrix(self, linear=np.eye(3)):
        return matrix_of(self.rotation @ linear, self.offset)


class Eye:
    """A camera about the origin, on one side of z = 0, and its lens."""

    def __init__(self, generator, position, focal_point):
        self.side = 1 if generator.random() < 0.7 else -1
        self.position = np.array(position) * (1, 1, self.side)
        self.focal_point = np.array(focal_point, float)
        self.is_parallel = generator.random() < 0.25
        self.scale = generator.uniform(2, 4)
        # a far plane far off makes depths coarse
        self.near_far = (generator.choice((0.05, 0.3, 1.0)), generator.choice((80.0, 500.0, 5000.0)))

    def look(self, renderer, place):
        camera = wt.place_camera(renderer, place.move(self.position), place.move(self.focal_point), self.near_far,
                                 place.normal)
        camera.SetParallelProjection(self.is_parallel)
        camera.SetParallelScale(self.scale)
        camera.SetViewAngle(VIEW_ANGLE)

    def rays(self):
        """Starts and directions of all pixels' rays, and what takes points to NDC."""
        forward = wt.unit(self.focal_point - self.position)
        right = wt.unit(np.cross(forward, (0, 0, 1)))
        up = np.cross(right, forward)
        half = self.scale if self.is_parallel else np.tan(np.radians(0.5 * VIEW_ANGLE))
        wide = half * SIZE[0] / SIZE[1]
        x, y = np.meshgrid(*[((np.arange(size) + 0.5) / size * 2 - 1) for size in SIZE])
        beside = wide * x[..., None] * right + half * y[..., None] * up
        starts = self.position + (beside if self.is_parallel else 0 * beside)
        directions = forward + (0 * beside if self.is_parallel else beside)

        def to_ndc(points):
            arm = points - self.position
            depth = 1.0 if self.is_parallel else arm @ forward
            return arm @ right / depth / wide, arm @ up / depth / half

        return starts, directions, to_ndc


class Scene:
    """A view of things in water: of its own sheet, or of a mesh that is given with a mapper, and a matrix."""

    def __init__(self, place, eye, contents=(), mapper=None, matrix=None, half_width=HALF_WIDTH):
        self.view = wt.View(SIZE, SKY)
        for data, color in contents:
            wt.add_actor(self.view.renderer, wt.transformed(data, place.matrix()), color, lit=False)
        self.water = wt.add_water(self.view.renderer, wt.plane(place.offset, place.normal),
                                  (-half_width, half_width, -half_width, half_width))
        if mapper is not None:
            self.water.SetMapper(mapper)
        if matrix is not None:
            self.water.SetUserMatrix(matrix)
        eye.look(self.view.renderer, place)

    def seen(self):
        """The picture, and which of its pixels are water."""
        return self.view.picture(), wt.water_mask(self.view, self.water)


def mapper_of(mesh, mode=None):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    if mode is not None:
        mapper.SetVBOShiftScaleMethod(mode)
    return mapper


def mirrored_picture(place, eye, contents):
    """The mirror image of things, seen by the eye without any water."""
    view = wt.View(SIZE, SKY)
    for data, color in contents:
        image = wt.mirror_image(data, (0, 0, 0), (0, 0, eye.side))
        wt.add_actor(view.renderer, wt.transformed(image, place.matrix()), color, lit=False)
    eye.look(view.renderer, place)
    return view.picture()


def add_wall(renderer, place):
    """A wall x = WALL_X: red goes up and down from metre to metre across it, green along it."""
    across, up = WALL_REACH
    source = vtkTriangleFilter()
    source.SetInputData(rectangle((WALL_X, -across, -up), (WALL_X, across, -up), (WALL_X, -across, up),
                                  (2 * across, 2 * up)))
    source.Update()
    wall = source.GetOutput()
    steps = np.rint(points_of(wall)[:, 1:]).astype(int)
    colors = np.zeros((len(steps), 3), np.uint8)
    colors[:, :2] = steps % 2 * 255
    wall.GetPointData().SetScalars(numpy_to_vtk(colors, deep=True))
    actor = vtkActor()
    actor.SetMapper(mapper_of(wt.transformed(wall, place.matrix())))
    actor.GetProperty().LightingOff()
    renderer.AddActor(actor)


def cast(starts, directions, triangles):
    """Where rays meet the first of some triangles, which no two of cover each other seen along z; NaN: nowhere."""
    first = ray_caster.in_blocks(lambda *rays: _first(*rays, triangles), starts.reshape(-1, 3), directions.reshape(-1, 3))
    first = first.reshape(starts.shape[:2])
    return starts + np.where(np.isfinite(first), first, np.nan)[..., None] * directions


def _first(start, direction, triangles):
    """How far along rays the first triangle is; inf: they meet none."""
    first = np.full(len(start), np.inf)
    for a, b, c in triangles:
        normal = np.cross(b - a, c - a)
        way = ((a - start) @ normal) / (direction @ normal)
        x, y = (start[:, axis] + way * direction[:, axis] for axis in (0, 1))
        is_inside = way > 0
        for p, q in ((a, b), (b, c), (c, a)):
            edge = (q - p)[0] * (y - p[1]) - (q - p)[1] * (x - p[0])
            is_inside &= edge * np.sign(normal[2]) >= -1e-9
        first = np.where(is_inside & (way < first), way, first)
    return first


class WallTruth:
    """What a mesh of triangles about z = 0 shows of the wall, to an eye.

    A point of the surface shows what the plane reflects there: what its mirror image hides from the eye in the
    mirrored scene.
    """

    def __init__(self, eye, mesh, places):
        corners = places[vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
        starts, directions, to_ndc = eye.rays()
        flip = np.array((1, 1, -1))
        with np.errstate(invalid="ignore", divide="ignore"):
            points = cast(starts, directions, corners)
            if eye.is_parallel:
                below, rays = points, directions * flip
            else:
                below, rays = starts * flip, points - starts * flip
            way = (WALL_X - below[..., 0]) / rays[..., 0]
            seen = (below + way[..., None] * rays)[..., 1:]
            part = np.mod(seen, 2)
            self.colors = 255 * np.where(part < 1, part, 2 - part)
            # where a colour turns, and beyond the texture's edges, filtering shows more than the point itself
            change = 255 * sum(np.abs(np.gradient(seen, axis=axis)) for axis in (0, 1))
            near_turn = np.minimum(self.colors, 255 - self.colors) < 1.5 * change + 2
            is_on_wall = (way > 0) & (np.abs(seen[..., 0]) < WALL_REACH[0] - 2) & (
                seen[..., 1] * eye.side > 0.2) & (seen[..., 1] * eye.side < WALL_REACH[1] - 2)
            is_in_picture = np.logical_and.reduce([np.abs(ndc) < 0.97 for ndc in to_ndc(points * flip)])
            self.is_known = is_on_wall & is_in_picture & ~near_turn.any(axis=-1) & np.isfinite(change).all(axis=-1)
            self.change = change.max(axis=-1)

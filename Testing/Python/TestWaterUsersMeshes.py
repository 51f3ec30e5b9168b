# SPDX-License-Identifier: BSD-3-Clause
"""A mesh of the user's is as exact as the own sheet: in the plane, near it and of any height, from the origin to
1e6 from it, in floats and doubles, through a matrix or not, however VTK shifts its coordinates.

The environment may ask for other scenes: WATER_MESHES_SEED, a number; and for more: WATER_MESHES_SCENES.
"""

import os

import mesh_scenes as ms
import numpy as np
import pytest
import water_test as wt
from vtkmodules.vtkRenderingCore import vtkDataSetMapper

SEED = int(os.environ.get("WATER_MESHES_SEED", 1))
SCENES = int(os.environ.get("WATER_MESHES_SCENES", 1))
LIMIT_PERCENT = 0.02
NEAR_FAR = (0.05, 80)  # depths between them are exact enough
KNOWN = 1e3  # up to there floats tell heights to 6e-5; farther off a height of 1e-3 may be their rounding
DISTANCES = (0, 1e3, 1e5, 1e6)
RENDERERS = pytest.mark.parametrize("is_software", (1, 0), ids=("software", "hardware"))
AT = pytest.mark.parametrize("distance", DISTANCES, ids="{:g}".format)


def generator_of(*numbers):
    return np.random.default_rng([SEED, *(int(number) for number in numbers)])


def turned(generator):
    """A rotation about z."""
    angle = generator.uniform(0, 2 * np.pi)
    cos, sin = np.cos(angle), np.sin(angle)
    return np.array([[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]])


def mode_of(generator, distance, most):
    """How VTK shifts and scales: as it does by itself, or, up to a distance, not."""
    return 0 if distance <= most and generator.random() < 0.5 else None


def mapped(generator, place, mesh, places, is_single, has_matrix):
    """A mesh at places about the origin: in world, or in coordinates of its own and the matrix for them."""
    if not has_matrix:
        return ms.with_points(mesh, place.move(places), is_single), None
    linear = turned(generator) @ np.diag(generator.uniform(0.1, 3, 3))
    return ms.with_points(mesh, places @ np.linalg.inv(linear).T, is_single), place.matrix(linear)


class Tally:
    """Pixels of water of several scenes, and how many of them are off; the worst scene is printed."""

    def __init__(self):
        self.off = self.pixels = 0
        self.worst = (0.0, "none")

    def add(self, name, errors):
        off = int((errors > 1).sum())
        self.off += off
        self.pixels += len(errors)
        self.worst = max(self.worst, (100 * off / max(1, len(errors)), f"{name}: {off} of {len(errors)} pixels"))

    def check(self, name, least):
        print(f"{name}, worst:", self.worst)
        wt.check_at_least(f"{name}: pixels of water", self.pixels, least)
        wt.check_at_most(f"{name}: % of water pixels off by more than 1/255", 100 * self.off / max(1, self.pixels),
                         LIMIT_PERCENT)


def flat_scenes(number, distance):
    """Meshes in the plane of one scene, each with a name; and what they must look like."""
    generator = generator_of(number, distance)
    place = ms.Place(generator, distance)
    turn, way = generator.uniform(0, 2 * np.pi), generator.uniform(7, 14)
    eye = ms.Eye(generator, (way * np.cos(turn), way * np.sin(turn), generator.uniform(1.5, 7)),
                 (*generator.uniform(-1, 1, 2), generator.uniform(-0.3, 0.3)))
    contents = ms.things(generator)
    width = generator.choice((15.0, 50.0, 500.0))
    meshes = {"grid": ms.grid(int(generator.integers(2, 120)), width),
              "irregular": ms.irregular(generator, int(generator.integers(2, 600)), width)}

    def scenes():
        for name, is_single, has_matrix in (("grid", False, False), ("grid", True, True),
                                            ("irregular", False, True), ("irregular", True, False)):
            mesh = meshes[name]
            data, matrix = mapped(generator, place, mesh, ms.points_of(mesh), is_single, has_matrix)
            full = f"{name}, {'floats' if is_single else 'doubles'}{', matrix' if has_matrix else ''}"
            yield full, ms.Scene(place, eye, contents, ms.mapper_of(data, mode_of(generator, distance, 1e4)), matrix)
        # the own sheet, which the actor turns and moves in its plane
        turning = place.rotation @ turned(generator) @ place.rotation.T
        moving = place.offset + place.rotation @ (1, 2, 0) - turning @ place.offset
        yield "own sheet, matrix", ms.Scene(place, eye, contents, None, ms.matrix_of(turning, moving), width)

    return ms.mirrored_picture(place, eye, contents), scenes()


@RENDERERS
@AT
def test_meshes_in_the_plane_show_the_mirrored_scene(distance, is_software, monkeypatch):
    """Calm water of any flat mesh in its plane shows exactly the mirrored scene."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    tally = Tally()
    for number in range(SCENES):
        truth, scenes = flat_scenes(number, distance)
        for name, scene in scenes:
            picture, mask = scene.seen()
            tally.add(f"scene {number}, {name}", np.abs(picture - truth).max(axis=2)[mask])
    tally.check(f"in the plane, {distance:g} from the origin", 50000 * SCENES)


HEIGHTS = {
    "off the plane": lambda generator, count: generator.choice((-1, 1)) * generator.uniform(0.05, 0.3),
    "hardly off it": lambda generator, count: generator.choice((-1, 1)) * 10 ** generator.uniform(-6, -2),
    "rough": lambda generator, count: generator.uniform(-0.3, 0.3, count),
    "hardly rough": lambda generator, count: generator.uniform(-1, 1, count) * 10 ** generator.uniform(-6, -2),
}


def high_scene(generator, distance, heights, is_single, has_matrix, make_mapper=None):
    """A scene of a wall and a mesh of some heights, and what it must look like."""
    place = ms.Place(generator, distance)
    eye = ms.Eye(generator, (-9, 0, generator.uniform(2, 6)), (0, 0, 0.5))
    mesh = ms.irregular(generator, int(generator.integers(5, 60)))
    places = ms.points_of(mesh)
    places[:, 2] = heights(generator, len(places))
    data, matrix = mapped(generator, place, mesh, places, is_single, has_matrix)
    mapper = make_mapper(data) if make_mapper else ms.mapper_of(data, mode_of(generator, distance, KNOWN))
    scene = ms.Scene(place, eye, (), mapper, matrix)
    scene.water.MeshSlopesOff()  # TestWaterMeshSlopes has them
    ms.add_wall(scene.view.renderer, place)
    return scene, ms.WallTruth(eye, mesh, places)


def errors_of_wall(scene, truth, shift_px=0.0):
    """Of 255, of all pixels of water whose truth is known, less a shift; a picture's numbers are rounded."""
    picture, mask = scene.seen()
    errors = np.abs(picture[..., :2] - truth.colors).max(axis=-1) - 0.5 - shift_px * truth.change
    return errors[mask & truth.is_known]


@RENDERERS
@AT
@pytest.mark.parametrize("kind", HEIGHTS, ids=lambda kind: kind.replace(" ", "_"))
def test_meshes_of_any_height_show_what_the_plane_reflects(kind, distance, is_software, monkeypatch):
    """Each point of a mesh near the plane shows what the plane reflects there."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", str(is_software))
    tally = Tally()
    for number in range(SCENES):
        generator = generator_of(number, distance, list(HEIGHTS).index(kind))
        is_single = distance <= KNOWN and generator.random() < 0.5
        has_matrix = generator.random() < 0.5
        scene, truth = high_scene(generator, distance, HEIGHTS[kind], is_single, has_matrix)
        tally.add(f"scene {number}", errors_of_wall(scene, truth))
    tally.check(f"{kind}, {distance:g} from the origin", 5000 * SCENES)


def rough_scene(*numbers, distance=0, heights="rough", make_mapper=None):
    generator = generator_of(*numbers)
    return high_scene(generator, distance, HEIGHTS[heights], False, False, make_mapper)


def check_wall(name, scene, truth):
    tally = Tally()
    tally.add(name, errors_of_wall(scene, truth))
    tally.check(name, 3000)


def test_a_data_set_mapper_is_as_good():
    """A mesh that a vtkDataSetMapper draws, whose coordinates VTK shifts, knows its heights."""
    def make_mapper(mesh):
        mapper = vtkDataSetMapper()
        mapper.SetInputData(mesh)
        return mapper

    for distance in (0, 1e5):
        for heights in HEIGHTS:
            check_wall(f"data set mapper, {heights}, {distance:g}",
                       *rough_scene(7, distance, distance=distance, heights=heights, make_mapper=make_mapper))


def test_a_mesh_that_changes_is_measured_again():
    """Points that move, and a matrix that does, change what the next frame shows."""
    generator = generator_of(11)
    place = ms.Place(generator, 0)
    eye = ms.Eye(generator, (-9, 0, 4), (0, 0, 0.5))
    mesh = ms.irregular(generator, 20)
    data = ms.with_points(mesh, place.move(ms.points_of(mesh)), False)
    scene = ms.Scene(place, eye, (), ms.mapper_of(data))
    scene.water.MeshSlopesOff()
    ms.add_wall(scene.view.renderer, place)
    places = ms.points_of(mesh)
    check_wall("flat", scene, ms.WallTruth(eye, mesh, places))
    places[:, 2] = HEIGHTS["rough"](generator, len(places))
    data.SetPoints(ms.points_made(place.move(places), False))
    check_wall("points moved", scene, ms.WallTruth(eye, mesh, places))
    lifted = places + (0, 0, 0.1)
    scene.water.SetPosition(*(0.1 * place.normal))
    check_wall("actor moved", scene, ms.WallTruth(eye, mesh, lifted))
    scene.water.SetPosition(0, 0, 0)
    data.SetPoints(ms.points_made(place.move(ms.points_of(mesh)), False))
    check_wall("flat again", scene, ms.WallTruth(eye, mesh, ms.points_of(mesh)))


def test_vertices_that_the_users_shader_moves_are_where_it_puts_them():
    """Where the user's vertex shader lifts the mesh, nobody takes it for flat, or the data's heights for its own."""
    scene, truth = rough_scene(13, heights="off the plane")
    generator = generator_of(13)
    place = ms.Place(generator, 0)
    ms.Eye(generator, (-9, 0, generator.uniform(2, 6)), (0, 0, 0.5))
    mesh = ms.irregular(generator, int(generator.integers(5, 60)))
    height = float(HEIGHTS["off the plane"](generator, mesh.GetNumberOfPoints()))
    scene.water.SetMapper(ms.mapper_of(ms.with_points(mesh, place.move(ms.points_of(mesh)), False)))
    lift = ", ".join(repr(float(part)) for part in height * place.normal)
    tag = "//VTK::PositionVC::Impl"
    scene.water.GetShaderProperty().AddVertexShaderReplacement(
        tag, True, f"{tag}\n  gl_Position = MCDCMatrix * (vertexMC + vec4({lift}, 0.0));", False)
    scene.view.renderer.GetActiveCamera().SetClippingRange(NEAR_FAR)
    check_wall(f"lifted by {height:.2f}", scene, truth)


def test_a_mesh_with_visible_edges_is_looked_up_by_its_depths():
    """Where VTK's shader for visible edges has no room for heights, depths tell them, and reflections are right to
    half a pixel: VTK 9.1 offsets the depths of polygons that have visible edges."""
    scene, truth = rough_scene(17)
    scene.view.renderer.GetActiveCamera().SetClippingRange(NEAR_FAR)
    scene.water.GetProperty().EdgeVisibilityOn()
    tally = Tally()
    tally.add("edges", errors_of_wall(scene, truth, 0.5))
    tally.check("with visible edges", 3000)

# SPDX-License-Identifier: BSD-3-Clause
"""Calm water of reflectance 1 shows exactly the explicitly mirrored scene.

For each case VTK renders the scene with the water, and the mirror image of the scene (data cut at the
plane and mirrored, the light mirrored with it) through the same camera without any water. The water's
pixels of the two must be the same: at most 0.02 % differ by more than 1/255.
"""

import math
import os
import pathlib
import random

import numpy as np
import pytest
import water_test as wt
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkTriangleFilter
from vtkmodules.vtkFiltersGeometry import vtkImageDataGeometryFilter
from vtkmodules.vtkFiltersGeneral import vtkWarpScalar
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

LIMIT_PERCENT = 0.02
SUN = (0.4, -0.5, 0.8)
UNLIT, SCENE_LIGHT, HEADLIGHT = "unlit", "scene light", "headlight"


def add_lights(view, light, origin, normal, mirrored):
    camera = view.renderer.GetActiveCamera()
    if light == SCENE_LIGHT:
        direction = wt.mirror_point(SUN, (0, 0, 0), normal) if mirrored else SUN
        wt.add_scene_light(view.renderer, direction)
    elif light == HEADLIGHT and mirrored:
        # the headlight is at the user's camera, so its mirror image is at the mirrored one
        wt.add_scene_light(
            view.renderer,
            wt.mirror_point(camera.GetPosition(), origin, normal),
            wt.mirror_point(camera.GetFocalPoint(), origin, normal),
        )


def compare(things, origin, normal, set_camera, size, light, sheet, specular=0.0):
    """Returns the numbers of differing and of all water pixels, and both pictures."""
    lit = light != UNLIT
    view = wt.View(size)
    for data, color in things:
        wt.add_actor(view.renderer, data, color, lit, specular)
    water = wt.add_water(view.renderer, wt.plane(origin, normal), sheet)
    set_camera(view.renderer.GetActiveCamera())
    add_lights(view, light, origin, normal, mirrored=False)
    seen = view.picture()
    assert water.GetReflectionPass().GetDecisionAsString() == "rendered", water.GetLastError()
    mask = wt.water_mask(view, water)

    mirror = wt.View(size)
    set_camera(mirror.renderer.GetActiveCamera())
    add_lights(mirror, light, origin, normal, mirrored=True)
    if not wt.is_above(mirror.renderer.GetActiveCamera(), origin, normal):
        normal = tuple(-np.asarray(normal))
    for data, color in things:
        wt.add_actor(
            mirror.renderer, wt.mirror_image(data, origin, normal), color, lit, specular
        )
    expected = mirror.picture()
    differs = (np.abs(seen - expected).max(axis=2) > 1) & mask
    return differs.sum(), mask.sum(), seen, expected


def look(position, focal_point, clipping_range, up=(0, 0, 1)):
    def set_camera(camera):
        camera.SetPosition(position)
        camera.SetFocalPoint(focal_point)
        camera.SetViewUp(up)
        camera.SetClippingRange(clipping_range)

    return set_camera


def terrain():
    """The lake's terrain in the colours of its height, thinned for the test."""
    path = pathlib.Path(__file__).resolve().parents[2] / "Examples" / "Data" / "jacksboro.vti"
    reader = vtkXMLImageDataReader()
    reader.SetFileName(str(path))
    geometry = vtkImageDataGeometryFilter()
    geometry.SetInputConnection(reader.GetOutputPort())
    warp = vtkWarpScalar()
    warp.SetInputConnection(geometry.GetOutputPort())
    warp.SetUseNormal(True)
    warp.SetNormal(0, 0, 1)
    triangles = vtkTriangleFilter()  # clip and draw split a bent quad along different diagonals
    triangles.SetInputConnection(warp.GetOutputPort())
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(triangles.GetOutputPort())
    normals.SplittingOff()
    normals.SetOutputPointsPrecision(1)
    normals.Update()
    return normals.GetOutput()


def report(name, result):
    differing, total, seen, expected = result
    percent = 100.0 * differing / max(1, total)
    wt.check_at_least(f"{name}: water pixels", int(total), 3000)
    wt.check_at_most(f"{name}: % of water pixels off by more than 1/255", percent, LIMIT_PERCENT)
    if percent > LIMIT_PERCENT:
        stem = name.replace(" ", "_").replace(",", "")
        wt.save(seen, wt.output_folder() / f"{stem}_water.png")
        wt.save(expected, wt.output_folder() / f"{stem}_mirrored.png")


LIGHTS = pytest.mark.parametrize("light", (UNLIT, SCENE_LIGHT, HEADLIGHT), ids=("unlit", "scene_light", "headlight"))


def specular_of(light):
    return 0 if light == UNLIT else 0.4


@LIGHTS
def test_columns_and_pyramids(light):
    """Calm water shows the mirrored scene of things with hard edges that stand in it."""
    report(
        f"columns and pyramids, {light}",
        compare(
            wt.columns_and_pyramids(), (0, 0, 0), (0, 0, 1),
            look((2, -14, 4), (0, 0, 0), (1, 60)), (640, 480), light, (-20, 20, -20, 20), specular_of(light),
        ),
    )


@LIGHTS
def test_a_tilted_plane_through_curved_things(light):
    """Calm water in a tilted plane shows the mirrored scene of curved things that stand in it."""
    report(
        f"tilted plane through curved things, {light}",
        compare(
            wt.curved_things(), (0, 0, 0.1), tuple(wt.unit((0.2, 0.3, 1))),
            look((2, -9, 4), (0, 0, 0), (1, 60)), (640, 480), light, (-8, 8, -8, 8), specular_of(light),
        ),
    )


@LIGHTS
def test_real_terrain(light):
    """A lake in real terrain shows the mirrored terrain."""
    ground = terrain()
    bounds = ground.GetBounds()
    center = [0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3])]
    level = bounds[4] + 0.25 * (bounds[5] - bounds[4])
    span = bounds[1] - bounds[0]
    report(
        f"real terrain, {light}",
        compare(
            [(ground, (0.5, 0.6, 0.4))], (0, 0, level), (0, 0, 1),
            look(
                (center[0], bounds[2] - 0.3 * span, level + 0.15 * span),
                (center[0], center[1], level),
                (0.02 * span, 3 * span),
            ),
            (640, 480), light, (bounds[0], bounds[1], bounds[2], bounds[3]),
        ),
    )


@LIGHTS
def test_a_grazing_view_of_tall_poles(light):
    """Seen at 2 degrees, calm water shows the mirrored scene of tall poles."""
    grazing = math.radians(2)
    report(
        f"grazing view at 2 degrees with tall poles, {light}",
        compare(
            wt.tall_poles(), (0, 0, 0), (0, 0, 1),
            look((0, -25 * math.cos(grazing), 25 * math.sin(grazing)), (0, 0, 0), (1, 90)),
            (640, 480), light, (-25, 25, -15, 25), specular_of(light),
        ),
    )


def test_random_planes_and_cameras():
    """From random cameras, water in random planes shows the mirrored scene."""
    count, seed = 30 if os.environ.get("WATER_TESTS_ONCE") == "0" else 100, 20240607  # another VTK has all
    generator = random.Random(seed)
    print(f"random planes and cameras: {count}, seed {seed}")
    differing = total = 0
    worst = (0.0, "none")
    for number in range(count):
        normal = tuple(wt.unit([generator.gauss(0, 1) for _ in range(3)]))
        origin = tuple(generator.uniform(-0.5, 0.5) for _ in range(3))
        direction = wt.unit([generator.gauss(0, 1) for _ in range(3)])
        is_parallel = generator.random() < 0.3
        is_off_axis = generator.random() < 0.4
        window_center = [generator.uniform(-0.5, 0.5) if is_off_axis else 0.0 for _ in range(2)]
        roll = generator.uniform(0, 360)

        def set_camera(camera):
            camera.SetPosition(9 * direction)
            camera.SetFocalPoint(0, 0, 0)
            camera.SetViewUp(0.1, 0.2, 1)
            camera.SetRoll(roll)
            camera.SetClippingRange(0.5, 60)
            camera.SetWindowCenter(*window_center)
            camera.SetParallelProjection(is_parallel)
            camera.SetParallelScale(4)

        light = (UNLIT, SCENE_LIGHT, HEADLIGHT)[number % 3]
        if is_parallel and light == HEADLIGHT:
            light = SCENE_LIGHT
        off, water, _, _ = compare(
            wt.curved_things(), origin, normal, set_camera, (200, 150), light, (-6, 6, -6, 6)
        )
        differing += off
        total += water
        if water and 100.0 * off / water > worst[0]:
            worst = (100.0 * off / water, f"view {number}: {off} of {water} pixels")
    print("random views, worst:", worst)
    wt.check_at_least("random views: water pixels", int(total), 100 * count)
    wt.check_at_most(
        "random views: % of water pixels off by more than 1/255",
        100.0 * differing / total,
        LIMIT_PERCENT,
    )

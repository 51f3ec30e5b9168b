# SPDX-License-Identifier: BSD-3-Clause
"""draws: props that the water cannot show: what they cost, and how many of them are left out."""

import os

import geometry
import instruments
import numpy as np
import ray_caster
import scenes
import water_test as wt
from instruments import text
from ratios import compare, terrain
from report import table
from TestWaterLarge import mapper_of_blocks
from timing import Frame
from tracer import Tracer
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkInformation
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSetCollection
from vtkmodules.vtkRenderingCore import vtkActor
from vtkwater import vtkWaterReflectionPass

COUNT = 1000
LIMIT = 80  # % of what could be left out
POND = (33.6, 35.6, 12.6, 14.6)  # small, in the middle of the terrain's lake
TILES = 32  # each way: blocks of composite data
LEFT_OUT, ALL_DRAWN = "blocks left out", "all blocks drawn"
BESIDE = (17, -5, 0.3), (22, -1, 5)  # between the sides of the view and of what the pond mirrors

TEXT = """
$count props that water cannot show, under its plane or outside the mirrored view, compared with the same props with
NOT_REFLECTED on each.

$tables

The terrain in $blocks blocks of composite data, which one mapper draws. Blocks that the water cannot show are left out of
the mirrored view (decision 009).

$composite

Work left out, compared with drawing everything (SKIP_NONE). A prop is needed if one of its points above the plane has its
mirror image on a pixel of water. Of the fragments, one is needed for each pixel of water that reflects something. This
is a lower bound: to reach it, all fragments would have to be drawn front to back, which drawing prop by prop cannot do.
Share: how much of the unneeded work is left out. On the water: how many fragments of the same frames are drawn on
pixels of visible water by the rules for GPUs, with a mask of these pixels. They can be more than those in the column "drawn", which is counted by the rules for software.
The last column has the share of the other fragments that is left out.

$shares
"""


def _under():
    scene = terrain()
    scene.water.SetLevel(0)
    return scene, scene.add_things(COUNT, (0, -10, -6), (30, 20, -2), 0.5)


def _beside():
    scene = terrain()
    scene.water.SetSheetBounds(*POND)
    return scene, scene.add_things(COUNT, *BESIDE, 0.4)


def _in_blocks(scene):
    data = vtkPartitionedDataSetCollection()
    for number, tile in enumerate(geometry.terrain(scenes.LEVEL, TILES)):
        data.SetPartition(number, 0, tile)
    mapper = mapper_of_blocks()
    mapper.SetInputDataObject(data)
    actor = vtkActor()
    actor.SetMapper(mapper)
    scene.renderer.AddActor(actor)


def _composite(results):
    plain, ours, whole = (terrain(has_water, fill=_in_blocks) for has_water in (False, True, True))
    whole.water.GetReflectionPass().SetSkips(
        vtkWaterReflectionPass.SKIP_ALL & ~vtkWaterReflectionPass.PIECES
    )
    for scene in (ours, whole):
        scene.stand(1)
    apart = int((ours.view.picture() != whole.view.picture()).any(axis=2).sum())
    results.check_at_most("composite data: pixels that change", apart, 0, 0)
    frames = [
        Frame(name, scene.window, scene.step)
        for name, scene in (("no water", plain), (LEFT_OUT, ours), (ALL_DRAWN, whole))
    ]
    return compare(results, "composite data", frames, ((LEFT_OUT, ALL_DRAWN, 1.0),))


def _compare(results, title, make):
    (ours, _), (by_hand, props) = make(), make()
    for prop in props:
        prop.SetPropertyKeys(_marked())
    frames = [
        Frame(name, scene.window, scene.step)
        for name, scene in (("NOT_REFLECTED by hand", by_hand), ("as they are", ours))
    ]
    return compare(results, title, frames, (("as they are", "NOT_REFLECTED by hand", 1.05),))


def _marked():
    keys = vtkInformation()
    keys.Set(vtkWaterReflectionPass.NOT_REFLECTED(), 1)
    return keys


def _five_scenes():
    kinds = scenes.kinds(True)
    yield "terrain in 16 tiles", terrain(fill=scenes.make_terrain(tiles=4))
    yield "1,000 props", scenes.Scene(kinds["1,000 props"], (800, 600))
    yield "1,000 props under the plane", _under()[0]
    yield "1,000 props outside the mirrored view", _beside()[0]
    pond = scenes.Scene(kinds["1,000 props"], (800, 600))
    pond.water.SetSheetBounds(-2, 2, -9, -6)
    yield "a pond among 1,000 props", pond


def _needed(scene):
    """How many props, and at least how many fragments, the water needs."""
    mask = wt.water_mask(scene.view, scene.water)
    width, height = scene.size
    matrix = scene.camera.GetCompositeProjectionTransformMatrix(width / height, -1, 1)
    to_clip = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    props = 0
    for actor in scene.renderer.GetActors():
        if actor.IsA("vtkWaterActor"):
            continue
        points = vtk_to_numpy(actor.GetMapper().GetInput().GetPoints().GetData())
        points = points[points[:, 2] > 0].astype(float) * (1, 1, -1)
        clip = np.concatenate([points, np.ones((len(points), 1))], axis=1) @ to_clip.T
        clip = clip[clip[:, 3] > 0]
        x, y = (
            np.floor((0.5 + 0.5 * clip[:, i] / clip[:, 3]) * size).astype(int)
            for i, size in ((0, width), (1, height))
        )
        is_inside = (x >= 0) & (x < width) & (y >= 0) & (y < height)
        x, y = x[is_inside], y[is_inside]
        props += bool(mask[y, x].any())
    return props, _reflecting_pixels(scene, mask)


def _reflecting_pixels(scene, mask):
    """How many pixels of calm water reflect something other than the sky."""
    start, ray = (rows[mask.ravel()] for rows in ray_caster.eye_rays(scene.camera, scene.size, 1))
    falls = ray[:, 2] < 0
    place = start[falls] - (start[falls, 2] / ray[falls, 2])[:, None] * ray[falls]
    _, distance = Tracer(scene.renderer).cast(place, ray[falls] * (1, 1, -1))
    return int(np.isfinite(distance).sum())


def _drawn(scene, has_skips):
    """Props and fragments of a mirrored view."""
    is_known = instruments.set_skips(scene.water, has_skips)
    instruments.turn_on(scene.water)
    for turn in (4, 3, 2, 1):  # a moving camera; what is left out is known from the frames before
        scene.stand(turn)
        scene.view.picture()
    said = instruments.read(scene.water)
    instruments.turn_on(scene.water, False)
    return (said["props"] if is_known or has_skips else None), said["fragments"]


def _on_water(scene):
    """Fragments on the pixels of visible water, of all that is drawn."""
    os.environ["VTK_WATER_SOFTWARE"] = "0"  # a mask of single pixels
    try:
        return _drawn(scene, True)[1]
    finally:
        del os.environ["VTK_WATER_SOFTWARE"]


def _share(everything, drawn, needed):
    """% of what is not needed that is left out; None: nothing could be, or nothing is known."""
    if everything is None or drawn is None or everything <= needed:
        return None
    return min(100.0, 100 * (everything - drawn) / (everything - needed))


def _shares(results):
    rows = []
    for name, scene in _five_scenes():
        scene.stand(1)
        needed = _needed(scene)
        everything, drawn = (_drawn(scene, has_skips) for has_skips in (False, True))
        cells = [name]
        for what, *counts in zip(("draws", "fragments"), everything, drawn, needed):
            share = _share(*counts)
            title = f"{name}: {what} left out, % of those not needed"
            if share is not None:
                results.check_at_least(title, share, LIMIT, 1)
            elif counts[0] is None or counts[1] is None:
                results.check_unknown(title, f">= {LIMIT}", "not measured by this module")
            results.row(
                "draws",
                name,
                what,
                everything=counts[0],
                drawn=counts[1],
                needed=counts[2],
                share=share,
            )
            cells += [*map(text, counts), text(share, "{:.0f} %")]
        on_water = _on_water(scene)
        share = _share(everything[1], drawn[1], on_water)
        results.check_at_least(f"{name}: fragments beside the water left out, %", share, LIMIT, 1)
        rows.append([*cells, text(on_water), text(share, "{:.0f} %")])
    return table(
        (
            "scene",
            "draws: all",
            "drawn",
            "needed",
            "share",
            "fragments: all",
            "drawn",
            "needed",
            "share",
            "on the water",
            "share",
        ),
        rows,
    )


def run(results):
    tables = [
        _compare(results, f"{COUNT:,} props {where}", make)
        for where, make in (("under the plane", _under), ("outside the mirrored view", _beside))
    ]
    results.add(
        "Props that the water cannot show",
        TEXT,
        count=f"{COUNT:,}",
        tables="\n\n".join(tables),
        blocks=f"{TILES * TILES:,}",
        composite=_composite(results),
        shares=_shares(results),
    )

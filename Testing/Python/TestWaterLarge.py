# SPDX-License-Identifier: BSD-3-Clause
"""TestWaterLarge: pictures of 256 tiles, as many as 16,384 x 16,384 pixels take; data of 1,000 blocks and in pieces.

WATER_TILE_PX=1024 makes the pictures 16,384 x 16,384 pixels large. This needs a GPU that can draw such a picture in one piece, for the
comparison, and 20 GB of memory.
"""

import os

import numpy as np
import pytest
import water_test as wt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSetCollection
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkWindowToImageFilter

SCALE = 16
TILE_PX = int(os.environ.get("WATER_TILE_PX", 0))
SIZE = (TILE_PX, TILE_PX) if TILE_PX else (48, 36)


def fill(view):
    for i in range(5):
        wt.add_actor(view.renderer, wt.pyramid((2 * i - 4, 1.5 * (i % 3) - 1, 0.8), 2 + 0.3 * i, 5), (1, 0.6, 0.2 * i))
    view.renderer.SetBackground(0.4, 0.6, 0.9)
    wt.place_camera(view.renderer, (3, -13, 3), (0, 0, 0.4), (0.5, 60))
    wt.add_scene_light(view.renderer, (2, -4, 5))
    wt.add_water(view.renderer, None, (-9, 9, -9, 9))


def fill_clear(view, has_waves):
    """A bed and balls on it, seen through water that reflects by Fresnel's law."""
    fill(view)
    wt.add_actor(view.renderer, wt.box((0, 0, -1.5), (18, 18, 0.4)), (0.8, 0.7, 0.5))
    for i in range(6):
        ball = wt.sphere((2 * i - 5, 1.3 * (i % 3) - 4, -1), 0.4)
        wt.add_actor(view.renderer, ball, (0.2, 0.3 + 0.1 * i, 0.9 - 0.1 * i))
    props = view.renderer.GetViewProps()
    water = next(prop for prop in (props.GetItemAsObject(i) for i in range(props.GetNumberOfItems()))
                 if prop.IsA("vtkWaterActor"))
    look = water.GetWaterProperty()
    look.SetReflectanceModeToFresnel()
    look.SetMetresPerUnit(1)
    look.RefractionOn()
    if has_waves:
        look.AddWave(0.05, 2.1, 30)
        look.AddWave(0.03, 1.3, 75)
    return water


def tiled(view):
    tiles = vtkWindowToImageFilter()
    tiles.SetInput(view.window)
    tiles.SetScale(SCALE)
    tiles.SetInputBufferTypeToRGB()
    tiles.ReadFrontBufferOff()
    tiles.Update()
    pixels = vtk_to_numpy(tiles.GetOutput().GetPointData().GetScalars())
    return pixels.reshape(SCALE * SIZE[1], SCALE * SIZE[0], 3)


def seams(picture, whole):
    """Shares of pixels off by more than 1 of 255: of all, and of those beside the edges of tiles."""
    is_off = (np.maximum(picture, whole) - np.minimum(picture, whole)).max(axis=2) > 1
    beside = np.zeros_like(is_off)
    for axis, size in ((0, SIZE[1]), (1, SIZE[0])):
        index = np.arange(is_off.shape[axis]) % size
        beside |= np.expand_dims((index == 0) | (index == size - 1), 1 - axis)
    return is_off.mean(), is_off[beside].mean()


def test_256_tiles_are_the_picture_in_one_piece():
    """A calm reflection has no seams: what each tile looks up is drawn for it."""
    view = wt.View(SIZE)
    fill(view)
    whole = wt.View((SCALE * SIZE[0], SCALE * SIZE[1]))
    fill(whole)
    all_off, seam_off = seams(tiled(view), whole.picture())
    wt.check_at_most("share of pixels off", all_off, 0.0002)
    wt.check_at_most("  beside the edges of tiles", seam_off, 0.0002)


@pytest.mark.parametrize("has_waves", (False, True), ids=("calm", "waves"))
def test_256_tiles_of_clear_water_have_no_seams(has_waves):
    """What refracted and traced rays find beside a tile is drawn for it, though no view of its own was asked for.

    Rays in waves are searched for in as many steps as in the whole picture, of which some cross more of it: they
    differ here and there, and no more beside edges of tiles than elsewhere.
    """
    view, whole = wt.View(SIZE), wt.View((SCALE * SIZE[0], SCALE * SIZE[1]))
    water = fill_clear(view, has_waves)
    fill_clear(whole, has_waves).GetWaterProperty().SetRefractionSourceToOwnView()
    all_off, seam_off = seams(tiled(view), whole.picture())
    wt.check_equal("error", water.GetLastError(), "")
    if has_waves:
        wt.check_at_most("share of pixels off", all_off, 0.02)
        wt.check_at_most("  beside the edges of tiles, of that elsewhere", seam_off / all_off, 1.1)
    else:
        wt.check_at_most("share of pixels off", all_off, 0.0002)
        wt.check_at_most("  beside the edges of tiles", seam_off, 0.0002)


def blocks(count):
    """A collection of pyramids, in a row each ten."""
    collection = vtkPartitionedDataSetCollection()
    for i in range(count):
        collection.SetPartition(i, 0, wt.pyramid((0.4 * (i % 40) - 8, 0.5 * (i // 40) - 6, 0.3), 1 + 0.02 * (i % 30),
                                                 4, 0.15))
    return collection


def mapper_of_blocks():
    if vtkVersion.GetVTKMajorVersion() * 100 + vtkVersion.GetVTKMinorVersion() >= 903:
        from vtkmodules.vtkRenderingCore import vtkCompositePolyDataMapper
        return vtkCompositePolyDataMapper()
    from vtkmodules.vtkRenderingOpenGL2 import vtkCompositePolyDataMapper2
    return vtkCompositePolyDataMapper2()


def test_data_of_1000_blocks_is_reflected_as_1000_actors_are():
    pictures = []
    for is_composite in (True, False):
        view = wt.View((400, 300))
        view.renderer.SetBackground(0.4, 0.6, 0.9)
        wt.place_camera(view.renderer, (3, -13, 3), (0, 0, 0.4), (0.5, 60))
        wt.add_scene_light(view.renderer, (2, -4, 5))
        data = blocks(1000)
        if is_composite:
            mapper = mapper_of_blocks()
            mapper.SetInputDataObject(data)
            actor = vtkActor()
            actor.SetMapper(mapper)
            actor.GetProperty().SetColor(1, 0.6, 0.2)
            view.renderer.AddActor(actor)
        else:
            for i in range(1000):
                wt.add_actor(view.renderer, data.GetPartition(i, 0), (1, 0.6, 0.2))
        water = wt.add_water(view.renderer, None, (-9, 9, -9, 9))
        pictures.append(view.picture())
        wt.check_equal("error", water.GetLastError(), "")
        wt.check_equal("decision", wt.decision_of(water), "RENDERED")
        water.SetVisibility(False)
        pictures.append(view.picture())
    dry = (np.abs(pictures[1] - pictures[3]).max(axis=2) > 1).mean()  # VTK's own mappers differ at some edges
    wet = (np.abs(pictures[0] - pictures[2]).max(axis=2) > 1).mean()
    wt.check_at_most("share of pixels off", wet, dry + 0.0002)
    wt.check_at_least("share of pixels that show water", (pictures[0] != pictures[1]).any(axis=2).mean(), 0.05)


def ball_in_pieces(count):
    """A view of a ball that its mapper streams in so many pieces; 1: all of it at once."""
    view = wt.View((320, 240))
    view.renderer.SetBackground(0.4, 0.6, 0.9)
    wt.place_camera(view.renderer, (3, -13, 3), (0, 0, 0.4), (0.5, 60))
    wt.add_scene_light(view.renderer, (2, -4, 5))
    source = vtkSphereSource()
    source.SetRadius(2)
    source.SetCenter(0, 0, 1)
    source.SetThetaResolution(64)
    source.SetPhiResolution(64)
    view.mapper = vtkPolyDataMapper()
    view.mapper.SetInputConnection(source.GetOutputPort())
    view.mapper.SetNumberOfSubPieces(count)
    actor = vtkActor()
    actor.SetMapper(view.mapper)
    actor.GetProperty().SetColor(1, 0.5, 0.2)
    view.renderer.AddActor(actor)
    return view


def test_pieces_that_a_mapper_streams_are_reflected_as_the_whole():
    """One piece at a time is in memory: the mirrored view streams them once more."""
    pictures = []
    for count in (1, 8):
        view = ball_in_pieces(count)
        dry = view.picture()
        water = wt.add_water(view.renderer, None, (-9, 9, -9, 9))
        for _ in range(2):
            pictures.append(view.picture())
            wt.check_equal("error", water.GetLastError(), "")
        wt.check_equal("cells in memory", view.mapper.GetInput().GetNumberOfCells(), 7936 // count)
    for picture in pictures[1:]:
        wt.check_equal("pixels that differ", int((picture != pictures[0]).any(axis=2).sum()), 0)
    wt.check_at_least("share of pixels that show water", (pictures[0] != dry).any(axis=2).mean(), 0.05)

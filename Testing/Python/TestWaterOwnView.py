# SPDX-License-Identifier: BSD-3-Clause
"""Clear water with a view of its own shows what the picture does not have; the view is rendered only when it must be."""

import numpy as np
import pytest
import ray_caster
import volumes
import water_test as wt
from vtkmodules.vtkCommonCore import vtkInformation
from TestWaterRefractsAndAbsorbs import BED, clear_water, look_at, truth_of
from vtkwater import vtkWaterReflectionPass

SIZE = (400, 300)
RED = (0.9, 0.1, 0.1)
DEPTH = 3.0
EYE = (0, -7, 5)


def straight_to_bed(row):
    """y of the bed straight behind a row of the picture, counted from the bottom."""
    view = np.array((0, 7, -5)) / np.hypot(7, 5)
    up = np.array((0, 5, 7)) / np.hypot(7, 5)
    ray = view + np.tan(np.radians(15)) * (2 * (row + 0.5) / SIZE[1] - 1) * up
    return EYE[1] - (EYE[2] + DEPTH) * ray[1] / ray[2]


def bed_box(low, high):
    """A red part of the bed, over all of its width."""
    return ray_caster.Box((0, 0.5 * (low + high), -DEPTH - 0.45), (300, high - low, 0.92), RED)


class Pool:
    """A bed under clear water, and things; what a ray caster shows of them."""

    def __init__(self, *things, samples=0):
        self.things = [ray_caster.Box((0, 0, -DEPTH - 0.5), (398, 398, 1), BED), *things]
        self.made = wt.View(SIZE, (0.6, 0.75, 0.9), samples)
        self.actors = [wt.add_actor(self.made.renderer, wt.box(0.5 * (thing.low + thing.high), thing.high - thing.low),
                                    thing.color, lit=False) for thing in self.things]
        self.water = clear_water(self.made, (0.35, 0.12, 0.06), (0.02, 0.10, 0.16))
        self.look = self.water.GetWaterProperty()
        self.passes = self.water.GetReflectionPass()
        self.camera = look_at(self.made, EYE)

    def wrong(self, source):
        """% of the water's pixels that differ from the truth by more than 40 of 255, and the picture."""
        self.look.SetRefractionSource(source)
        picture = self.made.picture()
        truth, mask = truth_of(self.things, self.camera, samples=1, size=SIZE)
        return 100 * float((np.abs(picture - truth).max(axis=2) > 40)[mask].mean()), picture

    def renders(self):
        """Renders a frame; how many own views were drawn for it."""
        before = self.passes.GetNumberOfOwnViewRenders()
        self.made.window.Render()
        return self.passes.GetNumberOfOwnViewRenders() - before

    def check_both(self, name, least):
        """Wrong pixels are many with the picture, and next to none with the own view."""
        of_picture, picture = self.wrong(self.look.PICTURE)
        of_own_view, own_view = self.wrong(self.look.OWN_VIEW)
        for source, shown in (("picture", picture), ("own-view", own_view)):
            wt.save(shown, wt.output_folder() / f"TestWaterOwnView-{name.replace(' ', '-')}-{source}.png")
        wt.check_at_least(f"{name}: % of wrong pixels from the picture", of_picture, least)
        wt.check_at_most(f"{name}: % of wrong pixels from the own view", of_own_view, 0.3)


def test_what_lies_outside_the_picture_is_seen():
    """A part of the bed that only refracted rays see, because it is under the picture's lower border."""
    Pool(bed_box(-30, straight_to_bed(-2))).check_both("outside", 3)


def test_what_stands_over_the_water_hides_nothing():
    """A part of the bed that the eye would see behind a board, if there were no water."""
    board = ray_caster.Box((0, -1.4, 1), (30, 0.05, 1.2), (0.2, 0.2, 0.2))
    low, high = (EYE[1] + (board.low[1] - EYE[1]) * (EYE[2] + DEPTH) / (EYE[2] - z) for z in (board.low[2], board.high[2]))
    Pool(bed_box(low + 0.1, high - 0.1), board).check_both("hidden", 3)


def test_an_eye_in_the_water_has_one_too():
    """From below, what is over the water is seen, and what lies in it hides nothing of it."""
    pool = Pool(bed_box(-1, 1))
    pool.camera.SetPosition(0, -7, -1.5)
    pool.camera.SetFocalPoint(0, 0, 3)
    pool.look.SetRefractionSourceToPicture()
    of_picture = pool.made.picture()
    pool.look.SetRefractionSourceToOwnView()
    of_own_view = pool.made.picture()
    wt.check_equal("own views", pool.passes.GetNumberOfOwnViewRenders(), 1)
    wt.check_at_most("largest difference under a plain sky", int(np.abs(of_picture - of_own_view).max()), 1)


def test_the_picture_stays_the_source_unless_another_is_asked_for():
    """The default is the picture, to the byte, also after an own view."""
    pool = Pool(bed_box(-30, straight_to_bed(-2)))
    pool.look.AddWave(0.0127, 2.0, 20.0, 10.0)
    before = pool.made.picture()
    wt.check_equal("default", pool.look.GetRefractionSourceAsString(), "PICTURE")
    wt.check_equal("own views by default", pool.passes.GetNumberOfOwnViewRenders(), 0)
    pool.look.SetRefractionSourceToOwnView()
    other = pool.made.picture()
    wt.check_equal("the own view shows something else", np.array_equal(before, other), False)
    pool.look.SetRefractionSourceToPicture()
    wt.check_equal("the picture again, to the byte", np.array_equal(before, pool.made.picture()), True)
    wt.check_equal("decision", pool.passes.GetOwnViewDecision(), vtkWaterReflectionPass.NOT_PLANNED)


def test_it_is_rendered_only_when_something_in_it_has_changed():
    """Neither time nor waves, nor what moves over the water, make another own view; the camera and the scene do."""
    board = ray_caster.Box((0, -1.4, 1), (3, 0.05, 1.2), (0.2, 0.2, 0.2))
    pool = Pool(bed_box(-1, 1), board)
    pool.look.AddWave(0.0127, 2.0, 20.0, 10.0)
    pool.look.SetRefractionSourceToOwnView()
    wt.check_equal("first frame", pool.renders(), 1)
    wt.check_equal("the same", pool.renders(), 0)
    wt.check_equal("decision", pool.passes.GetOwnViewDecisionAsString(), "used again: nothing has changed")
    pool.water.SetTime(1.5)
    wt.check_equal("another time", pool.renders(), 0)
    pool.look.SetWave(0, 0.02, 3.0, 20.0)
    wt.check_equal("other waves", pool.renders(), 0)
    pool.actors[2].AddPosition(0.5, 0, 0.5)
    wt.check_equal("a move over the water", pool.renders(), 0)
    pool.actors[1].AddPosition(0, 0.5, 0)
    wt.check_equal("a move under it", pool.renders(), 1)
    pool.actors[1].GetProperty().SetColor(0, 1, 0)
    wt.check_equal("another colour", pool.renders(), 1)
    pool.camera.Azimuth(5)
    wt.check_equal("another camera", pool.renders(), 1)
    pool.camera.SetFocalPoint(*pool.camera.GetPosition()[:2], 100)
    pool.camera.SetViewUp(0, 1, 0)
    wt.check_equal("out of view", pool.renders(), 0)
    wt.check_equal("out of view, decision", pool.passes.GetOwnViewDecision(), vtkWaterReflectionPass.WATER_OUT_OF_VIEW)


def test_what_is_said_of_reflections_does_not_matter():
    """A prop that is not reflected, or that another one stands in for in reflections, is seen through the water."""
    pool = Pool(bed_box(-2, 2))
    pool.look.SetRefractionSourceToOwnView()
    plain = pool.made.picture()
    wt.leave_out(pool.actors[1])
    wt.check_equal("not reflected: the same picture", np.array_equal(plain, pool.made.picture()), True)
    other = wt.add_actor(pool.made.renderer, wt.box((5, 5, -1), (1, 1, 1)), (0, 0, 1), lit=False)
    pool.made.renderer.RemoveActor(other)
    keys = vtkInformation()
    keys.Set(vtkWaterReflectionPass.STAND_IN(), other)
    pool.actors[1].SetPropertyKeys(keys)
    wt.check_equal("a stand-in: the same picture", np.array_equal(plain, pool.made.picture()), True)
    wt.check_at_least("own views", pool.passes.GetNumberOfOwnViewRenders(), 1)


def test_skips_do_not_show():
    """With all skips off the picture is the same, and the own view is rendered in every frame."""
    pool = Pool(bed_box(-30, straight_to_bed(-2)))
    pool.look.SetRefractionSourceToOwnView()
    picture = pool.made.picture()
    pool.passes.SetSkips(0)
    pool.renders()
    wt.check_equal("every frame", pool.renders(), 1)
    wt.check_equal("the same picture", np.array_equal(picture, pool.made.picture()), True)


@pytest.mark.parametrize("has_own_view", (False, True), ids=("picture", "own_view"))
def test_translucent_things_are_seen_through_the_water(has_own_view):
    """A translucent box over the bed is seen through the water with an own view, dimmed like the bed behind it."""
    pool = Pool()
    pool.look.SetRefractionSource(int(has_own_view))
    without = pool.made.picture()
    pool.actors.append(wt.add_actor(pool.made.renderer, wt.box((0, 0, -DEPTH + 0.1), (2, 2, 0.2)), RED, lit=False,
                                    opacity=0.5))
    seen = pool.made.picture()
    wt.save(seen, wt.output_folder() / f"TestWaterOwnView-translucent-{has_own_view}.png")
    changed = (np.abs(seen - without).max(axis=2) > 10).mean()
    if has_own_view:
        wt.check_at_least("% of the pixels that show it", 100 * float(changed), 2)
    else:
        wt.check_equal("pixels that show it", float(changed), 0.0)


@pytest.mark.parametrize("has_own_view", (False, True), ids=("picture", "own_view"))
def test_a_plume_is_seen_through_the_water(has_own_view):
    """A dense volume on the bed shows as a box of its size and colour does, with an own view; without one, nothing."""
    low, high = np.array((-1.0, -1.0, -DEPTH)), np.array((1.0, 1.0, -DEPTH + 0.1))
    pools = [Pool(), Pool(ray_caster.Box(0.5 * (low + high), high - low, RED)), Pool()]
    dense = volumes.ray_cast(volumes.block(low, high), 0.01, [(0, *RED), (255, *RED)], [(0, 1.0), (255, 1.0)])
    dense.GetProperty().SetScalarOpacityUnitDistance(0.001)
    pools[2].made.renderer.AddVolume(dense)
    for pool in pools:
        pool.look.SetRefractionSource(int(has_own_view))
    without, of_box, of_volume = (pool.made.picture().astype(int) for pool in pools)
    wt.save(of_volume.astype(np.uint8), wt.output_folder() / f"TestWaterOwnView-plume-{has_own_view}.png")
    shown = np.abs(of_box - without).max(axis=2) > 10
    wt.check_at_least("% of the pixels that show the box", 100 * float(shown.mean()), 2)
    if has_own_view:
        off = np.abs(of_volume - of_box).max(axis=2)
        wt.check_at_most("off where the box is, of 255, median", float(np.median(off[shown])), 8)
        wt.check_at_most("% of the box's pixels that are off by more than 40", 100 * float((off[shown] > 40).mean()), 1)
        wt.check_at_most("% of the other pixels that are off by more than 40", 100 * float((off[~shown] > 40).mean()), 0.3)
    else:
        wt.check_at_most("pixels that show the volume", int((of_volume != without).any(axis=2).sum()), 0)

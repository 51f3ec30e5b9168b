# SPDX-License-Identifier: BSD-3-Clause
"""Ray-cast volumes and translucent geometry are reflected, and cut at the water.

The reference is the mirrored camera looking at the scene without any water, the volume cut by its
mapper's own clipping plane, or made without what is under the water; flipped in x it is what the water must show.
"""

import numpy as np
import pytest
import volumes
import water_test as wt
from vtkmodules.vtkRenderingVolume import vtkFixedPointVolumeRayCastMapper

SIZE = (320, 240)


def cloud(height):
    return volumes.ray_cast(volumes.ball((0, 0, height), 1.0, 48, 1, 100), 0.02,
                            ((0, 1, 0.8, 0), (120, 1, 0.2, 0)), ((0, 0.9), (90, 0.3), (101, 0)))


def fill(view, kind, cut):
    if kind.startswith("volume"):
        # widest under water: uncut, that part would stand out from behind the cap over it
        volume = cloud(1.5 if "above" in kind else -0.3)
        if cut and "across" in kind:
            volume.GetMapper().AddClippingPlane(wt.plane((0, 0, 0), (0, 0, 1)))
        view.renderer.AddVolume(volume)
        wt.add_actor(view.renderer, wt.box((2.5, 1, 1), (1, 1, 2)), (0.3, 0.8, 0.3), lit=False)
    else:
        for i in range(3):
            wt.add_actor(view.renderer, wt.box((1.2 * i - 1, i, 1.5), (1.5, 0.8, 1.5)),
                         (1 - 0.4 * i, 0.2 + 0.3 * i, 0.3), lit=False, opacity=0.5)
    if "peeling" in kind:
        view.renderer.UseDepthPeelingOn()
        view.renderer.SetMaximumNumberOfPeels(20)
        view.window.SetAlphaBitPlanes(True)


def fill_with_block(view, mode, cut):
    """A block as dense everywhere that reaches deep into the water: its reflection has no more than its top."""
    block = volumes.block((-1, -1, 0 if cut else -1.8), (1, 1, 0.7))
    volume = volumes.ray_cast(block, 0.05, ((0, 1, 0.8, 0), (255, 1, 0.2, 0)), ((0, 0.95), (255, 0.95)))
    getattr(volume.GetMapper(), f"SetBlendModeTo{mode}")()
    view.renderer.AddVolume(volume)


def view_without_water(kind, fill):
    view = wt.View(SIZE)
    fill(view, kind, cut=True)
    wt.place_camera(view.renderer, (1, -9, 3), (0.5, 0, 0), (1, 40))
    return view.picture()


@pytest.mark.parametrize("kind", ("volume above", "volume across the surface", "translucent",
                                  "translucent with depth peeling"))
def test_water_shows_the_mirrored_picture_of(kind):
    """The water shows what the mirrored camera sees, and of a volume across the surface no more than is above it."""
    compare(kind, fill, off_limit=0.5)


@pytest.mark.parametrize("mode", ("Composite", "MaximumIntensity", "AverageIntensity", "Additive"))
def test_rays_that_meet_only_what_is_under_water_show_nothing(mode):
    """However a volume's samples are blended, there are none where only its submerged part is met."""
    compare(mode, fill_with_block, off_limit=0.05)


def test_a_volume_that_the_processor_casts_stays_as_it_is():
    """It is cut at the water beside its own planes, which are its only ones after the frame; it has not changed."""
    view = wt.View(SIZE)
    volume = volumes.ray_cast(volumes.block((-1, -1, -1), (1, 1, 1)), 0.05, ((0, 1, 1, 0), (255, 1, 1, 0)),
                              ((0, 0.9), (255, 0.9)), vtkFixedPointVolumeRayCastMapper)
    mapper = volume.GetMapper()
    own = wt.plane((0, 0, 0), (1, 0, 0))
    mapper.AddClippingPlane(own)
    view.renderer.AddVolume(volume)
    water = wt.add_water(view.renderer, None, (-6, 6, -4, 8))
    wt.place_camera(view.renderer, (1, -9, 3), (0.5, 0, 0), (1, 40))
    before = mapper.GetMTime()
    first = view.picture()
    planes = mapper.GetClippingPlanes()
    wt.check_equal("its planes", [planes.GetItem(i) for i in range(planes.GetNumberOfItems())], [own])
    wt.check_equal("has it changed", mapper.GetMTime() == before, True)
    wt.check_equal("the same again: difference", wt.difference(view.picture(), first), 0)
    view.picture()  # by then its data have the time that they were cast at
    wt.check_equal("the same again: decision", wt.decision_of(water), "REUSED")


def compare(kind, fill, off_limit):
    view = wt.View(SIZE)
    fill(view, kind, cut=False)
    water = wt.add_water(view.renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-6, 6, -4, 8))
    wt.place_camera(view.renderer, (1, -9, 3), (0.5, 0, 0), (1, 40))
    seen = view.picture()
    mask = wt.water_mask(view, water)

    mirror = wt.View(SIZE)
    fill(mirror, kind, cut=True)
    wt.place_camera(mirror.renderer, (1, -9, -3), (0.5, 0, 0), (1, 40), view_up=(0, 0, -1))
    expected = mirror.picture()[:, ::-1]
    background = expected[0, 0]

    # only what is really behind the surface in the reference: a volume in front hides the water
    error = np.abs(seen - expected).max(axis=2)
    hidden = np.abs(view_without_water(kind, fill) - background).max(axis=2) > 0
    shown = mask & ~hidden
    is_reflected = np.abs(expected - background).max(axis=2) > 30
    wt.check_at_least(f"{kind}: reflected pixels", int(is_reflected[shown].sum()), 500)
    rmse = float(np.sqrt(((seen - expected)[shown] ** 2).mean()))
    wt.check_at_most(f"{kind}: RMSE of 255", rmse, 1.0)
    wt.check_at_most(f"{kind}: % of water pixels off by more than 8/255", float(100 * (error > 8)[shown].mean()),
                     off_limit)

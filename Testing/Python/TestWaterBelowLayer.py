# SPDX-License-Identifier: BSD-3-Clause
"""What is translucent under clear water with an own view is refracted and dimmed where it is, as a ray caster shows it."""

import numpy as np
import pytest
import ray_caster
import water_test as wt
from TestWaterRefractsAndAbsorbs import ABSORPTION, BED, DEEP, RIPPLES, SKY, clear_water, look_at, truth_of

SIZE = (300, 220)
OPACITY = 0.6
ORANGE = (0.9, 0.5, 0.1)
FLOOR = [ray_caster.Box((0, 0, -3.5), (198, 198, 1), BED)]
POSTS = [ray_caster.Box((x, 2.5, -2.2), (0.3, 0.3, 1.6), (0.1, 0.2, 0.6)) for x in (-1.0, 1.2)]
SCENES = {"calm": (FLOOR + POSTS, ()), "waves": (FLOOR + POSTS, RIPPLES), "no bed": ([], ())}


def picture_with(things, waves, board, opacity):
    """Of the scene with a board of an opacity; also the camera."""
    made = wt.View(SIZE, SKY)
    for thing in (*things, board):
        actor = wt.add_actor(made.renderer, wt.box(0.5 * (thing.low + thing.high), thing.high - thing.low), thing.color,
                             lit=False, opacity=opacity if thing is board else 1.0)
        if thing is board:
            actor.GetProperty().BackfaceCullingOn()  # seen once, not twice
    water = clear_water(made, ABSORPTION, DEEP)
    water.GetWaterProperty().SetRefractionSourceToOwnView()
    for wave in waves:
        water.GetWaterProperty().AddWave(*wave)
    camera = look_at(made, (0, -7, 4))
    return made.picture(), camera


@pytest.mark.parametrize("software", ["1", "0"])
@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("depth", [0.7, 2.0])
def test_a_translucent_board_is_as_right_as_an_opaque_one(monkeypatch, software, scene, depth):
    """The board is in front of all else: what is seen is its share of an opaque one, and the rest of what is without it."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", software)
    things, waves = SCENES[scene]
    board = ray_caster.Box((0, 1.0, -depth), (2.0, 0.02, 0.7), ORANGE)
    opaque, camera = picture_with(things, waves, board, 1.0)
    seen, _ = picture_with(things, waves, board, OPACITY)
    truth, mask = truth_of([*things, board], camera, waves, samples=1, size=SIZE)
    bare, _ = truth_of(things, camera, waves, samples=1, size=SIZE)
    shown = np.abs(truth - bare).max(axis=2) > 10
    mixed = OPACITY * truth + (1 - OPACITY) * bare
    name = f"{scene}, {depth} m, software {software}"
    for kind, image in (("shown", seen), ("truth", mixed.round().clip(0, 255).astype(int))):
        wt.save(image, wt.output_folder() / f"TestWaterBelowLayer-{name.replace(' ', '').replace(',', '-')}-{kind}.png")
    wrong = [100.0 * float(((np.abs(picture - right).max(axis=2) > 10) & mask).sum()) / float(shown.sum())
             for picture, right in ((opaque, truth), (seen, mixed))]
    wt.check_at_least(f"{name}: pixels of the board", int(shown.sum()), 300)
    wt.check_at_most(f"{name}: wrong pixels, % of the board's (opaque: {wrong[0]:.1f})", wrong[1], wrong[0] + 4.0)

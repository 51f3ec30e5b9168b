# SPDX-License-Identifier: BSD-3-Clause
"""edge_generator: random scenes (refraction_generator) with much to see at the edges of their water.

Rocks and posts stand in the water, thin ones hang over it, and the bed may come out of it. One water of three is opaque,
half are calm; the background is white, or a sky.
"""

import refraction_generator
import scene_generator

WHITE = (1.0, 1.0, 1.0)
OPAQUE = 1 / 3  # share of the scenes
CALM = 1 / 2
WHITES = 1 / 2
LEAST_WAVE = 0.15  # of the reach: waves within a pixel are another matter
LEAST_OVER = 0.4  # share of the things that are posts


class Draft(refraction_generator.Draft):
    REACH = (1.0, 100.0)
    ELEVATION = (6.0, 60.0)
    DOMES = 0.0

    def _thing(self, random):
        data, color = super()._thing(random)
        while random.random() < LEAST_OVER and data.GetLength() < 0.2 * self.reach:
            data, color = super()._thing(random)
        return data, color

    def _waves(self, random):
        waves = super()._waves(random)
        is_calm, self._is_opaque, is_white = random.random(3) < (CALM, OPAQUE, WHITES)
        self.sky = (WHITE,) * 3 if is_white else self.sky
        long = tuple(wave for wave in waves if wave[1] > LEAST_WAVE * self.reach)
        return () if is_calm else long

    def scene(self, seed, tries):
        made = super().scene(seed, tries)
        look = made.water.GetWaterProperty()
        look.SetReflectanceModeToFresnel()
        look.SetRefraction(not self._is_opaque)
        renderer = made.made.renderer
        if self.sky[0] != WHITE:
            renderer.GradientBackgroundOn()
            renderer.SetBackground2(self.sky[1])
        made.facts |= {"opaque": bool(self._is_opaque), "white": self.sky[0] == WHITE}
        return made


def make(seed, size=scene_generator.SIZE):
    return scene_generator.make(seed, size, Draft)

# SPDX-License-Identifier: BSD-3-Clause
"""errors: how far a scene's water is from the truth, by the tools of Utilities/Accuracy.

The truth is the ray tracer's, at 16 samples a pixel, in water that reflects everything. It does not
know volumes: with one, the truth is the scene and its explicit mirror image under it, rendered
without water at 16 samples, and calm water is all that it is a truth for.
"""

import colour
import geometry
import kinds
import lookup
import numpy as np
import reference
import scenes
import water_test as wt
import wave_scenes
from formulas import FORMULAS, axes_of
from tracer import Tracer

SAMPLES = 4  # squared: rays per pixel of the truth
SEARCHED = 4000  # pixels that the search for a formula's best constant looks at
SEARCH_STEPS = 31
UNKNOWN = float("nan")


class Places(lookup.Case):
    """The pixels whose right place of the lookup is known."""

    def __init__(self, scene, tracer, waves):
        self.scene, self.made, self.water = scene, scene.view, scene.water
        self.all = reference.Pixels(tracer, self.made, self.water, waves, scene.size)
        self.is_water = wt.water_mask(self.made, self.water).ravel() & self.all.is_water
        self._counts = self.is_water & self.all.is_hit & self.all.is_on_map & self.all.is_seen
        self.pixels = self.all.only(self._counts)
        self.tracer = tracer

    def looked_up_errors(self, scale):
        """Distances in pixels of the picture, of the water as it is set, at a texture scale."""
        uv = wave_scenes.looked_up(self.made, self.water)[self._counts]
        size = np.array(self.scene.size) * scale
        right, texture = wave_scenes.map_places(
            self.scene.camera, self.water, self.pixels.end, size
        )
        is_there = ((right >= 0) & (right <= 1)).all(axis=1)
        return (np.linalg.norm((uv - right) * texture, axis=1) / scale)[is_there]

    def some(self):
        """Of the pixels only as many as a search needs."""
        other = object.__new__(Places)
        other.__dict__.update(self.__dict__)
        chosen = np.zeros(len(self.pixels.ray), dtype=bool)
        chosen[:: max(len(chosen) // SEARCHED, 1)] = True
        other.pixels = self.pixels.only(chosen)
        return other


class Truth(colour.View):
    """A scene's truth for some waves; RMSE and FLIP of pictures against it are colour.View's."""

    def __init__(self, scene, waves, tracer):
        self.scene, self.water = scene, scene.water
        kinds.set_waves(self.water, waves)
        if tracer:
            self.truth, is_water = reference.picture(
                tracer, scene.camera, scene.size, waves, SAMPLES
            )
            self.mask = is_water & wt.water_mask(scene.view, self.water)
        else:
            self.truth, self.mask = _mirrored_scene(scene.kind, scene.size)

    def of_module(self, step, scale, constants):
        """RMSE, FLIP of the water."""
        step.apply(self.water, scale, constants)
        picture = self.scene.view.picture()
        return self.rmse(picture), self.flip(picture)


class Reference:
    """The truths of a scene, with and without waves."""

    def __init__(self, kind, size):
        self.scene = scenes.Scene(kind, size, is_lit=False)
        self.constants, self._errors = {}, {}
        self.tracer = Tracer(self.scene.renderer) if kind.has_tracer else None
        self._truths = {False: Truth(self.scene, (), self.tracer)}
        self._places = {}
        if self.tracer:
            self._truths[True] = Truth(self.scene, kinds.WAVES, self.tracer)
            for has_waves in (False, True):
                self._render_once(kinds.TRACED if has_waves else kinds.CALM)
                self._places[has_waves] = Places(
                    self.scene, self.tracer, kinds.WAVES if has_waves else ()
                )
            some = self._places[True].some()
            for step in kinds.STEPS:  # the module turns no axes
                if step.formula:
                    self.constants[step.formula] = _best_constant(
                        some, kinds.formula_of(step), is_turned=False
                    )

    @property
    def truth(self):
        return self._truths[max(self._truths)]

    def errors(self, step, scale):
        """RMSE of 255, FLIP, and lookup errors in pixels: the median and what 95 % are within."""
        if step.has_waves not in self._truths:
            return (UNKNOWN,) * 4
        found = self._truths[step.has_waves].of_module(step, scale, self.constants)
        if step.has_waves not in self._places:
            return (*found, UNKNOWN, UNKNOWN)
        places = self._places[step.has_waves].looked_up_errors(scale)
        return (*found, *(float(share) for share in np.percentile(places, (50, 95))))

    def _render_once(self, step):
        """The places of a texture are those of the last mirrored view (Pixels.map_places)."""
        step.apply(self.scene.water, 1, {})
        self.scene.view.picture()

    def classics(self):
        """All classic formulas: (formula, who, RMSE, FLIP, median error of the lookup).

        Their pictures are the tracer's: the colour that the mirrored view has at the place they
        look up, without the loss of a texture.
        """
        self._render_once(kinds.TRACED)
        truth, places = self._truths[True], self._places[True].some()
        for formula in FORMULAS:
            for who, scale in (
                ("best constant", _best_constant(places, formula)),
                *formula.published,
            ):
                median, axes = _best_axes(places, formula, scale)
                picture = self._picture(formula, axes, scale)
                yield formula.name, who, truth.rmse(picture), truth.flip(picture), median

    def _picture(self, formula, axes, scale):
        truth, pixels = self._truths[True], self._places[True].all.only(
            self._truths[True].mask.ravel()
        )
        uv = np.clip(
            np.nan_to_num(formula.place(pixels, pixels.normal @ axes.T, scale), nan=0.5), 0, 1
        )
        picture = truth.truth.copy()
        picture[truth.mask] = np.rint(255 * self._mirrored_colors(pixels, uv))
        return picture

    def _mirrored_colors(self, pixels, uv):
        """What the mirrored view shows at places of its texture."""
        camera, (width, height) = self.scene.camera, self.scene.size
        ndc = (uv - 0.5) * 2 * pixels.texture_size / self.scene.size * (-1, 1)
        ahead = np.asarray(camera.GetDirectionOfProjection())
        right = np.cross(ahead, camera.GetViewUp())
        right /= np.linalg.norm(right)
        up = np.cross(right, ahead)
        tangent = np.tan(np.radians(camera.GetViewAngle()) / 2)
        ray = ahead + tangent * (ndc[:, :1] * width / height * right + ndc[:, 1:] * up)
        ray /= np.linalg.norm(ray, axis=1, keepdims=True)
        eye = np.asarray(camera.GetPosition())
        colors = np.tile(np.asarray(self.scene.renderer.GetBackground()), (len(ray), 1))
        falls = ray[:, 2] < -1e-6
        start = eye - (eye[2] / ray[falls, 2])[:, None] * ray[falls]
        start[:, 2] = 0
        colors[falls] = self.tracer.cast(start, ray[falls] * (1, 1, -1))[0]
        return colors


def _best_constant(places, formula, is_turned=True):
    """That with the smallest median error of the lookup: on a grid, then on a finer one."""
    scales = np.geomspace(*formula.search, SEARCH_STEPS)
    for _ in range(2):
        best = min((_best_axes(places, formula, scale, is_turned)[0], scale) for scale in scales)[1]
        step = scales[1] / scales[0]
        scales = np.geomspace(best / step, best * step, 7)
    return float(best)


def _best_axes(places, formula, scale, is_turned=True):
    """The smallest median error over the ways to turn a formula's axes, and that way."""
    found = [
        (float(np.median(lookup.formula_errors([places], formula, axes, scale))), axes)
        for axes in (axes_of(formula) if is_turned else (np.eye(3),))
    ]
    return min(found, key=lambda each: each[0])


def _mirrored_scene(kind, size):
    """The truth of the plume, and the pixels of water, from a window SAMPLES times as wide."""
    scene = scenes.Scene(kind, tuple(SAMPLES * length for length in size), is_lit=False)
    mask = wt.water_mask(scene.view, scene.water)
    scene.water.VisibilityOff()
    origin, up = (0, 0, 0), (0, 0, 1)
    for actor in list(scene.renderer.GetActors()):
        if actor.IsA("vtkWaterActor"):
            continue
        actor.GetMapper().AddClippingPlane(wt.plane(origin, up))
        scene.add(
            wt.mirror_image(actor.GetMapper().GetInput(), origin, up),
            actor.GetProperty().GetColor(),
        )
    above = list(scene.renderer.GetVolumes())
    for volume in above:
        scene.renderer.RemoveVolume(volume)
    for volume in (geometry.plume(is_mirrored=True), *above):  # the farther first
        scene.renderer.AddVolume(volume)
    picture = scene.view.picture()
    shape = (size[1], SAMPLES, size[0], SAMPLES)
    return (
        np.rint(picture.reshape(*shape, 3).mean(axis=(1, 3))),
        mask.reshape(shape).all(axis=(1, 3)),
    )

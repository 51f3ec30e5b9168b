# SPDX-License-Identifier: BSD-3-Clause
"""Secondary reflections: other waters in a mirrored view reflect the scene there; their views are drawn when they must
be, and no more often. That they show the right picture is in Matrix/TestMatrixSecondaryReflections.py."""

import numpy as np
import pytest
import ray_caster as rc
import water_test as wt
from vtkmodules.vtkRenderingCore import vtkActor
from vtkwater import vtkWaterReflectionPass as Pass

SIZE = (160, 120)
SKY = (0.2, 0.3, 0.4)
SPHERE = ((-0.6, -0.4, 1.2), 0.8, (0.95, 0.6, 0.2))
BOX = ((1.6, 0.8, 0.9), (0.9, 0.9, 1.8), (0.3, 0.85, 0.4))
FALL = ((0, 3.5, 0), (0.4, -1, -0.25), (-6, 6, -5, 5))  # origin, normal and sheet of water that falls into a pool
BEHIND = ((-3, -12, 1.5), (8, 0.5, 5), (0.8, 0.2, 0.6))  # behind the eye: only the fall shows it
DEEP = (0.1, 0.25, 0.3)


class Scene:
    """A pool, a fall of water behind it, a ball and a box before that; the pool shows the fall."""

    def __init__(self, is_on=True, skips=Pass.SKIP_ALL):
        self.view = wt.View(SIZE, background=SKY)
        self.renderer = self.view.renderer
        self.ball = wt.add_actor(self.renderer, wt.sphere(*SPHERE[:2]), SPHERE[2], lit=False)
        self.box = wt.add_actor(self.renderer, wt.box(*BOX[:2]), BOX[2], lit=False)
        self.behind = wt.add_actor(self.renderer, wt.box(*BEHIND[:2]), BEHIND[2], lit=False)
        self.pool = wt.add_water(self.renderer, wt.plane((0, 0, 0), (0, 0, 1)), (-5, 5, -5, 3.4))
        self.fall = wt.add_water(self.renderer, wt.plane(*FALL[:2]), FALL[2], 0.8)
        self.fall.GetWaterProperty().SetDeepColor(*DEEP)
        self.waters = [self.pool, self.fall]
        self.reflection = self.pool.GetReflectionPass()
        for water in self.waters:
            water.GetReflectionPass().SetSkips(skips)
        self.reflection.SetSecondaryReflections(is_on)
        self.camera = wt.place_camera(self.renderer, (1.2, -8, 2.6), (0, 0.5, 0.4), (0.5, 60))

    def picture(self):
        return self.view.picture()

    def counts(self):
        """Mirrored views of the pool, and secondary ones of its reflection, that the next frame draws."""
        before = self.reflection.GetNumberOfReflectionRenders(), self.reflection.GetNumberOfSecondaryRenders()
        self.picture()
        after = self.reflection.GetNumberOfReflectionRenders(), self.reflection.GetNumberOfSecondaryRenders()
        return after[0] - before[0], after[1] - before[1]


def test_it_is_off_by_default():
    """Without the setting no secondary view is drawn, and none is left after it was on."""
    scene = Scene(is_on=False)
    wt.check_equal("off by default", Pass().GetSecondaryReflections(), False)
    plain = scene.picture()
    wt.check_equal("secondary views", scene.reflection.GetNumberOfSecondaryRenders(), 0)
    scene.reflection.SecondaryReflectionsOn()
    changed = (np.abs(scene.picture() - plain).max(axis=2) > 2).mean()
    wt.save(scene.picture(), wt.output_folder() / "secondary_reflections.png")
    wt.save(plain, wt.output_folder() / "secondary_reflections_off.png")
    wt.check_at_least("share of the picture that it changes", round(float(changed), 4), 0.02)
    scene.reflection.SecondaryReflectionsOff()
    wt.check_equal("off again: difference", wt.difference(scene.picture(), plain), 0)


def test_each_water_asks_for_itself():
    """The setting is that of the water whose reflection shows the other."""
    scene = Scene()
    scene.fall.GetReflectionPass().SecondaryReflectionsOn()
    scene.picture()
    counts = [(water.GetReflectionPass().GetNumberOfReflectionRenders(),
               water.GetReflectionPass().GetNumberOfSecondaryRenders()) for water in scene.waters]
    wt.check_equal("mirrored and secondary views", counts, [(1, 1), (1, 1)])
    scene.reflection.SecondaryReflectionsOff()
    wt.check_equal("off for the pool", scene.counts(), (1, 0))


def move_behind(scene):
    scene.behind.AddPosition(0.5, 0, 0.3)


def remove_fall(scene):
    scene.renderer.RemoveActor(scene.fall)


def turn_fall(scene):
    scene.fall.GetPlane().SetNormal(0.3, -1, -0.25)


def hide_fall(scene):
    """Before the camera, far away."""
    scene.fall.GetPlane().SetOrigin(0, -60, 0)


def reflect_nothing(scene):
    scene.fall.GetWaterProperty().SetReflectance(0)


def reflect_the_sky(scene):
    scene.fall.GetWaterProperty().SetReflectionSourceToEnvironment()


# what changes, mirrored and secondary views that are drawn for it
CHANGES = {
    "nothing": (lambda scene: None, (0, 0)),
    "the time of the fall's waves": (lambda scene: scene.fall.SetTime(3), (0, 0)),
    "what only the secondary view shows": (move_behind, (1, 1)),
    "the colour of the fall": (lambda scene: scene.fall.GetWaterProperty().SetDeepColor(0.5, 0.1, 0.1), (1, 0)),
    "the plane of the fall": (turn_fall, (1, 1)),
    "a thing that both show": (lambda scene: scene.box.GetProperty().SetColor(1, 0, 0), (1, 1)),
    "the camera": (lambda scene: scene.camera.SetPosition(1.3, -8, 2.6), (1, 1)),
    "no fall": (remove_fall, (1, 0)),
    "a fall out of sight": (hide_fall, (1, 0)),
    "a fall that reflects nothing": (reflect_nothing, (1, 0)),
    "a fall that reflects the sky alone": (reflect_the_sky, (1, 0)),
    "half the texture scale": (lambda scene: scene.reflection.SetTextureScale(0.5), (1, 1)),
}


@pytest.mark.parametrize("name", CHANGES)
def test_views_are_drawn_when_they_must_be(name):
    """After a change the views that show it are drawn again, and the picture is that of a new scene."""
    change, expected = CHANGES[name]
    scene = Scene()
    for _ in range(3):  # shaders of another kind count as a change once
        scene.picture()
    change(scene)
    wt.check_equal("mirrored and secondary views", scene.counts(), expected)
    fresh = Scene(skips=Pass.SKIP_NONE)
    change(fresh)
    wt.check_equal("difference to a new scene without skips", wt.difference(scene.view.shown(), fresh.picture()), 0)


def test_sheets_of_one_plane_share_a_view():
    """Two sheets of the fall's plane need one secondary view, and show what one sheet does."""
    whole = Scene()
    parts = Scene()
    low, high, *others = FALL[2]
    parts.fall.SetSheetBounds(low, 0, *others)
    right = wt.add_water(parts.renderer, wt.plane(*FALL[:2]), (0, high, *others), 0.8)
    right.GetWaterProperty().SetDeepColor(*DEEP)
    wt.check_at_most("difference", wt.difference(parts.picture(), whole.picture()), 1)
    wt.check_equal("secondary views", parts.reflection.GetNumberOfSecondaryRenders(), 1)


def fall_by_rays(scene, variance):
    """The pool's pixels that show the fall, and their colours: rays from the eye, to the pool, to the fall, and on."""
    origin, normal = np.asarray(FALL[0], float), wt.unit(FALL[1])
    across = wt.unit((1.0, 0, 0) - normal[0] * normal)  # the plane's own axes
    up = np.cross(normal, across)
    start, ray = rc.eye_rays(scene.camera, SIZE, 1)
    things = [rc.Sphere(*SPHERE), rc.Box(*BOX), rc.Box(*BEHIND)]

    def to_fall(begin, along):
        with np.errstate(all="ignore"):
            way = (origin - begin) @ normal / (along @ normal)
        way = np.where(way > 1e-9, way, np.inf)
        with np.errstate(all="ignore"):
            place = begin + way[:, None] * along - origin
        x, y = place @ across, place @ up
        low, high, bottom, top = FALL[2]
        return np.where((x > low) & (x < high) & (y > bottom) & (y < top), way, np.inf)

    with np.errstate(all="ignore"):
        to_pool = np.where(ray[:, 2] < 0, -start[:, 2] / ray[:, 2], np.inf)
        point = start + to_pool[:, None] * ray
    is_pool = (to_pool < rc.cast(things, SKY, start, ray)[1]) & (to_pool < to_fall(start, ray))
    is_pool &= (np.abs(point[:, 0]) < 5) & (np.abs(point[:, 1] + 0.8) < 4.2)
    mirrored = ray * (1, 1, -1)
    way = np.full(len(ray), np.inf)
    way[is_pool] = to_fall(point[is_pool], mirrored[is_pool])
    way[is_pool] = np.where(way[is_pool] < rc.cast(things, SKY, point[is_pool], mirrored[is_pool])[1], way[is_pool], np.inf)
    shows = np.isfinite(way)
    begin, along = point[shows] + way[shows][:, None] * mirrored[shows], mirrored[shows]
    random = np.random.default_rng(1)
    total, weights = np.zeros((len(begin), 3)), np.zeros(len(begin))
    for slopes in random.normal(0, np.sqrt(variance), (400, 2)) if variance else np.zeros((1, 2)):
        facet = wt.unit(normal - slopes[0] * across - slopes[1] * up)
        cosine = -(along @ facet)
        weight = np.maximum(cosine, 0) / (facet @ normal)
        away = along + 2 * cosine[:, None] * facet
        down = np.minimum(away @ normal, 0)[:, None]
        seen, _ = rc.cast(things, SKY, begin, away - 2 * down * normal)
        total += weight[:, None] * (0.8 * seen + 0.2 * np.array(DEEP))
        weights += weight
    image = np.zeros((len(ray), 3))
    image[shows] = 255 * total / weights[:, None]
    return shows.reshape(SIZE[1], SIZE[0]), image.reshape(SIZE[1], SIZE[0], 3)


@pytest.mark.parametrize("variance, largest", ((0.0, 4.0), (0.0005, 8.0)), ids=("calm", "rough"))
def test_a_ray_caster_sees_the_same(variance, largest):
    """Rays that bounce off the pool and off a calm or rough fall see what the pool shows; the sky alone is far off."""
    errors = {}
    for is_on in (True, False):
        scene = Scene(is_on)
        if variance:
            scene.fall.GetWaterProperty().SetSlopeVariance(variance, variance, 0)
        seen = scene.picture()
        shows, truth = fall_by_rays(scene, variance)
        error = (seen - truth)[shows]
        errors[is_on] = float(np.sqrt((error**2).mean()))
        wt.save(np.where(shows[..., None], truth, seen).astype(int),
                wt.output_folder() / f"secondary_reflections_{variance}_truth.png")
        wt.save(seen, wt.output_folder() / f"secondary_reflections_{variance}_{is_on}.png")
    wt.check_at_least("pixels", int(shows.sum()), 500)
    wt.check_at_most("RMSE of 255", errors[True], largest)
    wt.check_at_least("RMSE without secondary reflections", errors[False], 4 * errors[True])


def add_second_fall(scene):
    return wt.add_water(scene.renderer, wt.plane((3.2, 1, 1), (-1, -0.6, -0.1)), (-2, 2, -2, 2), 0.8)


def add_box_beside(scene):
    added = vtkActor()
    added.SetMapper(scene.box.GetMapper())
    added.GetProperty().LightingOff()
    added.SetPosition(-3.5, 0, 0.4)
    scene.renderer.AddActor(added)


def test_an_observer_may_change_the_scene_in_a_secondary_view():
    """Props that come and go while the first of two secondary views is drawn do no harm; the next frame shows them."""
    scene, fresh = Scene(), Scene()
    for each in (scene, fresh):
        add_second_fall(each)
        each.behind.AddPosition(0.5, 0, 0.3)
    scene.picture()
    wt.check_equal("secondary views", scene.reflection.GetNumberOfSecondaryRenders(), 2)
    seen = []

    def change(*_):
        if not seen:
            seen.append(scene.renderer.GetActiveCamera() is scene.camera)
            scene.renderer.RemoveActor(scene.ball)
            add_box_beside(scene)

    scene.behind.GetMapper().AddObserver("StartEvent", change)  # the first that shows it is a secondary view
    scene.camera.SetPosition(1.3, -8, 2.6)
    fresh.camera.SetPosition(1.3, -8, 2.6)
    scene.picture()
    wt.check_equal("in the main view", seen, [False])
    fresh.renderer.RemoveActor(fresh.ball)
    add_box_beside(fresh)
    wt.check_equal("difference to a new scene", wt.difference(scene.picture(), fresh.picture()), 0)
    wt.check_equal("errors", wt.errors_of(scene.pool), [])


def test_the_time_of_secondary_views_counts():
    """The time of the mirrored view is with them, and so is what a time budget goes by."""
    scenes, times = [Scene(is_on) for is_on in (False, True)], ([], [])
    for scene in scenes:
        scene.behind.GetMapper().SetInputData(wt.sphere((-3, -12, 1.5), 4, 400))  # only a secondary view shows it
        scene.reflection.InstrumentationOn()
    for frame in range(15):
        for scene, ms in zip(scenes, times):
            scene.camera.Azimuth(0.5)
            scene.picture()
            ms.append(scene.reflection.GetLastReflectionTime())
    without, with_them = np.median(times[0][5:]), np.median(times[1][5:])
    wt.check_at_least("ms of the mirrored view, over that without secondary views", with_them / without, 2.0)
    reflection = scenes[1].reflection
    reflection.SetTimeBudget(1e-3)
    reflection.SetQualityToTimeBudget()
    for frame in range(24):
        scenes[1].camera.Azimuth(0.5)
        scenes[1].picture()
    wt.check_equal("texture scale when there is no time", reflection.GetTextureScaleInUse(), 0.25)

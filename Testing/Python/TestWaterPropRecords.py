# SPDX-License-Identifier: BSD-3-Clause
"""What is remembered of props from frame to frame is never out of date: random changes of props of every kind, picture
by picture equal to those of a renderer that remembers nothing and skips nothing.

The environment may ask for other walks: WATER_PROPS_SEED, a number; and for longer ones: WATER_PROPS_STEPS.
"""

import os

import numpy as np
import prop_changes
import prop_scene
import pytest
import water_test as wt
from vtkmodules.vtkCommonCore import vtkInformation
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer
from vtkwater import vtkWaterReflectionPass as Pass

LARGEST_ERROR = 1  # of 255
SEED = int(os.environ.get("WATER_PROPS_SEED", 1))
# another VTK takes all steps where WATER_TESTS_ONCE=0
STEPS = int(os.environ.get("WATER_PROPS_STEPS", 20 if os.environ.get("WATER_TESTS_ONCE") == "0" else 60))
# VTK itself cannot bear these of what it is drawing
NOT_IN_FRAMES = ("order", "removed", "replaced", "no mapper", "part removed or added")
OFTEN = {"nothing": 4, "time": 3, "camera": 3, "replaced": 2}


def changes(random, count):
    names = [name for name in prop_changes.CHANGES for _ in range(OFTEN.get(name, 1))]
    return [(names[random.integers(len(names))], random.random(8)) for _ in range(count)]


def in_the_frame(scene, name, numbers, when):
    """Renders a frame in whose middle a change comes."""
    teller = scene.volume.GetMapper() if when == "a draw" else scene.renderer
    done = []

    def change(caller, event):
        if not done:
            done.append(True)
            prop_changes.CHANGES[name](scene, numbers)

    tag = teller.AddObserver("VolumeMapperRenderEndEvent" if when == "a draw" else when, change)
    scene.view.window.Render()
    teller.RemoveObserver(tag)
    if not done:
        prop_changes.CHANGES[name](scene, numbers)


def compare(kept, fresh, step, name):
    fresh.renew()
    pictures = [scene.view.picture() for scene in (kept, fresh)]
    error = int(np.abs(pictures[0] - pictures[1]).max())
    if error > LARGEST_ERROR:
        print(f"  step {step}, {name}: {error}; {kept.water.GetReflectionPass().GetDecisionAsString()}")
        for picture, which in zip(pictures, ("kept", "fresh")):
            wt.save(picture, wt.output_folder() / f"props_{step}_{which}.png")
    return error


def scenes(has_assembly):
    return [prop_scene.Scene(skips, has_assembly) for skips in (Pass.SKIP_ALL, Pass.SKIP_NONE)]


def walk(seed, are_in_frames):
    print("seed", seed)
    random = np.random.default_rng(seed)
    kept, fresh = scenes(has_assembly=seed % 3 == 0)
    largest = compare(kept, fresh, -1, "the first picture")
    for step, (name, numbers) in enumerate(changes(random, STEPS)):
        when = ("StartEvent", "EndEvent", "a draw")[random.integers(3)]
        for scene in (kept, fresh):
            if are_in_frames and name not in NOT_IN_FRAMES:
                in_the_frame(scene, name, numbers, when)
            else:
                prop_changes.CHANGES[name](scene, numbers)
        largest = max(largest, compare(kept, fresh, step, name))
    return largest


@pytest.fixture(params=["software", "hardware"])
def ways(request, monkeypatch):
    """What is skipped where the processor draws, and where a GPU does: there props are asked while they are drawn."""
    monkeypatch.setenv("VTK_WATER_SOFTWARE", "0" if request.param == "hardware" else "1")


@pytest.mark.parametrize("seed", range(SEED + 1, SEED + 3))
def test_changes_between_frames_show(seed, ways):
    """A change of a prop shows in the next picture, whatever it is."""
    wt.check_at_most(f"seed {seed}: largest error of {STEPS} pictures", walk(seed, False), LARGEST_ERROR)


def test_changes_in_frames_show(ways):
    """So does one in the middle of a frame, in the next one."""
    wt.check_at_most(f"largest error of {STEPS} pictures", walk(SEED + 3, True), LARGEST_ERROR)


@pytest.mark.parametrize("name", prop_changes.CHANGES)
def test_every_change_shows_at_once(name):
    """Each kind of change, several times, after frames in which nothing changed."""
    random = np.random.default_rng(SEED)
    kept, fresh = scenes(has_assembly="part" in name)
    largest = 0
    for step in range(4):
        for _ in range(3):
            kept.view.window.Render()
        if "part" not in name:
            wt.check_equal("nothing has changed", kept.water.GetReflectionPass().GetDecision(), Pass.REUSED)
        numbers = random.random(8)
        for scene in (kept, fresh):
            prop_changes.CHANGES[name](scene, numbers)
        largest = max(largest, compare(kept, fresh, step, name))
    wt.check_at_most(f"{name}: largest error", largest, LARGEST_ERROR)


def test_props_are_drawn_in_any_order(on_a_gpu):
    """A culler that sorts, and props that are not drawn: changes show as ever."""
    random = np.random.default_rng(SEED)
    kept, fresh = scenes(has_assembly=False)
    for scene in (kept, fresh):
        culler = scene.renderer.GetCullers().GetLastItem()
        culler.SetSortingStyleToBackToFront()
        culler.SetMinimumCoverage(0.005)
    largest = 0
    for step, (name, numbers) in enumerate(changes(random, 40)):
        for scene in (kept, fresh):
            prop_changes.CHANGES[name](scene, numbers)
        largest = max(largest, compare(kept, fresh, step, name))
    wt.check_at_most("largest error of 40 pictures", largest, LARGEST_ERROR)


@pytest.mark.parametrize("seed", range(SEED + 1, SEED + 3))
def test_actors_that_are_asked_as_they_are_drawn(seed, on_a_gpu):
    """Where nothing keeps the mirrored view from the middle of the main one, each change of an actor shows."""
    random = np.random.default_rng(seed)
    kept, fresh = [prop_scene.Scene(skips, has_actors_alone=True) for skips in (Pass.SKIP_ALL, Pass.SKIP_NONE)]
    largest = compare(kept, fresh, -1, "the first picture")
    for step, (name, numbers) in enumerate(changes(random, STEPS)):
        if step % 3 == 0:
            kept.view.window.Render()
        for scene in (kept, fresh):
            prop_changes.CHANGES[name](scene, numbers)
        largest = max(largest, compare(kept, fresh, step, name))
    wt.check_at_most(f"seed {seed}: largest error of {STEPS} pictures", largest, LARGEST_ERROR)


def test_props_of_two_views_of_a_window(ways):
    """Another renderer of the window has the same props: both show what they show alone."""
    alone, shared = scenes(has_assembly=False)[0], scenes(has_assembly=False)[0]
    other = vtkRenderer()
    other.SetBackground(shared.renderer.GetBackground())
    for actor in shared.actors:
        other.AddActor(actor)
    shared.renderer.SetViewport(0, 0, 0.5, 1)
    alone.renderer.SetViewport(0, 0, 0.5, 1)
    other.SetViewport(0.5, 0, 1, 1)
    other.SetActiveCamera(shared.renderer.GetActiveCamera())
    shared.view.window.AddRenderer(other)
    largest = 0
    random = np.random.default_rng(SEED + 1)
    for name, numbers in changes(random, 30):
        for scene in (alone, shared):
            prop_changes.CHANGES[name](scene, numbers)
        half = prop_scene.SIZE[0] // 2
        error = np.abs(alone.view.picture()[:, :half] - shared.view.picture()[:, :half]).max()
        largest = max(largest, int(error))
    wt.check_at_most("largest error of 30 pictures", largest, LARGEST_ERROR)


def test_data_in_pieces(ways):
    """A mapper that draws its data piece by piece is reflected piece by piece, and so are two with a piece of each."""
    pictures = []
    for pieces, mappers in ((1, 1), (3, 1), (1, 2)):
        scene = prop_scene.Scene(Pass.SKIP_ALL)
        mapper = scene.actors[6].GetMapper()
        mapper.SetNumberOfSubPieces(pieces)
        for piece in range(1, mappers):
            other, further = vtkPolyDataMapper(), vtkActor()
            other.ShallowCopy(mapper)
            further.ShallowCopy(scene.actors[6])
            further.SetMapper(other)
            scene.renderer.AddActor(further)
            for number, each in enumerate((mapper, other)):
                each.SetNumberOfPieces(mappers)
                each.SetPiece(number)
        for turn in range(3):
            scene.renderer.GetActiveCamera().Azimuth(2)
            picture = scene.view.picture()
        pictures.append(picture)
    for picture in pictures[1:]:
        wt.check_at_most("difference of a pixel", int(np.abs(pictures[0] - picture).max()), LARGEST_ERROR)


def test_data_that_an_observer_of_the_draw_makes(ways):
    """What a mapper's observer changes as a draw begins is drawn by that draw, in a mirrored view before the main one,
    too."""
    pictures = []
    for is_observed in (False, True):
        scene = prop_scene.Scene(Pass.SKIP_ALL & ~Pass.HIDDEN_WATER & ~Pass.PIXELS)  # nothing to wait for
        ball, mapper = scene.pipelines[0].ball, scene.actors[6].GetMapper()
        scene.view.window.Render()
        scene.view.window.Render()
        if is_observed:
            mapper.AddObserver("StartEvent", lambda caller, event, ball=ball: ball.SetRadius(0.9))
        else:
            ball.SetRadius(0.9)
        scene.camera.SetPosition(1.3, -15, 4)
        pictures.append(scene.view.picture())
    wt.check_at_most("difference of a pixel", int(np.abs(pictures[0] - pictures[1]).max()), LARGEST_ERROR)


def test_what_is_set_for_a_draw_is_taken_back(ways):
    """Mappers are static and actors forced to be opaque as the user says, in frames that reflect them, too."""
    scene = prop_scene.Scene(Pass.SKIP_ALL)
    first, second = scene.actors[:2]
    first.GetMapper().SetStatic(True)
    second.SetForceOpaque(True)
    for _ in range(3):
        scene.renderer.GetActiveCamera().Azimuth(2)
        scene.view.window.Render()
    wt.check_equal("reflected in the last frame", scene.water.GetReflectionPass().GetDecision(), Pass.RENDERED)
    wt.check_equal("static mappers", [bool(actor.GetMapper().GetStatic()) for actor in scene.actors[:6]],
                   [True] + 5 * [False])
    wt.check_equal("actors forced to be opaque", [bool(actor.GetForceOpaque()) for actor in scene.actors[:6]],
                   [False, True] + 4 * [False])


def test_a_mapper_that_goes_while_it_is_drawn(ways):
    """The user's observer puts another mapper in the place of the one that is being drawn, which is gone then."""
    scene = prop_scene.Scene(Pass.SKIP_ALL)
    actor = scene.actors[0]
    scene.view.window.Render()
    draws = []

    def replace(caller, event):
        draws.append(True)
        if len(draws) == 4:  # of the second frame, the mirrored or the main view
            actor.SetMapper(vtkPolyDataMapper())

    actor.GetMapper().AddObserver("EndEvent", replace)
    for _ in range(4):
        scene.renderer.GetActiveCamera().Azimuth(2)
        scene.view.window.Render()
    wt.check_equal("the actor's new mapper is not static", bool(actor.GetMapper().GetStatic()), False)


def test_nothing_is_left_on_props():
    """After a frame plain actors have no keys, and keys of the user's that were added in it stay, alone."""
    scene = prop_scene.Scene(Pass.SKIP_ALL)
    scene.view.window.Render()
    wt.check_equal("plain actors with keys after a frame",
                   sum(actor.GetPropertyKeys() is not None for actor in scene.actors[:8]), 0)
    actor = scene.actors[0]

    def add(caller, event):
        actor.GetPropertyKeys().Set(Pass.NOT_REFLECTED(), 1)

    tag = actor.GetMapper().AddObserver("StartEvent", add)
    scene.view.window.Render()
    actor.GetMapper().RemoveObserver(tag)
    wt.check_equal("the user's key after the frame", actor.GetPropertyKeys().Get(Pass.NOT_REFLECTED()), 1)
    text = str(actor.GetPropertyKeys())
    wt.check_equal("keys of ours beside it", "RenderPasses" in text or "RENDER_PASSES" in text, False)


def test_keys_that_are_kept_lose_ours():
    """Whoever takes a prop's keys in the middle of a frame keeps them without ours."""
    scene = prop_scene.Scene(Pass.SKIP_ALL)
    actor, kept = scene.actors[0], []
    other = vtkInformation()

    def take(caller, event):
        if not kept:
            kept.append(actor.GetPropertyKeys())
            actor.SetPropertyKeys(other)

    actor.GetMapper().AddObserver("StartEvent", take)
    scene.view.window.Render()
    scene.view.window.Render()
    wt.check_equal("the prop's keys are those that the user gave", actor.GetPropertyKeys() is other, True)


def test_props_die_with_their_last_reference():
    """Nothing is held between frames."""
    scene = prop_scene.Scene(Pass.SKIP_ALL)
    scene.view.window.Render()
    gone = []
    actor = scene.actors.pop(3)
    actor.AddObserver("DeleteEvent", lambda caller, event: gone.append(True))
    scene.renderer.RemoveViewProp(actor)
    del actor
    wt.check_equal("a removed prop is gone", gone, [True])
    wt.check_at_least("and the next frame is rendered", scene.view.picture().max(), 1)

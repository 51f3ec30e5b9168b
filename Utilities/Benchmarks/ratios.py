# SPDX-License-Identifier: BSD-3-Clause
"""ratios: what water costs on the terrain: unchanged, not seen, waves, presets, many lakes."""

import geometry
import kinds
import numpy as np
import scenes
import water_test as wt
from report import table
from timing import Frame, measure
from vtkmodules.vtkFiltersSources import vtkPlaneSource

SIZE = (800, 600)
ROUNDS, QUICK_ROUNDS = 60, 9
BUDGET_S, QUICK_BUDGET_S = 40.0, 3.0  # a group
TIER = 0.02  # units between the levels of the lakes
SHEET_OPACITY = 0.5
PRESETS = ("lake", "ocean wind 5")
MOVING, STILL = "presets, everything moves", "presets, only time moves"
HIDDEN = 6  # cells of the elevation model that the hidden water is wide to each side

TEXT = """
Ratios of medians on the terrain, $width x $height pixels, each kind of frame in its own window. In the first group,
scene and camera are still; only the time of the waves changes. Sheet: a plain plane at the water's level with an
opacity of $opacity. Hidden water lies inside a mountain. Water that faces away has backface culling and is seen from
its culled side. The benchmark checks that water not seen changes no pixel. Of eight lakes at eight levels, two are in view.

$tables
"""


def terrain(has_water=True, **changes):
    kind = scenes.kinds(True)["terrain"]
    return scenes.Scene(scenes.Kind(**{**vars(kind), **changes}), SIZE, has_water)


def compare(results, title, frames, checks):
    """Measures a group of frames. checks: (of what, over what, limit). Returns the table."""
    measure(
        frames,
        results.rounds(ROUNDS, QUICK_ROUNDS),
        QUICK_BUDGET_S if results.is_quick else BUDGET_S,
    )
    by_name = {frame.name: frame for frame in frames}
    for frame in frames:
        results.row("ratios", title, frame.name, **frame.row, ratio=frame.median / frames[0].median)
    for what, over, limit in checks:
        name = f"{title}: {what} / {over}"
        ratio = by_name[what].median / by_name[over].median
        if limit:
            results.check_at_most(name, ratio, limit)
        else:
            print(f"{name}: {ratio:.3f}", flush=True)
    return f"**{title}**, medians of {len(frames[0].times)} frames of each kind\n\n" + table(
        ("frame", "ms", f"/ {frames[0].name}"),
        [(frame.name, str(frame), f"{frame.median / frames[0].median:.3f}") for frame in frames],
    )


def _add_sheet(scene):
    low_x, high_x, low_y, high_y = scene.kind.sheet
    source = vtkPlaneSource()
    source.SetOrigin(low_x, low_y, 0)
    source.SetPoint1(high_x, low_y, 0)
    source.SetPoint2(low_x, high_y, 0)
    source.Update()
    actor = scene.add(source.GetOutput(), (0.1, 0.3, 0.5))
    actor.GetProperty().SetOpacity(SHEET_OPACITY)


def _static(results):
    plain, sheet, calm, traced = terrain(False), terrain(False), terrain(), terrain()
    _add_sheet(sheet)
    kinds.CALM.apply(calm.water, 1, {})
    kinds.TRACED.apply(traced.water, 1, {})
    frames = [
        Frame(name, scene.window, scene.pass_time)
        for name, scene in (
            ("no water", plain),
            ("sheet", sheet),
            ("calm water", calm),
            ("RAY_TRACED on waves", traced),
        )
    ]
    return compare(
        results,
        "nothing changes but time",
        frames,
        (
            ("calm water", "sheet", 1.10),
            ("RAY_TRACED on waves", "sheet", 1.30),
            ("calm water", "no water", None),
        ),
    )


def inside_a_mountain(scene):
    """Bounds of a sheet that the ground covers, in the middle of the view."""
    x, y, metres = geometry.elevation()
    height = metres - scenes.LEVEL / geometry.METRES
    lowest = np.min(
        [
            np.roll(height, (i, j), (0, 1))
            for i in range(-HIDDEN, HIDDEN + 1, 2)
            for j in range(-HIDDEN, HIDDEN + 1, 2)
        ],
        axis=0,
    )
    east, north = np.meshgrid(x, y)
    eye = np.array(scene.kind.eye)
    ahead = np.array(scene.kind.target) - eye
    away = np.stack([east - eye[0], north - eye[1]], axis=-1)
    distance = np.linalg.norm(away, axis=-1)
    cosine = away @ ahead[:2] / np.maximum(distance * np.linalg.norm(ahead[:2]), 1e-9)
    is_there = (cosine > np.cos(np.radians(10))) & (distance > 20) & (distance < 80)
    row, column = np.unravel_index(np.argmax(np.where(is_there, lowest, -np.inf)), lowest.shape)
    half_x, half_y = (0.5 * HIDDEN * (axis[1] - axis[0]) for axis in (x, y))
    return (x[column] - half_x, x[column] + half_x, y[row] - half_y, y[row] + half_y)


def behind_the_eye(scene):
    return (
        scene.kind.eye[0] + 5,
        scene.kind.eye[0] + 15,
        scene.kind.eye[1] - 5,
        scene.kind.eye[1] + 5,
    )


def _unseen(results):
    plain, outside, hidden, away = terrain(False), terrain(), terrain(), terrain()
    outside.water.SetSheetBounds(*behind_the_eye(outside))
    hidden.water.SetSheetBounds(*inside_a_mountain(hidden))
    away.water.SetPlane(wt.plane((0, 0, 0), (0, 0, -1)))
    away.water.GetProperty().BackfaceCullingOn()
    names = {"outside of the view": outside, "hidden by the ground": hidden, "facing away": away}
    for name, scene in names.items():
        apart = int((plain.view.picture() != scene.view.picture()).any(axis=2).sum())
        results.check_at_most(f"water not seen: pixels that change, {name}", apart, 0, 0)
    frames = [
        Frame("no water", plain.window, plain.step),
        *(Frame(name, scene.window, scene.step) for name, scene in names.items()),
    ]
    return compare(results, "water not seen", frames, [(name, "no water", 1.02) for name in names])


def _lookups(results):
    scene_of = {step.name: terrain() for step in (kinds.CALM, kinds.FIXED, kinds.TRACED)}
    for step in (kinds.CALM, kinds.FIXED, kinds.TRACED):
        step.apply(scene_of[step.name].water, 1, {kinds.FIXED.formula: 0.2})
    frames = [Frame(name, scene.window, scene.step) for name, scene in scene_of.items()]
    return compare(
        results, "everything moves", frames, ((kinds.TRACED.name, kinds.FIXED.name, 1.3),)
    )


def _presets(results):
    """The presets at their own units: one of the scene is a metre."""
    scene_of = {"no water": terrain(False), **{name: terrain() for name in PRESETS}}
    for name in PRESETS:
        scene_of[name].water.GetWaterProperty().SetPreset(name)
    return "\n\n".join(
        compare(
            results,
            title,
            [
                Frame(name, scene.window, scene.step if title == MOVING else scene.pass_time)
                for name, scene in scene_of.items()
            ],
            [(name, "no water", limit) for name in PRESETS],
        )
        for title, limit in ((MOVING, 1.9), (STILL, 1.5))
    )


def _own_view(results):
    """Clear water that sees what lies below it in the picture, or in a view of its own."""

    def clear(has_own_view):
        scene = terrain()
        look = scene.water.GetWaterProperty()
        look.SetPreset("lake")
        look.SetRefractionSource(look.OWN_VIEW if has_own_view else look.PICTURE)
        return scene

    scene_of = {"no water": terrain(False), "lake, picture": clear(False), "lake, own view": clear(True)}
    return "\n\n".join(
        compare(
            results,
            title,
            [
                Frame(name, scene.window, scene.step if is_moving else scene.pass_time)
                for name, scene in scene_of.items()
            ],
            [("lake, own view", "lake, picture", limit)],
        )
        for title, is_moving, limit in (("own view, everything moves", True, 1.35),
                                        ("own view, only time moves", False, 1.1))
    )


def _lakes(results):
    def lakes(count):
        """The first two in view, the others behind the eye and far beside it."""
        scene = terrain(False)
        (x, y), waters = scene.kind.eye[:2], []
        sheets = [(-10, 20, -30, 40), (20, 40, -30, 40)]
        sheets += [(x + 4 + 6 * i, x + 9 + 6 * i, y - 4, y + 4) for i in range(3)]
        sheets += [(x - 2, x + 2, y + 20 + 6 * i, y + 25 + 6 * i) for i in range(3)]
        for i, sheet in enumerate(sheets[:count]):
            water = scene.add_water(sheet)
            water.SetLevel(TIER * i)
            waters.append(water)
        return scene, waters

    (two, _), (eight, waters) = lakes(2), lakes(8)
    eight.view.picture()
    renders = [water.GetReflectionPass().GetNumberOfReflectionRenders() for water in waters]
    print(f"lakes: mirrored views {renders} in one frame")
    frames = [
        Frame(name, scene.window, scene.step)
        for name, scene in (("two lakes", two), ("eight lakes", eight))
    ]
    return compare(
        results, "lakes at different levels", frames, (("eight lakes", "two lakes", 1.1),)
    )


def run(results):
    tables = [part(results) for part in (_static, _unseen, _lookups, _presets, _own_view, _lakes)]
    results.add(
        "Ratios",
        TEXT,
        width=SIZE[0],
        height=SIZE[1],
        opacity=SHEET_OPACITY,
        tables="\n\n".join(tables),
    )

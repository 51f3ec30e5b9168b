# SPDX-License-Identifier: BSD-3-Clause
"""bound: a moving camera, and what a frame with water costs at least when all is drawn anew."""

import instruments
import kinds
import water_test as wt
from ratios import compare, terrain
from report import table
from timing import Frame

SCALES = (1.0, 0.5)
TINY = 0.01  # of the window, the viewport in which only the geometry costs
LIMITS = {
    ("bare terrain", 1.0): 1.6,
    ("terrain and 1,000 props", 1.0): 1.55,
    ("bare terrain", 0.5): 1.45,
}
BOUND_LIMIT = 1.15
CLOCKS = {"median": "frame", "work": "CPU"}
PROPS = (1000, (0, -20, 0.3), (30, 25, 3.0), 0.3)

TEXT = """
The camera moves; calm water. The bound is 1 + (g V + f s^2 F) / (V + F) + f c. V is the time of the frame's geometry,
measured in a viewport of $tiny of the window's width and height; F is the rest of the frame without water; f is the
water's share of the picture. g is the share of the geometry that the mirrored view draws: for the part of V that
the bare terrain takes, the share of the terrain's triangles; for the part that the props add, the share of the props.
s is the texture scale. f c is the surface's own time relative to that of the frame, measured with the same water and a
still camera, when no mirrored view is drawn.
The bound is given twice: for the time of the frame, and for its CPU time in all threads. They differ because the
mirrored view waits for the picture that determines its visible part.

$tables

$bounds
"""


def _scene(has_props, has_water=True):
    scene = terrain(has_water)
    if has_props:
        scene.add_things(*PROPS)
    return scene


def _triangles(scene):
    return sum(
        actor.GetMapper().GetInput().GetNumberOfCells()
        for actor in scene.renderer.GetActors()
        if not actor.IsA("vtkWaterActor")
    )


def _mirrored_shares(scene):
    """Of all triangles, and of the props beside the terrain, how many the mirrored view draws."""
    instruments.turn_on(scene.water)
    scene.stand(0)
    scene.view.picture()
    said = instruments.read(scene.water)
    instruments.turn_on(scene.water, False)
    beside = scene.renderer.GetActors().GetNumberOfItems() - 2
    return (
        said["triangles"] / _triangles(scene),
        (said["props"] - 1) / beside if beside > 0 else 0.0,
    )


def _measure(results, name, has_props, terrain_v):
    """terrain_v: V of the bare terrain, by clock; is set for it."""
    plain, geometry = _scene(has_props, False), _scene(has_props, False)
    geometry.renderer.SetViewport(0, 0, TINY, TINY)
    still = _scene(has_props)
    kinds.CALM.apply(still.water, 1.0, {})
    waters = {scale: _scene(has_props) for scale in SCALES}
    for scale, scene in waters.items():
        kinds.CALM.apply(scene.water, scale, {})
    frames = [
        Frame("no water", plain.window, plain.step),
        Frame("geometry", geometry.window, geometry.step),
        Frame("calm water, nothing changes", still.window, still.pass_time),
        *(
            Frame(f"calm water, scale {scale:g}", scene.window, scene.step)
            for scale, scene in waters.items()
        ),
    ]
    shown = compare(
        results,
        name,
        frames,
        [
            (f"calm water, scale {scale:g}", "no water", LIMITS.get((name, scale)))
            for scale in SCALES
        ],
    )
    f_share = float(wt.water_mask(waters[1.0].view, waters[1.0].water).mean())
    rows = []
    for (scale, scene), frame in zip(waters.items(), frames[3:]):
        of_triangles, of_props = _mirrored_shares(scene)
        for clock, limit in (("median", BOUND_LIMIT), ("work", None)):
            whole, only_geometry, surface, measured = (
                getattr(one, clock) for one in (*frames[:3], frame)
            )
            v = min(only_geometry, whole)
            if not has_props:
                terrain_v[clock] = v
            of_terrain = min(terrain_v[clock] / v, 1.0)
            g = of_terrain * of_triangles + (1.0 - of_terrain) * of_props
            cost = max(surface - whole, 0) / whole
            bound = 1 + (g * v + f_share * scale**2 * (whole - v)) / whole + cost
            ratio = measured / whole
            of = CLOCKS[clock]
            title = f"{name}, scale {scale:g}, {of}: ratio / bound"
            if limit and scale == 1.0:
                results.check_at_most(title, ratio / bound, limit)
            else:
                print(f"{title}: {ratio / bound:.3f}", flush=True)
            results.row(
                "bound",
                name,
                f"scale {scale:g}",
                clock=of,
                scale=scale,
                V_ms=v,
                F_ms=whole - v,
                g=g,
                f=f_share,
                f_c=cost,
                bound=bound,
                ratio=ratio,
            )
            rows.append(
                (
                    name,
                    f"{scale:g}",
                    of,
                    f"{v:.2f}",
                    f"{whole - v:.2f}",
                    f"{g:.2f}",
                    f"{f_share:.2f}",
                    f"{cost:.3f}",
                    f"{bound:.2f}",
                    f"{ratio:.2f}",
                    f"{ratio / bound:.2f}",
                )
            )
    return shown, rows


def run(results):
    tables, rows, terrain_v = [], [], {}
    for name, has_props in (("bare terrain", False), ("terrain and 1,000 props", True)):
        shown, found = _measure(results, name, has_props, terrain_v)
        tables.append(shown)
        rows += found
    header = (
        "scene",
        "s",
        "time of",
        "V, ms",
        "F, ms",
        "g",
        "f",
        "f c",
        "bound",
        "measured",
        "measured / bound",
    )
    results.add(
        "Moving camera: the theoretical bound",
        TEXT,
        tiny=TINY,
        tables="\n\n".join(tables),
        bounds=table(header, rows),
    )

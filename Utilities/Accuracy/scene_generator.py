# SPDX-License-Identifier: BSD-3-Clause
"""scene_generator: makes a scene with water from a seed, and nothing else.

    scene = make(7)
    scene.made      the view (water_test.View): unlit actors, a camera, a water surface
    scene.water     its vtkWaterActor, a perfect mirror: a level, flat sheet with the waves' normals
    scene.waves     amplitude, wavelength, direction and phase of each wave
    scene.origin    the origin of the water's plane: waves and sheet count from there
    scene.sheet     half the width of the sheet
    scene.has_dome  whether no ray may see the background
    scene.facts     what was drawn, by name, for tables

All numbers come from one generator of the seed: a scene is the same whatever other scenes are made.
Lengths are shares of the reach, the distance from the eye to where it looks, so that scenes of
every size are alike. Geometry is made of triangles, in double precision: who traces them sees what
VTK draws.

No colour of a scene has more blue than green, nor has any mixture of them. The background behind a dome
is magenta: a pixel that is bluer than green has seen it (see BACKGROUND).
"""

import dataclasses

import numpy as np
import ray_caster
import scene_shapes as shapes
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkCamera

SIZE = (400, 300)
BACKGROUND = (1.0, 0.0, 1.0)  # behind a dome: no ray may see it
PROBES = (24, 18)  # rays that look how much water there is
LEAST_WATER = 0.05  # share of the picture
LEAST_THINGS = 0.05  # share of the picture that is a thing, or calm water that reflects one
TRIES = 200
LEAST_PARALLEL_ELEVATION = 5.0  # degrees; what a flatter beam sees is too long for one scene
DOME = (50.0, 60e3)  # m
NEAR = (1e-3, 10.0)  # m
LEAST_NEAR = 3e-4  # of the reach: 24 bits of depth then part what is 1/5000 of the reach apart
MOST_DOME = 4e5  # of the near plane: VTK, in single precision, cuts off what is farther, before the far plane


@dataclasses.dataclass
class Scene:
    seed: int
    made: wt.View
    water: object
    waves: tuple
    origin: np.ndarray
    sheet: float
    facts: dict

    @property
    def has_dome(self):
        return self.facts["dome"] > 0

    def rays(self, size, shift):
        """Rays through a place of each pixel (0 to 1), counted from the origin, from the near plane on: VTK draws
        nothing before it."""
        camera = self.made.renderer.GetActiveCamera()
        x, y = np.meshgrid(*((np.arange(count) + part) / count * 2 - 1 for count, part in zip(size, shift)))
        start, ray = ray_caster.rays_at(camera, size, x.ravel(), y.ravel())
        ahead = np.array(camera.GetDirectionOfProjection())
        near = camera.GetClippingRange()[0]
        return start - self.origin + (near / (ray @ ahead))[:, None] * ray, ray

    def meet_water(self, start, ray, distance):
        """Whether rays meet the water before a distance, and where."""
        with np.errstate(divide="ignore", invalid="ignore"):
            way = np.where((ray[:, 2] < 0) & (start[:, 2] > 0), -start[:, 2] / ray[:, 2], np.inf)
        is_water = way < distance
        place = start + np.where(is_water, way, 0)[:, None] * ray
        place[:, 2] = 0
        return is_water & (np.abs(place[:, :2]) < self.sheet).all(axis=1), place


def make(seed, size=SIZE, kind=None):
    """The scene of a seed: the first of its stream in which enough is seen. kind: Draft, or one of its classes."""
    random = np.random.default_rng(seed)
    for tries in range(1, TRIES + 1):
        draft = (kind or Draft)(random, size)
        if draft.is_good():
            return draft.scene(seed, tries)
    raise RuntimeError(f"seed {seed}: nothing to see in {TRIES} tries")


def log_uniform(random, low, high):
    return float(np.exp(random.uniform(np.log(low), np.log(high))))


def any_color(random):
    """A colour in whole 255ths, not bluer than green."""
    red, green, other = random.integers(15, 256, 3)
    return tuple(float(each) / 255 for each in (red, max(green, other), min(green, other)))


class Draft:
    """All that is drawn at random for one scene, before it is known what is seen in it."""

    REACH = (0.5, 500.0)  # m
    ELEVATION = (1.0, 85.0)  # degrees
    TERRAINS, DOMES = 0.7, 0.6  # shares of the scenes that have one

    def __init__(self, random, size):
        self.size = size
        self.reach = log_uniform(random, *self.REACH)
        self.camera = self._camera(random)
        self.terrain = self._terrain(random) if random.random() < self.TERRAINS else None
        self.things = [self._thing(random) for _ in range(random.integers(5, 25))]
        self.is_dome = random.random() < self.DOMES
        self.sky = any_color(random), any_color(random), any_color(random)
        self.waves = self._waves(random)
        self.origin = self._origin(random)
        self._shares = random.random(3)

    def _camera(self, random):
        is_parallel = random.random() < 0.15
        elevation = log_uniform(random, LEAST_PARALLEL_ELEVATION if is_parallel else self.ELEVATION[0], self.ELEVATION[1])
        angle = random.uniform(20, 75)
        center = random.uniform(-0.5, 0.5, 2) if random.random() < 0.2 else np.zeros(2)
        roll = random.uniform(-15, 15) if random.random() < 0.2 else 0.0
        heading = random.uniform(0, 2 * np.pi)
        height = random.uniform(0, 0.1) * self.reach
        scale = self.reach * np.tan(np.radians(angle) / 2)
        # a parallel beam begins behind all the water that it sees
        distance = self.reach + (3 * scale / np.tan(np.radians(elevation)) if is_parallel else 0)
        target = np.array((0, 0, 0.0 if is_parallel else height * np.sin(np.radians(elevation))))
        flat = np.cos(np.radians(elevation))
        position = distance * np.array(
            (flat * np.cos(heading), flat * np.sin(heading), np.sin(np.radians(elevation))))
        return {"position": position, "target": target, "angle": angle,
                "scale": scale, "is_parallel": is_parallel, "center": center, "roll": roll, "elevation": elevation}

    def _terrain(self, random):
        """A height field: a sum of cosines, rougher or smoother, whose border is drawn down or not."""
        count = int(random.integers(24, 97))
        width = self.reach * random.uniform(1, 5)
        height = self.reach * random.uniform(0.02, 0.25)
        level = random.uniform(-0.9, 0.4) * height
        center = self.reach * random.uniform(-1.0, 1.0, 2)
        x, y = np.meshgrid(np.linspace(-0.5, 0.5, count), np.linspace(-0.5, 0.5, count), indexing="ij")
        field = np.zeros_like(x)
        for number in random.uniform(1, 9, 12):
            turn, phase = random.uniform(0, 2 * np.pi, 2)
            field += np.cos(2 * np.pi * number * (x * np.cos(turn) + y * np.sin(turn)) + phase) / number
        field /= np.abs(field).max()
        is_island = random.random() < 0.5
        if is_island:
            field = (1 + field) * np.maximum(1 - 4 * (x**2 + y**2), 0) - 0.5
        points = np.stack([center[0] + width * x, center[1] + width * y, level + height * field], axis=-1)
        low, high = np.array(any_color(random)), np.array(any_color(random))
        share = ((field - field.min()) / np.ptp(field))[..., None]
        return shapes.surface(points), low + share * (high - low)

    def _thing(self, random):
        """Data and colour of a thing that stands in the water, floats or hangs over it."""
        shape = shapes.NAMES[random.integers(len(shapes.NAMES))]
        size = self.reach * log_uniform(random, 0.02, 0.2)
        data = shapes.SHAPES[shape](random, size)
        if shape not in ("pole", "half cylinder", "standing plane") or random.random() < 0.3:
            data = shapes.turned(data, random.uniform(-0.5, 0.5, 2), random.uniform(0, 2 * np.pi))
        else:
            data = shapes.turned(data, (0, 0), random.uniform(0, 2 * np.pi))
        low, high = data.GetBounds()[4:]
        place = {"stands": random.uniform(-0.5, -0.05) * (high - low), "floats": random.uniform(-0.02, 0.02) * size,
                 "hangs": random.uniform(0.05, 2) * size}
        where = list(place)[random.integers(len(place))]
        away = self.reach * (0.9 * random.random() if random.random() < 0.7 else 1.5 * np.sqrt(random.random()))
        turn = random.uniform(0, 2 * np.pi)
        data = wt.moved(data, (away * np.cos(turn), away * np.sin(turn), place[where] - low))
        return data, any_color(random)

    def _settle(self):
        """What depends on the things: near plane, dome and sheet. False: the eye is too close to one."""
        low, high = self._near_range()
        if high < low:
            return False
        near, dome, sheet = self._shares
        self.near = _between(low, high, near)
        distance = np.linalg.norm(self.camera["position"])
        farthest = 500 * self.reach if self.camera["is_parallel"] else MOST_DOME * self.near
        least = max(DOME[0], 4 * distance)
        self.radius = _between(least, max(min(DOME[1], farthest), least), dome)
        widest = 0.65 * self.radius if self.is_dome else 100 * self.reach
        self.sheet = _between(min(2 * (distance + self.reach), 0.5 * widest), widest, sheet)
        return True

    def _waves(self, random):
        count = int(random.integers(0, 5))
        slope = log_uniform(random, 0.02, 0.2)  # rms, of all waves together
        parts = random.uniform(0.3, 1, count)
        parts *= slope / np.linalg.norm(parts) if count else 1
        found = []
        for part in parts:
            wavelength = self.reach * log_uniform(random, 0.02, 1)
            direction, phase = random.uniform(0, 360, 2)
            amplitude = float(np.sqrt(2) * part * wavelength / (2 * np.pi))
            found.append((amplitude, wavelength, float(direction), float(phase)))
        return tuple(found)

    def _origin(self, random):
        """Far away in one scene of three, but so that single precision still knows places to a pixel's part."""
        farthest = min(1e3, 300 * self.reach)
        offset = random.uniform(-1, 1, 3) * log_uniform(random, 0.1 * self.reach, farthest)
        return offset if random.random() < 0.35 else np.zeros(3)

    def _all(self):
        return [data for data, _ in self.things] + ([self.terrain[0]] if self.terrain else [])

    def is_good(self):
        """Whether the eye is over the water, can have a near plane before all things, and sees enough of both."""
        locator, self._closest = self._locator()
        if not self._settle():
            return False
        camera = vtkCamera()
        self.place_camera(camera, np.zeros(3))
        x, y = np.meshgrid(*((np.arange(count) + 0.5) / count * 2 - 1 for count in PROBES))
        start, ray = ray_caster.rays_at(camera, self.size, x.ravel(), y.ravel())
        water = things = 0
        for one in zip(start, ray):
            sees_water, sees_thing = self._probe(locator, *one)
            water += sees_water
            things += sees_thing
        return water >= LEAST_WATER * len(ray) and things >= LEAST_THINGS * len(ray)

    def _probe(self, locator, start, ray):
        """Whether a ray meets water, and whether it or what calm water makes of it meets a thing."""
        far = self._far()
        if ray[2] >= 0 or start[2] <= 0:
            return False, _is_cut(locator, start, start + far * ray)
        end = start - start[2] / ray[2] * ray
        if _is_cut(locator, start, end):
            return False, True
        if np.abs(end[:2]).max() > self.sheet:
            return False, False
        return True, _is_cut(locator, end, end + far * self._beyond(ray))

    def _beyond(self, ray):
        """Where a ray goes on from calm water."""
        return ray * (1, 1, -1)

    def _locator(self):
        """Of all things; and the distance from the eye to the closest of them and the water."""
        together = vtkAppendPolyData()
        together.SetOutputPointsPrecision(1)
        for data in self._all():
            together.AddInputData(data)
        together.Update()
        locator = vtkStaticCellLocator()
        locator.SetDataSet(together.GetOutput())
        locator.BuildLocator()
        place, cell, part, squared = np.zeros(3), mutable(0), mutable(0), mutable(0.0)
        locator.FindClosestPoint(self.camera["position"], place, cell, part, squared)
        closest = min(float(squared) ** 0.5, self.camera["position"][2])
        return locator, closest

    def _near_range(self):
        if self.camera["is_parallel"]:
            return NEAR[0], min(NEAR[1], 0.1 * self.reach)
        return max(NEAR[0], LEAST_NEAR * self.reach), min(NEAR[1], 0.6 * self._closest)

    def place_camera(self, camera, origin):
        facts = self.camera
        camera.SetPosition(facts["position"] + origin)
        camera.SetFocalPoint(facts["target"] + origin)
        camera.SetViewUp(0, 0, 1)
        camera.SetViewAngle(facts["angle"])
        camera.SetParallelProjection(facts["is_parallel"])
        camera.SetParallelScale(facts["scale"])
        camera.SetWindowCenter(*facts["center"])
        camera.Roll(facts["roll"])
        camera.SetClippingRange(self.near, self._far())

    def _far(self):
        """Behind everything, in any direction."""
        farthest = max(np.sqrt(2) * self.sheet, self.radius if self.is_dome else 0,
                       *(_radius(data) for data in self._all()))
        return 2 * (np.linalg.norm(self.camera["position"]) + farthest)

    def scene(self, seed, tries):
        made = wt.View(self.size, BACKGROUND if self.is_dome else self.sky[0])
        for data, color in self.things:
            wt.add_actor(made.renderer, wt.moved(data, self.origin), color, lit=False)
        if self.terrain:
            _add_colored(made.renderer, wt.moved(self.terrain[0], self.origin), self.terrain[1].reshape(-1, 3))
        if self.is_dome:
            data, colors = self._dome()
            _add_colored(made.renderer, wt.moved(data, self.origin), colors)
        water = wt.add_water(made.renderer, wt.plane(self.origin, (0, 0, 1)), (-self.sheet, self.sheet) * 2,
                             reflectance=1.0)
        for wave in self.waves:
            water.GetWaterProperty().AddWave(*wave)
        self.place_camera(made.renderer.GetActiveCamera(), self.origin)
        return Scene(seed, made, water, self.waves, self.origin, self.sheet, self._facts(made, tries))

    def _dome(self):
        """A sphere around everything: a gradient from the horizon to the zenith, and another one below."""
        source = vtkSphereSource()
        source.SetRadius(self.radius)
        source.SetThetaResolution(64)
        source.SetPhiResolution(48)
        source.SetOutputPointsPrecision(1)
        data = shapes.triangles(source)
        height = vtk_to_numpy(data.GetPoints().GetData())[:, 2:] / self.radius
        horizon, zenith, ground = (np.array(color) for color in self.sky)
        share = np.sqrt(np.abs(height))
        return data, horizon + share * (np.where(height > 0, zenith, ground) - horizon)

    def _facts(self, made, tries):
        camera = made.renderer.GetActiveCamera()
        slopes = [np.sqrt(0.5) * 2 * np.pi * amplitude / length for amplitude, length, _, _ in self.waves]
        return {
            "reach": self.reach, "elevation": self.camera["elevation"], "near": camera.GetClippingRange()[0],
            "far": camera.GetClippingRange()[1], "parallel": self.camera["is_parallel"],
            "off axis": bool(np.any(self.camera["center"])), "dome": self.radius if self.is_dome else 0.0,
            "things": len(self.things), "terrain": self.terrain is not None, "waves": len(self.waves),
            "slope": float(np.linalg.norm(slopes)) if slopes else 0.0, "offset": float(np.linalg.norm(self.origin)),
            "sheet": self.sheet, "tries": tries}


def _between(low, high, share):
    return float(low * (high / low) ** share)


def _radius(data):
    bounds = np.array(data.GetBounds()).reshape(3, 2)
    return float(np.linalg.norm(np.abs(bounds).max(axis=1)))


def _is_cut(locator, first, last):
    t, part, cell = mutable(0.0), mutable(0), mutable(0)
    return bool(locator.IntersectWithLine(first, last, 0.0, t, np.zeros(3), np.zeros(3), part, cell))


def _add_colored(renderer, data, colors):
    """An actor with a colour at every point, in bytes."""
    values = numpy_to_vtk(np.rint(255 * colors).astype(np.uint8), deep=True)
    values.SetName("colors")
    data.GetPointData().SetScalars(values)
    wt.add_actor(renderer, data, (1, 1, 1), lit=False).GetMapper().ScalarVisibilityOn()

# SPDX-License-Identifier: BSD-3-Clause
"""An off-screen picture of a scene with water: ground, sun, sky, camera and a vtkWaterActor.

    scene = Scene(size=(960, 600))
    scene.add_ground(read("terrain.tif"), level=355.0)
    scene.add_water(355.0, preset="lake")
    scene.look(azimuth=200.0, height=15.0)
    scene.write("lake.png")
"""
import math

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkClipPolyData, vtkFeatureEdges, vtkPolyDataNormals
from vtkmodules.vtkFiltersModeling import vtkLinearExtrusionFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkSkybox,
)

from . import vtkWaterActor, vtkWaterClearSkySource
from .errors import raising
from .measure import mapper_of
from .pictures import pixels_of, write_picture
from .readers import ELEVATION
from .words import SUN_COLOR, SUN_PLACE, set_look

__all__ = ["Scene"]

SAMPLES = 8
VIEW_ANGLE_DEG = 30.0
STEEP_DEG = 89.0  # from here on north is up in the picture
SKY_AT_BOTTOM, SKY_AT_TOP = (0.93, 0.94, 0.93), (0.30, 0.50, 0.76)
WALL_COLOR = (0.27, 0.24, 0.20)
MESH_COLOR = (0.78, 0.76, 0.72)
BED_COLOR = (0.36, 0.33, 0.26)
# Colours of dry ground, by the share of its height over the water: shore, meadow, forest, rock, snow.
GROUND = ((0.0, 0.55, 0.50, 0.38), (0.03, 0.36, 0.40, 0.22), (0.35, 0.24, 0.32, 0.17), (0.65, 0.42, 0.39, 0.33),
          (0.9, 0.66, 0.65, 0.63), (1.0, 0.88, 0.88, 0.89))
BLOCK = 0.1  # of the ground's relief: what a block has under its lowest point
WATER_AROUND_A_MESH = 10.0  # times its width, on all sides
WATER_AROUND = 50.0  # the same for an island: a horizon. More would cost the depth its precision
NEAREST = 0.1  # of the way from the eye to what it looks at: nothing is drawn that is nearer
FILLED = 0.92  # of the picture, by what stands out of the water


class Scene:
    """A renderer with its off-screen window, ground, sky and water."""

    def __init__(self, size=(960, 600)):
        self.renderer = vtkRenderer()
        self.renderer.GradientBackgroundOn()
        self.renderer.SetBackground(SKY_AT_BOTTOM)
        self.renderer.SetBackground2(SKY_AT_TOP)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(SAMPLES)
        self.window.SetSize(*size)
        self.window.AddRenderer(self.renderer)
        self.set_sun(*SUN_PLACE)
        self.water = None
        self._ground = None
        self._exaggeration = 1.0
        self._base = None  # where the walls of a block end

    def set_sun(self, azimuth, height):
        """Set the sun by its azimuth (from north, 90 is east) and its elevation above the horizon, in degrees."""
        self.renderer.RemoveAllLights()
        light = vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetPosition(*direction(azimuth, height))
        light.SetFocalPoint(0.0, 0.0, 0.0)
        light.SetColor(SUN_COLOR)
        self.renderer.AddLight(light)

    def set_clear_sky(self, azimuth, height, turbidity):
        """Show a clear sky with sunlight instead of the gradient; angles as for set_sun, turbidity in [2, 10]."""
        sky = vtkWaterClearSkySource()
        with raising(sky):
            sky.SetAzimuth(azimuth)
            sky.SetElevation(height)
            sky.SetTurbidity(turbidity)
        skybox = vtkSkybox()
        sky.ConfigureSkybox(skybox, self.renderer)
        self.renderer.AddActor(skybox)
        self.renderer.GradientBackgroundOff()
        self.renderer.SetBackground(sky.GetMeanColor())
        self.set_sun(azimuth, height)
        self.renderer.GetLights().GetItemAsObject(0).SetColor(sky.GetSunColor())
        return skybox

    def set_ground(self, surface):
        """Set the readers.Surface for which the view is chosen; it is not drawn."""
        self._ground = surface

    def add_ground(self, surface, level, exaggeration=1.0):
        """Add a readers.Surface. A terrain is coloured by its height above the level; exaggeration scales both."""
        self.set_ground(surface)
        self._exaggeration = exaggeration if surface.is_terrain else 1.0
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(surface.data)
        actor = vtkActor()
        actor.GetProperty().SetAmbient(0.25)
        actor.GetProperty().SetDiffuse(0.95)
        if surface.is_terrain:
            actor.SetScale(1.0, 1.0, exaggeration)
            normals = vtkPolyDataNormals()
            normals.SetInputData(surface.data)
            normals.SplittingOff()
            mapper.SetInputConnection(normals.GetOutputPort())
            mapper.SetLookupTable(ground_colors(level, surface.data.GetPointData().GetArray(ELEVATION).GetRange()))
            mapper.UseLookupTableScalarRangeOn()
        else:
            mapper.ScalarVisibilityOff()
            actor.GetProperty().SetColor(MESH_COLOR)
        actor.SetMapper(mapper)
        self.renderer.AddActor(actor)
        return actor

    def add_mesh(self, data, color, smooth=True):
        """Add polygonal data (vtkPolyData, or a filter that makes it) in one colour: red, green, blue in [0, 1]."""
        mapper = vtkPolyDataMapper()
        if smooth:
            normals = vtkPolyDataNormals()
            normals.SetFeatureAngle(40.0)
        connect(normals if smooth else mapper, data)
        if smooth:
            mapper.SetInputConnection(normals.GetOutputPort())
        mapper.ScalarVisibilityOff()
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(color)
        actor.GetProperty().SetAmbient(0.25)
        actor.GetProperty().SetDiffuse(0.95)
        self.renderer.AddActor(actor)
        return actor

    def add_box(self, bounds, color):
        """Add a box with these xmin, xmax, ymin, ymax, zmin, zmax."""
        box = vtkCubeSource()
        box.SetBounds(bounds)
        return self.add_mesh(box, color, smooth=False)

    def add_water(self, level, preset=None, wind=None, exaggeration=1.0, **words):
        """Add water at a level of the data; around a mesh it extends beyond the mesh. The look is set by the arguments
        of ``words.set_look``: preset, wind, refraction, foam, ... By default units are metres and, without a preset,
        the water is opaque. Raises TypeError, ValueError."""
        self.water = vtkWaterActor()
        words["units"] = words.get("units") or "m"
        if preset is None and not any(words.get(word) for word in ("refraction", "foam", "caustics", "dome_port")):
            words["refraction"] = False
        set_look(self.water.GetWaterProperty(), preset=preset, wind=wind, **words)
        self.water.GetWaterProperty().SetVerticalExaggeration(exaggeration)
        with raising(self.water):
            self.water.SetLevel(level * exaggeration)
        if self._ground and not self._ground.is_terrain:
            self._widen_water(WATER_AROUND_A_MESH)
        self.renderer.AddActor(self.water)
        return self.water

    def _widen_water(self, times):
        """Extends the water beyond the ground on all sides.

        times : float
            Distance, in multiples of the ground's largest extent: along x, along y, or its height with its mirror
            image.
        """
        west, east, south, north, _, top = self._ground.data.GetBounds()
        reach = times * max(east - west, north - south, 2.0 * (top * self._exaggeration - self.water.GetLevel()))
        with raising(self.water):
            self.water.SetSheetBounds(west - reach, east + reach, south - reach, north + reach)

    def make_island(self, to_horizon=False):
        """Surround the ground with water, and build walls at the edges of a terrain.

        to_horizon : bool
            Whether the water reaches to the true horizon.
        """
        if to_horizon:
            self.water.SetSheetToHorizon()
        else:
            self._widen_water(WATER_AROUND)
        if self._ground.is_terrain:
            self.add_walls(self.water.GetLevel() / self._exaggeration)

    def add_walls(self, level, is_block=False):
        """Build walls at the edges of the ground, a terrain: down to its lowest point, and at least to the level.

        is_block : bool
            The walls end in a level line a little lower, like those of a block that is seen from all sides.
        """
        edges = vtkFeatureEdges()
        edges.SetInputData(self._ground.data)
        edges.FeatureEdgesOff()
        edges.NonManifoldEdgesOff()
        edges.ManifoldEdgesOff()
        edges.ColoringOff()
        low, high = self._ground.data.GetBounds()[4:]
        low = min(low, level)  # walls of high ground stand in the water, too
        walls = vtkLinearExtrusionFilter()
        walls.SetInputConnection(edges.GetOutputPort())
        walls.SetExtrusionTypeToVectorExtrusion()
        walls.SetVector(0.0, 0.0, -1.0)
        walls.SetScaleFactor(high - low)  # under the lowest point, wherever they begin
        walls.CappingOff()
        if is_block:
            self._base = low - BLOCK * (high - low)
            walls.SetScaleFactor(high - self._base)
            plane = vtkPlane()
            plane.SetOrigin(0.0, 0.0, self._base)
            plane.SetNormal(0.0, 0.0, 1.0)
            trimmed = vtkClipPolyData()
            trimmed.SetInputConnection(walls.GetOutputPort())
            trimmed.SetClipFunction(plane)
            walls = trimmed
        actor = self.add_mesh(walls, WALL_COLOR, smooth=False)
        actor.SetScale(1.0, 1.0, self._exaggeration)
        return actor

    def look(self, azimuth=200.0, height=15.0, zoom=1.0, highest=-math.inf, all_of_it=False):
        """Aim the camera at the ground from an azimuth (degrees from north) and a height (degrees above the horizon).

        zoom 1 shows everything above the water, and its reflection; with all_of_it, it shows the whole ground and the
        water's mesh as it is now. zoom 2 shows half of that width. highest is the highest level that the water will
        reach, in the data's unit: if there is dry ground now, the eye stays above that level.
        """
        points = vtk_to_numpy(self._ground.data.GetPoints().GetData()) * (1.0, 1.0, self._exaggeration)
        lowest = -math.inf
        if self._base is not None:
            points = np.concatenate([points, points * (1.0, 1.0, 0.0) + (0.0, 0.0, self._base * self._exaggeration)])
        if self.water and not all_of_it:
            level = self.water.GetLevel()
            dry = points[points[:, 2] > level]
            if len(dry):  # and their mirror image
                points = np.concatenate([dry, dry * (1.0, 1.0, -1.0) + (0.0, 0.0, 2.0 * level)])
                lowest = highest * self._exaggeration
        mapper = mapper_of(self.water) if self.water and all_of_it else None
        if mapper:
            mapper.Update()
            if mapper.GetInput().GetNumberOfPoints():
                points = np.concatenate([points, vtk_to_numpy(mapper.GetInput().GetPoints().GetData())])
        back = np.array(direction(azimuth, height))
        up = np.array((0.0, 0.0, 1.0) if height < STEEP_DEG else (0.0, 1.0, 0.0))
        right = np.cross(up, back) / np.linalg.norm(np.cross(up, back))
        target = 0.5 * (points.min(axis=0) + points.max(axis=0))
        target[2] = max(target[2], lowest)
        points = points - target
        # how far the eye must be for a point to be in the picture, along both of its sides
        tangent = FILLED * math.tan(math.radians(0.5 * VIEW_ANGLE_DEG))
        width, rows = self.window.GetSize()
        across = np.abs(points @ right) / (tangent * width / rows)
        along = np.abs(points @ np.cross(back, right)) / tangent
        distance = np.max(points @ back + np.maximum(across, along)) / zoom
        self.set_camera(target + distance * back, target, up=up)

    def set_camera(self, eye, target, angle=VIEW_ANGLE_DEG, up=(0.0, 0.0, 1.0)):
        """Set the positions of the eye and the target, and the vertical angle of view in degrees."""
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(eye)
        camera.SetFocalPoint(target)
        camera.SetViewUp(up)
        camera.SetViewAngle(angle)
        self.renderer.ResetCameraClippingRange()
        near, far = camera.GetClippingRange()  # VTK's, for such wide water, would cut the nearest away
        camera.SetClippingRange(min(near, NEAREST * camera.GetDistance()), far)

    def _raising(self):
        return raising(*([self.water] if self.water else []))

    def picture(self):
        """Render to rows x columns x RGB of 8 bits, top row first. Raises ValueError if water cannot be drawn."""
        with self._raising():
            self.window.Render()
        return pixels_of(self.window)

    def write(self, file):
        """Render into a PNG, JPEG or WebP. Raises OSError if it cannot be written, ValueError for another suffix or
        if the water cannot be drawn."""
        with self._raising():
            write_picture(self.window, file)


def connect(algorithm, data):
    if data.IsA("vtkAlgorithm"):
        algorithm.SetInputConnection(data.GetOutputPort())
    else:
        algorithm.SetInputData(data)


def direction(azimuth, height):
    """Unit vector for an azimuth (degrees from north, y, towards east, x) and a height above the horizon."""
    azimuth, height = math.radians(azimuth), math.radians(height)
    return math.sin(azimuth) * math.cos(height), math.cos(azimuth) * math.cos(height), math.sin(height)


def ground_colors(level, heights):
    colors = vtkColorTransferFunction()
    span = heights[1] - max(level, heights[0])
    shore = max(level, heights[0])
    if span <= 0.0:  # all of it under water
        shore, span = heights[1], 1.0
    colors.AddRGBPoint(min(heights[0], level) - 1.0, *BED_COLOR)
    for share, red, green, blue in GROUND:
        colors.AddRGBPoint(shore + share * span, red, green, blue)
    return colors

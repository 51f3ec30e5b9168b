# SPDX-License-Identifier: BSD-3-Clause
"""The water of a solver's file in a Scene: its surface, its bed and its colours, at any time of the file.

    solution = Solution("flood.pvd", ["h", "zb", "speed"])
    water = DataWater(scene, solution, depth="h", bed="zb", color_by="speed")
    water.show(300.0)

The picture depends only on the file and the time: the range of colours is that of all steps, and the colours of the
land and the view are those of the first step that has water.
"""
import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCellDataToPointData, vtkContourFilter, vtkPolyDataNormals
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkPolyDataMapper

from . import vtkWaterActor, vtkWaterLakes, vtkWaterSurfaceFilter
from .errors import heed, raising
from .measure import WHOLE
from .readers import ELEVATION, HIGHEST, Surface
from .solutions import array_of, odd_units
from .vertex_data import wrong_components
from .words import set_look

__all__ = ["COLOR_MAPS", "DataWater", "table_of"]

LEVEL = "vtkwater level"  # the array of a level that is one number
TABLE_SIZE = 256
NAN_COLOR = (0.6, 0.6, 0.6, 1.0)
BAR_TEXT = 14  # points
BAR_PIXELS = 72  # title, labels and bar, in a picture of any size
# Of matplotlib, at 17 even steps; between them they are off by at most 9 of 255.
COLOR_MAPS = {
    "viridis": "440154 48186a 472d7b 424086 3b528b 33638d 2c728e 26828e 21918c "
               "1fa088 28ae80 3fbc73 5ec962 84d44b addc30 d8e219 fde725",
    "plasma": "0d0887 310597 4c02a1 6600a7 7e03a8 9511a1 aa2395 bc3587 cc4778 "
              "da5a6a e66c5c f0804e f89540 fdac33 fdc527 f8df25 f0f921",
    "turbo": "30123b 4040a2 466be3 4294ff 28bceb 18ddc2 32f298 6dfe62 a4fc3c "
             "cdec34 eecf3a fdac34 fb7e21 eb500e d02f05 a91601 7a0403",
    "coolwarm": "3b4cc0 4e68d8 6282ea 779af7 8db0fe a3c2fe b9d0f9 ccd9ed dddcdc "
                "ecd3c5 f5c4ac f7b093 f4987a eb7d62 dd5f4b ca3b37 b40426",
    "Blues": "f7fbff eaf3fb deebf7 d2e3f3 c6dbef b2d2e8 9dcae1 84bcdb 6aaed6 "
             "56a0ce 4191c6 3181bd 2070b4 1460a8 08509b 084082 08306b",
}


class DataWater:
    """A solution as the water of a Scene, with its bed as the ground.

    Parameters
    ----------
    scene : Scene
        A scene without water.
    solution : Solution
        It must read the arrays that are named below; with contour, it must be one of a volume.
    level, depth, bed : str, optional
        Names of arrays, as in vtkWaterSurfaceFilter; level may also be a number. The solution converts them to metres.
    contour : tuple[str, float], optional
        Instead of level, depth and bed: the name of an array of a volume, and its value on the water's surface.
    color_by : str, optional
        An array that colours the water; vectors by their magnitude.
    data : VertexData, optional
        Arrays of a current, of matter in the water, of foam.
    cmap : str, optional
        One of COLOR_MAPS or, where it is installed, of matplotlib's; default 'viridis'.
    clim : sequence[float], optional
        The values of the first and the last colour. The default is the array's range over all steps, which are then
        all read.
    log_scale : bool, default: False
        Whether the colours have a logarithmic scale; the default of clim then begins with the smallest value above 0.
    dry_depth : float, optional
        DryDepth of the filter.
    exaggeration : float, default: 1.0
        Factor of the heights in the picture.
    **words
        Settings of the water's look, as in ``words.set_look``.

    Raises
    ------
    FileError, ValueError
    """

    def __init__(self, scene, solution, *, level=None, depth=None, bed=None, contour=None, color_by=None, data=None,
                 cmap=None, clim=None, log_scale=False, dry_depth=None, exaggeration=1.0, **words):
        self.scene, self.solution = scene, solution
        self._level, self._names = level, {"depth": depth, "bed": bed}
        self._exaggeration = exaggeration
        self._ground = self._walls = self._known = None
        self._heights = None
        self._colors = color_by
        self._mapper = vtkPolyDataMapper()
        self._mapper.ScalarVisibilityOff()
        self._contoured = contour[0] if contour else None
        self._lakes = None if contour else vtkWaterLakes()  # each in its own plane, which a river's slope tilts
        if contour:
            self.filter = self._shown = contour_of(*contour)  # it has normals
            self.water = level_water(self._mapper)
        else:
            self.filter = surface_of(level, depth, bed, dry_depth, exaggeration)
            self._shown = normals_of(self.filter)
            self.water = self._lakes.GetWater()
            self._lakes.SetMapper(self._mapper)
            setattr(self.water, WHOLE, self._mapper)
        self._mapper.SetInputConnection(self._shown.GetOutputPort())
        self.notes = odd_units(solution, (level, depth, bed))  # what a user may not expect
        heed(self.filter, self.notes.append)
        scene.water = self.water
        set_look(self.water.GetWaterProperty(), **words)
        self.water.GetWaterProperty().SetVerticalExaggeration(exaggeration)
        if data is not None:
            self._give(data)
        if color_by:
            self._color(color_by, cmap, clim, log_scale)
        self._begin()
        if self._lakes:
            self._lakes.AddTo(scene.renderer)
        else:
            scene.renderer.AddActor(self.water)

    def show(self, time):
        """Show the water of a time of the file; returns whether anything is wet then."""
        mesh = self._mesh(time)
        self._show_mesh(mesh)
        if self._ground is not None:
            self._show_bed(mesh)
        return self.filter.GetOutput().GetNumberOfCells() > 0

    @property
    def level(self):
        """Mean height of the water that is shown, as it is drawn."""
        return self.water.GetLevel() if self._contoured else self.filter.GetMeanLevel()

    def times_text(self, time):
        """A time, and those of the file, for a user."""
        times = self.solution.times
        return f"time {time:g} of {times[0]:g} to {times[-1]:g}" if len(times) > 1 else "one step"

    def bar(self, title):
        """A scalar bar of the colours, above the picture's middle."""
        bar = vtkScalarBarActor()
        bar.SetLookupTable(self._mapper.GetLookupTable())
        bar.SetTitle(f"{title}\n ")  # VTK lays the last line over the labels
        bar.SetOrientationToHorizontal()
        height = min(max(0.12, BAR_PIXELS / self.scene.window.GetSize()[1]), 0.4)
        bar.SetPosition(0.30, 0.98 - height)
        bar.SetWidth(0.40)
        bar.SetHeight(height)
        bar.SetNumberOfLabels(5)
        bar.SetMaximumNumberOfColors(TABLE_SIZE)  # each of the water's
        bar.SetLabelFormat("%.3g" if "%" in bar.GetLabelFormat() else "{:.3g}")
        bar.UnconstrainedFontSizeOn()
        for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
            text.SetFontSize(BAR_TEXT)
            text.ItalicOff()
            text.BoldOff()
            text.ShadowOff()
        self.scene.renderer.AddViewProp(bar)
        return bar

    def _begin(self):
        """Ground and view: those of the first step that has water."""
        times = self.solution.times
        for time in times:
            mesh = self._mesh(time)
            self._show_mesh(mesh)
            if self.filter.GetOutput().GetNumberOfCells():
                break
        else:
            raise ValueError(f"{self.solution.path}: {self._dry_text()}")
        heights = None if self._contoured else bed_of(mesh, self._level, **self._names)
        surface = self.filter.GetOutput()
        lowest = surface.GetBounds()[4]
        if heights is None:
            kept = mesh if self._contoured else surface  # all of the volume is in view
            shown = kept.NewInstance()
            shown.ShallowCopy(kept)
            self.scene.set_ground(Surface(shown))
            return
        data, self._known = known_part(mesh, heights)
        self._ground = data
        self._set_heights(heights)
        level = lowest / self._exaggeration
        self.scene.add_ground(Surface(data, is_terrain=True), level, self._exaggeration)
        self.scene.add_walls(level, is_block=True)

    def _dry_text(self):
        """Why there is no water, with the ranges of the arrays."""
        times = self.solution.times
        when = f" at any time, {times[0]:g} to {times[-1]:g}" if len(times) > 1 else ""
        names = [self._contoured] if self._contoured else [self._level, *self._names.values()]
        ranges = {name: self.solution.range_of(name) for name in names if isinstance(name, str)}
        texts = [f"'{name}' is {ends[0]:g} to {ends[1]:g}" if ends else f"'{name}' has no finite value"
                 for name, ends in ranges.items()]
        told = [note for note in self.notes if note.startswith("the array")]  # by the filter, with ranges
        return f"no place is wet{when}: {'; '.join(told) or ', '.join(texts)}"

    def _mesh(self, time):
        mesh = self.solution.at(time)
        if self._colors is not None and self.solution.factor_of(self._colors) != 1.0:
            mesh = with_stated(mesh, self._colors, self.solution.factor_of(self._colors))
        if self._contoured and mesh.GetPointData().GetArray(self._contoured) is None:
            convert = vtkCellDataToPointData()
            convert.PassCellDataOn()
            convert.SetInputData(mesh)
            convert.Update()
            mesh = convert.GetOutput()
        if isinstance(self._level, float):
            made = mesh.NewInstance()
            made.ShallowCopy(mesh)
            mesh = made
            levels = numpy_to_vtk(np.full(mesh.GetNumberOfPoints(), self._level), deep=True)
            levels.SetName(LEVEL)
            mesh.GetPointData().AddArray(levels)
        return mesh

    def _show_mesh(self, mesh):
        self.filter.SetInputData(mesh)
        with raising(self.filter, LevelArrayName="level", DepthArrayName="depth"):
            self.filter.Update()
        if not self._contoured:
            self._lakes.Update()
            return
        self.water.SetLevel(0.0)
        placement = [0.0] * 4
        if self.filter.GetOutput().GetNumberOfCells() and self.water.GetMeshPlacement(placement):
            self.water.SetLevel(placement[0])

    def _show_bed(self, mesh):
        heights = bed_of(mesh, self._level, **self._names)
        if heights is not None and not np.array_equal(heights, self._heights, equal_nan=True):
            self._set_heights(heights)

    def _set_heights(self, heights):
        """The land's heights; where a later step has none, the land stays as it is."""
        self._heights = heights
        heights = heights[self._known]
        before = vtk_to_numpy(self._ground.GetPoints().GetData())[:, 2]
        heights = np.where(np.isfinite(heights), heights, before)
        places = vtk_to_numpy(self._ground.GetPoints().GetData()).astype(float)
        places[:, 2] = heights
        points = vtkPoints()
        points.SetData(numpy_to_vtk(places, deep=True))
        self._ground.SetPoints(points)
        elevation = numpy_to_vtk(heights, deep=True)
        elevation.SetName(ELEVATION)
        self._ground.GetPointData().SetScalars(elevation)

    def _give(self, data):
        for word, name in data.given().items():
            wrong = wrong_components(word, array_of(self.solution.step(0), name).GetNumberOfComponents())
            if wrong:
                raise ValueError(f"{self.solution.path}: the array '{name}' has {wrong} for {word.replace('_', '-')}")
        data.give(self.water)

    def _color(self, name, cmap, clim, log_scale):
        factor = self.solution.factor_of(name)
        ends = clim or self.solution.range_of(name, log_scale)
        if ends and not clim:
            ends = tuple(end / factor for end in ends)
        if ends is None:
            raise ValueError(f"{self.solution.path}: the array '{name}' has no finite value"
                             f"{' above 0' if log_scale else ''}")
        self._mapper.SetLookupTable(table_of(cmap or "viridis", ends, log_scale))
        self._mapper.UseLookupTableScalarRangeOn()
        of_points = self.solution.step(0).GetPointData().GetArray(name) is not None
        if of_points:
            self._mapper.SetScalarModeToUsePointFieldData()
        else:
            self._mapper.SetScalarModeToUseCellFieldData()
        self._mapper.SelectColorArray(name if factor == 1.0 else stated_name(name))
        self._mapper.SetColorModeToMapScalars()
        self._mapper.SetInterpolateScalarsBeforeMapping(of_points)
        self._mapper.ScalarVisibilityOn()


def normals_of(surface):
    """A filter that gives the points of a surface their normals, because its slopes change its reflections."""
    normals = vtkPolyDataNormals()
    normals.SplittingOff()
    normals.ConsistencyOff()
    normals.SetInputConnection(surface.GetOutputPort())
    return normals


def with_stated(mesh, name, factor):
    """The mesh with another array: the one that colours the water, in the unit that the file states, not in metres."""
    made = mesh.NewInstance()
    made.ShallowCopy(mesh)
    of_points = mesh.GetPointData().GetArray(name) is not None
    array = numpy_to_vtk(vtk_to_numpy(array_of(mesh, name)) / factor, deep=True)
    array.SetName(stated_name(name))
    (made.GetPointData() if of_points else made.GetCellData()).AddArray(array)
    return made


def stated_name(name):
    return f"{name} in the file's unit"


def contour_of(name, value):
    contour = vtkContourFilter()
    contour.SetInputArrayToProcess(0, 0, 0, 0, name)  # of points
    contour.SetValue(0, value)
    return contour


def surface_of(level, depth, bed, dry_depth, exaggeration):
    """A filter that gives a solver's water; the arguments are those of DataWater."""
    surface = vtkWaterSurfaceFilter()
    surface.SetLevelArrayName(LEVEL if isinstance(level, float) else level or "")
    surface.SetDepthArrayName(depth or "")
    surface.SetBedArrayName(bed or "")
    with raising(surface, DryDepth="dry depth", VerticalScale="exaggeration"):
        surface.SetVerticalScale(exaggeration)
        if dry_depth is not None:
            surface.SetDryDepth(dry_depth)
    return surface


def level_water(mapper):
    """A water of a mapper's mesh, which mirrors in one level plane."""
    water = vtkWaterActor()
    water.SetMapper(mapper)
    plane = vtkPlane()
    plane.SetNormal(0.0, 0.0, 1.0)
    water.SetPlane(plane)
    return water


def bed_of(mesh, level, depth, bed):
    """Heights of the bed at a mesh's points: as given, the level less the depth, or the mesh's own; NaN in holes.

    None: all of it is unknown.
    """
    if bed:
        heights = at_points(mesh, bed)
    elif level is not None and depth:
        heights = (level if isinstance(level, float) else at_points(mesh, level)) - at_points(mesh, depth)
    elif depth:
        heights = vtk_to_numpy(mesh.GetPoints().GetData())[:, 2].astype(float)
    else:
        return None
    heights = np.where(np.abs(heights) <= HIGHEST, heights, np.nan)
    return heights if has_known_cells(mesh, heights) else None


def known_cells(mesh, heights):
    """For each polygon, whether all of its corners have a height."""
    polygons = mesh.GetPolys()
    starts, corners = (vtk_to_numpy(part) for part in (polygons.GetOffsetsArray(), polygons.GetConnectivityArray()))
    has_points = np.diff(starts) > 0
    are_known = np.zeros(len(has_points), bool)
    if has_points.any():
        are_known[has_points] = np.logical_and.reduceat(np.isfinite(heights)[corners], starts[:-1][has_points])
    return are_known


def has_known_cells(mesh, heights):
    return bool(np.isfinite(heights).all() or known_cells(mesh, heights).any())


def known_part(mesh, heights):
    """The land whose heights are known, which may have holes, and its points' numbers in the mesh."""
    data = vtkPolyData()
    if np.isfinite(heights).all():
        data.CopyStructure(mesh)
        return data, np.arange(mesh.GetNumberOfPoints())
    polygons = mesh.GetPolys()
    starts, corners = (vtk_to_numpy(part) for part in (polygons.GetOffsetsArray(), polygons.GetConnectivityArray()))
    is_known, sizes = known_cells(mesh, heights), np.diff(starts)
    used, corners = np.unique(corners[np.repeat(is_known, sizes)], return_inverse=True)
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(np.r_[0, np.cumsum(sizes[is_known])].astype(np.int64), deep=True),
                  numpy_to_vtkIdTypeArray(corners.ravel().astype(np.int64), deep=True))
    points = vtkPoints()
    points.SetData(numpy_to_vtk(vtk_to_numpy(mesh.GetPoints().GetData())[used].astype(float), deep=True))
    data.SetPoints(points)
    data.SetPolys(cells)
    return data, used


def at_points(mesh, name):
    if mesh.GetPointData().GetArray(name) is None:
        convert = vtkCellDataToPointData()
        convert.SetInputData(mesh)
        convert.Update()
        mesh = convert.GetOutput()
    return vtk_to_numpy(array_of(mesh, name)).astype(float)


def table_of(name, ends, log_scale=False):
    """A lookup table of a colour map between two values; values outside them have the nearer end's colour.

    Parameters
    ----------
    name : str
        One of COLOR_MAPS, or of matplotlib's where it is installed.
    ends : sequence[float]
        Finite, and the first not above the second; with log_scale, above 0.
    log_scale : bool, default: False
        Whether equal ratios, not equal differences, are equal steps of the colour map.

    Raises
    ------
    ValueError
    """
    low, high = ends
    if not (low <= high and math.isfinite(high - low)):
        raise ValueError(f"the range of colours is ({low:g}, {high:g}); both must be finite, and the "
                         "first must not exceed the second")
    if log_scale and low <= 0.0:
        raise ValueError(f"the range of colours is ({low:g}, {high:g}); on a logarithmic scale both must be above 0")
    table = vtkLookupTable()
    table.SetNumberOfTableValues(TABLE_SIZE)
    table.SetVectorModeToMagnitude()
    for i, color in enumerate(colors_of(name)):
        table.SetTableValue(i, *color, 1.0)
    table.SetNanColor(NAN_COLOR)
    table.SetRange(low, high)
    if log_scale:
        table.SetScaleToLog10()
    return table


def colors_of(name):
    shares = np.linspace(0.0, 1.0, TABLE_SIZE)
    if name in COLOR_MAPS:
        colors = vtkColorTransferFunction()
        steps = COLOR_MAPS[name].split()
        for i, step in enumerate(steps):
            colors.AddRGBPoint(i / (len(steps) - 1), *(int(step[j:j + 2], 16) / 255.0 for j in (0, 2, 4)))
        return [colors.GetColor(share) for share in shares]
    try:
        from matplotlib import colormaps
    except ImportError:
        raise ValueError(f"unknown colour map {name!r}; known: {', '.join(COLOR_MAPS)}, and if matplotlib "
                         "(3.5 or later) is installed, all of its maps") from None
    if name not in colormaps:
        raise ValueError(f"unknown colour map {name!r}; known: {', '.join(COLOR_MAPS)} and those of matplotlib")
    return colormaps[name](shares)[:, :3].tolist()

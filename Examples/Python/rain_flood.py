# SPDX-License-Identifier: BSD-3-Clause
"""rain_flood: a flood as a solver computed it, coloured by the time at which the water came.

Six hours of a rain flood in the hills of Tennessee, by landlab's OverlandFlow (Examples/Data/solve_flood.py): the mesh
of the solver with its depths is the water, and ends where the bed reaches its level. With --dam, a dam breaks in a
valley of the same map. With --plot, the flooded area and the volume of the water, which vtkwater.measure measures in
each frame, are drawn over the hours, beside the picture; in grey those of the solver's cells. They are larger: the
solver fills whole cells, and most of its streams are a cell or two wide, while the water in the picture ends where the
bed rises above its level.
"""

import argparse
import pathlib
import sys

import numpy as np
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401  draws charts
from tqdm import tqdm
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkRectf, vtkStructuredGrid, vtkTable
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingContext2D import vtkContextActor
from vtkmodules.vtkRenderingCore import vtkPolyDataMapper, vtkRenderer
from vtkwater import measure, movies, vtkWaterActor, vtkWaterSurfaceFilter
from vtkwater.errors import ending
from vtkwater.pictures import png_name
from vtkwater.readers import surface_of_heights
from vtkwater.scenes import Scene

DATA = pathlib.Path(__file__).resolve().parents[1] / "Data"
FLOOD, DAM_FLOOD = DATA / "flood.npz", DATA / "dam_flood.npz"
EXAGGERATION = 2.0  # heights are drawn this many times higher than they are
WET = 0.1  # m: shallower water is not shown
FRAMES_PER_SECOND = 10.0
PLOT_WIDTH = 0.36  # of the window
AREA_COLOR, VOLUME_COLOR = (31, 99, 180), (205, 88, 20)  # of the curves and the titles of their axes
CELLS_COLOR = 150, 150, 150
AREA_UNIT, VOLUME_UNIT = 1e6, 1e6  # m2 in km2, m3 in millions of m3


def read_flood(file=FLOOD):
    """Depths (m) at each hour, rows x columns from the south-west, the hours, the bed's heights and the spacing (m)."""
    with np.load(file) as kept:
        depths = kept["step"] * np.cumsum(kept["depth"], axis=0, dtype=np.int32)
        return depths, kept["hours"], kept["bed"].astype(float), kept["spacing"]


def solvers_mesh(bed, spacing):
    """The mesh of the solver, with its bed."""
    rows, columns = bed.shape
    y, x = np.mgrid[0:rows, 0:columns]
    points = vtkPoints()
    points.SetData(numpy_to_vtk(
        np.stack([spacing[0] * x, spacing[1] * y, 0.0 * x], axis=-1).reshape(-1, 3), deep=True))
    mesh = vtkStructuredGrid()
    mesh.SetDimensions(columns, rows, 1)
    mesh.SetPoints(points)
    set_array(mesh, "bed", bed)
    return mesh


def set_array(mesh, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values, dtype=float).ravel(), deep=True)
    array.SetName(name)
    mesh.GetPointData().AddArray(array)


def times_table(last):
    """From the colour of the first hour, or minute, to that of the last."""
    first, middle, end = np.array(((0.99, 0.88, 0.30), (0.87, 0.28, 0.38), (0.20, 0.06, 0.45)))
    table = vtkLookupTable()
    table.SetNumberOfTableValues(64)
    for i, share in enumerate(np.linspace(0.0, 2.0, 64)):
        color = first + share * (middle - first) if share < 1 else middle + (share - 1) * (end - middle)
        table.SetTableValue(i, *color, 1.0)
    table.SetRange(0.0, last)
    return table


def add_water(scene, mesh, table, unit="hours"):
    """The water of the mesh, coloured by the time of its arrival in this unit."""
    surface = vtkWaterSurfaceFilter()
    surface.SetInputData(mesh)
    surface.SetDepthArrayName("depth")
    surface.SetBedArrayName("bed")
    surface.SetDryDepth(WET)
    surface.SetVerticalScale(EXAGGERATION)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("arrival")
    mapper.SetLookupTable(table)
    mapper.UseLookupTableScalarRangeOn()
    water = vtkWaterActor()
    water.SetMapper(mapper)
    water.GetWaterProperty().SetReflectionSourceToEnvironment()  # of the sky: a river in hills has no single level
    scene.renderer.AddActor(water)
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle(f"{unit} until the water came\n ")  # VTK lays the last line over the labels
    bar.SetOrientationToHorizontal()
    bar.SetPosition(0.30, 0.86)
    bar.SetWidth(0.40)
    bar.SetHeight(0.12)
    bar.SetNumberOfLabels(4)
    bar.SetLabelFormat("%.0f")
    bar.UnconstrainedFontSizeOn()
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetFontSize(14)
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
    scene.renderer.AddViewProp(bar)
    return water, surface


class Plot:
    """Two charts at the right of a window: the flooded area (km2) and the volume of the water (million m3) over hours.

    The axes are fixed from the start: they end at the last hour, and 5 % above the largest area (m2) and volume (m3).
    """

    def __init__(self, scene, last_hour, most_area, most_volume):
        scene.renderer.SetViewport(0.0, 0.0, 1.0 - PLOT_WIDTH, 1.0)
        self.renderer = vtkRenderer()
        self.renderer.SetViewport(1.0 - PLOT_WIDTH, 0.0, 1.0, 1.0)
        self.renderer.SetBackground(1.0, 1.0, 1.0)
        scene.window.AddRenderer(self.renderer)
        self.table = vtkTable()
        for name in ("hours", "area", "volume", "area of cells", "volume of cells"):
            column = vtkFloatArray()
            column.SetName(name)
            self.table.AddColumn(column)
        self.actor = vtkContextActor()
        self.renderer.AddActor(self.actor)
        width, height = scene.window.GetSize()
        self.charts = [
            self._chart(vtkRectf(0, share * height, PLOT_WIDTH * width, height / 2), title, column, color, last_hour,
                        most)
            for share, title, column, color, most in (
                (0.5, "flooded area, km\u00b2 (grey: of whole cells)", 1, AREA_COLOR, most_area / AREA_UNIT),
                (0.0, "volume, million m\u00b3 (grey: of whole cells)", 2, VOLUME_COLOR, most_volume / VOLUME_UNIT))]

    def _chart(self, place, title, column, color, last_hour, most):
        chart = vtkChartXY()
        chart.SetAutoSize(False)
        chart.SetSize(place)
        chart.SetTitle(title)
        chart.GetTitleProperties().SetFontSize(14)
        chart.GetTitleProperties().SetColor([c / 255 for c in color])
        for side, text, top in ((vtkAxis.BOTTOM, "hours", last_hour), (vtkAxis.LEFT, "", 1.05 * most)):
            axis = chart.GetAxis(side)
            axis.SetTitle(text)
            axis.SetBehavior(vtkAxis.FIXED)
            axis.SetRange(0.0, top)
        for number, paint, width in ((column + 2, CELLS_COLOR, 1.5), (column, color, 3.0)):
            curve = chart.AddPlot(vtkChart.LINE)
            curve.SetInputData(self.table, 0, number)
            curve.SetColor(*paint, 255)
            curve.SetWidth(width)
            curve.SetVisible(False)
        self.actor.GetScene().AddItem(chart)
        return chart

    def add(self, hour, measured, of_cells):
        """Add areas and volumes (m2, m3) at an hour to the curves: of the picture, and of the solver's cells."""
        units = AREA_UNIT, VOLUME_UNIT
        for i, value in enumerate((hour, *np.divide(measured, units), *np.divide(of_cells, units))):
            self.table.GetColumn(i).InsertNextValue(value)
        self.table.Modified()
        for chart in self.charts:
            for i in range(chart.GetNumberOfPlots()):
                chart.GetPlot(i).SetVisible(self.table.GetNumberOfRows() > 1)  # VTK draws no line through one point
                chart.GetPlot(i).Modified()


def arrivals(depths, hours):
    """The hour at which each place became wet; the last one where it stays dry."""
    wet = depths > WET
    return np.where(wet.any(axis=0), hours[wet.argmax(axis=0)], hours[-1])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("movie", nargs="?", default="rain_flood.gif",
                        help=f"{', '.join(movies.KINDS)}; default: %(default)s")
    parser.add_argument("--frames", type=int, default=60, help="default: %(default)s")
    parser.add_argument("--picture", type=png_name, metavar="FILE.png", help="the last frame, besides")
    parser.add_argument("--dam", action="store_true", help="a dam breaks in a valley of the same map: 15 minutes, "
                        "coloured by minutes")
    parser.add_argument("--plot", action="store_true", help="flooded area and volume over time, beside the picture")
    arguments = parser.parse_args()
    depths, hours, bed, spacing = read_flood(DAM_FLOOD if arguments.dam else FLOOD)
    unit, units_an_hour = ("minutes", 60.0) if arguments.dam else ("hours", 1.0)
    arrival = units_an_hour * arrivals(depths, hours)

    scene = Scene((960, 600))
    scene.add_ground(surface_of_heights(bed, spacing), bed.min(), EXAGGERATION)
    mesh = solvers_mesh(bed, spacing)
    set_array(mesh, "arrival", arrival)
    set_array(mesh, "depth", depths[0])
    water, surface = add_water(scene, mesh, times_table(units_an_hour * hours[-1]), unit)
    scene.set_sun(170.0, 42.0)
    scene.look(azimuth=300.0 if arguments.dam else 110.0, height=42.0, zoom=1.05 if arguments.dam else 1.0)
    most = np.zeros(2)
    for depth in depths if arguments.plot else ():
        set_array(mesh, "depth", depth)
        most = np.maximum(most, measure.flooded_cells(mesh, "depth", WET))
    plot = Plot(scene, hours[-1], *most) if arguments.plot else None
    with movies.open_movie(arguments.movie, FRAMES_PER_SECOND) as movie, movies.interrupts() as is_stopped:
        for i in tqdm(range(arguments.frames)):
            if is_stopped():
                break
            # between two steps of the solver
            step = (len(hours) - 1) * i / max(arguments.frames - 1, 1)
            first = min(int(step), len(hours) - 2)
            depth = depths[first] + (step - first) * (depths[first + 1] - depths[first])
            set_array(mesh, "depth", depth)
            surface.Update()
            water.SetLevel(surface.GetMeanLevel())
            if plot:
                hour = np.interp(step, range(len(hours)), hours)
                plot.add(hour, measure.flooded(water), measure.flooded_cells(mesh, "depth", WET))
            movie.add(scene.picture())
        if arguments.picture:
            scene.write(arguments.picture)
    print(f"{arguments.movie}: the deepest water at the end is {depths[-1].max():.1f} m, "
          f"{surface.GetOutput().GetNumberOfCells()} of {mesh.GetNumberOfCells()} cells are flooded")
    return 130 if is_stopped() else 0


if __name__ == "__main__":
    with ending("rain_flood"):
        sys.exit(main())

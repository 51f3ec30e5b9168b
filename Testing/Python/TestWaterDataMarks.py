# SPDX-License-Identifier: BSD-3-Clause
"""Contour lines, streamlines and glyphs on water of data show where they lie, in their colour, and once."""

import numpy as np
import pytest
import water_test as wt
from TestWaterSurfaceFilter import add_array, surface_of
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkInformation, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkGlyph3D, vtkMaskPoints, vtkPolyDataNormals
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer
from vtkmodules.vtkFiltersSources import vtkGlyphSource2D, vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkDataSetMapper, vtkPolyDataMapper
from vtkwater import vtkWaterActor, vtkWaterReflectionPass
from vtkwater.data_scenes import table_of
from vtkwater.marks import lay_on_water

SIZE = (480, 360)
HALF = 5.0  # the mesh covers [-5, 5] x [-5, 5]
COLOR = (255, 51, 204)  # nothing else has it
SWELL = 0.15  # height of the waves of a surface that is not flat
LOOKS = {"opaque": {}, "waves": {"waves": True}, "clear": {"clear": True},
         "clear waves": {"clear": True, "waves": True}}
SHAPES = ("flat", "swell")


def solvers_mesh(swell):
    """A current around a point, over a slope; the surface is flat, or a swell."""
    source = vtkPlaneSource()
    source.SetOrigin(-HALF, -HALF, 0)
    source.SetPoint1(HALF, -HALF, 0)
    source.SetPoint2(-HALF, HALF, 0)
    source.SetResolution(60, 60)
    source.Update()
    mesh = source.GetOutput()
    x, y, _ = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float).T
    add_array(mesh, "level", 0.3 + swell * np.sin(1.3 * x) * np.cos(0.9 * y))
    add_array(mesh, "bed", 0.5 * x - 2.0)  # dry from x = 4.6 on
    add_array(mesh, "c", np.hypot(x - 0.37, y + 0.21))
    add_array(mesh, "v", np.stack([0.21 + y, 0.37 - x, 0 * x], axis=1))
    return mesh


def contour_lines(surface):
    lines = vtkContourFilter()
    lines.SetInputConnection(surface.GetOutputPort())
    lines.SetInputArrayToProcess(0, 0, 0, 0, "c")
    lines.GenerateValues(5, 1, 5)
    return lines


def streamlines(surface):
    seeds, points = vtkPolyData(), vtkPoints()
    for y in (-1.0, -2.2, -3.4, -4.5):
        points.InsertNextPoint(0.37, y, 0.3)
    seeds.SetPoints(points)
    lines = vtkStreamTracer()
    lines.SetInputConnection(surface.GetOutputPort())
    lines.SetSourceData(seeds)
    lines.SetInputArrayToProcess(0, 0, 0, 0, "v")
    lines.SetMaximumPropagation(20.0)
    lines.SetIntegratorTypeToRungeKutta4()
    lines.SurfaceStreamlinesOn()
    return lines


def arrows(surface):
    """Of lines, on every 83rd point."""
    some = vtkMaskPoints()
    some.SetInputConnection(surface.GetOutputPort())
    some.SetOnRatio(83)
    arrow = vtkGlyphSource2D()
    arrow.SetGlyphTypeToArrow()
    arrow.FilledOff()
    made = vtkGlyph3D()
    made.SetInputConnection(some.GetOutputPort())
    made.SetSourceConnection(arrow.GetOutputPort())
    made.SetInputArrayToProcess(1, 0, 0, 0, "v")
    made.SetScaleFactor(0.3)
    return made


MARKS = {"contour lines": contour_lines, "streamlines": streamlines, "arrows": arrows}


class Scene:
    """Water of data with a post in it, and marks on it, which can be hidden; so can the water."""

    def __init__(self, make, swell=0.0, clear=False, waves=False, samples=0, laid=True):
        self.view = wt.View(SIZE, samples=samples)
        self.surface, _, _ = surface_of(solvers_mesh(swell), LevelArrayName="level", BedArrayName="bed")
        normals = vtkPolyDataNormals()
        normals.SetInputConnection(self.surface.GetOutputPort())
        normals.SplittingOff()
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(normals.GetOutputPort())
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray("c")
        mapper.SetLookupTable(table_of("viridis", (0, 6)))
        mapper.UseLookupTableScalarRangeOn()
        self.water = vtkWaterActor()
        self.water.SetMapper(mapper)
        self.water.SetLevel(self.surface.GetMeanLevel())
        look = self.water.GetWaterProperty()
        if clear:
            look.RefractionOn()
            look.SetDataOpacity(0.5)
        if waves:
            look.AddWave(0.01, 0.7, 30)
        renderer = self.view.renderer
        renderer.AddActor(self.water)
        self.post = wt.add_actor(renderer, wt.box((0, -3.5, 1), (1, 1, 3)), (0.9, 0.2, 0.1))
        wt.add_actor(renderer, wt.box((0, 0, -5.6), (12, 12, 0.2)), (0.8, 0.7, 0.5))
        shown = vtkPolyDataMapper()
        filtered = make(self.surface)
        shown.SetInputConnection(filtered.GetOutputPort())
        shown.ScalarVisibilityOff()
        self.marks = vtkActor()
        self.marks.SetMapper(shown)
        self.marks.GetProperty().SetColor([c / 255 for c in COLOR])
        self.marks.GetProperty().LightingOff()
        self.marks.GetProperty().SetLineWidth(2)
        if laid:
            lay_on_water(self.marks)
        renderer.AddActor(self.marks)
        wt.place_camera(renderer, (-6, -14, 5), (0, 0, 0), (1, 60)).SetViewAngle(35)

    def picture(self, marks=True, water=True):
        self.marks.SetVisibility(marks)
        self.water.SetVisibility(water)
        return self.view.picture()

    def shares(self):
        """Of the marks that the post leaves in view, the share that shows on water; and how far other pixels change."""
        alone, without = self.picture(water=False), self.picture(marks=False, water=False)
        true = (alone == COLOR).all(axis=2)
        touched = (alone != without).any(axis=2)
        shown, plain = self.picture(), self.picture(marks=False)
        seen = (np.abs(shown - COLOR).max(axis=2) <= 1) & true
        return true.sum(), seen.sum() / true.sum(), int(np.abs(shown - plain)[~touched].max()), shown


@pytest.mark.parametrize("look", LOOKS)
@pytest.mark.parametrize("swell", (0.0, SWELL), ids=SHAPES)
@pytest.mark.parametrize("make, samples", [("contour lines", 0), *((make, 4) for make in MARKS)])
def test_marks_show_where_they_lie_and_once(make, samples, swell, look):
    scene = Scene(MARKS[make], swell, samples=samples, **LOOKS[look])
    count, share, off, picture = scene.shares()
    name = f"marks_{make}_{look}_{SHAPES[swell > 0]}_{samples}.png"
    wt.save(picture, wt.output_folder() / name.replace(" ", "_"))
    wt.check_at_least("pixels of the marks", int(count), 400)
    wt.check_at_least("of them in their colour, %", round(100 * float(share), 2), 99.5)
    wt.check_at_most("elsewhere off by, of 255", off, 0)


@pytest.mark.parametrize("look", LOOKS)
def test_marks_show_with_depth_peeling_too(look):
    scene = Scene(contour_lines, SWELL, **LOOKS[look])
    scene.view.renderer.UseDepthPeelingOn()
    _, share, off, _ = scene.shares()
    wt.check_at_least("of the lines in their colour, %", round(100 * float(share), 2), 99.5)
    wt.check_at_most("elsewhere off by, of 255", off, 0)


def test_at_a_low_angle_lines_want_more():
    """On flat water: the crests of a swell hide lines behind them."""
    scene = Scene(contour_lines, samples=4)
    scene.view.renderer.GetActiveCamera().SetPosition(-6, -14, 1)
    wt.check_at_most("of the lines with the default, %", round(100 * float(scene.shares()[1]), 2), 95)
    lay_on_water(scene.marks, nearer=640)
    wt.check_at_least("of the lines with four times as much, %", round(100 * float(scene.shares()[1]), 2), 99.5)


@pytest.mark.parametrize("look", ("opaque", "clear"))
def test_marks_of_a_mapper_of_any_data_show_too(look):
    """PyVista's is one."""
    scene = Scene(contour_lines, SWELL, samples=4, laid=False, **LOOKS[look])
    mapper = vtkDataSetMapper()
    mapper.SetInputConnection(scene.marks.GetMapper().GetInputConnection(0, 0))
    mapper.ScalarVisibilityOff()
    scene.marks.SetMapper(mapper)
    lay_on_water(scene.marks)
    _, share, off, _ = scene.shares()
    wt.check_at_least("of the lines in their colour, %", round(100 * float(share), 2), 99.5)
    wt.check_at_most("elsewhere off by, of 255", off, 0)


def test_other_objects_hide_them():
    """A post that stands on the lines."""
    scene = Scene(contour_lines)
    shown = scene.picture()
    scene.post.VisibilityOff()
    more = (scene.picture() == COLOR).all(axis=2).sum() - (shown == COLOR).all(axis=2).sum()
    wt.check_at_least("pixels of lines behind the post", int(more), 50)


def test_without_it_lines_are_broken_and_show_twice():
    """That is what the function is for: with VTK's own settings clear water shows them twice."""
    _, share, off, _ = Scene(contour_lines, SWELL, clear=True, laid=False).shares()
    wt.check_at_most("of the lines in their colour, %", round(100 * float(share), 2), 75)
    wt.check_at_least("elsewhere off by, of 255", off, 50)


def test_keys_of_the_user_stay():
    actor = Scene(contour_lines, laid=False).marks
    keys = vtkInformation()
    keys.Set(vtkWaterReflectionPass.STAND_IN(), vtkActor())
    actor.SetPropertyKeys(keys)
    lay_on_water(actor)
    lay_on_water(actor)
    wt.check_equal("key of the user", actor.GetPropertyKeys().Has(vtkWaterReflectionPass.STAND_IN()), 1)
    wt.check_equal("key of this", actor.GetPropertyKeys().Get(vtkWaterReflectionPass.NOT_REFLECTED()), 1)


def test_what_has_no_lines_is_refused():
    with pytest.raises(TypeError, match="actor must be a vtkActor, not float"):
        lay_on_water(3.0)
    with pytest.raises(ValueError, match="actor has no mapper"):
        lay_on_water(vtkActor())
    solid = wt.add_actor(wt.View(SIZE).renderer, wt.box((0, 0, 0), (1, 1, 1)), (1, 1, 1))
    with pytest.raises(ValueError, match="actor has 6 polygons; it must have only lines"):
        lay_on_water(solid)
    with pytest.raises(ValueError, match=r"nearer is -1; it must be in \[0, 60000\]"):
        lay_on_water(solid, nearer=-1)
    with pytest.raises(ValueError, match="nearer is nan"):
        lay_on_water(solid, nearer=float("nan"))
    with pytest.raises(TypeError, match="nearer must be a number in .* not str"):
        lay_on_water(solid, nearer="far")
    empty = vtkActor()
    empty.SetMapper(vtkPolyDataMapper())
    with pytest.raises(ValueError, match="actor shows nothing; it must show a vtkPolyData"):
        lay_on_water(empty)

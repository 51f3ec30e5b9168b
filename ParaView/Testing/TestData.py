# SPDX-License-Identifier: BSD-3-Clause
"""A solver's mesh becomes water: at its level, up to the shore, with its colours, its times and its current."""
import os
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
from water_scene import pv  # noqa: E402
from vtkmodules.vtkCommonDataModel import VTK_QUAD  # noqa: E402
import data_scene  # noqa: E402

FRONT = 70  # rows of the picture below the basin's front rim, under which a sheet is visible

water_scene.load()
data_scene.make_steps()


class TestData(unittest.TestCase):
    def setUp(self):
        pv.ResetSession()
        self.view = water_scene.make_view()
        water_scene.add_sphere(self.view, 1.2)
        self.reader = data_scene.open_steps(self.view)
        self.scene = pv.GetAnimationScene()

    def at(self, time, name):
        self.scene.AnimationTime = time
        return water_scene.picture(self.view, name)

    def test_the_water_is_that_of_a_sheet_at_the_level(self):
        """A flat lake is the sheet that the land hides at the same line."""
        dry = self.at(1.0, "data-dry")
        surface = data_scene.surface_of(self.reader)
        shown = pv.Show(surface, self.view)
        lake = self.at(1.0, "data-lake")
        self.assertAlmostEqual(water_scene.of(shown, "MeanLevel"), 0.4, places=6)
        self.assertIn("WaterDepth", surface.PointData.keys())
        pv.Hide(surface, self.view)
        pv.Show(pv.Water(Level=0.4, Extent="Bounds", SheetBounds=[-4.0, 4.0, -4.0, 4.0]), self.view)
        sheet = self.at(1.0, "data-sheet")
        self.assertGreater(water_scene.differing(dry, lake), 6000)
        self.assertLess(water_scene.differing(lake[FRONT:], sheet[FRONT:], 2),
                        0.01 * water_scene.differing(dry, lake))

    def test_any_two_heights_are_enough(self):
        pictures = []
        for arrays in ({"LevelArray": "zeta", "BedArray": "zb"}, {"DepthArray": "h", "BedArray": "zb"},
                       {"LevelArray": "zeta", "DepthArray": "h"}):
            surface = data_scene.surface_of(self.reader, **arrays)
            pv.Show(surface, self.view)
            pictures.append(self.at(0.0, "data-heights-%d" % len(pictures)))
            pv.Delete(surface)
        for other in pictures[1:]:
            self.assertLess(water_scene.differing(pictures[0][FRONT:], other[FRONT:], 2), 150)

    def test_the_water_rises_with_the_time(self):
        shown = pv.Show(data_scene.surface_of(self.reader), self.view)
        pictures = {}
        for time, level in data_scene.LEVELS.items():
            pictures[time] = self.at(time, "data-time-%g" % time)
            self.assertAlmostEqual(water_scene.of(shown, "MeanLevel"), level, places=6)
        self.assertGreater(water_scene.differing(pictures[0.0], pictures[2.0]), 3000)
        self.assertEqual(water_scene.differing(pictures[1.0], self.at(1.0, "data-time-again"), 0), 0)

    def test_an_array_colours_the_water(self):
        self.view.CameraPosition = [0.0, -0.1, 12.0]  # from above, where it hardly reflects
        surface = data_scene.surface_of(self.reader)
        shown = pv.Show(surface, self.view)
        shown.ReflectScene = 0
        shown.Glitter = 0
        plain = self.at(1.0, "data-plain")
        pv.ColorBy(shown, ("POINTS", "distance"))
        table = pv.GetColorTransferFunction("distance")
        table.RescaleTransferFunction(0.0, 3.5)
        colored = self.at(1.0, "data-colored")
        pv.Hide(surface, self.view)
        again = pv.Show(pv.ExtractSurface(Input=surface), self.view)  # as ParaView shows a mesh
        pv.ColorBy(again, ("POINTS", "distance"))
        table.RescaleTransferFunction(0.0, 3.5)  # ColorBy has fitted it to the data
        again.Ambient, again.Diffuse = 1.0, 0.0
        expected = self.at(1.0, "data-expected")
        self.assertGreater(water_scene.differing(plain, colored, 20), 6000)
        self.assertLess(water_scene.differing(colored, expected, 12), 200)
        pv.Hide(again.Input, self.view)
        pv.Show(surface, self.view)
        shown.DataOpacity = 0.0
        self.assertLess(water_scene.differing(plain, self.at(1.0, "data-clear"), 2), 50)

    def test_an_array_of_cells_colours_the_water(self):
        cells = pv.PointDatatoCellData(Input=self.reader, PassPointData=1)
        surface = data_scene.surface_of(cells)
        shown = pv.Show(surface, self.view)
        plain = self.at(1.0, "data-cells-plain")
        pv.ColorBy(shown, ("CELLS", "distance"))
        shown.RescaleTransferFunctionToDataRange(False, True)
        self.assertGreater(water_scene.differing(plain, self.at(1.0, "data-cells"), 20), 3000)

    def test_a_current_carries_the_waves(self):
        shown = pv.Show(data_scene.surface_of(self.reader), self.view)
        shown.Waves = "Sines"
        shown.SineWaves = [0.004, 0.3, 30.0, 0.003, 0.23, 100.0]
        still = self.at(2.0, "data-current-none")
        shown.FlowArray = "current"
        carried = self.at(2.0, "data-current")
        self.assertGreater(water_scene.differing(still, carried), 1500)
        shown.FlowArray = "None"
        self.assertEqual(water_scene.differing(still, self.at(2.0, "data-current-gone"), 0), 0)

    def test_any_surface_is_water_by_its_representation(self):
        dry = self.at(0.0, "data-any-dry")
        height = pv.Calculator(Input=self.reader, ResultArrayName="height", Function="0.3")
        level = pv.WarpByScalar(Input=height, Scalars=["POINTS", "height"])  # no polygons, but a structured grid
        shown = pv.Show(level, self.view, "WaterSurfaceRepresentation")
        shown.ColorArrayName = [None, ""]  # ParaView colours by an array that is alone
        sheet = self.at(0.0, "data-any")
        self.assertAlmostEqual(water_scene.of(shown, "MeanLevel"), 0.3, places=6)
        pv.Hide(level, self.view)
        pv.Show(pv.Water(Level=0.3, Extent="Bounds", SheetBounds=[-4.0, 4.0, -4.0, 4.0]), self.view)
        self.assertGreater(water_scene.differing(dry, sheet), 6000)
        self.assertLess(water_scene.differing(sheet, self.at(0.0, "data-any-sheet"), 2), 20)

    def show_tilted(self, data, name):
        """The picture of data as water, its mean level, and where ParaView's camera stands to see all of it."""
        source = pv.TrivialProducer()
        source.GetClientSideObject().SetOutput(data)
        view = water_scene.make_view()
        water_scene.add_sphere(view, 1.2)
        shown = pv.Show(source, view, "WaterSurfaceRepresentation")
        shown.ColorArrayName = [None, ""]
        picture = water_scene.picture(view, name)
        level = water_scene.of(shown, "MeanLevel")
        self.assertEqual(water_scene.of(shown, "LastError"), "")
        view.ResetCamera()
        seen_from = view.GetActiveCamera().GetPosition()
        pv.Delete(view)
        pv.Delete(source)
        return picture, level, seen_from

    def test_hidden_cells_and_points_are_no_water(self):
        """Whatever heights they have: picture, level and bounds are those of the cells that are left."""
        _, level, seen_from = self.show_tilted(data_scene.tilted(None), "data-hidden-no-fill")
        expected, _, _ = self.show_tilted(data_scene.tilted("none"), "data-hidden-none")  # its points take fewer digits
        for kind in ("cells", "points"):
            for form in ("grid", "mesh"):
                data = data_scene.tilted(kind, form)
                picture, found, place = self.show_tilted(data, "data-hidden-%s-%s" % (kind, form))
                off = water_scene.differing(expected, picture)
                print("hidden %s of a %s: %d pixels are off, mean level %.9g, %.9g" % (kind, form, off, found, level))
                with self.subTest(kind=kind, form=form):
                    self.assertEqual(off, 0)
                    self.assertAlmostEqual(found, level, places=6)
                    for one, other in zip(place, seen_from):
                        self.assertAlmostEqual(one, other, places=6)
                if form == "mesh":  # what is shown is as it was
                    self.assertEqual({data.GetCellType(cell) for cell in range((data_scene.COUNT - 1) ** 2)}, {VTK_QUAD})

    def test_a_state_file_restores_the_surface(self):
        shown = pv.Show(data_scene.surface_of(self.reader), self.view)
        pv.ColorBy(shown, ("POINTS", "h"))
        shown.Preset = "lake"
        shown.DataOpacity = 0.7
        expected = self.at(1.0, "data-state")
        pv.SaveState(water_scene.path("data.pvsm"))
        pv.ResetSession()
        pv.LoadState(water_scene.path("data.pvsm"))
        view = pv.GetActiveViewOrCreate("RenderView")
        view.ViewSize = water_scene.SIZE
        self.assertEqual(water_scene.differing(expected, water_scene.picture(view, "data-state-loaded"), 0), 0)

    def test_frames_of_lower_detail_show_the_water(self):
        self.view.LODThreshold = 0.0
        shown = pv.Show(data_scene.surface_of(self.reader), self.view)
        self.at(1.0, "data-fine")
        before = water_scene.of(shown, "ReflectionRenders")
        self.view.SMProxy.InteractiveRender()
        self.assertGreater(water_scene.of(shown, "ReflectionRenders"), before)  # of the land's coarse mesh
        self.assertEqual(water_scene.of(shown, "LastError"), "")


water_scene.main()

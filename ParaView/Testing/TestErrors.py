# SPDX-License-Identifier: BSD-3-Clause
"""What is wrong is said in words, and the picture stays."""
import os
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
from water_scene import pv  # noqa: E402

PROGRAM = '''
import sys
sys.path.insert(0, %r)
import water_scene
from water_scene import pv
%s
'''


class TestErrors(unittest.TestCase):
    def run_program(self, text):
        """Runs it by another pvpython: what VTK says of an error goes to the process's output."""
        file = water_scene.path("errors.py")
        with open(file, "w", encoding="utf-8") as stream:
            stream.write(PROGRAM % (os.path.dirname(os.path.abspath(__file__)), text))
        return subprocess.run([os.environ["WATER_PVPYTHON"], "--force-offscreen-rendering", file], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120, check=False).stdout

    def test_without_the_plugin_there_is_no_water(self):
        said = self.run_program("pv.Water()")
        self.assertRegex(said, "AttributeError: .*no attribute 'Water'")

    def test_a_state_without_the_plugin_says_what_is_missing(self):
        said = self.run_program("water_scene.load()\nview = water_scene.make_view()\n"
                                "water_scene.add_water(view)\npv.SaveState(water_scene.path('errors.pvsm'))")
        self.assertNotIn("Error", said)
        said = self.run_program("pv.LoadState(water_scene.path('errors.pvsm'))\nprint('the end')")
        self.assertRegex(said, "Water")
        self.assertIn("the end", said)

    def check_value(self, name, value, *words):
        """The error says these words, once, and the picture is that of the value before."""
        said = self.run_program(f'''
water_scene.load()
view = water_scene.make_view()
water_scene.add_sphere(view)
shown = water_scene.add_water(view, Waves="Wind Sea", MetresPerUnit=1.0)
before = water_scene.picture(view, "error-before")
shown.{name} = {value!r}
for _ in range(3):
    pv.Render(view)
after = water_scene.picture(view, "error-after")
print("pixels differ:", water_scene.differing(before, after, 0))
''')
        for word in words:
            self.assertIn(word, said)
        self.assertEqual(said.count(words[0]), 1, said)
        self.assertIn("pixels differ: 0", said)

    def test_a_preset_that_does_not_exist(self):
        self.check_value("Preset", "puddle", "Preset is 'puddle'", "turbid river")

    def test_a_wind_out_of_range(self):
        self.check_value("WindSpeed", 1000.0, "1000", "[0.1, 100]")

    def test_a_texture_scale_out_of_range(self):
        self.check_value("TextureScale", 0.0, "TextureScale is 0", "16]")

    def test_a_quality_that_does_not_exist(self):
        self.check_value("Quality", "best", 'is "best"', "reference")

    def test_an_unknown_choice_and_property(self):
        said = self.run_program('''
water_scene.load()
shown = water_scene.add_water(water_scene.make_view())
for name, value in (("Refraction", "Perhaps"), ("Refractions", 1)):
    try:
        setattr(shown, name, value)
    except (AttributeError, ValueError) as error:
        print("refused", name, error)
''')
        self.assertIn("refused Refraction ", said)
        self.assertIn("refused Refractions ", said)

    def test_a_plane_without_a_normal(self):
        said = self.run_program('''
water_scene.load()
view = water_scene.make_view()
water = pv.Water(UsePlane=1, Normal=[0.0, 0.0, 0.0])
pv.Show(water, view)
pv.Render(view)
print("the end")
''')
        self.assertIn("Normal is (0, 0, 0); it must point out of the water", said)
        self.assertIn("the end", said)


water_scene.main()

# SPDX-License-Identifier: BSD-3-Clause
"""A plugin for another ParaView, and a module of another version, are refused in words."""
import os
import re
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
import ranks  # noqa: E402


class TestVersions(unittest.TestCase):
    def test_a_plugin_of_another_version_is_refused(self):
        """It wants libraries of its own ParaView, whose names have the version."""
        with open(water_scene.PLUGIN, "rb") as stream:
            data = stream.read()
        name = "-pv%s.so" % water_scene.SERIES
        major, minor = water_scene.SERIES.split(".")
        other_name = "-pv%s.%s.so" % (major, "9" * len(minor))
        self.assertTrue(name.encode() in data, name)
        other = water_scene.path("Water.so")
        with open(other, "wb") as stream:
            stream.write(data.replace(name.encode(), other_name.encode()))
        program = water_scene.path("other.py")
        with open(program, "w", encoding="utf-8") as stream:
            stream.write("from paraview.simple import *\nimport sys\ntry:\n    LoadPlugin(sys.argv[1], ns=globals())\n"
                         "except Exception as error:\n    print('refused:', error)\nprint('the end')\n")
        said = ranks.run([os.environ["WATER_PVPYTHON"], "--force-offscreen-rendering", program, other])
        self.assertRegex(said, re.escape(other_name) + r"\S*: cannot open shared object file")
        self.assertIn("refused:", said)

    def test_a_module_of_another_version_is_refused(self):
        """As from another package, whose folder comes first in the path of libraries."""
        folder = water_scene.path("other-module")
        os.makedirs(folder, exist_ok=True)
        with open(os.environ["WATER_MODULE"], "rb") as stream:
            data = stream.read()
        version = os.environ["WATER_VERSION"].encode() + b"\0"
        self.assertEqual(data.count(version), 1)
        with open(os.path.join(folder, os.path.basename(os.environ["WATER_MODULE"])), "wb") as stream:
            stream.write(data.replace(version, b"9" + version[1:]))
        program = water_scene.path("module.py")
        with open(program, "w", encoding="utf-8") as stream:
            stream.write("import sys\nsys.path.insert(0, %r)\nimport water_scene\nfrom water_scene import pv\n"
                         "water_scene.load()\nview = water_scene.make_view()\nwater_scene.add_water(view)\n"
                         "pv.Render(view)\nprint('the end')\n" % os.path.dirname(os.path.abspath(__file__)))
        environment = {**ranks.ENVIRONMENT, "LD_LIBRARY_PATH": folder + ":" + os.environ.get("LD_LIBRARY_PATH", "")}
        said = subprocess.run([os.environ["WATER_PVPYTHON"], "--force-offscreen-rendering", program], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=ranks.LIMIT, check=False,
                              env=environment).stdout
        self.assertIn("has version 9%s, but the plugin was built with version %s" %
                      (os.environ["WATER_VERSION"][1:], os.environ["WATER_VERSION"]), said)
        self.assertIn("the end", said)


water_scene.main()

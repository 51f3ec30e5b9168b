# SPDX-License-Identifier: BSD-3-Clause
"""The package for Debian has all that the plugin needs beside ParaView: unpacked anywhere, it shows the same."""
import glob
import os
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
import ranks  # noqa: E402

PICTURE = '''
import sys
sys.path.insert(0, %r)
import water_scene
water_scene.load()
view = water_scene.make_view()
water_scene.add_sphere(view)
water_scene.add_water(view, Preset="lake")
water_scene.picture(view, sys.argv[1])
print("mapped", *{line.split()[-1] for line in open("/proc/self/maps") if "Water" in line})
print("the end")
''' % os.path.dirname(os.path.abspath(__file__))


def picture(name, **environment):
    file = water_scene.path("package.py")
    with open(file, "w", encoding="utf-8") as stream:
        stream.write(PICTURE)
    done = subprocess.run([os.environ["WATER_PVPYTHON"], "--force-offscreen-rendering", file, name], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120, check=False,
                          env=dict(ranks.ENVIRONMENT, **environment))
    return done.stdout


class TestPackage(unittest.TestCase):
    def test_the_package_alone_shows_the_water(self):
        folder = water_scene.path("package")
        shutil.rmtree(folder, ignore_errors=True)
        subprocess.run([os.environ["WATER_CPACK"], "--config", os.environ["WATER_CPACK_CONFIG"], "-B", folder],
                       check=True, stdout=subprocess.DEVNULL)
        package, = glob.glob(os.path.join(folder, "vtkwater-paraview_*.deb"))
        about = subprocess.run(["dpkg-deb", "-f", package, "Depends"], check=True, text=True,
                               stdout=subprocess.PIPE).stdout
        major, minor = map(int, water_scene.SERIES.split("."))
        self.assertIn("paraview (>= %d.%d), paraview (<< %d.%d~)" % (major, minor, major, minor + 1), about)
        root = os.path.join(folder, "root")
        subprocess.run(["dpkg", "-x", package, root], check=True)
        files = sorted(name for _, _, names in os.walk(root) for name in names)
        self.assertEqual(files, ["Water.so", "copyright", "libvtkRenderingWater.so", "libvtkWaterRepresentations.so"])
        plugin, = glob.glob(os.path.join(root, "usr/lib/*/paraview-%s/plugins/Water/Water.so" % water_scene.SERIES))
        of_paraview = [part for part in os.environ["LD_LIBRARY_PATH"].split(":") if "/install/" not in part]
        said = picture("package", WATER_PLUGIN=plugin, LD_LIBRARY_PATH=":".join(of_paraview))
        self.assertIn("the end", said)
        for mapped in said.split("mapped ")[1].splitlines()[0].split():
            self.assertTrue(mapped.startswith(root), mapped)
        self.assertIn("the end", picture("package-expected"))
        self.assertEqual(water_scene.differing(water_scene.read(water_scene.path("package.png")),
                                               water_scene.read(water_scene.path("package-expected.png")), 0), 0)


water_scene.main()

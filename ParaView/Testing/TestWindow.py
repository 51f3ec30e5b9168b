# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window loads the plugin by itself, its panels change the water, and the view shows it.

window.png, in the tests' output, is the whole window.
"""
import os
import struct
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import numpy  # noqa: E402
from vtkmodules.util.numpy_support import numpy_to_vtk  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkImageData  # noqa: E402
from vtkmodules.vtkIOImage import vtkPNGWriter  # noqa: E402
import water_scene  # noqa: E402
import ranks  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
LIMIT = 120  # seconds
SETTINGS = """[General]
GeneralSettings.ShowWelcomeDialog=false

[MainWindow]
Size=@Size(1200 1000)
Position=@Point(0 0)
"""


def screen(folder):
    """The picture of the X server's screen, rows from below, from its file in the format of xwd."""
    with open(os.path.join(folder, "Xvfb_screen0"), "rb") as stream:
        data = stream.read()
    header = struct.unpack(">25I", data[:100])
    width, height, line, colors = header[4], header[5], header[12], header[19]
    rows = numpy.frombuffer(data, numpy.uint8, line * height, header[0] + 12 * colors).reshape(height, line)
    return rows[::-1, :4 * width].reshape(height, width, 4)[:, :, 2::-1].astype(int)


def write(picture, name):
    image = vtkImageData()
    image.SetDimensions(picture.shape[1], picture.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(picture.reshape(-1, 3).astype(numpy.uint8), deep=True))
    writer = vtkPNGWriter()
    writer.SetFileName(water_scene.path(name))
    writer.SetInputData(image)
    writer.Write()


class TestWindow(unittest.TestCase):
    def start(self, *arguments):
        """ParaView's window on a screen of its own, which is a file in the folder of the settings."""
        home = water_scene.path("window")
        os.makedirs(os.path.join(home, "ParaView"), exist_ok=True)
        for name in ("ParaView%s.ini" % water_scene.VERSION, "ParaView.ini"):  # 6.1: the second
            with open(os.path.join(home, "ParaView", name), "w", encoding="utf-8") as stream:
                stream.write(SETTINGS)
        command = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset -fbdir " + home,
                   os.environ["WATER_PARAVIEW"], "--plugin-search-paths=" + os.path.dirname(water_scene.PLUGIN),
                   "--plugins=Water", "--script=" + os.path.join(HERE, "window_program.py"), *arguments]
        environment = dict(ranks.ENVIRONMENT, XDG_CONFIG_HOME=home, HOME=home)
        environment.pop("DISPLAY", None)
        return home, subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                      env=environment, start_new_session=True)

    def stop(self, started):
        """Ends the server and the window, which are one process group."""
        os.killpg(started.pid, 15)
        started.communicate(timeout=30)

    def test_the_panels_change_the_water(self):
        state = water_scene.path("window.pvsm")
        if os.path.exists(state):
            os.remove(state)
        _, started = self.start("--test-directory=" + water_scene.OUTPUT, "--exit",
                                "--test-script=" + os.path.join(HERE, "window_events.xml"))
        try:
            said = started.communicate(timeout=LIMIT)[0]
        except subprocess.TimeoutExpired:
            self.stop(started)
            raise
        self.assertEqual(started.returncode, 0, said)
        values = {}
        for proxy in xml.etree.ElementTree.parse(state).iter("Proxy"):
            if proxy.get("type") in ("Water", "WaterRepresentation"):
                for one in proxy.iter("Property"):
                    element = one.find("Element")
                    values[one.get("name")] = None if element is None else element.get("value")
        self.assertEqual(values["Level"], "0.25")
        self.assertEqual(values["Preset"], "lake")
        self.assertEqual(values["Waves"], "2")
        self.assertEqual(values["WindSpeed"], "7.5")

    def test_the_window_shows_the_water(self):
        home, started = self.start()
        try:
            red = blue = 0
            end = time.monotonic() + LIMIT
            while time.monotonic() < end and not (red > 300 and blue > 20000):
                time.sleep(1.0)
                if not os.path.exists(os.path.join(home, "Xvfb_screen0")):
                    continue
                picture = screen(home)
                view = picture[60:800, 300:1190]  # without the panels
                gray = numpy.abs(view - view[:, :, :1]).max(axis=2) < 3
                water = numpy.abs(view - [36, 78, 107]).max(axis=2) < 30
                red, blue = int((gray & (view[:, :, 0] > 120)).sum()), int(water.sum())
            time.sleep(3.0)  # the panels are laid out last
            write(screen(home), "window.png")
            self.assertGreater(red, 300)
            self.assertGreater(blue, 20000)
        finally:
            self.stop(started)


water_scene.main()

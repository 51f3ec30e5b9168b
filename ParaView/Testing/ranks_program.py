# SPDX-License-Identifier: BSD-3-Clause
"""A scene in pieces with water, for TestRanks.py: pvbatch on some ranks, or a client of a server.

    ranks_program.py NAME [--dry] [--look calm|sea|basin|balls] [--server PORT]

Writes NAME.png and NAME-animation.png, and says how many pixels the ranks have sent each other. Connected to a
server, which renders both, it also writes NAME-local.png, which the client renders, and NAME-remote-again.png.
"""
import argparse
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
from water_scene import pv  # noqa: E402
import data_scene  # noqa: E402

SIZE = [1280, 720]
STEPS = 20
DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../Examples/Data/jacksboro.vti")
LEVEL = 768.0


def make_scene(view):
    """Mountains that each rank has a part of; heights are doubled. Returns their bounds."""
    reader = pv.XMLImageDataReader(FileName=[DATA])
    reader.UpdatePipeline()
    name = reader.PointData.GetArray(0).Name
    warp = pv.WarpByScalar(Input=reader, ScaleFactor=2.0, Scalars=["POINTS", name])
    land = water_scene.add_normals(pv.ExtractSurface(Input=warp))
    shown = pv.Show(land, view)
    shown.ColorArrayName = ["POINTS", name]
    lut = pv.GetColorTransferFunction(name)
    lut.RGBPoints = [200.0, 0.40, 0.36, 0.27, 412.0, 0.30, 0.34, 0.19, 750.0, 0.31, 0.32, 0.19,
                     1000.0, 0.66, 0.64, 0.61, 1100.0, 0.90, 0.90, 0.91]
    lut.ColorSpace = "RGB"
    shown.LookupTable = lut
    return reader.GetDataInformation().GetBounds()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("name")
    parser.add_argument("--dry", action="store_true")
    parser.add_argument("--look", choices=("calm", "sea", "basin", "balls"), default="calm")
    parser.add_argument("--server")
    options = parser.parse_args()
    water_scene.begin(options.server)
    view = pv.CreateView("RenderView")
    view.ViewSize = SIZE
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Gradient"
    view.Background = [1.0, 0.97, 0.9]
    view.Background2 = [0.24, 0.46, 0.74]
    view.RemoteRenderThreshold = 0.0
    shown, rise = (basin if options.look == "basin" else mountains)(view, options)
    pv.Render(view)
    pv.Render(view)
    water_scene.picture(view, options.name, SIZE)
    if options.server:
        for name, threshold in (("-local", 1e6), ("-remote-again", 0.0)):
            view.RemoteRenderThreshold = threshold
            pv.Render(view)
            water_scene.picture(view, options.name + name, SIZE)
    if shown:
        count(view, shown, rise)
    animate(view, rise)
    water_scene.picture(view, options.name + "-animation", SIZE)
    print("the end")
    sys.stdout.flush()


def mountains(view, options):
    """Mountains and a sheet. Returns its representation, if any, and how far the camera rises a step."""
    bounds = make_scene(view)
    shown = None
    if not options.dry:
        shown = pv.Show(pv.Water(Level=LEVEL, Extent="Bounds", SheetBounds=bounds[:4]), view)
        if options.look == "sea":
            shown.MetresPerUnit = 1.0
            shown.Waves = "Wind Sea"
            shown.WindSpeed = 4.0

    def place(east, north):
        return [bounds[0] + east * (bounds[1] - bounds[0]), bounds[2] + north * (bounds[3] - bounds[2])]
    if options.look == "balls":
        add_balls(view, place)
    view.CameraPosition = place(0.831, 0.233) + [LEVEL + 150.0]
    view.CameraFocalPoint = place(0.530, 0.122) + [LEVEL + 200.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraViewAngle = 32.0
    return shown, 5.0


def add_balls(view, place):
    """Translucent balls in and above the water, near and far: ParaView blends the ranks' pictures in their order.

    A ball is a source that gives each rank a part; a box would be on all ranks, and blended several times.
    """
    radius = 0.025 * (place(1, 0)[0] - place(0, 0)[0])
    for east, north, color in ((0.74, 0.21, [0.9, 0.2, 0.1]), (0.66, 0.15, [0.1, 0.8, 0.3]),
                               (0.58, 0.16, [0.2, 0.2, 0.9])):
        ball = pv.Sphere(Radius=radius, Center=place(east, north) + [LEVEL + 0.5 * radius], ThetaResolution=48,
                         PhiResolution=48)
        shown = pv.Show(ball, view)
        shown.Opacity = 0.5
        shown.DiffuseColor = shown.AmbientColor = color


def basin(view, options):
    """A solver's lake, which rises with the time. Returns the same."""
    reader = data_scene.open_steps(view)
    water_scene.add_sphere(view, 1.2)
    shown = None
    if not options.dry:
        shown = pv.Show(data_scene.surface_of(reader), view)
        pv.ColorBy(shown, ("POINTS", "distance"))
        pv.GetColorTransferFunction("distance").RescaleTransferFunction(0.0, 4.0)
    view.CameraPosition = [0.0, -6.0, 2.0]
    view.CameraFocalPoint = [0.0, 0.0, 0.2]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    return shown, 0.05


def move(view, height):
    view.CameraPosition = [*view.CameraPosition[:2], height]


def count(view, shown, rise):
    still = []
    for _ in range(4):
        pv.Render(view)
        still.append(water_scene.of(shown, "PixelsJoined"))
    height = view.CameraPosition[2]
    move(view, height + rise)
    pv.Render(view)
    moved = water_scene.of(shown, "PixelsJoined")
    move(view, height)
    pv.Render(view)
    print("pixels joined in still frames:", *still)
    print("pixels joined when moved:", moved)
    print("mirrored views:", water_scene.of(shown, "ReflectionRenders"), water_scene.of(shown, "Decision"))


def animate(view, rise):
    """Steps in which the waves, the data and the camera move."""
    scene = pv.GetAnimationScene()
    scene.EndTime = 10.0
    height = view.CameraPosition[2]
    for step in range(STEPS):
        scene.AnimationTime = 0.25 * step
        move(view, height + rise * step)
        pv.Render(view)


main()

# SPDX-License-Identifier: BSD-3-Clause
"""What a user does with a view, for TestFeatures.py: pvpython, pvbatch on some ranks, or a client of a server.

    features_program.py NAME [--dry] [--frames NUMBER] [--server PORT]

Writes NAME-*.png: a frame at rest, one during an interaction and the one after it, a state file loaded again, a
screenshot larger than the view, an animation, and every tenth of so many frames of random changes. Says how many mirrored
views the first three steps took, and how many pixels the ranks have sent each other.
"""
import argparse
import os
import random
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import water_scene  # noqa: E402
from water_scene import pv  # noqa: E402
from vtkmodules.vtkIOImage import vtkPNGWriter  # noqa: E402
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter  # noqa: E402

EVERY = 10  # of the random frames is written
PRESETS = ("none", "pool", "lake", "clear tropical", "ocean wind 5", "turbid river", "mirror floor")
COLORS = ((1.0, 0.0, 0.0), (0.2, 0.8, 0.1), (0.9, 0.8, 0.1))


def make_scene(is_dry):
    """Balls, of which each rank has a part, and a wind sea. Returns view, balls and the water's representation."""
    view = water_scene.make_view()
    balls = []
    for number, color in enumerate(COLORS):
        ball = pv.Sphere(Radius=0.5, Center=[1.4 * (number - 1), 0.4 * number, 0.45], ThetaResolution=48,
                         PhiResolution=48)
        shown = pv.Show(ball, view)
        shown.DiffuseColor = shown.AmbientColor = list(color)
        balls.append(shown)
    shown = None
    if not is_dry:
        shown = water_scene.add_water(view, Waves="Wind Sea", WindSpeed=3.0, MetresPerUnit=1.0)
    view.RemoteRenderThreshold = 0.0
    view.ImageReductionFactor = 1  # or a server sends smaller pictures during an interaction,
    view.CompressorConfig = "NULL"  # and colours of fewer bits
    return view, balls, shown


def grab(view, name):
    """What the window shows, which is not rendered again for it: on the first rank, or the client."""
    reader = vtkWindowToImageFilter()
    reader.SetInput(view.GetRenderWindow())
    reader.ShouldRerenderOff()
    reader.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(reader.GetOutputPort())
    writer.SetFileName(water_scene.path(name + ".png"))
    writer.Write()


def say(what, shown):
    if shown:
        print("%s: %d %d" % (what, water_scene.of(shown, "ReflectionRenders"), water_scene.of(shown, "PixelsJoined")))


def interact(view, shown, name):
    """Frames at rest, of an interaction, and at rest again."""
    view.LODThreshold = 0.0  # all data count as large
    view.LODResolution = 0.0
    for _ in range(3):  # data that a representation has taken over may be new once more
        pv.Render(view)
    say("still", shown)
    water_scene.picture(view, name + "-still")
    for _ in range(3):
        view.SMProxy.InteractiveRender()
    say("coarse", shown)
    view.SMProxy.InteractiveRender()
    say("coarse again", shown)
    grab(view, name + "-coarse")
    pv.Render(view)
    say("fine", shown)
    grab(view, name + "-fine")


def load_state(file, server):
    """In pvbatch, ParaView 6.1 reads the file on the first rank only, which then waits for the others without end
    (vtkSMSessionProxyManager::LoadString updates a source, and the update asks all ranks), with and without water."""
    if server or int(water_scene.SERIES.split(".")[0]) < 6:
        pv.LoadState(file)
        return
    from paraview.modules.vtkRemotingCore import vtkPVSession
    pv.LoadState(file, location=vtkPVSession.SERVERS)


def reload(view, name, server):
    """The state of a file, in place of what there is. Returns its view."""
    file = water_scene.path(name + ".pvsm")
    pv.SaveState(file)
    for source in list(pv.GetSources().values()):
        pv.Delete(source)
    pv.Delete(view)
    del view
    load_state(file, server)
    view = pv.GetActiveViewOrCreate("RenderView")
    view.ViewSize = water_scene.SIZE
    water_scene.picture(view, name + "-loaded")
    return view


def animate(view, name):
    scene = pv.GetAnimationScene()
    scene.PlayMode = "Sequence"
    scene.StartTime, scene.EndTime, scene.NumberOfFrames = 0.0, 2.0, 3
    pv.SaveAnimation(water_scene.path(name + "-movie.png"), view, ImageResolution=list(water_scene.SIZE),
                     FrameWindow=[0, 2])
    scene.AnimationTime = 0.0


def change(view, balls, shown, kind, dice):
    """One of a user's changes. The same numbers are drawn with and without water."""
    number, value = dice.randrange(60), dice.random()
    if kind == 0 and shown:
        shown.Visibility = int(value > 0.3)
    elif kind == 1:
        balls[number % len(balls)].Visibility = int(value > 0.25)
    elif kind == 2 and shown:
        shown.Preset = PRESETS[number % len(PRESETS)]
    elif kind == 3:
        view.ViewSize = [160 + 4 * number, 120 + 3 * number]
    elif kind == 4:
        view.RemoteRenderThreshold = 1e6 if value < 0.5 else 0.0  # the client renders, or the server does
    elif kind == 5:
        view.CameraPosition = [6.0 * value - 3.0, -6.0, 1.0 + 0.05 * number]
    elif kind == 6:
        view.ViewTime = 10.0 * value
    elif kind == 7:
        view.SMProxy.InteractiveRender()


def toggle(view, balls, shown, name, frames):
    """Random changes, the same in each way of running this."""
    dice = random.Random(11)
    done = [0] * 8
    for frame in range(frames):
        kind = dice.randrange(8)
        done[kind] += 1
        change(view, balls, shown, kind, dice)
        pv.Render(view)
        if frame % EVERY == EVERY - 1:
            water_scene.picture(view, "%s-frame-%d" % (name, frame))
    print("changes:", *done)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("name")
    parser.add_argument("--dry", action="store_true")
    parser.add_argument("--frames", type=int, default=60)
    parser.add_argument("--server")
    options = parser.parse_args()
    water_scene.begin(options.server)
    view, balls, shown = make_scene(options.dry)
    interact(view, shown, options.name)
    toggle(view, balls, shown, options.name, options.frames)
    for ball in balls:
        ball.Visibility = 1
    if shown:
        shown.Visibility = 1
    view.ViewSize = water_scene.SIZE
    view.RemoteRenderThreshold = 0.0
    water_scene.picture(view, options.name + "-large", [2 * size for size in water_scene.SIZE])
    animate(view, options.name)
    del balls, shown
    water_scene.picture(view, options.name + "-saved")
    reload(view, options.name, options.server)
    print("the end")
    sys.stdout.flush()


main()

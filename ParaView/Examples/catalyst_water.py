# SPDX-License-Identifier: BSD-3-Clause
"""A Catalyst script: pictures of a simulation's water while it runs.

The simulation hands over a mesh with the arrays "depth" and "bed" as the channel "input". Each picture has the
simulation's time. WATER_PLUGIN names the plugin's file, WATER_PICTURES the pictures' folder.
"""
import os

from paraview.simple import *  # noqa: F401,F403 (as ParaView's own scripts have it)
from paraview import catalyst

LoadPlugin(os.environ["WATER_PLUGIN"], remote=False, ns=globals())  # noqa: F405

view = CreateView("RenderView")  # noqa: F405
view.ViewSize = [640, 480]
view.OrientationAxesVisibility = 0
view.CameraPosition = [0.0, -6.0, 3.0]
view.CameraFocalPoint = [0.0, 0.0, 0.0]
view.CameraViewUp = [0.0, 0.0, 1.0]

producer = TrivialProducer(registrationName="input")  # noqa: F405
land = Show(WarpByScalar(Input=producer, Scalars=["POINTS", "bed"]), view)  # noqa: F405
land.ColorArrayName = [None, ""]
land.DiffuseColor = [0.55, 0.5, 0.35]
water = Show(WaterSurface(Input=producer, DepthArray="depth", BedArray="bed"), view)  # noqa: F405
water.Waves = "Sines"
water.SineWaves = [0.004, 0.3, 30.0]

pictures = CreateExtractor("PNG", view, registrationName="pictures")  # noqa: F405
pictures.Writer.FileName = "water_{timestep:04d}.png"
pictures.Writer.ImageResolution = [640, 480]

options = catalyst.Options()
options.ExtractsOutputDirectory = os.environ.get("WATER_PICTURES", ".")
options.GlobalTrigger.Frequency = 2  # every second step

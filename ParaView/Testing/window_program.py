# SPDX-License-Identifier: BSD-3-Clause
"""What TestWindow.py shows in ParaView's window: the plugin is loaded already."""
from paraview.simple import *  # noqa: F401,F403 (as ParaView's Python shell has it)

view = GetActiveViewOrCreate("RenderView")  # noqa: F405
Show(Sphere(Center=[0.0, 0.0, 1.0], ThetaResolution=64, PhiResolution=64))  # noqa: F405
water = Water(Extent="Bounds", SheetBounds=[-4.0, 4.0, -4.0, 4.0])  # noqa: F405
Show(water)  # noqa: F405
SetActiveSource(water)  # noqa: F405
view.CameraPosition = [0.0, -6.0, 2.0]
view.CameraFocalPoint = [0.0, 0.0, 0.2]
view.CameraViewUp = [0.0, 0.0, 1.0]
Render()  # noqa: F405

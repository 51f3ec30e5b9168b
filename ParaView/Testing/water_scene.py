# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the plugin share: the plugin, a scene, pictures as arrays, and their end."""
import os
import sys
import unittest

import numpy
import paraview.simple as pv
from paraview.modules.vtkRemotingViews import vtkSMRepresentationProxy  # noqa: F401 (its methods, wrapped)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

OUTPUT = os.environ["WATER_TEST_OUTPUT"]
PLUGIN = os.environ["WATER_PLUGIN"]
VERSION = os.environ["WATER_PARAVIEW_VERSION"]  # of ParaView
SERIES = VERSION.rpartition(".")[0]  # its first two numbers, which are in the names of folders and libraries
SIZE = (320, 240)

pv._DisableFirstRenderCameraReset()


def load(remote=False):
    """Loads the plugin; the names of its proxies become those of paraview.simple."""
    pv.LoadPlugin(PLUGIN, remote=remote, ns=vars(pv))


def begin(server=None):
    """Loads the plugin, and before on a server that listens at this port, to which it connects."""
    if server:
        pv.Connect("localhost", int(server))
        load(remote=True)
    load()


def path(name):
    return os.path.join(OUTPUT, name)


def add_normals(surface):
    """The filter that adds point normals: it is GenerateSurfaceNormals up to ParaView 5.11."""
    return getattr(pv, "SurfaceNormals" if hasattr(pv, "SurfaceNormals") else "GenerateSurfaceNormals")(Input=surface)


def make_view(size=SIZE):
    """A view from above the water at z = 0 onto (0, 0, 0.2), with an even background."""
    view = pv.CreateView("RenderView")
    view.ViewSize = size
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.3, 0.4, 0.6]
    view.CameraPosition = [0.0, -6.0, 2.0]
    view.CameraFocalPoint = [0.0, 0.0, 0.2]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    return view


def add_sphere(view, z=1.0, color=(1.0, 0.0, 0.0), resolution=64):
    """A sphere of radius 0.5, of one colour without light and shade."""
    sphere = pv.Sphere(Radius=0.5, Center=[0.0, 0.0, z], ThetaResolution=resolution, PhiResolution=resolution)
    shown = pv.Show(sphere, view)
    shown.DiffuseColor = shown.AmbientColor = list(color)
    shown.Ambient = 1.0
    shown.Diffuse = 0.0
    return sphere


def add_water(view, **look):
    """A sheet of 8 x 8 at z = 0. Returns its representation."""
    water = pv.Water(Extent="Bounds", SheetBounds=[-4.0, 4.0, -4.0, 4.0])
    shown = pv.Show(water, view)
    for name, value in look.items():
        setattr(shown, name, value)
    return shown


def read(name):
    """The picture of a file as an array of rows from below, of red, green and blue."""
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3].astype(int)


def picture(view, name, size=None):
    """The view's picture, which is also left in a file for whoever looks into a failure."""
    file = path(name + ".png")
    pv.SaveScreenshot(file, view, ImageResolution=size or list(view.ViewSize))
    return read(file)


def differing(one, other, by=1):
    """Number of pixels that differ by more than `by` of 255 in a channel."""
    return int((numpy.abs(one - other).max(axis=2) > by).sum())


def of(shown, name):
    """A property that only informs, as it is now."""
    shown.SMProxy.UpdatePropertyInformation()
    return shown.SMProxy.GetProperty(name).GetElement(0)


def main():
    """Runs the module's tests. pvpython may leave the process with 0 after an error: this does not."""
    result = unittest.main(module="__main__", argv=sys.argv, exit=False, verbosity=2).result
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(0 if result.wasSuccessful() and result.testsRun > 0 else 1)

# SPDX-License-Identifier: BSD-3-Clause
"""vtk_view: the scene as plain VTK draws it, a window a view; the VTK peers add their water."""

from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkLight,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  its factories

VERSION = f"VTK {vtkVersion.GetVTKVersion()}"


def read_terrain(file):
    reader = vtkPLYReader()
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


class View:
    def __init__(self, scene, terrain):
        self.scene = scene
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(*scene["sky"])
        self.renderer.AutomaticLightCreationOff()
        sun = vtkLight()
        sun.SetLightTypeToSceneLight()
        sun.SetPosition(*scene["to_sun"])
        sun.SetFocalPoint(0.0, 0.0, 0.0)
        sun.SetColor(*scene["sun_color"])
        self.renderer.AddLight(sun)
        self.ground = self.add_mesh(terrain)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(*scene["size"])
        self.window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.SetViewUp(0.0, 0.0, 1.0)
        camera.SetViewAngle(scene["view_angle"])
        camera.SetClippingRange(*scene["clipping_range"])

    def add_mesh(self, mesh):
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(mesh)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetAmbient(self.scene["ambient"])
        actor.GetProperty().SetDiffuse(self.scene["diffuse"])
        self.renderer.AddActor(actor)
        return actor

    def render(self, eye, target):
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(*eye)
        camera.SetFocalPoint(*target)
        self.window.Render()
        self.window.WaitForCompletion()

    def save(self, file):
        capture = vtkWindowToImageFilter()
        capture.SetInput(self.window)
        capture.ReadFrontBufferOff()
        capture.ShouldRerenderOff()
        writer = vtkPNGWriter()
        writer.SetFileName(file)
        writer.SetInputConnection(capture.GetOutputPort())
        writer.Write()


def driver(view):
    """The GL renderer; the view has to have been drawn, or is."""
    view.window.Render()
    for line in view.window.ReportCapabilities().splitlines():
        name, _, value = line.partition(":")
        if name == "OpenGL renderer string":
            return value.strip()
    return "unnamed"

# SPDX-License-Identifier: BSD-3-Clause
"""Row Props of the mirror matrix: surfaces, how they are shaded and coloured."""

import mirror_matrix as mm
import numpy as np
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkPolyDataTangents
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkProperty, vtkTexture
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLTexture  # noqa: F401  factory

row = mm.Results("Props: surfaces", __file__)


def coarse_sphere(center=(0, 0, 0.4), radius=1.8, resolution=14):
    """A sphere whose facets can be seen, with texture coordinates and the height as scalars."""
    source = vtkSphereSource()
    source.SetCenter(center)
    source.SetRadius(radius)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    source.SetOutputPointsPrecision(1)
    source.Update()
    data = source.GetOutput()
    points = wt.vtk_to_numpy(data.GetPoints().GetData())
    angle = np.arctan2(points[:, 1] - center[1], points[:, 0] - center[0])
    coordinates = np.stack([0.5 + 0.5 * angle / np.pi, 0.5 * points[:, 2]], axis=1)
    data.GetPointData().SetTCoords(numpy_to_vtk(coordinates, deep=True))
    data.GetPointData().SetScalars(numpy_to_vtk(np.sin(3 * points[:, 2]), deep=True))
    return data


def cell(name, change, color=(1, 0.6, 0.2), data=coarse_sphere, **options):
    """change(actor) is what the cell is about."""

    def fill(scene, on):
        actor = scene.add_data(data(), color)
        scene.add_data(wt.box((2.7, 1, 0.3), (0.7, 0.7, 2.4)), (0.3, 0.8, 0.4))
        if on:
            change(actor)

    row.cell(name, fill, **options)


def shaded(interpolation):
    def change(actor):
        look = actor.GetProperty()
        look.SetInterpolation(interpolation)
        look.SetSpecular(0.7)
        look.SetSpecularPower(12)

    return change


row.cell("plain surface", lambda scene: scene.add_data(coarse_sphere()))
for name, interpolation in (("flat", 0), ("Gouraud", 1), ("Phong", 2)):
    cell(f"{name} shading with highlights", shaded(interpolation))


def texture_of(picture, mipmap=False, is_float=False):
    image = vtkImageData()
    height, width = picture.shape[:2]
    image.SetDimensions(width, height, 1)
    values = np.ascontiguousarray(picture.reshape(-1, picture.shape[2]))
    image.GetPointData().SetScalars(
        numpy_to_vtk(values.astype(np.float32 if is_float else np.uint8), deep=True))
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.InterpolateOn()
    texture.SetMipmap(mipmap)
    if is_float:
        texture.SetColorModeToDirectScalars()
    return texture


def squares(count=16, size=128):
    index = np.arange(size) * count // size
    black = (np.add.outer(index, index) % 2)[:, :, None]
    return np.where(black, (250, 250, 250), (30, 60, 160))


def surroundings():
    """A panorama of radiances: bright ahead, dark behind, with a warm stripe."""
    height, width = 32, 64
    v, u = np.mgrid[0:height, 0:width]
    sky = np.stack([0.3 + 0.02 * v, 0.5 + 0.01 * v, 0.9 - 0.01 * u], axis=2)
    sky[12:16, 10:24] = (4, 3, 1)
    return texture_of(sky, mipmap=True, is_float=True)


def with_tangents(data):
    normals = vtkPolyDataNormals()
    normals.SetInputData(data)
    tangents = vtkPolyDataTangents()
    tangents.SetInputConnection(normals.GetOutputPort())
    tangents.Update()
    return tangents.GetOutput()


def physical(with_environment=False, anisotropy=0.0, coat=0.0):
    def fill(scene, on):
        actor = scene.add_data(with_tangents(coarse_sphere(resolution=40)), (0.9, 0.7, 0.4))
        look = actor.GetProperty()
        if on or anisotropy or coat:
            look.SetInterpolationToPBR()
            look.SetMetallic(0.7)
            look.SetRoughness(0.25)
        if on:
            look.SetAnisotropy(anisotropy)
            look.SetCoatStrength(coat)
        if with_environment:
            renderer = scene.renderer
            renderer.UseImageBasedLightingOn()
            renderer.SetEnvironmentTexture(surroundings())
            renderer.GetEnvMapLookupTable().SetLUTSize(64)
            renderer.GetEnvMapLookupTable().SetLUTSamples(64)
            renderer.GetEnvMapPrefiltered().SetPrefilterLevels(3)
            renderer.GetEnvMapPrefiltered().SetPrefilterMaxSamples(32)

    return fill


row.cell("PBR", physical())
row.cell("PBR, anisotropic", physical(anisotropy=0.9))
row.cell("PBR with a clear coat", physical(coat=1.0))
row.cell("PBR with image-based lighting", physical(with_environment=True))
cell("texture", lambda actor: actor.SetTexture(texture_of(squares())))
cell("texture with mipmaps", lambda actor: actor.SetTexture(texture_of(squares(64, 256), mipmap=True)))


def open_cup(center=(0, 0, 1.0), radius=1.6):
    """The lower part of a ball without its top: its inside is seen from above, its outside in the water."""
    source = vtkSphereSource()
    source.SetCenter(center)
    source.SetRadius(radius)
    source.SetThetaResolution(40)
    source.SetPhiResolution(40)
    source.SetStartPhi(70)
    source.SetEndPhi(150)
    source.SetOutputPointsPrecision(1)
    source.Update()
    return source.GetOutput()


def two_sided(actor):
    back = vtkProperty()
    back.SetColor(0.1, 0.3, 1.0)
    actor.SetBackfaceProperty(back)


def turned_cup():
    """Open below: its inside is seen in the water."""
    return wt.transformed(open_cup((0, 0, 0)), mm.matrix_of((1, 0, 0, 0), (0, -1, 0, 0), (0, 0, -1, 1.4)))


cell("back-face property", two_sided, data=turned_cup)
cell("back faces culled", lambda actor: actor.GetProperty().BackfaceCullingOn(), data=turned_cup)
cell("front faces culled", lambda actor: actor.GetProperty().FrontfaceCullingOn(), data=turned_cup)


def edged(actor):
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0, 0, 0.4)
    actor.GetProperty().SetLineWidth(2)


cell("visible edges", edged)


def wired(actor):
    actor.GetProperty().SetRepresentationToWireframe()


cell("wireframe", wired)
cell("wireframe of wide lines", lambda actor: (wired(actor), actor.GetProperty().SetLineWidth(4)))
cell("wireframe unlit", lambda actor: (wired(actor), actor.GetProperty().LightingOff()))


def dotted(actor):
    actor.GetProperty().SetRepresentationToPoints()
    actor.GetProperty().SetPointSize(5)


cell("points", dotted)


def with_vertices(scene, on):
    actor = scene.add_data(coarse_sphere())
    look = actor.GetProperty()
    look.EdgeVisibilityOn()  # VTK 9.1 draws vertices with edges only
    look.SetVertexVisibility(on)
    look.SetVertexColor(0.8, 0, 0)
    look.SetPointSize(6)


row.cell("visible vertices", with_vertices)


def coloured(kind):
    def change(actor):
        mapper, data = actor.GetMapper(), actor.GetMapper().GetInput()
        mapper.ScalarVisibilityOn()
        if kind == "colours":
            values = wt.vtk_to_numpy(data.GetPoints().GetData())
            values = (127 + 127 * np.sin(4 * values)).astype(np.uint8)
            data.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
            return
        if kind == "of cells":
            count = data.GetNumberOfCells()
            data.GetCellData().SetScalars(numpy_to_vtk(np.arange(count) % 7.0, deep=True))
            mapper.SetScalarModeToUseCellData()
            mapper.SetScalarRange(0, 6)
        else:
            mapper.SetScalarRange(-1, 1)
            mapper.SetInterpolateScalarsBeforeMapping(kind == "before")
        table = vtkLookupTable()
        table.SetNumberOfTableValues(7)
        table.Build()
        mapper.SetLookupTable(table)

    return change


cell("vertex colours", coloured("colours"))
cell("scalars mapped, then interpolated", coloured("after"))
cell("scalars interpolated, then mapped", coloured("before"))
cell("scalars of cells", coloured("of cells"))
test_cell = row.test()

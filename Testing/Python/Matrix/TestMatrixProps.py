# SPDX-License-Identifier: BSD-3-Clause
"""Row Props of the mirror matrix: kinds of props and mappers."""

import mirror_matrix as mm
import numpy as np
import vtkmodules.vtkRenderingLOD  # noqa: F401  factories
import water_test as wt
from mirror_scene import as_vertices
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkRenderingAnnotation import vtkAxesActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkAssembly,
    vtkCompositeDataDisplayAttributes,
    vtkGlyph3DMapper,
    vtkImageActor,
    vtkImageSlice,
    vtkImageSliceMapper,
    vtkLODProp3D,
    vtkPointGaussianMapper,
    vtkPolyDataMapper,
    vtkPropAssembly,
    vtkRenderWindowInteractor,
)
from vtkmodules.vtkRenderingImage import vtkImageResliceMapper, vtkImageStack
from vtkmodules.vtkRenderingLOD import vtkLODActor, vtkQuadricLODActor

row = mm.Results("Props: kinds", __file__)


def cloud(count=120, low=-0.5, high=2.0, seed=3):
    """Points at random, as vertices."""
    generator = np.random.default_rng(seed)
    return as_vertices(generator.uniform((-2, -1, low), (2, 1.5, high), (count, 3)))


def sticks(count=25, low=-0.8, high=2.0):
    """Lines that lean, most of them through the water."""
    points, lines = vtkPoints(), vtkCellArray()
    points.SetDataTypeToDouble()
    for i in range(count):
        x, y = i % 5 - 2.0, i // 5 * 0.7 - 1
        points.InsertNextPoint(x, y, low)
        points.InsertNextPoint(x + 0.4 * ((i * 7) % 3 - 1), y + 0.2, high - 0.05 * i)
        lines.InsertNextCell(2, [2 * i, 2 * i + 1])
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    return data


# Points and lines.
def dots(size, data=cloud):
    def fill(scene):
        look = scene.add_data(data()).GetProperty()
        look.SetPointSize(size)
        look.SetLineWidth(size)

    return fill


row.cell("points of 1 pixel", dots(1, lambda: cloud(1500)))
row.cell("points of 7 pixels", dots(7))
row.cell("lines of 1 pixel", dots(1, sticks))
row.cell("lines of 4 pixels", dots(4, sticks))


def balls(data):
    def fill(scene):
        look = scene.add_data(data()).GetProperty()
        look.RenderPointsAsSpheresOn()
        look.SetPointSize(14)
        look.SetSpecular(0.5)

    return fill


row.cell("points as spheres", balls(cloud))


def tubes(data):
    def fill(scene):
        look = scene.add_data(data()).GetProperty()
        look.RenderLinesAsTubesOn()
        look.SetLineWidth(8)

    return fill


row.cell("lines as tubes", tubes(sticks))


def splats(data, opacity=1.0, shader=None):
    def fill(scene):
        mapper = vtkPointGaussianMapper()
        mapper.SetInputData(data())
        mapper.SetScaleFactor(0.12)
        mapper.ScalarVisibilityOff()
        mapper.SetEmissive(False)
        if shader:
            mapper.SetSplatShaderCode(shader)
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(1, 0.6, 0.2)
        actor.GetProperty().SetOpacity(opacity)
        scene.add(actor, cut=False)
        scene.cut_fragments(actor)

    return fill


DISK = """//VTK::Color::Impl
  if (dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy) > 1.0) discard;
"""
row.cell("point gaussians", splats(cloud))
row.cell("point gaussians, translucent", splats(cloud, 0.6))
row.cell("point gaussians as disks", splats(cloud, shader=DISK))
row.cell("point gaussians whose points are under the water", splats(lambda: cloud(low=-0.3, high=-0.1)))


# Glyphs and blocks.
def glyphs(scene):
    side = 100
    x, y = np.meshgrid(np.linspace(-5, 5, side), np.linspace(-3, 6, side))
    places = np.stack([x, y, 0.5 + np.sin(2 * x) * np.cos(y)], axis=2).reshape(-1, 3)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    data.GetPointData().SetScalars(numpy_to_vtk(places[:, 0].copy(), deep=True))
    data.GetPointData().SetVectors(numpy_to_vtk(np.roll(places, 1, axis=1).copy(), deep=True))
    cone = vtkConeSource()
    cone.SetResolution(6)
    mapper = vtkGlyph3DMapper()
    mapper.SetInputData(data)
    mapper.SetSourceConnection(cone.GetOutputPort())
    mapper.SetScaleModeToNoDataScaling()
    mapper.SetScaleFactor(0.15)
    mapper.OrientOn()
    mapper.SetOrientationArray(1)
    mapper.SetOrientationModeToDirection()
    mapper.SetScalarRange(-5, 5)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetSpecular(0.5)
    scene.add(actor)


row.cell("vtkGlyph3DMapper of 10,000 glyphs", glyphs)


def blocks(scene, on):
    try:
        from vtkmodules.vtkRenderingCore import vtkCompositePolyDataMapper as Mapper
        if mm.VTK_VERSION < (9, 3):
            raise ImportError
    except ImportError:
        from vtkmodules.vtkRenderingOpenGL2 import vtkCompositePolyDataMapper2 as Mapper
    data = vtkMultiBlockDataSet()
    for i in range(6):
        data.SetBlock(i, wt.sphere((i % 3 * 1.6 - 1.6, i // 3 * 2 - 1, 0.2 + 0.3 * i), 0.8, 20))
    mapper = Mapper()
    mapper.SetInputDataObject(data)
    look = vtkCompositeDataDisplayAttributes()
    mapper.SetCompositeDataDisplayAttributes(look)
    if on:
        for i in range(6):
            look.SetBlockColor(data.GetBlock(i), (0.2 * i, 1 - 0.15 * i, 0.5))
        look.SetBlockVisibility(data.GetBlock(4), False)
    actor = vtkActor()
    actor.SetMapper(mapper)
    scene.add(actor)
    scene.keep.append(data)


row.cell("composite mapper with colours and visibility of blocks", blocks)


# Images.
def picture(size=64):
    u, v = np.meshgrid(np.arange(size), np.arange(size))
    values = np.stack([255 * u / size, 255 * v / size, 127 + 127 * np.sin(u * v / 90)], axis=2)
    image = vtkImageData()
    image.SetDimensions(size, size, 1)
    image.SetSpacing(3.0 / size, 3.0 / size, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(values.reshape(-1, 3).astype(np.uint8), deep=True))
    return image


def stand(prop):
    """Raises a picture that lies in the plane z = 0, so that it stands half in the water."""
    prop.SetPosition(-1.6, 0.4, -1.0)
    prop.RotateX(78)
    return prop


def image_slice(scene):
    mapper = vtkImageSliceMapper()
    mapper.SetInputData(picture())
    image = vtkImageSlice()
    image.SetMapper(mapper)
    scene.add(stand(image))


def image_reslice(scene):
    mapper = vtkImageResliceMapper()
    deep = vtkImageData()
    deep.SetDimensions(64, 64, 24)
    deep.SetSpacing(3 / 64, 3 / 64, 3 / 24)
    deep.SetOrigin(-1.6, -1.5, -1.2)
    z, y, x = np.mgrid[0:24, 0:64, 0:64]
    values = (127 + 127 * np.sin(z / 3.0 + x / 9.0) * np.cos(y / 7.0)).astype(np.uint8)
    deep.GetPointData().SetScalars(numpy_to_vtk(values.ravel(), deep=True))
    mapper.SetInputData(deep)
    mapper.SetSlicePlane(wt.plane((0, 0, 0.2), (0.2, -1, 0.3)))
    image = vtkImageSlice()
    image.SetMapper(mapper)
    image.GetProperty().SetColorWindow(255)
    image.GetProperty().SetColorLevel(127)
    scene.add(image)


def image_actor(scene):
    image = vtkImageActor()
    image.SetInputData(picture())
    scene.add(stand(image))


def image_stack():
    """Two pictures, one on the other."""
    stack = vtkImageStack()
    for layer, size in enumerate((128, 64)):
        mapper = vtkImageSliceMapper()
        mapper.SetInputData(picture(size))
        image = vtkImageSlice()
        image.SetMapper(mapper)
        image.GetProperty().SetLayerNumber(layer)
        image.GetProperty().SetOpacity(1.0 - 0.4 * layer)
        image.SetPosition(0.8 * layer, 0, 0)
        stack.AddImage(image)
    stack.SetPosition(-1.6, -1.5, -0.9)  # flatter: what is under water would be seen over it
    stack.RotateX(35)
    return stack


def image_stack_in_assembly(scene):
    group = vtkPropAssembly()
    group.AddPart(image_stack())
    scene.add(group)


row.cell("vtkImageSlice", image_slice)
row.cell("vtkImageStack", lambda scene: scene.add(image_stack()))
row.cell("vtkImageStack in a vtkPropAssembly", image_stack_in_assembly)
row.cell("vtkImageSlice of vtkImageResliceMapper", image_reslice)
row.cell("vtkImageActor", image_actor)


# Assemblies and levels of detail.
def ball(height=0.3, color=(1, 0.6, 0.2), at=0.0):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(wt.sphere((at, 0, height), 0.8, 30))
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(color)
    actor.GetProperty().SetSpecular(0.5)
    return actor


def assembly(scene):
    inner, outer = vtkAssembly(), vtkAssembly()
    inner.AddPart(ball(0.2))
    inner.AddPart(ball(0.9, (0.3, 0.5, 1), 1.2))
    inner.RotateZ(40)
    inner.SetPosition(1.2, 0, 0)
    outer.AddPart(inner)
    outer.AddPart(ball(0.5, (0.5, 0.9, 0.3), -1.3))
    outer.RotateY(15)
    outer.SetScale(1.2)
    scene.add(outer)


def prop_assembly(scene):
    parts = vtkPropAssembly()
    parts.AddPart(ball(0.2, at=-1))
    parts.AddPart(ball(0.9, (0.3, 0.5, 1), 1.2))
    scene.add(parts)


row.cell("assembly in an assembly, moved", assembly)
row.cell("vtkPropAssembly", prop_assembly)


def lod_prop(scene):
    detail = vtkLODProp3D()
    mapper = ball().GetMapper()
    if scene.kind == mm.MIRRORED:
        mapper.AddClippingPlane(wt.plane(scene.origin, scene.normal))
    detail.AddLOD(mapper, 0.0)
    scene.add(detail, cut=False)


def lod_of(actor_class):
    def fill(scene):
        scene.window.SetInteractor(vtkRenderWindowInteractor())  # vtkQuadricLODActor::Render needs it
        actor = actor_class()
        actor.SetMapper(ball().GetMapper())
        actor.GetProperty().SetColor(0.3, 0.7, 1)
        scene.add(actor)

    return fill


row.cell("vtkLODProp3D", lod_prop)
row.cell("vtkLODActor", lod_of(vtkLODActor))
row.cell("vtkQuadricLODActor", lod_of(vtkQuadricLODActor))


def axes(scene):
    actor = vtkAxesActor()
    actor.AxisLabelsOff()
    actor.SetTotalLength(2.5, 2.5, 2.5)
    actor.SetShaftTypeToCylinder()
    actor.SetCylinderRadius(0.15)
    transform = vtkTransform()
    transform.Translate(-0.5, -1, 0.4)
    actor.SetUserTransform(transform)
    scene.add(wt.reflect(actor))


row.cell("vtkAxesActor over the water", axes)
test_cell = row.test()

# SPDX-License-Identifier: BSD-3-Clause
"""mirror_scene: one scene as the water shows it, and as VTK draws it mirrored, without any of our code."""

import numpy as np
import water_test as wt
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonMath import vtkMatrix4x4
from vtkmodules.vtkCommonTransforms import vtkMatrixToLinearTransform
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkCamera, vtkLight, vtkPolyDataMapper, vtkPropCollection, vtkTexture

SIZE = (240, 180)
SHEET = (-7, 7, -5, 7)
UP = (0.0, 0.0, 1.0)

SEEN, MIRRORED, COMPOSED = "seen", "mirrored", "composed"

# The sheet of the composed picture shows its texture by the place in the window.
BY_PLACE = """
  gl_FragData[0] = vec4(texelFetch(actortexture, ivec2(gl_FragCoord.xy), 0).rgb, opacity);
"""


def as_vertices(places):
    """Points as vertices of a mesh."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(places, deep=True))
    data = vtkPolyData()
    data.SetPoints(points)
    vertices = vtkCellArray()
    for i in range(len(places)):
        vertices.InsertNextCell(1, [i])
    data.SetVerts(vertices)
    return data


class Scene(wt.View):
    """One picture of a cell; kind tells what it is for.

    What is added with add() is cut at the water in the mirrored picture.
    """

    def __init__(self, kind, size=SIZE, background=(0.2, 0.3, 0.4), samples=0, origin=(0, 0, 0), normal=UP):
        super().__init__(size, background, samples)
        self.kind = kind
        self.origin, self.normal = np.asarray(origin, float), wt.unit(normal)
        camera = self.camera = self.renderer.GetActiveCamera()
        camera.SetPosition(1.5, -9, 4)
        camera.SetFocalPoint(0, 0, 0.2)
        camera.SetViewUp(0, 0, 1)
        camera.SetClippingRange(1, 60)
        self.keep = []  # what VTK does not hold on to
        self.freezes_lights = True
        self.is_cut_by_view = False
        self.when_mirrored = []  # to be called when the camera is

    def users_camera(self):
        """The user's camera, which stays where it is when the scene's is mirrored."""
        if self.kind != MIRRORED:
            return self.camera
        camera = vtkCamera()
        camera.DeepCopy(self.camera)
        self.keep.append(camera)
        return camera

    def add(self, prop, cut=True):
        """Adds a prop, in the mirrored picture cut at the water unless cut is False; returns it."""
        if self.kind == MIRRORED and cut:
            self.cut(prop)
        self.renderer.AddViewProp(prop)
        return prop

    def cut(self, prop):
        """Cuts a prop, or the parts of an assembly, at the water with VTK's own clipping planes."""
        if hasattr(prop, "GetParts"):
            parts = prop.GetParts()
            for i in range(parts.GetNumberOfItems()):
                self.cut(parts.GetItemAsObject(i))
        elif prop.IsA("vtkImageStack"):
            images = vtkPropCollection()
            prop.GetImages(images)
            for i in range(images.GetNumberOfItems()):
                self.cut(images.GetItemAsObject(i))
        elif hasattr(prop, "GetMapper"):
            normal = self.normal if self.is_above() else -self.normal
            prop.GetMapper().AddClippingPlane(wt.plane(self.origin, normal))

    def cut_fragments(self, actor):
        """In the mirrored picture, cuts an actor fragment by fragment, by a shader of the user's.

        For what VTK's clipping planes keep or drop whole, by its center.
        """
        if self.kind != MIRRORED:
            return
        above = self.is_above()

        def set_plane():
            normal = self.normal if above else -self.normal
            world_to_clip = self.camera.GetCompositeProjectionTransformMatrix(
                self.renderer.GetTiledAspectRatio(), -1, 1)
            clip_to_world = np.linalg.inv(array_of(world_to_clip))
            plane = np.append(normal, -np.dot(normal, self.origin)) @ clip_to_world
            width, height = self.window.GetSize()
            window_to_clip = np.array([(2 / width, 0, 0, -1), (0, 2 / height, 0, -1), (0, 0, 2, -1), (0, 0, 0, 1)])
            actor.GetShaderProperty().GetFragmentCustomUniforms().SetUniform4f(
                "cutPlane", list(plane @ window_to_clip))

        actor.GetShaderProperty().AddFragmentShaderReplacement(
            "//VTK::Clip::Impl", True,
            "if (dot(cutPlane, vec4(gl_FragCoord.xyz, 1.0)) < 0.0) discard;\n//VTK::Clip::Impl", False)
        self.when_mirrored.append(set_plane)

    def cut_by_view(self):
        """In the mirrored picture, cuts everything at the water, whatever draws it: by the near plane of the view.

        Not for what computes its own depth: spheres, tubes, skyboxes, volumes.
        """
        self.is_cut_by_view = True

    def add_data(self, data, color=(1, 0.6, 0.2), cut=True, **options):
        """Adds an actor of poly data; options as those of water_test.add_actor."""
        actor = wt.add_actor(self.renderer, data, color, **options)
        self.renderer.RemoveActor(actor)
        return self.add(actor, cut)

    def is_above(self):
        """Is the user's eye on the side that the normal points to? Asked before the camera is mirrored."""
        return wt.is_above(self.camera, self.origin, self.normal)

    def pixels(self):
        """Renders; returns rows x columns x RGB as integers, bottom row first."""
        return self.picture()


def mirror(scene):
    """Turns a filled scene into its mirrored picture's, to be turned left to right."""
    camera, origin, normal = scene.camera, scene.origin, scene.normal
    scene.renderer.ComputeAspect()
    kept_side = normal if scene.is_above() else -normal
    if scene.freezes_lights:
        freeze_lights(scene)
    up = np.asarray(camera.GetViewUp())
    position, focal_point = camera.GetPosition(), camera.GetFocalPoint()
    camera.SetPosition(wt.mirror_point(position, origin, normal))
    camera.SetFocalPoint(wt.mirror_point(focal_point, origin, normal))
    camera.SetViewUp(wt.mirror_point(up, (0, 0, 0), normal))
    center, shear = camera.GetWindowCenter(), camera.GetViewShear()
    camera.SetWindowCenter(-center[0], center[1])
    camera.SetViewShear(-shear[0], shear[1], shear[2])
    if camera.GetUserViewTransform():
        camera.SetUserViewTransform(turned_left_to_right(camera.GetUserViewTransform().GetMatrix(), scene))
    if camera.GetUseExplicitProjectionTransformMatrix():
        matrix = camera.GetExplicitProjectionTransformMatrix()
        camera.SetExplicitProjectionTransformMatrix(turned_left_to_right(matrix, scene).GetMatrix())
    if scene.is_cut_by_view:
        cut_by_near_plane(scene, kept_side)
    for act in scene.when_mirrored:
        act()


def array_of(matrix):
    return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])


def cut_by_near_plane(scene, kept_side):
    """Puts the near plane of the mirrored view into the water (Lengyel, Oblique View Frustum, 2005).

    Only the row of the projection that makes depths changes: all pixels stay where they are.
    """
    camera = scene.camera
    projection = array_of(camera.GetProjectionTransformMatrix(scene.renderer.GetTiledAspectRatio(), -1, 1))
    view_to_world = np.linalg.inv(array_of(camera.GetViewTransformMatrix()))
    plane = np.append(kept_side, -np.dot(kept_side, scene.origin)) @ view_to_world
    corner = np.linalg.inv(projection) @ (np.sign(plane[0]), np.sign(plane[1]), 1, 1)
    projection[2] = plane * (2 / np.dot(plane, corner)) - projection[3]
    camera.SetExplicitProjectionTransformMatrix(matrix_of(*projection))
    camera.UseExplicitProjectionTransformMatrixOn()


def turned_left_to_right(matrix, scene):
    """F M F with F = diag(-1, 1, 1, 1), as a transform that scene keeps."""
    turned = vtkMatrix4x4()
    for i in range(4):
        for j in range(4):
            turned.SetElement(i, j, matrix.GetElement(i, j) * (-1 if (i == 0) != (j == 0) else 1))
    transform = vtkMatrixToLinearTransform()
    transform.SetInput(turned)
    scene.keep.append(transform)
    return transform


def freeze_lights(scene):
    """Makes scene lights of all lights, where the camera now puts them."""
    renderer = scene.renderer
    lights = [renderer.GetLights().GetItemAsObject(i) for i in range(renderer.GetLights().GetNumberOfItems())]
    if not lights and renderer.GetAutomaticLightCreation():
        headlight = vtkLight()
        headlight.SetLightTypeToHeadlight()
        lights = [headlight]
    placed = scene.camera.GetCameraLightTransformMatrix()
    frozen = []
    for light in lights:
        copy = vtkLight()
        copy.DeepCopy(light)
        copy.SetLightTypeToSceneLight()
        position, focal_point = (*light.GetPosition(), 1), (*light.GetFocalPoint(), 1)
        if light.LightTypeIsHeadlight():
            position, focal_point = (*scene.camera.GetPosition(), 1), (*scene.camera.GetFocalPoint(), 1)
        elif light.LightTypeIsCameraLight():
            position, focal_point = placed.MultiplyPoint(position), placed.MultiplyPoint(focal_point)
        copy.SetPosition(position[:3])
        copy.SetFocalPoint(focal_point[:3])
        frozen.append(copy)
    renderer.RemoveAllLights()
    for light in frozen:
        renderer.AddLight(light)
    renderer.AutomaticLightCreationOff()
    renderer.LightFollowCameraOff()


def matrix_of(*rows):
    """A vtkMatrix4x4 of its first rows."""
    matrix = vtkMatrix4x4()
    for i, row in enumerate(rows):
        for j, value in enumerate(row):
            matrix.SetElement(i, j, value)
    return matrix


def image_of(picture):
    """Rows x columns x RGB as vtkImageData."""
    height, width = picture.shape[:2]
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    values = np.ascontiguousarray(picture.astype(np.uint8)).reshape(-1, 3)
    image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    return image


def mapper_of(data):
    """A mapper of poly data that shows no scalars."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    return mapper


def add_sheet(scene, picture, data=None, bounds=SHEET, opacity=1.0):
    """An ordinary sheet in the water's place that shows a picture, if any, by the place in the window."""
    if data is None:
        first, second = axes_of(scene.normal)
        corner = [scene.origin + x * first + y * second
                  for x, y in ((bounds[0], bounds[2]), (bounds[1], bounds[2]), (bounds[0], bounds[3]))]
        source = vtkPlaneSource()
        source.SetOutputPointsPrecision(1)
        source.SetOrigin(corner[0])
        source.SetPoint1(corner[1])
        source.SetPoint2(corner[2])
        source.Update()
        data = source.GetOutput()
    sheet = vtkActor()
    sheet.SetMapper(mapper_of(data))
    sheet.GetProperty().SetOpacity(opacity)
    scene.renderer.AddActor(sheet)
    if picture is None:
        return sheet
    texture = vtkTexture()
    texture.SetInputData(image_of(picture))
    texture.InterpolateOff()
    texture.RepeatOff()
    sheet.SetTexture(texture)
    sheet.GetShaderProperty().AddFragmentShaderReplacement("//VTK::TCoord::Impl", True, BY_PLACE, False)
    return sheet


def axes_of(normal):
    """The plane's own axes, as the design defines them."""
    normal = np.asarray(normal, float)
    world = np.array((1.0, 0, 0)) if abs(normal[0]) <= np.sqrt(0.5) else np.array((0.0, 1, 0))
    first = wt.unit(world - np.dot(world, normal) * normal)
    return first, np.cross(normal, first)


def mirrored_picture(fill, **options):
    """The scene as the mirrored camera sees it, turned left to right."""
    scene = Scene(MIRRORED, **options)
    fill(scene)
    mirror(scene)
    return scene.pixels()[:, ::-1]


def composed_picture(fill, mirrored, bounds=SHEET, opacity=1.0, **options):
    """The scene with an ordinary sheet in the water's place that shows a mirrored picture."""
    scene = Scene(COMPOSED, **options)
    fill(scene)
    add_sheet(scene, mirrored, None, bounds, opacity)
    return scene.pixels()


def water_pixels(scene, water):
    """Which pixels have any colour of the water's."""
    look = water.GetWaterProperty()
    look.SetReflectance(0)
    pictures = []
    for color in ((1, 0, 1), (0, 1, 0)):
        look.SetDeepColor(color)
        pictures.append(scene.pixels())
    look.SetReflectance(1)
    return np.abs(pictures[0] - pictures[1]).max(axis=2) > 0

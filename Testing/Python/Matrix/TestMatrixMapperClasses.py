# SPDX-License-Identifier: BSD-3-Clause
"""Row Classes of mappers of the mirror matrix: VTK's mappers of 3D props that have no cell in another row.

What they draw stands in the water, half over and half under it, unless the cell says that it stands over it.
"""

import mirror_matrix as mm
import numpy as np
import volumes
import water_test as wt
from mirror_scene import as_vertices
from vtk_classes import find
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkMolecule,
    vtkMultiBlockDataSet,
    vtkMutableUndirectedGraph,
)
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkContourFilter, vtkElevationFilter
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkFiltersSources import vtkHyperTreeGridSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkVolume
from vtkmodules.vtkRenderingVolume import vtkMultiVolume

row = mm.Results("Classes of mappers", __file__)
BY_VIEW, BY_PLANES, BY_FRAGMENTS, NOT = "by view", "by planes", "by fragments", "not"


def cell(path, make, cut=BY_VIEW, name=None, **options):
    """Registers the cell of a class, given by its module and name, if this VTK has it.

    make(mapper, scene) fills the mapper, and gives the prop if it is no plain actor; cut: how the truth is cut
    """
    made_class = find(path)
    if made_class is None:
        return

    def fill(scene):
        mapper = made_class()
        prop = make(mapper, scene)
        if prop is None:
            prop = vtkActor()
            prop.GetProperty().SetColor(1, 0.6, 0.2)
            prop.SetMapper(mapper)
        scene.add(prop, cut is BY_PLANES)
        if cut is BY_VIEW:
            scene.cut_by_view()
        elif cut is BY_FRAGMENTS:
            scene.cut_fragments(prop)

    row.cell(name or path.split(".")[1], fill, **options)


# Surfaces.
def ball(height=0.3, radius=1.2, resolution=40):
    """A ball whose scalars are its heights."""
    elevation = vtkElevationFilter()
    elevation.SetInputData(wt.sphere((0, 0, height), radius, resolution))
    elevation.SetLowPoint(0, 0, height - radius)
    elevation.SetHighPoint(0, 0, height + radius)
    elevation.Update()
    return elevation.GetOutput()


def grid_of(data):
    append = vtkAppendFilter()
    append.AddInputData(data)
    append.Update()
    return append.GetOutput()


def balls():
    data = vtkMultiBlockDataSet()
    data.SetBlock(0, ball())
    data.SetBlock(1, wt.sphere((2, 0.5, 0.4), 0.8))
    return data


def of_data(data):
    def make(mapper, scene):
        mapper.SetInputDataObject(data())

    return make


def graph(mapper, scene):
    network, points = vtkMutableUndirectedGraph(), vtkPoints()
    for i in range(12):
        network.AddVertex()
        points.InsertNextPoint(2 * np.cos(i), np.sin(i), 0.5 + 1.1 * np.cos(2.3 * i))
    for i in range(12):
        network.AddEdge(i, (i + 5) % 12)
    network.SetPoints(points)
    mapper.SetInputData(network)
    mapper.SetVertexPointSize(9)
    mapper.SetEdgeLineWidth(3)


def contours(mapper, scene):
    lines = vtkContourFilter()
    lines.SetInputData(ball())
    lines.GenerateValues(5, 0.1, 0.95)
    lines.Update()
    mapper.SetInputData(lines.GetOutput())


def hyper_tree_grid(mapper, scene):
    source = vtkHyperTreeGridSource()
    source.SetMaxDepth(3)
    source.SetDimensions(4, 4, 1)
    source.SetGridScale(1.1, 1.1, 1)
    source.SetBranchFactor(2)
    source.SetDescriptor("R.R .R. R.R | .... R... .... ...R .... | .... ....")
    source.Update()
    mapper.SetInputDataObject(source.GetOutput())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().EdgeVisibilityOn()
    actor.SetPosition(-1.6, 0, -1)
    actor.RotateX(75)
    return actor


# Imposters, and what computes its depth.
def places(count=40):
    generator = np.random.default_rng(5)
    return as_vertices(generator.uniform((-2, -1, -0.5), (2, 1.5, 1.6), (count, 3)))


def spheres(mapper, scene):
    mapper.SetInputData(places())
    mapper.SetRadius(0.25)


def molecule(mapper, scene):
    water = vtkMolecule()
    atoms = [water.AppendAtom(number, *place) for number, place in (
        (8, (0, 0, 0.2)), (1, (0.9, 0, 0.8)), (1, (-0.9, 0, 0.7)), (6, (0.2, 0.9, -0.2)))]
    for atom in atoms[1:]:
        water.AppendBond(atoms[0], atom, 1)
    mapper.SetInputData(water)
    mapper.UseBallAndStickSettings()


# Line integral convolution, whose noise lies on the screen or on the surface.
def convolved(data):
    def make(mapper, scene):
        blocks = data()
        parts = [blocks.GetBlock(i) for i in range(2)] if blocks.IsA("vtkMultiBlockDataSet") else [blocks]
        for part in parts:
            normals = np.array([part.GetPointData().GetNormals().GetTuple(i) for i in range(part.GetNumberOfPoints())])
            vectors = numpy_to_vtk(np.cross(normals, (0.3, 0.2, 1.0)), deep=True)
            vectors.SetName("flow")
            part.GetPointData().SetVectors(vectors)
        mapper.SetInputDataObject(blocks)
        mapper.SetInputArrayToProcess(0, 0, 0, 0, "flow")

    return make


# Volumes.
TABLES = dict(colors=((0, 1, 0.9, 0.2), (100, 0.9, 0.2, 0.1)), opacities=((0, 0.6), (90, 0.2), (105, 0)))
OVER = 1.5


def image(height=OVER):
    return volumes.ball((0, 0, height), 1.2, 30, 1.5, 70)


def volume_of(mapper):
    volume = volumes.ray_cast(image(), 0.05, **TABLES)
    volume.SetMapper(mapper)
    volume.GetProperty().SetInterpolationTypeToLinear()
    return volume


def cast(mapper, scene):
    mapper.SetInputData(image())
    return volume_of(mapper)


def tetrahedra(mapper, scene):
    split = vtkDataSetTriangleFilter()
    split.SetInputData(volumes.ball((0, 0, OVER), 1.2, 12, 1.5, 70))
    split.TetrahedraOnlyOn()
    split.Update()
    mapper.SetInputData(split.GetOutput())
    volume = volume_of(mapper)
    volume.GetProperty().SetScalarOpacityUnitDistance(0.5)
    return volume


def blocks_of_volumes(mapper, scene):
    data = vtkMultiBlockDataSet()
    data.SetBlock(0, volumes.ball((-1.2, 0, OVER), 0.9, 20, 1.0, 70))
    data.SetBlock(1, volumes.ball((1.2, 0, OVER), 0.9, 20, 1.0, 70))
    mapper.SetInputDataObject(data)
    return volume_of(mapper)


def fluid(mapper, scene):
    mapper.SetInputData(places(400))
    mapper.SetParticleRadius(0.2)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    return volume


def several(mapper, scene):
    """Two volumes of one mapper."""
    volume = vtkMultiVolume()
    for i in range(2):
        mapper.SetInputDataObject(i, volumes.ball((1.6 * i - 0.8, 0, OVER), 1.1, 24, 1.2, 70))
        volume.SetVolume(volume_of(None), i)
    volume.SetMapper(mapper)
    mapper.UseJitteringOff()
    mapper.AutoAdjustSampleDistancesOff()
    mapper.SetSampleDistance(0.05)
    return volume


def under_a_scene_light(make):
    def lit(mapper, scene):
        wt.add_scene_light(scene.renderer, (2, -4, 5))
        return make(mapper, scene)

    return lit


# VTK 9.1 at times casts rays on the CPU as if every window were square, without water as well
SQUARE = dict(size=(200, 200))
FIXED = ("Its rays are computed in 15 bits and rounded to its own pixels, whose rows differ from those of the "
         "flipped mirrored view.")
ROUNDED = ("It blends cell by cell and rounds each time to 8 bits; the reflection texture and a window round "
           "differently.")
OWN_LIGHT = "Its shaders use their own light, at the eye of the current view."
PARTS = "Its actors, which VTK does not expose, are not cut at the water."
cell("RenderingCore.vtkDataSetMapper", of_data(lambda: grid_of(ball())))
cell("RenderingCore.vtkHierarchicalPolyDataMapper", of_data(balls))
cell("RenderingCore.vtkGraphMapper", graph, wrong=True, reason=PARTS)
cell("RenderingCore.vtkHyperTreeGridMapper" if mm.VTK_VERSION < (9, 3) else
     "RenderingHyperTreeGrid.vtkHyperTreeGridMapper", hyper_tree_grid)
cell("RenderingCore.vtkLabeledContourMapper", contours)
cell("RenderingOpenGL2.vtkOpenGLLowMemoryPolyDataMapper", under_a_scene_light(of_data(ball)))
cell("RenderingOpenGL2.vtkOpenGLSphereMapper", spheres, BY_FRAGMENTS)
cell("DomainsChemistry.vtkMoleculeMapper", molecule, BY_FRAGMENTS)
cell("RenderingLICOpenGL2.vtkSurfaceLICMapper", convolved(ball), BY_PLANES)
cell("RenderingLICOpenGL2.vtkCompositeSurfaceLICMapper", convolved(balls), BY_PLANES)
cell("RenderingVolume.vtkFixedPointVolumeRayCastMapper", cast, NOT, exact=False, reason=FIXED, **SQUARE)
cell("RenderingVolume.vtkProjectedTetrahedraMapper", tetrahedra, NOT, exact=False, reason=ROUNDED)
cell("RenderingVolume.vtkUnstructuredGridVolumeRayCastMapper", tetrahedra, NOT, **SQUARE)
cell("RenderingVolume.vtkUnstructuredGridVolumeZSweepMapper", tetrahedra, NOT, **SQUARE)
cell("RenderingVolumeOpenGL2.vtkMultiBlockVolumeMapper", blocks_of_volumes, NOT)
cell("RenderingOpenGL2.vtkOpenGLFluidMapper", fluid, NOT, others=mm.BESIDE, wrong=True, reason=OWN_LIGHT)
cell("RenderingVolume.vtkGPUVolumeRayCastMapper", several, NOT, "vtkMultiVolume")
test_cell = row.test()

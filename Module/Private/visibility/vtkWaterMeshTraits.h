// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMeshTraits: what an actor and its mapper say of how a mesh is drawn, and with it whether
// parts of the mesh may be left out.
#ifndef vtkWaterMeshTraits_h
#define vtkWaterMeshTraits_h

class vtkAbstractMapper;
class vtkActor;
class vtkMapper;
class vtkOpenGLPolyDataMapper;
class vtkPolyData;
class vtkPolyDataMapper;
class vtkProperty;
class vtkShaderProgram;

namespace vtkWaterMeshTraits
{
// The mapper, if it is of exactly that class; nullptr: it is not.
vtkOpenGLPolyDataMapper* AsPolyDataMapper(vtkAbstractMapper* mapper);

// The mapper, if it is what a mapper of composite data draws its blocks with; nullptr: it is not.
vtkOpenGLPolyDataMapper* AsBlocksMapper(vtkAbstractMapper* mapper);

// May the vertices be elsewhere than the data says?
bool HasOwnShaders(vtkAbstractMapper* mapper, vtkActor* actor);

// Is a mesh drawn where its data says, by one mapper for all of its points?
bool IsDrawnAsItIs(vtkMapper* mapper, vtkActor* actor);

// What VTK makes of coordinates for the GPU: (coordinate - shift) * scale. Nothing, unless the mesh
// is large, or far off.
void ReadShiftAndScale(vtkAbstractMapper* mapper, double shift[3], double scale[3]);

// Can the triangles of a mesh be drawn without some of them? Not when the shader counts them to
// find the data of their cells.
bool CanBeCut(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkActor* actor);

// Can it draw its triangles without those of some blocks?
bool CanLeaveBlocksOut(vtkOpenGLPolyDataMapper* blocks, vtkActor* actor);

// May a pixel have another depth than its triangle, or none? Fragment shaders write depths where an
// offset tells coincident surfaces apart, and the user's may write or discard anything.
bool HasOwnDepths(vtkMapper* mapper, vtkActor* actor);

// Is every pixel of what an actor draws in the opaque pass opaque? VTK blends there, too.
bool IsOpaqueEverywhere(vtkActor* actor);

// Does every triangle, whichever way it faces, cover all of its pixels for good?
bool IsSolid(vtkPolyDataMapper* mapper, vtkActor* actor);

// Is the mesh coloured by an array of its own, through a lookup table or directly?
bool ShowsScalars(vtkAbstractMapper* mapper);

// The polygons that a mapper of VTK's draws; nullptr: it is of another kind, or has not made them
// yet.
vtkPolyData* FindPolygons(vtkMapper* mapper);

// Are there neither points nor lines besides?
bool HasTrianglesOnly(vtkPolyData* mesh, vtkMapper* mapper, vtkProperty* property);
bool HasTrianglesOnly(vtkPolyDataMapper* mapper, vtkProperty* property);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFlow: the current of a mesh, as an attribute of its vertices (vtkWaterFlowVS.glsl).
//
// It is added to the vertex arrays of whatever mapper draws the mesh, while it draws, so that the
// user's mapper is left as it is.
#ifndef vtkWaterFlow_h
#define vtkWaterFlow_h

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkType.h"

#include <string>
#include <utility>

class vtkMapper;
class vtkOpenGLVertexArrayObject;
class vtkPolyData;
class vtkShaderProgram;

class vtkWaterFlow
{
public:
  // What is wrong with the array of this name in a mapper's data; empty: nothing. nullptr: there is
  // no mesh.
  static std::string Check(vtkMapper* mapper, const std::string& name);

  // Adds the current of the mesh that is about to be drawn; without such an array there is none.
  void Add(vtkPolyData* mesh, const std::string& name, vtkShaderProgram* program,
    vtkOpenGLVertexArrayObject* vertices);

  void ReleaseGraphicsResources();

private:
  bool Upload(vtkPolyData* mesh, const std::string& name);

  vtkNew<vtkOpenGLBufferObject> Buffer;
  std::pair<void*, vtkMTimeType> Uploaded = { nullptr, 0 }; // the mesh, and its time
  std::string Name;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterVertexData: an array of a mesh as an attribute of its vertices: a current, the
// concentration of matter, a measure of foam.
//
// It is added to the vertex arrays of whatever mapper draws the mesh, while it draws, so that the
// user's mapper is left as it is.
#ifndef vtkWaterVertexData_h
#define vtkWaterVertexData_h

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <utility>

class vtkDataArray;
class vtkFloatArray;
class vtkMapper;
class vtkOpenGLVertexArrayObject;
class vtkPolyData;
class vtkShaderProgram;

class vtkWaterVertexData
{
public:
  // What an array is for.
  struct Use
  {
    const char* Attribute; // of the vertex shader
    const char* Values;    // what its values are, for errors
    int Least;             // of its components
    int Most;              // and so many has the attribute
    const char* Rule;      // that values are told of which do not keep to it; nullptr: they are not
    int Kind;              // for Convert
    double (*Convert)(int kind, double value); // a component as it is used
  };

  static const Use& Flow();
  static const Use& Matter();
  // measure  water_foam_measure
  static const Use& Foam(int measure);

  // What is wrong with the array of this name in a mapper's data; empty: nothing. nullptr: there is
  // no mesh.
  static std::string Check(vtkMapper* mapper, const Use& use, const std::string& name);

  // Adds the values of the mesh that is about to be drawn; without such an array they are 0.
  void Add(vtkPolyData* mesh, const Use& use, const std::string& name, vtkShaderProgram* program,
    vtkOpenGLVertexArrayObject* vertices);

  // Adds numbers that are used as they are, one for each vertex. false: they cannot be added.
  bool Add(vtkFloatArray* values, const char* attribute, vtkShaderProgram* program,
    vtkOpenGLVertexArrayObject* vertices);

  // What is wrong with values of the last mesh that was added; empty: nothing.
  const std::string& GetWrong() const { return this->Wrong; }

  void ReleaseGraphicsResources();

private:
  bool Upload(vtkPolyData* mesh, const Use& use, const std::string& name);
  // The values of an array as they are used, as many as the attribute has.
  vtkSmartPointer<vtkDataArray> Convert(vtkDataArray* array, const Use& use, bool isOfPoints);

  vtkNew<vtkOpenGLBufferObject> Buffer;
  std::pair<void*, vtkMTimeType> Uploaded = { nullptr, 0 }; // the mesh, and its time
  const Use* UploadedUse = nullptr;
  std::string Name;
  std::string Wrong;
};

#endif

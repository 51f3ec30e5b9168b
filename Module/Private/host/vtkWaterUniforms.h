// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterUniforms: numbers of the core into a program, in float; each does nothing when the
// program has no use for the name.
#ifndef vtkWaterUniforms_h
#define vtkWaterUniforms_h

class vtkShaderProgram;
class vtkTextureObject;

namespace vtkWaterUniforms
{
void Set(vtkShaderProgram* program, const char* name, int value);
void Set(vtkShaderProgram* program, const char* name, double value);
void Set2(vtkShaderProgram* program, const char* name, const double value[2]);
void Set3(vtkShaderProgram* program, const char* name, const double value[3]);
void Set4(vtkShaderProgram* program, const char* name, const double value[4]);
// An array of as many.
void Set4s(vtkShaderProgram* program, const char* name, int count, const double value[][4]);
// Matrices by rows; GL wants columns: the one place that transposes.
void SetMatrix3(vtkShaderProgram* program, const char* name, const double rows[9]);
// 4 rows of 3, as the first columns of a 4 x 4 one.
void SetMatrix4x3(vtkShaderProgram* program, const char* name, const double rows[12]);
// The unit of an active texture; nullptr is left out.
void Set(vtkShaderProgram* program, const char* name, vtkTextureObject* texture);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterUniforms.h"

#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace
{
template <size_t Count>
std::array<float, Count> ToFloat(const double* value)
{
  std::array<float, Count> single;
  std::transform(value, value + Count, single.begin(),
    [](double component) { return static_cast<float>(component); });
  return single;
}
}

//------------------------------------------------------------------------------
void vtkWaterUniforms::Set(vtkShaderProgram* program, const char* name, int value)
{
  if (program->IsUniformUsed(name))
  {
    program->SetUniformi(name, value);
  }
}

//------------------------------------------------------------------------------
void vtkWaterUniforms::Set(vtkShaderProgram* program, const char* name, double value)
{
  if (program->IsUniformUsed(name))
  {
    program->SetUniformf(name, static_cast<float>(value));
  }
}

//------------------------------------------------------------------------------
void vtkWaterUniforms::Set2(vtkShaderProgram* program, const char* name, const double value[2])
{
  if (program->IsUniformUsed(name))
  {
    program->SetUniform2f(name, ToFloat<2>(value).data());
  }
}

//------------------------------------------------------------------------------
void vtkWaterUniforms::Set3(vtkShaderProgram* program, const char* name, const double value[3])
{
  if (program->IsUniformUsed(name))
  {
    program->SetUniform3f(name, ToFloat<3>(value).data());
  }
}

//------------------------------------------------------------------------------
void vtkWaterUniforms::Set4(vtkShaderProgram* program, const char* name, const double value[4])
{
  if (program->IsUniformUsed(name))
  {
    program->SetUniform4f(name, ToFloat<4>(value).data());
  }
}

//------------------------------------------------------------------------------
void vtkWaterUniforms::Set4s(
  vtkShaderProgram* program, const char* name, int count, const double value[][4])
{
  if (program->IsUniformUsed(name))
  {
    std::vector<std::array<float, 4>> single;
    std::transform(value, value + count, std::back_inserter(single), ToFloat<4>);
    program->SetUniform4fv(name, count, reinterpret_cast<const float(*)[4]>(single.data()));
  }
}

//------------------------------------------------------------------------------
void vtkWaterUniforms::SetMatrix3(vtkShaderProgram* program, const char* name, const double rows[9])
{
  if (program->IsUniformUsed(name))
  {
    float columns[9];
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        columns[3 * column + row] = static_cast<float>(rows[3 * row + column]);
      }
    }
    program->SetUniformMatrix3x3(name, columns);
  }
}

//------------------------------------------------------------------------------
void vtkWaterUniforms::SetMatrix4x3(
  vtkShaderProgram* program, const char* name, const double rows[12])
{
  if (program->IsUniformUsed(name))
  {
    float columns[16] = {};
    for (int row = 0; row < 4; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        columns[4 * column + row] = static_cast<float>(rows[3 * row + column]);
      }
    }
    program->SetUniformMatrix4x4(name, columns);
  }
}

//------------------------------------------------------------------------------
void vtkWaterUniforms::Set(vtkShaderProgram* program, const char* name, vtkTextureObject* texture)
{
  if (texture && program->IsUniformUsed(name))
  {
    program->SetUniformi(name, texture->GetTextureUnit());
  }
}

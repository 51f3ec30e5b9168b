// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterQuad.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

//------------------------------------------------------------------------------
vtkWaterQuad::vtkWaterQuad() = default;

//------------------------------------------------------------------------------
vtkWaterQuad::~vtkWaterQuad() = default;

//------------------------------------------------------------------------------
vtkShaderProgram* vtkWaterQuad::Ready(vtkOpenGLRenderWindow* window, const char* fragmentShader)
{
  if (!this->Quad)
  {
    this->Quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, fragmentShader, nullptr);
  }
  else
  {
    window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
  }
  vtkShaderProgram* program = this->Quad->Program;
  return program && program->GetCompiled() ? program : nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterQuad::Draw()
{
  this->Quad->Render();
}

//------------------------------------------------------------------------------
void vtkWaterQuad::ReleaseGraphicsResources()
{
  this->Quad.reset();
}

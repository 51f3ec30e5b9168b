// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSurface: a water's own draw: which stages its shader has, its textures and its uniforms.
#ifndef vtkWaterSurface_h
#define vtkWaterSurface_h

#include "vtkSmartPointer.h"
#include "vtkWaterBackdrop.h"
#include "water_grid.h"

#include <string>

class vtkOpenGLRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWaterActor;
class vtkWaterProperty;
class vtkWindow;

class vtkWaterSurface
{
public:
  // What is drawn.
  struct Frame
  {
    vtkOpenGLRenderer* Renderer;
    const water_plan* Plan;       // nullptr: show the plain colour
    vtkTextureObject* Reflection; // any texture when nothing is reflected
    vtkTextureObject* ReflectionDepth;
    bool IsFlat;                 // the sheet lies in the plane exactly
    const water_grid_view* View; // waves move the vertices; nullptr: they do not
    const double* RowDir;        // of the grid under them
  };

  // The stages of a water's shader, as bits: they are files of their own, because software
  // renderers execute both sides of a branch.
  enum Stages
  {
    WAVES = 1 << 0,
    RAY_TRACED = 1 << 1,
    OFFSET = 1 << 2,
    BODY = 1 << 3,
    DISPLACED = 1 << 4
  };
  static int GetStages(vtkWaterProperty* property);

  // The source that defines waterShade.
  //
  // canDisplace  the vertex shader can move its vertices
  static std::string GetShader(vtkWaterProperty* property, bool canDisplace);

  // The source that defines waterDisplace, for vertices.
  static std::string GetVertexShader();

  // Is another shader needed than for the last draw?
  bool UpdateStages(vtkWaterProperty* property);

  // The surface is drawn between the two.
  void Begin(vtkWaterActor* water, const Frame& frame);
  void End();

  void SetParameters(vtkShaderProgram* program);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void UploadWaves(vtkWaterActor* water, const double origin[2]);
  void SetDisplacement(vtkShaderProgram* program);
  void SetViewParameters(vtkShaderProgram* program);
  void SetReflectionParameters(vtkShaderProgram* program);
  void SetSkyParameters(vtkShaderProgram* program);

  int BuiltStages = 0;
  Frame Drawn = Frame();
  vtkWaterProperty* Property = nullptr;    // of what is drawn
  vtkTextureObject* Active[5] = {};        // nullptr: not in use
  vtkSmartPointer<vtkTextureObject> Waves; // a row per wave
  int WaveCount = 0;
  bool IsSteep = false; // waves that move their points
  vtkWaterBackdrop Backdrop;
  bool HasBackdrop = false;
};

#endif

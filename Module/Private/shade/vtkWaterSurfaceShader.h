// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSurfaceShader: a water's own draw: which stages its
// shader has, its textures and its uniforms.
#ifndef vtkWaterSurfaceShader_h
#define vtkWaterSurfaceShader_h

#include "vtkSmartPointer.h"
#include "vtkWaterBackdrop.h"
#include "vtkWaterFullScreen.h"
#include "vtkWaterNormalMaps.h"
#include "vtkWaterSlopeTexture.h"
#include "water_grid.h"
#include "water_types.h"

#include <string>
#include <utility>
#include <vector>

class vtkOpenGLRenderer;
class vtkProp;
class vtkShaderProgram;
class vtkTexture;
class vtkTextureObject;
class vtkWaterActor;
class vtkWaterTranslucentLayer;
class vtkWaterProperty;
class vtkWaterSea;
class vtkWindow;

class vtkWaterSurfaceShader
{
public:
  // What is drawn.
  struct Frame
  {
    vtkOpenGLRenderer* Renderer;
    vtkWaterFullScreen* Screen;   // of the renderer
    const water_plan* Plan;       // nullptr: show the plain colour
    vtkTextureObject* Reflection; // any texture when nothing is reflected
    vtkTextureObject* ReflectionDepth;
    vtkWaterTranslucentLayer* Layer =
      nullptr;         // of the reflection texture; nullptr: nothing in it is translucent
    int MostSteps = 0; // of the march
    int MostProbes = 0;
    bool IsFlat;                 // the sheet lies in the plane exactly
    const water_grid_view* View; // waves move the vertices; nullptr: they do not
    const double* RowDir;        // of the grid under them
    bool IsSecondary = false;    // in the mirrored view of another water
    bool AddsFog = false;        // to all that the eye sees, which is in the water
  };

  // The stages of a water's shader, as bits: they are files of their own, because software
  // renderers execute both sides of a branch.
  enum Stages
  {
    WAVES = 1 << 0,
    RAY_TRACED = 1 << 1,
    OFFSET = 1 << 2,
    ENVIRONMENT = 1 << 3,
    BODY = 1 << 4,
    CAUSTICS = 1 << 5,
    GLITTER = 1 << 6,
    SEA = 1 << 7,
    NORMAL_MAPS = 1 << 8,
    ROUGH = 1 << 9,
    DISPLACED = 1 << 10,
    FOAM = 1 << 11,
    SHADOWS = 1 << 12,
    OUTPUT = 1 << 13,
    LAYER = 1 << 14 // of the reflection texture that it looks up, not of its look
  };
  static int GetStages(vtkWaterActor* water);

  // The same of one that looks up a reflection texture with a layer.
  static int GetLayeredStages(vtkWaterActor* water);

  // The same in the mirrored view of another water: the background, and the mean of all waves.
  static int GetSecondaryStages(vtkWaterActor* water);

  // Is it a water through which the scene is seen?
  static bool IsClear(vtkProp* prop);

  // The stages of the last draw.
  int GetBuiltStages() const { return this->BuiltStages; }
  bool GetIsSecondary() const { return this->Drawn.IsSecondary; }

  // The source that defines waterShade.
  //
  // canDisplace  the vertex shader can move its vertices
  static std::string GetShader(int stages, bool canDisplace);

  // The source that defines waterDisplace, for vertices.
  static std::string GetVertexShader();

  // Is another shader needed than for the last draw?
  bool UpdateStages(int stages);

  // The driver has refused the shader of these stages: the plain colour is shown until there are
  // others, or another context.
  void SetIsRefused() { this->IsRefused = true; }
  bool GetIsRefused() const { return this->IsRefused; }

  // VTK draws with the program that was in use before when one does not compile: none.
  void ReleaseShader();

  // The surface is drawn between the two.
  void Begin(vtkWaterActor* water, const Frame& frame);
  void End();

  void SetParameters(vtkShaderProgram* program);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void UploadWaves(vtkWaterActor* water, const double origin[2]);
  void SetDisplacement(vtkShaderProgram* program);
  void UploadNormalMap(size_t number);
  void SetViewParameters(vtkShaderProgram* program);
  void SetReflectionParameters(vtkShaderProgram* program);
  void SetSkyParameters(vtkShaderProgram* program);
  void SetSunParameters(vtkShaderProgram* program);
  void SetSeaParameters(vtkShaderProgram* program);
  void SetNormalMapParameters(vtkShaderProgram* program);

  int BuiltStages = 0;
  bool IsRefused = false;
  Frame Drawn = Frame();
  // Drawing runs the user's observers, who may drop any of these.
  vtkSmartPointer<vtkWaterProperty> Property; // of what is drawn
  water_plan Plan = water_plan();
  std::vector<std::pair<const char*, vtkSmartPointer<vtkTextureObject>>>
    Active;                                // names in the shader
  vtkSmartPointer<vtkTexture> Environment; // in use
  double Time = 0.0;
  vtkSmartPointer<vtkTextureObject> Waves; // a row per wave
  int WaveCount = 0;
  bool IsSteep = false;             // waves that move their points
  const vtkWaterSea* Sea = nullptr; // of what is drawn; nullptr: it has none
  vtkWaterSlopeTexture NormalMaps[vtkWaterNormalMaps::Limit];
  std::pair<vtkTexture*, vtkMTimeType> NormalMapTimes[vtkWaterNormalMaps::Limit] = {}; // of those
  double NormalMapTexels[vtkWaterNormalMaps::Limit] = {};                              // their size
  vtkWaterBackdrop Backdrop;
  bool HasBackdrop = false;
};

#endif

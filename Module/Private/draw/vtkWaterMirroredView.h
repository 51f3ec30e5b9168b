// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMirroredView: carries a plan out: draws the mirrored view of a renderer into its target.
#ifndef vtkWaterMirroredView_h
#define vtkWaterMirroredView_h

#include "vtkSmartPointer.h"
#include "vtkWaterClusters.h"
#include "vtkWaterFullScreen.h"
#include "vtkWaterGpuQueries.h"
#include "vtkWaterSceneDepth.h"
#include "vtkWaterTarget.h"
#include "vtkWaterTranslucent.h"
#include "vtkWaterTranslucentLayer.h"
#include "vtkWaterVisibility.h"
#include "water_plan.h"

#include <vector>

class vtkCamera;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkShadowMapPass;
class vtkWaterShaderHook;

class vtkWaterMirroredView
{
public:
  struct Settings
  {
    int Samples = 0;                     // per pixel, 0: none
    bool IsFloat = false;                // colours are half floats, or bytes
    bool HasMarchedRays = false;         // rays are followed through the reflection texture
    bool CanCut = false;                 // parts of large meshes may be left out
    vtkShadowMapPass* Shadows = nullptr; // which is up to date; nullptr: there are none
  };

  // Draws the props into the target.
  //
  // Returns nullptr, or what went wrong in a few words; the target is then not to be used.
  const char* Draw(vtkRenderer* renderer, vtkWaterShaderHook* shading, const water_plan& plan,
    std::vector<vtkProp*>& props, const Settings& settings);

  // Which cells of the reflection texture visible water looks up, by the picture that is bound for
  // drawing; all of it may be where that cannot be told.
  void FindVisibility(vtkRenderer* renderer, const water_plan& plan);

  // Of the last reflection texture that was drawn, or is about to be; nullptr: all may be.
  const water_visibility* GetVisibility() const { return this->Seen; }

  // In the middle of Draw, which runs the user's observers: nothing may be released then.
  bool GetIsDrawing() const { return this->IsDrawing; }

  // Fills the colour's mip levels with what was drawn last.
  void MakeLevels();

  vtkTextureObject* GetColor() { return this->Target.GetColor(); }
  vtkTextureObject* GetDepth() { return this->Target.GetDepth(); }

  // What is translucent in the reflection texture; nullptr: nothing, or no rays are followed.
  vtkWaterTranslucentLayer* GetLayer() { return this->HasLayer ? &this->Layer : nullptr; }

  vtkWaterFullScreen& GetScreen() { return this->Screen; }

  vtkWaterGpuQueries& GetInstruments() { return this->Instruments; }

  // A texture of one pixel, for surfaces that have no reflection to look up.
  vtkTextureObject* GetBlank(vtkOpenGLRenderWindow* window);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void SetCamera(vtkRenderer* renderer, const water_plan& plan);
  void DrawOpaque(
    vtkRenderer* renderer, const water_plan& plan, const std::vector<vtkProp*>& props, bool canCut);

  vtkWaterTarget Target;
  vtkWaterFullScreen Screen;
  vtkWaterSceneDepth SceneDepth;
  vtkWaterVisibility SeenCells;
  const water_visibility* Seen = nullptr;
  vtkWaterClusters Clusters;
  vtkWaterGpuQueries Instruments;
  vtkSmartPointer<vtkTextureObject> Blank;
  vtkSmartPointer<vtkCamera> Camera;
  vtkWaterTranslucent Translucent;
  vtkWaterTranslucentLayer Layer;
  bool HasLayer = false;
  bool IsDrawing = false;
};

#endif

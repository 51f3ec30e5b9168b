// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMirroredView: carries a plan out: draws the mirrored view of a renderer into its target,
// the reflection texture.
#ifndef vtkWaterMirroredView_h
#define vtkWaterMirroredView_h

#include "vtkSmartPointer.h"
#include "vtkWaterBackground.h"
#include "vtkWaterBlocks.h"
#include "vtkWaterClipDistance.h"
#include "vtkWaterClosedCells.h"
#include "vtkWaterClusters.h"
#include "vtkWaterFog.h"
#include "vtkWaterGpuQueries.h"
#include "vtkWaterPeel.h"
#include "vtkWaterPropFacts.h"
#include "vtkWaterRankSamples.h"
#include "vtkWaterRanks.h"
#include "vtkWaterSkyReader.h"
#include "vtkWaterTarget.h"
#include "vtkWaterTranslucent.h"
#include "vtkWaterTranslucentLayer.h"
#include "vtkWaterVisibility.h"
#include "water_plan.h"

#include <functional>
#include <vector>

class vtkCamera;
class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkProp;
class vtkRenderer;
class vtkShadowMapPass;
class vtkWaterSecondaryLookup;
class vtkWaterShaderHook;

class vtkWaterMirroredView
{
public:
  // What a plan is carried out with.
  struct Draft
  {
    vtkWaterShaderHook* Hook = nullptr;
    std::vector<vtkProp*> Props;          // that are drawn
    std::vector<vtkWaterPropFacts> Known; // of each of them
    std::vector<vtkProp*> Others;         // of them, what is not a plain actor
    std::vector<vtkProp*> Blended;        // of them, those, and plain actors that are translucent
    bool HasMarchedRays = false;          // rays are traced in it
    bool WantsPeel = false;               // and go on behind edges
    bool CanCut = false;                  // clusters of large meshes may be left out
    bool IsDepth = false;                 // depths of what is opaque are all that is looked at
    vtkWaterSkyTextures Sky;              // of the plan's sky
    vtkWaterSecondaryLookup* Secondary = nullptr; // of other waters; nullptr: they reflect the sky
    vtkShadowMapPass* Shadows = nullptr;          // which is up to date; nullptr: there are none
    vtkWaterRanks* Ranks = nullptr; // that draw the view together; nullptr: there are none
    // With ranks: tells them what was drawn here, once all that is opaque is, and again if anything
    // is blended on any of them, or a peel is wanted. Unless all of them have drawn it, Draw ends
    // then.
    std::function<const vtkWaterRanks::Drawing&(const water_rank_drawn& mine)> Agree;
  };

  // Draws the props into the target.
  //
  // Returns nullptr, or what went wrong in a few words; the target is then not to be used.
  const char* Draw(vtkRenderer* renderer, const water_plan& plan, Draft& draft);

  // What there was no memory for in the last call of FindVisible or Draw: more was drawn than is
  // seen.
  const vtkWaterShortage& GetShortage() const
  {
    return this->Shortage.What ? this->Shortage : this->Clusters.GetShortage();
  }

  // Which cells of the reflection texture visible water looks up, by the picture that is bound for
  // drawing; nullptr: all of it may be, or that is not to be asked.
  //
  // isWanted  water_plan_wants_visibility
  const water_visibility* FindVisible(vtkRenderer* renderer, const water_plan& plan, bool isWanted);

  // In the middle of Draw, which runs the user's observers: nothing may be released then.
  bool GetIsDrawing() const { return this->IsDrawing; }

  // Fills the mip levels with what was drawn last.
  void MakeLevels();

  vtkTextureObject* GetColor() { return this->Target.GetColor(); }
  vtkTextureObject* GetDepth() { return this->Target.GetDepth(); }

  // What is translucent in it; nullptr: nothing, or no rays are traced.
  vtkWaterTranslucentLayer* GetLayer() { return this->HasLayer ? &this->Layer : nullptr; }

  // What is behind its first things; nullptr: no rays go there.
  vtkWaterPeel* GetPeel() { return this->HasPeel ? &this->Peel : nullptr; }

  vtkWaterBackground& GetBackground() { return this->Background; }
  vtkWaterFog& GetFog() { return this->Fog; }
  vtkWaterGpuQueries& GetGpuQueries() { return this->GpuQueries; }

  // A texture of one pixel, for surfaces that have no reflection to look up.
  vtkTextureObject* GetBlank(vtkOpenGLRenderWindow* window);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  void SetCamera(vtkRenderer* renderer, const water_plan& plan);
  void DrawBackground(vtkRenderer* renderer, const water_plan& plan, const Draft& draft);
  const char* DrawProps(vtkRenderer* renderer, const water_plan& plan, Draft& draft);
  void DrawOpaque(vtkRenderer* renderer, const water_plan& plan, const Draft& draft);
  void DrawTranslucent(vtkRenderer* renderer, const water_plan& plan, Draft& draft);
  // With other ranks, vtkWaterMirroredRanks.cxx: what is opaque on all of them, then what all
  // blend, and what is behind the first things.
  struct RankParts;
  const char* JoinOpaque(vtkRenderer* renderer, const water_plan& plan, Draft& draft);
  const char* JoinHeights(const water_plan& plan, const Draft& draft); // of a depth alone
  const char* JoinMore(vtkRenderer* renderer, const water_plan& plan, Draft& draft,
    const vtkWaterRanks::Drawing& drawing);
  bool DrawOwnLayer(vtkRenderer* renderer, const water_plan& plan, Draft& draft, RankParts& parts);
  bool DrawOwnPeel(vtkRenderer* renderer, const water_plan& plan, Draft& draft, RankParts& parts);
  bool JoinLayers(const Draft& draft, const std::vector<size_t>& order, RankParts& parts);
  void DrawPeel(vtkRenderer* renderer, const water_plan& plan, Draft& draft);
  void DrawProp(vtkRenderer* renderer, const Draft& draft, size_t number);

  vtkWaterTarget Target;
  vtkWaterBackground Background;
  vtkWaterFog Fog;
  vtkWaterClosedCells ClosedCells;
  vtkWaterVisibility Visibility;
  const water_visibility* Visible = nullptr; // of the last one that was drawn, or is about to be
  vtkWaterClusters Clusters;
  vtkWaterBlocks Blocks;
  vtkWaterClipDistance ClipDistance;
  vtkWaterGpuQueries GpuQueries;
  vtkSmartPointer<vtkTextureObject> Blank;
  vtkSmartPointer<vtkCamera> Camera;
  vtkWaterTranslucent Translucent;
  vtkWaterTranslucentLayer Layer;
  vtkWaterShortage Shortage; // of what is visible
  vtkWaterPeel Peel;
  vtkWaterRankSamples RankSamples;
  bool HasLayer = false;
  bool HasPeel = false;
  bool IsDrawing = false;
};

#endif

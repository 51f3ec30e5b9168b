// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterShaderHook: plan -> shader replacements and uniforms, with vtkWaterSurfaceShader for the
// water's own.
//
// It is a key in the RenderPasses list of the props: mappers ask the passes of that list to change
// their shaders. One object serves all waters that a thread renders, because a mapper rebuilds its
// shaders whenever the list changes: with one key per water, two waters would rebuild everything,
// twice a frame. See Documentation/decisions.
#ifndef vtkWaterShaderHook_h
#define vtkWaterShaderHook_h

#include "vtkOpenGLRenderPass.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkWaterShaderFailures.h"
#include "vtkWeakPointer.h"
#include "water_types.h"

#include <unordered_set>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkProp;
class vtkWaterClipDistance;
class vtkWaterBlocks;
class vtkWaterClusters;
class vtkWaterPropRecords;
class vtkWaterSecondaryLookup;
struct vtkWaterSkyTextures;
class vtkWaterSource;
class vtkWaterSurfaceShader;

class vtkWaterShaderHook : public vtkOpenGLRenderPass
{
public:
  static vtkWaterShaderHook* New();
  vtkTypeMacro(vtkWaterShaderHook, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  // Which props go without the lines that this object adds.
  vtkWaterShaderFailures Failures;

  // Of the frame that began last; nullptr: none has, or it is gone.
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;

  // Of that frame; nullptr: it has ended.
  vtkWaterPropRecords* Records = nullptr;

  // Its driver cuts by clip distances: else every prop discards, which shows the same.
  bool CanClip = true;

  // What is drawn into a reflection texture.
  struct View
  {
    const water_plan* Plan = nullptr;
    water_camera Eye = water_camera(); // of the picture that it is drawn for
    const std::vector<vtkProp*>* Props = nullptr;
    const vtkWaterSkyTextures* Sky = nullptr; // of the plan's sky
    vtkWaterClusters* Clusters = nullptr;     // of large meshes, if they may be drawn in clusters
    vtkWaterBlocks* Blocks = nullptr;         // of composite data, if Clusters is set
    vtkWaterClipDistance* ClipDistance = nullptr;
    vtkWaterSecondaryLookup* Secondary = nullptr; // of other waters; nullptr: all reflect the sky
  };

  // May what is drawn next be cut by the clip at the water, by where it is? It is if its vertices
  // may be elsewhere.
  void SetMayBeCut(bool mayBe) { this->MayBeCut = mayBe; }

  // From now on programs can leave out what the reflection texture shows: those of all windows of
  // the thread are built once more when this is called for the first time, and stay so.
  void WantPeel();

  // Where the reflection texture's depth is bound for that: the last texture unit, which textures
  // come to last. Programs name it in every draw.
  static int GetPeelUnit(vtkOpenGLRenderWindow* window);

  // What is behind the first things of the mirrored view is drawn between the two.
  void BeginPeel() { this->SetPeeling(true); }
  void EndPeel() { this->SetPeeling(false); }

  // A mirrored view is drawn between the two.
  void BeginMirroredView(const View& view);
  void EndMirroredView();

  // Translucent geometry writes its depth until then; nullptr: no more.
  void SetDepthWriter(vtkOpenGLState* state) { this->DepthWriter = state; }
  bool IsInMirroredView() const { return this->Mirrored.Plan != nullptr; }
  const View& GetMirroredView() const { return this->Mirrored; }

  // This surface is drawn between the two.
  //
  // probed  a state in which it leaves no trace in the depth, or none
  void BeginSurface(vtkWaterSurfaceShader* surface, vtkOpenGLState* probed);
  // Returns false when the driver has refused the shader that was built for it.
  bool EndSurface();

  void Render(const vtkRenderState*) override {} // a key only, it draws nothing
  vtkMTimeType GetShaderStageMTime() override;
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vao) override;

protected:
  vtkWaterShaderHook();
  ~vtkWaterShaderHook() override;

private:
  vtkWaterShaderHook(const vtkWaterShaderHook&) = delete;
  void operator=(const vtkWaterShaderHook&) = delete;

  void ReplaceForWater(vtkWaterSource& water, std::string& vertexShader,
    const std::string& geometryShader, std::string& fragmentShader) const;
  void SetMirroredParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop);
  void SetIsAwaited(bool isAwaited);
  void SetPeeling(bool isPeeling);
  void SetPeelParameters(vtkShaderProgram* program);
  void SetClipDistance(
    vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, bool isCut);

  View Mirrored;
  bool MayBeCut = true;
  vtkTimeStamp PeelTime; // 0: none has been wanted
  bool IsPeeling = false;
  std::unordered_set<vtkShaderProgram*> SetUp; // programs that know the present view
  vtkShaderProgram* LastSetUp = nullptr;       // one of them
  vtkWaterSurfaceShader* Surface = nullptr;
  vtkOpenGLState* Probed = nullptr;
  vtkOpenGLState* DepthWriter = nullptr; // in it, of translucent geometry
  bool IsAwaited = false; // the surface's shader was built, and nobody has asked for its parameters
};

#endif

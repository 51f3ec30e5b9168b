// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterShading: plan -> shader replacements and uniforms, with vtkWaterSurface for the water's
// own.
//
// It is a key in the RenderPasses list of the props: mappers ask the passes of that list to change
// their shaders. One object serves all waters that a thread renders, because a mapper rebuilds its
// shaders whenever the list changes: with one key per water, two waters would rebuild everything,
// twice a frame. See Documentation/decisions.
#ifndef vtkWaterShading_h
#define vtkWaterShading_h

#include "vtkOpenGLRenderPass.h"
#include "vtkSmartPointer.h"
#include "vtkWaterKeys.h"
#include "vtkWaterRefusals.h"
#include "water_types.h"

#include <unordered_set>
#include <vector>

class vtkOpenGLState;
class vtkProp;
class vtkRenderer;
class vtkWaterPieces;
class vtkWaterSurface;

class vtkWaterShading : public vtkOpenGLRenderPass
{
public:
  static vtkWaterShading* New();
  vtkTypeMacro(vtkWaterShading, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  // The object of the thread that renders, whichever thread made the water. It lives as long as
  // the thread.
  static vtkWaterShading* GetOfThread();

  // Which props carry this object in their lists.
  vtkWaterKeys Keys;

  // Which of them go without the lines that this object adds.
  vtkWaterRefusals Refusals;

  // What is drawn into a map.
  struct View
  {
    const water_plan* Plan = nullptr;
    water_camera Eye = water_camera(); // of the picture that it is drawn for
    const std::vector<vtkProp*>* Props = nullptr;
    vtkWaterPieces* Pieces = nullptr; // of large meshes, if they may be drawn in pieces
  };

  // A mirrored view is drawn between the two.
  void BeginMirroredView(const View& view);
  void EndMirroredView();

  // Translucent geometry writes its depth until then; nullptr: no more.
  void SetDepthWriter(vtkOpenGLState* state) { this->DepthWriter = state; }
  bool IsInMirroredView() const { return this->Mirrored.Plan != nullptr; }
  const View& GetMirroredView() const { return this->Mirrored; }

  // Is this the first water that an eye is in, in the renderer's frame? The others add no fog.
  bool BeginFog(vtkRenderer* renderer, const water_plan& plan);

  // This surface is drawn between the two.
  //
  // probed  a state in which it leaves no trace in the depth, or none
  void BeginSurface(vtkWaterSurface* surface, vtkOpenGLState* probed)
  {
    this->Surface = surface;
    this->Probed = probed;
    this->IsAwaited = false;
  }
  // Returns false when the driver has refused the shader that was built for it.
  bool EndSurface()
  {
    this->Surface = nullptr;
    return !this->IsAwaited;
  }

  void Render(const vtkRenderState*) override {} // a key only, it draws nothing
  vtkMTimeType GetShaderStageMTime() override { return this->Refusals.GetTime(); }
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vao) override;

protected:
  vtkWaterShading();
  ~vtkWaterShading() override;

private:
  vtkWaterShading(const vtkWaterShading&) = delete;
  void operator=(const vtkWaterShading&) = delete;

  void SetMirroredParameters(vtkShaderProgram* program, vtkProp* prop);

  View Mirrored;
  std::unordered_set<vtkShaderProgram*> SetUp; // programs that know the present view
  vtkMTimeType FogFrame = 0;
  double FogEye[12] = {}; // its directions
  vtkWaterSurface* Surface = nullptr;
  vtkOpenGLState* Probed = nullptr;
  vtkOpenGLState* DepthWriter = nullptr; // in it, of translucent geometry
  bool IsAwaited = false; // the surface's shader was built, and nobody has asked for its parameters
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterShading: plan -> shader replacements and uniforms. The only writer of uniforms.
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
#include "water_types.h"

#include <unordered_set>

class vtkProp;
class vtkRenderer;
class vtkTextureObject;
class vtkWaterProperty;

// What the shader of a surface needs besides the water's property.
struct vtkWaterSurface
{
  vtkWaterProperty* Property;
  vtkTextureObject* Reflection; // active; any texture when not reflecting
  const water_plan* Plan;       // nullptr: there is no mirrored view, show the plain colour
  bool IsFlat;                  // lies in the plane exactly
  vtkRenderer* Renderer;        // whose background is the sky
  // with waves; else nullptr
  vtkTextureObject* ReflectionDepth; // active
  vtkTextureObject* Waves;           // active; a row per wave
  int WaveCount;
  bool IsSteep; // waves that move their points
};

// Sets a 3 x 3 matrix given by rows; does nothing when the program has no use for it.
void vtkWaterSetUniformMatrix3(vtkShaderProgram* program, const char* name, const double rows[9]);

class vtkWaterShading : public vtkOpenGLRenderPass
{
public:
  static vtkWaterShading* New();
  vtkTypeMacro(vtkWaterShading, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  // The object of the thread that renders, whichever thread made the water. It lives as long as
  // the thread.
  static vtkWaterShading* GetOfThread();

  // The shaders of a surface. They are separate because software renderers execute both sides of a
  // branch. Another one is built when the surface's vtkProperty says that it was modified.
  enum Variants
  {
    CALM,
    RAY_TRACED,
    OFFSET
  };
  static Variants GetVariant(vtkWaterProperty* property);

  // Which props carry this object in their lists.
  vtkWaterKeys Keys;

  // The mirrored view of this plan is drawn between the two.
  void BeginMirroredView(const water_plan& plan);
  void EndMirroredView();
  bool IsInMirroredView() const { return this->MirroredView != nullptr; }

  // This surface is drawn between the two.
  void BeginSurface(const vtkWaterSurface& surface) { this->Surface = &surface; }
  void EndSurface() { this->Surface = nullptr; }

  void Render(const vtkRenderState*) override {} // a key only, it draws nothing
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

  void SetSurfaceParameters(vtkShaderProgram* program);
  void SetWaveParameters(vtkShaderProgram* program);
  void SetMirroredParameters(vtkShaderProgram* program, vtkProp* prop);

  const water_plan* MirroredView = nullptr;
  std::unordered_set<vtkShaderProgram*> SetUp; // programs that know the present view
  const vtkWaterSurface* Surface = nullptr;
};

#endif

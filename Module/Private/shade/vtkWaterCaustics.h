// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterCaustics: light that waves gather under water, as a texture over the picture: drawn anew
// for each draw of the water, in two steps: where the light of each point of a grid comes to
// (vtkWaterPhotonFS.glsl), and the sum of these (vtkWaterLightVS.glsl, vtkWaterLightFS.glsl). The
// numbers are the core's, water_caustics.h.
#ifndef vtkWaterCaustics_h
#define vtkWaterCaustics_h

#include "vtkOpenGLFramebufferObject.h" // for members
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h" // for members
#include "vtkWaterQuad.h"
#include "vtkWeakPointer.h"
#include "water_caustics_plan.h"

#include <functional>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkWindow;

class vtkWaterCaustics
{
public:
  using Parameters = std::function<void(vtkShaderProgram*)>;

  // What the eye sees under the water.
  struct Picture
  {
    vtkTextureObject* Depth; // window depths; active
    const double*
      HeightClip; // point in clip space of the eye -> height over the plane, times w; of four
    const double* ClipW; // the same -> w of the point in view space
  };

  vtkWaterCaustics();
  ~vtkWaterCaustics();

  // Draws the light. GL's state is as before.
  //
  // photonShader   fragment shader without what VTK wants around it
  // setParameters  sets its uniforms, but for those of water_caustics
  //
  // Returns false when the GPU refuses; what it refused is not tried again in the window while the
  // shader is the same.
  bool Draw(vtkOpenGLRenderWindow* window, const water_caustics& caustics, const Picture& picture,
    const std::string& photonShader, const Parameters& setParameters);

  bool GetHasFailed() const { return this->HasFailed; }

  // Of the last draw, one channel: light over that of calm water.
  vtkTextureObject* GetLight() { return this->Light; }

  // Depth under water of the bed that it lies on, over the picture.
  vtkTextureObject* GetBed() { return this->Beds[1]; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Ensure(vtkOpenGLRenderWindow* window, const water_caustics& caustics);
  bool DrawBed(
    vtkOpenGLRenderWindow* window, const water_caustics& caustics, const Picture& picture);
  bool DrawPhotons(
    vtkOpenGLRenderWindow* window, const water_caustics& caustics, const Parameters& setParameters);
  bool AddLight(const water_caustics& caustics); // on the CPU
  bool DrawLight(vtkOpenGLRenderWindow* window, const water_caustics& caustics);

  vtkSmartPointer<vtkTextureObject> Photons[2]; // places and weights; shapes
  vtkSmartPointer<vtkTextureObject> Light;
  vtkSmartPointer<vtkOpenGLFramebufferObject> PhotonFramebuffer;
  vtkSmartPointer<vtkOpenGLFramebufferObject> LightFramebuffer;
  vtkSmartPointer<vtkOpenGLVertexArrayObject> Points; // without attributes
  vtkSmartPointer<vtkTextureObject> Beds[2];          // each from the other
  vtkSmartPointer<vtkOpenGLFramebufferObject> BedFramebuffers[2];
  vtkWaterQuad BedQuad;
  vtkWaterQuad Quad;
  std::vector<float> Read[2]; // the photons
  std::vector<float> Sum;
  std::string PhotonShader; // that the quad has
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  bool HasFailed = false;
};

#endif

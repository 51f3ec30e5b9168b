// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterAccess.h: the protected members of VTK that are swapped silently.
//
// The public setters fire events and bump modification times, which a user's observers and caches
// would see in every frame although nothing of theirs changed. A pointer to member formed in a
// derived class is plain C++ and does not depend on the layout of the class.
#ifndef vtkWaterAccess_h
#define vtkWaterAccess_h

#include "vtkActor.h"
#include "vtkCameraActor.h"
#include "vtkLightActor.h"
#include "vtkMapper.h"
#include "vtkObject.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkShadowMapPass.h"
#include "vtkVersion.h"

#include <string>
#include <vector>

namespace vtkWaterAccess
{
struct Renderer : public vtkRenderer
{
  static vtkCamera*& ActiveCameraOf(vtkRenderer* renderer)
  {
    return renderer->*(&Renderer::ActiveCamera);
  }
  // What is drawn in this frame, in this order; there from culling to the end of the frame.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0)
  static vtkProp** PropsOf(vtkRenderer* renderer)
  {
    return (renderer->*(&Renderer::PropArray)).data();
  }
  static int PropCountOf(vtkRenderer* renderer)
  {
    return static_cast<int>((renderer->*(&Renderer::PropArray)).size());
  }
#else
  static vtkProp** PropsOf(vtkRenderer* renderer)
  {
    return renderer->*(&Renderer::PropArray);
  }
  static int PropCountOf(vtkRenderer* renderer)
  {
    return renderer->*(&Renderer::PropArrayCount);
  }
#endif
};

struct OpenGLRenderer : public vtkOpenGLRenderer
{
  // The renderer owns a reference; nullptr until it draws shadows for the first time.
  static vtkShadowMapPass*& ShadowMapPassOf(vtkOpenGLRenderer* renderer)
  {
    return renderer->*(&OpenGLRenderer::ShadowMapPass);
  }
};

struct ShadowMapPass : public vtkShadowMapPass
{
  static vtkRenderPass*& OpaqueSequenceOf(vtkShadowMapPass* pass)
  {
    return pass->*(&ShadowMapPass::OpaqueSequence);
  }
  // From view coordinates to those of the shadow maps, 16 numbers for each.
  static std::vector<double>& TransformsOf(vtkShadowMapPass* pass)
  {
    return pass->*(&ShadowMapPass::ShadowTransforms);
  }
};

struct AbstractMapper : public vtkAbstractMapper
{
  static vtkPlaneCollection*& ClippingPlanesOf(vtkAbstractMapper* mapper)
  {
    return mapper->*(&AbstractMapper::ClippingPlanes);
  }
};

struct Mapper : public vtkMapper
{
  // Is its input drawn as it is, without being brought up to date first?
  static vtkTypeBool& StaticOf(vtkMapper* mapper) { return mapper->*(&Mapper::Static); }
};

struct PolyDataMapper : public vtkOpenGLPolyDataMapper
{
  // The index buffer that lists the triangles of polygons; the mapper owns a reference.
  static vtkOpenGLIndexBufferObject*& TrianglesOf(vtkOpenGLPolyDataMapper* mapper)
  {
    return (mapper->*(&PolyDataMapper::Primitives))[PrimitiveTris].IBO;
  }
  // Are those what it draws next? Between two draws nothing is.
  static bool AreTrianglesNext(vtkOpenGLPolyDataMapper* mapper)
  {
    return BuiltOf(mapper) == &(mapper->*(&PolyDataMapper::Primitives))[PrimitiveTris];
  }
  // Of the points of all primitives.
  static vtkOpenGLVertexBufferObject* VerticesOf(vtkOpenGLPolyDataMapper* mapper)
  {
    return (mapper->*(&PolyDataMapper::VBOs))->GetVBO("vertexMC");
  }
  // What its shaders are being built for; nullptr between two draws.
  static vtkOpenGLHelper* BuiltOf(vtkOpenGLPolyDataMapper* mapper)
  {
    return mapper->*(&PolyDataMapper::LastBoundBO);
  }
};

struct Actor : public vtkActor
{
  // Is all of it drawn as opaque, whatever its parts say?
  static bool& ForceOpaqueOf(vtkActor* actor) { return actor->*(&Actor::ForceOpaque); }
  // The bounds that GetBounds found last, and when it did.
  static const double* BoundsOf(vtkActor* actor) { return actor->*(&Actor::Bounds); }
  static vtkMTimeType BoundsTimeOf(vtkActor* actor)
  {
    return (actor->*(&Actor::BoundsMTime)).GetMTime();
  }
};

struct CameraActor : public vtkCameraActor
{
  // What it draws; made when it is asked for its bounds, or drawn.
  static vtkActor* FrustumOf(vtkCameraActor* actor) { return actor->*(&CameraActor::FrustumActor); }
};

struct LightActor : public vtkLightActor
{
  // What it draws, made as above.
  static vtkActor* ConeOf(vtkLightActor* actor) { return actor->*(&LightActor::ConeActor); }
  static vtkCameraActor* FrustumOf(vtkLightActor* actor)
  {
    return actor->*(&LightActor::FrustumActor);
  }
};

struct ShaderCache : public vtkOpenGLShaderCache
{
  // Makes sources of the templates that mappers hand over, as a driver gets them.
  static void Finish(
    vtkOpenGLShaderCache* cache, std::string& vertex, std::string& geometry, std::string& fragment)
  {
    Finish(cache, &ShaderCache::ReplaceShaderValues, vertex, geometry, fragment);
  }

private:
  using Three = unsigned int (vtkOpenGLShaderCache::*)(std::string&, std::string&, std::string&);
  using Five = unsigned int (vtkOpenGLShaderCache::*)(
    std::string&, std::string&, std::string&, std::string&, std::string&); // with tessellation
  static void Finish(vtkOpenGLShaderCache* cache, Three replace, std::string& vertex,
    std::string& geometry, std::string& fragment)
  {
    (cache->*replace)(vertex, fragment, geometry);
  }
  static void Finish(vtkOpenGLShaderCache* cache, Five replace, std::string& vertex,
    std::string& geometry, std::string& fragment)
  {
    std::string none[2];
    (cache->*replace)(vertex, fragment, geometry, none[0], none[1]);
  }
};

struct Object : public vtkObject
{
  // Of its last modification.
  static vtkTimeStamp& TimeOf(vtkObject* object) { return object->*(&Object::MTime); }
};

struct Prop : public vtkProp
{
  // The prop owns one reference, as if set by SetPropertyKeys.
  static vtkInformation*& PropertyKeysOf(vtkProp* prop) { return prop->*(&Prop::PropertyKeys); }
};
}
#endif

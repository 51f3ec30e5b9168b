// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterAccess.h: the protected members of VTK that are swapped silently.
//
// The public setters fire events and bump modification times, which a user's observers and caches
// would see in every frame although nothing of theirs changed. A pointer to member formed in a
// derived class is plain C++ and does not depend on the layout of the class.
#ifndef vtkWaterAccess_h
#define vtkWaterAccess_h

#include "vtkActor.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkProp.h"
#include "vtkRenderer.h"

namespace vtkWaterAccess
{
struct Renderer : public vtkRenderer
{
  static vtkCamera*& ActiveCameraOf(vtkRenderer* renderer)
  {
    return renderer->*(&Renderer::ActiveCamera);
  }
  // What is drawn in this frame, in this order; there from culling to the end of the frame.
  static vtkProp** PropsOf(vtkRenderer* renderer) { return renderer->*(&Renderer::PropArray); }
  static int PropCountOf(vtkRenderer* renderer) { return renderer->*(&Renderer::PropArrayCount); }
};

struct PolyDataMapper : public vtkOpenGLPolyDataMapper
{
  // The index buffer that lists the triangles of polygons; the mapper owns a reference.
  static vtkOpenGLIndexBufferObject*& TrianglesOf(vtkOpenGLPolyDataMapper* mapper)
  {
    return (mapper->*(&PolyDataMapper::Primitives))[PrimitiveTris].IBO;
  }
};

struct Actor : public vtkActor
{
  // The bounds that GetBounds found last, and when it did.
  static const double* BoundsOf(vtkActor* actor) { return actor->*(&Actor::Bounds); }
  static vtkMTimeType BoundsTimeOf(vtkActor* actor)
  {
    return (actor->*(&Actor::BoundsMTime)).GetMTime();
  }
};

struct Prop : public vtkProp
{
  // The prop owns one reference, as if set by SetPropertyKeys.
  static vtkInformation*& PropertyKeysOf(vtkProp* prop) { return prop->*(&Prop::PropertyKeys); }
};
}
#endif

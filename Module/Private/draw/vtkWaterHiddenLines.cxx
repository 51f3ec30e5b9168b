// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterHiddenLines.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"
#include "vtkWaterGL.h"

namespace
{
constexpr double kOffset = 2.0; // of VTK's pass

// Surfaces lie behind their own edges while an object of this class lives.
struct ScopedOffset
{
  ScopedOffset()
    : Mode(vtkMapper::GetResolveCoincidentTopology())
  {
    vtkMapper::GetResolveCoincidentTopologyPolygonOffsetParameters(this->Factor, this->Units);
    vtkMapper::SetResolveCoincidentTopology(VTK_RESOLVE_POLYGON_OFFSET);
    vtkMapper::SetResolveCoincidentTopologyPolygonOffsetParameters(kOffset, kOffset);
  }
  ~ScopedOffset()
  {
    vtkMapper::SetResolveCoincidentTopology(this->Mode);
    vtkMapper::SetResolveCoincidentTopologyPolygonOffsetParameters(this->Factor, this->Units);
  }

  int Mode;
  double Factor = 0.0;
  double Units = 0.0;
};

struct Wireframe
{
  size_t Number;
  vtkSmartPointer<vtkProperty> Property; // the user's observers may drop it
};
}

//------------------------------------------------------------------------------
bool vtkWaterHiddenLines::AreRemoved(vtkRenderer* renderer)
{
  return renderer->GetUseHiddenLineRemoval() && !renderer->GetPass();
}

//------------------------------------------------------------------------------
void vtkWaterHiddenLines::Draw(vtkRenderer* renderer, const std::vector<vtkProp*>& props,
  const std::function<void(size_t)>& draw)
{
  std::vector<Wireframe> wireframes;
  for (size_t i = 0; i < props.size(); ++i)
  {
    auto* actor = vtkActor::SafeDownCast(props[i]);
    if (actor && actor->GetProperty()->GetRepresentation() == VTK_WIREFRAME)
    {
      wireframes.push_back({ i, actor->GetProperty() });
    }
    else
    {
      draw(i);
    }
  }
  if (wireframes.empty())
  {
    return;
  }
  vtkOpenGLState* state = static_cast<vtkOpenGLRenderer*>(renderer)->GetState();
  const ScopedOffset scopedOffset;
  // before any of them is drawn: they may share a property
  for (const Wireframe& wireframe : wireframes)
  {
    wireframe.Property->SetRepresentation(VTK_SURFACE);
  }
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  for (const Wireframe& wireframe : wireframes)
  {
    draw(wireframe.Number);
  }
  for (const Wireframe& wireframe : wireframes)
  {
    wireframe.Property->SetRepresentation(VTK_WIREFRAME);
  }
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  for (const Wireframe& wireframe : wireframes)
  {
    draw(wireframe.Number);
  }
}

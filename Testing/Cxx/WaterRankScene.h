// SPDX-License-Identifier: BSD-3-Clause
// WaterRankScene.h: the parts of a scene that ranks have.
#ifndef WaterRankScene_h
#define WaterRankScene_h

#include "WaterTestScene.h"

#include "vtkPropCollection.h"

#include <vector>

// Leaves a rank its own things and the water.
//
// isOwn(actor, number)  the number is the actor's place among the scene's
template <typename IsOwn>
void WaterKeepProps(WaterTestScene& scene, IsOwn isOwn)
{
  std::vector<vtkActor*> others;
  vtkPropCollection* props = scene.Renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    auto* actor = vtkActor::SafeDownCast(props->GetItemAsObject(i));
    if (actor != scene.Water.Get() && !isOwn(actor, i))
    {
      others.push_back(actor);
    }
  }
  for (vtkActor* actor : others)
  {
    scene.Renderer->RemoveActor(actor);
  }
}

// Adds balls in a square, of which each rank has a block; they are fine enough that drawing takes
// time.
//
// count       of all ranks together
// resolution  of a ball: it has about 2 x resolution x resolution triangles
// rank        whose balls; -1: all
inline void WaterAddBalls(WaterTestScene& scene, int count, int ranks, int resolution, int rank)
{
  int side = 1;
  while (side * side < count)
  {
    ++side;
  }
  const double step = 17.0 / side;
  for (int i = 0; i < count; ++i)
  {
    if (rank >= 0 && static_cast<long long>(i) * ranks / count != rank)
    {
      continue;
    }
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(-8.5 + step * (i % side), -6.5 + step * (i / side), 0.6 + 0.1 * (i % 7));
    ball->SetRadius(0.45 * step);
    ball->SetThetaResolution(resolution);
    ball->SetPhiResolution(resolution);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.2 + 0.1 * (i % 8), 0.9 - 0.1 * (i % 5), 0.4);
    scene.Renderer->AddActor(actor);
  }
}

#endif

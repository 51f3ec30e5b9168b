// SPDX-License-Identifier: BSD-3-Clause
// WaterRankPart.h: the part of a scene that a rank has which may do something wrong.
#ifndef WaterRankPart_h
#define WaterRankPart_h

#include "WaterRankScene.h"
#include "WaterTestScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkMultiProcessController.h"
#include "vtkWaterReflectionPass.h"

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

// A prop that throws when it is asked where it is, or more, once the cullers have asked.
class FaultyActor : public vtkActor
{
public:
  static FaultyActor* New();
  vtkTypeMacro(FaultyActor, vtkActor);
  bool IsBroken = false;
  bool IsCulled = false;
  bool IsHidingTime = false; // throws when it is asked whether it has changed
  bool IsHidingData = false; // and what it shows
  void SetAllocatedRenderTime(double seconds, vtkViewport* viewport) override
  {
    this->IsCulled = true;
    this->vtkActor::SetAllocatedRenderTime(seconds, viewport);
  }
  double* GetBounds() override
  {
    if (this->IsBroken && this->IsCulled)
    {
      throw std::runtime_error("no bounds");
    }
    return this->vtkActor::GetBounds();
  }
  vtkMTimeType GetRedrawMTime() override
  {
    if (this->IsHidingTime && this->IsCulled)
    {
      throw std::runtime_error("no time");
    }
    return this->vtkActor::GetRedrawMTime();
  }
  void InitPathTraversal() override
  {
    if (this->IsHidingData && this->IsCulled)
    {
      throw std::runtime_error("no data");
    }
    this->vtkActor::InitPathTraversal();
  }
};
inline vtkStandardNewMacro(FaultyActor);

enum class RankView
{
  PICTURE,
  MIRRORED,
  OWN,
  SUN,
  SKY
};

// A rank's part of the scene: every third thing, one of them translucent.
struct Part : public WaterTestScene
{
  // waitLimit  s
  Part(vtkMultiProcessController* controller, int ranks, double waitLimit)
  {
    this->AddThings<vtkPolyDataMapper>();
    const int rank = controller->GetLocalProcessId();
    WaterKeepProps(*this, [&](vtkActor* actor, int number) {
      const bool isOwn = number % ranks == rank;
      if (isOwn)
      {
        (this->First ? this->Glass : this->First) = actor;
      }
      return isOwn;
    });
    this->Glass->GetProperty()->SetOpacity(0.5);
    this->Thing->SetMapper(this->First->GetMapper());
    this->Renderer->AddActor(this->Thing);
    this->AddWater();
    this->Water->GetReflectionPass()->SetController(controller);
    this->Water->GetReflectionPass()->SetRankWaitLimit(waitLimit);
    vtkNew<vtkCallbackCommand> nothing; // errors are asked for, not printed
    nothing->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    this->Water->AddObserver(vtkCommand::ErrorEvent, nothing);
    this->Renderer->AddObserver(vtkCommand::ErrorEvent, nothing);
  }

  // All views are wanted; a rank has the dome that rays of waves find in the sky view.
  void WantViews(bool hasDome)
  {
    vtkWaterProperty* look = this->Water->GetWaterProperty();
    look->SetMetresPerUnit(1.0);
    look->RefractionOn();
    look->SetRefractionSourceToOwnView();
    look->AddWave(0.04, 2.1, 30.0);
    look->ShadowsOn();
    vtkNew<vtkLight> sun;
    sun->SetPosition(8.0, 12.0, 9.0);
    sun->SetFocalPoint(0.0, 0.0, 0.0);
    this->Renderer->AddLight(sun);
    this->Renderer->GetActiveCamera()->SetClippingRange(1.0, 100.0);
    if (hasDome)
    {
      vtkNew<vtkSphereSource> dome;
      dome->SetRadius(40.0);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(dome->GetOutputPort());
      this->Dome->SetMapper(mapper);
      this->Renderer->AddActor(this->Dome);
    }
  }

  // What is drawn is known by its camera: a view that is no picture has a projection of its own,
  // and the sky view stands in the plane.
  RankView GetView()
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const double height = camera->GetPosition()[2];
    if (!camera->GetUseExplicitProjectionTransformMatrix())
    {
      return RankView::PICTURE;
    }
    if (std::abs(height) < 0.1)
    {
      return RankView::SKY;
    }
    return height < 0.0 ? RankView::MIRRORED : height < 20.0 ? RankView::OWN : RankView::SUN;
  }

  // Does something when a thing is drawn in a view.
  void When(vtkActor* actor, RankView view, std::function<void()> action)
  {
    this->Action = action;
    this->Awaited = view;
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long, void* data, void*) {
      auto* self = static_cast<Part*>(data);
      if (self->Action && self->GetView() == self->Awaited)
      {
        self->Action();
      }
    });
    actor->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, command);
  }

  void Render()
  {
    this->Renderer->GetActiveCamera()->Azimuth(1.0); // or nothing is drawn
    this->Window->Render();
  }

  std::string GetError() { return this->Water->GetLastError(); }
  bool IsReflecting()
  {
    return this->Water->GetReflectionPass()->GetDecision() == vtkWaterReflectionPass::RENDERED;
  }

  vtkActor* First = nullptr;
  vtkActor* Glass = nullptr;
  vtkNew<vtkActor> Dome;
  vtkNew<FaultyActor> Thing;
  std::function<void()> Action;
  RankView Awaited = RankView::PICTURE;
};

#endif

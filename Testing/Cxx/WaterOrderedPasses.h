// SPDX-License-Identifier: BSD-3-Clause
// WaterOrderedPasses.h: VTK's passes that join the ranks' depths (vtkCompositeZPass) and blend
// their pictures in the order of a k-d tree (vtkCompositeRGBAPass), as an engine for
// WaterOrderedScene.h.
#ifndef WaterOrderedPasses_h
#define WaterOrderedPasses_h

#include "WaterOrderedScene.h"

#include "vtkBSPCuts.h"
#include "vtkCameraPass.h"
#include "vtkCompositeRGBAPass.h"
#include "vtkCompositeZPass.h"
#include "vtkDepthPeelingPass.h"
#include "vtkKdNode.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkOverlayPass.h"
#include "vtkPKdTree.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"

// A node of a k-d tree that is divided across these axes, one after the other.
//
// region  the number of its first region
inline vtkKdNode* WaterDivide(const double bounds[6], std::vector<int> axes, int region)
{
  vtkKdNode* node = vtkKdNode::New();
  node->SetBounds(bounds[0], bounds[1], bounds[2], bounds[3], bounds[4], bounds[5]);
  node->SetDataBounds(bounds[0], bounds[1], bounds[2], bounds[3], bounds[4], bounds[5]);
  node->SetDim(axes.empty() ? 3 : axes.front()); // 3: a region
  node->SetID(axes.empty() ? region : -1);
  if (axes.empty())
  {
    return node;
  }
  const int axis = axes.front();
  axes.erase(axes.begin());
  double lower[6];
  double upper[6];
  std::copy_n(bounds, 6, lower);
  std::copy_n(bounds, 6, upper);
  lower[2 * axis + 1] = upper[2 * axis] = axis == 1 ? kWaterCutY : kWaterCutX;
  vtkKdNode* left = WaterDivide(lower, axes, region);
  vtkKdNode* right = WaterDivide(upper, axes, region + (axes.empty() ? 1 : 2));
  node->AddChildNodes(left, right);
  left->Delete();
  right->Delete();
  return node;
}

// The tree of the planes of WaterOrderedScene.h.
inline void WaterBuildTree(vtkPKdTree* tree, vtkMultiProcessController* controller)
{
  const double bounds[6] = { -20.0, 20.0, -20.0, 20.0, -20.0, 20.0 };
  const bool areFour = controller->GetNumberOfProcesses() > 3;
  vtkKdNode* root =
    WaterDivide(bounds, areFour ? std::vector<int>{ 1, 0 } : std::vector<int>{ 1 }, 0);
  vtkNew<vtkBSPCuts> cuts;
  cuts->CreateCuts(root);
  tree->SetController(controller);
  tree->SetCuts(cuts);
  vtkNew<vtkCubeSource> whole;
  whole->SetXLength(39.0);
  whole->SetYLength(39.0);
  whole->SetZLength(39.0);
  whole->Update();
  tree->AddDataSet(whole->GetOutput());
  tree->AssignRegionsContiguous();
  tree->BuildLocator();
}

inline void WaterArrangePasses(WaterOrderedScene& scene, vtkMultiProcessController* controller)
{
  vtkNew<vtkPKdTree> tree;
  WaterBuildTree(tree, controller);
  vtkNew<vtkCompositeZPass> joinDepths;
  joinDepths->SetController(controller);
  vtkNew<vtkTranslucentPass> translucent;
  vtkNew<vtkDepthPeelingPass> peeling;
  peeling->SetMaximumNumberOfPeels(20);
  peeling->SetOcclusionRatio(0.0);
  peeling->SetTranslucentPass(translucent);
  vtkNew<vtkCompositeRGBAPass> blend;
  blend->SetController(controller);
  blend->SetKdtree(tree);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(vtkNew<vtkLightsPass>());
  passes->AddItem(vtkNew<vtkOpaquePass>());
  passes->AddItem(joinDepths);
  passes->AddItem(peeling);
  passes->AddItem(vtkNew<vtkVolumetricPass>());
  passes->AddItem(blend);
  passes->AddItem(vtkNew<vtkOverlayPass>());
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  scene.Renderer->SetPass(camera);
}

#endif

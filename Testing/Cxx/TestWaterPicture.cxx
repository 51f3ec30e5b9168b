// SPDX-License-Identifier: BSD-3-Clause
// Calm water under a gradient sky by exact Fresnel equals its baseline: the columns stand upside
// down in it, the sky is darker near the camera and brighter towards the horizon.
#include "WaterTestScene.h"

#include "vtkRegressionTestImage.h"
#include "vtkRenderWindowInteractor.h"

int TestWaterPicture(int argc, char* argv[])
{
  WaterTestScene scene;
  scene.AddThings<vtkPolyDataMapper>();
  scene.AddWater();
  scene.Window->Render();
  const int result = vtkRegressionTestImage(scene.Window);
  return result == vtkRegressionTester::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}

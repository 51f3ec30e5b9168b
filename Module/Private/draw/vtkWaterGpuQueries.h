// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterGpuQueries: what the last mirrored view and the last draw of the surface took, as the
// GPU counts it. Nothing is asked of the GPU while it is off.
#ifndef vtkWaterGpuQueries_h
#define vtkWaterGpuQueries_h

#include "vtkType.h"
#include "vtkWaterOcclusion.h"

#include <limits>
#include <memory>

class vtkObject;
class vtkOpenGLRenderTimer;

class vtkWaterGpuQueries
{
public:
  vtkWaterGpuQueries();
  ~vtkWaterGpuQueries();

  enum Parts
  {
    REFLECTION, // the mirrored view
    SURFACE,
    NUMBER_OF_PARTS
  };

  void SetOn(bool isOn) { this->IsOn = isOn; }
  bool GetIsOn() const { return this->IsOn; }

  // Times what is drawn between the two.
  void Begin(int part, vtkWindow* window);
  void End(int part);
  // Without timer queries nothing is timed; that is said once, if debugging of `told` is on.
  void SayMissing(vtkObject* told);
  // Counts the opaque geometry that is drawn between the two.
  void BeginCounting(vtkWindow* window);
  void EndCounting();

  // ms of the last one that the GPU has finished; NaN: there is none.
  double GetTime(int part);

  // Of the last count; -1: there is none, or the driver never says. They wait for the GPU, a second
  // at most.
  vtkIdType GetTriangles();
  vtkIdType GetFragments();

  void ReleaseGraphicsResources();

private:
  vtkWaterGpuQueries(const vtkWaterGpuQueries&) = delete;
  void operator=(const vtkWaterGpuQueries&) = delete;

  void Use(vtkWindow* window);

  bool IsOn = false;
  bool IsMissing = false; // timed, if the driver could
  bool IsSaid = false;
  vtkWindow* Window = nullptr; // compared only
  std::unique_ptr<vtkOpenGLRenderTimer> Timers[NUMBER_OF_PARTS];
  double Times[NUMBER_OF_PARTS] = { std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN() };
  vtkWaterOcclusion Fragments;
  unsigned int Triangles = 0; // a query
  bool IsCounting = false;
  bool HasCounted = false;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterOcclusion: counts the samples of a draw that are seen (an occlusion query of GL).
#ifndef vtkWaterOcclusion_h
#define vtkWaterOcclusion_h

#include "vtkType.h"

class vtkWindow;

class vtkWaterOcclusion
{
public:
  // What is drawn between the two is counted. Begin does nothing while somebody else counts.
  //
  // window  whose context is current; what another one's counted is forgotten
  void Begin(vtkWindow* window);
  void End();

  // Samples of the last draw that was counted; -1: none was, or it is not known to have been
  // finished yet.
  vtkIdType GetSamples(vtkWindow* window);

  // Samples of the last draw that was counted; waits for it, a second at most.
  // -1: none was, or the driver never says.
  vtkIdType WaitForSamples();

  // With the context that drew.
  void ReleaseGraphicsResources();

private:
  vtkWindow* Window = nullptr; // compared only
  unsigned int Query = 0;
  bool IsCounting = false;
  bool HasCounted = false;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterClipProbe: does a window's driver cut by GL's first clip distance as it should? It is
// asked once per window, by a draw of a few pixels. Some drivers do not, and a reflection that is
// not cut at the water is wrong all over.
#ifndef vtkWaterClipProbe_h
#define vtkWaterClipProbe_h

#include "vtkWeakPointer.h"

#include <vector>

class vtkObject;
class vtkOpenGLRenderWindow;

class vtkWaterClipProbe
{
public:
  // Also false while it cannot be asked, since somebody counts what is drawn.
  //
  // window  whose context is current
  // told    hears of a driver that does not, once per window, if its debugging is on
  bool Works(vtkOpenGLRenderWindow* window, vtkObject* told);

private:
  struct Answer
  {
    vtkWeakPointer<vtkOpenGLRenderWindow> Window; // a new one at an old place is asked anew
    bool IsRight = false;
    bool IsSaid = false;
  };
  std::vector<Answer> Answers;
};

#endif

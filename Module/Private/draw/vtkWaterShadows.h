// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterShadows: VTK's shadow maps in the mirrored view.
//
// A shadow map belongs to a light and not to a camera, so those that the picture is drawn with
// serve the mirrored view as well: the pass that reads them (vtkShadowMapPass) is asked to draw the
// mirrored view, too. It is the same object, so that a prop's shader stays the same in both.
#ifndef vtkWaterShadows_h
#define vtkWaterShadows_h

#include <functional>
#include <vector>

class vtkProp;
class vtkRenderPass;
class vtkRenderer;
class vtkShadowMapPass;

namespace vtkWaterShadows
{
// What shadows the renderer's picture: its own pass, or one in the user's chain; nullptr: nothing.
vtkShadowMapPass* Find(vtkRenderer* renderer);

// Bakes the maps unless they are up to date; the picture then finds them so. The renderer's camera
// is the user's.
void Bake(vtkRenderer* renderer, vtkShadowMapPass* pass);

// Draws with shadows, for the renderer's camera of the moment.
//
// pass  nullptr: there are none
// draw  draws the props
void Draw(vtkRenderer* renderer, vtkShadowMapPass* pass, std::vector<vtkProp*>& props,
  const std::function<void()>& draw);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterFrameAverage.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkHomogeneousTransform.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkTransform.h"
#include "vtkWaterCompat.h"
#include "vtkWindowToImageFilter.h"
#include "water_quality.h"

#include <algorithm>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWaterFrameAverage);

namespace
{
// The cameras of a window's renderers, shifted while an object of this class lives.
class ShiftedCameras
{
public:
  explicit ShiftedCameras(vtkRenderWindow* window)
  {
    vtkCollectionSimpleIterator it;
    vtkRendererCollection* renderers = window->GetRenderers();
    renderers->InitTraversal(it);
    while (vtkRenderer* renderer = renderers->GetNextRenderer(it))
    {
      vtkCamera* camera = renderer->GetActiveCamera();
      const auto isIt = [camera](const Shifted& shifted) { return shifted.Camera == camera; };
      if (std::none_of(this->Cameras.begin(), this->Cameras.end(), isIt))
      {
        this->Cameras.emplace_back();
        this->Cameras.back().Camera = camera;
        this->Cameras.back().Renderer = renderer;
        this->Cameras.back().Given = camera->GetUserTransform();
        camera->SetUserTransform(this->Cameras.back().Shift);
      }
    }
  }
  ~ShiftedCameras()
  {
    for (const Shifted& shifted : this->Cameras)
    {
      shifted.Camera->SetUserTransform(shifted.Given);
    }
  }
  ShiftedCameras(const ShiftedCameras&) = delete;
  void operator=(const ShiftedCameras&) = delete;

  // The picture moves the other way.
  void Shift(const double place_px[2])
  {
    for (const Shifted& shifted : this->Cameras)
    {
      const int* size = shifted.Renderer->GetSize();
      shifted.Shift->Identity();
      shifted.Shift->Translate(
        -2.0 * place_px[0] / std::max(size[0], 1), -2.0 * place_px[1] / std::max(size[1], 1), 0.0);
      if (shifted.Given)
      {
        shifted.Shift->Concatenate(shifted.Given->GetMatrix());
      }
      shifted.Camera->Modified();
    }
  }

private:
  struct Shifted
  {
    vtkSmartPointer<vtkCamera> Camera;
    vtkSmartPointer<vtkRenderer> Renderer;
    vtkSmartPointer<vtkHomogeneousTransform> Given;
    vtkSmartPointer<vtkTransform> Shift = vtkSmartPointer<vtkTransform>::New();
  };
  std::vector<Shifted> Cameras;
};
}

//------------------------------------------------------------------------------
vtkWaterFrameAverage::vtkWaterFrameAverage()
  : Output(vtkSmartPointer<vtkImageData>::New())
{
}

//------------------------------------------------------------------------------
vtkWaterFrameAverage::~vtkWaterFrameAverage() = default;

//------------------------------------------------------------------------------
void vtkWaterFrameAverage::SetRenderWindow(vtkRenderWindow* window)
{
  if (this->RenderWindow != window)
  {
    this->RenderWindow = window;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderWindow* vtkWaterFrameAverage::GetRenderWindow() const
{
  return this->RenderWindow;
}

//------------------------------------------------------------------------------
void vtkWaterFrameAverage::SetNumberOfFrames(int frames)
{
  vtkWaterSetInRange(NumberOfFrames, frames, 1, 65536);
}

//------------------------------------------------------------------------------
vtkImageData* vtkWaterFrameAverage::GetOutput() const
{
  return this->Output;
}

//------------------------------------------------------------------------------
bool vtkWaterFrameAverage::Update()
{
  const vtkSmartPointer<vtkRenderWindow> window = this->RenderWindow;
  if (!window)
  {
    vtkErrorMacro("RenderWindow is not set: there is nothing to render.");
    return false;
  }
  const auto frames = static_cast<unsigned>(this->NumberOfFrames); // an observer may set another
  std::vector<unsigned> sum; // 65,536 frames at the most fit in
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  capture->ReadFrontBufferOff();
  ShiftedCameras cameras(window);
  for (unsigned frame = 0; frame < frames; ++frame)
  {
    double place_px[2];
    water_quality_jitter(frame, place_px);
    cameras.Shift(place_px);
    capture->Modified();
    capture->Update();
    vtkDataArray* colors = capture->GetOutput()->GetPointData()->GetScalars();
    const size_t count = colors ? static_cast<size_t>(colors->GetNumberOfValues()) : 0;
    if (count == 0 || (frame > 0 && count != sum.size()) || window->GetAbortRender())
    {
      return false; // no picture, or none that can be added
    }
    sum.resize(count, 0u);
    const auto* seen = static_cast<const unsigned char*>(colors->GetVoidPointer(0));
    std::transform(sum.begin(), sum.end(), seen, sum.begin(),
      [](unsigned soFar, unsigned char color) { return soFar + color; });
  }
  this->Output->DeepCopy(capture->GetOutput());
  auto* mean =
    static_cast<unsigned char*>(this->Output->GetPointData()->GetScalars()->GetVoidPointer(0));
  std::transform(sum.begin(), sum.end(), mean,
    [frames](unsigned all) { return static_cast<unsigned char>((all + frames / 2u) / frames); });
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterFrameAverage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RenderWindow: " << this->RenderWindow << "\n";
  os << indent << "NumberOfFrames: " << this->NumberOfFrames << "\n";
}

VTK_ABI_NAMESPACE_END

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterFrameAverage.h"

#include "vtkCamera.h"
#include "vtkHomogeneousTransform.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWaterCompat.h"
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
      const int* size = renderer->GetSize();
      const auto isIt = [camera](const Shifted& shifted) { return shifted.Camera == camera; };
      const auto found = std::find_if(this->Cameras.begin(), this->Cameras.end(), isIt);
      if (found != this->Cameras.end())
      {
        // of the largest renderer, whose pixels are the smallest
        found->Size[0] = std::max(found->Size[0], size[0]);
        found->Size[1] = std::max(found->Size[1], size[1]);
      }
      else
      {
        this->Cameras.emplace_back();
        this->Cameras.back().Camera = camera;
        std::copy_n(size, 2, this->Cameras.back().Size);
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
      shifted.Shift->Identity();
      shifted.Shift->Translate(-2.0 * place_px[0] / std::max(shifted.Size[0], 1),
        -2.0 * place_px[1] / std::max(shifted.Size[1], 1), 0.0);
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
    int Size[2] = { 0, 0 }; // pixels
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
  if (window->CheckInRenderStatus())
  {
    vtkErrorMacro("Update is called while the window renders: it cannot be rendered once more.");
    return false;
  }
  const auto frames = static_cast<unsigned>(this->NumberOfFrames); // an observer may set another
  int size[2];
  std::copy_n(window->GetSize(), 2, size);
  // 65,536 frames at the most fit in
  std::vector<unsigned> sum(3 * static_cast<size_t>(std::max(size[0], 0)) * std::max(size[1], 0));
  vtkNew<vtkUnsignedCharArray> colors;
  ShiftedCameras cameras(window);
  for (unsigned frame = 0; frame < frames; ++frame)
  {
    double place_px[2];
    water_quality_jitter(frame, place_px);
    cameras.Shift(place_px);
    window->Render(); // runs the user's observers
    const int* now = window->GetSize();
    if (frame == 0 && sum.empty()) // the first picture of a window whose size nobody has set
    {
      std::copy_n(now, 2, size);
      sum.resize(3 * static_cast<size_t>(std::max(size[0], 0)) * std::max(size[1], 0), 0u);
    }
    if (sum.empty() || !std::equal(size, size + 2, now) || window->GetAbortRender() ||
      window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, colors, 0) != VTK_OK ||
      static_cast<size_t>(colors->GetNumberOfValues()) != sum.size())
    {
      return false; // no picture, or none that can be added
    }
    std::transform(sum.begin(), sum.end(), colors->GetPointer(0), sum.begin(),
      [](unsigned soFar, unsigned char color) { return soFar + color; });
  }
  this->Output->SetDimensions(size[0], size[1], 1);
  this->Output->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* mean = static_cast<unsigned char*>(this->Output->GetScalarPointer());
  std::transform(sum.begin(), sum.end(), mean,
    [frames](unsigned all) { return static_cast<unsigned char>((all + frames / 2u) / frames); });
  this->Output->Modified();
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

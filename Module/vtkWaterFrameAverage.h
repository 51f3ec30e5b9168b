// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterFrameAverage
 * @brief   averages many frames of a window, each with the camera shifted by less than a pixel
 *
 * Use it for print, and as a reference for faster settings. Update renders the window
 * NumberOfFrames times. In each frame the cameras of all its renderers are shifted by less than a
 * pixel. The mean has smooth edges. If the water's quality is "reference", it also shows the
 * reflections of waves smaller than a pixel:
 *
 *     water.GetWaterProperty().SetRayTraceQualityToReference()
 *     average = vtkWaterFrameAverage()
 *     average.SetRenderWindow(window)
 *     average.Update()  # renders
 *     writer.SetInputData(average.GetOutput())
 *
 * The window may be on-screen or off-screen, with or without multisampling. Update restores the
 * cameras. Overlays such as 2D actors are not shifted.
 */
#ifndef vtkWaterFrameAverage_h
#define vtkWaterFrameAverage_h

#include "vtkObject.h"
#include "vtkRenderingWaterModule.h" // for the export macro
#include "vtkSmartPointer.h"

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class vtkImageData;
class vtkRenderWindow;

class VTKRENDERINGWATER_EXPORT vtkWaterFrameAverage : public vtkObject
{
public:
  static vtkWaterFrameAverage* New();
  vtkTypeMacro(vtkWaterFrameAverage, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The window to render, or nullptr for none. Default is nullptr.
   */
  void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow() const;
  ///@}

  ///@{
  /**
   * Number of frames, in [1, 65536]. Default is 64.
   */
  void SetNumberOfFrames(int frames);
  vtkGetMacro(NumberOfFrames, int);
  ///@}

  /**
   * Renders the frames and averages them. Returns false and leaves the output unchanged if there is
   * no window, if it is already rendering, if rendering was aborted, or if the window's size
   * changed meanwhile.
   */
  bool Update();

  /**
   * The mean: RGB, unsigned char, with the window's size. Empty before the first successful Update.
   */
  vtkImageData* GetOutput() const;

protected:
  vtkWaterFrameAverage();
  ~vtkWaterFrameAverage() override;

private:
  vtkWaterFrameAverage(const vtkWaterFrameAverage&) = delete;
  void operator=(const vtkWaterFrameAverage&) = delete;

  vtkSmartPointer<vtkRenderWindow> RenderWindow;
  vtkSmartPointer<vtkImageData> Output;
  int NumberOfFrames = 64;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif

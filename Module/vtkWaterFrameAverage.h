// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterFrameAverage
 * @brief   the mean of many frames of a window, each seen through other places of its pixels
 *
 * For print, and as a reference that faster settings are compared with. Update renders the window
 * so many times; in each frame the cameras of all its renderers are shifted by less than a pixel.
 * The mean has smooth edges, and shows what waves reflect that are smaller than a pixel, if the
 * water's quality is "reference":
 *
 *     water.GetWaterProperty().SetRayTraceQualityToReference()
 *     average = vtkWaterFrameAverage()
 *     average.SetRenderWindow(window)
 *     average.Update()  # renders
 *     writer.SetInputData(average.GetOutput())
 *
 * The window may be on the screen or off it, with multisampling or without. Afterwards the cameras
 * are as they were. What is drawn over the scene, as 2D actors are, is not
 * shifted.
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
   * The window that is rendered; nullptr: none. Default is none.
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
   * Renders them. Returns false, and leaves the output as it was, when there is no window, or it is
   * rendering, and when rendering was aborted or the window's size changed meanwhile.
   */
  bool Update();

  /**
   * The mean: RGB, unsigned char, of the window's size; empty before the first Update that
   * succeeds.
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

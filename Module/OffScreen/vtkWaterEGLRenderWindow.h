// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterEGLRenderWindow
 * @brief   off-screen window for a VTK that itself has only X windows
 *
 * Renders through EGL into VTK's own framebuffers; no display server is needed and nothing is ever
 * shown. vtkWaterOffScreen puts it in the place of vtkRenderWindow.
 *
 * A thread cannot have a GLX and an EGL context at once: call ReleaseCurrent of one window before
 * the other renders. A process forked after the first render cannot render in the child.
 *
 * Private: not wrapped, header not installed. Empty from VTK 9.4 on.
 */
#ifndef vtkWaterEGLRenderWindow_h
#define vtkWaterEGLRenderWindow_h

#include "vtkWaterEGLContext.h"

#if VTK_WATER_GLX_ONLY

#include "vtkOpenGLRenderWindow.h"
#include "vtkWaterCompat.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkWaterEGLRenderWindow : public vtkOpenGLRenderWindow
{
public:
  static vtkWaterEGLRenderWindow* New();
  vtkTypeMacro(vtkWaterEGLRenderWindow, vtkOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Create the context, or say why there is none (an error, once) and leave the window without:
   * Render and the reading of pixels then do nothing.
   */
  void Initialize() override;
  void Finalize() override;
  void WindowRemap() override;
  void Render() override;
  void Frame() override;

  ///@{
  /**
   * The thread's current context. MakeCurrent costs little where it is already.
   */
  void MakeCurrent() override;
  void ReleaseCurrent() override;
  bool IsCurrent() override;
  void PushContext() override;
  void PopContext() override;
  ///@}

  void OpenGLInitContext() override;
  int SupportsOpenGL() override;

  /**
   * 0 for Mesa's software renderers, else 1.
   */
  vtkTypeBool IsDirect() override;

  ///@{
  /**
   * VTK's framebuffers follow at the next Render; the context stays.
   */
  void SetSize(int width, int height) override;
  void SetSize(int size[2]) override { this->SetSize(size[0], size[1]); }
  ///@}

  /**
   * There is no screen; 1920 x 1080 is what programs are told.
   */
  int* GetScreenSize() VTK_SIZEHINT(2) override { return this->ScreenSize; }

  ///@{
  /**
   * The window is never shown and always off-screen: requests for another state are ignored.
   */
  void SetShowWindow(bool) override {}
  void SetUseOffScreenBuffers(bool) override {}
  ///@}

  vtkTypeBool GetEventPending() override { return 0; }

  ///@{
  /**
   * Handles of the windowing system; only EGL's display and context exist.
   */
  void* GetGenericDisplayId() override { return vtkWaterEGLContext::GetDisplay(); }
  void* GetGenericContext() override { return this->Context.GetHandle(); }
  void* GetGenericWindowId() override { return nullptr; }
  void* GetGenericParentId() override { return nullptr; }
  void* GetGenericDrawable() override { return nullptr; }
  void SetDisplayId(void*) override {}
  void SetWindowId(void*) override {}
  void SetNextWindowId(void*) override {}
  void SetParentId(void*) override {}
  void SetWindowInfo(const char*) override {}
  void SetNextWindowInfo(const char*) override {}
  void SetParentInfo(const char*) override {}
  ///@}

protected:
  vtkWaterEGLRenderWindow();
  ~vtkWaterEGLRenderWindow() override;

  void CreateAWindow() override;
  void DestroyWindow() override;
  int ReadPixels(
    const vtkRecti& rect, int front, int glFormat, int glType, void* data, int right) override;

private:
  vtkWaterEGLRenderWindow(const vtkWaterEGLRenderWindow&) = delete;
  void operator=(const vtkWaterEGLRenderWindow&) = delete;

  void ReportFailure(const std::string& why);

  vtkWaterEGLContext Context;
  bool FailureReported = false;
};
VTK_ABI_NAMESPACE_END

#endif
#endif

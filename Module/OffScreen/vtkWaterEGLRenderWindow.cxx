// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterEGLRenderWindow.h"

#if VTK_WATER_GLX_ONLY

#include "vtkObjectFactory.h"
#include "vtkOpenGLState.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkWaterGL.h"

#include <cstdlib>
#include <mutex>
#include <set>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// The windows that have a context. At exit they are finalized while the driver is still whole:
// the libraries of Mesa end before the last static objects, which may hold a window.
struct LiveWindows
{
  std::mutex Mutex;
  std::set<vtkWaterEGLRenderWindow*> Windows;
  bool Registered = false;
  bool Exiting = false;

  static LiveWindows& Get()
  {
    static auto* instance = new LiveWindows; // never destroyed: used at exit
    return *instance;
  }

  void Add(vtkWaterEGLRenderWindow* window)
  {
    std::lock_guard<std::mutex> lock(this->Mutex);
    if (!this->Registered)
    {
      // Now and not earlier: what was registered last runs first, and the driver, loaded with
      // the first context, has registered its own end.
      this->Registered = true;
      std::atexit(LiveWindows::FinalizeAll);
    }
    this->Windows.insert(window);
  }

  void Remove(vtkWaterEGLRenderWindow* window)
  {
    std::lock_guard<std::mutex> lock(this->Mutex);
    this->Windows.erase(window);
  }

  static void FinalizeAll()
  {
    LiveWindows& self = LiveWindows::Get();
    std::set<vtkWaterEGLRenderWindow*> windows;
    {
      std::lock_guard<std::mutex> lock(self.Mutex);
      self.Exiting = true;
      windows.swap(self.Windows);
    }
    for (vtkWaterEGLRenderWindow* window : windows)
    {
      window->Finalize();
    }
  }
};
}

vtkStandardNewMacro(vtkWaterEGLRenderWindow);

//------------------------------------------------------------------------------
vtkWaterEGLRenderWindow::vtkWaterEGLRenderWindow()
{
  this->ShowWindow = false;
  this->UseOffScreenBuffers = true;
  this->ScreenSize[0] = 1920;
  this->ScreenSize[1] = 1080;
}

//------------------------------------------------------------------------------
vtkWaterEGLRenderWindow::~vtkWaterEGLRenderWindow()
{
  this->Finalize();
  // The renderers may outlive the window and must not call it.
  vtkCollectionSimpleIterator iterator;
  this->Renderers->InitTraversal(iterator);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(iterator))
  {
    renderer->SetRenderWindow(nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkWaterEGLRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "EGL display: " << vtkWaterEGLContext::GetDisplayName() << "\n";
  os << indent << "Context: " << this->Context.GetHandle() << "\n";
}

//------------------------------------------------------------------------------
void vtkWaterEGLRenderWindow::ReportFailure(const std::string& why)
{
  if (!this->FailureReported)
  {
    this->FailureReported = true;
    vtkErrorMacro("Cannot render off-screen: " << why << ".");
  }
}

//------------------------------------------------------------------------------
void vtkWaterEGLRenderWindow::Initialize()
{
  if (!this->Context.IsCreated() && !LiveWindows::Get().Exiting)
  {
    this->CreateAWindow();
  }
}

//------------------------------------------------------------------------------
void vtkWaterEGLRenderWindow::Finalize()
{
  this->DestroyWindow();
}

//------------------------------------------------------------------------------
void vtkWaterEGLRenderWindow::WindowRemap()
{
  this->Finalize();
  this->Initialize();
}

//------------------------------------------------------------------------------
void vtkWaterEGLRenderWindow::CreateAWindow()
{
  std::string why;
  if (!this->Context.Create(why))
  {
    this->ReportFailure(why);
    return;
  }
  if (!this->Context.MakeCurrent())
  {
    this->Context.Destroy();
    this->ReportFailure("EGL cannot make the context current; if an X window rendered in this "
                        "thread, call its ReleaseCurrent first");
    return;
  }
  this->OpenGLInit();
  if (!this->Initialized) // GLEW failed and said so
  {
    this->Context.Destroy();
    return;
  }
  LiveWindows::Get().Add(this);
  this->FailureReported = false;
  this->Mapped = 0;
  this->OwnContext = 1;
}

//------------------------------------------------------------------------------
void vtkWaterEGLRenderWindow::DestroyWindow()
{
  if (this->Context.IsCreated())
  {
    LiveWindows::Get().Remove(this);
    if (!vtkWaterEGLContext::IsForked())
    {
      this->ReleaseGraphicsResources(this);
    }
    this->Context.Destroy();
  }
}

//------------------------------------------------------------------------------
void vtkWaterEGLRenderWindow::OpenGLInitContext()
{
  if (this->Initialized)
  {
    return;
  }
  this->ContextCreationTime.Modified();
  // GLEW loads OpenGL first and then looks for GLX, which is missing (codes 3 and 4). VTK's own
  // version treats that as a failure.
  const GLenum result = glewInit();
  this->GlewInitValid =
    result != GLEW_ERROR_NO_GL_VERSION && result != GLEW_ERROR_GL_VERSION_10_ONLY;
  if (!this->GlewInitValid || !GLEW_VERSION_3_2)
  {
    this->GlewInitValid = false;
    this->ReportFailure("GLEW finds no OpenGL 3.2 in the EGL context");
    return;
  }
  this->Initialized = true;

  float range[2] = { 1.0f, 1.0f };
  this->GetState()->vtkglGetFloatv(
    this->LineSmoothing ? GL_SMOOTH_LINE_WIDTH_RANGE : GL_ALIASED_LINE_WIDTH_RANGE, range);
  this->MaximumHardwareLineWidth = range[1];
}

//------------------------------------------------------------------------------
int vtkWaterEGLRenderWindow::SupportsOpenGL()
{
  // VTK's test uses a window of its own, which becomes the thread's current one.
  this->PushContext();
  const int supported = this->Superclass::SupportsOpenGL();
  this->PopContext();
  return supported;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkWaterEGLRenderWindow::IsDirect()
{
  this->Initialize();
  const std::string& renderer = this->GetState()->GetRenderer();
  return this->Context.IsCreated() && renderer.find("llvmpipe") == std::string::npos &&
    renderer.find("softpipe") == std::string::npos;
}

//------------------------------------------------------------------------------
void vtkWaterEGLRenderWindow::Render()
{
  // Without a context VTK would call functions that GLEW has not loaded.
  this->Initialize();
  if (this->Context.IsCreated())
  {
    this->Superclass::Render();
  }
}

//------------------------------------------------------------------------------
void vtkWaterEGLRenderWindow::Frame()
{
  this->MakeCurrent();
  this->Superclass::Frame();
}

//------------------------------------------------------------------------------
int vtkWaterEGLRenderWindow::ReadPixels(
  const vtkRecti& rect, int front, int glFormat, int glType, void* data, int right)
{
  return this->Context.IsCreated()
    ? this->Superclass::ReadPixels(rect, front, glFormat, glType, data, right)
    : VTK_ERROR;
}

//------------------------------------------------------------------------------
void vtkWaterEGLRenderWindow::SetSize(int width, int height)
{
  if (this->Size[0] != width || this->Size[1] != height)
  {
    this->Superclass::SetSize(width, height);
    if (this->Interactor)
    {
      this->Interactor->SetSize(width, height);
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterEGLRenderWindow::MakeCurrent()
{
  if (this->Context.IsCreated() && !this->Context.MakeCurrent())
  {
    this->ReportFailure("EGL cannot make the context current; is it current in another thread, or "
                        "is the context of an X window current in this thread? Call "
                        "ReleaseCurrent there first");
  }
}

//------------------------------------------------------------------------------
void vtkWaterEGLRenderWindow::ReleaseCurrent()
{
  this->Context.ReleaseCurrent();
}

//------------------------------------------------------------------------------
bool vtkWaterEGLRenderWindow::IsCurrent()
{
  return this->Context.IsCurrent();
}

//------------------------------------------------------------------------------
void vtkWaterEGLRenderWindow::PushContext()
{
  this->Context.Push();
}

//------------------------------------------------------------------------------
void vtkWaterEGLRenderWindow::PopContext()
{
  this->Context.Pop();
}
VTK_ABI_NAMESPACE_END

#endif

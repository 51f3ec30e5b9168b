// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterEGLContext.h"

#if VTK_WATER_GLX_ONLY

#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <sstream>
#include <type_traits>

#include <dlfcn.h>
#include <unistd.h>

namespace
{
// The part of EGL/egl.h and EGL/eglext.h in use; no package with these headers is needed.
using EGLBoolean = unsigned int;
using EGLEnum = unsigned int;
using EGLInt = std::int32_t;
using EGLHandle = void*; // EGLDisplay, EGLSurface, EGLContext, EGLConfig, EGLDeviceEXT

constexpr EGLInt EGL_NONE = 0x3038;
constexpr EGLInt EGL_ALPHA_SIZE = 0x3021;
constexpr EGLInt EGL_BLUE_SIZE = 0x3022;
constexpr EGLInt EGL_GREEN_SIZE = 0x3023;
constexpr EGLInt EGL_RED_SIZE = 0x3024;
constexpr EGLInt EGL_DEPTH_SIZE = 0x3025;
constexpr EGLInt EGL_SURFACE_TYPE = 0x3033;
constexpr EGLInt EGL_PBUFFER_BIT = 0x0001;
constexpr EGLInt EGL_RENDERABLE_TYPE = 0x3040;
constexpr EGLInt EGL_OPENGL_BIT = 0x0008;
constexpr EGLInt EGL_EXTENSIONS = 0x3055;
constexpr EGLInt EGL_HEIGHT = 0x3056;
constexpr EGLInt EGL_WIDTH = 0x3057;
constexpr EGLInt EGL_DRAW = 0x3059;
constexpr EGLInt EGL_READ = 0x305A;
constexpr EGLInt EGL_CONTEXT_MAJOR_VERSION = 0x3098;
constexpr EGLInt EGL_CONTEXT_MINOR_VERSION = 0x30FB;
constexpr EGLInt EGL_CONTEXT_OPENGL_PROFILE_MASK = 0x30FD;
constexpr EGLInt EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT = 0x0001;
constexpr EGLEnum EGL_OPENGL_API = 0x30A2;
constexpr EGLEnum EGL_PLATFORM_SURFACELESS_MESA = 0x31DD;
constexpr EGLEnum EGL_PLATFORM_DEVICE_EXT = 0x313F;

constexpr const char* PackageHint = "; the Debian packages libegl1 and libegl-mesa0 provide it";

// libEGL, its functions and the process' display. Lives to the end of the process.
//
// The display is tried out first and opened again by the first window: a process may look for
// EGL, fork its workers and render in these, but not fork once the driver's threads run.
struct Library
{
  EGLBoolean (*BindAPI)(EGLEnum) = nullptr;
  EGLBoolean (*ChooseConfig)(EGLHandle, const EGLInt*, EGLHandle*, EGLInt, EGLInt*) = nullptr;
  EGLHandle (*CreateContext)(EGLHandle, EGLHandle, EGLHandle, const EGLInt*) = nullptr;
  EGLHandle (*CreatePbufferSurface)(EGLHandle, EGLHandle, const EGLInt*) = nullptr;
  EGLBoolean (*DestroyContext)(EGLHandle, EGLHandle) = nullptr;
  EGLBoolean (*DestroySurface)(EGLHandle, EGLHandle) = nullptr;
  EGLHandle (*GetCurrentContext)() = nullptr;
  EGLHandle (*GetCurrentDisplay)() = nullptr;
  EGLHandle (*GetCurrentSurface)(EGLInt) = nullptr;
  EGLInt (*GetError)() = nullptr;
  void (*(*GetProcAddress)(const char*))() = nullptr;
  EGLBoolean (*Initialize)(EGLHandle, EGLInt*, EGLInt*) = nullptr;
  EGLBoolean (*MakeCurrent)(EGLHandle, EGLHandle, EGLHandle, EGLHandle) = nullptr;
  const char* (*QueryString)(EGLHandle, EGLInt) = nullptr;
  EGLBoolean (*Terminate)(EGLHandle) = nullptr;

  EGLHandle Display = nullptr; // nullptr: EGL cannot be used, Error says why
  std::string DisplayName;
  std::string Error;
  pid_t Process = 0; // that opened the display; 0 until then

  static Library& Get();
  bool CreateContextAndSurface(EGLHandle& context, EGLHandle& surface);

private:
  bool Load();
  void FindDisplay();
  bool TryDisplay(EGLHandle display, const std::string& name);
  bool Open(EGLHandle display);
  bool CreateOn(EGLHandle display, EGLHandle& context, EGLHandle& surface);

  std::mutex Mutex;
  EGLHandle Config = nullptr;
};

//------------------------------------------------------------------------------
Library& Library::Get()
{
  // Never destroyed: windows may be, after all static objects.
  static Library* library = [] {
    auto* created = new Library;
    if (created->Load())
    {
      created->FindDisplay();
    }
    return created;
  }();
  return *library;
}

//------------------------------------------------------------------------------
bool Library::Load()
{
  const char* name = std::getenv("VTK_WATER_EGL_LIBRARY");
  name = name && *name ? name : "libEGL.so.1";
  void* library = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
  if (!library)
  {
    const char* reason = dlerror();
    this->Error =
      std::string("EGL cannot be loaded (") + (reason ? reason : name) + ")" + PackageHint;
    return false;
  }
  auto find = [this, library, name](const char* symbol, auto& function) {
    using Pointer = std::remove_reference_t<decltype(function)>;
    function = reinterpret_cast<Pointer>(dlsym(library, symbol));
    if (!function && this->Error.empty())
    {
      this->Error = std::string(name) + " lacks the function " + symbol + PackageHint;
    }
  };
  find("eglBindAPI", this->BindAPI);
  find("eglChooseConfig", this->ChooseConfig);
  find("eglCreateContext", this->CreateContext);
  find("eglCreatePbufferSurface", this->CreatePbufferSurface);
  find("eglDestroyContext", this->DestroyContext);
  find("eglDestroySurface", this->DestroySurface);
  find("eglGetCurrentContext", this->GetCurrentContext);
  find("eglGetCurrentDisplay", this->GetCurrentDisplay);
  find("eglGetCurrentSurface", this->GetCurrentSurface);
  find("eglGetError", this->GetError);
  find("eglGetProcAddress", this->GetProcAddress);
  find("eglInitialize", this->Initialize);
  find("eglMakeCurrent", this->MakeCurrent);
  find("eglQueryString", this->QueryString);
  find("eglTerminate", this->Terminate);
  return this->Error.empty();
}

//------------------------------------------------------------------------------
void Library::FindDisplay()
{
  // No display yet (nullptr): the extensions of EGL itself.
  const char* text = this->QueryString(nullptr, EGL_EXTENSIONS);
  const std::string extensions = text ? text : "";
  auto has = [&extensions](const char* name) { return extensions.find(name) != std::string::npos; };

  auto getDisplay = reinterpret_cast<EGLHandle (*)(EGLEnum, void*, const EGLInt*)>(
    this->GetProcAddress("eglGetPlatformDisplayEXT"));
  if (getDisplay && has("EGL_MESA_platform_surfaceless") &&
    this->TryDisplay(
      getDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr), "surfaceless (Mesa)"))
  {
    return;
  }
  if (getDisplay && has("EGL_EXT_platform_device"))
  {
    auto queryDevices = reinterpret_cast<EGLBoolean (*)(EGLInt, EGLHandle*, EGLInt*)>(
      this->GetProcAddress("eglQueryDevicesEXT"));
    EGLHandle devices[16] = {};
    EGLInt count = 0;
    if (queryDevices && queryDevices(16, devices, &count))
    {
      for (EGLInt i = 0; i < count; ++i)
      {
        if (this->TryDisplay(getDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr),
              "device " + std::to_string(i)))
        {
          return;
        }
      }
    }
  }
  this->Error = "EGL has no driver for off-screen OpenGL 3.2 (tried Mesa's surfaceless display and "
                "all devices); the Debian packages libegl-mesa0 and libgl1-mesa-dri provide one";
}

//------------------------------------------------------------------------------
bool Library::TryDisplay(EGLHandle display, const std::string& name)
{
  EGLHandle context = nullptr;
  EGLHandle surface = nullptr;
  if (!display || !this->Open(display))
  {
    return false;
  }
  if (this->CreateOn(display, context, surface))
  {
    this->DestroySurface(display, surface);
    this->DestroyContext(display, context);
    this->Display = display;
    this->DisplayName = name;
  }
  this->Terminate(display); // ends the driver's threads
  return this->Display != nullptr;
}

//------------------------------------------------------------------------------
bool Library::Open(EGLHandle display)
{
  EGLInt major = 0;
  EGLInt minor = 0;
  // EGL 1.4 is the first with OpenGL (not ES).
  if (!this->Initialize(display, &major, &minor) || (major == 1 && minor < 4))
  {
    return false;
  }
  // VTK renders into its own framebuffers; the surface's 8 bit colours only tell it that the
  // window has alpha, its depth that the window is an ordinary one.
  const EGLInt wanted[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
    EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_ALPHA_SIZE, 8, EGL_DEPTH_SIZE, 24,
    EGL_NONE };
  EGLInt count = 0;
  return this->ChooseConfig(display, wanted, &this->Config, 1, &count) && count > 0;
}

//------------------------------------------------------------------------------
bool Library::CreateOn(EGLHandle display, EGLHandle& context, EGLHandle& surface)
{
  const EGLInt version[] = { EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2,
    EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
  const EGLInt size[] = { EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE }; // never drawn to
  this->BindAPI(EGL_OPENGL_API); // a thread starts with OpenGL ES
  context = this->CreateContext(display, this->Config, nullptr, version);
  surface = context ? this->CreatePbufferSurface(display, this->Config, size) : nullptr;
  if (context && !surface)
  {
    this->DestroyContext(display, context);
    context = nullptr;
  }
  return surface != nullptr;
}

//------------------------------------------------------------------------------
// VTK's GLEW asks GLX for OpenGL's functions. GLX's first call after a fork takes the current
// context away, an EGL one too (libglvnd resets its dispatch), so that call is made here.
void EnterGLX()
{
  if (void* gl = dlopen("libGL.so.1", RTLD_LAZY | RTLD_LOCAL)) // VTK has loaded it already
  {
    using GetFunction = void (*(*)(const unsigned char*))();
    if (auto getFunction = reinterpret_cast<GetFunction>(dlsym(gl, "glXGetProcAddressARB")))
    {
      getFunction(reinterpret_cast<const unsigned char*>("glGetString"));
    }
    dlclose(gl);
  }
}

//------------------------------------------------------------------------------
bool Library::CreateContextAndSurface(EGLHandle& context, EGLHandle& surface)
{
  std::lock_guard<std::mutex> lock(this->Mutex);
  if (!this->Process)
  {
    if (!this->Open(this->Display))
    {
      return false;
    }
    this->Process = getpid();
    EnterGLX();
  }
  return this->CreateOn(this->Display, context, surface);
}
}

//------------------------------------------------------------------------------
bool vtkWaterEGLContext::Probe(std::string& why)
{
  why = Library::Get().Error;
  return why.empty();
}

//------------------------------------------------------------------------------
bool vtkWaterEGLContext::Create(std::string& why)
{
  if (!vtkWaterEGLContext::Probe(why))
  {
    return false;
  }
  Library& egl = Library::Get();
  if (vtkWaterEGLContext::IsForked())
  {
    why = "the process was forked after a first window had rendered; spawn it instead";
    return false;
  }
  if (!this->Context && !egl.CreateContextAndSurface(this->Context, this->Surface))
  {
    std::ostringstream text;
    text << "EGL made no OpenGL 3.2 core context (error 0x" << std::hex << egl.GetError() << ")";
    why = text.str();
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterEGLContext::Destroy()
{
  if (!this->Context)
  {
    return;
  }
  if (!vtkWaterEGLContext::IsForked())
  {
    this->ReleaseCurrent();
    Library& egl = Library::Get();
    egl.DestroySurface(egl.Display, this->Surface);
    egl.DestroyContext(egl.Display, this->Context);
  }
  this->Surface = nullptr;
  this->Context = nullptr;
}

//------------------------------------------------------------------------------
bool vtkWaterEGLContext::MakeCurrent()
{
  Library& egl = Library::Get();
  // To make a context current flushes it, so this is not done again for every GL call of VTK.
  return this->Context &&
    (this->IsCurrent() ||
      egl.MakeCurrent(egl.Display, this->Surface, this->Surface, this->Context));
}

//------------------------------------------------------------------------------
void vtkWaterEGLContext::ReleaseCurrent()
{
  if (this->IsCurrent())
  {
    Library& egl = Library::Get();
    egl.MakeCurrent(egl.Display, nullptr, nullptr, nullptr);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterEGLContext::IsCurrent() const
{
  if (!this->Context)
  {
    return false;
  }
  Library& egl = Library::Get();
  egl.BindAPI(EGL_OPENGL_API); // whose context is asked for, in this thread
  return egl.GetCurrentContext() == this->Context;
}

//------------------------------------------------------------------------------
bool vtkWaterEGLContext::Push()
{
  Library& egl = Library::Get();
  Binding before = {};
  if (egl.Display)
  {
    egl.BindAPI(EGL_OPENGL_API);
    before = { egl.GetCurrentDisplay(), egl.GetCurrentSurface(EGL_DRAW),
      egl.GetCurrentSurface(EGL_READ), egl.GetCurrentContext() };
  }
  this->Stack.push_back(before);
  return !this->Context || this->MakeCurrent();
}

//------------------------------------------------------------------------------
void vtkWaterEGLContext::Pop()
{
  if (this->Stack.empty())
  {
    return;
  }
  const Binding before = this->Stack.back();
  this->Stack.pop_back();
  Library& egl = Library::Get();
  if (before.Context && before.Context != egl.GetCurrentContext())
  {
    egl.MakeCurrent(before.Display, before.Draw, before.Read, before.Context);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterEGLContext::IsForked()
{
  const pid_t process = Library::Get().Process;
  return process && process != getpid();
}

//------------------------------------------------------------------------------
void* vtkWaterEGLContext::GetDisplay()
{
  return Library::Get().Display;
}

//------------------------------------------------------------------------------
std::string vtkWaterEGLContext::GetDisplayName()
{
  return Library::Get().DisplayName;
}

#endif

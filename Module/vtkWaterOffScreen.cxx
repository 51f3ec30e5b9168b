// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterOffScreen.h"

#include "vtkObjectFactory.h"
#include "vtkWaterCompat.h"
#include "vtkWaterEGLContext.h"

#if VTK_WATER_GLX_ONLY
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkNew.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkVersion.h"
#include "vtkWaterEGLRenderWindow.h"
#include "vtkWeakPointer.h"

#include <cstdlib>
#include <cstring>
#include <string>

#include <dlfcn.h>
#endif

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWaterOffScreen);

//------------------------------------------------------------------------------
void vtkWaterOffScreen::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Enabled: " << (vtkWaterOffScreen::IsEnabled() ? "yes" : "no") << "\n";
  os << indent << "Reason: " << vtkWaterOffScreen::GetReason() << "\n";
}

#if VTK_WATER_GLX_ONLY
namespace
{
VTK_CREATE_CREATE_FUNCTION(vtkWaterEGLRenderWindow);
VTK_CREATE_CREATE_FUNCTION(vtkGenericRenderWindowInteractor);

class WindowFactory : public vtkObjectFactory
{
public:
  static WindowFactory* New();
  vtkTypeMacro(WindowFactory, vtkObjectFactory);

  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "Off-screen windows of VTK::RenderingWater"; }

protected:
  WindowFactory()
  {
    this->RegisterOverride("vtkRenderWindow", "vtkWaterEGLRenderWindow", "EGL window", 1,
      vtkObjectFactoryCreatevtkWaterEGLRenderWindow);
    // The interactor that VTK would create opens the X display.
    this->RegisterOverride("vtkRenderWindowInteractor", "vtkGenericRenderWindowInteractor",
      "interactor without events", 1, vtkObjectFactoryCreatevtkGenericRenderWindowInteractor);
  }
};
vtkStandardNewMacro(WindowFactory);

// The registered factory; VTK owns it, and vtkObjectFactory::ReHash may delete it.
vtkWeakPointer<vtkObjectFactory> Registered;

std::string& Reason()
{
  static std::string reason = "off-screen rendering was not requested";
  return reason;
}

// An environment variable's value; empty if it is unset.
std::string Variable(const char* name)
{
  const char* value = std::getenv(name);
  return value ? value : "";
}

//------------------------------------------------------------------------------
// Whether an X server answers. A DISPLAY left over from another session is no display, and VTK
// would end the process there.
bool OpensDisplay(const std::string& name)
{
  if (name.empty())
  {
    return false;
  }
  void* library = dlopen("libX11.so.6", RTLD_LAZY | RTLD_LOCAL); // VTK has loaded it already
  if (!library)
  {
    return true; // no way to know
  }
  auto open = reinterpret_cast<void* (*)(const char*)>(dlsym(library, "XOpenDisplay"));
  auto close = reinterpret_cast<int (*)(void*)>(dlsym(library, "XCloseDisplay"));
  void* display = open && close ? open(name.c_str()) : nullptr;
  if (display)
  {
    close(display);
  }
  dlclose(library);
  return display || !open || !close;
}
}

//------------------------------------------------------------------------------
bool vtkWaterOffScreen::Enable()
{
  if (vtkWaterOffScreen::IsEnabled())
  {
    return true;
  }
  std::string why;
  if (!vtkWaterEGLContext::Probe(why))
  {
    Reason() = "off-screen rendering is not possible: " + why;
    return false;
  }
  vtkNew<WindowFactory> factory;
  vtkObjectFactory::RegisterFactory(factory);
  // VTK asks the factories in their order, and the one of its X windows may be there already, so
  // this one goes first. The others stay as they are, and Disable has nothing to restore.
  vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  factories->vtkCollection::RemoveItem(factory);
  if (factories->GetNumberOfItems() > 0)
  {
    factories->InsertItem(-1, factory);
  }
  else
  {
    factories->AddItem(factory);
  }
  Registered = factory;
  Reason() = "windows are off-screen by EGL, " + vtkWaterEGLContext::GetDisplayName();
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterOffScreen::EnableIfNeeded()
{
  const std::string wish = Variable("VTK_WATER_OFFSCREEN");
  if (wish == "1" || vtkWaterOffScreen::IsEnabled())
  {
    return vtkWaterOffScreen::Enable();
  }
  const std::string name = Variable("DISPLAY");
  const bool opens = OpensDisplay(name);
  if (opens)
  {
    Reason() = "windows are VTK's own: the display " + name + " can be opened";
    return true;
  }
  if (wish == "0")
  {
    Reason() = "no display can be opened, and VTK_WATER_OFFSCREEN=0 forbids off-screen windows";
    return false;
  }
  return vtkWaterOffScreen::Enable();
}

//------------------------------------------------------------------------------
void vtkWaterOffScreen::Disable()
{
  if (vtkWaterOffScreen::IsEnabled())
  {
    vtkObjectFactory::UnRegisterFactory(Registered);
    Registered = nullptr;
  }
  Reason() = "off-screen rendering was switched off";
}

//------------------------------------------------------------------------------
bool vtkWaterOffScreen::IsEnabled()
{
  return Registered != nullptr;
}

//------------------------------------------------------------------------------
const char* vtkWaterOffScreen::GetReason()
{
  return Reason().c_str();
}

#else

//------------------------------------------------------------------------------
bool vtkWaterOffScreen::Enable()
{
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterOffScreen::EnableIfNeeded()
{
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterOffScreen::Disable() {}

//------------------------------------------------------------------------------
bool vtkWaterOffScreen::IsEnabled()
{
  return false;
}

//------------------------------------------------------------------------------
const char* vtkWaterOffScreen::GetReason()
{
  return "nothing to do: this VTK selects its windows itself";
}

#endif
VTK_ABI_NAMESPACE_END

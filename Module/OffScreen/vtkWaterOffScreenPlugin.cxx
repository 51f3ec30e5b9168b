// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterOffScreenPlugin: off-screen windows for programs that do not know this module.
//
// VTK before 9.4 opens every shared library in the folders of VTK_AUTOLOAD_PATH when its first
// object is made, and registers the factory that vtkLoad returns. The real factory is the
// module's, so that vtkWaterOffScreen knows of it; the one returned here overrides nothing.
#include "vtkObjectFactory.h"
#include "vtkVersion.h"
#include "vtkWaterCompat.h"
#include "vtkWaterOffScreen.h"

namespace
{
class PluginFactory : public vtkObjectFactory
{
public:
  static PluginFactory* New();
  vtkTypeMacro(PluginFactory, vtkObjectFactory);

  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "Enables vtkWaterOffScreen if needed"; }

protected:
  PluginFactory()
  {
    if (!vtkWaterOffScreen::EnableIfNeeded())
    {
      // VTK is about to end the process because there is no display; this avoids it.
      vtkWarningMacro("No window can be made: " << vtkWaterOffScreen::GetReason() << ".");
    }
  }
};
vtkStandardNewMacro(PluginFactory);
}

VTK_FACTORY_INTERFACE_IMPLEMENT(PluginFactory)

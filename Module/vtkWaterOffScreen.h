// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterOffScreen
 * @brief   lets a VTK that has only X windows render without a display
 *
 * Before 9.4 a VTK built for X (as Debian 12's) cannot render without an X server. Enable makes
 * every vtkRenderWindow created from then on an off-screen window of EGL, and every
 * vtkRenderWindowInteractor one whose Start returns at once. Nothing else of the program changes.
 * Windows that exist already stay as they are.
 *
 * From 9.4 on VTK itself chooses between GLX, EGL and OSMesa; there, and on systems without X,
 * this class has nothing to do: its functions return true and IsEnabled is false.
 *
 * The plugin vtkWaterOffScreenPlugin does the same to programs that do not know this module: VTK
 * loads it from the folder that the environment variable VTK_AUTOLOAD_PATH names.
 *
 * Environment variables:
 * - VTK_WATER_OFFSCREEN: 1 makes EnableIfNeeded enable always, 0 never.
 * - VTK_WATER_EGL_LIBRARY: the EGL library to load, default libEGL.so.1.
 */
#ifndef vtkWaterOffScreen_h
#define vtkWaterOffScreen_h

#include "vtkObject.h"
#include "vtkRenderingWaterModule.h" // for the export macro

#ifdef VTK_ABI_NAMESPACE_BEGIN
VTK_ABI_NAMESPACE_BEGIN
#endif

class VTKRENDERINGWATER_EXPORT vtkWaterOffScreen : public vtkObject
{
public:
  static vtkWaterOffScreen* New();
  vtkTypeMacro(vtkWaterOffScreen, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Render off-screen from now on. Before anything is changed, an OpenGL context is tried; if that
   * fails, VTK stays as it is, false is returned and GetReason says why. A second call changes
   * nothing.
   */
  static bool Enable();

  /**
   * Enable, but only if no X display can be opened (DISPLAY is unset or empty, or nothing answers
   * there). Returns whether rendering can be expected to work: with the display or off-screen.
   */
  static bool EnableIfNeeded();

  /**
   * Windows created from now on are VTK's own again. Off-screen windows that exist stay usable.
   */
  static void Disable();

  /**
   * Whether the next vtkRenderWindow is off-screen because of this class.
   */
  static bool IsEnabled();

  /**
   * Why the last call had the result it had, in one sentence: the EGL display in use, what is
   * missing and the Debian packages that provide it, or that there is nothing to do. Never null.
   */
  static const char* GetReason();

protected:
  vtkWaterOffScreen() = default;
  ~vtkWaterOffScreen() override = default;

private:
  vtkWaterOffScreen(const vtkWaterOffScreen&) = delete;
  void operator=(const vtkWaterOffScreen&) = delete;
};

#ifdef VTK_ABI_NAMESPACE_END
VTK_ABI_NAMESPACE_END
#endif
#endif

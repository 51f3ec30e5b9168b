// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWaterOffScreen
 * @brief   off-screen rendering without a display, for VTK versions that only have X windows
 *
 * Before 9.4, a VTK built for X (such as Debian 12's) cannot render without an X server. After
 * Enable, every new vtkRenderWindow is an off-screen EGL window, and every new
 * vtkRenderWindowInteractor returns from Start at once. Nothing else in the program changes.
 * Existing windows stay as they are.
 *
 * From 9.4 on, VTK itself chooses between GLX, EGL and OSMesa. There, and on systems without X,
 * this class does nothing: Enable and EnableIfNeeded return true, IsEnabled returns false.
 *
 * The plugin vtkWaterOffScreenPlugin does the same for programs that do not use this module. VTK
 * loads it from the folder named by the environment variable VTK_AUTOLOAD_PATH.
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
   * Switches to off-screen rendering. This function first tries to create an OpenGL context. If
   * that fails, VTK stays as it is, the function returns false, and GetReason returns the cause. A
   * second call has no effect.
   */
  static bool Enable();

  /**
   * Enables off-screen rendering if no X display can be opened (DISPLAY is unset or empty, or no
   * server answers). Returns whether rendering is expected to work, with the display or off-screen.
   */
  static bool EnableIfNeeded();

  /**
   * Makes new windows VTK's own again. Existing off-screen windows remain usable.
   */
  static void Disable();

  /**
   * Whether the next vtkRenderWindow is off-screen because of this class.
   */
  static bool IsEnabled();

  /**
   * Reason for the result of the last call, in one sentence: the EGL display in use, what is
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

// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterEGLContext: one OpenGL 3.2 core context of EGL that needs no display server.
//
// libEGL is opened at run time, so the module links against none. The first context opens the
// process' display, which is never closed: all windows share the driver's threads behind it.
// The environment variable VTK_WATER_EGL_LIBRARY names another libEGL than libEGL.so.1.
#ifndef vtkWaterEGLContext_h
#define vtkWaterEGLContext_h

#include "vtkVersionMacros.h"

// True where VTK's only window is one of X (GLX). From 9.4 VTK chooses GLX, EGL or OSMesa itself.
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0)
#include "vtkRenderingOpenGLConfigure.h" // for VTK_USE_X
#endif
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 4, 0) && defined(VTK_USE_X)
#define VTK_WATER_GLX_ONLY 1
#else
#define VTK_WATER_GLX_ONLY 0
#endif

#include <string>
#include <vector>

class vtkWaterEGLContext
{
public:
  vtkWaterEGLContext() = default;
  ~vtkWaterEGLContext() { this->Destroy(); }
  vtkWaterEGLContext(const vtkWaterEGLContext&) = delete;
  void operator=(const vtkWaterEGLContext&) = delete;

  // Whether EGL can be used here. The first call tries a context, and leaves no threads behind.
  static bool Probe(std::string& why);

  // Creates the context and its surface; they are not made current.
  //
  // why  set on failure: one sentence, with the Debian packages that would help
  bool Create(std::string& why);
  void Destroy();
  bool IsCreated() const { return this->Context != nullptr; }

  // Makes the context the thread's. False if EGL refuses: it is current in another thread, or the
  // thread has a GLX context.
  bool MakeCurrent();
  void ReleaseCurrent();
  bool IsCurrent() const;

  // Remembers the thread's EGL context and makes this one current; Pop brings the other back.
  // Where there was none, this one stays, as VTK's X window does it.
  bool Push();
  void Pop();

  // Whether this process was forked from the one that opened the display. The driver's threads
  // stayed there and a call would wait for them for ever, so no context can be made here or drawn
  // to; Destroy just forgets it.
  static bool IsForked();

  void* GetHandle() const { return this->Context; }
  static void* GetDisplay();

  // Which EGL display is used, for messages; empty if none works.
  static std::string GetDisplayName();

private:
  struct Binding
  {
    void* Display;
    void* Draw;
    void* Read;
    void* Context;
  };

  void* Context = nullptr;
  void* Surface = nullptr;
  std::vector<Binding> Stack;
};

#endif

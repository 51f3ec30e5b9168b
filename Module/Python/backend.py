# SPDX-License-Identifier: BSD-3-Clause
"""Finds the off-screen window and the renderer that VTK uses on this machine, in a separate process.

VTK ends the process if it finds no OpenGL at all. `find()` therefore starts another one:

    backend = find()
    backend.window, backend.renderer, backend.version    # "vtkEGLRenderWindow", "llvmpipe ...", "4.5 ..."
    backend.error                                        # "" or what is missing and which packages provide it
"""
import json
import os
import subprocess
import sys
from dataclasses import dataclass

__all__ = ["Backend", "check_display", "find"]

TIMEOUT_S = 60.0
WINDOWS_ON_SCREENS = ("vtkXOpenGLRenderWindow", "vtkWin32OpenGLRenderWindow", "vtkCocoaRenderWindow")
PACKAGES = ("Rendering needs OpenGL 3.2: a GPU's driver, or Mesa "
            "(Debian and Ubuntu: apt-get install libegl1 libegl-mesa0 libgl1-mesa-dri, or libosmesa6)")
CODE = """
import json
import vtkwater
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetSize(16, 16)
window.AddRenderer(vtkRenderer())
window.Render()
report = dict(line.split(" string:  ", 1) for line in window.ReportCapabilities().splitlines() if " string:  " in line)
found = [window.GetClassName(), report.get("OpenGL renderer", ""), report.get("OpenGL version", "")]
print("FOUND" + json.dumps(found))
"""


@dataclass
class Backend:
    window: str = ""
    renderer: str = ""
    version: str = ""
    error: str = ""


def find():
    try:
        answer = subprocess.run([sys.executable, "-c", CODE], capture_output=True, text=True, timeout=TIMEOUT_S)
    except subprocess.TimeoutExpired:
        return Backend(error=f"No picture after {TIMEOUT_S:.0f} s. {PACKAGES}")
    found = [line[5:] for line in answer.stdout.splitlines() if line.startswith("FOUND")]
    if answer.returncode or not found:
        return Backend(error=f"VTK finds no OpenGL on this machine. {PACKAGES}")
    window, renderer, version = json.loads(found[0])
    if not version:
        return Backend(error=f"VTK's {window} has no OpenGL on this machine. {PACKAGES}")
    return Backend(window, renderer, version)


def check_display(window, instead):
    """Raise ValueError if there is no display to show a window on; the text says what to do instead.

    Without a display VTK silently creates an off-screen window, and an interactor then waits forever.
    """
    if not any(window.IsA(name) for name in WINDOWS_ON_SCREENS):
        display = os.environ.get("DISPLAY")
        why = f"DISPLAY is {display}" if display else "DISPLAY is not set"
        raise ValueError(f"there is no display to show a window on: {why}, and VTK only has a "
                         f"{window.GetClassName()}. Set DISPLAY to an X server, or {instead}")

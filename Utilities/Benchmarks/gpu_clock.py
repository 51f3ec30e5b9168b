# SPDX-License-Identifier: BSD-3-Clause
"""gpu_clock: how long a GPU is at a frame, by OpenGL's timer queries.

VTK's own (vtkRenderTimerLog) cannot be read from Python. The time is that between the first command and
the last, its waiting for the next command included.
"""

import ctypes

GL_TIMESTAMP, GL_QUERY_RESULT = 0x8E28, 0x8866  # OpenGL 3.3, ARB_timer_query
# of the windows' libraries, and what they find OpenGL's functions by
LIBRARIES = (
    ("vtkEGLRenderWindow", ("libEGL.so.1",), "eglGetProcAddress"),
    ("vtkOSOpenGLRenderWindow", ("libOSMesa.so.8", "libOSMesa.so.6"), "OSMesaGetProcAddress"),
)
FUNCTIONS = {
    "glGenQueries": (ctypes.c_int, ctypes.POINTER(ctypes.c_uint)),
    "glQueryCounter": (ctypes.c_uint, ctypes.c_uint),
    "glGetQueryObjectui64v": (ctypes.c_uint, ctypes.c_uint, ctypes.POINTER(ctypes.c_uint64)),
}


class Clock:
    """Of a window that has rendered before. is_there: false where nobody knows the functions."""

    def __init__(self, window):
        self._window = window
        self._functions = find(window.GetClassName(), FUNCTIONS)
        self.is_there = len(self._functions) == len(FUNCTIONS)
        if self.is_there:
            self._queries = (ctypes.c_uint * 2)()
            window.MakeCurrent()
            self._functions["glGenQueries"](2, self._queries)

    def time(self, draw):
        """ms; waits until the GPU is done."""
        stamps = (ctypes.c_uint64 * 2)()
        for i, query in enumerate(self._queries):
            self._window.MakeCurrent()
            self._functions["glQueryCounter"](query, GL_TIMESTAMP)
            if i == 0:
                draw()
        for i, query in enumerate(self._queries):
            place = ctypes.cast(ctypes.byref(stamps, 8 * i), ctypes.POINTER(ctypes.c_uint64))
            self._functions["glGetQueryObjectui64v"](query, GL_QUERY_RESULT, place)
        return 1e-6 * (stamps[1] - stamps[0])


def find(window, functions, result=None):
    """Functions of OpenGL by name, of those that a class of windows has; functions: their arguments."""
    for name, libraries, finder in LIBRARIES:
        for library in libraries if name == window else ():
            try:
                place_of = getattr(ctypes.CDLL(library), finder)
            except OSError:
                continue
            place_of.restype = ctypes.c_void_p
            places = {name: place_of(name.encode()) for name in functions}
            return {
                name: ctypes.CFUNCTYPE(result, *functions[name])(place)
                for name, place in places.items()
                if place
            }
    return {}

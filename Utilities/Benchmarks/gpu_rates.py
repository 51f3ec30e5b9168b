# SPDX-License-Identifier: BSD-3-Clause
"""gpu_rates: what the part of a GPU that draws can do, to compare a report's machine with one's own.

    script/gpu run python3 Utilities/Benchmarks/gpu_rates.py

Data centre cards draw with a small part of their processors: an H200 with 4 of 132. Prints reads of a
texture and multiply-adds a second, in full-screen draws, and the time of a draw that waits for the
draw before. gpu_frames prints the same with its frames.
"""

import ctypes
import time

import gpu_clock

GL_FLOAT, GL_RED, GL_R32F = 0x1406, 0x1903, 0x822E
GL_RGBA, GL_RGBA8, GL_UNSIGNED_BYTE = 0x1908, 0x8058, 0x1401
GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_NEAREST = 0x0DE1, 0x2801, 0x2800, 0x2600
GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 = 0x8D40, 0x8CE0
GL_FRAGMENT_SHADER, GL_VERTEX_SHADER, GL_LINK_STATUS = 0x8B30, 0x8B31, 0x8B82
GL_TRIANGLES = 4
GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST = 0x0BE2, 0x0B44, 0x0B71, 0x0C11
SIZE, SMALL = (1920, 1080), (256, 256)
READS, SUMS, PASSES = 64, 1024, 64
ROUNDS = 9

_INT, _UINT, _PLACE = ctypes.c_int, ctypes.c_uint, ctypes.c_void_p
_FUNCTIONS = {
    "glAttachShader": (_UINT, _UINT),
    "glBindFramebuffer": (_UINT, _UINT),
    "glBindTexture": (_UINT, _UINT),
    "glBindVertexArray": (_UINT,),
    "glCompileShader": (_UINT,),
    "glDeleteFramebuffers": (_INT, _PLACE),
    "glDeleteProgram": (_UINT,),
    "glDeleteTextures": (_INT, _PLACE),
    "glDeleteVertexArrays": (_INT, _PLACE),
    "glDisable": (_UINT,),
    "glDrawArrays": (_UINT, _INT, _INT),
    "glEnable": (_UINT,),
    "glFinish": (),
    "glFramebufferTexture2D": (_UINT, _UINT, _UINT, _UINT, _INT),
    "glGenFramebuffers": (_INT, _PLACE),
    "glGenTextures": (_INT, _PLACE),
    "glGenVertexArrays": (_INT, _PLACE),
    "glGetProgramiv": (_UINT, _UINT, _PLACE),
    "glLinkProgram": (_UINT,),
    "glShaderSource": (_UINT, _INT, _PLACE, _PLACE),
    "glTexImage2D": (_UINT, _INT, _INT, _INT, _INT, _INT, _UINT, _UINT, _PLACE),
    "glTexParameteri": (_UINT, _UINT, _INT),
    "glUseProgram": (_UINT,),
    "glViewport": (_INT, _INT, _INT, _INT),
}
_MAKERS = {"glIsEnabled": (_UINT,), "glCreateShader": (_UINT,), "glCreateProgram": ()}
_VERTICES = """#version 150
out vec2 at;
void main()
{
  at = vec2((gl_VertexID & 1) * 2, (gl_VertexID >> 1) * 2);
  gl_Position = vec4(2.0 * at - 1.0, 0.0, 1.0);
}
"""
_HEAD = """#version 150
in vec2 at;
out vec4 sum;
uniform sampler2D texels;
void main()
{
  sum = vec4(at, 0.0, 1.0);
"""
_READ = _HEAD + """
  for (int i = 0; i < %d; ++i)
    sum.xy += 1e-3 + 1e-3 * textureLod(texels, sum.xy, 0.0).rr;
}
""" % READS
_ADD = _HEAD + """
  for (int i = 0; i < %d; ++i)
    sum = sum * 1.0001 + at.xyxy;
}
""" % (SUMS // 4)
_ONE = _HEAD + "sum += textureLod(texels, at, 0.0); }"


def measure(window):
    """Of a window that has rendered before: reads and multiply-adds a second, seconds a draw; {} where OpenGL's
    functions are not found. What is bound afterwards VTK does not know: the window is of no use."""
    gl = gpu_clock.find(window.GetClassName(), _FUNCTIONS)
    make = gpu_clock.find(window.GetClassName(), _MAKERS, _UINT)
    if len(gl) < len(_FUNCTIONS) or len(make) < len(_MAKERS):
        return {}
    window.MakeCurrent()
    card = _Card(gl, make)
    pixels = SIZE[0] * SIZE[1]
    target = card.target(SIZE, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE)
    texels = card.texture(SIZE, GL_R32F, GL_RED, GL_FLOAT)
    empty = _least(card, lambda: card.draw(_ONE, target, texels, SIZE))
    read = _least(card, lambda: card.draw(_READ, target, texels, SIZE)) - empty
    add = _least(card, lambda: card.draw(_ADD, target, texels, SIZE)) - empty
    pair = [card.target(SMALL, GL_R32F, GL_RED, GL_FLOAT) for _ in range(2)]

    def chain():
        for i in range(PASSES):
            card.draw(_ONE, pair[i % 2], pair[1 - i % 2][1], SMALL)

    one = _least(card, chain) / PASSES
    card.close()
    return {
        "reads_per_s": READS * pixels / read,
        "multiply_adds_per_s": SUMS * pixels / add,
        "draw_s": one,
    }


def text_of(rates):
    if not rates:
        return "unknown"
    return (f"{1e-9 * rates['reads_per_s']:.1f} billion reads of a texture a second, "
            f"{1e-12 * rates['multiply_adds_per_s']:.2f} trillion multiply-adds, "
            f"{1e6 * rates['draw_s']:.1f} us for a small draw that waits for the previous one")


def _least(card, draw):
    """Seconds, to the end of what is drawn."""
    spans = []
    for _ in range(ROUNDS):
        begin = time.perf_counter()
        draw()
        card.gl["glFinish"]()
        spans.append(time.perf_counter() - begin)
    return min(spans)


class _Card:
    def __init__(self, gl, make):
        self.gl, self._make = gl, make
        self._programs, self._names = {}, {"Framebuffers": [], "Textures": [], "VertexArrays": []}
        self.gl["glBindVertexArray"](self._new("VertexArrays"))
        states = (GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST)
        self._enabled = [state for state in states if make["glIsEnabled"](state) & 255]
        for state in self._enabled:
            gl["glDisable"](state)

    def _new(self, kind):
        name = ctypes.c_uint()
        self.gl["glGen" + kind](1, ctypes.byref(name))
        self._names[kind].append(name)
        return name.value

    def texture(self, size, inner, outer, kind):
        name = self._new("Textures")
        self.gl["glBindTexture"](GL_TEXTURE_2D, name)
        self.gl["glTexImage2D"](GL_TEXTURE_2D, 0, inner, *size, 0, outer, kind, None)
        for of in (GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER):
            self.gl["glTexParameteri"](GL_TEXTURE_2D, of, GL_NEAREST)
        return name

    def target(self, *of):
        framebuffer, texture = self._new("Framebuffers"), self.texture(*of)
        self.gl["glBindFramebuffer"](GL_FRAMEBUFFER, framebuffer)
        self.gl["glFramebufferTexture2D"](GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0)
        return framebuffer, texture

    def _program(self, fragments):
        if fragments not in self._programs:
            program = self._make["glCreateProgram"]()
            for kind, source in ((GL_VERTEX_SHADER, _VERTICES), (GL_FRAGMENT_SHADER, fragments)):
                shader = self._make["glCreateShader"](kind)
                lines = (ctypes.c_char_p * 1)(source.encode())
                self.gl["glShaderSource"](shader, 1, ctypes.cast(lines, _PLACE), None)
                self.gl["glCompileShader"](shader)
                self.gl["glAttachShader"](program, shader)
            self.gl["glLinkProgram"](program)
            is_linked = ctypes.c_int()
            self.gl["glGetProgramiv"](program, GL_LINK_STATUS, ctypes.byref(is_linked))
            assert is_linked.value, fragments
            self._programs[fragments] = program
        return self._programs[fragments]

    def draw(self, fragments, target, texels, size):
        self.gl["glUseProgram"](self._program(fragments))
        self.gl["glBindFramebuffer"](GL_FRAMEBUFFER, target[0])
        self.gl["glBindTexture"](GL_TEXTURE_2D, texels)
        self.gl["glViewport"](0, 0, *size)
        self.gl["glDrawArrays"](GL_TRIANGLES, 0, 3)

    def close(self):
        for state in self._enabled:
            self.gl["glEnable"](state)
        self.gl["glUseProgram"](0)
        self.gl["glBindFramebuffer"](GL_FRAMEBUFFER, 0)
        self.gl["glBindVertexArray"](0)
        for program in self._programs.values():
            self.gl["glDeleteProgram"](program)
        for kind, names in self._names.items():
            for name in names:
                self.gl["glDelete" + kind](1, ctypes.byref(name))


if __name__ == "__main__":
    import water_test as wt

    own = wt.View(SMALL)
    own.window.Render()
    print(own.window.GetClassName() + ":", text_of(measure(own.window)))

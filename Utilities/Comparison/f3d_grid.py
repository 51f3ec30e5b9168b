# SPDX-License-Identifier: BSD-3-Clause
"""f3d_grid: F3D's reflecting grid, at its absolute origin, which is the water's level.

F3D has no clipping plane: seen from below, the bed of the lake would hide all. So it gets the
terrain cut at the water, for the frame without water as well. The grid cannot be made smaller.
"""

import ctypes
import ctypes.util
import sys

import f3d
from peer import read_scene, serve

REFLECTION = 0.6


class View:
    def __init__(self, scene, has_water):
        self.engine = f3d.Engine.create_osmesa()
        options = self.engine.options
        options["scene.up_direction"] = [0.0, 0.0, 1.0]
        options["render.background.color"] = list(scene["sky"])
        options["model.coloring"] = "direct"
        options["model.scivis.array_name"] = "RGB"
        options["model.scivis.field"] = "points"
        options["model.material.roughness"] = 1.0
        options["render.grid.enable"] = has_water
        options["render.grid.absolute"] = True
        options["render.grid.unit"] = 1e6  # metres: no lines
        options["render.grid.subdivisions"] = 1
        options["render.grid.reflection"] = REFLECTION if has_water else 0.0
        self.engine.window.size = scene["size"]
        self.engine.scene.add(scene["terrain_dry"])
        self.engine.scene.remove_all_lights()
        self.engine.scene.add_light(f3d.LightState(
            type=f3d.LightType.SCENE_LIGHT, positional_light=False,
            color=f3d.Color(*scene["sun_color"]),
            position=tuple(10000.0 * each for each in scene["to_sun"]),
            direction=tuple(-each for each in scene["to_sun"]), intensity=3.0))
        self.engine.window.camera.view_angle = scene["view_angle"]

    def render(self, eye, target):
        camera = self.engine.window.camera
        camera.position, camera.focal_point = eye, target
        camera.view_up = (0.0, 0.0, 1.0)  # again: F3D turns it with the eye
        self.engine.window.render()
        GL.glFinish()

    def save(self, file):
        self.engine.window.render_to_image().save(file)


def main():
    scene = read_scene(sys.argv[1])
    f3d.Engine.autoload_plugins()
    views = {"plain": View(scene, False), "grid": View(scene, True)}
    views["plain"].engine.window.render()
    GL.glGetString.restype = ctypes.c_char_p
    renderer = (GL.glGetString(0x1F01) or b"unnamed").decode()  # GL_RENDERER
    serve(views, f"F3D {f3d.__version__}", renderer)


# the library that F3D draws with: F3D itself has no call that waits for the drawing
GL = ctypes.CDLL(ctypes.util.find_library("OSMesa") or "libOSMesa.so.8")

if __name__ == "__main__":
    main()

# SPDX-License-Identifier: BSD-3-Clause
"""What users set on their actors' shaders and mappers goes together with being reflected."""

import numpy as np
import pytest
import water_test as wt
from water_scenes import SHEET, SIZE, add_thing, plain_picture, view

FAR = (1e7, 2e7, 1e3)
AUTO, NEAR_PLANE, FOCAL_POINT = 1, 5, 6  # of vtkOpenGLVertexBufferObject's ShiftScaleMethod


def test_a_users_shader_replacement_stays():
    """A user's own shader may take the place where water declares its functions."""
    scene = view()
    actor = add_thing(scene.renderer)
    for tag in ("//VTK::Clip::Dec", "//VTK::Clip::Impl"):
        actor.GetShaderProperty().AddFragmentShaderReplacement(tag, True, "// mine\n", True)
    wt.add_water(scene.renderer, None, SHEET)
    wt.check_equal("user's shader replacement: picture, error", wt.difference(scene.picture(), plain_picture()), 0)


def far_picture(method):
    scene = view(FAR)
    add_thing(scene.renderer, FAR).GetMapper().SetVBOShiftScaleMethod(method)
    wt.add_water(scene.renderer, wt.plane(FAR, (0, 0, 1)), SHEET)
    return scene.picture()


@pytest.mark.parametrize("name, method", (("near plane", NEAR_PLANE), ("focal point", FOCAL_POINT)),
                         ids=("near_plane", "focal_point"))
def test_mappers_may_shift_by_the_camera(name, method):
    """A mapper that shifts and scales coordinates by the camera is reflected as one that does so by its data."""
    far = far_picture(AUTO)
    wt.check_at_most("shift and scale by the data: pixels off by more than 1/255 of the picture at the origin",
                     int((np.abs(far - plain_picture()).max(axis=2) > 1).sum()), 0.0002 * SIZE[0] * SIZE[1])
    off = np.abs(far_picture(method) - far).max(axis=2) > 1
    wt.check_at_most(f"shift and scale by the {name}: pixels off by more than 1/255", int(off.sum()),
                     0.0002 * SIZE[0] * SIZE[1])

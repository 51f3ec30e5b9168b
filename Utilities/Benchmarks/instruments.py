# SPDX-License-Identifier: BSD-3-Clause
"""instruments: what the reflection pass says about its last frame; None: it does not say."""

SAYS = {
    "props": "GetNumberOfPropsReflected",
    "triangles": "GetNumberOfTrianglesReflected",
    "fragments": "GetNumberOfFragmentsReflected",
    "gather_ms": "GetLastGatherTime",
    "plan_ms": "GetLastPlanTime",
    "reflection_ms": "GetLastReflectionTime",
    "surface_ms": "GetLastSurfaceTime",
}


def turn_on(water, is_on=True):
    """Counting waits for the GPU: never while frames are timed."""
    reflection = water.GetReflectionPass()
    if hasattr(reflection, "SetInstrumentation"):
        reflection.SetInstrumentation(is_on)


def read(water):
    reflection = water.GetReflectionPass()
    return {
        name: getattr(reflection, getter)() if hasattr(reflection, getter) else None
        for name, getter in SAYS.items()
    }


def set_skips(water, is_on):
    """Leaves out what need not be rendered, or nothing. False: this module cannot tell."""
    reflection = water.GetReflectionPass()
    if not hasattr(reflection, "SetSkips"):
        return False
    reflection.SetSkips(reflection.SKIP_ALL if is_on else reflection.SKIP_NONE)
    return True


def text(value, form="{:,}"):
    """For a table; unknown things are n/a."""
    return "n/a" if value is None or value != value else form.format(value)

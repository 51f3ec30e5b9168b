# SPDX-License-Identifier: BSD-3-Clause
"""driver: what renders here."""

import water_test as wt


def driver():
    """The renderer's name."""
    view = wt.View((8, 8))
    view.picture()
    for line in view.window.ReportCapabilities().splitlines():
        if line.startswith("OpenGL renderer string:"):
            return line.split(":", 1)[1].strip()
    return "an unnamed OpenGL renderer"

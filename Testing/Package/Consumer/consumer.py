# SPDX-License-Identifier: BSD-3-Clause
"""Prints the installed package's version and a water actor's default level."""
import vtkwater

print("vtkwater", vtkwater.__version__, "level", vtkwater.vtkWaterActor().GetLevel())

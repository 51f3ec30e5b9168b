# SPDX-License-Identifier: BSD-3-Clause
"""python -m vtkwater: the command, if its script is not on the path."""
import sys

from .command import main

sys.exit(main())

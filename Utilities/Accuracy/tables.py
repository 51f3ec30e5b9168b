# SPDX-License-Identifier: BSD-3-Clause
"""tables: Markdown's. Needs nothing else, so that what was measured elsewhere can be shown anywhere."""


def table(header, rows):
    """A table in Markdown; numbers are to be formatted already."""
    lines = ["| " + " | ".join(cells) + " |" for cells in (header, *rows)]
    return "\n".join([lines[0], "|---" * len(header) + "|", *lines[1:]])

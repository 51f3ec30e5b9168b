# SPDX-License-Identifier: BSD-3-Clause
"""tables: Markdown's. Needs nothing else, so that what was measured elsewhere can be shown anywhere."""

FIGURES = "<!-- figures: Utilities/Accuracy/figures.py writes them -->", "<!-- end of the figures -->"


def table(header, rows):
    """A table in Markdown; numbers are to be formatted already."""
    lines = ["| " + " | ".join(cells) + " |" for cells in (header, *rows)]
    return "\n".join([lines[0], "|---" * len(header) + "|", *lines[1:]])


def figures_in(text):
    """What is between the marks in a report; nothing if it has none."""
    return text.partition(FIGURES[0])[2].partition(FIGURES[1])[0].strip()


def put_figures(path, figures):
    """Replaces what is between the marks in a report."""
    before, mark, rest = path.read_text().partition(FIGURES[0])
    if not mark or FIGURES[1] not in rest:
        raise ValueError(f"{path} has no marks for the figures: {FIGURES[0]} and {FIGURES[1]}")
    path.write_text(f"{before}{FIGURES[0]}\n{figures}\n{FIGURES[1]}{rest.partition(FIGURES[1])[2]}")

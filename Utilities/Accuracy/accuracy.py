# SPDX-License-Identifier: BSD-3-Clause
"""accuracy: measures reflections on waves against a ray tracer of their own and writes a report.

    script/accuracy                       everything, into Documentation/accuracy.md and its images
    script/accuracy --only lookup [...]   some sections, into build/accuracy

How it is put together:

    tracer      Embree traces the triangles that VTK draws
    reference   what is right: reflected rays, where they end, the picture they make
    formulas    the lookups that other programs use
    report      figures with limits, tables, plots, the text
    lookup, colour, cost, confidence, random_scenes, random_refraction, edges, caustics,
    surfaces, solver
                the sections. Each has run(report) and its own prose; a new one is a module with the
                same, added to SECTIONS
    scene_generator
                makes the random scenes, each from a seed. More of them than the report has:
                random_scenes.py is a command of its own, and oracle.py tells what
                a lookup that is right everywhere would reach; refraction_generator and refraction_truth are
                the same for what is seen through water, edge_generator and edges for edges

The truth shares no code with the module under test: waves, reflections and intersections are
computed from their definitions in vtkWaterProperty.h. The other scenes are those of the wave tests
(Testing/Python/wave_scenes.py). Exit status 1: a limit was not met. The report is written all the same.
"""

import argparse
import importlib
import pathlib
import sys

PROJECT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(PROJECT / "Testing" / "Python"))  # scenes, ray_caster

# name, module
SECTIONS = {"lookup": "lookup", "colour": "colour", "cost": "cost", "confidence": "confidence",
            "scenes": "random_scenes", "refraction": "random_refraction", "edges": "edges", "caustics": "caustics",
            "surfaces": "surfaces", "solver": "solver"}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", nargs="+", choices=SECTIONS, help="only these sections, into build/accuracy")
    only = parser.parse_args().only

    from report import Report  # VTK and the plots take seconds to load; a wrong argument should not

    report = Report(PROJECT / "build" / "accuracy" if only else PROJECT / "Documentation")
    for section in only or SECTIONS:
        importlib.import_module(SECTIONS[section]).run(report)
    report.write()
    return 1 if report.has_failed() else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Proves from the #include "..." lines of Module that its parts form no ring and its rooms an order.

usage: check_includes.py [--self-test]

A unit is a header with its source, the further sources of its name and its internals: vtkWaterActor.h,
vtkWaterActor.cxx, vtkWaterActorDraw.cxx and vtkWaterActorInternals.h are one, as a change of any asks to
read all. No units may form a ring, no headers either, and no file may include one of a room above its own.
VTK's and generated headers are not looked at. Prints every offence, or the order. --self-test: whether
each kind of offence is found in a made-up tree.
"""
import re
import sys
import tempfile
from pathlib import Path

# Bottom to top: a file includes only what lies in its own room or in one before it.
CORE = [
    "detail",  # numbers alone: below the types, which the files of base compute with it
    "shared",  # formulas of shaders, read as C
    "base",
    "waves",
    "optics",  # above the waves: a preset is a water's colour and its sea
    "visibility",  # whole scenes' boxes and triangles; the plan asks it, it asks no plan
    "plan",
    "quality",  # changes what a plan is given
]
PRIVATE = ["host", "geometry", "gather", "visibility", "shade", "draw", "reflection", "frame"]
PLUGIN = "OffScreen/vtkWaterOffScreenPlugin.cxx"  # a library of its own, which uses ours
ROOMS = [
    *(f"Core/{room}" for room in CORE),
    *(f"Private/{room}" for room in PRIVATE),
    "OffScreen",  # windows for a VTK without: they know the host alone, and only a public class knows them
    "public",  # Module/*.h, *.cxx, and Private/interface: the members that their classes hide
    "plugin",
]
# The classes' own headers: what lies below the classes is given what it needs.
FACADES = {"vtkWaterActor.h", "vtkWaterReflectionPass.h", "vtkWaterProperty.h"}
# The public headers and what a class keeps out of its own: only these are in the room "public".
INTERFACE = "Private/interface"

# Two classes that know each other, and why neither can do without: they count as one unit, while their
# headers are in no ring as all others.
TOGETHER = {
    "vtkWaterFrameThread": "vtkWaterFrame",  # keeps a thread's frames, and a frame is found there
}

def room_of(path):
    if path == PLUGIN:
        return "plugin"
    folder = path.rpartition("/")[0]
    return "public" if folder in ("", INTERFACE) else folder


def read(root):
    """The graph of files: path -> {path included: line number}, all relative to root."""
    paths = sorted(str(path.relative_to(root)) for path in root.rglob("*") if path.suffix in (".h", ".c", ".cxx"))
    by_name = {}
    offences = []
    for path in paths:
        name = path.rpartition("/")[2]
        if name in by_name:
            offences.append(f"two files of one name: {by_name[name]} and {path}")
        by_name[name] = path
    graph = {}
    for path in paths:
        graph[path] = {}
        for number, line in enumerate((root / path).read_text().splitlines(), 1):
            match = re.match(r'\s*#\s*include\s*["<]([^">]+)[">]', line)
            included = match and by_name.get(match.group(1).rpartition("/")[2])
            if included:
                graph[path].setdefault(included, number)
    return graph, offences


def unit_of(path, headers):
    """The header's name without its end: the file's own, else the longest that the name begins with."""
    stem = path.rpartition("/")[2].rpartition(".")[0]
    name = stem.removesuffix("Internals")
    while name and name not in headers:
        name = re.sub(r"[A-Z][a-z]*$|_[a-z]+$|.$", "", name, count=1)
    return TOGETHER.get(name, name or stem)


def rings(graph):
    """The rings of a graph {node: nodes}, one for each set of nodes that reach one another (Tarjan)."""
    index, low, stack, found = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for after in sorted(graph[node]):
            if after not in index:
                visit(after)
            if after in stack:
                low[node] = min(low[node], low[after])
        if low[node] == index[node]:
            members = set()
            while node not in members:
                members.add(stack.pop())
            if len(members) > 1 or node in graph[node]:
                found.append(walk(graph, members))

    def walk(graph, members):
        """The shortest way from the first member back to it."""
        start = min(members)
        ways, seen = [[start]], set()
        for way in ways:  # grows
            for after in sorted(graph[way[-1]] & members):
                if after == start:
                    return [*way, start]
                if after not in seen:
                    seen.add(after)
                    ways.append([*way, after])

    for node in sorted(graph):
        if node not in index:
            visit(node)
    return found


def check(root):
    """Every offence of the tree, one line each, and how many files, units and includes were seen."""
    graph, offences = read(root)
    headers = {path for path in graph if path.endswith(".h")}
    for ring in rings({path: set(graph[path]) for path in headers}):
        offences.append("headers in a ring: " + " -> ".join(ring))

    names = {path.rpartition("/")[2].rpartition(".")[0] for path in headers}
    units = {}
    for path, included in graph.items():
        unit = unit_of(path, names)
        units.setdefault(unit, set()).update(unit_of(other, names) for other in included)
    for unit, others in units.items():
        others.discard(unit)
    for ring in rings(units):
        offences.append("units in a ring: " + " -> ".join(ring))

    for path, included in graph.items():
        room = room_of(path)
        if room not in ROOMS:
            offences.append(f"a room without a place in the order: {path}")
            continue
        for other, line in included.items():
            above = room_of(other)
            if above in ROOMS and ROOMS.index(above) > ROOMS.index(room):
                offences.append(f"upwards: {path} includes {other}")
            if path.startswith("Private/") and room != "public" and other.rpartition("/")[2] in FACADES:
                offences.append(f"a public class known below: {path} includes {other}")
    return offences, len(graph), len(units), sum(len(included) for included in graph.values())


def self_test():
    """A tree without offences has none; each kind of offence is found."""
    sound = {
        "Core/detail/water_math.h": "",
        "Core/base/water_types.h": '#include <stdint.h>\n#include "vtkObject.h"\n',
        "Core/base/water_plane.c": '#include "water_types.h"\n# include "water_math.h"\n',
        "Private/host/vtkWaterQuad.h": '#include "water_types.h"\n',
        "Private/frame/vtkWaterFrame.h": '#include "vtkWaterQuad.h"\n',
        "Private/frame/vtkWaterFrameGroups.cxx": '#include "vtkWaterFrame.h"\n',
        "Private/interface/vtkWaterActorInternals.h": '#include "vtkWaterActor.h"\n',
        "vtkWaterActor.h": "",
        "vtkWaterActor.cxx": '#include "vtkWaterActorInternals.h"\n#include "vtkWaterFrame.h"\n',
    }
    cases = {
        "": {},
        "headers in a ring: Core/base/water_types.h -> Core/detail/water_math.h -> Core/base/water_types.h":
            {"Core/detail/water_math.h": '#include "water_types.h"\n',
             "Core/base/water_types.h": '#include "water_math.h"\n'},
        "units in a ring: vtkWaterFrame -> vtkWaterThread -> vtkWaterFrame":
            {"Private/frame/vtkWaterThread.h": '#include "vtkWaterFrame.h"\n',
             "Private/frame/vtkWaterFrameGroups.cxx": '#include "vtkWaterThread.h"\n'},
        "upwards: Private/host/vtkWaterQuad.cxx includes Private/frame/vtkWaterFrame.h":
            {"Private/host/vtkWaterQuad.cxx": '#include "vtkWaterFrame.h"\n'},
        "upwards: Core/base/water_plane.c includes Private/host/vtkWaterQuad.h":
            {"Core/base/water_plane.c": '#include "vtkWaterQuad.h"\n'},
        "a public class known below: Private/frame/vtkWaterFrame.h includes vtkWaterActor.h":
            {"Private/frame/vtkWaterFrame.h": '#include "vtkWaterActor.h"\n'},
        "a room without a place in the order: Private/attic/vtkWaterOld.h": {"Private/attic/vtkWaterOld.h": ""},
        "two files of one name": {"Private/frame/vtkWaterQuad.h": ""},
    }
    failures = 0
    for wanted, changes in cases.items():
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for path, text in {**sound, **changes}.items():
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text(text)
            offences = check(root)[0]
        ok = any(offence.startswith(wanted) for offence in offences) if wanted else not offences
        print(f"{'found' if wanted else 'a sound tree'}: {wanted or 'no offence'}: {'ok' if ok else 'FAILED'}")
        if not ok:
            print("\n".join(f"  {offence}" for offence in offences))
            failures += 1
    return failures


def main():
    if sys.argv[1:] not in ([], ["--self-test"]):
        sys.exit(__doc__)
    if sys.argv[1:]:
        sys.exit(1 if self_test() else 0)
    offences, files, units, includes = check(Path(__file__).resolve().parents[2] / "Module")
    for offence in offences:
        print(offence)
    if offences:
        sys.exit(f"check_includes: {len(offences)} offence(s)")
    if not includes:
        sys.exit("check_includes: no include was found: is the tree another?")
    print("bottom to top: " + ", ".join(ROOMS))
    print(f"check_includes: {files} files, {units} units, {includes} includes: no ring, no room includes one above it")


if __name__ == "__main__":
    main()

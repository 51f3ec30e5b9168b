# SPDX-License-Identifier: BSD-3-Clause
"""What a file or folder holds, for ``vtkwater info FILE``: bounds, units, steps, arrays, and commands to try.

    facts = contents_of("flood.pvd")
    facts["arrays"]         # [{"name": "h", "of": "points", "components": 1, "range": [0.0, 2.3]}, ...]
    print(text_of(facts))
"""
import re
import shlex
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import readers, solutions
from .readers import FileError, kind_of
from .sources import open_source

__all__ = ["contents_of", "text_of"]

# What solvers call these arrays, in lower case and without anything but letters and digits.
USUAL_NAMES = {
    "level": ("level", "waterlevel", "zeta", "eta", "wse", "stage", "ssh", "freesurface", "surfaceelevation"),
    "depth": ("depth", "waterdepth", "h", "hydraulicdepth"),
    "bed": ("bed", "zb", "bedlevel", "bottom", "bathymetry", "elevation", "topography", "terrain", "ground"),
    "contour": ("alphawater", "alpha1", "vof", "volumefraction", "fraction"),
    "flow": ("velocity", "flow", "current", "uv"),
}
FLOODED = 0.25  # share of a terrain's points below the suggested level


def contents_of(file, no_data=None):
    """The contents of a file that the command can show, as a dict of plain values.

    Parameters
    ----------
    file : str or pathlib.Path
        One of the types of readers.KINDS or solutions.KINDS, or a folder of GeoTIFF files.

    Returns
    -------
    dict
        "file", "kind", "points", "cells", "bounds" (x, y and z; of the first step), "units" (a sentence), "times"
        (empty if the file has none), "arrays" (of the first step), "notes" and "try" (command lines).

    Raises
    ------
    FileError
        If the file is missing, empty, of an unknown type, or not of the type that its suffix claims.
    """
    path = Path(file)
    suffix = path.suffix.lower()
    surface, why = None, None
    if not path.is_dir():
        kind_of(path, {**readers.KINDS, **solutions.KINDS})
        if suffix in readers.KINDS:
            try:
                surface = readers.read(path, no_data)
            except FileError as error:
                why = error
    facts = {"file": str(file), "times": [], "arrays": [], "notes": [], "try": []}
    if surface is not None:
        facts.update(kind="terrain" if surface.is_terrain else "mesh", **sizes_of(surface.data),
                     units="metres (--units names another unit)" if surface.is_terrain else
                     "not known; --units names it, by default it follows from the size")
        facts["notes"] += [surface.note] if surface.note else []
        heights = vtk_to_numpy(surface.data.GetPoints().GetData())[:, 2].astype(float)
        level = level_among(heights, FLOODED if surface.is_terrain else None)
        if level is not None:
            facts["try"].append(f"vtkwater render {shlex.quote(str(file))} --level {plain(level)}")
    if path.is_dir() or suffix in solutions.KINDS:
        try:
            add_steps(facts, path)
        except FileError as error:
            if surface is None:
                raise error from why
    elif why:
        raise why
    if surface is not None and not facts["try"]:
        facts["notes"].append(f"all heights are {heights[0]:g}: no level lies between them")
    return facts


def add_steps(facts, path):
    """Add what a solver's file has: times, arrays, and its usual options."""
    source = open_source(path)
    data = source.read(0)
    leaves = solutions.leaves_of(data)
    is_volume = max(map(solutions.dimension_of, leaves), default=0) == 3
    mesh = solutions.mesh_of(data, path, is_volume)
    if "kind" not in facts:
        facts.update(kind="folder of GeoTIFF files" if path.is_dir() else
                     "solver's volume" if is_volume else "solver's mesh", **sizes_of(mesh),
                     units="degrees, converted to metres for pictures" if source.is_lonlat else
                     "metres (--units names another unit)")
    facts["times"] = list(source.times)
    facts["arrays"] = [array for array in arrays_of(mesh) if not array["name"].startswith("vtk")]
    for array in facts["arrays"]:
        array["unit"] = source.unit_of(array["name"])
    if getattr(source, "note", ""):
        facts["notes"].append(source.note)
    options = usual_options(facts["arrays"], is_volume)
    if not options and not facts["try"] and not is_volume:
        options = level_over_bed(facts["arrays"])
    if options:
        facts["try"].insert(0, f"vtkwater render {shlex.quote(facts['file'])} {options}")
    elif not facts["try"]:
        wanted = "--contour, a volume fraction" if is_volume else "two of --level, --depth and --bed"
        facts["notes"].append(f"no array has a usual name; name arrays for {wanted}")


def sizes_of(mesh):
    return {"points": mesh.GetNumberOfPoints(), "cells": mesh.GetNumberOfCells(), "bounds": list(mesh.GetBounds())}


def arrays_of(mesh):
    """The arrays of a mesh: name, place, components, and the range of the finite values or of their magnitudes."""
    for data, of in ((mesh.GetPointData(), "points"), (mesh.GetCellData(), "cells")):
        for i in range(data.GetNumberOfArrays()):
            array = data.GetArray(i)
            if array is None:  # of texts
                continue
            values = vtk_to_numpy(array).astype(float)
            values = values if values.ndim == 1 else np.linalg.norm(values, axis=1)
            values = values[np.isfinite(values)]
            yield {"name": array.GetName() or "", "of": of, "components": array.GetNumberOfComponents(),
                   "range": [float(values.min()), float(values.max())] if values.size else None}


def level_among(heights, share=None):
    """A level between the lowest and the highest of some heights, rounded to three digits of their range or more.

    It floods a share of them, or half of their range. None if all heights are the same.
    """
    low, high = heights.min(), heights.max()
    if not low < high:
        return None
    level = 0.5 * (low + high) if share is None else np.quantile(heights, share)
    if not low < level < high:  # many are the lowest, such as a sea's
        level = np.quantile(heights[heights > low], share) if level <= low else level
        level = 0.5 * (low + level)
    digits = 2 - int(np.floor(np.log10(high - low)))
    rounded = [round(float(level), more) for more in range(digits, digits + 4)]
    return next((value for value in rounded if low < value < high), float(level))


def plain(value):
    """A number without an exponent, because an option does not accept a negative number with one."""
    return np.format_float_positional(value, trim="-")


def usual_options(arrays, is_volume):
    """Options for arrays with usual names; empty if they do not define the water."""
    named = {}
    for word, names in USUAL_NAMES.items():
        components = (2, 3) if word == "flow" else (1,)
        named[word] = next((array["name"] for name in names for array in arrays if array["components"] in components
                            and simple(array["name"]) == name), None)
    if is_volume:
        words = ["contour"] if named["contour"] else []
    else:
        words = [word for word in ("depth", "level", "bed") if named[word]]
        words = ["depth", "bed"] if len(words) == 3 else words if words != ["bed"] else []
        words += ["flow"] if words and named["flow"] else []
    waves = " --wind 5" if "flow" in words else ""
    return " ".join(f"--{word} {shlex.quote(named[word])}" for word in words) + waves


def level_over_bed(arrays):
    """Options for a flat mesh whose heights are an array with a usual name; empty if it has none."""
    for array in arrays:
        if array["components"] == 1 and array["range"] and simple(array["name"]) in USUAL_NAMES["bed"]:
            level = level_among(np.array(array["range"]))
            return "" if level is None else f"--level {plain(level)} --bed {shlex.quote(array['name'])}"
    return ""


def simple(name):
    """A name in lower case, with only its letters and digits."""
    return re.sub("[^a-z0-9]", "", name.lower())


def text_of(facts):
    """The contents as lines for a reader."""
    x, y, z = (f"{facts['bounds'][i]:g} to {facts['bounds'][i + 1]:g}" for i in (0, 2, 4))
    lines = [f"{facts['file']}: {facts['kind']}, {facts['points']} points, {facts['cells']} cells",
             f"bounds: x {x}; y {y}; z {z}", f"units: {facts['units']}"]
    times = facts["times"]
    if times:
        lines.append(f"steps: {len(times)}, times {times[0]:g} to {times[-1]:g}")
    for array in facts["arrays"]:
        what = "" if array["components"] == 1 else f", {array['components']} components, magnitude"
        ends = array["range"]
        values = f"{ends[0]:g} to {ends[1]:g}" if ends else "no finite value"
        values += f" {array['unit']}" if array["unit"] else ""
        first = " in the first step" if len(times) > 1 else ""
        lines.append(f"array: {array['name']} ({array['of']}{what}) {values}{first}")
    lines += [f"note: {note}" for note in facts["notes"]]
    lines += [f"try: {line}" for line in facts["try"]]
    return "\n".join(lines)

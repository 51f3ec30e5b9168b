#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The recipes for conda-forge, vcpkg and VTK have the project's version, licence and names, and vcpkg's format.

usage: check_recipes.py [FOLDER]   default: the folder of this file
       check_recipes.py --self-test   does it find what it is meant to find?

Exit status 1: something is wrong; each is a line.
"""
import json
import re
import shutil
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parents[1]
# The order that `vcpkg format-manifest` gives these keys.
MANIFEST_KEYS = ["name", "version-semver", "description", "homepage", "license", "supports", "dependencies"]


def project_facts():
    """The values that the recipes must repeat: version, licence, module, dependencies of the wheel."""
    cmake = (PROJECT / "CMakeLists.txt").read_text()
    wheel = (PROJECT / "pyproject.toml").read_text()
    dependencies = re.search(r"^dependencies = \[(.*)\]", wheel, re.M).group(1)
    return {
        "version": re.search(r"project\(vtkWater VERSION ([0-9.]+)", cmake).group(1),
        "license": re.search(r'^license = "(.*)"', wheel, re.M).group(1),
        "module": re.search(r"VTK::(\w+)", (PROJECT / "vtk.module").read_text()).group(1),
        "run": sorted(set(re.findall(r'"([a-z]+)', dependencies)) - {"vtk"}),
    }


def check_conda(folder, facts):
    text = (folder / "conda/recipe.yaml").read_text()
    run = re.search(r"^  run:\n((?:    - .*\n)+)", text, re.M).group(1)
    found = {
        "version": re.search(r'^  version: "(.*)"', text, re.M).group(1),
        "license": re.search(r"^  license: (.*)", text, re.M).group(1),
        "run": sorted(set(re.findall(r"- (\w+)", run)) - {"python"}),
    }
    return [f"conda/recipe.yaml: {key} is {value}, the project's is {facts[key]}"
            for key, value in found.items() if value != facts[key]]


def check_vcpkg(folder, facts):
    port = folder / "vcpkg/vtkwater"
    text = (port / "vcpkg.json").read_text()
    manifest = json.loads(text)
    errors = []
    if list(manifest) != MANIFEST_KEYS or text != json.dumps(manifest, indent=2) + "\n":
        errors.append("vcpkg.json: not in the format of `vcpkg format-manifest`: keys " + ", ".join(MANIFEST_KEYS))
    names = [(entry if isinstance(entry, str) else entry["name"]) for entry in manifest["dependencies"]]
    # helpers for the machine that builds come first, then names in the order of the alphabet
    is_host = [isinstance(entry, dict) and bool(entry.get("host")) for entry in manifest["dependencies"]]
    if [*zip(is_host, names)] != sorted(zip(is_host, names), key=lambda pair: (not pair[0], pair[1])):
        errors.append("vcpkg.json: the dependencies are not in order: " + ", ".join(names))
    for key, name in (("version-semver", "version"), ("license", "license")):
        if manifest[key] != facts[name]:
            errors.append(f"vcpkg.json: {key} is {manifest[key]}, the project's is {facts[name]}")
    portfile = (port / "portfile.cmake").read_text()
    if not (port / "usage").is_file() or "vcpkg_install_copyright" not in portfile:
        errors.append("vcpkg/vtkwater: a port needs a file usage, and installs its copyright")
    return errors


def check_remote(folder, facts):
    file = folder / f"vtk/{facts['module']}.remote.cmake"
    if not file.is_file():
        return [f"{file.name} is missing: VTK takes the module's name for the name of the file"]
    name, tag = re.search(r"vtk_fetch_module\((\w+).*GIT_TAG (\S+)", file.read_text(), re.S).groups()
    if (name, tag) != (facts["module"], "v" + facts["version"]):
        return [f"{file.name}: fetches {name} {tag}, the project is {facts['module']} v{facts['version']}"]
    return []


def check(folder):
    facts = project_facts()
    return check_conda(folder, facts) + check_vcpkg(folder, facts) + check_remote(folder, facts)


def self_test():
    """Every change of a line below is reported."""
    changes = [("conda/recipe.yaml", 'version: "', 'version: "9'), ("conda/recipe.yaml", "    - tqdm\n", ""),
               ("conda/recipe.yaml", "license: BSD", "license: GPL"), ("vcpkg/vtkwater/vcpkg.json", '  "name": "vtkw', ' "name": "vtkw'),
               ("vcpkg/vtkwater/vcpkg.json", 'semver": "', 'semver": "9'),
               ("vcpkg/vtkwater/vcpkg.json", '"vcpkg-cmake"', '"vcpkg-zmake"'),
               ("vcpkg/vtkwater/portfile.cmake", "vcpkg_install_copyright", "install"),
               ("vtk/RenderingWater.remote.cmake", "GIT_TAG v", "GIT_TAG w")]
    missed = []
    for name, old, new in changes:
        with tempfile.TemporaryDirectory() as work:
            copy = Path(shutil.copytree(HERE, Path(work) / "copy"))
            text = (copy / name).read_text()
            (copy / name).write_text(text.replace(old, new, 1))
            if old not in text or not check(copy):
                missed.append(f"{name}: {old!r} -> {new!r}")
    print("\n".join(["not found: " + line for line in missed] or [f"{len(changes)} faults found"]))
    return 1 if missed else 0


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    errors = check(Path(sys.argv[1]) if len(sys.argv) > 1 else HERE)
    print("\n".join(errors) or "the recipes agree with the project")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""make_sdk: marries PyPI's vtk wheel with Debian's headers into a CMake SDK.

The wheel has every library of VTK but no header and no CMake file. Debian's packages of the same
version have those, but were built otherwise: other third-party libraries, another Python, the new
libstdc++ ABI. So this takes

    headers, CMake modules, class hierarchies   from libvtk9-dev and libvtk9.x,
    the imported targets' libraries             from the wheel,
    the wrapping tools                          from vtk9 and python3-vtk9, run by libc6's loader,

and mends what Debian's files say about the rest. Called by assemble.sh. Needs only the standard
library, dpkg-deb, tar and nm.
"""
import argparse
import base64
import hashlib
import json
import os
import re
import shutil
import stat
import subprocess
import sys
import zipfile
from pathlib import Path

MULTIARCH = "x86_64-linux-gnu"
# imported executable -> the package it is taken from, its file
TOOLS = {
    "WrapHierarchy": ("vtk9", "vtkWrapHierarchy"),
    "WrapPython": ("python3-vtk9", "vtkWrapPython"),
    "WrapPythonInit": ("python3-vtk9", "vtkWrapPythonInit"),
    "WrapSerDes": ("vtk9", "vtkWrapSerDes"),
}
# Left out although the wheel has them: they would want Viskores' own CMake package.
LEFT_OUT = {"vtkviskores", "AcceleratorsVTKmCore", "AcceleratorsVTKmDataModel",
            "AcceleratorsVTKmFilters"}
# What targets may link that is not VTK's.
EXTERNAL = re.compile(r"Python3::|Threads::Threads|^dl$|^m$|pthread")


class Wheel:
    """What the installed wheel is and how it was built."""

    def __init__(self, python):
        facts = json.loads(subprocess.check_output([python, "-c", """
import importlib.metadata, json, pathlib, sys, sysconfig
import vtkmodules
from vtkmodules.vtkCommonCore import vtkSMPTools
print(json.dumps([importlib.metadata.version("vtk"), str(pathlib.Path(vtkmodules.__file__).parent),
                  "%d.%d" % sys.version_info[:2], sysconfig.get_config_var("SOABI"),
                  vtkSMPTools.GetBackend()]))
"""], text=True))
        self.version, folder, self.python, self.soabi, self.smp_default = facts
        self.folder = Path(folder)
        self.short = ".".join(self.version.split(".")[:2])  # 9.6
        symbols = subprocess.check_output(
            ["nm", "-DC", str(self.folder / "libvtkCommonCore.so")], text=True)
        # BackendType's values: 0 Sequential, 1 STDThread, 2 TBB, 3 OpenMP
        backends = re.findall(r"vtkSMPToolsImpl<\(vtk::detail::smp::BackendType\)(\d)>", symbols)
        names = ("Sequential", "STDThread", "TBB", "OpenMP")
        self.smp = {name: str(value) in backends for value, name in enumerate(names)}
        self.old_abi = "__cxx11::basic_string" not in symbols

    def library(self, name):
        """File name of a library, None if the wheel has none."""
        for file in ("lib%s.so" % name, "lib%s%s.so" % (name, self.python)):
            if (self.folder / file).exists():
                return file
        return None


def extract(debs, work, short):
    """Unpacks the packages; returns {package: folder}."""
    folders = {}
    for package in ("libvtk9-dev", "vtk9", "python3-vtk9", "libc6", "libvtk" + short):
        files = sorted(Path(debs).glob(package + "_*_amd64.deb"))
        if not files:
            sys.exit("make_sdk: no %s_*_amd64.deb in %s" % (package, debs))
        folder = work / package
        folder.mkdir(parents=True)
        folders[package] = folder
        if package != "libvtk" + short:
            subprocess.check_call(["dpkg-deb", "-x", str(files[-1]), str(folder)])
            continue
        # 350 MB of libraries, of which only these are of use
        wanted = ["./usr/lib/%s/libvtkWrappingTools-%s.so*" % (MULTIARCH, short),
                  "./usr/lib/%s/vtk-%s/hierarchy" % (MULTIARCH, short)]
        unpack = subprocess.Popen(["dpkg-deb", "--fsys-tarfile", str(files[-1])],
                                  stdout=subprocess.PIPE)
        subprocess.check_call(["tar", "-x", "-C", str(folder), "--wildcards"] + wanted,
                              stdin=unpack.stdout)
        if unpack.wait():
            sys.exit("make_sdk: dpkg-deb failed on %s" % files[-1])
    return folders


def copy_headers(debian, prefix, wheel):
    folder = prefix / "include" / ("vtk-" + wheel.short)
    shutil.copytree(debian["libvtk9-dev"] / "usr/include" / folder.name, folder,
                    ignore=shutil.ignore_patterns("vtkviskores"))
    version = re.search(r'#define VTK_VERSION "([^"]+)"',
                        (folder / "vtkVersionMacros.h").read_text()).group(1)
    if version != wheel.version:
        sys.exit("make_sdk: headers are %s, the wheel is %s" % (version, wheel.version))

    # vtkSMP.h decides the layout of classes: it must say what the wheel was built with.
    text = (folder / "vtkSMP.h").read_text()
    default = wheel.smp_default
    for name, is_on in wheel.smp.items():
        text = re.sub(r"(#define VTK_SMP_ENABLE_%s) \d" % name.upper(), r"\1 %d" % is_on, text)
        text = re.sub(r"(#define VTK_SMP_DEFAULT_IMPLEMENTATION_%s) \d" % name.upper(),
                      r"\1 %d" % (name == default), text)
    text = re.sub(r"#define VTK_SMP_(%s)\b" % "|".join(wheel.smp),
                  "#define VTK_SMP_" + default, text)
    text = re.sub(r'#define VTK_SMP_BACKEND ".*"', '#define VTK_SMP_BACKEND "%s"' % default, text)
    (folder / "vtkSMP.h").write_text(text)


def copy_tools(debian, prefix, wheel):
    """The wrapping tools, with their own loader and C library: they are newer than this system."""
    folder = prefix / "libexec/vtk-host-tools"
    folder.mkdir(parents=True)
    (prefix / "bin").mkdir()
    libraries = debian["libc6"] / "usr/lib" / MULTIARCH
    for file in ("ld-linux-x86-64.so.2", "libc.so.6"):
        shutil.copy(libraries / file, folder / file)
    soname = "libvtkWrappingTools-%s.so.1" % wheel.short
    library = debian["libvtk" + wheel.short] / "usr/lib" / MULTIARCH / soname
    shutil.copy(library.resolve(), folder / soname)
    for package, file in TOOLS.values():
        shutil.copy(debian[package] / "usr/bin" / ("%s-%s" % (file, wheel.short)), folder / file)
        script = prefix / "bin" / file
        script.write_text(
            '#!/bin/sh\nd=$(dirname "$(readlink -f "$0")")/../libexec/vtk-host-tools\n'
            'exec "$d/ld-linux-x86-64.so.2" --library-path "$d" "$d/%s" "$@"\n' % file)
        script.chmod(0o755)
        (folder / file).chmod(0o755)
    (folder / "ld-linux-x86-64.so.2").chmod(0o755)


def parse_targets(text):
    """VTK-targets.cmake as {name: (kind, {property: value})}."""
    targets = {}
    parts = re.split(r"^# Create imported target VTK::(\S+)\n", text, flags=re.M)
    for name, body in zip(parts[1::2], parts[2::2]):
        added = re.match(r"add_(library|executable)\(VTK::\S+ (?:(\w+) )?IMPORTED\)", body)
        kind = "EXECUTABLE" if added.group(1) == "executable" else added.group(2)
        properties = {}
        block = re.search(r"set_target_properties\(VTK::\S+ PROPERTIES\n(.*?)\n\)", body, re.S)
        if block:
            properties.update(re.findall(r'^\s+(\S+) "(.*)"$', block.group(1), re.M))
        includes = properties.get("INTERFACE_INCLUDE_DIRECTORIES", "").split(";")
        for block in re.findall(
                r"APPEND PROPERTY INTERFACE_INCLUDE_DIRECTORIES\n(.*?)\n\s*\)", body, re.S):
            includes += re.findall(r'"([^"]*)"', block)
        includes = [i for i in dict.fromkeys(i.rstrip("/") for i in includes) if i]
        if includes:
            properties["INTERFACE_INCLUDE_DIRECTORIES"] = ";".join(includes)
        targets[name] = (kind, properties)
    return targets


def split_list(text):
    """A CMake list, split at the semicolons outside of generator expressions."""
    items, item, depth = [], "", 0
    for letter in text:
        depth += (letter == "<") - (letter == ">")
        if letter == ";" and depth == 0:
            items.append(item)
            item = ""
        else:
            item += letter
    return [i for i in items + [item] if i]


class CMakeFiles:
    """Debian's CMake package, mended for the wheel."""

    def __init__(self, debian, prefix, wheel):
        self.wheel = wheel
        self.prefix = prefix
        self.source = (debian["libvtk9-dev"] / "usr/lib" / MULTIARCH / "cmake" /
                       ("vtk-" + wheel.short))
        self.folder = prefix / "lib/cmake" / ("vtk-" + wheel.short)
        self.library_names = dict(re.findall(
            r'TARGET "VTK::(\S+)" PROPERTY "INTERFACE_vtk_module_library_name" "([^"]*)"',
            self.read("VTK-vtk-module-properties.cmake")))
        self.kept = self.choose_targets()  # {name: (kind, properties, file of wheel or prefix)}

    def read(self, name):
        return (self.source / name).read_text()

    def choose_targets(self):
        kept = {}
        for name, (kind, properties) in parse_targets(self.read("VTK-targets.cmake")).items():
            if name in LEFT_OUT:
                continue
            if kind == "EXECUTABLE":
                if name in TOOLS:
                    kept[name] = (kind, properties, TOOLS[name][1])
                continue
            library = self.wheel.library(self.library_names.get(name, "vtk" + name))
            if library:
                kept[name] = ("SHARED", properties, library)
            elif kind == "INTERFACE":
                kept[name] = (kind, properties, None)
        return kept

    def is_known(self, item):
        """May this link item or dependency stay?"""
        target = re.search(r"VTK::(\w+)", item)
        return target.group(1) in self.kept if target else bool(EXTERNAL.search(item))

    def write(self):
        shutil.copytree(self.source, self.folder, ignore=shutil.ignore_patterns(
            "viskores", "*-targets*.cmake", "*Java*", "Find*.cmake", "patches"))
        if (self.source / "patches").exists():
            (self.folder / "patches").mkdir()  # vtkCMakeBackports.cmake looks for the folder
        self.write_targets()
        self.write_python_targets()
        self.write_module_properties()
        self.write_find_packages()
        self.write_config()

    def write_targets(self):
        lines = """\
# Made by make_sdk.py: VTK @version@, libraries of PyPI's wheel
if (TARGET VTK::CommonCore)
  return ()
endif ()
get_filename_component(_IMPORT_PREFIX "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
# The wheel's libraries: where the caller says, beside this package, or where they were.
if (NOT VTK_WHEEL_LIBRARY_DIR)
  foreach (_vtk_wheel_dir IN ITEMS "${_IMPORT_PREFIX}/../../vtkmodules" "@folder@")
    if (EXISTS "${_vtk_wheel_dir}/libvtkCommonCore.so")
      get_filename_component(VTK_WHEEL_LIBRARY_DIR "${_vtk_wheel_dir}" ABSOLUTE)
      break ()
    endif ()
  endforeach ()
  unset(_vtk_wheel_dir)
endif ()
if (NOT EXISTS "${VTK_WHEEL_LIBRARY_DIR}/libvtkCommonCore.so")
  message(FATAL_ERROR "VTK's wheel was not found: set VTK_WHEEL_LIBRARY_DIR to the vtkmodules folder of vtk==@version@")
endif ()
""".replace("@version@", self.wheel.version).replace("@folder@", str(self.wheel.folder)).splitlines()
        for name, (kind, properties, file) in self.kept.items():
            if kind == "EXECUTABLE":
                lines += ["add_executable(VTK::%s IMPORTED)" % name,
                          'set_target_properties(VTK::%s PROPERTIES IMPORTED_LOCATION '
                          '"${_IMPORT_PREFIX}/bin/%s")' % (name, file)]
                continue
            lines.append("add_library(VTK::%s %s IMPORTED)" % (name, kind))
            properties = self.mend_properties(name, kind, properties, file)
            if properties:
                lines.append("set_target_properties(VTK::%s PROPERTIES" % name)
                lines += ['  %s "%s"' % item for item in properties.items()] + [")"]
        lines.append("unset(_IMPORT_PREFIX)")
        (self.folder / "VTK-targets.cmake").write_text("\n".join(lines) + "\n")

    def mend_properties(self, name, kind, properties, file):
        result = dict(properties)
        result.pop("INTERFACE_SYSTEM_INCLUDE_DIRECTORIES", None)
        links = [i for i in split_list(result.get("INTERFACE_LINK_LIBRARIES", ""))
                 if self.is_known(i)]
        # vtkplatform is linked by all and so carries the wheel's ABI to everything that uses VTK
        if name == "vtkplatform":
            links = []
            if self.wheel.old_abi:
                result["INTERFACE_COMPILE_DEFINITIONS"] = "_GLIBCXX_USE_CXX11_ABI=0"
        elif kind == "SHARED" and "VTK::vtkplatform" not in links:
            links.insert(0, "VTK::vtkplatform")
        result["INTERFACE_LINK_LIBRARIES"] = ";".join(links)

        includes = [i for i in result.get("INTERFACE_INCLUDE_DIRECTORIES", "").split(";") if i]
        if not includes and (kind == "SHARED" or name in ("Python", "vtkplatform")):
            includes = ["${_IMPORT_PREFIX}/include/vtk-" + self.wheel.short]
        result["INTERFACE_INCLUDE_DIRECTORIES"] = ";".join(
            i for i in includes if os.path.isdir(i.replace("${_IMPORT_PREFIX}", str(self.prefix))))
        if kind == "SHARED":
            result["IMPORTED_LOCATION"] = "${VTK_WHEEL_LIBRARY_DIR}/" + file
            result["IMPORTED_SONAME"] = file
        return {key: value for key, value in result.items() if value}

    def write_python_targets(self):
        lines = ["if (TARGET VTK::vtkCommonCorePython)", "  return ()", "endif ()"]
        for name in self.kept:
            library = self.library_names.get(name, "-")
            file = "%s.%s.so" % (library, self.wheel.soabi)
            if (self.wheel.folder / file).exists():
                lines += ["add_library(VTK::%sPython MODULE IMPORTED)" % library,
                          'set_target_properties(VTK::%sPython PROPERTIES IMPORTED_LOCATION '
                          '"${VTK_WHEEL_LIBRARY_DIR}/%s" IMPORTED_NO_SONAME TRUE)' % (library, file)]
        (self.folder / "VTKPython-targets.cmake").write_text("\n".join(lines) + "\n")

    def write_module_properties(self):
        """Only kept modules with only kept dependencies; Debian's lib/<multiarch> becomes lib."""
        climb = ('get_filename_component(_vtk_module_import_prefix '
                 '"${_vtk_module_import_prefix}" DIRECTORY)\n')
        for file in ("VTK-vtk-module-properties.cmake",
                     "vtkmodules-vtk-python-module-properties.cmake"):
            lines = []
            for line in self.read(file).splitlines():
                match = re.match(
                    r'set_property\(TARGET "VTK::([^"]+)" PROPERTY "([^"]+)" "(.*)"\)$', line)
                if match:
                    name, key, value = match.groups()
                    if name not in self.kept:
                        continue
                    if key.endswith(("_depends", "_implements")):
                        value = ";".join(i for i in split_list(value) if self.is_known(i))
                        line = 'set_property(TARGET "VTK::%s" PROPERTY "%s" "%s")' % (
                            name, key, value)
                lines.append(line.replace("/lib/%s/" % MULTIARCH, "/lib/"))
            text = "\n".join(lines) + "\n"
            # the file climbs to the prefix by itself: one folder less now
            if text[:2000].count(climb) >= 4:
                text = text.replace(climb, "", 1)
            (self.folder / file).write_text(text)
        (self.folder / "vtk-prefix.cmake").write_text(
            'set(_vtk_module_import_prefix "${CMAKE_CURRENT_LIST_DIR}")\n' + 3 * climb)

    def write_find_packages(self):
        """Of the external packages only Python and threads are still looked for."""
        text = self.read("VTK-vtk-module-find-packages.cmake")
        blocks = re.split(r"(?=^set\(_vtk_module_find_package_enabled OFF\)$)", text, flags=re.M)
        kept = [blocks[0], "find_package(Threads QUIET)\n"]
        for block in blocks[1:]:
            package = re.search(r"^  find_package\((\S+)", block, re.M)
            if package and package.group(1) == "Python3":
                kept.append(re.sub(r"(find_package\(Python3\s+)\d+\.\d+",
                                   r"\g<1>%s EXACT" % self.wheel.python, block))
        end = re.search(r"(?:^unset\(_vtk_module_find_package_"
                        r"(?:components|components_required|quiet)\)\n)+\Z", blocks[-1], re.M)
        (self.folder / "VTK-vtk-module-find-packages.cmake").write_text(
            "".join(kept) + (end.group(0) if end else ""))

    def write_config(self):
        text = self.read("vtk-config.cmake")
        components = re.search(r'_AVAILABLE_COMPONENTS" "([^"]*)"', text).group(1).split(";")
        settings = {
            "AVAILABLE_COMPONENTS": ";".join(c for c in components if c in self.kept),
            "HAS_VISKORES": "OFF",
            "HAS_VTKm": "OFF",
            "WRAP_JAVA": "OFF",
            "SMP_BACKENDS": ";".join(name for name, is_on in self.wheel.smp.items() if is_on),
            "PYTHONPATH": ".",
        }
        for name, value in settings.items():
            text = re.sub(r'(_%s") "[^"]*"\)' % name, r'\1 "%s")' % value, text, count=1)
        text = text.replace("if (6) # VTK_QT_VERSION", "if (0) # VTK_QT_VERSION")
        (self.folder / "vtk-config.cmake").write_text(text)


def write_wheel(prefix, folder, wheel):
    """The prefix as a wheel vtk_sdk, which scikit-build-core finds by its entry point."""
    python = "cp" + wheel.python.replace(".", "")
    tag = "%s-%s-linux_x86_64" % (python, python)
    info = "vtk_sdk-%s.dist-info/" % wheel.version
    record = []
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / ("vtk_sdk-%s-%s.whl" % (wheel.version, tag))
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        def add(name, data, mode=0o644):
            entry = zipfile.ZipInfo(name, (2020, 1, 1, 0, 0, 0))  # same input, same file
            entry.external_attr = (stat.S_IFREG | mode) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record.append("%s,sha256=%s,%d" % (name, digest, len(data)))

        add("vtk_sdk/__init__.py", b'__version__ = "%s"\n' % wheel.version.encode())
        add("vtk_sdk/cmake/__init__.py", b"")
        for file in ("vtk-config.cmake", "vtk-config-version.cmake"):
            add("vtk_sdk/cmake/" + file,
                ("include(${CMAKE_CURRENT_LIST_DIR}/../content/lib/cmake/vtk-%s/%s)\n"
                 % (wheel.short, file)).encode())
        for file in sorted(f for f in prefix.rglob("*") if f.is_file()):
            mode = 0o755 if file.stat().st_mode & 0o111 else 0o644
            add("vtk_sdk/content/" + file.relative_to(prefix).as_posix(), file.read_bytes(), mode)
        add(info + "METADATA",
            ("Metadata-Version: 2.1\nName: vtk-sdk\nVersion: %s\n"
             "Summary: local stand-in for Kitware's vtk-sdk (Debian's headers)\n"
             "Requires-Dist: vtk==%s\n" % (wheel.version, wheel.version)).encode())
        add(info + "WHEEL", ("Wheel-Version: 1.0\nGenerator: make_sdk\n"
                             "Root-Is-Purelib: false\nTag: %s\n" % tag).encode())
        add(info + "entry_points.txt", b"[cmake.prefix]\nany = vtk_sdk.cmake\n")
        record.append(info + "RECORD,,")
        archive.writestr(info + "RECORD", "\n".join(record) + "\n")
    return path


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--python", required=True, help="a Python that has the wheel installed")
    parser.add_argument("--debs", required=True, help="folder with Debian's packages")
    parser.add_argument("--prefix", required=True, type=Path, help="folder to make anew")
    parser.add_argument("--wheel", type=Path, help="folder for a wheel of the SDK")
    arguments = parser.parse_args()
    prefix = arguments.prefix.absolute()
    work = prefix.with_name(prefix.name + ".work")
    for folder in (prefix, work):
        shutil.rmtree(folder, ignore_errors=True)

    wheel = Wheel(arguments.python)
    print("make_sdk: vtk %s for Python %s, SMP backends %s, %s libstdc++ ABI" % (
        wheel.version, wheel.python, " ".join(n for n, is_on in wheel.smp.items() if is_on),
        "old" if wheel.old_abi else "new"))
    debian = extract(arguments.debs, work, wheel.short)
    copy_headers(debian, prefix, wheel)
    shutil.copytree(
        debian["libvtk" + wheel.short] / "usr/lib" / MULTIARCH / ("vtk-" + wheel.short) / "hierarchy",
        prefix / "lib" / ("vtk-" + wheel.short) / "hierarchy")
    copy_tools(debian, prefix, wheel)
    cmake_files = CMakeFiles(debian, prefix, wheel)
    cmake_files.write()
    print("make_sdk: %d targets, %d with a library of the wheel" % (
        len(cmake_files.kept), sum(kind == "SHARED" for kind, _, _ in cmake_files.kept.values())))
    if arguments.wheel:
        print("make_sdk:", write_wheel(prefix, arguments.wheel, wheel))
    shutil.rmtree(work)


if __name__ == "__main__":
    main()

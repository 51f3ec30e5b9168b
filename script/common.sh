# SPDX-License-Identifier: BSD-3-Clause
# Shared by the scripts beside it; sourced, not run. Gives them the project's folder as the current
# one, messages, and the build of one leg.
#
# A leg is a build of the module against one VTK:
#   system  the distribution's VTK (Debian 12: 9.1) and /usr/bin/python3
#   wheel   PyPI's VTK (9.6) and a Python environment in build/sdk
# shellcheck shell=bash
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
project=$PWD
jobs=$(nproc)
me=$(basename "$0")

say() { echo "$me: $*"; }
die() { echo "$me: $*" >&2; exit 1; }

# timed WHAT COMMAND...: runs it, its output into build/log/WHAT.log, which is shown if it fails.
timed() {
  local what=$1 start=$SECONDS status=0
  shift
  mkdir -p build/log
  "$@" >"build/log/$what.log" 2>&1 || status=$?
  if [ "$status" -eq 0 ]; then
    say "$what: $((SECONDS - start)) s"
  else
    say "$what FAILED after $((SECONDS - start)) s; the end of build/log/$what.log:"
    tail -n 40 "build/log/$what.log"
  fi
  return "$status"
}

# The folder of the distribution's vtk-config.cmake.
system_vtk_dir() {
  local config
  config=$(find /usr/lib -path '*/cmake/vtk*/vtk-config.cmake' 2>/dev/null | sort | head -1)
  [ -n "$config" ] && dirname "$config"
}

# configure FOLDER CMAKE-ARGUMENT...: configures only when the arguments or the presets are new; the build handles
# later changes of CMake files.
configure() {
  local folder=$1 stamp=$1/.configured-with
  shift
  if [ ! -e "$folder/build.ninja" ] || [ "$(cat "$stamp" 2>/dev/null)" != "$*" ] || [ CMakePresets.json -nt "$stamp" ]; then
    rm -f "$stamp"
    cmake -S . -B "$folder" -G Ninja "$@" || return
    echo "$*" >"$stamp"
  fi
}

build() { # FOLDER
  cmake --build "$1" -j "$jobs"
}

configure_and_build() { # FOLDER CMAKE-ARGUMENT...
  configure "$@" && build "$1"
}

configure_system_leg() { # FOLDER CMAKE-ARGUMENT...
  local folder=$1 vtk_dir
  shift
  vtk_dir=$(system_vtk_dir) || { echo "no VTK below /usr/lib (Debian: libvtk9-dev)"; return 1; }
  configure "$folder" "-DVTK_DIR=$vtk_dir" -DPython3_EXECUTABLE=/usr/bin/python3 "$@"
}

configure_wheel_leg() { # FOLDER CMAKE-ARGUMENT...
  local folder=$1
  shift
  configure "$folder" "-DVTK_DIR=$(cat build/sdk/vtk-dir)" \
    "-DPython3_EXECUTABLE=$project/build/sdk/venv/bin/python" "$@"
}

build_system_leg() { # FOLDER CMAKE-ARGUMENT...
  configure_system_leg "$@" && build "$1"
}

build_wheel_leg() { # FOLDER CMAKE-ARGUMENT...
  configure_wheel_leg "$@" && build "$1"
}

# Clang's warnings for the core: all but these. Used by script/platforms and by the fuzzers' leg of script/test.
strict=(
  -std=c11 -pedantic -Weverything -Werror
  -Wno-declaration-after-statement        # C99, which the core is
  -Wno-padded                             # the layout of structs is the compiler's business
  -Wno-unsafe-buffer-usage                # about C++
  -Wno-float-equal                        # zero, and the same number, are asked for on purpose
  -Wno-switch-enum -Wno-covered-switch-default # values out of an enumeration's range are input
  -Wno-bad-function-cast                  # (int)floor(x) is meant
  -Wno-keyword-macro                      # water_shared.c reads GLSL as C
  -Wno-unknown-warning-option             # of another version of Clang
)

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds and installs the package, as conda-forge's tools call it: in the folder of the sources, with PREFIX, PYTHON,
# SP_DIR, CPU_COUNT and CMAKE_ARGS in the environment.
set -euo pipefail
# shellcheck disable=SC2086 # CMAKE_ARGS is a list
cmake -S . -B build/conda -G Ninja ${CMAKE_ARGS:-} \
  -DCMAKE_BUILD_TYPE=Release \
  "-DCMAKE_INSTALL_PREFIX=$PREFIX" \
  "-DCMAKE_PREFIX_PATH=$PREFIX" \
  -DCMAKE_INSTALL_LIBDIR=lib \
  "-DPython3_EXECUTABLE=$PYTHON" \
  "-DWATER_PYTHON_DESTINATION=${SP_DIR#"$PREFIX/"}" \
  -DWATER_HARDENED=OFF \
  -DBUILD_TESTING=OFF \
  -DWATER_BUILD_EXAMPLES=OFF
cmake --build build/conda --parallel "${CPU_COUNT:-2}"
cmake --install build/conda

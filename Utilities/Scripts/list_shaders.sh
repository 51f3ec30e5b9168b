#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What water_features.h makes of its lists of shader files: list_shaders.sh files|triples|table, see
# Testing/Core/list_shaders.c, which this compiles and runs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"${CC:-cc}" -std=c11 -IModule/Core/plan -IModule/Core/base \
  Testing/Core/list_shaders.c Module/Core/plan/water_features.c -o "$work/list_shaders"
"$work/list_shaders" "$@"

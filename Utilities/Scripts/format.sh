#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Formats all C and C++ files as .clang-format says; with --check only names those that differ.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

case ${1:-} in
  "") arguments=(-i) ;;
  --check) arguments=(--dry-run --Werror) ;;
  *) echo "usage: format.sh [--check]" >&2; exit 2 ;;
esac
command -v clang-format >/dev/null || { echo "format: no clang-format (Debian: clang-format)" >&2; exit 2; }

find Module ParaView Testing Examples Utilities -type f \( -name '*.h' -o -name '*.c' -o -name '*.cxx' \) \
  -print0 | xargs -0 clang-format "${arguments[@]}"

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Writes the table of the surface's shader files into Documentation/architecture.md, between its two
# marker comments; with --check only tells whether it is another one than water_features.h has.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
case ${1:-} in
  "" | --check) ;;
  *) echo "usage: shader_table.sh [--check]" >&2; exit 2 ;;
esac
page=Documentation/architecture.md
begin='<!-- shader table: Utilities/Scripts/shader_table.sh writes it -->'
end='<!-- end of the shader table -->'
for marker in "$begin" "$end"; do
  [ "$(grep -cxF -e "$marker" "$page")" = 1 ] || { echo "shader_table: $page has not one line \"$marker\""; exit 1; }
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
Utilities/Scripts/list_shaders.sh table >"$work/table"
awk -v begin="$begin" -v end="$end" -v table="$work/table" '
  $0 == end { inside = 0 }
  !inside { print }
  $0 == begin { inside = 1; while ((getline line < table) > 0) print line }' "$page" >"$work/page"
if cmp -s "$work/page" "$page"; then
  echo "shader_table: $page has the table of water_features.h"
elif [ "${1:-}" = --check ]; then
  diff "$page" "$work/page" || true
  echo "shader_table: $page has another table than water_features.h: run Utilities/Scripts/shader_table.sh"
  exit 1
else
  cp "$work/page" "$page"
  echo "shader_table: $page has the table of water_features.h now"
fi

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Checks what keeps the parts apart (see Documentation/architecture.md). Prints every offence.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

failures=0
# forbid WHAT WHY PATTERN FILE...: no line of the files may match the pattern. WHAT is code (strings
# left out) or text (strings are looked at, too); comments never count.
forbid() {
  local what=$1 why=$2 pattern=$3 found
  shift 3
  found=$(awk -v what="$what" -v pattern="$pattern" '
    { line = $0 }
    what == "code" { gsub(/"([^"\\]|\\.)*"/, "", line) }
    { sub(/\/\/.*/, "", line) }
    line ~ pattern { print "  " FILENAME ":" FNR ": " $0 }' "$@")
  if [ -n "$found" ]; then
    printf '%s:\n%s\n' "$why" "$found"
    failures=$((failures + 1))
  fi
}

shopt -s nullglob
core=(Module/Core/*/*.[ch])
shims=(Module/*.cxx Module/*.h Module/Private/*/*.cxx Module/Private/*/*.h)
shaders=(Module/GLSL/*/*.glsl)

forbid text "The core includes neither VTK nor GL" \
  '#include *[<"](vtk|GL/|EGL/)' "${core[@]}"
forbid code "The core allocates nothing and prints nothing" \
  '(^|[^a-z_])(malloc|calloc|realloc|free|printf|fprintf|puts)[(]' "${core[@]}"
forbid code "Formulas belong into the core, shims copy and call" \
  '(sqrt|acos|asin|atan2?|hypot|pow|::Dot|::Cross|::Normalize|[^a-zA-Z]sin|[^a-zA-Z]cos|[^a-zA-Z]tan)[(]' "${shims[@]}"
forbid text "GLSL belongs into Module/GLSL" \
  '"[^"]*(gl_Position|gl_Frag[A-Z]|texture[(]|uniform |void main[(][)]|vec[234][ (])' "${shims[@]}"

found=$(LC_ALL=C grep -n '[^ -~]' "${shaders[@]}" || true)
if [ -n "$found" ]; then
  printf 'Shaders are ASCII without tabs:\n%s\n' "$found"
  failures=$((failures + 1))
fi
for file in "${core[@]}" "${shims[@]}" "${shaders[@]}"; do
  if ! head -2 "$file" | grep -q 'SPDX-License-Identifier: BSD-3-Clause'; then
    echo "No SPDX line at the top of $file"
    failures=$((failures + 1))
  fi
done

[ "$failures" -eq 0 ] || { echo "check_structure: $failures rule(s) broken"; exit 1; }
echo "check_structure: ${#core[@]} files of the core, ${#shims[@]} of the shims, ${#shaders[@]} shaders: all rules kept"

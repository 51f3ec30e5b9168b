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
    { sub(/\/\/.*/, "", line); sub(/^ *\/?\*+([ \/].*)?$/, "", line) }
    line ~ pattern { print "  " FILENAME ":" FNR ": " $0 }' "$@")
  if [ -n "$found" ]; then
    printf '%s:\n%s\n' "$why" "$found"
    failures=$((failures + 1))
  fi
}

shopt -s nullglob
core=(Module/Core/*/*.[ch])
shims=(Module/*.cxx Module/*.h Module/Private/*/*.cxx Module/Private/*/*.h Module/OffScreen/*.cxx Module/OffScreen/*.h)
shaders=(Module/GLSL/*/*.glsl Module/Core/shared/*.glsl)

forbid text "The core includes neither VTK nor GL" \
  '#include *[<"](vtk[^">]*[.]h|GL/|EGL/)' "${core[@]}"
forbid code "The core allocates nothing and prints nothing" \
  '(^|[^a-z_])(malloc|calloc|realloc|aligned_alloc|strn?dup|free|v?f?printf|f?puts|f?putc|putchar)[(]' "${core[@]}"
# All that <cmath> computes, for double, float and long double. Asking (std::isfinite) and choosing (std::min) are
# no formulas. A member of such a name is no function of <cmath>.
computing='(a?(sin|cos|tan)h?|atan2|l?l?abs|fabs|sqrt|cbrt|hypot|pow|exp|exp2|expm1|log|log2|log10|log1p|logb|ilogb'
computing+='|fmod|remainder|remquo|modf|fma|fdim|floor|ceil|trunc|l?l?round|l?l?rint|nearbyint'
computing+='|ldexp|frexp|scalbl?n|nextafter|nexttoward|copysign|lerp|erfc?|[tl]gamma)[fl]?'
forbid code "Formulas belong into the core, shims copy and call" \
  "(^|[^A-Za-z0-9_.>])${computing}[(]|::(Dot|Cross|Norm|Normalize|Floor|Ceil|Round|Distance2?BetweenPoints|Determinant[23]x[23])[(]" "${shims[@]}"
for file in "${shims[@]}"; do
  if grep -qE '#include *<(cmath|math[.]h)>' "$file" && ! grep -qE 'std::is(finite|nan|inf)[(]' "$file"; then
    echo "Formulas belong into the core: $file includes <cmath> and does not need it for std::isfinite"
    failures=$((failures + 1))
  fi
done
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

lengths=$(awk -f Utilities/Scripts/function_lengths.awk "${core[@]}" "${shims[@]}" "${shaders[@]}")
summary=${lengths##*$'\n'} # functions N longest M
long=$(sed '$d' <<<"$lengths")
if [ -n "$long" ]; then
  printf 'A function over 60 lines says why, above it or in its first lines (// Long because ...):\n%s\n' "$long"
  failures=$((failures + 1))
fi
if ! [[ $summary =~ ^functions\ [1-9][0-9]{2,}\  ]]; then
  echo "Hardly a function was found: $summary"
  failures=$((failures + 1))
fi

[ "$failures" -eq 0 ] || { echo "check_structure: $failures rule(s) broken"; exit 1; }
echo "check_structure: ${#core[@]} files of the core, ${#shims[@]} of the shims, ${#shaders[@]} shaders; $summary lines: all rules kept"

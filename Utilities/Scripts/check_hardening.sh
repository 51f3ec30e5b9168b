#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_hardening.sh FOLDER...: whether all libraries and programs in build folders have what
# cmake/WaterHardening.cmake gives them. Prints every file that lacks something.
set -euo pipefail
command -v readelf >/dev/null || { echo "check_hardening: no readelf (Debian: binutils)"; exit 125; }

count=0 guarded=0 failures=0
# lacks FILE WHAT PATTERN TEXT: the text must have a line that matches the pattern
lacks() {
  if ! grep -qE "$3" <<<"$4"; then
    echo "$1 lacks $2"
    failures=$((failures + 1))
  fi
}

while IFS= read -r -d '' file; do
  [ "$(head -c 4 "$file" | tr -d '\0')" = $'\x7fELF' ] || continue
  count=$((count + 1))
  segments=$(readelf -lW "$file")
  lacks "$file" "a stack that is not executable" '^ *GNU_STACK .* RW +0x' "$segments"
  lacks "$file" "relocations that are read-only" '^ *GNU_RELRO ' "$segments"
  lacks "$file" "immediate binding" 'BIND_NOW|FLAGS.*NOW' "$(readelf -dW "$file")"
  if grep -q '__stack_chk_fail' <<<"$(readelf -W --dyn-syms "$file")"; then
    guarded=$((guarded + 1)) # a file without an array on any stack has nothing to guard
  elif [[ $file == *libvtkRenderingWater* ]]; then
    echo "$file lacks checked stack frames"
    failures=$((failures + 1))
  fi
done < <(find "$@" -type f \( -name '*.so*' -o -perm -u+x \) -print0)

[ "$count" -gt 0 ] || { echo "check_hardening: no library or program in $*"; exit 1; }
[ "$failures" -eq 0 ] || { echo "check_hardening: $failures lack(s) in $count files"; exit 1; }
echo "check_hardening: $count files, $guarded with checked stack frames: nothing lacks"

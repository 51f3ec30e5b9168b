# SPDX-License-Identifier: BSD-3-Clause
# Prints every function over 60 lines, from its brace to its brace, that does not say why above it or in
# its first lines ("// Long because ..."), then a line "functions N longest M". For C, C++ and GLSL as
# clang-format leaves them: a body lies between lines { and } in the first column, or in the third for a
# method written inside its class. Braces of namespaces, types and lists are not a function's.
BEGIN { most = 60 }
FNR == 1 { start[0] = start[2] = before = ""; in_type = opened = 0; why = 0 }
/^ *\/\/ Long because [^ ]/ {
  why = 1
  for (column in start)
    if (start[column] != "" && FNR - start[column] <= 3) excused[column] = 1
}
/^\{$/ || (/^  \{$/ && in_type) {
  column = /^\{/ ? 0 : 2
  type = "^ *(template.*> *)?(typedef )?(class|struct|union|enum|namespace|extern \"C\")"
  is_type = (head ~ type || before ~ type || before ~ /=$/) && before !~ /\)( const)?$/
  if (column == 0) in_type = is_type && head !~ /^(namespace|extern)/
  start[column] = is_type ? "" : FNR
  excused[column] = why
  named[column] = head
}
/^\};?$/ || (/^  \};?$/ && in_type) {
  column = /^\}/ ? 0 : 2
  if (start[column] != "" && /\}$/) { # a type ends with };
    lines = FNR - start[column] + 1
    count++
    if (lines > longest) longest = lines
    if (lines > most && !excused[column])
      printf "  %s:%d: %d lines: %s\n", FILENAME, start[column], lines, named[column]
  }
  start[column] = ""
  if (column == 0) in_type = 0
}
/^ *(\/\/|(public|protected|private):)/ { next } # no part of a head
/^$/ || /[;}]$/ { if ($0 !~ /^ *\{$/) { why = 0; head = ""; before = ""; next } }
{
  if (head == "" && $0 !~ /^[ ]*[{#]/) head = $0
  if ($0 !~ /^ *\{$/) before = $0
  else head = ""
}
END { printf "functions %d longest %d\n", count, longest }

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Uniforms are set by name, and GL says nothing about a wrong one. So every uniform of a shader has to
# be named by C++ that sets it, and every name "water..." in C++ has to be declared by a shader: as a
# uniform, an attribute or a function. Prints every offence.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
shims=(Module/*.cxx Module/*.h Module/Private/*/*.cxx Module/Private/*/*.h)
shaders=(Module/GLSL/*/*.glsl Module/Core/shared/*.glsl)

awk '
  { sub(/\/\/.*/, ""); gsub(/\/\*[^*]*\*\//, "") } # comments, but no string of ours has two slashes
  FILENAME ~ /[.]glsl$/ {
    line = $0
    sub(/^layout *\([^)]*\) */, "", line)
    gsub(/(highp|mediump|lowp|flat|smooth) /, "", line)
    if (line ~ /^(uniform|in|out) .*;/)
    {
      kind = line
      sub(/ .*/, "", kind)
      sub(/;.*/, "", line)
      sub(/^[a-z]+ +[A-Za-z0-9]+ +/, "", line)
      gsub(/\[[^\]]*\]|,/, " ", line)
      count = split(line, names, " ")
      for (i = 1; i <= count; ++i)
      {
        if (kind == "in" && names[i] ~ /VSOutput$/) received[names[i]] = FILENAME ":" FNR
        if (kind == "out") { sent[names[i]] = 1; continue }
        declared[names[i]] = 1
        if (kind == "uniform" && !(names[i] in uniform)) uniform[names[i]] = FILENAME ":" FNR
      }
    }
    else if (match($0, /^[a-z][a-zA-Z0-9]* water[A-Za-z0-9]*\(/))
    {
      name = substr($0, RSTART, RLENGTH - 1)
      sub(/.* /, "", name)
      declared[name] = 1
    }
    next
  }
  {
    rest = $0
    while (match(rest, /"water[A-Z][A-Za-z0-9]*"/))
    {
      name = substr(rest, RSTART + 1, RLENGTH - 2)
      before = substr(rest, 1, RSTART - 1)
      rest = substr(rest, RSTART + RLENGTH)
      if (!(name in named)) named[name] = FILENAME ":" FNR
      if (before !~ /IsUniformUsed\($/) set[name] = 1
    }
  }
  END {
    for (name in uniform)
    {
      ++uniforms
      if (!(name in set)) { print uniform[name] ": nobody sets the uniform " name; ++failures }
    }
    for (name in named)
      if (!(name in declared)) { print named[name] ": no shader declares " name; ++failures }
    for (name in received)
      if (!(name in sent)) { print received[name] ": no vertex shader has the output " name; ++failures }
    if (failures) { print "check_uniforms: " failures " name(s) without a partner"; exit 1 }
    print "check_uniforms: " uniforms " uniforms, each declared and set"
  }' "${shaders[@]}" "${shims[@]}"

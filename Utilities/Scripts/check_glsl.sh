#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Compiles as GLSL 1.50, with glslangValidator (Debian: glslang-tools): the surface's shader in combinations
# of files that a look can ask for (list_shaders.sh; with the files of a user's mesh, a peel and a dome, in
# enough of them), and all other shaders.
#
#   check_glsl.sh        enough combinations to have every three files together that any has
#   check_glsl.sh --all  every combination; takes two minutes
#
# They are pieces that VTK's shaders take in. What VTK provides around them is written down here: the
# version, the names they use, and a main where they have none.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
case ${1:-} in
  '') choice=triples ;;
  --all) choice=files ;;
  *) echo "usage: check_glsl.sh [--all]" >&2; exit 2 ;;
esac
command -v glslangValidator >/dev/null || { echo "check_glsl: no glslangValidator (Debian: glslang-tools)" >&2; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

files=(Module/Core/shared/*.glsl Module/GLSL/*/*[!S].glsl Module/GLSL/*/*S.glsl) # parts of others come first
printf '%s\n' "${files[@]}" >"$work/files"
Utilities/Scripts/list_shaders.sh "$choice" >"$work/list"

# Each line of the list becomes a file, STAGE and features in its name. A piece that no line has, and
# that nobody includes, stands alone.
awk -v work="$work" '
  FILENAME ~ /files$/ { # its number stands in front of the line in messages
    name = $0
    sub(/.*\//, "", name)
    sub(/[.]glsl$/, "", name)
    number[name] = FNR
    path[name] = $0
    text = "#line 0 " FNR "\n"
    while ((getline line < $0) > 0)
    {
      if (line ~ /^#include "/)
      {
        split(line, part, "\"")
        sub(/[.]glsl$/, "", part[2])
        is_part[part[2]] = 1
        line = "//" line "\n" content[part[2]] # those that are included stand first in the list
      }
      gsub(/gl_FragData\[0\]/, "fragOutput0", line) # VTK makes such an output of it
      text = text line "\n"
    }
    content[name] = text
    next
  }
  function compile(stage, features, text,   to) {
    to = work "/" features "." stage
    print "#version 150" > to
    if (stage == "frag") print "out vec4 fragOutput0;" > to
    print text > to
    close(to)
  }
  {
    text = ""
    for (i = 3; i <= NF; ++i)
    {
      if (!($i in content)) { print "water_features.h names " $i ", and there is no such file"; failed = 1 }
      text = text content[$i]
      is_part[$i] = 1
    }
    compile($1, (text ~ /void main\(/ ? "photon-" : "combination-") $2, text ~ /void main\(/ ? text : text "void main()\n{\n" ($1 == "frag" ? \
      "  vec4 color = vec4(0.0);\n  waterShade(color);\n  fragOutput0 = color;\n}" : \
      "  vec4 position = vec4(1.0);\n" \
      (text ~ /waterDisplace/ ? "  waterDisplace(position);\n" : "  waterMeasure(position);\n") \
      "  gl_Position = position;\n}"))
  }
  END {
    volume = "uniform mat4 in_modelViewMatrix, in_inverseModelViewMatrix;\n" \
      "uniform mat4 in_volumeMatrix[1];\n" \
      "uniform mat4 in_textureDatasetMatrix[1], in_inverseTextureDatasetMatrix[1];\n" \
      "uniform mat4 in_inverseVolumeMatrix[1], in_cellToPoint[1];\n" \
      "uniform vec3 in_texMin[1], in_texMax[1];\n" \
      "vec3 g_rayOrigin, g_rayTermination, g_rayJitter, g_dataPos, g_terminatePos, g_dirStep;\n" \
      "float g_terminatePointMax;\n" # the globals of its ray caster
    for (name in content)
      if (!(name in is_part))
        compile(name ~ /VS$/ ? "vert" : "frag", name, (name == "vtkWaterVolumeFS" ? volume : "") content[name] \
          (content[name] ~ /void main\(\)/ ? "" : "void main() {}"))
    exit failed
  }' "$work/files" "$work/list"

shaders=("$work"/*.frag "$work"/*.vert)
if ! glslangValidator "${shaders[@]}" >"$work/log"; then
  # the same line fails in many combinations
  awk -v names="$(tr '\n' ' ' <"$work/files")" '
    BEGIN { split(names, path, " ") }
    /^ERROR: [0-9]+:[0-9]+: / {
      split($2, at, ":")
      sub(/^ERROR: [0-9:]+/, path[at[1]] ":" at[2] ":")
      if (!seen[$0]++) print
    }' "$work/log" | sort | head -40
  grep -c '^ERROR: .*compilation errors' "$work/log" |
    sed "s/\$/ of ${#shaders[@]} shaders do not compile/; s/^/check_glsl: /"
  exit 1
fi
echo "check_glsl: ${#shaders[@]} shaders of ${#files[@]} files compile as GLSL 1.50"

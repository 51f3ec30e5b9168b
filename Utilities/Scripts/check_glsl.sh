#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Compiles every shader of Module/GLSL as GLSL 1.50 with glslangValidator (Debian: glslang-tools).
#
# They are pieces that VTK's shaders take in. What VTK provides around them is written down here, so
# that a piece compiles alone: the version, the names it uses, and an empty main where it has none.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
command -v glslangValidator >/dev/null || { echo "check_glsl: no glslangValidator (Debian: glslang-tools)" >&2; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# needed NAME: the pieces that NAME builds on, and those that they do, each once and in order. A piece
# says so in its head: "Needs vtkWaterOptics.glsl and vtkWaterPointFS.glsl before it".
needed() {
  local piece
  for piece in $(sed '/^\/\//!{/./q}' Module/GLSL/*/"$1.glsl" | tr -d '\n/' |
    sed 's/^.*Needs //; t; d' | sed 's/ before.*//' | grep -oE 'vtkWater[A-Za-z]+\.glsl'); do
    needed "${piece%.glsl}"
    echo "$piece"
  done | awk '!seen[$0]++'
}

# prelude NAME: what VTK and other pieces have declared before the piece NAME.
prelude() {
  local piece
  echo "#version 150"
  if [[ $1 != *VS ]]; then
    echo "out vec4 fragOutput0;" # VTK makes such an output of gl_FragData[0]
  fi
  for piece in $(needed "$1"); do
    cat Module/GLSL/*/"$piece"
  done
  if [ "$1" = vtkWaterVolumeFS ]; then # the globals of VTK's ray caster
    cat <<'GLSL'
uniform mat4 in_modelViewMatrix, in_inverseModelViewMatrix;
uniform mat4 in_volumeMatrix[1];
uniform mat4 in_textureDatasetMatrix[1], in_cellToPoint[1];
vec3 g_rayOrigin, g_rayTermination, g_rayJitter, g_dataPos, g_terminatePos, g_dirStep;
float g_terminatePointMax;
GLSL
  fi
}

failures=0
count=0
for file in Module/GLSL/*/*.glsl; do
  name=$(basename "$file" .glsl)
  stage=frag
  [[ $name == *VS ]] && stage=vert
  {
    prelude "$name"
    echo "#line 1"
    sed 's/gl_FragData\[0\]/fragOutput0/' "$file"
    grep -q 'void main()' "$file" || echo "void main() {}"
  } >"$work/$name.$stage"
  count=$((count + 1))
  if ! glslangValidator "$work/$name.$stage" >"$work/log" 2>&1; then
    echo "$file does not compile (line numbers are the file's):"
    sed "s|$work/||" "$work/log"
    failures=$((failures + 1))
  fi
done
[ "$failures" -eq 0 ] || { echo "check_glsl: $failures of $count shaders fail"; exit 1; }
echo "check_glsl: $count shaders compile as GLSL 1.50"

#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Does the plugin compile against the ParaView of other Debian suites? Their packages cannot be installed here, but
# their headers can be used: what the C++ files say is compiled, and nothing is linked or run.
#
#   check_headers.sh SUITE...    trixie (ParaView 5.13), testing (6.1); downloads 11 to 12 MB a suite
#
# WATER_DEBIAN_MIRROR: instead of deb.debian.org. Exit status 1: something does not compile.
set -euo pipefail
project=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
mirror=${WATER_DEBIAN_MIRROR:-http://deb.debian.org/debian}
[ $# -gt 0 ] || { echo "usage: check_headers.sh SUITE..." >&2; exit 2; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
version=$(sed -nE 's/^project\(vtkWater VERSION ([0-9.]+).*/\1/p' "$project/CMakeLists.txt")

unpack() { # SUITE PACKAGE: prints its version
  awk -v package="$2" 'BEGIN { RS = ""; FS = "\n" }
    $1 == "Package: " package { for (i = 2; i <= NF; ++i) if ($i ~ /^(Version|Filename):/) print $i }' \
    "$folder/$1.packages" >"$folder/found"
  curl -sf --max-time 300 -o "$folder/package.deb" "$mirror/$(sed -n 's/^Filename: //p' "$folder/found")"
  dpkg -x "$folder/package.deb" "$folder/$1"
  sed -n 's/^Version: //p' "$folder/found"
}

# what CMake would write
mkdir "$folder/made"
echo '#define VTKWATERREPRESENTATIONS_EXPORT' >"$folder/made/vtkWaterRepresentationsModule.h"
echo '#define VTKRENDERINGWATER_EXPORT' >"$folder/made/vtkRenderingWaterModule.h"
status=0
for suite in "$@"; do
  curl -sf --max-time 300 "$mirror/dists/$suite/main/binary-amd64/Packages.xz" | xz -dc >"$folder/$suite.packages"
  echo "$suite: paraview-dev $(unpack "$suite" paraview-dev)"
  if ! compgen -G "$folder/$suite/usr/include/paraview-*/vtkObject.h" >/dev/null; then
    echo "$suite: libvtk9-dev $(unpack "$suite" libvtk9-dev)" # this ParaView has no VTK of its own
  fi
  includes=()
  for include in "$folder/$suite"/usr/include/*/; do includes+=(-isystem "$include"); done
  for file in "$project"/ParaView/Plugin/Representations/*.cxx; do
    if c++ -fsyntax-only -std=c++17 -DVTK_DEPRECATION_LEVEL=0 "-DWATER_PLUGIN_VERSION=\"$version\"" \
      -I"$folder/made" "${includes[@]}" -I"$project/Module" -I"$project/Module/Core/base" \
      -I"$project/Module/Core/plan" "$file"; then
      echo "$suite: $(basename "$file") compiles"
    else
      status=1
    fi
  done
done
exit $status

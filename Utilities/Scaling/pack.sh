#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Packs what measuring ranks on the GPUs of a machine without network, VTK, MPI and compiler needs:
#
#   pack.sh BUILD OUT      OUT/gpus.tar.xz   bin/RankDevices  of BUILD, a build of the module with PyPI's VTK
#                                            lib              the module, what it needs of VTK, and the
#                                                             loaders of OpenGL (libglvnd), no driver
#
# The machine brings Linux on x86-64 with glibc, and a driver with EGL. Read by script/scaling --gpus.
set -euo pipefail
project=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
limit_mb=55 # what may travel there is 67, the checkout included

say() { echo "scaling-pack: $*"; }
die() { echo "scaling-pack: $*" >&2; exit 3; }

[ $# = 2 ] || die "usage: pack.sh BUILD OUT"
build=$(cd "$1" && pwd)
out=$(mkdir -p "$2" && cd "$2" && pwd)
for tool in readelf strip xz tar apt-get dpkg-deb; do
  command -v "$tool" >/dev/null || die "$tool is missing (Debian: apt-get install binutils xz-utils tar dpkg)"
done
[ -x "$build/bin/RankDevices" ] || die "no $build/bin/RankDevices: its VTK has no module RenderingParallel"

source=$("$project/build/sdk/venv/bin/python" -c \
  "import pathlib, vtkmodules; print(pathlib.Path(vtkmodules.__file__).parent)")
pack=$(mktemp -d)
trap 'rm -rf "$pack"' EXIT
mkdir "$pack/bin" "$pack/lib"
needed_by() { readelf -d "$1" | sed -nE 's/.*NEEDED.*\[(.*)\]/\1/p'; }
find_library() { # NAME: of the module's build, or of VTK's wheel
  local candidate
  for candidate in "$build"/lib*/"$1" "$source/$1"; do
    if [ -e "$candidate" ]; then
      echo "$candidate"
      return
    fi
  done
}
add() { # a program or a library, and all that it needs
  local needed from
  for needed in $(needed_by "$1"); do
    from=$(find_library "$needed")
    if [ -n "$from" ] && [ ! -e "$pack/lib/$needed" ]; then
      cp -L "$from" "$pack/lib/$needed"
      add "$from"
    fi
  done
}
cp "$build/bin/RankDevices" "$pack/bin/"
add "$build/bin/RankDevices"
strip --strip-unneeded "$pack"/bin/* "$pack"/lib/*

debs=$pack/debs
mkdir "$debs"
(cd "$debs" && apt-get -qq download libegl1 libglvnd0 libopengl0 libgl1 libglx0) || die "apt cannot download libegl1"
for package in "$debs"/*.deb; do dpkg-deb -x "$package" "$debs/root"; done
find "$debs/root/usr/lib" \( -name 'libEGL.so*' -o -name 'libGL.so*' -o -name 'libGLX.so*' -o -name 'libGLdispatch.so*' \
  -o -name 'libOpenGL.so*' \) -exec cp -P {} "$pack/lib/" \;
rm -rf "$debs"

tar -C "$pack" -cf - bin lib | xz -T0 --x86 --lzma2=preset=5,dict=64MiB >"$out/gpus.tar.xz.part"
mv "$out/gpus.tar.xz.part" "$out/gpus.tar.xz"
size_mb=$(($(stat -c %s "$out/gpus.tar.xz") / 1000000))
say "$out/gpus.tar.xz: $size_mb MB, $(find "$pack/lib" -type f | wc -l) libraries"
[ "$size_mb" -lt "$limit_mb" ] || die "that is more than the $limit_mb MB that travel"

# Is it complete? VTK and the module are found in the pack alone.
strange=$(LD_LIBRARY_PATH=$pack/lib ldd "$pack/bin/RankDevices" | grep -iE 'vtk|not found' | grep -vF "=> $pack/" || true)
[ -z "$strange" ] || die "RankDevices wants libraries that are not in the pack:
$strange"

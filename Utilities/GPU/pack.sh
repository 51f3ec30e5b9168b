#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Packs all that rendering water on a machine without a network needs, beside this folder's checkout:
#
#   pack.sh OUT      OUT/pack.tar.xz   site/vtkmodules  what our Python code imports of PyPI's vtk, and
#                                                       whatever that needs
#                                      site/vtkwater    this module, built for that vtk
#                                      site/embreex     and flip_evaluator: what the accuracy suite needs
#                                      bin              the C++ tests of it
#                                      gl               the loaders of OpenGL (libglvnd), no driver
#                    OUT/sdk           a Python with vtk and numpy, and the SDK (Utilities/WheelSDK)
#                    OUT/wheel312      the build of the module
#
# The machine brings Linux on x86-64, a Python of the same version with numpy, and a driver with EGL;
# the tests want pytest as well. Read by script/gpu, which runs things there.
#
# The archive is two xz streams, one after the other: `tar --ignore-zeros -xJf`. VTK's takes a minute
# to compress, is hardly ever another one, and so is kept.
#
# Settings from the environment:
#   WATER_GPU_PYTHON  a Python with headers, of the version that the machine has (default: a python3.12)
# and those of Utilities/WheelSDK/assemble.sh.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
project=$(cd "$here/../.." && pwd)
version=3.12
limit_mb=55 # what may travel there is 67, the checkout included

say() { echo "gpu-pack: $*"; }
die() { echo "gpu-pack: $*" >&2; exit 3; }

[ $# = 1 ] || die "usage: pack.sh OUT"
out=$(mkdir -p "$1" && cd "$1" && pwd)

for tool in cmake ninja c++ readelf strip xz tar dpkg-deb; do
  command -v "$tool" >/dev/null ||
    die "$tool is missing (Debian: apt-get install cmake ninja-build g++ binutils xz-utils tar dpkg)"
done

# is_good PYTHON: it runs, is of the version, and something can be built for it.
is_good() {
  "$1" -c "
import os, sys, sysconfig, venv, ensurepip
wanted = os.environ.get('WATER_GPU_PYTHON') or '%d.%d' % sys.version_info[:2] == '$version'
sys.exit(not (wanted and os.path.exists(sysconfig.get_paths()['include'] + '/Python.h')))" 2>/dev/null
}
python=
usual=("python$version" "${HOME:-}"/.pyenv/versions/"$version".*/bin/"python$version" python3)
[ -z "${WATER_GPU_PYTHON:-}" ] || usual=("$WATER_GPU_PYTHON")
for candidate in "${usual[@]}"; do
  if is_good "$candidate"; then
    python=$(command -v "$candidate")
    break
  fi
done
[ -n "$python" ] || die "no Python $version with headers and venv: WATER_GPU_PYTHON names one (Ubuntu 24.04:
  apt-get install python3-dev python3-venv; elsewhere: pyenv install $version)"
version=$("$python" -c "import sys; print('%d.%d' % sys.version_info[:2])")

# VTK and its SDK. The stamp holds what made it.
made_with=$(cat "$project"/Utilities/WheelSDK/{assemble.sh,make_sdk.py} <("$python" -VV) | sha256sum)
if [ "$(cat "$out/sdk/.made-with" 2>/dev/null)" != "$made_with" ]; then
  rm -rf "$out/sdk" "$out/wheel312"
  WATER_PYTHON=$python bash "$project/Utilities/WheelSDK/assemble.sh" "$out/sdk"
  echo "$made_with" >"$out/sdk/.made-with"
fi

# Our module, laid out as in its wheel (pyproject.toml): all in one folder beside VTK's.
say "building the module"
log=$out/build.log
{
  cmake -S "$project" -B "$out/wheel312" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    "-DVTK_DIR=$(cat "$out/sdk/vtk-dir")" "-DPython3_EXECUTABLE=$out/sdk/venv/bin/python" \
    -DBUILD_TESTING=ON -DWATER_CORE_TESTS=OFF -DWATER_BUILD_EXAMPLES=OFF -DCMAKE_INSTALL_LIBDIR=vtkwater \
    -DWATER_PYTHON_DESTINATION=. '-DWATER_INSTALL_RPATH=$ORIGIN;$ORIGIN/../vtkmodules' &&
    cmake --build "$out/wheel312" -j "$(nproc)" &&
    rm -rf "$out/own" &&
    for component in python runtime; do
      cmake --install "$out/wheel312" --prefix "$out/own/site" --component "$component" --strip || exit
    done &&
    install -D -s -t "$out/own/bin" "$out/wheel312/bin/vtkRenderingWaterCxxTests"
} >"$log" 2>&1 || { tail -n 30 "$log"; die "the module cannot be built; all of it: $log"; }
# The ray tracer and the measure of pictures of the accuracy suite; its plots are not made there.
grep -v matplotlib "$project/Utilities/Accuracy/requirements.txt" >"$out/requirements.txt"
"$out/sdk/venv/bin/python" -m pip --disable-pip-version-check install -q --no-deps --no-compile \
  --target "$out/own/site" -r "$out/requirements.txt" || die "pip cannot install what the accuracy suite needs"
find "$out/own/site" -name '*.so*' -path '*embree*' -exec strip --strip-unneeded {} +
rm -rf "$out/own/site/bin" # the command vtkwater: python3 -m vtkwater is as good
echo "$version" >"$out/own/python-version"

# The part of VTK. What our code imports is asked of the code; what that needs, of the libraries.
source=$("$out/sdk/venv/bin/python" -c "import pathlib, vtkmodules; print(pathlib.Path(vtkmodules.__file__).parent)")
needed_by() { readelf -d "$1" | sed -nE 's/.*NEEDED.*\[(.*)\]/\1/p'; }
imported=" vtkFiltersPython" # vtkmodules.util.vtkAlgorithm imports it
for name in $(cd "$project" && grep -rhoE --include='*.py' --include='*.py.in' 'vtkmodules\.vtk[A-Za-z0-9]+' \
  Testing Utilities Module/Python Examples | sed 's/.*\.//' | sort -u); do
  if compgen -G "$source/$name.*so" >/dev/null; then
    imported+=" $name"
  else
    say "not in PyPI's VTK: $name"
  fi
done
own_needs=$(for library in "$out"/own/site/vtkwater/*.so* "$out"/own/bin/*; do needed_by "$library"; done | sort -u)

declare -A taken
add() { # a library of the wheel, and all that it needs
  [ -z "${taken[$1]:-}" ] && [ -e "$source/$1" ] || return 0
  taken[$1]=1
  local needed
  for needed in $(needed_by "$source/$1"); do add "$needed"; done
}
for name in $imported; do add "lib$name.so"; done
for name in $own_needs; do add "$name"; done
for library in "${!taken[@]}"; do # its Python side, which imports those of the libraries it needs
  name=${library#lib}
  for wrapper in "$source/${name%.so}".cpython-*.so; do
    [ -e "$wrapper" ] && add "$(basename "$wrapper")"
  done
done

how=$(sed -n '/^# The part of VTK/,/^tar /p' "$0") # the archive is another one when this text is
stamp=$("$out/sdk/venv/bin/python" -m pip list 2>/dev/null | grep '^vtk ' |
  cat - <(printf '%s\n' "${!taken[@]}" | sort) <(echo "$how") | sha256sum)
if [ "$(cat "$out/vtk.stamp" 2>/dev/null)" != "$stamp" ]; then
  say "VTK: ${#taken[@]} libraries"
  rm -rf "$out/vtk"
  mkdir -p "$out/vtk/site/vtkmodules"
  for library in "${!taken[@]}"; do cp "$source/$library" "$out/vtk/site/vtkmodules/"; done
  cp "$source/__init__.py" "$out/vtk/site/vtkmodules/"
  cp -r "$source/util" "$out/vtk/site/vtkmodules/"
  find "$out/vtk" -name __pycache__ -prune -exec rm -r {} +
  strip --strip-unneeded "$out"/vtk/site/vtkmodules/*.so

  # The loaders: Debian's packages, unpacked; without apt this machine's own.
  mkdir -p "$out/vtk/gl" "$out/debs"
  loaders='libEGL.so* libGL.so* libGLX.so* libGLdispatch.so* libOpenGL.so*'
  if (cd "$out/debs" && apt-get -qq download libegl1 libglvnd0 libopengl0 libgl1 libglx0) 2>/dev/null; then
    for package in "$out"/debs/*.deb; do dpkg-deb -x "$package" "$out/debs/root"; done
    folders=$out/debs/root/usr/lib
  else
    folders=$(ldconfig -p | sed -nE 's/.*libEGL\.so\.1 .*x86-64.*=> (.*)\/[^/]*/\1/p' | head -1)
    [ -n "$folders" ] || die "no loaders of OpenGL: apt cannot download libegl1, nor is it installed here"
  fi
  for pattern in $loaders; do
    find "$folders" -name "$pattern" -exec cp -P {} "$out/vtk/gl/" \;
  done
  rm -rf "$out/debs"

  say "compressing them, which takes a minute"
  tar -C "$out/vtk" -cf - site gl | xz -T0 --x86 --lzma2=preset=6,dict=64MiB >"$out/vtk.tar.xz"
  rm -rf "$out/vtk"
  echo "$stamp" >"$out/vtk.stamp"
fi

tar -C "$out/own" -cf - site bin python-version | xz -T0 -6 | cat "$out/vtk.tar.xz" - >"$out/pack.tar.xz.part"
mv "$out/pack.tar.xz.part" "$out/pack.tar.xz"
size_mb=$(($(stat -c %s "$out/pack.tar.xz") / 1000000))
say "$out/pack.tar.xz: $size_mb MB, for Python $version"
[ "$size_mb" -lt "$limit_mb" ] || die "that is more than the $limit_mb MB that travel"

# Is it complete? All that our code imports is imported, from the pack alone.
there=$(mktemp -d)
trap 'rm -rf "$there"' EXIT
tar -C "$there" --ignore-zeros -xJf "$out/pack.tar.xz"
base=$("$python" -c "import sys; print(sys._base_executable)")
# shellcheck disable=SC2086  a name a word
env -i "PYTHONPATH=$there/site" "LD_LIBRARY_PATH=$there/gl" VTK_WATER_OFFSCREEN=0 "$base" -s -c '
import importlib, sys
for name in sys.argv[2:]:
    importlib.import_module("vtkmodules." + name)
import vtkwater
with open("/proc/self/maps") as maps:
    files = {line.split()[-1] for line in maps if "vtk" in line}
strange = sorted(file for file in files if not file.startswith(sys.argv[1]))
sys.exit("from elsewhere: %s" % strange if strange else 0)
' "$there" $imported || die "the pack is not complete (above)"
libraries=$(LD_LIBRARY_PATH=$there/site/vtkwater:$there/site/vtkmodules ldd "$there"/bin/*)
strange=$(grep -i vtk <<<"$libraries" | grep -vF "=> $there/" || true)
[ -z "$strange" ] || die "the C++ tests want libraries that are not in the pack:
$strange"

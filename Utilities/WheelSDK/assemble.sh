#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes what a build against PyPI's vtk wheel needs: a Python with that wheel, and an SDK for it.
#
#   assemble.sh OUT     OUT/venv       a virtual environment with vtk and numpy
#                       OUT/vtk-dir    a file that holds the folder to give as VTK_DIR
#                       OUT/dist       (not with Kitware's SDK) a wheel vtk_sdk, for pyproject builds
#
# See README.md. Settings from the environment:
#   WATER_PYTHON         the Python to make the environment with (default: /usr/bin/python3)
#   WATER_DEBIAN_MIRROR  a Debian mirror (default: the one in this machine's apt sources)
#   WATER_DEBIAN_SUITE   the suite whose libvtk9-dev is taken (default: forky)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

# The VTK that this project is tested with. A newer 9.6.x is taken where the suite has moved on: the
# wheel of the same version is then on PyPI, too.
pinned=9.6.2

say() { echo "wheel-sdk: $*"; }
die() { echo "wheel-sdk: $*" >&2; exit 3; }
# retry COMMAND...: mirrors and registries fail now and then.
retry() {
  local n
  for n in 1 2 3; do
    "$@" && return 0
    [ "$n" = 3 ] || { say "failed, trying again: $1 ..."; sleep $((n * 5)); }
  done
  return 1
}

[ $# = 1 ] || die "usage: assemble.sh OUT"
out=$(mkdir -p "$1" && cd "$1" && pwd)
suite=${WATER_DEBIAN_SUITE:-forky}
[ "$(uname -m)" = x86_64 ] || die "only for x86_64: on $(uname -m) build VTK $pinned yourself and give its VTK_DIR"

python=${WATER_PYTHON:-/usr/bin/python3}
[ -x "$out/venv/bin/python" ] || "$python" -m venv "$out/venv" ||
  die "$python cannot make a virtual environment (Debian: apt-get install python3-venv)"
pip=("$out/venv/bin/python" -m pip --disable-pip-version-check -q)

# Kitware's own SDK, where it exists for this platform.
if "${pip[@]}" download --no-deps --only-binary=:all: -d "$out/sdk" "vtk-sdk==$pinned" >/dev/null 2>&1; then
  retry "${pip[@]}" install "vtk==$pinned" "vtk-sdk==$pinned" numpy || die "pip cannot install vtk $pinned"
  config=$(find "$out/venv" -path '*vtk_sdk*' -name vtk-config.cmake | tail -1)
  [ -n "$config" ] || die "the vtk-sdk wheel has no vtk-config.cmake"
  dirname "$config" >"$out/vtk-dir"
  say "VTK $pinned with Kitware's SDK"
  exit 0
fi

# Else Debian's headers. An apt of our own: another suite, and the machine's state stays as it is.
# Signatures are checked; age is not, as a mirror that lags behind serves us as well.
mirror=${WATER_DEBIAN_MIRROR:-$(sed -nE 's/^URIs: *//p; s/^deb +(\[[^]]*\] +)?([^ ]+) .*/\2/p' \
  /etc/apt/sources.list.d/*.sources /etc/apt/sources.list /etc/apt/sources.list.d/*.list 2>/dev/null |
  grep -m1 "/debian/*$" || true)}
[ -n "$mirror" ] || die "no Debian mirror in this machine's apt sources; name one: WATER_DEBIAN_MIRROR=URL"
state=$out/apt
mkdir -p "$state/lists/partial" "$out/debs"
keyring=/usr/share/keyrings/debian-archive-keyring.gpg
[ -e "$keyring" ] || keyring=
echo "deb ${keyring:+[signed-by=$keyring] }$mirror $suite main" >"$state/sources.list"
apt_options=(-oDir::Etc::sourcelist="$state/sources.list" -oDir::Etc::sourceparts=/dev/null
  -oDir::State::Lists="$state/lists" -oDir::Cache::pkgcache="$state/pkg"
  -oDir::Cache::srcpkgcache="$state/src" -oAPT::Sandbox::User=root -oAcquire::Retries=3
  -oAcquire::Check-Valid-Until=false)
retry apt-get "${apt_options[@]}" -qq update ||
  die "no package lists of Debian $suite from $mirror; WATER_DEBIAN_MIRROR names another mirror"
version=$(apt-cache "${apt_options[@]}" show libvtk9-dev 2>/dev/null |
  sed -nE 's/^Version: ([0-9]+\.[0-9]+\.[0-9]+).*/\1/p' | head -1)
case $version in
  "$pinned") ;;
  "${pinned%.*}".*) say "Debian $suite has moved on from VTK $pinned to $version, which is taken" ;;
  *) die "Debian $suite has VTK ${version:-none}, wanted is ${pinned%.*}.x (another suite: WATER_DEBIAN_SUITE)" ;;
esac

say "VTK $version: the wheel from PyPI"
retry "${pip[@]}" install "vtk==$version" numpy || die "pip cannot install vtk $version"
say "VTK $version: headers and tools from Debian $suite"
(cd "$out/debs" && rm -f ./*.deb && retry apt-get "${apt_options[@]}" -qq download \
  libvtk9-dev "libvtk${version%.*}" vtk9 python3-vtk9 libc6) ||
  die "Debian's packages cannot be downloaded"
"$out/venv/bin/python" "$here/make_sdk.py" --python "$out/venv/bin/python" \
  --debs "$out/debs" --prefix "$out/prefix" --wheel "$out/dist" ||
  die "the SDK cannot be assembled"
rm -rf "$out/debs" "$state" # 190 MB
echo "$out/prefix/lib/cmake/vtk-${version%.*}" >"$out/vtk-dir"
say "VTK $version is ready"

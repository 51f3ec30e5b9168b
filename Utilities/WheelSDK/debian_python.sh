#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Unpacks a CPython of a newer Debian suite, so that wheels for it can be built and tested on this machine.
#
#   debian_python.sh VERSION OUT     debian_python.sh 3.14 build/python-3.14
#
# Prints the program's path, OUT/usr/bin/python3.14. Nothing is installed: OUT can be deleted.
# That Python runs with its own C library, from OUT. What it builds is compiled by this machine's compiler against
# this machine's C library, so the wheels keep the manylinux tag of this machine.
# PATCHELF names the program patchelf. Settings: WATER_DEBIAN_MIRROR, WATER_DEBIAN_SUITE, as for assemble.sh.
# Exit status 3, with the reason: the suite has no such Python.
set -euo pipefail

die() { echo "debian-python: $*" >&2; exit 3; }

[ $# = 2 ] || die "usage: debian_python.sh VERSION OUT"
version=$1
out=$(mkdir -p "$2" && cd "$2" && pwd)
program=$out/usr/bin/python$version
[ ! -e "$out/.made" ] || { echo "$program"; exit 0; }
[ "$(uname -m)" = x86_64 ] || die "only for x86_64, this is $(uname -m)"
command -v apt-get >/dev/null && command -v dpkg-deb >/dev/null || die "needs apt-get and dpkg-deb"

# An apt of our own that knows of no installed package, as in assemble.sh: the machine's state stays as it is.
suite=${WATER_DEBIAN_SUITE:-forky}
mirror=${WATER_DEBIAN_MIRROR:-$(sed -nE 's/^URIs: *//p; s/^deb +(\[[^]]*\] +)?([^ ]+) .*/\2/p' \
  /etc/apt/sources.list.d/*.sources /etc/apt/sources.list /etc/apt/sources.list.d/*.list 2>/dev/null |
  grep -m1 "/debian/*$" || true)}
[ -n "$mirror" ] || die "no Debian mirror in this machine's apt sources; name one: WATER_DEBIAN_MIRROR=URL"
state=$out/apt
rm -rf "${out:?}"/usr "$state"
mkdir -p "$state/lists/partial" "$state/archives/partial"
touch "$state/status"
keyring=/usr/share/keyrings/debian-archive-keyring.gpg
[ -e "$keyring" ] || keyring=
echo "deb ${keyring:+[signed-by=$keyring] }$mirror $suite main" >"$state/sources.list"
apt_options=(-qq -oDir::Etc::sourcelist="$state/sources.list" -oDir::Etc::sourceparts=/dev/null
  -oDir::State::Lists="$state/lists" -oDir::State::status="$state/status" -oDir::Cache::archives="$state/archives"
  -oDir::Cache::pkgcache="$state/pkg" -oDir::Cache::srcpkgcache="$state/src" -oAPT::Sandbox::User=root
  -oAcquire::Retries=3 -oAcquire::Check-Valid-Until=false)
{
  apt-get "${apt_options[@]}" update || die "no package lists of Debian $suite from $mirror"
  apt-cache "${apt_options[@]}" show "python$version-venv" >/dev/null 2>&1 || die "Debian $suite has no Python $version"
  apt-get "${apt_options[@]}" -y --no-install-recommends --download-only install \
    "libpython$version-dev" "python$version-venv" || die "Debian's packages cannot be downloaded"
  for package in "$state"/archives/*.deb; do
    # without the C library's headers: the machine's compiler has those of the machine
    case ${package##*/} in libc6-dev_* | linux-libc-dev_*) ;; *) dpkg-deb --extract "$package" "$out" ;; esac
  done
  # Its own dynamic linker and libraries come first, for this program only. The machine's are found after them.
  # In two steps and in this order: with both at once patchelf writes a program that crashes.
  "${PATCHELF:-patchelf}" --force-rpath --set-rpath "$out/usr/lib/x86_64-linux-gnu" "$program" &&
    "${PATCHELF:-patchelf}" --set-interpreter "$out/usr/lib64/ld-linux-x86-64.so.2" "$program" || die "patchelf failed"
  # Debian's pyconfig.h only includes that of the architecture, which a compiler finds in /usr/include alone
  ln -sf "../x86_64-linux-gnu/python$version/pyconfig.h" "$out/usr/include/python$version/pyconfig.h"
  # `python -m venv` takes pip from here
  sed -i "s|'WHEEL_PKG_DIR': '[^']*'|'WHEEL_PKG_DIR': '$out/usr/share/python-wheels'|" \
    "$out/usr/lib/python$version"/_sysconfigdata*.py
  rm -rf "$state"
  "$program" -c 'import ctypes, ssl, sqlite3' || die "the unpacked Python $version does not run"
} >&2
touch "$out/.made"
echo "$program"

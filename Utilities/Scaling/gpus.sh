#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Measures water on ranks of which each has a GPU of its own, with what pack.sh has packed:
#
#   gpus.sh FOLDER [DEVICES [PROPS RESOLUTION WIDTH HEIGHT FRAMES]]
#
# FOLDER has gpus.tar.xz, which is unpacked once. DEVICES: the GPUs to use (default: as many as nvidia-smi lists,
# at least 1). One rank, then 2 to DEVICES ranks, on one GPU and on one each. Prints the lines of RankDevices, and
# writes them into $OUT/scaling-gpus.json, or FOLDER/out. Exit status 1: a run failed.
#
# VTK_DEFAULT_OPENGL_WINDOW=vtkOSOpenGLRenderWindow tries it in software; __EGL_VENDOR_LIBRARY_FILENAMES names
# another driver than NVIDIA's.
set -euo pipefail

die() { echo "scaling-gpus: $*" >&2; exit 1; }

[ $# -ge 1 ] || die "usage: gpus.sh FOLDER [DEVICES [PROPS RESOLUTION WIDTH HEIGHT FRAMES]]"
folder=$(cd "$1" && pwd) || die "no folder $1: script/scaling --pack makes it"
pack=$folder/gpus.tar.xz
[ -e "$pack" ] || die "no $pack: script/scaling --pack makes it, on a machine with a network"
shift
there=$folder/unpacked
stamp=$(sha256sum <"$pack")
if [ "$(cat "$there/.stamp" 2>/dev/null)" != "$stamp" ]; then
  rm -rf "$there"
  mkdir -p "$there"
  if command -v xz >/dev/null; then
    tar -C "$there" -xJf "$pack"
  else
    python3 -c "
import sys, tarfile
with tarfile.open(sys.argv[1], 'r:xz') as pack:
    pack.extractall(sys.argv[2])" "$pack" "$there"
  fi
  echo "$stamp" >"$there/.stamp"
fi

for driver in /usr/share/glvnd /usr/local/nvidia/share/glvnd; do # NVIDIA's, where it is
  if [ -z "${__EGL_VENDOR_LIBRARY_FILENAMES:-}" ] && [ -e "$driver/egl_vendor.d/10_nvidia.json" ]; then
    export __EGL_VENDOR_LIBRARY_FILENAMES=$driver/egl_vendor.d/10_nvidia.json
  fi
done
export LD_LIBRARY_PATH=$there/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
[ ! -d /usr/local/nvidia/lib64 ] || LD_LIBRARY_PATH+=:/usr/local/nvidia/lib64
unset DISPLAY
export VTK_DEFAULT_OPENGL_WINDOW=${VTK_DEFAULT_OPENGL_WINDOW:-vtkEGLRenderWindow}
export MALLOC_TRIM_THRESHOLD_=1073741824 MALLOC_MMAP_THRESHOLD_=1073741824 # returning memory costs time

listed=0
name="$VTK_DEFAULT_OPENGL_WINDOW"
if command -v nvidia-smi >/dev/null; then
  listed=$(nvidia-smi --list-gpus | grep -c '^GPU' || true)
  name=$(nvidia-smi --query-gpu=name --format=csv,noheader | head -1 || true)
fi
devices=${1:-$((listed > 0 ? listed : 1))}
shift || true
[ $# -gt 0 ] || set -- 144 256 1920 1080 60 # 19 million triangles
out=${OUT:-$folder/out}
mkdir -p "$out"
lines=()
status=0
measure() { # RANKS DEVICES
  local line
  if line=$("$there/bin/RankDevices" "$1" "$2" "${@:3}"); then
    echo "$line"
    lines+=("$line")
  else
    echo "scaling-gpus: $1 ranks on $2 GPUs failed" >&2
    status=1
  fi
}
measure 1 1 "$@"
for ((ranks = 2; ranks <= (devices > 2 ? devices : 2); ranks *= 2)); do
  measure "$ranks" 1 "$@"
  [ "$devices" -lt 2 ] || measure "$ranks" "$devices" "$@"
done
measure 1 1 "$@" # again, for what else the machine does meanwhile
{
  printf '{"gpu": "%s", "runs": [\n' "$name"
  for i in "${!lines[@]}"; do
    printf '%s%s\n' "${lines[i]}" "$([ "$i" -lt $((${#lines[@]} - 1)) ] && echo ,)"
  done
  printf ']}\n'
} >"$out/scaling-gpus.json"
exit $status

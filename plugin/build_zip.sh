#!/usr/bin/env bash
# Builds vorogeo-meshlab-VERSION-linux.zip: the plugin for the window of each MeshLab version, and a page on installing it.
#
# Usage: plugin/build_zip.sh
#   It is left in build/wheels/dist, made around the core of pyfilter/build_wheels.sh (run before, or by this script) and with
#   the same Debian 11 libraries, whose Qt 5.15.2 is that of MeshLab's releases. A version whose headers cannot be had is named
#   and left out. VOROGEO_JOBS: compilers at a time (default: one per core).
# Exit status 77 with a sentence on the standard error where no Debian root can be made.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
jobs="${VOROGEO_JOBS:-$(nproc)}"
out=build/wheels
zip="$out/dist/vorogeo-meshlab-$(cat VERSION)-linux.zip"
core() { find "$out/build-cp311" -name libvorogeo_core.a 2>/dev/null | head -n 1; }
[ -n "$(core)" ] || pyfilter/build_wheels.sh

plugins=()
for host in 2025.07 2023.12 2022.02; do
  if ! headers="$(plugin/host/obtain_headers.sh "$host" 2>"$out/headers-$host.log" | tail -n 1)" || [ -z "$headers" ]; then
    echo "zip: left out: MeshLab $host, its headers cannot be had (log: $out/headers-$host.log)"
    continue
  fi
  echo "zip: MeshLab $host (log: $out/float-$host.log)"
  if ! tests/roots/in_root.sh build/roots/builder-bookworm --bind build/roots/sysroot /sysroot --bind "$headers" /headers \
      env VOROGEO_SYSROOT=/sysroot sh -euc "
        cd /project
        cmake -G Ninja -S pyfilter/host_plugin -B $out/float-$host -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=g++-12 \
          -DCMAKE_TOOLCHAIN_FILE=/project/pyfilter/cmake/sysroot.cmake -DVOROGEO_CORE_LIBRARY=/project/$(core) \
          -DVOROGEO_HOST_VERSION=$host -DVOROGEO_HOST_SCALAR=float -DVOROGEO_HOST_SOURCE=/headers
        cmake --build $out/float-$host --target filter_vorogeo edit_vorogeo --parallel $jobs" >"$out/float-$host.log" 2>&1; then
    tail -n 30 "$out/float-$host.log" >&2
    exit 1
  fi
  plugins+=("$host=$out/float-$host/libfilter_vorogeo.so")
done
plugin/pack_zip.sh "$zip" "${plugins[@]}"
echo "$zip"

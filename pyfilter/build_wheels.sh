#!/usr/bin/env bash
# Builds what is uploaded to PyPI: the source archive, a wheel for Python 3.11 and one for Python 3.12 and later, both with
# the plugins inside; and wheels for Linux on aarch64 and for Windows. docs/releasing.md says what to do with them.
#
# Usage: pyfilter/build_wheels.sh [--platform linux | windows | aarch64]
#   They are left in build/wheels/dist. Compilers and Pythons are those of Debian roots (build/roots, made once, some 2 GB).
#   linux, the default: the source archive and the two wheels. The C and C++ libraries are those of Debian 11, so that the
#   wheels run on every system with glibc 2.31 or later. A PyMeshLab version whose headers cannot be had is named and left out.
#   windows: the wheel for Python 3.11, compiled by mingw-w64; the numpy part.
#   aarch64: the wheel for Python 3.11, compiled by Debian's cross compiler, with the plugin for the only PyMeshLab there, 2025.7.
#   VOROGEO_JOBS: compilers at a time (default: one per core).
# Exit status 77 with a sentence on the standard error where no root can be made, or no Python for Windows be had.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

case "$*" in
  "" | "--platform linux") platform=linux ;;
  "--platform windows" | "--platform aarch64") platform="$2" ;;
  *) echo "build_wheels.sh: unknown arguments '$*'; usage: pyfilter/build_wheels.sh [--platform linux | windows | aarch64]" >&2; exit 2 ;;
esac
jobs="${VOROGEO_JOBS:-$(nproc)}"
version="$(cat VERSION)"
out=build/wheels
mkdir -p "$out/dist"
say() { echo "wheels: $*"; }

inside=()
variables=("CMAKE_BUILD_PARALLEL_LEVEL=$jobs")
# Usage: run_in_root BUILDER NAME [VARIABLE=VALUE...] COMMAND...
run_in_root() {
  local builder="$1" name="$2" log="$out/$2.log"
  shift 2
  say "$name in build/roots/builder-$builder (log: $log)"
  if ! tests/roots/in_root.sh "build/roots/builder-$builder" ${inside[@]+"${inside[@]}"} env "$@" >"$log" 2>&1; then
    tail -n 30 "$log" >&2
    exit 1
  fi
}

# Headers are obtained by this system and handed into the roots.
hosts=()
# Usage: obtain_headers VERSION...
obtain_headers() {
  local host headers
  for host in "$@"; do
    if headers="$(plugin/host/obtain_headers.sh "$host" 2>"$out/headers-$host.log" | tail -n 1)" && [ -n "$headers" ]; then
      hosts+=("$host")
      inside+=(--bind "$headers" "/headers/$host")
      variables+=("VOROGEO_MESHLAB_SOURCE_${host/./_}=/headers/$host")
    else
      say "left out: PyMeshLab with MeshLab $host, its headers cannot be had (log: $out/headers-$host.log)"
    fi
  done
}

if [ "$platform" != linux ]; then
  case "$platform" in
    windows)
      pyfilter/wheels/obtain_windows_python.sh >/dev/null
      name=win_amd64 compiler=g++-mingw-w64-x86-64-posix runs_it="wine wine64" ;;
    aarch64)
      obtain_headers 2025.07
      name=aarch64 compiler=g++-aarch64-linux-gnu runs_it=qemu-user-static ;;
  esac
  # shellcheck disable=SC2086  # packages are words
  tests/roots/make_root.sh "build/roots/builder-$platform" bookworm --no-install-recommends $compiler cmake ninja-build python3 \
    python3-venv libeigen3-dev ca-certificates $runs_it
  rm -f "$out"/dist/*"$name".whl
  packaging/source_archive.sh >/dev/null
  run_in_root "$platform" "$platform" "${variables[@]}" bash /project/pyfilter/wheels/build_cross.sh "$platform" "$version" "${hosts[*]}"
  ls -l "$out"/dist/*"$name".whl
  exit
fi

find "$out/dist" -type f ! -name '*win_amd64.whl' ! -name '*aarch64.whl' -delete
inside+=(--bind build/roots/sysroot /sysroot)
variables+=(VOROGEO_SYSROOT=/sysroot)
obtain_headers 2025.07 2023.12 2022.02

# Usage: build SUITE TAG
build() {
  tests/roots/make_root.sh "build/roots/builder-$1" "$1" --no-install-recommends g++-12 cmake ninja-build ca-certificates \
    python3 python3-dev python3-venv
  run_in_root "$1" "$2" "${variables[@]}" bash /project/pyfilter/wheels/build_in_root.sh "$2" "$version" \
    "$(IFS=';'; echo "${hosts[*]}")"
}

tests/roots/make_root.sh build/roots/sysroot bullseye --no-install-recommends libc6-dev libstdc++-10-dev libeigen3-dev \
  qtbase5-dev libqt5opengl5-dev libglew-dev
# Absolute links would lead out of it into the root that compiles.
find build/roots/sysroot/usr/lib64 build/roots/sysroot/usr/lib/x86_64-linux-gnu -type l -lname '/*' | while read -r link; do
  ln -sfr "build/roots/sysroot$(readlink "$link")" "$link"
done
packaging/source_archive.sh >/dev/null
build bookworm cp311
build trixie abi3
ls -l "$out/dist"

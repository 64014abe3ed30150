#!/usr/bin/env bash
# Sets up everything the samples and tests need. Run it as often as you like: finished steps are skipped.
#
# Usage: samples/setup.sh [--numpy | --tests | --daily | --bench]
#   Debian packages (only missing ones; asks for nothing, uses sudo if you are not root), .venv with the Python
#   packages of samples/requirements.txt, the core in build/core, around it the plugin for PyMeshLab 2025.7 in
#   build/plugin-2025.07-double, and the Python package vorogeo in .venv.
#   --numpy: all but the plugin and what only it needs: half of the time. A package with the plugin stays.
#   --tests: also what only the tests need: tests/requirements.txt, GoogleTest, debootstrap, Maven, clang with libc++, and PyMeshLab
#   2022.2 and 2023.12 in build/venv-2022 and build/venv-2023 with their plugins and vorogeo. The core is then that of the C++ tests,
#   in build/release. 2023.12 is left out where the headers of MeshLab 2023.12 cannot be had; build/logs/headers-2023.12.log has the
#   reason.
#   --daily: as --tests, without the older PyMeshLab versions, Maven and clang.
#   --bench: instead of all this, what tests/bench needs: build/venv-bench with the package without its plugin and with
#   the packages it is compared with, and the programs in build/bench. What cannot be obtained is named and left out.
#
# VOROGEO_JOBS: compilers at a time (default: one per core). VOROGEO_NO_PACKAGES=1: leave the system's packages alone.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

with_plugin=yes
with_tests=no
with_older=no
for_bench=no
for argument in "$@"; do
  case "$argument" in
    --numpy) with_plugin=no ;;
    --tests) with_tests=yes with_older=yes ;;
    --daily) with_tests=yes ;;
    --bench) for_bench=yes ;;
    *) echo "samples/setup.sh: unknown argument '$argument'; usage: samples/setup.sh [--numpy | --tests | --daily | --bench]" >&2; exit 2 ;;
  esac
done

die() {
  echo "samples/setup.sh: $*" >&2
  exit 1
}
say() { echo "setup: $*"; }
logs=build/logs
mkdir -p "$logs"

# Runs a step unless its stamp says that it succeeded with the same input before. The stamp lies in the folder
# that the step makes, so that removing the folder removes the stamp. A function returns at its first failure by itself:
# bash does not stop it inside a condition.
# Usage: once NAME STAMP INPUT COMMAND...
once() {
  local name="$1" stamp="$2" input="$3" log="$logs/$1.log"
  shift 3
  if [ "$(cat "$stamp" 2>/dev/null)" = "$input" ]; then
    return
  fi
  rm -f "$stamp"
  say "$name (log: $log)"
  if ! "$@" >"$log" 2>&1; then
    tail -n 30 "$log" >&2
    die "$name failed; the lines above are the end of $log"
  fi
  echo "$input" >"$stamp"
}

packages=(g++ cmake ninja-build ca-certificates python3 python3-venv python3-dev libeigen3-dev
          libgl1 libopengl0 libegl1 libglu1-mesa libgomp1 libxrender1)
if [ "$with_plugin" = yes ]; then
  packages+=(git xz-utils debian-archive-keyring qtbase5-dev libqt5opengl5-dev libglew-dev)
fi
if [ "$with_tests" = yes ]; then
  packages+=(libgtest-dev clang-format g++-aarch64-linux-gnu debootstrap)
fi
if [ "$with_older" = yes ]; then
  packages+=(maven clang-16 libc++-16-dev)  # Maven brings CPython for Windows; libc++ is macOS's library
fi
if [ "$for_bench" = yes ]; then
  packages+=(libcgal-dev linux-perf)
fi

install_packages() {
  local missing=() package as_root=()
  for package in "${packages[@]}"; do
    if [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
      missing+=("$package")
    fi
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null || die "these Debian packages are missing and need root to be installed:" \
                                      "apt-get install ${missing[*]}"
    as_root=(sudo)
  fi
  say "installing Debian packages: ${missing[*]}"
  local install=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends
                 "${missing[@]}")
  if ! "${install[@]}" >"$logs/packages.log" 2>&1; then  # the lists may be missing or old
    "${as_root[@]}" apt-get update -qq >"$logs/packages.log" 2>&1 || true
    if ! "${install[@]}" >>"$logs/packages.log" 2>&1; then
      tail -n 15 "$logs/packages.log" >&2
      die "the packages could not be installed; the lines above are the end of $logs/packages.log"
    fi
  fi
}

if [ "${VOROGEO_NO_PACKAGES:-}" != 1 ]; then
  command -v apt-get >/dev/null && command -v dpkg-query >/dev/null ||
    die "apt is not available: this set-up is for Debian 12. Elsewhere install what these packages hold and run it" \
        "again with VOROGEO_NO_PACKAGES=1: ${packages[*]}"
  install_packages
fi

jobs="${VOROGEO_JOBS:-$(nproc)}"
python="$(command -v python3)" || die "python3 is not installed"
python_version="$("$python" -c 'import sys; print(".".join(map(str, sys.version_info[:2])))')"

# Usage: make_venv FOLDER REQUIREMENTS
make_venv() {
  rm -rf "$1"
  "$python" -m venv "$1"
  "$1/bin/pip" install --disable-pip-version-check --no-compile -r "$2"  # Python compiles what is imported
}
venv() { once "$1" "$2/.stamp" "$python_version $(sha256sum <"$3")" make_venv "$2" "$3"; }

# The core is compiled once, for the plugins and the package: without the tests' own needs, or as part of their build.
core_preset=core
[ "$with_tests" = no ] || core_preset=release
core_library="$PWD/build/$core_preset/core/libvorogeo_core.a"
build_core() {
  cmake --preset "$core_preset" &&
    cmake --build "build/$core_preset" --target vorogeo_core vorogeo_methods --parallel "$jobs"
}
core() { once "core" "build/$core_preset/.stamp-core" "$(sources core)" build_core; }

# Usage: build_plugin VERSION
# Leaves the plugin in build/plugin-VERSION-double/plugin and a copy in build/plugins/VERSION, as pyfilter takes it.
build_plugin() {
  local folder="build/plugin-$1-double"
  cmake --preset "plugin-$1-double" "-DVOROGEO_CORE_LIBRARY=$core_library" || return
  cmake --build "$folder" --target filter_vorogeo --parallel "$jobs" || return
  mkdir -p "build/plugins/$1"
  if ! cmp -s "$folder/plugin/libfilter_vorogeo.so" "build/plugins/$1/libfilter_vorogeo.so"; then
    cp "$folder/plugin/libfilter_vorogeo.so" "build/plugins/$1/.new"
    mv "build/plugins/$1/.new" "build/plugins/$1/libfilter_vorogeo.so"
  fi
}
plugin() { once "plugin-$1" "build/plugins/$1/.stamp" "$(sources core plugin)" build_plugin "$1"; }

# The plugin that only the tests load, next to the one that they test.
build_probe() { cmake --build "build/plugin-$1-double" --target filter_probe --parallel "$jobs"; }
probe() {
  once "probe-$1" "build/plugins/$1/.stamp-probe" "$(sources plugin tests/plugin/probe)" build_probe "$1"
}

# One line for the contents of folders of the project and the files that configure the build.
sources() {
  find "$@" CMakeLists.txt CMakePresets.json VERSION -type f ! -path '*/__pycache__/*' ! -path '*/.*_cache/*' ! -name '*.md' -print0 |
    sort -z | xargs -0 sha256sum | sha256sum
}

# Usage: install_vorogeo VENV VERSION CORE BUILDER
# BUILDER is the venv whose Python builds the package: with one builder for all, its extension is compiled once.
install_vorogeo() {
  local wheels="$PWD/build/pyfilter/wheels-$2"
  rm -rf "$wheels"
  CMAKE_BUILD_PARALLEL_LEVEL="$jobs" "$4/bin/pip" wheel --disable-pip-version-check --no-build-isolation \
    --no-deps --wheel-dir "$wheels" "--config-settings=cmake.define.VOROGEO_PLUGIN_DIR=$PWD/build/plugins" \
    "--config-settings=cmake.define.VOROGEO_CORE_LIBRARY=$3" "--config-settings=cmake.define.VOROGEO_HOSTS=$2" ./pyfilter &&
    "$1/bin/pip" install --disable-pip-version-check --no-deps --force-reinstall "$wheels"/*.whl
}
# Usage: vorogeo VENV VERSION, which is empty for the numpy part
vorogeo() {
  once "vorogeo-${2:-numpy}" "$1/.stamp-vorogeo" "$2 $(sources core plugin pyfilter)" install_vorogeo "$1" "$2" "$core_library" .venv
}

# Usage: install_peers VENV REQUIREMENTS
# A line each, so that one package that cannot be obtained does not prevent the others.
install_peers() {
  local line
  grep -v '^#' "$2" | while read -r line; do
    # shellcheck disable=SC2086  # a line may hold options
    "$1/bin/pip" install --disable-pip-version-check $line || echo "left out: $line"
  done
}
build_bench() {
  cmake --preset bench || return
  cmake --build build/bench --target core_bench --parallel "$jobs" || return
  cmake --build build/bench --target cgal_peer --parallel "$jobs" || echo "left out: CGAL"
}
if [ "$for_bench" = yes ]; then
  bench=build/venv-bench
  venv venv-bench "$bench" tests/bench/requirements.txt
  peers=tests/bench/requirements-peers.txt
  once venv-bench-peers "$bench/.stamp-peers" "$(cat "$peers" "$bench/.stamp")" install_peers "$bench" "$peers"
  once vorogeo-bench "$bench/.stamp-vorogeo" "$(sources core pyfilter)" install_vorogeo "$bench" "" "" "$bench"
  once bench build/bench/.stamp "$(sources core tests/bench)" build_bench
  grep -h '^left out' "$logs/venv-bench-peers.log" "$logs/bench.log" || true
  say "ready"
  exit
fi

python_packages() {
  venv venv .venv samples/requirements.txt
  if [ "$with_tests" = yes ]; then
    local tools=tests/requirements.txt
    once venv-tests .venv/.stamp-tests "$(cat "$tools" .venv/.stamp)" \
      .venv/bin/pip install --disable-pip-version-check --no-compile -r "$tools"
  fi
}
python_packages &  # downloads while the compiler works
trap wait EXIT
core
[ "$with_plugin" = no ] || plugin 2025.07
wait $!
if [ "$with_plugin" = no ]; then
  installed="$(cat .venv/.stamp-vorogeo 2>/dev/null || true)"
  [ "${installed#* }" = "$(sources core plugin pyfilter)" ] || vorogeo .venv ""
  say "ready, without the plugin"
  exit
fi
vorogeo .venv 2025.07
if [ "$with_tests" = yes ]; then
  peers=tests/requirements-peers.txt
  once venv-peers .venv/.stamp-peers "$(cat "$peers" .venv/.stamp)" install_peers .venv "$peers"
  probe 2025.07
fi
if [ "$with_older" = yes ]; then
  for version in 2022.02 2023.12; do
    year="${version%.*}"
    # No package of Debian has the headers of 2023.12, so a machine may have no way to them.
    if [ "$version" = 2023.12 ] && ! plugin/host/obtain_headers.sh "$version" >/dev/null 2>"$logs/headers-$version.log"; then
      say "PyMeshLab 2023.12 is left out: there are no headers of MeshLab 2023.12 (log: $logs/headers-$version.log)"
      continue
    fi
    venv "venv-$year" "build/venv-$year" "samples/requirements-$year.txt"
    plugin "$version"
    probe "$version"
    vorogeo "build/venv-$year" "$version"
  done
fi
say "ready"

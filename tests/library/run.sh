#!/usr/bin/env bash
# Installs the library into an empty prefix, static and shared, and builds the C++ samples around it out of source in all three
# ways: find_package, pkg-config, FetchContent from this checkout. Each sample checks its answers against a formula.
#
# Usage: tests/library/run.sh BUILD [VCGLIB]
#   BUILD: a folder of the build with the target vorogeo, such as build/release. VCGLIB: the folder of vcglib; if given, from_vcg is
#   built, too. VOROGEO_JOBS: compilers at a time (default: one per core). What is made is left in build/library.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build="$1" vcg="${2:-}"
jobs="${VOROGEO_JOBS:-$(nproc)}"
out="$PWD/build/library"
rm -rf "$out"
mkdir -p "$out"

die() {
  echo "tests/library/run.sh: $*" >&2
  exit 1
}
plain=(first_field many_pairs path_to_obj)
samples=("${plain[@]}")
[ -z "$vcg" ] || samples+=(from_vcg)

# Usage: run_samples FOLDER SAMPLES...
run_samples() {
  local folder="$1" sample
  shift
  for sample in "$@"; do
    (cd "$folder" && "./$sample") || die "$folder/$sample failed"
  done
  grep -q '^l 1 2' "$folder/path.obj" || die "$folder/path.obj has no line"
}
# Usage: build_samples FOLDER CMAKE_OPTIONS...
build_samples() {
  cmake -G Ninja -S samples/cpp -B "$@"
  cmake --build "$1" --parallel "$jobs"
}

echo "--- the prefixes"
cmake --install "$build" --prefix "$out/static"
core="$PWD/$build/core/libvorogeo_core.a"
cmake -G Ninja -S . -B "$out/build-shared" -DBUILD_SHARED_LIBS=ON "-DVOROGEO_CORE_LIBRARY=$core"
cmake --build "$out/build-shared" --parallel "$jobs" --target vorogeo
cmake --install "$out/build-shared" --prefix "$out/shared"
for kind in static shared; do
  (cd "$out/$kind" && find . -type f -o -type l | sort) >"$out/$kind.txt"
  for file in include/vorogeo.h include/vorogeo/{errors,results,vcg}.h share/doc/vorogeo/LICENSE share/doc/vorogeo/VERSION; do
    [ -s "$out/$kind/$file" ] || die "there is no $file in the $kind prefix"
  done
done
headers="$(find "$out/static/include" -type f | wc -l)"
[ "$headers" = 4 ] || die "$headers headers are installed, not vorogeo.h and three in vorogeo/ alone"

echo "--- what the libraries hold"
library="$(find "$out/shared" -name libvorogeo.so)"
nm -DC --defined-only "$library" >"$out/symbols.txt"
grep -q 'vorogeo::v0::Surface::path' "$out/symbols.txt" || die "the shared library does not offer Surface::path"
if grep -v 'vorogeo::v0::' "$out/symbols.txt"; then die "the shared library shows more than the public interface (above)"; fi
archive="$(find "$out/static" -name libvorogeo.a)"
nm -C "$archive" >"$out/archive.txt"
if grep -m 3 -E 'GeodesicMethod|_entry\(\)|Eigen::' "$out/archive.txt"; then die "methods of the literature are in the library (above)"; fi

echo "--- find_package"
build_samples "$out/static-samples" "-DCMAKE_PREFIX_PATH=$out/static" -DCMAKE_BUILD_TYPE=Release "-DVCG_DIR=$vcg"
run_samples "$out/static-samples" "${samples[@]}"
build_samples "$out/shared-samples" "-DCMAKE_PREFIX_PATH=$out/shared" -DCMAKE_BUILD_TYPE=Release
run_samples "$out/shared-samples" "${plain[@]}"

echo "--- pkg-config, from prefixes that were moved"
for kind in static shared; do
  mv "$out/$kind" "$out/moved-$kind"
  folder="$(dirname "$(find "$out/moved-$kind" -name vorogeo.pc)")"
  export PKG_CONFIG_PATH="$folder" LD_LIBRARY_PATH="$folder/.."
  [ "$(pkg-config --modversion vorogeo)" = "$(cat VERSION)" ] || die "pkg-config has another version"
  mkdir "$out/pkg-config-$kind"
  for sample in first_field path_to_obj; do
    # shellcheck disable=SC2046  # flags are words
    g++ -std=c++20 -O1 "samples/cpp/$sample.cpp" -o "$out/pkg-config-$kind/$sample" $(pkg-config --cflags --libs vorogeo)
  done
  run_samples "$out/pkg-config-$kind" first_field path_to_obj
done
unset PKG_CONFIG_PATH LD_LIBRARY_PATH

echo "--- FetchContent: of the core a module is compiled as a part of the samples, and the rest taken from BUILD, which saves a minute"
fetched="$out/fetched-samples"
cmake -G Ninja -S samples/cpp -B "$fetched" "-DVOROGEO_SOURCE=$PWD"
cmake --build "$fetched" --target _deps/vorogeo-build/core/CMakeFiles/vorogeo_core.dir/Unity/unity_support_cxx.cxx.o
build_samples "$fetched" "-DVOROGEO_SOURCE=$PWD" "-DVOROGEO_CORE_LIBRARY=$core"
run_samples "$fetched" "${plain[@]}"
if find "$out" -name 'libvorogeo_methods*' | grep .; then die "a user's build compiles the methods of the literature"; fi
echo "--- all samples agree with their formulas"

#!/usr/bin/env bash
# Builds a wheel for another system inside a Debian root that has a compiler for that, and wine or qemu to load what it compiled.
#
# Usage: build_cross.sh windows|aarch64 VERSION HOSTS       run by build_wheels.sh --platform windows|aarch64
set -euo pipefail
system="$1" version="$2" hosts="$3"
cd /project/build/wheels
tools=/opt/vorogeo-tools
[ -x "$tools/bin/wheel" ] || {
  python3 -m venv "$tools"
  "$tools/bin/pip" install --disable-pip-version-check build scikit-build-core wheel
}
"$tools/bin/pip" install --disable-pip-version-check "nanobind==$(sed -n 's#.*pkg:pypi/nanobind@\([0-9.]*\).*#\1#p' /project/packaging/sbom.json)"
export PATH="$tools/bin:$PATH"

case "$system" in
  windows)
    export VOROGEO_WINDOWS_PYTHON=/project/build/windows/python-3.11 WINEPREFIX=/opt/vorogeo-wine WINEDEBUG=-all
    there() { wine "$VOROGEO_WINDOWS_PYTHON/python.exe" "$@" </dev/null 2>&1 | cat; } # wine cannot use files outside the root
    tag=win_amd64 ;;
  aarch64)
    export VOROGEO_AARCH64=/opt/aarch64
    /project/pyfilter/wheels/obtain_aarch64.sh "$VOROGEO_AARCH64"
    there() { qemu-aarch64-static "$VOROGEO_AARCH64/usr/bin/python3.11" "$@"; }
    tag=manylinux_2_36_aarch64 ;;  # tests/wheels compares it with the symbols: auditwheel knows its own system only
esac

rm -rf "raw-$system" "unpacked-$system" "build-$system"  # files of an archive have its time
mkdir -p "unpacked-$system/source"
tar -x -f "dist/vorogeo-$version.tar.gz" -C "unpacked-$system/source" --strip-components=1
python -m build --wheel --no-isolation --outdir "raw-$system" -C "build-dir=$PWD/build-$system" -C "cmake.define.VOROGEO_HOSTS=$hosts" \
  -C "cmake.define.CMAKE_TOOLCHAIN_FILE=$PWD/unpacked-$system/source/pyfilter/cmake/$system.cmake" "unpacked-$system/source"
python -m wheel tags --remove --platform-tag "$tag" "raw-$system"/*.whl
python -m wheel unpack --dest "unpacked-$system" "raw-$system"/*.whl

# The types of the extension's functions are made by loading it.
cd "unpacked-$system/vorogeo-$version"
there "$(python -c 'import nanobind; print(nanobind.__path__[0])')/stubgen.py" --module _core --import vorogeo --output-file vorogeo/_core.pyi
sed -i 's/\r$//' vorogeo/_core.pyi
# The runtime of mingw-w64 is inside, with its licences.
[ "$system" != windows ] || cp /usr/share/doc/mingw-w64-x86-64-dev/copyright "vorogeo-$version.dist-info/licenses/NOTICES-mingw-w64.txt"
cd ../..
python -m wheel pack --dest-dir dist "unpacked-$system/vorogeo-$version"

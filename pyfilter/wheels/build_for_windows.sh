#!/usr/bin/env bash
# Builds the wheel for Windows inside a Debian root that has mingw-w64, and wine to load what it compiled.
#
# Usage: build_for_windows.sh       run by build_wheels.sh --platform windows
set -euo pipefail
cd /project/build/wheels
tools=/opt/vorogeo-tools
[ -x "$tools/bin/wheel" ] || {
  python3 -m venv "$tools"
  "$tools/bin/pip" install --disable-pip-version-check build scikit-build-core nanobind wheel
}
export PATH="$tools/bin:$PATH" VOROGEO_WINDOWS_PYTHON=/project/build/windows/python-3.11

rm -rf raw-windows unpacked-windows
python -m build --wheel --no-isolation --outdir raw-windows -C "build-dir=$PWD/build-windows" -C cmake.define.VOROGEO_HOSTS= \
  -C "cmake.define.CMAKE_TOOLCHAIN_FILE=$PWD/source/pyfilter/cmake/windows.cmake" source
python -m wheel tags --remove --platform-tag win_amd64 raw-windows/*.whl
python -m wheel unpack --dest unpacked-windows raw-windows/*.whl

# The types of the extension's functions are made by loading it, which takes Windows. Wine cannot use files outside the root.
cd unpacked-windows/vorogeo-*
export WINEPREFIX=/opt/vorogeo-wine WINEDEBUG=-all
wine "$VOROGEO_WINDOWS_PYTHON/python.exe" "$(python -c 'import nanobind; print(nanobind.__path__[0])')/stubgen.py" \
  --module _core --import vorogeo --output-file vorogeo/_core.pyi </dev/null 2>&1 | cat
sed -i 's/\r$//' vorogeo/_core.pyi
cd ../..
python -m wheel pack --dest-dir dist unpacked-windows/vorogeo-*

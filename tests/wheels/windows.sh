#!/usr/bin/env bash
# Tests the wheel for Windows under Debian's wine, in a CPython for Windows.
#
# Usage: tests/wheels/windows.sh [--built] [-- PYTEST OPTIONS]
#   Builds the wheel (pyfilter/build_wheels.sh --platform windows; --built: takes that in build/wheels/dist), looks into it,
#   installs it with NumPy's and SciPy's wheels for Windows, and runs the tests that need no more than these: the contract, and what
#   systems do in different ways. Needs what samples/setup.sh --tests sets up, root's rights, and 2 GB in build.
# Exit status 77 where there is no root, no wine or no package for Windows; the reason stands on the standard error.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
[ "${1:-}" = --built ] && shift || pyfilter/build_wheels.sh --platform windows
[ "${1:-}" != -- ] || shift

wheel="$(ls "$PWD"/build/wheels/dist/*win_amd64.whl)"
VOROGEO_WHEEL="$wheel" .venv/bin/python -m pytest -q -p no:cacheprovider tests/wheels/test_package_files.py
packages=build/windows/packages
# NumPy 2 calls functions of the C library that Debian's wine does not have.
if [ -z "$(ls $packages/scipy-*.whl 2>/dev/null)" ]; then
  mkdir -p "$packages"
  .venv/bin/python -m pip download -q --disable-pip-version-check --dest "$packages" --only-binary :all: --platform win_amd64 \
    --python-version 3.11 numpy==1.26.4 'scipy<1.12' pytest colorama meshio >build/windows/packages.log 2>&1 ||
    { echo "NumPy, SciPy and pytest for Windows cannot be had here: $(tail -n 1 build/windows/packages.log)" >&2; exit 77; }
fi
tests/roots/make_root.sh build/roots/user-windows bookworm --no-install-recommends wine wine64
tests/roots/in_root.sh build/roots/user-windows bash /project/tests/wheels/run_under_wine.sh "${wheel##*/}" "$@"

#!/usr/bin/env bash
# Tests the wheel for Linux on aarch64 by qemu, in Debian's Python for arm64.
#
# Usage: tests/wheels/aarch64.sh [--built] [-- PYTEST OPTIONS AND FILES]
#   Builds the wheel (pyfilter/build_wheels.sh --platform aarch64; --built: takes that in build/wheels/dist), looks into it,
#   installs it with NumPy's and PyMeshLab's, and runs the contract tests of fields, distances and paths, and those of the filters
#   that need no more. Needs what samples/setup.sh --daily sets up, root's rights, and 3 GB in build.
# Exit status 77 where no root can be made; the reason stands on the standard error.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
[ "${1:-}" = --built ] && shift || pyfilter/build_wheels.sh --platform aarch64
[ "${1:-}" != -- ] || shift
[ $# -gt 0 ] || set -- tests/contract/test_{field,distance,path}.py tests/wheels/test_filters.py

wheel="$(ls "$PWD"/build/wheels/dist/*aarch64.whl)"
VOROGEO_WHEEL="$wheel" .venv/bin/python -m pytest -q -p no:cacheprovider tests/wheels/test_package_files.py
tests/roots/in_root.sh build/roots/builder-aarch64 bash -euo pipefail -c '
  cd /project
  /opt/vorogeo-tools/bin/pip install -q --target /tmp/site --only-binary :all: --python-version 3.11 \
    --platform manylinux_2_36_aarch64 --platform manylinux_2_35_aarch64 --platform manylinux_2_28_aarch64 \
    --platform manylinux2014_aarch64 numpy pytest meshio pymeshlab==2025.7.post1 "build/wheels/dist/$1"
  PYTHONPATH=/tmp/site qemu-aarch64-static /opt/aarch64/usr/bin/python3.11 -m pytest -q -rs -p no:cacheprovider "${@:2}"
' aarch64 "${wheel##*/}" "$@"

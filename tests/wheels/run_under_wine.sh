#!/usr/bin/env bash
# Installs the wheel for Windows in a new Python inside a root that has wine, and runs the tests that need no more than that.
#
# Usage: run_under_wine.sh WHEEL [PYTEST OPTIONS]       run by tests/wheels/windows.sh
set -euo pipefail
wheel="$1"
shift
export WINEPREFIX=/opt/vorogeo-wine WINEDEBUG=-all
cp -r /project/build/windows/python-3.11 /tmp/python
cd /project
python() { wine /tmp/python/python.exe "$@" </dev/null 2>&1 | cat; }  # wine cannot use files outside the root
python -m pip install -q --no-index --no-warn-script-location --find-links build/windows/packages "build/wheels/dist/$wheel" scipy pytest colorama meshio
python -c "import vorogeo; print(vorogeo.__version__, vorogeo.__file__)"
python -m pytest -q -rs -p no:cacheprovider tests/wheels/test_systems.py tests/contract "$@"

#!/usr/bin/env bash
# Tests what is uploaded where users install it: in Debian roots with nothing but Python, without compiler, CMake and headers.
#
# Usage: tests/wheels/run.sh [--built]
#   Builds the source archive and the wheels (pyfilter/build_wheels.sh; --built: takes those in build/wheels/dist), looks into
#   them, and installs each wheel without and with PyMeshLab in a new environment, where the tests of the numpy part and of
#   the filters run; the source archive is installed in a root with a compiler. Needs what samples/setup.sh --tests sets up,
#   root's rights, and some 3 GB in build/roots. Logs: build/wheels/test-*.log.
# Exit status 77 where no root can be made; the reason stands on the standard error.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
dist=build/wheels/dist
[ "${1:-}" = --built ] || pyfilter/build_wheels.sh
say() { echo "wheels: $*"; }

# Usage: step NAME COMMAND...
step() {
  local log="build/wheels/test-$1.log"
  say "$1 (log: $log)"
  shift
  "$@" >"$log" 2>&1 || { tail -n 30 "$log"; exit 1; }
  grep -hE '^[0-9]+ passed|passed' "$log" | tail -n 1 || true
}

tools=build/wheels/venv-upload
[ -x "$tools/bin/auditwheel" ] || { python3 -m venv "$tools" && "$tools/bin/pip" install -q twine auditwheel; }
step upload "$tools/bin/twine" check --strict "$dist"/vorogeo-*.whl "$dist"/vorogeo-*.tar.gz
step tags "$tools/bin/python" tests/wheels/show_wheel.py "$dist"/*manylinux*x86_64.whl
for wheel in "$dist"/*manylinux*x86_64.whl; do
  step "files-$(cut -d - -f 3,4 <<<"$(basename "$wheel")")" env "VOROGEO_WHEEL=$PWD/$wheel" \
    .venv/bin/python -m pytest -q -p no:cacheprovider tests/wheels/test_package_files.py
done

# What PyMeshLab asks for beside Python: libraries of OpenGL and Kerberos, and no compiler.
install_in() {
  tests/roots/make_root.sh "build/roots/user-$1" "$1" --no-install-recommends python3 python3-venv ca-certificates \
    libgl1 libopengl0 libegl1 libglu1-mesa libgomp1 libxrender1 libglib2.0-0 libcom-err2
}
# Usage: in_user SUITE COMMAND...
in_user() { tests/roots/in_root.sh "build/roots/user-$1" bash /project/tests/wheels/install_in_root.sh "${@:2}"; }

install_in bookworm
step numpy-cp311 in_user bookworm numpy cp311
step filters-cp311-2025.7 in_user bookworm filters cp311 2025.7.post1
step filters-cp311-2022.2 in_user bookworm filters cp311 2022.2.post4
if [ -n "$(python3 -m zipfile -l "$dist"/*cp311-manylinux*x86_64.whl | grep plugins/2023.12)" ]; then
  step filters-cp311-2023.12 in_user bookworm filters cp311 2023.12.post3
else
  say "skipped: PyMeshLab 2023.12, its plugin is not in the wheel"
fi
install_in trixie
step numpy-abi3 in_user trixie numpy abi3
step filters-abi3-2025.7 in_user trixie filters abi3 2025.7.post1

# The source archive compiles the numpy part; the headers of Eigen are those of the root with a compiler.
step sdist tests/roots/in_root.sh build/roots/builder-bookworm --bind build/roots/sysroot/usr/include/eigen3 /usr/include/eigen3 \
  bash /project/tests/wheels/install_in_root.sh sdist
say "all passed"

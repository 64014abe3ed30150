#!/usr/bin/env bash
# Prints what an index costs and how it errs on meshes of every kind, beside fast DGG. Does its own set-up.
# Usage: tests/bench/any_mesh.sh [MESH...]      (default: all of ../shared/meshes and the generated parts)
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
(cd "$root" && cmake --preset bench && cmake --build --preset bench --target any_mesh_bench) >&2
if [ $# -eq 0 ]; then
  shopt -s nullglob
  set -- "${VOROGEO_MESHES:-$root/../shared/meshes}"/*.ply drilled_plate thick_plate drilled_block gear small_plate small_gear coarse_sphere block_city
fi
exec "$root/build/bench/tests/bench/any_mesh_bench" 6 "$@"

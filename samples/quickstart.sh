#!/usr/bin/env bash
# From a fresh Debian 12 machine to geodesic distances on a mesh: installs, builds, draws a first field with numpy alone, builds
# the plugin, and runs the main job in PyMeshLab.
#
# Usage: samples/quickstart.sh [MESH]
#   MESH: any mesh file that PyMeshLab can read; by default the bunny inside the pymeshlab package.
#   Writes to samples/out/: first_picture.png, the distance field from a point and both layers of patches, each as PLY and PNG,
#   and the index file; prints a table of times, sizes and errors. Set-up is done once; see samples/setup.sh.
set -euo pipefail
samples="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"

if [ $# -gt 1 ] || [[ "${1:-}" == -* ]]; then
  echo "usage: samples/quickstart.sh [MESH]" >&2
  exit 2
fi
if [ $# -eq 1 ] && [ ! -f "$1" ]; then # said before the set-up, which takes minutes the first time
  echo "There is no file $1. Give a PLY, OBJ, STL, OFF, GLB or other mesh file." >&2
  exit 1
fi

bash "$samples/setup.sh" --numpy
python="$samples/../.venv/bin/python"
mesh="${1:-$("$python" -c 'import pymeshlab; print(pymeshlab.__path__[0])')/tests/sample_meshes/bunny.obj}"
"$python" -W ignore::RuntimeWarning "$samples/first_picture.py" "$mesh"  # the warning is that there is no plugin yet
bash "$samples/setup.sh"
exec "$python" "$samples/quickstart.py" "$mesh" "$samples/out"

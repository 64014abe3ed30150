#!/usr/bin/env bash
# Installs a wheel or the source archive in a new environment inside a root, and runs the tests that need no compiler.
#
# Usage: install_in_root.sh numpy cp311|abi3 | filters cp311|abi3 PYMESHLAB | sdist       run by tests/wheels/run.sh
set -euo pipefail
part="$1" tag="${2:-}" pymeshlab="${3:-}"
dist=/project/build/wheels/dist
venv=/tmp/venv
python3 -m venv "$venv"
cd /tmp  # the package must come from the environment, not from the project
if [ "$part" = sdist ]; then
  CXX=g++-12 "$venv/bin/pip" install "$dist"/vorogeo-*.tar.gz  # the root has no compiler by its short name
  "$venv/bin/python" -c "import vorogeo; print(vorogeo.exact_distance_field([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]], 1))"
  exit
fi
for tool in cc g++ cmake ninja make; do
  ! command -v "$tool" || { echo "$tool is installed here: this root shows nothing"; exit 1; }
done
wheel="$(ls "$dist"/*"$tag"-manylinux*x86_64.whl)"
"$venv/bin/pip" install "$wheel"
"$venv/bin/python" -c "import vorogeo; print(vorogeo.__version__, vorogeo.__file__)"  # with nothing but numpy
"$venv/bin/vorogeo" --version
numpy_bound=numpy extras=test
[ "$part" != numpy ] || extras=test,dask
[ "$pymeshlab" != 2022.2.post4 ] || numpy_bound='numpy<2'
"$venv/bin/pip" install --only-binary :all: "$wheel[$extras]" "$numpy_bound"
if [ "$part" = numpy ]; then
  "$venv/bin/python" -m pytest -q -rs -p no:cacheprovider /project/tests/python
  exit
fi
"$venv/bin/pip" install --only-binary :all: "pymeshlab==$pymeshlab"
# The filters of the wheel under the tests of the plugin; the plugin that only these tests load was built before.
# PyMeshLab may print warnings about plugins of its own before the answer.
host="$("$venv/bin/python" -c "from vorogeo.plugin import meshlab_version; print(meshlab_version('$pymeshlab'))" | tail -n 1)"
installed="$("$venv/bin/python" -c "from vorogeo import plugin; print(plugin.plugin_file('$pymeshlab'))" | tail -n 1)"
mkdir -p /tmp/build/plugin
cp "$installed" /tmp/build/plugin/
ln -s "/project/build/plugin-$host-double/plugin/probe" /tmp/build/plugin/probe
"$venv/bin/python" -m pytest -q -rs -p no:cacheprovider /project/tests/python/test_python_{plugin,package}.py
"$venv/bin/python" -c "import vorogeo, pymeshlab; print(len(vorogeo.load_plugin()), 'filters')"
VOROGEO_PLUGIN_BUILD=/tmp/build "$venv/bin/python" -m pytest -q -rs -p no:cacheprovider /project/tests/plugin \
  --ignore=/project/tests/plugin/test_older_pymeshlab.py --ignore=/project/tests/plugin/test_obtain_headers.py \
  --ignore=/project/tests/plugin/test_loading.py

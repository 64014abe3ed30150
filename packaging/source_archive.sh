#!/usr/bin/env bash
# Builds the source archive vorogeo-VERSION.tar.gz: for PyPI, and what all wheels and recipes are built from.
#
# Usage: packaging/source_archive.sh [FOLDER]       left in FOLDER (default: build/wheels/dist)
#   Two runs on one commit give the same bytes: names are sorted, and owners, permissions and times do not count. The time in it
#   is that of the commit.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
out="${1:-build/wheels/dist}"
tools=build/wheels/venv-source
tree="$(mktemp -d)"
trap 'rm -rf "$tree"' EXIT

# What compiles, with the settings of pyfilter/pyproject.toml at the top. By itself it builds the numpy part, which needs no
# more than a compiler and the headers of Eigen; by CMake it builds the library.
mkdir -p "$out"
git ls-files -z --cached --others --exclude-standard core include plugin pyfilter cmake CMakeLists.txt VERSION LICENSE CHANGELOG.md |
  tar -c --null --dereference --files-from=- | tar -x -C "$tree"
cp pyfilter/README.md pyfilter/NOTICES.txt "$tree/"
rm "$tree/pyfilter/pyproject.toml"
sed -e 's#^wheel.packages = .*#wheel.packages = ["pyfilter/vorogeo"]\ncmake.source-dir = "pyfilter"\ncmake.define.VOROGEO_HOSTS = ""#' \
  -e 's#^input = "../VERSION"#input = "VERSION"#' -e 's#^build-dir = .*#build-dir = "build/{wheel_tag}"#' \
  pyfilter/pyproject.toml >"$tree/pyproject.toml"

# Its own version is part of what decides the bytes.
[ -x "$tools/bin/python" ] || { python3 -m venv "$tools" && "$tools/bin/pip" install -q build scikit-build-core==1.1.2; }
SOURCE_DATE_EPOCH="$(git log -1 --format=%ct)" \
  "$tools/bin/python" -m build --sdist --no-isolation --skip-dependency-check --outdir "$out" "$tree"

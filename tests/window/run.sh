#!/usr/bin/env bash
# Tests the plugin in the real MeshLab window, without a screen: MeshLab of the right Debian in a root of its own.
#
# Usage: tests/window/run.sh [2022.02|2025.07]... [-- PYTEST OPTIONS]
#   Without a version: both. The first time it downloads some 700 MB and takes several minutes; later it takes about
#   one per version. Pictures: build/window/VERSION/seen/shots. Needs what samples/setup.sh sets up, and the rights of root.
# Exit status 77 where no root can be made; the reason stands on the standard error.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

versions=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do
  versions+=("$1")
  shift
done
[ $# -eq 0 ] || shift
[ ${#versions[@]} -gt 0 ] || versions=(2022.02 2025.07)
python="$PWD/.venv/bin/python"
say() { printf 'window %s: %s\n' "$version" "$*"; }

for version in "${versions[@]}"; do
  root="$(tests/window/make_root.sh "$version")"
  # One run at a time in a root: the plugin is installed there, and taken away for a while.
  exec {turn}>"$root/etc/vorogeo-window.lock"
  flock "$turn"
  say "building and installing the plugin"
  folder="build/window/$version"
  mkdir -p "$folder"
  if ! tests/window/build_plugin.sh "$version" "$root" >"$folder/build.log" 2>&1; then
    tail -n 30 "$folder/build.log"
    exit 1
  fi
  say "driving MeshLab (pictures: $folder/seen/shots)"
  rm -rf "$folder/seen"
  for script in scenario refusals filter_script edits loading; do
    "$python" tests/window/make_meshes.py "$folder/seen/meshes" # scripts save over them
    log="$folder/seen/$script-run.log"
    timeout 1200 tests/window/in_root.sh "$root" dbus-run-session -- \
      python3 "/project/tests/window/$script.py" "/project/$folder/seen" >"$log" 2>&1 || tail -n 15 "$log"
  done
  VOROGEO_WINDOW_RESULTS="$PWD/$folder/seen" "$python" -m pytest -q -p no:cacheprovider tests/window \
    -o "junit_suite_name=window-$version" "$@"
  exec {turn}>&-
done

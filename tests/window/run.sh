#!/usr/bin/env bash
# Tests the plugin in the real MeshLab window, on a virtual display: the MeshLab of a Debian in a root of its own.
#
# Usage: tests/window/run.sh [--large | --random COUNT] [--zip FILE] [2022.02|2025.07]... [-- PYTEST OPTIONS]
#   --large: instead of the tests, work on a mesh of two million vertices, some half an hour on two idle cores; prints the
#     time of each filter and the longest time in which the window did not answer (tests/window/large_mesh.py).
#   --random: instead of the tests, so many sequences of random steps (tests/window/random_steps.py), some ten seconds each.
#   --zip: test the plugin in this archive (plugin/build_zip.sh) instead of one that is built here.
#   Without a version: both, 2022.02 only through what differs between the two. The first time it downloads some 700 MB and
#   takes several minutes; later it takes about one per version. Pictures: build/window/VERSION/seen/shots. Needs what
#   samples/setup.sh sets up, and root's rights.
# Exit status 77 where no root can be made; the reason stands on the standard error.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

versions=()
large=no
random=
zip=
while [ $# -gt 0 ] && [ "$1" != -- ]; do
  case "$1" in
    --large) large=yes ;;
    --random) random="$2"; shift ;;
    --zip) zip="$2"; shift ;;
    *) versions+=("$1") ;;
  esac
  shift
done
[ $# -eq 0 ] || shift
[ ${#versions[@]} -gt 0 ] || versions=(2022.02 2025.07)
python="$PWD/.venv/bin/python"
say() { printf 'window %s: %s\n' "$version" "$*"; }

# Usage: drive SECONDS SCRIPT FOLDER [ARGUMENTS]
drive() {
  timeout "$1" tests/roots/in_root.sh "$root" dbus-run-session -- python3 "/project/tests/window/$2.py" "/project/$3" "${@:4}"
}

for version in "${versions[@]}"; do
  root="$(tests/window/make_root.sh "$version")"
  # One run at a time in a root: the plugin is installed there, and taken away for a while.
  exec {lock}>"$root/etc/vorogeo-window.lock"
  flock "$lock"
  folder="build/window/$version"
  install=(tests/window/build_plugin.sh "$version" "$root")
  if [ -n "$zip" ]; then
    folder="build/window/$version-zip"
    install=(tests/window/install_zip.sh "$version" "$root" "$zip" "$folder/plugin")
  fi
  say "installing the plugin"
  mkdir -p "$folder"
  if ! "${install[@]}" >"$folder/build.log" 2>&1; then
    tail -n 30 "$folder/build.log"
    exit 1
  fi
  if [ "$large" = yes ]; then
    say "driving MeshLab with a mesh of two million vertices (pictures: $folder/large/shots)"
    rm -rf "$folder/large"
    mkdir -p "$folder/large/shots"
    "$python" tests/window/make_meshes.py "$folder/large/meshes" large
    drive 9000 large_mesh "$folder/large"
    exec {lock}>&-
    continue
  fi
  if [ -n "$random" ]; then
    say "driving MeshLab through $random sequences of random steps (pictures: $folder/random/shots)"
    rm -rf "$folder/random"
    "$python" tests/window/make_meshes.py "$folder/random/meshes"
    log="$folder/random/run.log"
    drive $((300 + 60 * random)) random_steps "$folder/random" "$random" >"$log" 2>&1 || tail -n 15 "$log"
    VOROGEO_WINDOW_RESULTS="$PWD/$folder/random" "$python" -m pytest -q -p no:cacheprovider tests/window/test_random_steps.py "$@"
    exec {lock}>&-
    continue
  fi
  # What is refused, edited and scripted is the same code under both versions; starting, dialogs and loading are not.
  scripts=(scenario ruler ruler_layer ruler_table ruler_choices loading extra_folder)
  judges=(tests/window/test_{window,ruler,ruler_table,ruler_choices,loading}.py)
  if [ -n "$zip" ]; then
    scripts=(scenario loading)
    judges=(tests/window/test_{window,loading}.py -k "not one_user")
  elif [ "$version" = 2025.07 ]; then
    scripts=(scenario refusals filter_script edits random_steps ruler ruler_layer ruler_table ruler_choices ruler_snapshot
      ruler_density loading extra_folder)
    judges=(tests/window)
  fi
  say "driving MeshLab (pictures: $folder/seen/shots)"
  rm -rf "$folder/seen"
  for script in "${scripts[@]}"; do
    "$python" tests/window/make_meshes.py "$folder/seen/meshes" # scripts save over them
    log="$folder/seen/$script-run.log"
    drive 2400 "$script" "$folder/seen" >"$log" 2>&1 || tail -n 15 "$log"
  done
  VOROGEO_WINDOW_RESULTS="$PWD/$folder/seen" "$python" -m pytest -q -p no:cacheprovider "${judges[@]}" \
    -o "junit_suite_name=window-$version" "$@"
  exec {lock}>&-
done

#!/usr/bin/env bash
# The own tests of gdist and pygeodesic, answered by vorogeo. They are obtained when this is run, and are not part of this
# repository.
#
# Usage: tests/peers/run.sh [OPTIONS OF pytest]
# VOROGEO_GDIST_SOURCE, VOROGEO_PYGEODESIC_SOURCE: checkouts of both; without one, it is cloned from GitHub into build/peers. Exit
# status 77, with the reason in the last line, if one cannot be had.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
project="$PWD"

# Usage: checkout NAME REPOSITORY FOLDER-OR-NOTHING; prints the folder
checkout() {
  local folder="${3:-$project/build/peers/$1}"
  if [ ! -d "$folder/tests" ]; then
    [ -z "${3:-}" ] || return 1
    rm -rf "$folder"
    mkdir -p "$(dirname "$folder")"
    timeout 120 git clone --quiet --depth 1 "https://github.com/$2" "$folder" >&2 || return 1
  fi
  echo "$folder"
}

gdist="$(checkout gdist the-virtual-brain/tvb-gdist "${VOROGEO_GDIST_SOURCE:-}")" ||
  { echo "the tests of gdist cannot be cloned, or VOROGEO_GDIST_SOURCE has none"; exit 77; }
pygeodesic="$(checkout pygeodesic mhogg/pygeodesic "${VOROGEO_PYGEODESIC_SOURCE:-}")" ||
  { echo "the tests of pygeodesic cannot be cloned, or VOROGEO_PYGEODESIC_SOURCE has none"; exit 77; }

# Their tests import the packages by name: these folders come before those that are installed.
status=0
for peer in "$gdist/tests/test_gdist.py" "$pygeodesic/tests/test_pygeodesic.py"; do
  (cd "$(dirname "$peer")/.." && PYTHONPATH="$project/tests/peers" PYTHONSAFEPATH=1 "$project/.venv/bin/python" \
    -m pytest -q -p no:cacheprovider --import-mode=importlib "$@" "$peer") || status=1
done
exit "$status"

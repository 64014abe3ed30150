#!/usr/bin/env bash
# Hostile meshes of several sizes through everything, on all cores; ends with how many were run and what was found.
#
# Usage: tests/fuzz/run.sh [--sanitized] [--hours H | --count N] [OPTIONS OF hostile_fuzz]
#   --hours: as many as fit; one hour is for 10,000 meshes on two cores. Without either: 1,000 meshes.
# The findings are printed as they come, and lie in build/fuzz. The status is 1 if there is one of a kind that
# allowed.txt next to this script does not name.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

program=hostile_fuzz
if [ "${1:-}" = --sanitized ]; then
  program=hostile_fuzz_sanitized
  shift
fi
jobs="${VOROGEO_JOBS:-$(nproc)}"
cmake --preset release >/dev/null
cmake --build --preset release --parallel "$jobs" --target "$program" >/dev/null
mkdir -p build/fuzz
findings="build/fuzz/$program.txt"
status=0
"build/release/tests/$program" --mixed --jobs "$jobs" "$@" | tee "$findings" || status=$?
if [ "$status" = 1 ] && grep -q '^FINDING' "$findings"; then
  echo "kinds of findings (the first two of a kind on each mesh):"
  sed -n 's/^FINDING //p' "$findings" | sort | uniq -c | sort -rn
  sed -n 's/^FINDING //p' "$findings" | grep -vxFf <(grep -v '^#' tests/fuzz/allowed.txt) >/dev/null || status=0
fi
exit "$status"

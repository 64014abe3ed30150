#!/usr/bin/env bash
# Hostile meshes of several sizes through everything, on all cores; ends with how many were run and what was found.
#
# Usage: tests/fuzz/run.sh [--sanitized | --report | --named] [--hours H | --count N] [OPTIONS OF hostile_fuzz]
#   --hours: as many as fit; one hour is for 10,000 meshes on two cores. Without either: 1,000 meshes.
#   --report: writes what was tried, and the worst of each kind, to docs/hostile.md.
#   --named: the meshes of named_seeds.txt, one after another, each with a summary of its own.
# The findings are printed as they come, and lie in build/fuzz. The status is 1 if there is one that allowed.txt next
# to this script does not name, or whose cost is more times a scan's than it says there.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

program=hostile_fuzz
report=
if [ "${1:-}" = --report ]; then
  report=docs/hostile.md
  shift
fi
if [ "${1:-}" = --sanitized ]; then
  program=hostile_fuzz_sanitized
  shift
fi
named=no
if [ "${1:-}" = --named ]; then
  named=yes
  shift
fi
jobs="${VOROGEO_JOBS:-$(nproc)}"
cmake --preset release >/dev/null
cmake --build --preset release --parallel "$jobs" --target "$program" >/dev/null
mkdir -p build/fuzz
findings="build/fuzz/$program.txt"
# Usage: run_meshes OPTIONS OF hostile_fuzz
run_meshes() {
  local seed vertices status worst=0
  if [ "$named" = no ]; then
    "build/release/tests/$program" --mixed --jobs "$jobs" "$@"
    return
  fi
  while read -r seed vertices; do
    "build/release/tests/$program" --first "$seed" --count 1 --vertices "$vertices" "$@" || { status=$?; ((status <= worst)) || worst=$status; }
  done < <(grep -v '^#' tests/fuzz/named_seeds.txt)
  return "$worst"
}
status=0
run_meshes "$@" | tee "$findings" || status=$?
if [ "$status" = 1 ] && grep -q '^FINDING' "$findings"; then
  echo "kinds of findings (the first two of a kind on each mesh):"
  sed -n 's/^FINDING //p' "$findings" | sort | uniq -c | sort -rn
  # Of a finding: "FINDING time of build", "  1.5 s, a scan no smaller takes 0.1 s", "  again: hostile_fuzz --seed 3 ...".
  awk '
    NR == FNR { if (/^[0-9]/) { times = $1; sub(/^[0-9]+ /, ""); most[$0] = times }; next }
    /^FINDING / { kind = substr($0, 9); cost = 1; usual = 1 }
    /, a scan no smaller takes / { cost = $1; usual = $(NF - 1) }
    /^  again: / { sub(/.*hostile_fuzz /, ""); if (cost > most[kind " " $0] * usual) exit 1 }
  ' tests/fuzz/allowed.txt "$findings" && status=0
fi
if [ -n "$report" ]; then
  {
    sed '/^| times/,$d' "$report"
    sed -n '/^| times/,$p' "$findings" | sed '$d'
    echo "$(tail -n 1 "$findings" | sed 's/ in [0-9]* s / /'): \`tests/fuzz/run.sh --report $*\`."
    sed -n 's/^FINDING //p' "$findings" | sort | uniq -c | sort -rn | sed 's/^ *\([0-9]*\) \(.*\)/- \1 times: \2/'
  } >"$report.new"
  mv "$report.new" "$report"
fi
exit "$status"

#!/usr/bin/env bash
# Says which functions of the core take the time of the exact solver, the build, a field and two points. Does its own set-up.
#
# Usage: tests/bench/profile.sh [--write] [MESH]   (default igea; a mesh that tests/bench/run.sh has measured)
#   --write: also refresh the table of docs/figures.md.
# Needs perf (Debian: linux-perf) and, in containers, the right to sample a clock. Samples lie in build/bench-work/profile.
set -euo pipefail
bench="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
root="$bench/../.."
write=""
if [ "${1:-}" = --write ]; then
  write=--write
  shift
fi
name="${1:-igea}"
bash "$root/samples/setup.sh" --bench >&2
command -v perf >/dev/null || { echo "profile.sh: perf is missing: apt-get install linux-perf" >&2; exit 1; }
work="$root/build/bench-work"
mesh="$work/$name.raw" index="$work/$name.vgi"
for file in "$mesh" "$index" "$work/$name.far" "$work/$name.near"; do
  [ -f "$file" ] || { echo "profile.sh: there is no $file; run tests/bench/run.sh --no-peers $name first" >&2; exit 1; }
done
mkdir -p "$work/profile"

# Usage: profile NAME TASK ARGUMENTS...
profile() {
  local data="$work/profile/$1.data"
  shift
  perf record -e cpu-clock -F 499 -q -o "$data" -- "$root/build/bench/tests/bench/core_bench" "$@" >/dev/null
}
profile exact exact "$mesh" 0 1000 2000
profile build build "$mesh" 2 "$work/profile/index"
profile field fields "$mesh" "$index" 1 200 0 1000 2000
profile far pairs "$mesh" "$index" "$work/$name.far" 200
profile near pairs "$mesh" "$index" "$work/$name.near" 30
rm -f "$work/profile/index"
"$root/build/venv-bench/bin/python" "$bench/profile_table.py" "$work/profile" $write

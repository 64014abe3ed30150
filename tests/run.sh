#!/usr/bin/env bash
# Runs the tests: sets up what they need, builds, and ends with the line "N passed, N failed".
#
# Usage: tests/run.sh [--quick | --all]
#   By default what a change needs before it lands: C++ and Python with the newest PyMeshLab, hostile meshes, and the contract,
#   kernels and files under sanitizers; some 15 minutes on two cores after set-up.
#   --quick: C++, Python and the newest PyMeshLab alone; some 4 minutes.
#   --all: also older PyMeshLab versions, the core for arm64 and with libc++, all wheels, recipes, peers' own tests, long fuzzing, the
#     thread sanitizer, and the real window of MeshLab in both versions. What needs the rights of root (and some 10 GB) is skipped where
#     it cannot be run, with the reason.
# Needs no terminal and may be run as often as you like; what is built is not built again. Logs and results lie in
# build/test-results. VOROGEO_FUZZ_SECONDS: how long the fuzzer of index files runs (20, with --all 300); that of meshes runs a
# quarter of it.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exec </dev/null

quick=no
all=no
for argument in "$@"; do
  case "$argument" in
    --quick) quick=yes ;;
    --all) all=yes ;;
    *) echo "tests/run.sh: unknown argument '$argument'; usage: tests/run.sh [--quick | --all]" >&2; exit 2 ;;
  esac
done
[ "$quick$all" != yesyes ] || { echo "tests/run.sh: give --quick or --all, not both" >&2; exit 2; }

jobs="${VOROGEO_JOBS:-$(nproc)}"
[ "$all" = yes ] && fuzz_seconds=300 meshes_of_today=2000 || fuzz_seconds=20 meshes_of_today=200
fuzz_seconds="${VOROGEO_FUZZ_SECONDS:-$fuzz_seconds}"
results=build/test-results
rm -rf "$results"
mkdir -p "$results"
checks="$results/checks.txt"  # one line per check that is no test framework's: pass|fail|skip NAME
: >"$checks"
say() { printf '[%4ds] %s\n' "$SECONDS" "$*"; }

# Runs a command and notes its seconds, those of the clock and of the processor, for the table at the end.
# Usage: timed NAME COMMAND...
timed() {
  local name="$1" TIMEFORMAT="%R %U %S $1"
  shift
  { time "$@" 2>&3; } 3>&2 2>>"$results/times.txt"
}

# Runs a command as one check with a log; the end of the log is shown if it fails.
# Usage: check NAME COMMAND...
check() {
  local name="$1" log
  log="$results/$(tr -c 'a-z0-9\n' '_' <<<"${1,,}").log"
  shift
  say "$name"
  if timed "$name" "$@" >"$log" 2>&1; then
    echo "pass $name" >>"$checks"
  else
    echo "fail $name (log: $log)" >>"$checks"
    tail -n 25 "$log"
    return 1
  fi
}

# A test run that reports by itself into a JUnit file; that it wrote one is part of the check.
# Usage: suite NAME COMMAND...
suite() {
  local name="$1"
  shift
  say "$name"
  timed "$name" "$@" >"$results/$name.log" 2>&1
  note_end "$name" $?
}

# The end of a run that reports by itself: a failed test is in its file; a crash at the end, or a test that never ran, is not.
# Usage: note_end NAME STATUS
note_end() {
  local name="$1" status="$2" log="$results/$1.log" why=""
  if [ ! -s "$results/$name.xml" ]; then
    why="wrote no results"
  elif [ "$status" != 0 ] && ! grep -qE '<(failure|error)[ >]' "$results/$name.xml"; then
    why="ended badly though no test failed"
  fi
  [ -n "$why" ] || return 0
  echo "fail $name $why (exit $status, log: $log)" >>"$checks"
  tail -n 25 "$log"
}

# Usage: build PRESET [CMAKE OPTIONS]
build() {
  local preset="$1"
  shift
  cmake --preset "$preset" "$@" && cmake --build --preset "$preset" --parallel "$jobs"
}

# One process per core, each with its part of the tests: a start takes as long as many a test.
# Usage: run_shard PROGRAM NAME SHARD [OPTIONS OF GOOGLETEST]
run_shard() {
  GTEST_TOTAL_SHARDS="$jobs" GTEST_SHARD_INDEX="$3" timeout 1800 "build/release/tests/$1" \
    "--gtest_output=xml:$results/$2-$3.xml" "${@:4}"
}
# Usage: cpp_suite PROGRAM NAME [OPTIONS OF GOOGLETEST]
cpp_suite() {
  local shard shards=()
  for ((shard = 0; shard < jobs; shard++)); do
    suite "$2-$shard" run_shard "$1" "$2" "$shard" "${@:3}" &
    shards+=($!)
  done
  wait "${shards[@]}"
}

# Usage: run_pytest NAME PYTHON FOLDERS...
run_pytest() {
  local name="$1" python="$2"
  shift 2
  env -u VOROGEO_PLUGIN_BUILD "$python" -m pytest -q -rs -p no:cacheprovider \
    --junitxml="$results/$name.xml" "$@"
}

cpp_sources() { git ls-files -z --cached --others --exclude-standard '*.cpp' '*.h'; }
check_cpp_format() { cpp_sources | xargs -0 clang-format --dry-run -Werror; }
python_sources() { git ls-files -z --cached --others --exclude-standard '*.py' '*.pyi'; }
check_python_format() { python_sources | xargs -0 .venv/bin/ruff format --check; }

# Ends the run: the summary, and a status that says whether anything failed.
finish() {
  say "done"
  echo "$SECONDS 0 0 whole run" >>"$results/times.txt"  # of its steps, some ran at a time
  if ! command -v python3 >/dev/null; then
    cat "$checks"
    echo "0 passed, 1 failed"
    exit 1
  fi
  python3 tests/count_results.py "$results"
  exit $?
}

setup=--daily
[ "$all" = no ] || setup=--tests
if ! timed "set-up" bash samples/setup.sh "$setup"; then
  echo "fail set-up (samples/setup.sh $setup)" >>"$checks"
  finish
fi

# What is run in Debian roots: exit status 77 where none can be made, with the reason in the last line of the log.
# Usage: rooted_suite NAME COMMAND...
rooted_suite() {
  local name="$1" status=0 log="$results/$1.log"
  shift
  say "$name"
  timed "$name" "$@" >"$log" 2>&1 || status=$?
  if [ "$status" = 77 ]; then
    echo "skip $name: $(tail -n 1 "$log")" >>"$checks"
  elif [ -s "$results/$name.xml" ]; then
    note_end "$name" "$status"
  elif [ "$status" = 0 ]; then
    echo "pass $name" >>"$checks"
  else
    echo "fail $name (exit $status, log: $log)" >>"$checks"
    tail -n 25 "$log"
  fi
}
# Usage: window_suite VERSION JOBS
window_suite() {
  VOROGEO_JOBS="$2" rooted_suite "window-$1" tests/window/run.sh "$1" -- "--junitxml=$results/window-$1.xml"
}

# All of this runs in parallel with the checks below: it downloads, waits for windows, and seldom needs more than one core. When
# the second version is built, the checks are done or nearly so.
if [ "$all" = yes ]; then
  { window_suite 2022.02 1; window_suite 2025.07 "$jobs"; } &
  window_suites=$!
fi

check "format of C++" check_cpp_format
check "format of Python" check_python_format
check "rules for Python (ruff)" .venv/bin/ruff check .
suite structure run_pytest structure .venv/bin/python tests/structure
check "types of Python (mypy)" .venv/bin/mypy --config-file pyfilter/pyproject.toml --package vorogeo  # as installed

# The plugin is loaded by the tests themselves in one folder and by the package vorogeo in the other, and cannot be
# unloaded: each folder has a process of its own. A quick run leaves out what other programs do with the package.
python_newer() {
  local python=.venv/bin/python others=(tests/python tests/wheels) beside
  [ "$quick" = no ] || others=(tests/python --ignore=tests/python/test_{bench,cli_batch,dask}.py)
  {
    suite plugin-2025.7 run_pytest plugin-2025.7 "$python" tests/plugin --ignore=tests/plugin/test_older_pymeshlab.py
    suite python-2025.7 run_pytest python-2025.7 "$python" "${others[@]}" --ignore-glob='*/test_numpy_*'
  } &
  beside=$!
  [ "$quick" = yes ] || wait "$beside"  # the other core builds what sanitizers watch
  suite numpy-2025.7 run_pytest numpy-2025.7 "$python" tests/contract tests/python/test_numpy_*.py
  wait "$beside"
}
if [ "$quick" = yes ]; then  # beside the C++ tests, so that both cores are busy
  python_newer &
  newer=$!
fi

# The public header for VCG meshes is tested where set-up has obtained the host's headers.
vcg="$(find "$PWD/build/host" -maxdepth 4 -type d -path '*/2025.07/*' -name vcglib 2>/dev/null | head -n 1)"
if check "build of the C++ tests" build release "-DVOROGEO_VCG_INCLUDE_DIR=$vcg"; then
  cpp_suite core_tests cpp
  [ ! -x build/release/tests/library_tests ] || suite cpp-library build/release/tests/library_tests "--gtest_output=xml:$results/cpp-library.xml"
  if [ "$quick" = no ]; then
    check "installed library" tests/library/run.sh build/release "$vcg"
    # With costs, so of seeds that do not change: on these no step takes more than a third of its bound.
    check "costs of hostile meshes" tests/fuzz/run.sh --first 4294180036 --count 113
    [ "$all" = no ] || check "hostile meshes with a name" tests/fuzz/run.sh --named
    check "hostile meshes" tests/fuzz/run.sh --count 400 --vertices 50 --no-costs
    check "hostile meshes of all kinds" tests/fuzz/run.sh --first 4000040000 --count 300 --vertices 50 --no-costs
    # About one unseen mesh in 500 has a vertex whose index field errs by more than 1 %: fixed seeds hold that bound.
    check "hostile meshes of today" tests/fuzz/run.sh --count "$meshes_of_today" --of-today --no-costs --error 0.1
    check "large hostile meshes of today" tests/fuzz/run.sh --count 20 --vertices 4000 --of-today --exact-only
  fi
fi

# That the core and the header compile without a warning where there is no machine to run them on: for arm64, and with the C++
# library of macOS. The units are those of the release build. The samples see the header as users do.
# Usage: compile_for COMPILER OPTIONS...
compile_for() {
  local unit
  for unit in build/release/core/CMakeFiles/vorogeo_{core,methods}.dir/Unity/*.cxx core/index/scans.cpp core/vorogeo*.cpp \
              samples/cpp/{first_field,many_pairs,path_to_obj}.cpp ${vcg:+samples/cpp/from_vcg.cpp}; do
    "$@" -std=c++20 -O1 -Wall -Wextra -Wpedantic -Werror -fsyntax-only -Icore -Iinclude -isystem /usr/include/eigen3 \
      ${vcg:+-isystem "$vcg"} "$unit" || return 1
  done
}
# Usage: compile_check NAME COMPILER OPTIONS...
compile_check() {
  if command -v "$2" >/dev/null; then
    check "$1" compile_for "${@:2}"
  else
    echo "skip $1: no $2" >>"$checks"
  fi
}
if [ "$all" = yes ]; then
  compile_check "core for arm64" aarch64-linux-gnu-g++ -Wno-psabi
  compile_check "core with libc++" clang++-16 -stdlib=libc++
fi

# Older PyMeshLab versions are asked only for what differs between them: loading, registration, parameters and files, the
# host's own methods, and how the package finds its plugin.
older=()
for name in loading registration index_filters path_filters method_comparison filter_scripts host_conditions; do
  older+=("tests/plugin/test_$name.py")
done
# Usage: python_older PYMESHLAB
python_older() {
  local python="build/venv-${1%.*}/bin/python"
  suite "plugin-$1" run_pytest "plugin-$1" "$python" "${older[@]}"
  suite "python-$1" run_pytest "python-$1" "$python" tests/python/test_python_{plugin,package}.py
}
all_older() {
  local log=build/logs/headers-2023.12.log
  python_older 2022.2
  if plugin/host/obtain_headers.sh 2023.12 >/dev/null 2>"$log"; then
    python_older 2023.12
  else
    echo "skip PyMeshLab 2023.12: the headers of MeshLab 2023.12 cannot be had: $(grep -o 'git clone: .*' "$log")" >>"$checks"
  fi
}
if [ "$quick" = no ]; then
  python_newer &
  newer=$!
fi
[ "$all" = no ] || all_older

if [ "$quick" = no ]; then
  if check "build of the core with sanitizers" \
      cmake --build build/release --parallel "$jobs" --target sanitized_tests; then
    watched='*Contract.*:SharedRun.*:BucketQueue.*:*Envelope*:*File*:*DamagedIndex*:*Defects*'
    watched+=':Surface*:Workers*:ManyPairs*'  # threads
    cpp_suite core_tests_sanitized cpp-sanitized "--gtest_filter=$watched-Seeds/*"
    check "fuzz index files" timeout $((fuzz_seconds + 120)) build/release/tests/index_file_fuzz "$fuzz_seconds" &
    fuzzer=$!
    check "hostile meshes with sanitizers" tests/fuzz/run.sh --sanitized --count 50 --vertices 25
    check "spoilt meshes with sanitizers" tests/fuzz/run.sh --sanitized --count 50 --vertices 25 --spoilt
    wait "$fuzzer"
  fi
  if [ "$all" = yes ] && check "build of the core with the thread sanitizer" \
      cmake --build build/release --parallel "$jobs" --target core_tests_threads; then
    # Only suites of what threads share are compiled into it; this one has a limit of time, and no threads.
    cpp_suite core_tests_threads cpp-threads "--gtest_filter=-Territories.*"
  fi
fi
wait "$newer"
if [ "$all" = yes ]; then
  wait "$window_suites"
  rooted_suite wheels tests/wheels/run.sh
  rooted_suite windows tests/wheels/windows.sh -- "--junitxml=$results/windows.xml"
  rooted_suite aarch64 tests/wheels/aarch64.sh
  rooted_suite "own tests of peers" tests/peers/run.sh
  check "source archive and recipes" packaging/check.sh
  rooted_suite debian packaging/build_debian.sh
else
  echo "skip what only --all runs: MeshLab's window, PyMeshLab 2022.2 and 2023.12, arm64, libc++, wheels, recipes, the thread sanitizer, long fuzzing" >>"$checks"
fi
[ "$quick" = no ] || echo "skip what --quick leaves out: sanitizers, fuzzers, hostile meshes, the installed library, other programs with the package" >>"$checks"
finish

#!/usr/bin/env bash
# Measures one page of figures, and prints its tables. Does its own set-up.
# Usage: tests/bench/run.sh PAGE [OPTIONS]; --help names the pages, PAGE --help their options.
set -euo pipefail
bench="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
bash "$bench/../../samples/setup.sh" --bench >&2
exec "$bench/../../build/venv-bench/bin/python" "$bench/bench.py" "$@"

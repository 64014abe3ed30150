#!/usr/bin/env bash
# Measures time and memory against the size of the mesh and draws them. Does its own set-up.
# Usage: tests/bench/growth.sh [OPTIONS] [SIZE...]; --help names the options.
set -euo pipefail
bench="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
bash "$bench/../../samples/setup.sh" --bench >&2
exec "$bench/../../build/venv-bench/bin/python" "$bench/growth.py" "$@"

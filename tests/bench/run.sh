#!/usr/bin/env bash
# Compares VoroGeo with public packages on meshes and prints the tables. Does its own set-up.
# Usage: tests/bench/run.sh [OPTIONS] [MESH...]; --help names the options.
set -euo pipefail
bench="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
bash "$bench/../../samples/setup.sh" --bench >&2
exec "$bench/../../build/venv-bench/bin/python" "$bench/bench.py" "$@"

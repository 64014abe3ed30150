#!/usr/bin/env bash
# Measures the time of many fields by the automatic choice beside each fixed one. Does its own set-up.
# Usage: tests/bench/choosing.sh [--write] [MESH[:SIZE]...]
set -euo pipefail
bench="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
bash "$bench/../../samples/setup.sh" --bench >&2
exec "$bench/../../build/venv-bench/bin/python" "$bench/choosing.py" "$@"

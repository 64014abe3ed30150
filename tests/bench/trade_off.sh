#!/usr/bin/env bash
# Measures and draws memory, build and query of both forms of the index against their accuracy. Does its own set-up.
# Usage: tests/bench/trade_off.sh [MESH]
set -euo pipefail
bench="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
bash "$bench/../../samples/setup.sh" --bench >&2
exec "$bench/../../build/venv-bench/bin/python" "$bench/trade_off.py" "$@"

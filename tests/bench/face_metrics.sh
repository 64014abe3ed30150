#!/usr/bin/env bash
# Measures fields and pairs in metrics that jump at edges against formulas. Does its own set-up.
# Usage: tests/bench/face_metrics.sh [--cells N] [--pairs K]
set -euo pipefail
bench="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
bash "$bench/../../samples/setup.sh" --bench >&2
exec "$bench/../../build/venv-bench/bin/python" "$bench/face_metrics.py" "$@"

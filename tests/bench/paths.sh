#!/usr/bin/env bash
# Paths of many random pairs against exact fields: errors, what is certified, and times. Does its own set-up.
# Usage: tests/bench/paths.sh [--pairs N] [--points] [--landmarks K] [--write] [MESH...]; --help says what they mean.
set -euo pipefail
bench="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
bash "$bench/../../samples/setup.sh" --bench >&2
exec "$bench/../../build/venv-bench/bin/python" "$bench/paths.py" "$@"

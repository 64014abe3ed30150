#!/usr/bin/env bash
# Measures the methods of docs/methods.md, and public code of them beside; with --gaps, bridging. Does its own set-up.
# Usage: tests/bench/literature.sh [--sources K] [--methods NAMES] [--gaps] MESH...
set -euo pipefail
bench="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
bash "$bench/../../samples/setup.sh" --bench >&2
exec "$bench/../../build/venv-bench/bin/python" "$bench/literature.py" "$@"

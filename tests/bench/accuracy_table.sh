#!/usr/bin/env bash
# Measures the index on meshes and refreshes the table in docs/figures.md. Does its own set-up.
# Usage: tests/bench/accuracy_table.sh [--sources N] [--dry-run] [MESH...]; see accuracy_table.py.
set -euo pipefail
bench="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
bash "$bench/../../samples/setup.sh" >&2
exec "$bench/../../.venv/bin/python" "$bench/accuracy_table.py" "$@"

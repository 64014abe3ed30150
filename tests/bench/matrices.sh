#!/usr/bin/env bash
# Matrices of all distances, float32, into a file: time, memory and errors beside other packages. Does its own set-up.
# Usage: tests/bench/matrices.sh [--seconds S] [--whole] [--write] MESH[@VERTICES]...; --help says what they mean.
set -euo pipefail
bench="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
bash "$bench/../../samples/setup.sh" --bench >&2
exec "$bench/../../build/venv-bench/bin/python" "$bench/matrices.py" "$@"

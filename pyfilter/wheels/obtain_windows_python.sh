#!/usr/bin/env bash
# Obtains CPython for Windows, with its headers and import library, from Maven Central: to compile against, and to run under wine.
#
# Usage: obtain_windows_python.sh       prints its folder, which is kept: build/windows/python-3.11
# Exit status 77 with a sentence on the standard error where it cannot be had.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
artifact=org.bytedeco:cpython:3.11.3-1.5.9:jar:windows-x86_64
folder=build/windows/python-3.11
log=build/windows/python.log

cannot() {
  echo "CPython for Windows cannot be had here: $*" >&2
  exit 77
}
if [ ! -f "$folder/python.exe" ]; then
  command -v mvn >/dev/null || cannot "Maven is not installed (apt-get install maven)"
  mkdir -p build/windows
  work="$(mktemp -d build/windows/.making-XXXXXX)"
  trap 'rm -rf "$work"' EXIT
  mvn -B -q dependency:copy "-Dartifact=$artifact" "-DoutputDirectory=$PWD/$work" >"$log" 2>&1 ||
    cannot "Maven does not get $artifact (log: $log)"
  python3 -m zipfile -e "$work"/cpython-*.jar "$work/unpacked"
  mv "$work/unpacked/org/bytedeco/cpython/windows-x86_64" "$folder"
fi
echo "$PWD/$folder"

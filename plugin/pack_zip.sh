#!/usr/bin/env bash
# Packs plugins for MeshLab's window into an archive for people, with the page that says where to put them.
#
# Usage: plugin/pack_zip.sh ZIP VERSION=LIBRARY...
#   In the archive each library is VERSION/libfilter_vorogeo.so, below a folder named like the archive, and beside it is
#   libedit_vorogeo.so, which lies beside the LIBRARY.
set -euo pipefail
project="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
mkdir -p "$(dirname "$1")"
zip="$(cd "$(dirname "$1")" && pwd)/$(basename "$1")"
shift
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
top="$work/$(basename "$zip" .zip)"
mkdir "$top"
cp "$project"/{LICENSE,pyfilter/NOTICES.txt,plugin/INSTALL.md} "$top"
for plugin in "$@"; do
  mkdir "$top/${plugin%%=*}"
  cp "${plugin#*=}" "$top/${plugin%%=*}/libfilter_vorogeo.so"
  cp "$(dirname "${plugin#*=}")/libedit_vorogeo.so" "$top/${plugin%%=*}/"
done
(cd "$work" && python3 -m zipfile -c whole.zip "$(basename "$top")")
mv "$work/whole.zip" "$zip"

#!/usr/bin/env bash
# Installs the plugin in a root from the archive that users get, as plugin/INSTALL.md says.
#
# Usage: install_zip.sh 2022.02|2025.07 ROOT ZIP FOLDER
#   FOLDER gets the unpacked archive; MeshLab's dialog can load FOLDER/plugin/libfilter_vorogeo.so.
set -euo pipefail
version="$1" root="$2" zip="$3" folder="$4"
plugins="$root/usr/lib/x86_64-linux-gnu/meshlab/plugins"
rm -rf "$folder/unpacked"
mkdir -p "$folder/unpacked" "$folder/plugin"
python3 -m zipfile -e "$zip" "$folder/unpacked"
file="$(find "$folder/unpacked" -path "*/$version/libfilter_vorogeo.so")"
[ -n "$file" ] || { echo "install_zip.sh: $zip has no plugin for MeshLab $version" >&2; exit 1; }
for library in "$file" "$(dirname "$file")/libedit_vorogeo.so"; do
  cp "$library" "$folder/plugin/"
  cp "$library" "$plugins/"
done

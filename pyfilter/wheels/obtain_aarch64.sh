#!/usr/bin/env bash
# Brings what code for arm64 is compiled against and run with into a Debian 12 root: Debian's Python 3.11 for arm64 with its headers,
# unpacked into FOLDER beside the system's own, and the libraries for arm64 that Python, Qt and PyMeshLab need.
#
# Usage: obtain_aarch64.sh FOLDER       inside the root
set -euo pipefail
folder="$1"
[ ! -x "$folder/usr/bin/python3.11" ] || exit 0
dpkg --add-architecture arm64
apt-get update -q
# Qt's own programs run here and write code; all else of Qt, and of what PyMeshLab asks for, is for arm64.
apt-get install -q -y --no-install-recommends qtbase5-dev-tools {qtbase5-dev,libqt5opengl5-dev,libglew-dev}:arm64 \
  {libgl1,libopengl0,libegl1,libglu1-mesa,libgomp1,libxrender1,libglib2.0-0,libcom-err2}:arm64 \
  {zlib1g,libexpat1,libffi8,libbz2-1.0,liblzma5}:arm64
work="$(mktemp -d)"
cd "$work"
apt-get download -q {python3.11-minimal,libpython3.11-minimal,libpython3.11-stdlib,libpython3.11-dev}:arm64
for package in *.deb; do dpkg -x "$package" "$folder.new"; done
mv "$folder.new" "$folder"

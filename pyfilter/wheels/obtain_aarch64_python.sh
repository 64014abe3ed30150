#!/usr/bin/env bash
# Unpacks Debian's Python 3.11 for arm64 beside this system's own, with its headers: to compile against, and to run by qemu.
#
# Usage: obtain_aarch64_python.sh FOLDER       inside a Debian 12 root
set -euo pipefail
folder="$1"
[ ! -x "$folder/usr/bin/python3.11" ] || exit 0
dpkg --add-architecture arm64
apt-get update -q
work="$(mktemp -d)"
cd "$work"
apt-get download -q {python3.11-minimal,libpython3.11-minimal,libpython3.11-stdlib,libpython3.11-dev}:arm64 \
  {libc6,libgcc-s1,libstdc++6,zlib1g,libexpat1,libffi8,libbz2-1.0,liblzma5}:arm64
for package in *.deb; do dpkg -x "$package" "$folder.new"; done
mv "$folder.new" "$folder"

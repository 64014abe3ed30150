#!/usr/bin/env bash
# Makes a Debian root with MeshLab, a compiler, and what runs and drives a window on a virtual display.
#
# Usage: make_root.sh 2022.02|2025.07
#   2022.02 is the MeshLab of Debian 13 (trixie), 2025.07 that of Debian unstable (sid). The last line of the standard
#   output is the root's folder, build/window/root-VERSION; it is kept, and remade only if the list of packages changes.
# Exit status 77 with a sentence on the standard error where a root cannot be made.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

version="${1:-}"
case "$version" in
  2022.02) suite=trixie ;;
  2025.07) suite=sid ;;
  *) echo "make_root.sh: name the version of MeshLab, 2022.02 or 2025.07 (got '$version')" >&2; exit 2 ;;
esac
# MeshLab comes with its recommended packages: without them some of its own plugins complain.
tests/roots/make_root.sh "build/window/root-$version" "$suite" meshlab xvfb openbox xdotool imagemagick \
  at-spi2-core dbus gir1.2-atspi-2.0 python3-gi \
  g++ cmake ninja-build qtbase5-dev libqt5opengl5-dev libeigen3-dev libglew-dev
echo "build/window/root-$version"

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
packages=(meshlab xvfb openbox xdotool imagemagick
          at-spi2-core dbus gir1.2-atspi-2.0 python3-gi
          g++ cmake ninja-build qtbase5-dev libqt5opengl5-dev libeigen3-dev libglew-dev)
root="build/window/root-$version"
log="build/window/root-$version.log"
input="$suite ${packages[*]}"

cannot() {
  echo "no root for MeshLab $version can be made here: $*" >&2
  exit 77
}
[ "$(id -u)" = 0 ] || cannot "it needs the rights of root"
unshare --mount --pid --fork --kill-child true 2>/dev/null || cannot "this system gives no namespaces of their own (unshare)"

mkdir -p build/window
exec {lock}>"build/window/.making-$version.lock"  # who comes second finds the root made
flock "$lock"
if [ "$(cat "$root/etc/vorogeo-window" 2>/dev/null)" = "$input" ]; then
  echo "$root"
  exit 0
fi

command -v debootstrap >/dev/null || cannot "debootstrap is not installed (apt-get install debootstrap)"
mirror="$(apt-get indextargets --format '$(REPO_URI)' 'Origin: Debian' 'Label: Debian' 2>/dev/null | sort -u | head -n 1)"
if [ -z "$mirror" ]; then  # before the first apt-get update the origin is not known
  mirror="$(apt-get indextargets --format '$(REPO_URI)' 2>/dev/null | grep -E '/debian/?$' | sort -u | head -n 1 || true)"
fi
[ -n "$mirror" ] || cannot "apt names no Debian mirror (see /etc/apt/sources.list)"

work="$(mktemp -d "build/window/.making-$version-XXXXXX")"
trap 'rm -rf "$work"' EXIT
echo "window: making a Debian root ($suite) with MeshLab $version, some minutes (log: $log)" >&2
debootstrap --variant=minbase "$suite" "$work/root" "$mirror" >"$log" 2>&1 ||
  cannot "debootstrap failed: $(tail -n 1 "$log")"
cp /etc/resolv.conf "$work/root/etc/resolv.conf"
# A test root may be made from a mirror that lags behind (signatures are checked all the same), and if the machine stops
# in the middle it is remade: no need to wait for the disk after each file.
echo 'Acquire::Check-Valid-Until "false";' >"$work/root/etc/apt/apt.conf.d/90vorogeo"
echo force-unsafe-io >"$work/root/etc/dpkg/dpkg.cfg.d/90vorogeo"
tests/window/in_root.sh "$work/root" sh -c "apt-get update -q && apt-get install -q -y ${packages[*]} && apt-get clean" \
  >>"$log" 2>&1 || cannot "its packages could not be installed: $(grep '^E:' "$log" | head -n 1)"
echo "$input" >"$work/root/etc/vorogeo-window"
rm -rf --one-file-system "$root"
mv "$work/root" "$root"
echo "$root"

#!/usr/bin/env bash
# Makes a Debian root in a folder, with packages, from the machine's own Debian mirror.
#
# Usage: make_root.sh FOLDER SUITE [PACKAGE...]
#   FOLDER is kept, and remade only if the suite or the list of packages changes. FOLDER.log is the log. What all roots of
#   a suite have in common is in build/roots/base-SUITE.
# Exit status 77 with a sentence on the standard error where a root cannot be made. Commands run in it by in_root.sh.
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
bases="$here/../../build/roots"
root="$1" suite="$2"
shift 2
log="$root.log"
input="$suite $*"

cannot() {
  echo "no Debian root ($suite) can be made here: $*" >&2
  exit 77
}
[ "$(id -u)" = 0 ] || cannot "it needs the rights of root"
unshare --mount --pid --fork --kill-child true 2>/dev/null || cannot "this system gives no namespaces of their own (unshare)"

mkdir -p "$(dirname "$root")" "$bases"
exec {lock}>"$root.lock"  # who comes second finds the root made
flock "$lock"
if [ "$(cat "$root/etc/vorogeo-root" 2>/dev/null)" = "$input" ]; then
  exit 0
fi

base="$bases/base-$suite"
# A root is made beside its place and moved there when it is complete.
work="$(mktemp -d "$bases/.making-XXXXXX")"
trap 'rm -rf --one-file-system "$work"' EXIT
echo "making a Debian root ($suite) in $root, some minutes (log: $log)" >&2

make_base() {
  local mirror
  command -v debootstrap >/dev/null || cannot "debootstrap is not installed (apt-get install debootstrap)"
  mirror="$(apt-get indextargets --format '$(REPO_URI)' 'Origin: Debian' 'Label: Debian' 2>/dev/null | sort -u | head -n 1)"
  if [ -z "$mirror" ]; then  # before the first apt-get update the origin is not known
    mirror="$(apt-get indextargets --format '$(REPO_URI)' 2>/dev/null | grep -E '/debian/?$' | sort -u | head -n 1 || true)"
  fi
  [ -n "$mirror" ] || cannot "apt names no Debian mirror (see /etc/apt/sources.list)"
  debootstrap --variant=minbase "$suite" "$work/base" "$mirror" >"$log" 2>&1 ||
    cannot "debootstrap failed: $(tail -n 1 "$log")"
  cp /etc/resolv.conf "$work/base/etc/resolv.conf"
  # A root may be made from a mirror that lags behind (signatures are checked all the same), and if the machine stops in
  # the middle it is remade: no need to wait for the disk after each file.
  echo 'Acquire::Check-Valid-Until "false";' >"$work/base/etc/apt/apt.conf.d/90vorogeo"
  echo force-unsafe-io >"$work/base/etc/dpkg/dpkg.cfg.d/90vorogeo"
  mv "$work/base" "$base"
}

: >"$log"
exec {base_lock}>"$base.lock"
flock "$base_lock"
[ -d "$base" ] || make_base
cp -a "$base" "$work/root"
exec {base_lock}>&-
if [ $# -gt 0 ]; then
  "$here/in_root.sh" "$work/root" sh -c "apt-get update -q && apt-get install -q -y $* && apt-get clean" >>"$log" 2>&1 ||
    cannot "its packages could not be installed: $(grep '^E:' "$log" | head -n 1)"
fi
echo "$input" >"$work/root/etc/vorogeo-root"
rm -rf --one-file-system "$root"
mv "$work/root" "$root"

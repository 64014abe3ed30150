#!/usr/bin/env bash
# Finds the source tree of one MeshLab version, whose headers the plugin is compiled with.
#
# Usage: obtain_headers.sh 2022.02|2023.12|2025.07 [FOLDER]
# Tried in this order; the first that fits is taken:
#   1. a folder the user names: FOLDER, or the variable VOROGEO_MESHLAB_SOURCE_2025_07 (with each version's own number);
#   2. the cache: VOROGEO_HOST_CACHE/VERSION, by default build/host/VERSION in the project;
#   3. Debian's source package of that version (checked against a sha256), from the machine's own Debian mirror; Debian has
#      none of 2023.12;
#   4. a git clone of the tag MeshLab-VERSION with its submodule vcglib.
# The choice is reported on the standard error; the last line of the standard output is the folder: it holds ML_VERSION,
# src/common and src/vcglib. Nothing outside the cache is written, and no Debian package is installed.
set -euo pipefail

die() {
  echo "obtain_headers.sh: $*" >&2
  exit 1
}
say() { echo "MeshLab $version headers: $*" >&2; }

version="${1:-}"
named_folder="${2:-}"
case "$version" in
  2022.02) orig_sha256=11da26ec46c3fbbbc806d410a3221542ec21ec13fdcc55d624304600029435fd ;;
  2025.07) orig_sha256=d22c98d362f2a284e481af8dbfc272b2222f5b9c67b3cf8bec57d1c3161886f4 ;;
  2023.12) orig_sha256=none ;;
  *) die "name the version of MeshLab, 2022.02, 2023.12 or 2025.07 (got '$version')" ;;
esac
variable="VOROGEO_MESHLAB_SOURCE_${version/./_}"
project="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
cache="${VOROGEO_HOST_CACHE:-$project/build/host}"
mkdir -p "$cache"
cache="$(cd "$cache" && pwd)"
target="$cache/$version"

# Why a folder cannot be used; empty if it can.
fault_of() {
  local folder="$1" file found
  [ -d "$folder" ] || { echo "there is no folder $folder"; return; }
  for file in ML_VERSION src/common/plugins/interfaces/filter_plugin.h src/vcglib/vcg/complex/complex.h \
              src/vcglib/wrap/callback.h; do
    [ -f "$folder/$file" ] || { echo "$folder has no $file"; return; }
  done
  found="$(tr -d '[:space:]' <"$folder/ML_VERSION")"
  [ "$found" = "$version" ] || echo "$folder is MeshLab $found, not $version (see its file ML_VERSION)"
}

take() {
  say "$2"
  echo "$1"
  exit 0
}

# 1. A folder the user names must fit; silently taking another one would hide the mistake.
if [ -z "$named_folder" ]; then
  named_folder="${!variable:-}"
fi
if [ -n "$named_folder" ]; then
  fault="$(fault_of "$named_folder")"
  [ -z "$fault" ] || die "the folder you named cannot be used: $fault. Name the top folder of MeshLab's source tree" \
                         "(with vcglib in src/vcglib), or unset $variable."
  take "$(cd "$named_folder" && pwd)" "taken from the folder you named"
fi

# 2. The cache.
if [ -z "$(fault_of "$target")" ]; then
  take "$target" "taken from the cache"
fi

work="$(mktemp -d "$cache/.unpack-$version-XXXXXX")"
trap 'rm -rf "$work"' EXIT
reasons=()

# Puts the unpacked tree where the cache expects it, completely or not at all.
keep() {
  local fault
  fault="$(fault_of "$1")"
  if [ -n "$fault" ]; then
    reasons+=("$2: $fault")
    return 1
  fi
  rm -rf "$target"
  mv "$1" "$target"
}

# 3. Debian's source package: a private apt configuration reads the source lists of two suites and changes nothing
# on the machine; its mirror is the one that the machine's own apt uses.
from_debian() {
  local mirror suite keyring=/usr/share/keyrings/debian-archive-keyring.gpg source_version archive sum
  if [ "$orig_sha256" = none ]; then
    reasons+=("Debian source package: Debian never had MeshLab $version")
    return 1
  fi
  if ! command -v apt-get >/dev/null; then
    reasons+=("Debian source package: apt-get is not installed here")
    return 1
  fi
  mirror="$(apt-get indextargets --format '$(REPO_URI)' 'Origin: Debian' 'Label: Debian' 2>/dev/null | sort -u | head -n 1)"
  if [ -z "$mirror" ]; then  # before the first apt-get update the origin is not known
    mirror="$(apt-get indextargets --format '$(REPO_URI)' 2>/dev/null | grep -E '/debian/?$' | sort -u | head -n 1 || true)"
  fi
  if [ -z "$mirror" ]; then
    reasons+=("Debian source package: apt names no Debian mirror (see /etc/apt/sources.list)")
    return 1
  fi
  if [ ! -f "$keyring" ]; then
    reasons+=("Debian source package: $keyring is missing (install debian-archive-keyring)")
    return 1
  fi
  local private="$work/apt"
  mkdir -p "$private/lists/partial"
  for suite in sid trixie; do
    echo "deb-src [signed-by=$keyring] $mirror $suite main"
  done >"$private/sources.list"
  local options=(-q -o "Dir::Etc::sourcelist=$private/sources.list" -o Dir::Etc::sourceparts=/dev/null
                 -o "Dir::State::Lists=$private/lists" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache=
                 -o APT::Sandbox::User=root -o Acquire::Languages=none)
  say "reading the source lists of Debian"
  if ! apt-get "${options[@]}" update >"$private/log" 2>&1; then
    reasons+=("Debian source package: the source lists could not be read: $(grep -E '^(E|W):' "$private/log" | head -n 1)")
    return 1
  fi
  source_version="$(apt-cache "${options[@]}" showsrc meshlab 2>/dev/null | sed -n 's/^Version: //p' \
                    | grep -E "^${version//./\\.}[^0-9]" | sort -V | tail -n 1 || true)"
  if [ -z "$source_version" ]; then
    reasons+=("Debian source package: neither sid nor trixie has meshlab $version any more")
    return 1
  fi
  say "downloading Debian's source of meshlab $source_version"
  if ! (cd "$private" && apt-get "${options[@]}" source --download-only --tar-only "meshlab=$source_version") \
      >"$private/log" 2>&1; then
    reasons+=("Debian source package: download failed: $(grep -E '^E:' "$private/log" | head -n 1)")
    return 1
  fi
  archive="$(find "$private" -maxdepth 1 -name 'meshlab_*.orig.tar.*' ! -name '*.asc' | head -n 1)"
  sum="$(sha256sum "$archive" | cut -d ' ' -f 1)"
  if [ "$sum" != "$orig_sha256" ]; then
    reasons+=("Debian source package: $(basename "$archive") has sha256 $sum, expected $orig_sha256")
    return 1
  fi
  mkdir "$work/tree"
  if ! tar -xf "$archive" -C "$work/tree" --strip-components=1 --wildcards '*/ML_VERSION' '*/LICENSE.txt' \
      '*/src/common' '*/src/vcglib/vcg' '*/src/vcglib/wrap' 2>"$private/log"; then
    reasons+=("Debian source package: $(basename "$archive") could not be unpacked: $(head -n 1 "$private/log")")
    return 1
  fi
  keep "$work/tree" "Debian source package"
}

# 4. The tag in MeshLab's own repository. Only vcglib is needed of its submodules.
from_git() {
  local tree="$work/clone"
  if ! command -v git >/dev/null; then
    reasons+=("git clone: git is not installed here")
    return 1
  fi
  say "cloning the tag MeshLab-$version"
  if ! GIT_TERMINAL_PROMPT=0 git clone -q --depth 1 --branch "MeshLab-$version" \
        https://github.com/cnr-isti-vclab/meshlab "$tree" 2>"$work/git.log" ||
      ! GIT_TERMINAL_PROMPT=0 git -C "$tree" submodule update -q --init --depth 1 src/vcglib 2>"$work/git.log"; then
    reasons+=("git clone: $(tail -n 1 "$work/git.log")")
    return 1
  fi
  rm -rf "$tree/.git"
  keep "$tree" "git clone"
}

if from_debian; then
  take "$target" "unpacked from Debian's source package"
fi
if from_git; then
  take "$target" "cloned from MeshLab's repository"
fi

{
  echo "obtain_headers.sh: the headers of MeshLab $version could not be obtained:"
  printf '  - %s\n' "${reasons[@]}"
  echo "Unpack the source of MeshLab $version (with vcglib in src/vcglib) yourself and name its folder:" \
       "$variable=FOLDER."
} >&2
exit 1

#!/usr/bin/env bash
# Fills in the recipes of this folder for one source archive: version, place, checksums and the maintainer's name.
#
# Usage: packaging/recipes.sh [URL OF THE ARCHIVE'S FOLDER]       left in build/recipes
#   Takes the archive in build/wheels/dist (packaging/source_archive.sh). By default it is named where it lies.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
version="$(cat VERSION)"
archive="build/wheels/dist/vorogeo-$version.tar.gz"
[ -f "$archive" ] || { echo "recipes.sh: there is no $archive; make it by packaging/source_archive.sh" >&2; exit 1; }
rm -rf build/recipes
mkdir -p build/recipes
cp -r packaging/{vcpkg,conan,conda,debian,sbom.json} build/recipes/
find build/recipes -type f -exec sed -i \
  -e "s#@VERSION@#$version#g" -e "s#@URL@#${1:-file://$PWD/build/wheels/dist}/vorogeo-$version.tar.gz#g" \
  -e "s#@SHA256@#$(sha256sum <"$archive" | cut -d ' ' -f 1)#g" -e "s#@SHA512@#$(sha512sum <"$archive" | cut -d ' ' -f 1)#g" \
  -e "s#@MAINTAINER@#${DEBFULLNAME:-$(git log -1 --format=%an)} <${DEBEMAIL:-$(git log -1 --format=%ae)}>#g" {} +

#!/usr/bin/env bash
# Builds the Debian packages from the source archive in a Debian root, and installs them in another one.
#
# Usage: packaging/build_debian.sh
#   They are left in build/debian, with the source package. Takes build/wheels/dist/vorogeo-VERSION.tar.gz
#   (packaging/source_archive.sh, run if there is none). lintian must find neither an error nor a warning; that no report at Debian
#   asks for the package does not count.
# Exit status 77 with a sentence on the standard error where no root can be made.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
version="$(cat VERSION)" suite=trixie
archive="build/wheels/dist/vorogeo-$version.tar.gz"
[ -f "$archive" ] || packaging/source_archive.sh
packaging/recipes.sh
headers="$(plugin/host/obtain_headers.sh 2022.02 | tail -n 1)"  # of the MeshLab of that Debian

out=build/debian
rm -rf "$out"
mkdir -p "$out/vorogeo-$version"
cp "$archive" "$out/vorogeo_$version.orig.tar.gz"
tar -c --sort=name --owner=0 --group=0 --mtime=2022-02-01 -C "$headers/.." --transform 's#^[^/]*#meshlab#' "$(basename "$headers")" |
  xz -T0 >"$out/vorogeo_$version.orig-meshlab.tar.xz"
tar -x -f "$archive" -C "$out/vorogeo-$version" --strip-components=1
tar -x -f "$out/vorogeo_$version.orig-meshlab.tar.xz" -C "$out/vorogeo-$version"
cp -r build/recipes/debian "$out/vorogeo-$version/debian"
cat >"$out/vorogeo-$version/debian/changelog" <<END
vorogeo ($version-1) UNRELEASED; urgency=medium

  * Version $version; CHANGELOG.md says what is new.

 -- $(sed -n 's/^Maintainer: //p' build/recipes/debian/control)  $(git log -1 --format=%cD)
END

needs="$(sed -n '/^Build-Depends:/,/^[^ ]*:/{s/^Build-Depends://;/^[A-Z]/d;p}' packaging/debian/control | sed 's/([^)]*)//;s/,//' | tr -s ' \n' ' ')"
# shellcheck disable=SC2086  # packages are words
tests/roots/make_root.sh build/roots/builder-debian "$suite" --no-install-recommends build-essential lintian $needs
tests/roots/in_root.sh build/roots/builder-debian env "DEB_BUILD_OPTIONS=parallel=${VOROGEO_JOBS:-$(nproc)}" bash -euc "
  cd /project/$out/vorogeo-$version
  dpkg-buildpackage -us -uc
  lintian --allow-root --fail-on error,warning --suppress-tags initial-upload-closes-no-bugs ../*.changes" >"$out/build.log" 2>&1 || { tail -n 40 "$out/build.log" >&2; exit 1; }

tests/roots/make_root.sh build/roots/user-debian "$suite" --no-install-recommends g++
tests/roots/in_root.sh build/roots/user-debian bash -euc "
  apt-get update -q && apt-get install -q -y --no-install-recommends pkgconf /project/$out/*.deb
  cd /tmp
  vorogeo --version
  python3 -c 'import vorogeo; print(vorogeo.exact_distance_field([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]], 1))'
  g++ -std=c++20 /project/samples/cpp/first_field.cpp -o first_field \$(pkg-config --cflags --libs vorogeo)
  ./first_field
  ls /usr/lib/*/meshlab/plugins/*vorogeo*" >"$out/install.log" 2>&1 || { tail -n 40 "$out/install.log" >&2; exit 1; }
tail -n 8 "$out/install.log"
ls -l "$out"/*.deb

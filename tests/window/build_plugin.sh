#!/usr/bin/env bash
# Builds the plugin for MeshLab's window inside a root and installs it there: by the commands of docs/building.md, and then
# over it from an archive such as users get.
#
# Usage: build_plugin.sh 2022.02|2025.07 ROOT
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
version="$1" root="$2"
headers="$(plugin/host/obtain_headers.sh "$version")"
jobs="${VOROGEO_JOBS:-$(nproc)}"
build="build/window/$version/plugin"  # not build/plugin-VERSION-float: that one is compiled against this system's Qt
mkdir -p "$build"
# The core does not depend on the host, and a library of an older compiler works on a newer system: the one that set-up made of
# these sources is used, and compiled only where there is none.
core=""
for made in build/release build/core; do
  library="$made/core/libvorogeo_core.a"
  if [ -f "$library" ] && [ -f "${library/core.a/methods.a}" ] && [ -z "$(find core -name '*.md' -prune -o -type f -newer "$library" -print -quit)" ]; then
    core="/project/$library"
    break
  fi
done
tests/roots/in_root.sh "$root" --bind "$headers" /meshlab-source sh -euc "
  cd /project
  cmake --preset plugin-$version-float -B $build -DVOROGEO_HOST_SOURCE=/meshlab-source '-DVOROGEO_CORE_LIBRARY=$core'
  cmake --build $build --target filter_vorogeo edit_vorogeo --parallel $jobs
  cmake --install $build"
library="$build/plugin/libfilter_vorogeo.so"
cmp "$library" "$root/usr/lib/x86_64-linux-gnu/meshlab/plugins/libfilter_vorogeo.so"
plugin/pack_zip.sh "build/window/$version/vorogeo-meshlab-$(cat VERSION)-linux.zip" "$version=$library"
tests/window/install_zip.sh "$version" "$root" "build/window/$version/vorogeo-meshlab-$(cat VERSION)-linux.zip" \
  "build/window/$version/zip"

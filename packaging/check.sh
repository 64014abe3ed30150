#!/usr/bin/env bash
# Checks the source archive and what is built from it: the same bytes twice, and each recipe by its own tool.
#
# Usage: packaging/check.sh
#   Conan builds the library and a sample around it; the conda recipe is rendered, the vcpkg port read, the list of what is inside
#   (SBOM) compared with its schema, the workflow read by actionlint. Needs CMake, Ninja, g++ and a Python; pip and Go bring the
#   tools. VOROGEO_JOBS: compilers at a time (default: one per core).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
work="$PWD/build/recipes-check"
say() { echo "--- $*"; }
rm -rf "$work"/{first,second,conan,sample}
mkdir -p "$work"
[ -x "$work/venv/bin/conan" ] ||
  { python3 -m venv "$work/venv" && "$work/venv/bin/pip" install -q conan py-rattler-build 'cyclonedx-python-lib[json-validation]'; }
export PATH="$work/venv/bin:$PATH"

say "the source archive, twice"
packaging/source_archive.sh "$work/first" >/dev/null
(umask 077 && TZ=Pacific/Apia packaging/source_archive.sh "$work/second" >/dev/null)
cmp "$work"/{first,second}/*.tar.gz
mkdir -p build/wheels/dist
cp "$work"/first/*.tar.gz build/wheels/dist/
packaging/recipes.sh
if grep -rnE '@[A-Z0-9]+@' build/recipes; then echo "not filled in (above)" >&2; exit 1; fi

say "Conan"
export CONAN_HOME="$work/conan"
conan profile detect --force >/dev/null 2>&1
options=(-c tools.cmake.cmaketoolchain:user_presets= -s compiler.cppstd=20 -s build_type=Release -c "tools.build:jobs=${VOROGEO_JOBS:-$(nproc)}" -c tools.cmake.cmaketoolchain:generator=Ninja)
conan create build/recipes/conan "${options[@]}" >"$work/conan.log" 2>&1 || { tail -n 30 "$work/conan.log"; exit 1; }
# Conan leaves a CMakeUserPresets.json where it is called.
mkdir -p "$work/sample"
(cd "$work/sample" && conan install --requires "vorogeo/$(cat ../../../VERSION)" -g CMakeDeps -g CMakeToolchain -of . "${options[@]}") \
  >"$work/sample.log" 2>&1
cmake -G Ninja -S samples/cpp -B "$work/sample" "-DCMAKE_TOOLCHAIN_FILE=$work/sample/conan_toolchain.cmake" -DCMAKE_BUILD_TYPE=Release >>"$work/sample.log"
cmake --build "$work/sample" --target first_field >>"$work/sample.log"
"$work/sample/first_field"

say "conda, vcpkg, SBOM"
python - <<'END'
import json
from pathlib import Path

from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator
from rattler_build import Stage0Recipe, VariantConfig

recipe = Stage0Recipe.from_file("build/recipes/conda/recipe.yaml")
variants = recipe.render(VariantConfig({"c_stdlib": ["sysroot"], "python": ["3.12.*"]}))
assert [str(variant.recipe.package.name) for variant in variants] == ["libvorogeo", "vorogeo"]
port = json.loads(Path("build/recipes/vcpkg/vcpkg.json").read_text())
assert port["version"] == Path("VERSION").read_text().strip()
error = JsonStrictValidator(SchemaVersion.V1_6).validate_str(Path("build/recipes/sbom.json").read_text())
assert error is None, error
END
if command -v go >/dev/null; then
  say "the workflow"
  go run github.com/rhysd/actionlint/cmd/actionlint@v1.7.7
fi
say "all passed"

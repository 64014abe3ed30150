// Reads the test meshes: binary little-endian PLY triangles; and finds them on disk.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "support/shapes.h"

namespace vorogeo::test {

/// Reads vertices with x, y, z (float or double, other scalar properties are skipped) and triangles.
/// \throw std::runtime_error that names the file if it is missing, of another kind or cut short.
Soup read_ply(const std::filesystem::path& file);

/// The test mesh of a name such as "bunny": in the folder that the environment variable VOROGEO_MESHES
/// names, else in ../shared/meshes next to the source folder. Nothing if it does not exist.
std::optional<std::filesystem::path> test_mesh_file(const std::string& name);

}  // namespace vorogeo::test

/// Declares the Soup `soup` of a test mesh, or skips the test visibly.
#define VOROGEO_READ_OR_SKIP(soup, name)                                    \
  const auto soup##_file = vorogeo::test::test_mesh_file(name);             \
  if (!soup##_file) GTEST_SKIP() << "test mesh " << (name) << " not found"; \
  const vorogeo::test::Soup soup = vorogeo::test::read_ply(*soup##_file)

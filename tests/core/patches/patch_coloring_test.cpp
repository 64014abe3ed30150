// Colours of patches: neighbours differ, few colours suffice where few are needed, more are made where they
// are.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "patches/partition.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// Fails for each vertex at which two patches have one colour.
void expect_neighbors_differ(const Mesh& mesh, const std::vector<Index>& patch, const PatchColoring& colors) {
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    std::set<Index> patches;
    std::set<Rgb> seen;
    for (const Index corner : mesh.corners(v)) {
      const Index here = patch[Mesh::face_of(corner)];
      patches.insert(here);
      seen.insert(colors.palette.at(colors.color_of_patch.at(here)));
    }
    EXPECT_EQ(patches.size(), seen.size()) << "at vertex " << v;
  }
}

TEST(PatchColoring, BlocksOfAGridNeedFourColorsAndGetThem) {
  // Blocks of 4 x 4 cells: four meet at each inner corner, so fewer than four colours are not enough.
  const auto mesh = test::make_mesh(test::plane_grid(16, 16, 1.0, 1.0).soup);
  std::vector<Index> patch;
  for (Index f = 0; f < mesh->face_count(); ++f) {
    const Index cell = f / 2;
    patch.push_back(cell / 16 / 4 * 4 + cell % 16 / 4);
  }
  const PatchColoring colors = color_neighbors_differently(*mesh, patch);
  expect_neighbors_differ(*mesh, patch, colors);
  EXPECT_EQ(colors.palette.size(), 8U);
  EXPECT_GE(colors.colors_used, 4);
}

TEST(PatchColoring, AFanWithElevenPatchesGetsElevenColors) {
  // All faces meet at the apex, so all patches are neighbours of one another.
  const auto mesh = test::make_mesh(test::cone(11, 1, 5.0, 1.0).soup);
  std::vector<Index> patch;
  for (Index f = 0; f < mesh->face_count(); ++f) patch.push_back(f);
  ASSERT_EQ(patch.size(), 11U);
  const PatchColoring colors = color_neighbors_differently(*mesh, patch);
  expect_neighbors_differ(*mesh, patch, colors);
  EXPECT_EQ(colors.colors_used, 11);
  EXPECT_EQ(std::set<Rgb>(colors.palette.begin(), colors.palette.end()).size(), 11U);
}

TEST(PatchColoring, PatchesThatDoNotTouchShareTheWorkOfThePalette) {
  test::Soup soup = test::icosphere(0);
  for (int i = 0; i < 15; ++i) soup = test::two_components(soup, test::icosphere(0));
  const auto mesh = test::make_mesh(soup);
  std::vector<Index> patch;
  for (Index f = 0; f < mesh->face_count(); ++f) patch.push_back(f / 20);
  const PatchColoring colors = color_neighbors_differently(*mesh, patch);
  std::vector<int> uses(colors.palette.size(), 0);
  for (const int color : colors.color_of_patch) ++uses[color];
  for (const int count : uses) EXPECT_EQ(count, 2);  // 16 patches, 8 colours
}

TEST(PatchColoring, NoColourIsNearThatOfFacesThatNoPathReaches) {
  // The greys of the filters: light for what is not reached or in no patch, dark for what is not compared.
  constexpr std::array<double, 2> greys{160.0, 90.0};
  const auto mesh = test::make_mesh(test::cone(60, 1, 5.0, 1.0).soup);
  std::vector<Index> patch;
  for (Index f = 0; f < mesh->face_count(); ++f) patch.push_back(f);
  const PatchColoring colors = color_neighbors_differently(*mesh, patch);
  EXPECT_EQ(colors.palette.size(), 60U);
  for (const Rgb& color : colors.palette) {
    for (const double grey : greys) {
      EXPECT_GT(std::hypot(color[0] - grey, color[1] - grey, color[2] - grey), 50.0)
          << int{color[0]} << ' ' << int{color[1]} << ' ' << int{color[2]};
    }
    const auto [least, greatest] = std::minmax({color[0], color[1], color[2]});
    EXPECT_GT(greatest - least, 50) << int{color[0]} << ' ' << int{color[1]} << ' ' << int{color[2]};
  }
}

TEST(PatchColoring, WithoutFacesThereIsNothingToColour) {
  const Mesh empty({}, {});
  const PatchColoring colors = color_neighbors_differently(empty, {});
  EXPECT_TRUE(colors.color_of_patch.empty());
  EXPECT_EQ(colors.colors_used, 0);
}

}  // namespace
}  // namespace vorogeo

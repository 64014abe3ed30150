// Patches: two layers of them, their halos and their colours.
#include "patches/partition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "patches/halo.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

// Two layers of patches: counts and nesting.

using test::Soup;

PartitionOptions patches(Index first, Index second) {
  return {.first_layer_patches = first, .second_layer_patches = second};
}

Partition partition_of(const Soup& soup, const PartitionOptions& options = {}) {
  return make_partition(*test::make_mesh(soup), options, {});
}

void expect_valid(const Partition& partition, Index faces) {
  ASSERT_EQ(static_cast<Index>(partition.first_layer.size()), faces);
  ASSERT_EQ(static_cast<Index>(partition.second_layer.size()), faces);
  ASSERT_EQ(static_cast<Index>(partition.parent.size()), partition.second_layer_count);
  EXPECT_TRUE(std::is_sorted(partition.parent.begin(), partition.parent.end()));
  std::vector<int> first(partition.first_layer_count, 0);
  std::vector<int> second(partition.second_layer_count, 0);
  for (Index f = 0; f < faces; ++f) {
    const Index p = partition.first_layer[f];
    const Index q = partition.second_layer[f];
    ASSERT_TRUE(p >= 0 && p < partition.first_layer_count) << "face " << f;
    ASSERT_TRUE(q >= 0 && q < partition.second_layer_count) << "face " << f;
    EXPECT_EQ(partition.parent[q], p) << "face " << f;
    ++first[p];
    ++second[q];
  }
  EXPECT_TRUE(std::find(first.begin(), first.end(), 0) == first.end()) << "an empty patch";
  EXPECT_TRUE(std::find(second.begin(), second.end(), 0) == second.end()) << "an empty patch";
}

TEST(Partition, EveryFaceInOnePatchOfEachLayer) {
  const Soup two = test::two_components(test::icosphere(3), test::torus(30, 14, 2.0, 0.7));
  for (const Soup& soup :
       {test::icosphere(4), test::hills(30, 0.2), test::book_of_three_pages(12, 2.0, 1.0).soup,
        test::bow_tie(10).soup, test::with_isolated_vertex(two, {5, 5, 5}),
        test::with_zero_area_cap(test::icosphere(2), 11, 0)}) {
    const Index faces = test::make_mesh(soup)->face_count();
    for (Index n1 : {0, 1, 3}) {
      for (Index n2 : {0, 1, 5}) {
        expect_valid(partition_of(soup, patches(n1, n2)), faces);
      }
    }
  }
}

TEST(Partition, AutomaticNumbersGrowWithTheMesh) {
  const Partition small = partition_of(test::icosphere(2));
  EXPECT_EQ(small.first_layer_count, 1);
  EXPECT_EQ(small.second_layer_count, 1);
  const Partition medium = partition_of(test::icosphere(5));  // 10,242 vertices
  EXPECT_GE(medium.second_layer_count, 2 * medium.first_layer_count);
  EXPECT_LT(medium.second_layer_count, 200);
  const Partition large = partition_of(test::hills(200, 0.1));  // 40,401 vertices
  EXPECT_GT(large.first_layer_count, 1);
  EXPECT_GT(large.first_layer_count, medium.first_layer_count);
  EXPECT_GT(large.second_layer_count, 2 * medium.second_layer_count);
}

TEST(Partition, AutomaticPatchesHaveSimilarSizes) {
  for (const Soup& soup : {test::icosphere(5), test::hills(90, 0.1)}) {
    const Partition partition = partition_of(soup);
    std::vector<Index> faces(partition.second_layer_count, 0);
    for (Index p : partition.second_layer) ++faces[p];
    const double mean = static_cast<double>(partition.second_layer.size()) / partition.second_layer_count;
    EXPECT_LT(*std::max_element(faces.begin(), faces.end()), 3.5 * mean);
    EXPECT_GT(*std::min_element(faces.begin(), faces.end()), mean / 6.0);
  }
}

// The rim around patches, widened on both sides.

TEST(Halo, GrowsOnBothSidesRoundAHubOfNeedles) {
  // Face i of the disc lies between the rim's vertices i and i + 1.
  constexpr Index needles = 5000;
  const auto mesh = test::make_mesh(test::needle_disc(needles));
  const std::array<Index, 4> first_face{0, 2000, 2100, needles};
  Halo halo(*mesh, first_face);
  halo.surround(std::array{Index{1}}, 3.0);
  const auto [least, greatest] = std::ranges::minmax(halo.faces());
  EXPECT_EQ(halo.faces().size(), 300U);
  EXPECT_EQ(least, 1900);
  EXPECT_EQ(greatest, 2199);
}

// Colours of patches: neighbours differ, few are used where few are enough, and more are made where needed.

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

TEST(PatchColoring, AFanWithElevenPatchesGetsElevenColors) {
  // All faces meet at the apex, so all patches are neighbours of one another.
  const auto mesh = test::make_mesh(test::cone(11, 1, 5.0, 1.0).soup);
  const std::vector<Index> patch = test::all_faces(*mesh);
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
  const std::vector<Index> patch = test::all_faces(*mesh);
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

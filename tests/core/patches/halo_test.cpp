// The rim around patches: what is marked, where it ends, and that marks are cleared.
#include "patches/halo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(Halo, WidensByRingsOfFacesAndTakesThemBack) {
  const auto index = test::make_index(test::icosphere(3), 3, 4);
  const IndexData& data = index->data();
  const Mesh& mesh = *data.work.mesh;
  Halo halo(mesh, data.first_face);
  const std::vector<Index> patch{0};
  const auto all_faces = static_cast<std::size_t>(mesh.face_count());
  // Next to the patch, inside it, and where the second of three rings is too many.
  for (const auto& [seed, most] : {std::pair(mesh.face_count() - 1, all_faces),
                                   std::pair(Index{0}, all_faces), std::pair(Index{0}, std::size_t{14})}) {
    halo.surround(patch);
    std::set<Index> expected(halo.faces().begin(), halo.faces().end());
    std::set<Index> rings{seed};
    for (int k = 0; k < 3 && rings.size() < most; ++k) {
      std::set<Index> next = rings;
      for (Index f : rings) {
        for (Index v : mesh.face_vertices(f)) {
          for (Index corner : mesh.corners(v)) next.insert(Mesh::face_of(corner));
        }
      }
      rings.swap(next);
    }
    expected.insert(rings.begin(), rings.end());
    halo.widen(std::array{seed}, 3, most);
    EXPECT_EQ(std::set<Index>(halo.faces().begin(), halo.faces().end()), expected);
    EXPECT_EQ(halo.faces().size(), expected.size()) << "each face once";
  }
  halo.surround(std::vector<Index>{});
  EXPECT_EQ(std::count(halo.mask().begin(), halo.mask().end(), 0), mesh.face_count());
}

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

}  // namespace
}  // namespace vorogeo

// The rim around patches: what is marked, where it ends, and that marks are cleared.
#include "patches/halo.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "support/indexes.h"
#include "support/parallel.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

TEST(Halo, MarksThePatchesAndARimAroundThem) {
  const auto index = test::make_index(test::icosphere(4), 3, 4);
  const IndexData& data = index->data();
  Halo halo(*data.work.mesh, data.first_face);
  std::vector<std::vector<Index>> choices;
  for (Index p = 0; p < data.second.patch_count; ++p) choices.push_back({p});
  choices.push_back({0, 1});
  choices.push_back({2, 7, 9});
  for (const auto& patches : choices) {
    halo.surround(patches);
    const std::set<Index> marked(halo.faces().begin(), halo.faces().end());
    EXPECT_EQ(marked.size(), halo.faces().size()) << "each face once";
    std::size_t own = 0;
    for (Index f = 0; f < data.work.mesh->face_count(); ++f) {
      EXPECT_EQ(halo.mask()[f] != 0, marked.contains(f));
      const bool inside =
          std::find(patches.begin(), patches.end(), data.work.second_layer[f]) != patches.end();
      own += inside;
      EXPECT_TRUE(!inside || marked.contains(f)) << "a face of the patch is missing";
    }
    // At least one ring of faces, not much more than the patches themselves.
    EXPECT_GT(marked.size(), own + own / 5);
    EXPECT_LT(marked.size(), 3 * own);
  }
}

TEST(Halo, StopsWhereTheMeshEnds) {
  const auto index = test::make_index(test::two_components(test::icosphere(1), test::icosphere(1)), 3, 4);
  const IndexData& data = index->data();
  Halo halo(*data.work.mesh, data.first_face);
  std::vector<Index> all(data.second.patch_count);
  for (Index p = 0; p < data.second.patch_count; ++p) all[p] = p;
  halo.surround(all);
  EXPECT_EQ(static_cast<Index>(halo.faces().size()), data.work.mesh->face_count());
  halo.surround(std::vector<Index>{});
  EXPECT_TRUE(halo.faces().empty());
  EXPECT_EQ(std::count(halo.mask().begin(), halo.mask().end(), 0), data.work.mesh->face_count());
}

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

TEST(Halo, TakesAllPagesOfABookOnce) {
  constexpr Index pages = 20'000;
  const auto mesh = test::make_mesh(test::book_of_pages(pages));
  const std::array<Index, 4> first_face{0, 100, 200, pages};
  Halo halo(*mesh, first_face);
  const auto start = thread_seconds();
  halo.surround(std::array{Index{1}}, 1000.0);
  EXPECT_EQ(halo.faces().size(), static_cast<std::size_t>(pages));
  // Quadratic work would take half a second.
  EXPECT_LT(thread_seconds() - start, 0.1);
}

TEST(Halo, TakesTheFacesOfPatchesInAnyOrder) {
  const auto index = test::make_index(test::icosphere(3), 3, 4);
  const IndexData& data = index->data();
  const UnsplitSurface surface(data.mesh, data.work, data.partition);
  Halo by_order(*data.mesh, surface.first_face, surface.faces);
  for (Index p = 0; p < data.second.patch_count; ++p) {
    by_order.surround(std::array{p}, 0.0);
    for (Index f = 0; f < data.mesh->face_count(); ++f) {
      EXPECT_EQ(by_order.mask()[f] != 0, data.partition.second_layer[f] == p);
    }
  }
}

}  // namespace
}  // namespace vorogeo

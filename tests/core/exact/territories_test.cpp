// Territories: every owner has its share, and whoever works beside a vertex is told its distance.
#include "exact/territories.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/indexes.h"
#include "support/parallel.h"
#include "support/small_copy.h"

namespace vorogeo {
namespace {

TEST(Territories, OwnersHaveEqualSharesAndShortBorders) {
  const auto mesh = test::make_mesh(test::icosphere(5));
  for (int owners : {1, 2, 5}) {
    const Territories territories(*mesh, owners);
    for (int owner = 0; owner < owners; ++owner) {
      const auto edges = std::count(territories.of_edge.begin(), territories.of_edge.end(), owner);
      EXPECT_NEAR(static_cast<double>(edges) * owners / mesh->edge_count(), 1.0, 0.3);
    }
    // A patch of 64 faces has a border of some 30 edges.
    const auto shared = std::count(territories.is_shared.begin(), territories.is_shared.end(), 1);
    EXPECT_LE(shared, owners == 1 ? 0 : 2 * mesh->vertex_count() / 3);
  }
}

TEST(Territories, VerticesThatAreNotSharedConcernTheirOwnerOnly) {
  const test::Soup soup =
      test::two_components(test::with_flipped_faces(test::gear(16, 12, 1.0), 3), test::icosphere(3));
  const auto mesh = test::make_mesh(test::with_isolated_vertex(soup, {9, 9, 9}));
  const Territories territories(*mesh, 3);
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    std::set<int> owners{territories.of_vertex[v]};
    for (Index corner : mesh->corners(v)) {
      for (Index h : {corner, Mesh::next_in_face(corner), Mesh::previous_in_face(corner)}) {
        owners.insert(territories.of_edge[mesh->edge_of(h)]);
        owners.insert(territories.of_vertex[mesh->tail(h)]);
      }
    }
    EXPECT_TRUE(territories.is_shared[v] != 0 || owners.size() == 1) << "vertex " << v;
  }
}

TEST(Territories, PartsMuchSmallerThanAnEdgeHaveOneOwner) {
  const test::Soup large = test::plane_grid(40, 40, 1.0, 1.0, 0.2).soup;
  const auto first_small = static_cast<Index>(large.positions.size());
  const auto mesh = test::make_mesh(test::with_small_copy(large, 1e-3));
  const Territories territories(*mesh, 3);
  std::set<int> owners;
  for (Index e = 0; e < mesh->edge_count(); ++e) {
    const auto [a, b] = mesh->edge_vertices(e);
    if (std::min(a, b) >= first_small) owners.insert(territories.of_edge[e]);
  }
  EXPECT_EQ(owners.size(), 1U);
  for (int owner = 0; owner < 3; ++owner) {
    EXPECT_GT(std::count(territories.of_edge.begin(), territories.of_edge.end(), owner), 1000);
  }
}

TEST(Territories, OfABookOfThousandsOfPagesAreFoundAtOnce) {
  const auto mesh = test::make_mesh(test::book_of_pages(20'000));
  const double start = thread_seconds();
  const Territories territories(*mesh, 2);
  // Quadratic work takes seconds.
  EXPECT_LT(thread_seconds() - start, 0.5);
  const auto owned = std::count(territories.of_edge.begin(), territories.of_edge.end(), 0);
  EXPECT_NEAR(static_cast<double>(owned), 20'000.0, 4'000.0);
}

TEST(Territories, OfAMeshWithoutFacesAreEmpty) {
  const auto mesh = test::make_mesh({{{0, 0, 0}, {1, 0, 0}}, {}});
  const Territories territories(*mesh, 2);
  EXPECT_EQ(territories.of_edge.size(), 0U);
  EXPECT_EQ(territories.of_vertex.size(), 2U);
}

}  // namespace
}  // namespace vorogeo

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

}  // namespace
}  // namespace vorogeo

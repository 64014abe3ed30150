// Layouts and points of faces with sides of their own.
#include <gtest/gtest.h>

#include "exact/refraction.h"
#include "support/error.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(FaceNorms, RefusesLengthsThatProductsLeave) {
  auto norms = [](double side) {
    const auto mesh = std::make_shared<const Mesh>(std::vector<Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                                   std::vector<std::array<Index, 3>>{{0, 1, 2}},
                                                   FaceSides{{{side, side, side}}, 2});
    return FaceNorms(mesh, mesh->points_per_edge());
  };
  EXPECT_THROW(norms(1e-200), InvalidInput) << "products would underflow";
  EXPECT_THROW(norms(1e200), InvalidInput);
  EXPECT_EQ(norms(0).edge_cost(0), 0.0);
}

}  // namespace
}  // namespace vorogeo

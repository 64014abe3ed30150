// Limits of edge lengths: what passes, what is refused, and that the advised factor helps.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mesh/mesh.h"
#include "support/error.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(LengthLimits, PointsAndOrdinaryMeshesPass) {
  EXPECT_TRUE(index_lengths.allow(0.0, 0.0));
  EXPECT_TRUE(index_lengths.allow(1.0, 2.0));
  EXPECT_FALSE(index_lengths.allow(1.0, 1e29));
  EXPECT_FALSE(index_lengths.allow(1e-29, 1e-28));
  EXPECT_TRUE(exact_lengths.allow(1e-29, 1e29));
  EXPECT_FALSE(exact_lengths.allow(0.0, 1e-320)) << "a mean that underflows";
  EXPECT_FALSE(exact_lengths.allow(std::numeric_limits<double>::infinity(), unreachable));
}

TEST(LengthLimits, RefusalsSayBothLengthsAndAFactor) {
  test::Soup soup = test::plane_grid(2, 2, 2e70, 2e70).soup;
  try {
    require_lengths(*test::make_mesh(soup), "exact distances take", exact_lengths.least_mean,
                    exact_lengths.greatest);
    FAIL() << "taken";
  } catch (const InvalidInput& error) {
    // 12 edges of length 1e70 and 4 diagonals: the mean is (12 + 4 sqrt 2) / 16 = 1.10355.
    EXPECT_EQ(
        std::string(error.what()),
        "The mesh has a mean edge length of 1.10355e+70 and a longest edge of 1.41421e+70; exact distances "
        "take lengths between 1e-60 and 1e+60: scale the mesh, for example by 1e-70.");
  }
}

TEST(LengthLimits, TheFactorIsFiniteAndHelpsWheneverOneCan) {
  for (double mean : {5e-324, 1e-300, 1e-100, 1e-29, 1.0, 1e29, 1e100, 1e300, 1.7e308}) {
    for (double ratio : {1.0, 1e3, 1e20}) {
      const double factor = factor_to_unit(mean, mean * ratio);
      EXPECT_TRUE(std::isfinite(factor) && factor > 0.0);
      if (std::isfinite(mean * ratio)) {
        EXPECT_TRUE(index_lengths.allow(mean * factor, mean * ratio * factor)) << mean << " " << ratio;
      }
    }
  }
}

}  // namespace
}  // namespace vorogeo

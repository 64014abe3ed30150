// The exact method on shapes with a closed form.
#include <gtest/gtest.h>

#include <numbers>

#include "support/methods.h"

namespace vorogeo {
namespace {

TEST(MmpMethod, IsExactOnABoxAndOnASaddle) {
  for (const test::Shape& shape :
       {test::box({1.0, 1.7, 3.1}, 5), test::cone(12, 5, 2.6 * std::numbers::pi, 2.0),
        test::plane_with_slit(3)}) {
    const auto field = test::method_field("mmp", test::make_mesh(shape.soup), {11});
    for (Index v = 0; v < static_cast<Index>(field.size()); ++v) {
      EXPECT_NEAR(field[v], shape.vertex_distance(11, v), 1e-11) << v;
    }
  }
}

}  // namespace
}  // namespace vorogeo

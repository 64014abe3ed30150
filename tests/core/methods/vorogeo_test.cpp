// The index as a method.
#include <gtest/gtest.h>

#include "support/indexes.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

TEST(VorogeoMethod, IsTheIndex) {
  const test::Soup soup = test::icosphere(4);
  const auto mesh = test::make_mesh(soup);
  const auto errors = test::errors_against_exact("vorogeo", mesh, 100);
  EXPECT_LT(errors.mean, 5e-4);
  EXPECT_GT(errors.mean, 0.0);
  const auto method = prepare_method("vorogeo", mesh, {}, {});
  EXPECT_EQ(method->bytes(), static_cast<std::size_t>(test::make_index(soup)->statistics().bytes));
}

}  // namespace
}  // namespace vorogeo

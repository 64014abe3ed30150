// Timing of an exact field: whole where there is time, stopped and extrapolated otherwise.
#include <gtest/gtest.h>

#include "exact/local_solver.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(FieldTiming, IsWholeWhereThereIsTime) {
  const auto geometry = std::make_shared<const LocalGeometry>(test::make_mesh(test::icosphere(2)));
  const FieldTiming timing = time_exact_field(geometry, 1000.0, {}, "Timing");
  EXPECT_TRUE(timing.is_complete);
  EXPECT_GT(timing.seconds, 0.0);
  EXPECT_EQ(timing.expected_seconds(), timing.seconds);
}

TEST(FieldTiming, StopsAndExtrapolates) {
  const auto geometry = std::make_shared<const LocalGeometry>(test::make_mesh(test::icosphere(5)));
  const FieldTiming timing = time_exact_field(geometry, 0.0, {}, "Timing");
  EXPECT_FALSE(timing.is_complete);
  EXPECT_GT(timing.reached, 0.0);
  EXPECT_LT(timing.reached, 1.0);
  EXPECT_GT(timing.expected_seconds(), timing.seconds / timing.reached);
}

TEST(FieldTiming, IsThatOfTheLargestComponent) {
  const test::Soup sphere = test::icosphere(4);
  const auto seconds = [](const test::Soup& soup) {
    const auto geometry = std::make_shared<const LocalGeometry>(test::make_mesh(soup));
    return time_exact_field(geometry, 1000.0, {}, "Timing").seconds;
  };
  // A triangle beside it, with the first faces and vertices, takes a thousandth.
  const test::Soup triangle{{{9.0, 0.0, 0.0}, {9.0, 1.0, 0.0}, {9.0, 0.0, 1.0}}, {{0, 1, 2}}};
  EXPECT_GT(seconds(test::two_components(triangle, sphere)), 0.1 * seconds(sphere));
}

TEST(FieldTiming, IsExtrapolatedToTheComponentOnly) {
  const auto stopped = [](const test::Soup& soup) {
    const auto geometry = std::make_shared<const LocalGeometry>(test::make_mesh(soup));
    return time_exact_field(geometry, 0.0, {}, "Timing");
  };
  const test::Soup sphere = test::icosphere(5);
  const FieldTiming alone = stopped(sphere);
  const FieldTiming beside = stopped(test::two_components(sphere, sphere));
  ASSERT_FALSE(alone.is_complete || beside.is_complete);
  // Reports come by the number of steps, so that both stop at the same vertices.
  EXPECT_NEAR(beside.reached, alone.reached, 0.1 * alone.reached);
}

TEST(FieldTiming, IsCancelled) {
  const auto geometry = std::make_shared<const LocalGeometry>(test::make_mesh(test::icosphere(5)));
  const Progress stop([](double, const std::string&) { return false; });
  EXPECT_THROW(time_exact_field(geometry, 1000.0, stop, "Timing"), Cancelled);
}

}  // namespace
}  // namespace vorogeo

// Waves across gaps: a plane in two parts, loose triangles, and the short cut between fingers that the
// literature names.
#include <gtest/gtest.h>

#include "mesh/gaps.h"
#include "support/error.h"
#include "support/gaps.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

TEST(CampenKobbeltMethod, CrossesAGapOfAPlaneWithTheErrorsOfFastMarching) {
  const auto plates = test::two_plates(20, 14, 1e-3);
  const auto mesh = test::make_mesh(plates.soup);
  const auto without = test::method_field("campen_kobbelt", mesh, {0});
  EXPECT_EQ(without, test::method_field("fast_marching", mesh, {0}));
  EXPECT_EQ(without.back(), unreachable);
  const auto field = test::method_field("campen_kobbelt", mesh, {0}, {{"gap", 2e-3}});
  const auto errors = test::errors_of(field, test::straight_distances(plates.soup, 0));
  EXPECT_LT(errors.mean, 0.02);
  EXPECT_LT(errors.greatest, 0.1);
  EXPECT_EQ(test::method_field("campen_kobbelt", mesh, {0}, {{"gap", 5e-4}}), without);
}

TEST(CampenKobbeltMethod, IsFastMarchingOnLooseTriangles) {
  const auto sphere = test::icosphere(3);
  const auto loose = test::exploded(sphere);
  const auto field = test::method_field("campen_kobbelt", test::make_mesh(loose.soup), {0}, {{"gap", 1e-12}});
  const auto whole = test::method_field("fast_marching", test::make_mesh(sphere), {loose.origin[0]});
  for (std::size_t v = 0; v < field.size(); ++v) EXPECT_NEAR(field[v], whole[loose.origin[v]], 1e-9) << v;
}

TEST(CampenKobbeltMethod, TakesTheShortCutBetweenFingersThatBridgesDoNot) {
  const auto hand = test::hand(3, 4, 3.0, 0.01, false);
  const auto mesh = test::make_mesh(hand);
  const auto vertex_at = [&](double x) {
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      if (std::abs(mesh->position(v)[0] - x) < 1e-9 && mesh->position(v)[2] > 2.9) return v;
    }
    return no_index;
  };
  const Index tip = vertex_at(1.0);  // on the side of the first finger that faces the second
  const Index across = vertex_at(1.01);
  ASSERT_NE(tip, no_index);
  ASSERT_NE(across, no_index);
  EXPECT_LT(test::method_field("campen_kobbelt", mesh, {tip}, {{"gap", 0.02}})[across], 1.1);
  const auto bridged = bridged_mesh(hand.positions, hand.faces, {0.02});
  EXPECT_GT(exact_distance_field(bridged, std::vector<Index>{tip})[across], 5.0);
}

TEST(CampenKobbeltMethod, RefusesGapsOfManyEdgesAndMetrics) {
  const auto soup = test::icosphere(4);
  EXPECT_THROW(prepare_method("campen_kobbelt", test::make_mesh(soup), {{"gap", 2.0}}, {}), InvalidInput);
  const SideLengths sides(soup.faces.size(), {1.0, 1.0, 1.0});
  const auto metric = std::make_shared<const Mesh>(soup.positions, soup.faces, sides);
  EXPECT_THROW(prepare_method("campen_kobbelt", metric, {{"gap", 0.01}}, {}), InvalidInput);
}

}  // namespace
}  // namespace vorogeo

// CH and ICH are exact, and CH warns before large meshes.
#include <gtest/gtest.h>

#include "support/indexes.h"
#include "support/methods.h"
#include "support/ply.h"

namespace vorogeo {
namespace {

void expect_exact(const std::string& method, const test::Soup& soup, const MethodOptions& options = {}) {
  const auto mesh = test::make_mesh(soup);
  const auto exact = exact_distance_field(mesh, std::vector<Index>{11, 20});
  const auto field = test::method_field(method, mesh, {11, 20}, options);
  for (Index v = 0; v < mesh->vertex_count(); ++v)
    ASSERT_NEAR(field[v], exact[v], 1e-9 * (1.0 + exact[v])) << v;
}

TEST(ChenHanMethods, AreExact) {
  for (const test::Soup& soup :
       {test::icosphere(2), test::hills(10, 0.6), test::drilled_plate(1, 1, 0.4, 3), test::gear(8, 8, 0.5),
        test::with_flipped_faces(test::torus(12, 8, 2.0, 0.7), 3)}) {
    expect_exact("ich", soup);
    expect_exact("ich", soup, {{"order", 0.0}});
  }
  expect_exact("ch", test::icosphere(2));
  expect_exact("ch", test::hills(8, 0.6));
}

TEST(ChenHanMethods, AreExactOnAScan) {
  VOROGEO_READ_OR_SKIP(soup, "spot");
  expect_exact("ich", soup);
}

TEST(ChenHanMethods, ChWarnsBeforeLargeMeshes) {
  const auto& warning = method_named("ch").warning;
  EXPECT_EQ(warning(*test::make_mesh(test::icosphere(3))), "");
  EXPECT_NE(
      warning(*test::make_mesh(test::icosphere(5))).find("up to 4.2e+08 windows on this mesh of 20480 faces"),
      std::string::npos);
}

}  // namespace
}  // namespace vorogeo

// Virtual sources as a method: vertices in, distances out; what they are is tested with core/exact.
#include <gtest/gtest.h>

#include "exact/virtual_sources.h"
#include "support/indexes.h"
#include "support/methods.h"

namespace vorogeo {
namespace {

TEST(GspMethod, GivesTheDistancesOfVirtualSources) {
  const auto mesh = test::make_mesh(test::icosphere(3));
  const auto field = test::method_field("gsp", mesh, {3, 100});
  VirtualSources runs(mesh);
  const std::vector<ExactSource> sources{{SurfacePoint::at_vertex(3)}, {SurfacePoint::at_vertex(100)}};
  runs.run(sources);
  for (Index v = 0; v < mesh->vertex_count(); ++v) EXPECT_EQ(field[v], runs.distance(v));
}

TEST(GspMethod, GoesRoundAnEndOfASlit) {
  const auto mesh = test::make_mesh(test::plane_with_slit(8).soup);
  EXPECT_LT(test::errors_against_exact("gsp", mesh, 3).mean, 0.003);
}

}  // namespace
}  // namespace vorogeo

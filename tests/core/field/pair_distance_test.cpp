// Pairs of work vertices on a plane: straight lines, exactly where they are near.
#include "field/pair_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

TEST(PairDistance, StraightOnAPlaneInBothForms) {
  const test::Soup soup = test::plane_grid(36, 36, 1.0, 1.0, 0.2).soup;
  for (const auto& index : {test::make_index(soup, 5, 4), test::make_graph_index(soup, 5, 4)}) {
    const IndexData& data = index->data();
    const Mesh& mesh = *data.work.mesh;
    NearField near(data);
    PairDistance pairs(data, near);
    test::ErrorCollector errors;
    for (Index a : test::random_vertices(mesh.vertex_count(), 20, 1)) {
      const auto own = test::patches_at(mesh, data.work.second_layer, a);
      for (Index b : test::random_vertices(mesh.vertex_count(), 20, 2)) {
        if (a == b) continue;
        const Point& p = mesh.position(a);
        const Point& q = mesh.position(b);
        const double straight = std::hypot(p[0] - q[0], p[1] - q[1]);
        const double found = pairs.distance(a, b);
        EXPECT_EQ(found, pairs.distance(b, a));
        errors.add(found, straight);
        const auto there = test::patches_at(mesh, data.work.second_layer, b);
        const bool in_one_patch =
            std::ranges::any_of(own, [&](Index patch) { return there.contains(patch); });
        if (in_one_patch) {
          EXPECT_NEAR(found, straight, 1e-9) << a << ", " << b;
        }
      }
    }
    // Patches of some twenty vertices, a few borders between the ends: errors are far above those of a mesh.
    EXPECT_LE(errors.statistics().mean, 5e-4);
    EXPECT_LE(errors.statistics().greatest, 1e-2);
  }
}

}  // namespace
}  // namespace vorogeo

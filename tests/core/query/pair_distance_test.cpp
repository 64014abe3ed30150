// Pairs of work vertices on a plane: straight lines, exactly where they are near.
#include "query/pair_distance.h"

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
        // Also closer than half a patch is wide, whether patches touch or not.
        const double members = static_cast<double>(mesh.vertex_count()) / data.second.patch_count;
        if (in_one_patch || straight < 0.5 * std::sqrt(members) * mesh.typical_edge_length()) {
          EXPECT_NEAR(found, straight, 1e-9) << a << ", " << b;
        }
      }
    }
    // Patches of some twenty vertices, a few borders between the ends: errors are far above those of a mesh.
    EXPECT_LE(errors.statistics().mean, 5e-4);
    EXPECT_LE(errors.statistics().greatest, 1e-2);
  }
}

/// Whether a patch of one vertex is or touches one of the other.
bool are_near(const IndexData& data, Index a, Index b) {
  const auto own = test::patches_at(*data.work.mesh, data.work.second_layer, a);
  const auto there = test::patches_at(*data.work.mesh, data.work.second_layer, b);
  return std::ranges::any_of(own, [&](Index p) {
    return std::ranges::any_of(there, [&](Index q) { return p == q || data.second.touching.touch(p, q); });
  });
}

// On a thin prism, near ends may lie on opposite sides, where straight lines in space say little; with a
// metric of half those lengths, they say nothing in the first run.
TEST(PairDistance, NearEndsOnAThinPrismInTwoMetrics) {
  const test::Shape prism = test::prism(3, 4, 30, 0.4, 3.0, 0.3);
  for (const double scale : {1.0, 0.5}) {
    const auto plain = test::make_mesh(prism.soup);
    SideLengths sides(plain->face_count());
    for (Index h = 0; h < 3 * plain->face_count(); ++h) {
      // The length of the side opposite each corner.
      sides[h / 3][(h + 2) % 3] = scale * plain->edge_length(plain->edge_of(h));
    }
    const auto mesh =
        scale == 1.0 ? plain : std::make_shared<const Mesh>(plain->positions(), plain->faces(), sides);
    IndexOptions options;
    options.first_layer_patches = 3;
    options.second_layer_patches = 3;
    const auto index = GeodesicIndex::build(mesh, options);
    const IndexData& data = index->data();
    NearField near(data);
    PairDistance pairs(data, near);
    int tested = 0;
    for (Index a : test::random_vertices(mesh->vertex_count(), 25, 3)) {
      for (Index b : test::random_vertices(mesh->vertex_count(), 25, 4)) {
        const Index from = data.work.work_vertex[a];
        const Index to = data.work.work_vertex[b];
        if (a == b || !are_near(data, from, to)) continue;
        EXPECT_NEAR(pairs.distance(from, to), scale * prism.vertex_distance(a, b), 1e-12) << a << ", " << b;
        ++tested;
      }
    }
    EXPECT_GE(tested, 100);
  }
}

}  // namespace
}  // namespace vorogeo

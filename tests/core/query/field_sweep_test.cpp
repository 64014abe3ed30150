// Sweeps over a patch: the least sum over the border, unfolded; exact from exact border distances in the
// plane.
#include <gtest/gtest.h>

#include <algorithm>

#include "exact/exact_solver.h"
#include "index/boundary_dijkstra.h"
#include "query/border_field.h"
#include "support/hostile_meshes.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

/// The border distances of a search over the second layer.
struct Searched {
  Searched(const PatchLayer& layer, const BoundaryDijkstra& search) {
    for (Index node = 0; node < layer.node_count(); ++node) {
      distance.push_back(search.distance(node));
      before.push_back(search.predecessor(node));
    }
  }
  operator BorderDistances() const { return {distance, before}; }
  std::vector<double> distance;
  std::vector<Index> before;
};

TEST(FieldSweep, AtMostTheLeastSumAndNotBelowIt) {
  const auto index = test::make_index(test::hills(40, 0.12), 4, 4);
  const PatchLayer& layer = index->data().second;
  BoundaryDijkstra search(layer);
  search.reset();
  search.add(layer.node_count() / 2, 0.0);
  search.run();
  const Searched searched(layer, search);
  FieldSweep sweep;
  test::ErrorCollector against_sums;
  for (Index p = 0; p < layer.patch_count; ++p) {
    const auto found = sweep.sweep(layer, searched, p);
    ASSERT_EQ(static_cast<Index>(found.size()), layer.member_count(p));
    for (Index i = 0; i < layer.border_size(p); ++i) EXPECT_EQ(found[i], search.distance(layer.nodes(p)[i]));
    for (Index column = layer.border_size(p); column < layer.member_count(p); ++column) {
      double least = unreachable;
      for (Index row = 0; row < layer.border_size(p); ++row) {
        least = std::min(least, search.distance(layer.nodes(p)[row]) + layer.distance(p, row, column));
      }
      // Border distances are rounded to the unit of the table when sums are compared.
      EXPECT_LE(found[column], least * (1.0 + 1e-6) + layer.scale[p].unit());
      against_sums.add(found[column], least);
    }
  }
  EXPECT_GT(against_sums.statistics().least, -0.05) << "unfolding shortens a path, not more";
}

/// Errors of sweeps from exact border distances, outside the patches of a few sources.
test::ErrorCollector sweep_errors(const test::Soup& soup) {
  const auto index = test::make_index(soup, 3, 5);
  const IndexData& data = index->data();
  const PatchLayer& layer = data.second;
  ExactSolver solver(data.geometry->windows);
  BoundaryDijkstra search(layer);
  FieldSweep sweep;
  test::ErrorCollector errors;
  for (Index source : test::random_vertices(data.work.mesh->vertex_count(), 5, 1)) {
    solver.run_from_vertices(std::array{source});
    search.reset();
    for (Index node = 0; node < layer.node_count(); ++node) {
      search.add(node, solver.distance(layer.node_vertex[node]));
    }
    const Searched searched(layer, search);
    const auto own = test::patches_at(*data.work.mesh, data.work.second_layer, source);
    for (Index p = 0; p < layer.patch_count; ++p) {
      if (own.contains(p)) continue;
      const auto found = sweep.sweep(layer, searched, p);
      for (std::size_t i = 0; i < found.size(); ++i)
        errors.add(found[i], solver.distance(layer.members(p)[i]));
    }
  }
  return errors;
}

TEST(FieldSweep, FromExactBorderDistancesNearlyExact) {
  for (const test::Soup& soup : {test::plane_grid(40, 40, 1.0, 1.0, 0.2).soup, test::icosphere(4)}) {
    const test::ErrorCollector errors = sweep_errors(soup);
    EXPECT_EQ(errors.contradictions, 0U);
    EXPECT_LT(errors.statistics().mean, 1e-4);
    EXPECT_LT(errors.statistics().p99, 1e-3);
    EXPECT_GT(errors.statistics().least, -0.01);
  }
}

TEST(FieldSweep, RightBehindLongBorderEdges) {
  // Prisms with long sides between arcs of short ones: some vertices lie right behind the middle of a side.
  for (const int seed : {2, 3}) {
    test::HostileRandom random(seed);
    const auto mesh = test::hostile_base(test::HostileBase::extrusion, 2500, random);
    SCOPED_TRACE(mesh.sentence());
    const test::ErrorCollector errors = sweep_errors(mesh.soup);
    EXPECT_EQ(errors.contradictions, 0U);
    EXPECT_LT(errors.statistics().greatest, 0.005);
  }
}

TEST(FieldSweep, APatchThatTheSearchDidNotReachIsUnreachable) {
  const auto index = test::make_index(test::two_components(test::icosphere(2), test::icosphere(2)), 2, 3);
  const IndexData& data = index->data();
  BoundaryDijkstra search(data.second);
  search.reset();
  search.add(data.second.nodes(0)[0], 0.0);
  search.run();
  const Searched searched(data.second, search);
  FieldSweep sweep;
  const Index component = data.work.mesh->component(data.second.members(0)[0]);
  for (Index p = 0; p < data.second.patch_count; ++p) {
    const auto found = sweep.sweep(data.second, searched, p);
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i] == unreachable, data.work.mesh->component(data.second.members(p)[i]) != component);
    }
  }
}

TEST(FieldSweep, FarFromTheSourceNothingIsLostToRounding) {
  // Border distances around ten million, of which single precision would keep only whole numbers.
  const auto index = test::make_index(test::plane_grid(20, 20, 1.0, 1.0, 0.2).soup, 1, 4);
  const PatchLayer& layer = index->data().second;
  BoundaryDijkstra search(layer);
  search.reset();
  for (Index i = 0; i < layer.border_size(0); ++i) search.add(layer.nodes(0)[i], 1e7 + 0.01 * i);
  const Searched searched(layer, search);
  FieldSweep sweep;
  const auto found = sweep.sweep(layer, searched, 0);
  for (Index column = layer.border_size(0); column < layer.member_count(0); ++column) {
    double least = unreachable;
    double shortest = unreachable;
    for (Index row = 0; row < layer.border_size(0); ++row) {
      least = std::min(least, 0.01 * row + layer.distance(0, row, column));
      shortest = std::min<double>(shortest, layer.distance(0, row, column));
    }
    EXPECT_LE(found[column] - 1e7, least + layer.scale[0].unit());
    EXPECT_GE(found[column] - 1e7, shortest - 0.05) << "unfolding shortens by less than a border edge";
  }
}

}  // namespace
}  // namespace vorogeo

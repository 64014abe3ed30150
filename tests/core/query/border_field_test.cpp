// Distances of the border nodes, from table to table and by search: against exact distances.
#include "query/border_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "exact/exact_solver.h"
#include "support/heavy.h"
#include "support/hostile_meshes.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

void fill_all(const IndexData& data, BorderField& field, FieldSweep& sweep) {
  for (Index p = 0; p < data.first.patch_count; ++p) field.fill(p, sweep);
}

TEST(BorderField, CloseToExactFromOneNode) {
  for (const test::Soup& soup : test::one_under_sanitizers<test::Soup>(
           {test::plane_grid(50, 50, 1.0, 1.0, 0.2).soup, test::icosphere(4), test::hills(45, 0.12),
            test::torus(70, 34, 2.0, 0.8)})) {
    const auto index = test::make_index(soup, 6, 4);
    const IndexData& data = index->data();
    ASSERT_GT(data.transit_table.count, 0);
    BorderField field(data);
    FieldSweep sweep;
    ExactSolver solver(data.geometry->windows);
    test::ErrorCollector errors;
    for (Index seed : test::random_vertices(data.second.node_count(), 12, 7)) {
      field.reset(std::array{BorderField::Seed{seed, 0.0, 0}});
      fill_all(data, field, sweep);
      solver.run_from_vertices(std::array{data.second.node_vertex[seed]});
      const BorderDistances border = field.border();
      for (Index node = 0; node < data.second.node_count(); ++node) {
        errors.add(border.distance[node], solver.distance(data.second.node_vertex[node]));
      }
    }
    EXPECT_EQ(errors.contradictions, 0U);
    EXPECT_LT(errors.statistics().mean, 5e-4);
    EXPECT_LT(errors.statistics().p99, 5e-3);
    EXPECT_GT(errors.statistics().least, -0.02);
  }
}

TEST(BorderField, TheSameToTheLastBitWhateverTheThreads) {
  const auto index = test::make_index(test::hills(60, 0.12), 20, 3);
  const IndexData& data = index->data();
  // Several threads have something to do.
  ASSERT_GT(data.transit_table.group_count(), 64);
  FieldSweep sweep;
  BorderField alone(data);
  for (Index seed : test::random_vertices(data.second.node_count(), 3, 5)) {
    const std::array seeds{BorderField::Seed{seed, 0.0, 0}};
    alone.reset(seeds);
    fill_all(data, alone, sweep);
    for (int threads : {2, 3, 8}) {
      BorderField shared(data, threads);
      shared.reset(seeds);
      fill_all(data, shared, sweep);
      EXPECT_TRUE(std::ranges::equal(shared.border().distance, alone.border().distance)) << threads;
      EXPECT_TRUE(std::ranges::equal(shared.border().predecessor, alone.border().predecessor)) << threads;
    }
  }
}

/// Greatest relative error of all nodes from exact seeds: the border of the patch around each source.
double greatest_error(const test::Soup& soup) {
  const auto index = test::make_index(soup, 3, 6);
  const IndexData& data = index->data();
  BorderField field(data);
  FieldSweep sweep;
  ExactSolver solver(data.geometry->windows);
  double greatest = 0.0;
  for (Index source : test::random_vertices(data.work.mesh->vertex_count(), 8, 3)) {
    solver.run_from_vertices(std::array{source});
    std::vector<BorderField::Seed> seeds;
    for (Index node : data.second.nodes(data.home_patch[source])) {
      seeds.push_back({node, solver.distance(data.second.node_vertex[node]), 0});
    }
    field.reset(seeds);
    fill_all(data, field, sweep);
    for (Index node = 0; node < data.second.node_count(); ++node) {
      const double exact = solver.distance(data.second.node_vertex[node]);
      if (exact > 0.0) greatest = std::max(greatest, field.border().distance[node] / exact - 1.0);
    }
  }
  return greatest;
}

TEST(BorderField, NodesRightBehindLongBorderEdges) {
  // Prisms with long sides between arcs of short ones.
  for (const int seed : {1, 4}) {
    test::HostileRandom random(seed);
    const auto mesh = test::hostile_base(test::HostileBase::extrusion, 2500, random);
    EXPECT_LT(greatest_error(mesh.soup), 0.01) << mesh.sentence();
  }
}

TEST(BorderField, TablesAndSearchAgree) {
  const auto index = test::make_index(test::hills(50, 0.1), 6, 4);
  const IndexData& data = index->data();
  BorderField by_table(data);
  FieldSweep sweep;
  const std::array seeds{BorderField::Seed{3, 0.25, 0}};
  by_table.reset(seeds);
  fill_all(data, by_table, sweep);
  BoundaryDijkstra search(data.second);
  search.reset();
  search.add(3, 0.25);
  search.run();
  for (Index node = 0; node < data.second.node_count(); ++node) {
    EXPECT_NEAR(by_table.border().distance[node], search.distance(node), 0.02 * search.distance(node));
  }
}

TEST(BorderField, SourcesInEveryPatchAreSearched) {
  const auto index = test::make_index(test::icosphere(4), 4, 4);
  const IndexData& data = index->data();
  std::vector<BorderField::Seed> seeds;
  for (Index node = 0; node < data.second.node_count(); node += 9) {
    seeds.push_back({node, 0.0, static_cast<Index>(seeds.size())});
  }
  BorderField field(data);
  FieldSweep sweep;
  field.reset(seeds);
  fill_all(data, field, sweep);
  std::vector<Index> sources;
  for (const auto& seed : seeds) sources.push_back(data.second.node_vertex[seed.node]);
  ExactSolver solver(data.geometry->windows);
  solver.run_from_vertices(sources);
  test::ErrorCollector errors;
  for (Index node = 0; node < data.second.node_count(); ++node) {
    errors.add(field.border().distance[node], solver.distance(data.second.node_vertex[node]));
  }
  EXPECT_EQ(errors.contradictions, 0U);
  EXPECT_LT(errors.statistics().mean, 3e-3);
}

TEST(BorderField, ASecondStartForgetsTheFirstAndOtherComponentsStayUnreachable) {
  const auto index = test::make_index(test::two_components(test::icosphere(3), test::icosphere(3)), 8, 3);
  const IndexData& data = index->data();
  const Mesh& mesh = *data.work.mesh;
  const Index nodes = data.second.node_count();
  BorderField used(data);
  BorderField fresh(data);
  FieldSweep sweep;
  const std::array other{BorderField::Seed{nodes - 1, 0.5, 0}};
  const std::array seeds{BorderField::Seed{2, 0.0, 0}};
  used.reset(other);
  fill_all(data, used, sweep);
  used.reset(seeds);
  fill_all(data, used, sweep);
  fresh.reset(seeds);
  fill_all(data, fresh, sweep);
  const Index own = mesh.component(data.second.node_vertex[2]);
  for (Index node = 0; node < nodes; ++node) {
    const double distance = used.border().distance[node];
    EXPECT_EQ(distance, fresh.border().distance[node]);
    EXPECT_EQ(distance == unreachable, mesh.component(data.second.node_vertex[node]) != own);
  }
}

TEST(BorderField, WithinABoundAsWithoutOne) {
  const auto index = test::make_index(test::hills(45, 0.12), 6, 4);
  const IndexData& data = index->data();
  BorderField whole(data);
  BorderField bounded(data);
  FieldSweep sweep;
  const std::array seeds{BorderField::Seed{10, 0.0, 0}};
  whole.reset(seeds);
  fill_all(data, whole, sweep);
  for (double bound : {0.1, 0.4, 0.8}) {
    bounded.reset(seeds, bound);
    fill_all(data, bounded, sweep);
    for (Index node = 0; node < data.second.node_count(); ++node) {
      const double distance = whole.border().distance[node];
      if (distance > 0.99 * bound) continue;
      EXPECT_NEAR(bounded.border().distance[node], distance, 1e-3 * distance) << bound;
    }
  }
}

}  // namespace
}  // namespace vorogeo

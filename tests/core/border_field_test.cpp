// Distances of the border nodes, from table to table and by search: against exact distances.
#include "query/border_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "exact/exact_solver.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

void fill_all(const IndexData& data, BorderField& field, FieldSweep& sweep) {
  for (Index p = 0; p < data.first.patch_count; ++p) field.fill(p, sweep);
}

TEST(BorderField, CloseToExactFromOneNode) {
  for (const test::Soup& soup : {test::plane_grid(50, 50, 1.0, 1.0, 0.2).soup, test::icosphere(4),
                                 test::hills(45, 0.12), test::torus(70, 34, 2.0, 0.8)}) {
    const auto index = test::make_index(soup, 6, 4);
    const IndexData& data = index->data();
    ASSERT_GT(data.node_table.count, 0);
    BorderField field(data);
    FieldSweep sweep;
    ExactSolver solver(data.geometry);
    test::ErrorCollector errors;
    for (Index start : test::random_vertices(data.second.node_count(), 12, 7)) {
      field.start(std::array{BorderField::Start{start, 0.0, 0}});
      fill_all(data, field, sweep);
      solver.run_from_vertices(std::array{data.second.node_vertex[start]});
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

TEST(BorderField, TablesAndSearchAgree) {
  const auto index = test::make_index(test::hills(50, 0.1), 6, 4);
  const IndexData& data = index->data();
  BorderField by_table(data);
  FieldSweep sweep;
  const std::array starts{BorderField::Start{3, 0.25, 0}};
  by_table.start(starts);
  fill_all(data, by_table, sweep);
  BorderSearch search(data.second);
  search.start();
  search.add(3, 0.25);
  search.run();
  for (Index node = 0; node < data.second.node_count(); ++node) {
    EXPECT_NEAR(by_table.border().distance[node], search.distance(node), 0.02 * search.distance(node));
  }
}

TEST(BorderField, SourcesInEveryPatchAreSearched) {
  const auto index = test::make_index(test::icosphere(4), 4, 4);
  const IndexData& data = index->data();
  std::vector<BorderField::Start> starts;
  for (Index node = 0; node < data.second.node_count(); node += 9) {
    starts.push_back({node, 0.0, static_cast<Index>(starts.size())});
  }
  BorderField field(data);
  FieldSweep sweep;
  field.start(starts);
  fill_all(data, field, sweep);
  std::vector<Index> sources;
  for (const auto& start : starts) sources.push_back(data.second.node_vertex[start.node]);
  ExactSolver solver(data.geometry);
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
  const std::array other{BorderField::Start{nodes - 1, 0.5, 0}};
  const std::array starts{BorderField::Start{2, 0.0, 0}};
  used.start(other);
  fill_all(data, used, sweep);
  used.start(starts);
  fill_all(data, used, sweep);
  fresh.start(starts);
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
  const std::array starts{BorderField::Start{10, 0.0, 0}};
  whole.start(starts);
  fill_all(data, whole, sweep);
  for (double bound : {0.1, 0.4, 0.8}) {
    bounded.start(starts, bound);
    fill_all(data, bounded, sweep);
    for (Index node = 0; node < data.second.node_count(); ++node) {
      const double distance = whole.border().distance[node];
      if (distance > 0.99 * bound) continue;
      EXPECT_NEAR(bounded.border().distance[node], distance, 1e-3 * distance) << bound;
    }
  }
}

TEST(BorderField, ChildrenAreTheSecondLayerPatchesOfAFirstLayerPatch) {
  const auto index = test::make_index(test::hills(30, 0.12), 4, 5);
  const IndexData& data = index->data();
  const BorderField field(data);
  for (Index p = 0; p < data.second.patch_count; ++p) {
    const NodeRange children = field.children(data.partition.parent[p]);
    EXPECT_TRUE(children.begin <= p && p < children.end);
  }
}

}  // namespace
}  // namespace vorogeo

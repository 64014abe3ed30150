// Building an index: statistics, refusals, warnings, estimates, memory budgets, patches.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "index/border_pieces.h"
#include "index/build_cost.h"
#include "index/geodesic_index.h"
#include "index/index_data.h"
#include "patches/partition.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/refusal.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

TEST(GeodesicIndex, StatisticsSayWhatIsThere) {
  const Soup soup = test::with_isolated_vertex(test::icosphere(3), {5, 5, 5});
  const auto index = test::make_index(soup, 3, 5, 0.01);
  const auto& statistics = index->statistics();
  EXPECT_EQ(statistics.vertices, 643);
  EXPECT_EQ(statistics.faces, 1280);
  EXPECT_EQ(statistics.components, 2);
  EXPECT_EQ(statistics.first_layer_patches, 3);
  EXPECT_EQ(statistics.second_layer_patches, 15);
  EXPECT_EQ(statistics.delta, 0.01);
  EXPECT_EQ(statistics.seed, 0U);
  EXPECT_GT(statistics.seconds, 0.0);
  EXPECT_GT(statistics.arcs, 0);
  EXPECT_LT(statistics.arcs, statistics.arcs_before_pruning);
  EXPECT_EQ(statistics.form, IndexForm::graph) << "asked for by delta";
  EXPECT_EQ(statistics.arcs, pairs_of_nodes(index->data().second) +
                                 static_cast<std::int64_t>(index->data().graph.arc.size() / 2));
  // Border vertices by definition: places in two or more patches.
  const IndexData& data = index->data();
  Index first = 0;
  Index second = 0;
  for (Index place = 0; place < data.surface.place_count(); ++place) {
    std::set<Index> patches;
    for_each_face_at(*data.surface.mesh, data.surface.surface_point(place),
                     [&](Index f, const auto&) { patches.insert(data.surface.second_layer[f]); });
    std::set<Index> parents;
    for (Index p : patches) parents.insert(data.partition.parent[p]);
    first += parents.size() > 1;
    second += patches.size() > 1;
  }
  EXPECT_EQ(statistics.first_layer_border_vertices, first);
  EXPECT_EQ(statistics.second_layer_border_vertices, second);
}

TEST(GeodesicIndex, TheLongestPieceOfABorderIsTheGreatestGapBetweenItsPoints) {
  // Cells of 0.8 x 0.25 in three patches: the left half, and the right one below and above y = 1. Edges
  // between the latter two are long for their patches, so they have points inside.
  IndexData data;
  data.mesh = test::make_mesh(test::plane_grid(10, 8, 8.0, 2.0).soup);
  data.partition.first_layer.assign(data.mesh->face_count(), 0);
  data.partition.first_layer_count = 1;
  data.partition.parent.assign(3, 0);
  data.partition.second_layer_count = 3;
  for (Index f = 0; f < data.mesh->face_count(); ++f) {
    double x = 0.0;
    double y = 0.0;
    for (Index v : data.mesh->face_vertices(f)) {
      x += data.mesh->position(v)[0] / 3.0;
      y += data.mesh->position(v)[1] / 3.0;
    }
    data.partition.second_layer.push_back(x < 4.0 ? 0 : (y < 1.0 ? 1 : 2));
  }
  data.lay_out(1, {});
  ASSERT_EQ(data.longest_piece.size(), 3U);
  // The borders are straight lines along the axes, the second and third with a corner at (4, 1): these sums
  // grow along them as their lengths do.
  const std::array<std::array<double, 2>, 3> along{{{0.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}}};
  for (Index p = 0; p < 3; ++p) {
    std::set<double> at;
    for (Index node : data.second.nodes(p)) {
      const Point& place = data.node_position[node];
      at.insert(along[p][0] * place[0] + along[p][1] * place[1]);
    }
    double greatest = 0.0;
    for (auto it = std::next(at.begin()); it != at.end(); ++it)
      greatest = std::max(greatest, *it - *std::prev(it));
    EXPECT_NEAR(data.longest_piece[p], greatest, 1e-12) << p;
  }
  EXPECT_NEAR(data.longest_piece[0], 0.25, 1e-12);
  EXPECT_GT(data.longest_piece[1], 0.25) << "pieces of the edges of 0.8";
  EXPECT_LT(data.longest_piece[1], 0.5) << "which have points inside";
  const auto whole = test::make_index(test::icosphere(1), 1, 1);
  EXPECT_EQ(whole->data().longest_piece, std::vector<double>{0.0}) << "no border";
}

TEST(GeodesicIndex, Refusals) {
  auto refusal = [](const Soup& soup, const IndexOptions& options) {
    return test::refusal([&] { GeodesicIndex::build(test::make_mesh(soup), options); });
  };
  EXPECT_EQ(test::refusal([] { test::make_index(test::icosphere(0))->face_patches(3); }),
            "Layer 3 does not exist: layers are 1 (large patches) and 2.");
  IndexOptions options;
  for (double delta : {-0.1, 1.0, std::numeric_limits<double>::quiet_NaN(), unreachable}) {
    options.delta = delta;
    EXPECT_EQ(refusal(test::icosphere(0), options),
              "delta is " + std::to_string(delta) + "; it must be at least 0 (nothing lost) and below 1.");
  }
  options = {};
  EXPECT_EQ(refusal({}, options), "The mesh has no face; geodesic distances need a surface.");
  const std::string range =
      "; an index takes lengths between 1e-28 and 1e+28: scale the mesh, for example by ";
  EXPECT_EQ(
      refusal(test::scaled(test::icosphere(0), 1e40), options),
      "The mesh has a mean edge length of 1.05146e+40 and a longest edge of 1.05146e+40" + range + "1e-40.");
  EXPECT_EQ(
      refusal(test::scaled(test::icosphere(0), 1e-40), options),
      "The mesh has a mean edge length of 1.05146e-40 and a longest edge of 1.05146e-40" + range + "1e+40.");
  options.first_layer_patches = -3;
  EXPECT_EQ(refusal(test::icosphere(0), options),
            "The number of first-layer patches, n1, is -3; give one from 0 (automatic) to 20, the number of "
            "faces.");
}

TEST(GeodesicIndex, TinyMeshesAndAsManyPatchesAsFaces) {
  const Soup triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(test::make_index(triangle)->statistics().second_layer_border_vertices, 0);
  const Soup all = test::icosphere(0);
  for (Index n1 : {1, 20}) {
    for (Index n2 : {1, 20}) {
      const auto index = test::make_index(all, n1, n2);
      EXPECT_GE(index->statistics().second_layer_patches, 1);
    }
  }
}

/// A surface of many parts with several patches each: a field stays in one part, tables cover all of them.
Soup many_tori(int count) {
  const Soup part = test::torus(60, 30, 2.0, 0.7);
  Soup all = part;
  for (int i = 1; i < count; ++i) all = test::two_components(all, part);
  return all;
}

TEST(GeodesicIndex, WarnsWithFiguresBeforeABuildThatHardlyPays) {
  std::vector<std::string> warnings;
  double reached = 0.0;
  const Progress progress(
      [&](double fraction, const std::string&) {
        reached = fraction;
        return true;
      },
      [&](const std::string& sentence) {
        warnings.push_back(sentence);
        return false;
      });
  const auto mesh = test::make_mesh(many_tori(24));
  EXPECT_THROW(GeodesicIndex::build(mesh, {}, progress), Cancelled);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_LE(reached, 0.115) << "before the tables";
  std::smatch figures;
  ASSERT_TRUE(std::regex_search(
      warnings[0], figures, std::regex("about ([0-9.]+) s of one core, as long as ([0-9]+) exact fields")))
      << warnings[0];
  EXPECT_GE(std::stod(figures[1]), 1.0);
  EXPECT_GE(std::stod(figures[2]), fields_to_warn);
}

// Estimates of a build, against the index that is then built.

TEST(BuildEstimate, SaysWhatTheIndexWillHold) {
  for (const test::Soup& soup :
       {test::icosphere(4), test::drilled_plate(5, 4, 0.2, 3), test::hills(50, 0.3)}) {
    const auto index = test::make_index(soup);
    const BuildEstimate estimate = estimate_build(test::make_mesh(soup));
    EXPECT_GT(estimate.bytes, 0.5 * index->statistics().bytes);
    EXPECT_LT(estimate.bytes, 2.0 * index->statistics().bytes);
    EXPECT_EQ(estimate.form, IndexForm::tables);
    EXPECT_GT(estimate.build_seconds, 0.0);
    EXPECT_GE(estimate.core_seconds, estimate.build_seconds);
    EXPECT_GT(estimate.exact_field_seconds, 0.0);
    EXPECT_GT(estimate.field_seconds, 0.0);
  }
}

TEST(BuildEstimate, TakesPartsOfALargeMeshForTheWhole) {
  // The same surface with fewer and with more faces than make a mesh large.
  const BuildEstimate whole = estimate_build(test::make_mesh(test::torus(240, 120, 3.0, 1.0)));
  const BuildEstimate parts = estimate_build(test::make_mesh(test::torus(480, 240, 3.0, 1.0)));
  EXPECT_GT(parts.bytes, 2.5 * whole.bytes);
  EXPECT_LT(parts.bytes, 9.0 * whole.bytes);
  EXPECT_GT(parts.exact_field_seconds, whole.exact_field_seconds);
  EXPECT_LT(parts.field_seconds, parts.exact_field_seconds);
}

/// Expects that the estimate for these numbers of patches (0: automatic) is about the size of an index of
/// tables, which follows from the layout.
void expect_bytes_laid_out(const std::shared_ptr<const Mesh>& mesh, Index first, Index second) {
  IndexData data;
  data.mesh = mesh;
  data.partition = make_partition(*data.mesh, {first, second}, {});
  data.lay_out(2, {});
  const double held = static_cast<double>(data.bytes() + table_bytes(data.second) + table_bytes(data.first) +
                                          transit_bytes(data.first, false) + access_bounds_bytes(data));
  IndexOptions options;
  options.first_layer_patches = first;
  options.second_layer_patches = second;
  EXPECT_NEAR(estimate_build(mesh, options).bytes, held, 0.3 * held);
}

TEST(BuildEstimate, PartsOfALargeMeshHaveTheirShareOfThePatchesAskedFor) {
  expect_bytes_laid_out(test::make_mesh(test::torus(300, 150, 3.0, 1.0)), 60, 5);
}

TEST(BuildEstimate, LargeMeshesWhoseComponentsAreFirstLayerPatchesHaveNoBordersThere) {
  test::Soup many = test::torus(60, 30, 3.0, 1.0);
  while (many.faces.size() < 80000) many = test::two_components(many, many);
  expect_bytes_laid_out(test::make_mesh(many), 0, 0);
}

TEST(BuildEstimate, ALargeMeshOfOneFirstLayerPatchHasNoBordersThere) {
  expect_bytes_laid_out(test::make_mesh(test::torus(240, 150, 3.0, 1.0)), 1, 100);
}

TEST(BuildEstimate, ChoosesTheFormByTheMemoryBudget) {
  IndexOptions options;
  options.memory_budget = 1;
  EXPECT_EQ(estimate_build(test::make_mesh(test::icosphere(5)), options).form, IndexForm::graph);
}

TEST(BuildEstimate, RefusesWhatABuildRefusesAndIsCancelled) {
  EXPECT_THROW(estimate_build(test::make_mesh({{{0.0, 0.0, 0.0}}, {}})), InvalidInput);
  IndexOptions options;
  options.delta = 2.0;
  EXPECT_THROW(estimate_build(test::make_mesh(test::icosphere(1)), options), InvalidInput);
  const Progress stop([](double, const std::string&) { return false; });
  EXPECT_THROW(estimate_build(test::make_mesh(test::icosphere(3)), {}, stop), Cancelled);
}

// The two forms: which is chosen, and the refusal of a budget that is too small.

constexpr double mib = 1 << 20;

struct Case {
  std::shared_ptr<const Mesh> mesh = test::make_mesh(test::hills(56, 0.1));
  IndexOptions options;
  Case() {
    options.first_layer_patches = 12;
    options.second_layer_patches = 3;
  }
  std::shared_ptr<const GeodesicIndex> build(std::int64_t budget, double delta = 0.0) {
    options.memory_budget = budget;
    options.delta = delta;
    return GeodesicIndex::build(mesh, options);
  }
  std::string refusal(std::int64_t budget, double delta = 0.0) {
    return test::refusal([&] { build(budget, delta); });
  }
};

TEST(MemoryBudget, ChoosesTheForm) {
  Case c;
  const auto tables = c.build(0);
  EXPECT_EQ(tables->statistics().form, IndexForm::tables);
  EXPECT_GT(tables->data().transit_table.count, 0);
  const auto graph = c.build(0, 0.05);
  EXPECT_EQ(graph->statistics().form, IndexForm::graph) << "asked for by delta";
  EXPECT_EQ(graph->data().transit_table.count, 0);
  EXPECT_LT(graph->statistics().arcs, tables->statistics().arcs);
  EXPECT_LT(graph->statistics().bytes, tables->statistics().bytes);

  // A budget of exactly what the tables take is enough, so predicted sizes are the actual ones.
  const auto needed =
      static_cast<std::int64_t>(std::ceil(static_cast<double>(tables->statistics().bytes) / mib));
  EXPECT_EQ(c.build(needed)->statistics().form, IndexForm::tables);
}

TEST(MemoryBudget, OneThatIsTooSmallIsToldTheLeast) {
  Case c;
  const std::string whole = c.refusal(1);
  EXPECT_TRUE(whole.starts_with("The memory budget is 1 MiB, but the index of this mesh takes more than "))
      << whole;
  EXPECT_TRUE(
      whole.ends_with(" MiB in its smallest form: give a larger memory budget, or a delta above 0, which "
                      "makes the graph smaller."))
      << whole;
  const std::string early = c.refusal(1, 0.05);
  EXPECT_TRUE(early.starts_with("The memory budget is 1 MiB, but the index of this mesh takes more than "))
      << early;
  EXPECT_TRUE(early.ends_with(" MiB in its smallest form: give a larger memory budget or a larger delta."))
      << early;
  EXPECT_EQ(c.refusal(-1), "The memory budget is -1 MiB; give a positive number, or 0 for 4096 MiB.");
  // The least budget is enough, and one MiB less is not.
  const auto least =
      static_cast<std::int64_t>(std::ceil(static_cast<double>(c.build(0, 0.05)->statistics().bytes) / mib));
  EXPECT_EQ(c.build(least, 0.05)->statistics().form, IndexForm::graph);
  EXPECT_NE(c.refusal(least - 1, 0.05).find("takes"), std::string::npos);
}

// Patches of an index: made anew where tables would be large or borders long.

TEST(IndexPartition, PatchesOfAPlateWithDeepHolesGoThroughIt) {
  // With patches by distance, each side of the plate has its own, with borders around each hole between them.
  const auto mesh = test::make_mesh(test::drilled_plate(8, 8, 3.0, 2));
  const PartitionOptions options{0, 0, 1, 1};
  const Partition usual = make_partition(*mesh, options, {});
  const Partition found = partition_for_index(*mesh, options, {});
  ASSERT_GT(found.second_layer_count, 1);
  EXPECT_LT(wanted_entries(*mesh, found), 0.7 * wanted_entries(*mesh, usual));
  // Every patch has faces on both sides.
  std::vector<std::array<bool, 2>> has(found.second_layer_count, {false, false});
  for (Index f = 0; f < mesh->face_count(); ++f) {
    for (Index v : mesh->face_vertices(f))
      has[found.second_layer[f]][mesh->position(v)[2] > 1.5 ? 1 : 0] = true;
  }
  for (const auto& sides : has) EXPECT_TRUE(sides[0] && sides[1]);
}

TEST(IndexPartition, AFanOfThousandsOfNeedlesHasShortBorders) {
  const auto index = test::make_index(test::needle_disc(12000));
  EXPECT_LT(index->statistics().bytes, 1000 * index->mesh()->vertex_count());
  test::IndexQuery query(index, 1);
  const auto field = query.distance_field(std::array{Index{5}});
  for (Index v = 1; v < index->mesh()->vertex_count(); v += 7) {
    const double chord = 2.0 * std::abs(std::sin(std::numbers::pi * (v - 5) / 12000));
    EXPECT_NEAR(field[v], chord, 0.005 * chord) << v;
  }
}

}  // namespace
}  // namespace vorogeo

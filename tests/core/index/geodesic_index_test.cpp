// Building an index: options, statistics, determinism, progress and cancelling, defects, refusals.
#include "index/geodesic_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "index/index_data.h"
#include "support/error.h"
#include "support/indexes.h"
#include "support/shapes.h"

namespace vorogeo {
namespace {

using test::Soup;

bool same_contents(const IndexData& a, const IndexData& b) {
  auto same_arcs = [](const Arc& x, const Arc& y) {
    return x.target == y.target && x.length == y.length && x.leg == y.leg;
  };
  return a.partition.first_layer == b.partition.first_layer &&
         a.partition.second_layer == b.partition.second_layer && a.second.table == b.second.table &&
         a.first.table == b.first.table && a.graph.arc_begin == b.graph.arc_begin &&
         std::ranges::equal(a.graph.arc, b.graph.arc, same_arcs) &&
         a.graph.landmark_distance == b.graph.landmark_distance && a.home_patch == b.home_patch &&
         a.home_column == b.home_column;
}

TEST(GeodesicIndex, TheSameWhateverTheThreadsAnotherForAnotherSeed) {
  const auto mesh = test::make_mesh(test::hills(36, 0.15));
  IndexOptions options;
  options.first_layer_patches = 4;
  options.second_layer_patches = 4;
  options.delta = 0.005;
  options.seed = 3;
  options.threads = 1;
  const auto one = GeodesicIndex::build(mesh, options);
  for (int threads : {2, 4}) {
    options.threads = threads;
    EXPECT_TRUE(same_contents(GeodesicIndex::build(mesh, options)->data(), one->data()))
        << threads << " threads";
  }
  options.seed = 4;
  EXPECT_FALSE(same_contents(GeodesicIndex::build(mesh, options)->data(), one->data()));
}

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
  EXPECT_EQ(statistics.arcs, static_cast<std::int64_t>(index->data().graph.arc.size() / 2));
  const auto tables = static_cast<std::int64_t>(
      sizeof(std::uint16_t) * (index->data().first.table.size() + index->data().second.table.size()));
  EXPECT_EQ(statistics.form, IndexForm::graph) << "asked for by delta";
  EXPECT_GT(statistics.bytes, tables);
  EXPECT_LT(statistics.bytes, 8 * tables);
  // Border vertices by definition: vertices of the work mesh in two or more patches.
  const IndexData& data = index->data();
  Index first = 0;
  Index second = 0;
  for (Index v = 0; v < data.work.mesh->vertex_count(); ++v) {
    const auto patches = test::patches_at(*data.work.mesh, data.work.second_layer, v);
    std::set<Index> parents;
    for (Index p : patches) parents.insert(data.partition.parent[p]);
    first += parents.size() > 1;
    second += patches.size() > 1;
  }
  EXPECT_EQ(statistics.first_layer_border_vertices, first);
  EXPECT_EQ(statistics.second_layer_border_vertices, second);
}

TEST(GeodesicIndex, FacePatchesOfBothLayers) {
  const auto index = test::make_index(test::icosphere(3), 3, 5);
  for (int layer : {1, 2}) {
    const auto patches = index->face_patches(layer);
    EXPECT_EQ(patches.size(), 1280U);
    EXPECT_EQ(*std::ranges::min_element(patches), 0);
    EXPECT_EQ(*std::ranges::max_element(patches), layer == 1 ? 2 : 14);
  }
  try {
    index->face_patches(3);
    FAIL() << "not refused";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "Layer 3 does not exist: layers are 1 (large patches) and 2.");
  }
}

TEST(GeodesicIndex, Refusals) {
  auto refusal = [](const Soup& soup, const IndexOptions& options) -> std::string {
    try {
      GeodesicIndex::build(test::make_mesh(soup), options);
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "not refused";
  };
  IndexOptions options;
  for (double delta : {-0.1, 1.0, std::numeric_limits<double>::quiet_NaN(), unreachable}) {
    options.delta = delta;
    EXPECT_EQ(refusal(test::icosphere(0), options),
              "delta is " + std::to_string(delta) + "; it must be at least 0 (nothing lost) and below 1.");
  }
  options = {};
  EXPECT_EQ(refusal({}, options), "The mesh has no face; geodesic distances need a surface.");
  Soup huge = test::icosphere(0);
  for (Point& p : huge.positions) {
    for (double& x : p) x *= 1e40;
  }
  const std::string range =
      "; an index takes lengths between 1e-28 and 1e+28: scale the mesh, for example by ";
  EXPECT_EQ(
      refusal(huge, options),
      "The mesh has a mean edge length of 1.05146e+40 and a longest edge of 1.05146e+40" + range + "1e-40.");
  for (Point& p : huge.positions) {
    for (double& x : p) x *= 1e-80;
  }
  EXPECT_EQ(
      refusal(huge, options),
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

/// Builds with a report that is recorded; returns the number of reports.
int reports_of(const std::shared_ptr<const Mesh>& mesh, int allowed, std::vector<double>* seen = nullptr) {
  int reports = 0;
  IndexOptions options;
  options.first_layer_patches = 3;
  options.second_layer_patches = 4;
  GeodesicIndex::build(mesh, options, Progress([&](double fraction, const std::string& activity) {
                         EXPECT_FALSE(activity.empty());
                         if (seen) seen->push_back(fraction);
                         return reports++ < allowed;
                       }));
  return reports;
}

TEST(GeodesicIndex, ProgressOnlyGrowsAndEndsAtOne) {
  std::vector<double> seen;
  reports_of(test::make_mesh(test::icosphere(3)), 1 << 30, &seen);
  ASSERT_GE(seen.size(), 6U);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_GE(seen.front(), 0.0);
  EXPECT_EQ(seen.back(), 1.0);
}

TEST(GeodesicIndex, CancelledAtAnyReport) {
  const auto mesh = test::make_mesh(test::icosphere(2));
  const int reports = reports_of(mesh, 1 << 30);
  for (int allowed = 0; allowed < reports; ++allowed) {
    // A slower run may report more often, a faster one never less than the fixed reports.
    try {
      const int made = reports_of(mesh, allowed);
      EXPECT_LE(made, allowed);
    } catch (const Cancelled& error) {
      EXPECT_STREQ(error.what(), "Cancelled: nothing was changed.");
    }
  }
  EXPECT_THROW(reports_of(mesh, 0), Cancelled);
  EXPECT_THROW(reports_of(mesh, 3), Cancelled);
}

/// A surface of many parts, each of several patches: a field stays in one part, the tables are of all.
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

TEST(GeodesicIndex, DoesNotWarnOfAnIndexThatPays) {
  const Progress progress([](double, const std::string&) { return true; },
                          [](const std::string& sentence) {
                            ADD_FAILURE() << sentence;
                            return true;
                          });
  const auto index = GeodesicIndex::build(test::make_mesh(test::icosphere(4)), {}, progress);
  EXPECT_EQ(index->statistics().expected_fields, 0.0);
}

}  // namespace
}  // namespace vorogeo

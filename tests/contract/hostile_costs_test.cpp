// Never stuck on hostile meshes: each seed here once took a hundred times what a scan of its size takes, or
// had an index or a quick field that erred by a third.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <ctime>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "exact/exact_solver.h"
#include "index/geodesic_index.h"
#include "query/path_query.h"
#include "support/heavy.h"
#include "support/hostile_meshes.h"
#include "support/indexes.h"
#include "support/shapes.h"
#include "tasks/voronoi_regions.h"

namespace vorogeo {
namespace {

/// What a mesh costs, in processor time and memory.
enum Cost {
  exact_seconds,
  exact_bytes,
  build_seconds,
  index_bytes,
  field_seconds,
  pairs_seconds,
  paths_seconds
};
constexpr int cost_count = 7;
using Costs = std::array<double, cost_count>;
constexpr std::array<const char*, cost_count> names{
    "seconds of an exact field", "bytes of an exact field", "seconds of a build",    "bytes of an index",
    "seconds of a field",        "seconds of pairs",        "seconds of exact paths"};

/// How many times the cost of a scan of the same size, or up to somewhat more than twice as large, a mesh may
/// take. Fields, pairs and paths, which tables answer on a scan, are compared with its exact field.
constexpr Costs most_of_a_scan{10, 10, 10, 10, 5, 10, 10};
/// The same for a fan of a thousand needles on one edge of a folded sheet, and fans of needles round two
/// vertices, with spikes or beside such a sheet: many needles see most vertices of the rim, so an exact run
/// keeps a window for each pair of needle and vertex.
constexpr Costs most_of_fans{50, 100, 10, 10, 50, 80, 60};
/// The errors of the clock, and a handful of pages.
constexpr double clock_seconds = 0.02;
constexpr double some_bytes = 1 << 20;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

template <class Run>
double seconds_of(Run&& run) {
  const double start = processor_seconds();
  run();
  return processor_seconds() - start;
}

Costs costs_of(const test::Soup& soup) {
  const auto mesh = test::make_mesh(soup);
  // Vertices that have faces, spread over the mesh.
  auto vertex = [&](Index part) { return mesh->face_vertices(mesh->face_count() / 3 * part)[0]; };
  Costs costs{};
  ExactSolver solver(mesh);
  costs[exact_seconds] =
      seconds_of([&] { solver.run_from_vertices(std::array{vertex(0)}, {.distances_only = true}); });
  costs[exact_bytes] = static_cast<double>(solver.memory_bytes());
  IndexOptions options;
  options.threads = 1;
  std::shared_ptr<const GeodesicIndex> index;
  costs[build_seconds] = seconds_of([&] { index = GeodesicIndex::build(mesh, options); });
  costs[index_bytes] = static_cast<double>(index->statistics().bytes);
  test::IndexQuery query(index, 1);
  costs[field_seconds] = seconds_of([&] { query.distance_field(std::array{vertex(0)}); });
  costs[pairs_seconds] = seconds_of([&] {
    for (Index part = 1; part < 3; ++part) query.distance(vertex(0), vertex(part));
  });
  PathQuery paths(index);
  costs[paths_seconds] = seconds_of([&] {
    for (Index part = 1; part < 3; ++part)
      paths.exact_path(SurfacePoint::at_vertex(vertex(0)), SurfacePoint::at_vertex(vertex(part)));
  });
  return costs;
}

const Costs& scan_costs(std::size_t vertices) {
  static std::map<std::size_t, Costs> known;
  // A larger scan would only make the test slower.
  const std::size_t size = std::min<std::size_t>(std::bit_ceil(vertices), 4096);
  const auto [found, added] = known.try_emplace(size);
  if (added) {
    test::HostileRandom random(size);
    found->second =
        costs_of(test::hostile_base(test::HostileBase::scan, static_cast<int>(size + size / 8), random).soup);
  }
  return found->second;
}

/// A mesh of hostile_mesh().
struct Seed {
  unsigned seed;
  int size;
  const char* was;  ///< what it once took
  Costs most = most_of_a_scan;
};

void PrintTo(const Seed& seed, std::ostream* out) { *out << seed.seed << ", size " << seed.size; }

class CostContract : public testing::TestWithParam<Seed> {};

TEST_P(CostContract, AMeshTakesNoMoreThanSomeTimesWhatAScanTakes) {
  VOROGEO_HEAVY_TEST();
  const test::HostileMesh mesh = test::hostile_mesh(GetParam().seed, GetParam().size);
  SCOPED_TRACE(mesh.sentence() + "; once " + GetParam().was);
  const Costs costs = costs_of(mesh.soup);
  const Costs& scan = scan_costs(std::max(mesh.soup.positions.size(), mesh.soup.faces.size() / 2));
  for (int i = 0; i < cost_count; ++i) {
    const bool is_bytes = i == exact_bytes || i == index_bytes;
    const int of_scan = i >= field_seconds ? exact_seconds : i;
    EXPECT_LE(costs[i], GetParam().most[i] * scan[of_scan] + (is_bytes ? some_bytes : clock_seconds))
        << names[i];
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, CostContract,
                         testing::Values(Seed{1001220, 2500, "1,240 times the time of a build"},
                                         Seed{703856, 600, "999 times the time of a build"},
                                         Seed{1010053, 2500, "970 times the time of a build"},
                                         Seed{1003363, 600, "856 times the time of a build"},
                                         Seed{703485, 2500, "a build without end"},
                                         Seed{1012985, 2500, "863 times the time of pairs", most_of_fans},
                                         Seed{1004644, 2500, "184 times the time of pairs", most_of_fans},
                                         Seed{702153, 2500, "179 times the time of pairs"},
                                         Seed{1000924, 2500, "233 times the time of exact paths"},
                                         Seed{1010978, 2500, "213 times the time of exact paths"},
                                         Seed{1012106, 60, "14,587 times the memory of a field"},
                                         Seed{704674, 2500, "7,745 times the memory of a field",
                                              most_of_fans},
                                         Seed{1014910, 600, "6,448 times the memory of a field"},
                                         Seed{702020, 2500, "89 times the time of regions"},
                                         Seed{1009633, 2500, "303 times the memory of pairs"},
                                         Seed{704420, 600, "36 times the memory of a build"},
                                         Seed{4267833709, 2500, "134 times the memory of a build"},
                                         Seed{1207860130, 200, "16 times the memory of an exact field"},
                                         Seed{4230000918, 60, "a field without end"}),
                         [](const auto& seed) { return std::to_string(seed.param.seed); });

/// On these seeds, fields once erred by 31 % and pairs by .9 %, at single vertices.
TEST(IndexContract, FieldsOfAnIndexErrByAPercentAtMostOnSeedsThatErredByAThird) {
  VOROGEO_HEAVY_TEST();
  for (const auto& [seed, size] : {std::pair{1004843U, 2500}, std::pair{1004702U, 60}}) {
    const auto mesh = test::make_mesh(test::hostile_mesh(seed, size).soup);
    test::IndexQuery query(GeodesicIndex::build(mesh, {}), 1);
    // The same sources each time: errors of most sources stay below a percent, not those of all.
    for (const Index source : test::random_vertices(mesh->vertex_count(), 2, 1)) {
      const std::vector<double> exact = exact_distance_field(mesh, std::array{source});
      const std::vector<double> field = query.distance_field(std::array{source});
      const double rounding = 1e-12 * mesh->longest_edge_length();
      for (Index v = 0; v < mesh->vertex_count(); ++v) {
        if (exact[v] == unreachable) continue;
        ASSERT_NEAR(field[v], exact[v], 0.01 * exact[v] + rounding)
            << seed << ", source " << source << ", vertex " << v;
      }
    }
  }
}

/// On these seeds, distances once were up to 46 % too long, where a window narrower than rounding was merged,
/// and 16 % or 1.3 % too short, where a pseudo-source lies next to its edge.
TEST(QuickContract, FieldsErrByAPercentAtMostOnSeedsThatErredByAHalf) {
  for (const unsigned seed : {4240001518U, 4230000766U, 4220000814U, 4270003514U}) {
    const auto mesh = test::make_mesh(test::hostile_mesh(seed, 60).soup);
    Surface surface(mesh);
    for (Index source = 0; source < mesh->vertex_count(); ++source) {
      Answered answered;
      const std::vector<ExactSource> sources = sources_at(std::array{source});
      const std::vector<double> exact = exact_distance_field(mesh, std::array{source});
      const std::vector<double> quick = surface.field(sources, unreachable, Answer::quick, answered).distance;
      const double rounding = 1e-15 * mesh->longest_edge_length();
      for (Index v = 0; v < mesh->vertex_count(); ++v) {
        if (exact[v] == unreachable) continue;
        ASSERT_NEAR(quick[v], exact[v], 0.01 * exact[v] + rounding)
            << seed << ", source " << source << ", vertex " << v;
      }
    }
  }
}

/// Here fields of an index err by up to 20 %, each field differently, so that at 515 vertices the field of
/// each single site gives a longer distance than the field of all sites.
TEST(IndexContract, RegionsHoldEveryVertexThatASiteReaches) {
  const auto mesh = test::make_mesh(test::hostile_mesh(4200003631U, 60).soup);
  IndexOptions options;
  options.delta = 0.0;
  Surface surface(GeodesicIndex::build(mesh, options), 1);
  const std::array<Index, 2> sites{1118, 2016};
  const VoronoiRegions regions = voronoi_regions(surface, PointList(sites), {.by = Answer::index});
  const std::vector<double> exact = exact_distance_field(mesh, sites);
  for (Index v = 0; v < mesh->vertex_count(); ++v) {
    ASSERT_EQ(regions.distance[v] < unreachable, exact[v] < unreachable) << "vertex " << v;
    ASSERT_EQ(regions.vertex_region[v] != no_index, exact[v] < unreachable) << "vertex " << v;
  }
}

}  // namespace
}  // namespace vorogeo

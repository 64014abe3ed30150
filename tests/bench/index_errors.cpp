// What an index costs and how it errs, in processor time of one core: on meshes of every kind with defaults
// (any_mesh), and on one mesh in both forms with several sizes of patches and values of delta (trade_off).
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include "core_bench.h"
#include "exact/exact_solver.h"
#include "index/geodesic_index.h"
#include "query/surface.h"
#include "support/indexes.h"
#include "support/ply.h"
#include "support/shapes.h"

namespace bench {

namespace {

constexpr int targets_per_source = 200;
constexpr double needle_angle = std::numbers::pi / 180.0;
constexpr int patch_sizes[] = {90, 180, 350, 700};
constexpr double deltas[] = {vorogeo::test::lossless_delta, 0.001, 0.01, 0.05};
constexpr int patches_per_parent = 8;

/// A PLY file, or a part that the tests make.
vorogeo::test::Soup soup_of(const std::string& name) {
  using namespace vorogeo::test;
  if (name == "drilled_plate") return drilled_plate(14, 14, 0.6, 1);
  if (name == "thick_plate") return drilled_plate(14, 14, 3.0, 2);
  if (name == "drilled_block") return drilled_plate(10, 10, 6.0, 2);
  if (name == "gear") return gear(200, 24, 8.0);
  if (name == "small_plate") return drilled_plate(6, 6, 0.6, 1);
  if (name == "small_gear") return gear(40, 16, 8.0);
  if (name == "coarse_sphere") return random_sphere(1500, 2);
  if (name == "block_city") return block_city(20, 20, 1);
  return read_ply(name);
}

/// A question with its answer.
struct ExactField {
  Index source;
  std::vector<Index> targets;
  std::vector<double> distances;
  double seconds;
};

std::vector<ExactField> exact_fields(const MeshPointer& mesh, int count) {
  std::mt19937 random(1);
  std::vector<ExactField> fields(static_cast<std::size_t>(std::max(1, count)));
  for (ExactField& field : fields) {
    field.source = any_vertex(*mesh, random);
    field.seconds = cpu_seconds(
        [&] { field.distances = vorogeo::exact_distance_field(mesh, std::span(&field.source, 1)); });
    for (int i = 0; i < targets_per_source; ++i) field.targets.push_back(any_vertex(*mesh, random));
  }
  return fields;
}

/// What an index costs, and its answers to the same questions.
struct Measured {
  std::shared_ptr<const vorogeo::GeodesicIndex> index;
  double build, field = 0.0, pair = 0.0;  ///< seconds
  double bytes_per_vertex;
  vorogeo::test::ErrorCollector field_errors, pair_errors;
};

Measured measured(const MeshPointer& mesh, const std::vector<ExactField>& exact,
                  vorogeo::IndexOptions options) {
  options.threads = 1;
  Measured result{};
  result.build = cpu_seconds([&] { result.index = vorogeo::GeodesicIndex::build(mesh, options); });
  result.bytes_per_vertex = static_cast<double>(result.index->statistics().bytes) / mesh->vertex_count();
  vorogeo::test::IndexQuery query(result.index, 1);
  for (const ExactField& one : exact) {
    std::vector<double> found;
    result.field += cpu_seconds([&] { found = query.distance_field(std::span(&one.source, 1)); });
    for (Index v = 0; v < mesh->vertex_count(); ++v) result.field_errors.add(found[v], one.distances[v]);
    found.clear();
    result.pair += cpu_seconds([&] {
      for (Index target : one.targets) found.push_back(query.distance(one.source, target));
    });
    for (std::size_t i = 0; i < found.size(); ++i)
      result.pair_errors.add(found[i], one.distances[one.targets[i]]);
  }
  result.field /= static_cast<double>(exact.size());
  result.pair /= static_cast<double>(exact.size()) * targets_per_source;
  return result;
}

/// Quick fields of the same questions, and exact ones, both by a surface that has answered before.
struct Quick {
  double share = 0.0;  ///< of the time of an exact field
  vorogeo::test::ErrorCollector errors;
};

Quick quick(const MeshPointer& mesh, const std::vector<ExactField>& exact) {
  using vorogeo::Answer;
  Quick result;
  vorogeo::Surface surface(mesh, {.threads = 1});
  vorogeo::Query query(surface);
  std::vector<double> found;
  const auto seconds = [&](const ExactField& one, Answer by) {
    const std::vector<vorogeo::ExactSource> sources = vorogeo::sources_at(std::span(&one.source, 1));
    return cpu_seconds([&] { found = query.field(sources, vorogeo::unreachable, by, 1); });
  };
  seconds(exact.front(), Answer::exact);
  double exact_seconds = 0.0, quick_seconds = 0.0;
  for (const ExactField& one : exact) {
    exact_seconds += seconds(one, Answer::exact);
    quick_seconds += seconds(one, Answer::quick);
    for (Index v = 0; v < mesh->vertex_count(); ++v) result.errors.add(found[v], one.distances[v]);
  }
  result.share = quick_seconds / exact_seconds;
  return result;
}

double needle_share(const vorogeo::Mesh& mesh) {
  Index needles = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    double least = needle_angle;
    for (int i = 0; i < 3; ++i) least = std::min(least, mesh.corner_angle(3 * f + i));
    needles += least < needle_angle ? 1 : 0;
  }
  return static_cast<double>(needles) / std::max<Index>(1, mesh.face_count());
}

}  // namespace

void measure_any_mesh(Arguments arguments) {
  for (const char* name : arguments.subspan(1)) {
    const auto mesh = vorogeo::test::make_mesh(soup_of(name));
    const auto exact = exact_fields(mesh, std::atoi(arguments[0]));
    double exact_seconds = 0.0;
    for (const ExactField& one : exact) exact_seconds += one.seconds / static_cast<double>(exact.size());
    const Measured found = measured(mesh, exact, {});
    const Quick quickly = quick(mesh, exact);
    const auto fields = found.field_errors.statistics(), pairs = found.pair_errors.statistics(),
               quick_fields = quickly.errors.statistics();
    print_figures("mesh", std::filesystem::path(name).stem().string(),
                  {{"vertices", mesh->vertex_count()},
                   {"needles", 100.0 * needle_share(*mesh)},
                   {"exact", exact_seconds},
                   {"build", found.build},
                   {"field", found.field},
                   {"pair", found.pair},
                   {"build/exact", found.build / exact_seconds},
                   {"border", static_cast<double>(found.index->statistics().second_layer_border_vertices)},
                   {"bytes", found.bytes_per_vertex},
                   {"mean", 100.0 * fields.mean},
                   {"p99", 100.0 * fields.p99},
                   {"over", 100.0 * fields.greatest},
                   {"under", 100.0 * std::abs(fields.least)},
                   {"pair_mean", 100.0 * pairs.mean},
                   {"pair_p99", 100.0 * pairs.p99},
                   {"pair_over", 100.0 * pairs.greatest},
                   {"pair_under", 100.0 * std::abs(pairs.least)},
                   {"quick/exact", quickly.share},
                   {"quick_mean", 100.0 * quick_fields.mean},
                   {"quick_p99", 100.0 * quick_fields.p99},
                   {"quick_over", 100.0 * quick_fields.greatest},
                   {"quick_under", 100.0 * std::abs(quick_fields.least)}});
  }
}

void measure_trade_off(Arguments arguments) {
  const MeshPointer mesh = load(arguments[0]);
  const auto exact = exact_fields(mesh, std::atoi(arguments[1]));
  const auto measure = [&](int patch_size, double delta) {
    vorogeo::IndexOptions options;
    options.delta = delta;
    options.second_layer_patches = patches_per_parent;
    options.first_layer_patches =
        std::max<Index>(1, mesh->vertex_count() / (patch_size * patches_per_parent));
    const Measured found = measured(mesh, exact, options);
    print_figures("form", to_string(found.index->statistics().form),
                  {{"patch_size", patch_size},
                   {"delta", delta == vorogeo::test::lossless_delta ? 0.0 : delta},
                   {"build", found.build / mesh->vertex_count()},
                   {"bytes", found.bytes_per_vertex},
                   {"field", found.field},
                   {"pair", found.pair},
                   {"field_error", 100.0 * found.field_errors.statistics().mean},
                   {"pair_error", 100.0 * found.pair_errors.statistics().mean}});
  };
  for (int size : patch_sizes) {
    measure(size, 0.0);  // tables
    for (double delta : deltas) measure(size, delta);
  }
}

}  // namespace bench

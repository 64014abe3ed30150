// The trade-off between accuracy, memory, build and query: indexes of one mesh with four sizes of patches, as
// tables and as graphs with four values of delta. Prints lines of JSON, one per index. Times are of one core
// (processor time).
//
//   trade_off_bench MESH SOURCES
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <memory>
#include <random>
#include <span>
#include <vector>

#include "exact/exact_solver.h"
#include "index/geodesic_index.h"
#include "mesh_file.h"
#include "query/geodesic_query.h"

namespace {

using vorogeo::Index;

constexpr int patch_sizes[] = {90, 180, 350, 700};
constexpr double deltas[] = {0.0, 0.001, 0.01, 0.05};
constexpr int patches_per_parent = 8;
constexpr int targets_per_source = 200;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Exact {
  Index source;
  std::vector<double> field;
  std::vector<Index> targets;
};

void measure(const std::shared_ptr<const vorogeo::Mesh>& mesh, const std::vector<Exact>& exact,
             int patch_size, double delta, vorogeo::IndexForm form) {
  vorogeo::IndexOptions options;
  options.threads = 1;
  options.delta = delta;
  options.form = form;
  options.second_layer_patches = patches_per_parent;
  options.first_layer_patches = std::max<Index>(1, mesh->vertex_count() / (patch_size * patches_per_parent));
  double start = processor_seconds();
  const auto index = vorogeo::GeodesicIndex::build(mesh, options);
  const double build = processor_seconds() - start;
  vorogeo::GeodesicQuery query(index, 1);
  double field_error = 0.0;
  double pair_error = 0.0;
  std::size_t fields = 0;
  std::size_t pairs = 0;
  double field_time = 0.0;
  double pair_time = 0.0;
  for (const Exact& e : exact) {
    start = processor_seconds();
    const auto field = query.distance_field(std::span(&e.source, 1));
    field_time += processor_seconds() - start;
    for (Index v = 0; v < mesh->vertex_count(); ++v) {
      if (!(e.field[v] > 0.0 && e.field[v] < vorogeo::unreachable)) continue;
      field_error += std::abs(field[v] / e.field[v] - 1.0);
      ++fields;
    }
    std::vector<double> found;
    start = processor_seconds();
    for (Index target : e.targets) found.push_back(query.distance(e.source, target));
    pair_time += processor_seconds() - start;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double distance = e.field[e.targets[i]];
      if (!(distance > 0.0 && distance < vorogeo::unreachable)) continue;
      pair_error += std::abs(found[i] / distance - 1.0);
      ++pairs;
    }
  }
  const double runs = static_cast<double>(exact.size());
  std::printf(
      "{\"form\": \"%s\", \"patch_size\": %d, \"delta\": %g, \"build\": %.6g, \"bytes_per_vertex\": %.6g, "
      "\"field\": %.6g, \"pair\": %.6g, \"field_error\": %.6g, \"pair_error\": %.6g}\n",
      to_string(index->statistics().form), patch_size, delta, build,
      static_cast<double>(index->statistics().bytes) / mesh->vertex_count(), field_time / runs,
      pair_time / (runs * targets_per_source),
      field_error / static_cast<double>(std::max<std::size_t>(fields, 1)),
      pair_error / static_cast<double>(std::max<std::size_t>(pairs, 1)));
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 3) throw std::runtime_error("usage: trade_off_bench MESH SOURCES");
  bench::RawMesh raw = bench::read_mesh(arguments[1]);
  const auto mesh = std::make_shared<const vorogeo::Mesh>(std::move(raw.positions), raw.faces);
  std::mt19937 random(1);
  auto any_vertex = [&] {
    return static_cast<Index>(random() % static_cast<unsigned>(mesh->vertex_count()));
  };
  std::vector<Exact> exact(static_cast<std::size_t>(std::max(1, std::atoi(arguments[2]))));
  for (Exact& e : exact) {
    e.source = any_vertex();
    e.field = vorogeo::exact_distance_field(mesh, std::span(&e.source, 1));
    for (int i = 0; i < targets_per_source; ++i) e.targets.push_back(any_vertex());
  }
  for (int size : patch_sizes) {
    measure(mesh, exact, size, 0.0, vorogeo::IndexForm::tables);
    for (double delta : deltas) measure(mesh, exact, size, delta, vorogeo::IndexForm::graph);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "trade_off_bench: %s\n", error.what());
  return 1;
}

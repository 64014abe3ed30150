// What an index costs and how it errs on meshes of every kind: scans, CAD parts, needles, cities, high genus.
// One line of a table per mesh. Times are of one core (processor time); errors are in percent of the exact
// distance.
//
//   any_mesh_bench SOURCES MESH...     a MESH is a PLY file, or the name of a generated one (see `generated`)
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "exact/exact_solver.h"
#include "index/geodesic_index.h"
#include "query/geodesic_query.h"
#include "support/ply.h"
#include "support/shapes.h"

namespace {

using vorogeo::Index;

constexpr int pairs_per_source = 200;
constexpr double needle_angle = std::numbers::pi / 180.0;

/// Mean and largest error of fast DGG (epsilon 0.001), in percent, as measured for the same meshes.
struct PeerFigures {
  const char* mesh;
  double mean, largest;
};
constexpr PeerFigures fast_dgg[] = {
    {"abc3", 0.018, 0.16}, {"basket", 0.020, 0.14}, {"fsaverage5", 0.03, 0.2}, {"igea", 0.031, 0.27}};

struct Generated {
  const char* name;
  std::function<vorogeo::test::Soup()> make;
};
const Generated generated[] = {
    {"drilled_plate", [] { return vorogeo::test::drilled_plate(14, 14, 0.6, 1); }},
    {"thick_plate", [] { return vorogeo::test::drilled_plate(14, 14, 3.0, 2); }},
    {"drilled_block", [] { return vorogeo::test::drilled_plate(10, 10, 6.0, 2); }},
    {"gear", [] { return vorogeo::test::gear(200, 24, 8.0); }},
    {"small_plate", [] { return vorogeo::test::drilled_plate(6, 6, 0.6, 1); }},
    {"small_gear", [] { return vorogeo::test::gear(40, 16, 8.0); }},
    {"coarse_sphere", [] { return vorogeo::test::random_sphere(1500, 2); }},
    {"block_city", [] { return vorogeo::test::block_city(20, 20, 1); }},
};

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Relative errors, collected in percent.
class Errors {
 public:
  void add(double found, double exact) {
    if (!(exact > 0.0 && exact < vorogeo::unreachable)) return;
    const double error = 100.0 * (found / exact - 1.0);
    over_ = std::max(over_, error);
    under_ = std::min(under_, error);
    total_ += std::abs(error);
    size_.push_back(static_cast<float>(std::abs(error)));
  }
  double mean() const { return size_.empty() ? 0.0 : total_ / static_cast<double>(size_.size()); }
  double over() const { return over_; }
  double under() const { return under_; }
  /// Exceeded by one in a hundred.
  double p99() {
    if (size_.empty()) return 0.0;
    const auto at = size_.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(size_.size() - 1));
    std::nth_element(size_.begin(), at, size_.end());
    return *at;
  }

 private:
  std::vector<float> size_;
  double total_ = 0.0;
  double over_ = 0.0;
  double under_ = 0.0;
};

double needle_share(const vorogeo::Mesh& mesh) {
  Index needles = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    double least = needle_angle;
    for (int i = 0; i < 3; ++i) least = std::min(least, mesh.corner_angle(3 * f + i));
    needles += least < needle_angle ? 1 : 0;
  }
  return static_cast<double>(needles) / std::max<Index>(1, mesh.face_count());
}

vorogeo::test::Soup read(const std::string& name) {
  for (const Generated& one : generated) {
    if (name == one.name) return one.make();
  }
  return vorogeo::test::read_ply(name);
}

void measure(const std::string& name, int sources) {
  const auto soup = read(name);
  const auto mesh = std::make_shared<const vorogeo::Mesh>(soup.positions, soup.faces);
  vorogeo::IndexOptions options;
  options.threads = 1;
  double start = processor_seconds();
  const auto index = vorogeo::GeodesicIndex::build(mesh, options);
  const double build = processor_seconds() - start;
  vorogeo::GeodesicQuery query(index, 1);
  Errors fields;
  Errors pairs;
  double exact_time = 0.0;
  double field_time = 0.0;
  std::mt19937 random(1);
  auto any_vertex = [&] {
    return static_cast<Index>(random() % static_cast<unsigned>(mesh->vertex_count()));
  };
  for (int i = 0; i < sources; ++i) {
    const Index source = any_vertex();
    start = processor_seconds();
    const auto exact = vorogeo::exact_distance_field(mesh, std::span(&source, 1));
    exact_time += processor_seconds() - start;
    start = processor_seconds();
    const auto field = query.distance_field(std::span(&source, 1));
    field_time += processor_seconds() - start;
    for (Index v = 0; v < mesh->vertex_count(); ++v) fields.add(field[v], exact[v]);
    for (int k = 0; k < pairs_per_source; ++k) {
      const Index target = any_vertex();
      pairs.add(query.distance(source, target), exact[target]);
    }
  }
  const std::string stem = std::filesystem::path(name).stem().string();
  const auto& statistics = index->statistics();
  const double vertices = mesh->vertex_count();
  std::printf(
      "%-14s %7d %5.1f %6.3f %7.4f %8.2f %7.3f %6.0f %6d %6.0f | %.4f %.3f %+.2f %+.2f | %.4f %.3f %+.2f "
      "%+.2f |",
      stem.c_str(), mesh->vertex_count(), 100.0 * needle_share(*mesh), exact_time / sources,
      field_time / sources, build, 1000.0 * build / vertices, build * sources / exact_time,
      statistics.second_layer_border_vertices, static_cast<double>(statistics.bytes) / vertices,
      fields.mean(), fields.p99(), fields.over(), fields.under(), pairs.mean(), pairs.p99(), pairs.over(),
      pairs.under());
  for (const PeerFigures& peer : fast_dgg) {
    if (stem == peer.mesh) std::printf(" %.3f %.2f", peer.mean, peer.largest);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) try {
  if (count < 3) throw std::runtime_error("usage: any_mesh_bench SOURCES MESH...");
  std::printf(
      "mesh          vertices needle%% exact_s field_s build_s ms/vertex build/exact border bytes/vertex | "
      "field error %%: "
      "mean p99 over under | pair error %%: mean p99 over under | fast DGG %%: mean largest\n");
  for (int i = 2; i < count; ++i) measure(arguments[i], std::max(1, std::atoi(arguments[1])));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "any_mesh_bench: %s\n", error.what());
  return 1;
}

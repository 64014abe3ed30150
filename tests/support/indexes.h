// Small indexes for tests, and what is measured on them.
#pragma once

#include <filesystem>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "index/geodesic_index.h"
#include "index/index_data.h"
#include "query/surface.h"
#include "support/shapes.h"

namespace vorogeo::test {

/// An index of a soup with the given numbers of patches (0: automatic).
std::shared_ptr<const GeodesicIndex> make_index(const Soup& soup, Index first_layer_patches = 0,
                                                Index second_layer_patches = 0, double delta = 0.0,
                                                int threads = 0);

/// A delta that selects the form of a graph and prunes nothing: 1 + delta is 1.
inline constexpr double lossless_delta = 1e-300;

/// Questions to an index, whatever might answer sooner.
class IndexQuery {
 public:
  explicit IndexQuery(std::shared_ptr<const GeodesicIndex> index, int threads = 0)
      : surface_(std::move(index), threads), query_(surface_) {}
  double distance(Index source, Index target) {
    return query_.distance(SurfacePoint::at_vertex(source), SurfacePoint::at_vertex(target), Answer::index);
  }
  std::vector<double> field(std::span<const ExactSource> sources, double max_distance = unreachable,
                            std::vector<Index>* labels = nullptr) {
    return query_.field(sources, max_distance, Answer::index, surface_.threads(), labels);
  }
  std::vector<double> distance_field(std::span<const Index> sources, double max_distance = unreachable) {
    return field(sources_at(sources), max_distance);
  }
  std::vector<double> distances(std::span<const ExactSource> sources, const PointList& targets,
                                double max_distance = unreachable) {
    return query_.distances(sources, targets, max_distance, Answer::index);
  }

 private:
  Surface surface_;
  Query query_;
};

/// The sentence with which loading an index file is refused, or "loaded".
std::string loading(const std::filesystem::path& file, const std::shared_ptr<const Mesh>& mesh);

/// A terrain over plane_grid: smooth hills, so that shortest paths bend and distances have no formula.
Soup hills(int cells, double height);

/// The unit disc as a fan of needles round vertex 0; vertex 1 + i lies at the angle 2 pi i / needles.
Soup needle_disc(int needles);
/// Triangles of height 1 on one spine, from vertex 0 to 1; page i has vertex i + 2. Two of these are 2 apart.
Soup book_of_pages(int pages);

/// Relative errors of distances, over all pairs with a finite exact distance above 0.
struct ErrorStatistics {
  double mean = 0.0;      ///< of the absolute values
  double p99 = 0.0;       ///< 99 % of the absolute values are at most this
  double greatest = 0.0;  ///< overestimate, 0 if there is none
  double least = 0.0;     ///< underestimate as a negative number, 0 if there is none
  std::size_t count = 0;
};

/// Compares distances with exact ones. A point that only one of the two reaches is counted in
/// `contradictions`.
class ErrorCollector {
 public:
  void add(double actual, double exact);
  ErrorStatistics statistics() const;
  std::size_t contradictions = 0;

 private:
  std::vector<double> errors_;
};

/// A few random different numbers of [0, count), always the same for a seed.
std::vector<Index> random_vertices(Index count, int wanted, unsigned seed);

std::vector<Index> all_faces(const Mesh& mesh);

/// Patches of the faces at a vertex.
std::set<Index> patches_at(const Mesh& mesh, std::span<const Index> face_label, Index vertex);

/// Exact distances between places of an index.
class PlaceSolver {
 public:
  explicit PlaceSolver(const IndexData& data) : surface_(data.surface), solver_(data.geometry) {}
  void run_from(Index place) {
    const ExactSource source{surface_.surface_point(place)};
    solver_.run(std::span(&source, 1));
  }
  double distance(Index place) const {
    return surface_.at_place(place, [&](const auto& at) { return solver_.distance(at); });
  }

 private:
  const InnerSurface& surface_;
  LocalSolver solver_;
};

/// Distances between all nodes of a graph, by plain searches over its arcs.
std::vector<std::vector<double>> graph_distances(const TransitGraph& graph);

}  // namespace vorogeo::test

// Distance fields for many sources at a time: one query object per worker thread.
#pragma once

#include <memory>
#include <vector>

#include "index/geodesic_index.h"
#include "mesh/surface_point.h"
#include "support/types.h"

namespace vorogeo {

/// Fields from one and from several sources may differ by this factor, as the index errs slightly: a field
/// that is bounded by a distance from another field gets this much margin.
inline constexpr double bounded_field_slack = 1.02;

/// Computes fields and distances for the workers of a parallel_for. Tasks made of many fields (matrices,
/// Voronoi regions, samplings) are written against it, so that they run on an index or on exact propagation.
class FieldTeam {
 public:
  /// Answers from an index. `threads`: workers; 0 is one per core.
  explicit FieldTeam(std::shared_ptr<const GeodesicIndex> index, int threads = 0);
  /// Answers by exact propagation on the mesh: slower, but without errors and without an index.
  explicit FieldTeam(std::shared_ptr<const Mesh> mesh, int threads = 0);
  ~FieldTeam();
  FieldTeam(FieldTeam&&) noexcept;
  FieldTeam& operator=(FieldTeam&&) noexcept;

  const Mesh& mesh() const;
  int threads() const;
  bool is_exact() const;

  /// Distances from one point to all vertices, `unreachable` above max_distance. Shape (n). On one thread;
  /// `worker` is in [0, threads()) and runs one call at a time. Points are on the mesh.
  std::vector<double> field(const SurfacePoint& source, double max_distance, int worker);
  std::vector<double> field(Index source, double max_distance, int worker);
  /// Distances from one point to others: the values of its field there. In a face they are interpolated from
  /// the corners, but exact where the source is near (GeodesicQuery::distances) or the team is exact.
  std::vector<double> distances(const SurfacePoint& source, const PointList& targets, double max_distance,
                                int worker);
  /// A field from the nearest of several sources, on all threads; only one such call at a time.
  std::vector<double> field_on_all_threads(const PointList& sources, double max_distance = unreachable);
  /// Distance of two points, symmetric: GeodesicQuery::distance for two vertices, otherwise the length of the
  /// refined path (PathQuery::path). \throw InvalidInput without an index.
  double distance(const SurfacePoint& source, const SurfacePoint& target, int worker);
  /// An order of points in which a matrix of pairs is filled faster, row by row: neighbours in one patch are
  /// consecutive and read the same tables.
  std::vector<std::size_t> order_of_points(const PointList& points) const;
  /// An order in which pairs of vertices are answered faster than in a random one: pairs between the same
  /// patches read the same tables, and pairs with a common end share its access distances. Empty if any order
  /// is as good: for points in faces, and in an exact team.
  std::vector<std::size_t> order_of_pairs(const PointList& sources, const PointList& targets) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace vorogeo

// Distance fields for many sources at a time: one query object per worker thread.
#pragma once

#include <memory>
#include <vector>

#include "index/geodesic_index.h"
#include "query/point_list.h"
#include "support/types.h"

namespace vorogeo {

/// Gives fields and distances to the workers of a parallel_for. What is built on many fields (matrices,
/// Voronoi regions, samplings) asks it and so runs on an index or on exact propagation alike.
class FieldTeam {
 public:
  /// Answers from an index. `threads`: workers; 0 is one per core.
  explicit FieldTeam(std::shared_ptr<const GeodesicIndex> index, int threads = 0);
  /// Answers by exact propagation on the mesh: slower, without an index and its errors.
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
  /// Distances from one point to others: what a field gives at them. Points in faces get theirs from those of
  /// the corners, or exactly where the source is near (SourceField) or the team exact.
  std::vector<double> distances(const SurfacePoint& source, const PointList& targets, double max_distance,
                                int worker);
  /// A field from the nearest of several sources, on all threads; only one such call at a time.
  std::vector<double> field_on_all_threads(const PointList& sources, double max_distance = unreachable);
  /// Distance of two points, symmetric: of two vertices GeodesicQuery::distance, otherwise the length of the
  /// refined path (PathQuery::path). \throw InvalidInput without an index.
  double distance(const SurfacePoint& source, const SurfacePoint& target, int worker);
  /// An order of points in which a matrix of pairs is filled faster, row by row: neighbours follow one
  /// another.
  std::vector<std::size_t> order_of_points(const PointList& points) const;
  /// An order in which pairs of vertices are answered faster than in a random one: pairs between the same
  /// patches read the same tables, and pairs with an end in common share its side. Empty for points in faces:
  /// any.
  std::vector<std::size_t> order_of_pairs(const PointList& sources, const PointList& targets) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace vorogeo

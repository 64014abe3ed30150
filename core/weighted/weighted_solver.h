// Distances and paths in metrics that jump at edges, from points on the edges.
#pragma once

#include <memory>
#include <queue>
#include <span>
#include <vector>

#include "exact/surface_path.h"
#include "support/progress.h"
#include "weighted/face_norms.h"

namespace vorogeo {

/// The weighted region problem on a surface: shortest paths refract at edges and run along cheap ones.
///
/// Points on edges (Lanthier, Maheshwari, Sack 2001; Aleksandrov, Maheshwari, Sack 2005) are settled in order
/// of distance. A face is crossed from the points of a side or from between two of them: the distances of
/// both place a source in the plane of the face. With p points on an edge, the error of a crossing is of the
/// order of 1 / p^2. One object belongs to one thread.
class WeightedSolver {
 public:
  explicit WeightedSolver(std::shared_ptr<const FaceNorms> norms);

  /// From the nearest of some points. \throw InvalidInput for a bad point; Cancelled.
  void run(std::span<const SurfacePoint> sources, double max_distance = unreachable,
           const Progress& progress = {});

  /// Distance of a vertex, or of any point of the surface; `unreachable` where there is no path or only one
  /// longer than the limit.
  double distance(Index vertex) const;
  double distance(const SurfacePoint& point) const;

  /// A shortest path from a point back to its nearest source, target first. Its edges are found by going back
  /// through the distances; then its crossings are moved to where its length is least, by Snell's law. Empty
  /// if unreachable.
  SurfacePath path_to_source(const SurfacePoint& target) const;

 private:
  /// Where the last piece of a path to a point of a face comes from.
  struct BackStep {
    double distance = unreachable;        ///< of the point
    double begin_distance = unreachable;  ///< of where the piece begins
    Index source = no_index;              ///< the piece begins at a source in the face, or
    Index edge = no_index;                ///< on an edge,
    double fraction = 0.0;                ///< here, from the edge's first vertex;
    Index face = no_index;                ///< it crosses this face; no_index: it runs along the edge
  };

  void start_at(const SurfacePoint& source);
  void reach(Index point, double distance);
  bool is_beyond_limit(Index point) const;
  void settle(Index point);
  void cross_from(Index halfedge, Index first, Index second);
  BackStep step_into(Index face, const std::array<double, 3>& weights, double below) const;
  BackStep step_along(Index edge, double fraction, double below) const;
  /// `below`: the distance of where the piece begins is less.
  BackStep best_step(const SurfacePoint& point, double below) const;

  std::shared_ptr<const FaceNorms> norms_;
  const Mesh& mesh_;
  std::vector<double> distance_;
  std::vector<Index> touched_;
  std::vector<SurfacePoint> sources_;
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  double max_distance_ = unreachable;
};

}  // namespace vorogeo

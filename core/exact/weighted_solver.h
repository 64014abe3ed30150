// Propagation from point to point of edges, where the metric jumps at edges.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "exact/crossing_path.h"
#include "exact/exact_solver.h"
#include "exact/refraction.h"
#include "support/distance_queue.h"

namespace vorogeo {

/// The weighted region problem on a surface: shortest paths refract at edges and run along cheap ones.
///
/// Points on edges (Lanthier, Maheshwari, Sack 2001; Aleksandrov, Maheshwari, Sack 2005) are settled in order
/// of distance, and again where a shorter path is found late. Each knows the wave that reached it: its
/// direction and its curvature, like those of a source in the plane. So a face is crossed from all of a side,
/// not only from its points, and distances between two points have an error of third order in their spacing.
/// Its functions are those of ExactSolver, for any metric. One object belongs to one thread.
class WeightedSolver {
 public:
  explicit WeightedSolver(std::shared_ptr<const FaceNorms> norms);

  const Mesh& mesh() const { return norms_->mesh(); }

  /// See ExactSolver::run. Landmarks are not used, as distances from them are not exact; windows are neither
  /// merged nor dropped, as there are none. \throw InvalidInput for a bad source; Cancelled.
  void run(std::span<const ExactSource> sources, const ExactLimits& limits = {});
  /// The same from vertices.
  void run_from_vertices(std::span<const Index> source_vertices, const ExactLimits& limits = {}) {
    run(sources_at(source_vertices), limits);
  }

  /// Distance of a vertex, of any point of the surface, or of a point of an edge; `unreachable` where there
  /// is no path or only one longer than the limit.
  double distance(Index vertex) const;
  double distance(const SurfacePoint& point) const;
  double distance(const EdgePoint& point) const;
  /// Which source (index into the list given to run) a vertex belongs to; no_index if unreachable.
  Index nearest_source(Index vertex) const;
  /// The same for a point of an edge.
  Index nearest_source(const EdgePoint& point) const;

  /// The expected relative error, in the mean over the vertices that the last run has reached: what the waves
  /// of neighbouring points disagree on is of the order of the error of a crossing between them, and adds up
  /// along each path.
  double expected_error();

  /// A shortest path from a point back to its nearest source, target first. Its edges are those by which the
  /// waves came; its crossings are moved to where its length is least, by Snell's law. Empty if unreachable.
  SurfacePath path_to_source(const SurfacePoint& target) const;

  /// Distances up to this one are final.
  double settled_distance() const;
  /// Least distance at which a path met a face that it may not enter; with a corridor, a lower bound of the
  /// length of a path to its target by way of such a face.
  double barrier_distance() const { return barrier_distance_; }

 private:
  /// How a point is reached.
  struct Arrival {
    double distance = unreachable;
    Index source = no_index;
    Index from = no_index;  ///< the point whose wave arrives; no_index: the source's own
    Index face = no_index;  ///< the face crossed last; no_index: along its edge
    double slope = 0.0;     ///< see EdgeWave
    double radius = 0.0;
    bool bends = false;  ///< runs along a side of the face before or after it
  };
  struct PointState {
    double distance = unreachable;
    double slope = 0.0;
    double radius = 0.0;
    float error = -1.0f;  ///< expected relative error of the waves from it; below 0: not known
    Index from = no_index;
    Index face = no_index;
    Index source = no_index;
    bool bends = false;
    std::uint8_t settled = 0;  ///< how often
  };
  /// Where the last piece of a path to a point of a face comes from.
  struct BackStep {
    double distance = unreachable;  ///< of the point
    Index source = no_index;        ///< the piece begins at a source in the face, or
    Index edge = no_index;          ///< on an edge,
    double fraction = 0.0;          ///< here, from the edge's first vertex;
    Index face = no_index;          ///< it crosses this face; no_index: it runs along the edge
    Index from = no_index;          ///< the point whose wave it is
    Index flat_face = no_index;     ///< of no width, if that point is its apex, in the same place of the edge
  };

  void reset(std::span<const ExactSource> sources, const ExactLimits& limits);
  void start_at(Index source);
  bool came_by(Index point, Index other) const;
  void reach(Index point, const Arrival& arrival);
  // Metrics with drifts have loops of their own, so that they cost the others nothing.
  template <bool one_way>
  EdgeWave wave_at(Index edge, Index k) const;
  template <bool one_way>
  WaveParts parts_of(Index edge, Index first) const;
  template <bool one_way>
  FaceBeam beam_from(Index edge, const EdgeFrame& frame, double dearer, Index k, Index other, double low,
                     double high) const;
  bool is_final(const ExactLimits& limits, double bound);
  double least_rest_at(Index vertex) const;
  double least_rest(Index point) const;
  bool is_beyond_limit(Index point) const;
  bool may_enter(Index face, double distance);
  template <bool one_way>
  void settle(Index point);
  template <bool one_way>
  void settle_vertex(Index vertex);
  template <bool one_way>
  void run_along(Index edge, Index from, Index to);
  template <bool one_way>
  void cross_from_vertex(Index corner);
  template <bool one_way>
  void cross_from(Index edge, Index from);
  template <bool one_way>
  void cross(Index halfedge, Index from);
  void cross_thin(Index halfedge, Index from);
  bool passes(Index point, Index face) const;
  BackStep step_into(Index face, const std::array<double, 3>& weights, double below) const;
  BackStep step_along(Index edge, double fraction, double below) const;
  /// `below`: only the waves of points with a smaller distance than this are considered.
  BackStep best_step(const SurfacePoint& point, double below = unreachable) const;
  Index go_back(Index point, CrossingPath& path) const;
  Index follow(const BackStep& step, CrossingPath& path) const;
  double estimate_at(const PathJoint& here, Index point) const;
  double disagreement_at(Index point) const;
  void go_back_bent(Index point, CrossingPath& path) const;
  PathJoint joint_at(Index point) const;
  double within_limit(double distance) const { return distance <= max_distance_ ? distance : unreachable; }

  std::shared_ptr<const FaceNorms> norms_;
  std::vector<PointState> state_;
  std::vector<Index> touched_;
  std::vector<ExactSource> sources_;
  std::vector<Index> face_sources_;  ///< numbers of the sources that are no vertices
  DistanceQueue queue_;              ///< of points to be settled

  // Limits of the last run.
  double max_distance_ = unreachable;
  std::span<const std::uint8_t> face_allowed_;
  std::span<const double> least_remaining_;
  bool has_corridor_ = false;
  Point corridor_at_{};
  SurfacePoint corridor_point_;             ///< its target
  double corridor_distance_ = unreachable;  ///< of the target, when all targets were final
  std::size_t final_targets_ = 0;
  std::size_t final_edge_targets_ = 0;
  double settled_distance_ = unreachable;
  double barrier_distance_ = unreachable;
  double rest_ = 0.0;  ///< lower bound of the rest of a path from the point being settled
};

}  // namespace vorogeo

// One solver for any metric, and how long its fields take.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "exact/exact_geometry.h"
#include "exact/exact_solver.h"
#include "exact/ridge.h"
#include "exact/weighted_solver.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Distances and paths by propagation over a surface, whatever its metric

/// What all solvers of a surface share: the faces unfolded beside their edges, by the lengths of these or
/// each in a norm of its own.
struct LocalGeometry {
  /// \throw InvalidInput for lengths outside `exact_lengths`.
  explicit LocalGeometry(std::shared_ptr<const Mesh> mesh);

  std::size_t memory_bytes() const;

  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const ExactGeometry> windows;  ///< null if the metric jumps in all components
  std::shared_ptr<const FaceNorms> norms;        ///< null if it jumps in none
};

/// The solver for the metric of a surface: windows, which are exact, or points on edges in components where
/// the metric jumps. Tables, near fields, near pairs and exact paths use it, so that they need not know
/// which. One object belongs to one thread.
class LocalSolver {
 public:
  explicit LocalSolver(const std::shared_ptr<const LocalGeometry>& geometry);

  // See ExactSolver.
  const Mesh& mesh() const { return windows_ ? windows_->mesh() : points_->mesh(); }
  void run(std::span<const ExactSource> sources, const ExactLimits& limits = {});
  void run_from_vertices(std::span<const Index> source_vertices, const ExactLimits& limits = {}) {
    run(sources_at(source_vertices), limits);
  }
  double distance(Index vertex) const {
    return at(vertex, [&](const auto& s) { return s.distance(vertex); });
  }
  double distance(const SurfacePoint& point) const {
    return at(vertex_near(point), [&](const auto& s) { return s.distance(point); });
  }
  double distance(const EdgePoint& point) const {
    return at(vertex_near(point), [&](const auto& s) { return s.distance(point); });
  }
  Index nearest_source(Index vertex) const {
    return at(vertex, [&](const auto& s) { return given_number(s, s.nearest_source(vertex)); });
  }
  Index nearest_source(const EdgePoint& point) const {
    return at(vertex_near(point), [&](const auto& s) { return given_number(s, s.nearest_source(point)); });
  }
  /// \pre The metric does not jump around the source.
  double first_leg(Index vertex) const { return windows_->first_leg(vertex); }
  double first_leg(const SurfacePoint& point) const { return windows_->first_leg(point); }
  double last_leg(const TangentFrame& frame) const { return windows_->last_leg(frame); }
  SurfacePath last_leg_of(Index vertex) const {
    return windows_->path_to_source(SurfacePoint::at_vertex(vertex), true);
  }
  /// \pre The metric jumps nowhere.
  Ridge ridge() const { return windows_->ridge(); }
  SurfacePath path_to_source(const SurfacePoint& target) const {
    return at(vertex_near(target), [&](const auto& s) { return s.path_to_source(target); });
  }
  /// See WeightedSolver; 0 where the metric jumps nowhere.
  double expected_error() { return points_ ? points_->expected_error() : 0.0; }
  double settled_distance() const {
    return least([](const auto& s) { return s.settled_distance(); });
  }
  double barrier_distance() const {
    return least([](const auto& s) { return s.barrier_distance(); });
  }

 private:
  bool has_both() const { return windows_ && points_; }
  Index vertex_near(const SurfacePoint& point) const;
  Index vertex_near(const EdgePoint& point) const { return mesh().edge_vertices(point.edge)[0]; }
  /// Calls with the solver of the component of a vertex.
  template <class Call>
  std::invoke_result_t<const Call&, const ExactSolver&> at(Index vertex, const Call& call) const {
    if (!points_) return call(*windows_);
    const bool by_points = !windows_ || mesh().metric_jumps_in(mesh().component(vertex));
    return by_points ? call(*points_) : call(*windows_);
  }
  template <class Call>
  double least(const Call& call) const {
    return std::min(windows_ ? call(*windows_) : unreachable, points_ ? call(*points_) : unreachable);
  }
  Index given_number(const ExactSolver&, Index source) const { return given_number(by_windows_, source); }
  Index given_number(const WeightedSolver&, Index source) const { return given_number(by_points_, source); }
  Index given_number(const std::vector<Index>& numbers, Index source) const {
    return has_both() && source != no_index ? numbers[source] : source;
  }

  // At least one of them; both on a surface where the metric jumps in some components only.
  std::optional<ExactSolver> windows_;
  std::optional<WeightedSolver> points_;
  // With both: which of the sources given to the last run each solver has.
  std::vector<Index> by_windows_;
  std::vector<Index> by_points_;
};

// ---- How long an exact field of a mesh takes, without waiting for all of it

/// A run from one vertex that was stopped after some time.
struct FieldTiming {
  double seconds = 0.0;     ///< processor time that it took
  double reached = 0.0;     ///< part of the component's vertices that it reached
  bool is_complete = true;  ///< nothing was left to do

  /// Seconds of the whole field: windows grow in number with the distance, so the part that was reached takes
  /// less than its share.
  double expected_seconds() const;
};

/// Runs in the largest component for at most about `max_seconds` of the processor. \throw Cancelled if the
/// progress asks for it.
FieldTiming time_exact_field(const std::shared_ptr<const LocalGeometry>& geometry, double max_seconds,
                             const Progress& progress, const char* activity);

}  // namespace vorogeo

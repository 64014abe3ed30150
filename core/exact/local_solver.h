// One solver for any metric, and how long its fields take.
#pragma once

#include <memory>
#include <span>
#include <variant>

#include "exact/exact_geometry.h"
#include "exact/exact_solver.h"
#include "exact/weighted_solver.h"
#include "support/progress.h"

namespace vorogeo {

// ---- Distances and paths by propagation over a surface, whatever its metric

/// What all solvers of a surface share: the faces beside their edges, by lengths or each in a norm of its
/// own.
struct LocalGeometry {
  /// \throw InvalidInput for lengths outside `exact_lengths`.
  explicit LocalGeometry(std::shared_ptr<const Mesh> mesh);

  std::size_t memory_bytes() const;

  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const ExactGeometry> windows;  ///< null in a metric that jumps at edges
  std::shared_ptr<const FaceNorms> norms;        ///< null in any other
};

/// The solver for the metric of a surface: windows, which are exact, or points on edges where the metric
/// jumps. What tables, near fields, near pairs and exact paths use, so that these need not know which. One
/// object belongs to one thread.
class LocalSolver {
 public:
  explicit LocalSolver(const std::shared_ptr<const LocalGeometry>& geometry);

  // See ExactSolver.
  const Mesh& mesh() const {
    return std::visit([](const auto& s) -> const Mesh& { return s.mesh(); }, solver_);
  }
  void run(std::span<const ExactSource> sources, const ExactLimits& limits = {}) {
    std::visit([&](auto& s) { s.run(sources, limits); }, solver_);
  }
  void run_from_vertices(std::span<const Index> source_vertices, const ExactLimits& limits = {}) {
    run(sources_at(source_vertices), limits);
  }
  double distance(Index vertex) const {
    return std::visit([&](const auto& s) { return s.distance(vertex); }, solver_);
  }
  double distance(const SurfacePoint& point) const {
    return std::visit([&](const auto& s) { return s.distance(point); }, solver_);
  }
  double distance(const EdgePoint& point) const {
    return std::visit([&](const auto& s) { return s.distance(point); }, solver_);
  }
  Index nearest_source(Index vertex) const {
    return std::visit([&](const auto& s) { return s.nearest_source(vertex); }, solver_);
  }
  Index nearest_source(const EdgePoint& point) const {
    return std::visit([&](const auto& s) { return s.nearest_source(point); }, solver_);
  }
  SurfacePath path_to_source(const SurfacePoint& target) const {
    return std::visit([&](const auto& s) { return s.path_to_source(target); }, solver_);
  }
  double settled_distance() const {
    return std::visit([](const auto& s) { return s.settled_distance(); }, solver_);
  }
  double barrier_distance() const {
    return std::visit([](const auto& s) { return s.barrier_distance(); }, solver_);
  }

 private:
  std::variant<ExactSolver, WeightedSolver> solver_;
};

// ---- How long an exact field of a mesh takes, without waiting for all of it

/// A run from one vertex that was stopped after some time.
struct FieldTiming {
  double seconds = 0.0;     ///< of the processor that it took
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

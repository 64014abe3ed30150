// One solver for any metric, and how long its fields take.
#include "exact/local_solver.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/outliers.h"
#include "support/parallel.h"

namespace vorogeo {

// ---- The choice of the solver

namespace {

std::variant<ExactSolver, WeightedSolver> solver_of(const LocalGeometry& geometry) {
  if (geometry.windows) return ExactSolver(geometry.windows);
  return WeightedSolver(geometry.norms);
}

}  // namespace

LocalGeometry::LocalGeometry(std::shared_ptr<const Mesh> shared_mesh) : mesh(std::move(shared_mesh)) {
  if (mesh->metric_jumps()) {
    norms = std::make_shared<const FaceNorms>(mesh, mesh->points_per_edge());
    return;
  }
  windows = std::make_shared<const ExactGeometry>(mesh);
}

std::size_t LocalGeometry::memory_bytes() const {
  return windows ? windows->memory_bytes() : norms->memory_bytes();
}

LocalSolver::LocalSolver(const std::shared_ptr<const LocalGeometry>& geometry)
    : solver_(solver_of(*geometry)) {}

// ---- A run that its progress stops

namespace {

/// Measured on scans: the time of a field grows with this power of the vertices reached.
constexpr double field_growth = 1.25;

}  // namespace

double FieldTiming::expected_seconds() const {
  return is_complete || reached <= 0.0 ? seconds : seconds * std::pow(1.0 / reached, field_growth);
}

FieldTiming time_exact_field(const std::shared_ptr<const LocalGeometry>& geometry, double max_seconds,
                             const Progress& progress, const char* activity) {
  const Mesh& mesh = *geometry->mesh;
  const LargestComponent largest = largest_component(mesh);
  const double share = static_cast<double>(largest.vertices) / mesh.vertex_count();
  const double begin = thread_seconds();
  auto elapsed = [&] { return thread_seconds() - begin; };
  FieldTiming timing;
  const Progress until([&](double reached, const std::string&) {
    progress.report(reached, activity);
    timing.reached = std::min(1.0, reached / share);
    timing.is_complete = elapsed() <= max_seconds;
    return timing.is_complete;
  });
  LocalSolver exact(geometry);
  ExactLimits limits;
  limits.distances_only = true;
  limits.progress = &until;
  try {
    exact.run_from_vertices(std::array{largest.first_vertex}, limits);
  } catch (const Cancelled&) {
    if (timing.is_complete) throw;
  }
  timing.seconds = elapsed();
  return timing;
}

}  // namespace vorogeo

// One solver for any metric, and how long its fields take.
#include "exact/local_solver.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/outliers.h"
#include "support/parallel.h"

namespace vorogeo {

// ---- The choice of the solver

LocalGeometry::LocalGeometry(std::shared_ptr<const Mesh> shared_mesh) : mesh(std::move(shared_mesh)) {
  if (mesh->metric_jumps()) norms = std::make_shared<const FaceNorms>(mesh, mesh->points_per_edge());
  if (mesh->metric_agrees_somewhere()) windows = std::make_shared<const ExactGeometry>(mesh);
}

std::size_t LocalGeometry::memory_bytes() const {
  return (windows ? windows->memory_bytes() : 0) + (norms ? norms->memory_bytes() : 0);
}

LocalSolver::LocalSolver(const std::shared_ptr<const LocalGeometry>& geometry) {
  if (geometry->windows) windows_.emplace(geometry->windows);
  if (geometry->norms) points_.emplace(geometry->norms);
}

Index LocalSolver::vertex_near(const SurfacePoint& point) const {
  return point.is_vertex() ? point.vertex : mesh().face_vertices(point.face)[0];
}

void LocalSolver::run(std::span<const ExactSource> sources, const ExactLimits& limits) {
  if (!points_) return windows_->run(sources, limits);
  if (!windows_) return points_->run(sources, limits);
  // Paths stay in their component: each solver has the sources and targets of its own.
  const std::vector<ExactSource> checked = validated(mesh(), sources);
  for (const Index target : limits.targets) validated(mesh(), SurfacePoint::at_vertex(target));
  auto run_in = [&](auto& solver, std::vector<Index>& numbers, bool jumps) {
    auto is_own = [&](Index vertex) { return mesh().metric_jumps_in(mesh().component(vertex)) == jumps; };
    numbers.clear();
    std::vector<ExactSource> own;
    for (std::size_t i = 0; i < checked.size(); ++i) {
      if (!is_own(vertex_near(checked[i].point))) continue;
      numbers.push_back(static_cast<Index>(i));
      own.push_back(checked[i]);
    }
    std::vector<Index> targets;
    std::vector<EdgePoint> edge_targets;
    std::ranges::copy_if(limits.targets, std::back_inserter(targets), is_own);
    std::ranges::copy_if(limits.edge_targets, std::back_inserter(edge_targets),
                         [&](const EdgePoint& point) { return is_own(vertex_near(point)); });
    ExactLimits within = limits;
    within.targets = targets;
    within.edge_targets = edge_targets;
    const bool is_wanted = targets.size() + edge_targets.size() > 0 || limits.targets.empty();
    solver.run(is_wanted ? own : std::vector<ExactSource>{}, within);
  };
  run_in(*windows_, by_windows_, false);
  run_in(*points_, by_points_, true);
}

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

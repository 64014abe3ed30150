// A run that its progress stops.
#include "weighted/field_timing.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/components.h"
#include "support/thread_clock.h"
#include "weighted/local_solver.h"

namespace vorogeo {

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

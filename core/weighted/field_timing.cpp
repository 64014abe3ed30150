// A run that its progress stops.
#include "weighted/field_timing.h"

#include <cmath>
#include <span>
#include <vector>

#include "support/thread_clock.h"
#include "weighted/local_solver.h"

namespace vorogeo {

namespace {

/// Measured on scans: the time of a field grows with this power of the vertices reached.
constexpr double field_growth = 1.25;

Index vertex_of_largest_component(const Mesh& mesh) {
  std::vector<Index> vertices(mesh.component_count(), 0);
  Index largest = 0;
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (++vertices[mesh.component(v)] > vertices[mesh.component(largest)]) largest = v;
  }
  return largest;
}

}  // namespace

double FieldTiming::expected_seconds() const {
  return is_complete || reached <= 0.0 ? seconds : seconds * std::pow(1.0 / reached, field_growth);
}

FieldTiming time_exact_field(const std::shared_ptr<const LocalGeometry>& geometry, double max_seconds,
                             const Progress& progress, const char* activity) {
  const double begin = thread_seconds();
  auto elapsed = [&] { return thread_seconds() - begin; };
  FieldTiming timing;
  const Progress until([&](double reached, const std::string&) {
    progress.report(reached, activity);
    timing.reached = reached;
    timing.is_complete = elapsed() <= max_seconds;
    return timing.is_complete;
  });
  const Index source = vertex_of_largest_component(*geometry->mesh);
  LocalSolver exact(geometry);
  ExactLimits limits;
  limits.distances_only = true;
  limits.progress = &until;
  try {
    exact.run_from_vertices(std::span(&source, 1), limits);
  } catch (const Cancelled&) {
    if (timing.is_complete) throw;
  }
  timing.seconds = elapsed();
  return timing;
}

}  // namespace vorogeo

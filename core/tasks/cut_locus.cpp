// The points that several shortest paths reach, as lines over the surface.
#include "tasks/cut_locus.h"

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

namespace vorogeo {

namespace {

/// The lines pruned from their ends up to where their angle is at least this: what was connected stays so.
Ridge with_angle(const Ridge& all, double min_angle) {
  if (min_angle == 0.0) return all;
  const std::size_t count = all.points.size();
  std::vector<std::vector<Index>> edges_of(count);
  for (Index e = 0; e < static_cast<Index>(all.edges.size()); ++e) {
    for (const Index point : all.edges[e]) edges_of[point].push_back(e);
  }
  std::vector<std::size_t> degree(count);
  std::vector<bool> is_gone(all.edges.size(), false);
  std::vector<Index> ends;
  const auto look_at = [&](Index point) {
    if (degree[point] == 1) ends.push_back(point);
  };
  for (std::size_t p = 0; p < count; ++p) {
    degree[p] = edges_of[p].size();
    look_at(static_cast<Index>(p));
  }
  while (!ends.empty()) {
    const Index end = ends.back();
    ends.pop_back();
    for (const Index e : edges_of[end]) {
      const auto& [a, b] = all.edges[e];
      if (is_gone[e] || std::min(all.angle[a], all.angle[b]) >= min_angle) continue;
      is_gone[e] = true;
      --degree[end];
      const Index next = a == end ? b : a;
      --degree[next];
      look_at(next);
    }
  }
  return without_edges(all, is_gone);
}

}  // namespace

Ridge cut_locus(Surface& surface, const PointList& sources, double min_angle, double max_distance,
                const TaskOptions& options) {
  require_limit(max_distance);
  require_exact(options, "Cut loci are");
  const Mesh& mesh = *surface.mesh();
  require_agreeing_faces(mesh, "Cut loci");
  if (!(min_angle >= 0.0 && min_angle <= std::numbers::pi)) {
    throw InvalidInput("The least angle is " + std::to_string(min_angle) + "; give one from 0 to pi.");
  }
  if (sources.empty()) throw InvalidInput("There is no source: give at least one.");
  std::vector<ExactSource> from;
  for (const SurfacePoint& source : points_on(mesh, sources, "Source")) from.push_back({source});
  const Stopwatch watch;
  const Ridge found =
      surface.lend([&](Query& query) { return query.ridge(from, max_distance, options.progress); });
  report_exact(options, watch);
  if (options.answered != nullptr) options.answered->unreached = count_unreached(mesh, from, {});
  return with_angle(found, min_angle);
}

}  // namespace vorogeo

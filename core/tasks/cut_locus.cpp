// The points that several shortest paths reach, as lines over the surface.
#include "tasks/cut_locus.h"

#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace vorogeo {

namespace {

/// The edges whose points have at least this angle, with these points.
Ridge with_angle(const Ridge& all, double min_angle) {
  Ridge kept;
  std::vector<Index> number(all.points.size(), no_index);
  const auto keep = [&](Index point) {
    if (number[point] == no_index) {
      number[point] = static_cast<Index>(kept.points.size());
      kept.points.push_back(all.points[point]);
      kept.distance.push_back(all.distance[point]);
      kept.angle.push_back(all.angle[point]);
    }
    return number[point];
  };
  for (const auto& [a, b] : all.edges) {
    if (!(all.angle[a] >= min_angle && all.angle[b] >= min_angle)) continue;
    const Index first = keep(a);
    kept.edges.push_back({first, keep(b)});
  }
  return kept;
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
  return with_angle(found, min_angle);
}

}  // namespace vorogeo

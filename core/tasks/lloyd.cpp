// In each round: the Voronoi region of every point, then moves that lower the energy of their region.
#include "tasks/lloyd.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo {

namespace {

/// Least step: a fraction of the line from a point to the centre of its region.
constexpr double least_step = 0.1;

struct Label {
  double distance = unreachable;
  Index site = no_index;
  bool operator<(const Label& other) const {
    return distance < other.distance || (distance == other.distance && site < other.site);
  }
};

std::vector<double> vertex_areas(const Mesh& mesh) {
  std::vector<double> area(mesh.vertex_count(), 0.0);
  for (Index f = 0; f < mesh.first_bridge(); ++f) {
    for (Index v : mesh.face_vertices(f)) area[v] += mesh.face_area(f) / 3.0;
  }
  return area;
}

/// Nearest site of each vertex, from fields bounded by the greatest distance of a vertex from its site.
std::vector<Label> label_vertices(FieldTeam& team, const std::vector<SurfacePoint>& sites, double& radius,
                                  const Progress& progress) {
  const auto nearest = team.field_on_all_threads(sites);
  radius = 0.0;
  for (double distance : nearest) {
    if (distance < unreachable) radius = std::max(radius, distance);
  }
  const std::size_t count = nearest.size();
  std::vector<std::vector<Label>> of_worker(team.threads());
  parallel_for(sites.size(), team.threads(), progress, "Lloyd relaxation", [&](std::size_t i, int worker) {
    auto& labels = of_worker[worker];
    labels.resize(count);
    const auto field = team.field(sites[i], bounded_field_slack * radius, worker);
    for (std::size_t v = 0; v < count; ++v) {
      labels[v] = std::min(labels[v], Label{field[v], field[v] < unreachable ? static_cast<Index>(i) : -1});
    }
  });
  std::vector<Label> result(count);
  for (const auto& labels : of_worker) {
    for (std::size_t v = 0; v < labels.size(); ++v) {
      if (labels[v].site != no_index) result[v] = std::min(result[v], labels[v]);
    }
  }
  return result;
}

Point between(const Point& p, const Point& q, double t) {
  return {p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])};
}

/// The vertex of a region nearest in space to the point at the fraction `step` of the line from the site to
/// the region's centre of mass.
SurfacePoint candidate_of(const Mesh& mesh, const std::vector<double>& area, const std::vector<Index>& region,
                          const SurfacePoint& site, double step) {
  Point centre{};
  double weight = 0.0;
  for (Index v : region) {
    for (int i = 0; i < 3; ++i) centre[i] += area[v] * mesh.position(v)[i];
    weight += area[v];
  }
  if (!(weight > 0.0)) return site;
  for (double& coordinate : centre) coordinate /= weight;
  const Point wanted = between(position_of(mesh, site), centre, step);
  SurfacePoint best = site;
  double least = unreachable;
  for (Index v : region) {
    if (v >= mesh.given_vertex_count()) break;  // a region is in order
    const Point& p = mesh.position(v);
    const double distance = std::hypot(p[0] - wanted[0], p[1] - wanted[1], p[2] - wanted[2]);
    if (distance >= least) continue;
    least = distance;
    best = SurfacePoint::at_vertex(v);
  }
  return best;
}

}  // namespace

RelaxedPoints relax_points(FieldTeam& team, const PointList& given, Index rounds, const Progress& progress) {
  const Mesh& mesh = team.mesh();
  if (given.empty()) throw InvalidInput("There is no point to relax; name at least one.");
  const PointList points = points_on(mesh, given, "Point");
  if (!mesh.has_positions()) {
    throw InvalidInput(
        "Points are relaxed towards the centres of their regions in space, but this surface has edge lengths "
        "and no positions; give positions as well.");
  }
  if (rounds < 0) throw InvalidInput("The number of rounds is negative; give 0 or more.");
  const auto area = vertex_areas(mesh);
  RelaxedPoints result;
  result.points.assign(points.begin(), points.end());
  std::vector<double> step(points.size(), 1.0);
  for (Index round = 0;; ++round) {
    const Progress of_round =
        progress.part(static_cast<double>(round) / (rounds + 1.0), (round + 1.0) / (rounds + 1.0));
    double radius = 0.0;
    const auto labels = label_vertices(team, result.points, radius, of_round.part(0.0, 0.5));
    std::vector<std::vector<Index>> region(points.size());
    std::vector<double> energy(points.size(), 0.0);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      const Label& label = labels[v];
      if (label.site == no_index) continue;
      region[label.site].push_back(v);
      energy[label.site] += area[v] * label.distance * label.distance;
    }
    result.energy.push_back(std::accumulate(energy.begin(), energy.end(), 0.0));
    if (round == rounds) break;

    std::vector<SurfacePoint> moved_to(points.size());
    parallel_for(points.size(), team.threads(), of_round.part(0.5, 1.0), "Lloyd relaxation",
                 [&](std::size_t i, int worker) {
                   if (step[i] < least_step) return;
                   const SurfacePoint candidate =
                       candidate_of(mesh, area, region[i], result.points[i], step[i]);
                   if (candidate == result.points[i]) {
                     step[i] = 0.0;
                     return;
                   }
                   const auto field = team.field(candidate, 2.0 * bounded_field_slack * radius, worker);
                   double there = 0.0;
                   for (Index v : region[i]) there += area[v] * field[v] * field[v];
                   if (there < energy[i]) {
                     moved_to[i] = candidate;
                   } else {
                     step[i] *= 0.5;
                   }
                 });
    bool any_moved = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!moved_to[i].is_vertex()) continue;
      result.points[i] = moved_to[i];
      step[i] = 1.0;
      any_moved = true;
    }
    bool goes_on = false;
    for (double& of_point : step) {
      // Neighbours that moved have changed the region, so a point that had settled tries again.
      if (of_point < least_step && any_moved) of_point = 1.0;
      goes_on = goes_on || of_point >= least_step;
    }
    if (!goes_on) break;
  }
  for (const SurfacePoint& point : result.points) result.vertices.push_back(point.vertex);
  progress.report(1.0, "Lloyd relaxation");
  return result;
}

}  // namespace vorogeo

// Points spread over the surface, and moved to the middles of their regions.
#include "tasks/spread_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>

#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo {

// ---- Samplings that keep the distance from the nearest sample, updated sample by sample

namespace {

/// The given vertices with a face. \throw InvalidInput if there are none.
std::vector<Index> vertices_with_face(const Mesh& mesh) {
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh.given_vertex_count(); ++v) {
    if (mesh.fan(v) != Mesh::Fan::isolated) vertices.push_back(v);
  }
  if (vertices.empty()) {
    throw InvalidInput(
        "There is nothing to sample: no vertex there has a face that paths may enter. Take a surface with "
        "faces, a metric that does not bar all of them, or a smaller gap.");
  }
  return vertices;
}

void take_minimum(std::vector<double>& distance, const std::vector<double>& field) {
  for (std::size_t v = 0; v < field.size(); ++v) distance[v] = std::min(distance[v], field[v]);
}

/// A random number below `count`, the same with every standard library.
std::size_t below(std::mt19937_64& random, std::size_t count) {
  return static_cast<std::size_t>(random() % count);
}

}  // namespace

FarthestSamples sample_farthest(Surface& surface, const FarthestStop& stop, const PointList& given,
                                std::uint64_t seed, const TaskOptions& options) {
  const Mesh& mesh = *surface.mesh();
  const PointList start = points_on(mesh, given, "Start");
  if (stop.count < 0 || !(stop.radius >= 0.0) || (stop.count == 0 && stop.radius == 0.0)) {
    throw InvalidInput("Give a number of samples above 0, or a covering radius above 0 at which to stop.");
  }
  double expected = stop.count > 0 ? stop.count : unreachable;
  if (stop.radius > 0.0) expected = std::min(expected, 1.0 / surface.reach_of(0.5 * stop.radius));
  // The k-th sample reaches as far as the regions of k samples. An index helps with those that reach far; the
  // mean of these.
  const double last = reach_of_regions(expected);
  const double least = std::max(last, surface.short_reach());
  Workers workers(surface, options, expected * last / least, std::min(1.0, least * (1.0 - std::log(least))));
  const auto allowed = vertices_with_face(mesh);
  FarthestSamples result;
  result.distance.assign(mesh.vertex_count(), unreachable);
  std::mt19937_64 random(seed);
  Index farthest = no_index;
  auto measure = [&] {
    result.covering_radius = -1.0;
    for (Index v : allowed) {
      if (result.distance[v] <= result.covering_radius) continue;
      result.covering_radius = result.distance[v];
      farthest = v;
    }
  };
  measure();
  const std::size_t limit = stop.count > 0 ? static_cast<std::size_t>(stop.count) : allowed.size();
  while (result.points.size() < limit) {
    const std::size_t taken = result.points.size();
    SurfacePoint sample;
    if (taken < start.size()) {
      sample = start[taken];
      double nearest = sample.is_vertex() ? result.distance[sample.vertex] : unreachable;
      if (!sample.is_vertex() && taken > 0) {
        nearest = workers.field_at_points(result.points, unreachable)(sample);
      }
      result.radius.push_back(nearest);
    } else {
      if (result.covering_radius <= stop.radius) break;
      if (taken == 0) farthest = allowed[below(random, allowed.size())];
      sample = SurfacePoint::at_vertex(farthest);
      result.radius.push_back(result.distance[farthest]);
    }
    result.points.push_back(sample);
    take_minimum(result.distance,
                 workers.field_on_all_threads(std::span(&sample, 1), result.covering_radius));
    if (sample.is_vertex()) result.distance[sample.vertex] = 0.0;
    measure();
    double done = static_cast<double>(taken + 1) / static_cast<double>(limit);
    if (stop.radius > 0.0 && result.covering_radius < unreachable) {
      // On a surface the number of samples grows with the inverse square of the radius.
      const double ratio = stop.radius / std::max(stop.radius, result.covering_radius);
      done = std::max(done, ratio * ratio);
    }
    workers.progress().report(std::min(1.0, done), "Farthest point sampling");
  }
  result.distance.resize(mesh.given_vertex_count());
  return result;
}

std::vector<Index> sample_poisson_disk(Surface& surface, double radius, std::uint64_t seed,
                                       const TaskOptions& options) {
  if (!(radius > 0.0) || radius == unreachable) {
    throw InvalidInput("The radius is " + std::to_string(radius) +
                       "; it must be a length above 0 in the unit of the mesh.");
  }
  require_both_ways_alike(*surface.mesh(), "Poisson-disk samplings");
  const double reach = surface.reach_of(radius);
  Workers workers(surface, options, 1.0 / reach, reach);
  const Mesh& mesh = workers.mesh();
  auto order = vertices_with_face(mesh);
  std::mt19937_64 random(seed);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[below(random, i)]);

  std::vector<double> distance(mesh.vertex_count(), unreachable);
  std::vector<Index> samples;
  std::vector<Index> batch;
  std::vector<std::vector<double>> fields;
  std::size_t next = 0;
  while (next < order.size()) {
    // Darts that are a radius apart by a straight line nearly always lie outside each other's disks, so they
    // are thrown together. Those that do not are left out below, so that the samples do not depend on the
    // threads.
    batch.clear();
    while (next < order.size() && batch.size() < static_cast<std::size_t>(4 * workers.threads())) {
      const Index dart = order[next];
      if (distance[dart] >= radius) {
        const bool may_hit = std::any_of(batch.begin(), batch.end(), [&](Index other) {
          return mesh.straight_bound(mesh.position(dart), mesh.position(other)) < radius;
        });
        if (may_hit) break;
        batch.push_back(dart);
      }
      ++next;
    }
    fields.resize(batch.size());
    parallel_for(batch.size(), workers.threads(), {}, "",
                 [&](std::size_t i, int worker) { fields[i] = workers.field(batch[i], radius, worker); });
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (distance[batch[i]] < radius) continue;
      take_minimum(distance, fields[i]);
      samples.push_back(batch[i]);
    }
    workers.progress().report(static_cast<double>(next) / static_cast<double>(order.size()),
                              "Poisson-disk sampling");
  }
  return samples;
}

// ---- In each round, points move to the middle of their Voronoi regions where that lowers the energy

namespace {

/// Least step: a fraction of the line from a point to the centre of its region.
constexpr double least_step = 0.1;
/// The typical number of rounds until points have settled.
constexpr double rounds_to_settle = 12.0;

/// How points divide the surface, by vertex.
struct Division {
  std::vector<double> distance;
  std::vector<Index> region;  ///< the nearest point
};

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
    if (v >= mesh.given_vertex_count()) break;  // vertices of a region ascend
    const Point& p = mesh.position(v);
    const double distance = std::hypot(p[0] - wanted[0], p[1] - wanted[1], p[2] - wanted[2]);
    if (distance >= least) continue;
    least = distance;
    best = SurfacePoint::at_vertex(v);
  }
  return best;
}

}  // namespace

std::vector<double> vertex_areas(const Mesh& mesh) {
  std::vector<double> area(mesh.vertex_count(), 0.0);
  for (Index f = 0; f < mesh.first_bridge(); ++f) {
    for (Index v : mesh.face_vertices(f)) area[v] += mesh.face_area(f) / 3.0;
  }
  return area;
}

RelaxedPoints relax_points(Surface& surface, const PointList& given, Index rounds, const TaskOptions& options,
                           std::span<const double> weights, Power power) {
  const Mesh& mesh = *surface.mesh();
  if (given.empty()) throw InvalidInput("There is no point to relax; name at least one.");
  require_both_ways_alike(mesh, "Lloyd relaxations");
  const PointList points = points_on(mesh, given, "Point");
  if (!mesh.has_positions()) {
    throw InvalidInput(
        "Points are relaxed towards the centres of their regions in space, but this surface has edge lengths "
        "and no positions; give positions as well.");
  }
  if (rounds < 0) throw InvalidInput("The number of rounds is negative; give 0 or more.");
  // An index gains only beyond the short reach of each point, within which its fields are exact runs, too.
  Workers workers(surface, options, std::min<double>(rounds, rounds_to_settle) + 1.0,
                  std::max(0.0, 1.0 - (static_cast<double>(points.size()) - 1.0) * surface.short_reach()),
                  true);
  const Progress& progress = workers.progress();
  std::vector<double> area =
      weights.empty() ? vertex_areas(mesh) : std::vector<double>(weights.begin(), weights.end());
  area.resize(mesh.vertex_count(), 0.0);
  const std::size_t count = points.size();
  const auto divide = [&](const std::vector<SurfacePoint>& sites) {
    Division division;
    division.distance = workers.field_on_all_threads(sites, unreachable, &division.region);
    return division;
  };
  // By region, also with distances from other points than those that own the regions.
  const auto energies = [&](const std::vector<Index>& region, const std::vector<double>& distance) {
    std::vector<double> energy(count, 0.0);
    for (std::size_t v = 0; v < region.size(); ++v) {
      if (region[v] != no_index) energy[region[v]] += area[v] * powered(distance[v], power);
    }
    return energy;
  };
  const auto sum = [](const std::vector<double>& energy) {
    return std::accumulate(energy.begin(), energy.end(), 0.0);
  };

  RelaxedPoints result;
  result.points.assign(points.begin(), points.end());
  std::vector<double> step(count, 1.0);
  Division now;
  for (Index round = 0;; ++round) {
    const Watch watch(progress.part(round / (rounds + 1.0), (round + 1.0) / (rounds + 1.0)),
                      "Lloyd relaxation");
    if (round == 0) now = divide(result.points);
    const std::vector<double> energy = energies(now.region, now.distance);
    result.energy.push_back(sum(energy));
    if (round == rounds) break;
    std::vector<std::vector<Index>> region(count);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      if (now.region[v] != no_index) region[now.region[v]].push_back(v);
    }
    std::vector<SurfacePoint> moved = result.points;
    for (std::size_t i = 0; i < count; ++i) {
      if (step[i] < least_step) continue;
      moved[i] = candidate_of(mesh, area, region[i], result.points[i], step[i]);
      if (moved[i] == result.points[i]) step[i] = 0.0;
    }
    if (moved == result.points) break;
    Division next = divide(moved);
    std::vector<double> there = energies(now.region, next.distance);
    if (!(sum(there) < result.energy.back())) {
      // Points whose region would have more energy go back.
      for (std::size_t i = 0; i < count; ++i) {
        if (moved[i] == result.points[i] || there[i] < energy[i]) continue;
        moved[i] = result.points[i];
        step[i] *= 0.5;
      }
      if (moved == result.points) continue;
      next = divide(moved);
      there = energies(now.region, next.distance);
    }
    // The sum is no less only if points that went back had helped a neighbour's region, or if an index errs.
    const bool is_less = sum(there) < result.energy.back();
    for (std::size_t i = 0; i < count; ++i) {
      if (moved[i] != result.points[i]) step[i] = is_less ? 1.0 : 0.5 * step[i];
    }
    if (!is_less) continue;
    // A point that had settled tries again if its region has changed.
    for (std::size_t v = 0; v < now.region.size(); ++v) {
      if (now.region[v] == next.region[v]) continue;
      for (const Index i : {now.region[v], next.region[v]}) {
        if (i != no_index && step[i] < least_step) step[i] = 1.0;
      }
    }
    result.points = std::move(moved);
    now = std::move(next);
  }
  result.region = std::move(now.region);
  progress.report(1.0, "Lloyd relaxation");
  return result;
}

}  // namespace vorogeo

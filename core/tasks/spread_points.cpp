// Samplings that keep the distance from the nearest sample, updated sample by sample.
#include "tasks/spread_points.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo {

namespace {

/// The given vertices with a face, of one component, or of all for no_index.
std::vector<Index> vertices_with_face(const Mesh& mesh, Index component = no_index) {
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh.given_vertex_count(); ++v) {
    const bool counts = component == no_index || mesh.component(v) == component;
    if (counts && mesh.fan(v) != Mesh::Fan::isolated) vertices.push_back(v);
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

FarthestSamples sample_farthest(FieldTeam& team, const FarthestStop& stop, const PointList& given,
                                std::uint64_t seed, const Progress& progress) {
  const Mesh& mesh = team.mesh();
  const PointList start = points_on(mesh, given, "Start");
  if (stop.count < 0 || !(stop.radius >= 0.0) || (stop.count == 0 && stop.radius == 0.0)) {
    throw InvalidInput("Give a number of samples above 0, or a covering radius above 0 at which to stop.");
  }
  const auto allowed = vertices_with_face(mesh, stop.component);
  FarthestSamples result;
  result.distance.assign(mesh.vertex_count(), unreachable);
  std::mt19937_64 random(seed);
  Index farthest = no_index;
  auto measure = [&] {
    result.covering_radius = allowed.empty() ? 0.0 : -1.0;
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
        nearest = std::ranges::min(team.distances(sample, result.points, unreachable, 0));
      }
      result.radius.push_back(nearest);
    } else {
      if (result.covering_radius <= stop.radius) break;
      if (taken == 0) farthest = allowed[below(random, allowed.size())];
      sample = SurfacePoint::at_vertex(farthest);
      result.radius.push_back(result.distance[farthest]);
    }
    result.points.push_back(sample);
    result.vertices.push_back(sample.vertex);
    take_minimum(result.distance, team.field_on_all_threads(std::span(&sample, 1), result.covering_radius));
    if (sample.is_vertex()) result.distance[sample.vertex] = 0.0;
    measure();
    double done = static_cast<double>(taken + 1) / static_cast<double>(limit);
    if (stop.radius > 0.0 && result.covering_radius < unreachable) {
      // On a surface the number of samples grows with the inverse square of the radius.
      const double ratio = stop.radius / std::max(stop.radius, result.covering_radius);
      done = std::max(done, ratio * ratio);
    }
    progress.report(std::min(1.0, done), "Farthest point sampling");
  }
  result.distance.resize(mesh.given_vertex_count());
  return result;
}

std::vector<Index> sample_poisson_disk(FieldTeam& team, double radius, std::uint64_t seed,
                                       const Progress& progress) {
  if (!(radius > 0.0) || radius == unreachable) {
    throw InvalidInput("The radius is " + std::to_string(radius) +
                       "; it must be a length above 0 in the unit of the mesh.");
  }
  const Mesh& mesh = team.mesh();
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
    while (next < order.size() && batch.size() < static_cast<std::size_t>(4 * team.threads())) {
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
    parallel_for(batch.size(), team.threads(), {}, "",
                 [&](std::size_t i, int worker) { fields[i] = team.field(batch[i], radius, worker); });
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (distance[batch[i]] < radius) continue;
      take_minimum(distance, fields[i]);
      samples.push_back(batch[i]);
    }
    progress.report(static_cast<double>(next) / static_cast<double>(order.size()), "Poisson-disk sampling");
  }
  return samples;
}

}  // namespace vorogeo

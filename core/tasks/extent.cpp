// Eccentricity, diameter and disks, and how two fields differ.
#include "tasks/extent.h"

#include <algorithm>
#include <cmath>

#include "support/error.h"
#include "support/parallel.h"

namespace vorogeo {

// ---- Relative differences vertex by vertex, then their mean, RMS, percentile and maximum

FieldDifference difference_of(const std::vector<double>& values, const std::vector<double>& reference) {
  FieldDifference result;
  std::vector<double> sizes;
  for (std::size_t v = 0; v < values.size(); ++v) {
    const bool both = std::isfinite(values[v]) && std::isfinite(reference[v]);
    if (std::isfinite(values[v]) != std::isfinite(reference[v])) ++result.one_only;
    if (!both || !(reference[v] > 0.0)) {
      result.relative.push_back(std::nan(""));
      continue;
    }
    const double error = (values[v] - reference[v]) / reference[v];
    result.relative.push_back(error);
    result.bias += error;
    result.mean += std::abs(error);
    result.rms += error * error;
    sizes.push_back(std::abs(error));
  }
  result.compared = static_cast<int>(sizes.size());
  if (sizes.empty()) return result;
  const auto count = static_cast<double>(sizes.size());
  result.bias /= count;
  result.mean /= count;
  result.rms = std::sqrt(result.rms / count);
  std::sort(sizes.begin(), sizes.end());
  result.p99 = sizes[static_cast<std::size_t>(std::ceil(0.99 * count)) - 1];
  result.max = sizes.back();
  return result;
}

// ---- Eccentricities of a few vertices, and bounds for all others by the triangle inequality

namespace {

/// The typical number of fields after which the bounds of an extent meet.
constexpr double usual_fields = 20.0;

/// Only over the vertices that were given, as the ends and the centre of a surface must be among them.
Eccentricity eccentricity_in(const Mesh& mesh, const std::vector<double>& field) {
  Eccentricity result{-1.0, no_index};
  for (Index v = 0; v < mesh.given_vertex_count(); ++v) {
    if (field[v] < unreachable && field[v] > result.distance) result = {field[v], v};
  }
  return result;
}

}  // namespace

std::vector<Eccentricity> eccentricities(Surface& surface, const PointList& given,
                                         const TaskOptions& options) {
  const PointList points = points_on(*surface.mesh(), given, "Point");
  Workers workers(surface, options, static_cast<double>(points.size()));
  std::vector<Eccentricity> result(points.size());
  parallel_for(points.size(), workers.threads(), workers.progress(), "Eccentricities",
               [&](std::size_t i, int worker) {
                 result[i] = eccentricity_in(workers.mesh(), workers.field(points[i], unreachable, worker));
               });
  return result;
}

Extent extent_of_component(Surface& surface, Index start, Index max_fields, const TaskOptions& options) {
  const Mesh& mesh = *surface.mesh();
  points_on(mesh, std::span(&start, 1), "Start");
  if (max_fields < 2) throw InvalidInput("At least 2 fields are needed to bound a diameter; allow more.");
  require_both_ways_alike(mesh, "Diameter and centre");
  Workers workers(surface, options, std::min<double>(max_fields, usual_fields));
  std::vector<Index> members;
  for (Index v = 0; v < mesh.given_vertex_count(); ++v) {
    if (mesh.component(v) == mesh.component(start)) members.push_back(v);
  }
  std::vector<Bounds> bounds(mesh.vertex_count());
  Extent result;
  result.radius.upper = unreachable;
  result.diameter.lower = -1.0;
  Index next = start;
  while (result.fields < max_fields) {
    const auto field = workers.field_on_all_threads(std::span(&next, 1));
    const Eccentricity found = eccentricity_in(mesh, field);
    ++result.fields;
    if (found.distance > result.diameter.lower) {
      result.diameter.lower = found.distance;
      result.ends[0] = next;
      result.ends[1] = found.farthest;
    }
    if (found.distance < result.radius.upper) {
      result.radius.upper = found.distance;
      result.centre = next;
    }
    for (Index v : members) {
      Bounds& of = bounds[v];
      of.lower = std::max({of.lower, field[v], found.distance - field[v]});
      of.upper = std::min(of.upper, found.distance + field[v]);
    }
    bounds[next] = {found.distance, found.distance};
    // The vertices that may still have the greatest and the least eccentricity.
    Index widest = start;
    Index closest = start;
    for (Index v : members) {
      if (bounds[v].upper > bounds[widest].upper) widest = v;
      if (bounds[v].lower < bounds[closest].lower) closest = v;
    }
    result.diameter.upper = std::max(result.diameter.lower, bounds[widest].upper);
    result.radius.lower = std::min(result.radius.upper, bounds[closest].lower);
    workers.progress().report(static_cast<double>(result.fields) / max_fields, "Diameter and centre");
    const bool diameter_known = result.diameter.upper <= result.diameter.lower;
    const bool radius_known = result.radius.lower >= result.radius.upper;
    if (diameter_known && radius_known) break;
    if (result.fields == 1) {
      next = found.farthest;  // for the second sweep
    } else if (radius_known || (!diameter_known && result.fields % 2 == 1)) {
      next = widest;
    } else {
      next = closest;
    }
  }
  return result;
}

Disk geodesic_disk(Surface& surface, const PointList& given, double radius, const TaskOptions& options) {
  const Mesh& mesh = *surface.mesh();
  if (given.empty()) throw InvalidInput("There is no point around which a disk could lie; name one.");
  const PointList sources = points_on(mesh, given, "Point");
  require_radius(radius);
  const double reach = static_cast<double>(sources.size()) * surface.reach_of(radius);
  Workers workers(surface, options, 1.0, std::min(1.0, reach));
  const Watch watch(workers.progress(), "Geodesic disk");
  const auto field = workers.field_on_all_threads(sources, radius);
  Disk disk;
  for (Index v = 0; v < mesh.given_vertex_count(); ++v) {
    if (field[v] == unreachable) continue;
    disk.vertices.push_back(v);
    disk.distance.push_back(field[v]);
  }
  for (Index f = 0; f < mesh.first_bridge(); ++f) {
    const bool is_other_part = f > 0 && mesh.input_face(f) == mesh.input_face(f - 1);
    const auto& corners = mesh.given_corners(f);
    if (!is_other_part && std::ranges::all_of(corners, [&](Index v) { return field[v] < unreachable; })) {
      disk.faces.push_back(mesh.input_face(f));
    }
  }
  return disk;
}

}  // namespace vorogeo

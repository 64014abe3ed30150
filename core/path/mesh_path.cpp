// Upper bounds from paths along edges, then one exact run within them.
#include "path/mesh_path.h"

#include <algorithm>
#include <array>
#include <vector>

#include "path/path_edges.h"

namespace vorogeo {

namespace {

/// Rings of vertices around the tightened edge path in which a shorter one is looked for first. The edge path
/// of a rough surface lies farther from the shortest one than that of an index.
constexpr int rings_around = 4;

/// The vertex of a point, or the nearest corner of its face, and how far that is.
struct NearVertex {
  Index vertex = no_index;
  double distance = unreachable;
};

NearVertex near_vertex(const Mesh& mesh, const SurfacePoint& point) {
  if (point.is_vertex()) return {point.vertex, 0.0};
  const auto distances = distances_in_face(mesh, point);
  const auto nearest = std::ranges::min_element(distances);
  return {mesh.face_vertices(point.face)[nearest - distances.begin()], *nearest};
}

bool is_on_surface(const Mesh& mesh, const SurfacePoint& point) {
  return !point.is_vertex() || !mesh.corners(point.vertex).empty();
}

}  // namespace

MeshPathQuery::MeshPathQuery(const std::shared_ptr<const LocalGeometry>& geometry)
    : mesh_(*geometry->mesh), corridor_(geometry), surroundings_(mesh_) {
  if (geometry->windows) refiner_.emplace(*geometry->windows);
}

/// Lays a strip of faces along the shortest edge path. `length` receives that path's length. \return whether
/// the strip joins the points.
bool MeshPathQuery::lay_strip(const SurfacePoint& source, const SurfacePoint& target, double& length) {
  const NearVertex first = near_vertex(mesh_, source);
  const NearVertex last = near_vertex(mesh_, target);
  std::vector<EdgeStep> steps;
  if (!path_along_edges(mesh_, first.vertex, last.vertex, steps)) return false;
  length = first.distance + last.distance;
  for (const EdgeStep& step : steps) length += mesh_.edge_length(mesh_.edge_of(step.halfedge));
  strip_.clear();
  strip_.source = source;
  strip_.target = target;
  if (!source.is_vertex()) strip_.faces.push_back(source.face);
  for (const EdgeStep& step : steps) {
    const Index face = Mesh::face_of(step.halfedge);
    if (strip_.faces.empty()) {
      strip_.faces.push_back(face);
    } else if (!turn_around(mesh_, strip_, step.from, face)) {
      return false;
    }
  }
  if (strip_.faces.empty()) strip_.faces.push_back(Mesh::face_of(mesh_.corners(first.vertex).front()));
  if (!target.is_vertex() && !turn_around(mesh_, strip_, last.vertex, target.face)) return false;
  tidy(mesh_, strip_);
  return true;
}

double MeshPathQuery::upper_bound(const SurfacePoint& source, const SurfacePoint& target) {
  double bound = unreachable;
  if (!lay_strip(source, target, bound)) return bound;
  refiner_->refine(strip_);
  // Across edges of negligible length, an unfolded line may be off by any amount; its points are still right.
  const SurfacePath tight = refiner_->path();
  if (!tight.points.empty()) bound = std::min(bound, measured_length(mesh_, tight.points).length);
  const auto nearby = surroundings_.surround(refiner_->line(), rings_around);
  return std::min(bound, corridor_.within(source, target, bound, nearby).path.length);
}

ExactPath MeshPathQuery::exact_path(const SurfacePoint& source, const SurfacePoint& target) {
  const SurfacePoint from = validated(mesh_, source);
  const SurfacePoint to = validated(mesh_, target);
  auto component = [&](const SurfacePoint& p) {
    return mesh_.component(p.is_vertex() ? p.vertex : mesh_.face_vertices(p.face).front());
  };
  ExactPath result;
  result.path.length = unreachable;
  result.certified = true;
  if (!is_on_surface(mesh_, from) || !is_on_surface(mesh_, to) || component(from) != component(to)) {
    return result;
  }
  if (is_same_point(mesh_, from, to)) return {{{from, to}, 0.0}, true};
  auto taken_over = [&](FoundPath found) {
    result.path = std::move(found.path);
    const MeasuredLength measured = set_ends(mesh_, from, to, result.path);
    result.certified = is_path(mesh_, result.path, measured, from, to, found.distance);
  };
  if (!refiner_) {
    taken_over(corridor_.run(from, to, {}));
    result.certified = false;
    return result;
  }
  const double bound = upper_bound(from, to);
  taken_over(corridor_.within(from, to, bound));
  // On faces without area, the bound may be off by more than rounding.
  if (!result.certified && bound < unreachable) taken_over(corridor_.run(from, to, {}));
  result.certified = result.certified && is_provable(mesh_);
  return result;
}

}  // namespace vorogeo

// Upper bounds from paths along edges, then one exact run within them.
#include "query/mesh_path.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "query/path_chain.h"

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
  bound = std::min(bound, refiner_->path().length);
  const auto nearby = surroundings_.surround(refiner_->line(), rings_around);
  return std::min(bound, corridor_.within(source, target, bound, nearby).path.length);
}

std::optional<ExactPath> MeshPathQuery::known_path(const SurfacePoint& from, const SurfacePoint& to) const {
  auto component = [&](const SurfacePoint& p) {
    return mesh_.component(p.is_vertex() ? p.vertex : mesh_.face_vertices(p.face).front());
  };
  if (is_same_point(mesh_, from, to)) return ExactPath{{{from, to}, 0.0}, true};
  if (!is_on_surface(mesh_, from) || !is_on_surface(mesh_, to) || component(from) != component(to)) {
    return ExactPath{{{}, unreachable}, true};
  }
  return std::nullopt;
}

ExactPath MeshPathQuery::checked(FoundPath found, const SurfacePoint& from, const SurfacePoint& to) const {
  ExactPath result{std::move(found.path), false};
  const MeasuredLength measured = set_ends(mesh_, from, to, result.path);
  result.certified = !mesh_.metric_jumps() && is_provable(mesh_) &&
                     is_path(mesh_, result.path, measured, from, to, found.distance);
  return result;
}

/// Whether what was found is no path, or could be proven but is not.
bool MeshPathQuery::needs_another_run(const ExactPath& found, const SurfacePoint& from,
                                      const SurfacePoint& to) const {
  return !found.certified && (is_provable(mesh_) || !is_path(mesh_, found.path, from, to, found.path.length));
}

ExactPath MeshPathQuery::exact_path(const SurfacePoint& source, const SurfacePoint& target) {
  const SurfacePoint from = validated(mesh_, source);
  const SurfacePoint to = validated(mesh_, target);
  if (auto known = known_path(from, to)) return *std::move(known);
  if (!refiner_) return checked(corridor_.run(from, to, {}), from, to);
  const double bound = upper_bound(from, to);
  ExactPath result = checked(corridor_.within(from, to, bound), from, to);
  // On faces without area, the bound may be off by more than rounding.
  if (needs_another_run(result, from, to) && bound < unreachable) {
    result = checked(corridor_.run(from, to, {}), from, to);
  }
  return result;
}

ExactPath MeshPathQuery::exact_path(PathsFromPoint& from_source, const SurfacePoint& target) {
  const SurfacePoint& from = from_source.source();
  const SurfacePoint to = validated(mesh_, target);
  if (auto known = known_path(from, to)) return *std::move(known);
  FoundPath found{from_source.path_to(to), unreachable};
  found.distance = from_source.distance(to);
  ExactPath result = checked(std::move(found), from, to);
  if (mesh_.metric_jumps() || !needs_another_run(result, from, to)) return result;
  return exact_path(from, to);
}

}  // namespace vorogeo

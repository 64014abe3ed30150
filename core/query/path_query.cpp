// From end points to a path: an upper bound, from edges or from the index, and an exact run within it.
#include "query/path_query.h"

#include <algorithm>
#include <utility>

#include "index/index_data.h"
#include "query/path_chain.h"
#include "support/lists.h"

namespace vorogeo {

namespace {

/// A refined path that is this much longer (relative) than the index's distance is probably on the wrong side
/// of something: exact propagation decides.
constexpr double suspicious = 2e-4;
/// A shorter path is looked for near the refined one if that is longer than the index's distance by this much
/// (relative) on an even surface, by less for each radian of roughness, but by no less than a minimum.
/// Measured: on rough surfaces more paths have a shorter one close to them, and the index's distance itself
/// is longer (docs/figures.md).
constexpr double doubtful_if_even = 2e-4;
constexpr double doubtful_by_roughness = 1.8e-2;
constexpr double least_doubtful = -1.5e-4;
/// Such shorter paths hardly ever leave this many rings of faces around the strip.
constexpr int rings_beside = 2;

}  // namespace

PathQuery::PathQuery(std::shared_ptr<const GeodesicIndex> index)
    : index_(std::move(index)),
      mesh_(index_->mesh()),
      strip_geometry_(index_->data().geometry),
      exact_(index_->data()),
      routes_(std::make_unique<Routes>(index_->data())) {
  if (!strip_geometry_->norms) refiner_.emplace(*strip_geometry_->windows);
}

PathQuery::PathQuery(const std::shared_ptr<const LocalGeometry>& geometry)
    : mesh_(geometry->mesh), strip_geometry_(geometry), exact_(geometry) {
  if (!geometry->norms) refiner_.emplace(*geometry->windows);
}

/// The answer where no propagation is needed: to the point itself, or where no path exists.
std::optional<ExactPath> PathQuery::known_path(const SurfacePoint& from, const SurfacePoint& to) const {
  auto component = [&](const SurfacePoint& p) {
    return mesh_->component(p.is_vertex() ? p.vertex : mesh_->face_vertices(p.face).front());
  };
  if (is_same_point(*mesh_, from, to)) return ExactPath{{{from, to}, 0.0}, true};
  if (component(from) != component(to)) return ExactPath{{{}, unreachable}, true};
  return std::nullopt;
}

// ---- Without an index: bounds from the shortest path along edges

/// For near points, and without an index: the length of the shortest path along edges, pulled tight where a
/// strip of faces along it joins the points. Unreachable where the metric jumps, as no line can be pulled
/// tight there.
double PathQuery::length_by_edges(const PathEnd& from, const PathEnd& to) {
  if (!refiner_) return unreachable;
  const Mesh& mesh = *strip_geometry_->mesh;
  std::vector<PassedFace> passed;
  const double length =
      from.to_vertex + to.to_vertex + path_along_edges(mesh, from.vertex, to.vertex, passed);
  if (length == unreachable) return length;
  strip_.source = from.point;
  strip_.target = to.point;
  strip_.first = from.point.face;
  strip_.crossings.clear();
  for (const PassedFace& next : passed) {
    if (strip_.first == no_index) strip_.first = next.face;
    if (!turn_around(mesh, strip_, next.pivot, next.face)) return length;
  }
  if (strip_.first == no_index) strip_.first = Mesh::face_of(mesh.corners(from.vertex).front());
  const bool is_whole = to.point.is_vertex() || turn_around(mesh, strip_, to.vertex, to.point.face);
  return is_whole ? std::min(length, refiner_->refine(strip_)) : length;
}

// ---- With an index: the route, refined

void PathQuery::find_route(RoutedEnds& ends) {
  const IndexData& data = routes_->data;
  if (ends.from.place == ends.to.place) {
    ends.route.length = 0.0;
  } else {
    routes_->router.route(route_end_of(data, ends.from), route_end_of(data, ends.to), ends.route);
  }
}

/// The path by exact propagation, if the ends are near or the metric jumps, so that no line can be refined;
/// otherwise finds the route between the ends.
std::optional<ExactPath> PathQuery::solved(const SurfacePoint& from, const SurfacePoint& to,
                                           RoutedEnds& ends) {
  const bool are_ends_near = are_near(routes_->data, ends.from, ends.to);
  if (are_ends_near && refiner_) return exact_.path(from, to, {.upper = length_by_edges(ends.from, ends.to)});
  find_route(ends);
  if (refiner_) return std::nullopt;
  PathBounds bounds;
  bounds.upper = ends.length() * slack::widest;
  bounds.is_proof = false;
  if (are_ends_near) {
    std::vector<Index> patches = ends.from.patches;
    patches.insert(patches.end(), ends.to.patches.begin(), ends.to.patches.end());
    sort_once(patches);
    bounds.mask = exact_.mask_around(patches);
  } else {
    bounds.rest = routes_->bounds.fill(ends.from, ends.to, bounds.upper);
  }
  return exact_.path(from, to, bounds);
}

/// The path of the index, refined; without points if the tables do not lead to the other end.
SurfacePath PathQuery::refined(const SurfacePoint& from, const SurfacePoint& to, const RoutedEnds& ends) {
  const IndexData& data = routes_->data;
  const SurfacePath none{{}, unreachable};
  if (ends.route.length == unreachable) return none;
  if (!strip_along_route(data, ends.route, ends.from, ends.to, strip_)) return none;
  refiner_->refine(strip_);
  SurfacePath path = refiner_->path();
  if (!(path.length < unreachable)) return none;
  return exact_.checked(data.surface.user_path(std::move(path)), unreachable, from, to).path;
}

/// The index's distance along a route; for points in faces, from the distances of their corners. Unreachable
/// where the tables of the route do not hold the corners.
double PathQuery::expected_length(const RoutedEnds& ends) {
  return ends.from.distance([&](Index source) {
    return ends.to.distance([&](Index target) {
      return routes_->unfolder.length(ends.route, {source, ends.from.patch}, {target, ends.to.patch});
    });
  });
}

/// A refined path, or a shorter one if it may be on the wrong side of something.
SurfacePath PathQuery::doubted(SurfacePath path, double expected, const SurfacePoint& from,
                               const SurfacePoint& to) {
  auto take_shorter = [&](SurfacePath other) {
    if (other.length < path.length) path = std::move(other);
  };
  const Mesh& mesh = *strip_geometry_->mesh;
  const double doubtful =
      std::max(least_doubtful, doubtful_if_even - doubtful_by_roughness * roughness(mesh, refiner_->line()));
  if (path.length > expected * (1.0 + doubtful)) {
    const auto mask = exact_.mask_beside(refiner_->line().faces(), rings_beside);
    take_shorter(exact_.path(from, to, {.upper = path.length, .mask = mask, .is_fixed = true}).path);
  }
  if (path.length > expected * (1.0 + suspicious)) {
    take_shorter(exact_.path(from, to, {.upper = path.length}).path);
  }
  return path;
}

// ---- Questions

SurfacePath PathQuery::path(const SurfacePoint& source, const SurfacePoint& target) {
  SurfacePoint from = validated(*mesh_, source);
  SurfacePoint to = validated(*mesh_, target);
  if (auto known = known_path(from, to)) return std::move(known->path);
  // Searches from either end may find different paths: both directions take the same one.
  const bool swapped = canonical(*mesh_, to) < canonical(*mesh_, from);
  if (swapped) std::swap(from, to);
  RoutedEnds ends(routes_->data, from, to);
  SurfacePath found;
  if (auto exact = solved(from, to, ends)) {
    found = std::move(exact->path);
  } else {
    found = refined(from, to, ends);
    if (!found.points.empty()) found = doubted(std::move(found), expected_length(ends), from, to);
    if (!exact_.is_whole(found, from, to)) {
      found = exact_.path(from, to, {.upper = ends.length() * slack::of_route}).path;
    }
  }
  if (swapped) std::ranges::reverse(found.points);
  return found;
}

ExactPath PathQuery::path_on_mesh(const SurfacePoint& from, const SurfacePoint& to) {
  return exact_.path(from, to, {.upper = length_by_edges(PathEnd(*mesh_, from), PathEnd(*mesh_, to))});
}

ExactPath PathQuery::exact_path(const SurfacePoint& source, const SurfacePoint& target, bool certify,
                                const ExactLandmarks* landmarks) {
  const SurfacePoint from = validated(*mesh_, source);
  const SurfacePoint to = validated(*mesh_, target);
  if (auto known = known_path(from, to)) return *std::move(known);
  if (!index_) return path_on_mesh(from, to);
  RoutedEnds ends(routes_->data, from, to);
  if (auto exact = solved(from, to, ends)) return *std::move(exact);
  PathBounds bounds;
  bounds.upper = std::min(refined(from, to, ends).length, ends.length() * slack::of_route);
  if (certify || routes_->data.has_branches) {
    bounds.landmarks = landmarks;
  } else {
    bounds.is_proof = false;
    bounds.rest = routes_->bounds.fill(ends.from, ends.to, bounds.upper);
  }
  return exact_.path(from, to, bounds);
}

ExactPath PathQuery::exact_path(PathsFromPoint& from_source, const SurfacePoint& target) {
  const SurfacePoint& from = from_source.source();
  const SurfacePoint to = validated(*mesh_, target);
  if (auto known = known_path(from, to)) return *std::move(known);
  SurfacePath path = from_source.path_to(to);
  const double distance = exact_.can_prove() ? from_source.distance(to) : unreachable;
  ExactPath found = exact_.checked(std::move(path), distance, from, to);
  const bool is_answer = found.certified || (!exact_.can_prove() && exact_.is_whole(found.path, from, to));
  return is_answer ? found : path_on_mesh(from, to);
}

}  // namespace vorogeo

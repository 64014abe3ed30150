// From end points to a path: near ends by propagation, the others through the index.
#include "query/path_query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "index/index_data.h"
#include "mesh/surface_point.h"
#include "query/exact_search.h"
#include "query/path_chain.h"
#include "query/path_refine.h"
#include "query/router.h"

namespace vorogeo {

namespace {

/// A length from the tables, multiplied by this, is an upper bound in spite of their precision.
constexpr double estimate_slack = 1.0 + 1e-3;
/// The same where the metric jumps: there, propagated distances have errors of their own.
constexpr double estimate_slack_of_jumps = 1.0 + 1e-2;
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
/// Such shorter paths hardly ever leave this many rings of vertices around the strip.
constexpr int rings_beside = 2;

}  // namespace

struct PathQuery::State {
  explicit State(std::shared_ptr<const GeodesicIndex> shared_index)
      : index(std::move(shared_index)),
        data(index->data()),
        exact(data),
        router(data),
        surroundings(*data.work.mesh),
        unfolder(data) {
    if (data.geometry->windows) refiner.emplace(*data.geometry->windows);
  }

  Index component(const SurfacePoint& point) const {
    return data.mesh->component(point.is_vertex() ? point.vertex
                                                  : data.mesh->face_vertices(point.face).front());
  }
  bool connected(const SurfacePoint& source, const SurfacePoint& target) const {
    auto on_surface = [&](const SurfacePoint& p) {
      return !p.is_vertex() || data.work.work_vertex[p.vertex] != no_index;
    };
    return on_surface(source) && on_surface(target) && component(source) == component(target);
  }
  GraphRoute route(const PathEnd& from, const PathEnd& to);
  SurfacePath path_by_chain(const PathEnd& from, const PathEnd& to, const GraphRoute& route_found);
  double expected_length(const PathEnd& from, const PathEnd& to, const GraphRoute& route_found);
  void look_nearby(const PathEnd& from, const PathEnd& to, double expected, FoundPath& found);
  FoundPath path(const PathEnd& from, const PathEnd& to, const GraphRoute& route_found);
  /// A path over the user's mesh, and its length along its points.
  struct AskedPath {
    SurfacePath path;
    MeasuredLength measured;
  };
  AskedPath as_asked(const FoundPath& found, const SurfacePoint& source, const SurfacePoint& target) const;
  /// See is_path() in core/exact.
  bool is_whole(const AskedPath& found, const SurfacePoint& source, const SurfacePoint& target,
                double distance) const {
    return is_path(*data.mesh, found.path, found.measured, source, target, distance);
  }

  std::shared_ptr<const GeodesicIndex> index;
  const IndexData& data;
  ExactSearch exact;
  Router router;
  std::optional<PathRefiner> refiner;  ///< not where the metric jumps: there, lines refract
  PathNeighbourhood surroundings;
  FaceStrip strip;
  RouteUnfolder unfolder;
};

PathQuery::PathQuery(std::shared_ptr<const GeodesicIndex> index)
    : state_(std::make_unique<State>(std::move(index))) {}
PathQuery::~PathQuery() = default;
PathQuery::PathQuery(PathQuery&&) noexcept = default;
PathQuery& PathQuery::operator=(PathQuery&&) noexcept = default;
const GeodesicIndex& PathQuery::index() const { return *state_->index; }
void PathQuery::use_landmarks(std::shared_ptr<const ExactLandmarks> landmarks) {
  state_->exact.use_landmarks(std::move(landmarks));
}

GraphRoute PathQuery::State::route(const PathEnd& from, const PathEnd& to) {
  if (from.vertex == to.vertex) return {0.0, {}, {}};
  const RouteEnd a = route_end_of(data, from);
  const RouteEnd b = route_end_of(data, to);
  GraphRoute best;
  router.route(a, b, best);
  return best;
}

/// The path of the index, refined; without points if the tables do not lead to the other end.
SurfacePath PathQuery::State::path_by_chain(const PathEnd& from, const PathEnd& to,
                                            const GraphRoute& route_found) {
  SurfacePath none;
  none.length = unreachable;
  if (route_found.length == unreachable) return none;
  strip.source = from.point;
  strip.target = to.point;
  const PathChain chain =
      chain_of_route(data, route_found, from.vertex, to.vertex, from.patch(data), to.patch(data));
  if (!strip_along_chain(data, chain, strip)) return none;
  refiner->refine(strip);
  SurfacePath path = refiner->path();
  return path.length < unreachable ? path : none;
}

/// The index's distance along a route; for points in faces, from the distances of their corners. Unreachable
/// where the tables of the route do not hold the corners.
double PathQuery::State::expected_length(const PathEnd& from, const PathEnd& to,
                                         const GraphRoute& route_found) {
  const Mesh& mesh = *data.work.mesh;
  auto between = [&](const PathEnd& end, auto&& of_vertex) {
    if (end.point.is_vertex()) return of_vertex(end.point.vertex);
    std::array<double, 3> corners{};
    for (int i = 0; i < 3; ++i) corners[i] = of_vertex(mesh.face_vertices(end.point.face)[i]);
    return distance_in_face(mesh, end.point.face, end.point.barycentric, corners);
  };
  return between(from, [&](Index source) {
    return between(to, [&](Index target) {
      return unfolder.length(route_found, source, target, from.patch(data), to.patch(data));
    });
  });
}

/// Looks for a shorter path close to the refined one if that may be on the wrong side of something.
void PathQuery::State::look_nearby(const PathEnd& from, const PathEnd& to, double expected,
                                   FoundPath& found) {
  const double doubtful = std::max(
      least_doubtful, doubtful_if_even - doubtful_by_roughness * roughness(*data.work.mesh, refiner->line()));
  if (!(found.path.length > expected * (1.0 + doubtful))) return;
  // Within a few rings the shortest path may be missed, so this search proves nothing.
  const auto nearby = surroundings.surround(refiner->line(), rings_beside);
  found.join(exact.within(from, to, found.path.length, nearby).unproven());
}

FoundPath PathQuery::State::path(const PathEnd& from, const PathEnd& to, const GraphRoute& route_found) {
  FoundPath found;
  const double slack = refiner ? estimate_slack : estimate_slack_of_jumps;
  const double estimate = (from.to_vertex + route_found.length + to.to_vertex) * slack;
  if (are_near(data, from, to)) {
    found = exact.nearby(from, to, estimate);
  } else if (!refiner) {
    found = exact.by_index(from, to, estimate);
  } else {
    found.path = path_by_chain(from, to, route_found);
    if (found.path.points.empty()) {
      // The tables did not lead to the other end: exact propagation, within the length of the route.
      found = exact.between_landmarks(from, to, estimate);
    } else {
      found.is_refined = true;
    }
  }
  // On faces without area, lengths may be off by more than the slack.
  if (found.path.points.empty()) found = exact.everywhere(from, to);
  return found;
}

/// The same path over the user's mesh, between exactly the points that were asked for, with the length
/// measured along its points.
PathQuery::State::AskedPath PathQuery::State::as_asked(const FoundPath& found, const SurfacePoint& source,
                                                       const SurfacePoint& target) const {
  AskedPath result{found.on_user_mesh ? found.path : user_path(data, found.path), {}};
  result.measured = set_ends(*data.mesh, source, target, result.path);
  return result;
}

SurfacePath PathQuery::path(const SurfacePoint& source, const SurfacePoint& target) {
  State& state = *state_;
  const Mesh& mesh = *state.data.mesh;
  SurfacePoint s = validated(mesh, source);
  SurfacePoint t = validated(mesh, target);
  SurfacePath none;
  none.length = unreachable;
  if (is_same_point(mesh, s, t)) return {{s, t}, 0.0};
  if (!state.connected(s, t)) return none;
  // Searches from either end may find different paths: both directions take the same one.
  const bool swapped = canonical(mesh, t) < canonical(mesh, s);
  if (swapped) std::swap(s, t);
  const PathEnd from = path_end(state.data, s);
  const PathEnd to = path_end(state.data, t);
  const GraphRoute route_found = state.route(from, to);
  FoundPath first = state.path(from, to, route_found);
  double expected = unreachable;
  if (first.is_refined) {
    expected = state.expected_length(from, to, route_found);
    state.look_nearby(from, to, expected, first);
  }
  State::AskedPath found = state.as_asked(first, s, t);
  // By its length over the user's mesh: across needles beside split edges, unfolding may have lost it.
  if (found.path.length > expected * (1.0 + suspicious)) {
    auto exact = state.as_asked(state.exact.between_landmarks(from, to, found.path.length), s, t);
    if (exact.path.length < found.path.length) found = std::move(exact);
  }
  if (!state.is_whole(found, s, t, found.path.length)) {
    found = state.as_asked(state.exact.everywhere(from, to), s, t);
  }
  if (swapped) std::ranges::reverse(found.path.points);
  return std::move(found.path);
}

ExactPath PathQuery::exact_path(const SurfacePoint& source, const SurfacePoint& target, bool certify) {
  State& state = *state_;
  const Mesh& mesh = *state.data.mesh;
  const SurfacePoint s = validated(mesh, source);
  const SurfacePoint t = validated(mesh, target);
  ExactPath result;
  result.path.length = unreachable;
  result.certified = true;
  if (is_same_point(mesh, s, t)) return {{{s, t}, 0.0}, true};
  if (!state.connected(s, t)) return result;
  const PathEnd from = path_end(state.data, s);
  const PathEnd to = path_end(state.data, t);
  FoundPath found = state.path(from, to, state.route(from, to));
  if (!state.refiner) {
    // Nothing is proven of distances by points on edges.
    return {state.as_asked(found, s, t).path, false};
  }
  if (found.distance == unreachable) {
    const bool with_proof = certify || state.data.has_branches;
    found.join(with_proof ? state.exact.between_landmarks(from, to, found.path.length)
                          : state.exact.by_index(from, to, found.path.length));
  }
  State::AskedPath asked = state.as_asked(found, s, t);
  result.certified = state.is_whole(asked, s, t, found.distance);
  const bool meant_to_be_proven = certify || state.data.has_branches || found.distance < unreachable;
  if (!result.certified && (meant_to_be_proven || !state.is_whole(asked, s, t, asked.path.length))) {
    // The bounds were wrong by more than rounding explains, or the path back was not found: search without
    // bounds.
    found = state.exact.everywhere(from, to);
    State::AskedPath anywhere = state.as_asked(found, s, t);
    const bool is_path_there = state.is_whole(anywhere, s, t, anywhere.path.length);
    result.certified = is_path_there && state.is_whole(anywhere, s, t, found.distance);
    if (result.certified || (is_path_there && anywhere.path.length < asked.path.length)) {
      asked = std::move(anywhere);
    }
  }
  result.certified = result.certified && is_provable(mesh);
  result.path = std::move(asked.path);
  return result;
}

}  // namespace vorogeo
